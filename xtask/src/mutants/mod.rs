//! `cargo xtask mutants`: a random sample of small changes of the code, each of which some test ought to notice.
//!
//! All changes of the sample are compiled into one copy of the repository, each behind a switch that an environment variable sets.
//! A mutant costs no compiler then, and only the tests that come to its switch, the quick ones first.
//! They are run in the order in which they were drawn: those of a run that is stopped are a random sample too, and `--again` goes on.
//! The kernel has a list of its own.

mod sites;

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use self::sites::Site;
use crate::{Cause, data, tell};

/// Where the copy is built and where the list of the sample goes, below the root.
const PLACE: &str = "target/mutants";

/// The list, there.
const LIST: &str = "mutants.csv";

/// The copy, there.
const TREE: &str = "tree";

/// The variable that says which mutant is switched on.
const SWITCH: &str = "PALKKI_MUTANT";

/// The variable that names the file in which a run without a mutant lists the switches that it comes to.
const REACHED: &str = "PALKKI_REACHED";

/// What the switches call.
const READ_SWITCH: &str = r#"
#[doc(hidden)]
#[allow(missing_docs, unreachable_pub, dead_code)]
pub fn mutated(mutant: usize) -> bool {
    use std::sync::atomic::{AtomicBool, Ordering};
    static ON: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    static SEEN: [AtomicBool; 4096] = [const { AtomicBool::new(false) }; 4096];
    let on = *ON.get_or_init(|| std::env::var("PALKKI_MUTANT").ok().and_then(|on| on.parse().ok()).unwrap_or(0));
    if on == 0 && !SEEN[mutant].load(Ordering::Relaxed) && !SEEN[mutant].swap(true, Ordering::Relaxed) {
        if let Ok(path) = std::env::var("PALKKI_REACHED") {
            let file = std::fs::OpenOptions::new().append(true).create(true).open(path);
            let _ = std::io::Write::write_all(&mut file.unwrap(), format!("{mutant}\n").as_bytes());
        }
    }
    on == mutant
}
"#;

/// A run that takes so many times as long as it took without a mutant, and this much longer, does not end.
const PATIENCE: (u32, Duration) = (6, Duration::from_secs(30));

/// What is asked for.
#[derive(Debug, clap::Args)]
pub(crate) struct Wish {
    #[arg(long, default_value_t = 200)]
    sample: usize,
    #[arg(long, default_value_t = 1984)]
    seed: u64,
    /// Only files whose path begins so.
    #[arg(long, default_value = "src/")]
    only: String,
    /// Only mutants that the last run did not kill.
    #[arg(long)]
    again: bool,
    /// Only tests whose name has this in it, or another one of these.
    #[arg(long)]
    test: Vec<String>,
}

/// A mutant of the sample.
#[derive(Debug, Clone)]
struct Mutant {
    number: usize,
    file: String,
    site: Site,
}

/// What became of it, as a line of the file.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Line {
    number: usize,
    file: String,
    line: usize,
    change: String,
    killed_by: String,
}

