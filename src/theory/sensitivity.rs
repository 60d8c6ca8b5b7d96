//! Derivatives of an exact answer with respect to a number of its scene: the implicit function theorem for the equations of its list.
//!
//! The change `w = ∂v/∂λ` is a beam on the same nodes with `w'''' = ∂q/∂λ`. Its conditions at the nodes follow by differentiating their
//! equations along with their positions `z(λ)`:
//!
//! ```text
//! smooth point   w = ∂g,  z' = w'/h'',   w''(z+) − w''(z−) = R z'     a rotational spring of stiffness R/h''
//! end of a zone  w = ∂g,  w' = 0,        z' = w''/h''' in the span
//! edge           w = ∂g,  w'' the same on both sides
//! support        w = ∂d,  w'' the same on both sides, or w' = ∂φ where it is built in
//! force          R' = w'''(z−) − w'''(z+) + (p(z+) − p(z−)) z'     p the pressure of a zone, elsewhere zero
//! ```
//!
//! The load does not move with a node: a load that starts, ends or acts at a node keeps its position.
//!
//! So the slopes `w'` at the nodes solve one tridiagonal system, with Newton's matrix (module `newton`) in other unknowns.

use super::list::List;
use super::overhang::Overhang;
use super::piecewise::PiecewiseScene;
use super::span::{Span, fixed_end_of_load};
use super::tridiagonal::{factored, solved};

/// The change of a number, dimensionless and over `EI`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Change {
    /// The foundation under all contacts moves down by one.
    Ground,
    /// The same under the nodes from one index to another.
    GroundUnder(usize, usize),
    /// All loads decrease by their own size.
    Unload,
    /// An elastic foundation becomes stiffer by its own stiffness.
    Stiffen,
    /// The uniform load grows by this.
    Uniform(f64),
    /// A point load at a position grows by this.
    Force(f64, f64),
    /// A point load at a position and of this size moves to the right.
    Move(f64, f64),
    /// The support of this index moves down by one; on an elastic foundation the support at this breakpoint.
    Level(usize),
    /// The support of this index moves to the right along the axis of the beam, whose slope and curvature `w0'` and `w0''` are given.
    /// With the level `d` and the slope `φ` of the support, `v = d − w0`, and where it is built in `v' = φ − w0'`.
    Support(usize, [f64; 2]),
}

/// Rounding of a curvature as a share of its terms: a span that rotates and remains straight has none.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The change of a node and of its force.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct NodeChange {
    /// `z'`.
    pub(super) place: f64,
    /// `R'` of the force on the node; at a support it includes a load directly on it.
    pub(super) force: f64,
    /// `w`.
    pub(super) value: f64,
    /// `w'` to its left and to its right.
    pub(super) slopes: [f64; 2],
}

/// The fixed-end moments and shear forces of a change over a span.
#[derive(Debug, Clone, Copy, Default)]
struct Fixed {
    moment: [f64; 2],
    shear: [f64; 2],
}

impl Change {
    /// No change.
    const NOTHING: Self = Self::Uniform(0.0);

    /// Fixed-end moments and shear forces of the change over a span.
    fn over(self, given: &PiecewiseScene, span: &Span) -> Fixed {
        let (l, start) = (span.length(), span.a.x);
        match self {
            Self::Uniform(q) => Fixed { moment: [q * l * l / 12.0; 2], shear: [0.5 * q * l; 2] },
            Self::Unload => {
                let (moment, shear) = fixed_end_of_load(given, &span.a, &span.b);
                Fixed { moment: moment.map(|m| -m), shear: shear.map(|f| -f) }
            }
            Self::Force(at, p) if span.a.x < at && at < span.b.x => {
                let (s, r) = ((at - start) / l, (span.b.x - at) / l);
                Fixed { moment: [p * s * r * r * l, p * s * s * r * l], shear: [p * r, p * s] }
            }
            Self::Move(at, p) if span.a.x < at && at < span.b.x => {
                let (s, r) = ((at - start) / l, (span.b.x - at) / l);
                Fixed { moment: [p * (r * r - 2.0 * s * r), p * (2.0 * s * r - s * s)], shear: [-p / l, p / l] }
            }
            _ => Fixed::default(),
        }
    }

