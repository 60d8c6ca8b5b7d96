//! The judged deflection, by cells and their parts, dimensionless.

use super::ContactLoad;
use super::kernel::contact_node::{EnclosedScene, EnclosedSupport};
use super::kernel::distance::{self, Error, Part};
use super::kernel::interval::Interval;
use super::kernel::polynomial::{Polynomial, number};
use super::kernel::proof::{Pair, Piece};
use super::kernel::tension::{Hung, MOST_TERMS};
use super::largest::largest;
use crate::scene::axial::as_cubic;
use crate::scene::{Beam, Scale};
use crate::state::{Discretisation, Nodes};

/// A part of a deflection: `v(from + s)`.
pub(crate) type Curve = ([f64; 2], Polynomial);

/// The deflection that is judged.
#[derive(Debug, Clone, Copy)]
pub enum Judged<'a> {
    /// The deflection at the nodes of a grid, with cubics between the nodes from deflections and moments.
    Nodes(&'a Nodes),
    /// The deflection caused by contact forces, by statics and integration under the true load.
    Forces(&'a ContactLoad),
    /// The deflection that follows from the positions of the candidate contact list.
    Witness,
}

impl Judged<'_> {
    /// The number of positions at which the deflection was computed.
    pub(crate) fn places(&self) -> usize {
        match self {
            Self::Nodes(nodes) => nodes.x.len(),
            Self::Forces(forces) => forces.pressing.len() + forces.pulling.len(),
            Self::Witness => 0,
        }
    }
}

impl Hung {
    /// Its ends, and its polynomial.
    pub(crate) fn curve(&self) -> Curve {
        let coefficients = self.deflection.iter().take(MOST_TERMS).map(|c| Interval::exact(*c));
        ([self.from, self.to], Polynomial::of(coefficients))
    }
}

/// A bound of the distance between the nodal deflection and the true one, and a lower bound of its size; [`None`] if there is no bound.
pub(super) fn of_nodes(
    enclosed: &EnclosedScene<'_>,
    scale: &Scale,
    pair: &Pair,
    nodes: &Nodes,
) -> Option<(Error, f64)> {
    let EnclosedScene { stiffness, length, .. } = *enclosed;
    let cells = parts(&pair.pieces, cubics(nodes, scale, enclosed)?, length);
    Some((distance::of(pair, cells, stiffness, length)?, 0.0))
}

/// The same for a deflection by parts.
pub(super) fn of_curves(beam: &Beam, pair: &Pair, caused: &[Curve]) -> Option<(Error, f64)> {
    let (stiffness, length) = (beam.bending_stiffness(), beam.length());
    let cells = caused.iter().copied().map(Cell::of);
    let error = distance::of(pair, parts(&pair.pieces, cells, length), stiffness, length)?;
    let size = largest(caused.iter().copied());
    Some((Error { size: error.size.min(size.hi()), ..error }, size.lo()))
}

/// The same for the deflection that follows from the positions of the candidate contact list.
pub(super) fn of_witness(pair: &Pair, [greatest, least]: [Interval; 2], beam: &Beam) -> Option<(Error, f64)> {
    let length = beam.length();
    let most = Some(distance::of_witness(pair, beam.bending_stiffness(), length)).filter(|most| most.is_finite())?;
    let reached = greatest.lo().max(-least.hi());
    // The lift is not part of the deflection that follows from these positions.
    let at_least = (Interval::exact(reached) - Interval::exact(pair.lifted)).lo().max(0.0);
    Some((Error { most, at: 0.5 * length, size: greatest.hi().max(-least.lo()) }, at_least))
}

/// Largest width of a part that is compared at once, as a share of the beam. A wider cell is divided into at least [`PARTS`].
pub(super) const NARROW: f64 = 1.0 / 2048.0;
/// The excess of an enclosure over the values on a cell is proportional to the square of its length: with eight parts it is a
/// sixty-fourth.
const PARTS: f64 = 8.0;

