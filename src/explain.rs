//! An exact answer as equations to be checked by hand: the three-moment equations on the contacts that were found, with their
//! numbers.
//!
//! Nodes are the supports, the points of contact, the ends of the zones and the ends of the beam. Between two of them the beam is a
//! simple beam of length `L` with end moments `M`, the deflections `v` of its ends, and a load. Its slopes at the left and at the right
//! end are
//!
//! ```text
//! v'_l = (v_r − v_l)/L + (L (2 M_l + M_r) + S_l) / (6 EI)
//! v'_r = (v_r − v_l)/L − (L (M_l + 2 M_r) + S_r) / (6 EI)
//! S_l = 1/L ∫ q ξ (L − ξ)(2L − ξ) dξ,    S_r = 1/L ∫ q ξ (L² − ξ²) dξ,    ξ from the left end
//! ```
//!
//! so that `S = q L³/4` for a uniform load. Where two spans meet their slopes are the same: the equation of three moments (Clapeyron
//! 1857). Where a slope is given, by a built-in end or by ground that the beam follows, each side has an equation of its own; where the
//! place is not given as well, that is the equation for it.

use crate::scene::{Foundation, Scene};
use crate::theory::Exact;
use crate::theory::gauss::Gauss;

/// What stands at a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// An end of the beam at which nothing is.
    End,
    /// A simple support.
    Support,
    /// A support that holds the slope.
    BuiltIn,
    /// A point of contact whose place is a corner of the ground or an end of the beam.
    Corner,
    /// A point of contact at which the beam follows the slope of the ground: its place is an unknown.
    Point,
    /// An end of a zone: its place is an unknown.
    ZoneEnd,
}

impl What {
    /// In words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::End => "end of the beam",
            Self::Support => "support",
            Self::BuiltIn => "built-in support",
            Self::Corner => "contact at a corner",
            Self::Point => "contact at a point",
            Self::ZoneEnd => "end of a zone",
        }
    }
}

/// A node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// What stands there.
    pub what: What,
    /// Its place \[length\].
    pub x: f64,
    /// The deflection of the beam \[length\].
    pub deflection: f64,
    /// The slope, where it is given.
    pub slope: Option<f64>,
    /// The bending moments just left and just right of it \[force · length\].
    pub moments: [f64; 2],
    /// The force there, upwards on the beam \[force\].
    pub force: f64,
}

/// A stretch of the beam between two neighbouring nodes, off the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Its left node; the right one is the next.
    pub left: usize,
    /// `L` \[length\].
    pub length: f64,
    /// `S_l` and `S_r` \[force · length²\].
    pub load: [f64; 2],
    /// What the parts of the load contribute to both without their signs: they may cancel.
    load_size: f64,
}

/// An equation at a node: `Σ coefficient · M = settlement − load`.
#[derive(Debug, Clone, PartialEq)]
pub struct Equation {
    /// The node.
    pub node: usize,
    /// The spans whose slopes it takes: the one to the left, the one to the right.
    pub spans: [Option<usize>; 2],
    /// Moments: node, whether right of it, coefficient \[length\].
    pub terms: Vec<(usize, bool, f64)>,
    /// What deflections and given slopes contribute, with `6 EI` \[force · length²\].
    pub settlement: f64,
    /// What the load contributes \[force · length²\].
    pub load: f64,
}

/// Nodes, spans and equations of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// From left to right.
    pub nodes: Vec<Node>,
    /// From left to right.
    pub spans: Vec<Span>,
    /// From left to right.
    pub equations: Vec<Equation>,
    /// `6 EI`.
    pub stiffness: f64,
}

impl Explanation {
    /// Of an exact answer of its scene.
    #[must_use]
    pub fn of(scene: &Scene, exact: &Exact) -> Self {
        let nodes = nodes(scene, exact);
        let spans = spans(scene, exact, &nodes);
        let stiffness = 6.0 * scene.beam().bending_stiffness();
        let equations = (0..nodes.len()).flat_map(|i| equations(&nodes, &spans, i, stiffness)).collect();
        Self { nodes, spans, equations, stiffness }
    }

