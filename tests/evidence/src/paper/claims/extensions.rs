//! "The methods extend to any elastic body whose condensed stiffness or flexibility matrix can be computed, and to an elastic
//! foundation; further study is needed where the rigid motion of the body is not known beforehand."

use nalgebra::{DMatrix, DVector};
use palkki::methods::{Method, flexibility};
use palkki::qp::{Dense, Sizes, residual};
use palkki::scene::{Foundation, SceneError};
use palkki::solvers::Solver;
use palkki::{Settings, solve_raw};

use super::curved::scene_on;
use super::{Claim, Verdict, bound};
use crate::paper::{INTERVALS, beam};

/// A taut string of span 10 under tension 10 and a unit load, above a flat foundation at depth 1: touched or not, the
/// quadratic program (32) with another `K`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taut {
    /// Scaled residual of the optimality conditions.
    pub residual: f64,
    /// End reaction over that of the closed form `√(2 S q u₀)`, minus one, on 200 intervals.
    pub end_reaction: f64,
}

/// Solves the string with the active set.
///
/// Closed form: `S v'' = −q` up to the lift-off point `b`, where `v = u₀`, `v' = 0`: `b² = 2 S u₀/q`, reaction `q b`.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "200 intervals")]
pub fn any_body() -> Taut {
    const INTERVALS: usize = 200;
    let (length, tension, load, depth) = (10.0, 10.0, 1.0, 1.0_f64);
    let n = INTERVALS - 1;
    let spacing = length / INTERVALS as f64;
    let stiffness = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => 2.0 * tension / spacing,
        1 => -tension / spacing,
        _ => 0.0,
    });
    let depths = DVector::from_element(n, depth);
    let loads = DVector::from_element(n, load * spacing);
    let linear = &stiffness * &depths - &loads;
    let qp = Dense { matrix: stiffness, linear, sizes: Sizes { x: depth, gradient: load * length } };
    let answer = Solver::ActiveSet.run(&qp, 0.0);
    let first = depth - answer.x[0];
    let reaction = tension * first / spacing + 0.5 * load * spacing;
    Taut {
        residual: residual(qp.sizes, &answer.x, &answer.gradient),
        end_reaction: reaction / (2.0 * tension * load * depth).sqrt() - 1.0,
    }
}

impl Taut {
    /// Whether the method works as it is: optimal, and within one per cent of the closed form.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.residual <= 1e-9 && self.end_reaction.abs() <= 0.01 { Verdict::Confirmed } else { Verdict::Refuted }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "any_elastic_body",
            statement: "The methods extend to any elastic body whose stiffness or flexibility matrix can be computed.",
            verdict: self.verdict(),
            reading: None,
            summary: format!("a taut string: end reaction within {} of its closed form", bound(self.end_reaction)),
            evidence: format!(
                "The solvers take any symmetric positive definite matrix. Tried on a body that is not a beam, a taut string on 200 \
                 intervals: scaled residual below {}, end reaction within {} of its closed form √(2 S q u₀).",
                bound(self.residual.max(f64::EPSILON)),
                bound(self.end_reaction)
            ),
        }
    }
}

/// The beam of the example on elastic springs that it touches from the start, `u = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// Scaled residual of the optimality conditions.
    pub residual: f64,
    /// Deflection at mid-span over that of the series solution, minus one.
    pub deflection: f64,
    /// Springs that are not pressed: where none is, no contact changes, and nothing is known of contact.
    pub lifted: usize,
}

/// Foundation modulus `k` \[force / length²\].
const MODULUS: f64 = 0.5;
const SPRING_INTERVALS: usize = 60;

/// Solves `min ½ pᵀ (C + I/(kΔ)) p − (C q)ᵀ p, p ≥ 0`: the clearance of a spring that carries `p` is `p/(kΔ)` larger.
///
/// Authority: `v(l/2) = Σ (4 q₀ / m π) sin(m π/2) / (EI (m π/l)⁴ + k)`, `m` odd (Hetényi 1946), while all springs are pressed.
///
/// # Errors
///
/// None; the type is that of [`beam`].
#[expect(clippy::cast_precision_loss, reason = "60 intervals")]
pub fn elastic_foundation() -> Result<Springs, SceneError> {
    let beam = beam()?;
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let n = SPRING_INTERVALS - 1;
    let spacing = l / SPRING_INTERVALS as f64;
    let c = DMatrix::from_fn(n, n, |i, j| flexibility(l, ei, n, i + 1, j + 1));
    let loads = DVector::from_element(n, spacing);
    let linear = &c * &loads;
    let matrix = &c + DMatrix::identity(n, n) / (MODULUS * spacing);
    let qp = Dense { matrix, linear, sizes: Sizes { x: l, gradient: 1.0 / MODULUS } };
    let answer = Solver::ActiveSet.run(&qp, 0.0);
    let deflection = answer.x[n / 2] / (MODULUS * spacing);

    let term = |m: usize| {
        let wave = m as f64 * std::f64::consts::PI;
        let sign = if m % 4 == 1 { 1.0 } else { -1.0 };
        let ratio = wave / l;
        4.0 / wave * sign / (ei * ratio * ratio * ratio * ratio + MODULUS)
    };
    let series: f64 = (0..500).rev().map(|k| term(2 * k + 1)).sum();
    Ok(Springs {
        residual: residual(qp.sizes, &answer.x, &answer.gradient),
        deflection: deflection / series - 1.0,
        lifted: answer.x.iter().filter(|force| **force <= 0.0).count(),
    })
}

