//! The numbers behind a figure as CSV.

/// A header, then rows.
pub(super) fn csv(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let lines = rows.into_iter().map(|row| row.join(","));
    std::iter::once(header.join(",")).chain(lines).map(|line| line + "\n").collect()
}

/// Rows without those whose place, in the first column, is printed like that of the row before.
pub(super) fn one_a_place(rows: impl IntoIterator<Item = Vec<String>>) -> Vec<Vec<String>> {
    let mut rows: Vec<Vec<String>> = rows.into_iter().collect();
    rows.dedup_by(|row, before| row.first() == before.first());
    rows
}

/// A number with digits behind the point; zero has no sign.
pub(super) fn fixed(value: f64, places: usize) -> String {
    // Rounding to zero from below leaves a sign.
    let text = format!("{value:.places$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => text,
    }
}

/// A number that may be small, with its power of ten.
pub(super) fn scientific(value: f64, places: usize) -> String {
    format!("{value:.places$e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_plain() {
        let rows = [vec![fixed(-0.000_01, 3), scientific(0.012_34, 2)], vec![fixed(-1.5, 1), "4".to_owned()]];
        assert_eq!(csv(&["a", "b"], rows), "a,b\n0.000,1.23e-2\n-1.5,4\n");
    }
}
