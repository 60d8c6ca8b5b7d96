//! Beams that engineers have: nearly all are certified, and no certified number differs from that of finite elements.

mod general;
mod guide;
mod supports;

use std::collections::BTreeMap;
use std::fmt::Debug;

use palkki::route::{Solution, Status};
use palkki::scene::file::{ReadProblem, parse};
use palkki::solve_exactly;
use palkki_evidence::elements::{Found, Numbers, Reference, Shares, reference};
use palkki_evidence::practice::Family;
use palkki_evidence::random::{draws_all, rare_sample_of};

use crate::support::assert_table;

/// What is certified is guaranteed to this share of the largest of its kind.
const CERTIFIED: f64 = 1e-6;

/// Moments are not certified, and finite elements share a force between two nodes by both.
const MOMENTS: f64 = 1e-4;

/// Both meshes of the reference are at least this close in forces, deflections and energy: an error of 3e-4 shows in every case, and one of 1e-4 in
/// nearly all. Only ground that holds the slope of a bridge beside a support, with a large force up and one down, needs more than 2e-5.
const SHARP: f64 = 1e-4;

/// Of the cases of a family with an answer as many are certified, in thousandths; of free beams on soil all are.
const WANTED: u32 = 995;

/// What became of the cases of a family.
#[derive(Debug, Default)]
struct Count {
    cases: u32,
    /// Refused, and rightly: there is no answer.
    without: u32,
    /// Refused or not certified though there is one, by reason.
    lost: [BTreeMap<String, u32>; 2],
    certified: u32,
    apart: Shares,
    estimate: Shares,
    wrong: Vec<String>,
}

/// Cases of which finite elements have fewer digits than the difference of their meshes says: contact beside a support, and short zones. The
/// proven brackets are far narrower.
const COARSE: [(Family, u32); 5] = [
    (Family::Bridges, 132),
    (Family::PipesOnRock, 184),
    (Family::PipesOnRock, 245),
    (Family::PipesOnSoil, 10),
    (Family::PipesOnSoil, 214),
];

/// As near they come there.
const NEAR: f64 = 2e-4;

/// The name of a variant, and of the one within it.
fn kind(error: &impl Debug) -> String {
    let told = format!("{error:?}");
    let variants = told.split(|c: char| !c.is_alphanumeric()).filter(|word| word.starts_with(char::is_uppercase));
    variants.filter(|word| !["Scene", "Number"].contains(word)).take(1).collect()
}

/// The numbers of an answer at the places of a reference.
fn numbers(solution: &Solution, reference: &Reference) -> Numbers {
    let (state, exact) = (&solution.state, solution.exact.as_ref().expect("functions"));
    Numbers {
        supports: state.supports.iter().map(|support| support.force).collect(),
        contact: state.contact_force(),
        energy: state.energy,
        length: reference.numbers.length,
        deflections: reference.places.iter().map(|x| exact.deflection(*x)).collect(),
        moments: reference.places.iter().map(|x| Some(exact.moment(*x))).collect(),
    }
}

/// Whether numbers are farther from the reference than what is certified of them and twice what its meshes differ by: the first mesh is
/// much coarser, so that nearly all of their difference is its own error.
fn differ(reference: &Reference, numbers: &Numbers, is_coarse: bool) -> Option<String> {
    let apart = reference.numbers.apart(numbers);
    let own = if is_coarse { [NEAR; 4] } else { [CERTIFIED, CERTIFIED, CERTIFIED, MOMENTS] };
    let within: Vec<f64> = own.iter().zip(reference.estimate).map(|(own, estimate)| own + 2.0 * estimate).collect();
    let known = |k: usize| apart[k] <= within[k];
    (!(0..4).all(known)).then(|| format!("off by {apart:?} of what may be {within:?}"))
}

impl Count {
    fn add(&mut self, i: u32, text: &str, is_coarse: bool) {
        self.cases += 1;
        let read = parse("scene.toml", text, |_| Err(ReadProblem::Missing));
        let solved = read
            .map_err(|error| kind(&error.problem))
            .and_then(|scene| solve_exactly(&scene).map_err(|error| kind(&error)));
        let refusal = match &solved {
            Err(kind) => Some((0, kind.clone())),
            Ok(solution) if solution.verdict.status == Status::Certified => None,
            Ok(solution) => Some((1, solution.verdict.refusal.as_ref().map_or_else(String::new, kind))),
        };
        match (reference(text), solved, refusal) {
            (Found::NoAnswer, Err(_), _) => self.without += 1,
            (_, _, Some((how, kind))) => *self.lost[how].entry(kind).or_default() += 1,
            (Found::Answer(reference), Ok(solution), None) => {
                self.compare(i, &reference, &numbers(&solution, &reference), is_coarse)
            }
            (found, ..) => self.wrong.push(format!("{i}: certified, and {found:?}")),
        }
    }

