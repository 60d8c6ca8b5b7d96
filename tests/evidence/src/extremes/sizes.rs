//! Sizes: few and many intervals, depths of every size beside the sag of the beam, waves, pits.

use super::{Extreme, Known, extreme};
use crate::closed::{flat, parabola};
use crate::draft::Draft;
use crate::paper::{LENGTH, STIFFNESS, UNIFORM};
use palkki::scene::{Foundation, SceneError};

/// Powers of ten of `EI u₀/(q l⁴)`.
pub const POWERS: [i32; 20] =
    [-300, -200, -100, -54, -40, -24, -16, -12, -10, -8, -6, -5, -4, -3, -2, 0, 4, 16, 100, 300];
/// Numbers of intervals: the fewest, odd and even ones, a prime.
pub const INTERVALS: [usize; 7] = [2, 3, 4, 5, 7, 31, 100];

/// A flat foundation with `EI u₀/(q l⁴)` a power of ten, for a beam of length 1, stiffness 1 and load 1.
///
/// # Errors
///
/// A [`SceneError`] where the depth leaves the range of `f64`.
pub fn deep(power: i32) -> Result<Extreme, SceneError> {
    // In two factors, since 10⁻³⁰⁰ has no neighbour to be divided by.
    let half = power / 2;
    let depth = ten_to(half) * ten_to(power - half);
    let parts = Draft { length: 1.0, stiffness: 1.0, ..Draft::over(Foundation::Flat { depth }) };
    extreme(format!("flat, EI u₀/(q l⁴) = 1e{power}"), "closed form", &parts, flat(1.0, 1.0, depth, 1.0).into())
}

/// A power of ten.
fn ten_to(power: i32) -> f64 {
    libm::exp10(f64::from(power))
}

/// Sizes other than those of [`deep`].
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene is not well posed.
pub fn sizes() -> Result<Vec<Extreme>, SceneError> {
    let kinds = [intervals()?, lift_off_within_an_interval()?, next_to_nothing()?, out_of_reach()?, dishes()?];
    Ok(kinds.into_iter().flatten().collect())
}

/// Beam theory for the example above a flat foundation.
fn above(depth: f64) -> Known {
    flat(LENGTH, STIFFNESS, depth, UNIFORM).into()
}

/// A scene with the beam and the load of the example, on a grid.
fn over(
    name: String,
    authority: &'static str,
    foundation: Foundation,
    known: Known,
    intervals: usize,
) -> Result<Extreme, SceneError> {
    Ok(Extreme { intervals, ..extreme(name, authority, &Draft::over(foundation), known)? })
}

fn intervals() -> Result<Vec<Extreme>, SceneError> {
    let example = |n| {
        let name = format!("the example on {n} intervals");
        over(name, "closed form", Foundation::Flat { depth: 1.0 }, above(1.0), n)
    };
    INTERVALS.into_iter().map(example).collect()
}

/// Of the example itself `a = 2.364`: on 4 intervals and fewer its lift-off is shorter than one of them as well.
fn lift_off_within_an_interval() -> Result<Vec<Extreme>, SceneError> {
    let shallow = |(power, n)| {
        let depth = ten_to(power);
        let name = format!("lift-off shorter than one of {n} intervals, u₀ = 1e{power}");
        over(name, "closed form", Foundation::Flat { depth }, above(depth), n)
    };
    [(-4, 30), (-8, 30), (-12, 7)].into_iter().map(shallow).collect()
}

fn next_to_nothing() -> Result<Vec<Extreme>, SceneError> {
    // The beam touches at mid-span only, which is a node.
    let depth = 99.0;
    let touch = over("contact at one node".to_owned(), "closed form", Foundation::Flat { depth }, above(depth), 30)?;
    // A wave that carries next to nothing: by the principle of least energy |ΔJ| ≤ q l A, far below what is asked.
    let ripple = Foundation::Cosine { mean: 1.0, amplitude: 1e-15, wavelength: 5.0, phase: 0.0 };
    let wave = over("a wave of amplitude 1e-15".to_owned(), "flat, closed form", ripple, above(1.0), 30)?;
    Ok(vec![touch, wave])
}

/// Ground that the beam does not reach does not matter.
fn out_of_reach() -> Result<Vec<Extreme>, SceneError> {
    // Pits and cliffs beside the supports, inside the lift-off.
    let cliffs = [1e3, 1e6, 1e9, 1e12].into_iter().map(|depth: f64| {
        let points = vec![[0.0, depth], [1.0, depth], [1.0, 1.0], [9.0, 1.0], [9.0, depth], [10.0, depth]];
        let name = format!("steps of {depth:e} depths beside the supports");
        over(name, "flat, closed form", Foundation::Polyline { points }, above(1.0), 30)
    });
    // A crest that alone is in reach, at mid-span: F from the deflection there.
    let ridges = [1e8, 1e12, 1e15].into_iter().map(|deep: f64| {
        let (l, ei) = (LENGTH, STIFFNESS);
        let points = vec![[0.0, deep], [5.0, 50.0], [10.0, deep]];
        let force = 48.0 * ei / (l * l * l) * (100.0 - 50.0);
        let reaction = 0.5 * (l - force);
        let energy = -l * l * l * l * l / (240.0 * ei) + force * force * l * l * l / (96.0 * ei);
        let known = Known::symmetric(reaction, force, energy);
        let name = format!("ground {deep:e} deep but for a ridge");
        over(name, "closed form", Foundation::Polyline { points }, known, 30)
    });
    cliffs.chain(ridges).collect()
}

fn dishes() -> Result<Vec<Extreme>, SceneError> {
    let dish = |(depth, rise): (f64, f64)| {
        let closed = parabola(LENGTH, STIFFNESS, depth, rise, UNIFORM);
        let coefficients = vec![depth, 4.0 * rise / LENGTH, -4.0 * rise / (LENGTH * LENGTH)];
        let known = Known::symmetric(closed.reaction, closed.contact_force, closed.energy);
        let name = format!("a dish, {depth:e} deep with a rise of {rise:e}");
        over(name, "closed form", Foundation::Polynomial { coefficients }, known, 30)
    };
    [(1e-6, 1e-9), (1e-3, -1e-4), (1.0, 1e-12)].into_iter().map(dish).collect()
}
