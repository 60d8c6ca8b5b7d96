//! `cargo xtask fuzz`: the fuzz targets of `tests/fuzz`, built with instrumentation and run with a fixed seed from the corpus.
//!
//! libFuzzer comes with its crate and needs a C++ compiler; the instrumentation is a pass of the compiler itself, so that the
//! stable toolchain is enough.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::{Cause, tell};

/// The targets, each with a corpus of its name.
const TARGETS: [&str; 4] = ["scene", "survey", "forces", "matrix"];

/// Year of the paper.
const SEED: u64 = 1984;

/// Bytes of the longest text that is tried: twice the longest scene of the report.
const LONGEST: u64 = 1024;

/// Seconds after which a text counts as a hang.
const HANG: u64 = 10;

/// What cargo-fuzz sets, without the sanitizers, which have nothing to find where `unsafe` is forbidden.
const INSTRUMENTATION: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=4 --cfg=fuzzing";

/// Builds and runs all targets, and tells the counts; an error if one of them finds something.
pub(crate) fn run(root: &Path, runs: u64) -> Result<(), Cause> {
    let triple = host()?;
    let target = root.join("target/fuzz");
    tell("building the fuzz targets");
    // Naming the target keeps the instrumentation away from build scripts.
    let built = Command::new("cargo")
        .args(["build", "--release", "--bins", "--target", &triple])
        .current_dir(root.join("tests/fuzz"))
        .env("CARGO_TARGET_DIR", &target)
        .env("RUSTFLAGS", INSTRUMENTATION)
        .status()?;
    if !built.success() {
        return Err("the fuzz targets do not build".into());
    }
    let mut broken = false;
    for name in TARGETS {
        tell(&format!("{name}: {runs} executions"));
        let place = target.join("runs").join(name);
        // What an earlier run left; only the corpus of the repository counts, or the seed would not be fixed.
        let _ = fs::remove_dir_all(&place);
        let (found, failed) = (place.join("found"), place.join("failed"));
        for folder in [&found, &failed] {
            fs::create_dir_all(folder)?;
        }
        let corpus = root.join("tests/corpus").join(name);
        let output = Command::new(target.join(&triple).join("release").join(name))
            .args([&found, &corpus])
            .args([format!("-seed={SEED}"), format!("-runs={runs}"), format!("-max_len={LONGEST}")])
            .args([format!("-timeout={HANG}"), format!("-artifact_prefix={}/", failed.display())])
            .arg(format!("-dict={}", root.join("tests/fuzz/words.dict").display()))
            .arg("-print_final_stats=1")
            .output()?;
        let log = String::from_utf8_lossy(&output.stderr);
        let count = |place: &Path| fs::read_dir(place).map_or(0, Iterator::count);
        let failures = count(&failed);
        broken |= 0 < failures || !output.status.success();
        let executed = after(&log, "stat::number_of_executed_units:").unwrap_or(0);
        tell(&format!(
            "{name}: {executed} executions, {} edges, {failures} failures",
            after(&log, " cov: ").unwrap_or(0)
        ));
    }
    if broken {
        return Err(format!("texts that break something are in {}", target.join("runs").display()).into());
    }
    Ok(())
}

/// The number after the last occurrence of some words.
fn after(log: &str, words: &str) -> Option<u64> {
    log.rsplit_once(words)?.1.split_whitespace().next()?.parse().ok()
}

/// The platform that the compiler runs on.
fn host() -> Result<String, Cause> {
    let output = Command::new("rustc").arg("-vV").output()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines()
        .find_map(|line| line.strip_prefix("host: "))
        .map(str::to_owned)
        .ok_or_else(|| "rustc names no host".into())
}
