//! The residual of a discrete problem: how far nodal values are from (4), (5) and (8), as five dimensionless numbers.
//!
//! Loads and contact forces on the nodes bend the beam by statics and integration of `v'' = −M/EI`, both from left to right:
//!
//! ```text
//! M_i = M_{i−1} + V_{i−1} Δ,   V_i = V_{i−1} − t_i,           t = q − p          M_0 = M_N = 0
//! v_i = v_{i−1} + θ_{i−1} Δ,   θ_i = θ_{i−1} − (Δ/EI) c_i                        v_0 = v_N = 0
//! ```
//!
//! with the curvature share `c_i = M_i` of finite differences or `(M_{i−1} + 4 M_i + M_{i+1})/6` of an exact beam. Both are
//! the same [`DoubleSum`] with both ends at zero; no method and no solver is asked. Of other beams than the paper's the same
//! is asked from support to support (modules `residuals`, `nodal_beam`).

use super::residuals;
use crate::scene::{Grid, Scene};
use crate::state::{ContactState, Discretisation, Reactions};

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
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

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
        if !scene.beam().is_simple() {
            return residuals::on_supports(scene, state);
        }
        let nodes = state.nodes.as_ref()?;
        let (x, v, h, p, moment) = (&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment);
        let grid = Grid::uniform(scene, p.len() + 1).ok()?;
        if [x, v, h, moment].iter().any(|list| list.len() != p.len()) {
            return None;
        }
        let caused = Equilibrium::of(scene, grid, p, nodes.discretisation);

        let length = scene.beam().length();
        let flexibility = length * length * length / (48.0 * scene.beam().bending_stiffness());
        let idle = if caused.load == 0.0 { within_reach(&grid.gaps(scene)) } else { 0.0 };
        let force = nonzero(caused.load.max(caused.contact).max(idle / flexibility));
        // Of the state alone: ground that the beam does not reach, however deep, must not loosen the measure.
        let depth = nonzero(largest(v.iter().map(|v| v.abs())).max(idle).max(ROUNDING * flexibility * force));

        let (mut places, mut depths) = ([0.0; BATCH], [0.0; BATCH]);
        let mut worst = [0.0; 7];
        caused.walk(|first, caused_moment, caused_deflection| {
            let (places, u) = (&mut places[..caused_moment.len()], &mut depths[..caused_moment.len()]);
            grid.places(first + 1, places);
            scene.gaps(places, u);
            let rows = (0..places.len()).map(|k| {
                let i = first + k;
                let clearance = u[k] - v[i];
                [
                    -clearance,
                    -p[i],
                    (clearance / depth).min(p[i] / force),
                    (v[i] - caused_deflection[k]).abs(),
                    (moment[i] - caused_moment[k]).abs(),
                    mistaken(h[i], u[k], clearance),
                    (x[i] - places[k]).abs(),
                ]
            });
            worst = largest_each(worst, rows);
        });
        let [penetration, tension, complementarity, elastic, moments, clearances, out_of_place] = worst;
        // Reactions that balance forces, and moments about the left support.
        let Reactions { left, right } = state.reactions;
        let balance = largest([(caused.total - left - right).abs(), (caused.right - right).abs()]);
        Some(Self {
            penetration: penetration / depth,
            tension: tension / force,
            complementarity,
            equilibrium: largest([elastic / depth, balance / force]),
            record: largest([moments / (force * length), clearances / depth, out_of_place / length]),
        })
    }

    /// The worst of the five; infinite if any of them is NaN.
    #[must_use]
    pub fn residual(&self) -> f64 {
        largest([self.penetration, self.tension, self.complementarity, self.equilibrium, self.record])
    }

    /// Whether the state passes.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.residual() <= CERTIFIED_RESIDUAL
    }
}

/// The largest of some numbers, at least 0; infinite if one of them is NaN.
pub(super) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    largest_each([0.0], values.into_iter().map(|value| [value]))[0]
}