    /// The load of the change on an overhang beyond `x`: `[∫∂q, ∫∂q r]`.
    fn beyond(self, given: &PiecewiseScene, x: f64, at_left: bool) -> [f64; 2] {
        let length = if at_left { x } else { given.length - x };
        let outside = |at: f64| if at_left { at < x } else { x < at };
        match self {
            Self::Uniform(q) => [q * length, 0.5 * q * length * length],
            Self::Unload => {
                let Overhang { force, moment, .. } = Overhang::of(given, x, at_left);
                [-force, -moment]
            }
            Self::Force(at, p) if outside(at) => [p, p * (at - x).abs()],
            Self::Move(at, p) if outside(at) => [0.0, if at_left { -p } else { p }],
            _ => [0.0; 2],
        }
    }

    /// The increase of the load on a zone between two positions.
    pub(super) fn on_zone(self, given: &PiecewiseScene, from: f64, to: f64) -> f64 {
        match self {
            Self::Uniform(q) => q * (to - from),
            Self::Force(at, p) if from < at && at < to => p,
            Self::Unload => -given.load_inside(from, to),
            _ => 0.0,
        }
    }

    /// The increase of the load on a node, and of the couple on it.
    fn on_node(self, x: f64, standing: f64) -> [f64; 2] {
        let here = |at: f64| at <= x && x <= at;
        match self {
            Self::Force(at, p) if here(at) => [p, 0.0],
            Self::Move(at, p) if here(at) => [0.0, p],
            Self::Unload => [-standing, 0.0],
            _ => [0.0; 2],
        }
    }
}

/// The conditions on the change of the beam at a node.
struct Ask {
    value: f64,
    /// The slopes on both sides, if they are prescribed.
    slopes: Option<[f64; 2]>,
    /// `w''(+) − w''(−)` for a slope of zero, and its derivative with respect to the slope.
    jump: [f64; 2],
}

/// The change of the beam to the left and to the right of a node.
#[derive(Debug, Clone, Copy, Default)]
struct Ends {
    /// `w''`.
    bend: [f64; 2],
    /// `w'''`.
    third: [f64; 2],
}

/// The changes of the nodes of a solved list, for any change. The matrix of the slopes is always the same and is factored once.
#[derive(Debug)]
pub(super) struct Sensitivity<'a> {
    given: &'a PiecewiseScene,
    list: &'a List,
    spans: &'a [(usize, Span)],
    forces: &'a [f64],
    /// The spans to the left and to the right of each node.
    beside: Vec<[Option<&'a Span>; 2]>,
    /// The load directly on each node.
    standing: Vec<f64>,
    /// The support at each node, if any; compression-only supports are counted after the others.
    pub(super) supports: Vec<Option<usize>>,
    /// Per row: the factor for the row before, the pivot, and the entry to the right of it.
    factors: Vec<[f64; 3]>,
}

