//! What is written: files whole or not at all, and standard output.

use std::fs;
use std::process::Stdio;

use palkki::route::{Method, Solver};
use palkki::{Settings, solve_raw};

use super::{EXAMPLE, Folder, SURVEYED, scene};

#[test]
fn csv_holds_the_nodes_to_the_last_bit() {
    let folder = Folder::new("csv");
    folder.write("nodes.csv", "what was there before");
    let run = folder.run("solve example.toml --method displacement --intervals 12 --csv nodes.csv");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let csv = folder.read("nodes.csv");
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("x,deflection,clearance,contact_force,moment"));
    let settings =
        Settings { method: Method::Displacement, solver: Solver::ActiveSet, intervals: 12, tolerance: 1e-10 };
    let nodes = solve_raw(&scene(EXAMPLE), &settings).expect("an answer").state.nodes.expect("nodes");
    let columns = [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    let mut rows = 0;
    for (i, line) in lines.enumerate() {
        let read: Vec<u64> = line.split(',').map(|field| field.parse::<f64>().expect("a number").to_bits()).collect();
        assert_eq!(read, columns.map(|column| column[i].to_bits()), "row {i}");
        rows += 1;
    }
    assert_eq!(rows, 11, "one row for each interior node");
    let left = folder.contents().iter().filter(|(path, _)| path.to_string_lossy().contains(".tmp")).count();
    assert_eq!(left, 0, "no temporary file is left");
}

#[test]
fn without_a_foundation_the_clearance_is_left_empty() {
    let folder = Folder::new("csv_free");
    folder.write("free.toml", "[beam]\nlength = 2\nbending_stiffness = 1\n[load]\nuniform = 1\n");
    let run = folder.run("solve free.toml --method force --intervals 2 --csv nodes.csv");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let csv = folder.read("nodes.csv");
    let fields: Vec<&str> = csv.lines().nth(1).expect("one node").split(',').collect();
    assert_eq!(fields.len(), 5, "{csv}");
    assert_eq!([fields[0], fields[2]], ["1.0", ""], "x and the clearance in {csv}");
    let (_, _, json) = folder.json("solve free.toml --method force --intervals 2");
    assert_eq!(json["nodes"]["clearance"], serde_json::json!([null]), "JSON has no infinity");
}

#[test]
fn a_file_that_cannot_be_written_ends_the_run_before_anything_is_printed() {
    let folder = Folder::new("unwritable");
    folder.write("surveyed.toml", SURVEYED);
    folder.write("levels.csv", "x,depth\n0,1\n10,1\n");
    fs::create_dir(folder.path("directory.csv")).expect("a directory");
    let force = "solve example.toml --method force --csv";
    insta::assert_snapshot!(folder.refused(&format!("{force} nowhere/nodes.csv")), @r#"error: cannot write "nowhere/nodes.csv": there is no such directory"#);
    insta::assert_snapshot!(folder.refused(&format!("{force} directory.csv")), @r#"error: cannot write "directory.csv": it is not a regular file"#);
    insta::assert_snapshot!(folder.refused(&format!("{force} example.toml")), @r#"error: cannot write "example.toml": it is the scene itself, or its survey"#);
    insta::assert_snapshot!(folder.refused(&format!("{force} example.toml/nodes.csv")), @r#"error: cannot write "example.toml/nodes.csv": there is no such directory"#);
    insta::assert_snapshot!(folder.refused(&format!("{force} ..")), @r#"error: cannot write "..": it is not a regular file"#);
    insta::assert_snapshot!(folder.refused(&format!("{force} both --plot both")), @r#"error: cannot write "both": it is named twice"#);
    insta::assert_snapshot!(folder.refused("solve surveyed.toml --method force --csv levels.csv"), @r#"error: cannot write "levels.csv": it is the scene itself, or its survey"#);
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_stays_a_link() {
    let folder = Folder::new("link");
    folder.write("target.csv", "old");
    std::os::unix::fs::symlink("target.csv", folder.path("link.csv")).expect("a link");
    assert_eq!(folder.run("solve example.toml --method force --csv link.csv").code, Some(0));
    assert!(folder.read("target.csv").starts_with("x,"), "the file that the link names is written");
    assert!(folder.path("link.csv").is_symlink(), "the link is still one");
}

#[test]
fn a_reader_that_closes_the_pipe_is_no_failure() {
    let folder = Folder::new("pipe");
    let mut command = folder.command("solve example.toml --method force --intervals 300 --format json");
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), b"".as_slice()));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_a_failure() {
    let folder = Folder::new("full");
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has a full device");
    let output = folder.command("solve example.toml --method force").stdout(full).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stderr.starts_with(b"error: cannot print the answer: "), "it says why");
}

#[test]
fn a_plot_is_written_and_says_what_it_shows() {
    let folder = Folder::new("plot");
    let run = folder.run("solve example.toml --method displacement --intervals 12 --csv nodes.csv --plot beam.svg");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let svg = folder.read("beam.svg");
    assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"), "a whole figure");
    assert!(svg.contains("Example: displacement method, active-set, 12 intervals"), "its title names the answer");
    assert!(folder.read("nodes.csv").lines().count() == 12, "and the table is written as well");
}
