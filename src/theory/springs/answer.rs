//! The beam on an elastic foundation as an [`Exact`] solution: contacts, forces, extremes and energy, in the units of the scene.

use super::bearings::{force, search_with};
use super::{Part, StretchSet, beside, coarse, deepest, part_at};
use crate::certificate::Stretch;
use crate::scene::{Quantity, Resultant, Scaled, SceneError, Unheld};
use crate::state::{
    Contact, ContactState, Extremes, Pressure, Reactions, Regime, Standing, SupportForce, larger_moment,
};
use crate::theory::exact::Exact;
use crate::theory::gauss::Gauss;
use crate::theory::giving::spring_force;
use crate::theory::list::List;
use crate::theory::piece::{Piece, derivatives, differentiated};
use crate::theory::piecewise::{AtSpring, AtSupport, Breakpoint, PiecewiseScene};
use crate::theory::summary::add_extremes;
use crate::theory::violation::Violation;

/// Tolerance of a penetration with the wrong sign, as a share of the largest one but at least of [`rounding`]: the rounding of the end
/// positions of zones.
const MOST_VIOLATED: f64 = 1e-9;

/// A solution as functions of `x`, dimensionless.
#[derive(Debug, Clone)]
pub(in crate::theory) struct Springs {
    pub(super) parts: Vec<Part>,
    /// The pressed stretches, from left to right.
    pub(super) stretches: Vec<[f64; 2]>,
    /// `k` over `EI₀`, where the foundation is stiffest.
    pub(super) stiffness: f64,
}

impl Springs {
    /// The part at `x`, at a boundary the left or the right one.
    pub(in crate::theory) fn part(&self, x: f64, right: bool) -> &Part {
        part_at(&self.parts, x, right)
    }

    /// The pressure over `EI₀`.
    pub(in crate::theory) fn pressure(&self, x: f64) -> f64 {
        let part = self.part(x, true);
        if part.pressed { self.stiffness * part.ground * part.sunk(x)[0] } else { 0.0 }
    }

    /// The number of parts.
    pub(in crate::theory) fn size(&self) -> usize {
        self.parts.len()
    }

    /// The number of unknowns of the beam on these parts.
    pub(in crate::theory) fn unknowns(&self) -> usize {
        4 * self.parts.len()
    }

    /// Positions close enough to each other to show how the deflection decays into the foundation.
    pub(in crate::theory) fn places(&self) -> impl Iterator<Item = f64> + '_ {
        let inside = |part: &Part| [0.0, 0.25, 0.5, 0.75].map(|s| part.piece.place(s * part.piece.width()));
        self.parts.iter().filter(|part| part.pressed).flat_map(inside)
    }

    /// The parts without pressure.
    pub(in crate::theory) fn hanging(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().filter(|part| !part.pressed)
    }

    /// The parts as stretches for a certificate.
    pub(in crate::theory) fn stretches(&self) -> impl Iterator<Item = Stretch> + '_ {
        self.parts.iter().map(|part| {
            let Piece { lo, hi, anchor, .. } = part.piece;
            let sunk = if part.pressed { part.penetration.clone() } else { Vec::new() };
            let ends =
                [lo, hi].map(|x| if part.pressed { part.sunk(x) } else { derivatives(&part.deflection, x - anchor) });
            Stretch { from: lo, to: hi, sunk, ends }
        })
    }

    /// Extremes of the clearance over the parts with a foundation whose middle is between two positions; [`None`] if there are none.
    pub(in crate::theory) fn clearance_extremes(&self, ends: [f64; 2]) -> Option<Extremes> {
        let grounded = || self.between(ends).filter(|part| 0.0 < part.ground);
        grounded().next()?;
        Some(extremes(grounded(), |part: &Part| part.penetration.iter().map(|c| -c).collect()))
    }

    /// Extremes of `−e v''` between two positions.
    pub(in crate::theory) fn bend_extremes(&self, ends: [f64; 2]) -> Extremes {
        extremes(self.between(ends), bend)
    }

    /// The parts whose middle is between two positions.
    fn between(&self, [from, to]: [f64; 2]) -> impl Iterator<Item = &Part> {
        let first = self.parts.partition_point(|part| part.piece.hi < from);
        self.parts[first..].iter().take_while(move |part| part.piece.lo <= to).filter(move |part| {
            let middle = 0.5 * (part.piece.lo + part.piece.hi);
            from <= middle && middle <= to
        })
    }
}

