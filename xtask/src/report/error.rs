//! Why there is no report.

use std::io;
use std::path::PathBuf;

use super::files::Stale;
use crate::Cause;

/// Why the report was not made, or does not pass.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Error {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("the evidence `{subject}`: {source}")]
    Evidence { subject: &'static str, source: Cause },
    #[error("report/templates/{document}.md: {source}")]
    Template { document: &'static str, source: minijinja::Error },
    #[error("report/{document} has two headings `{heading}`; links to them would be ambiguous")]
    TwoHeadings { document: String, heading: String },
    #[error("{path} is no template of a document: add it to DOCUMENTS in xtask/src/report/mod.rs, or remove it")]
    UnknownTemplate { path: String },
    #[error("the evidence `{subject}` makes {path}, which another makes too")]
    TwoFilesOfOneName { subject: &'static str, path: String },
    #[error("{path} is made, but no document shows or links it")]
    NotShown { path: String },
    #[error("report/{document} links to `{target}`, which does not exist")]
    DeadLink { document: String, target: String },
    #[error("report/index.html: {source}")]
    Page { source: Cause },
    #[error("{path}: {source}")]
    Excerpt { path: String, source: Cause },
    #[error("{path} marks the excerpt `{name}`, which no document shows")]
    ExcerptNotShown { path: String, name: String },
    #[error("{path} has no <{element}>: a screen reader has nothing to say about it")]
    NotDescribed { path: String, element: &'static str },
    #[error("report/ is not what the code computes now:\n{}\nrun `cargo xtask report` and commit the result", list(.0))]
    Stale(Vec<Stale>),
}

fn list(stale: &[Stale]) -> String {
    let lines: Vec<String> = stale.iter().map(|stale| format!("  {stale}")).collect();
    lines.join("\n")
}
