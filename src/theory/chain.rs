//! A first idea of where the beam touches: a chain of stiff links with elastic hinges above sampled places of the profile.
//!
//! Unknown are the clearances `s = g − v ≥ 0`, the contact forces `p ≥ 0` and the moments `m = −v''` at the samples. With the
//! second difference `(B y)_i = (y_{i+1} − y_i)/Δ_i − (y_i − y_{i−1})/Δ_{i−1}` and the lumped loads `f`,
//!
//! ```text
//! B s − W m = B u + ρ        how the beam bends between samples
//! B m − p   = −f             equilibrium
//! s_i p_i   = 0              contact
//! ```
//!
//! A link near contact has its elasticity at its two ends (Hencky's chain: `Δ/2` at each end, `ρ = 0`), because a beam
//! shares the force at a lift-off point between samples and its contacts have holes. A link far from contact is a beam
//! (`Δ/3` and `Δ/6`, `ρ` the end rotations under its load), which is exact however long it is.
//!
//! A spring presses with `k (v − d) = k (s₀ − s)`, where `s₀` is the clearance without force.
//! Under an axial force equilibrium is `B m − N B s − p = −f − N B u`.
//! Where the beam is stiffer a link bends less, and a joint bends besides: its flexibility is added to `W`.
//!
//! At a support the clearance is given instead of the force, and at an end of the beam that is not built in the moment is zero. Both
//! are written as an equation with a penalty that fixes the variable: at a support `s p⁻¹ = 0`, at such an end `W = ∞`.
//!
//! Mehrotra's predictor–corrector method (1992) solves this in 15 to 40 block-tridiagonal systems and never cycles. Moments
//! beside clearances keep the digits that a stiffness matrix of order `1/Δ³` would lose, and clearances have the digits of
//! small numbers, since only differences of neighbouring depths enter. What comes out is a guess and is treated as one.

use crate::qp::blocks::{Block, PENALTY, factor_rigid, factor_under_tension, solve, solve_rigid};

/// The flexibility of a hinge in the chain, of a beam of length and stiffness one. It is not infinite: on a side of it where statics alone
/// says what is there, elimination would divide zero by zero. Eight of the digits of a guess are enough.
const HINGE: f64 = 1e8;

/// The chain above samples from end to end of the beam, or of a part of it between built-in supports.
#[derive(Debug)]
pub(super) struct Chain<'a> {
    /// The samples, both ends included.
    pub(super) samples: &'a [ChainSample],
    /// True for an end that is built in.
    pub(super) built_in: [bool; 2],
    /// `N`; the loads of its samples have `N B u` among them.
    pub(super) tension: f64,
}

/// What a chain is made of at a sample, and in the link to its right.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ChainSample {
    /// Where.
    pub(super) x: f64,
    /// `(B u)_i + ρ_i`; at an end that is built in, with its slope.
    pub(super) bend: f64,
    /// What of it belongs to the links on the two sides.
    pub(super) sides: [f64; 2],
    /// The load `f_i`.
    pub(super) load: f64,
    /// The clearance, where a support holds it.
    pub(super) held: Option<f64>,
    /// True where there is nothing to touch: the clearance is any number, and there is no force.
    pub(super) open: bool,
    /// True for a link that is a beam.
    pub(super) beam: bool,
    /// How much more flexible the link is than one of the least bending stiffness, at most 1; zero counts as 1.
    pub(super) flexibility: f64,
    /// The flexibility of a joint at the sample.
    pub(super) joint: f64,
    /// The stiffness of a spring at the sample, and the clearance without force.
    pub(super) spring: [f64; 2],
    /// The stiffness of a spring against turning at an end of the chain.
    pub(super) turning: f64,
}

/// Contact forces of the chain, and which samples touch.
#[derive(Debug)]
pub(super) struct Guess {
    /// True for a sample that touches.
    pub(super) touches: Vec<bool>,
    /// `p` at the samples, zero at supports.
    pub(super) force: Vec<f64>,
}

