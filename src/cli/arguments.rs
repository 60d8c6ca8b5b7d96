//! The arguments, and the help that explains them.

use std::path::PathBuf;

use clap::builder::PossibleValue;
use clap::{Args, Parser, Subcommand, ValueEnum};
use palkki::route::{Method, Solver};

/// Intervals of a grid that nobody asked for: those of the paper's example.
pub(super) const DEFAULT_INTERVALS: usize = 30;
/// The solver that always ends, at an optimum.
pub(super) const DEFAULT_SOLVER: Solver = Solver::ActiveSet;
/// More intervals than any computer that this runs on has memory for.
const MOST_INTERVALS: usize = 10_000_000;

/// A beam above a rigid, uneven foundation: where does it touch, and how hard?
///
/// A straight elastic beam rests on a support at each end. Below it, at a known depth, lies ground that is rigid and not
/// even. Loaded, the beam sags; where it meets the ground it is carried, and where it does not it hangs free. palkki
/// finds out which is which: contact zones and points of contact, the forces in them, the reactions of the supports,
/// deflection and bending moment.
///
/// The problem and three ways to solve it are those of M. Heinisuo, "Yksinkertainen palkki jäykällä epätasaisella
/// alustalla", Rakenteiden Mekaniikka 17 (1984). The beam, its loads and the ground stand in a scene file; those of the
/// report lie in report/scenes.
#[derive(Debug, Parser)]
#[command(name = "palkki", version, propagate_version = true, after_help = EXIT_CODES, max_term_width = 100)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  an answer that passed our own check
  1  an answer that did not; it is printed, with the reason
  2  bad input or usage; the message is on standard error, nothing else is printed or written";

const SOLVE_EXAMPLES: &str = "\
Examples:
  palkki solve report/scenes/heinisuo-1984.toml --method force
  palkki solve report/scenes/ridge.toml --method force --tolerance 1e-4
  palkki solve scene.toml --method displacement --solver clarabel --intervals 200 --format json
  palkki solve scene.toml --method force --csv nodes.csv --plot beam.svg";

const CERTIFY_EXAMPLE: &str = "\
FORCES is a CSV file with the header x,force: places along the beam and forces of the foundation on
the beam, positive upwards, for example
  x,force
  2.3333,1.14
  2.6667,0.55";

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Solve a scene: one method, one solver, one answer.
    ///
    /// Without --method the answer is that of beam theory, with lift-off points that are found and not placed on a grid.
    /// The three methods of the paper cut the beam into equal intervals and hand a quadratic programme to a solver. Whoever
    /// solved it, the answer is checked by the same judge, who looks at the scene and the answer alone; the solver's own
    /// opinion of itself is printed beside the verdict and does not count. An answer is certified if it solves its own problem
    /// and its forces prove bounds for the continuous beam; the error of its deflection is at most the one that is printed.
    ///
    /// How large that error may be can be asked for: --tolerance without --intervals is a dial, which chooses the grid and
    /// prints what it took.
    #[command(after_help = SOLVE_EXAMPLES)]
    Solve(Solve),
    /// Solve a scene by every method with every solver, and set the answers side by side.
    ///
    /// Each row has its verdict, its time and two errors. The solver error is the difference from the answer of the
    /// active-set solver on the same grid: what the solver is responsible for. The model error is the difference from beam
    /// theory, where that is available: what the grid is responsible for. Both are the worst relative difference
    /// among end reactions, energy and largest deflection. The exit code is 0 if at least one answer passed our check.
    Compare(Compare),
    /// Bound the error of contact forces that somebody else computed, whoever that was.
    ///
    /// From the scene and the forces alone follow bounds on the energy from both sides and on the deflection everywhere
    /// along the beam. They are guaranteed: admissibility between the nodes is proven and rounding is counted in. The
    /// deflection that is judged is the one that these forces and the load cause. Forces that pull are cut off, and said so.
    /// The exit code is 0 if that deflection is certain to one hundredth of its largest value.
    #[command(after_help = CERTIFY_EXAMPLE)]
    Certify(Certify),
}