/// The same of each column of a table, of which the upper part has been seen.
fn largest_each<const COLUMNS: usize>(
    mut most: [f64; COLUMNS],
    rows: impl Iterator<Item = [f64; COLUMNS]>,
) -> [f64; COLUMNS] {
    let mut unknown = [false; COLUMNS];
    for row in rows {
        for ((most, unknown), value) in most.iter_mut().zip(&mut unknown).zip(row) {
            // Not `max`: a comparison is all that a number needs.
            *most = if *most < value { value } else { *most };
            *unknown |= value.is_nan();
        }
    }
    most.iter_mut().zip(unknown).filter(|(_, unknown)| *unknown).for_each(|(most, _)| *most = f64::INFINITY);
    most
}

/// By how much a clearance is said wrong, beyond the rounding of the depth `u` that it was taken from.
pub(super) fn mistaken(said: f64, u: f64, clearance: f64) -> f64 {
    // Where there is no foundation both are infinite.
    if u == f64::INFINITY && said == f64::INFINITY {
        return 0.0;
    }
    (said - clearance).abs() - 4.0 * f64::EPSILON * u.abs()
}

/// The way from the straight beam to the ground: the highest rise above the line of the supports, or else the least depth.
/// Zero where there is no ground.
pub(super) fn within_reach(depths: &[f64]) -> f64 {
    let highest = depths.iter().copied().fold(f64::INFINITY, f64::min);
    if highest.is_finite() { highest.abs() } else { 0.0 }
}

/// A divisor: 1 where there is nothing to measure by.
pub(super) fn nonzero(size: f64) -> f64 {
    if 0.0 < size { size } else { 1.0 }
}

/// The beam in equilibrium with the nodal loads of a scene and with contact forces at the inner nodes of a grid.
///
/// Deflections of a fine grid are not kept: whoever wants them [walks](Self::walk) along the beam.
pub(super) struct Equilibrium {
    grid: Grid,
    /// `M_i/Δ` at the inner nodes \[force\].
    moment: Vec<f64>,
    /// `(Δ²/EI) c_i/Δ` of a moment `M_i/Δ = 1`: at its own node, and at each neighbour.
    curvature: [f64; 2],
    /// Sum of all forces, those on the supports included \[force\].
    total: f64,
    /// What of it the right support carries \[force\].
    right: f64,
    /// Sum of the magnitudes of all loads, a size only \[force\].
    load: f64,
    /// The same of contact forces.
    contact: f64,
}

/// Nodes of a step of a walk, a multiple of [`BLOCK`]: few enough for the nearest cache.
const BATCH: usize = 256;

impl Equilibrium {
    /// Contact forces are as many as the grid has inner nodes.
    pub(super) fn of(scene: &Scene, grid: Grid, contact_force: &[f64], discretisation: Discretisation) -> Self {
        let magnitude = |sum: f64, force: &f64| sum + force.abs();
        let [mut first, mut last] = [[0.0]; 2];
        grid.loads(scene.load(), 0, &mut first);
        grid.loads(scene.load(), grid.intervals(), &mut last);
        let [first, last] = [first[0], last[0]];
        let mut moment = vec![0.0; contact_force.len()];
        grid.loads(scene.load(), 1, &mut moment);
        let load = moment.iter().fold(first.abs() + last.abs(), magnitude);
        let contact = contact_force.iter().fold(0.0, magnitude);

        // t_i, which become M_i/Δ.
        moment.iter_mut().zip(contact_force).for_each(|(q, p)| *q -= p);
        let (left, inner) = DoubleSum::between_supports(&mut moment);
        let (total, right) = (inner + first + last, (inner - left) + last);

        let unit = grid.spacing() * grid.spacing() / scene.beam().bending_stiffness();
        let curvature = match discretisation {
            Discretisation::FiniteDifferences => [unit, 0.0],
            Discretisation::BeamElements => [4.0 * (unit / 6.0), unit / 6.0],
        };
        Self { grid, moment, curvature, total, right, load, contact }
    }

