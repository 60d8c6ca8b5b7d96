//! Files of comma-separated fields, a header first.

/// A number of an error, with its power of ten.
pub(super) fn error(value: f64) -> String {
    format!("{value:.2e}")
}

/// The lines below the header, field by field; an error if the header is another one.
pub(super) fn fields<'a>(text: &'a str, header: &str, path: &str) -> Result<Vec<Vec<&'a str>>, String> {
    let mut lines = text.lines();
    if lines.next() != Some(header) {
        return Err(format!("{path} has another header: `cargo xtask certificates` writes it anew"));
    }
    Ok(lines.map(|line| line.split(',').collect()).collect())
}