/// Extremes of a function with Taylor coefficients on each part.
fn extremes<'a>(parts: impl Iterator<Item = &'a Part>, of: impl Fn(&Part) -> Vec<f64>) -> Extremes {
    let mut values = Vec::new();
    for part in parts {
        let mut taylor = of(part);
        part.piece.outwards(&mut taylor);
        add_extremes(&part.piece, &taylor, [f64::INFINITY, f64::NEG_INFINITY], &mut values);
    }
    Extremes::of(values.iter().copied())
}

/// Taylor coefficients of `−e v''`.
fn bend(part: &Part) -> Vec<f64> {
    second(&part.deflection).iter().map(|c| 0.0 - c * part.stiffness).collect()
}

/// Taylor coefficients of the second derivative.
pub(super) fn second(taylor: &[f64]) -> Vec<f64> {
    let mut taylor = taylor.to_vec();
    differentiated(differentiated(&mut taylor)).to_vec()
}

/// The exact solution of a dimensionless scene on a foundation of this stiffness; the search starts from the answers `near` of
/// neighbouring scenes.
///
/// # Errors
///
/// [`SceneError::Overflow`] for a stiffness outside the range in which the beam can be computed, and [`Unheld::OnBorder`] if the loads
/// are above the only support and nothing presses next to it.
pub(in crate::theory) fn exact(
    scaled: &Scaled,
    given: PiecewiseScene,
    stiffness: f64,
    near: &[&Exact],
) -> Result<Exact, SceneError> {
    let springs = stiffness / scaled.scene.beam().bending_stiffness();
    let (quantity, what) = (Quantity::GroundStiffness, "the stiffness of the ground over that of the beam");
    let pushed = !given.bearings.is_empty() || given.springs.iter().any(|spring| spring.pushes_only);
    let none = || match scaled.balance.in_units_of(&scaled.scale).resultant() {
        // Nothing presses on either side of the only position that carries the beam.
        Some(Resultant { force, at }) if pushed => Unheld::OnBorder { force, at }.into(),
        _ => SceneError::Overflow { quantity, what, value: springs },
    };
    let near = starts(scaled, springs, near);
    let (given, found) = search_with(given, springs, &near).ok_or_else(none)?;
    let StretchSet { parts, stretches, solves, settled } = found;
    let violated = parts.iter().map(violation).fold(0.0, f64::max);
    let rounded = parts.iter().map(|part| rounding(part, given.length)).fold(0.0, f64::max);
    let measure = deepest(&parts).max(rounded / MOST_VIOLATED);
    let residual = if 0.0 < measure { violated / measure } else { violated };
    let units = scaled.units_over_stiffness();
    let mut state = state(&given, &parts, &stretches, springs).in_units_of(&units);
    let resultant = scaled.balance.in_units_of(&scaled.scale).resultant();
    state.standing = resultant.map(|resultant| Standing::of(&state, resultant, None));
    let solved = settled && residual <= MOST_VIOLATED && state.is_finite();
    let unknowns = 2 * stretches.len();
    let functions = Springs { parts, stretches, stiffness: springs };
    Ok(Exact {
        unknowns,
        solved,
        converged: settled,
        iterations: solves,
        lists: solves,
        samples: 0,
        residual,
        violations: if state.is_finite() { Vec::new() } else { vec![Violation::Overflow] },
        support_couples: [0.0; 2],
        listed: state.contacts.clone(),
        idle: Vec::new(),
        state,
        springs: Some(functions),
        list: List { nodes: Vec::new() },
        spans: Vec::new(),
        forces: Vec::new(),
        pieces: Vec::new(),
        given,
        units,
    })
}

/// Stretches to start from: from the answers of neighbouring scenes, or from a coarse bed.
fn starts(scaled: &Scaled, springs: f64, near: &[&Exact]) -> Vec<Vec<[f64; 2]>> {
    let carried = |exact: &&Exact| {
        let unit = exact.units.length / scaled.scale.length;
        let stretches = &exact.springs.as_ref().filter(|_| exact.solved)?.stretches;
        Some(stretches.iter().map(|ends| ends.map(|x| x * unit)).collect())
    };
    let near: Vec<_> = near.iter().filter_map(carried).collect();
    if near.is_empty() { coarse::stretches(&scaled.scene, springs).into_iter().collect() } else { near }
}

