//! Beams on supports of every kind, beside the exact beam.

use super::*;
use crate::certificate::kernel::interval::Interval;
use crate::certificate::{ContactLoad, contact_load, in_intervals};
use crate::scene::{Balance, Beam, Load, PointLoad, Support};

const LENGTH: f64 = 8.0;
const INTERVALS: usize = 32;

/// Beams on supports of every kind under forces at nodes: one simple support with a node of a given deflection, one built in,
/// several with overhangs.
fn scenes() -> Vec<Scene> {
    let (simple, built_in) = (Support::simple, Support::built_in);
    let turned = Support { at: 3.0, level: 0.2, slope: Some(-0.1) };
    let lists = [
        vec![simple(0.0), simple(LENGTH)],
        vec![simple(1.0), simple(6.0).at_level(0.3)],
        vec![built_in(0.0)],
        vec![turned],
        vec![built_in(LENGTH), simple(2.0), simple(3.0).at_level(-0.1)],
        vec![simple(0.5), turned, simple(5.0), built_in(7.75)],
        vec![built_in(0.0), simple(0.25), built_in(LENGTH)],
    ];
    let scene = |supports| {
        let beam = Beam::new(LENGTH, 3.0).expect("positive").with_supports(supports).expect("on the beam");
        let point = [(0.0, 0.5), (1.25, 2.0), (4.0, -1.0), (6.5, 1.0), (LENGTH, 0.75)];
        let point = point.map(|(at, force)| PointLoad { at, force }).to_vec();
        let load = Load::new(&beam, 0.0, Vec::new(), point).expect("finite");
        Scene::new(beam, load, None).expect("well posed")
    };
    lists.map(scene).to_vec()
}

/// Deflections at all nodes, and the sum of what the supports exert.
fn solved(scene: &Scene, intervals: usize, discretisation: Discretisation) -> (Vec<f64>, f64) {
    let grid = Grid::uniform(scene, intervals).expect("a grid");
    let stations = supports(&grid, &scene.held()).expect("supports are nodes");
    let loads = grid.nodal_loads(scene.load());
    let beam = NodalBeam::of(scene, grid, loads, &stations, discretisation).expect("it is held");
    let mut deflection = vec![f64::NAN; intervals + 1];
    stations.iter().for_each(|station| deflection[station.node] = station.deflection);
    beam.walk(|first, _, deflections| deflection[first..first + deflections.len()].copy_from_slice(deflections));
    (deflection, beam.stations.iter().map(|(force, _)| force).sum())
}

/// An exact beam, from its spans in intervals.
fn exact(scene: &Scene, x: f64) -> f64 {
    let none = ContactLoad::new(LENGTH, []).expect("none");
    let cells = in_intervals(scene, Balance::Held, |enclosed| contact_load::deflection(&none, enclosed, &[]));
    let cells = cells.expect("it is held");
    let ([from, _], v) = cells[cells.partition_point(|c| c.0[1] < x).min(cells.len() - 1)];
    v.at(Interval::exact(x - from)).middle()
}

#[test]
fn an_exact_beam_under_nodal_forces_is_found() {
    for scene in scenes() {
        let (deflection, carried) = solved(&scene, INTERVALS, Discretisation::BeamElements);
        let size = deflection.iter().fold(0.1, |most: f64, v| most.max(v.abs()));
        for (k, v) in (0_u32..).zip(&deflection) {
            let expected = exact(&scene, 0.25 * f64::from(k));
            assert!((v - expected).abs() <= 1e-12 * size, "{v}, not {expected}, at node {k} of {:?}", scene.beam());
        }
        assert!((carried - 3.25).abs() <= 1e-11, "{:?} carry {carried}, not 3.25", scene.beam());
    }
}

/// Finite differences come to it with the square of the interval.
#[test]
fn finite_differences_come_to_the_exact_beam() {
    for scene in scenes() {
        let off = |intervals: usize| {
            let (deflection, _) = solved(&scene, intervals, Discretisation::FiniteDifferences);
            let step = intervals / INTERVALS;
            let nodes = (0_u32..).zip(deflection.iter().step_by(step));
            nodes.fold(0.0, |most: f64, (k, v)| most.max((v - exact(&scene, 0.25 * f64::from(k))).abs()))
        };
        let (coarse, fine) = (off(4 * INTERVALS), off(8 * INTERVALS));
        assert!(fine <= 0.3 * coarse + 1e-12 && coarse < 0.02, "{coarse} and {fine} of {:?}", scene.beam());
    }
}
