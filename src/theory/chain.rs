//! A first guess of the contacts: a chain of stiff links with elastic hinges above sampled positions of the profile.
//!
//! The unknowns are the clearances `s = g − v ≥ 0`, the contact forces `p ≥ 0` and the moments `m = −v''` at the samples. With the
//! second difference `(B y)_i = (y_{i+1} − y_i)/Δ_i − (y_i − y_{i−1})/Δ_{i−1}` and the lumped loads `f`,
//!
//! ```text
//! B s − W m = B u + ρ        bending between samples
//! B m − p   = −f             equilibrium
//! s_i p_i   = 0              contact
//! ```
//!
//! A link near contact has its elasticity at its two ends (Hencky's chain: `Δ/2` at each end, `ρ = 0`), because a beam splits the force
//! at a lift-off position between samples and its contacts have holes. A link far from contact is a beam (`Δ/3` and `Δ/6`, `ρ` the end
//! rotations under its load), which is exact for any length.
//!
//! A spring exerts the force `k (v − d) = k (s₀ − s)`, where `s₀` is the clearance without force. Under an axial force equilibrium is
//! `B m − N B s − p = −f − N B u`. Where the beam is stiffer, a link bends less. A joint adds its flexibility to `W`.
//!
//! At a support the clearance is given instead of the force. At an end of the beam that is not built in, the moment is zero. Both are
//! written as an equation with a penalty that fixes the variable: at a support `s p⁻¹ = 0`, at such an end `W = ∞`.
//!
//! Mehrotra's predictor–corrector method (1992) solves this in 15 to 40 block-tridiagonal systems and never cycles. The moments are
//! unknowns in addition to the clearances, which keeps the digits that a stiffness matrix of order `1/Δ³` would lose. Clearances keep
//! the digits of small numbers, because only differences of neighbouring depths enter. The result is a guess and is treated as one.

use crate::qp::blocks::{Block, PENALTY, factor_rigid, factor_under_tension, solve, solve_rigid};

/// The flexibility of a hinge in the chain, for a beam of length and stiffness one. It is finite: where statics alone determines one
/// side of the hinge, elimination would otherwise divide zero by zero. Eight digits are enough for a guess.
const HINGE: f64 = 1e8;

/// The chain above samples from end to end of the beam, or of a part of it between built-in supports.
#[derive(Debug)]
pub(super) struct Chain<'a> {
    /// The samples, including both ends.
    pub(super) samples: &'a [ChainSample],
    /// Whether each end is built in.
    pub(super) built_in: [bool; 2],
    /// `N`; the loads of the samples include `N B u`.
    pub(super) tension: f64,
}

/// The properties of a chain at a sample, and of the link to its right.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ChainSample {
    /// Position.
    pub(super) x: f64,
    /// `(B u)_i + ρ_i`; at a built-in end it includes the slope.
    pub(super) bend: f64,
    /// The parts of `bend` that belong to the links on the two sides.
    pub(super) sides: [f64; 2],
    /// The load `f_i`.
    pub(super) load: f64,
    /// The clearance at a support.
    pub(super) held: Option<f64>,
    /// Whether there is nothing to touch: the clearance is then free, and the force is zero.
    pub(super) open: bool,
    /// Whether the link is a beam.
    pub(super) beam: bool,
    /// The flexibility of the link relative to the least bending stiffness, at most 1; zero counts as 1.
    pub(super) flexibility: f64,
    /// The flexibility of a joint at the sample.
    pub(super) joint: f64,
    /// The stiffness of a spring at the sample, and the clearance at which its force is zero.
    pub(super) spring: [f64; 2],
    /// The stiffness of a rotational spring at an end of the chain.
    pub(super) turning: f64,
}

/// Contact forces of the chain, and which samples touch.
#[derive(Debug)]
pub(super) struct Guess {
    /// Whether each sample touches.
    pub(super) touches: Vec<bool>,
    /// `p` at the samples, zero at supports.
    pub(super) force: Vec<f64>,
}

