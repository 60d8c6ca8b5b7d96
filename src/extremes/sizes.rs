//! Sizes: few and many intervals, depths of every size beside the sag of the beam, waves, pits.

use super::{Extreme, Parts, Truth, extreme};
use crate::scene::{Foundation, SceneError};
use crate::theory::closed::parabola;
use crate::theory::flat;

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
    let parts = Parts {
        length: 1.0,
        stiffness: 1.0,
        uniform: 1.0,
        linear: Vec::new(),
        point: Vec::new(),
        foundation: Some(Foundation::Flat { depth }),
    };
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
    let (l, ei) = (10.0, 500.0 / 384.0);
    let example = flat(l, ei, 1.0, 1.0);
    let mut found = Vec::new();
    let mut add = |name: String, authority, foundation, truth: Truth, intervals| -> Result<(), SceneError> {
        found.push(Extreme { intervals, ..extreme(name, authority, &Parts::over(foundation), truth)? });
        Ok(())
    };
    let one = || Foundation::Flat { depth: 1.0 };
    for n in INTERVALS {
        add(format!("the example on {n} intervals"), "closed form", one(), example.into(), n)?;
    }
    // a = 2.364: on 4 intervals and fewer the lift-off is shorter than one of them.
    for (power, n) in [(-4, 30), (-8, 30), (-12, 7)] {
        let depth = ten_to(power);
        let name = format!("lift-off shorter than one of {n} intervals, u₀ = 1e{power}");
        add(name, "closed form", Foundation::Flat { depth }, flat(l, ei, depth, 1.0).into(), n)?;
    }
    // The beam touches at mid-span only, which is a node.
    let touch = 99.0;
    add(
        "contact at one node".to_owned(),
        "closed form",
        Foundation::Flat { depth: touch },
        flat(l, ei, touch, 1.0).into(),
        30,
    )?;
    // A wave that carries next to nothing: by the principle of least energy |ΔJ| ≤ q l A, far below what is asked.
    let ripple = Foundation::Cosine { mean: 1.0, amplitude: 1e-15, wavelength: 5.0, phase: 0.0 };
    add("a wave of amplitude 1e-15".to_owned(), "flat, closed form", ripple, example.into(), 30)?;
    // Ground that the beam does not reach does not matter: pits and cliffs beside the supports, inside the lift-off.
    for depth in [1e3, 1e6, 1e9, 1e12] {
        let points = vec![[0.0, depth], [1.0, depth], [1.0, 1.0], [9.0, 1.0], [9.0, depth], [10.0, depth]];
        let name = format!("steps of {depth:e} depths beside the supports");
        add(name, "flat, closed form", Foundation::Polyline { points }, example.into(), 30)?;
    }
    // A crest that alone is in reach, at mid-span: F from the deflection there.
    for deep in [1e8, 1e12, 1e15] {
        let points = vec![[0.0, deep], [5.0, 50.0], [10.0, deep]];
        let force = 48.0 * ei / (l * l * l) * (100.0 - 50.0);
        let reaction = 0.5 * (l - force);
        let energy = -l * l * l * l * l / (240.0 * ei) + force * force * l * l * l / (96.0 * ei);
        let truth = Truth::symmetric(reaction, force, energy);
        add(
            format!("ground {deep:e} deep but for a ridge"),
            "closed form",
            Foundation::Polyline { points },
            truth,
            30,
        )?;
    }
    for (depth, rise) in [(1e-6, 1e-9), (1e-3, -1e-4), (1.0, 1e-12)] {
        let closed = parabola(l, ei, depth, rise, 1.0);
        let coefficients = vec![depth, 4.0 * rise / l, -4.0 * rise / (l * l)];
        let truth = Truth::symmetric(closed.reaction, closed.contact_force, closed.energy);
        add(
            format!("a dish, {depth:e} deep with a rise of {rise:e}"),
            "closed form",
            Foundation::Polynomial { coefficients },
            truth,
            30,
        )?;
    }
    Ok(found)
}
