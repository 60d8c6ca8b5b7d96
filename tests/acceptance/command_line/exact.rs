//! `--method exact`, which is what one gets without asking: beam theory on the command line.

use super::{Folder, RIDGE, number};

/// What theory is asked for: the digits that the paper's reference solution is printed with here.
const DIGITS: f64 = 1e-12;

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

/// Ground that gives: contacts without forces at their ends, the largest pressure, bounds; and what needs rigid ground says so, with
/// exit code 2 and nothing on standard output.
#[test]
fn ground_that_gives_is_solved_and_otherwise_refused() {
    let folder = Folder::new("exact_springs");
    folder.write("soft.toml", super::EXAMPLE.to_owned() + "stiffness = 100\n");
    let lying = super::EXAMPLE.replace("[load]", "supports = []\n[load]") + "stiffness = 100\n";
    folder.write("lying.toml", lying);
    folder.write("forces.csv", "x,force\n5,1\n");
    let (code, _, json) = folder.json("solve soft.toml");
    assert_eq!(code, Some(0));
    assert_eq!(json["status"], "certified");
    let contact = &json["contacts"][0];
    assert!(contact["force_from"].is_null() && contact["force_to"].is_null(), "{contact}");
    assert!(0.0 < number(&json["pressure"]["max"]) && number(&contact["from"]) < number(&json["pressure"]["at"]));
    for command in [
        "solve soft.toml --method force --plot figure.svg",
        "solve soft.toml --method force --tolerance 1e-2",
        "compare soft.toml",
        "solve soft.toml --depth-tolerance 0.01",
        "sweep soft.toml --vary foundation.stiffness --from 1 --to 2 --steps 3 --envelope",
    ] {
        assert_eq!(folder.json(command).0, Some(0), "{command}");
    }
    // Other forces than those of the beam.
    assert_eq!(folder.json("certify soft.toml forces.csv").0, Some(1));
    let (code, _, json) = folder.json("solve soft.toml --derivatives");
    let by_depth = &json["derivatives"]["depth"];
    assert_eq!(code, Some(0));
    assert!((number(&by_depth["energy"]) + number(&json["contact_force"])).abs() <= 1e-9, "{by_depth}");
    assert!(number(&json["derivatives"]["foundation.stiffness"]["energy"]) > 0.0);
    assert_eq!(folder.json("certify lying.toml forces.csv").0, Some(1));
    for (format, title) in [("text", "\nLinks"), ("markdown", "\n## Links")] {
        let run = folder.run(&format!("explain soft.toml --format {format}"));
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{}", run.out);
        assert!(run.out.contains(title) && run.out.contains("V right - V left + P = R"), "{}", run.out);
    }
    // Loads and forces at nodes do not say how deep nodes are.
    let run = folder.run("certify lying.toml forces.csv --load nodal");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{}", run.err);
    assert!(run.err.contains("needs rigid ground, but `foundation.stiffness` is given"), "{}", run.err);
}