/// Stiffness of the spring under a sample with nothing to touch, relative to the bed of an unsupported beam. Without the spring
/// elimination would lose how the links bend. It is soft enough not to slow any step.
const SOFT: f64 = 1e-9;

/// Maximum number of steps of the predictor–corrector method.
const STEPS: usize = 60;

/// Convergence: clearance times force is at most this share of their sizes, divided by the square of the number of samples. Clearances
/// next to a contact fall with the square of the sample distance.
const ENOUGH: f64 = 1e-16;

/// Convergence: equilibrium is satisfied to this share of the forces, which is enough for a guess.
const IN_BALANCE: f64 = 1e-6;

/// Share of the step to the boundary, at which the next system would be singular. *Tuned* on hostile scenes: with 0.9 one of 300 is
/// lost.
const SHORT: f64 = 0.995;

/// A beam that is no deeper in the foundation than this share of its largest clearance is clear of it, to rounding.
const CLEAR: f64 = 1e-15;

/// Lower limit of the initial clearances as a share of their size, which keeps them inside the boundary. *Tuned* on hostile scenes:
/// with 1 one of 300 is lost.
const FIRST: f64 = 0.1;

/// `P l³/EI v` for a force at midspan of a beam on two supports.
const IN_THE_MIDDLE: f64 = 48.0;

/// A sample: its properties and the current iterate.
#[derive(Debug, Clone, Copy, Default)]
struct Row {
    /// `1/Δ` of the link to its right, its part of `W`, and the solution of the linear system: `ds`, `dm`.
    block: Block,
    /// `(B u)_i + ρ_i` and the load.
    bend: f64,
    load: f64,
    /// Clearance, contact force and moment.
    s: f64,
    p: f64,
    m: f64,
    /// Residuals of both linear equations.
    rest: [f64; 2],
    /// The stiffness of a spring, and the clearance at which its force is zero.
    spring: [f64; 2],
    /// Whether it is a support, where `s` is given and `p` is not used.
    held: bool,
    /// Whether there is nothing to touch, so `p` remains zero.
    open: bool,
    /// `dp`.
    dp: f64,
}

impl AsMut<Block> for Row {
    fn as_mut(&mut self) -> &mut Block {
        &mut self.block
    }
}

impl Row {
    /// Whether the sample can touch and is not a support.
    fn may_touch(&self) -> bool {
        !self.held && !self.open
    }

    /// `Θ` of the row; a support fixes the variable.
    fn ratio(&self, free: f64) -> f64 {
        if self.held { PENALTY } else { free + self.spring[0] }
    }

    /// Applies a part of its step and sets whether it touches.
    fn advance(&mut self, step: f64, touches: &mut bool) {
        self.m += step * self.block.step[1];
        if self.open {
            self.s += step * self.block.step[0];
        }
        if !self.may_touch() {
            return;
        }
        let (s, p) = (self.s + step * self.block.step[0], self.p + step * self.dp);
        // Of the two variables, the one that vanishes faster tends to zero (Tapia's indicators).
        *touches = s * self.p < p * self.s;
        (self.s, self.p) = (s, p);
    }
}

/// Factors the matrix of a chain, with or without an axial force.
fn factored(rows: &mut [Row], tension: f64, ratio: impl Fn(&Row) -> f64) {
    if tension == 0.0 {
        factor_rigid(rows, ratio);
    } else {
        let last = rows.len() - 1;
        factor_under_tension(rows, last, ratio, |Row { block: Block { c, off, .. }, .. }| c * (c - tension * off));
    }
}

/// Solves with these factors.
fn solved(rows: &mut [Row], tension: f64, right: impl Fn(&Row) -> [f64; 2]) {
    if tension == 0.0 {
        solve_rigid(rows, right);
    } else {
        solve(rows, right);
    }
}

