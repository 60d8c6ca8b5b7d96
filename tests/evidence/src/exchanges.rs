//! Instances that are hard for an active set, from `tests/corpus`: full exchanges go round in circles on each line of
//! `exchanges.csv`, and exchanges of one variable of each run go round or wander on those of `dense.csv`, dense contact.

use std::collections::BTreeMap;

use crate::paper::scene_over;
use crate::random::smooth;
use palkki::qp::{FreeSet, NotPositiveDefinite, Qp};
use palkki::route::Method;
use palkki::scene::{Foundation, Scene};

/// One line of `exchanges.csv`: the beam and load of the example over a foundation `cosine amplitude wavelength phase` with
/// mean 1, or `polyline` through depths at equal distances.
#[derive(Debug)]
pub struct Instance {
    /// The line itself.
    pub line: &'static str,
    /// The method whose program it is.
    pub method: Method,
    /// Equal intervals.
    pub intervals: usize,
    /// Length of the circle.
    pub period: usize,
    /// What becomes of the paper's four steps.
    pub four_step: &'static str,
    /// The scene.
    pub scene: Scene,
}

/// All lines of `exchanges.csv`.
///
/// # Errors
///
/// The line that is no instance.
pub fn corpus() -> Result<Vec<Instance>, &'static str> {
    include_str!("../../corpus/exchanges.csv").lines().skip(1).map(|line| instance(line).ok_or(line)).collect()
}

fn instance(line: &'static str) -> Option<Instance> {
    let fields: Vec<&str> = line.split(',').collect();
    let [method, intervals, period, four_step, foundation] = fields[..] else { return None };
    let (kind, numbers) = foundation.split_once(' ')?;
    let numbers: Vec<f64> = numbers.split(' ').map(|n| n.parse().ok()).collect::<Option<_>>()?;
    let profile = match (kind, &numbers[..]) {
        ("cosine", &[amplitude, wavelength, phase]) => Foundation::Cosine { mean: 1.0, amplitude, wavelength, phase },
        ("polyline", depths) => {
            let last = u32::try_from(depths.len() - 1).ok()?;
            let place = |i: u32| 10.0 * f64::from(i) / f64::from(last);
            Foundation::Polyline { points: (0..=last).zip(depths).map(|(i, &u)| [place(i), u]).collect() }
        }
        _ => return None,
    };
    Some(Instance {
        line,
        method: Method::ALL.into_iter().find(|m| m.name() == method)?,
        intervals: intervals.parse().ok()?,
        period: period.parse().ok()?,
        four_step,
        scene: scene_over(profile).ok()?,
    })
}

/// How exchanges end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// At the optimum, after so many solves.
    Optimum {
        /// All of them.
        solves: usize,
    },
    /// On a circle: so many solves until a face is met again, and from there to there.
    Circle {
        /// Until then.
        solves: usize,
        /// From there to there.
        period: usize,
    },
}

/// Full exchanges from the face on which all variables are free, without a fallback: every free variable that came out
/// negative is set to zero and every one at zero with a negative gradient is released, all at once, until there are none.
pub fn full_exchange(qp: &dyn Qp) -> Result<End, NotPositiveDefinite> {
    exchanges(qp, |negative, _| negative)
}

/// Exchanges from the face on which all variables are free: of the free variables that came out negative all change, of those
/// at zero with a negative gradient the ones that are chosen. There are finitely many faces, so it ends at the optimum or comes
/// back to a face.
pub fn exchanges(qp: &dyn Qp, chosen: impl Fn(Vec<usize>, &[f64]) -> Vec<usize>) -> Result<End, NotPositiveDefinite> {
    /// Of the size: far above the rounding of these small solves, far below their violations.
    const SIGN: f64 = 1e-12;
    let sizes = qp.sizes();
    let mut free = FreeSet::all(qp.dimension());
    let mut seen = BTreeMap::new();
    loop {
        let solves = seen.len();
        if let Some(before) = seen.insert(free.clone(), solves) {
            return Ok(End::Circle { solves, period: solves - before });
        }
        let point = qp.stationary(&free)?;
        let dropped = free.variables().filter(|&i| point.x[i] < -SIGN * sizes.x);
        let negative =
            (0..free.dimension()).filter(|&i| !free.contains(i) && point.gradient[i] < -SIGN * sizes.gradient);
        let mut violators: Vec<usize> = dropped.collect();
        violators.extend(chosen(negative.collect(), &point.gradient));
        if violators.is_empty() {
            return Ok(End::Optimum { solves: solves + 1 });
        }
        violators.iter().for_each(|&i| free.set(i, !free.contains(i)));
    }
}

/// One line: the force method on a [smooth] scene, the solves of the exchanges, and the length of the circle at their
/// end, 0 if that is the optimum.
#[derive(Debug)]
pub struct Dense {
    /// The line itself.
    pub line: &'static str,
    /// Equal intervals.
    pub intervals: usize,
    /// How the exchanges end.
    pub end: End,
    /// The scene.
    pub scene: Scene,
}

/// All lines of `dense.csv`.
///
/// # Errors
///
/// The line that is no instance.
pub fn dense() -> Result<Vec<Dense>, &'static str> {
    include_str!("../../corpus/dense.csv").lines().skip(1).map(|line| dense_instance(line).ok_or(line)).collect()
}

fn dense_instance(line: &'static str) -> Option<Dense> {
    let fields: Vec<&str> = line.split(',').collect();
    let [intervals, segments, load, seed, solves, period] = fields[..] else { return None };
    let (solves, period) = (solves.parse().ok()?, period.parse().ok()?);
    Some(Dense {
        line,
        intervals: intervals.parse().ok()?,
        end: if period == 0 { End::Optimum { solves } } else { End::Circle { solves, period } },
        scene: smooth(segments.parse().ok()?, load.parse().ok()?, seed.parse().ok()?),
    })
}

/// Exchanges as the active set has them before windows: of each run of neighbours with a negative gradient the steepest one.
pub fn exchange_of_runs(qp: &dyn Qp) -> Result<End, NotPositiveDefinite> {
    exchanges(qp, |negative, gradient| {
        let runs = negative.chunk_by(|i, j| i + 1 == *j);
        runs.filter_map(|run| run.iter().copied().min_by(|&i, &j| gradient[i].total_cmp(&gradient[j]))).collect()
    })
}
