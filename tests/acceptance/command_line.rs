//! The program as it is run: exit codes, standard output, files, JSON. The contract is what scripts rely on.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::{Settings, solve};
use serde_json::Value;

const EXAMPLE: &str = "\
title = 'Example'
[beam]
length = 10
bending_stiffness = 1.3020833333333333
[load]
uniform = 1
[foundation]
depth = 1
";

/// A ridge, at which the paper's four steps stop short of the optimum on 30 intervals.
const RIDGE: &str = "\
[beam]
length = 10
bending_stiffness = 1.3020833333333333
[load]
uniform = 1
[foundation]
points = [[0, 1], [3, 1], [4, 0.5], [5, 1], [10, 1]]
[units]
length = 'm'
force = 'kN'
";

const SURVEYED: &str = "[beam]\nlength = 10\nbending_stiffness = 1\n[foundation]\nsurvey = 'levels.csv'\n";

/// A folder of its own for one test, with the scenes above in it.
struct Folder(PathBuf);

/// What a run of the program came to.
struct Run {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Folder {
    fn new(test: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("command_line").join(test);
        // What an earlier run left.
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder for the test");
        let folder = Self(folder);
        folder.write("example.toml", EXAMPLE);
        folder.write("ridge.toml", RIDGE);
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.path(name), text).expect("a file for the test");
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("a file that the program wrote")
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_palkki"));
        command.current_dir(&self.0).args(arguments.split_whitespace()).env("COLUMNS", "100");
        command
    }

    fn run(&self, arguments: &str) -> Run {
        let Output { status, stdout, stderr } = self.command(arguments).output().expect("the program runs");
        let text = |bytes| String::from_utf8(bytes).expect("the program prints text");
        Run { code: status.code(), out: text(stdout), err: text(stderr) }
    }

    /// Names and contents of all files.
    fn contents(&self) -> Vec<(PathBuf, Option<Vec<u8>>)> {
        let entries =
            fs::read_dir(&self.0).expect("the folder of the test").map(|entry| entry.expect("an entry").path());
        let mut contents: Vec<_> = entries.map(|path| (path.clone(), fs::read(path).ok())).collect();
        contents.sort();
        contents
    }

    /// Runs what has to fail: exit code 2, nothing on standard output, nothing written, and no panic. Hands back the message.
    #[track_caller]
    fn refused(&self, arguments: &str) -> String {
        let before = self.contents();
        let Run { code, out, err } = self.run(arguments);
        assert_eq!(code, Some(2), "exit code of {arguments:?}; it said {err}");
        assert_eq!(out, "", "nothing on standard output from {arguments:?}");
        assert!(err.starts_with("error: "), "{arguments:?} says why: {err}");
        assert!(!err.contains("panicked"), "{arguments:?} panicked: {err}");
        assert!(before == self.contents(), "{arguments:?} leaves the folder as it is");
        err.trim_end().to_owned()
    }

    fn json(&self, arguments: &str) -> (Option<i32>, String, Value) {
        let run = self.run(&format!("{arguments} --format json"));
        assert_eq!(run.err, "", "nothing to complain about in {arguments:?}");
        let value = serde_json::from_str(&run.out).expect("valid JSON");
        (run.code, run.out, value)
    }
}

fn scene(text: &str) -> Scene {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a valid scene")
}

// Exit codes.

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

// Usage.

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
        ("compare example.toml --intervals 1", "must be at least 2, but is 1"),
        ("solve example.toml --method force --tolerance 0", "must be a positive, finite number, but is 0"),
        ("solve example.toml --method force --tolerance -1e-9", "must be a positive, finite number, but is -1e-9"),
        ("solve example.toml --method force --tolerance nan", "must be a positive, finite number, but is nan"),
        ("solve example.toml --method force --tolerance inf", "must be a positive, finite number, but is inf"),
        ("solve example.toml --solver nsor", "--solver belongs to a discretised method"),
        ("solve example.toml --method exact --solver nsor", "--solver belongs to a discretised method"),
        ("solve example.toml --method exact --intervals 30", "--intervals belongs to a discretised method"),
        ("solve example.toml --tolerance 1e-8", "--tolerance belongs to a discretised method"),
        ("solve example.toml --nodes", "--nodes belongs to a discretised method"),
    ] {
        let run = folder.run(arguments);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{arguments}");
        assert!(run.err.contains(why), "{arguments} says {why:?}: {}", run.err);
    }
}

