//! Exact solutions as tables of numbers.

use palkki::plot::Curves;

use super::csv::{csv, fixed, one_a_place};

/// What a figure of the curves draws, row by row, one row for places that print alike; no pressure where nothing touches, no
/// clearance without a foundation.
pub(super) fn table(curves: &Curves) -> String {
    /// Places to which the numbers are printed.
    const PLACES: usize = 5;
    let number = |value: f64| if value.is_finite() { fixed(value, PLACES) } else { String::new() };
    let zones: Vec<[f64; 2]> = curves.pressure.iter().flatten().copied().collect();
    let rows = curves.x.iter().enumerate().map(|(i, &x)| {
        let at = zones.partition_point(|p| p[0] < x);
        let pressure = zones.get(at).filter(|p| p[0] <= x).map_or_else(String::new, |p| number(p[1]));
        let [deflection, clearance, moment] = [curves.deflection[i], curves.clearance[i], curves.moment[i]].map(number);
        vec![number(x), deflection, clearance, pressure, moment]
    });
    csv(&["x", "deflection", "clearance", "pressure", "moment"], one_a_place(rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_example_is_flat_between_its_lift_off_points() {
        let scene = palkki_evidence::paper::example().expect("the example is well posed");
        let exact = palkki::theory::solve(&scene).expect("it has an exact solution");
        let curves = Curves::exact(&scene, &exact);
        assert_eq!(curves.point_forces.len(), 2, "one force at each lift-off point");
        let table = table(&curves);
        let middle: Vec<&str> = table.lines().filter(|line| line.starts_with("5.00000,")).collect();
        assert_eq!(middle, ["5.00000,1.00000,0.00000,1.00000,0.00000"], "{table}");
        assert!(table.contains("0.00000,0.00000,1.00000,,0.00000"), "no pressure beside a support: {table}");
    }
}