    /// From the left to the right support, some neighbouring nodes at a time: the index of the first one, counted from 0 at
    /// node 1, and `M_i` and `v_i` of all.
    pub(super) fn walk(&self, mut visit: impl FnMut(usize, &[f64], &[f64])) {
        let mut shot = DoubleSum::default();
        self.curvatures(|_, curvatures| shot.along(curvatures));
        let mut sums = DoubleSum::from(0.0, shot.aimed(self.moment.len()));
        let mut moments = [0.0; BATCH];
        self.curvatures(|first, deflections| {
            // (Δ²/EI) c_i/Δ become v_i/Δ.
            sums.along(deflections);
            let moments = &mut moments[..deflections.len()];
            moments.copy_from_slice(&self.moment[first..first + deflections.len()]);
            for value in moments.iter_mut().chain(deflections.iter_mut()) {
                *value *= self.grid.spacing();
            }
            visit(first, moments, deflections);
        });
    }

    /// `(Δ²/EI) c_i/Δ` of some neighbouring nodes at a time, with the index of the first one.
    fn curvatures(&self, mut visit: impl FnMut(usize, &mut [f64])) {
        let [own, beside] = self.curvature;
        let mut curvatures = [0.0; BATCH];
        let mut before = 0.0;
        for (b, moments) in self.moment.chunks(BATCH).enumerate() {
            let first = b * BATCH;
            let behind = self.moment.get(first + BATCH).copied().unwrap_or(0.0);
            let after = moments.iter().skip(1).chain([&behind]);
            let curvatures = &mut curvatures[..moments.len()];
            for ((share, &m), after) in curvatures.iter_mut().zip(moments).zip(after) {
                *share = own * m + beside * (before + after);
                before = m;
            }
            visit(first, curvatures);
        }
    }
}

/// Forces to moments, curvatures to deflections:
///
/// ```text
/// y_i = y_{i−1} + s_{i−1},   s_i = s_{i−1} − f_i,      y_0 = 0, s_0 given
/// ```
///
/// A million roundings of a slope would be a million times larger in the height. So within a short block slopes and heights
/// count from its beginning, where they are small, and from block to block both sums keep what rounding takes from them, as
/// in Kahan's and Neumaier's sums; the slope passes its share on.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct DoubleSum {
    height: Sum,
    slope: Sum,
}

/// Nodes in a block: a power of two, so that the way which a slope rises over a block is exact.
const BLOCK: usize = 16;

impl DoubleSum {
    /// From `f_1 … f_{N−1}` to `y_1 … y_{N−1}` with `y_0 = y_N = 0`; `s_0`, and the sum of all `f`.
    pub(super) fn between_supports(falls: &mut [f64]) -> (f64, f64) {
        let mut shot = Self::default();
        let mut heights = [0.0; BLOCK];
        for block in falls.chunks(BLOCK) {
            heights[..block.len()].copy_from_slice(block);
            shot.along(&mut heights[..block.len()]);
        }
        let slope = shot.aimed(falls.len());
        Self::from(0.0, slope).along(falls);
        (slope, -shot.slope.total())
    }

    /// `s_0` for `y_N = 0`: a shot from a horizontal start, at its last inner node, misses the right end by `N` times that slope.
    #[expect(clippy::cast_precision_loss, reason = "grids stay far below 2⁵³ nodes")]
    fn aimed(self, inner: usize) -> f64 {
        -self.next() / (inner + 1) as f64
    }

    /// From a height with a slope.
    pub(super) fn from(height: f64, slope: f64) -> Self {
        let sum = |value| Sum { value, lost: 0.0 };
        Self { height: sum(height), slope: sum(slope) }
    }

    /// Over the next nodes: what the slope loses at each of them gives way to the height there.
    pub(super) fn along(&mut self, falls: &mut [f64]) {
        let (blocks, rest) = falls.as_chunks_mut::<BLOCK>();
        blocks.iter_mut().for_each(|block| self.block(block));
        rest.as_chunks_mut::<1>().0.iter_mut().for_each(|single| self.block(single));
    }

