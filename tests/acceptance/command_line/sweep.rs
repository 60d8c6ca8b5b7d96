//! `sweep`, `--derivatives` and `--depth-tolerance` as they are run.

use std::fs;
use std::path::Path;
use std::time::Instant;

use palkki_evidence::numdiff::numdiff;

use super::Folder;

const VARY: &str = "sweep example.toml --vary foundation.depth --from 0.5 --to 8 --steps 7";

#[test]
fn files_of_a_sweep_are_whole() {
    let folder = Folder::new("sweep_files");
    let run = folder.run(&format!("{VARY} --csv rows.csv --plot sweep.svg"));
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert!(run.out.contains("certified: 7 of 7 answers"), "{}", run.out);
    let csv = folder.read("rows.csv");
    let columns = csv.lines().next().expect("a header").split(',').count();
    assert!(csv.lines().count() == 8 && csv.lines().all(|line| line.split(',').count() == columns), "{csv}");
    assert!(folder.read("sweep.svg").ends_with("</svg>\n"));
    // Of many rows some are shown, and what answers and events take is no more than the program takes.
    let begin = Instant::now();
    let run = folder.run(&VARY.replace("--steps 7", "--steps 1000"));
    let most = begin.elapsed().as_secs_f64();
    assert!(run.out.contains("\nAnswers, 41 of 1000; --csv and --format json have all"), "{}", run.out);
    let line = run.out.lines().find(|line| line.contains("for the events")).expect("how long it took");
    let seconds: f64 = line.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).sum();
    assert!(0.0 < seconds && 0.95 * seconds < most, "{line}, but {most}");
}

/// What a figure shows, in words.
fn description(svg: &str) -> &str {
    svg.split("<desc id=\"desc\">").nth(1).and_then(|rest| rest.split("</desc>").next()).unwrap_or_default()
}

/// The commands of the guide run, and those above its figures draw these figures, with the same events.
#[test]
fn the_commands_of_the_guide_make_its_figures() {
    let folder = Folder::new("sweep_page");
    let report = Path::new(env!("CARGO_MANIFEST_DIR")).join("report");
    let page = fs::read_to_string(report.join("pages/guide.md")).expect("the page can be read");
    let scenes = format!("{}/", report.join("scenes").display());
    let (mut figures, mut others) = (0, 0);
    let commands = page.lines().filter_map(|line| line.strip_prefix("$ palkki "));
    for command in commands.filter(|command| command.contains("report/scenes/")) {
        let run = folder.run(&command.replace("report/scenes/", &scenes).replace('\'', ""));
        assert_eq!(run.code, Some(0), "`{command}`: {}", run.err);
        let Some((_, name)) = command.rsplit_once("--plot ") else {
            others += 1;
            continue;
        };
        let shown = fs::read_to_string(report.join("figures").join(name)).expect("the figure can be read");
        let drawn = folder.read(name);
        let difference = numdiff(description(&shown), description(&drawn));
        assert!(difference.is_ok() && description(&drawn).contains("Event 1 at"), "`{command}`: {difference:?}");
        figures += 1;
    }
    assert_eq!((figures, others), (1, 1), "commands of the guide");
}

/// Thousands of supports: every value has its certified answer, and the search for events ends with its work.
#[test]
fn a_sweep_that_is_stopped_says_where_and_fails() {
    const SUPPORTS: u32 = 3000;
    let folder = Folder::new("sweep_stopped");
    let supports: Vec<String> = (0..=SUPPORTS).map(|i| format!("{{ at = {} }}", f64::from(i) / 30.0)).collect();
    let beam = format!("[beam]\nlength = 100.0\nbending_stiffness = 1000.0\nsupports = [{}]\n", supports.join(", "));
    folder.write("many.toml", format!("{beam}[load]\nuniform = 1.0\n[foundation]\ndepth = 0.5\n"));
    let run = folder.run("sweep many.toml --vary load.uniform --from 0.5 --to 2 --steps 3 --format json");
    assert_eq!(run.code, Some(1), "{}", run.err);
    let object: serde_json::Value = serde_json::from_str(&run.out).expect("one object");
    assert_eq!(object["rows"].as_array().map(Vec::len), Some(3), "every value has its answer");
    let reason = object["stopped"]["reason"].as_str().unwrap_or_default();
    assert!(reason.contains("the work that one sweep may take is done"), "{reason}");
}

