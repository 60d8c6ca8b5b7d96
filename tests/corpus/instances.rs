//! The instances of `exchanges.csv`, and plain full exchanges, which go round in circles on each of them.

use std::collections::BTreeMap;

use palkki::paper::scene_over;
use palkki::problem::{FreeSet, NotPositiveDefinite, Programme};
use palkki::route::Method;
use palkki::scene::{Foundation, Scene};

/// One line of `exchanges.csv`: the beam and load of the example over a foundation `cosine amplitude wavelength phase` with
/// mean 1, or `polyline` through depths at equal distances.
#[derive(Debug)]
pub(crate) struct Instance {
    pub(crate) line: &'static str,
    pub(crate) method: Method,
    pub(crate) intervals: usize,
    /// Length of the circle.
    pub(crate) period: usize,
    /// What becomes of the paper's four steps.
    pub(crate) four_step: &'static str,
    pub(crate) scene: Scene,
}

/// All of them; the error is the line that is none.
pub(crate) fn corpus() -> Result<Vec<Instance>, &'static str> {
    include_str!("exchanges.csv").lines().skip(1).map(|line| instance(line).ok_or(line)).collect()
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
        method: Method::ALL.into_iter().find(|m| m.word() == method)?,
        intervals: intervals.parse().ok()?,
        period: period.parse().ok()?,
        four_step,
        scene: scene_over(profile).ok()?,
    })
}

/// How exchanges end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// At the optimum, after so many solves.
    Optimum { solves: usize },
    /// On a circle: so many solves until a face is met again, and from there to there.
    Circle { solves: usize, period: usize },
}

/// Full exchanges from the face on which all variables are free, without a fallback: every free variable that came out
/// negative is set to zero and every one at zero with a negative gradient is released, all at once, until there are none.
pub(crate) fn full_exchange(programme: &dyn Programme) -> Result<End, NotPositiveDefinite> {
    exchanges(programme, |negative, _| negative)
}

/// Exchanges from the face on which all variables are free: of the free variables that came out negative all change, of those
/// at zero with a negative gradient the ones that are chosen. There are finitely many faces, so it ends at the optimum or comes
/// back to a face.
pub(crate) fn exchanges(
    programme: &dyn Programme,
    chosen: impl Fn(Vec<usize>, &[f64]) -> Vec<usize>,
) -> Result<End, NotPositiveDefinite> {
    /// Of the size: far above the rounding of these small solves, far below their violations.
    const SIGN: f64 = 1e-12;
    let sizes = programme.sizes();
    let mut free = FreeSet::all(programme.dimension());
    let mut seen = BTreeMap::new();
    loop {
        let solves = seen.len();
        if let Some(before) = seen.insert(free.clone(), solves) {
            return Ok(End::Circle { solves, period: solves - before });
        }
        let point = programme.stationary(&free)?;
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
