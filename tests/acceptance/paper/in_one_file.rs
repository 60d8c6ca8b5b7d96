//! The paper in one file, `report/paper.rs`, which shares nothing with the library, beside the library.

use palkki::route::{Method, Solver};
use palkki::scene::Scene;

use crate::scenes::{apart, largest, nodes, report, run};

#[path = "../../../report/paper.rs"]
#[expect(dead_code, reason = "the suite does not need its table")]
mod paper;

/// What the file is told of a scene: forces on the interior nodes by the law of the lever, and the depth below them. A load is
/// integrated over each interval here, between the places where a part of it begins or ends.
fn on_grid(scene: &Scene, intervals: u32) -> paper::Scene {
    let (beam, load) = (scene.beam(), scene.load());
    let place = |i: u32| beam.length() * f64::from(i) / f64::from(intervals);
    let spacing = beam.length() / f64::from(intervals);
    let hat = |i: u32, x: f64| (1.0 - (x - place(i)).abs() / spacing).max(0.0);
    let nodal = |i: u32| {
        let points: f64 = load.point().iter().map(|p| p.force * hat(i, p.at)).sum();
        let parts = load.linear().iter().map(|part| {
            let intensity = |x: f64| part.start + (part.end - part.start) * (x - part.from) / (part.to - part.from);
            // A line times a line: Simpson's rule is exact.
            let over = |a: f64, b: f64| {
                let (a, b) = (a.max(part.from), b.min(part.to));
                let value = |x: f64| intensity(x) * hat(i, x);
                if a < b { (b - a) / 6.0 * (value(a) + 4.0 * value(0.5 * (a + b)) + value(b)) } else { 0.0 }
            };
            over(place(i - 1), place(i)) + over(place(i), place(i + 1))
        });
        load.uniform() * spacing + points + parts.sum::<f64>()
    };
    paper::Scene {
        length: beam.length(),
        bending_stiffness: beam.bending_stiffness(),
        load: nalgebra::DVector::from_iterator(intervals as usize - 1, (1..intervals).map(nodal)),
        depth: nalgebra::DVector::from_iterator(intervals as usize - 1, (1..intervals).map(|i| scene.depth(place(i)))),
    }
}

/// Every scene of the gallery that has ground, on 30 intervals, by every method: contact forces within 1e-9 of the load and
/// clearances within 1e-9 of the largest deflection or clearance.
#[test]
fn the_paper_in_one_file_agrees_with_the_library() {
    let mut compared = 0;
    for (name, scene) in report() {
        if scene.foundation().is_none() {
            continue;
        }
        let on_grid = on_grid(&scene, 30);
        let weight = on_grid.load.abs().sum();
        let programs = paper::programs(&on_grid);
        for (method, (word, program)) in Method::ALL.into_iter().zip(&programs) {
            assert_eq!(method.name(), *word);
            let (x, _) = paper::active_set(program);
            let gradient = program.gradient(&x);
            let (force, clearance) = if method == Method::Force { (x, gradient) } else { (gradient, x) };
            let raw = run(&scene, method, Solver::ActiveSet, 30);
            let nodes = nodes(&raw);
            let off = apart(&nodes.contact_force, force.as_slice());
            assert!(off <= 1e-9 * weight, "{name}, {method}: forces differ by {off:e} of {weight:e}");
            let off = apart(&nodes.clearance, clearance.as_slice());
            let size = largest(&nodes.deflection).max(largest(clearance.as_slice()));
            assert!(off <= 1e-9 * size, "{name}, {method}: clearances differ by {off:e} of {size:e}");
            compared += 1;
        }
    }
    assert!(39 <= compared, "{compared} answers were compared");
}

#[test]
fn the_paper_in_one_file_has_200_lines_at_the_most() {
    let lines = include_str!("../../../report/paper.rs").lines().count();
    assert!(lines <= 200, "report/paper.rs has {lines} lines; the README promises 200");
}

/// What the page says below its table.
#[test]
fn with_99_nodes_the_four_steps_and_nsor_fall_short_where_the_page_says_so() {
    let load = nalgebra::DVector::from_element(99, 0.1);
    let depth = nalgebra::DVector::from_element(99, 1.0);
    let scene = paper::Scene { length: 10.0, bending_stiffness: 500.0 / 384.0, load, depth };
    let [_, (_, displacement), (_, force)] = paper::programs(&scene);
    let (x, _) = paper::four_steps(&displacement);
    assert!(1e-6 < displacement.residual(&x), "the four steps end at the optimum");
    let (x, _) = paper::active_set(&displacement);
    assert!(displacement.residual(&x) < 1e-12, "the active set does not");
    let (_, sweeps) = paper::nsor(&force);
    assert_eq!(sweeps, 20_000, "NSOR comes to an end on the flexibility");
}
