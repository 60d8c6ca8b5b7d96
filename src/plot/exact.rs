//! The curves of an exact solution, from samples of the functions that it is made of.

use super::curves::{Curves, PointForce};
use crate::scene::Scene;
use crate::theory::Exact;

/// Equal intervals between samples; a drawing is 2400 units wide.
const INTERVALS: u32 = 600;

impl Curves {
    /// The exact solution of a scene as a figure needs it.
    #[must_use]
    pub fn exact(scene: &Scene, exact: &Exact) -> Self {
        let samples = exact.samples(scene, INTERVALS);
        let state = &exact.state;
        let zones = state.contacts.iter().filter(|c| c.from < c.to);
        let pressure = zones
            .map(|zone| {
                let within = samples.iter().filter(|s| zone.from <= s.x && s.x <= zone.to);
                // At its ends the samples outside of the zone are those without pressure.
                let outside = |x: f64, pressure: f64| pressure == 0.0 && (x <= zone.from || zone.to <= x);
                within.filter(|s| !outside(s.x, s.pressure)).map(|s| [s.x, s.pressure]).collect()
            })
            .collect();
        Self {
            x: samples.iter().map(|s| s.x).collect(),
            deflection: samples.iter().map(|s| s.deflection).collect(),
            clearance: samples.iter().map(|s| s.clearance).collect(),
            moment: samples.iter().map(|s| s.moment).collect(),
            shear: samples.iter().map(|s| [s.x, s.shear]).collect(),
            pressure,
            point_forces: point_forces(exact),
            contacts: state.contacts.iter().map(|c| [c.from, c.to]).collect(),
            reactions: state.reactions,
            deflection_extremes: state.deflection,
            moment_extremes: state.moment,
        }
    }
}

/// Concentrated contact forces: point contacts, the ends of zones, and point loads that a zone carries.
fn point_forces(exact: &Exact) -> Vec<PointForce> {
    let mut forces = Vec::new();
    for contact in &exact.state.contacts {
        match contact.end_forces {
            Some([from, to]) => forces.extend([(contact.from, from), (contact.to, to)]),
            None => forces.push((contact.from, contact.force)),
        }
    }
    forces.extend(exact.forces_inside_zones());
    forces.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A zone that ends at a support has no force there.
    forces.retain(|&(_, force)| force != 0.0);
    forces.into_iter().map(|(at, force)| PointForce { at, force, nodes: 1 }).collect()
}

#[cfg(test)]
mod tests {
    use super::Curves;
    use crate::plot::curves;
    use crate::scene::{Beam, Foundation, Load, PointLoad, Scene};
    use crate::theory;

    /// Rounding of some hundred sums.
    const ROUNDING: f64 = 1e-9;

    /// A beam with `EI = 1`, `q₀ = 24`, `u₀ = 1`, so that `a = 1`, `T = 12`; and a load on it where it touches.
    #[test]
    fn the_exact_solution_keeps_its_equilibrium() {
        let (l, q, t, force) = (4.0, 24.0, 12.0, 3.0);
        let beam = Beam::new(l, 1.0).expect("a beam");
        let load = Load::new(&beam, q, Vec::new(), vec![PointLoad { at: 2.0, force }]).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
        let sampled = Curves::exact(&scene, &theory::solve(&scene).expect("an exact solution"));
        let area = |line: &[[f64; 2]]| -> f64 {
            line.windows(2).map(|p| 0.5 * (p[0][1] + p[1][1]) * (p[1][0] - p[0][0])).sum()
        };
        let close = |value: f64, expected: f64| (value - expected).abs() < ROUNDING * expected.abs().max(1.0);
        let distributed: f64 = sampled.pressure.iter().map(|zone| area(zone)).sum();
        assert!(close(distributed, q * (l - 2.0)), "{distributed} is distributed");
        let forces: Vec<f64> = sampled.point_forces.iter().map(|f| f.force).collect();
        assert!(forces.len() == 3 && close(forces[1], force), "lift-off points and a load between them: {forces:?}");
        let carried = distributed + forces.iter().sum::<f64>() + 2.0 * t;
        assert!(close(carried, q * l + force), "contact and reactions carry {carried}");
        assert!(close(area(&sampled.shear), 0.0), "shear is the derivative of a moment that vanishes at both ends");
        assert!(close(sampled.shear[0][1], t), "shear at the support is the reaction");
        let svg = curves(&scene, &sampled, "exact").expect("a figure");
        assert!(svg.contains("V = 12 at x = 0") && svg.contains("contact pressure p"), "shear and pressure are drawn");
    }
}
