//! A table: rows of cells that are text already, printed as Markdown in a document and as comma-separated values in data.

use std::fmt;

use crate::{Cause, data};

/// Cells of a row, each printed as it is.
macro_rules! row {
    ($($cell:expr),* $(,)?) => { [$($cell.to_string()),*] };
}
pub(crate) use row;

/// A header without empty cells, and rows of as many cells.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub(crate) fn new(header: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { header: cells(header), rows: Vec::new() }
    }

    /// One more row.
    pub(crate) fn push(&mut self, row: impl IntoIterator<Item = impl Into<String>>) {
        self.rows.push(cells(row));
    }

    /// With more rows.
    pub(crate) fn rows<Row: IntoIterator<Item: Into<String>>>(mut self, rows: impl IntoIterator<Item = Row>) -> Self {
        self.rows.extend(rows.into_iter().map(cells));
        self
    }

    /// How many rows there are.
    pub(crate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Without rows whose first cell is that of the row before: places that print alike.
    pub(crate) fn one_a_place(mut self) -> Self {
        self.rows.dedup_by(|row, before| row.first() == before.first());
        self
    }

    /// As comma-separated values, with the minus sign that programs read.
    pub(crate) fn csv(&self) -> Result<String, Cause> {
        let plain = |row: &Vec<String>| row.iter().map(|cell| cell.replace('−', "-")).collect::<Vec<_>>();
        data::text(&std::iter::once(&self.header).chain(&self.rows).map(plain).collect::<Vec<_>>())
    }
}

fn cells(row: impl IntoIterator<Item = impl Into<String>>) -> Vec<String> {
    row.into_iter().map(Into::into).collect()
}

/// As Markdown. Columns of numbers are aligned to the right.
impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line = |cells: &[String]| format!("| {} |", cells.join(" | "));
        let marks = (0..self.header.len()).map(|k| {
            let numbers = self.rows.iter().filter_map(|row| row.get(k)).all(|cell| is_number(cell));
            if numbers && !self.rows.is_empty() { "---:".to_owned() } else { "---".to_owned() }
        });
        writeln!(f, "{}\n{}", line(&self.header), line(&marks.collect::<Vec<_>>()))?;
        let rows: Vec<String> = self.rows.iter().map(|row| line(row)).collect();
        f.write_str(&rows.join("\n"))
    }
}

/// Whether a cell holds a number, or stands for one that is not there.
fn is_number(cell: &str) -> bool {
    let cell = cell.trim_matches('*');
    cell == "–" || cell.chars().next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '−' | '+'))
}

/// Templates see the Markdown.
impl From<Table> for minijinja::Value {
    fn from(table: Table) -> Self {
        table.to_string().into()
    }
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn columns_of_numbers_are_aligned_to_the_right() {
        let table = Table::new(["scene", "error"]).rows([["ridge", "1.2·10⁻⁹"], ["flat", "–"]]);
        assert_eq!(table.to_string(), "| scene | error |\n| --- | ---: |\n| ridge | 1.2·10⁻⁹ |\n| flat | – |");
    }

    #[test]
    fn a_comma_in_a_cell_is_quoted() {
        let table = Table::new(["x", "y"]).rows([row!["0.00", "a, b"], row!["0.00", 1], row![0.5, "−2"]]);
        assert_eq!(table.one_a_place().csv().expect("text"), "x,y\n0.00,\"a, b\"\n0.5,-2\n");
        assert!(Table::new(["x"]).rows([["1", "2"]]).csv().is_err(), "a cell too many");
    }
}
