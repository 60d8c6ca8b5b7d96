//! A table of the report as Markdown.

use std::fmt;

use serde::{Serialize, Serializer};

/// A header without empty cells, and rows of as many cells. Columns of numbers are aligned to the right.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub(crate) fn new(header: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { header: header.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// With one more row.
    pub(crate) fn row(mut self, cells: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.rows.push(cells.into_iter().map(Into::into).collect());
        self
    }

    /// With more rows.
    pub(crate) fn rows<Row: IntoIterator<Item: Into<String>>>(self, rows: impl IntoIterator<Item = Row>) -> Self {
        rows.into_iter().fold(self, Self::row)
    }
}

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
    cell == "–" || cell.chars().next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '-' | '−' | '+'))
}

impl From<Table> for minijinja::Value {
    fn from(table: Table) -> Self {
        table.to_string().into()
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn columns_of_numbers_are_aligned_to_the_right() {
        let table = Table::new(["scene", "error"]).row(["ridge", "1.2·10⁻⁹"]).row(["flat", "–"]);
        assert_eq!(table.to_string(), "| scene | error |\n| --- | ---: |\n| ridge | 1.2·10⁻⁹ |\n| flat | – |");
    }
}
