//! Elastic bodies whose answers are known: by construction, without rounding, or in closed form.

use palkki::body::{Body, Kind};
use palkki::methods::flexibility;
use palkki::qp::Profile;

use crate::random::Random;

/// A body with its answer.
#[derive(Debug)]
pub struct Known {
    /// The body.
    pub body: Body,
    /// Its clearances.
    pub clearance: Vec<f64>,
    /// Its contact forces.
    pub contact_force: Vec<f64>,
}

/// The five-diagonal matrix 1, −4, 6, −4, 1 of `n` freedoms: lifted off by 1 in the first half; the next tenth just touches, neither
/// lifted off nor pressed; the rest is pressed by 1.
///
/// Its condition grows with n⁴. The least eigenvalue is about 5e-13 at n = 5000.
///
/// # Panics
///
/// If `n` is less than 3.
#[must_use]
pub fn five_diagonal(n: usize) -> Known {
    let clearance: Vec<f64> = (0..n).map(|i| if i < n / 2 { 1.0 } else { 0.0 }).collect();
    let contact_force: Vec<f64> = (0..n).map(|i| if n / 2 + n / 10 <= i { 1.0 } else { 0.0 }).collect();
    let entry = |i: usize, j: usize| [6.0, -4.0, 1.0].get(i.abs_diff(j)).copied().unwrap_or(0.0);
    let load = (0..n).map(|i| {
        let near = i.saturating_sub(2)..(i + 3).min(n);
        contact_force[i] - near.map(|j| entry(i, j) * clearance[j]).sum::<f64>()
    });
    let entries = (0..n).flat_map(|i| (i.saturating_sub(2)..=i).map(move |j| (i, j, entry(i, j))));
    let body = Body::new(Kind::Stiffness, Profile::of_entries(n, entries), None, vec![0.0; n], load.collect());
    Known { body: body.expect("positive definite"), clearance, contact_force }
}

/// Two simple beams, the lower one twice as stiff and a gap `δ` below, under a force `F` upon the middle of the upper one, on an even
/// number of intervals.
///
/// Closed form: both bend as a beam does under a force in its middle, so that they touch there alone, with
/// `P = (F c − δ)/(c + c/2)`, `c = l³/48EI`; at a distance `x` from the nearer end the clearance is `δ (1 − 3x/l + 4x³/l³)`.
///
/// # Panics
///
/// If there is no interval.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "some hundreds of intervals")]
pub fn two_beams(intervals: usize) -> Known {
    // l = 1 and c = 1.
    const STIFFNESS: f64 = 1.0 / 48.0;
    const GAP: f64 = 1.0;
    const FORCE: f64 = 2.0;
    let n = intervals - 1;
    let in_middle = |force: f64| (0..n).map(|i| if i == n / 2 { force } else { 0.0 }).collect::<Vec<_>>();
    let upper = Profile::full(n, |i, j| flexibility(1.0, STIFFNESS, n, i + 1, j + 1));
    let lower = Profile::full(n, |i, j| 0.5 * upper.entry(i, j));
    let clearance = (1..=n).map(|k| {
        let x = k.min(intervals - k) as f64 / intervals as f64;
        GAP * (1.0 - 3.0 * x + 4.0 * x * x * x)
    });
    let body = Body::new(Kind::Flexibility, upper, Some(&lower), vec![GAP; n], in_middle(FORCE));
    Known {
        body: body.expect("two beams are held"),
        clearance: clearance.collect(),
        contact_force: in_middle((FORCE - GAP) / 1.5),
    }
}

/// A body of whole numbers with up to 60 freedoms, full or banded, `Mᵀ M` of a triangle `M` whose diagonal grows up to `2^exponent`; every
/// tenth freedom that touches is not pressed. None where a number has more than 53 bits, or where rounding destroys definiteness.
#[must_use]
pub fn whole(random: &mut Random, exponent: usize) -> Option<Known> {
    let mut small = |count: usize| i64::try_from(random.below(count)).unwrap_or(0);
    let n = usize::try_from(3 + small(58)).ok()?;
    let band = if small(2) == 0 { n } else { usize::try_from(1 + small(4)).ok()? };
    let spread = 1_usize << usize::try_from(small(exponent + 1)).ok()?;
    let mut triangle = vec![vec![0; n]; n];
    for (i, row) in triangle.iter_mut().enumerate() {
        row[i.saturating_sub(band)..i].fill_with(|| small(7) - 3);
        row[i] = 1 + small(spread);
    }
    let entry = |i: usize, j: usize| (0..n).map(|k| triangle[k][i] * triangle[k][j]).sum::<i64>();
    let x: Vec<i64> = (0..n).map(|_| if small(2) == 0 { 1 + small(9) } else { 0 }).collect();
    let g: Vec<i64> = x.iter().map(|x| if *x == 0 && small(10) != 0 { 1 + small(9) } else { 0 }).collect();
    let kind = if small(2) == 0 { Kind::Stiffness } else { Kind::Flexibility };
    let numbers = |values: Vec<i64>| -> Option<Vec<f64>> {
        #[expect(clippy::cast_precision_loss, reason = "that is what is asked next")]
        values.into_iter().map(|value| (value.unsigned_abs() < 1 << 53).then_some(value as f64)).collect()
    };
    let given = numbers((0..n).map(|i| g[i] - (0..n).map(|j| entry(i, j) * x[j]).sum::<i64>()).collect())?;
    let places: Vec<[usize; 2]> = (0..n).flat_map(|i| (0..=i).map(move |j| [i, j])).collect();
    let values = numbers(places.iter().map(|[i, j]| entry(*i, *j)).collect())?;
    let entries = places.iter().zip(values).map(|([i, j], a)| (*i, *j, a)).filter(|(_, _, a)| *a != 0.0);
    let matrix = Profile::of_entries(n, entries.collect::<Vec<_>>().into_iter());
    let (x, g) = (numbers(x)?, numbers(g)?);
    let none = vec![0.0; n];
    let (gap, load, clearance, contact_force) = match kind {
        Kind::Stiffness => (none, given, x, g),
        Kind::Flexibility => (given, none, g, x),
    };
    let body = Body::new(kind, matrix, None, gap, load).ok()?;
    Some(Known { body, clearance, contact_force })
}
