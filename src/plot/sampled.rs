//! The curves of an exact solution, sampled from the functions that it is made of.

use super::curves::{Curves, PointForce};
use super::layer::Place;
use crate::scene::{Foundation, Scene};
use crate::state::ContactState;

/// Equal intervals between two samples, besides the places where something jumps; a drawing is 2400 units wide.
const INTERVALS: u32 = 600;

/// A zone's pressure is asked for this part of its length inside its ends, where rounding cannot put it outside.
const INSIDE: f64 = 1e-9;

impl Curves {
    /// The curves of a state whose deflection, moment and distributed contact pressure are known as functions of `x`.
    ///
    /// Concentrated forces come from the contacts of `state`, clearance from the foundation. Shear is the derivative of
    /// the parabola through the moments at the ends and in the middle of each interval: exact under a uniform load.
    #[must_use]
    pub fn sampled(
        scene: &Scene,
        state: &ContactState,
        deflection: impl Fn(f64) -> f64,
        moment: impl Fn(f64) -> f64,
        pressure: impl Fn(f64) -> f64,
    ) -> Self {
        let x = places(scene, state);
        let touching = |x: f64| state.contacts.iter().any(|c| (c.from..=c.to).contains(&x));
        // Where it touches, the clearance is zero and not the rounding of a difference.
        let clearance = x.iter().map(|&x| if touching(x) { 0.0 } else { scene.depth(x) - deflection(x) }).collect();
        let shear = x
            .windows(2)
            .flat_map(|ends| {
                let (a, b) = (ends[0], ends[1]);
                let [left, middle, right] = [a, 0.5 * (a + b), b].map(&moment);
                let h = b - a;
                [[a, (4.0 * middle - 3.0 * left - right) / h], [b, (left + 3.0 * right - 4.0 * middle) / h]]
            })
            .collect();
        let mut zones: Vec<Vec<Place>> = Vec::new();
        let mut point_forces = Vec::new();
        let mut push = |at: f64, force: f64| point_forces.push(PointForce { at, force, nodes: 1 });
        for contact in &state.contacts {
            let (from, to) = (contact.from, contact.to);
            if to <= from {
                push(from, contact.force);
                continue;
            }
            let edge = INSIDE * (to - from);
            let within = x.iter().filter(|x| (from..=to).contains(x));
            zones.push(within.map(|&x| [x, pressure(x.clamp(from + edge, to - edge))]).collect());
            if let Some([left, right]) = contact.end_forces {
                push(from, left);
                push(to, right);
            }
        }
        Self {
            deflection: x.iter().map(|&x| deflection(x)).collect(),
            clearance,
            moment: x.iter().map(|&x| moment(x)).collect(),
            shear,
            pressure: zones,
            point_forces,
            contacts: state.contacts.iter().map(|c| [c.from, c.to]).collect(),
            reactions: state.reactions,
            deflection_extremes: state.deflection,
            moment_extremes: state.moment,
            x,
        }
    }
}

/// Equally spaced places, and all those at which a curve may have a kink or a jump.
fn places(scene: &Scene, state: &ContactState) -> Vec<f64> {
    let length = scene.beam().length();
    let even = (0..=INTERVALS).map(|i| length * (f64::from(i) / f64::from(INTERVALS)));
    let mut x: Vec<f64> = even.chain(state.contacts.iter().flat_map(|c| [c.from, c.to])).collect();
    x.extend(scene.load().linear().iter().flat_map(|q| [q.from, q.to]));
    x.extend(scene.load().point().iter().map(|p| p.at));
    if let Some(Foundation::Polyline { points }) = scene.foundation() {
        x.extend(points.iter().map(|p| p[0]));
    }
    x.retain(|x| (0.0..=length).contains(x));
    x.sort_by(f64::total_cmp);
    // Places closer than rounding make no interval: their moments cannot be told apart.
    x.dedup_by(|b, a| *b - *a <= 1e-9 * length);
    x
}

#[cfg(test)]
mod tests {
    use super::Curves;
    use crate::plot::curves;
    use crate::scene::{Beam, Foundation, Load, Scene};
    use crate::state::{Contact, ContactState, Extremes, Reactions, Regime};

    /// The paper's beam with `EI = 1`, `q₀ = 24`, `u₀ = 1`, so that `a = 1`, `T = 12`.
    #[test]
    fn the_exact_solution_keeps_its_equilibrium() {
        let (l, q, a, t) = (4.0, 24.0, 1.0, 12.0);
        let beam = Beam::new(l, 1.0).expect("a beam");
        let load = Load::uniform_on(&beam, q).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
        let state = ContactState {
            regime: Regime::Zone,
            reactions: Reactions { left: t, right: t },
            contacts: vec![Contact { from: a, to: l - a, force: 72.0, end_forces: Some([t, t]) }],
            deflection: Extremes { max: 1.0, max_at: 2.0, min: 0.0, min_at: 0.0 },
            moment: Extremes { max: 3.0, max_at: 0.5, min: 0.0, min_at: 2.0 },
            energy: 0.0,
            nodes: None,
        };
        let near = |x: f64| x.min(l - x);
        let s = |x: f64| (a - near(x)).max(0.0);
        let sampled = Curves::sampled(
            &scene,
            &state,
            |x| 1.0 - q * s(x) * s(x) * s(x) * (2.0 * a - s(x)) / 24.0,
            |x| 0.5 * q * near(x) * (a - near(x)).max(0.0),
            |x| if a <= near(x) { q } else { 0.0 },
        );
        let area = |line: &[[f64; 2]]| -> f64 {
            line.windows(2).map(|p| 0.5 * (p[0][1] + p[1][1]) * (p[1][0] - p[0][0])).sum()
        };
        let contact: f64 = sampled.pressure.iter().map(|zone| area(zone)).sum::<f64>()
            + sampled.point_forces.iter().map(|f| f.force).sum::<f64>();
        // Rounding of some hundred sums.
        let close = |value: f64, expected: f64| (value - expected).abs() < 1e-9 * expected.abs().max(1.0);
        assert!(close(contact + 2.0 * t, q * l), "contact {contact} and reactions carry the load");
        assert!(close(area(&sampled.shear), 0.0), "shear is the derivative of a moment that vanishes at both ends");
        assert!(close(sampled.shear[0][1], t), "shear at the support is the reaction");
        let svg = curves(&scene, &sampled, "exact").expect("a figure");
        assert!(svg.contains("V = 12 at x = 0") && svg.contains("contact pressure p"), "shear and pressure are drawn");
    }
}