/// Mehrotra's predictor and corrector: computes the step of each row and returns the share of it that reaches the boundary. Samples
/// with nothing to touch are on soft springs.
fn direction(rows: &mut [Row], mu: f64, count: f64, [soft, tension]: [f64; 2]) -> f64 {
    factored(rows, tension, |row| row.ratio(if row.open { soft } else { row.p / row.s }));
    solved(rows, tension, |row| [row.rest[1] - row.p, row.rest[0]]);
    let mut longest = 1.0_f64;
    for row in rows.iter_mut().filter(|row| row.may_touch()) {
        row.dp = -row.p - row.p / row.s * row.block.step[0];
        longest = limited(longest, row);
    }
    let ahead = rows.iter().map(|r| (r.s + longest * r.block.step[0]) * (r.p + longest * r.dp)).sum::<f64>() / count;
    let sigma = (ahead / mu) * (ahead / mu) * (ahead / mu);
    // From here on `dp` contains the right-hand side of the contact condition, over `s`.
    for row in rows.iter_mut().filter(|row| row.may_touch()) {
        row.dp = (sigma * mu - row.block.step[0] * row.dp) / row.s - row.p;
    }
    solved(rows, tension, |row| [row.rest[1] + row.dp, row.rest[0]]);
    longest = 1.0;
    for row in rows.iter_mut().filter(|row| row.may_touch()) {
        row.dp -= row.p / row.s * row.block.step[0];
        longest = limited(longest, row);
    }
    longest
}

impl Chain<'_> {
    /// Solves the chain.
    pub(super) fn solve(&self) -> Guess {
        let n = self.samples.len();
        let mut rows = self.rows();
        let count = as_float(rows.iter().filter(|row| row.may_touch()).count());
        let [unit_clearance, unit_force] = self.start(&mut rows, count);
        let enough = ENOUGH / (count * count) * unit_clearance * unit_force;
        let mut touches = vec![false; n];
        if !rows.iter().any(Row::may_touch) {
            return Guess { touches, force: vec![0.0; n] };
        }
        for _ in 0..STEPS {
            // At a support `p` and `dp` remain zero.
            let mu = rows.iter().map(|r| r.s * r.p).sum::<f64>() / count;
            let off = residuals(&mut rows, self.tension);
            if mu <= enough && off <= IN_BALANCE * unit_force {
                break;
            }
            let step = SHORT * direction(&mut rows, mu, count, [SOFT * self.bed(), self.tension]);
            let moved: f64 = rows.iter().map(|r| r.block.step[0] + r.block.step[1] + r.dp).sum();
            if !(step * moved).is_finite() {
                break;
            }
            rows.iter_mut().zip(&mut touches).for_each(|(row, touches)| row.advance(step, touches));
        }
        Guess { touches, force: rows.iter().map(|r| r.p).collect() }
    }

    /// Sets moments, clearances and forces to their initial values; returns the sizes of clearances and forces.
    fn start(&self, rows: &mut [Row], count: f64) -> [f64; 2] {
        // The beam without contact. If it could then move or has a free end, it is on a bed of springs: elimination would otherwise
        // lose how links bend that are not supported.
        let springs = if self.is_held_at_both_ends() { 0.0 } else { self.bed() };
        factored(rows, self.tension, |row| row.ratio(springs));
        residuals(rows, self.tension);
        solved(rows, self.tension, |row| [row.rest[1], row.rest[0]]);
        // The size of clearances is the depth of that beam in the foundation, whatever the depth of the foundation elsewhere.
        let touching = || rows.iter().filter(|row| row.may_touch());
        let reach = touching().fold(0.0_f64, |most, row| most.max(row.block.step[0].abs()));
        let deepest = touching().fold(CLEAR * reach, |most, row| most.max(-row.block.step[0]));
        let unit_clearance = if 0.0 < deepest { deepest } else { 1.0 };
        let total: f64 = rows.iter().filter(|row| !row.held).map(|row| row.load.abs()).sum();
        let unit_force = total.max(IN_THE_MIDDLE * unit_clearance / self.cube()) / count;
        for row in rows {
            row.m = row.block.step[1];
            if row.open {
                row.s = row.block.step[0];
            } else if !row.held {
                (row.s, row.p) = (row.block.step[0].max(FIRST * unit_clearance), unit_force);
            }
        }
        [unit_clearance, unit_force]
    }

    /// The length of the beam, cubed.
    fn cube(&self) -> f64 {
        let length = self.samples[self.samples.len() - 1].x - self.samples[0].x;
        length * length * length
    }

    /// The stiffness of each spring in a bed that is as stiff as the beam at midspan.
    fn bed(&self) -> f64 {
        IN_THE_MIDDLE / (self.cube() * as_float(self.samples.len()))
    }

    /// Whether a support holds each end.
    fn is_held_at_both_ends(&self) -> bool {
        [self.samples.first(), self.samples.last()].iter().all(|end| end.is_some_and(|end| end.held.is_some()))
    }

    fn rows(&self) -> Vec<Row> {
        let n = self.samples.len();
        // The length of a link, its length times its flexibility, and whether it is a beam.
        let link = |i: usize| {
            let ChainSample { x, beam, flexibility, .. } = self.samples[i];
            let length = self.samples[i + 1].x - x;
            (length, if flexibility == 0.0 { length } else { length * flexibility }, beam)
        };
        let share = |(_, bends, beam): (f64, f64, bool)| if beam { bends / 3.0 } else { 0.5 * bends };
        let row = |i: usize| {
            let ChainSample { bend, load, held, open, joint, spring, turning, .. } = self.samples[i];
            let free = |built_in: bool| match built_in {
                true => 0.0,
                false if 0.0 < turning => 1.0 / turning,
                false => PENALTY,
            };
            let left = if 0 < i { share(link(i - 1)) } else { free(self.built_in[0]) };
            let left = left + joint.min(HINGE);
            let row = Row { bend, load, open, spring, held: held.is_some(), s: held.unwrap_or(0.0), ..Row::default() };
            if i + 1 == n {
                let w = left + free(self.built_in[1]);
                return Row { block: Block::new(0.0, w, 0.0), ..row };
            }
            let right = link(i);
            let off = if right.2 { right.1 / 6.0 } else { 0.0 };
            let block = Block::new(1.0 / right.0, left + share(right), off);
            Row { block: block.on_springs(-self.tension / right.0, 0.0), ..row }
        };
        (0..n).map(row).collect()
    }
}

