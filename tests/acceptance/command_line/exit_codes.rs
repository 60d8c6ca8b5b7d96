//! Exit codes: 0, 1, 2, and what goes with each.

use serde_json::Value;

use super::{EXAMPLE, Folder};

#[test]
fn a_certified_answer_is_printed_with_exit_code_0() {
    let run = Folder::new("certified").run("solve example.toml --method force");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    assert!(run.out.contains("certified: the deflection is certain to "), "{}", run.out);
    // End reaction of the example on 30 intervals, from an independent computation with the paper's formulas.
    assert!(run.out.contains("1.186044111"), "{}", run.out);
}

#[test]
fn an_answer_that_fails_the_check_is_printed_with_its_reason_and_exit_code_1() {
    let run = Folder::new("not_certified").run("solve ridge.toml --method displacement --solver four-step");
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""));
    assert!(run.out.contains("not-certified: the residual of its discrete problem is "), "{}", run.out);
    assert!(run.out.contains("Equilibrium"), "what there is is printed: {}", run.out);
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
    let line = run.out.lines().find(|line| line.trim_start().starts_with("status ")).expect("a status");
    for words in [
        "not-certified: it solves its grid, and the beam may be off by ",
        " % of its largest deflection, more than 10 %: refine (--intervals), or ask for an error (--tolerance) (residual ",
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

#[test]
fn help_and_version_are_no_failures() {
    let folder = Folder::new("help");
    for arguments in ["--help", "-h", "--version", "help", "solve --help", "compare -h", "help solve"] {
        let run = folder.run(arguments);
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{arguments}");
        assert!(!run.out.is_empty(), "{arguments} prints something");
    }
}

#[test]
fn usage_errors() {
    let folder = Folder::new("usage");
    for (arguments, why) in [
        ("", ""),
        ("solve", "<SCENE>"),
        ("frobnicate", "frobnicate"),
        ("solve example.toml --frobnicate", "--frobnicate"),
        ("solve example.toml --method farce", "farce"),
        ("solve example.toml --method force --solver simplex", "simplex"),
        ("solve example.toml --method force --format xml", "xml"),
        ("solve example.toml --method force --intervals 0", "must be at least 2, but is 0"),
        ("solve example.toml --method force --intervals 1", "must be at least 2, but is 1"),
        ("solve example.toml --method force --intervals -5", "must be a whole number, at least 2, but is -5"),
        ("solve example.toml --method force --intervals 2.5", "must be a whole number, at least 2, but is 2.5"),
        ("solve example.toml --method force --intervals many", "must be a whole number, at least 2, but is many"),
        ("solve example.toml --method force --intervals 10000001", "must be at most 10000000, but is 10000001"),
        ("solve example.toml --method force --intervals 99999999999999999999", "must be at most 10000000"),
        (
            "solve example.toml --method force --intervals 3000001 --nodes",
            "--nodes takes at most 3000000 intervals, but --intervals is 3000001",
        ),
        (
            "solve example.toml --method force --intervals 3000001 --csv nodes.csv",
            "--csv takes at most 3000000 intervals, but --intervals is 3000001",
        ),
        ("compare example.toml --intervals 1", "must be at least 2, but is 1"),
        ("solve example.toml --method force --tolerance 0", "must be a positive, finite number, but is 0"),
        ("solve example.toml --method force --tolerance -1e-9", "must be a positive, finite number, but is -1e-9"),
        ("solve example.toml --method force --tolerance nan", "must be a positive, finite number, but is nan"),
        ("solve example.toml --method force --tolerance inf", "must be a positive, finite number, but is inf"),
        ("solve example.toml --solver nsor", "--solver belongs to a discretised method"),
        ("solve example.toml --method exact --solver nsor", "--solver belongs to a discretised method"),
        ("solve example.toml --method exact --intervals 30", "--intervals belongs to a discretised method"),
        ("solve example.toml --nodes", "--nodes belongs to a discretised method"),
    ] {
        let run = folder.run(arguments);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{arguments}");
        assert!(run.err.contains(why), "{arguments} says {why:?}: {}", run.err);
    }
}