/// A cell of a deflection: `v` and `v''` at both ends and inside; [`None`] if the inside is the cubic that follows from the ends.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    ends: [f64; 2],
    values: [[Interval; 2]; 2],
    inside: Option<Box<[Polynomial; 2]>>,
    fourth: f64,
}

impl Cell {
    /// The cell with `v(from + s)`.
    pub(super) fn of(([from, to], v): ([f64; 2], Polynomial)) -> Self {
        let width = Interval::exact(to) - Interval::exact(from);
        let bent = v.derivative().derivative();
        let fourth = bent.derivative().derivative().range(width).magnitude();
        let values = [Interval::ZERO, width].map(|s| [v.at(s), bent.at(s)]);
        Self { ends: [from, to], values, inside: Some(Box::new([v, bent])), fourth }
    }

    /// The cell divided at positions inside.
    fn parts(self, inner: Vec<f64>) -> impl Iterator<Item = Part> {
        let Self { ends: [from, to], values, inside, fourth } = self;
        let count = inner.len();
        // Most cells of a grid are not divided.
        let inside = inside.or_else(|| (0 < count).then(|| Box::new(cubic([from, to], values))));
        let end = move |k: usize| match k {
            0 => (from, values[0]),
            _ if k <= count => {
                let s = Interval::exact(inner[k - 1]) - Interval::exact(from);
                (
                    inner[k - 1],
                    inside.as_ref().map_or([Interval::WHOLE; 2], |inside| [inside[0].at(s), inside[1].at(s)]),
                )
            }
            _ => (to, values[1]),
        };
        (0..=count).map(move |k| {
            let [left, right] = [end(k), end(k + 1)];
            Part { ends: [left.0, right.0], values: [left.1, right.1], fourth }
        })
    }
}

/// The cubic from `v₀` and `κ₀` to `v₁` and `κ₁`, and its second derivative.
fn cubic([a, b]: [f64; 2], [[v0, k0], [v1, k1]]: [[Interval; 2]; 2]) -> [Polynomial; 2] {
    let width = Interval::exact(b) - Interval::exact(a);
    let slope = (v1 - v0) / width - width * (number(2) * k0 + k1) / number(6);
    let v = Polynomial::new(&[v0, slope, k0 / number(2), (k1 - k0) / (number(6) * width)]);
    [v, v.derivative().derivative()]
}

/// The positions inside a cell at which it is divided, so that each part is within one piece of `v̂`; usually none.
fn divided(pieces: &[Piece], [a, b]: [f64; 2], length: f64) -> Vec<f64> {
    let first = pieces.partition_point(|p| p.to <= a);
    let mut places: Vec<f64> = pieces[first..].iter().map(|p| p.to).take_while(|x| *x < b).collect();
    if NARROW * length < b - a {
        let parts = ((b - a) / (NARROW * length)).ceil().max(PARTS);
        places.extend((1..).map(f64::from).take_while(|k| *k < parts).map(|k| a + (b - a) * (k / parts)));
        places.sort_by(f64::total_cmp);
        places.dedup();
    }
    places
}

/// The parts of a deflection given by cells, for a comparison with `v̂` given by pieces.
pub(super) fn parts(pieces: &[Piece], cells: impl Iterator<Item = Cell>, length: f64) -> impl Iterator<Item = Part> {
    cells.flat_map(move |cell| {
        let inner = divided(pieces, cell.ends, length);
        cell.parts(inner)
    })
}

