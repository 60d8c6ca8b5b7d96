//! The forces of a beam on its supports and on the points where it touches, in fractions: Clapeyron's equations of three moments.
//!
//! Only the places of the contacts are taken from the answer.

use palkki::scene::{Foundation, Scene};
use palkki::theory::Exact;

use super::laws::{CERTAIN, exceeds, grounded, sizes};
use super::trial::Trial;
use crate::authority::RBig;
use crate::authority::number::Number;
use crate::authority::statics::exactly;
use crate::draft::Draft;

/// Between two places that are held, with loads: `6EI` times the slopes of a simple beam at its ends, and the forces there.
struct Span {
    length: RBig,
    slopes: [RBig; 2],
    forces: [RBig; 2],
}

/// Loads as parts `(from, to, start, end)` and points.
struct Loads {
    parts: Vec<[RBig; 4]>,
    points: Vec<[RBig; 2]>,
}

impl Loads {
    fn of(draft: &Draft) -> Option<Self> {
        let mut parts = vec![[0.0, draft.length, draft.uniform, draft.uniform].map(RBig::of)];
        for q in &draft.linear {
            exactly(q.from + q.to + q.start + q.end)?;
            parts.push([q.from, q.to, q.start, q.end].map(RBig::of));
        }
        let points = draft.point.iter().map(|p| [p.at, p.force].map(RBig::of)).collect();
        Some(Self { parts, points })
    }

    /// The sum of `f(x) q(x)`, of all loads strictly between two places; `f` a cubic.
    fn sum(&self, [from, to]: [&RBig; 2], f: impl Fn(&RBig) -> RBig) -> RBig {
        let mut sum = RBig::ZERO;
        for [at, force] in &self.points {
            if from < at && at < to {
                sum += force * f(at);
            }
        }
        for [left, right, start, end] in &self.parts {
            let [a, b] = [left.max(from), right.min(to)];
            if a >= b {
                continue;
            }
            // Boole's rule is exact up to degree five.
            let intensity = |x: &RBig| start + (end - start) * (x - left) / (right - left);
            for (k, weight) in [7, 32, 12, 32, 7].into_iter().enumerate() {
                let x = a + (b - a) * RBig::fraction(i64::try_from(k).unwrap_or(0), 4);
                sum += RBig::fraction(weight, 90) * (b - a) * intensity(&x) * f(&x);
            }
        }
        sum
    }

    fn span(&self, a: &RBig, b: &RBig) -> Span {
        let length = b - a;
        let slope = |near: &RBig| {
            self.sum([a, b], |x| {
                let [to_left, to_right] = [x - a, b - x];
                let far = if near == a { &length + &to_right } else { &length + &to_left };
                to_left * to_right * far / &length
            })
        };
        let slopes = [slope(a), slope(b)];
        let forces = [self.sum([a, b], |x| (b - x) / &length), self.sum([a, b], |x| (x - a) / &length)];
        Span { length, slopes, forces }
    }
}

/// Forces of the places, from left to right.
fn forces(draft: &Draft, places: &[[RBig; 2]]) -> Option<Vec<RBig>> {
    let loads = Loads::of(draft)?;
    let six = RBig::whole(6) * RBig::of(draft.stiffness);
    let n = places.len();
    let ends = [RBig::ZERO, RBig::of(draft.length)];
    let (first, last) = (&places[0][0], &places[n - 1][0]);
    // Loads at the very end of an overhang count as well.
    let beyond = [&ends[0] - RBig::whole(1), &ends[1] + RBig::whole(1)];
    let spans: Vec<Span> = places.windows(2).map(|pair| loads.span(&pair[0][0], &pair[1][0])).collect();
    let chords: Vec<RBig> =
        places.windows(2).zip(&spans).map(|(pair, span)| (&pair[1][1] - &pair[0][1]) / &span.length).collect();
    let mut moments = vec![RBig::ZERO; n];
    moments[0] = -loads.sum([&beyond[0], first], |x| first - x);
    moments[n - 1] = -loads.sum([last, &beyond[1]], |x| x - last);
    let (mut passed, mut known) = (vec![RBig::ZERO; n], vec![RBig::ZERO; n]);
    known[0] = moments[0].clone();
    for i in 1..n - 1 {
        let (left, right) = (&spans[i - 1], &spans[i]);
        let kink = &six * (&chords[i - 1] - &chords[i]) - &left.slopes[1] - &right.slopes[0];
        let pivot = RBig::whole(2) * (&left.length + &right.length) - &left.length * &passed[i - 1];
        known[i] = (kink - &left.length * &known[i - 1]) / &pivot;
        passed[i] = &right.length / &pivot;
    }
    for i in (1..n - 1).rev() {
        moments[i] = &known[i] - &passed[i] * &moments[i + 1];
    }
    let mut forces = vec![RBig::ZERO; n];
    forces[0] += loads.sum([&beyond[0], first], |_| RBig::whole(1));
    forces[n - 1] += loads.sum([last, &beyond[1]], |_| RBig::whole(1));
    for (i, span) in spans.iter().enumerate() {
        let lever = (&moments[i + 1] - &moments[i]) / &span.length;
        forces[i] += &span.forces[0] + &lever;
        forces[i + 1] += &span.forces[1] - lever;
    }
    for (force, [at, _]) in forces.iter_mut().zip(places) {
        *force += loads.points.iter().filter(|p| p[0] == *at).fold(RBig::ZERO, |sum, p| sum + &p[1]);
    }
    Some(forces)
}