/// Computes the residuals of both equations; returns the largest equilibrium residual.
fn residuals(rows: &mut [Row], tension: f64) -> f64 {
    // The slopes of clearance and moment over the link to the left, and the rotation here caused by the moment at its left end.
    let (mut left_s, mut left_m, mut bent) = (0.0, 0.0, 0.0);
    let mut worst = 0.0_f64;
    for i in 0..rows.len() {
        let (next_s, next_m) = rows.get(i + 1).map_or((0.0, 0.0), |next| (next.s, next.m));
        let row = &mut rows[i];
        let Block { c, w, off, .. } = row.block;
        let (right_s, right_m) = (c * (next_s - row.s), c * (next_m - row.m));
        let bends = row.bend - (right_s - left_s) + w * row.m + off * next_m + bent;
        let sprung = row.spring[0] * (row.spring[1] - row.s);
        let pulled = if tension == 0.0 { 0.0 } else { tension * (right_s - left_s) };
        row.rest = [bends, row.p - row.load + sprung - (right_m - left_m) + pulled];
        if !row.held {
            worst = worst.max(row.rest[1].abs());
        }
        (left_s, left_m, bent) = (right_s, right_m, off * row.m);
    }
    worst
}

/// The longest step, at most `longest`, that keeps clearance and force from becoming negative.
fn limited(longest: f64, row: &Row) -> f64 {
    let limit = |longest: f64, x: f64, d: f64| if x + longest * d < 0.0 { -x / d } else { longest };
    limit(limit(longest, row.s, row.block.step[0]), row.p, row.dp)
}

#[expect(clippy::cast_precision_loss, reason = "samples are counted in millions")]
fn as_float(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests;