/// A strut of `π² EI/l² = 2.96`: where it buckles is an event, and the sweep is whole, in both directions; one that never bears its compression has
/// no row.
#[test]
fn a_sweep_ends_where_the_beam_buckles() {
    let folder = Folder::new("sweep_buckles");
    let beam = "[beam]\nlength = 10.0\nbending_stiffness = 30.0\ntension = -1.0\n[load]\nuniform = 1.0\n";
    folder.write("strut.toml", format!("{beam}[foundation]\ndepth = 9.0\n"));
    let at = -0.3 * std::f64::consts::PI * std::f64::consts::PI;
    for (from, to, what) in [(-1.0, -4.0, "the beam buckles"), (-4.0, -1.0, "the beam no longer buckles")] {
        let command = format!("sweep strut.toml --vary beam.tension --from {from} --to {to} --steps 13");
        let (code, text, object) = folder.json(&command);
        assert!(code == Some(0) && object.get("stopped").is_none(), "{text}");
        assert_eq!(object["rows"].as_array().map(Vec::len), Some(8), "-1, -1.25, … -2.75");
        let events = object["events"].as_array().expect("a list");
        let buckles = events.iter().find(|event| event["what"] == what).unwrap_or_else(|| panic!("{events:?}"));
        assert!((buckles["value"].as_f64().expect("a number") - at).abs() < 1e-10, "{events:?}");
        let run = folder.run(&command);
        assert!(run.code == Some(0) && run.out.contains("8 of 8 answers"), "{}", run.out);
        assert!(run.out.contains("for 5 more values, which have no answer"), "{}", run.out);
    }
    let run = folder.run("sweep strut.toml --vary beam.tension --from -3 --to -4 --steps 3");
    assert!(run.code == Some(2) && run.err.contains("buckles"), "{}", run.err);
}

/// A range with values without an answer, at its end, at its beginning, or at both: the rows that there are are printed, the same ones and
/// with the same events in both directions, with the reason; if there is none, that is an error.
#[test]
fn a_sweep_that_leaves_what_has_an_answer_prints_what_there_is() {
    let folder = Folder::new("sweep_left");
    let supports = "supports = [{ at = 2.0, pushes_only = true }, { at = 8.0, pushes_only = true }]";
    let beam = format!("[beam]\nlength = 10.0\nbending_stiffness = 1.0\n{supports}\n");
    folder.write("bearings.toml", format!("{beam}[load]\npoint = [{{ at = 5.0, force = 1.0 }}]\n"));
    let swept = |path: &str, from: f64, to: f64| {
        let file = if path.starts_with("load") { "bearings" } else { "example" };
        let run =
            folder.run(&format!("sweep {file}.toml --vary {path} --from {from} --to {to} --steps 9 --format json"));
        assert_eq!(run.code, Some(1), "{path}: {}", run.err);
        let object: serde_json::Value = serde_json::from_str(&run.out).expect("one object");
        let numbers = |key: &str| -> Vec<f64> {
            let rows = object[key].as_array().expect("a list").iter();
            rows.map(|row| row["value"].as_f64().expect("a value")).collect()
        };
        assert_eq!(object["stopped"]["of"].as_u64(), Some(9), "{path}");
        let reason = object["stopped"]["reason"].as_str().unwrap_or_default().to_owned();
        (numbers("rows"), numbers("events"), reason)
    };
    let (path, of_load) = ("foundation.depth", "load.point[0].at");
    for (path, from, to, rows, words) in [
        (path, 120.0, -40.0, 7, "`foundation.depth` = -20, and none from 0 on"),
        (path, -40.0, 120.0, 7, "there are answers from 0 on"),
        (of_load, 0.0, 10.0, 5, "there are answers from 2 on, but for 1 more stretch of values"),
    ] {
        let (forth, events, reason) = swept(path, from, to);
        let (mut back, mut events_back, _) = swept(path, to, from);
        back.reverse();
        events_back.reverse();
        assert!(forth.len() == rows && forth == back, "{path}: {forth:?} and {back:?}");
        let near = events.iter().zip(&events_back).all(|(a, b)| (a - b).abs() <= 1e-7);
        assert!(events.len() == events_back.len() && near, "{path}: {events:?} and {events_back:?}");
        assert!(reason.contains(words), "{reason}");
    }
    let nothing = folder.run("sweep example.toml --vary foundation.depth --from -2 --to -1 --steps 5");
    assert!(nothing.code == Some(2) && nothing.out.is_empty(), "{}", nothing.err);
}