impl Springs {
    /// Open as long as all springs are pressed: a beam on springs that never let go is no contact problem. Otherwise confirmed if
    /// the method works as it is: optimal, and within one per cent of the series.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match (self.residual <= 1e-9 && self.deflection.abs() <= 0.01, self.lifted) {
            (false, _) => Verdict::Refuted,
            (true, 0) => Verdict::Open,
            (true, _) => Verdict::Confirmed,
        }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "elastic_foundation",
            statement: "The methods extend to an elastic foundation.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "on {} springs, {} of which lift off, within {} of the series solution; contact is not tried",
                SPRING_INTERVALS - 1,
                self.lifted,
                bound(self.deflection)
            ),
            evidence: format!(
                "The force method with the flexibility of springs added to the diagonal of C, {SPRING_INTERVALS} intervals: scaled residual \
                 below {}, deflection at mid-span within {} of the series solution of a beam on an elastic foundation (Hetényi 1946). \
                 That decides nothing: {} of {} springs lift off, so no contact comes or goes, and springs beside each other \
                 are not the elastic body that the paper speaks of.",
                bound(self.residual.max(f64::EPSILON)),
                bound(self.deflection),
                self.lifted,
                SPRING_INTERVALS - 1,
            ),
        }
    }
}

/// The beam of the example with its supports taken away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unsupported {
    /// Eigenvalues of the stiffness that vanish beside the largest one: rigid motions.
    pub rigid_motions: usize,
    /// Whether step 1° of the paper's algorithm can be carried out.
    pub first_step_works: bool,
    /// Whether the active set solves it from a rigid beam on the ground below the resultant of the loads.
    pub solved: bool,
}

/// The condensed stiffness of an unsupported beam with 29 inner nodes and two ends, and what step 1° makes of it.
///
/// Deflections of the ends are added to those of the supported beam: `K_free = Bᵀ K B` with `B v = v − chord of the ends`.
///
/// # Errors
///
/// None; the type is that of [`beam`].
#[expect(clippy::cast_precision_loss, reason = "30 intervals")]
pub fn unknown_rigid_motion() -> Result<Unsupported, SceneError> {
    let beam = beam()?;
    let n = 29;
    let c = DMatrix::from_fn(n, n, |i, j| flexibility(beam.length(), beam.bending_stiffness(), n, i + 1, j + 1));
    let chord = |i: usize, end: usize| {
        let share = (i + 1) as f64 / (n + 1) as f64;
        if end == 0 { 1.0 - share } else { share }
    };
    let relative = DMatrix::from_fn(n, n + 2, |i, j| match j {
        0 => -chord(i, 0),
        j if j == n + 1 => -chord(i, 1),
        j => f64::from(u8::from(j == i + 1)),
    });
    let stiffness = c.try_inverse().unwrap_or_else(|| DMatrix::zeros(n, n));
    let free = relative.transpose() * stiffness * &relative;
    let eigenvalues = free.clone().symmetric_eigenvalues();
    let largest = eigenvalues.max();
    // A x = b has a solution only if b does no work on the motions that A takes to zero.
    let loads = DVector::from_element(n + 2, 1.0);
    let motions = [DVector::from_element(n + 2, 1.0), DVector::from_fn(n + 2, |i, _| i as f64)];
    let is_rigid = |motion: &DVector<f64>| (&free * motion).amax() <= 1e-9 * largest * motion.amax();
    let first_step_works = !motions.iter().any(|motion| is_rigid(motion) && 1e-9 < loads.dot(motion).abs());
    let ground = Foundation::Polyline { points: vec![[0.0, 1.0], [4.0, 0.5], [10.0, 1.0]] };
    let lies = scene_on(vec![], None, ground)?;
    Ok(Unsupported {
        solved: solve_raw(&lies, &Settings::new(Method::Force, Solver::ActiveSet, INTERVALS))?.solved,
        rigid_motions: eigenvalues.iter().filter(|e| e.abs() <= 1e-9 * largest).count(),
        first_step_works,
    })
}

impl Unsupported {
    /// Confirmed if there are rigid motions, the algorithm does not even start, and another start is enough.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.rigid_motions == 2 && !self.first_step_works && self.solved {
            Verdict::Confirmed
        } else {
            Verdict::Refuted
        }
    }

    pub(super) fn claim(&self) -> Claim {
        Claim {
            name: "unknown_rigid_motion",
            statement: "Where the rigid motion of the body is not known beforehand, further study is needed.",
            verdict: self.verdict(),
            reading: None,
            summary: format!(
                "without supports there are {} rigid motions, and step 1° {}",
                self.rigid_motions,
                if self.first_step_works { "has a solution" } else { "has no solution" },
            ),
            evidence: format!(
                "Without supports the condensed stiffness has {} vanishing eigenvalues, the rigid motions, on which the load does work, \
                 and C does not exist: step 1° of the algorithm {}. The quadratic program is still convex, and the further study is a step before it: a rigid \
                 beam is laid on the ground below the resultant of the loads, and rests on two places. From these the active set \
                 {} the example without supports over a ridge on {INTERVALS} intervals.",
                self.rigid_motions,
                if self.first_step_works { "can be carried out" } else { "cannot be carried out" },
                if self.solved { "solves" } else { "does not solve" },
            ),
        }
    }
}
