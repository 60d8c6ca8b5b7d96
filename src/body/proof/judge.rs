//! Error bounds for answers, from their distance to the proven point: answers of solvers, and clearances or forces from another
//! program.

use super::{Brought, Errors, Off, Proof, UP, apart, energy};
use crate::body::{Body, Kind};
use crate::double::Double;
use crate::qp::NotPositiveDefinite;
use crate::solvers::Answer;

/// Variables and gradient of a given answer, with bounds on their errors (`off`) and on the norm of the gradient residual
/// (`rest`).
struct Point {
    x: Vec<Double>,
    gradient: Vec<Double>,
    off: [f64; 2],
    rest: f64,
}

impl Proof {
    /// Error bounds for clearances, given with reduced gaps where the foundation is out of reach.
    #[must_use]
    pub fn off(&self, clearance: &[f64]) -> Off {
        self.clearance_off(clearance.iter().copied().map(Double::exact), self.error)
    }

    fn clearance_off(&self, clearance: impl Iterator<Item = Double>, error: f64) -> Off {
        Off::new(apart(&self.clearance, clearance, error), self.sizes.clearance)
    }

    /// Error bounds for contact forces.
    #[must_use]
    pub fn force_off(&self, force: &[f64]) -> Off {
        let force = force.iter().copied().map(Double::exact);
        Off::new(apart(&self.force, force, self.force_error), self.sizes.force)
    }

    /// Error bounds for an energy that is itself known up to an error.
    fn energy_off(&self, (energy, error): (Double, f64)) -> Off {
        let ([lower, upper], energy) = (self.energy, energy.rounded());
        let least = (lower - energy).max(energy - upper) - error * UP;
        let most = (upper - energy).max(energy - lower) + error * UP;
        let known = [
            if least.is_nan() { f64::INFINITY } else { least.max(0.0) },
            if most.is_nan() { f64::INFINITY } else { most },
        ];
        Off::new(known, self.sizes.energy)
    }

    /// Error bounds for the answer of a solver.
    #[must_use]
    pub fn errors(&self, body: &Body, answer: &Answer) -> Errors {
        let (clearance, force) = body.clearance_within_reach(answer);
        let x: Vec<Double> = answer.x.iter().copied().map(Double::exact).collect();
        let energy = energy(body, &x, &body.program.gradient_at(&x));
        Errors { clearance: self.off(clearance), force: self.force_off(force), energy: self.energy_off(energy) }
    }

    /// The clearances and contact forces of a given answer, one of them computed from the other, and their error bounds.
    ///
    /// A clearance out of reach that is correct to its last digits only shows that there is no contact. The small displacement
    /// there is then computed from equilibrium.
    ///
    /// # Errors
    ///
    /// [`NotPositiveDefinite`], which does not occur for a valid body.
    pub fn judge(&self, body: &Body, brought: &Brought) -> Result<([Vec<f64>; 2], Errors), NotPositiveDefinite> {
        let qp = &body.program;
        let Point { x, gradient, off: [x_off, gradient_off], rest } = match brought {
            Brought::Clearance(clearance) => self.of_clearance(body, clearance)?,
            Brought::Force(force) => self.of_force(body, force)?,
        };
        let sums = qp.gradient_at(&x);
        let b = qp.right();
        let slope = |i: usize| {
            let of_energy = if body.kind == Kind::Stiffness { sums.values[i] } else { sums.values[i] + b.values[i] };
            of_energy.rounded().abs() + sums.off(i) + b.off(i)
        };
        let norm = (0..x.len()).map(|i| slope(i) * slope(i)).sum::<f64>().sqrt();
        let (known, rounded) = energy(body, &x, &sums);
        // J(x + δ) − J(x) = J'(x)ᵀδ + ½ δᵀA δ, and A δ is the residual of the gradient.
        let energy = self.energy_off((known, (rounded + x_off * (norm + rest)) * UP));
        let (clearance, force, [off, force_off]) = match body.kind {
            Kind::Stiffness => (x, gradient, [x_off, gradient_off]),
            Kind::Flexibility => (gradient, x, [gradient_off, x_off]),
        };
        // Values that may be only the rounding of the solve are set to zero.
        let rounded = |values: &[Double], off: f64| -> Vec<f64> {
            values.iter().map(|h| if h.rounded().abs() <= off { 0.0 } else { h.rounded() }).collect()
        };
        let both = [rounded(&clearance, off), rounded(&force, force_off)];
        let force = apart(&self.force, force.into_iter(), (self.force_error + force_off) * UP);
        let errors = Errors {
            clearance: self.clearance_off(clearance.into_iter(), (self.error + off) * UP),
            force: Off::new(force, self.sizes.force),
            energy,
        };
        Ok((both, errors))
    }

