//! The equations of a beam on an elastic foundation, or under an axial force `N`: a chain of links between nodes.
//!
//! A link has the deflections `v` and the moments `M` of its two ends. Nodes are the supports, the ends of the pressed parts, the
//! point loads and couples, the ends of distributed loads, and the points of a polyline within pressed parts. Further nodes divide
//! the pressed parts so that no pressed link is longer than `1/λ`, `4 λ⁴ = k/EI`. On a link
//!
//! ```text
//! EI v'''' + k v = q + k g    where the foundation presses,      EI v'''' = q    elsewhere
//! v'_l = c (v_r − v_l) − η v_l + w M_l + ω M_r + s_l       V_l = c (M_r − M_l) − η M_l − a v_l − σ v_r + t_l
//! v'_r = c (v_r − v_l) + η v_r − ω M_l − w M_r + s_r       V_r = c (M_r − M_l) + η M_r + σ v_l + a v_r + t_r
//! ```
//!
//! Without a foundation `c = 1/L, w = L/3EI, ω = L/6EI` and `η = a = σ = 0`: these are the equations of three moments. With
//! `K = k/EI`, `W_m = Σ (−K)^r L^(4r+m)/(4r+m)!` and `D = W₁² + K W₃²`,
//!
//! ```text
//! c = W₁/D,    η = (W₁ (W₀ − 1) + K W₂ W₃)/D,    w = (W₁ W₂ − W₀ W₃)/D EI,    ω = W₃/D EI,    a = (k EI) w,    σ = (k EI) ω
//! ```
//!
//! Under an axial force no link off a rigid foundation is longer than `1/μ`, `μ² = |N|/EI`, and `H = V + N v'` replaces `V`. With the
//! `W_m` of `EI v'''' − N v'' + k v = 0`, `n = N/EI` and `W₃'' = W₁ + n W₃`
//!
//! ```text
//! D = W₁ W₃'' + K W₃²,   c = W₃''/D,   η = (W₃'' (W₀ − 1) + K W₂ W₃)/D,   a = (k EI) w + N (c + η),   σ = (k EI) ω − N c
//! ```
//!
//! and a link along a rigid foundation has the slopes `s` and the forces `t` of the foundation.
//!
//! `s` and `t` are the slopes and the shear forces of a link whose ends have neither deflection nor moment. At every node `v'` is the
//! same on both sides, or the slope that a support fixes, and `V_right − V_left = R − P`. At a joint `v'` is less on the right by
//! `M/k`; at a hinge `M = 0`. Module `laws` gives the forces of elastic supports; at a support that is elastic against rotation `M`
//! jumps.
//!
//! The coefficients are computed here from the scene, on purpose not by the chain of beam theory, which they check.

use super::places::{Place, corners, found, has_lifted, is_in_zone, is_same, joint_at, lifted};
use super::{Law, What};
use crate::scene::{Scene, Support};
use crate::theory::Exact;
use crate::theory::gauss::Gauss;

/// A node between two links.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChainNode {
    /// The kind of the node.
    pub what: What,
    /// The position \[length\].
    pub x: f64,
    /// `v` \[length\].
    pub deflection: f64,
    /// The slope that a support fixes.
    pub slope: Option<f64>,
    /// `M` just left and just right of the node \[force · length\].
    pub moments: [f64; 2],
    /// The point load at the node \[force\].
    pub load: f64,
    /// The reaction of the support there, upwards on the beam \[force\].
    pub force: f64,
    /// The stiffness of a joint there, zero for a hinge \[force · length\].
    pub joint: Option<f64>,
}

/// The beam between two neighbouring nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// `L` \[length\].
    pub length: f64,
    /// Whether the foundation presses on it.
    pub pressed: bool,
    /// Whether it lies along a rigid foundation.
    pub lies: bool,
    /// `c` and `η` \[1/length\].
    pub stretch: [f64; 2],
    /// `w` and `ω` \[1/(force · length)\].
    pub bend: [f64; 2],
    /// `a` and `σ` \[force/length\].
    pub spring: [f64; 2],
    /// `s_l` and `s_r`.
    pub slopes: [f64; 2],
    /// `t_l` and `t_r` \[force\].
    pub shears: [f64; 2],
}

/// A slope or shear force at one end of a link, as a sum of three contributions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parts {
    /// The contribution of the deflections `v`.
    pub deflections: f64,
    /// The contribution of the moments `M`.
    pub moments: f64,
    /// The contribution `s` or `t` of load and foundation.
    pub load: f64,
}

