//! The kernel beside fractions: its pair, made by other code and without rounding, and the energies that the checker of proofs finds.
//!
//! Of a beam's own list both energies are one number but for rounding, and the bracket of the kernel is as wide as its intervals.
//! Of a list that is wrong they are apart, and the gap that is proven has to be theirs. What makes the kernel wrong by a billionth
//! is found by one or the other: see `mutants.md`.

use std::cell::LazyCell;
use std::collections::BTreeMap;

use palkki::certificate::{Judged, certify};
use palkki::proof::{Fields, of_contacts};
use palkki::scene::Scene;
use palkki::state::Contact;
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Verdict};
use palkki_evidence::authority::number::Number;
use palkki_evidence::authority::{RANDOM, RBig};
use palkki_evidence::random;

use crate::proof::bracket;
use crate::scenes;

/// A bracket is wider than the energies are apart by at most so many units in the last place of the magnitudes that they are sums
/// of: *tuned* on the scenes below. Of half of them it is 300, and of the worst 43,000, where the terms of polynomials cancel.
const UNITS: f64 = 65_536.0;

/// A gap is a sum of squares of misfits; of most lists these are known to so many units in the last place of the root of the
/// magnitudes above: *tuned* on the lists below, of nine in ten of which it is 50.
const UNITS_OF_MISFIT: f64 = 128.0;

/// Of a span next to a support and shorter than a thousandth of the beam the square of its length is lost: *tuned* on the one list
/// below that has one, with 4e-5.
const SHORT_SPAN: f64 = 1e-4;

/// Energies that are farther apart, as a share of the magnitudes that they are sums of, are those of ground that is below a support by a
/// rounding: the kernel takes them for level.
const LEVEL: f64 = 1e-13;

/// What a list of contacts says of a scene, in fractions.
#[derive(Debug)]
struct Pair {
    upper: RBig,
    lower: RBig,
    is_lifted: bool,
    /// The sum of the magnitudes that `J(v̂)` is a sum of, in 64 bits.
    size: f64,
}

impl Pair {
    fn is_wide(&self) -> bool {
        LEVEL * self.size < (&self.upper - &self.lower).to_double()
    }
}

fn pair(scene: &Scene, contacts: &[Contact]) -> Result<Pair, String> {
    let proof = of_contacts(scene, contacts).map_err(|why| why.to_string())?;
    let [lower, upper] = bracket(scene, &proof)?;
    Ok(Pair { upper, lower, is_lifted: proof.is_lifted, size: size(scene, &proof) })
}

/// `½∫EI v''²`, `∫q v` and `Σ P v`, with magnitudes for values, by the midpoint rule on a few parts of each cell: its size is enough.
fn size(scene: &Scene, proof: &Fields) -> f64 {
    const PARTS: u8 = 8;
    let at = |p: &[f64], s: f64| p.iter().rev().fold(0.0, |sum: f64, c| sum * s + c);
    let mut sum = 0.0;
    for cell in &proof.cells {
        let [from, to] = cell.ends.each_ref().map(Number::to_double);
        let v: Vec<f64> = cell.deflection.iter().map(Number::to_double).collect();
        let moment: Vec<f64> = cell.moment.iter().map(Number::to_double).collect();
        let width = (to - from) / f64::from(PARTS);
        for s in (0..PARTS).map(|part| (f64::from(part) + 0.5) * width) {
            let line = |q: &palkki::scene::LinearLoad| {
                let share = (from + s - q.from) / (q.to - q.from);
                if (0.0..=1.0).contains(&share) { (q.start + (q.end - q.start) * share).abs() } else { 0.0 }
            };
            let load = scene.load().uniform().abs() + scene.load().linear().iter().map(line).sum::<f64>();
            let bend = at(&moment, s);
            sum += width * (0.5 * bend * bend / scene.beam().bending_stiffness() + load * at(&v, s).abs());
        }
        let points = scene.load().point().iter().filter(|load| from < load.at && load.at <= to);
        sum += points.map(|load| (load.force * at(&v, load.at - from)).abs()).sum::<f64>();
    }
    sum
}

/// Random scenes of three kinds.
fn random(i: u64) -> [(String, Scene); 3] {
    [("plain", random::scene(i)), ("held", random::held(i)), ("lattice", random::on_lattice(i))]
        .map(|(kind, scene)| (format!("{kind} {i}"), scene))
}

