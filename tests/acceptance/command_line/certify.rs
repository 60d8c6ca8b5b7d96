//! `certify`: contact forces from any program.

use serde_json::Value;

use super::{Folder, number};

/// The numbers of `nodes.contact_force` of a solved scene as a file for `certify`.
fn forces_of(folder: &Folder, arguments: &str) -> String {
    let (_, _, json) = folder.json(arguments);
    let list = |name: &str| json["nodes"][name].as_array().cloned().unwrap_or_default();
    let rows = list("x").into_iter().zip(list("contact_force")).map(|(x, force)| format!("{x},{force}\n"));
    format!("x,force\n{}", rows.collect::<String>())
}

#[test]
fn good_forces_are_certified() {
    let folder = Folder::new("certify_good");
    folder.write("forces.csv", forces_of(&folder, "solve example.toml --method force --intervals 200"));
    let (code, _, json) = folder.json("certify example.toml forces.csv");
    assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")));
    assert!(
        json["reason"].as_str().is_some_and(|reason| reason.starts_with("the deflection error is at most ")),
        "{json}"
    );
    assert_eq!(json["scene"], "Example");
    let bounds = &json["certificate"];
    let [lower, upper, error] = ["energy_lower", "energy_upper", "deflection_error"].map(|key| number(&bounds[key]));
    // J* = −q₀ u₀ (l − 4a/5), in closed form.
    let energy = -palkki_evidence::closed::flat(10.0, 1.302_083_333_333_333_3, 1.0, 1.0).energy.abs();
    assert!(lower <= energy && energy <= upper && upper - lower <= 1e-9 * energy.abs(), "{bounds}");
    assert!(bounds.get("coarse").is_none(), "{bounds}");
    assert!(0.0 < error && error < 1e-2, "{bounds}");
    let text = folder.run("certify example.toml forces.csv").out;
    assert!(text.starts_with("certified: the deflection error is at most "), "{text}");
}

/// Forces as the paper computes them: the load is lumped at the nodes of 20 intervals, and under the distributed one the beam is in the
/// ground by `q Δ² l²/96 EI` at mid-span.
#[test]
fn forces_under_a_lumped_load_are_certified_if_that_is_said() {
    let folder = Folder::new("certify_nodal");
    folder.write("forces.csv", forces_of(&folder, "solve example.toml --method force --intervals 20"));
    let (code, _, json) = folder.json("certify example.toml forces.csv");
    assert_eq!((code, &json["status"]), (Some(1), &Value::from("not-certified")));
    assert_eq!(json["violations"][0]["condition"], "penetration");
    let sag = 10.0 * 10.0 / 4.0 / (96.0 * 1.302_083_333_333_333_3);
    assert!((number(&json["violations"][0]["amount"]) - sag).abs() < 1e-12, "{json}");
    assert!(json.get("intervals").is_none(), "there are no intervals: {json}");
    let (code, _, json) = folder.json("certify example.toml forces.csv --load nodal");
    assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")));
    assert_eq!(json["intervals"], 20);
    let (_, _, own) = folder.json("solve example.toml --method force --intervals 20");
    let errors = [&json, &own].map(|json| number(&json["certificate"]["deflection_error"]));
    assert!((errors[0] - errors[1]).abs() < 1e-9 && errors[0] < 1e-2, "{errors:?}");
}

/// A force that pulls is set to zero at its node.
#[test]
fn forces_that_pull_are_cut_off_at_nodes_too() {
    let folder = Folder::new("certify_nodal_pull");
    folder.write("pull.csv", "x,force\n2.5,1\n5,-0.25\n7.5,1\n");
    folder.write("none.csv", "x,force\n2.5,1\n5,0\n7.5,1\n");
    let (code, _, pull) = folder.json("certify example.toml pull.csv --load nodal");
    let (_, _, none) = folder.json("certify example.toml none.csv --load nodal");
    assert_eq!((code, &pull["certificate"]), (Some(1), &none["certificate"]));
    let conditions = |json: &Value| {
        json["violations"].as_array().expect("a list").iter().map(|v| v["condition"].clone()).collect::<Vec<_>>()
    };
    assert!(
        conditions(&pull).contains(&Value::from("tension")) && !conditions(&none).contains(&Value::from("tension"))
    );
}

#[test]
fn no_forces_are_a_question_too() {
    let folder = Folder::new("certify_none");
    folder.write("none.csv", "x,force\n");
    folder.write("high.toml", "[beam]\nlength = 4\nbending_stiffness = 9\n[load]\nuniform = 1\n");
    let (code, _, json) = folder.json("certify high.toml none.csv");
    assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")), "a free beam has no contact forces");
    assert_eq!(json["violations"], Value::Array(Vec::new()));
    let (code, ..) = folder.json("certify example.toml none.csv");
    assert_eq!(code, Some(1), "a beam on the ground has");
}

/// Forces in any order, twice at a place, or far too large are forces: they are bounded, not believed.
#[test]
fn strange_forces_are_bounded() {
    let folder = Folder::new("certify_strange");
    folder.write("sorted.csv", "x,force\n2.5,1\n5,2\n7.5,1\n");
    folder.write("shuffled.csv", "x,force\n7.5,1\n5,1.5\n2.5,1\n5,0.5\n");
    let bounds = |forces: &str| folder.json(&format!("certify example.toml {forces}")).2["certificate"].clone();
    assert_eq!(bounds("sorted.csv"), bounds("shuffled.csv"), "the same forces");

    for (name, forces) in [
        ("huge", "x,force\n5,1e300\n"),
        ("overflowing", "x,force\n5,1e308\n5,1e308\n"),
        ("cancelling", "x,force\n5,1e308\n6,-1e308\n"),
        ("tiny", "x,force\n5,1e-320\n"),
        ("at the supports", "x,force\n0,3\n10,3\n"),
        ("beside a support", "x,force\n1e-300,3\n"),
        ("pulling", "x,force\n5,-2\n"),
    ] {
        folder.write("strange.csv", forces);
        let (code, text, json) = folder.json("certify example.toml strange.csv");
        assert_eq!((code, &json["status"]), (Some(1), &Value::from("not-certified")), "{name}: {text}");
        // J* = −q₀ u₀ (l − 4a/5), in closed form; what could not be bounded is null.
        let energy = palkki_evidence::closed::flat(10.0, 1.302_083_333_333_333_3, 1.0, 1.0).energy;
        let [lower, upper] = ["energy_lower", "energy_upper"].map(|key| json["certificate"][key].as_f64());
        let holds = lower.is_none_or(|lower| lower <= energy) && upper.is_none_or(|upper| energy <= upper);
        assert!(holds, "{name}: {text}");
    }
}
