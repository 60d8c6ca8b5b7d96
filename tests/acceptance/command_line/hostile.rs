//! Files that nobody means well with: huge, deep, endless, half written; and output that has nowhere to go.

use std::fmt::Write as _;
use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use super::{EXAMPLE, Folder, Run, SURVEYED};

/// Longest that any of these runs may take, on a machine that is busy with other things as well: what is meant is that none of
/// them hangs, or takes time in the square of the size of a file.
const PATIENCE: Duration = Duration::from_secs(60);

/// Bytes of the longest message about a file of any size.
const LONGEST_MESSAGE: usize = 20_000;

/// Refused with exit code 2 and one message of bounded length that names the file.
#[track_caller]
fn check(folder: &Folder, arguments: &str, says: &str) {
    let start = Instant::now();
    let Run { code, out, err } = folder.run(arguments);
    assert!(start.elapsed() < PATIENCE, "{arguments} took {:?}", start.elapsed());
    assert_eq!((code, out.as_str()), (Some(2), ""), "{arguments}: {}", err.chars().take(1000).collect::<String>());
    assert!(
        err.starts_with("error: ") && err.contains(says),
        "{says:?} in {}",
        err.chars().take(1000).collect::<String>()
    );
    assert!(err.len() <= LONGEST_MESSAGE, "{arguments} says {} bytes", err.len());
}

#[test]
fn nesting_has_a_limit() {
    let folder = Folder::new("nesting");
    let many = 100_000;
    folder.write("arrays.toml", format!("a = {}", "[".repeat(many)));
    folder.write("tables.toml", format!("a = {}", "{a = ".repeat(many)));
    folder.write("keys.toml", format!("{}a = 1\n", "a.".repeat(many)));
    folder.write("header.toml", format!("[{}a]\n", "a.".repeat(many)));
    for name in ["arrays", "tables", "keys", "header"] {
        check(&folder, &format!("solve {name}.toml"), "not valid TOML");
    }
}

#[test]
fn messages_do_not_repeat_what_is_long() {
    let folder = Folder::new("long");
    let long = 1_000_000;
    folder.write("key.toml", format!("{EXAMPLE}{} = 1\n", "k".repeat(long)));
    folder.write("twice.toml", format!("{0} = 1\n{0} = 2\n", "k".repeat(long)));
    folder.write("number.toml", EXAMPLE.replace("length = 10", &format!("length = 1{}", "0".repeat(long))));
    folder.write("text.toml", EXAMPLE.replace("'Example'", &format!("1{}", "0".repeat(long))));
    folder.write("name.toml", SURVEYED.replace("levels.csv", &"n".repeat(long)));
    folder.write("surveyed.toml", SURVEYED);
    folder.write("levels.csv", format!("x,depth\n0,{}\n", "1".repeat(long)));
    folder.write("forces.csv", format!("x,force\n{},1\n", "z".repeat(long)));
    check(&folder, "solve key.toml", "unknown key");
    check(&folder, "solve twice.toml", "is there twice");
    check(&folder, "solve number.toml", "beyond the range");
    check(&folder, "solve text.toml", "must be one line of text");
    check(&folder, "solve name.toml", "cannot read the survey");
    check(&folder, "solve surveyed.toml", "`depth` must be a finite number");
    check(&folder, "certify example.toml forces.csv", "`x` must be a finite number");
}

#[test]
fn files_have_a_largest_size() {
    let folder = Folder::new("huge");
    // Holes: they take no room on the disk.
    for name in ["levels.csv", "forces.csv", "scene.toml"] {
        fs::File::create(folder.path(name)).and_then(|file| file.set_len(100 << 20)).expect("a large file");
    }
    folder.write("surveyed.toml", SURVEYED);
    let too_large = |bytes: u64| format!("it is larger than {} bytes", bytes << 20);
    for (arguments, most) in
        [("solve scene.toml", 16), ("solve surveyed.toml", 64), ("certify example.toml forces.csv", 64)]
    {
        let Run { code, out, err } = folder.run(arguments);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{arguments}");
        assert!(err.contains(&too_large(most)), "{err}");
    }
}

#[test]
fn surveys_of_very_many_points() {
    let folder = Folder::new("many_points");
    folder.write("surveyed.toml", SURVEYED);
    let survey = |count: u32| {
        let mut text = String::from("x,depth\n");
        for k in 0..=count {
            let x = 10.0 * (f64::from(k) / f64::from(count));
            // Writing to a string does not fail.
            let _ = writeln!(text, "{x},{}", 1.0 + 0.001 * f64::from(k % 7));
        }
        text
    };
    folder.write("levels.csv", survey(200_000));
    let start = Instant::now();
    let run = folder.run("solve surveyed.toml --method force --intervals 30");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "a grid takes as many as there are");
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
    insta::assert_snapshot!(folder.refused("solve surveyed.toml"), @"error: beam theory has no answer for this scene: a foundation given by points must have at most 20000 of them for an exact solution, but has 200001; choose another --method");
}