#[derive(Debug, Args)]
pub(super) struct Common {
    /// Scene file: beam, loads and foundation, in TOML
    #[arg(value_name = "SCENE")]
    pub(super) scene: PathBuf,
    /// A table to read, or JSON to read on
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
}

#[derive(Debug, Args)]
pub(super) struct Solve {
    /// How the beam is modelled
    #[arg(long, value_name = "METHOD", value_enum, default_value_t = MethodArgument::Exact)]
    pub(super) method: MethodArgument,
    /// Who solves the programme of a discretised method [default: active-set]
    #[arg(long, value_name = "SOLVER", value_enum)]
    pub(super) solver: Option<SolverArgument>,
    /// Equal intervals of a discretised method, at least 2 [default: 30, or as many as --tolerance takes]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = intervals)]
    pub(super) intervals: Option<usize>,
    /// Guaranteed error of the deflection, as a share of the largest deflection
    ///
    /// A discretised method refines its grid until the certified error is at most EPS, with as little work as it can, and says
    /// which grids it tried; if that cannot be reached, the best answer is printed and the exit code is 1. With beam theory the
    /// certified error has to be at most EPS.
    ///
    /// Together with --intervals the grid is fixed, and EPS is the scaled residual at which an iterative solver may stop; the
    /// check is not loosened by it [default: 1e-10].
    #[arg(long, value_name = "EPS", allow_hyphen_values = true, value_parser = tolerance)]
    pub(super) tolerance: Option<f64>,
    /// Print the nodes: in a table always, in JSON also those of more than 10000 intervals
    #[arg(long)]
    pub(super) nodes: bool,
    #[command(flatten)]
    pub(super) common: Common,
    /// Write the values along the beam to this file, as CSV: those at the nodes, or samples of the exact solution
    #[arg(long, value_name = "FILE")]
    pub(super) csv: Option<PathBuf>,
    /// Draw beam, foundation, contact forces, moment and shear into this file
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(super) struct Compare {
    #[command(flatten)]
    pub(super) common: Common,
    /// Equal intervals of the discretised methods, at least 2
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = intervals, default_value_t = DEFAULT_INTERVALS)]
    pub(super) intervals: usize,
}

#[derive(Debug, Args)]
pub(super) struct Certify {
    #[command(flatten)]
    pub(super) common: Common,
    /// Contact forces as CSV, with the header x,force
    #[arg(value_name = "FORCES")]
    pub(super) forces: PathBuf,
}

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
            Self::Exact => PossibleValue::new("exact").help("beam theory with free lift-off points, no grid"),
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
            Self(Solver::Clarabel),
            Self(Solver::Osqp),
            Self(Solver::FourStep),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.word()).help(match self.0 {
            Solver::ActiveSet => "pivots until the contact set is right; always ends, and at an optimum",
            Solver::Nsor => "over-relaxation with projection, the paper's choice for many unknowns",
            Solver::Clarabel => "interior points, a library",
            Solver::Osqp => "operator splitting, a library",
            Solver::FourStep => "the paper's own four steps, for comparison; may stop short of the optimum",
        }))
    }
}

fn intervals(text: &str) -> Result<usize, String> {
    let not = |what: &str| Err(format!("the number of intervals must be {what}, but is {text}"));
    match text.parse::<usize>() {
        Ok(..2) => not("at least 2"),
        Ok(number) if number <= MOST_INTERVALS => Ok(number),
        Err(error) if *error.kind() != std::num::IntErrorKind::PosOverflow => not("a whole number, at least 2"),
        _ => not(&format!("at most {MOST_INTERVALS}")),
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if 0.0 < number && number < f64::INFINITY => Ok(number),
        _ => Err(format!("the tolerance must be a positive, finite number, but is {text}")),
    }
}