/// The rounding of a penetration: of the digits of the deflection, and of its change by the digits of a position.
fn rounding(part: &Part, length: f64) -> f64 {
    /// A few roundings of each.
    const UNITS: f64 = 16.0;
    let size = [part.piece.lo, part.piece.hi].map(|x| part.beam(x)[0].abs() + length * part.sunk(x)[1].abs());
    UNITS * f64::EPSILON * size[0].max(size[1])
}

/// The violation of the sign of `w` on a part: where springs press `w` must not be negative, elsewhere not positive. Without a
/// foundation it is free.
fn violation(part: &Part) -> f64 {
    if part.ground <= 0.0 {
        return 0.0;
    }
    let Extremes { max, min, .. } = extremes(std::iter::once(part), |part| part.penetration.clone());
    if part.pressed { -min } else { max }
}

/// The dimensionless state, with forces, moments and energy over the least `EI`, as the stiffness of the foundation.
fn state(given: &PiecewiseScene, parts: &[Part], stretches: &[[f64; 2]], springs: f64) -> ContactState {
    let lifted = given.bearings.iter().filter(|&&at| given.support_at(at).is_none());
    let lifted = lifted.map(|&at| SupportForce::pushing(given.breakpoints[at].x, 0.0));
    let firm = (0..given.supports.len()).map(|i| support(given, parts, i));
    let giving = given.springs.iter().map(|spring| giving(given, parts, spring));
    let mut supports: Vec<SupportForce> = firm.chain(lifted).chain(giving).collect();
    supports.sort_by(|a, b| a.at.total_cmp(&b.at));
    let contact = |&[from, to]: &[f64; 2]| {
        let first = parts.partition_point(|part| part.piece.lo < from);
        let inside = parts[first..].iter().take_while(|part| part.piece.hi <= to).filter(|part| part.pressed);
        let sunk: f64 = inside.map(|part| part.ground * integral(&part.penetration, part.piece.width())).sum();
        Contact { from, to, force: springs * sunk, end_forces: None }
    };
    let contacts: Vec<Contact> = stretches.iter().map(contact).collect();
    let bent = extremes(parts.iter(), bend);
    let pressure = |part: &Part| part.penetration.iter().map(|c| part.ground * c).collect();
    let sunk = extremes(parts.iter().filter(|part| part.pressed), pressure);
    ContactState {
        regime: Regime::of(&contacts),
        reactions: Reactions::of(&supports, given.length),
        supports,
        standing: None,
        contacts,
        touches: Vec::new(),
        deflection: extremes(parts.iter(), |part| part.deflection.clone()),
        moment: bent,
        energy: energy(given, parts, springs) + in_springs(given, parts),
        pressure: Some(Pressure { max: sunk.max.max(0.0) * springs, at: sunk.max_at }),
        nodes: None,
    }
}

/// The reaction of a rigid support.
fn support(given: &PiecewiseScene, parts: &[Part], i: usize) -> SupportForce {
    let AtSupport { breakpoint, built_in, turning, .. } = given.supports[i];
    let holds = built_in || turning.is_some();
    let x = given.breakpoints[breakpoint].x;
    let force = force(given, parts, breakpoint);
    if given.is_bearing(breakpoint) {
        // Negative only by rounding.
        return SupportForce::pushing(x, force.max(0.0));
    }
    let [left, right] = beside(parts, x);
    let moment = -larger_moment([left[2], right[2]]);
    SupportForce {
        pushes_only: false,
        at: x,
        force,
        moment: holds.then_some(moment),
        couple: if holds { left[2] - right[2] + given.breakpoints[breakpoint].acts.couple() } else { 0.0 },
    }
}

