//! Grids with a node at every break of the scene: kinks, steps and point loads.
//!
//! A break between two nodes causes an error of first order in the spacing. A break at a node causes none. Of two grids of about the
//! same size, the grid with the breaks among its nodes is better by orders of magnitude.

use crate::scene::{Foundation, Grid, Scene};

/// Largest number of equal intervals that is tried. On a grid this fine there is little left to gain.
const MOST: u32 = 1000;

/// A node is at a position if their distance is below this fraction of the beam length: a few units in the last place.
const AT: f64 = 1e-14;

/// The smallest even number of equal intervals with a node at every break of foundation and load, so that a symmetrical beam has a
/// node at midspan. If there is none, only breaks of the foundation are required to be nodes, and if there is still none, neither.
/// Supports, joints and changes of the bending stiffness are always nodes. If even these need more than [`MOST`] intervals, the
/// result is the coarsest grid that fits, or 2.
pub(super) fn common_intervals(scene: &Scene) -> usize {
    let length = scene.beam().length();
    let mut foundation: Vec<f64> = match scene.foundation() {
        Some(Foundation::Polyline { points }) => points.iter().map(|point| point[0] / length).collect(),
        _ => Vec::new(),
    };
    let mut all: Vec<f64> = Vec::new();
    all.extend(scene.load().places(length).map(|x| x / length));
    // Supports inside the beam and changes of the beam must be nodes; all other breaks should be.
    let beam = scene.beam();
    let mut inner: Vec<f64> = beam.all_supports().iter().map(|support| support.at / length).collect();
    inner.extend(beam.joints().iter().map(|joint| joint.at).chain(beam.changes()).map(|at| at / length));
    if let Some(Foundation::Polyline { points }) = scene.beam().shape() {
        foundation.extend(points.iter().map(|point| point[0] / length));
    }
    all.extend(&foundation);
    let common = |places: &[f64]| {
        let meets = |parts: u32| places.iter().chain(&inner).all(|&x| divides(x, parts));
        (1..=MOST).find(|&parts| meets(parts))
    };
    let found = common(&all).or_else(|| common(&foundation)).or_else(|| common(&[]));
    let Some(found) = found else { return Grid::least_fitting(scene).unwrap_or(2) };
    let even = if found % 2 == 0 { found } else { 2 * found };
    usize::try_from(even).unwrap_or(2)
}

/// Whether the position, a fraction of the length, is a multiple of one part.
fn divides(x: f64, parts: u32) -> bool {
    let place = x * f64::from(parts);
    (place - place.round()).abs() <= AT * f64::from(parts)
}

#[cfg(test)]
mod tests {
    use super::common_intervals;
    use crate::scene::{Beam, Foundation, Grid, Load, PointLoad, Scene, Support};

    #[track_caller]
    fn check(length: f64, places: &[f64], load: f64, expected: usize) {
        let beam = Beam::new(length, 1.0).expect("a beam");
        let points = std::iter::once(0.0).chain(places.iter().copied()).chain([length]).map(|x| [x, 1.0]).collect();
        let point = vec![PointLoad { at: load, force: 1.0 }];
        let load = Load::new(&beam, 0.0, Vec::new(), point).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Polyline { points })).expect("a scene");
        assert_eq!(common_intervals(&scene), expected, "{places:?} and a load on a beam of {length}");
    }

    #[test]
    fn nodes_fall_on_breaks() {
        check(10.0, &[3.0, 4.0, 5.0], 5.0, 10);
        check(10.0, &[4.0, 4.0], 10.0, 10);
        check(12.0, &[0.5, 11.5], 6.0, 24);
        check(0.3, &[0.1, 0.2], 0.1, 6);
        check(7.0, &[], 0.0, 2);
    }

    #[test]
    fn supports_come_first() {
        let supported = |places: &[f64]| {
            let supports = places.iter().map(|at| Support::simple(*at)).collect();
            let beam = Beam::new(10.0, 1.0).and_then(|beam| beam.with_supports(supports)).expect("a beam");
            let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: std::f64::consts::PI, force: 1.0 }]);
            Scene::new(beam, load.expect("a load"), None).expect("a scene")
        };
        // A load at which no grid has a node is ignored; such a support is not.
        for (places, common, step) in [
            ([0.0, 4.0, 10.0], 10, 5),
            ([0.0, 2.5, 6.0], 20, 20),
            ([0.0, 5.0, 10.0], 2, 2),
            ([0.0, 3.0, 4.567], 10_000, 10_000),
        ] {
            let scene = supported(&places);
            assert_eq!((common_intervals(&scene), Grid::step(&scene)), (common, Some(step)), "{places:?}");
        }
        assert_eq!(Grid::step(&supported(&[0.0, 10.0])), Some(1));
    }

    #[test]
    fn what_no_grid_meets_is_left() {
        check(10.0, &[5.0], std::f64::consts::PI, 2);
        check(10.0, &[std::f64::consts::E], 5.0, 2);
    }
}
