//! The files that the report's page on bounds is rendered from: complete, and without an exception.

use std::fs;
use std::path::Path;

use palkki::route::{Method, Solver};

use crate::scenes::report;

/// Grids that are asked for.
const GRIDS: [&str; 5] = ["10", "30", "100", "300", "1000"];

#[track_caller]
fn lines(name: &str) -> Vec<Vec<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("report/data").join(name);
    let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{name}: {e}"));
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn every_answer_has_its_certificate_and_none_is_an_exception() {
    let rows = lines("certificates.csv");
    for (scene, _) in report() {
        for method in Method::ALL {
            for solver in Solver::ALL {
                for intervals in GRIDS {
                    let key = [scene.as_str(), method.name(), solver.name(), intervals];
                    let found = rows.iter().filter(|row| row[..4] == key).count();
                    assert_eq!(found, 1, "{key:?} has one row");
                }
            }
        }
    }
    for row in &rows {
        assert!(["bounded", "refused"].contains(&row[5].as_str()), "{row:?}");
        let (truth, certified): (f64, f64) = (row[6].parse().expect("a number"), row[7].parse().expect("a number"));
        // Infinite, both, for what is no number.
        assert!(truth <= certified, "{row:?}");
    }
}

#[test]
fn every_scene_has_its_faults_and_none_is_an_exception() {
    let rows = lines("faults.csv");
    for (scene, _) in report() {
        assert!(20 < rows.iter().filter(|row| row[0] == scene).count(), "{scene} has faults put into its answers");
    }
    for row in &rows {
        assert_eq!(row.last().map(String::as_str), Some("0"), "{row:?}");
    }
}