impl<'a> Sensitivity<'a> {
    /// For a list with its spans and forces. [`None`] if the beam is free to rotate, or a node has no force to hold it.
    pub(super) fn of(
        given: &'a PiecewiseScene,
        list: &'a List,
        spans: &'a [(usize, Span)],
        forces: &'a [f64],
    ) -> Option<Self> {
        let nodes = 0..list.nodes.len();
        let beside = nodes.clone().map(|i| ends(spans, i)).collect();
        let standing = nodes.clone().map(|i| standing(given, list, i)).collect();
        let supports = list.nodes.iter().map(|node| node.any_support(given)).collect();
        let mut all = Self { given, list, spans, forces, beside, standing, supports, factors: Vec::new() };
        // Rows: w''(−) − w''(+) + jump = 0 for each node that may rotate.
        let asks = nodes.map(|i| all.ask(Change::NOTHING, i));
        let free: Vec<Option<f64>> = asks.map(|ask| ask.slopes.is_none().then_some(ask.jump[1])).collect();
        let mut rows: Vec<[f64; 3]> = free.iter().map(|free| [0.0, free.unwrap_or(1.0), 0.0]).collect();
        for (right, span) in spans.iter().filter(|(_, span)| !span.is_overhang()) {
            let (l, left, right) = (span.length(), right - 1, *right);
            let beside = |node: usize| if free[node].is_some() { 2.0 / l } else { 0.0 };
            if free[left].is_some() {
                rows[left][1] += 4.0 / l;
                rows[left][2] += beside(right);
            }
            if free[right].is_some() {
                rows[right][1] += 4.0 / l;
                rows[right][0] += beside(left);
            }
        }
        all.factors = factored(rows)?;
        Some(all)
    }

    /// The changes of the nodes as a number falls and as it grows.
    pub(super) fn on_both_sides(&self, [falls, grows]: [Change; 2]) -> [Vec<NodeChange>; 2] {
        let grown = self.change(grows, 1.0);
        // The two sides differ where a zone ends.
        let is_one = falls == grows && self.list.zones().next().is_none();
        [if is_one { grown.clone() } else { self.change(falls, -1.0) }, grown]
    }

    /// The changes of the nodes per unit of a number: as it grows if `towards` is 1, as it falls if `towards` is −1.
    fn change(&self, of: Change, towards: f64) -> Vec<NodeChange> {
        let &Self { given, list, .. } = self;
        let n = list.nodes.len();
        let asks: Vec<Ask> = (0..n).map(|i| self.ask(of, i)).collect();
        let slopes = self.slopes(of, &asks);
        let beside = self.changed_ends(of, &asks, &slopes);
        let changes = (0..n).map(|i| {
            let node = &list.nodes[i];
            let [on_left, on_right] = self.beside[i];
            let load = self.standing[i];
            // A load at the end of a zone enters the span if that end moves inwards.
            let end_of_zone = |bend: f64, third: f64, inwards: f64| {
                let place = bend / third;
                if 0.0 < inwards * towards * place { bend / (third - inwards * load) } else { place }
            };
            let place = match node {
                _ if node.is_smooth() => slopes[i][0] / bend(self.beside[i]),
                _ if node.starts_zone() => {
                    end_of_zone(beside[i].bend[0], on_left.map_or(f64::NAN, |span| span.at_b[3]), 1.0)
                }
                _ if node.ends_zone() => {
                    end_of_zone(beside[i].bend[1], on_right.map_or(f64::NAN, |span| span.at_a[3]), -1.0)
                }
                _ if matches!(of, Change::Support(moved, _) if self.supports[i] == Some(moved)) => 1.0,
                _ => 0.0,
            };
            // A load keeps its position when the node moves, and so does an end of it: only the pressure of a zone moves.
            let pushed = |in_zone: bool, cell: fn(&PiecewiseScene, f64) -> usize| match in_zone {
                true => given.drive(given.cell_ahead(node.x, cell(given, node.x), towards * place), node.x),
                false => 0.0,
            };
            let jump = pushed(list.in_zone_before(i), PiecewiseScene::cell_to)
                - pushed(list.in_zone_before(i + 1), PiecewiseScene::cell_from);
            let [grown, _] = of.on_node(node.x, load);
            let moved = if place == 0.0 || jump == 0.0 { 0.0 } else { jump * place };
            let force = beside[i].third[0] - beside[i].third[1] + moved + grown;
            NodeChange { place, force, value: asks[i].value, slopes: slopes[i] }
        });
        changes.collect()
    }

