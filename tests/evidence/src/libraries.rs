//! Situations at the edge of what a library for quadratic programmes is made for, and what becomes of them.

use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::qp::{FreeSet, Matrix, NotPositiveDefinite, Qp, Sizes, Stationary, residual};
use palkki::route::{Method, Solver};
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::{Settings, solve_raw};

/// A situation.
#[derive(Debug, Clone, Copy)]
pub struct Situation {
    /// In words.
    pub name: &'static str,
    given: Given,
    tolerance: f64,
}

#[derive(Debug, Clone, Copy)]
enum Given {
    /// The beam of the example under its load, over `[foundation]` with this line, on so many intervals.
    Scene { foundation: &'static str, load: f64, intervals: usize },
    /// `min ½ xᵀ A x − bᵀ x, x ≥ 0` with a tridiagonal `A`: diagonal, off-diagonal, entries of `b`.
    Qp { diagonal: f64, beside: f64, linear: &'static [f64] },
}

/// What came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What the library says, or what we say where it was not asked.
    pub word: String,
    /// True if it says that it succeeded.
    pub claims: bool,
    /// Whether the answer passes our check.
    pub solved: bool,
    /// Iterations.
    pub iterations: usize,
}

const ASKED: f64 = 1e-10;

/// The free deflection of the example, `q (l³ x − 2 l x³ + x⁴)/24EI`.
const FREE: &str = "polynomial = [0, 32, 0, -0.64, 0.032]";

const fn scene(name: &'static str, foundation: &'static str, load: f64, intervals: usize) -> Situation {
    Situation { name, given: Given::Scene { foundation, load, intervals }, tolerance: ASKED }
}

const fn program(name: &'static str, diagonal: f64, beside: f64, linear: &'static [f64]) -> Situation {
    Situation { name, given: Given::Qp { diagonal, beside, linear }, tolerance: ASKED }
}

/// All of them.
pub const ALL: &[Situation] = &[
    scene("the example of the paper", "depth = 1", 1.0, 30),
    scene("no contact", "depth = 1000", 1.0, 30),
    scene("contact without pressure, everywhere", FREE, 1.0, 30),
    scene("no room at all", "depth = 0", 1.0, 30),
    scene("no load", "depth = 1", 0.0, 30),
    scene("a load that lifts", "depth = 1", -1.0, 30),
    scene("one unknown", "depth = 1", 1.0, 2),
    scene("ground at 10⁻¹² of the free deflection", "depth = 1e-10", 1.0, 30),
    scene("ground at 10¹² times the free deflection", "depth = 1e14", 1.0, 30),
    scene("ground at 10¹⁵⁰ times the free deflection", "depth = 1e152", 1.0, 30),
    scene("300 intervals", "depth = 1", 1.0, 300),
    Situation { tolerance: 1e-300, ..scene("a tolerance that nothing can reach", "depth = 1", 1.0, 6) },
    Situation { tolerance: 1e300, ..scene("a tolerance that anything reaches", "depth = 1", 1.0, 30) },
    program("no unknown at all", 2.0, -1.0, &[]),
    program("a NaN in A", f64::NAN, -1.0, &[1.0, -1.0, 1.0]),
    program("an infinite number in b", 2.0, -1.0, &[1.0, f64::INFINITY, 1.0]),
    program("A of size 10²⁰⁰", 2e200, -1e200, &[1e200, -1e200, 1e200]),
    program("A of size 10⁻²⁰⁰", 2e-200, -1e-200, &[1e-200, -1e-200, 1e-200]),
    program("A indefinite, no minimum", -2.0, 1.0, &[1.0, 1.0, 1.0]),
    program("A zero, no minimum", 0.0, 0.0, &[1.0, 1.0, 1.0]),
    program("A singular, a line of minima", 1.0, -1.0, &[0.0, 0.0]),
];

/// A quadratic program with a tridiagonal matrix; nothing is asked of its numbers.
struct Banded {
    rows: Vec<[f64; 3]>,
    linear: Vec<f64>,
}

impl Qp for Banded {
    fn dimension(&self) -> usize {
        self.rows.len()
    }

    fn matrix(&self) -> Matrix {
        Matrix::Pentadiagonal(self.rows.clone())
    }

    fn linear(&self) -> Vec<f64> {
        self.linear.clone()
    }

    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let matrix = self.matrix();
        self.linear.iter().enumerate().map(|(i, b)| matrix.row_times(i, x) - b).collect()
    }

    fn stationary(&self, _: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        Err(NotPositiveDefinite { index: 0, pivot: f64::NAN })
    }

    fn sizes(&self) -> Sizes {
        Sizes { x: 1.0, gradient: 1.0 }
    }
}

impl Situation {
    /// Hands it to a library, by the force method where it is a scene.
    pub fn run(&self, library: Solver) -> Result<Run, String> {
        match self.given {
            Given::Scene { foundation, load, intervals } => {
                let scene = read(foundation, load)?;
                let settings =
                    Settings { tolerance: self.tolerance, ..Settings::new(Method::Force, library, intervals) };
                let raw = solve_raw(&scene, &settings).map_err(|error| error.to_string())?;
                Ok(Run {
                    word: raw.run.message,
                    claims: raw.run.reports_success,
                    solved: raw.solved,
                    iterations: raw.run.iterations,
                })
            }
            Given::Qp { diagonal, beside, linear } => {
                let rows = vec![[diagonal, beside, 0.0]; linear.len()];
                let qp = Banded { rows, linear: linear.to_vec() };
                let answer = library.run(&qp, self.tolerance);
                // Its own multipliers are not believed: the gradient is taken anew.
                let found = residual(qp.sizes(), &answer.x, &qp.gradient(&answer.x));
                let solved = found <= CERTIFIED_RESIDUAL && answer.x.len() == linear.len() && !linear.is_empty();
                let (word, claims) = (answer.run.message, answer.run.reports_success);
                Ok(Run { word, claims, solved, iterations: answer.run.iterations })
            }
        }
    }
}

fn read(foundation: &str, load: f64) -> Result<Scene, String> {
    let text = format!(
        "[beam]\nlength = 10\nbending_stiffness = 1.3020833333333333\n[load]\nuniform = {load:?}\n[foundation]\n{foundation}\n"
    );
    parse("situation.toml", &text, |_| Err(ReadProblem::Missing)).map_err(|error| error.to_string())
}
