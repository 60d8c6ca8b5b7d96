//! The three methods, with their matrices on a grid that is small enough to be read.

use palkki::methods::{Discrete, Method};
use palkki::scene::{Beam, Foundation, Load, Scene};
use serde::Serialize;

use crate::report::csv::fixed;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers::power;
use crate::report::study::Study;

/// Intervals of the grid that is printed.
const INTERVALS: u8 = 4;

#[derive(Debug, Serialize)]
struct Values {
    intervals: u8,
    nodes: u8,
    /// One matrix for each method.
    matrices: Vec<Printed>,
    /// Condition numbers of `K` and `C`, for the paper's grid and a finer one, as orders of magnitude.
    conditions: Vec<Condition>,
}

#[derive(Debug, Serialize)]
struct Printed {
    method: &'static str,
    /// Each row as text in columns.
    rows: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Condition {
    intervals: usize,
    /// The power of ten next to the condition number, in words.
    condition: String,
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    // Spacing and stiffness are 1, so that the numbers are multiples of EI/Δ⁴, EI/Δ³ and Δ³/EI.
    let beam = Beam::new(f64::from(INTERVALS), 1.0)?;
    let scene = Scene::new(beam, Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
    let discrete = Discrete::new(&scene, usize::from(INTERVALS))?;
    let n = discrete.interior();
    let printed = |method: Method| {
        let matrix = method.programme(&discrete).matrix();
        let row = |i: usize| (0..n).map(|j| format!("{:>10}", fixed(matrix.entry(i, j), 4))).collect();
        Printed { method: method.word(), rows: (0..n).map(row).collect() }
    };
    let conditions = study
        .ledger()?
        .recommendation
        .digits
        .iter()
        .map(|digits| Condition { intervals: digits.intervals, condition: power(order(digits.condition)) });
    Ok(Evidence::new(Values {
        intervals: INTERVALS,
        nodes: INTERVALS - 1,
        matrices: Method::ALL.map(printed).into(),
        conditions: conditions.collect(),
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
