//! Files that nobody means well with: huge, deep, endless, half written.

use std::fmt::Write as _;
use std::fs;
use std::time::{Duration, Instant};

use super::{EXAMPLE, Folder, Run, SURVEYED};

/// Longest that any of these runs may take, on a machine that is busy with other things as well: what is meant is that none of
/// them hangs, or takes time in the square of the size of a file.
const PATIENCE: Duration = Duration::from_secs(60);

/// Bytes of the longest message about a file of any size.
const LONGEST_MESSAGE: usize = 20_000;

/// Refused with exit code 2 and one message of bounded length that names the file.
#[track_caller]
pub(super) fn check(folder: &Folder, arguments: &str, says: &str) {
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
        fs::File::create(folder.path(name)).and_then(|file| file.set_len(600 << 20)).expect("a large file");
    }
    folder.write("surveyed.toml", SURVEYED);
    let too_large = |bytes: u64| format!("it is larger than {} bytes", bytes << 20);
    for (arguments, most) in
        [("solve scene.toml", 16), ("solve surveyed.toml", 512), ("certify example.toml forces.csv", 512)]
    {
        let Run { code, out, err } = folder.run(arguments);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{arguments}");
        assert!(err.contains(&too_large(most)), "{err}");
    }
}

/// A matrix is read line by line.
#[test]
fn a_line_of_a_matrix_may_have_4096_bytes() {
    let folder = Folder::new("long_line");
    super::body::known(&folder);
    let matrix = folder.read("K.mtx");
    let (first, rest) = matrix.split_once('\n').expect("lines");
    for (bytes, says) in [(4096, None), (4097, Some("line 2 is longer than 4096 bytes, the most that is read"))] {
        folder.write("K.mtx", format!("{first}\n%{}\n{rest}", " ".repeat(bytes - 2)));
        match says {
            Some(says) => check(&folder, "solve body.toml", says),
            None => assert_eq!(folder.run("solve body.toml").code, Some(0)),
        }
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
    let run = folder.run("solve surveyed.toml --format json");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "beam theory takes as many as there are");
    let start = Instant::now();
    let run = folder.run("solve surveyed.toml --method force --intervals 30");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "a grid takes as many as there are");
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
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
    insta::assert_snapshot!(folder.refused("solve escape.toml"), @r#"
    error: unknown key "x" in `beam`
     --> escape.toml:4:1
      |
    4 | x = 1 # ·31m · ä
      | ^ expected one of `length`, `bending_stiffness`, `shape`, `supports`, `joints`, `tension`
    "#);
}