    /// The same for a number of nodes that is a power of two.
    #[inline]
    #[expect(clippy::cast_precision_loss, reason = "a block is short")]
    fn block<const NODES: usize>(&mut self, falls: &mut [f64; NODES]) {
        let (from, rise) = (self.height.total(), self.slope.total());
        // What falls in the block have taken from slope and height.
        let (mut steep, mut deep) = (0.0, 0.0);
        for (k, y) in falls.iter_mut().enumerate() {
            let fall = *y;
            deep += steep;
            steep += fall;
            *y = (from + (k + 1) as f64 * rise) - deep;
        }
        let nodes = NODES as f64;
        self.height.add(nodes * self.slope.value);
        self.height.lost += nodes * self.slope.lost;
        self.height.add(-deep);
        self.slope.add(-steep);
    }

    /// The height one node further on.
    fn next(mut self) -> f64 {
        let mut height = [0.0];
        self.along(&mut height);
        height[0]
    }
}

/// A sum, and what rounding has taken from it.
#[derive(Debug, Clone, Copy, Default)]
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

#[cfg(test)]
mod tests {
    use super::{DoubleSum, Sum, largest};

    /// Falls of one, on a slope of 10¹⁶ that cannot be told from what they leave of it unless nothing is lost.
    #[test]
    fn nothing_is_lost() {
        let mut sums = DoubleSum { slope: Sum { value: 1e16, lost: 0.0 }, ..DoubleSum::default() };
        sums.along(&mut [1.0; 100]);
        sums.along(&mut [1e16]);
        // 101 intervals with the steep slope; the k-th fall of one is felt in the 102 − k nodes behind it.
        let ones: f64 = (1..=100_i32).map(|k| f64::from(102 - k)).sum();
        assert_eq!(sums.next().to_bits(), (101.0 * 1e16 - ones).to_bits());
        assert_eq!(sums.slope.total().to_bits(), (-100.0_f64).to_bits());
    }

    /// Falls of a third between two supports: a parabola `y_i = f i (N − i)/2`, to a few units in the last place of its height,
    /// on a grid of any size, with the slope `f (N − 1)/2` at the left support.
    #[test]
    fn uniform_falls_make_a_parabola() {
        /// Of the slope that is found, of a sum of sixteen, of two products.
        const UNITS: f64 = 4.0;
        let fall = 1.0 / 3.0;
        for n in [1, 15, 16, 17, 1000, 300_000_u32] {
            let number = f64::from(n);
            let mut heights = vec![fall; n as usize];
            let (slope, sum) = DoubleSum::between_supports(&mut heights);
            assert!((slope - fall * number / 2.0).abs() <= UNITS * f64::EPSILON * slope, "{slope} of {n}");
            assert!((sum - fall * number).abs() <= UNITS * f64::EPSILON * sum, "{sum} of {n}");
            let most = fall * (number + 1.0) * (number + 1.0) / 8.0;
            for (i, y) in (1..).map(f64::from).zip(heights) {
                let exact = fall * i * (number + 1.0 - i) / 2.0;
                assert!((y - exact).abs() <= UNITS * f64::EPSILON * most, "{y} instead of {exact} at {i} of {n}");
            }
        }
    }

    #[test]
    fn nan_is_the_largest_wherever_it_stands() {
        assert_eq!(largest([-1.0, -2.0]).to_bits(), 0.0_f64.to_bits(), "at least zero");
        assert_eq!(largest([1.0, 3.0, 2.0]).to_bits(), 3.0_f64.to_bits(), "the largest");
        for place in 0..3 {
            let mut values = [1.0, 3.0, 2.0];
            values[place] = f64::NAN;
            assert!(largest(values).is_infinite(), "NaN at {place}");
        }
    }
}
