//! The discrete problem on a given set of contact nodes: a continuous beam over sinking supports (Clapeyron 1857).
//!
//! Moments count in `m = M/Δ`, deflections in `y = 6 EI v/Δ³`: both are forces. By definition, at every interior node,
//!
//! ```text
//! statics      m_{i−1} − 2 m_i + m_{i+1} = −(q_i − p_i)
//! elasticity   y_{i−1} − 2 y_i + y_{i+1} = −κ_i,      κ_i = m_{i−1} + 4 m_i + m_{i+1}     energy methods (beam elements)
//!                                                     κ_i = 6 m_i                         finite differences
//! ```
//!
//! and `m = y = 0` at the two ends. Between two supports the loads give `m` and `y` of a simple beam; at a support with spans
//! of `a` and `b` intervals beside it
//!
//! ```text
//! (a − ε/a) m₋ + (2 (a + b) + ε/a + ε/b) m + (b − ε/b) m₊ = −(ϑ_right + ϑ_left) − (bend of the polyline of depths)
//! ```
//!
//! with ε = 0 for beam elements and 1 for finite differences.

use palkki::state::Discretisation;

use super::number::Number;

/// A scene on a grid. Indices run from 0 to N, the supports of the beam included.
#[derive(Debug, Clone)]
pub struct Problem<T> {
    /// Beam elements or finite differences.
    pub discretisation: Discretisation,
    /// `Δ`.
    pub spacing: T,
    /// `EI`.
    pub stiffness: T,
    /// Nodal loads `q`, forces.
    pub loads: Vec<T>,
    /// Depths `u`; zero at the supports of the beam, which do not lie on the foundation.
    pub depths: Vec<T>,
}

/// The beam held on some nodes.
#[derive(Debug, Clone)]
pub struct Solution<T> {
    /// `M/Δ`.
    moments: Vec<T>,
    /// `6 EI v/Δ³`.
    heights: Vec<T>,
    /// `p`.
    pub contact_force: Vec<T>,
    /// `6 EI h/Δ³`.
    clearances: Vec<T>,
    /// What the definition is violated by, at worst.
    residual: T,
    /// `Δ³/(6 EI)`.
    pub unit: T,
}

impl<T: Number> Problem<T> {
    /// `N`.
    #[must_use]
    pub fn intervals(&self) -> usize {
        self.loads.len() - 1
    }

    /// The optimum, its contact set and how many exchanges it took from the contact set `touches`: nodes on the wrong side
    /// change sides until (34), (35) hold with certainty. None if that takes too long.
    pub fn optimum(&self, mut touches: Vec<bool>) -> Option<(Solution<T>, Vec<bool>, usize)> {
        /// From the contact set of an active set two or three are the rule.
        const MOST: usize = 60;
        for exchanges in 0..MOST {
            let solution = self.solve(&touches);
            let wrong = solution.wrong(&touches);
            if wrong.is_empty() {
                return solution.is_optimal(&touches).then_some((solution, touches, exchanges));
            }
            wrong.iter().for_each(|i| touches[i - 1] = !touches[i - 1]);
        }
        None
    }

    /// The answer on the nodes that `touches`, entry `i − 1` for node `i`.
    pub fn solve(&self, touches: &[bool]) -> Solution<T> {
        let n = self.intervals();
        let unit = cube(&self.spacing).over(&T::whole(6).times(&self.stiffness));
        let depths: Vec<T> = self.depths.iter().map(|u| u.over(&unit)).collect();
        let inner = (1..n).filter(|&i| touches[i - 1]);
        let supports: Vec<usize> = [0].into_iter().chain(inner).chain([n]).collect();

        let at_supports = self.support_moments(&supports, &depths);
        let (mut moments, mut heights) = (vec![T::zero(); n + 1], vec![T::zero(); n + 1]);
        for (span, ends) in supports.windows(2).zip(at_supports.windows(2)) {
            let (from, to) = (span[0], span[1]);
            let m = polygon(&self.loads[from + 1..to], &ends[0], &ends[1]);
            let y = polygon(&self.curvatures(&m), &depths[from], &depths[to]);
            moments[from..=to].clone_from_slice(&m);
            heights[from..=to].clone_from_slice(&y);
        }
        let mut contact_force = vec![T::zero(); n + 1];
        for &i in &supports[1..supports.len() - 1] {
            contact_force[i] = self.loads[i].plus(&second_difference(&moments, i));
        }
        let clearances = depths.iter().zip(&heights).map(|(u, y)| u.minus(y)).collect();
        let mut solution = Solution { moments, heights, contact_force, clearances, residual: T::zero(), unit };
        solution.residual = self.worst_residual(&solution);
        solution
    }

