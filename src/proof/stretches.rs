//! The nodes of a beam on an elastic foundation: the ends of the parts on which it is pressed, and its supports.

use dashu_ratio::RBig;

use super::contact_nodes::{HoldingNode, Part, PressedEnd};
use super::given::Given;
use super::polynomial::{Polynomial, exactly, short};
use crate::certificate::Stretch;
use crate::scene::Scale;

/// A penetration below this fraction of the largest one counts as zero, because lift-off positions have this many digits.
const SURFACE: f64 = 1e-10;

/// Terms below this fraction of the largest term of a polynomial are left out. The bracket contains the square of the error.
const NOTHING: f64 = 1e-20;

impl Given {
    /// The nodes of a beam that is pressed on the given stretches, from end to end. The stretches are dimensionless.
    pub(super) fn nodes_of_stretches(&self, stretches: &[Stretch], scale: &Scale) -> Vec<HoldingNode> {
        let mut nodes: Vec<HoldingNode> = Vec::new();
        let is_pressed = |i: Option<usize>| i.and_then(|i| stretches.get(i)).filter(|part| !part.sunk.is_empty());
        for i in 0..=stretches.len() {
            let [left, right] = [is_pressed(i.checked_sub(1)), is_pressed(Some(i))];
            let x = stretches.get(i).map_or(self.length, |part| part.from * scale.length);
            if left.is_none() && right.is_none() && self.support(x).is_none() {
                continue;
            }
            let part = right.map_or(Part::Span, |part| Part::Pressed(coefficients(part, scale)));
            let mut node = HoldingNode::new(x, None, part);
            if left.is_some() || right.is_some() {
                self.press(&mut node, [left, right], scale);
                if self.joint(x).is_some() {
                    // A part without contact on one side of a joint has its own slope.
                    let beside = [i.checked_sub(1).and_then(|i| stretches.get(i)), stretches.get(i)];
                    for (side, stretch) in beside.into_iter().enumerate() {
                        if let Some(part) = stretch.filter(|part| part.sunk.is_empty()) {
                            node.slopes[side] = exactly(part.ends[1 - side][1] * scale.slope());
                        }
                    }
                }
            }
            nodes.push(node);
        }
        nodes
    }

    /// Sets deflection, slope, moment and shear at an end of one or two pressed parts.
    fn press(&self, node: &mut HoldingNode, beside: [Option<&Stretch>; 2], scale: &Scale) {
        let x = node.x;
        let l = scale.length;
        let units = [0, 1, 2, 3].map(|j| scale.depth / [1.0, l, l * l, l * l * l][j]);
        // The derivatives of v on each side, from those of g and of v − g.
        let sides = [0, 1].map(|side| {
            let part = beside[side]?;
            let sunk = part.ends[1 - side];
            let gap = self.about(x, side == 0)?;
            let mut factorial = RBig::ONE;
            Some([0, 1, 2, 3].map(|j| {
                factorial *= RBig::from(j.max(1));
                let g = gap.get(j).cloned().unwrap_or(RBig::ZERO) * &factorial;
                g + exactly(sunk[j] * units[j])
            }))
        });
        let Some(one) = sides[1].as_ref().or(sides[0].as_ref()) else { return };
        // Where the beam lifts off, and no edge pushes it up, it is at the surface.
        let ends = beside
            .iter()
            .flatten()
            .flat_map(|part| part.ends.map(|end| (end[0].abs(), part.to - part.from, end[1].abs())));
        let deepest = ends.fold(0.0, |most: f64, (sunk, l, turn)| most.max(sunk.max(turn * l)));
        let sunk = beside[1].map(|part| part.ends[0][0]).or(beside[0].map(|part| part.ends[1][0])).unwrap_or(0.0);
        let lifts_off = beside.iter().any(Option::is_none) && sunk <= SURFACE * deepest;
        let surface = self.gap_beside(x, sides[1].is_none()).filter(|_| lifts_off).map(|[g, _]| g);
        let stiffness = [true, false].map(|left| self.bending_beside(x, left));
        let moment = |of: &[RBig; 4], side: usize| short(&(-stiffness[side] * &of[2]));
        let splits = self.turning(x).is_some() || self.support(x).is_some_and(|s| s.slope.is_some());
        let is_end = [x <= 0.0, self.length <= x];
        let both =
            |of: &dyn Fn(&[RBig; 4], usize) -> RBig| [0, 1].map(|side| of(sides[side].as_ref().unwrap_or(one), side));
        let [_, couple] = self.acting(x);
        let hinged = self.joint(x).is_some_and(Option::is_none);
        let moments = match is_end {
            [false, false] if splits => both(&moment),
            [false, false] if hinged => [RBig::ZERO, RBig::ZERO],
            [false, false] => {
                let left = if sides[1].is_some() { moment(one, 1) - &couple } else { moment(one, 0) };
                [left.clone(), left + couple]
            }
            [true, _] if splits => [RBig::ZERO, moment(one, 1)],
            [_, true] if splits => [moment(one, 0), RBig::ZERO],
            [true, _] => [RBig::ZERO, couple],
            [_, true] => [-couple, RBig::ZERO],
        };
        let deflection = surface.unwrap_or_else(|| one[0].clone());
        let shear = |of: &[RBig; 4], side: usize| short(&(-stiffness[side] * &of[3] + &self.tension * &of[1]));
        node.slopes =
            [0, 1].map(|side| sides[side].as_ref().filter(|_| self.joint(x).is_some()).unwrap_or(one)[1].clone());
        node.pressed = Some(Box::new(PressedEnd { deflection, moment: moments, shear: both(&shear) }));
    }
}

/// The polynomial of a part in the units of the scene, without negligible terms.
fn coefficients(part: &Stretch, scale: &Scale) -> Polynomial {
    let l = part.to - part.from;
    let mut power = 1.0;
    let sizes: Vec<f64> = part
        .sunk
        .iter()
        .map(|c| {
            power *= l;
            (c * power).abs()
        })
        .collect();
    let most = sizes.iter().fold(0.0, |most: f64, size| most.max(*size));
    let terms = sizes.iter().rposition(|size| NOTHING * most < *size).map_or(0, |last| last + 1);
    let mut unit = exactly(scale.depth);
    let mut coefficients = Polynomial::new();
    for c in &part.sunk[..terms] {
        coefficients.push(exactly(*c) * &unit);
        unit /= exactly(scale.length);
    }
    coefficients
}