/// Where there is nothing to touch a sample lies on a spring, without which elimination would lose how the links bend; softer than
/// the bed of a beam that nothing holds by this factor, so that it slows no step.
const SOFT: f64 = 1e-9;

/// Steps of the predictor–corrector method at most.
const STEPS: usize = 60;

/// They end where clearance times force is this share of the sizes of both over the square of the number of samples: clearances beside
/// a contact fall with the square of the distance of samples.
const ENOUGH: f64 = 1e-16;

/// And where forces are in balance to this share of theirs: a guess asks for no more.
const IN_BALANCE: f64 = 1e-6;

/// Of a step to the border, where the next system would be singular. *Tuned* on hostile scenes: with 0.9 one of 300 is lost.
const SHORT: f64 = 0.995;

/// A beam that lies no deeper in the ground than this share of how far it reaches is clear of it but for rounding.
const CLEAR: f64 = 1e-15;

/// Of the size of clearances, what they begin with at least: inside the border. *Tuned* on hostile scenes: with 1 one of 300 is lost.
const FIRST: f64 = 0.1;

/// `P l³/EI v` of a force in the middle of a beam on two supports.
const IN_THE_MIDDLE: f64 = 48.0;

/// A sample: what it is made of and where the iteration stands.
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
    /// The stiffness of a spring, and the clearance without force.
    spring: [f64; 2],
    /// True at a support, where `s` is given and `p` is not used.
    held: bool,
    /// True where nothing touches, and `p` stays zero.
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
    /// True if there is something to touch, and no support.
    fn may_touch(&self) -> bool {
        !self.held && !self.open
    }

    /// `Θ` of the row: what a support holds is fixed.
    fn ratio(&self, free: f64) -> f64 {
        if self.held { PENALTY } else { free + self.spring[0] }
    }

    /// Goes a part of its step, and says whether it touches.
    fn advance(&mut self, step: f64, touches: &mut bool) {
        self.m += step * self.block.step[1];
        if self.open {
            self.s += step * self.block.step[0];
        }
        if !self.may_touch() {
            return;
        }
        let (s, p) = (self.s + step * self.block.step[0], self.p + step * self.dp);
        // Of the two that vanish together, the one that vanishes faster (Tapia's indicators).
        *touches = s * self.p < p * self.s;
        (self.s, self.p) = (s, p);
    }
}

/// Factors the matrix of a chain, with an axial force or without.
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

/// Mehrotra's predictor and corrector: the step of each row, and how much of it leads to the border. What nothing can touch lies on
/// soft springs.
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
    // From here on `dp` holds what the contact condition needs, over `s`.
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
            // At a support `p` and `dp` stay zero.
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

    /// Puts moments, clearances and forces where the steps begin: the sizes of the latter two.
    fn start(&self, rows: &mut [Row], count: f64) -> [f64; 2] {
        // The beam that touches nothing; one that then could move lies on a bed of springs, and so does one with a free end: of links
        // that nothing holds, elimination would lose how they bend.
        let springs = if self.is_held_at_both_ends() { 0.0 } else { self.bed() };
        factored(rows, self.tension, |row| row.ratio(springs));
        residuals(rows, self.tension);
        solved(rows, self.tension, |row| [row.rest[1], row.rest[0]]);
        // Clearances are measured by how deep that beam lies in the foundation, however deep the foundation is elsewhere.
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

    /// The stiffness of each spring of a bed that is as stiff as the beam in its middle.
    fn bed(&self) -> f64 {
        IN_THE_MIDDLE / (self.cube() * as_float(self.samples.len()))
    }

    /// True if a support holds each end.
    fn is_held_at_both_ends(&self) -> bool {
        [self.samples.first(), self.samples.last()].iter().all(|end| end.is_some_and(|end| end.held.is_some()))
    }

    fn rows(&self) -> Vec<Row> {
        let n = self.samples.len();
        // The length, and what of it bends.
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

/// Residuals of both equations; returns the largest of equilibrium.
fn residuals(rows: &mut [Row], tension: f64) -> f64 {
    // How clearance and moment rise over the link to the left, and how the moment at its left end bends the beam here.
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