    /// The moments at all supports, by elimination from left to right and substitution back.
    fn support_moments(&self, supports: &[usize], depths: &[T]) -> Vec<T> {
        let spans: Vec<Span<T>> = supports.windows(2).map(|s| self.span(s[0], s[1], depths)).collect();
        let mut moments = vec![T::zero(); supports.len()];
        let mut passed = vec![T::zero(); supports.len()];
        for (i, pair) in spans.windows(2).enumerate() {
            let (left, right) = (&pair[0], &pair[1]);
            let right_hand_side =
                T::zero().minus(&left.rotations[1].plus(&right.rotations[0])).minus(&right.slope.minus(&left.slope));
            let pivot = left.own.plus(&right.own).minus(&left.other.times(&passed[i]));
            moments[i + 1] = right_hand_side.minus(&left.other.times(&moments[i])).over(&pivot);
            passed[i + 1] = right.other.over(&pivot);
        }
        for i in (1..supports.len() - 1).rev() {
            moments[i] = moments[i].minus(&passed[i].times(&moments[i + 1]));
        }
        moments
    }

    /// What the equation of a support wants to know of a span beside it.
    fn span(&self, from: usize, to: usize, depths: &[T]) -> Span<T> {
        let length = whole::<T>(to - from);
        let slope = depths[to].minus(&depths[from]).over(&length);
        let m = polygon(&self.loads[from + 1..to], &T::zero(), &T::zero());
        let curvatures = self.curvatures(&m);
        let mut rotations = [T::zero(), T::zero()];
        for (k, curvature) in curvatures.iter().enumerate() {
            let shares = [to - from - k - 1, k + 1];
            for (rotation, share) in rotations.iter_mut().zip(shares) {
                *rotation = rotation.plus(&curvature.times(&whole(share)));
            }
        }
        let mut rotations = rotations.map(|r| r.over(&length));
        let twice = length.plus(&length);
        match self.discretisation {
            // The half of κ at a support that belongs to this side: 2 m₀ + m₁.
            Discretisation::BeamElements => {
                rotations[0] = rotations[0].plus(&m[1]);
                rotations[1] = rotations[1].plus(&m[m.len() - 2]);
                Span { slope, rotations, own: twice, other: length }
            }
            Discretisation::FiniteDifferences => {
                let less = T::whole(1).over(&length);
                Span { slope, rotations, own: twice.plus(&less), other: length.minus(&less) }
            }
        }
    }

    /// `κ` at the inner nodes of a stretch with the moments `m`.
    fn curvatures(&self, m: &[T]) -> Vec<T> {
        let curvature = |m: &[T]| match self.discretisation {
            Discretisation::BeamElements => m[0].plus(&T::whole(4).times(&m[1])).plus(&m[2]),
            Discretisation::FiniteDifferences => T::whole(6).times(&m[1]),
        };
        m.windows(3).map(curvature).collect()
    }

    /// The worst violation of statics, elasticity and contact, by the definition alone.
    fn worst_residual(&self, solution: &Solution<T>) -> T {
        let Solution { moments, heights, contact_force, .. } = solution;
        let mut worst = T::zero();
        let mut see = |value: T| {
            let value = value.magnitude();
            if worst < value {
                worst = value;
            }
        };
        for (i, curvature) in (1..).zip(self.curvatures(moments)) {
            let carried = self.loads[i].minus(&contact_force[i]);
            see(second_difference(moments, i).plus(&carried));
            see(second_difference(heights, i).plus(&curvature));
        }
        for ends in [moments, heights] {
            see(ends[0].clone());
            see(ends[ends.len() - 1].clone());
        }
        worst
    }
}

