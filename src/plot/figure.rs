//! Figures: a title, a description for readers who cannot see the image, and panels, written as an SVG document.
//!
//! The document has a nominal size, colours for dark surroundings, and compact markup.

use std::fmt::Write as _;

use super::canvas::{Align, Canvas, Point, TEXT, Type, wrapped};
use super::palette::dark_rules;
use super::panel::{Layout, Panel};
use super::{PlotError, count};

/// Panels under one title, in rows from left to right.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The title, printed above the panels.
    pub title: String,
    /// The content of the figure in words, which becomes the description of the image.
    pub description: String,
    /// The panels, at least one.
    pub panels: Vec<Panel>,
    /// Number of panels side by side, at least one.
    pub columns: usize,
    /// Notes below the panels, each starting on a new line.
    pub notes: Vec<String>,
}

/// Margin around the figure \[drawing units\].
const MARGIN: f64 = 40.0;

impl Figure {
    /// A figure with its panels one below the other.
    pub fn new(title: impl Into<String>, description: impl Into<String>, panels: Vec<Panel>) -> Self {
        Self { title: title.into(), description: description.into(), panels, columns: 1, notes: Vec::new() }
    }

    /// With notes below the panels.
    #[must_use]
    pub fn notes(self, notes: Vec<String>) -> Self {
        Self { notes, ..self }
    }

    /// The figure as an SVG document; the same data give the same bytes.
    ///
    /// # Errors
    ///
    /// A [`PlotError`] for a number that is not finite, or not positive on a logarithmic axis, and for an empty panel.
    pub fn svg(&self) -> Result<String, PlotError> {
        if self.panels.is_empty() {
            return Err(PlotError::Empty { what: "a figure" });
        }
        let sheet = f64::from(WIDTH);
        let title = Words::title(&self.title);
        let mut top = title.bottom + 0.7 * MARGIN;
        let rows = self.rows()?;
        let mut groups = vec![group("class=\"title\"", |canvas| title.draw(canvas))?];
        for row in &rows {
            let in_columns = row.iter().enumerate().map(|(column, layout)| {
                // Frames one below the other have the same left and right edges.
                let same = rows.iter().filter(|other| other.len() == row.len()).map(|other| other[column].margins);
                layout.with_margins(same.fold([0.0; 2], |most, next| [most[0].max(next[0]), most[1].max(next[1])]))
            });
            let in_columns: Vec<Layout<'_>> = in_columns.collect();
            let (width, height) = (sheet / count(row.len()), in_columns.iter().map(Layout::height).fold(0.0, f64::max));
            for (column, layout) in in_columns.iter().enumerate() {
                let left = width * count(column);
                let place = format!("data-panel=\"{left:.0} {top:.0} {width:.0} {height:.0}\"");
                groups.push(group(&place, |canvas| layout.draw(canvas, [left, top]))?);
            }
            top += height;
        }
        let notes = Words::notes(&self.notes, top);
        for note in &notes {
            groups.push(group("class=\"note\"", |canvas| note.draw(canvas))?);
        }
        let bottom = notes.iter().map(|note| note.bottom + MARGIN).fold(top, f64::max);
        Ok(document(&self.title, &self.description, whole(bottom), &groups.concat()))
    }

    /// The panels row by row; all panels of a row have the same width.
    fn rows(&self) -> Result<Vec<Vec<Layout<'_>>>, PlotError> {
        let mut rows: Vec<Vec<&Panel>> = Vec::new();
        for panel in &self.panels {
            match rows.last_mut() {
                Some(row) if row.len() < self.columns && !panel.wide && !row.iter().any(|other| other.wide) => {
                    row.push(panel);
                }
                _ => rows.push(vec![panel]),
            }
        }
        let width = |row: &[&Panel]| f64::from(WIDTH) / count(row.len());
        rows.iter().map(|row| row.iter().map(|panel| panel.layout(width(row))).collect()).collect()
    }
}

