//! The exact answer of a discrete problem, proven, for the error of the solver alone.
//!
//! The contact set of an active set is only where the search begins: in integers of hundreds of bits nodes on the wrong side
//! are exchanged until (34), (35) hold by more than all rounding. What comes out is *the* optimum, better than every answer
//! that is compared with it.

use std::time::Instant;

use palkki::methods::Method;
use palkki::scene::Scene;
use palkki::solvers::Solver;
use palkki::state::Bending;
use palkki::{Settings, solve};

use palkki_evidence::authority::forward::apart;
use palkki_evidence::authority::given;
use palkki_evidence::authority::number::{Fixed, Number};

/// The finest grid with a reference: seconds, and hundreds of megabytes.
const FINEST: usize = 100_000;

/// What is known of the optimum of a discrete problem.
#[derive(Debug)]
pub(super) struct Reference {
    reaction: Fixed,
    /// Resultant of the contact that is looked at.
    contact: Fixed,
    energy: Fixed,
    /// At the interior nodes; rounding them to 64 bits moves them by less than what is told apart.
    pub(super) deflection: Vec<f64>,
    /// Exchanges that were needed.
    pub(super) exchanges: usize,
    pub(super) seconds: f64,
}

/// Observables of a floating-point answer.
#[derive(Debug)]
pub(super) struct Found<'a> {
    pub(super) reaction: f64,
    pub(super) contact: Vec<f64>,
    pub(super) energy: f64,
    pub(super) deflection: &'a [f64],
}

impl Reference {
    /// The optimum on `intervals`; none beyond [`FINEST`], and none if the search does not end. `looked_at` says which nodes
    /// belong to the contact that is looked at.
    pub(super) fn new(
        scene: &Scene,
        intervals: usize,
        bending: Bending,
        looked_at: &dyn Fn(f64) -> bool,
    ) -> Option<Self> {
        if FINEST < intervals {
            return None;
        }
        let method = if bending == Bending::AtNodes { Method::Complementarity } else { Method::Force };
        let begin = solve(scene, &Settings::new(method, Solver::ActiveSet, intervals)).ok()?.state.nodes?;
        let touches: Vec<bool> = begin.contact_force.iter().map(|p| 0.0 < *p).collect();

        let start = Instant::now();
        let problem = given::problem(scene, intervals, bending)?;
        let (solution, _, exchanges) = problem.optimum(touches)?;
        let forces = begin.x.iter().zip(&solution.contact_force[1..]);
        let looked_at = forces.filter(|(x, _)| looked_at(**x)).map(|(_, p)| p);
        Some(Self {
            reaction: solution.left_reaction(&problem.loads[0]),
            contact: looked_at.fold(Fixed::zero(), |sum, p| sum.plus(p)),
            energy: solution.energy(&problem.loads),
            deflection: (1..intervals).map(|i| solution.deflection(i).to_double()).collect(),
            exchanges,
            seconds: start.elapsed().as_secs_f64(),
        })
    }

    /// Relative errors of an answer of the same discrete problem: end reaction, contact, the worst of all nodal deflections
    /// against the largest, energy. Differences are taken exactly.
    pub(super) fn errors(&self, found: &Found<'_>) -> [f64; 4] {
        let share = |found: f64, exact: &Fixed| apart(found, exact) / exact.to_double().abs();
        let contact = if found.contact.iter().all(|p| p.is_finite()) {
            let sum = found.contact.iter().fold(Fixed::zero(), |sum, p| sum.plus(&Fixed::of(*p)));
            sum.minus(&self.contact).magnitude().to_double() / self.contact.to_double().abs()
        } else {
            f64::NAN
        };
        let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
        for (v, exact) in found.deflection.iter().zip(&self.deflection) {
            let off = (v - exact).abs();
            // `max` would overlook NaN.
            worst = if off.is_nan() || worst.is_nan() { f64::NAN } else { worst.max(off) };
            largest = largest.max(exact.abs());
        }
        [share(found.reaction, &self.reaction), contact, worst / largest, share(found.energy, &self.energy)]
    }

    /// Reaction, contact and energy, rounded once.
    pub(super) fn sums(&self) -> [f64; 3] {
        [&self.reaction, &self.contact, &self.energy].map(Fixed::to_double)
    }
}
