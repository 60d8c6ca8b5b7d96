//! `cargo xtask mutants`: a random sample of small changes of the code, each of which some test ought to notice.
//!
//! All changes of the sample are compiled into one copy of the repository, each behind a switch that an environment variable sets.
//! A mutant therefore costs the time of its tests and not that of a compiler. The kernel has a list of its own.

mod sites;

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde::Serialize;

use self::sites::Site;
use crate::{Cause, data, tell};

/// Where the copy is built and where the list of the sample goes, below the root.
const PLACE: &str = "target/mutants";

/// The variable that says which mutant is switched on.
const SWITCH: &str = "PALKKI_MUTANT";

/// Read once in a process: a mutant costs a comparison.
const READ_SWITCH: &str = r#"
#[doc(hidden)]
#[allow(missing_docs, unreachable_pub, dead_code)]
pub fn mutated(mutant: usize) -> bool {
    static ON: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    *ON.get_or_init(|| std::env::var("PALKKI_MUTANT").ok().and_then(|on| on.parse().ok()).unwrap_or(0)) == mutant
}
"#;

/// A run that takes so many times as long as the one without a mutant does not end.
const PATIENCE: u32 = 4;

/// A mutant of the sample.
#[derive(Debug, Clone)]
struct Mutant {
    number: usize,
    file: String,
    site: Site,
}

/// What became of it, as a line of the file.
#[derive(Debug, Serialize)]
struct Line {
    number: usize,
    file: String,
    line: usize,
    change: String,
    killed_by: String,
}

/// Makes a sample of so many mutants and runs the tests on each of them.
pub(crate) fn run(root: &Path, sample: usize, seed: u64, only: &str) -> Result<(), Cause> {
    let place = root.join(PLACE);
    let tree = place.join("tree");
    let _ = fs::remove_dir_all(&tree);
    copy(root, &tree)?;
    let mut mutants = drawn(root, sample, seed, only)?;
    tell(&format!("building a program with {} mutants", mutants.len()));
    let programs = loop {
        write(root, &tree, &mutants)?;
        match build(&tree, &place)? {
            Built::Programs(programs) => break programs,
            Built::Not(broken) => {
                let before = mutants.len();
                mutants.retain(|mutant| !broken.iter().any(|at| mutant.holds(&tree, at)));
                tell(&format!("{} changes do not compile", before - mutants.len()));
                if mutants.len() == before {
                    return Err(format!("the copy does not build, and no mutant is the cause: {broken:?}").into());
                }
            }
        }
    };
    let suites: Vec<Suite> =
        programs.into_iter().map(|program| Suite::new(program, &tree)).collect::<Result<_, _>>()?;
    let mut lines: Vec<Line> = Vec::new();
    for mutant in &mutants {
        let mut killer = None;
        for suite in &suites {
            if killer.is_none() {
                killer = suite.killer(&tree, mutant.number)?;
            }
        }
        let killed_by = killer.unwrap_or_default();
        let by = if killed_by.is_empty() { "LIVES" } else { killed_by.as_str() };
        tell(&format!("{}:{} {}: {by}", mutant.file, mutant.site.line, mutant.site.what));
        let (file, change) = (mutant.file.clone(), mutant.site.what.clone());
        lines.push(Line { number: mutant.number, file, line: mutant.site.line, change, killed_by });
        data::write(&place, "mutants.csv", &lines)?;
    }
    let killed = lines.iter().filter(|line| !line.killed_by.is_empty()).count();
    println!("{killed} of {} mutants are killed; {PLACE}/mutants.csv has them all", lines.len());
    Ok(())
}

/// Copies what the repository holds.
fn copy(root: &Path, tree: &Path) -> Result<(), Cause> {
    let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(root).output()?;
    for path in String::from_utf8(listed.stdout)?.split_terminator('\0') {
        let to = tree.join(path);
        fs::create_dir_all(to.parent().expect("a path below the tree"))?;
        fs::copy(root.join(path), to).map_err(|error| format!("{path}: {error}"))?;
    }
    Ok(())
}

