//! The laws of elastic supports: the force or the moment jump that each exerts.
//!
//! ```text
//! R = k (v − d)            elastic against settlement
//! M jumps by −k (v' − φ)   elastic against rotation
//! ```
//!
//! At a node the law is the equation for `v` or for `v'`; the other equations there use these as known numbers. Where the foundation
//! determines `v` or `v'`, it carries what the support does not.

use super::places::{SAME, has_lifted, is_same};
use crate::scene::Scene;
use crate::theory::Exact;

/// The law of an elastic support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// The node whose deflection or slope this equation determines; [`None`] if the foundation determines it.
    pub node: Option<usize>,
    /// The position \[length\].
    pub x: f64,
    /// Whether it is the law against rotation.
    pub turning: bool,
    /// `k` \[force / length, or force · length\].
    pub stiffness: f64,
    /// `d` or `φ`.
    pub without: f64,
    /// `v` or `v'` in the answer.
    pub now: f64,
    /// `R`, upwards, or the jump of `M` that it causes.
    pub exerts: f64,
}

impl Law {
    /// The laws of the supports that the beam has not lifted off, from left to right, with nodes at these positions.
    pub(super) fn all(scene: &Scene, exact: &Exact, nodes: &[f64]) -> Vec<Self> {
        let here = SAME * scene.beam().length();
        let is_here = |x: f64, other: f64| is_same(scene, x, other);
        let node = |x: f64| nodes.iter().position(|node| is_here(*node, x));
        let contacts = &exact.state.contacts;
        let touches = |x: f64| contacts.iter().any(|c| c.from - here <= x && x <= c.to + here);
        let follows = |x: f64| {
            let in_zone = contacts.iter().any(|c| c.from < c.to && c.from - here <= x && x <= c.to + here);
            exact.is_rigid() && (in_zone || exact.held().iter().any(|(held, _)| is_here(*held, x)))
        };
        let mut laws: Vec<Self> = Vec::new();
        let lifted = |x: f64| exact.state.supports.iter().any(|s| is_here(s.at, x) && has_lifted(s));
        let exerted = |x: f64| exact.state.supports.iter().find(|support| is_here(support.at, x));
        let turning = |x: f64, of: Option<[f64; 2]>| {
            let couple = exerted(x).map_or(0.0, |support| support.couple);
            let law = |[stiffness, without]: [f64; 2]| {
                let (node, now) = (node(x).filter(|_| !follows(x)), exact.slope(x));
                let exerts = if node.is_some() { couple } else { -stiffness * (now - without) };
                Self { node, x, turning: true, stiffness, without, now, exerts }
            };
            of.map(law)
        };
        for spring in scene.springs().filter(|spring| !lifted(spring.at)) {
            let (x, exerts) = (spring.at, exerted(spring.at).map_or(0.0, |support| support.force));
            let (stiffness, without, now) = (spring.stiffness, spring.deflection, exact.deflection(x));
            let node = node(x).filter(|_| !(exact.is_rigid() && touches(x)));
            laws.push(Self { node, x, turning: false, stiffness, without, now, exerts });
            laws.extend(turning(x, spring.turning));
        }
        laws.extend(scene.held().into_iter().filter_map(|held| turning(held.at, held.turning)));
        laws.sort_by(|a, b| a.x.total_cmp(&b.x));
        laws
    }

    /// The force or moment jump according to the law.
    #[must_use]
    pub fn says(&self) -> f64 {
        let gives = self.stiffness * (self.now - self.without);
        if self.turning { -gives } else { gives }
    }
}
