//! Finds the location in the file of the number to which a [`SceneError`] refers.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::contents::KINDS;
use super::survey::Survey;
use super::table::Span;
use super::{FileError, Problem, Source};
use crate::scene::{Profile, ProfileKey, Quantity, SceneError};

/// A scene file that has been read, with its surveys.
#[derive(Debug)]
pub(super) struct Located<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) document: &'a DeTable<'a>,
    pub(super) surveys: &'a [(Profile, Option<Survey>)],
}

impl Located<'_> {
    /// `error` with its location.
    pub(super) fn error(&self, error: SceneError) -> Box<FileError> {
        let at_support = self.at_support(&error);
        for (profile, survey) in self.surveys.iter().filter(|_| at_support.is_none()) {
            if let Some(survey) = survey
                && let Some((quantity, span)) = in_survey(survey, *profile, &error)
            {
                return survey.error(span, Problem::Scene { error, quantity });
            }
        }
        let span = at_support.or_else(|| self.span(&error)).unwrap_or(0..0);
        self.source.error(span, Problem::Scene { error, quantity: None })
    }

    /// The support to which an error refers, if the file lists supports.
    fn at_support(&self, error: &SceneError) -> Option<Span> {
        let (SceneError::AboveSupport { at, .. }
        | SceneError::BearingInGround { at, .. }
        | SceneError::RisesAtBuiltIn { at, .. }
        | SceneError::ValleyAtSupport { at, .. }
        | SceneError::CornerAtBuiltIn { at }) = error
        else {
            return None;
        };
        let supports = self.document.get("beam")?.get_ref().get("supports")?.get_ref().as_array()?;
        let place = |support: &Spanned<DeValue<'_>>| -> Option<f64> {
            match support.get_ref().get("at")?.get_ref() {
                DeValue::Float(x) => x.as_str().parse().ok(),
                DeValue::Integer(x) => x.as_str().parse().ok(),
                _ => None,
            }
        };
        let support = supports.iter().find(|support| place(support).is_some_and(|x| x <= *at && *at <= x))?;
        Some(support.span())
    }

    fn span(&self, error: &SceneError) -> Option<Span> {
        match (error, error.quantity()?) {
            (SceneError::AboveSupport { at, .. }, _) => match self.kind("foundation")? {
                "points" if *at <= 0.0 => self.find("foundation.points[0][1]"),
                "points" => self.find(&format!("foundation.points[{}][1]", self.points()?.checked_sub(1)?)),
                kind => self.find(&format!("foundation.{kind}")),
            },
            (_, Quantity::Profile(of, ProfileKey::Whole)) => {
                self.find(&format!("{}.{}", of.path(), self.kind(of.path())?))
            }
            (_, Quantity::Supports) => self.find("beam.supports").or_else(|| self.find("beam")),
            // The text of a quantity is its path.
            (_, quantity) => self.find(&quantity.to_string()),
        }
    }

    fn kind(&self, table: &str) -> Option<&'static str> {
        KINDS.iter().copied().find(|kind| self.find(&format!("{table}.{kind}")).is_some())
    }

    fn points(&self) -> Option<usize> {
        self.document.get("foundation")?.get_ref().get("points")?.get_ref().as_array().map(|points| points.len())
    }

    /// The location of a value with a path such as `load.point[2].at`.
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

/// For errors that refer to a point of a profile: the name of the number in the survey, and its location.
fn in_survey(survey: &Survey, profile: Profile, error: &SceneError) -> Option<(Option<&'static str>, Span)> {
    let field = |index, axis| {
        let (name, span) = survey.place(index, axis);
        Some((Some(name), span))
    };
    match (error, error.quantity()?) {
        (_, Quantity::Profile(of, _)) if of != profile => None,
        (SceneError::AboveSupport { at, .. }, _) if *at <= 0.0 => Some((None, survey.place(0, 1).1)),
        (SceneError::AboveSupport { .. } | SceneError::TooFewPoints { .. }, _) => Some((None, survey.last_row())),
        (_, Quantity::Profile(_, ProfileKey::PolylineX(i))) => field(i, 0),
        (_, Quantity::Profile(_, ProfileKey::PolylineDepth(i))) => field(i, 1),
        _ => None,
    }
}
