//! A beam under an axial force `N`, tension positive: its spans are divided into parts with one polynomial each, from any source.
//!
//! For any `v̂` that satisfies the support conditions, the axial force is a known load `−N v̂''`. With moments `M` in equilibrium with
//! the loads
//!
//! ```text
//! M'' = p − q − N v̂'',    r = EI v̂'' + M,    H = M' + N v̂'  the vertical force, which contacts make jump
//! J(v̂) − J* ≤ ρ²/2α + ∫ (g − v̂) dp,      ‖v̂ − v*‖² ≤ 2 (J(v̂) − J*)/α,      ρ² = ∫ r²/EI,   ‖w‖² = ∫ EI w''²
//! ```
//!
//! if the quadratic part of `J`, `½∫ EI w''² + ½∫ N w'²`, is at least `α ‖w‖²/2` for all `w` that vanish at the supports. Under tension
//! `α = 1`. Under compression `α` is the proven stability margin (`steady`). A gap divided by `α²` bounds both. In joints `k [w']²` is
//! part of the norm, and `(k [v̂'] + M)²/k` is part of `ρ²`. Elastic supports add their energy to the norm, and an elastic foundation
//! adds `½∫ (k ŵ − p)²/k` to the gap.
//!
//! A moment `M` that remains in a hinge costs `M [w']`. Let `a` be the distance to the next joint. The energy `E` of a beam under tension
//! is at least `½ κ w'²` with the slope `w'` at the hinge, so that `|[w']| ≤ √(2/κ) √(2 E)`:
//!
//! ```text
//! κ = √(N EI) tanh(μ a) ≥ √(N EI) μ a/(1 + μ a) = N a/(1 + μ a),      μ² = N/EI
//! ```

use std::rc::Rc;

use super::clearance;
use super::contact_node::{ContactNode, EnclosedScene, Slope};
use super::held::known;
use super::interval::Interval;
use super::load::cells;
use super::polynomial::{Polynomial, TERMS, number};
use super::reference::{Datum, OUTWARDS};
use super::span::{Curve, Span};
use super::springs::cubic;

/// A part of the beam between contacts, with the first coefficients of its deflection `v(from + s)`, in dimensionless numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Hung {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) deflection: Vec<f64>,
}

/// The number of coefficients that are used. The moments that they cause are polynomials too.
pub(crate) const MOST_TERMS: usize = TERMS;

/// The parts of a span, each with its deflection about its left end.
pub(super) type Parts = Rc<[([f64; 2], Polynomial)]>;

