//! The optimality conditions of a discrete problem as four dimensionless numbers, and a fifth for what is said beside them.

use crate::scene::{Grid, Scene};
use crate::state::{Bending, ContactState, Nodes};

/// A state whose worst residual is at most this is certified.
///
/// Nodal contact forces differ from the optimum by up to `‖K‖` times the residual. With 30 intervals and the example of
/// the paper that is a factor of some 10³, so that 1e-9 in clearance leaves six digits of a nodal force, and more of every
/// integral quantity.
pub const CERTIFIED_RESIDUAL: f64 = 1e-9;

/// Rounding, as a share of what is certified: sixteen units in the last place of the largest length in the scene.
///
/// Contact forces are rounded numbers, and half a unit in the last place of each moves the beam by that share of the
/// deflection `P l³ / 48 EI` that all of them together would cause. Where the foundation lies so close that the beam moves
/// less than that, a smaller measure would judge the representation of numbers, not the answer.
const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

/// Violations of (4), (5), (8) by a state, all dimensionless.
///
/// Forces are measured by `P`, the sum of all loads or of all contact forces, whichever is larger; in a scene without
/// loads by the force `48 EI u / l³` that bends the beam to the ground. Lengths are measured by `D`, the largest deflection,
/// in a scene without loads not less than the way to the ground, and never by less than rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kkt {
    /// Feasibility: `max(v_i − u_i) / D`, the deepest penetration at a node.
    pub penetration: f64,
    /// Sign of the contact forces: `max(−p_i) / P`, the strongest tension.
    pub tension: f64,
    /// Complementarity: `max min(p_i / P, h_i / D)`, force across a clearance.
    pub complementarity: f64,
    /// Equilibrium and elasticity: the deflection that the contact forces cause, against that of the state, over `D`;
    /// and the balance of forces and of moments with the reactions, over `P`.
    pub equilibrium: f64,
    /// What the state says beside deflections and forces, against what follows from them: places over `l`, clearances over
    /// `D`, bending moments over `P l`.
    pub record: f64,
}

impl Kkt {
    /// Judges the nodal values of `state` in `scene`; `None` if the state has none, or not as many as it should.
    #[must_use]
    pub fn of(scene: &Scene, state: &ContactState) -> Option<Self> {
        let nodes = state.nodes.as_ref()?;
        let n = nodes.contact_force.len();
        let grid = Grid::uniform(scene, n + 1).ok()?;
        if [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.moment].iter().any(|list| list.len() != n) {
            return None;
        }
        let loads = grid.nodal_loads(scene.load());
        let depth_at = |i: usize| scene.depth(grid.place(i));
        let (v, p) = (&nodes.deflection, &nodes.contact_force);

        let length = scene.beam().length();
        let flexibility = length * length * length / (48.0 * scene.beam().bending_stiffness());
        // Forces, and their moments about the left support over `l`: what is not balanced, and the sums of magnitudes, which are sizes only.
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let per_interval = 1.0 / (n + 1) as f64;
        #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
        let lever = |i: usize| i as f64 * per_interval;
        let (mut total, mut moment) = (Sum::default(), Sum::default());
        let (mut load, mut contact) = (0.0_f64, 0.0_f64);
        for (i, &q) in loads.iter().enumerate() {
            let p = if i == 0 || i == n + 1 { 0.0 } else { p[i - 1] };
            total.add(q - p);
            moment.add((q - p) * lever(i));
            load += q.abs();
            contact += p.abs();
        }
        let idle = if load == 0.0 { within_reach((1..=n).map(depth_at)) } else { 0.0 };
        let force = nonzero(load.max(contact).max(idle / flexibility));
        // Of the state alone: ground that the beam does not reach, however deep, must not loosen the measure.
        let moved = worst(v.iter().map(|v| v.abs())).max(idle);
        let depth = nonzero(moved.max(ROUNDING * flexibility * force));

        let (mut moments, mut clearances, mut places) = (Worst::default(), Worst::default(), Worst::default());
        let caused = deflection(&grid, scene.beam().bending_stiffness(), &loads, nodes, &mut moments);
        let (mut penetration, mut tension, mut complementarity, mut elastic) =
            (Worst::default(), Worst::default(), Worst::default(), Worst::default());
        for (i, ((v, p), caused)) in v.iter().zip(p).zip(&caused[1..]).enumerate() {
            let place = grid.place(i + 1);
            let u = scene.depth(place);
            let h = u - v;
            penetration.see(-h);
            tension.see(-p);
            // Anything else is not positive, or no number, which the lines around this one see.
            if 0.0 < h && 0.0 < *p {
                complementarity.see((h / depth).min(p / force));
            }
            elastic.see((v - caused).abs());
            clearances.see(mistaken(nodes.clearance[i], u, h));
            places.see((nodes.x[i] - place).abs());
        }
        // Reactions that balance forces, and moments about the left support.
        let mut balance = Worst::default();
        balance.see((total.total() - state.reactions.left - state.reactions.right).abs());
        balance.see((moment.total() - state.reactions.right).abs());
        Some(Self {
            penetration: penetration.value() / depth,
            tension: tension.value() / force,
            complementarity: complementarity.value(),
            equilibrium: (elastic.value() / depth).max(balance.value() / force),
            record: worst([moments.value() / (force * length), clearances.value() / depth, places.value() / length]),
        })
    }

