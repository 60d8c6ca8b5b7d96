//! The residual of a discrete problem: the deviation of nodal values from (4), (5) and (8), as five dimensionless numbers.
//!
//! The forces on the beam, including reactions, come from the state. Their sums are moments, and the sums of these are deflections,
//! which are compared with the deflections of the state. No system of equations is solved.

mod giving;
mod worst;

use self::giving::{Slope, changes, deflections, slopes};
use super::summed::{BATCH, Summed, Walked};
use crate::scene::{Grid, Held, Scene, Spring, is_same_place};
use crate::state::{ContactState, Nodes, Reactions, SupportForce};

/// A state whose largest residual is at most this is certified.
///
/// Nodal contact forces differ from the optimum by up to `‖K‖` times the residual. With 30 intervals and the example of the paper this
/// factor is about 10³. So 1e-9 in clearance leaves six digits of a nodal force, and more of every integral quantity.
pub const CERTIFIED_RESIDUAL: f64 = 1e-9;

/// Rounding, as a share of the certified residual: sixteen units in the last place of the largest length in the scene.
///
/// Contact forces are rounded numbers. Half a unit in the last place of each moves the beam by this share of the deflection
/// `P l³ / 48 EI` that all of them together would cause. If the foundation is so close that the beam moves less than this, a smaller
/// measure would judge the representation of numbers and not the answer.
const ROUNDING: f64 = 16.0 * f64::EPSILON / CERTIFIED_RESIDUAL;

/// Deflections above this multiple of the length are treated as those of a mechanism, in a beam with hinges.
const MOST: f64 = 1e12;

/// The least deflection that is used as a measure: [`ROUNDING`] times the `P l³/48 EI` that a force causes on a beam of this length and
/// bending stiffness.
pub(crate) fn least_deflection(force: f64, length: f64, stiffness: f64) -> f64 {
    ROUNDING * flexibility(length, stiffness) * force
}

/// `l³/48 EI`.
fn flexibility(length: f64, stiffness: f64) -> f64 {
    length * length * length / (48.0 * stiffness)
}

/// Violations of (4), (5), (8) by a state, all dimensionless.
///
/// Forces are measured by `P`, the sum of all loads or of all contact forces, whichever is larger. In a scene without loads `P` is at
/// least the force `48 EI u / l³` that bends the beam down to the foundation. Lengths are measured by `D`, the largest deflection. In a
/// scene without loads `D` is at least the distance to the foundation, and it is never less than rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kkt {
    /// Feasibility: `max(v_i − g_i) / D`, the deepest penetration at a node.
    pub penetration: f64,
    /// Sign of the contact forces: `max(−p_i) / P`, the largest tension.
    pub tension: f64,
    /// Complementarity: `max min(p_i / P, h_i / D)`, force across a clearance.
    pub complementarity: f64,
    /// Equilibrium and elasticity: the deflection caused by the contact forces compared with the deflection of the state, over `D`, and
    /// the equilibrium of forces and of moments with the reactions, over `P`.
    pub equilibrium: f64,
    /// The other values of the state compared with those that follow from its deflections and forces: positions over `l`, clearances
    /// over `D`, bending moments over `P l`, reactions of compression-only supports over `P`.
    pub record: f64,
}

