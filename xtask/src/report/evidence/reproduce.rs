//! How to reproduce: what the lock file and the tree say about themselves.

use std::fs;

use serde::{Deserialize, Serialize};

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::files;
use crate::report::study::Study;

/// The crates whose versions can change a number or a drawing of the report.
const NUMERICAL: [&str; 6] = ["nalgebra", "clarabel", "osqp", "libm", "plotters", "insta"];

#[derive(Debug, Serialize)]
struct Values {
    rust_version: String,
    versions: Vec<Package>,
    /// Names of the files in `report/scenes`.
    scenes: Vec<String>,
}

/// The part of `Cargo.lock` that is read.
#[derive(Debug, Deserialize)]
struct Lock {
    package: Vec<Package>,
}

#[derive(Debug, Deserialize, Serialize, PartialEq, Eq)]
struct Package {
    name: String,
    version: String,
}

/// The part of `Cargo.toml` that is read.
#[derive(Debug, Deserialize)]
struct Manifest {
    workspace: Workspace,
}

#[derive(Debug, Deserialize)]
struct Workspace {
    package: Shared,
}

#[derive(Debug, Deserialize)]
struct Shared {
    #[serde(rename = "rust-version")]
    rust_version: String,
}

#[derive(Debug, thiserror::Error, PartialEq, Eq)]
#[error("Cargo.lock must have one version of `{name}`, but has {count}")]
struct NotOneVersion {
    name: &'static str,
    count: usize,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let manifest: Manifest = toml::from_str(&fs::read_to_string(study.root.join("Cargo.toml"))?)?;
    let lock: Lock = toml::from_str(&fs::read_to_string(study.root.join("Cargo.lock"))?)?;
    let scenes = files::list(study.root, "report/scenes")?;
    let scenes = scenes.iter().filter_map(|path| path.strip_prefix("report/scenes/")).map(str::to_owned).collect();
    let rust_version = manifest.workspace.package.rust_version;
    Ok(Evidence::new(Values { rust_version, versions: versions(lock)?, scenes }))
}

/// The versions of [`NUMERICAL`], in that order.
fn versions(lock: Lock) -> Result<Vec<Package>, NotOneVersion> {
    let mut found = Vec::new();
    let mut packages = lock.package;
    for name in NUMERICAL {
        let of_name: Vec<Package> = packages.extract_if(.., |package| package.name == name).collect();
        match <[Package; 1]>::try_from(of_name) {
            Ok([package]) => found.push(package),
            Err(others) => return Err(NotOneVersion { name, count: others.len() }),
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lock(names: &[&str]) -> Lock {
        let package = |name: &&str| Package { name: (*name).to_owned(), version: "1.0.0".to_owned() };
        Lock { package: names.iter().map(package).collect() }
    }

    #[test]
    fn one_version_of_each_is_listed() {
        let mut names = NUMERICAL.to_vec();
        names.push("other");
        let found = versions(lock(&names)).expect("each is there once");
        assert_eq!(found.iter().map(|package| package.name.as_str()).collect::<Vec<_>>(), NUMERICAL, "in our order");
    }

    #[test]
    fn none_and_two_are_refused() {
        assert_eq!(versions(lock(&[])), Err(NotOneVersion { name: "nalgebra", count: 0 }), "none");
        assert_eq!(versions(lock(&["nalgebra", "nalgebra"])), Err(NotOneVersion { name: "nalgebra", count: 2 }), "two");
    }
}
