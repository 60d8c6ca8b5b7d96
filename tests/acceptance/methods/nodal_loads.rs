//! Nodal loads of a grid: forces and moments of the loads that they stand for.

use palkki::scene::{Beam, Grid, LinearLoad, Load, PointLoad, Scene};

use crate::scenes::apart;

/// Sums of up to a thousand terms that do not grow.
const ROUNDING: f64 = 1e-13;

/// Resultant force and moment about the left support of nodal loads.
fn resultants(beam: &Beam, load: &Load, intervals: usize) -> (f64, f64) {
    let scene = Scene::new(beam.clone(), load.clone(), None).expect("a scene");
    let grid = Grid::uniform(&scene, intervals).expect("enough intervals");
    let forces = grid.nodal_loads(&scene);
    let mut few = [f64::NAN; 4];
    grid.loads(&scene, intervals - 1, &mut few);
    let expected = [forces[intervals - 1], forces[intervals], 0.0, 0.0];
    assert_eq!(few.map(f64::to_bits), expected.map(f64::to_bits), "the last two nodes, and none behind");
    assert_eq!(forces.len(), intervals + 1, "a load on every node");
    (forces.iter().sum(), forces.iter().enumerate().map(|(i, f)| f * grid.place(i)).sum())
}

#[test]
fn nodal_loads_keep_force_and_moment() {
    let l = 9.0;
    let beam = Beam::new(l, 1.0).expect("a beam");
    let trapezoid = |from: f64, to: f64, start: f64, end: f64| {
        let load = Load::new(&beam, 0.0, vec![LinearLoad { from, to, start, end }], Vec::new());
        let span = to - from;
        let force = 0.5 * (start + end) * span;
        (load, force, force * from + (start + 2.0 * end) * span * span / 6.0)
    };
    let point =
        |at: f64, force: f64| (Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at, force }]), force, force * at);
    let cases = [
        ("uniform", (Load::uniform_on(&beam, 2.5), 2.5 * l, 2.5 * l * l / 2.0)),
        ("a trapezoid over the whole beam", trapezoid(0.0, l, 1.0, -3.0)),
        ("a trapezoid across many nodes", trapezoid(0.7, 8.1, 0.5, 2.0)),
        ("a trapezoid inside one interval", trapezoid(4.51, 4.52, 100.0, 300.0)),
        ("a trapezoid from node to node", trapezoid(3.0, 6.0, 0.0, 4.0)),
        ("a force on a node", point(3.0, 2.0)),
        ("a force between nodes", point(4.321, -2.0)),
        // On nine intervals `x / l · 9` is rounded across the node.
        ("a force just before a node", point(4.0_f64.next_down(), 2.0)),
        ("a force on the left support", point(0.0, 2.0)),
        ("a force on the right support", point(l, 2.0)),
        ("a force beside a support", point(l - 1e-9, 2.0)),
    ];
    for (name, (load, force, moment)) in cases {
        let load = load.expect("a load on the beam");
        for intervals in [2, 3, 9, 31, 1000] {
            let (f, m) = resultants(&beam, &load, intervals);
            let size = load.magnitude(l);
            assert!((f - force).abs() <= ROUNDING * size, "{name}, {intervals} intervals: force {f} and not {force}");
            assert!(
                (m - moment).abs() <= ROUNDING * size * l,
                "{name}, {intervals} intervals: moment {m} and not {moment}"
            );
        }
    }
}

#[test]
fn nodal_loads_are_those_of_the_paper_and_of_the_lever() {
    let beam = Beam::new(9.0, 1.0).expect("a beam");
    let of = |load: &Load, intervals| {
        let scene = Scene::new(beam.clone(), load.clone(), None).expect("a scene");
        Grid::uniform(&scene, intervals).expect("enough intervals").nodal_loads(&scene)
    };
    let uniform = of(&Load::uniform_on(&beam, 2.0).expect("a load"), 9);
    assert!(apart(&uniform, &[1.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 1.0]) <= 0.0, "q_i = q₀Δ: {uniform:?}");
    let point = vec![PointLoad { at: 3.75, force: 4.0 }];
    let point = of(&Load::new(&beam, 0.0, Vec::new(), point).expect("a load"), 3);
    assert!(apart(&point, &[0.0, 3.0, 1.0, 0.0]) <= 0.0, "the law of the lever: {point:?}");
}
