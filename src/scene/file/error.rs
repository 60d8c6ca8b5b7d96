//! An error with its location in a file, and its rendered message: file, line, column and a caret.

use std::fmt;

use super::Problem;
use super::mistyped;
use super::problem::is_forbidden;
use super::survey::line_end;
use super::table::Span;

/// The reason why a scene file, a survey or another input file is invalid.
#[derive(Debug, Clone, PartialEq)]
pub struct FileError {
    /// The name of the file as given by the caller.
    pub file: String,
    /// The location in the file; [`None`] if the error concerns the whole file.
    pub place: Option<Place>,
    /// The error itself.
    pub problem: Problem,
}

/// A location in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Line, from 1.
    pub line: usize,
    /// Column, in characters, from 1.
    pub column: usize,
    /// The line itself; [`None`] if it must not be printed.
    text: Option<String>,
    /// The bytes of the line to which the error refers.
    marked: Span,
}

impl FileError {
    /// An error that concerns the whole file.
    #[must_use]
    pub fn whole(file: &str, problem: Problem) -> Self {
        Self { file: file.to_owned(), place: None, problem }
    }

    /// An error at the bytes `span` of `text`.
    pub(super) fn at(file: &str, text: &str, span: Span, problem: Problem) -> Self {
        Self { file: file.to_owned(), place: Some(Place::of(text, span)), problem }
    }

    /// An error at the bytes `span` of a single line, whose contents are `text`.
    pub(super) fn on_line(file: &str, line: usize, text: &str, span: Span, problem: Problem) -> Self {
        let place = Place { line, ..Place::of(text, span) };
        Self { file: file.to_owned(), place: Some(place), problem }
    }

    /// The same error with a message that contains no text of the file, only the location.
    #[must_use]
    pub fn without_text(mut self) -> Self {
        if let Some(place) = &mut self.place {
            place.text = None;
        }
        Self { problem: self.problem.without_text(), ..self }
    }

    /// The remedy for frequent mistakes. How a number is mistyped is in the line, not in the message of the TOML parser.
    fn help(&self) -> Option<String> {
        match &self.problem {
            Problem::Syntax { .. } => self.place.as_ref().and_then(|place| mistyped::in_line(place.text.as_deref()?)),
            problem => problem.help(),
        }
    }

    /// The message with an excerpt of the file, in terminal colours if `colour`. Without the feature `cli` there is no excerpt.
    #[must_use]
    pub fn render(&self, colour: bool) -> String {
        // File names, keys and columns may contain any character; unprintable ones must not reach a terminal.
        let title = printable(&self.problem.to_string());
        let file = printable(&self.file);
        let lines = |text: String| text.split('\n').map(printable).collect::<Vec<_>>().join("\n");
        let notes = [self.problem.expected(), self.help()].map(|note| note.map(lines));
        picture(&title, &file, self.place.as_ref(), notes, colour)
    }
}

/// Replaces text that a message does not repeat.
#[cfg(feature = "cli")]
const NOT_SHOWN: &str = "the text of this file is not shown: the file is outside the folder of the scene";

/// Renders the message with the line of the location and a caret below it.
#[cfg(feature = "cli")]
fn picture(
    title: &str,
    file: &str,
    place: Option<&Place>,
    [expected, help]: [Option<String>; 2],
    colour: bool,
) -> String {
    use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

    /// Lines longer than this are not printed \[bytes\]: the caret would not be visible.
    const LONGEST_LINE: usize = 4000;

    fn note<'a>(group: Group<'a>, text: Option<String>) -> Group<'a> {
        match text {
            Some(text) => group.element(Level::NOTE.message(text)),
            None => group,
        }
    }

    let title = Level::ERROR.primary_title(title);
    let group = match place {
        None => note(title.element(Origin::path(file)), expected),
        Some(place) => match place.text.as_deref().filter(|line| line.len() <= LONGEST_LINE) {
            Some(line) => title.element(
                Snippet::source(line)
                    .path(file)
                    .line_start(place.line)
                    .annotation(AnnotationKind::Primary.span(place.marked.clone()).label(expected)),
            ),
            None => {
                let group = title.element(Origin::path(file).line(place.line).char_column(place.column));
                note(note(group, expected), place.text.is_none().then(|| NOT_SHOWN.to_owned()))
            }
        },
    };
    let group = match help {
        Some(help) => group.element(Level::HELP.message(help)),
        None => group,
    };
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&[group])
}

/// Renders the message with the location in numbers.
#[cfg(not(feature = "cli"))]
fn picture(title: &str, file: &str, place: Option<&Place>, [expected, help]: [Option<String>; 2], _: bool) -> String {
    let place = place.map_or_else(String::new, |place| format!(":{}:{}", place.line, place.column));
    let expected = expected.map_or_else(String::new, |expected| format!("\nnote: {expected}"));
    let help = help.map_or_else(String::new, |help| format!("\nhelp: {help}"));
    format!("error: {title}\n --> {file}{place}{expected}{help}")
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for FileError {}

impl Place {
    /// The line in which `span` starts, and the part of the line inside `span`.
    fn of(text: &str, span: Span) -> Self {
        let start = floor_char_boundary(text, span.start);
        let end = floor_char_boundary(text, span.end).max(start);
        let line_break = line_end(text);
        let line_start = text[..start].rfind(line_break).map_or(0, |i| i + 1);
        let line_end = text[start..].find(line_break).map_or(text.len(), |i| start + i);
        let line_end = if text[line_start..line_end].ends_with('\r') { line_end - 1 } else { line_end };
        let line = &text[line_start..line_end];
        let start = start.min(line_end);
        Self {
            line: text[..line_start].matches(line_break).count() + 1,
            column: text[line_start..start].chars().count() + 1,
            text: Some(line.replace(is_c1, "\u{b7}")),
            marked: start - line_start..end.min(line_end) - line_start,
        }
    }
}

/// U+0080 to U+009F, which can control a terminal and which the renderer does not remove. The replacement has the same number of
/// bytes, so that locations in the line stay valid.
fn is_c1(c: char) -> bool {
    ('\u{80}'..='\u{9f}').contains(&c)
}

/// The last character boundary at or before byte `at`.
fn floor_char_boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}

/// `text` with escaped terminal control characters.
fn printable(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() || is_forbidden(c) { c.escape_default().to_string() } else { c.to_string() })
        .collect()
}
