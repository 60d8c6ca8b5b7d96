//! JSON, against the contract.

use palkki::route::{Method, Solver};
use palkki::{Settings, solve_raw};
use serde_json::Value;

use super::{EXAMPLE, Folder, scene};

/// Keys of the contract in its order, with those that we add.
pub(super) const KEYS: [&str; 21] = [
    "scene",
    "method",
    "solver",
    "intervals",
    "status",
    "reason",
    "solver_status",
    "residual",
    "regime",
    "unknowns",
    "iterations",
    "seconds",
    "reactions",
    "supports",
    "contacts",
    "contact_force",
    "deflection",
    "moment",
    "energy",
    "certificate",
    "nodes",
];

#[track_caller]
pub(super) fn check_keys(object: &Value, keys: &[&str]) {
    let mut expected = keys.to_vec();
    expected.sort_unstable();
    let found: Vec<&str> = object.as_object().expect("an object").keys().map(String::as_str).collect();
    assert_eq!(found, expected);
}

#[test]
fn json_of_solve_has_the_shape_of_the_contract() {
    let folder = Folder::new("json");
    let (code, text, json) = folder.json("solve example.toml --method force");
    assert_eq!(code, Some(0));
    check_keys(&json, &KEYS);
    assert!(
        json["reason"].as_str().is_some_and(|reason| reason.starts_with("the deflection is certain to ")),
        "{text}"
    );
    let places: Vec<_> = KEYS.iter().map(|key| text.find(&format!("\n  \"{key}\": ")).expect("a key")).collect();
    assert!(places.is_sorted(), "the keys are in the order of the contract");
    assert_eq!(json["scene"], "Example");
    assert_eq!([&json["method"], &json["solver"]], ["force", "active-set"]);
    assert_eq!(json["intervals"], 30);
    assert_eq!([&json["status"], &json["regime"]], ["certified", "zone"]);
    assert!(json["solver_status"].is_string(), "{text}");
    check_keys(
        &json["certificate"],
        &["energy_lower", "energy_upper", "gap", "deflection_error", "deflection_error_at", "reactions", "stiffness"],
    );
    assert!(json["seconds"].as_f64().is_some_and(|seconds| 0.0 < seconds), "the solve takes time");
    check_keys(&json["reactions"], &["left", "right"]);
    check_keys(&json["contacts"][0], &["from", "to", "force"]);
    check_keys(&json["deflection"], &["max", "at", "min", "min_at"]);
    check_keys(&json["moment"], &["max", "max_at", "min", "min_at"]);
    check_keys(&json["nodes"], &["x", "deflection", "clearance", "contact_force", "moment"]);
    for (name, values) in json["nodes"].as_object().expect("an object") {
        assert_eq!(values.as_array().map(Vec::len), Some(29), "{name} has a value for each interior node");
    }
}

#[test]
fn json_numbers_read_back_as_the_same_bits() {
    let folder = Folder::new("json_bits");
    let (_, text, _) = folder.json("solve example.toml --method displacement --intervals 30");
    let settings =
        Settings { method: Method::Displacement, solver: Solver::ActiveSet, intervals: 30, tolerance: 1e-10 };
    let state = solve_raw(&scene(EXAMPLE), &settings).expect("an answer").state;
    for (key, value) in [("energy", state.energy), ("contact_force", state.contact_force())] {
        let line = text.lines().find_map(|line| line.strip_prefix(&format!("  \"{key}\": "))).expect("the key");
        let read: f64 = line.trim_end_matches(',').parse().expect("a number");
        assert_eq!(read.to_bits(), value.to_bits(), "{key}");
    }
}

#[test]
fn json_of_an_answer_that_fails_the_check() {
    let (code, _, json) = Folder::new("json_1").json("solve ridge.toml --method displacement --solver four-step");
    assert_eq!(code, Some(1));
    assert_eq!(json["status"], "not-certified");
    assert_eq!(json["scene"], "ridge.toml", "a scene without a title is called by its file");
}

#[test]
fn nodes_of_a_fine_grid_are_printed_on_demand() {
    let folder = Folder::new("fine");
    // Nothing to solve: what is printed is all that matters here.
    folder.write("free.toml", "[beam]\nlength = 2\nbending_stiffness = 1\n[load]\nuniform = 1\n");
    let fine = "solve free.toml --method force --intervals";
    let (_, _, json) = folder.json(&format!("{fine} 10000"));
    assert_eq!(json["nodes"]["x"].as_array().map(Vec::len), Some(9999), "10000 intervals are not many");
    let (_, _, json) = folder.json(&format!("{fine} 10001"));
    assert_eq!(json["nodes"], Value::Null, "10001 are");
    let (_, _, json) = folder.json(&format!("{fine} 10001 --nodes"));
    assert_eq!(json["nodes"]["x"].as_array().map(Vec::len), Some(10_000), "but they can be had");
}

#[test]
fn compare_has_every_method_with_every_solver() {
    let folder = Folder::new("compare");
    let (code, _, json) = folder.json("compare ridge.toml --intervals 12");
    assert_eq!(code, Some(0), "at least one answer passes");
    check_keys(&json, &["scene", "intervals", "routes"]);
    assert_eq!(json["intervals"], 12);
    let routes = json["routes"].as_array().expect("an array");
    for route in routes {
        let errors = ["solver_error", "model_error"];
        let keys: Vec<&str> = KEYS[1..20].iter().copied().chain(errors).collect();
        check_keys(route, &keys);
        assert!(route["certificate"]["deflection_error"].is_number(), "every route has its certified error: {route}");
    }
    for method in Method::ALL {
        for solver in Solver::ALL {
            let found: Vec<_> =
                routes.iter().filter(|r| r["method"] == method.name() && r["solver"] == solver.name()).collect();
            let [route] = found[..] else { panic!("{method} × {solver} is there once, not {} times", found.len()) };
            let reference = if method == Method::Complementarity { "complementarity" } else { "force" };
            assert_eq!(route["solver_error"]["reference"], format!("{reference}/active-set"));
        }
    }
}

/// An answer is as far from the reference as its numbers are.
#[test]
fn compare_measures_solver_errors() {
    let (_, _, json) = Folder::new("compare_errors").json("compare ridge.toml");
    let routes = json["routes"].as_array().expect("an array");
    let find = |method: &str, solver: &str| {
        let mut routes = routes.iter();
        routes.find(|r| r["method"] == method && r["solver"] == solver).expect("the route")
    };
    let number = |value: &Value| value.as_f64().expect("a number");
    let (reference, answer) = (find("force", "active-set"), find("displacement", "four-step"));
    let reaction = |route: &Value, side: &str| number(&route["reactions"][side]);
    let most = reaction(reference, "left").max(reaction(reference, "right"));
    let off = ["left", "right"].map(|side| (reaction(answer, side) - reaction(reference, side)).abs() / most);
    let printed = number(&answer["solver_error"]["reaction"]);
    // Both are computed from the same numbers, one of them after printing and reading.
    const ROUNDING: f64 = 1e-12;
    assert!((printed - off[0].max(off[1])).abs() < ROUNDING, "{printed} for {off:?}");
    assert_eq!(number(&reference["solver_error"]["energy"]).to_bits(), 0, "the reference is its own reference");
}
