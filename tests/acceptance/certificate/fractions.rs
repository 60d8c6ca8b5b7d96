//! The kernel beside fractions: its pair and the energies of it, made by other code and without rounding.
//!
//! Of a beam's own list both energies are one number but for rounding, and the bracket of the kernel is as wide as its intervals.
//! Of a list that is wrong they are apart, and the gap that is proven has to be theirs. What makes the kernel wrong by a billionth
//! is found by one or the other: see `mutants.md`.

use std::cell::LazyCell;
use std::collections::BTreeMap;

use palkki::certificate::{Judged, certify};
use palkki::scene::Scene;
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Verdict};
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::energies::Unsaid;
use palkki_evidence::authority::number::Number;
use palkki_evidence::authority::pair::{Pair, RANDOM, pair};
use palkki_evidence::random;

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

/// Random scenes of three kinds.
fn random(i: u64) -> [(String, Scene); 3] {
    [("plain", random::scene(i)), ("held", random::held(i)), ("lattice", random::on_lattice(i))]
        .map(|(kind, scene)| (format!("{kind} {i}"), scene))
}

/// The bracket of the kernel has the energies of the pair in it, and is wider by rounding only; or why fractions say nothing.
#[track_caller]
fn by_its_own_list(name: &str, scene: &Scene, exact: &Exact) -> Result<(), Unsaid> {
    let pair = pair(scene, &exact.state.touched())?;
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
    let cosines = ["free: a cosine", "hollows: a cosine", "hump: a cosine", "wave: a cosine"];
    assert_eq!(left_out, [&cosines[..], &["held/balanced: a beam that may turn"]].concat());
}

#[test]
fn a_thousand_random_scenes_in_fractions() {
    let scenes = random::sample_of(RANDOM);
    let (mut said, mut unsaid) = (0, BTreeMap::<Unsaid, usize>::new());
    for (name, scene) in (0..).flat_map(random) {
        let Ok(exact) = theory::solve(&scene) else { continue };
        match by_its_own_list(&name, &scene, &exact) {
            Ok(()) => said += 1,
            Err(why) => *unsaid.entry(why).or_default() += 1,
        }
        if said == scenes {
            break;
        }
    }
    unsaid.remove("a cosine");
    // Mostly a couple at a support that ground beside it does not make but for rounding.
    assert!(20 * unsaid.values().sum::<usize>() < said, "{unsaid:?}");
}

/// Lists with all places off by a share: where they are admissible, the gap that is proven is that of the pair.
#[test]
fn gaps_of_wrong_lists_in_fractions() {
    let (mut known, mut sharp, mut lists) = (0, 0, 0);
    for (name, scene) in (90..200).flat_map(random) {
        let Ok(exact) = theory::solve(&scene) else { continue };
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
    assert!(300 < lists && 40 < known && 9 * known <= 10 * sharp, "{sharp} of {known} of {lists}");
}
