//! Borders: the changes of regime and one unit in the last place to either side, contact without pressure, depth 0, loads
//! that are zero, upward, in balance, at a support, at a kink.

use super::{Extreme, Known, extreme};
use crate::closed::{flat, incline, lifted, parabola};
use crate::draft::Draft;
use crate::paper::{LENGTH as L, STIFFNESS as EI};
use palkki::scene::{Foundation, LinearLoad, SceneError};

/// All of them.
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene is not well posed.
pub fn borders() -> Result<Vec<Extreme>, SceneError> {
    let mut found = regimes()?;
    found.extend(lift_off_at_a_node()?);
    found.extend(without_pressure()?);
    found.extend(at_supports()?);
    found.extend(loads()?);
    Ok(found)
}

fn mirrored(reaction: f64, contact: f64) -> Known {
    Known { reactions: [reaction; 2], contact_force: contact, energy: None }
}

/// `u₀` at `q l⁴/(384 EI)`, where a zone begins, and at five times that, where contact ends.
fn regimes() -> Result<Vec<Extreme>, SceneError> {
    let unit = L * L * L * L / (384.0 * EI);
    let mut found = Vec::new();
    for (name, border) in [("a zone begins", unit), ("contact ends", 5.0 * unit)] {
        for (where_, depth) in
            [("at", border), ("one ulp above", border.next_down()), ("one ulp below", border.next_up())]
        {
            let known = flat(L, EI, depth, 1.0).into();
            found.push(extreme(
                format!("flat, {where_} the depth where {name}"),
                "closed form",
                &Draft::over(Foundation::Flat { depth }),
                known,
            )?);
        }
    }
    // The same border of a crest, and of a dish from the supports that the free beam just fills.
    for rise in [-9.0, -5.0, 5.0] {
        let depth = 100.0 - rise;
        let closed = parabola(L, EI, depth, rise, 1.0);
        let coefficients = vec![depth, 4.0 * rise / L, -4.0 * rise / (L * L)];
        let known = mirrored(closed.reaction, closed.contact_force);
        found.push(extreme(
            format!("a parabola that the free beam just touches, rise {rise}"),
            "closed form",
            &Draft::over(Foundation::Polynomial { coefficients }),
            known,
        )?);
    }
    Ok(found)
}

/// `a⁴ = 24 EI u₀/q` with `a` the third of 30 intervals, and a step of the foundation there.
fn lift_off_at_a_node() -> Result<Vec<Extreme>, SceneError> {
    let mut found = Vec::new();
    for a in [1.0, 2.5, 4.0] {
        let depth = a * a * a * a / (24.0 * EI);
        for (name, u) in [("at", depth), ("one ulp before", depth.next_down()), ("one ulp behind", depth.next_up())] {
            let known = flat(L, EI, u, 1.0).into();
            let made = extreme(
                format!("lift-off {name} the node {a}"),
                "closed form",
                &Draft::over(Foundation::Flat { depth: u }),
                known,
            )?;
            found.push(Extreme { intervals: 20, ..made });
        }
        let points = vec![
            [0.0, 2.0 * depth],
            [a, 2.0 * depth],
            [a, depth],
            [L - a, depth],
            [L - a, 2.0 * depth],
            [L, 2.0 * depth],
        ];
        let known = flat(L, EI, depth, 1.0).into();
        let made = extreme(
            format!("a step exactly at lift-off, {a}"),
            "flat, closed form",
            &Draft::over(Foundation::Polyline { points }),
            known,
        )?;
        found.push(Extreme { intervals: 20, ..made });
    }
    Ok(found)
}

/// `u = v` of the free beam: contact without pressure everywhere, and `q = EI u''''`.
fn without_pressure() -> Result<Vec<Extreme>, SceneError> {
    let mut found = Vec::new();
    let free = mirrored(0.5 * L, 0.0);
    for (name, share) in [("equal to the free deflection", 1.0), ("a millionth below the free deflection", 1.000_001)] {
        // v = q/(24 EI) (x⁴ − 2 l x³ + l³ x).
        let c = share / (24.0 * EI);
        let coefficients = vec![0.0, c * L * L * L, 0.0, -2.0 * c * L, c];
        found.push(extreme(
            format!("a foundation {name}"),
            "statics",
            &Draft::over(Foundation::Polynomial { coefficients }),
            free,
        )?);
    }
    // No load on flat ground at depth 0: nothing moves.
    let idle = Draft { uniform: 0.0, ..Draft::over(Foundation::Flat { depth: 0.0 }) };
    found.push(extreme("no load, ground at depth 0", "statics", &idle, mirrored(0.0, 0.0))?);
    let far = Draft { uniform: 0.0, ..Draft::over(Foundation::Flat { depth: 1.0 }) };
    found.push(extreme("no load, ground below", "statics", &far, mirrored(0.0, 0.0))?);
    // A load on a part of the beam that lies on ground at depth 0: the rest is a zone without pressure.
    let mut part = Draft { uniform: 0.0, ..Draft::over(Foundation::Flat { depth: 0.0 }) };
    part.linear = vec![LinearLoad { from: 4.0, to: 6.0, start: 1.0, end: 1.0 }];
    let known = Known { energy: Some(0.0), ..mirrored(0.0, 2.0) };
    found.push(extreme("a load on a part of a beam at depth 0", "statics", &part, known)?);
    Ok(found)
}