impl Parts {
    /// The sum of the three.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.deflections + self.moments + self.load
    }

    /// The largest of the three in magnitude.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.deflections.abs().max(self.moments.abs()).max(self.load.abs())
    }
}

/// The nodes and links of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// From left to right.
    pub nodes: Vec<ChainNode>,
    /// Link `i` is between nodes `i` and `i + 1`.
    pub links: Vec<Link>,
    /// Positions of supports that the beam has lifted off; they are no nodes \[length\].
    pub lifted: Vec<f64>,
    /// The laws of elastic supports, from left to right.
    pub laws: Vec<Law>,
    /// `N`; if it is not zero, `V` stands for `H` \[force\].
    pub tension: f64,
}

impl Chain {
    /// The chain of an exact answer of its scene; [`None`] if the foundation is not elastic and no axial force acts on the beam.
    #[must_use]
    pub fn of(scene: &Scene, exact: &Exact) -> Option<Self> {
        let tension = scene.beam().tension();
        (scene.ground_stiffness().is_some() || tension != 0.0).then_some(())?;
        let nodes = nodes(scene, exact);
        let link = |pair: &[ChainNode]| {
            let ends = [pair[0].x, pair[1].x];
            let is_pressed = is_in_zone(exact, 0.5 * (ends[0] + ends[1]));
            if exact.is_rigid() && is_pressed {
                return Link::along(exact, ends, tension);
            }
            Link::of(scene, ends, if is_pressed { stiffness(scene, ends) } else { 0.0 })
        };
        let places: Vec<f64> = nodes.iter().map(|node| node.x).collect();
        let laws = Law::all(scene, exact, &places);
        Some(Self { links: nodes.windows(2).map(link).collect(), lifted: lifted(exact), laws, nodes, tension })
    }

    /// `v'` at a node, from the link to its left and from the link to its right.
    #[must_use]
    pub fn slopes(&self, node: usize) -> [Option<Parts>; 2] {
        self.beside(node, |link, [left, right], [moment_left, moment_right], is_right| {
            let ([c, eta], [w, omega]) = (link.stretch, link.bend);
            let chord = c * (right - left);
            match is_right {
                false => [chord - eta * left, w * moment_left + omega * moment_right, link.slopes[0]],
                true => [chord + eta * right, -omega * moment_left - w * moment_right, link.slopes[1]],
            }
        })
    }

    /// `V` at a node, from the link to its left and from the link to its right.
    #[must_use]
    pub fn shears(&self, node: usize) -> [Option<Parts>; 2] {
        self.beside(node, |link, [left, right], [moment_left, moment_right], is_right| {
            let ([c, eta], [a, sigma]) = (link.stretch, link.spring);
            let rise = c * (moment_right - moment_left);
            match is_right {
                false => [-a * left - sigma * right, rise - eta * moment_left, link.shears[0]],
                true => [sigma * left + a * right, rise + eta * moment_right, link.shears[1]],
            }
        })
    }

    /// The residuals of the equations at a node: the largest difference between `v'` on both sides and the given slope, less the
    /// rotation of a joint, and the equilibrium residual of the forces.
    #[must_use]
    pub fn residuals(&self, node: usize) -> [f64; 2] {
        let ([left, right], [before, behind]) = (self.slopes(node), self.shears(node));
        let at = &self.nodes[node];
        let sum = |parts: Option<Parts>| parts.map(|parts| parts.sum());
        let right = match at.joint {
            // A hinge rotates freely.
            Some(k) if k <= 0.0 => sum(left),
            Some(k) => sum(right).map(|slope| slope + at.moments[0] / k),
            None => sum(right),
        };
        let known = [sum(left), right, at.slope];
        let apart = |a: Option<f64>, b: Option<f64>| a.zip(b).map_or(0.0, |(a, b)| (a - b).abs());
        let turned = apart(known[0], known[1]).max(apart(known[0], known[2])).max(apart(known[1], known[2]));
        let [before, behind] = [before, behind].map(|side| sum(side).unwrap_or(0.0));
        [turned, (behind - before + at.load - at.force).abs()]
    }

    fn beside(&self, node: usize, of: impl Fn(&Link, [f64; 2], [f64; 2], bool) -> [f64; 3]) -> [Option<Parts>; 2] {
        [(node.checked_sub(1), true), (Some(node), false)].map(|(i, is_right)| {
            let (i, link) = (i?, self.links.get(i?)?);
            let [left, right] = [&self.nodes[i], &self.nodes[i + 1]];
            let ends = [left.deflection, right.deflection];
            let [deflections, moments, load] = of(link, ends, [left.moments[1], right.moments[0]], is_right);
            Some(Parts { deflections, moments, load })
        })
    }
}

