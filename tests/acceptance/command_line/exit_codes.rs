//! Exit codes: 0, 1, 2, and what goes with each.

use super::Folder;

#[test]
fn a_certified_answer_is_printed_with_exit_code_0() {
    let run = Folder::new("certified").run("solve example.toml --method force");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    assert!(run.out.contains("certified"), "{}", run.out);
    // End reaction of the example on 30 intervals, from an independent computation with the paper's formulas.
    assert!(run.out.contains("1.186044111"), "{}", run.out);
}

#[test]
fn an_answer_that_fails_the_check_is_printed_with_its_reason_and_exit_code_1() {
    let run = Folder::new("not_certified").run("solve ridge.toml --method displacement --solver four-step");
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""));
    assert!(run.out.contains("not-certified: the answer fails our check (residual "), "{}", run.out);
    assert!(run.out.contains("Equilibrium"), "what there is is printed: {}", run.out);
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