// Files that are not what they should be.

#[test]
fn scene_files_that_cannot_be_read() {
    let folder = Folder::new("unreadable_scene");
    folder.write("binary.toml", b"[beam]\nlength = \xff\xfe\n");
    folder.write("empty.toml", "");
    fs::create_dir(folder.path("directory.toml")).expect("a directory");
    insta::assert_snapshot!(folder.refused("solve missing.toml"), @"
    error: cannot read the scene: there is no such file
    --> missing.toml
    ");
    insta::assert_snapshot!(folder.refused("compare missing.toml --format json"), @"
    error: cannot read the scene: there is no such file
    --> missing.toml
    ");
    insta::assert_snapshot!(folder.refused("solve directory.toml"), @"
    error: cannot read the scene: it is a directory, not a file
    --> directory.toml
    ");
    insta::assert_snapshot!(folder.refused("solve binary.toml"), @"
    error: cannot read the scene: it is not a text file: the byte at line 2, column 10 is not UTF-8
    --> binary.toml
    ");
    insta::assert_snapshot!(folder.refused("solve empty.toml"), @"
    error: the file is empty
    --> empty.toml
     = note: expected a scene in TOML, with at least a table [beam]
    ");
    insta::assert_snapshot!(folder.refused("solve example.toml/scene.toml"), @"
    error: cannot read the scene: it cannot be read (not a directory)
    --> example.toml/scene.toml
    ");
}

#[test]
fn a_scene_file_that_is_too_large() {
    let folder = Folder::new("large_scene");
    let file = fs::File::create(folder.path("large.toml")).expect("a file for the test");
    // A hole: it takes no room on the disk.
    file.set_len(64 * 1024 * 1024 + 1).expect("a large file");
    let run = folder.run("solve large.toml");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    insta::assert_snapshot!(run.err.trim_end(), @"
    error: cannot read the scene: it is larger than 67108864 bytes, the most that is read
    --> large.toml
    ");
}

#[test]
fn a_bad_scene_is_shown_with_file_line_and_column() {
    let folder = Folder::new("bad_scene");
    folder.write("bad.toml", EXAMPLE.replace("length = 10", "length = -10"));
    insta::assert_snapshot!(folder.refused("solve bad.toml --method force --csv nodes.csv"), @"
    error: `beam.length` must be positive and finite, but is -10
     --> bad.toml:3:10
      |
    3 | length = -10
      |          ^^^
    ");
}

#[test]
fn surveys_are_read_beside_the_scene_file() {
    let folder = Folder::new("survey");
    fs::create_dir(folder.path("site")).expect("a directory");
    folder.write("site/scene.toml", SURVEYED);
    insta::assert_snapshot!(folder.refused("solve site/scene.toml --method force"), @r#"
    error: cannot read the survey "levels.csv": there is no such file
     --> site/scene.toml:5:10
      |
    5 | survey = 'levels.csv'
      |          ^^^^^^^^^^^^
    "#);
    folder.write("site/levels.csv", "x,depth\n0,1\n10,one\n");
    insta::assert_snapshot!(folder.refused("solve site/scene.toml --method force"), @r#"
    error: `depth` must be a finite number, but is "one"
     --> site/levels.csv:3:4
      |
    3 | 10,one
      |    ^^^
    "#);
    folder.write("site/levels.csv", b"x,depth\n0,1\n10,\xb2\n");
    insta::assert_snapshot!(folder.refused("solve site/scene.toml --method force"), @r#"
    error: cannot read the survey "levels.csv": it is not a text file: the byte at line 3, column 4 is not UTF-8
     --> site/scene.toml:5:10
      |
    5 | survey = 'levels.csv'
      |          ^^^^^^^^^^^^
    "#);
    folder.write("site/levels.csv", "x,depth\n0,1\n10,1\n");
    assert_eq!(folder.run("solve site/scene.toml --method force").code, Some(0), "a survey that is one");
}

// Files that are written.

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
    let nodes = solve(&scene(EXAMPLE), &settings).expect("an answer").state.nodes.expect("nodes");
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

// Standard output.

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

// JSON.

/// Keys of the contract in its order, with those that we add.
const KEYS: [&str; 19] = [
    "scene",
    "method",
    "solver",
    "intervals",
    "status",
    "solver_status",
    "residual",
    "regime",
    "unknowns",
    "iterations",
    "seconds",
    "reactions",
    "contacts",
    "contact_force",
    "deflection",
    "moment",
    "energy",
    "certificate",
    "nodes",
];

#[track_caller]
fn check_keys(object: &Value, keys: &[&str]) {
    let mut expected = keys.to_vec();
    expected.sort_unstable();
    let found: Vec<&str> = object.as_object().expect("an object").keys().map(String::as_str).collect();
    assert_eq!(found, expected);
}

#[test]
fn json_of_solve_has_the_shape_of_the_contract() {
    let folder = Folder::new("json");
    let (code, text, json) = folder.json("solve example.toml --method force");
    assert_eq!(code, Some(0));
    check_keys(&json, &KEYS);
    let places: Vec<_> = KEYS.iter().map(|key| text.find(&format!("\n  \"{key}\": ")).expect("a key")).collect();
    assert!(places.is_sorted(), "the keys are in the order of the contract");
    assert_eq!(json["scene"], "Example");
    assert_eq!([&json["method"], &json["solver"]], ["force", "active-set"]);
    assert_eq!(json["intervals"], 30);
    assert_eq!([&json["status"], &json["regime"]], ["certified", "zone"]);
    assert!(json["solver_status"].is_string() && json["certificate"].is_null(), "{text}");
    assert!(json["seconds"].as_f64().is_some_and(|seconds| 0.0 < seconds), "the solve takes time");
    check_keys(&json["reactions"], &["left", "right"]);
    check_keys(&json["contacts"][0], &["from", "to", "force"]);
    check_keys(&json["deflection"], &["max", "at", "min", "min_at"]);
    check_keys(&json["moment"], &["max", "max_at", "min", "min_at"]);
    check_keys(&json["nodes"], &["x", "deflection", "clearance", "contact_force", "moment"]);
    for (name, values) in json["nodes"].as_object().expect("an object") {
        assert_eq!(values.as_array().map(Vec::len), Some(29), "{name} has a value for each interior node");
    }
}

#[test]
fn json_numbers_read_back_as_the_same_bits() {
    let folder = Folder::new("json_bits");
    let (_, text, _) = folder.json("solve example.toml --method displacement --intervals 30");
    let settings =
        Settings { method: Method::Displacement, solver: Solver::ActiveSet, intervals: 30, tolerance: 1e-10 };
    let state = solve(&scene(EXAMPLE), &settings).expect("an answer").state;
    for (key, value) in [("energy", state.energy), ("contact_force", state.contact_force())] {
        let line = text.lines().find_map(|line| line.strip_prefix(&format!("  \"{key}\": "))).expect("the key");
        let read: f64 = line.trim_end_matches(',').parse().expect("a number");
        assert_eq!(read.to_bits(), value.to_bits(), "{key}");
    }
}

#[test]
fn json_of_an_answer_that_fails_the_check() {
    let (code, _, json) = Folder::new("json_1").json("solve ridge.toml --method displacement --solver four-step");
    assert_eq!(code, Some(1));
    assert_eq!(json["status"], "not-certified");
    assert_eq!(json["scene"], "ridge.toml", "a scene without a title is called by its file");
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

#[test]
fn compare_has_every_method_with_every_solver() {
    let folder = Folder::new("compare");
    let (code, _, json) = folder.json("compare ridge.toml --intervals 12");
    assert_eq!(code, Some(0), "at least one answer passes");
    check_keys(&json, &["scene", "intervals", "routes"]);
    assert_eq!(json["intervals"], 12);
    let routes = json["routes"].as_array().expect("an array");
    for route in routes {
        let keys: Vec<&str> = KEYS[1..18].iter().copied().chain(["solver_error", "model_error"]).collect();
        check_keys(route, &keys);
    }
    for method in Method::ALL {
        for solver in Solver::ALL {
            let found: Vec<_> =
                routes.iter().filter(|r| r["method"] == method.word() && r["solver"] == solver.word()).collect();
            let [route] = found[..] else { panic!("{method} × {solver} is there once, not {} times", found.len()) };
            let reference = if method == Method::Complementarity { "complementarity" } else { "force" };
            assert_eq!(route["solver_error"]["reference"], format!("{reference}/active-set"));
        }
    }
}

/// An answer is as far from the reference as its numbers are.
#[test]
fn compare_measures_solver_errors() {
    let (_, _, json) = Folder::new("compare_errors").json("compare ridge.toml");
    let routes = json["routes"].as_array().expect("an array");
    let find = |method: &str, solver: &str| {
        let mut routes = routes.iter();
        routes.find(|r| r["method"] == method && r["solver"] == solver).expect("the route")
    };
    let number = |value: &Value| value.as_f64().expect("a number");
    let (reference, answer) = (find("force", "active-set"), find("displacement", "four-step"));
    let reaction = |route: &Value, side: &str| number(&route["reactions"][side]);
    let most = reaction(reference, "left").max(reaction(reference, "right"));
    let off = ["left", "right"].map(|side| (reaction(answer, side) - reaction(reference, side)).abs() / most);
    let printed = number(&answer["solver_error"]["reaction"]);
    // Both are computed from the same numbers, one of them after printing and reading.
    const ROUNDING: f64 = 1e-12;
    assert!((printed - off[0].max(off[1])).abs() < ROUNDING, "{printed} for {off:?}");
    assert_eq!(number(&reference["solver_error"]["energy"]).to_bits(), 0, "the reference is its own reference");
}

// Tables.

/// A table without what changes from run to run and from processor to processor.
fn steady(text: &str) -> String {
    let shaky = ["  seconds", "  status", "  what remains", "  iterations"];
    let lines = text.lines().filter(|line| !shaky.iter().any(|start| line.starts_with(start)));
    lines.collect::<Vec<_>>().join("\n")
}

/// Four intervals with contact at all three nodes, to be checked by hand: `p_1 = q − 2 EI u / Δ⁴`, `p_2 = q + 2 EI u / Δ⁴`.
#[test]
fn table_of_solve() {
    let folder = Folder::new("table");
    let run = folder.run("solve example.toml --method complementarity --intervals 4 --nodes");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    insta::assert_snapshot!(steady(&run.out), @"
    Example
    =======

      method      complementarity, 4 intervals
      solver      active-set, which says: optimal
      regime      zone
      unknowns    3

    Equilibrium
                           force
      loads                   10  down
      left support   1.333333333  up
      right support  1.333333333  up
      contact        7.333333333  up

    Contacts
            from   to        force
      zone   2.5  7.5  7.333333333

    Extremes
                                 value   at
      largest deflection             1  2.5
      least deflection               0    0
      largest moment      0.2083333333  2.5
      least moment                   0    0
      energy J            -7.416666667

    Nodes
      node    x  deflection  clearance  contact force        moment
         1  2.5           1          0    2.333333333  0.2083333333
         2    5           1          0    2.666666667             0
         3  7.5           1          0    2.333333333  0.2083333333
    ");
}

#[test]
fn table_with_units_and_without_contact() {
    let folder = Folder::new("table_units");
    folder.write("high.toml", RIDGE.replace("uniform = 1", "uniform = 0.001"));
    let run = folder.run("solve high.toml --method force --intervals 2");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    insta::assert_snapshot!(steady(&run.out), @"
    high.toml
    =========

      method      force, 2 intervals
      solver      active-set, which says: optimal
      regime      none
      unknowns    1

    Equilibrium
                     force [kN]
      loads                0.01  down
      left support        0.005  up
      right support       0.005  up
      contact                 0  up

    Contacts: none

    Extremes
                                value  at [m]
      largest deflection [m]     0.08       5
      least deflection [m]          0       0
      largest moment [kN m]    0.0125       5
      least moment [kN m]           0       0
      energy J [kN m]         -0.0002
    ");
}

#[test]
fn table_of_compare_has_a_row_for_each_route() {
    let run = Folder::new("table_compare").run("compare example.toml --intervals 6");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    for method in Method::ALL {
        for solver in Solver::ALL {
            let rows =
                run.out.lines().filter(|line| line.split_whitespace().take(2).eq([method.word(), solver.word()]));
            assert_eq!(rows.count(), 1, "{method} × {solver} in\n{}", run.out);
        }
    }
}
