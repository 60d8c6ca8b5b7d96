//! A starting point from a coarse bed with fewer readings: the shallowest of each group, on which the beam rests first.

use super::bearings::search_with;
use crate::scene::{Foundation, Scene};
use crate::theory::piecewise::PiecewiseScene;

/// Number of readings in a group, of which one is kept. *Tuned* on surveys of 10³ to 10⁵ readings.
const TOGETHER: usize = 16;

/// Number of readings below which all are used from the beginning.
const FEWEST: usize = 512;

/// The stretches that springs of a stiffness over `EI` press on a coarse bed of a dimensionless scene; [`None`] if it has few readings.
pub(super) fn stretches(scene: &Scene, springs: f64) -> Option<Vec<[f64; 2]>> {
    let Some(Foundation::Polyline { points }) = scene.foundation() else { return None };
    if points.len() < FEWEST {
        return None;
    }
    let points = Foundation::Polyline { points: shallowest(points) };
    let coarse = scene.above_other(Some(points)).ok()?;
    let near = stretches(&coarse, springs);
    let (_, found) = search_with(PiecewiseScene::new(&coarse), springs, near.as_slice())?;
    found.settled.then_some(found.stretches)
}

/// The first and the last reading, readings at steps, and the shallowest reading of each group.
fn shallowest(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let is_step = |i: usize| {
        let at = |j: usize| points.get(j).is_some_and(|point| point[0] <= points[i][0]);
        at(i + 1) || 0 < i && points[i][0] <= points[i - 1][0]
    };
    let mut kept: Vec<usize> = (0..points.len()).filter(|i| is_step(*i)).collect();
    kept.extend([0, points.len() - 1]);
    let groups = (0..points.len()).step_by(TOGETHER).map(|i| i..(i + TOGETHER).min(points.len()));
    kept.extend(groups.filter_map(|mut group| {
        let first = group.next()?;
        Some(group.fold(first, |best, i| if points[i][1] < points[best][1] { i } else { best }))
    }));
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|i| points[i]).collect()
}
