//! `--tolerance` without `--intervals`: the error that is asked for chooses the grid.

use serde_json::Value;

use super::json::check_keys;
use super::{Folder, RIDGE};

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn the_grid_follows_from_the_error() {
    let folder = Folder::new("dial");
    let mut before = 0.0;
    for eps in ["1e-2", "1e-4", "1e-6"] {
        let (code, text, json) = folder.json(&format!("solve example.toml --method force --tolerance {eps}"));
        assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")), "{text}");
        let demanded: f64 = eps.parse().expect("a number");
        let error = number(&json["certificate"]["deflection_error"]) / number(&json["deflection"]["max"]);
        assert!(error <= demanded, "{error} for {eps}");
        let dial = &json["dial"];
        check_keys(dial, &["tolerance", "reached", "end", "error", "seconds", "grids"]);
        assert_eq!((&dial["reached"], &dial["end"]), (&Value::from(true), &Value::from("reached")));
        let grids = dial["grids"].as_array().expect("a list");
        let keys = ["intervals", "solver_tolerance", "unknowns", "iterations", "residual", "error", "seconds"];
        grids.iter().for_each(|grid| check_keys(grid, &keys));
        let last = grids.last().expect("a grid");
        assert_eq!(last["intervals"], json["intervals"]);
        assert_eq!(last["seconds"], json["seconds"], "`seconds` is the solve alone");
        assert!(number(&last["error"]) <= demanded && number(&json["seconds"]) < number(&dial["seconds"]), "{dial}");
        let intervals = number(&json["intervals"]);
        assert!(before < intervals, "a smaller error takes more intervals: {intervals} for {eps}");
        before = intervals;
    }
    let run = folder.run("solve example.toml --method force --tolerance 1e-3");
    assert_eq!(run.code, Some(0));
    for words in ["Grids tried", "demanded  an error of the deflection of at most 1.0e-3", "end       reached, with "] {
        assert!(run.out.contains(words), "{words:?} in {}", run.out);
    }
}

/// The paper's four steps stop short of the optimum as soon as the grid is fine enough for that.
#[test]
fn what_cannot_be_reached_is_said_with_the_best_there_is() {
    let folder = Folder::new("dial_not");
    let arguments = "solve ridge.toml --method force --solver four-step --tolerance 1e-4";
    let (code, text, json) = folder.json(arguments);
    assert_eq!((code, &json["status"]), (Some(1), &Value::from("not-certified")), "{text}");
    let end = json["dial"]["end"].as_str().expect("words");
    assert!(end.contains("its answer fails our check: the residual of its discrete problem is"), "{end}");
    let reason = json["reason"].as_str().expect("words");
    assert!(reason.contains("more than 0.01 %"), "{reason}");
    let errors = json["dial"]["grids"].as_array().expect("a list").iter();
    let least =
        errors.filter(|g| number(&g["residual"]) < 1e-9).map(|g| number(&g["error"])).fold(f64::INFINITY, f64::min);
    assert_eq!(number(&json["dial"]["error"]).to_bits(), least.to_bits(), "the best answer is the one that is printed");
    let run = folder.run(arguments);
    assert!(run.code == Some(1) && run.out.contains("not reached: this route ends at"), "{}", run.out);
}

#[test]
fn beam_theory_has_an_error_too() {
    let folder = Folder::new("dial_exact");
    let (code, _, json) = folder.json("solve ridge.toml --tolerance 1e-9");
    assert_eq!((code, &json["status"], json.get("dial")), (Some(0), &Value::from("certified"), None));
    let (code, _, json) = folder.json("solve ridge.toml --tolerance 1e-16");
    assert_eq!((code, &json["status"]), (Some(1), &Value::from("not-certified")));
    assert!(json["reason"].as_str().is_some_and(|reason| reason.contains("more than 1.0e-16")), "{json}");
}

#[test]
fn with_a_grid_the_tolerance_is_that_of_the_solver() {
    let folder = Folder::new("dial_fixed");
    folder.write("rough.toml", RIDGE.replace("0.5", "0.6"));
    let fixed = "solve rough.toml --method force --solver clarabel --intervals 64 --tolerance";
    let iterations = |eps: &str| {
        let (_, text, json) = folder.json(&format!("{fixed} {eps}"));
        assert_eq!((&json["intervals"], json.get("dial")), (&Value::from(64), None), "{text}");
        number(&json["iterations"])
    };
    assert!(iterations("1e-2") < iterations("1e-10"), "less is asked, less is done");
}
