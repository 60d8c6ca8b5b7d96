//! Tables and lists as text, and the unit labels in them.

use std::fmt::Write as _;

use palkki::scene::Units;
use palkki::text::Results;

/// The cells of a row.
pub(super) type Row = Vec<String>;

/// Names with their values, one per line.
pub(super) fn list(lines: &[(impl AsRef<str>, String)]) -> String {
    let lines = || lines.iter().map(|(name, value)| (name.as_ref(), value));
    let width = lines().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    lines().fold(String::new(), |mut text, (name, value)| {
        // Writing to a string does not fail.
        let _ = writeln!(text, "  {name:width$}  {value}");
        text
    })
}

/// A table with a title: columns of words are left-aligned, columns with numbers right-aligned.
pub(super) fn table(title: &str, header: &[impl AsRef<str>], rows: &[Row]) -> String {
    let header: Row = header.iter().map(|cell| cell.as_ref().to_owned()).collect();
    let lines = || std::iter::once(&header).chain(rows);
    let widths: Vec<usize> = (0..header.len())
        .map(|column| lines().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0))
        .collect();
    let words: Vec<bool> = (0..header.len())
        .map(|column| {
            rows.iter().all(|row| row.get(column).is_none_or(|cell| !cell.contains(|c: char| c.is_ascii_digit())))
        })
        .collect();
    let mut text = format!("\n{title}\n");
    for row in lines() {
        let mut line = String::from("  ");
        for ((cell, &width), &words) in row.iter().zip(&widths).zip(&words) {
            let padding = " ".repeat(width - cell.chars().count());
            line += &if words { format!("{cell}{padding}  ") } else { format!("{padding}{cell}  ") };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// The label of a unit, if the scene has one.
pub(super) struct Label(Option<String>, Results);

impl Label {
    /// The name of a quantity with its unit, `moment [kN m]`.
    pub(super) fn name(&self, name: &str) -> String {
        self.0.as_ref().map_or_else(|| name.to_owned(), |label| format!("{name} [{label}]"))
    }

    /// A value with its unit, `2.5 kN m`.
    pub(super) fn value(&self, value: f64) -> String {
        let number = self.1.number(value);
        self.0.as_ref().map_or_else(|| number.clone(), |label| format!("{number} {label}"))
    }
}

/// The unit labels of a scene, and the format of its numbers.
pub(super) struct Labels {
    pub(super) results: Results,
    pub(super) length: Label,
    pub(super) force: Label,
    /// Force over length: for a distributed load or an elastic support.
    pub(super) density: Label,
    pub(super) moment: Label,
    pub(super) bending_stiffness: Label,
}

impl Labels {
    pub(super) fn of(Units { length, force }: &Units, results: Results) -> Self {
        let of_both = |label: fn(&str, &str) -> String| {
            Label(force.as_deref().zip(length.as_deref()).map(|(force, length)| label(force, length)), results)
        };
        Self {
            results,
            length: Label(length.clone(), results),
            force: Label(force.clone(), results),
            density: of_both(|force, length| format!("{force}/{length}")),
            moment: of_both(|force, length| format!("{force} {length}")),
            bending_stiffness: of_both(|force, length| format!("{force} {length}²")),
        }
    }

    /// A number without a unit.
    pub(super) fn number(&self, value: f64) -> String {
        self.results.number(value)
    }
}

/// Largest number of rows of one kind in a table.
pub(super) const MOST_ROWS: usize = 200;

/// A line with the number of entries that were left out; empty if there are none.
pub(super) fn first(what: &str, there: usize, shown: usize) -> String {
    if shown < there { format!("The first {shown} of {there} {what}; --format json has all.\n") } else { String::new() }
}
