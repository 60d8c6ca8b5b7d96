//! A drawing as part of a page.

use palkki::plot::dark_rules;

/// The rules of the drawings for dark surroundings, under the theme of the page instead of the system's. Paper stays light.
pub(super) fn style() -> String {
    let rules = dark_rules();
    format!(
        "@media screen {{\n:root[data-theme=dark] svg {{ {rules} }}\n@media (prefers-color-scheme: dark) {{ \
         :root:not([data-theme]) svg {{ {rules} }} }}\n}}\n"
    )
}

/// A drawing whose ids begin with `name`, as wide as the page lets it be, in the colours of the page.
pub(super) fn inlined(svg: &str, name: &str) -> String {
    let svg = svg.find("<svg").map_or(svg, |start| &svg[start..]);
    let (head, body) = svg.split_once('>').unwrap_or((svg, ""));
    let mut head = head.to_owned();
    for attribute in [" width=\"", " height=\"", " xmlns=\""] {
        head = without(&head, attribute, "\"");
    }
    if let Some((before, rest)) = head.split_once("aria-labelledby=\"") {
        let (names, after) = rest.split_once('"').unwrap_or((rest, ""));
        let names: Vec<String> = names.split_whitespace().map(|id| format!("{name}-{id}")).collect();
        head = format!("{before}aria-labelledby=\"{}\"{after}", names.join(" "));
    }
    let body = without(body, "<style", "</style>").replace(" opacity=\"1\"", "");
    let body = [" id=\"", "url(#", "href=\"#"]
        .iter()
        .fold(body, |body, reference| body.replace(reference, &format!("{reference}{name}-")));
    format!("{head}>{}", body.trim_end())
}

/// The text without its first part that begins with `from` and ends with `to`.
fn without(text: &str, from: &str, to: &str) -> String {
    let cut = text.split_once(from).and_then(|(before, rest)| Some((before, rest.split_once(to)?.1)));
    cut.map_or_else(|| text.to_owned(), |(before, after)| format!("{before}{after}"))
}
