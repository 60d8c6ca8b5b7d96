//! The paper in one file: `report/paper.rs` as a page, its documentation as prose and its code between, and what it prints.

use super::prelude::*;
use crate::report::files;

#[path = "../../../../report/paper.rs"]
#[expect(dead_code, reason = "the page shows what its table says")]
mod paper;

/// Where it is, below the root.
const PATH: &str = "report/paper.rs";

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let source = files::text(study.root, PATH)?;
    Ok(Evidence::new(context! { page => page(&source), lines => source.lines().count(), table => paper::results() }))
}

/// Documentation that begins a line is prose; what is between are blocks of code.
pub(super) fn page(source: &str) -> String {
    let mut page = String::new();
    let mut code = String::new();
    for line in source.lines().filter(|line| !line.starts_with("#![")) {
        let prose = ["//!", "///"].iter().find_map(|mark| line.strip_prefix(mark));
        match prose {
            // The page has a title of its own.
            Some(text) if text.starts_with(" # ") => {}
            Some(text) => {
                block(&mut page, &mut code);
                page += &format!("{}\n", text.strip_prefix(' ').unwrap_or(text));
            }
            None => code += &format!("{line}\n"),
        }
    }
    block(&mut page, &mut code);
    page
}

/// Ends a block of code, if there is one.
fn block(page: &mut String, code: &mut String) {
    let lines = std::mem::take(code);
    if !lines.trim().is_empty() {
        *page += &format!("\n```rust\n{}\n```\n\n", lines.trim_matches('\n'));
    }
}