/// The bracket of the kernel has the energies of the pair in it, and is wider by rounding only; or why fractions say nothing.
#[track_caller]
fn by_its_own_list(name: &str, scene: &Scene, exact: &Exact) -> Result<(), String> {
    let pair = pair(scene, &exact.state.touched())?;
    if pair.is_wide() {
        return Err("level with a support but for rounding".to_owned());
    }
    let proven = Verdict::of_exact(scene, exact, &Demand::default()).certificate.expect("the scene can be scaled");
    let bracket = [proven.energy_lower, proven.energy_upper];
    assert!(bracket.iter().all(|energy| energy.is_finite()), "{name}: {bracket:?}");
    let ([lower, upper], energies) = (bracket.map(RBig::of), [&pair.lower, &pair.upper].map(Number::to_double));
    assert!(pair.lower <= pair.upper, "{name}: the energies are the wrong way round");
    assert!(lower <= pair.lower && pair.upper <= upper, "{name}: {energies:?} is not in {bracket:?}");
    let wider = ((upper - lower) - (pair.upper - pair.lower)).to_double();
    assert!(wider <= UNITS * f64::EPSILON * pair.size, "{name}: {bracket:?} is {wider:e} wider than {energies:?}");
    Ok(())
}

#[test]
fn scenes_of_the_report_in_fractions() {
    let other = "held/cantilever held/overhang held/pipe-sleeper held/pipe-step held/settlement held/ski held/table-edge \
        held/two-spans held/balanced swept/hoist";
    let other = other.split_whitespace().map(|name| (name.to_owned(), scenes::scene(name)));
    let mut left_out = Vec::new();
    for (name, scene) in scenes::report().into_iter().chain(other) {
        let exact = theory::solve(&scene).expect("beam theory has an answer");
        if let Err(why) = by_its_own_list(&name, &scene, &exact) {
            left_out.push(format!("{name}: {why}"));
        }
    }
    let why = ["free", "hollows", "hump", "sill", "wave", "held/balanced"].into_iter().zip([
        "cosine",
        "cosine",
        "cosine",
        "level with a support but for rounding",
        "cosine",
        "may turn",
    ]);
    assert_eq!(left_out.len(), why.len(), "{left_out:?}");
    for (found, (name, why)) in left_out.iter().zip(why) {
        assert!(found.starts_with(&format!("{name}: ")) && found.contains(why), "{found}: {name}, {why}");
    }
}

#[test]
fn a_thousand_random_scenes_in_fractions() {
    let scenes = random::sample_of(RANDOM);
    let (mut said, mut unsaid) = (0, BTreeMap::<String, usize>::new());
    for (name, scene) in (0..).flat_map(random) {
        let Ok(exact) = theory::solve(&scene) else { continue };
        match by_its_own_list(&name, &scene, &exact) {
            Ok(()) => said += 1,
            // In fractions there is no admissible deflection.
            Err(why) if why.contains("cosine") || why.contains("above the support") => {}
            Err(why) => *unsaid.entry(why).or_default() += 1,
        }
        if said == scenes {
            break;
        }
    }
    // Mostly ground that is below a support by a rounding.
    assert!(20 * unsaid.values().sum::<usize>() < said, "{unsaid:?}");
}

/// Lists with all places off by a share: where they are admissible, the gap that is proven is that of the pair.
#[test]
fn gaps_of_wrong_lists_in_fractions() {
    let (mut known, mut sharp, mut lists) = (0, 0, 0);
    for (name, scene) in (90..200).flat_map(random) {
        let Ok(exact) = theory::solve(&scene) else { continue };
        // Ground that is level with a support but for rounding is another problem in fractions.
        if pair(&scene, &exact.state.touched()).is_ok_and(|own| own.is_wide()) {
            continue;
        }
        let of_none = LazyCell::new(|| pair(&scene, &[]));
        for off in [1e-4, 1e-2] {
            let mut list = exact.state.contacts.clone();
            for contact in &mut list {
                let far = if contact.from < contact.to { 0.5 } else { 1.0 };
                (contact.from, contact.to) = (contact.from * (1.0 - off), contact.to * (1.0 - far * off));
            }
            let Ok(pair) = pair(&scene, &list) else { continue };
            let proven = certify(&scene, Judged::Witness, &list).expect("the scene can be scaled");
            lists += 1;
            // Both have the energy of the beam between them, whatever the kernel corrects.
            let [lower, upper] = [proven.energy_lower, proven.energy_upper];
            let meet = |below: &RBig, above: f64| above.is_infinite() || *below <= RBig::of(above);
            assert!(meet(&pair.lower, upper) && meet(&-pair.upper.clone(), -lower), "{name}: {proven:?}, {pair:?}");
            let gap = (&pair.upper - &pair.lower).to_double();
            let misfit = f64::EPSILON * (pair.size / gap).sqrt();
            let is_better = |none: &Pair| (&none.upper - &none.lower).to_double() < gap;
            // The kernel takes the better one of the list and of none.
            if pair.is_lifted || misfit.is_nan() || 1e-6 < misfit || of_none.as_ref().is_ok_and(is_better) {
                continue;
            }
            let wider = proven.gap / gap - 1.0;
            assert!((0.0..=SHORT_SPAN).contains(&wider), "{name}, {off}: {:e} beside {gap:e}", proven.gap);
            (known, sharp) = (known + 1, sharp + usize::from(wider <= UNITS_OF_MISFIT * misfit));
        }
    }
    assert!(300 < lists && 40 <= known && 9 * known <= 10 * sharp, "{sharp} of {known} of {lists}");
}
