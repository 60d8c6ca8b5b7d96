//! A drawing as part of a page.

use palkki::plot::dark_rules;

use crate::Cause;

/// The rules of the drawings for dark surroundings, under the theme of the page instead of the system's. Paper stays light.
pub(super) fn style() -> String {
    let rules = dark_rules();
    format!(
        "@media screen {{\n:root[data-theme=dark] svg {{ {rules} }}\n@media (prefers-color-scheme: dark) {{ \
         :root:not([data-theme]) svg {{ {rules} }} }}\n}}\n"
    )
}

/// What a drawing begins with.
pub(super) const BEGIN: &str = "<p class=\"title\">";

/// A drawing in the colours of the page: title and notes as text, and each panel by itself, so that panels that stand side by side
/// stand one below the other where the page is narrow.
pub(super) fn inlined(svg: &str) -> Result<String, Cause> {
    let between =
        |from: &str, to: &str| svg.split_once(from).and_then(|(_, rest)| rest.split_once(to)).map(|cut| cut.0);
    let part = |name: &str, from, to| between(from, to).ok_or_else(|| format!("the drawing has no {name}"));
    let title = part("title", "<title id=\"title\">", "</title>")?;
    let description = part("description", "<desc id=\"desc\">", "</desc>")?;
    let font = part("font", " font-family=\"", ">")?;
    let [width, height] = sides(part("size", " viewBox=\"", "\"")?)?;
    let (mut panels, mut notes) = (String::new(), String::new());
    for (attribute, body) in svg.split("<g ").skip(1).filter_map(|group| group.split_once("</g>")?.0.split_once('>')) {
        if let Some(place) = attribute.strip_prefix("data-panel=") {
            let share = sides(place.trim_matches('"'))?[0] / width;
            panels += &format!("<svg viewBox={place} font-family=\"{font} style=\"--share:{share}\">{body}</svg>\n");
        } else if attribute == "class=\"note\"" {
            notes += &format!("<p class=\"note\">{}</p>\n", words(body));
        }
    }
    if panels.is_empty() {
        return Err("the drawing has no panel: `cargo xtask report` draws it anew".into());
    }
    Ok(format!(
        "{BEGIN}{title}</p>\n<div class=\"drawing\" role=\"img\" aria-label=\"{description}\" \
         style=\"--ratio:{}\">\n{panels}</div>\n{notes}",
        width / height
    ))
}

/// Width and height of a `viewBox`.
fn sides(place: &str) -> Result<[f64; 2], Cause> {
    let numbers: Vec<f64> = place.split(' ').map(str::parse).collect::<Result<_, _>>()?;
    numbers.get(2..4).and_then(|sides| sides.try_into().ok()).ok_or_else(|| format!("{place} is no place").into())
}

/// What is written in a part of a drawing, its lines joined.
fn words(body: &str) -> String {
    let texts = body.split("</text>").filter_map(|text| Some(text.rsplit_once('>')?.1.trim()));
    texts.collect::<Vec<_>>().join(" ")
}
