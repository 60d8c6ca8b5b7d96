//! The command-line arguments and their help texts.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use palkki::DEFAULT_TOLERANCE;
use palkki::route::Solver;
use palkki::text::{DIGITS, MOST_DIGITS};

use super::explain::{EXAMPLE as EXPLAIN_EXAMPLE, Explain};
use super::find::{EXAMPLES as FIND_EXAMPLES, Find};
use super::json::MOST_INTERVALS_WITH_NODES;
use super::numbers::{depth_tolerance, digits, intervals, number, steps, tolerance};
pub(super) use super::values::{Form, Format, GridMethod, LoadArgument, MethodArgument, SolverArgument};

/// Default number of intervals of a grid: as in the paper's example.
pub(super) const DEFAULT_INTERVALS: usize = 30;
/// Default solver: it always ends, at an optimum.
pub(super) const DEFAULT_SOLVER: Solver = Solver::ActiveSet;

/// A beam on an uneven foundation: where does it touch, and how hard?
///
/// palkki computes contacts, contact forces, reactions, deflection and bending moment of an elastic beam above a rigid or elastic foundation that
/// can only push. Supports are simple, built in, elastic or compression-only; without a list of supports there is a simple one at each end. The
/// beam may have steps of its bending stiffness, hinges, elastic joints, an initial shape and an axial force. Any elastic body, given by its
/// stiffness or flexibility matrix, can replace the beam.
///
/// The problem with two simple supports and the three methods on a grid come from M. Heinisuo, "Yksinkertainen palkki jäykällä epätasaisella
/// alustalla", Rakenteiden Mekaniikka 17 (1984). A scene file describes the beam, its loads and the foundation; report/pages/scene-file.md lists
/// its keys, and report/scenes has examples.
#[derive(Debug, Parser)]
#[command(name = "palkki", version, propagate_version = true, after_help = EXIT_CODES, max_term_width = 100)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  the answer is certified
  1  it is not certified, or there is no answer; the reason is printed, with the answer if there is one
  2  bad input or usage; the message is on standard error, nothing else is printed or written";

const SOLVE_EXAMPLES: &str = "\
Examples:
  palkki solve report/scenes/heinisuo-1984.toml --method force
  palkki solve report/scenes/ridge.toml --method force --tolerance 1e-4
  palkki solve report/scenes/ridge.toml --method displacement --solver clarabel -n 200 -f json
  palkki solve report/scenes/ridge.toml --method force --csv nodes.csv --plot beam.svg";

const COMPARE_EXAMPLE: &str = "\
Examples:
  palkki compare report/scenes/heinisuo-1984.toml
  palkki compare report/scenes/ridge.toml --intervals 100 --format json";

const CERTIFY_EXAMPLE: &str = "\
FORCES is a CSV file with the header x,force: positions along the beam, and the forces of the
foundation on the beam, positive upwards, all of them.
On an elastic foundation (foundation.stiffness) a force is that of the spring at a node. It is
spread evenly over half the distance to its neighbours; list the nodes without a force as well,
with 0. If the supports allow a rigid motion, it is chosen so that the springs exert these forces as
nearly as possible. The bound is on the difference of its deflection from that of the continuous
beam.

For a scene with a [body] the header is i,force or i,clearance: degrees of freedom, from 1, with
contact forces or clearances. The largest error of a clearance is then bounded from both sides.

Examples:
  printf 'x,force\\n4,5.4167\\n' > forces.csv
  palkki certify report/scenes/kink.toml forces.csv

  palkki solve report/scenes/ridge.toml --method force --csv nodes.csv
  cut -d, -f1,4 nodes.csv | sed 1s/contact_// > nodal.csv
  palkki certify report/scenes/ridge.toml nodal.csv --load nodal --format json

  cp report/scenes/bodies/two-beams.* .
  palkki certify two-beams.toml two-beams.answer.csv";

const SWEEP_EXAMPLES: &str = "\
PATH is a number as the scene file writes it, for example load.point[0].at, load.uniform,
foundation.depth, foundation.points[2].depth, beam.bending_stiffness, beam.supports[1].level. A path
that the scene does not have is answered with those that it has.

Examples:
  palkki sweep report/scenes/heinisuo-1984.toml --vary foundation.depth --from 0.5 --to 8
  palkki sweep report/scenes/kink.toml --vary load.point[0].at --from 0 --to 10 --plot kink.svg
  palkki sweep report/scenes/survey.toml --vary load.point[0].at,load.point[1].at \\
    --from 0 --to 4 --envelope";