impl Kkt {
    /// Judges the nodal values of `state` in `scene`; [`None`] if the state has none. The nodes must be those of a grid with all supports
    /// at nodes, except the ends of the beam that have a support; otherwise the result is [`None`] too.
    #[must_use]
    pub fn of(scene: &Scene, state: &ContactState) -> Option<Self> {
        let recorded = Recorded::by(scene, state)?;
        let Recorded { nodes, ref grid, first, ref supports, ref summed, .. } = recorded;
        let Nodes { x, deflection: v, clearance: h, contact_force: p, moment, .. } = nodes;
        let ([force, depth], step) = (recorded.sizes(scene), grid.spacing());
        let gives = scene.ground_stiffness().is_some();
        let (mut places, mut depths) = ([0.0; BATCH], [0.0; BATCH]);
        let mut worst = [0.0; 7];
        let mut at_supports = [0.0; 2];
        let mut supports_ahead = supports.iter().peekable();
        let ([start, slope], kinks) = recorded.start()?;
        let tangents = summed.walk(start, slope, &kinks, |walked| {
            let Walked { first: from, moments, jump, deflections } = walked;
            while let Some(support) = supports_ahead.next_if(|s| s.node < from + deflections.len()) {
                let off = support.off(deflections[support.node - from], moments[0] * step, jump * step);
                at_supports = largest_each(at_supports, [off].into_iter());
            }
            if recorded.hinges.contains(&from) {
                at_supports = largest_each(at_supports, [[0.0, (moments[0] * step).abs()]].into_iter());
            }
            // An end of the beam that a support holds is not a node of the state.
            let Some(i) = from.checked_sub(first).filter(|i| *i < p.len()) else { return };
            let (places, u) = (&mut places[..deflections.len()], &mut depths[..deflections.len()]);
            grid.places(from, places);
            scene.gaps(places, u);
            let mut gives_here = [0.0; BATCH];
            if gives {
                for (k, (give, gap)) in gives_here.iter_mut().zip(u.iter_mut()).enumerate() {
                    *give = grid.give_of(scene, from + k);
                    // Where the foundation is interrupted no contact is possible.
                    *gap = if give.is_finite() { *gap } else { f64::INFINITY };
                }
            }
            let rows = (0..places.len()).map(|k| {
                let i = i + k;
                let clearance = u[k] - v[i];
                // On an elastic foundation, the clearance of the foot of the spring.
                let foot = if gives && clearance.is_finite() { clearance + gives_here[k] * p[i] } else { clearance };
                [
                    -foot,
                    -p[i],
                    (foot / depth).min(p[i] / force),
                    (v[i] - deflections[k]).abs(),
                    nearer(moment[i], moments[k] * step, jump * step),
                    mistaken(h[i], u[k], clearance),
                    (x[i] - places[k]).abs(),
                ]
            });
            worst = largest_each(worst, rows);
        });
        recorded.judged(scene, state, worst, at_supports, &tangents)
    }

    /// The largest of the five; infinite if any of them is NaN.
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

/// The sums of the forces that a state records on its beam. Differences at the far end and at supports are residuals.
struct Recorded<'a> {
    nodes: &'a Nodes,
    grid: Grid,
    /// The first node of the state, as a node of the grid.
    first: usize,
    supports: Vec<RecordedSupport>,
    /// Supports with a vertical spring: node, spring, and its force and moment in the state.
    springs: Vec<(usize, Spring, SupportForce)>,
    /// The slopes that supports hold, rigidly or by a spring, from left to right.
    slopes: Vec<Slope>,
    hinges: Vec<usize>,
    /// The beam under `t = q − p − R`.
    summed: Summed,
    /// Sums of the magnitudes of all loads and of all contact forces \[force\].
    load: f64,
    contact: f64,
}

/// A support: its node, what it prescribes, and its force and moment in the state.
struct RecordedSupport {
    node: usize,
    held: Held,
    recorded: SupportForce,
}

impl RecordedSupport {
    /// The deviation of a deflection from the prescribed one, and of its recorded moment from the moment before or after a jump.
    fn off(&self, deflection: f64, moment: f64, jump: f64) -> [f64; 2] {
        let moment = self.recorded.moment.map_or(0.0, |recorded| nearer(recorded, moment, jump));
        [(deflection - self.held.deflection).abs(), moment]
    }
}

/// The distance of a moment from the moment before a jump or after it, whichever is nearer.
fn nearer(recorded: f64, moment: f64, jump: f64) -> f64 {
    (recorded - moment).abs().min((recorded - (moment + jump)).abs())
}

impl<'a> Recorded<'a> {
    /// Sums the forces of a state; [`None`] if the nodes of the state are not those of a grid with all supports among them, or if the
    /// state lacks the reaction of a support.
    fn by(scene: &Scene, state: &'a ContactState) -> Option<Self> {
        let nodes = state.nodes.as_ref()?;
        let p = &nodes.contact_force;
        if [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.moment].iter().any(|list| list.len() != p.len()) {
            return None;
        }
        let (held, length) = (scene.held(), scene.beam().length());
        let [left, right] = [0.0, length].map(|end| usize::from(held.iter().any(|s| is_same_place(s.at, end, length))));
        let (grid, first) = (Grid::uniform(scene, (p.len() + left + right).checked_sub(1)?).ok()?, left);
        let support = |held: Held| {
            Some(RecordedSupport {
                node: grid.node_at(held.at)?,
                held,
                recorded: recorded_support(state, &held, length)?,
            })
        };
        let supports: Vec<_> = held.into_iter().map(support).collect::<Option<_>>()?;
        let mut forces = grid.nodal_loads(scene);
        let [load, contact] = [&forces, p].map(|forces| forces.iter().map(|force| force.abs()).sum::<f64>());
        forces[first..].iter_mut().zip(p).for_each(|(q, p)| *q -= p);
        supports.iter().for_each(|support| forces[support.node] -= support.recorded.force);
        let spring = |spring: Spring| {
            let recorded = state.supports.iter().find(|recorded| is_same_place(recorded.at, spring.at, length))?;
            let is_complete = recorded.moment.is_some() == spring.turning.is_some();
            Some((grid.node_at(spring.at)?, spring, *recorded)).filter(|_| is_complete)
        };
        let springs: Vec<_> = scene.springs().map(spring).collect::<Option<_>>()?;
        springs.iter().for_each(|(node, _, recorded)| forces[*node] -= recorded.force);
        let slopes = slopes(&supports, &springs);
        let changes = changes(scene, &grid, &slopes)?;
        let hinges = changes.iter().filter(|change| change.is_hinge()).map(|change| change.node).collect();
        let stiffness = scene.beam().bending_stiffness();
        let mut summed = Summed::of(forces, changes, grid.spacing(), stiffness, nodes.discretisation);
        if scene.beam().tension() != 0.0 {
            summed = summed.pulled(scene.beam(), &deflections(nodes, &grid, &supports), nodes.discretisation);
        }
        Some(Self { nodes, grid, first, supports, springs, slopes, hinges, summed, load, contact })
    }