/// Makes a sample of so many mutants and runs the tests on each of them, or only on those that the last run did not kill.
pub(crate) fn run(root: &Path, wish: &Wish) -> Result<(), Cause> {
    let Wish { sample, seed, ref only, again, ref test } = *wish;
    let commit = Command::new("git").args(["describe", "--always", "--dirty"]).current_dir(root).output()?;
    let from = format!("seed {seed}, commit {}", String::from_utf8(commit.stdout)?.trim());
    let place = root.join(PLACE);
    let tree = place.join(TREE);
    let before: Vec<Line> = if again { data::read(&place, LIST)?.1 } else { Vec::new() };
    let _ = fs::remove_dir_all(&tree);
    copy(root, &tree)?;
    let mut mutants = drawn(root, sample, seed, only)?;
    tell(&format!("building a program with {} mutants", mutants.len()));
    let programs = loop {
        write(root, &tree, &mutants)?;
        match build(&tree, &place)? {
            Ok(programs) => break programs,
            Err(broken) => {
                let before = mutants.len();
                mutants.retain(|mutant| !broken.iter().any(|at| mutant.holds(&tree, at)));
                tell(&format!("{} changes do not compile", before - mutants.len()));
                if mutants.len() == before {
                    return Err(format!("the copy does not build, and no mutant is the cause: {broken:?}").into());
                }
            }
        }
    };
    let drawn = mutants.len();
    // Some tests read the sources, and the report shows lines of them.
    copy(root, &tree)?;
    let tests = Test::all(&programs, &place, test)?;
    let old = |new: &Line| {
        before.iter().find(|old| (old.number, &old.file, &old.change) == (new.number, &new.file, &new.change)).cloned()
    };
    // Some tests alone do not say that a mutant lives.
    mutants.retain(|mutant| !again || test.is_empty() || old(&mutant.line()).is_some());
    let of = |lines: &[Line]| {
        let killed = lines.iter().filter(|line| !line.killed_by.is_empty()).count();
        format!("{from}: {killed} killed of {} run, of {drawn} that compile", lines.len())
    };
    let mut lines: Vec<Line> = Vec::new();
    for mutant in &mutants {
        let mut line = mutant.line();
        line.killed_by = match old(&line).filter(|old| !old.killed_by.is_empty()) {
            Some(old) => old.killed_by,
            None => killer(&tests, &tree, mutant.number)?.unwrap_or_default(),
        };
        lines.push(line.clone());
        let Line { file, line, change, killed_by: by, .. } = line;
        let by = if by.is_empty() { "LIVES" } else { &by };
        tell(&format!("{file}:{line} {change}: {by}; {}", of(&lines)));
        // What is not run yet is in the list as it was.
        let rest = mutants[lines.len()..].iter().filter_map(|mutant| old(&mutant.line()));
        data::write(&place, LIST, &lines.iter().cloned().chain(rest).collect::<Vec<_>>())?;
    }
    println!("| file | change | why it lives |\n|---|---|---|");
    for Line { file, line, change, .. } in lines.iter().filter(|line| line.killed_by.is_empty()) {
        println!("| `{file}:{line}` | {change} | |");
    }
    println!("{}", of(&lines));
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

/// A sample of sites, none inside another one, as they were drawn. The same seed draws the same sample of the same tree.
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
    for (file, mut here) in files {
        here.sort_by_key(|mutant| Reverse(mutant.site.bytes.start));
        let mut text = fs::read_to_string(root.join(file))?;
        for mutant in here {
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
    fn line(&self) -> Line {
        let (file, change) = (self.file.clone(), self.site.what.clone());
        Line { number: self.number, file, line: self.site.line, change, killed_by: String::new() }
    }

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

/// The test programs, or what does not compile.
fn build(tree: &Path, place: &Path) -> Result<Result<Vec<PathBuf>, Vec<At>>, Cause> {
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
    Ok(if output.status.success() { Ok(programs) } else { Err(broken) })
}

/// A test, as it is without a mutant.
struct Test {
    program: PathBuf,
    name: String,
    takes: Duration,
    /// Mutants whose switch it comes to.
    reaches: BTreeSet<usize>,
}

impl Test {
    /// All tests of such a name that pass, the quick ones first.
    fn all(programs: &[PathBuf], place: &Path, wanted: &[String]) -> Result<Vec<Self>, Cause> {
        let begun = Instant::now();
        let mut tests = Vec::new();
        for program in programs {
            let listed = Command::new(program).args(["--list", "--format", "terse"]).output()?;
            let names = String::from_utf8(listed.stdout)?;
            tests.extend(
                names
                    .lines()
                    .filter_map(|line| line.strip_suffix(": test"))
                    .filter(|name| wanted.is_empty() || wanted.iter().any(|part| name.contains(part)))
                    .map(|name| Self {
                        program: program.clone(),
                        name: name.to_owned(),
                        takes: Duration::MAX,
                        reaches: BTreeSet::new(),
                    }),
            );
        }
        let queue = Mutex::new(tests.iter_mut().enumerate());
        let next = || queue.lock().ok()?.next();
        thread::scope(|scope| {
            for _ in 0..thread::available_parallelism().map_or(1, |cores| cores.get()) {
                scope.spawn(|| {
                    while let Some((i, test)) = next() {
                        if let Err(error) = test.measure(&place.join(TREE), &place.join(format!("reached-{i}"))) {
                            tell(&format!("{} is left out: {error}", test.name));
                        }
                    }
                });
            }
        });
        tests.retain(|test| test.takes < Duration::MAX);
        tests.sort_by(|a, b| a.group().cmp(&b.group()));
        tell(&format!("{} tests pass without a mutant, in {:.0?}", tests.len(), begun.elapsed()));
        Ok(tests)
    }

    /// Tests that are run at once: of one program, and none takes five times as long as another one.
    fn group(&self) -> (u32, &Path) {
        (self.takes.as_millis().max(1).ilog(5), &self.program)
    }

    /// Its time and what it reaches.
    fn measure(&mut self, tree: &Path, list: &Path) -> Result<(), Cause> {
        let begun = Instant::now();
        fs::write(list, "")?;
        let output = program(&self.program, tree, 0).args(["--exact", &self.name]).env(REACHED, list).output()?;
        if !output.status.success() {
            return Err("it fails without a mutant".into());
        }
        self.reaches = fs::read_to_string(list)?.lines().map(str::parse).collect::<Result<_, _>>()?;
        self.takes = begun.elapsed();
        Ok(fs::remove_file(list)?)
    }
}

fn program(path: &Path, tree: &Path, mutant: usize) -> Command {
    let mut command = Command::new(path);
    command.current_dir(tree).env(SWITCH, mutant.to_string()).env("INSTA_UPDATE", "no").env("PALKKI_DRAW", "all");
    command
}

/// A test that fails with a mutant, of the first group that has one.
fn killer(tests: &[Test], tree: &Path, mutant: usize) -> Result<Option<String>, Cause> {
    let reaching: Vec<&Test> = tests.iter().filter(|test| test.reaches.contains(&mutant)).collect();
    for group in reaching.chunk_by(|a, b| a.group() == b.group()) {
        let killer = first_to_fail(program(&group[0].program, tree, mutant), group)?;
        if killer.is_some() {
            return Ok(killer);
        }
    }
    Ok(None)
}

/// The first of some tests of a program to fail.
fn first_to_fail(mut program: Command, tests: &[&Test]) -> Result<Option<String>, Cause> {
    program.arg("--exact").args(tests.iter().map(|test| &test.name)).stdout(Stdio::piped()).stderr(Stdio::null());
    // With the commands that a test starts: none of them goes on without it.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut program, 0);
    let mut child = program.spawn()?;
    let output = BufReader::new(child.stdout.take().ok_or("no output")?);
    let (send, lines) = channel();
    thread::spawn(move || output.lines().map_while(Result::ok).try_for_each(|line| send.send(line)));
    let end = Instant::now() + PATIENCE.0 * tests.iter().map(|test| test.takes).sum::<Duration>() + PATIENCE.1;
    let killer = loop {
        match lines.recv_timeout(end.saturating_duration_since(Instant::now())) {
            Ok(line) => {
                let failed = line.strip_prefix("test ").and_then(|line| line.strip_suffix(" ... FAILED"));
                if let Some(test) = failed {
                    break test.trim_end_matches(" - should panic").to_owned();
                }
            }
            Err(RecvTimeoutError::Timeout) => break "does not end".to_owned(),
            Err(RecvTimeoutError::Disconnected) => {
                let status = child.wait()?;
                return Ok((!status.success()).then(|| status.to_string()));
            }
        }
    };
    #[cfg(unix)]
    Command::new("kill").args(["-KILL", "--", &format!("-{}", child.id())]).stderr(Stdio::null()).status()?;
    child.kill()?;
    child.wait()?;
    Ok(Some(killer))
}