const EXPORT_EXAMPLES: &str = "\
Examples:
  palkki export report/scenes/ridge.toml --method force --intervals 30 --to ridge
  palkki solve ridge/body.toml --csv solved.csv
  cut -d, -f1,2 solved.csv > answer.csv
  palkki certify ridge/body.toml answer.csv

  palkki export report/scenes/ridge.toml --method displacement -n 300 --to sparse --form sparse
  palkki export report/scenes/ridge.toml --method force -n 300 --to qps --form qps";

const COMPLETIONS_EXAMPLE: &str = "\
Examples:
  mkdir -p ~/.local/share/bash-completion/completions ~/.config/fish/completions
  palkki completions bash > ~/.local/share/bash-completion/completions/palkki
  palkki completions fish > ~/.config/fish/completions/palkki.fish";

const MANUAL_EXAMPLE: &str = "\
Examples:
  palkki manual > palkki.1
  palkki manual solve > palkki-solve.1";

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Solve a scene: one method, one solver, one answer.
    ///
    /// Without --method the solution needs no grid: its unknowns are the positions where the beam lifts off. The three methods of the paper divide the
    /// beam into equal intervals and give a quadratic program to a solver. Every answer is checked from the scene and the answer alone. It is certified
    /// if it solves its discrete problem and if a bound on its error is proven. The bound covers the deflection, each reaction, the total contact force
    /// and the energy. It is at most 10 % of the largest value of each, or the tolerance if that is smaller, and 1e-6 without a grid. The solver's own
    /// status is printed but not used.
    ///
    /// With --tolerance and without --intervals the grid is refined until the proven errors are small enough.
    #[command(after_help = SOLVE_EXAMPLES)]
    Solve(Solve),
    /// Solve a scene by every method with every solver, and print the answers side by side.
    ///
    /// Each row has its status, its time and two errors. The solver error is the difference from the answer of the active-set solver on the same grid.
    /// The model error is the difference from the grid-free solution, if there is one. Both are the largest relative difference of end reactions, energy
    /// and largest deflection. The exit code is 0 if at least one answer is certified.
    #[command(after_help = COMPARE_EXAMPLE)]
    Compare(Compare),
    /// Bound the error of contact forces that any program computed.
    ///
    /// The bounds are proven from the scene and the forces alone: on the energy from both sides, and on the deflection along the whole beam. The
    /// deflection is the one that the forces cause together with the load (see --load). Tensile forces are set to zero, and the output says so.
    /// The exit code is 0 if the error of the deflection is proven to be at most 10 % of its largest value.
    #[command(after_help = CERTIFY_EXAMPLE)]
    Certify(Certify),
    /// Vary one number of a scene: an answer for each value, and the values at which something happens.
    ///
    /// Each answer is grid-free, and checked and certified by itself. Between them are the events. At an event a contact appears, is lost, becomes a zone
    /// or a point, splits, merges or moves over an edge, the regime changes, or a support begins or ceases to be in tension. Each event is a root of the
    /// condition that decides it, to twelve digits. At least 128 values are examined; an event that is undone within a step may be missed. The exit
    /// code is 0 if every answer is certified.
    #[command(after_help = SWEEP_EXAMPLES)]
    Sweep(Sweep),
    /// Find the values of one number of a scene for which the beam reaches something.
    ///
    /// The output lists all values between A and B that the search finds, to rounding, in the order from A to B. The certified answers just below and
    /// just above each value are printed with it. The search examines 256 values, and more where the condition may be satisfied between two of them. A
    /// condition that is satisfied and lost again within a 256th of the range may be missed. If the quantity jumps past the number, as a shear force
    /// does where a load passes, the value of the jump is printed and marked. If no value satisfies the condition, the nearest one is printed with what
    /// is reached there, and the exit code is 1.
    #[command(after_help = FIND_EXAMPLES)]
    Find(Find),
    /// Print the equations of the grid-free solution with their numbers, to be followed by hand.
    ///
    /// On a rigid foundation these are nodes and spans, the three-moment equation where two spans meet, and one equation for each side where the beam has
    /// a given slope. On an elastic foundation they are the equations of each link. Each equation is printed with its numbers and its residual. The exit
    /// code is that of solve.
    #[command(after_help = EXPLAIN_EXAMPLE)]
    Explain(Explain),
    /// Write the quadratic program of a beam on a grid, for other solvers.
    ///
    /// The program is written as a scene with a [body], whose matrix and gaps or loads are files, or in the sparse variables that the libraries receive.
    /// These minimise ½ xᵀ P x + qᵀ x subject to lower ≤ A x ≤ upper. names.csv lists what each variable is.
    #[command(after_help = EXPORT_EXAMPLES)]
    Export(Export),
    /// Print the completions of commands and options for a shell.
    #[command(after_help = COMPLETIONS_EXAMPLE)]
    Completions {
        /// The shell that reads it
        #[arg(value_name = "SHELL", value_enum)]
        shell: clap_complete::Shell,
    },
    /// Print the manual as a man page: that of palkki, or that of a command.
    #[command(after_help = MANUAL_EXAMPLE)]
    Manual {
        /// The command
        #[arg(value_name = "COMMAND")]
        command: Option<String>,
    },
}