    /// The conditions on the change at node `i`.
    fn ask(&self, of: Change, i: usize) -> Ask {
        let &Self { given, list, forces, .. } = self;
        let node = &list.nodes[i];
        let [_, turned] = of.on_node(node.x, 0.0);
        let ground = match of {
            Change::Ground => 1.0,
            Change::GroundUnder(from, to) if (from..=to).contains(&i) => 1.0,
            _ => 0.0,
        };
        let fixed = |value: f64| Ask { value, slopes: Some([0.0; 2]), jump: [0.0; 2] };
        if node.is_smooth() {
            let bend = bend(self.beside[i]);
            return match bend {
                0.0 => fixed(ground),
                _ => Ask { value: ground, slopes: None, jump: [-turned, forces[i] / bend] },
            };
        }
        let [on_left, on_right] = self.beside[i];
        let sides = [on_left.map(|span| span.beam_b), on_right.map(|span| span.beam_a)];
        // For a support that moves: the change of its level along the beam, and the curvature of the axis.
        let moves = |own: usize| match of {
            Change::Level(changed) if changed == own => (1.0, None),
            Change::Support(changed, [axis, bent]) if changed == own => {
                (-(sides.iter().flatten().next().map_or(0.0, |beam| beam[1]) + axis), Some(bent))
            }
            _ => (0.0, None),
        };
        let holding = self.supports[i].filter(|&index| index < given.supports.len());
        let Some(index) = holding else {
            let bearing = self.supports[i];
            return match bearing.map(moves) {
                _ if !node.is_edge(given) => fixed(ground),
                None => Ask { value: ground, slopes: None, jump: [-turned, 0.0] },
                // The support does not move with the foundation.
                Some((value, moved)) => {
                    let force = if moved.is_some() { forces[i] } else { 0.0 };
                    Ask { value, slopes: None, jump: [force - turned, 0.0] }
                }
            };
        };
        let (value, moved) = moves(index);
        if node.held_slope(given).is_some() {
            // w' = −(v'' + w0'') on either side; where the foundation fixes the slope, w' = g'' − v''.
            let support = &given.supports[index];
            let held = given.cells_beside(support.breakpoint)[usize::from(!list.follows_foundation(i)[0])];
            let moved = moved.map(|bent| if support.built_in { bent } else { -given.derivative(held, node.x, 2) });
            let slopes = sides.map(|beam| beam.zip(moved).map_or(0.0, |(beam, bent)| -(beam[2] + bent)));
            return Ask { value, slopes: Some(slopes), jump: [0.0; 2] };
        }
        let force = if moved.is_some() { forces[i] + self.standing[i] } else { 0.0 };
        Ask { value, slopes: None, jump: [force - turned, 0.0] }
    }

    /// `w'` to the left and to the right of the nodes.
    fn slopes(&self, of: Change, asks: &[Ask]) -> Vec<[f64; 2]> {
        let mut constants: Vec<f64> =
            asks.iter().map(|ask| if ask.slopes.is_some() { 0.0 } else { ask.jump[0] }).collect();
        let known = |i: usize, side: usize| asks[i].slopes.map_or(0.0, |slopes| slopes[side]);
        for (right, span) in self.spans {
            if let Some((node, at_left)) = self.overhang(*right, span) {
                let [_, moment] = of.beyond(self.given, self.list.nodes[node].x, at_left);
                constants[node] += if at_left { moment } else { -moment };
                continue;
            }
            let (l, left, right) = (span.length(), right - 1, *right);
            let fixed = of.over(self.given, span);
            let chord = (asks[right].value - asks[left].value) / l;
            // The prescribed ones of the two slopes, relative to the chord.
            let (a, b) = (known(left, 1) - chord, known(right, 0) - chord);
            constants[left] -= fixed.moment[0] - (4.0 * a + 2.0 * b) / l;
            constants[right] += fixed.moment[1] + (2.0 * a + 4.0 * b) / l;
        }
        // A prescribed slope is not an unknown.
        asks.iter()
            .zip(&mut constants)
            .filter(|(ask, _)| ask.slopes.is_some())
            .for_each(|(_, constant)| *constant = 0.0);
        let turns = solved(&self.factors, constants);
        asks.iter().zip(turns).map(|(ask, turn)| ask.slopes.unwrap_or([turn; 2])).collect()
    }

