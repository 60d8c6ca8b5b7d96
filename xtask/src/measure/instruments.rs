//! What a measurement has to know of the machine: where it was made, and how much memory a process has in use at the most.
//! Where the system does not say (no `/proc`), there is no number.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What a program prints, without the end of the line; nothing if it cannot be run.
fn told(root: &Path, program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).current_dir(root).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The commit that is measured; with a word if the code that is measured is not as it was committed.
fn commit(root: &Path) -> String {
    let Some(hash) = told(root, "git", &["rev-parse", "--short=10", "HEAD"]) else { return "unknown".to_owned() };
    let changed = told(root, "git", &["status", "--porcelain", "--", "src", "tests/evidence", "xtask", "Cargo.lock"]);
    if changed.is_none_or(|changed| !changed.is_empty()) { format!("{hash} with changes") } else { hash }
}

/// One line for each thing that can move a time.
pub(super) fn describe(root: &Path) -> Vec<String> {
    let cpu = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(':').map(|(_, name)| name.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let rustc = told(root, "rustc", &["--version"]);
    let lock = fs::read_to_string(root.join("Cargo.lock")).unwrap_or_default();
    let version = |name: &str| {
        let start = lock.find(&format!("name = \"{name}\"\n"))?;
        lock[start..].lines().nth(1)?.split('"').nth(1).map(str::to_owned)
    };
    let versions = ["clarabel", "osqp", "nalgebra"].map(|name| format!("{name} {}", version(name).unwrap_or_default()));
    vec![
        format!("commit: {}", commit(root)),
        format!("date: {}", told(root, "date", &["-u", "+%F"]).unwrap_or_else(|| "unknown".to_owned())),
        format!(
            "machine: {}, {cores} cores, {}",
            cpu.unwrap_or_else(|| "unknown processor".to_owned()),
            std::env::consts::ARCH
        ),
        format!("compiler: {}", rustc.unwrap_or_else(|| "unknown".to_owned())),
        format!("libraries: {}", versions.join(", ")),
    ]
}

/// These lines at the head of a file of measurements.
pub(super) fn heading(described: &[String]) -> String {
    described.iter().map(|line| format!("# {line}\n")).collect()
}

/// The lines that [`heading`] wrote at the head of a text.
pub(crate) fn described(text: &str) -> Vec<String> {
    text.lines().filter_map(|line| line.strip_prefix("# ")).map(str::to_owned).collect()
}

/// The same for templates: `commit`, `date`, `machine`, `compiler` and `libraries`.
pub(crate) fn provenance(described: &[String]) -> minijinja::Value {
    minijinja::Value::from_pairs(described.iter().filter_map(|line| line.split_once(": ")))
}

/// Kilobytes that a process has had in use at the most: the line `VmHWM:   123456 kB` of its status.
pub(super) fn high_water_mark(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::high_water_mark;

    #[test]
    fn the_high_water_mark_is_read() {
        assert_eq!(high_water_mark("Name:\tx\nVmHWM:\t   10548 kB\nVmRSS:\t 1 kB\n"), Some(10_548));
        assert_eq!(high_water_mark("Name:\tx\n"), None, "another system");
    }
}