    /// The worst of the five; infinite if any of them is NaN.
    #[must_use]
    pub fn residual(&self) -> f64 {
        worst([self.penetration, self.tension, self.complementarity, self.equilibrium, self.record])
    }

    /// Whether the state passes.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.residual() <= CERTIFIED_RESIDUAL
    }
}

/// The largest of some numbers, at least 0; infinite if one of them is NaN.
fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut worst = Worst::default();
    values.into_iter().for_each(|value| worst.see(value));
    worst.value()
}

/// The largest number seen, at least 0, and whether all were numbers.
#[derive(Default)]
struct Worst {
    largest: f64,
    nan: bool,
}

impl Worst {
    fn see(&mut self, value: f64) {
        self.nan |= value.is_nan();
        if self.largest < value {
            self.largest = value;
        }
    }

    fn value(&self) -> f64 {
        if self.nan { f64::INFINITY } else { self.largest }
    }
}

/// By how much a clearance is said wrong, beyond the rounding of the depth `u` that it was taken from.
fn mistaken(said: f64, u: f64, clearance: f64) -> f64 {
    // Where there is no foundation both are infinite.
    if u == f64::INFINITY && said == f64::INFINITY {
        return 0.0;
    }
    (said - clearance).abs() - 4.0 * f64::EPSILON * u.abs()
}

/// The way from the straight beam to the ground: the highest rise above the line of the supports, or else the least depth.
/// Zero where there is no ground.
fn within_reach(depths: impl Iterator<Item = f64>) -> f64 {
    let highest = depths.fold(f64::INFINITY, f64::min);
    if highest.is_finite() { highest.abs() } else { 0.0 }
}

/// A divisor: 1 where there is nothing to measure by.
fn nonzero(size: f64) -> f64 {
    if 0.0 < size { size } else { 1.0 }
}

/// Deflections at all nodes under the loads and the contact forces of a state: moments by statics, then
/// integration of `v'' = −M/EI` from the left with the right end brought back to zero.
///
/// ```text
/// M_{i+1} = M_i + V_i Δ,   V_i = V_{i−1} − t_i,                  V_0 from M_N = 0
/// θ_i     = θ_{i−1} − (Δ/EI) c_i,   v_{i+1} = v_i + θ_i Δ        θ_0 from v_N = 0
/// ```
///
/// with the curvature share `c_i = M_i` of finite differences or `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. The
/// differences of `M_i` from the moments of the state are seen by `moments` on the way.
fn deflection(grid: &Grid, stiffness: f64, loads: &[f64], nodes: &Nodes, moments: &mut Worst) -> Vec<f64> {
    let spacing = grid.spacing();
    let unit = spacing / stiffness;
    let mut y = vec![0.0; loads.len()];
    for ((y, q), p) in y[1..].iter_mut().zip(&loads[1..]).zip(&nodes.contact_force) {
        *y = q - p;
    }
    integrate_twice(&mut y, spacing);
    // In place: the moment of the node before is kept.
    let mut before = 0.0;
    for i in 1..y.len() - 1 {
        let here = y[i];
        moments.see((here - nodes.moment[i - 1]).abs());
        y[i] = match nodes.bending {
            Bending::AtNodes => unit * here,
            Bending::Between => unit * ((before + 4.0 * here + y[i + 1]) / 6.0),
        };
        before = here;
    }
    integrate_twice(&mut y, spacing);
    y
}

/// From `f_1 … f_{N−1}`, between two zeros, to `y_0 … y_N` with `y_0 = y_N = 0` and slopes that fall by `f_i` at node `i`.
///
/// A million roundings of a slope would be a million times larger in the height: both sums keep what rounding takes from
/// them, as in Kahan's and Neumaier's sums, and the slope passes its share on.
#[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
fn integrate_twice(y: &mut [f64], spacing: f64) {
    // First with a horizontal start, then turned so that the right end comes to zero. Heights in units of the spacing.
    let (mut slope, mut height) = (Sum::default(), Sum::default());
    for y in y.iter_mut() {
        let f = *y;
        *y = height.total();
        slope.add(-f);
        height.add(slope.value);
        height.lost += slope.lost;
    }
    let turn = y[y.len() - 1] / (y.len() - 1) as f64;
    for (i, y) in y.iter_mut().enumerate() {
        *y = (*y - turn * i as f64) * spacing;
    }
}

/// A sum, and what rounding has taken from it.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: f64,
    lost: f64,
}

impl Sum {
    /// Adds a number; `lost` gets the exact error of the addition (Knuth's two-sum).
    fn add(&mut self, next: f64) {
        let sum = self.value + next;
        let of_next = sum - self.value;
        self.lost += (self.value - (sum - of_next)) + (next - of_next);
        self.value = sum;
    }

    fn total(self) -> f64 {
        self.value + self.lost
    }
}
