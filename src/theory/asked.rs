//! By what an answer is differentiated: which derivatives are asked for, and what is known of each before it is computed.

use super::changes::{Ground, curvature};
use super::derivatives::By;
use super::exact::Exact;
use super::missing::Missing;
use super::sensitivity::Change;
use crate::scene::{PointLoad, Quantity, Scene, Support};

/// A derivative to be computed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked {
    pub(super) by: By,
    pub(super) change: Change,
    pub(super) unit: f64,
    /// Whether there are scenes beside this one, as the number falls and as it grows.
    pub(super) open: [bool; 2],
    /// Known to be another on the other side.
    pub(super) one_sided: bool,
    /// Why it is not there where the change parts ground and support.
    pub(super) parts: Option<Missing>,
}

impl Asked {
    /// One of which nothing is known before.
    fn by(quantity: Quantity, change: Change, unit: f64) -> Self {
        Self { by: By::Number(quantity), change, unit, open: [true; 2], one_sided: false, parts: None }
    }
}

impl Exact {
    /// All derivatives that are asked for, in their order.
    pub(super) fn asked(&self, scene: &Scene) -> Vec<Asked> {
        let (scale, supports) = (&self.scale, self.at_supports(scene));
        let mut all = Vec::new();
        if scene.foundation().is_some() {
            let open = [!supports.iter().any(|s| s.at_level), true];
            let parts = supports.iter().find_map(|s| s.rests);
            let (by, change, unit) = (By::Depth, Change::Ground, scale.depth);
            all.push(Asked { by, change, unit, open, one_sided: false, parts });
        }
        all.push(Asked::by(Quantity::BendingStiffness, Change::Unload, scene.beam().bending_stiffness()));
        let stiffer = |ground| Asked::by(Quantity::GroundStiffness, Change::Stiffen, ground);
        all.extend(scene.ground_stiffness().map(stiffer));
        let more = Change::Uniform(1.0 / self.stiffness);
        all.push(Asked::by(Quantity::Uniform, more, scale.force / scale.length));
        let loads = scene.load().point().iter().enumerate();
        all.extend(loads.flat_map(|(i, load)| self.asked_of_load(scene, &supports, i, load)));
        let given = scene.beam().supports_as_given();
        let given = given.into_iter().enumerate();
        all.extend(given.flat_map(|(i, support)| self.asked_of_support(scene, &supports, i, &support)));
        all
    }

    /// The size of a point load and its place.
    fn asked_of_load(&self, scene: &Scene, supports: &[Ground], i: usize, load: &PointLoad) -> [Asked; 2] {
        let (scale, at) = (&self.scale, load.at / self.scale.length);
        let grows = Change::Force(at, 1.0 / self.stiffness);
        let size = load.force / scale.force / self.stiffness;
        // From a support to the ground beside it.
        let onto = scene.beam().supports().iter().zip(supports).find(|(s, _)| s.at <= load.at && load.at <= s.at);
        let onto = onto.and_then(|(_, here)| here.rests);
        let moves = Asked {
            open: [0.0 < at, at < self.given.length],
            // At the end of a zone the other side is another stretch.
            one_sided: self.ends_zone(at),
            parts: self.pulls(at, size).then_some(Missing::Pulls).or(onto),
            ..Asked::by(Quantity::PointAt(i), Change::Move(at, size), scale.length)
        };
        [Asked::by(Quantity::PointForce(i), grows, scale.force), moves]
    }

    /// The level of a support and, on rigid ground, its place.
    fn asked_of_support(&self, scene: &Scene, supports: &[Ground], given: usize, support: &Support) -> Vec<Asked> {
        let before = |these: &[Support]| these.iter().filter(|s| s.at < support.at).count();
        let pushes = || supports.len() + before(scene.beam().bearings());
        let i = if support.pushes_only { pushes() } else { before(scene.beam().supports()) };
        let here = supports.get(i).copied().unwrap_or_default();
        let level = |change: Change| Asked {
            open: [true, !here.at_level],
            parts: here.rests,
            ..Asked::by(Quantity::SupportLevel(given), change, self.scale.depth)
        };
        if self.springs.is_some() {
            let at = self.given.breakpoint_at(support.at / self.scale.length);
            return at.map(|at| level(Change::Level(at))).into_iter().collect();
        }
        vec![level(Change::Level(i)), self.asked_of_place(scene, &here, [given, i], support)]
    }

    /// The place of a support above this ground; `given` is its number in the scene and `i` that of the exact solution.
    fn asked_of_place(&self, scene: &Scene, here: &Ground, [given, i]: [usize; 2], support: &Support) -> Asked {
        let (scale, at_level) = (&self.scale, here.at_level);
        let (at_left, at_right) = (support.at <= 0.0, scene.beam().length() <= support.at);
        // Where the ground meets the support the beam may pass this place on one side only.
        let blocked = match (at_left, at_right) {
            (true, _) => [true, at_level && here.axis[1] <= 0.0],
            (_, true) => [at_level && 0.0 <= here.axis[0], true],
            _ => [at_level && 0.0 < here.axis[0], at_level && here.axis[1] < 0.0],
        };
        let side = usize::from(!blocked[1]);
        let unit = scale.length / scale.depth;
        let (own, kinked) = scene.beam().shape().map_or(([0.0; 2], false), |shape| {
            let slopes = shape.sides(support.at).map(|[_, slope]| slope);
            let kinked = slopes[0].total_cmp(&slopes[1]).is_ne();
            ([slopes[side] * unit, curvature(shape, support.at) * unit * scale.length], kinked)
        });
        let touches = blocked == [true; 2] || (at_left || at_right) && here.rests.is_some();
        Asked {
            open: [0, 1].map(|to| !blocked[to] && (to == side || !kinked)),
            one_sided: kinked || at_level && !here.flat,
            parts: here.rests.filter(|_| !here.flat).or(touches.then_some(Missing::Touches)),
            ..Asked::by(Quantity::SupportAt(given), Change::Support(i, own), scale.length)
        }
    }
}
