//! An exact answer as equations to check by hand: three-moment equations on the contacts of the answer, with their numbers.
//!
//! Nodes are the supports, the points of contact, the ends of the zones and the ends of the beam. Between two nodes the beam is a
//! simple beam of length `L` with end moments `M`, end deflections `v` and a load. Its slopes at the left and right ends are
//!
//! ```text
//! v'_l = (v_r − v_l)/L + (L (2 M_l + M_r) + S_l) / (6 EI)
//! v'_r = (v_r − v_l)/L − (L (M_l + 2 M_r) + S_r) / (6 EI)
//! S_l = 1/L ∫ q ξ (L − ξ)(2L − ξ) dξ,    S_r = 1/L ∫ q ξ (L² − ξ²) dξ,    ξ from the left end
//! ```
//!
//! so that `S = q L³/4` for a uniform load. If the bending stiffness changes between the nodes, or if there are joints, other factors
//! replace `2L` and `L`, with the least `EI`. A joint at a node rotates by `M/k`. A hinge is a node whose moment is zero; its
//! deflection follows from the condition that no force acts there.
//!
//! Two spans that meet at a node have the same slope there: the equation of three moments (Clapeyron 1857). If the slope is given, by
//! a built-in end or by a foundation that the beam follows, each side has its own equation. If the position is unknown as well, the
//! additional equation determines it. Beyond the outermost nodes the beam overhangs, and statics gives its moment there. Forces
//! follow from moments: with the reactions `A` of a span to its own load
//!
//! ```text
//! V_l = (M_r − M_l)/L + A_l,    V_r = (M_r − M_l)/L − A_r,    R = V(x+) − V(x−) + P
//! ```
//!
//! Deflections, moments and forces are numbers of the answer. The terms of load and stiffness are integrated here from the scene, on
//! purpose not by the functions of beam theory: with the same functions an error in them would satisfy the equations.

mod bent;
mod laws;
mod places;
mod springs;
mod what;

pub use laws::Law;
pub use springs::{Chain, ChainNode, Link, Parts};
pub use what::What;

use crate::scene::{Concentrated, Scene};
use crate::theory::Exact;
use bent::{Bent, each_load};
use places::{Place, SAME, found, is_in_zone, is_same, joint_at, lifted};

/// Shear forces at two positions this close differ by less than this share if no force acts between them.
const NEARBY: f64 = 1e-9;

/// A node of the three-moment equations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// The kind of the node.
    pub what: What,
    /// The position \[length\].
    pub x: f64,
    /// The deflection of the beam \[length\].
    pub deflection: f64,
    /// The slope, where it is given.
    pub slope: Option<f64>,
    /// The bending moments just left and just right of the node \[force · length\].
    pub moments: [f64; 2],
    /// The shear forces just left and just right of it, zero beyond an end of the beam \[force\].
    pub shears: [f64; 2],
    /// The point load at the node \[force\].
    pub load: f64,
    /// The couple at the node: the moment jumps up by it from left to right \[force · length\].
    pub couple: f64,
    /// The reaction or contact force there, upwards on the beam \[force\].
    pub force: f64,
    /// The stiffness of a joint there, zero for a hinge \[force · length\].
    pub joint: Option<f64>,
}

/// The beam between two neighbouring nodes, where it does not lie on the foundation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// The left node; the right one is the next.
    pub left: usize,
    /// `L` \[length\].
    pub length: f64,
    /// The factors of the end moments in its slopes: `2L`, `L` and `2L` if its stiffness is constant \[length\].
    pub bend: [f64; 3],
    /// `S_l` and `S_r` \[force · length²\].
    pub load: [f64; 2],
    /// `A_l` and `A_r` \[force\].
    pub reactions: [f64; 2],
    /// The sum of the contributions of the load to both, without their signs: they may cancel.
    load_size: f64,
}

/// An overhang beyond a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overhang {
    /// The node at its root.
    pub root: usize,
    /// The node at its free end.
    pub tip: usize,
    /// The length \[length\].
    pub length: f64,
    /// The load on the overhang, without the load at its root \[force\].
    pub load: f64,
    /// The moment of this load about the root; the bending moment beside the root is minus this \[force · length\].
    pub moment: f64,
}