    /// The differences between the reactions at the left and at the right end and the forces of the supports there, and the largest
    /// difference between the reaction of a compression-only support and the contact force of its node, which must be equal.
    fn of_supports(&self, scene: &Scene, state: &ContactState) -> Option<[f64; 3]> {
        let length = scene.beam().length();
        let pushed =
            |at: f64| Some((at, *self.nodes.contact_force.get(self.grid.node_at(at)?.checked_sub(self.first)?)?));
        let pushed: Vec<_> = scene.bearings().map(|bearing| pushed(bearing.at)).collect::<Option<_>>()?;
        let of_end = |x: f64| {
            let held = self.supports.iter().map(|s| (s.held.at, s.recorded.force));
            let held = held.chain(self.springs.iter().map(|(_, spring, recorded)| (spring.at, recorded.force)));
            held.chain(pushed.iter().copied()).find(|(at, _)| is_same_place(*at, x, length)).map_or(0.0, |s| s.1)
        };
        let recorded = |at: f64| state.supports.iter().find(|s| s.pushes_only && is_same_place(s.at, at, length));
        let mistaken = pushed.iter().map(|&(at, p)| recorded(at).map_or(f64::NAN, |s| (s.force - p).abs()));
        let Reactions { left, right } = state.reactions;
        Some([left - of_end(0.0), right - of_end(length), largest(mistaken)])
    }

    /// The deflection of the left end and the slope next to it for which the beam passes through two positions with known deflection, or
    /// through one with known slope as well; and the kinks in its hinges for which it passes through the deflections at hinges and ends.
    /// [`None`] if there are no such positions.
    fn start(&self) -> Option<([f64; 2], Vec<f64>)> {
        let known = self.known();
        let mut shot = vec![0.0; known.len()];
        let tangents = self.summed.walk(0.0, 0.0, &[], |Walked { first, deflections, .. }| {
            let here = first..first + deflections.len();
            let seen = known.iter().zip(&mut shot).filter(|((node, _), _)| here.contains(node));
            seen.for_each(|((node, _), height)| *height = deflections[node - first]);
        });
        let lowered = |k: usize| known[k].1 - shot[k];
        let place = |k: usize| self.grid.place(known[k].0);
        let slopes: Vec<f64> = match known.len() {
            0 => return None,
            1 => vec![self.slopes.first()?.turned() - tangents.first()?],
            _ => (1..known.len()).map(|k| (lowered(k) - lowered(k - 1)) / (place(k) - place(k - 1))).collect(),
        };
        let kinks = slopes.windows(2).map(|pair| pair[1] - pair[0]).collect();
        Some(([lowered(0) - slopes[0] * place(0), slopes[0]], kinks))
    }

    /// The deflections at the ends of the beam and in its hinges.
    fn at_hinges(&self) -> Option<Vec<(usize, f64)>> {
        let nodes = [0].into_iter().chain(self.hinges.iter().copied()).chain([self.grid.intervals()]);
        let deflection = |node: usize| {
            let support = self.supports.iter().find(|support| support.node == node);
            let held = support.map(|support| support.held.deflection);
            let recorded = || node.checked_sub(self.first).and_then(|i| self.nodes.deflection.get(i)).copied();
            Some((node, held.or_else(recorded)?))
        };
        nodes.map(deflection).collect()
    }

