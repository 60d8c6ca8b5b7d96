//! Reactions, contacts, extremes and energy of a list, dimensionless.

use super::bernstein::{range, sign_changes};
use super::check::PLACE;
use super::forces::zone_force;
use super::list::List;
use super::penetration::{by_blocks, clearance_range};
use super::piece::{NEAR, Piece, derivatives, differentiated};
use super::piecewise::PiecewiseScene;
use super::search::Candidate;
use crate::state::{Contact, ContactState, Extremes, Reactions, Regime, SupportForce, larger_moment};

/// The state of a beam, with forces, moments and energy over the least `EI`.
pub(super) fn state(given: &PiecewiseScene, found: &Candidate) -> ContactState {
    let pieces = &found.checked.pieces;
    let (supports, contacts) = (supports(given, found), contacts(given, found));
    let (deflection, Extremes { max, max_at, min, min_at }) = extremes(given, pieces);
    let moment = |bent: f64| -bent + 0.0;
    ContactState {
        regime: Regime::of(&contacts),
        reactions: Reactions::of(&supports, given.length),
        supports,
        standing: None,
        contacts,
        touches: Vec::new(),
        deflection,
        moment: Extremes { max: moment(min), max_at: min_at, min: moment(max), min_at: max_at },
        energy: energy(given, pieces) + in_springs(given, found),
        pressure: None,
        nodes: None,
    }
}

/// The reactions from left to right, including compression-only supports.
fn supports(given: &PiecewiseScene, found: &Candidate) -> Vec<SupportForce> {
    let nodes = found.list.nodes.iter().zip(&found.checked.forces).zip(&found.checked.moments);
    let supports = nodes.filter_map(|((node, force), moments)| {
        let support = &given.supports[node.support(given)?];
        let (at, holds) = (&given.breakpoints[support.breakpoint], support.built_in || support.turning.is_some());
        // The moment next to the support, on the side where there is a beam; on both sides the larger one.
        let [left, right] = *moments;
        let moment = larger_moment(*moments);
        Some(SupportForce {
            at: node.x,
            force: force + at.acts.force(),
            moment: holds.then_some(moment),
            couple: if holds { right - left + at.acts.couple() } else { 0.0 },
            pushes_only: false,
        })
    });
    let springs = given.springs.iter().zip(&found.checked.springs).map(|(spring, state)| SupportForce {
        at: given.breakpoints[spring.breakpoint].x,
        force: state.force + 0.0,
        moment: spring.turning.map(|_| larger_moment(state.moments)),
        couple: state.couple,
        pushes_only: spring.pushes_only,
    });
    let rests = |i: usize| found.list.nodes.iter().position(|node| node.is_edge(given) && node.breakpoint == Some(i));
    let bearings = given.bearings.iter().map(|&i| {
        let force = rests(i).map_or(0.0, |node| found.checked.forces[node]);
        SupportForce::pushing(given.breakpoints[i].x, force)
    });
    let mut all: Vec<SupportForce> = supports.chain(bearings).chain(springs).collect();
    all.sort_by(|a, b| a.at.total_cmp(&b.at));
    all
}

/// The contacts from left to right.
fn contacts(given: &PiecewiseScene, found: &Candidate) -> Vec<Contact> {
    let List { nodes, .. } = &found.list;
    let forces = &found.checked.forces;
    let mut contacts = Vec::new();
    let place = |i: usize| on_the_beam(nodes[i].x, given.length);
    for i in 0..=nodes.len() {
        if found.list.in_zone_before(i) {
            // If foundation and support carry a force together, all of it is assigned to the support.
            let end = |i: usize| (place(i), if nodes[i].support(given).is_some() { 0.0 } else { forces[i] });
            let ((from, force_from), (to, force_to)) = (end(i - 1), end(i));
            let force = force_from + force_to + zone_force(given, from, to);
            // At the border of two regimes a zone has no length and is a point.
            let end_forces = (from < to).then_some([force_from, force_to]);
            contacts.push(Contact { from, to, force, end_forces });
        }
        if let Some(node) = nodes.get(i)
            && node.is_ground(given)
        {
            contacts.push(Contact::at(place(i), forces[i]));
        }
    }
    contacts
}

/// Moves a position that rounding has put just outside the beam to its end.
fn on_the_beam(x: f64, length: f64) -> f64 {
    let nearest = x.clamp(0.0, length);
    if (x - nearest).abs() <= PLACE * length { nearest } else { x }
}

/// `J / EI₀ = ∫ ½ e v''² + ½ N v'² − q v dx − Σ P v − Σ C v' + Σ ½ w (e v'')²`, every integral exact.
fn energy(given: &PiecewiseScene, pieces: &[Piece]) -> f64 {
    let mut taylor = vec![0.0; given.terms];
    let mut sum = 0.0;
    for piece in pieces {
        piece.deflection(given, &mut taylor);
        piece.outwards(&mut taylor);
        // In distances from the anchor: in a short piece far from zero a position has fewer digits than its distance from the anchor.
        sum += given.energy_rule.integral(0.0, piece.width(), |s| {
            let [v, v1, v2, _] = derivatives(&taylor, s);
            let bent = piece.bending_energy(given, v2) - given.load(piece.cell, piece.place(s)) * v;
            if given.tension == 0.0 { bent } else { bent + 0.5 * given.tension * v1 * v1 }
        });
    }
    for breakpoint in given.forces() {
        let i = pieces.partition_point(|p| p.hi < breakpoint.x).min(pieces.len() - 1);
        let piece = &pieces[i];
        piece.deflection(given, &mut taylor);
        let [v, v1, ..] = derivatives(&taylor, breakpoint.x.max(piece.lo).min(piece.hi) - piece.anchor);
        sum -= breakpoint.acts.work([v, v1]);
    }
    // The energy of a joint is half of its rotation times its moment.
    for (x, flexibility) in given.elastic_joints() {
        let i = pieces.partition_point(|p| p.hi < x).min(pieces.len() - 1);
        pieces[i].deflection(given, &mut taylor);
        let [_, _, bent, _] = pieces[i].beam(given, &taylor, x - pieces[i].anchor);
        sum += 0.5 * flexibility * bent * bent;
    }
    sum
}