/// Lines of text with their positions, and the bottom of the last line.
struct Words {
    kind: Type,
    lines: Vec<(String, Point)>,
    bottom: f64,
}

impl Words {
    /// The title in as many lines as it needs.
    fn title(title: &str) -> Self {
        const LINE: f64 = 1.28 * Type::TITLE.size;
        let lines = wrapped(title, f64::from(WIDTH) - 2.0 * MARGIN, Type::TITLE);
        let bottom = MARGIN + LINE * count(lines.len());
        let place = |i: usize| [MARGIN, MARGIN + LINE * (count(i) + 0.5)];
        let lines = lines.into_iter().enumerate().map(|(i, line)| (line, place(i))).collect();
        Self { kind: Type::TITLE, lines, bottom }
    }

    /// Notes in one column, or in two if there are many.
    fn notes(notes: &[String], top: f64) -> Vec<Self> {
        /// Largest number of notes in one column.
        const ONE_COLUMN: usize = 8;
        const LINE: f64 = 1.3 * TEXT;
        /// Indentation of all lines of a note except the first.
        const INDENT: f64 = 2.0 * TEXT;
        let columns = if notes.len() <= ONE_COLUMN { 1 } else { 2 };
        let width = (f64::from(WIDTH) - MARGIN) / count(columns);
        let mut all = Vec::new();
        for (column, notes) in notes.chunks(notes.len().div_ceil(columns).max(1)).enumerate() {
            let left = MARGIN + width * count(column);
            let mut bottom = top;
            for note in notes {
                let place = |i: usize| [if i == 0 { left } else { left + INDENT }, bottom + LINE * (count(i) + 0.5)];
                let lines = wrapped(note, width - MARGIN - INDENT, Type::PLAIN).into_iter().enumerate();
                let lines: Vec<(String, Point)> = lines.map(|(i, line)| (line, place(i))).collect();
                bottom += LINE * count(lines.len());
                all.push(Self { kind: Type::PLAIN, lines, bottom });
            }
        }
        all
    }

    fn draw(&self, canvas: &mut Canvas) -> Result<(), PlotError> {
        self.lines.iter().try_for_each(|(line, at)| canvas.text(line, *at, Align::Left, self.kind))
    }
}

/// A height in whole drawing units.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to what a u32 holds")]
fn whole(height: f64) -> u32 {
    height.ceil().clamp(1.0, 1e6) as u32
}

/// Width of every drawing \[drawing units\]. Positions are whole units, so the number is large.
const WIDTH: u32 = 2400;

/// Drawing units per pixel of the nominal size.
const UNITS_PER_PIXEL: u32 = 3;

/// The output of `draw` as a group with an attribute. `data-panel` gives the part of the sheet that a panel occupies, so that panels
/// can be rearranged.
fn group(attribute: &str, draw: impl FnOnce(&mut Canvas) -> Result<(), PlotError>) -> Result<String, PlotError> {
    let mut drawn = String::new();
    let mut canvas = Canvas::new(&mut drawn);
    draw(&mut canvas)?;
    canvas.present()?;
    // The backend opens and closes its own document on its first and last line.
    let body = drawn.split_once('\n').map_or("", |(_, body)| body);
    let body = body.rsplit_once("</svg>").map_or(body, |(body, _)| body);
    Ok(format!("<g {attribute}>\n{}</g>\n", compact(body)))
}

/// Groups on a white sheet of `height` as a complete document.
fn document(title: &str, description: &str, height: u32, groups: &str) -> String {
    // Whole pixels; otherwise the last row of pixels would be half empty.
    let height = height.div_ceil(UNITS_PER_PIXEL) * UNITS_PER_PIXEL;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {WIDTH} {height}\" \
         role=\"img\" aria-labelledby=\"title desc\" font-family=\"sans-serif\" font-size=\"{TEXT}\">\n\
         <title id=\"title\">{}</title>\n\
         <desc id=\"desc\">{}</desc>\n\
         <style>@media (prefers-color-scheme: dark) {{ {} }}</style>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#FFFFFF\"/>\n\
         {groups}</svg>\n",
        WIDTH / UNITS_PER_PIXEL,
        height / UNITS_PER_PIXEL,
        escaped(title),
        escaped(description),
        dark_rules(),
    )
}