/// A sample of sites, none inside another one. The same seed draws the same sample of the same tree.
fn drawn(root: &Path, sample: usize, seed: u64, only: &str) -> Result<Vec<Mutant>, Cause> {
    let listed = Command::new("git").args(["ls-files", "src/*.rs"]).current_dir(root).output()?;
    let mut all = Vec::new();
    for file in String::from_utf8(listed.stdout)?.lines() {
        if !file.starts_with(only)
            || file.starts_with("src/certificate/kernel")
            || file.ends_with("tests.rs")
            || file.contains("/tests/")
        {
            continue;
        }
        let source = fs::read_to_string(root.join(file))?;
        let sites = sites::of(&source).map_err(|error| format!("{file}: {error}"))?;
        all.extend(sites.into_iter().map(|site| Mutant { number: 0, file: file.to_owned(), site }));
    }
    tell(&format!("{} changes are possible", all.len()));
    let mut random = palkki_evidence::random::Random::new(seed);
    let mut chosen: Vec<Mutant> = Vec::new();
    while chosen.len() < sample && !all.is_empty() {
        let mutant = all.swap_remove(random.below(all.len()));
        let (file, bytes) = (&mutant.file, &mutant.site.bytes);
        let apart = |other: &Mutant| {
            other.file != *file || other.site.bytes.end <= bytes.start || bytes.end <= other.site.bytes.start
        };
        if chosen.iter().all(apart) {
            chosen.push(mutant);
        }
    }
    chosen.sort_by(|a, b| (&a.file, a.site.bytes.start).cmp(&(&b.file, b.site.bytes.start)));
    chosen.iter_mut().zip(1..).for_each(|(mutant, number)| mutant.number = number);
    Ok(chosen)
}

/// Writes all sources with their switches into the copy.
fn write(root: &Path, tree: &Path, mutants: &[Mutant]) -> Result<(), Cause> {
    let mut files: BTreeMap<&str, Vec<&Mutant>> =
        BTreeMap::from([("src/lib.rs", Vec::new()), ("src/main.rs", Vec::new())]);
    mutants.iter().for_each(|mutant| files.entry(&mutant.file).or_default().push(mutant));
    // A file whose mutants have all been taken back has its old text again.
    copy(root, tree)?;
    for (file, here) in files {
        let mut text = fs::read_to_string(root.join(file))?;
        for mutant in here.iter().rev() {
            let switched = mutant.site.switched(&text, mutant.number);
            text.replace_range(mutant.site.bytes.clone(), &switched);
        }
        if matches!(file, "src/lib.rs" | "src/main.rs") {
            text.push_str(READ_SWITCH);
        }
        fs::write(tree.join(file), text)?;
    }
    Ok(())
}

/// A place that the compiler names: file and line.
type At = (String, usize);

impl Mutant {
    /// Whether the switch of this mutant stands in this line of the copy.
    fn holds(&self, tree: &Path, (file, line): &At) -> bool {
        let switch = format!("crate::mutated({})", self.number);
        let here = || fs::read_to_string(tree.join(file)).unwrap_or_default();
        // A change may be longer than a line: the switch that stands in the line, or the last one before it.
        *file == self.file
            && here()
                .lines()
                .take(*line)
                .filter(|text| text.contains("crate::mutated("))
                .last()
                .is_some_and(|text| text.contains(&switch))
    }
}

enum Built {
    /// The test programs and, last, the program that makes the report.
    Programs(Vec<PathBuf>),
    Not(Vec<At>),
}

fn build(tree: &Path, place: &Path) -> Result<Built, Cause> {
    let target = place.join("build");
    let output = Command::new("cargo")
        .args(["test", "--no-run", "--locked", "--lib", "--bins", "--test", "acceptance", "--message-format=json"])
        .current_dir(tree)
        .env("CARGO_TARGET_DIR", &target)
        .env("RUSTFLAGS", "-Awarnings")
        .stderr(Stdio::null())
        .output()?;
    let (mut programs, mut broken) = (Vec::new(), Vec::new());
    for line in String::from_utf8(output.stdout)?.lines() {
        let message: serde_json::Value = serde_json::from_str(line)?;
        if let Some(program) = message["executable"].as_str().filter(|_| message["profile"]["test"] == true) {
            programs.push(PathBuf::from(program));
        }
        if message["message"]["level"] == "error" {
            let spans = message["message"]["spans"].as_array().into_iter().flatten();
            broken.extend(spans.filter_map(|span| {
                let line = usize::try_from(span["line_start"].as_u64()?).ok()?;
                Some((span["file_name"].as_str()?.to_owned(), line))
            }));
        }
    }
    if !output.status.success() {
        return Ok(Built::Not(broken));
    }
    // Unit tests first: they are quick.
    programs.sort_by_key(|program| {
        program.file_name().is_some_and(|name| name.to_string_lossy().starts_with("acceptance"))
    });
    let report = Command::new("cargo")
        .args(["build", "--package", "xtask", "--locked"])
        .current_dir(tree)
        .env("CARGO_TARGET_DIR", &target)
        .env("RUSTFLAGS", "-Awarnings")
        .status()?;
    if !report.success() {
        return Err("the program that makes the report does not build".into());
    }
    programs.push(target.join("debug/xtask"));
    Ok(Built::Programs(programs))
}