/// The given polynomial between two positions; zero where none is given.
fn given(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> Polynomial {
    let middle = 0.5 * (from + to);
    let next = enclosed.hung.partition_point(|part| part.to <= middle);
    let Some(part) = enclosed.hung.get(next).filter(|part| part.from <= middle) else { return Polynomial::ZERO };
    let coefficients = part.deflection.iter().take(MOST_TERMS).map(|c| Interval::exact(*c));
    Polynomial::of(coefficients).shifted(Interval::length(part.from, from))
}

/// Deflection and slope of a polynomial at a position.
fn jet(of: &Polynomial, s: Interval) -> [Interval; 2] {
    [of.at(s), of.derivative().at(s)]
}

/// The same, each as the midpoint of its interval.
fn numbers(of: &Polynomial, s: Interval) -> [Interval; 2] {
    jet(of, s).map(|value| Interval::exact(value.middle()))
}

/// A polynomial plus a rigid-body motion, so that it has this deflection and slope at a position.
fn moved(of: &Polynomial, [y, turn]: [Interval; 2], s: Interval) -> Polynomial {
    let [own, turned] = jet(of, s);
    of.plus(&Polynomial::new(&[y - own - (turn - turned) * s, turn - turned]))
}

/// A cell that is shorter than this share of the longest cell of its span is moved as a rigid body. A cubic correction over the width `w`
/// for a rounding `δ` of the deflection would cost `12 EI δ²/w³`.
const SHORT: f64 = 1e-3;

/// Restraints of a beam under tension as a string. `½∫ N w'²` is also less than the gap. With a position `y` where `|w| ≤ ε`
///
/// ```text
/// |w(x)| ≤ ε + √(2 gap (|x − y|/N + 1/k))        k of an elastic support at y
/// ```
#[derive(Debug, Clone, Default)]
pub(crate) struct Taut {
    places: Vec<Datum>,
    /// An upper bound of `√(3 EI/N)`.
    lever: f64,
}

impl Taut {
    /// From the positions that carry a beam, each less a share of its force.
    pub(super) fn of(enclosed: &EnclosedScene<'_>, carriers: Vec<Datum>, gap: f64, share: Interval) -> Self {
        /// The cost of an error bound is proportional to it.
        const MOST: usize = 64;
        if enclosed.tension <= 0.0 {
            return Self::default();
        }
        let pressing = carriers.into_iter().filter_map(|place| known(place, gap, share));
        let places = enclosed.holding().chain(pressing).take(MOST).collect();
        let lever = (number(3) * Interval::exact(enclosed.stiffness) / Interval::exact(enclosed.tension)).sqrt().hi();
        Self { places, lever }
    }

    /// An upper bound of `|w|` on a part of the beam, from the factor `√(2 gap/3 EI)`.
    pub(super) fn on_part(&self, factor: f64, [a, b]: [f64; 2]) -> f64 {
        let bound = |place: &Datum| {
            let far = (b - place.from).max(place.to - a).max(0.0);
            let soft = place.soft[0];
            let lever =
                if soft <= 0.0 { self.lever * far.sqrt() } else { (self.lever * self.lever * far + soft).sqrt() };
            (factor * lever + place.uncertainty) * OUTWARDS
        };
        self.places.iter().map(bound).fold(f64::INFINITY, f64::min)
    }

    /// The ends of all data.
    pub(super) fn places(&self) -> impl Iterator<Item = f64> {
        self.places.iter().flat_map(|place| [place.from, place.to])
    }
}

impl Span {
    /// The beam between two positions, from the given parts. `ends` contains `[v, v']` at each end that is not free.
    pub(super) fn under_tension(
        enclosed: &EnclosedScene<'_>,
        [from, to]: [f64; 2],
        ends: [Option<[Interval; 2]>; 2],
        loaded: [Interval; 2],
    ) -> Self {
        let mut places = enclosed.breaks(from, to);
        places.extend(enclosed.hung.iter().flat_map(|part| [part.from, part.to]).filter(|x| from < *x && *x < to));
        let cells = cells(from, to, places);
        let given: Vec<Polynomial> = cells.iter().map(|cell| given(enclosed, *cell)).collect();
        let width = |cell: &[f64; 2]| Interval::length(cell[0], cell[1]);
        let thin = SHORT * cells.iter().map(|[a, b]| b - a).fold(0.0, f64::max);
        let (mut parts, mut kinks, mut last, mut land) = (Vec::new(), Vec::new(), cells.len() - 1, ends[1]);
        while let Some(end) = land.filter(|_| width(&cells[last]).hi() < thin && !enclosed.is_joint(cells[last][0])) {
            land = Some(jet(&moved(&given[last], end, width(&cells[last])), Interval::ZERO));
            last -= 1;
        }
        let mut start = ends[0].unwrap_or_else(|| numbers(&given[0], Interval::ZERO));
        for (i, (cell, t)) in cells.iter().zip(&given).enumerate() {
            let part =
                (width(cell).hi() < thin && (i != last || land.is_none())).then(|| moved(t, start, Interval::ZERO));
            let own = part.as_ref().map_or_else(|| numbers(t, width(cell)), |part| jet(part, width(cell)));
            let beyond = match given.get(i + 1) {
                _ if i == last => land.unwrap_or(own),
                Some(next) if enclosed.is_joint(cell[1]) => [own[0], numbers(next, Interval::ZERO)[1]],
                _ => own,
            };
            let end = if enclosed.is_joint(cell[1]) { [beyond[0], own[1]] } else { beyond };
            kinks.extend(enclosed.is_joint(cell[1]).then_some((cell[1], beyond[1] - end[1])));
            parts.push((*cell, part.unwrap_or_else(|| t.plus(&cubic([start, end], t, width(cell), None)))));
            start = beyond;
        }
        Self::of_parts(enclosed, parts.into(), kinks, loaded, ends.map(|end| end.is_none()))
    }

    /// The span that consists of these parts. One end may be free.
    fn of_parts(
        enclosed: &EnclosedScene<'_>,
        parts: Parts,
        kinks: Vec<(f64, Interval)>,
        loaded: [Interval; 2],
        free: [bool; 2],
    ) -> Self {
        let (first, last) = (&parts[0], &parts[parts.len() - 1]);
        let [from, to] = [first.0[0], last.0[1]];
        let length = Interval::length(from, to);
        let jet = |part: &([f64; 2], Polynomial), s: Interval| {
            let [v1, v2] = [part.1.derivative(), part.1.derivative().derivative()];
            [part.1.at(s), v1.at(s), v2.at(s), v2.derivative().at(s)]
        };
        let [mut start, mut end] = [jet(first, Interval::ZERO), jet(last, Interval::length(last.0[0], to))];
        let pulled = Interval::exact(enclosed.tension) * (end[0] - start[0]);
        let (load, [b, a]) = (enclosed.load, loaded.map(|mean| mean * length));
        // At a free end, moment and vertical force equal the couple and the load there.
        if free[1] {
            let moment = pulled - load.couple(to) - a - load.point(to) * length;
            start[2] = -(moment / enclosed.stiffness_beside(from, false));
            end[2] = load.couple(to) / enclosed.stiffness_beside(to, true);
        } else if free[0] {
            let moment = load.couple(from) - load.point(from) * length - pulled - b;
            start[2] = -(load.couple(from) / enclosed.stiffness_beside(from, false));
            end[2] = -(moment / enclosed.stiffness_beside(to, true));
        }
        Self { from, to, start, end, loaded, flexible: None, kinks, hung: Some(parts) }
    }

    /// An overhang, rotated about the only position that carries the beam.
    fn turned(&self, enclosed: &EnclosedScene<'_>, about: f64, angle: Interval) -> Option<Self> {
        let parts = self.hung.as_ref()?.iter().map(|([from, to], v)| {
            let turn = Polynomial::new(&[angle * Interval::length(about, *from), angle]);
            ([*from, *to], v.plus(&turn))
        });
        let free = [self.from < about, about < self.to];
        Some(Self::of_parts(enclosed, parts.collect(), self.kinks.clone(), self.loaded, free))
    }

    /// `M` on each part, from the moments at the two ends of the span and the vertical force at the left end.
    pub(super) fn moments_under_tension(
        &self,
        enclosed: &EnclosedScene<'_>,
        parts: &Parts,
        moments: [Interval; 2],
    ) -> Vec<([f64; 2], Polynomial)> {
        let (load, tension) = (enclosed.load, Interval::exact(enclosed.tension));
        // For each interval between changes of the load: its start, the shear force and moment there, and `∬q` beyond it.
        let mut breaks = load.breaks(self.from, self.to).into_iter().peekable();
        let at = |x: f64, to: f64| Polynomial::new(&load.line(x, [x, to])).integral().integral();
        let next =
            |breaks: &mut std::iter::Peekable<std::vec::IntoIter<f64>>| breaks.peek().copied().unwrap_or(self.to);
        let (mut origin, mut moment, mut shear) = (self.from, moments[0], self.shears(enclosed.tension, moments)[0]);
        let mut caused = at(origin, next(&mut breaks));
        let of = |([from, to], v): &([f64; 2], Polynomial)| {
            let line = Polynomial::new(&[moment, shear]).minus(&caused).shifted(Interval::length(origin, *from));
            let risen = v.minus(&Polynomial::new(&[self.start[0]])).times(tension);
            if breaks.next_if(|x| x.total_cmp(to).is_eq()).is_some() {
                let there = Polynomial::new(&[moment, shear]).minus(&caused).shifted(Interval::length(origin, *to));
                let [m, v] = [0, 1].map(|k| there.coefficients().get(k).copied().unwrap_or(Interval::ZERO));
                (origin, moment, shear) = (*to, m + load.couple(*to), v - load.point(*to));
                caused = at(origin, next(&mut breaks));
            }
            ([*from, *to], line.minus(&risen))
        };
        parts.iter().map(of).collect()
    }

    /// An upper bound of `½∫ r²/EI + Σ (k [v̂'] + M)²/2k` over the parts, from the moments at the two ends of the span.
    pub(super) fn work_under_tension(
        &self,
        enclosed: &EnclosedScene<'_>,
        parts: &Parts,
        moments: [Interval; 2],
    ) -> Interval {
        let mut sum = Interval::ZERO;
        let bent = self.moments_under_tension(enclosed, parts, moments);
        for ((ends, v), (_, bent)) in parts.iter().zip(bent) {
            let (width, ei) = (Interval::length(ends[0], ends[1]), enclosed.stiffness_between(*ends));
            let rest = v.derivative().derivative().times(Interval::exact(ei)).plus(&bent);
            sum = sum + rest.integral_of_product(&rest, width).not_negative() / (number(2) * Interval::exact(ei));
            let Some(k) = enclosed.joint(ends[1]).filter(|k| 0.0 < *k) else { continue };
            let kink = self.kinks.iter().filter(|kink| kink.0.total_cmp(&ends[1]).is_eq());
            let turn = kink.fold(Interval::ZERO, |sum, kink| sum + kink.1) * Interval::exact(k);
            sum = sum + (turn + self.moment_behind(*ends, &bent, moments)).square() / (number(2) * Interval::exact(k));
        }
        sum
    }

    /// The moments that remain in hinges inside the span, with the position of each.
    pub(super) fn hinges_under_tension(
        &self,
        enclosed: &EnclosedScene<'_>,
        parts: &Parts,
        moments: [Interval; 2],
    ) -> Vec<(f64, Interval)> {
        if !self.kinks.iter().any(|kink| enclosed.is_hinge(kink.0)) {
            return Vec::new();
        }
        let bent = self.moments_under_tension(enclosed, parts, moments);
        let hinged = bent.into_iter().filter(|(ends, _)| enclosed.is_hinge(ends[1]));
        hinged.map(|(ends, bent)| (ends[1], self.moment_behind(ends, &bent, moments))).collect()
    }

    /// `M` at the right end of a part.
    fn moment_behind(&self, [from, to]: [f64; 2], bent: &Polynomial, moments: [Interval; 2]) -> Interval {
        if to.total_cmp(&self.to).is_eq() { moments[1] } else { bent.at(Interval::length(from, to)) }
    }

    /// Lifts the parts next to contacts separately, as far as necessary. If a whole span were lifted, the axial force would amplify a
    /// rounding of `h''` at a contact. Returns an upper bound of the square root of the cost.
    pub(super) fn lift_beside(
        &self,
        enclosed: &EnclosedScene<'_>,
        curves: &mut [Curve],
        nodes: [Option<&ContactNode>; 2],
    ) -> Option<Interval> {
        let mut cost = Interval::ZERO;
        if self.hung.is_none() || curves.len() < 2 {
            return Some(cost);
        }
        let all = curves.len();
        let sides = [(true, [nodes[0], None]), (false, [None, nodes[1]])];
        for (left, ends) in sides.into_iter().filter(|(_, ends)| *ends != [None; 2]) {
            // On a very short part everything is rounding, so up to three parts are combined.
            let (lift, beside, width) = [1, 2, 3].into_iter().filter(|count| *count < all).find_map(|count| {
                let beside = if left { 0..count } else { all - count..all };
                let [from, to] = [curves[beside.start].0[0], curves[beside.end - 1].0[1]];
                let part = Self { from, to, ..self.clone() };
                let lift = clearance::lift(enclosed, &part, &curves[beside.clone()], ends)?;
                Some((lift, beside, Interval::length(from, to)))
            })?;
            let bent = lift.derivative().derivative();
            let bent = bent.integral_of_product(&bent, width).not_negative() * Interval::exact(enclosed.stiffest);
            cost = cost + enclosed.lifted(bent, &lift, width).sqrt();
            let start = curves[beside.start].0[0];
            for (ends, known) in &mut curves[beside] {
                *known = [0, 1].map(|i| known[i].minus(&lift.shifted(Interval::length(start, ends[i]))));
            }
        }
        Some(cost)
    }

    /// The deflection by parts, each about both of its ends. `breaks` are additional ends.
    pub(super) fn curves_of(&self, parts: &Parts, breaks: Vec<f64>) -> Vec<Curve> {
        let places = parts.iter().map(|part| part.0[0]).chain(breaks).collect();
        let curve = |cell: [f64; 2]| {
            let part = parts.partition_point(|part| part.0[1] <= cell[0]).min(parts.len() - 1);
            let about = |x: f64| parts[part].1.shifted(Interval::length(parts[part].0[0], x));
            (cell, cell.map(about))
        };
        cells(self.from, self.to, places).into_iter().map(curve).collect()
    }
}

impl EnclosedScene<'_> {
    /// An upper bound of `√(2/κ)` for a hinge; [`None`] without tension.
    pub(super) fn turn_of_hinge(&self, x: f64) -> Option<Interval> {
        (0.0 < self.tension).then_some(())?;
        let ends = self.joints.iter().map(|joint| joint.0).chain([0.0, self.length]);
        let free = ends.map(|end| Interval::length(x.min(end), x.max(end)).lo()).filter(|far| 0.0 < *far);
        let (free, tension) = (Interval::exact(free.fold(f64::INFINITY, f64::min)), Interval::exact(self.tension));
        let rate = (tension / Interval::exact(self.stiffness)).sqrt();
        Some((number(2) * (number(1) + rate * free) / (tension * free)).sqrt())
    }

    /// Whether a single position carries a beam under tension, so that the beam rotates there until its moments are balanced.
    pub(super) fn hangs_on(&self, nodes: &[ContactNode]) -> bool {
        let is_free = |node: &ContactNode| matches!(node.slope, Slope::Free(_));
        let is_held = |node: &ContactNode| self.support(node.x).is_some_and(|support| support.holds_slope());
        0.0 < self.tension && matches!(nodes, [node] if is_free(node) && !is_held(node))
    }

    /// The overhangs of such a beam, rotated by `ε` so that the moments on both sides of the position are balanced: `N ε l` equals their
    /// difference before.
    pub(super) fn balanced(&self, nodes: &[ContactNode], spans: Vec<Option<Span>>) -> Vec<Option<Span>> {
        let [node] = nodes else { return spans };
        if !self.hangs_on(nodes) {
            return spans;
        }
        let moment = |side: usize| {
            let curvature = spans[side].as_ref().map_or(Interval::ZERO, |span| [span.end, span.start][side][2]);
            -(self.stiffness_beside(node.x, side == 0) * curvature)
        };
        let jump = moment(1) - moment(0) - self.load.couple(node.x);
        let angle = -(jump / (Interval::exact(self.tension) * Interval::exact(self.length)));
        spans.iter().map(|span| span.as_ref()?.turned(self, node.x, angle)).collect()
    }

    /// The vertical force `H` of a beam that follows the foundation, on one side of a position.
    pub(super) fn force_along(&self, x: f64, left: bool) -> Interval {
        let (jet, stiffness) = (self.gap.jet(x, left), self.stiffness_beside(x, left));
        let shear = -(stiffness * jet[3]);
        if self.tension == 0.0 { shear } else { shear + Interval::exact(self.tension) * jet[1] }
    }

    /// `ρ²` of the lift of a span, from `∫ EI φ''²`, including the effect of the axial force.
    pub(super) fn lifted(&self, bent: Interval, lift: &Polynomial, length: Interval) -> Interval {
        if self.tension == 0.0 {
            return bent;
        }
        let square = lift.integral_of_product(lift, length).not_negative() / Interval::exact(self.stiffness);
        (bent.sqrt() + Interval::exact(self.tension.abs()) * square.sqrt()).square()
    }
}