/// The reaction of an elastic support.
fn giving(given: &PiecewiseScene, parts: &[Part], spring: &AtSpring) -> SupportForce {
    let AtSpring { breakpoint, stiffness: k, level, turning, pushes_only, acts } = *spring;
    let at = &given.breakpoints[breakpoint];
    if !acts {
        return SupportForce::pushing(at.x, 0.0);
    }
    let ([left, right], v) = (beside(parts, at.x), part_at(parts, at.x, false).beam(at.x)[0]);
    let size = left[3].abs() + right[3].abs() + at.acts.force().abs();
    let size = if given.tension == 0.0 { size } else { size + given.tension.abs() * left[1].abs().max(right[1].abs()) };
    let force = spring_force(k, [v, level], force(given, parts, breakpoint), [v.abs(), size]);
    SupportForce {
        at: at.x,
        // Negative only by rounding.
        force: if pushes_only { force.max(0.0) } else { force } + 0.0,
        moment: turning.map(|_| -larger_moment([left[2], right[2]])),
        couple: turning.map_or(0.0, |_| left[2] - right[2] + at.acts.couple()),
        pushes_only,
    }
}

/// The energy in elastic supports: `½ Σ R²/k_s + ½ Σ T²/k_t` over `EI₀`.
fn in_springs(given: &PiecewiseScene, parts: &[Part]) -> f64 {
    let sunk = given.acting().map(|spring| {
        let x = given.breakpoints[spring.breakpoint].x;
        let force = giving(given, parts, spring).force;
        let off = part_at(parts, x, false).beam(x)[0] - spring.level;
        // Of the two expressions, the one with more digits.
        0.5 * if spring.stiffness * off.abs() < force.abs() {
            spring.stiffness * off * off
        } else {
            force * force / spring.stiffness
        }
    });
    let turned = (0..given.breakpoints.len()).filter_map(|i| Some((i, given.turning_at(i)?)));
    let turned = turned.map(|(i, [k, _])| {
        let [left, right] = beside(parts, given.breakpoints[i].x);
        let couple = left[2] - right[2] + given.breakpoints[i].acts.couple();
        0.5 * couple * couple / k
    });
    sunk.sum::<f64>() + turned.sum::<f64>()
}

/// `∫₀^w` of a polynomial.
#[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
pub(super) fn integral(taylor: &[f64], width: f64) -> f64 {
    taylor.iter().enumerate().rev().fold(0.0, |sum, (j, c)| sum * width + c / (j + 1) as f64) * width
}

/// The quadrature rule that is exact for squares of the functions on a part.
pub(super) fn rule(given: &PiecewiseScene) -> Gauss {
    /// Degree at which squares of functions that decay and oscillate are exact to rounding over a length of `1/λ`.
    const PRESSED_DEGREE: usize = 29;
    Gauss::exact_to((2 * given.terms).max(PRESSED_DEGREE))
}

/// `J / EI₀ = ∫ ½ e v''² + ½ N v'² + ½ K (v − g)₊² − q v dx − Σ P v − Σ C v' + ½ Σ w (e v'')²`; the last sum is over joints.
fn energy(given: &PiecewiseScene, parts: &[Part], springs: f64) -> f64 {
    let rule = rule(given);
    let mut sum = 0.0;
    for part in parts {
        let Piece { lo, hi, cell, .. } = part.piece;
        sum += rule.integral(lo, hi, |x| {
            let [v, turned, bent, _] = part.beam(x);
            let w = if part.pressed { part.sunk(x)[0] } else { 0.0 };
            let pulled = if given.tension == 0.0 { 0.0 } else { given.tension * turned * turned };
            0.5 * (bent * bent / part.stiffness + springs * part.ground * w * w + pulled) - given.load(cell, x) * v
        });
    }
    let turned = given.elastic_joints().map(|(x, flexibility)| {
        let bent = part_at(parts, x, false).beam(x)[2];
        0.5 * flexibility * bent * bent
    });
    let sum = turned.fold(sum, |sum, turned| sum + turned);
    given.forces().fold(sum, |sum, &Breakpoint { x, acts, .. }| {
        // The slope of a short part is a quotient by its length, so the longer part is used.
        let [left, right] = [false, true].map(|right| part_at(parts, x, right));
        let [v, v1, ..] = if left.piece.width() < right.piece.width() { right } else { left }.beam(x);
        sum - acts.force() * v + acts.couple() * v1
    })
}
