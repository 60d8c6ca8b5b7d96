//! The sliders of the page: places, texts and data. `sliders.js` draws them.

use std::fmt::Write as _;

use minijinja::context;

use super::super::{Rendered, template};
use crate::Cause;

/// A picture that the reader changes.
#[derive(Debug)]
struct Slider {
    /// Its name in the marker; `data/slider-<name>.csv` is what it shows.
    name: &'static str,
    title: &'static str,
    text: &'static str,
    label: &'static str,
}

const SLIDERS: [Slider; 2] = [
    Slider {
        name: "depth",
        title: "Try it: how deep the ground lies",
        text: "The deeper the flat ground, the less of the beam rests on it: first a zone touches, then mid-span alone, then \
               nothing. Every position is an exact answer by beam theory. The picture is drawn so that the ground stays \
               where it is; deflections are in proportion to its depth, and force arrows have one scale.",
        label: "Depth of the ground",
    },
    Slider {
        name: "grid",
        title: "Try it: how many intervals",
        text: "The paper's example by the force method. The force at the first node that touches jumps from grid to grid, \
               because it depends on where the nodes happen to lie. The resultant moves far less: it is the sum of all contact \
               forces of one half, less the pressure that beam theory has there.",
        label: "Number of intervals",
    },
];

/// What stands in a document where the page has a slider. Code hosts hide it.
pub(in crate::report) fn marker(name: &str) -> String {
    format!("<!-- slider: {name} -->")
}

/// The slider of a comment; nothing if it is no marker.
pub(super) fn of_marker(comment: &str) -> Result<String, Cause> {
    let found = SLIDERS.iter().find(|slider| marker(slider.name) == comment.trim());
    let Some(&Slider { name, title, text, label }) = found else { return Ok(String::new()) };
    template::filled(include_str!("slider.html"), context! { name, title, text, label })
}

/// The data of the sliders. Each slider has to be in the page once.
pub(super) fn data(rendered: &Rendered, articles: &str) -> Result<String, Cause> {
    let mut scripts = String::new();
    for Slider { name, .. } in SLIDERS {
        let count = articles.matches(&format!("<section class=\"slider\" id=\"slider-{name}\"")).count();
        if count != 1 {
            return Err(format!("{count} documents have the marker {} and not one", marker(name)).into());
        }
        let path = format!("data/slider-{name}.csv");
        let csv = rendered.get(&path).ok_or_else(|| format!("{path} is not made"))?;
        let _ = write!(scripts, "<script type=\"text/csv\" id=\"data-{name}\">\n{csv}</script>\n");
    }
    Ok(scripts)
}
