//! The SVG document around a drawing: a nominal size, a title and a description for those who cannot see it, colours for dark
//! surroundings, and few words for each element.

use std::fmt::Write as _;

use super::canvas::{Canvas, TEXT};
use super::error::PlotError;
use super::palette::dark_rules;

/// Width of every drawing \[drawing units\]; plotters draws in whole units, so there are many.
pub(super) const WIDTH: u32 = 2400;

/// Drawing units for one pixel of the nominal size.
const UNITS_PER_PIXEL: u32 = 3;

/// A drawing of `height` as a document that stands alone.
pub(super) fn document(
    title: &str,
    description: &str,
    height: u32,
    draw: impl FnOnce(&Canvas<'_>) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    // Whole pixels, or the last row of them would be half empty.
    let height = height.div_ceil(UNITS_PER_PIXEL) * UNITS_PER_PIXEL;
    let mut drawn = String::new();
    let canvas = Canvas::new(&mut drawn, (WIDTH, height))?;
    draw(&canvas)?;
    canvas.present()?;
    // The backend opens the document without title and with one size for both; its first line makes room for ours.
    let body = drawn.split_once('\n').map_or("", |(_, body)| body);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {WIDTH} {height}\" \
         role=\"img\" aria-labelledby=\"title desc\" font-family=\"sans-serif\" font-size=\"{TEXT}\">\n\
         <title id=\"title\">{}</title>\n\
         <desc id=\"desc\">{}</desc>\n\
         <style>@media (prefers-color-scheme: dark) {{ {} }}</style>\n\
         {}",
        WIDTH / UNITS_PER_PIXEL,
        height / UNITS_PER_PIXEL,
        escaped(title),
        escaped(description),
        dark_rules(""),
        compact(body),
    ))
}

/// The elements of plotters' backend, one a line, without what is the default, and lines of one look that follow each other as
/// one path.
fn compact(body: &str) -> String {
    const POINTS: &str = " points=\"";
    let font_size = format!(" font-size=\"{TEXT}\"");
    // In texts quotes are escaped, so that nothing of them looks like an attribute.
    let defaults =
        [" opacity=\"1\"", " stroke=\"none\"", " font-family=\"sans-serif\"", " text-anchor=\"start\"", &font_size];
    let mut out = String::new();
    let mut open: Option<String> = None;
    for line in body.lines() {
        let line = defaults.iter().fold(line.replace(" \"/>", "\"/>"), |line, default| line.replace(default, ""));
        let path = line.strip_prefix("<polyline").and_then(|rest| rest.trim_end_matches("\"/>").split_once(POINTS));
        if let Some((look, points)) = path {
            if open.as_deref() != Some(look) {
                close(&mut out, &mut open);
                let _ = write!(out, "<path{look} d=\"");
                open = Some(look.to_owned());
            }
            let _ = write!(out, "M{points}");
            continue;
        }
        close(&mut out, &mut open);
        out.push_str(&line);
        // A text stands on a line between its tags.
        if line.starts_with("</text") || line.ends_with("/>") || line.starts_with("</svg") {
            out.push('\n');
        }
    }
    out
}

/// Ends a path, if one is open.
fn close(out: &mut String, open: &mut Option<String>) {
    if open.take().is_some() {
        out.push_str("\"/>\n");
    }
}

/// `text` as XML character data. Control characters, which XML cannot hold at all, become spaces.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{compact, document, escaped};

    #[test]
    fn xml_is_escaped() {
        assert_eq!(escaped("a < b & \"c\" > 'd'\u{7}"), "a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos; ");
    }

    #[test]
    fn lines_of_one_look_become_one_path() {
        let line =
            |y: i32| format!("<polyline fill=\"none\" opacity=\"1\" stroke=\"#000000\" points=\"0,{y} 9,{y} \"/>\n");
        let text = "<text x=\"1\" opacity=\"1\">\na opacity=&quot;1&quot;\n</text>\n";
        assert_eq!(
            compact(&format!("{}{}{text}</svg>\n", line(1), line(2))),
            "<path fill=\"none\" stroke=\"#000000\" d=\"M0,1 9,1M0,2 9,2\"/>\n<text x=\"1\">a opacity=&quot;1&quot;</text>\n</svg>\n"
        );
    }

    #[test]
    fn a_document_has_title_description_role_and_dark_colours() {
        let svg = document("p ≥ 0 & h ≥ 0", "a < b", 300, |_| Ok(())).expect("an empty sheet");
        assert!(svg.contains("<title id=\"title\">p ≥ 0 &amp; h ≥ 0</title>"), "{svg}");
        assert!(svg.contains("<desc id=\"desc\">a &lt; b</desc>"), "{svg}");
        assert!(svg.contains("prefers-color-scheme: dark"), "{svg}");
        assert!(svg.starts_with("<svg ") && svg.contains("role=\"img\"") && svg.ends_with("</svg>\n"), "{svg}");
    }
}
