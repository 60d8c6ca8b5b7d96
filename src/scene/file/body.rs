//! Reads the table `[body]`: an elastic body from a matrix, with gaps and loads as CSV in the layout of a survey.

use std::ops::ControlFlow;

use toml::de::DeTable;

use super::contents::units;
use super::problem::excerpt;
use super::survey::{Survey, beside as named_beside};
use super::table::{Error, Keys, Value};
use super::{FileError, Found, ReadProblem, Source};
use crate::body::matrix_market::{Reader, Wrong};
use crate::body::proof::Brought;
use crate::body::{Body, BodyProblem, Kind};
use crate::qp::{Explicit, Profile};
use crate::scene::Scene;

/// Reads the files that a scene file names; `path` is the name as written there.
pub trait Beside {
    /// The contents of a file.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be read.
    fn text(&mut self, path: &str) -> Result<String, ReadProblem>;

    /// Passes the lines of a file to `each` one by one, without line ends, until `each` breaks.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be read.
    fn lines(&mut self, path: &str, each: &mut dyn FnMut(&str) -> ControlFlow<()>) -> Result<(), ReadProblem>;
}

/// The model that a scene file describes.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one of it at a time")]
pub enum Model {
    /// A beam above a foundation.
    Scene(Scene),
    /// Any elastic body.
    Body(Box<Body>),
}

const FILE: &[&str] = &["title", "units", "body", "beam", "load", "foundation"];
const BODY: &[&str] = &["stiffness", "flexibility", "sum_duplicates", "gap", "load", "foundation"];

pub(super) fn read(
    source: Source<'_>,
    document: &DeTable<'_>,
    beside: &mut dyn Beside,
) -> Result<Body, Box<FileError>> {
    let at = |error: Error| source.error(error.span, error.problem);
    let wrong = |value: &Value<'_>, problem: BodyProblem| source.error(value.span(), problem.into());
    let file = Keys::of_file(document, FILE).map_err(at)?;
    for beam in ["beam", "load", "foundation"] {
        if let Some(value) = file.get(beam) {
            return Err(wrong(&value, BodyProblem::Beside(beam)));
        }
    }
    let body = file.required_table("body", BODY).map_err(at)?;
    let (kind, key, given) = match (body.get("stiffness"), body.get("flexibility")) {
        (Some(given), None) => (Kind::Stiffness, "stiffness", given),
        (None, Some(given)) => (Kind::Flexibility, "flexibility", given),
        _ => return Err(source.error(body.span(), BodyProblem::OneMatrix.into())),
    };
    let sums_duplicates = body.truth("sum_duplicates").map_err(at)?.unwrap_or(false);
    let mut files = Files { source, sums_duplicates, beside };
    let matrix = files.matrix(key, &given)?;
    let n = matrix.dimension();
    let foundation = match body.get("foundation") {
        None => None,
        Some(value) if kind == Kind::Stiffness => return Err(wrong(&value, BodyProblem::FoundationOfStiffness)),
        Some(value) => Some((files.matrix("foundation", &value)?, value)),
    };
    let mut table =
        |key, quantity| body.get(key).map_or_else(|| Ok(vec![0.0; n]), |v| files.table(key, quantity, &v, n));
    let (gap, load) = (table("gap", "gap")?, table("load", "force")?);
    let title = file.line_of_text("title").map_err(at)?.unwrap_or_default();
    let units = units(&file).map_err(at)?;
    let body = Body::new(kind, matrix, foundation.as_ref().map(|(foundation, _)| foundation), gap, load);
    // Each matrix is already known to be positive definite, so that only rounding can make their sum indefinite.
    let mut body = body.map_err(|problem| match (&problem, &foundation) {
        (BodyProblem::Sizes { .. }, Some((_, value))) => wrong(value, problem),
        _ => wrong(&given, problem),
    })?;
    (body.title, body.units) = (title, units);
    Ok(body)
}

/// The files of a body.
struct Files<'a> {
    source: Source<'a>,
    sums_duplicates: bool,
    beside: &'a mut dyn Beside,
}