/// The cubics between the nodes of a grid, from the deflections and moments at both ends:
///
/// ```text
/// v = v₀ + (Δv/Δ − Δ (2 κ₀ + κ₁)/6) s + κ₀ s²/2 + (κ₁ − κ₀) s³/6Δ,     κ = −M/EI
/// κ₀ = 3 (Δv − φ Δ)/Δ² − κ₁/2                                           where the beam is built in with the slope φ
/// ```
///
/// Supports that are not nodes are added. Their deflection is known, and their moment is zero unless the beam is built in. Next to a
/// rotational spring the moment is extrapolated from the next two nodes. [`None`] if the nodes are not a beam from end to end.
pub(super) fn cubics<'a>(
    given: &Nodes,
    scale: &Scale,
    enclosed: &EnclosedScene<'a>,
) -> Option<impl Iterator<Item = Cell> + use<'a>> {
    let nodes = nodes_and_supports(given, scale, enclosed)?;
    let enclosed = *enclosed;
    let pulled = enclosed.tension != 0.0 && given.discretisation == Discretisation::BeamElements;
    let built_in = move |x: f64| enclosed.support(x).and_then(|support| support.slope);
    let turns = move |x: f64| {
        let held = enclosed.support(x).and_then(|support| support.gives);
        held.is_some_and(|gives| gives.turning.is_some())
            || enclosed.said.iter().any(|s| s.x.total_cmp(&x).is_eq() && s.gives.turning.is_some())
    };
    let beyond = |near: Option<&[f64; 3]>, next: Option<&[f64; 3]>, x: f64| {
        let ([a, _, m], [b, _, n]) = (near?, next?);
        Some(m + (n - m) * ((x - a) / (b - a)))
    };
    Some((1..nodes.len()).map(move |i| {
        let ([a, v0, mut m0], [b, v1, mut m1]) = (nodes[i - 1], nodes[i]);
        if turns(a) {
            m0 = beyond(nodes.get(i), nodes.get(i + 1), a).unwrap_or(m1);
        }
        if turns(b) {
            m1 = beyond(nodes.get(i - 1), i.checked_sub(2).and_then(|i| nodes.get(i)), b).unwrap_or(m0);
        }
        let turned = |slope: Interval, other: Interval| {
            let [width, rise] = [[b, a], [v1, v0]].map(|[to, from]| Interval::exact(to) - Interval::exact(from));
            number(3) * (rise - slope * width) / (width * width) - other / number(2)
        };
        let stiffness = enclosed.stiffness_between([a, b]);
        let [mut left, mut right] = [m0, m1].map(|moment| -Interval::exact(moment) / Interval::exact(stiffness));
        if pulled {
            // The curvatures that give an element under the axial force its end rotations.
            let z = enclosed.tension * (b - a) * (b - a) / stiffness;
            let [own, other] = as_cubic(z).map(Interval::exact);
            [left, right] = [own * left + other * right, own * right + other * left];
        }
        if let Some(slope) = built_in(a) {
            left = turned(slope, right);
        }
        if let Some(slope) = built_in(b) {
            // From the right end, slopes and curvatures have the opposite sign.
            right = -turned(slope, -left);
        }
        let values = [[Interval::exact(v0), left], [Interval::exact(v1), right]];
        Cell { ends: [a, b], values, inside: None, fourth: 0.0 }
    }))
}