/// One span: slope of its chord, end rotations under its own loads, coefficients of the moments at its two ends.
struct Span<T> {
    slope: T,
    rotations: [T; 2],
    own: T,
    other: T,
}

impl<T: Number> Solution<T> {
    /// What every moment and every deflection, as forces, is off by at most.
    ///
    /// A residual is a force or a kink that was not asked for. One of size r moves a beam without inner supports nowhere by
    /// more than N³ r/8, and with supports less; there are two at each of N nodes. Clearances and contact forces are sums of
    /// up to four such numbers.
    pub fn uncertainty(&self) -> T {
        let n = whole::<T>(self.moments.len());
        cube(&n).times(&n).times(&self.residual)
    }

    /// Nodes on the wrong side of (34), (35), by their number: those in contact that pull and those out of it that penetrate.
    pub fn wrong(&self, touches: &[bool]) -> Vec<usize> {
        let negative = |i: &usize| {
            let value = if touches[*i - 1] { &self.contact_force[*i] } else { &self.clearances[*i] };
            *value < T::zero()
        };
        (1..=touches.len()).filter(negative).collect()
    }

    /// Whether (34), (35) hold with certainty: what is held has `h = 0` and presses, the rest has `p = 0` and does not
    /// penetrate, by more than what rounding could have changed. Without rounding, exactly.
    pub fn is_optimal(&self, touches: &[bool]) -> bool {
        let least = self.uncertainty();
        (1..=touches.len()).all(|i| {
            let (p, h) = (&self.contact_force[i], &self.clearances[i]);
            if touches[i - 1] { least <= *p && h.magnitude() <= least } else { p.magnitude() <= least && least <= *h }
        })
    }

    /// `v` at a node.
    pub fn deflection(&self, node: usize) -> T {
        self.heights[node].times(&self.unit)
    }

    /// The left reaction, with `load`, that of the node at the support: the shear force of the first interval is `m₁`.
    pub fn left_reaction(&self, load: &T) -> T {
        self.moments[1].plus(load)
    }

    /// `M` at a node.
    pub fn moment(&self, node: usize, spacing: &T) -> T {
        self.moments[node].times(spacing)
    }

    /// `J(v) = Σ (½ t − q) v` with `t = q − p`, since `v = C t`.
    pub fn energy(&self, loads: &[T]) -> T {
        let half = T::fraction(-1, 2);
        let terms = loads.iter().zip(&self.contact_force).zip(&self.heights);
        let sum = terms.fold(T::zero(), |sum, ((q, p), y)| sum.plus(&q.plus(p).times(y)));
        sum.times(&half).times(&self.unit)
    }
}

/// `y` with `y_{k−1} − 2 y_k + y_{k+1} = −f_k` between two given ends: forces to slopes, slopes to heights.
fn polygon<T: Number>(f: &[T], from: &T, to: &T) -> Vec<T> {
    let length = f.len() + 1;
    let moment = (1..).zip(f).fold(to.minus(from), |sum, (k, f)| sum.plus(&f.times(&whole(length - k))));
    let mut slope = moment.over(&whole(length));
    let mut y = Vec::with_capacity(length + 1);
    y.push(from.clone());
    for (k, f) in f.iter().enumerate() {
        y.push(y[k].plus(&slope));
        slope = slope.minus(f);
    }
    y.push(to.clone());
    y
}

fn second_difference<T: Number>(y: &[T], i: usize) -> T {
    y[i - 1].minus(&y[i]).plus(&y[i + 1].minus(&y[i]))
}

fn cube<T: Number>(value: &T) -> T {
    value.times(value).times(value)
}

fn whole<T: Number>(count: usize) -> T {
    T::whole(i64::try_from(count).unwrap_or(i64::MAX))
}
