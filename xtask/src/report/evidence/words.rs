//! The words of the figures: title, description and legend, which are sections of `report/templates/figures.md`.

use std::collections::BTreeMap;
use std::path::Path;

use minijinja::Value;

use crate::Cause;
use crate::report::{files, template};

/// The file, below `report/templates`, without `.md`.
pub(in crate::report) const NAME: &str = "figures";

/// The words of one figure.
#[derive(Debug)]
pub(super) struct Words {
    pub(super) title: String,
    /// What follows the title: what a screen reader says of the figure.
    pub(super) description: String,
    /// The last part of it, if an axis shows that as well.
    pub(super) legend: String,
    /// What stands below the figure: the lines of the section that begin with `- `.
    pub(super) notes: Vec<String>,
}

/// The sections of the file, by the names of their figures.
pub(in crate::report) fn sections(root: &Path) -> Result<BTreeMap<String, String>, Cause> {
    let text = files::text(root, &format!("report/templates/{NAME}.md"))?;
    let sections = text.split("## ").skip(1).filter_map(|section| section.split_once('\n'));
    Ok(sections.map(|(name, text)| (name.to_owned(), text.to_owned())).collect())
}

impl Words {
    /// The section of a figure, with its values.
    pub(super) fn of(sections: &BTreeMap<String, String>, figure: &str, values: Value) -> Result<Self, Cause> {
        let section = sections.get(figure).ok_or_else(|| format!("{NAME}.md has no section `{figure}`"))?;
        let text = template::environment(BTreeMap::new())
            .render_named_str(&format!("{NAME}.md"), section, values)
            .map_err(|error| format!("{NAME}.md, `{figure}`: {error}"))?;
        let (notes, text): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.starts_with("- "));
        let notes = notes.iter().map(|note| note.trim_start_matches("- ").to_owned()).collect();
        let text = text.join("\n").trim().to_owned();
        let mut parts = text.split("\n\n").map(|part| part.trim().replace('\n', " "));
        let title = parts.next().unwrap_or_default();
        let parts: Vec<String> = parts.collect();
        Ok(Self { title, legend: parts.last().cloned().unwrap_or_default(), description: parts.join(" "), notes })
    }
}