/// Place, deflection and moment at each node and support, from end to end of the beam.
fn nodes_and_supports(given: &Nodes, scale: &Scale, enclosed: &EnclosedScene<'_>) -> Option<Vec<[f64; 3]>> {
    let EnclosedScene { length, supports, .. } = *enclosed;
    let n = given.x.len();
    if given.deflection.len() != n || given.moment.len() != n {
        return None;
    }
    let mut nodes: Vec<[f64; 3]> = Vec::with_capacity(n + supports.len());
    // What gives against sinking is a node, or an end that is none.
    let mut left = supports.iter().filter(|s| s.gives.is_none_or(|gives| gives.spring.is_none())).peekable();
    let added = |support: &EnclosedSupport| [support.x, support.deflection.middle(), 0.0];
    for k in 0..n {
        let x = given.x[k] / scale.length;
        nodes.extend(std::iter::from_fn(|| left.next_if(|s| s.x < x)).map(added));
        left.next_if(|s| s.x <= x);
        nodes.push([x, given.deflection[k] / scale.depth, given.moment[k] / scale.moment()]);
    }
    nodes.extend(left.map(added));
    let reaches = nodes.first().is_some_and(|node| node[0].abs() <= 0.0)
        && nodes.last().is_some_and(|node| (node[0] - length).abs() <= 0.0);
    (reaches && nodes.is_sorted_by(|a, b| a[0] < b[0])).then_some(nodes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::in_intervals;
    use crate::scene::{Balance, Beam, Load, Scene, Support};

    const LENGTH: f64 = 20.0;
    const STIFFNESS: f64 = 70.0;
    const ROUNDING: f64 = 1e-12;
    /// Units other than one.
    const SCALE: Scale = Scale { length: 2.0, depth: 0.5, force: 8.0 };

    /// The cubics of dimensionless numbers, given in units.
    fn of(supports: Vec<Support>, nodes: &[[f64; 3]]) -> Option<Vec<([f64; 2], Polynomial)>> {
        let beam = Beam::new(LENGTH, STIFFNESS).expect("positive").with_supports(supports).expect("on the beam");
        let scene = Scene::new(beam, Load::default(), None).expect("well posed");
        let given = Nodes {
            x: nodes.iter().map(|n| n[0] * SCALE.length).collect(),
            deflection: nodes.iter().map(|n| n[1] * SCALE.depth).collect(),
            moment: nodes.iter().map(|n| n[2] * SCALE.moment()).collect(),
            ..Nodes::default()
        };
        in_intervals(&scene, Balance::Held, |enclosed| {
            Some(cubics(&given, &SCALE, enclosed)?.map(|cell| (cell.ends, cubic(cell.ends, cell.values)[0])).collect())
        })
    }

    /// Compares value, slope and curvature of a cell at a share of its width.
    #[track_caller]
    fn is(([from, to], v): &([f64; 2], Polynomial), share: f64, expected: [f64; 3]) {
        let s = Interval::exact(share * (to - from));
        for (v, expected) in [*v, v.derivative(), v.derivative().derivative()].iter().zip(expected) {
            let found = v.at(s);
            assert!(
                found.lo() <= expected + ROUNDING && expected - ROUNDING <= found.hi(),
                "{found:?}, not {expected}"
            );
            assert!(found.hi() - found.lo() <= ROUNDING, "{found:?}");
        }
    }

    fn simple() -> Vec<Support> {
        vec![Support::simple(0.0), Support::simple(LENGTH)]
    }

    /// Between two supports that are not nodes, and one that is.
    #[test]
    fn between_nodes_the_beam_has_their_deflections_and_moments() {
        let mut supports = simple();
        supports.insert(1, Support { level: 0.25, ..Support::simple(5.0) });
        let nodes = [[4.0, 0.5, 3.0], [12.0, -1.0, -5.0]];
        let found = of(supports.clone(), &nodes).expect("from end to end");
        let all = [[0.0, 0.0, 0.0], nodes[0], [5.0, 0.25, 0.0], nodes[1], [LENGTH, 0.0, 0.0]];
        assert_eq!(found.len(), 4);
        for (cell, ends) in found.iter().zip(all.windows(2)) {
            let [[a, v0, m0], [b, v1, m1]] = [ends[0], ends[1]];
            assert_eq!(cell.0.map(f64::to_bits), [a, b].map(f64::to_bits));
            let (width, turn) = (b - a, (b - a) / (6.0 * STIFFNESS));
            is(cell, 0.0, [v0, (v1 - v0) / width + turn * (2.0 * m0 + m1), -m0 / STIFFNESS]);
            is(cell, 1.0, [v1, (v1 - v0) / width - turn * (m0 + 2.0 * m1), -m1 / STIFFNESS]);
        }
        let at_support =
            of(supports, &[[4.0, 0.5, 3.0], [5.0, 0.3, 2.0], [12.0, -1.0, -5.0]]).expect("from end to end");
        is(&at_support[2], 0.0, [0.3, -1.3 / 7.0 + 7.0 / (6.0 * STIFFNESS) * (4.0 - 5.0), -2.0 / STIFFNESS]);
    }

    /// Where the beam is built in, the cubic has the slope of the support and the moment that this requires; the other end of the cell
    /// keeps its own moment.
    #[test]
    fn where_the_beam_is_built_in_the_slope_is_known() {
        let built_in = |at: f64, slope: f64| Support { slope: Some(slope), ..Support::simple(at) };
        let slopes = [0.25, -0.125, 0.5];
        let supports = vec![built_in(0.0, slopes[0]), built_in(8.0, slopes[1]), built_in(LENGTH, slopes[2])];
        let nodes = [[3.0, 0.5, 3.0], [8.0, 0.125, 99.0], [14.0, -1.0, -5.0]];
        let found = of(supports, &nodes).expect("from end to end");
        // A cubic from v₀ with slope φ to v₁ with curvature κ₁: κ₀ = 3 (Δv − φ Δ)/Δ² − κ₁/2, v₁' = (3 Δv/Δ − φ)/2 + κ₁ Δ/4.
        let check = |cell: &([f64; 2], Polynomial), near: f64, slope: f64, v: [f64; 2], moment: f64| {
            let (width, curvature) = (cell.0[1] - cell.0[0], -moment / STIFFNESS);
            // Towards the right, or towards the left.
            let sign = 1.0 - 2.0 * near;
            let (rise, towards) = (v[1] - v[0], sign * slope);
            let bent = 3.0 * (rise - towards * width) / (width * width) - 0.5 * curvature;
            is(cell, near, [v[0], slope, bent]);
            let other = 0.5 * (3.0 * rise / width - towards) + 0.25 * curvature * width;
            is(cell, 1.0 - near, [v[1], sign * other, curvature]);
        };
        check(&found[0], 0.0, slopes[0], [0.0, 0.5], 3.0);
        check(&found[1], 1.0, slopes[1], [0.125, 0.5], 3.0);
        check(&found[2], 0.0, slopes[1], [0.125, -1.0], -5.0);
        check(&found[3], 1.0, slopes[2], [0.0, -1.0], -5.0);
    }

    #[test]
    fn nodes_that_are_not_in_order_or_not_complete_are_none() {
        let known = |x: &[f64]| of(simple(), &x.iter().map(|x| [*x, 1.0, 1.0]).collect::<Vec<_>>()).is_some();
        assert!(known(&[5.0, 6.0]) && known(&[0.0, 5.0, LENGTH]) && known(&[]));
        for x in [&[6.0, 5.0][..], &[5.0, 5.0], &[-1.0, 5.0], &[5.0, 21.0], &[5.0, f64::INFINITY], &[f64::NAN, 5.0]] {
            assert!(!known(x), "{x:?}");
        }
        // Without supports at its ends a beam is known from its first node to its last.
        let inside = || vec![Support::simple(4.0), Support::simple(9.0)];
        for (x, complete) in [(&[0.0, LENGTH][..], true), (&[0.0, 15.0], false), (&[1.0, LENGTH], false), (&[], false)]
        {
            let nodes: Vec<[f64; 3]> = x.iter().map(|x| [*x, 1.0, 1.0]).collect();
            assert_eq!(of(inside(), &nodes).is_some(), complete, "{x:?}");
        }
        let scene =
            Scene::new(Beam::new(LENGTH, STIFFNESS).expect("positive"), Load::default(), None).expect("well posed");
        for (deflections, moments, complete) in [(1, 2, false), (2, 1, false), (2, 2, true)] {
            let x = vec![5.0, 6.0];
            let nodes = Nodes { x, deflection: vec![1.0; deflections], moment: vec![1.0; moments], ..Nodes::default() };
            let found = in_intervals(&scene, Balance::Held, |enclosed| cubics(&nodes, &SCALE, enclosed).is_some());
            assert_eq!(found, complete, "{deflections} deflections, {moments} moments");
        }
    }
}
