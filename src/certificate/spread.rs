//! Forces that a program computed for the springs of an elastic foundation: the length over which each acts, and the position of a beam
//! that only these forces hold.
//!
//! The spring at a node of a mesh stands for the foundation on its share of the beam. So each force is distributed evenly over half the
//! distance to the nearer of its neighbours, on both sides: its resultant stays where it was given. A force at an end of the beam, at a
//! compression-only support or without a neighbour stays concentrated. The spring stiffness is `∫k` over the length of the force.
//!
//! If the supports do not hold the beam, the forces determine both how it bends and how deep it is, like springs of the width `w` of each
//! force:
//!
//! ```text
//! v(x_i) ≈ g(x_i) + f_i/∫k,      v + a + b x, or v + b (x − x_s) on a single support, by least squares
//! ```
//!
//! The judged deflection is the beam under the true load and these pressures, in this position. The bound on its error is true whatever
//! the forces are.

use super::contact_load::{self, ContactLoad, bent};
use super::kernel::contact_node::EnclosedScene;
use super::kernel::interval::Interval;
use super::kernel::polynomial::Polynomial;
use super::standing;
use crate::scene::{LinearLoad, Load, Scene};

/// A cell of a deflection: `v(from + s)`.
type Curve = ([f64; 2], Polynomial);

/// A contact force and the width over which it is distributed; zero if it is concentrated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spread {
    pub(crate) x: f64,
    pub(crate) force: f64,
    pub(crate) width: f64,
    /// `∫k` over this width.
    pub(crate) spring: f64,
}

/// The forces, from left to right.
pub(crate) fn spread(scene: &Scene, forces: &ContactLoad) -> Vec<Spread> {
    let (length, places) = (scene.beam().length(), &forces.places);
    let width = |x: f64| {
        let i = places.partition_point(|place| *place < x);
        let beside = [i.checked_sub(1), Some(i + 1)].map(|i| places.get(i?).map(|place| (place - x).abs()));
        let nearest = beside.into_iter().flatten().reduce(f64::min).unwrap_or(0.0);
        let stands = scene.beam().bearings().iter().any(|bearing| (bearing.at - x).abs() <= 0.5 * nearest);
        if stands { 0.0 } else { (2.0 * x.min(length - x)).min(nearest) }
    };
    let parts: Vec<_> = scene.ground_parts().collect();
    let spring = |x: f64, width: f64| match parts[..] {
        [(_, k)] => k * width,
        _ => {
            let over = |(part, k): &([f64; 2], f64)| {
                k * (part[1].min(x + 0.5 * width) - part[0].max(x - 0.5 * width)).max(0.0)
            };
            parts.iter().map(over).sum()
        }
    };
    let one = |&(x, force): &(f64, f64)| {
        let width = width(x);
        Spread { x, force, width, spring: spring(x, width) }
    };
    forces.pressing.iter().map(one).collect()
}

/// The deflection that contact forces cause. The forces of an elastic foundation act like forces of springs.
pub(super) fn caused(scene: &Scene, enclosed: &EnclosedScene<'_>, forces: &ContactLoad) -> Option<Vec<Curve>> {
    match scene.ground_stiffness() {
        Some(_) => deflection(scene, enclosed, forces),
        None => contact_load::deflection(forces, enclosed, &[]),
    }
}

/// The deflection that spring forces cause; [`None`] if they do not determine its position.
pub(super) fn deflection(scene: &Scene, enclosed: &EnclosedScene<'_>, forces: &ContactLoad) -> Option<Vec<Curve>> {
    scene.ground_stiffness()?;
    let given = spread(scene, forces);
    let spread = given.iter().filter(|f| 0.0 < f.width).map(|f| {
        let [from, to, pressure] = [f.x - 0.5 * f.width, f.x + 0.5 * f.width, -f.force / f.width];
        LinearLoad { from: from.max(0.0), to: to.min(enclosed.length), start: pressure, end: pressure }
    });
    let (load, beam) = (scene.load(), scene.beam());
    let linear = load.linear().iter().copied().chain(spread).collect();
    let couples = load.couple().to_vec();
    let load = Load::new(beam, load.uniform(), linear, load.point().to_vec())
        .and_then(|load| load.with_couples(beam, couples))
        .ok()?;
    let mut net = standing::between(&scene.under(load).ok()?);
    let concentrated = given.iter().filter(|f| f.width <= 0.0);
    net.points.extend(concentrated.map(|f| (f.x, Interval::exact(-f.force))));
    net.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut curves = bent(&EnclosedScene { load: &net, ..*enclosed }, &forces.pressing, &[])?;
    if !beam.is_held() {
        let about = beam.supports().first().map(|support| support.at);
        let [level, slope] = placed(enclosed, &curves, &given, about)?;
        for ([from, _], v) in &mut curves {
            let line = Interval::exact(level) + Interval::exact(slope) * Interval::exact(*from);
            *v = v.plus(&Polynomial::new(&[line, Interval::exact(slope)]));
        }
    }
    Some(curves)
}

