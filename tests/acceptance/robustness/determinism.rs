//! The same scene gives the same bits: again, in several threads at once, in another process, in several processes at once.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;

use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::theory;
use serde_json::Value;

use crate::scenes::{nodes, report, run, scene};

/// Few, so that every solver takes part, and the paper's number does not divide it.
const INTERVALS: usize = 25;

/// Zones, a step, waves, a survey: every kind of foundation.
const SCENES: [&str; 4] = ["heinisuo-1984", "step", "wave", "survey"];

/// Every route of a scene and what it ends with, in words: numbers are printed so that reading them back gives the same bits.
fn answers(scene: &Scene, intervals: usize) -> Vec<String> {
    let routes = Method::ALL.into_iter().flat_map(|method| Solver::ALL.map(|solver| (method, solver)));
    let discrete =
        routes.map(|(method, solver)| format!("{method} {solver}: {:?}", run(scene, method, solver, intervals)));
    let exact = theory::solve(scene).expect("theory has an answer");
    discrete.chain([format!("exact: {:?}", exact.state)]).collect()
}

#[track_caller]
fn same(expected: &[String], found: &[String]) {
    assert_eq!(expected.len(), found.len(), "as many routes");
    for (a, b) in expected.iter().zip(found) {
        assert!(a == b, "two runs differ:\n{a}\n{b}");
    }
}

#[test]
fn twice_the_same_bits() {
    for (name, scene) in report() {
        for method in Method::ALL {
            let [a, b] = [(); 2].map(|()| format!("{:?}", run(&scene, method, Solver::ActiveSet, 300)));
            assert!(a == b, "{name}, {method}:\n{a}\n{b}");
        }
    }
}

#[test]
fn in_several_threads_at_once_the_same_bits() {
    /// More than most machines that this runs on have cores to spare.
    const THREADS: usize = 4;
    for name in SCENES {
        let scene = scene(name);
        let alone = answers(&scene, INTERVALS);
        thread::scope(|scope| {
            let threads: Vec<_> = (0..THREADS).map(|_| scope.spawn(|| answers(&scene, INTERVALS))).collect();
            for thread in threads {
                same(&alone, &thread.join().expect("the thread ends"));
            }
        });
    }
}

/// A process that solves one scene of the report by one route.
fn process(name: &str, route: &[&str]) -> std::process::Child {
    Command::new(env!("CARGO_BIN_EXE_palkki"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["solve", &format!("report/scenes/{name}.toml"), "--format", "json"])
        .args(route)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("palkki starts")
}

/// What it prints, but for the seconds.
#[track_caller]
fn printed(process: std::process::Child) -> Value {
    let output = process.wait_with_output().expect("palkki ends");
    let mut json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    json["seconds"] = Value::Null;
    json
}

#[test]
fn another_process_prints_the_same_bits() {
    let intervals = INTERVALS.to_string();
    for (name, method, solver) in SCENES
        .into_iter()
        .zip([Method::Complementarity, Method::Displacement, Method::Force, Method::Force])
        .flat_map(|(name, method)| Solver::ALL.map(|solver| (name, method, solver)))
    {
        let route = ["--method", method.name(), "--solver", solver.name(), "--intervals", &intervals];
        // Two at once, so that each is a load on the machine for the other.
        let [a, b] = [(); 2].map(|()| process(name, &route)).map(printed);
        assert_eq!(a, b, "{name}, {method}, {solver}: two processes");
        let here = run(&scene(name), method, solver, INTERVALS);
        for (list, expected) in [
            ("deflection", &nodes(&here).deflection),
            ("contact_force", &nodes(&here).contact_force),
            ("clearance", &nodes(&here).clearance),
        ] {
            let found: Vec<u64> = a["nodes"][list].as_array().into_iter().flatten().filter_map(bits).collect();
            let expected: Vec<u64> = expected.iter().map(|value| (value + 0.0).to_bits()).collect();
            assert_eq!(found, expected, "{name}, {method}, {solver}: {list} of another process");
        }
    }
    for name in SCENES {
        let [a, b] = [(); 2].map(|()| process(name, &[])).map(printed);
        assert_eq!(a, b, "{name}, exact: two processes");
    }
}

#[test]
fn another_process_draws_the_same_figure() {
    let intervals = INTERVALS.to_string();
    for name in SCENES {
        let figures = ["one", "other"]
            .map(|which| Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("determinism-{name}-{which}.svg")));
        let drawing = figures.each_ref().map(|path| {
            let path = path.to_str().expect("a path in UTF-8");
            process(name, &["--method", "force", "--intervals", &intervals, "--plot", path])
        });
        drawing.into_iter().for_each(|process| drop(printed(process)));
        let [one, other] = figures.map(|path| fs::read_to_string(&path).expect("a figure"));
        assert!(one.contains("<svg") && one == other, "{name}: two processes");
    }
}

/// Bits of a number; a zero has no sign.
fn bits(value: &Value) -> Option<u64> {
    value.as_f64().map(|value| (value + 0.0).to_bits())
}
