//! The three methods, with their matrices on a grid that is small enough to be read.

use std::fmt::Write as _;

use minijinja::context;
use palkki::methods::{Discrete, Method};
use palkki::scene::{Beam, Foundation, Load, Scene};

use crate::report::csv::fixed;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::study::Study;

/// Intervals of the grid that is printed.
const INTERVALS: u8 = 4;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    // Spacing and stiffness are 1, so that the numbers are multiples of EI/Δ⁴, EI/Δ³ and Δ³/EI.
    let beam = Beam::new(f64::from(INTERVALS), 1.0)?;
    let scene = Scene::new(beam, Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
    let discrete = Discrete::new(&scene, usize::from(INTERVALS))?;
    let n = discrete.interior();
    let mut matrices = String::new();
    for (method, name) in Method::ALL.into_iter().zip(["A of method 1, in EI/Δ⁴", "K, in EI/Δ³", "C, in Δ³/EI"])
    {
        let matrix = method.programme(&discrete).matrix();
        writeln!(matrices, "{name}")?;
        for i in 0..n {
            let row: String = (0..n).map(|j| format!("{:>10}", fixed(matrix.entry(i, j), 4))).collect();
            writeln!(matrices, "{row}")?;
        }
    }
    // The condition of K and C, as orders of magnitude.
    let digits = &study.ledger()?.recommendation.digits;
    let conditions: Vec<String> =
        digits.iter().map(|d| format!("{} with {} intervals", power(order(d.condition)), d.intervals)).collect();
    Ok(Evidence::new(context! {
        intervals => INTERVALS,
        nodes => INTERVALS - 1,
        matrices => matrices.trim_end(),
        conditions => conditions.join(" and "),
    }))
}

/// The nearest power of ten.
fn order(value: f64) -> i32 {
    let scientific = format!("{value:.0e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or(("1", "0"));
    let up = i32::from(mantissa.parse::<u32>().is_ok_and(|digit| 3 < digit));
    exponent.parse::<i32>().unwrap_or(0) + up
}

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn powers_of_ten_are_the_nearest() {
        assert_eq!([1.2e5, 4.6e5, 9.6e8].map(order), [5, 6, 9]);
    }
}