/// `v` at a position.
pub(super) fn at(curves: &[Curve], x: f64) -> f64 {
    let i = curves.partition_point(|(part, _)| part[1] < x).min(curves.len() - 1);
    let ([from, _], v) = &curves[i];
    v.at(Interval::exact(x) - Interval::exact(*from)).middle()
}

/// `a` and `b`; with a given support position, `a = −b x_s`.
fn placed(enclosed: &EnclosedScene<'_>, curves: &[Curve], given: &[Spread], about: Option<f64>) -> Option<[f64; 2]> {
    let lacking = given.iter().filter(|f| 0.0 < f.spring).map(|f| {
        let sunk = f.force / f.spring;
        (f.x, enclosed.gap.depth(f.x).middle() + sunk - at(curves, f.x))
    });
    let lacking: Vec<(f64, f64)> = lacking.collect();
    #[expect(clippy::cast_precision_loss, reason = "a number of forces")]
    let count = lacking.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| lacking.iter().map(of).sum::<f64>() / count;
    let (x, level) = about.map_or_else(|| (mean(&|p| p.0), mean(&|p| p.1)), |about| (about, 0.0));
    let sums = lacking.iter().map(|p| [(p.0 - x) * (p.0 - x), (p.0 - x) * (p.1 - level)]);
    let [square, product] = sums.fold([0.0; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
    let slope = product / square;
    (level.is_finite() && slope.is_finite()).then_some([level - slope * x, slope])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::in_intervals;
    use crate::scene::{Balance, Beam, Foundation, PointLoad};

    /// A beam under its own weight on springs at one level sinks by `q/k` without bending. It does the same under the spring forces of
    /// any mesh with equal shares. Moved and rotated, it is placed at the depth that the springs imply.
    #[test]
    fn forces_say_where_a_beam_is() {
        const LENGTH: f64 = 8.0;
        let beam = Beam::new(LENGTH, 3.0).and_then(|beam| beam.with_supports(Vec::new())).expect("a beam");
        let load = Load::uniform_on(&beam, 2.0).expect("finite");
        let ground = Some(Foundation::Polynomial { coefficients: vec![0.25, 0.125] });
        let scene = Scene::above(beam, load, ground, Some(5.0)).expect("a scene");
        let forces = (0..16).map(|i| (0.25 + 0.5 * f64::from(i), 1.0));
        let forces = ContactLoad::new(LENGTH, forces).expect("forces");
        let curves = in_intervals(&scene, Balance::Held, |enclosed| deflection(&scene, enclosed, &forces));
        let curves = curves.expect("a position");
        for x in [0.0, 1.0, 3.3, 8.0] {
            let expected = 0.25 + 0.125 * x + 0.4;
            assert!((at(&curves, x) - expected).abs() <= 1e-13, "{} for {expected} at {x}", at(&curves, x));
        }
        // One force determines how deep the beam is, but not its rotation.
        let one = ContactLoad::new(LENGTH, [(4.0, 16.0), (5.0, 0.0)]).expect("a force");
        assert!(in_intervals(&scene, Balance::Held, |enclosed| deflection(&scene, enclosed, &one)).is_none());
    }

    /// Half the distance to the nearer neighbour, which may have zero force; concentrated at an end, and without a neighbour.
    #[test]
    fn forces_have_their_share_of_the_beam() {
        let beam = Beam::new(8.0, 3.0).expect("positive");
        let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 4.0, force: 1.0 }]).expect("finite");
        let scene = Scene::above(beam, load, Some(Foundation::Flat { depth: 0.0 }), Some(1.0)).expect("a scene");
        let widths = |forces: &[(f64, f64)]| -> Vec<f64> {
            let forces = ContactLoad::new(8.0, forces.iter().copied()).expect("forces");
            spread(&scene, &forces).iter().map(|f| f.width).collect()
        };
        assert_eq!(widths(&[(0.0, 1.0), (1.0, 1.0), (2.0, 0.0), (5.0, 2.0), (7.5, 1.0)]), [0.0, 1.0, 2.5, 1.0]);
        assert_eq!(widths(&[(3.0, 1.0)]), [0.0]);
    }
}
