//! Where in the file the number is that a [`SceneError`] is about.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::foundation::KINDS;
use super::survey::Survey;
use super::table::Span;
use super::{FileError, Problem, Source};
use crate::scene::{Quantity, SceneError, Support};

/// A scene file that has been read, with its survey if it has one.
#[derive(Debug)]
pub(super) struct Located<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) document: &'a DeTable<'a>,
    pub(super) survey: Option<&'a Survey>,
}

impl Located<'_> {
    /// `error` with its place.
    pub(super) fn error(&self, error: SceneError) -> Box<FileError> {
        if let Some(survey) = self.survey
            && let Some((quantity, span)) = in_survey(survey, &error)
        {
            return survey.error(span, Problem::Scene { error, quantity });
        }
        let span = self.span(&error).unwrap_or(0..0);
        self.source.error(span, Problem::Scene { error, quantity: None })
    }

    fn span(&self, error: &SceneError) -> Option<Span> {
        match (error, error.quantity()?) {
            (SceneError::AboveSupport { support, .. }, _) => match (support, self.foundation_kind()?) {
                (Support::Left, "points") => self.find("foundation.points[0][1]"),
                (Support::Right, "points") => {
                    self.find(&format!("foundation.points[{}][1]", self.points()?.checked_sub(1)?))
                }
                (_, kind) => self.find(&format!("foundation.{kind}")),
            },
            (_, Quantity::Foundation) => self.find(&format!("foundation.{}", self.foundation_kind()?)),
            // Displayed, a quantity is its path.
            (_, quantity) => self.find(&quantity.to_string()),
        }
    }

    fn foundation_kind(&self) -> Option<&'static str> {
        KINDS.iter().copied().find(|kind| self.find(&format!("foundation.{kind}")).is_some())
    }

    fn points(&self) -> Option<usize> {
        self.document.get("foundation")?.get_ref().get("points")?.get_ref().as_array().map(|points| points.len())
    }

    /// Follows a path such as `load.point[2].at`.
    fn find(&self, path: &str) -> Option<Span> {
        let mut steps = path.split(['.', '[']).map(|step| step.trim_end_matches(']'));
        let mut value = self.document.get(steps.next()?)?;
        for step in steps {
            value = child(value, step)?;
        }
        Some(value.span())
    }
}

fn child<'a>(value: &'a Spanned<DeValue<'a>>, step: &str) -> Option<&'a Spanned<DeValue<'a>>> {
    match value.get_ref() {
        DeValue::Table(table) => table.get(step),
        DeValue::Array(array) => array.get(step.parse::<usize>().ok()?),
        _ => None,
    }
}

/// Name and place in the survey, for errors that are about a point of it.
fn in_survey(survey: &Survey, error: &SceneError) -> Option<(Option<&'static str>, Span)> {
    let field = |index, axis| {
        let (name, span) = survey.place(index, axis);
        Some((Some(name), span))
    };
    match (error, error.quantity()?) {
        (SceneError::AboveSupport { support: Support::Left, .. }, _) => Some((None, survey.place(0, 1).1)),
        (SceneError::AboveSupport { .. } | SceneError::TooFewPoints { .. }, _) => Some((None, survey.last_row())),
        (_, Quantity::PolylineX(i)) => field(i, 0),
        (_, Quantity::PolylineDepth(i)) => field(i, 1),
        _ => None,
    }
}