impl Link {
    /// A link on springs of this stiffness, or off the foundation if it is zero.
    fn of(scene: &Scene, [from, to]: [f64; 2], stiffness: f64) -> Self {
        /// Exact to rounding for loads and waves over `1/λ`.
        const DEGREE: usize = 29;
        let (length, bending) = (to - from, scene.beam().stiffness_between(from, to));
        let tension = scene.beam().tension();
        let law @ [n, k] = [tension / bending, stiffness / bending];
        let [w0, w1, w2, w3] = [0, 1, 2, 3].map(|m| wave(m, law, length));
        let (less, bent) = (-k * wave(4, law, length), w1 + n * w3);
        let d = w1 * bent + k * w3 * w3;
        let (w, omega) = ((w1 * w2 - w0 * w3) / d, w3 / d);
        let own = |x: f64| scene.beam().shape().map_or(0.0, |shape| shape.depth(x));
        let ground = |x: f64| if 0.0 < stiffness { k * (scene.depth(x) - own(x)) } else { 0.0 };
        // A beam that starts without deflection, slope, moment and shear force: `v`, `v'`, `v''` and `v'''` at its other end.
        let mut begun = [0.0; 4];
        for (x, weight) in Gauss::exact_to(DEGREE).points(from, to) {
            let acts = weight * (intensity(scene, x) / bending + ground(x));
            let [w0, w1, w2, w3] = [0, 1, 2, 3].map(|m| wave(m, law, to - x));
            let grown = [w3, w2, w1 + n * w3, w0 + n * w2];
            begun.iter_mut().zip(grown).for_each(|(sum, grown)| *sum += acts * grown);
        }
        let turn = (w3 * begun[2] - bent * begun[0]) / d;
        let shear = (w1 * begun[2] + k * w3 * begun[0]) / d;
        let (stretch, slopes) =
            ([bent / d, (bent * less + k * w2 * w3) / d], [turn, turn * w0 - shear * w2 + begun[1]]);
        let far = k * w2 * turn + (w0 + n * w2) * shear - begun[3];
        Self {
            length,
            pressed: 0.0 < stiffness,
            lies: false,
            stretch,
            bend: [w / bending, omega / bending],
            spring: [stiffness * w + tension * (stretch[0] + stretch[1]), stiffness * omega - tension * stretch[0]],
            slopes,
            shears: [bending * shear + tension * slopes[0], bending * far + tension * slopes[1]],
        }
    }

    /// A link along a rigid foundation.
    fn along(exact: &Exact, [from, to]: [f64; 2], tension: f64) -> Self {
        // If the link ends at a hinge, its own slope counts there.
        let slopes = [from.next_up(), to.next_down()].map(|x| exact.slope(x));
        let shears = [exact.shear(from)[1] + tension * slopes[0], exact.shear(to)[0] + tension * slopes[1]];
        let none = [0.0; 2];
        Self { length: to - from, pressed: true, lies: true, stretch: none, bend: none, spring: none, slopes, shears }
    }
}

/// `W_m` of `v'''' = n v'' − K v`, over at most `1/λ` and `1/μ`.
fn wave(m: usize, [n, k]: [f64; 2], length: f64) -> f64 {
    /// Number of terms: over `1/λ` the next one is less than `4⁷/28!` of the first.
    const TERMS: usize = 28;
    /// Number of powers of the length that the terms use, from any first term.
    const MOST: usize = 4 + TERMS + 1;
    let over: [f64; MOST] = std::array::from_fn(|i| length / f64::from(u32::try_from(i.max(1)).unwrap_or(1)));
    let mut terms = [0.0; MOST];
    terms[m] = over[1..=m].iter().product();
    for i in m + 1..=m + TERMS {
        let before = |back: usize| i.checked_sub(back).map_or(0.0, |i| terms[i]);
        let times = |factor: f64, back: usize| over[i + 1 - back..=i].iter().fold(factor, |product, by| product * by);
        // The derivatives up to the third are given.
        terms[i] = if i < 4 { 0.0 } else { times(-k * before(4), 4) + times(n * before(2), 2) };
    }
    terms[m] + terms[m + 1..].iter().sum::<f64>()
}

/// The distributed load at a position inside a link.
fn intensity(scene: &Scene, x: f64) -> f64 {
    let here = scene.load().linear().iter().filter(|q| q.from <= x && x <= q.to);
    here.fold(scene.load().uniform(), |sum, q| sum + q.intensity(x))
}