/// The scene, and how numbers of its answer are written.
#[derive(Debug, Args)]
pub(super) struct SceneArgument {
    /// Scene file: beam, supports, loads and foundation, or any elastic body, in TOML; `-` is standard input
    #[arg(value_name = "SCENE")]
    pub(super) path: PathBuf,
    // JSON has all digits.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = digits, default_value_t = DIGITS, help = digits_help())]
    pub(super) digits: usize,
}

#[derive(Debug, Args)]
pub(super) struct Common {
    /// Text with tables, or JSON for scripts
    #[arg(short, long, value_name = "FORMAT", value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    #[command(flatten)]
    pub(super) scene: SceneArgument,
}

#[derive(Debug, Args)]
pub(super) struct Solve {
    /// How the beam is modelled
    #[arg(short, long, value_name = "METHOD", value_enum, default_value_t = MethodArgument::Exact)]
    pub(super) method: MethodArgument,
    // Options that only some methods accept have no default that clap could print.
    #[arg(short, long, value_name = "SOLVER", value_enum, help = solver_help())]
    pub(super) solver: Option<SolverArgument>,
    #[arg(short = 'n', long, value_name = "N", allow_hyphen_values = true, value_parser = intervals, help = intervals_help())]
    pub(super) intervals: Option<usize>,
    /// Proven error of the deflection, as a share of the largest deflection
    #[arg(short, long, value_name = "EPS", allow_hyphen_values = true, value_parser = tolerance, long_help = tolerance_help())]
    pub(super) tolerance: Option<f64>,
    #[arg(long, help = nodes_help())]
    pub(super) nodes: bool,
    /// Without a grid: derivatives of reactions, contacts and energy with respect to depth, stiffness, loads and supports
    #[arg(long)]
    pub(super) derivatives: bool,
    /// Without a grid: what is known if each depth may have an error of this size
    #[arg(long, value_name = "DELTA", allow_hyphen_values = true, value_parser = depth_tolerance)]
    pub(super) depth_tolerance: Option<f64>,
    #[command(flatten)]
    pub(super) common: Common,
    /// Write the values along the beam to this file, as CSV: at the nodes, or samples of the grid-free solution. `-` is standard
    /// output, and the answer then goes to standard error
    #[arg(long, value_name = "FILE")]
    pub(super) csv: Option<PathBuf>,
    /// Draw beam, foundation, contact forces, moment and shear into this file, or `-` as above
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
    /// Write a proof to this file, or `-` as above: a deflection and a moment field in fractions, as JSON. Anybody can check that the
    /// energy of the beam lies between theirs, with the 250 lines of report/check.rs or a checker of their own
    #[arg(long, value_name = "FILE")]
    pub(super) proof: Option<PathBuf>,
}

fn solver_help() -> String {
    format!("Solver of the quadratic program of a discretised method [default: {DEFAULT_SOLVER}]")
}

fn intervals_help() -> String {
    format!(
        "Equal intervals of a discretised method, at least 2 [default: {DEFAULT_INTERVALS}, or as many as --tolerance takes]"
    )
}

fn tolerance_help() -> String {
    format!(
        "Required proven error of deflection, reactions, contact force and energy, as a share of the largest value of each\n\n\
         A discretised method refines its grid until the proven errors are at most EPS, and the output lists the grids it \
         tried. If EPS is not reached, the best answer is printed and the exit code is 1. The grid-free solution is \
         certified only if its proven errors are at most EPS and at most 1e-6.\n\n\
         Together with --intervals the grid is fixed, and EPS is the scaled residual at which an iterative solver may stop. \
         The check does not become looser [default: {DEFAULT_TOLERANCE:e}]."
    )
}

