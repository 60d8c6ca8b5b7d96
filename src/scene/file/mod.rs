//! Scene files: reads text into a [`Scene`], or returns an error with its location in the file.
//!
//! The file is TOML. Its tables are read key by key instead of with serde's derive. Serde accepts an array in place of a table
//! (`beam = [10, 1.3]`), and its messages would have to be parsed to name quantity, value and requirement. The *numbers* are
//! checked only by the functions that create a scene ([`Beam::new`], [`Load::new`], [`Foundation::checked`], [`Scene::scaled`]);
//! this module adds the location in the file to their errors.
//!
//! This module opens no file: the caller passes the text, and a function that reads a survey.

mod body;
mod columns;
mod contents;
mod error;
mod forces;
mod instead;
mod locate;
mod mistyped;
mod problem;
mod reader;
mod remedy;
mod survey;
mod survey_problem;
mod table;

use toml::Spanned;
use toml::de::DeTable;

pub use body::{Beside, Model, parse_answers};
pub use error::FileError;
pub use forces::parse_forces;
pub use problem::{Found, Problem, ReadProblem};
pub use survey_problem::{Declaration, SurveyProblem};

use self::contents::{BeamKeys, Given, LoadKeys, Stiffness};
use self::locate::Located;
use self::survey::Survey;
use self::table::Span;
use super::{Beam, Foundation, Load, Profile, Scene, SceneError};

/// Reads a scene file.
///
/// `name` is the name of the file for messages and `text` its contents. `read_survey` receives the value of the key
/// `foundation.survey` or `beam.shape.survey` as written in the file, and returns the contents of the survey.
///
/// # Errors
///
/// Text that is not TOML; keys that are unknown, missing, duplicate or of a wrong type; an invalid survey; and every
/// [`SceneError`], including those of [`Scene::scaled`]. The location in the file is included.
pub fn parse(
    name: &str,
    text: &str,
    mut read_survey: impl FnMut(&str) -> Result<String, ReadProblem>,
) -> Result<Scene, Box<FileError>> {
    let source = Source { name, text };
    parse_beam(source, &source.document()?, &mut read_survey, false)
}

/// Reads a scene file with a beam or with a [body](crate::body). `beside` reads the files that it names.
///
/// # Errors
///
/// Those of [`parse`], and errors in the files of a body.
pub fn parse_model(name: &str, text: &str, beside: &mut dyn Beside) -> Result<Model, Box<FileError>> {
    model(name, text, beside, false)
}

/// Reads a scene file for a sweep: point loads may be located beyond the beam, where they do not act ([`Scene::loads_beyond`]).
///
/// # Errors
///
/// Those of [`parse_model`].
pub fn parse_train(name: &str, text: &str, beside: &mut dyn Beside) -> Result<Model, Box<FileError>> {
    model(name, text, beside, true)
}

fn model(name: &str, text: &str, beside: &mut dyn Beside, is_train: bool) -> Result<Model, Box<FileError>> {
    let source = Source { name, text };
    let document = source.document()?;
    if document.get_ref().contains_key("body") {
        return body::read(source, document.get_ref(), beside).map(|body| Model::Body(Box::new(body)));
    }
    parse_beam(source, &document, &mut |survey| beside.text(survey), is_train).map(Model::Scene)
}

fn parse_beam(
    source: Source<'_>,
    document: &Spanned<DeTable<'_>>,
    read_survey: &mut dyn FnMut(&str) -> Result<String, ReadProblem>,
    is_train: bool,
) -> Result<Scene, Box<FileError>> {
    let name = source.name;
    let mut contents = contents::read(document.get_ref()).map_err(|e| source.error(e.span, e.problem))?;
    let length = contents.beam.length;
    let mut profile = |given: Option<Given>| match given {
        None => Ok::<_, Box<FileError>>((None, None)),
        Some(Given::Profile(profile)) => Ok((Some(profile), None)),
        Some(Given::Survey(named)) => {
            let path = named.path.clone();
            let unreadable = |problem| source.error(named.span.clone(), Problem::UnreadableSurvey { path, problem });
            let text = read_survey(&named.path).and_then(survey::with_memory).map_err(unreadable)?;
            let mut survey = Survey::named(name, named, text);
            let points = survey.points_on_beam(length)?;
            Ok((Some(Foundation::Polyline { points }), Some(survey)))
        }
    };
    let (foundation, below) = profile(contents.foundation)?;
    let (shape, own) = profile(contents.beam.shape.take())?;
    let surveys = [(Profile::Foundation, below), (Profile::Shape, own)];
    let beyond = if is_train { Scene::taken_beyond(&mut contents.load.point, length) } else { Vec::new() };
    let located = Located { source: &source, document: document.get_ref(), surveys: &surveys };
    let scene =
        assemble(contents.beam, shape, contents.load, foundation, contents.stiffness).map_err(|e| located.error(e))?;
    Ok(scene.labelled(contents.title, contents.units).with_loads_beyond(beyond))
}

/// A file for messages: its name and its contents.
#[derive(Debug, Clone, Copy)]
struct Source<'a> {
    name: &'a str,
    text: &'a str,
}

impl<'a> Source<'a> {
    fn document(&self) -> Result<Spanned<DeTable<'a>>, Box<FileError>> {
        if self.text.is_empty() {
            return Err(Box::new(FileError::whole(self.name, Problem::Empty)));
        }
        DeTable::parse(self.text).map_err(|e| self.syntax(&e))
    }

    fn error(&self, span: Span, problem: Problem) -> Box<FileError> {
        Box::new(FileError::at(self.name, self.text, span, problem))
    }

    fn syntax(&self, error: &toml::de::Error) -> Box<FileError> {
        let end = self.text.len();
        let span = error.span().unwrap_or(end..end);
        let problem = match (error.message(), self.text.get(span.clone())) {
            // The only semantic error that the TOML parser reports; its message does not contain the key.
            ("duplicate key", Some(key)) => Problem::KeyTwice { key: key.to_owned() },
            (message, _) => Problem::Syntax { message: message.trim_end_matches(", expected nothing").to_owned() },
        };
        self.error(span, problem)
    }
}

fn assemble(
    keys: BeamKeys,
    shape: Option<Foundation>,
    load: LoadKeys,
    foundation: Option<Foundation>,
    stiffness: Option<Stiffness>,
) -> Result<Scene, SceneError> {
    let mut beam = match keys.bending_stiffness {
        Stiffness::One(stiffness) => Beam::new(keys.length, stiffness)?,
        Stiffness::Steps(steps) => Beam::new(keys.length, 1.0)?.with_steps(steps)?,
    };
    if let Some(supports) = keys.supports {
        beam = beam.with_supports(supports)?;
    }
    if let Some(shape) = shape {
        beam = beam.with_shape(shape)?;
    }
    let beam = beam.with_joints(keys.joints)?.with_tension(keys.tension)?;
    let load = Load::new(&beam, load.uniform, load.linear, load.point)?.with_couples(&beam, load.couple)?;
    let scene = match stiffness {
        None => Scene::new(beam, load, foundation)?,
        Some(Stiffness::One(stiffness)) => Scene::above(beam, load, foundation, Some(stiffness))?,
        Some(Stiffness::Steps(steps)) => Scene::above_steps(beam, load, foundation, steps)?,
    };
    scene.scaled()?;
    Ok(scene)
}