    /// The left side of an equation with the moments of the answer, less its right side \[force · length²\].
    #[must_use]
    pub fn residual(&self, equation: &Equation) -> f64 {
        let moment = |&(node, right, coefficient): &(usize, bool, f64)| {
            coefficient * self.nodes[node].moments[usize::from(right)]
        };
        equation.terms.iter().map(moment).sum::<f64>() - (equation.settlement - equation.load)
    }

    /// The largest moment, and what a load of one span alone would bend it by, `S/L` \[force · length\].
    #[must_use]
    pub fn moment(&self) -> f64 {
        let moments = self.nodes.iter().flat_map(|node| node.moments).map(f64::abs);
        let bent = self.spans.iter().map(|span| span.load[0].abs().max(span.load[1].abs()) / span.length);
        moments.chain(bent).fold(0.0, f64::max)
    }

    /// The largest part of an equation: what its residual is compared with \[force · length²\].
    #[must_use]
    pub fn size(&self, equation: &Equation) -> f64 {
        let moment = |&(node, right, coefficient): &(usize, bool, f64)| {
            (coefficient * self.nodes[node].moments[usize::from(right)]).abs()
        };
        // Deflections may cancel in the settlement.
        let depth = |span: usize| {
            let Span { left, length, .. } = self.spans[span];
            self.stiffness * self.nodes[left].deflection.abs().max(self.nodes[left + 1].deflection.abs()) / length
        };
        let spans = || equation.spans.into_iter().flatten();
        let loads = spans().map(|span| self.spans[span].load_size);
        equation.terms.iter().map(moment).chain(spans().map(depth)).chain(loads).fold(0.0, f64::max)
    }
}

fn nodes(scene: &Scene, exact: &Exact) -> Vec<Node> {
    let (beam, state) = (scene.beam(), &exact.state);
    let length = beam.length();
    let is_corner = |x: f64| {
        let at_vertex = |profile: &Foundation| match profile {
            Foundation::Polyline { points } => points.iter().any(|point| (point[0] - x).abs() <= 1e-12 * length),
            _ => false,
        };
        x <= 0.0 || length <= x || scene.foundation().into_iter().chain(beam.shape()).any(at_vertex)
    };
    let mut found: Vec<(f64, What, f64)> = Vec::new();
    // One off which the beam has lifted is none.
    for support in state.supports.iter().filter(|support| !support.pushes_only || 0.0 < support.force) {
        let what = if support.moment.is_some() { What::BuiltIn } else { What::Support };
        found.push((support.at, what, support.force));
    }
    for contact in &state.contacts {
        match contact.end_forces {
            Some([left, right]) if contact.from < contact.to => {
                found.extend([(contact.from, What::ZoneEnd, left), (contact.to, What::ZoneEnd, right)]);
            }
            _ if is_corner(contact.from) => found.push((contact.from, What::Corner, contact.force)),
            _ => found.push((contact.from, What::Point, contact.force)),
        }
    }
    found.extend([0.0, length].map(|end| (end, What::End, 0.0)));
    // Several at one place are one, of the kind of the first; their forces add up.
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.dedup_by(|next, kept| {
        let same = (next.0 - kept.0).abs() <= 1e-12 * length;
        if same {
            // A support or a contact rather than an end of the beam.
            let what = if kept.1 == What::End { next.1 } else { kept.1 };
            *kept = (kept.0, what, kept.2 + next.2);
        }
        same
    });
    let node = |(x, what, force)| {
        let given = matches!(what, What::BuiltIn | What::Point | What::ZoneEnd);
        let (deflection, moments) = (exact.deflection(x), exact.moments(x));
        Node { what, x, deflection, slope: given.then(|| exact.slope(x)), moments, force }
    };
    found.into_iter().map(node).collect()
}