/// A program that tests, and how it ends without a mutant.
struct Suite {
    program: PathBuf,
    arguments: Vec<String>,
    /// What it complains of because the sources of the copy are not those of the repository.
    complaints: Vec<String>,
    patience: Duration,
}

impl Suite {
    fn new(program: PathBuf, tree: &Path) -> Result<Self, Cause> {
        let report = program.file_name().is_some_and(|name| name == "xtask");
        let arguments = if report { vec!["report".to_owned(), "--check".to_owned()] } else { Vec::new() };
        let mut suite = Self { program, arguments, complaints: Vec::new(), patience: Duration::from_secs(3600) };
        let begun = Instant::now();
        suite.complaints = suite.run(tree, 0, false)?;
        if !report {
            suite.arguments.extend(suite.complaints.iter().flat_map(|test| ["--skip".to_owned(), test.clone()]));
        }
        suite.patience = PATIENCE * begun.elapsed() + Duration::from_secs(20);
        tell(&format!("{}: {:.0?}, without {:?}", suite.program.display(), begun.elapsed(), suite.complaints));
        Ok(suite)
    }

    /// What this program says against a mutant first.
    fn killer(&self, tree: &Path, mutant: usize) -> Result<Option<String>, Cause> {
        let complaints = self.run(tree, mutant, true)?;
        Ok(complaints.into_iter().find(|complaint| !self.complaints.contains(complaint)))
    }

    /// Tests that fail and documents that are not up to date, all of them or, at the first, no more.
    fn run(&self, tree: &Path, mutant: usize, stop: bool) -> Result<Vec<String>, Cause> {
        let mut child = Command::new(&self.program)
            .args(&self.arguments)
            .current_dir(tree)
            .env(SWITCH, mutant.to_string())
            .env("INSTA_UPDATE", "no")
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let (send, lines) = channel();
        let [output, errors]: [Box<dyn Read + Send>; 2] =
            [Box::new(child.stdout.take().ok_or("no output")?), Box::new(child.stderr.take().ok_or("no errors")?)];
        for stream in [output, errors] {
            let send = send.clone();
            thread::spawn(move || {
                BufReader::new(stream).lines().map_while(Result::ok).try_for_each(|line| send.send(line))
            });
        }
        drop(send);
        let end = Instant::now() + self.patience;
        let mut complaints = Vec::new();
        loop {
            match lines.recv_timeout(end.saturating_duration_since(Instant::now())) {
                Ok(line) => complaints.extend(complaint(&line)),
                Err(RecvTimeoutError::Timeout) => complaints.push("does not end".to_owned()),
                Err(RecvTimeoutError::Disconnected) => {
                    let status = child.wait()?;
                    if !status.success() && complaints.is_empty() {
                        complaints.push(format!("{status}"));
                    }
                    return Ok(complaints);
                }
            }
            if complaints.last().is_some_and(|last| last == "does not end")
                || stop && !complaints.iter().all(|c| self.complaints.contains(c))
            {
                child.kill()?;
                child.wait()?;
                return Ok(complaints);
            }
        }
    }
}

/// What a line of a program's output complains of.
fn complaint(line: &str) -> Option<String> {
    let failed = line.strip_prefix("test ").and_then(|line| line.strip_suffix(" ... FAILED"));
    let stale = || ["stale: ", "missing: ", "left over: "].iter().find_map(|word| line.trim().strip_prefix(word));
    failed.map(|test| test.trim_end_matches(" - should panic")).or_else(stale).map(str::to_owned)
}
