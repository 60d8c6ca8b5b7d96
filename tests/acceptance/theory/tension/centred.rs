//! Contacts at or next to a position where the beam is divided: under an axial force in the middle of a symmetric beam, and under a load.

use std::f64::consts::PI;

use palkki::verdict::Status;
use palkki_evidence::random::{Random, sample_of};

use crate::theory::general::scene;

/// A simple beam under its own weight above a foundation at a share of its deflection without contact, under a share of its buckling load.
fn strut([length, stiffness, pull, load, share, force]: [f64; 6], foundation: impl Fn(f64) -> String) -> String {
    let tension = pull * PI * PI * stiffness / (length * length);
    let depth =
        share * (5.0 * load * length + 8.0 * force) * length * length * length / 384.0 / stiffness / (1.0 + pull);
    format!(
        "[beam]\nlength = {length:?}\nbending_stiffness = {stiffness:?}\ntension = {tension:?}\n[load]\nuniform = {load:?}\n\
         point = [{{ at = {:?}, force = {force:?} }}]\n[foundation]\n{}\n",
        0.5 * length,
        foundation(depth)
    )
}

/// Symmetric beams touch in their middle, where a part ends and a load stands: one rounding of the contact must not decide its force.
#[test]
fn symmetric_beams_under_an_axial_force_are_certified_and_symmetric() {
    const CASES: u32 = 600;
    let mut random = Random::new(20);
    for i in 0..sample_of(CASES) {
        let length = [1.0, 3.28, 12.0, 1000.0][random.below(4)];
        let pull = if random.below(4) == 0 { random.between(0.2, 9.0) } else { random.between(-0.95, -0.05) };
        let (stiffness, load) = (10_f64.powf(random.between(0.0, 6.0)), 10_f64.powf(random.between(-3.0, 1.0)));
        let force = if random.below(2) == 0 { 0.0 } else { 0.3 * load * length };
        let wave = length / 3.0;
        let text = strut([length, stiffness, pull, load, random.between(0.1, 0.9), force], |depth| match i % 2 {
            0 => format!("depth = {depth:?}"),
            _ => format!("cosine = {{ mean = {depth:?}, amplitude = {:?}, wavelength = {wave:?} }}", 0.2 * depth),
        });
        let solution = palkki::solve_exactly(&scene(&text)).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{i}: {}\n{text}", solution.verdict);
        let supports = &solution.state.supports;
        let total = supports[0].force.abs() + supports[1].force.abs() + solution.state.contact_force();
        assert!((supports[0].force - supports[1].force).abs() <= 1e-11 * total, "{i}: {supports:?}\n{text}");
    }
}

/// A load without force divides a beam under an axial force and changes nothing, however near to a contact it stands.
#[test]
fn a_load_without_force_beside_a_contact_changes_nothing() {
    for pull in [-0.7, -0.3, 2.0, 6.0] {
        for more in [0.4, 1.0] {
            let with = |place: f64| {
                let text = strut([1.0, 1.0, pull, 1.0, 0.6, 0.0], |depth| format!("depth = {depth:?}"));
                let linear =
                    format!("uniform = 1.0\nlinear = [{{ from = 0.0, to = 1.0, start = 0.0, end = {more:?} }}]\n");
                let text = text.replace("uniform = 1.0\n", &linear);
                palkki::solve_exactly(&scene(&text.replace("at = 0.5,", &format!("at = {place:?},"))))
                    .expect("an answer")
            };
            let alone = with(0.01);
            let at = alone.state.contacts[0].from;
            for power in 5..17 {
                for side in [-1.0, 1.0] {
                    let beside = with(at + side * 10_f64.powi(-power));
                    let verdict = &beside.verdict;
                    assert_eq!(verdict.status, Status::Certified, "{pull} {more} {side} {power}: {verdict}");
                    let [a, b] = [&alone, &beside].map(|solution| solution.state.contact_force());
                    assert!((a - b).abs() <= 1e-10 * a, "{pull} {more} {side} {power}: {a} {b}");
                }
            }
        }
    }
}
