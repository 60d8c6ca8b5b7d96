//! The program as it is run: exit codes, standard output, files, JSON. The contract is what scripts rely on.

mod body;
mod body_forms;
mod certify;
mod compare;
mod exact;
mod forces;
mod help;
mod hostile;
mod json;
mod layouts;
mod output;
mod proof;
mod refinement;
mod scene_file;
mod shown;
mod steady;
mod streams;
mod sweep;
mod told;
#[cfg(unix)]
mod untrusted;
mod warnings;
mod words;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
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

/// A folder of its own for one test of one process, with the scenes above in it; it goes when the test has passed.
struct Folder(PathBuf);

/// What a run of the program came to.
struct Run {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Folder {
    fn new(test: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("command_line");
        let folder = folder.join(format!("{test}.{}", std::process::id()));
        // What an earlier process of that number left.
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

impl Drop for Folder {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            // What is left behind harms nobody.
            let _ = fs::remove_dir_all(&self.0);
        }
    }
}

/// A pipe that nobody reads any more.
fn no_reader() -> std::io::PipeWriter {
    std::io::pipe().expect("a pipe").1
}

/// A number of an answer in JSON.
#[track_caller]
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn scene(text: &str) -> Scene {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a valid scene")
}
