//! `--tolerance` without `--intervals`: the error that is asked for chooses the grid.

use serde_json::Value;

use super::{EXAMPLE, Folder, RIDGE, number};

#[test]
fn the_grid_follows_from_the_error() {
    let folder = Folder::new("refinement");
    let mut before = 0.0;
    for eps in ["1e-2", "1e-4", "1e-6"] {
        let (code, text, json) = folder.json(&format!("solve example.toml --method force --tolerance {eps}"));
        assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")), "{text}");
        let demanded: f64 = eps.parse().expect("a number");
        let error = number(&json["certificate"]["deflection_error"]) / number(&json["deflection"]["max"]);
        assert!(error <= demanded, "{error} for {eps}");
        let refinement = &json["refinement"];
        assert_eq!((&refinement["reached"], &refinement["end"]), (&Value::from(true), &Value::from("reached")));
        let grids = refinement["grids"].as_array().expect("a list");
        let last = grids.last().expect("a grid");
        assert_eq!(last["intervals"], json["intervals"]);
        assert_eq!(last["seconds"], json["seconds"], "`seconds` is the solve alone");
        assert!(
            number(&last["error"]) <= demanded && number(&json["seconds"]) < number(&refinement["seconds"]),
            "{refinement}"
        );
        let intervals = number(&json["intervals"]);
        assert!(before < intervals, "a smaller error takes more intervals: {intervals} for {eps}");
        before = intervals;
    }
}

#[test]
fn with_a_grid_the_tolerance_is_that_of_the_solver() {
    let folder = Folder::new("refinement_fixed");
    folder.write("rough.toml", RIDGE.replace("0.5", "0.6"));
    let fixed = "solve rough.toml --method force --solver clarabel --intervals 64 --tolerance";
    let iterations = |eps: &str| {
        let (_, text, json) = folder.json(&format!("{fixed} {eps}"));
        assert_eq!((&json["intervals"], json.get("refinement")), (&Value::from(64), None), "{text}");
        number(&json["iterations"])
    };
    assert!(iterations("1e-2") < iterations("1e-10"), "less is asked, less is done");
}

/// The grids that are tried have a node at each support.
#[test]
fn a_grid_that_is_found_has_its_supports() {
    let folder = Folder::new("refinement_support");
    folder.write("inner.toml", EXAMPLE.replace("length = 10", "length = 10\nsupports = [{ at = 0 }, { at = 4 }]"));
    let (_, text, json) = folder.json("solve inner.toml --method force --tolerance 0.01");
    assert_eq!(json["intervals"].as_u64().map(|n| n % 5), Some(0), "{text}");
}

/// Thirty intervals have no node on the post: the answer solves its grid, and the beam is somewhere else.
#[test]
fn a_post_between_two_nodes_is_not_certified() {
    let folder = Folder::new("post");
    folder.write(
        "post.toml",
        EXAMPLE.replace("depth = 1", "points = [[0, 50], [5.1, 50], [5.15, 1], [5.2, 50], [10, 50]]"),
    );
    let arguments = "solve post.toml --method force --intervals 30";
    let run = folder.run(arguments);
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""));
    let line = run.out.lines().next().expect("a status");
    for words in [
        "not-certified: it solves its grid, and the deflection error may be ",
        " % of the largest deflection, more than 10 %: refine (--intervals), or ask for an error (--tolerance) (residual ",
    ] {
        assert!(line.contains(words), "{words:?} in {line}");
    }
    let (code, _, json) = folder.json(arguments);
    assert_eq!((code, &json["status"]), (Some(1), &Value::from("not-certified")));
    assert!(json["reason"].as_str().is_some_and(|reason| line.contains(reason)), "the same words: {}", json["reason"]);
    let number = |value: &Value| value.as_f64().expect("a number");
    assert!(0.1 * number(&json["deflection"]["max"]) < number(&json["certificate"]["deflection_error"]), "{json}");

    // What the words advise.
    for better in [
        "solve post.toml --method force --tolerance 1e-2",
        "solve post.toml --method force --intervals 200",
        "solve post.toml",
    ] {
        assert_eq!(folder.run(better).code, Some(0), "{better}");
    }
    let (code, _, json) = folder.json("compare post.toml --intervals 30");
    let routes = json["routes"].as_array().expect("an array");
    let certified = routes.iter().filter(|route| route["status"] == "certified").map(|route| &route["method"]);
    assert_eq!((code, certified.collect::<Vec<_>>()), (Some(0), vec![&Value::from("exact")]), "beam theory alone");
    assert!(routes[2]["solver_error"].is_object(), "the active set still solves its grid");
}