fn digits_help() -> String {
    format!("Significant digits of results in text, at most {MOST_DIGITS}; JSON and CSV have all")
}

fn nodes_help() -> String {
    format!("Print the nodes: in a table always, in JSON also those of more than {MOST_INTERVALS_WITH_NODES} intervals")
}

#[derive(Debug, Args)]
pub(super) struct Compare {
    #[command(flatten)]
    pub(super) common: Common,
    /// Equal intervals of the discretised methods, at least 2
    #[arg(short = 'n', long, value_name = "N", allow_hyphen_values = true, value_parser = intervals, default_value_t = DEFAULT_INTERVALS)]
    pub(super) intervals: usize,
}

#[derive(Debug, Args)]
pub(super) struct Certify {
    #[command(flatten)]
    pub(super) common: Common,
    /// Contact forces as CSV, with the header x,force; `-` is standard input
    #[arg(value_name = "FORCES")]
    pub(super) forces: PathBuf,
    /// How the program that computed the forces put the load on the beam
    ///
    /// The error is that of the deflection which the forces and the load cause together. Under a distributed load q the beam also
    /// bends between the nodes. A load that is lumped at nodes with the spacing Δ leaves that out, and the deflection at mid-span is
    /// smaller by q Δ² l² / (96 EI). The bounds are those of the beam under the distributed load either way.
    #[arg(long, value_name = "LOAD", value_enum, default_value = "distributed")]
    pub(super) load: LoadArgument,
}

#[derive(Debug, Args)]
pub(super) struct Export {
    #[command(flatten)]
    pub(super) common: Common,
    /// The method whose program it is
    #[arg(short, long, value_name = "METHOD", value_enum)]
    pub(super) method: GridMethod,
    /// Equal intervals, at least 2
    #[arg(short = 'n', long, value_name = "N", allow_hyphen_values = true, value_parser = intervals, default_value_t = DEFAULT_INTERVALS)]
    pub(super) intervals: usize,
    /// The folder for the files; it is made if there is none
    #[arg(long, value_name = "FOLDER")]
    pub(super) to: PathBuf,
    /// Variables of the program
    #[arg(long, value_name = "FORM", value_enum, default_value = "dense")]
    pub(super) form: Form,
}

/// What is varied, and how far.
#[derive(Debug, Args)]
pub(super) struct Varied {
    /// The number that is varied. Of several, with commas between them, the others are changed by the same amount as the first, or by
    /// minus the amount after a minus sign. `[*]` stands for each index. A point load beyond the beam is no load, also in the file
    #[arg(long, value_name = "PATH[,PATH…]")]
    pub(super) vary: String,
    /// Its first value
    #[arg(long, value_name = "A", allow_hyphen_values = true, value_parser = number)]
    pub(super) from: f64,
    /// Its last value
    #[arg(long, value_name = "B", allow_hyphen_values = true, value_parser = number)]
    pub(super) to: f64,
}

#[derive(Debug, Args)]
pub(super) struct Sweep {
    #[command(flatten)]
    pub(super) common: Common,
    #[command(flatten)]
    pub(super) varied: Varied,
    /// How many values, both ends included, at least 2
    #[arg(short = 'n', long, value_name = "N", allow_hyphen_values = true, value_parser = steps, default_value_t = 101)]
    pub(super) steps: usize,
    /// Positions along the beam, with commas between them: deflection, slope, moment and shear force there for each value
    #[arg(long, value_name = "X[,X…]", value_delimiter = ',', allow_hyphen_values = true, value_parser = number)]
    pub(super) at: Vec<f64>,
    /// Largest and least moment, shear force and reactions over all values. The governing moments and the reactions are refined
    /// between the values
    #[arg(long)]
    pub(super) envelope: bool,
    /// Write a row for each value to this file, as CSV; `-` is standard output, and the answer then goes to standard error. With
    /// --envelope: a row for each place
    #[arg(long, value_name = "FILE")]
    pub(super) csv: Option<PathBuf>,
    /// With --envelope: draw that; else draw reactions, extremes and contacts over the value, with the events, into this file, or `-` as above
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}

/// The finest grid whose nodes are printed, written or drawn: their text needs some hundred megabytes per million intervals.
pub(super) const MOST_INTERVALS_WRITTEN: usize = 3_000_000;
