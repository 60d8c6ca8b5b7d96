//! JSON: its numbers and its lists; all keys are on the page `shown@json`.

use palkki::route::{Method, Solver};
use palkki::{Settings, solve_raw};
use serde_json::Value;

use super::{EXAMPLE, Folder, scene};

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