impl Files<'_> {
    fn unreadable(&self, key: &'static str, path: &str, value: &Value<'_>, problem: ReadProblem) -> Box<FileError> {
        let problem = BodyProblem::Unreadable { key, path: excerpt(path), problem };
        self.source.error(value.span(), problem.into())
    }

    /// Reads a positive definite matrix.
    fn matrix(&mut self, key: &'static str, value: &Value<'_>) -> Result<Profile, Box<FileError>> {
        let path = value.line_of_text().map_err(|error| self.source.error(error.span, error.problem))?;
        let name = named_beside(self.source.name, &path);
        let at = |w: Wrong| Box::new(FileError::on_line(&name, w.line, &w.text, w.marked, w.problem.into()));
        let (mut reader, mut found) = (Reader::new(self.sums_duplicates), None);
        let read = self.beside.lines(&path, &mut |line| match reader.line(line) {
            Ok(()) => ControlFlow::Continue(()),
            Err(wrong) => {
                found = Some(wrong);
                ControlFlow::Break(())
            }
        });
        read.map_err(|problem| self.unreadable(key, &path, value, problem))?;
        let matrix = found.map_or_else(|| reader.end(), Err).map_err(at)?;
        match Explicit::factored([matrix, Profile::default()]) {
            Ok(program) => Ok(program.profile().clone()),
            Err(error) => Err(Box::new(FileError::whole(&name, BodyProblem::from(error).into()))),
        }
    }

    /// Reads a number for each degree of freedom.
    fn table(
        &mut self,
        key: &'static str,
        quantity: &'static str,
        value: &Value<'_>,
        n: usize,
    ) -> Result<Vec<f64>, Box<FileError>> {
        let path = value.line_of_text().map_err(|error| self.source.error(error.span, error.problem))?;
        let text = self.beside.text(&path).map_err(|problem| self.unreadable(key, &path, value, problem))?;
        let file = Survey::new(named_beside(self.source.name, &path), text);
        column(&file, &[quantity], &vec![0.0; n]).map(|(_, values)| values)
    }
}

/// Quantities that are infinite where there is no foundation.
const WITHOUT_END: [&str; 2] = ["gap", "clearance"];

/// Reads rows `i,quantity` for degrees of freedom `i`, counted from 1. Returns the index of the quantity named in the header, and
/// the values of all degrees of freedom. A degree of freedom without a row receives its value from `left_out` if the quantity may
/// be infinite, and zero otherwise.
fn column(file: &Survey, quantities: &[&'static str], left_out: &[f64]) -> Result<(usize, Vec<f64>), Box<FileError>> {
    let n = left_out.len();
    let (layout, mut rows) = (file.layout(), file.rows());
    let (header, span) = rows.next().unwrap_or(("", 0..0));
    let names: Vec<&str> = layout.fields(header, span.start).map(|(name, _)| name).collect();
    let Some(which) = quantities.iter().position(|quantity| names == ["i", quantity]) else {
        let expected = quantities.iter().map(|quantity| format!("`i,{quantity}`")).collect::<Vec<_>>().join(" or ");
        return Err(file.error(span, BodyProblem::TableHeader { expected, found: Found::of(header) }.into()));
    };
    let mut values: Vec<Option<f64>> = vec![None; n];
    for (row, span) in rows {
        let mut given = layout.fields(row, span.start);
        let (Some((i, place)), Some(value), None) = (given.next(), given.next(), given.next()) else {
            let found = layout.fields(row, span.start).count();
            return Err(file.error(span, BodyProblem::Fields { expected: "two numbers", found }.into()));
        };
        let Some(index) = i.parse().ok().filter(|i| (1..=n).contains(i)) else {
            let (expected, found) = (format!("a whole number from 1 to {n}"), Found::of(i));
            return Err(file.error(place, BodyProblem::Number { quantity: "i", expected, found }.into()));
        };
        let at_value = value.1.clone();
        let without_end = WITHOUT_END.contains(&quantities[which]) && value.0.eq_ignore_ascii_case("inf");
        let value = if without_end { f64::INFINITY } else { file.number(&layout, quantities[which], value)? };
        if quantities[which] == "clearance" && value.is_finite() && !left_out[index - 1].is_finite() {
            let (expected, found) = ("inf, as the gap of this freedom is".to_owned(), Found::of(&value.to_string()));
            return Err(file.error(at_value, BodyProblem::Number { quantity: "clearance", expected, found }.into()));
        }
        if values[index - 1].replace(value).is_some() {
            return Err(file.error(place, BodyProblem::RowTwice(index).into()));
        }
    }
    let or_else = |left_out: f64| if WITHOUT_END.contains(&quantities[which]) { left_out } else { 0.0 };
    Ok((which, values.into_iter().zip(left_out).map(|(value, left_out)| value.unwrap_or(or_else(*left_out))).collect()))
}

/// Reads the answer of another program for a body: `i,force` or `i,clearance`.
///
/// # Errors
///
/// Text in another format, with line and column.
pub fn parse_answers(name: &str, text: &str, body: &Body) -> Result<Brought, Box<FileError>> {
    let file = Survey::new(name.to_owned(), text.to_owned());
    let left_out: Vec<f64> = body.gap().iter().map(|gap| if gap.is_finite() { 0.0 } else { *gap }).collect();
    let (which, values) = column(&file, &["force", "clearance"], &left_out)?;
    Ok(if which == 0 { Brought::Force(values) } else { Brought::Clearance(values) })
}
