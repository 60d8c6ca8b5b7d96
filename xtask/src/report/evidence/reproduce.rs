//! How to reproduce: what the lock file and the tree say about themselves.

mod references;

use std::fs;

use minijinja::context;
use serde::Deserialize;

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::files;
use crate::report::study::Study;
use crate::report::table::Table;

/// The crates whose versions can change a number or a line of the report.
const NUMERICAL: [&str; 5] = ["nalgebra", "clarabel", "osqp", "libm", "insta"];

/// The part of `Cargo.lock` that is read.
#[derive(Debug, Deserialize)]
struct Lock {
    package: Vec<Package>,
}

#[derive(Debug, Deserialize)]
struct Package {
    name: String,
    version: String,
}

/// The part of `Cargo.toml` that is read.
#[derive(Debug, Deserialize)]
struct Manifest {
    workspace: Workspace,
    package: Package,
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
    references::check(study.root)?;
    let manifest: Manifest = toml::from_str(&fs::read_to_string(study.root.join("Cargo.toml"))?)?;
    let lock: Lock = toml::from_str(&fs::read_to_string(study.root.join("Cargo.lock"))?)?;
    let scenes = files::list(study.root, "report/scenes")?;
    let scenes: Vec<String> =
        scenes.iter().filter_map(|path| path.strip_prefix("report/")).map(str::to_owned).collect();
    Ok(Evidence::new(context! {
        version => manifest.package.version,
        rust_version => manifest.workspace.package.rust_version,
        versions => Table::new(["crate", "version"]).rows(versions(&lock)?),
        scenes,
    }))
}

/// The versions of [`NUMERICAL`], in that order.
fn versions(lock: &Lock) -> Result<Vec<[String; 2]>, NotOneVersion> {
    let version = |name: &'static str| {
        let of_name: Vec<&Package> = lock.package.iter().filter(|package| package.name == name).collect();
        match of_name[..] {
            [package] => Ok([name.to_owned(), package.version.clone()]),
            _ => Err(NotOneVersion { name, count: of_name.len() }),
        }
    };
    NUMERICAL.into_iter().map(version).collect()
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
        let found = versions(&lock(&[&NUMERICAL[..], &["other"]].concat())).expect("each is there once");
        assert!(found.iter().map(|[name, _]| name).eq(NUMERICAL.iter()), "in our order");
        assert_eq!(versions(&lock(&[])), Err(NotOneVersion { name: "nalgebra", count: 0 }), "none");
        assert_eq!(versions(&lock(&["nalgebra"; 2])), Err(NotOneVersion { name: "nalgebra", count: 2 }), "two");
    }
}
