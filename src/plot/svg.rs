//! The SVG document around a drawing: a nominal size, a title and a description for those who cannot see it.

use std::fmt::Write as _;

use super::canvas::Canvas;
use super::error::PlotError;

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
    let mut drawn = String::new();
    let canvas = Canvas::new(&mut drawn, (WIDTH, height))?;
    draw(&canvas)?;
    canvas.present()?;
    // The backend opens the document without title and with one size for both; its first line makes room for ours.
    let body = drawn.split_once('\n').map_or("", |(_, body)| body);
    let mut document = String::new();
    let _ = writeln!(
        document,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {WIDTH} {height}\" \
         role=\"img\" aria-labelledby=\"title desc\">",
        WIDTH / UNITS_PER_PIXEL,
        height.div_ceil(UNITS_PER_PIXEL),
    );
    let _ = writeln!(document, "<title id=\"title\">{}</title>", escaped(title));
    let _ = writeln!(document, "<desc id=\"desc\">{}</desc>", escaped(description));
    document.push_str(body);
    Ok(document)
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
    use super::{document, escaped};

    #[test]
    fn xml_is_escaped() {
        assert_eq!(escaped("a < b & \"c\" > 'd'\u{7}"), "a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos; ");
    }

    #[test]
    fn a_document_has_title_description_and_role() {
        let svg = document("p ≥ 0 & h ≥ 0", "a < b", 300, |_| Ok(())).expect("an empty sheet");
        assert!(svg.contains("<title id=\"title\">p ≥ 0 &amp; h ≥ 0</title>"), "{svg}");
        assert!(svg.contains("<desc id=\"desc\">a &lt; b</desc>"), "{svg}");
        assert!(svg.starts_with("<svg ") && svg.contains("role=\"img\"") && svg.ends_with("</svg>\n"), "{svg}");
    }
}
