//! The loads of a scene as they are drawn above the beam.

use super::units::{UnitLabels, with_unit};
use crate::plot::curves::Curves;
use crate::plot::layer::LoadSketch;
use crate::scene::Scene;

/// `q(x)` as a line with its steps, and the point loads.
pub(super) fn sketch(scene: &Scene, curves: &Curves, units: &UnitLabels) -> LoadSketch {
    let (load, length) = (scene.load(), scene.beam().length());
    let mut cuts: Vec<f64> = load.linear().iter().flat_map(|q| [q.from, q.to]).chain([0.0, length]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by_key(|x| x.to_bits());
    let mut intensity = Vec::new();
    let mut values: Vec<(f64, f64, String)> = Vec::new();
    for pair in cuts.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let middle = 0.5 * (from + to);
        let q = |x: f64| {
            let linear = load.linear().iter().filter(|q| (q.from..=q.to).contains(&middle)).map(|q| q.intensity(x));
            load.uniform() + linear.sum::<f64>()
        };
        let (start, end) = (q(from), q(to));
        intensity.extend([[from, start], [to, end]]);
        let text = |value: f64| format!("q = {}", with_unit(value, units.pressure.as_ref()));
        if start.to_bits() == end.to_bits() {
            if start != 0.0 {
                values.push((middle, start, text(start)));
            }
        } else if end.abs() < start.abs() {
            values.push((from, start, text(start)));
        } else {
            values.push((to, end, text(end)));
        }
    }
    let points = load.point().iter().map(|p| (p.at, p.force, with_unit(p.force.abs(), units.force.as_ref()))).collect();
    // Above the highest point of the beam, which may rise above the line of its supports.
    let level = curves.deflection.iter().fold(0.0_f64, |least, v| least.min(*v));
    LoadSketch { level, intensity, values, points }
}