/// Foundations at depth 0 at one support or both.
fn at_supports() -> Result<Vec<Extreme>, SceneError> {
    let mut found = Vec::new();
    found.push(extreme(
        "flat ground at depth 0",
        "statics",
        &Draft::over(Foundation::Flat { depth: 0.0 }),
        Known { energy: Some(0.0), ..mirrored(0.0, L) },
    )?);
    for (name, depths) in [("left", [0.0, 0.5]), ("right", [0.5, 0.0])] {
        if let Some(closed) = incline(L, EI, depths, 1.0) {
            let coefficients = vec![depths[0], (depths[1] - depths[0]) / L];
            let known =
                Known { reactions: closed.reactions, contact_force: closed.contact_force, energy: Some(closed.energy) };
            found.push(extreme(
                format!("an incline from depth 0 at the {name} support"),
                "closed form",
                &Draft::over(Foundation::Polynomial { coefficients }),
                known,
            )?);
        }
    }
    for rise in [5.0, 70.0, 120.0] {
        let closed = parabola(L, EI, 0.0, rise, 1.0);
        let coefficients = vec![0.0, 4.0 * rise / L, -4.0 * rise / (L * L)];
        let known = Known::symmetric(closed.reaction, closed.contact_force, closed.energy);
        found.push(extreme(
            format!("a dish from both supports, {rise} deep"),
            "closed form",
            &Draft::over(Foundation::Polynomial { coefficients }),
            known,
        )?);
    }
    Ok(found)
}

/// Loads that are zero, upward, in balance, at a support, at a kink.
fn loads() -> Result<Vec<Extreme>, SceneError> {
    let one = || Draft::over(Foundation::Flat { depth: 1.0 });
    let none = || Draft { uniform: 0.0, ..one() };
    let mut found = Vec::new();
    let up = Draft { uniform: -1.0, ..one() };
    let free = -L * L * L * L * L / (240.0 * EI);
    found.push(extreme("a load upwards", "statics", &up, Known::symmetric(-0.5 * L, 0.0, free))?);
    let couple = none().with_points(&[(3.0, 0.01), (7.0, -0.01)]);
    let known = Known { reactions: [0.004, -0.004], contact_force: 0.0, energy: None };
    found.push(extreme("loads in balance, out of reach of the ground", "statics", &couple, known)?);
    let mut balanced = one().with_points(&[(5.0, -L)]);
    balanced.ground = Some(Foundation::Flat { depth: 100.0 });
    found.push(extreme("a load upwards that balances the uniform one", "statics", &balanced, mirrored(0.0, 0.0))?);
    let example = flat(L, EI, 1.0, 1.0);
    let ends = one().with_points(&[(0.0, 3.0), (L, 4.0)]);
    let known = Known {
        reactions: [example.reaction + 3.0, example.reaction + 4.0],
        contact_force: example.contact_force,
        energy: Some(example.energy),
    };
    found.push(extreme("loads on the supports", "closed form", &ends, known)?);
    let known = Known { energy: Some(example.energy - 7.0), ..mirrored(example.reaction, example.contact_force + 7.0) };
    found.push(extreme("a load inside a zone", "closed form", &one().with_points(&[(5.0, 7.0)]), known)?);
    // On a ridge at mid-span that holds the beam up by 50: the load goes straight into it.
    let points = vec![[0.0, 400.0], [5.0, 50.0], [L, 400.0]];
    let force = 48.0 * EI / (L * L * L) * 50.0;
    let energy = free + force * force * L * L * L / (96.0 * EI) - 50.0 * 7.0;
    let ridge = Draft::over(Foundation::Polyline { points }).with_points(&[(5.0, 7.0)]);
    found.push(extreme(
        "a load on a kink",
        "closed form",
        &ridge,
        Known::symmetric(0.5 * (L - force), force + 7.0, energy),
    )?);
    if let Some(closed) = lifted(L, EI, 0.01, 1.0, 3.0) {
        let mut lift = one().with_points(&[(5.0, -3.0)]);
        lift.ground = Some(Foundation::Flat { depth: 0.01 });
        let known = Known::symmetric(closed.reaction, 2.0 * closed.zone_force, closed.energy);
        found.push(extreme("a load upwards inside a zone", "closed form", &lift, known)?);
    }
    Ok(found)
}
