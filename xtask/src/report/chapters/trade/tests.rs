//! The chapter is rendered from whatever rows there are.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use minijinja::Value;

use super::asked::Asked;
use super::{Evidence, Store, of};
use crate::report::template::{environment, render};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The text of the chapter and its files, from the text of the file of measurements.
#[track_caller]
fn rendered(measurements: &str) -> (String, Vec<String>) {
    let evidence = of(&Store::parse(PathBuf::new(), measurements), Vec::new()).expect("the chapter has evidence");
    let template = std::fs::read_to_string(root().join("report/chapters/100-trade.md")).expect("there is a template");
    let Evidence { values, .. } = &evidence;
    let context = Value::from(BTreeMap::from([("trade", values.clone())]));
    let text = render(&environment(), "100-trade", &template, &context).unwrap_or_else(|error| panic!("{error}"));
    (text, evidence.files().keys().cloned().collect())
}

const HEADER: &str = "scene,route,intervals,tolerance,status,claims,residual,iterations,unknowns,runs,median_s,min_s,max_s,\
    reaction_solver,contact_solver,deflection_solver,energy_solver,reaction_total,contact_total,deflection_total,energy_total,\
    added_s,tridiagonal_s,peak_kb,certificate_s";

#[test]
fn from_no_row_at_all() {
    let (text, files) = rendered(&format!("# machine: a\n{HEADER}\n"));
    assert!(text.contains("It has 0 measurements") && text.contains("- machine: a"), "{text}");
    assert_eq!(files, [""; 0], "nothing to draw");
}

#[test]
fn from_every_beginning_of_the_file_of_the_report() {
    let file = std::fs::read_to_string(root().join(crate::measure::store::PATH)).expect("the report has measurements");
    let lines: Vec<&str> = file.lines().collect();
    for share in 0..=6 {
        let (text, files) = rendered(&lines[..4.max(lines.len() * share / 6)].join("\n"));
        for file in files.iter().filter(|file| file.starts_with("figures/")) {
            assert!(text.contains(&format!("({file})")), "{file} is made and not shown, {share} sixths of the file");
        }
    }
}

/// 40 ms against 10 ms of the yardstick, 20 times a hundred thousand intervals, 12 kB: the arithmetic of the verdicts.
#[test]
fn requirements_are_judged() {
    let row = |n: usize, seconds: &str, more: &str| {
        let e = "1.00e-10";
        format!(
            "heinisuo-1984,force/active-set,{n},0e0,certified,success,1e-13,,,9,{n},5,{seconds},{seconds},{seconds},NaN,NaN,NaN,NaN,{e},{e},{e},{e},{more}"
        )
    };
    let (text, _) =
        rendered(&format!("{HEADER}\n{}\n{}\n", row(1_000_000, "4e-2", ",1e-2,12"), row(100_000, "2e-3", ",,,1e-3")));
    for line in [
        "| at most 5 times one tridiagonal solve of the same size | 4.0 times; the tridiagonal solve took 10 milliseconds | met, 1.2 times over |",
        "| at most 300 MB in use | 0.012 MB, program and all | met, 2.5·10⁴ times over |",
        "| a [certificate](#bounds-for-the-continuous-beam) on 100 000 intervals takes at most 1 times as long as the solve | 0.50 times: 1.0 milliseconds beside 2.0 | met, 2.0 times over |",
        "| at most 13 times as long as on 100 000 intervals | 20 times | **not met**, short by a factor of 1.5 |",
    ] {
        let found = text.lines().any(|printed| printed == line);
        assert!(found, "`{line}` is missing in\n{text}");
    }
}

#[test]
fn a_requirement_is_met_or_not() {
    let [a, b] = [Asked::at_most(5.0, 4.0), Asked::at_least(30.0, 15.0)];
    assert_eq!((a.met, a.factor, b.met, b.factor), (true, Some(1.25), false, Some(2.0)), "5/4 and 2 are exact");
    let nothing = Asked::at_most(1e-14, 0.0);
    assert_eq!((nothing.met, nothing.factor), (true, None), "no factor, but met");
}
