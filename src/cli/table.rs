//! Tables and lists as text, and the names of quantities in them.

use std::fmt::Write as _;

use palkki::scene::Units;

/// Cells of a table.
pub(super) type Row = Vec<String>;

/// Names and what they have, line by line.
pub(super) fn list(lines: &[(&str, String)]) -> String {
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    lines.iter().fold(String::new(), |mut text, (name, value)| {
        // Writing to a string does not fail.
        let _ = writeln!(text, "  {name:width$}  {value}");
        text
    })
}

/// A table with a title: columns of words are set flush left, columns with numbers flush right.
pub(super) fn table(title: &str, header: &[&str], rows: &[Row]) -> String {
    let header: Row = header.iter().map(|&cell| cell.to_owned()).collect();
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

/// Names of quantities with the labels of their units.
pub(super) struct Labels {
    length: Option<String>,
    force: Option<String>,
}

impl Labels {
    pub(super) fn of(units: &Units) -> Self {
        Self { length: units.length.clone(), force: units.force.clone() }
    }

    pub(super) fn length(&self, name: &str) -> String {
        with_unit(name, self.length.clone())
    }

    pub(super) fn force(&self, name: &str) -> String {
        with_unit(name, self.force.clone())
    }

    pub(super) fn stiffness(&self, name: &str) -> String {
        let unit = self.force.as_ref().zip(self.length.as_ref()).map(|(force, length)| format!("{force}/{length}"));
        with_unit(name, unit)
    }

    pub(super) fn moment(&self, name: &str) -> String {
        let unit = self.force.as_ref().zip(self.length.as_ref()).map(|(force, length)| format!("{force} {length}"));
        with_unit(name, unit)
    }
}

fn with_unit(name: &str, unit: Option<String>) -> String {
    unit.map_or_else(|| name.to_owned(), |unit| format!("{name} [{unit}]"))
}
