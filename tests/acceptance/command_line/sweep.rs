//! `sweep`, `--derivatives` and `--depth-tolerance` as they are run.

use std::fs;
use std::path::Path;

use palkki_evidence::numdiff::numdiff;

use super::Folder;

const VARY: &str = "sweep example.toml --vary foundation.depth --from 0.5 --to 8 --steps 7";

#[test]
fn a_sweep_has_rows_and_events() {
    let folder = Folder::new("sweep");
    let (code, _, value) = folder.json(VARY);
    assert_eq!(code, Some(0));
    assert_eq!(value["vary"], "foundation.depth");
    let rows = value["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 7);
    for (row, depth) in rows.iter().zip([0.5, 1.75, 3.0, 4.25, 5.5, 6.75, 8.0]) {
        assert_eq!(row["value"], depth);
        assert_eq!(row["status"], "certified");
        assert!(row.get("nodes").is_none() && row["contacts"].is_array() && row["energy"].is_number());
    }
    // q l⁴/(384 EI) is 20 here.
    assert_eq!(value["events"].as_array().map(Vec::len), Some(0));
    let (code, _, value) = folder.json("sweep example.toml --vary foundation.depth --from 1 --to 150 --steps 3");
    assert_eq!(code, Some(0));
    let events = value["events"].as_array().expect("events");
    for (event, border) in events.iter().zip([20.0, 100.0]) {
        assert!((event["value"].as_f64().expect("a value") - border).abs() < 1e-11, "{event}");
    }
    assert_eq!(events.len(), 2);
}

#[test]
fn files_of_a_sweep_are_whole() {
    let folder = Folder::new("sweep_files");
    let run = folder.run(&format!("{VARY} --csv rows.csv --plot sweep.svg"));
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert!(run.out.contains("7 of 7 answers certified"), "{}", run.out);
    let csv = folder.read("rows.csv");
    let columns = csv.lines().next().expect("a header").split(',').count();
    assert!(csv.lines().count() == 8 && csv.lines().all(|line| line.split(',').count() == columns), "{csv}");
    assert!(folder.read("sweep.svg").ends_with("</svg>\n"));
}

/// The table has the forces of the supports that are there, by names that are true.
#[test]
fn a_sweep_shows_the_forces_of_its_outermost_supports() {
    let folder = Folder::new("sweep_supports");
    let held = [
        ("{ at = 1.0, built_in = true }, { at = 4.0 }, { at = 6.0, level = 0.1 }", ["first support", "last support"]),
        ("{ at = 0.0 }, { at = 8.0 }", ["left", "right"]),
        ("{ at = 0.0, built_in = true }", ["support", "support"]),
    ];
    for (supports, names) in held {
        let scene = format!(
            "[beam]\nlength = 8.0\nbending_stiffness = 2.0\nsupports = [{supports}]\n[load]\nuniform = 1.0\n[foundation]\ndepth = 9.0\n"
        );
        folder.write("held.toml", &scene);
        let arguments = "sweep held.toml --vary load.uniform --from 1 --to 2 --steps 2";
        let text = folder.run(arguments).out;
        let header = text.lines().find(|line| line.contains("least moment")).expect("a header");
        let (_, _, value) = folder.json(arguments);
        let forces = value["rows"][0]["supports"].as_array().expect("supports");
        let row = text.lines().skip_while(|line| *line != header).nth(1).expect("a row");
        for (name, support) in names.iter().zip([&forces[0], &forces[forces.len() - 1]]) {
            assert!(header.contains(&format!("  {name}  ")), "{header}");
            let force = support["force"].as_f64().expect("a force");
            assert!(row.contains(&format!(" {}  ", palkki::text::result(force))), "{force}: {row}");
        }
        assert_eq!(header.contains("left"), names[0] == "left", "{header}");
    }
}

#[test]
fn a_sweep_that_cannot_be_is_refused() {
    let folder = Folder::new("sweep_refused");
    let refused = |arguments: &str| folder.refused(&format!("sweep example.toml --csv a.csv {arguments}"));
    let message = refused("--vary load.point[0].at --from 0 --to 1 --steps 5");
    assert!(message.contains("`foundation.depth`") && message.contains("`beam.supports[0…1].level`"), "{message}");
    let message = refused("--vary foundation.depth --from 1 --to -1 --steps 5");
    assert!(message.contains("`foundation.depth` = -0.5") && message.contains("above a support"), "{message}");
    for steps in ["1", "0", "-3", "1000002", "many"] {
        let message = refused(&format!("--vary foundation.depth --from 1 --to 2 --steps {steps}"));
        assert!(message.contains("the number of steps must be"), "{message}");
    }
    for ends in ["--from nan --to 1", "--from 1 --to inf", "--from 1 --to 1", "--from x --to 1"] {
        refused(&format!("--vary foundation.depth {ends} --steps 5"));
    }
    assert!(refused("--vary beam.length --from 1 --to 2").contains("cannot be varied"));
}

/// ∂T/∂u₀ = T/4u₀ on the example.
#[test]
fn derivatives_and_tolerances_are_printed() {
    let folder = Folder::new("derivatives");
    let (code, _, value) = folder.json("solve example.toml --derivatives --depth-tolerance 0.1");
    assert_eq!(code, Some(0));
    let reaction = value["reactions"]["left"].as_f64().expect("a force");
    let by_depth = &value["derivatives"]["depth"];
    let left = by_depth["reactions"]["left"].as_f64().expect("a derivative");
    assert!((left - reaction / 4.0).abs() < 1e-12, "{left} for {reaction}");
    assert_eq!(by_depth["one_sided"], false);
    let known = &value["depth_tolerance"]["guaranteed"];
    assert_eq!(known["contact"], "certainly");
    let [lower, upper] = [0, 1].map(|i| known["energy"][i].as_f64().expect("a bound"));
    let energy = value["energy"].as_f64().expect("an energy");
    assert!(lower < energy && energy < upper, "{lower} {energy} {upper}");
    let text = folder.run("solve example.toml --derivatives --depth-tolerance 0.1").out;
    assert!(text.contains("by beam.bending_stiffness") && text.contains("guaranteed: the beam touches"), "{text}");
    for option in ["--derivatives", "--depth-tolerance 1"] {
        assert!(folder.refused(&format!("solve example.toml --method force {option}")).contains("--method exact"));
    }
    folder.refused("solve example.toml --depth-tolerance -1");
}

/// What a figure shows, in words.
fn description(svg: &str) -> &str {
    svg.split("<desc id=\"desc\">").nth(1).and_then(|rest| rest.split("</desc>").next()).unwrap_or_default()
}

/// The commands above the figures of the page draw these figures, with the same events.
#[test]
fn the_commands_of_the_page_of_sweeps_make_its_figures() {
    let folder = Folder::new("sweep_page");
    let report = Path::new(env!("CARGO_MANIFEST_DIR")).join("report");
    let page = fs::read_to_string(report.join("pages/sweeps.md")).expect("the page can be read");
    let scenes = format!("{}/", report.join("scenes").display());
    let (mut figures, mut others) = (0, 0);
    for command in page.lines().filter_map(|line| line.strip_prefix("$ cargo run --release -- ")) {
        let run = folder.run(&command.replace("report/scenes/", &scenes));
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
    assert_eq!((figures, others), (3, 2), "commands of the page");
}
