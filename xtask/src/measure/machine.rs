//! Where measurements come from: machine, compiler, dependencies.

use std::fs;
use std::path::Path;
use std::process::Command;

/// One line for each thing that can move a time.
pub(crate) fn describe(root: &Path) -> Vec<String> {
    let cpu = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(':').map(|(_, name)| name.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let rustc = Command::new("rustc").arg("--version").output().ok();
    let rustc = rustc.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    let lock = fs::read_to_string(root.join("Cargo.lock")).unwrap_or_default();
    let version = |name: &str| {
        let start = lock.find(&format!("name = \"{name}\"\n"))?;
        lock[start..].lines().nth(1)?.split('"').nth(1).map(str::to_owned)
    };
    let versions = ["clarabel", "osqp", "nalgebra"].map(|name| format!("{name} {}", version(name).unwrap_or_default()));
    vec![
        format!(
            "machine: {}, {cores} cores, {}",
            cpu.unwrap_or_else(|| "unknown processor".to_owned()),
            std::env::consts::ARCH
        ),
        format!("compiler: {}", rustc.unwrap_or_else(|| "unknown".to_owned())),
        format!("libraries: {}", versions.join(", ")),
    ]
}
