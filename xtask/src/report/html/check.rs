//! What the page promises: it loads nothing, and every link inside it leads somewhere.

use std::collections::BTreeSet;

use crate::Cause;

/// Elements that load something, whatever their attributes.
const LOADERS: [&str; 11] =
    ["link", "img", "image", "iframe", "frame", "object", "embed", "source", "video", "audio", "base"];
/// Attributes that load something.
const LOADS: [&str; 6] = ["src", "srcset", "data", "poster", "background", "xlink:href"];

/// Checks the made page.
pub(super) fn check(page: &str) -> Result<(), Cause> {
    let (mut ids, mut targets) = (BTreeSet::new(), BTreeSet::new());
    for (tag, text) in tags(page) {
        let element = tag.split(|c: char| c.is_whitespace() || c == '/').next().unwrap_or_default();
        let attributes: Vec<(&str, &str)> = attributes(tag).collect();
        let loads = LOADERS.contains(&element)
            || attributes.iter().any(|(name, _)| LOADS.contains(name))
            || attributes.iter().any(|(_, value)| fetches(value))
            || element == "style" && (fetches(text) || text.contains("@import"));
        if loads {
            return Err(format!("<{tag}> would load something").into());
        }
        for (name, value) in attributes {
            match (name, value.strip_prefix('#')) {
                ("id", _) if !ids.insert(value) => return Err(format!("there are two elements #{value}").into()),
                ("href", Some(target)) => drop(targets.insert(target)),
                _ => {}
            }
        }
    }
    match targets.difference(&ids).next() {
        Some(target) => Err(format!("a link leads to #{target}, which does not exist").into()),
        None => Ok(()),
    }
}

/// Whether a style or an attribute refers to something that is not in the page.
fn fetches(style: &str) -> bool {
    style.split("url(").skip(1).any(|target| !target.trim_start_matches(['"', '\'']).starts_with(['#']))
}

/// The opening tags with the text behind them; the text of a script or style has no tags.
fn tags(page: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = page;
    std::iter::from_fn(move || {
        loop {
            let (tag, behind) = rest.split_once('<')?.1.split_once('>')?;
            let end = ["script", "style"].iter().find(|name| tag.starts_with(*name)).map(|name| format!("</{name}"));
            let length = behind.find(end.as_deref().unwrap_or("<")).unwrap_or(behind.len());
            rest = &behind[length..];
            if !tag.starts_with(['/', '!']) {
                return Some((tag, &behind[..length]));
            }
        }
    })
}

/// The attributes of a tag, all of which are written as `name="value"`.
fn attributes(tag: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = tag;
    std::iter::from_fn(move || {
        let (before, value) = rest.split_once("=\"")?;
        let (value, after) = value.split_once('"')?;
        rest = after;
        Some((before.rsplit(char::is_whitespace).next().unwrap_or_default(), value))
    })
}

#[cfg(test)]
mod tests {
    use super::check;

    fn said(page: &str) -> String {
        check(page).err().map(|error| error.to_string()).unwrap_or_default()
    }

    #[test]
    fn a_page_that_keeps_to_itself_passes() {
        let page = "<!doctype html><style>a > b { color: red }</style><script>if (a < b) { c = '<img src=\"x\">' }</script>\
                    <h1 id=\"a\">id=\"a\"</h1><a href=\"#a\">x</a><a href=\"../src/lib.rs\">y</a>\
                    <g clip-path=\"url(#a)\"/>";
        assert_eq!(said(page), "");
    }

    #[test]
    fn what_loads_and_what_leads_nowhere_is_found() {
        for page in [
            "<img alt=\"\" src=\"x.png\">",
            "<script src=\"x.js\"></script>",
            "<link rel=\"stylesheet\" href=\"x.css\">",
            "<style>a { background: url(x.png) }</style>",
            "<style>@import 'x.css';</style>",
            "<p style=\"background: url('x.png')\">",
            "<iframe srcdoc=\"\">",
        ] {
            assert!(said(page).ends_with("would load something"), "{page}");
        }
        assert_eq!(said("<a href=\"#b\">x</a><i id=\"a\">"), "a link leads to #b, which does not exist");
        assert_eq!(said("<b id=\"a\"></b><i id=\"a\">"), "there are two elements #a");
    }
}