    /// The outermost two nodes with known deflection, or one if there is no other. These are supports. If supports do not hold the beam,
    /// nodes with contact forces are used with the deflection of the state: the node with the largest force, or with the largest moment
    /// about the node already chosen.
    fn known(&self) -> Vec<(usize, f64)> {
        if !self.hinges.is_empty() {
            return self.at_hinges().unwrap_or_default();
        }
        let of_support = |support: &RecordedSupport| (support.node, support.held.deflection);
        let mut known: Vec<_> = self.supports.first().map(of_support).into_iter().collect();
        known.extend(self.supports[1.min(self.supports.len())..].last().map(of_support));
        let p = &self.nodes.contact_force;
        // Springs, at their deflections in the state.
        let recorded = |(node, ..): &(usize, Spring, SupportForce)| {
            Some((*node, *self.nodes.deflection.get(node.checked_sub(self.first)?)?))
        };
        let both = || self.springs.iter().filter(|(_, spring, recorded)| !spring.pushes_only || 0.0 < recorded.force);
        if known.len() < 2 {
            known.extend(both().next().and_then(recorded));
        }
        if known.len() < 2 {
            known.extend(both().skip(1).last().and_then(recorded));
        }
        while known.len() < 2 && self.slopes.is_empty() {
            let taken = known.first().map(|(node, _)| *node);
            let turns = |i: usize| p[i] * taken.map_or(1.0, |taken| self.grid.place((i + self.first).abs_diff(taken)));
            let most = (0..p.len()).filter(|i| 0.0 < turns(*i)).max_by(|a, b| turns(*a).total_cmp(&turns(*b)));
            // If there is no contact force, the end that is farther away.
            let far = if taken.is_some_and(|taken| self.grid.intervals() <= 2 * taken) { 0 } else { p.len() - 1 };
            let i = most.unwrap_or(far);
            known.push((i + self.first, self.nodes.deflection[i]));
        }
        known.sort_by_key(|(node, _)| *node);
        known
    }

    /// `P` and `D`, by which forces and lengths are measured.
    fn sizes(&self, scene: &Scene) -> [f64; 2] {
        let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
        let deepest = largest(self.nodes.deflection.iter().map(|v| v.abs()));
        let idle = if self.load == 0.0 {
            within_reach(&self.grid.gaps_at(scene, self.first..self.first + self.nodes.x.len())).max(deepest)
        } else {
            0.0
        };
        let force = nonzero(self.load.max(self.contact).max(idle / flexibility(length, stiffness)));
        // In a scene with loads these depend on the state alone: a deep foundation that the beam does not reach must not loosen the
        // measure.
        [force, nonzero(deepest.max(idle).max(least_deflection(force, length, stiffness)))]
    }
}

/// The largest of some numbers, at least 0; infinite if one of them is NaN.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    largest_each([0.0], values.into_iter().map(|value| [value]))[0]
}

/// The same for each column of a table; `most` contains the maxima of the rows above.
fn largest_each<const COLUMNS: usize>(
    mut most: [f64; COLUMNS],
    rows: impl Iterator<Item = [f64; COLUMNS]>,
) -> [f64; COLUMNS] {
    let mut unknown = [false; COLUMNS];
    for row in rows {
        for ((most, unknown), value) in most.iter_mut().zip(&mut unknown).zip(row) {
            // Not `f64::max`, which also handles NaN and is slower: `unknown` does that.
            *most = if *most < value { value } else { *most };
            *unknown |= value.is_nan();
        }
    }
    most.iter_mut().zip(unknown).filter(|(_, unknown)| *unknown).for_each(|(most, _)| *most = f64::INFINITY);
    most
}

/// The error of a clearance in the state, beyond the rounding of the gap `u` from which it was computed.
fn mistaken(recorded: f64, u: f64, clearance: f64) -> f64 {
    // Without a foundation both are infinite.
    if u == f64::INFINITY && recorded == f64::INFINITY {
        return 0.0;
    }
    (recorded - clearance).abs() - 4.0 * f64::EPSILON * u.abs()
}

/// The magnitude of the least gap, that is the distance of the highest point of the foundation from the unloaded beam. Zero without a
/// foundation.
fn within_reach(depths: &[f64]) -> f64 {
    let highest = depths.iter().copied().fold(f64::INFINITY, f64::min);
    if highest.is_finite() { highest.abs() } else { 0.0 }
}

/// A divisor: 1 if the size is zero.
fn nonzero(size: f64) -> f64 {
    if 0.0 < size { size } else { 1.0 }
}

/// Force and moment of a support in a state; [`None`] if the state lacks its force, or the moment where the support holds the slope.
fn recorded_support(state: &ContactState, held: &Held, length: f64) -> Option<SupportForce> {
    let recorded = state.supports.iter().find(|recorded| is_same_place(recorded.at, held.at, length))?;
    let holds_slope = held.slope.is_some() || held.turning.is_some();
    (recorded.moment.is_some() == holds_slope).then_some(*recorded)
}

#[cfg(test)]
mod tests {
    use super::largest;

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
