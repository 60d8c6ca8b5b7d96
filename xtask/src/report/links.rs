//! Every file that is made is shown, every link leads somewhere, every drawing says what it shows, every excerpt is used.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use pulldown_cmark::{Event, Tag, TagEnd};

use super::excerpt::Excerpt;
use super::{Rendered, html};
use crate::Cause;

/// Checks the links of the documents against the files made with them and the files of the repository.
pub(super) fn check(root: &Path, rendered: &Rendered, excerpts: &BTreeMap<String, Excerpt>) -> Result<(), Cause> {
    let documents = || rendered.iter().filter(|(path, _)| path.ends_with(".md"));
    let mut places_of = BTreeMap::new();
    for (path, text) in documents() {
        places_of.insert(path.as_str(), places(path, text)?);
    }
    let mut linked = BTreeSet::new();
    for (path, (targets, _)) in &places_of {
        for target in targets.iter().filter(|target| !target.contains("://")) {
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { (*path).to_owned() } else { resolved(path, file) };
            let leads_somewhere = match places_of.get(file.as_str()) {
                Some((_, known)) => anchor.is_empty() || known.contains(anchor),
                None => rendered.contains_key(&file) || exists(root, &file),
            };
            if !leads_somewhere {
                return Err(format!("report/{path} links to `{target}`, which does not exist").into());
            }
            linked.insert(file);
        }
    }
    for (path, text) in rendered {
        if path != "README.md" && path != html::PATH && !linked.contains(path) {
            return Err(format!("{path} is made, but no document shows or links it").into());
        }
        for element in ["title", "desc"] {
            if path.ends_with(".svg") && !text.contains(&format!("<{element}")) {
                return Err(format!("{path} has no <{element}>: a screen reader has nothing to say about it").into());
            }
        }
    }
    match excerpts.iter().find(|(_, excerpt)| !documents().any(|(_, text)| text.contains(&excerpt.code))) {
        Some((name, excerpt)) => Err(format!("no document shows the excerpt `{name}` of {}", excerpt.path).into()),
        None => Ok(()),
    }
}

/// Whether a path relative to `report/` is one of the repository's, and not of the parts of the report that are made.
fn exists(root: &Path, file: &str) -> bool {
    let made = ["figures/", "data/", "pages/"].iter().any(|directory| file.starts_with(directory));
    !made && root.join("report").join(file).exists()
}

/// A link of a document as a path relative to `report/`.
pub(super) fn resolved(document: &str, link: &str) -> String {
    let mut parts: Vec<&str> = document.split('/').collect();
    parts.pop();
    for part in link.split('/') {
        match part {
            ".." if parts.last().is_some_and(|last| *last != "..") => drop(parts.pop()),
            "." | "" => {}
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

/// The targets of links and pictures of a document, and the anchors of its headings; two of the same name are an error.
fn places(document: &str, markdown: &str) -> Result<(Vec<String>, BTreeSet<String>), Cause> {
    let (mut targets, mut anchors, mut heading) = (Vec::new(), BTreeSet::new(), String::new());
    for event in html::events(markdown) {
        match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                targets.push(dest_url.to_string())
            }
            Event::Start(Tag::Heading { .. }) => heading.clear(),
            Event::End(TagEnd::Heading(_)) if !anchors.insert(anchor(&heading)) => {
                return Err(format!("report/{document} has two headings `{heading}`; links would be ambiguous").into());
            }
            other => heading.extend(html::text_of(&other)),
        }
    }
    Ok((targets, anchors))
}

/// The anchor that code hosts make of a heading: small letters, blanks as hyphens, signs dropped.
pub(super) fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(files: &[(&str, &str)]) -> Result<(), String> {
        let rendered = files.iter().map(|&(path, text)| (path.to_owned(), text.to_owned())).collect();
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        check(&root, &rendered, &BTreeMap::new()).map_err(|error| error.to_string())
    }

    #[test]
    fn links_that_lead_somewhere_pass() {
        let readme =
            "# A b\n[a](#a-b) ![f](figures/f.svg) [p](pages/p.md#c) [s](../src/lib.rs#L3) [w](https://example.org/x)";
        let page = "# C\n[d](../data/f.csv) [r](../README.md#a-b) [s](../../src/lib.rs)";
        let svg = "<svg><title>t</title><desc>d</desc></svg>";
        let files = [("README.md", readme), ("pages/p.md", page), ("figures/f.svg", svg), ("data/f.csv", "x\n1.0\n")];
        assert_eq!(checked(&files), Ok(()));
    }

    #[test]
    fn dead_links_and_hidden_files_are_found() {
        let dead = |target: &str| Err(format!("report/README.md links to `{target}`, which does not exist"));
        for target in ["#b", "figures/f.svg", "pages/p.md", "../src/no_such_file.rs"] {
            assert_eq!(checked(&[("README.md", &format!("# A\n[b]({target})"))]), dead(target));
        }
        let hidden = checked(&[("README.md", "# A"), ("data/f.csv", "")]);
        assert_eq!(hidden, Err("data/f.csv is made, but no document shows or links it".to_owned()));
        let mute = checked(&[("README.md", "![f](figures/f.svg)"), ("figures/f.svg", "<svg><title>t</title></svg>")]);
        assert!(mute.is_err_and(|message| message.contains("no <desc>")), "a figure without description");
        assert!(checked(&[("README.md", "# a\n## A")]).is_err(), "two anchors of one name");
        let unused = BTreeMap::from([("a".to_owned(), Excerpt { path: "src/a.rs".to_owned(), code: "x".to_owned() })]);
        let rendered = Rendered::from([("README.md".to_owned(), "# A".to_owned())]);
        assert!(check(Path::new("."), &rendered, &unused).is_err(), "an excerpt that is not shown");
    }

    #[test]
    fn code_blocks_have_no_headings_and_no_links() {
        let text = "# a\n```\n# b\n[x](y)\n```\n### c d\n#no";
        let (targets, anchors) = places("", text).expect("all differ");
        assert_eq!(anchors, BTreeSet::from(["a".to_owned(), "c-d".to_owned()]));
        assert_eq!(targets, [""; 0], "code is not prose");
    }
}
