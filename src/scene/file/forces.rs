//! Contact forces as CSV, `x,force`, one force per row, in the layout of a survey.

use super::survey::Survey;
use super::{FileError, Found, Problem};

const FIELDS: [&str; 2] = ["x", "force"];

/// Reads contact forces for a beam of the given length: `(x, force)` in the order of the file, forces positive upwards.
///
/// `name` is the name of the file for messages and `text` its contents.
///
/// # Errors
///
/// Text in another format, numbers that are not finite, and positions outside the beam, all with line and column.
pub fn parse_forces(name: &str, text: &str, length: f64) -> Result<Vec<(f64, f64)>, Box<FileError>> {
    let file = Survey::new(name.to_owned(), text.to_owned());
    let (layout, mut rows) = (file.layout(), file.rows());
    let Some((header, span)) = rows.next() else {
        return Err(file.error(0..0, Problem::ForcesWithoutHeader));
    };
    if !layout.fields(header, span.start).map(|(name, _)| name).eq(FIELDS) {
        return Err(file.error(span, Problem::ForcesHeader { found: Found::of(header) }));
    }
    let forces = rows.map(|(row, span)| {
        let mut given = layout.fields(row, span.start);
        let (Some(x), Some(force), None) = (given.next(), given.next(), given.next()) else {
            let found = layout.fields(row, span.start).count();
            return Err(file.error(span, Problem::ForcesFields { found }));
        };
        let at = x.1.clone();
        let (x, force) = (file.number(&layout, FIELDS[0], x)?, file.number(&layout, FIELDS[1], force)?);
        if (0.0..=length).contains(&x) {
            Ok((x, force))
        } else {
            Err(file.error(at, Problem::ForceOutsideBeam { x, length }))
        }
    });
    forces.collect()
}
