//! `compare`: every method with every solver, and their errors.

use palkki::route::{Method, Solver};
use serde_json::Value;

use super::{Folder, number};

/// Keys of each route of a comparison.
const KEYS: [&str; 21] = [
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
    "solver_error",
    "model_error",
];

#[track_caller]
fn check_keys(object: &Value, keys: &[&str]) {
    let mut expected = keys.to_vec();
    expected.sort_unstable();
    let found: Vec<&str> = object.as_object().expect("an object").keys().map(String::as_str).collect();
    assert_eq!(found, expected);
}

/// A route that would cost too much on a fine grid has a row, and the reason stands below the table. On level ground at the
/// level of the supports the routes that are tried end soon.
#[test]
fn compare_says_what_it_leaves_out() {
    let folder = Folder::new("left_out");
    let level = "beam = { length = 10, bending_stiffness = 1 }\nload = { uniform = 1 }\nfoundation = { depth = 0 }\n";
    folder.write("level.toml", level);
    let [tried, fine] = [2000, 2001].map(|n| folder.run(&format!("compare level.toml --intervals {n}")));
    let reasons = |out: &str| out.lines().filter(|line| line.contains("not tried: 2001 intervals, 2000 is")).count();
    let told = [reasons(&tried.out), tried.out.matches("in a comparison").count()];
    assert_eq!((tried.code, told), (Some(0), [0; 2]), "{}", tried.out);
    // Two solvers by three methods.
    assert_eq!((fine.code, reasons(&fine.out)), (Some(0), 6), "{}", fine.out);
    let rows = fine.out.lines().filter(|line| line.contains("not-converged")).count();
    assert!(6 <= rows, "{}", fine.out);
}

#[test]
fn compare_has_every_method_with_every_solver() {
    let folder = Folder::new("compare");
    let (code, _, json) = folder.json("compare ridge.toml --intervals 12");
    assert_eq!(code, Some(0), "at least one answer passes");
    check_keys(&json, &["version", "scene", "intervals", "routes"]);
    assert_eq!(json["intervals"], 12);
    let routes = json["routes"].as_array().expect("an array");
    for route in routes {
        check_keys(route, &KEYS);
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

#[test]
fn compare_measures_model_errors() {
    let (_, _, json) = Folder::new("exact_compare").json("compare example.toml");
    let routes = json["routes"].as_array().expect("an array");
    assert_eq!(routes[0]["method"], "exact", "theory comes first");
    assert!(routes[0]["model_error"].is_null(), "and has no model error");
    let force = routes.iter().find(|r| r["method"] == "force" && r["solver"] == "active-set").expect("the route");
    assert_eq!(force["model_error"]["reference"], "exact/free-boundary");
    let (discrete, exact) = (number(&force["reactions"]["left"]), number(&routes[0]["reactions"]["left"]));
    let expected = (discrete - exact).abs() / exact;
    let printed = number(&force["model_error"]["reaction"]);
    // Both are computed from the same numbers, one of them after printing and reading.
    assert!((printed - expected).abs() < 1e-12, "{printed} instead of {expected}");
}

/// Two intervals on three supports: every node is held, by every route.
#[test]
fn where_every_node_is_a_support_there_is_nothing_to_solve() {
    let folder = Folder::new("all_held");
    let supports = "supports = [{ at = 0 }, { at = 5 }, { at = 10 }]";
    let beam = format!("[beam]\nlength = 10\nbending_stiffness = 1.3\n{supports}\n");
    folder.write("held.toml", beam + "[load]\nuniform = 1\n[foundation]\ndepth = 1\n");
    let (code, text, json) = folder.json("compare held.toml --intervals 2");
    assert_eq!(code, Some(0), "beam theory is certified: {text}");
    let routes = json["routes"].as_array().expect("routes");
    assert_eq!(routes.len(), 16, "{text}");
    for route in &routes[1..] {
        assert_eq!(route["unknowns"], 0, "{route}");
        // The nodes do not move, and so say nothing of the beam between them.
        assert_eq!(route["status"], "not-certified", "{route}");
        assert!(route["reason"].as_str().is_some_and(|reason| reason.contains("any share")), "{route}");
    }
}
