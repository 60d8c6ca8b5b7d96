//! The words and numbers that arguments take, and how others are refused.

use clap::ValueEnum;
use clap::builder::PossibleValue;
use palkki::route::{Method, Solver};

/// More intervals than any computer that this runs on has memory for.
const MOST_INTERVALS: usize = 10_000_000;

/// `--format`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Json,
}

/// `--method`.
#[derive(Debug, Clone, Copy)]
pub(super) enum MethodArgument {
    Exact,
    Discretised(Method),
}

impl MethodArgument {
    pub(super) fn discretised(self) -> Option<Method> {
        match self {
            Self::Exact => None,
            Self::Discretised(method) => Some(method),
        }
    }
}

impl ValueEnum for MethodArgument {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self::Exact,
            Self::Discretised(Method::Complementarity),
            Self::Discretised(Method::Displacement),
            Self::Discretised(Method::Force),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Exact => PossibleValue::new("exact").help("the exact solution of beam theory, no grid"),
            Self::Discretised(method) => PossibleValue::new(method.word()).help(match method {
                Method::Complementarity => "finite differences: no penetration, no tension, one of the two everywhere",
                Method::Displacement => "beam elements: least potential energy without penetration at the nodes",
                Method::Force => "flexibility: least complementary energy without tension at the nodes",
            }),
        })
    }
}

/// `--solver`.
#[derive(Debug, Clone, Copy)]
pub(super) struct SolverArgument(pub(super) Solver);

impl ValueEnum for SolverArgument {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self(Solver::ActiveSet),
            Self(Solver::Nsor),
            #[cfg(feature = "clarabel")]
            Self(Solver::Clarabel),
            #[cfg(feature = "osqp")]
            Self(Solver::Osqp),
            Self(Solver::FourStep),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.word()).help(match self.0 {
            Solver::ActiveSet => "exchanges nodes until the contact set is right; always ends at the optimum",
            Solver::Nsor => "projected over-relaxation, which the paper recommends for many unknowns",
            #[cfg(feature = "clarabel")]
            Solver::Clarabel => "interior points, a library",
            #[cfg(feature = "osqp")]
            Solver::Osqp => "operator splitting, a library",
            Solver::FourStep => "the paper's own four steps, for comparison; may stop short of the optimum",
        }))
    }
}

/// `--load` of `certify`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LoadArgument {
    Distributed,
    Nodal,
}

impl ValueEnum for LoadArgument {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Distributed, Self::Nodal]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Distributed => PossibleValue::new("distributed")
                .help("distributed along the beam, as in the scene; FORCES may lie anywhere"),
            Self::Nodal => PossibleValue::new("nodal").help(
                "lumped at the nodes of equal intervals; FORCES has every inner node, with 0 where nothing touches",
            ),
        })
    }
}

/// `--intervals`.
pub(super) fn intervals(text: &str) -> Result<usize, String> {
    let not = |what: &str| Err(format!("the number of intervals must be {what}, but is {text}"));
    match text.parse::<usize>() {
        Ok(..2) => not("at least 2"),
        Ok(number) if number <= MOST_INTERVALS => Ok(number),
        Err(error) if *error.kind() != std::num::IntErrorKind::PosOverflow => not("a whole number, at least 2"),
        _ => not(&format!("at most {MOST_INTERVALS}")),
    }
}

/// `--tolerance`.
pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if 0.0 < number && number < f64::INFINITY => Ok(number),
        _ => Err(format!("the tolerance must be a positive, finite number, but is {text}")),
    }
}
