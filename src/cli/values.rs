//! The words that options accept.

use clap::ValueEnum;
use clap::builder::PossibleValue;
use palkki::route::{Method, Solver};

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
            Self::Exact => PossibleValue::new("exact").help("the grid-free solution of beam theory"),
            Self::Discretised(method) => PossibleValue::new(method.name()).help(match method {
                Method::Complementarity => "finite differences: no penetration, no tension, one of the two everywhere",
                Method::Displacement => "beam elements: least potential energy without penetration at the nodes",
                Method::Force => "flexibility: least complementary energy without tension at the nodes",
            }),
        })
    }
}

/// `--method` of `export`.
#[derive(Debug, Clone, Copy)]
pub(super) struct GridMethod(pub(super) Method);

impl ValueEnum for GridMethod {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self(Method::Complementarity), Self(Method::Displacement), Self(Method::Force)]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        MethodArgument::Discretised(self.0).to_possible_value()
    }
}

/// `--form` of `export`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Form {
    /// clearances or contact forces alone, with a full matrix: a scene with a [body]
    Dense,
    /// with moments as further variables
    Sparse,
    /// the same as one file in free MPS with `QUADOBJ`, in the units of the scene
    Qps,
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
        Some(PossibleValue::new(self.0.name()).help(match self.0 {
            Solver::ActiveSet => "exchanges nodes until the contact set is right; always ends at the optimum",
            Solver::Nsor => "projected over-relaxation, which the paper calls usable for many unknowns",
            #[cfg(feature = "clarabel")]
            Solver::Clarabel => "interior points, a library",
            #[cfg(feature = "osqp")]
            Solver::Osqp => "operator splitting, a library",
            Solver::FourStep => "the paper's own four steps, for comparison; may stop short of the optimum",
        }))
    }
}

/// `--load` of `certify`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum LoadArgument {
    /// distributed along the beam, as in the scene; FORCES may lie anywhere
    Distributed,
    /// lumped at the nodes of equal intervals; FORCES has every inner node, with 0 where nothing touches
    Nodal,
}
