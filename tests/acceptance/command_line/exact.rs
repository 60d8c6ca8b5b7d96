//! `--method exact`, which is what one gets without asking: beam theory on the command line.

use serde_json::Value;

use super::json::{KEYS, check_keys};
use super::{Folder, RIDGE};

/// What theory is asked for: the digits that the paper's reference solution is printed with here.
const DIGITS: f64 = 1e-12;

#[track_caller]
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn the_example_of_the_contract() {
    let (code, text, json) = Folder::new("exact").json("solve example.toml");
    assert_eq!(code, Some(0));
    check_keys(&json, &KEYS);
    assert_eq!([&json["method"], &json["solver"]], ["exact", "free-boundary"]);
    assert_eq!([&json["status"], &json["regime"]], ["certified", "zone"]);
    assert!(json["intervals"].is_null() && json["nodes"].is_null(), "no grid, no nodes: {text}");
    let [contact] = &json["contacts"].as_array().expect("an array")[..] else { panic!("one contact: {text}") };
    check_keys(contact, &["from", "to", "force", "force_from", "force_to"]);
    // a⁴ = 24 EI u₀ / q₀ and T = q₀ a / 2, as the paper's reference solution has them.
    let lift_off = (24.0_f64 * (500.0 / 384.0)).sqrt().sqrt();
    for (value, expected) in [
        (&contact["from"], lift_off),
        (&contact["to"], 10.0 - lift_off),
        (&contact["force"], 10.0 - lift_off),
        (&contact["force_from"], 0.5 * lift_off),
        (&contact["force_to"], 0.5 * lift_off),
        (&json["reactions"]["left"], 0.5 * lift_off),
        (&json["reactions"]["right"], 0.5 * lift_off),
        (&json["moment"]["max"], 0.125 * lift_off * lift_off),
        (&json["deflection"]["max"], 1.0),
    ] {
        assert!((number(value) - expected).abs() < 10.0 * DIGITS, "{value} instead of {expected} in {text}");
    }
}

#[test]
fn a_point_contact_has_no_forces_at_its_ends() {
    let (code, text, json) = Folder::new("exact_points").json("solve ridge.toml");
    assert_eq!(code, Some(0));
    let points: Vec<&Value> =
        json["contacts"].as_array().expect("an array").iter().filter(|c| c["from"] == c["to"]).collect();
    assert!(!points.is_empty(), "the ridge is touched at its top: {text}");
    for point in points {
        check_keys(point, &["from", "to", "force"]);
    }
}

/// The samples hold together by themselves: they start and end with the reactions, shear jumps by the point contacts and
/// falls by the load between them, and the moment is its integral.
#[test]
fn csv_is_in_equilibrium() {
    let folder = Folder::new("exact_csv");
    folder.write("ridge.toml", RIDGE.replace("uniform = 1", "uniform = 1\npoint = [{ at = 7.3, force = 0.5 }]"));
    let (code, _, json) = folder.json("solve ridge.toml --csv samples.csv");
    assert_eq!(code, Some(0));
    let csv = folder.read("samples.csv");
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("x,deflection,slope,clearance,pressure,moment,shear"));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|field| field.parse().expect("a number")).collect()).collect();
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    assert!([first[0], last[0] - 10.0].iter().all(|x| x.abs() < DIGITS), "from support to support");
    let reactions = ["left", "right"].map(|side| number(&json["reactions"][side]));
    assert!(
        (first[6] - reactions[0]).abs() < DIGITS && (last[6] + reactions[1]).abs() < DIGITS,
        "shear at the supports"
    );

    let mut jumps = 0.0;
    for pair in rows.windows(2) {
        let (a, b) = (&pair[0], &pair[1]);
        let step = b[0] - a[0];
        assert!(0.0 <= step, "places run from left to right");
        if step == 0.0 {
            jumps += b[6] - a[6];
            continue;
        }
        // Load and pressure are constant between samples of this scene: V' = p − q, M' = V.
        let slope = 0.5 * (a[4] + b[4]) - 1.0;
        assert!((b[6] - a[6] - slope * step).abs() < DIGITS * 10.0, "V' = p − q at x = {}", a[0]);
        assert!((b[5] - a[5] - 0.5 * (a[6] + b[6]) * step).abs() < DIGITS * 10.0, "M' = V at x = {}", a[0]);
    }
    let forces: f64 = json["contacts"]
        .as_array()
        .expect("an array")
        .iter()
        .map(|contact| match contact["force_from"].as_f64() {
            Some(from) => from + number(&contact["force_to"]),
            None => number(&contact["force"]),
        })
        .sum();
    // The point load stands in the zone: the ground takes it where it stands, and the shear force does not notice.
    assert!((jumps - forces).abs() < DIGITS * 10.0, "jumps {jumps}, forces {forces}");
}

#[test]
fn a_plot_is_drawn_from_samples() {
    let folder = Folder::new("exact_plot");
    let run = folder.run("solve example.toml --plot beam.svg");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    assert!(folder.read("beam.svg").contains("Example: beam theory"), "its title names the answer");
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
    assert!((printed - expected).abs() < DIGITS, "{printed} instead of {expected}");
}