/// A force 1 that moves over a beam of length 10 without a foundation: at mid-span `M = a/2` left of it and `(10 − a)/2` right of it, and
/// `V` is `−a/10` right of the force and `1 − a/10` left of it. Text, CSV and JSON have the same numbers.
#[test]
fn influence_lines_are_the_same_in_text_csv_and_json() {
    let folder = Folder::new("sweep_at");
    folder
        .write("line.toml", "[beam]\nlength = 10\nbending_stiffness = 100\n[load]\npoint = [{ at = 2, force = 1 }]\n");
    let command = "sweep line.toml --vary load.point[0].at --from 2 --to 8 --steps 4 --at 5,2.5 --csv rows.csv";
    let [text, json] = ["text", "json"].map(|format| {
        let run = folder.run(&format!("{command} --format {format}"));
        assert_eq!(run.code, Some(0), "{}", run.err);
        run.out
    });
    let object: serde_json::Value = serde_json::from_str(&json).expect("one object");
    let csv = folder.read("rows.csv");
    let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().expect("a header");
    let first = header.iter().position(|name| *name == "at_1_x").expect("columns of the places");
    let table = text.split("\nAt x = 5\n").nth(1).expect("a table of the first place");
    let shown = table.lines().skip(1).map(|line| line.split_whitespace().collect::<Vec<_>>());
    let rows = object["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 4);
    for ((row, cells), shown) in rows.iter().zip(lines).zip(shown) {
        let a = row["value"].as_f64().expect("a value");
        let place = &row["at"][0];
        let list = ["/x", "/deflection", "/slope", "/moment/0", "/moment/1", "/shear/0", "/shear/1"];
        let numbers = list.map(|key| place.pointer(key).and_then(serde_json::Value::as_f64).expect("a number"));
        let of_csv: Vec<f64> = cells[first..first + 7].iter().map(|cell| cell.parse().expect("a number")).collect();
        assert_eq!(of_csv, numbers, "{a}");
        let (moment, shear) = if a < 5.0 { (0.5 * a, -0.1 * a) } else { (0.5 * (10.0 - a), 1.0 - 0.1 * a) };
        for (number, expected) in numbers[3..].iter().zip([moment, moment, shear, shear]) {
            assert!((number - expected).abs() < 1e-12, "{a}: {numbers:?}");
        }
        let of_text: Vec<f64> = shown.iter().map(|cell| cell.parse().expect("a number")).collect();
        for (shown, number) in of_text.iter().zip(std::iter::once(&a).chain(&numbers[1..])) {
            assert!((shown - number).abs() <= 1e-5 * number.abs(), "{a}: {of_text:?}");
        }
        assert_eq!((of_text.len(), row["at"][1]["x"].as_f64()), (7, Some(2.5)), "{a}");
    }
}