/// An equation at a node: `Σ coefficient · M = settlement − load`.
#[derive(Debug, Clone, PartialEq)]
pub struct Equation {
    /// The node.
    pub node: usize,
    /// The spans whose slopes the equation uses: the left one and the right one.
    pub spans: [Option<usize>; 2],
    /// Terms with a moment: node, whether just right of it, coefficient \[length\].
    pub terms: Vec<(usize, bool, f64)>,
    /// The contribution of deflections and given slopes, with `6 EI` \[force · length²\].
    pub settlement: f64,
    /// The contribution of the load \[force · length²\].
    pub load: f64,
}

/// The nodes, spans and equations of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// From left to right.
    pub nodes: Vec<Node>,
    /// From left to right.
    pub spans: Vec<Span>,
    /// The overhang on the left before the one on the right.
    pub overhangs: Vec<Overhang>,
    /// From left to right.
    pub equations: Vec<Equation>,
    /// Positions of supports that the beam has lifted off; they are no nodes \[length\].
    pub lifted: Vec<f64>,
    /// The laws of elastic supports, from left to right: a law at a node is an equation for its deflection or its slope.
    pub laws: Vec<Law>,
    /// `6 EI`, with the least bending stiffness.
    pub stiffness: f64,
}

impl Explanation {
    /// The equations of an exact answer of its scene.
    #[must_use]
    pub fn of(scene: &Scene, exact: &Exact) -> Self {
        let nodes = nodes(scene, exact);
        let (spans, overhangs) = (spans(scene, exact, &nodes), overhangs(scene, exact, &nodes));
        let stiffness = 6.0 * scene.beam().bending_stiffness();
        let equations = (0..nodes.len()).flat_map(|i| equations(&nodes, &spans, i, stiffness)).collect();
        let places: Vec<f64> = nodes.iter().map(|node| node.x).collect();
        let laws = Law::all(scene, exact, &places);
        Self { lifted: lifted(exact), laws, nodes, spans, overhangs, equations, stiffness }
    }

    /// The unknowns of the equations, each with its node: a moment with whether it is the one just right of the node, or [`None`] for
    /// a position or the deflection of a hinge.
    ///
    /// There are as many unknowns as equations plus hinges off the foundation; the deflection of a hinge follows from its zero force.
    /// The remaining moments are given: by overhangs, by the foundation along which the beam lies, or as zero at an end.
    #[must_use]
    pub fn unknowns(&self) -> Vec<(usize, Option<bool>)> {
        let mut unknowns = Vec::new();
        for (i, node) in self.nodes.iter().enumerate() {
            let [before, behind] =
                [self.spans.iter().any(|span| span.left + 1 == i), self.spans.iter().any(|span| span.left == i)];
            let is_place = matches!(node.what, What::Point | What::ZoneEnd);
            if node.joint == Some(0.0) {
                unknowns.extend((node.what == What::Hinge).then_some((i, None)));
                continue;
            }
            if node.slope.is_some() && !is_place {
                unknowns.extend([(before, false), (behind, true)].iter().filter(|(is, _)| *is).map(|s| (i, Some(s.1))));
            } else if before && behind {
                unknowns.push((i, Some(false)));
            }
            if is_place && (before || behind) {
                unknowns.push((i, None));
            }
        }
        unknowns
    }

    /// The left side of an equation with the moments of the answer, minus its right side \[force · length²\].
    #[must_use]
    pub fn residual(&self, equation: &Equation) -> f64 {
        let moment = |&(node, right, coefficient): &(usize, bool, f64)| {
            coefficient * self.nodes[node].moments[usize::from(right)]
        };
        equation.terms.iter().map(moment).sum::<f64>() - (equation.settlement - equation.load)
    }

    /// The largest of all end moments and of all `S/L`, the moments that the load of one span alone would cause \[force · length\].
    #[must_use]
    pub fn moment(&self) -> f64 {
        let moments = self.nodes.iter().flat_map(|node| node.moments).map(f64::abs);
        let bent = self.spans.iter().map(|span| span.load[0].abs().max(span.load[1].abs()) / span.length);
        moments.chain(bent).fold(0.0, f64::max)
    }

    /// The largest term of an equation, with which its residual is compared \[force · length²\].
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
    found(scene, exact).into_iter().map(|found| Node::of(scene, exact, found)).collect()
}

