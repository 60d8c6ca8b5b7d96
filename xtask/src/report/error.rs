//! Why there is no report.

use std::error::Error as StdError;
use std::io;
use std::path::PathBuf;

use super::files::Stale;

/// What a chapter fails with.
pub(crate) type Cause = Box<dyn StdError + Send + Sync>;

/// Why the report was not made, or does not pass.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Error {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("the evidence of chapter {chapter}: {source}")]
    Evidence { chapter: &'static str, source: Cause },
    #[error("report/chapters/{chapter}.md: {source}")]
    Template { chapter: &'static str, source: minijinja::Error },
    #[error("report/chapters/{chapter}.md must begin with a heading `{expected}…`, but begins with `{line}`")]
    NoHeading { chapter: usize, expected: &'static str, line: String },
    #[error("the report has two headings `{heading}`; links to them would be ambiguous")]
    TwoHeadings { heading: String },
    #[error("{path} is no chapter: add it to CHAPTERS in xtask/src/report/chapters/mod.rs, or remove it")]
    UnknownChapter { path: String },
    #[error("chapter {chapter} makes {path}, which another chapter makes too")]
    TwoFilesOfOneName { chapter: &'static str, path: String },
    #[error("{path} is made, but no chapter shows or links it")]
    NotShown { path: String },
    #[error("the report links to `{target}`, which does not exist")]
    DeadLink { target: String },
    #[error("{path} has no <{element}>: a screen reader has nothing to say about it")]
    NotDescribed { path: String, element: &'static str },
    #[error("report/ is not what the code computes now:\n{}\nrun `cargo xtask report` and commit the result", list(.0))]
    Stale(Vec<Stale>),
}

fn list(stale: &[Stale]) -> String {
    let lines: Vec<String> = stale.iter().map(|stale| format!("  {stale}")).collect();
    lines.join("\n")
}