    fn compare(&mut self, i: u32, reference: &Reference, numbers: &Numbers, is_coarse: bool) {
        self.certified += 1;
        let largest = |sums: &mut Shares, shares: Shares| sums.iter_mut().zip(shares).for_each(|(a, b)| *a = b.max(*a));
        largest(&mut self.apart, reference.numbers.apart(numbers));
        largest(&mut self.estimate, reference.estimate);
        self.wrong.extend(differ(reference, numbers, is_coarse).map(|differ| format!("{i}: {differ}")));
    }

    /// With the counts of other cases of the family.
    fn row(&self, name: &str) -> String {
        let reasons = self.lost.each_ref().map(|lost| {
            let reasons: Vec<String> = lost.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
            if reasons.is_empty() { "-".to_owned() } else { reasons.join(", ") }
        });
        let [forces, deflections, energy, moments] = self.apart.map(told);
        let estimate = told(self.estimate[..3].iter().fold(0.0, |most: f64, share| most.max(*share)));
        format!(
            "{name:<21} {:>5} {:>9} {:>15} {:>20} {:>9} {forces:>11} {deflections:>11} {energy:>11} {moments:>11} {estimate:>11}",
            self.cases, self.without, reasons[0], reasons[1], self.certified
        )
    }
}

/// A share as a table has it: what is far below what is certified is rounding.
fn told(share: f64) -> String {
    if share < 1e-8 { "below 1e-8".to_owned() } else { format!("{share:.1e}") }
}

/// The row of the first quarter of a family, if so many are drawn, and what is wrong with those that are.
fn tried(family: Family, cases: u32) -> (String, Vec<String>) {
    let (mut count, mut pinned) = (Count::default(), String::new());
    for i in 0..rare_sample_of(cases) {
        count.add(i, &family.case(i).text(), COARSE.contains(&(family, i)));
        if count.cases == cases / 4 {
            pinned = count.row(family.name());
        }
    }
    if !count.estimate[..3].iter().all(|estimate| *estimate <= SHARP) {
        count.wrong.push("the reference is too coarse".to_owned());
    }
    let wanted = if family == Family::FreeBeams { 1000 } else { WANTED };
    if 1000 * count.certified < wanted * (count.cases - count.without) {
        count.wrong.push("too few are certified".to_owned());
    }
    let row = count.row(family.name());
    (pinned, count.wrong.into_iter().map(|wrong| format!("{row}\n{wrong}")).collect())
}

/// The head of a table.
fn head() -> String {
    let heads =
        ["forces", "deflections", "energy", "moments", "both meshes"].map(|head| format!("{head:>11}")).join(" ");
    format!("{:<21} cases no answer {:>15} {:>20} certified {heads}", "", "refused", "not certified")
}

/// The table has the first quarter of each family, of which a sixteenth is no part that it could be compared with.
#[test]
fn beams_in_practice_are_certified_and_right() {
    let head = head();
    let families = std::thread::scope(|scope| {
        Family::ALL
            .map(|(family, cases)| scope.spawn(move || tried(family, cases)))
            .map(|family| family.join().expect("no panic"))
    });
    let rows = families.each_ref().map(|(row, _)| row.as_str()).join("\n");
    let wrong: Vec<String> = families.into_iter().flat_map(|(_, wrong)| wrong).collect();
    assert!(wrong.is_empty(), "{head}\n{rows}\n{wrong:#?}");
    if !draws_all() {
        return;
    }
    assert_table!(
        "practice",
        "What becomes of beams in practice, by families; differences from finite elements as shares of the largest of a kind",
        format!("{head}\n{rows}\n")
    );
}

/// Each number that is moved by 1e-4 of the largest of its kind, a moment by 1e-3, differs from the reference; of a pipe on rock, where
/// [`reference`] knows moments to 1e-2, by 3e-2.
#[test]
fn a_wrong_number_of_a_beam_in_practice_shows() {
    let mut moved = 0;
    for (family, _) in Family::ALL {
        for case in (0..4).map(|i| family.case(i)) {
            let Found::Answer(reference) = reference(&case.text()) else { continue };
            let right = reference.numbers.clone();
            assert_eq!(differ(&reference, &right, false), None);
            let size = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            let forces = size(&right.supports).max(right.contact);
            let moments: Vec<f64> = right.moments.iter().flatten().copied().collect();
            let mut wrong = vec![right.clone(); 4];
            match wrong[0].supports.last_mut() {
                Some(force) => *force += 1e-4 * forces,
                None => wrong[0].contact -= 1e-4 * forces,
            }
            wrong[1].energy *= 1.0 + 1e-4;
            wrong[2].deflections[5] += 1e-4 * size(&right.deflections);
            let part = if family == Family::PipesOnRock { 3e-2 } else { 1e-3 };
            let inside = wrong[3].moments.iter_mut().flatten().next();
            *inside.expect("a moment") += part * size(&moments);
            for (what, wrong) in wrong.iter().enumerate() {
                let told = format!("{}, {what}: {:?}", family.name(), reference.estimate);
                assert!(differ(&reference, wrong, false).is_some(), "{told}");
                moved += 1;
            }
        }
    }
    assert!(100 <= moved, "{moved}");
}