/// The energy in springs, `Σ R²/2k + Σ C²/2k` with their forces and couples.
fn in_springs(given: &PiecewiseScene, found: &Candidate) -> f64 {
    let taken = |k: f64, acts: f64| 0.5 * acts * (acts / k);
    let turned = |turning: Option<[f64; 2]>, couple: f64| turning.map_or(0.0, |[k, _]| taken(k, couple));
    let springs = given.springs.iter().zip(&found.checked.springs);
    let sunk: f64 =
        springs.map(|(of, state)| taken(of.stiffness, state.force) + turned(of.turning, state.couple)).sum();
    let at_supports = found.list.nodes.iter().filter_map(|node| {
        let support = &given.supports[node.support(given)?];
        // The couple at the node without the external couple.
        let couple = node.couple(given) - given.breakpoints[support.breakpoint].acts.couple();
        Some(turned(support.turning, couple))
    });
    sunk + at_supports.sum::<f64>()
}

/// Extremes of `v` and of `e v''`: at the ends of pieces and at the roots of their derivatives.
fn extremes(given: &PiecewiseScene, pieces: &[Piece]) -> (Extremes, Extremes) {
    let mut taylor = vec![0.0; given.terms];
    // Inside a piece only where the function may exceed its values at the ends of all pieces.
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let (mut ends, mut bends) = (none, none);
    for piece in pieces {
        piece.deflection(given, &mut taylor);
        for x in [piece.lo, piece.hi] {
            let [v, _, bent, _] = piece.beam(given, &taylor, x - piece.anchor);
            ends = [ends[0].min(v), ends[1].max(v)];
            bends = [bends[0].min(bent), bends[1].max(bent)];
        }
    }
    let (mut first, mut second) = (Vec::with_capacity(3 * pieces.len()), Vec::with_capacity(3 * pieces.len()));
    for piece in pieces {
        piece.deflection(given, &mut taylor);
        piece.outwards(&mut taylor);
        add_extremes(piece, &taylor, ends, &mut first);
        add_extremes(piece, piece.bent(given, &mut taylor), bends, &mut second);
    }
    (Extremes::of(first.iter().copied()), Extremes::of(second.iter().copied()))
}

/// Extremes of the clearance over some pieces, from left to right; at a step the values of both sides count. Over a straight
/// foundation, only those cells are examined that may exceed the extremes found so far and the values at the ends of all pieces.
pub(super) fn clearance_extremes(given: &PiecewiseScene, pieces: &[Piece]) -> Extremes {
    let mut taylor = vec![0.0; given.terms];
    let mut found = [f64::INFINITY, f64::NEG_INFINITY];
    for piece in pieces {
        piece.clearance(given, &mut taylor);
        let [h, ..] = derivatives(&taylor, 0.0);
        found = [found[0].min(h), found[1].max(h)];
    }
    let mut values = Vec::new();
    for piece in pieces {
        if piece.state.is_none() {
            values.extend([(piece.lo, 0.0), (piece.hi, 0.0)]);
            continue;
        }
        by_blocks(given, piece, NEAR + 1, |part| {
            if 1 < part.count() {
                let Some([least, most]) = clearance_range(given, part, &mut taylor) else { return false };
                return found[0] < least && most < found[1];
            }
            part.clearance(given, &mut taylor);
            part.outwards(&mut taylor);
            let before = values.len();
            add_extremes(part, &taylor, found, &mut values);
            found = values[before..].iter().fold(found, |[least, most], (_, h)| [least.min(*h), most.max(*h)]);
            true
        });
    }
    Extremes::of(values.iter().copied())
}

/// Extremes of the moment `−e v''` over some pieces of the beam, from left to right.
pub(super) fn bend_extremes(given: &PiecewiseScene, pieces: &[Piece]) -> Extremes {
    let mut taylor = vec![0.0; given.terms];
    let mut values = Vec::new();
    for piece in pieces {
        piece.deflection(given, &mut taylor);
        piece.outwards(&mut taylor);
        let moment = piece.bent(given, &mut taylor);
        moment.iter_mut().for_each(|c| *c = 0.0 - *c);
        add_extremes(piece, moment, [f64::INFINITY, f64::NEG_INFINITY], &mut values);
    }
    Extremes::of(values.iter().copied())
}

/// Adds the values of `Σ c_j s^j` at both ends of a piece, and where its derivative vanishes if the function may leave `[least, most]`
/// there; from left to right, with their positions.
pub(super) fn add_extremes(piece: &Piece, c: &[f64], [least, most]: [f64; 2], values: &mut Vec<(f64, f64)>) {
    let width = piece.width();
    let start = values.len();
    values.push((piece.place(0.0), super::bernstein::value(c, 0.0)));
    if !range(c, width).is_some_and(|[lo, hi]| least < lo && hi < most) {
        let inside = sign_changes(differentiated(&mut c.to_vec()), width);
        values.extend(inside.into_iter().map(|s| (piece.place(s), super::bernstein::value(c, s))));
    }
    values.push((piece.place(width), super::bernstein::value(c, width)));
    if piece.lo < piece.anchor {
        values[start..].reverse();
    }
}