    /// The point that belongs to contact forces.
    fn of_force(&self, body: &Body, force: &[f64]) -> Result<Point, NotPositiveDefinite> {
        let exact: Vec<Double> = force.iter().copied().map(Double::exact).collect();
        match body.kind {
            Kind::Flexibility => Ok(self.at_variables(body, exact)),
            Kind::Stiffness => self.with_gradient(body, &vec![true; force.len()], exact),
        }
    }

    /// The point that belongs to clearances.
    fn of_clearance(&self, body: &Body, clearance: &[f64]) -> Result<Point, NotPositiveDefinite> {
        let (mut within, mut told) = (Vec::with_capacity(clearance.len()), vec![true; clearance.len()]);
        for (i, h) in clearance.iter().enumerate() {
            let (gap, reach) = (body.gap[i], body.reach.gap[i]);
            let last_digits = 2.0 * f64::EPSILON * gap.abs();
            let own = match gap.is_finite() {
                true => Double::exact(*h) - (Double::exact(gap) - Double::exact(reach)),
                false if f64::INFINITY <= *h => self.clearance[i],
                // No finite number is correct there.
                false => Double::exact(f64::NAN),
            };
            let off = (own - self.clearance[i]).rounded().abs();
            told[i] = !(body.is_out_of_reach(i) && off <= last_digits);
            within.push(own);
        }
        if body.kind == Kind::Flexibility {
            return self.with_gradient(body, &told, within);
        }
        let open: Vec<usize> = (0..within.len()).filter(|i| !told[*i]).collect();
        let x = body.program.solved(&open, &[], Some(within))?;
        Ok(self.at_variables(body, x))
    }

    fn at_variables(&self, body: &Body, x: Vec<Double>) -> Point {
        let sums = body.program.gradient_at(&x);
        let off = (0..x.len()).map(|i| sums.off(i)).fold(0.0, f64::max);
        Point { x, gradient: sums.values, off: [0.0, off], rest: 0.0 }
    }

    /// Variables with a prescribed gradient; where it is not prescribed, the variables are zero.
    fn with_gradient(&self, body: &Body, told: &[bool], gradient: Vec<Double>) -> Result<Point, NotPositiveDefinite> {
        let chosen: Vec<usize> = (0..told.len()).filter(|i| told[*i]).collect();
        let x = body.program.solved(&chosen, &gradient, None)?;
        let found = body.program.gradient_at(&x);
        let rest = |i: &usize| (found.values[*i] - gradient[*i]).rounded().abs() + found.off(*i);
        let square: f64 = chosen.iter().map(|i| rest(i) * rest(i)).sum();
        let rest = square.sqrt() * UP;
        let all = (0..told.len()).map(|i| if told[i] { gradient[i] } else { found.values[i] }).collect();
        let x_off = rest / self.least_eigenvalue * UP;
        let diagonal = body.program.profile().diagonal().fold(0.0, f64::max);
        let open = (0..told.len()).filter(|i| !told[*i]).map(|i| found.off(i)).fold(0.0, f64::max);
        // A prescribed gradient is exact; elsewhere |A δ|_i ≤ √a_ii ‖r‖/√τ.
        let gradient_off = if chosen.len() == told.len() {
            0.0
        } else {
            ((diagonal * UP).sqrt() * rest / self.least_eigenvalue.sqrt() + open) * UP
        };
        Ok(Point { x, gradient: all, off: [x_off, gradient_off], rest })
    }
}
