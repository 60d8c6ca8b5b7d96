//! What a certificate says, against closed forms, in a scene in which no unit is one.

use palkki::certificate::{Certificate, stiffness};
use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene};

use super::of_forces;
use crate::scenes::uniform;

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
const LOAD: f64 = 3.0;
/// Of some dozens of roundings, outwards.
const ROUNDING: f64 = 1e-11;
/// A bound on the square of which rounding is small.
const ROOT: f64 = 1e-5;

#[track_caller]
fn is(what: &str, number: f64, expected: f64, tolerance: f64) {
    assert!((number - expected).abs() <= tolerance * expected.abs(), "{what}: {number}, not {expected}");
}

/// The energy of the free beam, `−q² l⁵/240 EI`.
fn energy() -> f64 {
    -LOAD * LOAD * LENGTH * LENGTH * LENGTH * LENGTH * LENGTH / (240.0 * STIFFNESS)
}

/// Its largest deflection, `5 q l⁴/384 EI`.
fn sag() -> f64 {
    5.0 * LOAD * LENGTH * LENGTH * LENGTH * LENGTH / (384.0 * STIFFNESS)
}

/// Above ground that it does not reach, under forces that are not there.
fn certified(depth: f64, forces: &[(f64, f64)]) -> Certificate {
    let scene = uniform(LENGTH, STIFFNESS, LOAD, Foundation::Flat { depth });
    of_forces(&scene, forces, &[])
}

/// No force is right: all is known, the stiffness `120 EI/l³` of the beam as well.
#[test]
fn a_free_beam_is_known() {
    let certificate = certified(100.0, &[]);
    is("energy from below", certificate.energy_lower, energy(), ROUNDING);
    is("energy from above", certificate.energy_upper, energy(), ROUNDING);
    is("deflection", certificate.deflection, sag(), ROUNDING);
    assert!(certificate.energy_lower <= certificate.energy_upper && certificate.deflection_error <= ROOT * sag());
    assert!(certificate.contacts_proven);
    for reaction in certificate.reactions {
        let [least, most] = reaction.expect("nothing is near the supports");
        assert!(least <= 0.5 * LOAD * LENGTH && 0.5 * LOAD * LENGTH <= most, "{least} to {most}");
        is("reaction", most, least, ROOT);
    }
    let [least, most] = certificate.stiffness.expect("the energy is negative");
    let stiffness = 120.0 * STIFFNESS / (LENGTH * LENGTH * LENGTH);
    assert!(least <= stiffness && stiffness <= most, "{stiffness} in {least} to {most}");
    is("stiffness", most, least, ROUNDING);
}

/// A force `F` at mid-span, above ground that the beam does not reach. It would lift the beam by `F l³/48 EI`.
#[test]
fn a_force_that_is_not_there_is_seen() {
    let (depth, force) = (100.0, 10.0);
    let certificate = certified(depth, &[(0.5 * LENGTH, force)]);
    let lifted = force * LENGTH * LENGTH * LENGTH / (48.0 * STIFFNESS);
    is("energy from above", certificate.energy_upper, energy(), ROUNDING);
    is("energy from below", certificate.energy_lower, energy(), ROUNDING);
    is("deflection", certificate.deflection, sag() - lifted, ROUNDING);
    // The range of a cubic on an eighth of half the beam.
    assert!((lifted..1.02 * lifted).contains(&certificate.deflection_error), "{certificate:?}");
    assert!(certificate.best_deflection_error <= ROOT * sag(), "{certificate:?}");
    assert!((0.25 * LENGTH..=0.75 * LENGTH).contains(&certificate.deflection_error_at), "{certificate:?}");
}

/// A load of points at mid-span.
fn points(forces: &[f64]) -> Load {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let point = forces.iter().map(|&force| PointLoad { at: 0.5 * LENGTH, force }).collect();
    Load::new(&beam, 0.0, Vec::new(), point).expect("finite loads on the beam")
}

#[test]
fn without_an_energy_there_is_no_stiffness() {
    let load = points(&[2.0, 4.0]);
    assert_eq!(stiffness([-1.0, 0.0], &load, LENGTH), None);
    assert_eq!(stiffness([-1.0, 1.0], &load, LENGTH), None);
    assert_eq!(stiffness([f64::NEG_INFINITY, -1.0], &load, LENGTH), None);
    let [least, most] = stiffness([-4.0, -1.0], &load, LENGTH).expect("negative energies");
    assert!(least <= 4.5 && 18.0 <= most, "{least} to {most}");
    is("from below", least, 4.5, ROUNDING);
    is("from above", most, 18.0, ROUNDING);
}

/// Beside two forces that cancel, a resultant of 6 is lost to rounding: nothing may be said that needs it.
#[test]
fn a_resultant_that_cancels_bounds_no_stiffness_wrongly() {
    for forces in [[1e17, 6.0, -1e17], [1e15, -1e15, 6.0], [-1e16, 1e16 + 2.0, 4.0]] {
        let [least, most] = stiffness([-4.0, -1.0], &points(&forces), LENGTH).expect("negative energies");
        assert!((0.0..=4.5).contains(&least) && 18.0 <= most, "{forces:?}: {least} to {most}");
    }
}

/// A beam without a foundation under some load, and what is certified of it.
fn free(linear: &[[f64; 4]], point: &[(f64, f64)]) -> Certificate {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let linear = linear.iter().map(|&[from, to, start, end]| LinearLoad { from, to, start, end }).collect();
    let point = point.iter().map(|&(at, force)| PointLoad { at, force }).collect();
    let load = Load::new(&beam, 0.0, linear, point).expect("finite loads on the beam");
    let scene = Scene::new(beam, load, None).expect("well posed");
    of_forces(&scene, &[], &[])
}

#[track_caller]
fn same(one: &Certificate, other: &Certificate) {
    is("energy", one.energy_lower, other.energy_lower, ROUNDING);
    is("deflection", one.deflection, other.deflection, ROUNDING);
    for (one, other) in one.reactions.iter().zip(&other.reactions) {
        let ([a, b], [c, d]) = (one.expect("no ground"), other.expect("no ground"));
        assert!((a - c).abs().max((b - d).abs()) <= ROUNDING * d.abs(), "{one:?}, not {other:?}");
    }
}

/// `J = −P² a² b²/6 EI l`, reactions `P b/l` and `P a/l`.
#[test]
fn a_load_is_the_sum_of_its_parts() {
    let point = free(&[], &[(8.0, 5.0)]);
    is("energy", point.energy_upper, -25.0 * 64.0 * 144.0 / (6.0 * STIFFNESS * LENGTH), ROUNDING);
    for (reaction, expected) in point.reactions.iter().zip([3.0, 2.0]) {
        let [least, most] = reaction.expect("no ground");
        assert!(least <= expected && expected <= most && most - least <= ROUNDING, "{least} to {most}, not {expected}");
    }
    same(&free(&[], &[(8.0, 2.0), (8.0, 4.0), (8.0, -1.0)]), &point);
    let trapezoid = free(&[[2.0, 14.0, 1.0, 7.0]], &[]);
    same(&free(&[[2.0, 6.0, 1.0, 3.0], [6.0, 14.0, 3.0, 7.0]], &[]), &trapezoid);
    same(&free(&[[2.0, 14.0, 1.0, 1.0], [2.0, 14.0, 0.0, 6.0]], &[]), &trapezoid);
    same(&free(&[[2.0, 14.0, 1.0, 4.0], [2.0, 6.0, 0.0, 1.0], [6.0, 14.0, 1.0, 3.0]], &[]), &trapezoid);
}