fn spans(scene: &Scene, exact: &Exact, nodes: &[Node]) -> Vec<Span> {
    let in_zone = |from: f64, to: f64| {
        let middle = 0.5 * (from + to);
        exact.state.contacts.iter().any(|contact| contact.from < middle && middle < contact.to)
    };
    let span = |(left, pair): (usize, &[Node])| {
        let [from, to] = [pair[0].x, pair[1].x];
        let (load, load_size) = load_terms(scene, from, to);
        (!in_zone(from, to)).then_some(Span { left, length: to - from, load, load_size })
    };
    // Beyond the outermost supports and contacts the beam is held at one end only, and statics give its moment there.
    let overhang = |span: &Span| [span.left, span.left + 1].iter().any(|&node| nodes[node].what == What::End);
    nodes.windows(2).enumerate().filter_map(span).filter(|span| !overhang(span)).collect()
}

/// `S_l` and `S_r` of the load between two places, and the sum of both without signs.
fn load_terms(scene: &Scene, from: f64, to: f64) -> ([f64; 2], f64) {
    /// Of these integrals under a linear load.
    const DEGREE: usize = 4;
    let rule = Gauss::exact_to(DEGREE);
    let (load, length) = (scene.load(), to - from);
    let of_force = |at: f64, force: f64| {
        let xi = at - from;
        let common = force * xi * (length - xi) / length;
        [common * (2.0 * length - xi), common * (length + xi)]
    };
    let (mut sum, mut size) = ([0.0; 2], 0.0);
    let mut add = |[left, right]: [f64; 2]| {
        sum = [sum[0] + left, sum[1] + right];
        size += left.abs() + right.abs();
    };
    let inside = load.point().iter().filter(|point| from < point.at && point.at < to);
    inside.for_each(|point| add(of_force(point.at, point.force)));
    let whole = crate::scene::LinearLoad { from, to, start: load.uniform(), end: load.uniform() };
    for part in load.linear().iter().chain(std::iter::once(&whole)) {
        let [start, end] = [part.from.max(from), part.to.min(to)];
        if start < end {
            rule.points(start, end).for_each(|(x, weight)| add(of_force(x, part.intensity(x) * weight)));
        }
    }
    (sum, size)
}

/// The equations at a node: one for each side with a given slope, one for both where the slope is not given.
fn equations(nodes: &[Node], spans: &[Span], node: usize, stiffness: f64) -> Vec<Equation> {
    let before = spans.iter().position(|span| span.left + 1 == node);
    let behind = spans.iter().position(|span| span.left == node);
    let chord = |span: usize| {
        let Span { left, length, .. } = spans[span];
        stiffness * (nodes[left + 1].deflection - nodes[left].deflection) / length
    };
    // Moments of a span seen from its right end and from its left one.
    let from_right = |span: usize| {
        let Span { left, length, .. } = spans[span];
        [(left, true, length), (left + 1, false, 2.0 * length)]
    };
    let from_left = |span: usize| {
        let Span { left, length, .. } = spans[span];
        [(left, true, 2.0 * length), (left + 1, false, length)]
    };
    match (nodes[node].slope, before, behind) {
        (Some(slope), ..) => {
            let turned = stiffness * slope;
            let left = before.map(|span| Equation {
                node,
                spans: [Some(span), None],
                terms: from_right(span).to_vec(),
                settlement: chord(span) - turned,
                load: spans[span].load[1],
            });
            let right = behind.map(|span| Equation {
                node,
                spans: [None, Some(span)],
                terms: from_left(span).to_vec(),
                settlement: turned - chord(span),
                load: spans[span].load[0],
            });
            left.into_iter().chain(right).collect()
        }
        (None, Some(before), Some(behind)) => vec![Equation {
            node,
            spans: [Some(before), Some(behind)],
            terms: from_right(before).into_iter().chain(from_left(behind)).collect(),
            settlement: chord(before) - chord(behind),
            load: spans[before].load[1] + spans[behind].load[0],
        }],
        _ => Vec::new(),
    }
}