/// The depth of ground that has one in fractions.
fn depth(ground: &Foundation, x: f64) -> Option<RBig> {
    let x = RBig::of(x);
    match ground {
        Foundation::Flat { depth } => Some(RBig::of(*depth)),
        Foundation::Polynomial { coefficients } => {
            Some(coefficients.iter().rev().fold(RBig::ZERO, |sum, c| sum * &x + RBig::of(*c)))
        }
        Foundation::Cosine { .. } => None,
        Foundation::Polyline { points } => {
            let points: Vec<[RBig; 2]> = points.iter().map(|p| p.map(RBig::of)).collect();
            let here = points.iter().filter(|p| p[0] == x).map(|p| p[1].clone()).min();
            let between = || {
                let pair = points.windows(2).find(|pair| pair[0][0] < x && x < pair[1][0])?;
                let ([a, u], [b, w]) = (&pair[0], &pair[1]);
                Some(u + (w - u) * (&x - a) / (b - a))
            };
            here.or_else(between)
        }
    }
}

/// The forces of supports and point contacts are those of the beam that is held there.
pub(super) fn by_moments(trial: &mut Trial, draft: &Draft, scene: &Scene, exact: &Exact) {
    let (state, (largest, size)) = (&exact.state, sizes(scene, &exact.state));
    let supports = scene.beam().supports();
    let simple = supports.iter().all(|s| s.slope.is_none() && !grounded(scene, s.at, s.level, size));
    if !simple || supports.is_empty() || draft.shape.is_some() || state.contacts.iter().any(|c| c.from < c.to) {
        return;
    }
    let mut places: Vec<(f64, RBig, f64)> =
        supports.iter().zip(&state.supports).map(|(s, found)| (s.at, RBig::of(s.level), found.force)).collect();
    for contact in &state.contacts {
        let Some(depth) = draft.ground.as_ref().and_then(|ground| depth(ground, contact.from)) else { return };
        places.push((contact.from, depth, contact.force));
    }
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    if places.len() < 2 || places.windows(2).any(|pair| pair[0].0 >= pair[1].0) {
        return;
    }
    let held: Vec<[RBig; 2]> = places.iter().map(|(at, depth, _)| [RBig::of(*at), depth.clone()]).collect();
    let Some(forces) = forces(draft, &held) else { return };
    // The place of a contact is rounded, and with it the lever of its force about its neighbours.
    let mut levers = vec![0.0; places.len()];
    for i in 1..places.len() {
        let rounded = |(at, _, force): &(f64, RBig, f64)| {
            let found = state.contacts.iter().any(|c| (c.from - at).abs() <= 0.0);
            if found { f64::EPSILON * at * force.abs() } else { 0.0 }
        };
        let lever = (rounded(&places[i - 1]) + rounded(&places[i])) / (places[i].0 - places[i - 1].0);
        levers[i - 1] += lever;
        levers[i] += lever;
    }
    for (((at, _, found), force), lever) in places.iter().zip(forces).zip(levers) {
        let force = force.to_double();
        let beside = exact.shear(*at).into_iter().fold(force.abs(), |most: f64, shear| most.max(shear.abs()));
        if exceeds((found - force).abs(), CERTAIN * beside + 2.0 * f64::EPSILON * largest + lever) {
            trial.wrong.push(format!("theory: the force at {at} is {found:e}, in fractions {force:e}"));
            return;
        }
    }
}