impl Node {
    /// A node with deflection, slope, moments and shear forces from beam theory.
    fn of(scene: &Scene, exact: &Exact, (x, what, force, follows): Place) -> Self {
        let length = scene.beam().length();
        let (deflection, moments) = (exact.deflection(x), exact.moments(x));
        let here = scene.load().concentrated().filter(|acts| is_same(scene, acts.at, x));
        let [load, couple] = here.fold([0.0; 2], |sum, acts| [sum[0] + acts.force, sum[1] + acts.couple]);
        // Next to anything that acts at this position, extrapolated back along a line; at a free end the load there.
        let beside = |side: usize, way: f64| {
            let [near, far] = [way, 2.0 * way].map(|way| exact.shear((x + way).clamp(0.0, length))[side]);
            if (near - far).abs() <= NEARBY * near.abs() { near + (near - far) } else { near }
        };
        let here = SAME * length;
        let shears = match what {
            What::End if x <= 0.0 => [0.0, -load],
            What::End => [load, 0.0],
            _ => [if here < x { beside(0, -here) } else { 0.0 }, if x + here < length { beside(1, here) } else { 0.0 }],
        };
        let (slope, joint) = (follows.then(|| exact.slope(x)), joint_at(scene, x));
        Self { what, x, deflection, slope, moments, shears, load, couple, force, joint }
    }
}

fn spans(scene: &Scene, exact: &Exact, nodes: &[Node]) -> Vec<Span> {
    let span = |(left, pair): (usize, &[Node])| {
        let [from, to] = [pair[0].x, pair[1].x];
        let Bent { bend, load, reactions, size } = Bent::of(scene, [from, to]);
        let length = to - from;
        (!is_in_zone(exact, 0.5 * (from + to))).then_some(Span { left, length, bend, load, reactions, load_size: size })
    };
    let overhang = |span: &Span| [span.left, span.left + 1].iter().any(|&node| nodes[node].what == What::End);
    nodes.windows(2).enumerate().filter_map(span).filter(|span| !overhang(span)).collect()
}

/// The parts between a free end of the beam and the next node.
fn overhangs(scene: &Scene, exact: &Exact, nodes: &[Node]) -> Vec<Overhang> {
    let last = nodes.len() - 1;
    let hangs = |&(tip, root): &(usize, usize)| {
        nodes[tip].what == What::End
            && nodes[root].what != What::End
            && !is_in_zone(exact, 0.5 * (nodes[tip].x + nodes[root].x))
    };
    let of = |(tip, root): (usize, usize)| {
        let [tip_at, at] = [nodes[tip].x, nodes[root].x];
        let (from, to) = (tip_at.min(at), tip_at.max(at));
        let (mut load, mut moment) = (0.0, 0.0);
        let here = SAME * scene.beam().length();
        each_load(scene, from, to, |Concentrated { at: x, force, couple }| {
            let lever = (x - at).abs();
            load += if here < lever && here < (x - tip_at).abs() { force } else { 0.0 };
            moment += if here < (x - tip_at).abs() { force * lever } else { 0.0 };
            moment += if at < tip_at { couple } else { -couple };
        });
        let length = to - from;
        let (tip_load, tip_moment) =
            (nodes[tip].load, if at < tip_at { nodes[tip].couple } else { -nodes[tip].couple });
        Overhang { root, tip, length, load: load + tip_load, moment: moment + tip_load * length + tip_moment }
    };
    [(0, 1), (last, last.saturating_sub(1))].into_iter().filter(|_| 0 < last).filter(hangs).map(of).collect()
}

/// The equations at a node: one for each side if the slope is given, one for both otherwise.
fn equations(nodes: &[Node], spans: &[Span], node: usize, stiffness: f64) -> Vec<Equation> {
    let before = spans.iter().position(|span| span.left + 1 == node);
    let behind = spans.iter().position(|span| span.left == node);
    let chord = |span: usize| {
        let Span { left, length, .. } = spans[span];
        stiffness * (nodes[left + 1].deflection - nodes[left].deflection) / length
    };
    // The moments of a span with their factors at its right end, and at its left end.
    let from_right = |span: usize| {
        let Span { left, bend: [_, across, own], .. } = spans[span];
        [(left, true, across), (left + 1, false, own)]
    };
    let from_left = |span: usize| {
        let Span { left, bend: [own, across, _], .. } = spans[span];
        [(left, true, own), (left + 1, false, across)]
    };
    // The rotation of a joint between the two.
    let joint = |joint: f64| (node, false, stiffness / joint);
    match (nodes[node].slope, before, behind) {
        _ if nodes[node].joint == Some(0.0) => Vec::new(),
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
            terms: from_right(before)
                .into_iter()
                .chain(nodes[node].joint.map(joint))
                .chain(from_left(behind))
                .collect(),
            settlement: chord(before) - chord(behind),
            load: spans[before].load[1] + spans[behind].load[0],
        }],
        _ => Vec::new(),
    }
}