/// `k` between two nodes.
fn stiffness(scene: &Scene, [from, to]: [f64; 2]) -> f64 {
    scene.ground_stiffness_beside(0.5 * (from + to))[0]
}

/// All places where something is, with the forces of supports.
fn places(scene: &Scene, exact: &Exact) -> Vec<Place> {
    let (state, length, load) = (&exact.state, scene.beam().length(), scene.load());
    let is_pressed = |x: f64| is_in_zone(exact, x);
    let mut found: Vec<Place> = if exact.is_rigid() { found(scene, exact) } else { Vec::new() };
    for support in state.supports.iter().filter(|support| !exact.is_rigid() && !has_lifted(support)) {
        let what = What::of_support(scene, support);
        found.push((support.at, what, support.force, what == What::BuiltIn));
    }
    let ends = [0.0, length].map(|end| (end, What::End));
    let zones = state.contacts.iter().flat_map(|c| [c.from, c.to]).map(|x| (x, What::ZoneEnd));
    let joints = scene.beam().joints().iter().map(|joint| (joint.at, What::Joint));
    let steps = scene.beam().changes().map(|x| (x, What::Step));
    let loads = load.concentrated().map(|acts| acts.at).chain(load.linear().iter().flat_map(|q| [q.from, q.to]));
    let others = ends.into_iter().chain(zones).chain(joints).chain(steps).chain(loads.map(|x| (x, What::Load)));
    // In a zone on a rigid foundation no equations are needed.
    let others = others.filter(|(x, _)| !(exact.is_rigid() && is_pressed(*x)));
    found.extend(others.map(|(x, what)| (x, what, 0.0, false)));
    let sunk = |x: &f64| !exact.is_rigid() && is_pressed(*x);
    let bends = scene.ground_changes().chain(corners(scene)).filter(sunk);
    found.extend(bends.map(|x| (x, What::Corner, 0.0, false)));
    // The sort is stable: of several nodes at one position the first determines the kind.
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.dedup_by(|next, kept| {
        let same = is_same(scene, next.0, kept.0);
        if same && kept.1 != What::BuiltIn && matches!(next.1, What::Support | What::BuiltIn | What::Spring) {
            *kept = *next;
        }
        same
    });
    found
}

/// Places, with those in between by which links of springs or under an axial force stay as short as their functions stay tame.
fn with_between(scene: &Scene, exact: &Exact, found: &[Place]) -> Vec<Place> {
    let mut all: Vec<Place> = Vec::new();
    for pair in found.windows(2) {
        let [from, to] = [pair[0].0, pair[1].0];
        let bending = scene.beam().stiffness_between(from, to);
        let decay = (0.25 * stiffness(scene, [from, to]) / bending).sqrt().sqrt();
        let pulled = (scene.beam().tension().abs() / bending).sqrt();
        let shortest = match (is_in_zone(exact, 0.5 * (from + to)), exact.is_rigid()) {
            (true, true) => 0.0,
            (true, false) => decay.max(pulled),
            (false, _) => pulled,
        };
        let parts = ((to - from) * shortest).ceil().max(1.0);
        let inside = (1_u32..).map(f64::from).take_while(|k| *k < parts);
        all.push(pair[0]);
        all.extend(inside.map(|k| (from + (to - from) * (k / parts), What::Between, 0.0, false)));
    }
    all.extend(found.last());
    all
}

/// The deflection that a rigid support gives the beam; the answer has it with rounding.
fn given_deflection(scene: &Scene, what: What, x: f64) -> Option<f64> {
    let beam = scene.beam();
    let is_here = |support: &&Support| is_same(scene, support.at, x);
    let supports = beam.all_supports();
    let support = supports.iter().find(is_here).filter(|_| matches!(what, What::Support | What::BuiltIn))?;
    Some(support.level - beam.shape().map_or(0.0, |shape| shape.depth(support.at)))
}

fn nodes(scene: &Scene, exact: &Exact) -> Vec<ChainNode> {
    let node = |(x, what, force, follows): Place| {
        let here = scene.load().point().iter().filter(|load| is_same(scene, load.at, x));
        let joint = joint_at(scene, x);
        ChainNode {
            what,
            x,
            deflection: given_deflection(scene, what, x).unwrap_or_else(|| exact.deflection(x)),
            // At a joint the slope has two values.
            slope: (follows && joint.is_none()).then(|| exact.slope(x)),
            moments: exact.moments(x),
            load: here.map(|load| load.force).sum(),
            force,
            joint,
        }
    };
    with_between(scene, exact, &places(scene, exact)).into_iter().map(node).collect()
}