#[test]
fn numbers_at_the_end_of_the_range() {
    let folder = Folder::new("numbers");
    for (number, says) in [
        ("1e400", "beyond the range"),
        ("-1e400", "beyond the range"),
        ("nan", "must be positive and finite"),
        ("inf", "must be positive and finite"),
        ("-0.0", "must be positive and finite"),
        ("1e-400", "must be positive and finite"),
        ("0x", "must be a number"),
        ("0xffffffffffffffffffffffffffffffffffff", "beyond the range"),
        ("1e999999999999999999999", "beyond the range"),
    ] {
        folder.write("scene.toml", EXAMPLE.replace("length = 10", &format!("length = {number}")));
        check(&folder, "solve scene.toml", says);
    }
    // Denormal numbers are numbers: an answer, or a message that says what leaves the range.
    for number in ["5e-324", "2.2250738585072009e-308"] {
        for key in ["length = 10", "bending_stiffness = 1.3020833333333333", "uniform = 1", "depth = 1"] {
            let name = key.split(' ').next().expect("a key");
            folder.write("scene.toml", EXAMPLE.replace(key, &format!("{name} = {number}")));
            let Run { code, err, .. } = folder.run("solve scene.toml");
            assert!(matches!(code, Some(0..=2)) && !err.contains("panicked"), "{key} {number}: {code:?} {err}");
            assert_eq!(code == Some(2), !err.is_empty(), "a message if and only if there is no answer: {err}");
        }
    }
}

#[test]
fn files_as_editors_of_all_kinds_leave_them() {
    let folder = Folder::new("editors");
    let answer = folder.json("solve example.toml --method force").2;
    let same = |name: &str, text: &[u8]| {
        folder.write(name, text);
        let (_, _, mut other) = folder.json(&format!("solve {name} --method force"));
        other["seconds"] = answer["seconds"].clone();
        assert_eq!(other, answer, "{name}");
    };
    same("no_newline.toml", EXAMPLE.trim_end().as_bytes());
    same("windows.toml", EXAMPLE.replace('\n', "\r\n").as_bytes());
    same("mark.toml", format!("\u{feff}{EXAMPLE}").as_bytes());
    folder.write("nul.toml", EXAMPLE.replace("Example", "Exam\0ple"));
    folder.write(
        "latin.toml",
        EXAMPLE
            .replace("Example", "P?lkki")
            .into_bytes()
            .iter()
            .map(|&b| if b == b'?' { 0xe4 } else { b })
            .collect::<Vec<u8>>(),
    );
    folder.write("mac.toml", EXAMPLE.replace('\n', "\r"));
    folder.write("utf16.toml", EXAMPLE.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>());
    check(&folder, "solve nul.toml", "not valid TOML");
    check(&folder, "solve latin.toml", "not UTF-8");
    check(&folder, "solve mac.toml", "not valid TOML");
    check(&folder, "solve utf16.toml", "not valid TOML");
}

#[test]
fn what_a_terminal_would_obey_is_not_passed_on() {
    let folder = Folder::new("terminal");
    folder.write("escape.toml", "[beam]\nlength = 10\nbending_stiffness = 1\nx = 1 # \u{9b}31m \u{85} ä\n");
    insta::assert_snapshot!(folder.refused("solve escape.toml"), @r##"
    error: unknown key "x" in `beam`
     --> escape.toml:4:1
      |
    4 | x = 1 # ·31m · ä
      | ^ expected one of `length`, `bending_stiffness`
    "##);
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_pipes() {
    let folder = Folder::new("devices");
    check(&folder, "solve /dev/zero", "it is larger than");
    check(&folder, "solve /dev/null", "the file is empty");
    let made = std::process::Command::new("mkfifo").arg(folder.path("pipe")).status().expect("mkfifo");
    assert!(made.success(), "a pipe");
    // Nobody ever writes to it.
    let run = folder.run("solve pipe");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    insta::assert_snapshot!(run.err.trim_end(), @"
    error: cannot read the scene: it is a named pipe, which may wait forever; standard input is `/dev/stdin`
    --> pipe
    ");
    let run = folder.run("solve example.toml --method force --csv pipe");
    assert!(run.err.contains("it is not a regular file"), "{}", run.err);
    let run = folder.run("solve example.toml --method force --csv /dev/full --plot beam.svg");
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("it is not a regular file") && !folder.path("beam.svg").exists(), "{}", run.err);

    let mut child = folder
        .command("solve /dev/stdin --method force --format json")
        .stdin(Stdio::from(fs::File::open(folder.path("example.toml")).expect("the example")))
        .stdout(Stdio::null())
        .spawn()
        .expect("the program starts");
    assert_eq!(child.wait().expect("it ends").code(), Some(0), "standard input is a file like others");
}

#[cfg(unix)]
#[test]
fn a_disk_that_fills_up_leaves_the_old_file() {
    let folder = Folder::new("full_disk");
    folder.write("nodes.csv", "what was there before");
    // The shell limits the size of files to a few blocks: writing ends with a signal, in the middle.
    let program = env!("CARGO_BIN_EXE_palkki");
    let script = format!(
        "ulimit -c 0; ulimit -f 2; exec {program} solve example.toml --method force --intervals 3000 --csv nodes.csv"
    );
    let output = std::process::Command::new("sh")
        .args(["-c", &script])
        .current_dir(folder.path(""))
        .output()
        .expect("the program runs");
    assert_ne!(output.status.code(), Some(0), "a file that is too large for the limit");
    assert!(output.stdout.is_empty(), "nothing is printed");
    assert_eq!(folder.read("nodes.csv"), "what was there before");
}

#[test]
fn every_subcommand_may_lose_its_reader() {
    let folder = Folder::new("readers");
    folder.write("forces.csv", "x,force\n2.5,1\n7.5,1\n");
    for arguments in ["compare example.toml", "certify example.toml forces.csv", "solve example.toml", "--help"] {
        let mut child =
            folder.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(!err.contains("panicked"), "{arguments}: {err}");
        assert!(matches!(output.status.code(), Some(0 | 1)), "{arguments}: {:?} {err}", output.status);
    }
}
