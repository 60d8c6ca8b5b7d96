//! The root of a function of the varied number.

use super::Sweep;

/// Values below this share of the range are treated as this large when rounding is estimated.
const SMALL: f64 = 1e-3;

/// Number of consecutive secant steps before a bisection step.
const SECANTS: u32 = 3;

impl Sweep<'_> {
    /// Whether two values are so close that only rounding separates them.
    pub(super) fn is_narrow(&self, a: f64, b: f64) -> bool {
        let [start, end] = self.range;
        (b - a).abs() <= 2.0 * f64::EPSILON * a.abs().max(b.abs()).max(SMALL * (end - start).abs())
    }
}

/// The root of a function between the value `good`, where it is positive or undefined, and `bad`, where it is negative.
///
/// The method is the secant, with the number at an end that stays halved (Illinois), and every fourth step is a bisection. The search
/// ends when it `is_done` between two values.
pub(super) fn root(
    (mut good, mut at_good): (f64, Option<f64>),
    (mut bad, mut at_bad): (f64, f64),
    is_done: impl Fn(f64, f64) -> bool,
    mut of: impl FnMut(f64) -> Option<f64>,
) -> f64 {
    let mut turn = 0;
    let mut stays = 0;
    loop {
        let middle = 0.5 * (good + bad);
        if is_done(good, bad) {
            return middle;
        }
        turn += 1;
        let secant = at_good.map(|at_good| bad - at_bad * ((bad - good) / (at_bad - at_good)));
        let inside = |x: &f64| (x - good) * (x - bad) < 0.0;
        let next = secant.filter(|_| turn % (SECANTS + 1) != 0).filter(inside).unwrap_or(middle);
        match of(next) {
            Some(0.0) => return next,
            Some(m) if m < 0.0 => {
                (bad, at_bad) = (next, m);
                if stays == 1 {
                    at_good = at_good.map(|m| 0.5 * m);
                }
                stays = 1;
            }
            m => {
                (good, at_good) = (next, m);
                if stays == -1 {
                    at_bad *= 0.5;
                }
                stays = -1;
            }
        }
    }
}