    /// The second and third derivatives of `w` to the left and to the right of each node.
    fn changed_ends(&self, of: Change, asks: &[Ask], slopes: &[[f64; 2]]) -> Vec<Ends> {
        let mut beside = vec![Ends::default(); asks.len()];
        for (right, span) in self.spans {
            if let Some((node, at_left)) = self.overhang(*right, span) {
                let [force, moment] = of.beyond(self.given, self.list.nodes[node].x, at_left);
                let side = usize::from(!at_left);
                beside[node].bend[side] = moment;
                beside[node].third[side] = if at_left { force } else { -force };
                continue;
            }
            let (l, left, right) = (span.length(), right - 1, *right);
            let fixed = of.over(self.given, span);
            let chord = (asks[right].value - asks[left].value) / l;
            let (a, b) = (slopes[left][1] - chord, slopes[right][0] - chord);
            let size = (slopes[left][1].abs() + slopes[right][0].abs() + 2.0 * chord.abs()) * 4.0 / l;
            let bend = |fixed: f64, turned: f64| {
                let bend = fixed + turned;
                if bend.abs() <= ROUNDING * (fixed.abs() + size) { 0.0 } else { bend }
            };
            let bends =
                [bend(fixed.moment[0], -(4.0 * a + 2.0 * b) / l), bend(fixed.moment[1], (2.0 * a + 4.0 * b) / l)];
            let across = (bends[1] - bends[0]) / l;
            (beside[left].bend[1], beside[left].third[1]) = (bends[0], across - fixed.shear[0]);
            (beside[right].bend[0], beside[right].third[0]) = (bends[1], across + fixed.shear[1]);
        }
        beside
    }

    /// The node at which an overhang starts, and whether the overhang is to its left; [`None`] for a span between two nodes.
    fn overhang(&self, right: usize, span: &Span) -> Option<(usize, bool)> {
        span.is_overhang().then(|| if right == 0 { (0, true) } else { (self.list.nodes.len() - 1, false) })
    }
}

/// The load directly on a node.
pub(super) fn standing(given: &PiecewiseScene, list: &List, i: usize) -> f64 {
    given.breakpoint_at(list.nodes[i].x).map_or(0.0, |i| given.breakpoints[i].acts.force())
}

/// The parts of the span to the left of a node; an undivided span has one.
pub(super) fn parts_before(spans: &[(usize, Span)], i: usize) -> &[(usize, Span)] {
    let from = spans.partition_point(|(right, _)| *right < i);
    let parts = spans[from..].partition_point(|(right, _)| *right == i);
    &spans[from..from + parts]
}

/// The part of the span to the left of a node that contains `x`, or the next part to the right.
pub(super) fn part_at(spans: &[(usize, Span)], i: usize, x: f64) -> Option<&Span> {
    parts_before(spans, i).iter().map(|(_, span)| span).find(|span| x <= span.b.x)
}

/// The spans to the left and to the right of a node; for divided ones the parts next to the node.
pub(super) fn ends(spans: &[(usize, Span)], i: usize) -> [Option<&Span>; 2] {
    let behind = spans.partition_point(|(right, _)| *right <= i);
    let before = behind.checked_sub(1).map(|before| &spans[before]).filter(|(right, _)| *right == i);
    let after = spans.get(behind).filter(|(right, _)| *right == i + 1);
    [before, after].map(|span| span.map(|(_, span)| span))
}

/// `h''` at a smooth point, which is the same in the spans on both sides.
fn bend([left, right]: [Option<&Span>; 2]) -> f64 {
    right.map(|span| span.at_a[2]).or(left.map(|span| span.at_b[2])).unwrap_or(f64::NAN)
}