/// The elements of plotters' backend, one per line, without default attributes. Consecutive lines with the same appearance become one
/// path.
fn compact(body: &str) -> String {
    const POINTS: &str = " points=\"";
    let font_size = format!(" font-size=\"{TEXT}\"");
    // Quotes in texts are escaped, so no text looks like an attribute.
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
        // A text is on a line of its own between its tags.
        if line.starts_with("</text") || line.ends_with("/>") {
            out.push('\n');
        }
    }
    close(&mut out, &mut open);
    out
}

/// Ends a path if one is open.
fn close(out: &mut String, open: &mut Option<String>) {
    if open.take().is_some() {
        out.push_str("\"/>\n");
    }
}

/// `text` as XML character data. Control characters, which XML does not allow at all, become spaces.
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
    use std::collections::BTreeSet;

    use super::{Align, Figure, PlotError, Type, Words, document, group};
    use crate::plot::{Axis, Color, Dash, Panel, Style};

    #[test]
    fn a_figure_without_a_panel_or_a_point_is_refused() {
        let none = Figure::new("", "", Vec::new()).svg();
        assert!(matches!(none, Err(PlotError::Empty { what: "a figure" })), "no panel");
        let empty = Figure::new("", "", vec![Panel::new(Axis::new("x"), Axis::new("y"))]).svg();
        assert!(matches!(empty, Err(PlotError::Empty { what: "a panel" })), "no point");
    }

    #[test]
    fn a_group_is_closed_after_a_line_and_after_a_text() {
        let line = [[0.0, 0.0], [9.0, 0.0]];
        let lines = group("id=\"a\"", |canvas| canvas.lines(&[line, line], Color::BLACK, 1, Dash::Solid));
        let path = "<path fill=\"none\" stroke=\"#000000\" stroke-width=\"1\" d=\"M0,0 9,0M0,0 9,0\"/>";
        assert_eq!(lines.expect("two lines"), format!("<g id=\"a\">\n{path}\n</g>\n"), "one path");
        let text = group("id=\"a\"", |canvas| canvas.text("t", [0.0, 0.0], Align::Left, Type::PLAIN));
        assert!(text.expect("a text").ends_with(">t</text>\n</g>\n"), "a line with its tags");
    }

    #[test]
    fn more_than_eight_notes_stand_in_two_columns() {
        for (count, columns) in [(1, 1), (8, 1), (9, 2)] {
            let notes = Words::notes(&vec!["1 at the left end".to_owned(); count], 0.0);
            let lefts: BTreeSet<String> = notes.iter().map(|note| format!("{:?}", note.lines[0].1[0])).collect();
            assert_eq!(lefts.len(), columns, "{count} notes: {lefts:?}");
        }
    }

    #[test]
    fn series_differ_without_their_colours() {
        let styles: Vec<Style> = (0..7).map(Style::of_series).collect();
        for (i, a) in styles.iter().enumerate() {
            for b in &styles[..i] {
                assert!(a.color != b.color && a.marker != b.marker, "{a:?} and {b:?}");
            }
        }
    }

    #[test]
    fn a_document_has_title_description_role_and_dark_colours() {
        let svg = document("p ≥ 0 & h ≥ 0", "a < b > \"c\" 'd'\u{7}", 300, "");
        assert!(svg.contains("<title id=\"title\">p ≥ 0 &amp; h ≥ 0</title>"), "{svg}");
        assert!(svg.contains("<desc id=\"desc\">a &lt; b &gt; &quot;c&quot; &apos;d&apos; </desc>"), "{svg}");
        assert!(svg.contains("prefers-color-scheme: dark"), "{svg}");
        assert!(svg.starts_with("<svg ") && svg.contains("role=\"img\"") && svg.ends_with("</svg>\n"), "{svg}");
    }
}
