//! Any deflection, lifted until it is admissible: `v̂ = v − w` with a smooth `w ≥ max(v − u, 0)`.
//!
//! `w` is a number at each node of a coarse mesh, not less than the deepest penetration in the two intervals beside it, and
//! rises and falls between the nodes with horizontal tangents; beside the supports, where it has to vanish, a parabola
//! `α x (l − x)` takes its place. Coarse meshes make a smooth `w`, fine ones a small one: the best of several is taken.

use super::curve::{Curve, Piece, overlay};
use super::ground::Ground;
use super::load::{Pieces, cells};
use super::polynomial::{Polynomial, number};
use crate::certificate::interval::Interval;

/// Intervals of the meshes that are tried.
const MESHES: [usize; 5] = [8, 32, 128, 512, 2048];
/// Parts of the beam, on top of those of the deflection itself, in which the penetration is bounded.
const PARTS: usize = 2048;
/// Bisections towards a support.
const TOWARDS_A_SUPPORT: i32 = 40;

/// The best lifted deflection and its energy; [`None`] if there is no finite one.
pub(super) fn lifted(
    curve: &Curve,
    ground: Option<&Ground<'_>>,
    load: &Pieces,
    stiffness: f64,
    length: f64,
) -> Option<(Curve, Interval)> {
    let Some(ground) = ground else {
        let energy = curve.energy(load, stiffness);
        return Some((curve.clone(), energy));
    };
    let depths = penetrations(curve, ground, length);
    if depths.iter().all(|(_, _, depth)| *depth <= 0.0) {
        let energy = curve.energy(load, stiffness);
        return energy.hi().is_finite().then(|| (curve.clone(), energy));
    }
    let candidates = MESHES.iter().filter_map(|&mesh| {
        let lift = lift(&depths, mesh, length)?;
        let lifted = minus(curve, &lift);
        let energy = lifted.energy(load, stiffness);
        energy.hi().is_finite().then_some((lifted, energy))
    });
    candidates.min_by(|a, b| a.1.hi().total_cmp(&b.1.hi()))
}

/// How deep the deflection is in the foundation, at most, by cells; and over `x (l − x)`, for cells at the supports.
fn penetrations(curve: &Curve, ground: &Ground<'_>, length: f64) -> Vec<([f64; 2], f64, f64)> {
    #[expect(clippy::cast_precision_loss, reason = "thousands")]
    let mut breaks: Vec<f64> = (1..PARTS).map(|k| length * (k as f64 / PARTS as f64)).collect();
    breaks.extend((12..TOWARDS_A_SUPPORT).map(|k| length * 0.5_f64.powi(k)));
    breaks.extend((12..TOWARDS_A_SUPPORT).map(|k| length - length * 0.5_f64.powi(k)));
    breaks.extend(ground.breaks(0.0, length));
    let grounds = cells(0.0, length, breaks).into_iter().map(|c| (c, ground.cell(c[0], c[1])));
    let deflections = curve.pieces.iter().map(|p| ([p.from, p.to], p.v));
    let mut found = Vec::new();
    let is_below = |x: f64| 0.0 <= ground.depth(x).lo();
    let follows: Vec<[f64; 2]> = curve.pieces.iter().filter(|p| p.follows).map(|p| [p.from, p.to]).collect();
    overlay(deflections, grounds, |a, b, v, u| {
        let lies = follows.partition_point(|f| f[1] <= a);
        if follows.get(lies).is_some_and(|f| f[0] <= a) {
            found.push(([a, b], 0.0, 0.0));
            return;
        }
        let width = Interval::exact(b) - Interval::exact(a);
        let below = v.minus(u);
        let depth = below.range(width).hi();
        let per = if depth <= 0.0 {
            0.0
        } else if a <= 0.0 && is_below(0.0) {
            // v − u ≤ s (…), since v = 0 ≤ u at the support: the quotient by s, over the least of l − s.
            let quotient = below.divided(1).range(width).hi();
            (Interval::exact(quotient) / (Interval::exact(length) - Interval::exact(b))).hi()
        } else if length <= b && is_below(length) {
            let mirrored = below.shifted(width);
            let signs = mirrored.coefficients().iter().enumerate().map(|(j, &c)| if j % 2 == 1 { -c } else { c });
            let quotient = Polynomial::new(&signs.collect::<Vec<_>>()).divided(1).range(width).hi();
            (Interval::exact(quotient) / Interval::exact(a)).hi()
        } else {
            let least = |x: f64| Interval::exact(x) * (Interval::exact(length) - Interval::exact(x));
            (Interval::exact(depth) / Interval::exact(least(a).lo().min(least(b).lo()).max(0.0))).hi()
        };
        found.push(([a, b], depth.max(0.0), per.max(0.0)));
    });
    found
}

/// `w` on its mesh.
fn lift(depths: &[([f64; 2], f64, f64)], mesh: usize, length: f64) -> Option<Vec<([f64; 2], Polynomial)>> {
    #[expect(clippy::cast_precision_loss, reason = "thousands")]
    let place = |j: usize| length * (j as f64 / mesh as f64);
    let (inner_from, inner_to) = (place(1), place(mesh - 1));
    let mut heights = vec![0.0_f64; mesh + 1];
    let mut per = 0.0_f64;
    for &([a, b], depth, over) in depths {
        if depth <= 0.0 {
            continue;
        }
        if a < inner_from || inner_to < b {
            per = per.max(over);
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "0 … mesh"
        )]
        let index = |x: f64| (x / length * mesh as f64) as usize;
        // One node more on each side than needed covers the rounding of the quotient.
        for height in &mut heights[index(a).saturating_sub(1)..=(index(b) + 2).min(mesh)] {
            *height = height.max(depth);
        }
    }
    (heights[0], heights[mesh]) = (0.0, 0.0);
    if !per.is_finite() || heights.iter().any(|h| !h.is_finite()) {
        return None;
    }
    let per = Interval::exact(per);
    let pieces = (0..mesh).map(|j| {
        let [from, to] = [place(j), if j + 1 == mesh { length } else { place(j + 1) }];
        let width = Interval::exact(to) - Interval::exact(from);
        let rise = Interval::exact(heights[j + 1]) - Interval::exact(heights[j]);
        let step = Polynomial::new(&[
            Interval::exact(heights[j]),
            Interval::ZERO,
            number(3) * rise / width / width,
            -(number(2) * rise / width / width / width),
        ]);
        // α (from + s)(l − from − s).
        let (x, rest) = (Interval::exact(from), Interval::exact(length) - Interval::exact(from));
        let parabola = Polynomial::new(&[per * x * rest, per * (rest - x), -per]);
        ([from, to], step.plus(&parabola))
    });
    Some(pieces.collect())
}

fn minus(curve: &Curve, lift: &[([f64; 2], Polynomial)]) -> Curve {
    let mut pieces = Vec::new();
    let deflections = curve.pieces.iter().map(|p| ([p.from, p.to], p.v));
    overlay(deflections, lift.iter().copied(), |from, to, v, w| {
        pieces.push(Piece { from, to, v: v.minus(w), follows: false });
    });
    Curve { pieces }
}

#[cfg(test)]
mod tests;
