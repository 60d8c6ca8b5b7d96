//! A scene on a grid as the authority sees it: loads by the law of the lever, depths from the profile, nothing rounded to 64
//! bits.

use palkki::scene::{Foundation, Scene};
use palkki::state::Discretisation;

use super::RBig;
use super::clapeyron::Problem;
use super::number::{Fixed, Number};

/// Beam and load of the paper's example in fractions, over depths `u(i/N)`: l = 10, EI = 500/384, q₀ = 1.
pub fn example_over(intervals: i64, discretisation: Discretisation, depth: impl Fn(&RBig) -> RBig) -> Problem<RBig> {
    let spacing = RBig::fraction(10, intervals);
    let half = spacing.over(&RBig::whole(2));
    let is_end = |i: i64| i == 0 || i == intervals;
    let at = |i| if is_end(i) { RBig::zero() } else { depth(&RBig::fraction(i, intervals)) };
    Problem {
        discretisation,
        stiffness: RBig::fraction(500, 384),
        loads: (0..=intervals).map(|i| if is_end(i) { half.clone() } else { spacing.clone() }).collect(),
        depths: (0..=intervals).map(at).collect(),
        spacing,
    }
}

/// `scene` on `intervals`; none without a foundation, and none for a polyline with a step.
pub fn problem(scene: &Scene, intervals: usize, discretisation: Discretisation) -> Option<Problem<Fixed>> {
    let steps = i64::try_from(intervals).ok()?;
    let length = Fixed::of(scene.beam().length());
    let spacing = length.over(&Fixed::whole(steps));
    let place = |i: i64| length.times(&Fixed::whole(i)).over(&Fixed::whole(steps));
    let depth = depths(scene.foundation()?)?;
    let at = |i: i64| if i == 0 || i == steps { Fixed::zero() } else { depth(&place(i)) };
    Some(Problem {
        discretisation,
        stiffness: Fixed::of(scene.beam().bending_stiffness()),
        loads: loads(scene, intervals, &spacing),
        depths: (0..=steps).map(at).collect(),
        spacing,
    })
}

/// `u(x)`.
type Profile = Box<dyn Fn(&Fixed) -> Fixed>;

fn depths(foundation: &Foundation) -> Option<Profile> {
    Some(match foundation {
        Foundation::Flat { depth } => {
            let depth = Fixed::of(*depth);
            Box::new(move |_| depth.clone())
        }
        Foundation::Polynomial { coefficients } => {
            let coefficients: Vec<Fixed> = coefficients.iter().map(|c| Fixed::of(*c)).collect();
            Box::new(move |x| coefficients.iter().rev().fold(Fixed::zero(), |sum, c| sum.times(x).plus(c)))
        }
        Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            let [mean, amplitude, wavelength, phase] = [mean, amplitude, wavelength, phase].map(|v| Fixed::of(*v));
            let turn = Fixed::pi().plus(&Fixed::pi());
            Box::new(move |x| {
                let angle = turn.times(&x.over(&wavelength)).plus(&phase);
                mean.plus(&amplitude.times(&angle.cosine()))
            })
        }
        Foundation::Polyline { points } => {
            if points.windows(2).any(|pair| pair[0][0] >= pair[1][0]) {
                return None;
            }
            let points: Vec<[Fixed; 2]> = points.iter().map(|p| p.map(Fixed::of)).collect();
            Box::new(move |x| {
                let behind = points.partition_point(|p| p[0] < *x).clamp(1, points.len() - 1);
                let ([a, u], [b, w]) = (&points[behind - 1], &points[behind]);
                u.plus(&w.minus(u).times(&x.minus(a)).over(&b.minus(a)))
            })
        }
    })
}

/// Loads as forces on all nodes: each part between two nodes goes to these by the law of the lever.
fn loads(scene: &Scene, intervals: usize, spacing: &Fixed) -> Vec<Fixed> {
    let mut forces = vec![Fixed::zero(); intervals + 1];
    // A force and its moment about the left node of interval `i`.
    let mut put = |i: usize, force: &Fixed, moment: &Fixed| {
        let to_right = moment.over(spacing);
        forces[i] = forces[i].plus(&force.minus(&to_right));
        forces[i + 1] = forces[i + 1].plus(&to_right);
    };
    let node = |i: usize| spacing.times(&Fixed::whole(i64::try_from(i).unwrap_or(i64::MAX)));
    let uniform = Fixed::of(scene.load().uniform()).times(spacing);
    let half = Fixed::fraction(1, 2);
    for i in 0..intervals {
        put(i, &uniform, &uniform.times(spacing).times(&half));
    }
    for part in scene.load().linear() {
        let [from, to, start, end] = [part.from, part.to, part.start, part.end].map(Fixed::of);
        let growth = end.minus(&start).over(&to.minus(&from));
        for i in 0..intervals {
            let (left, right) = (node(i), node(i + 1));
            let (a, b) = (from.clone().max(left.clone()), to.clone().min(right));
            if a < b {
                let [at_a, at_b] = [&a, &b].map(|x| start.plus(&growth.times(&x.minus(&from))));
                let width = b.minus(&a);
                let force = at_a.plus(&at_b).times(&half).times(&width);
                // First moment about `a` of a trapezoid: (start + 2 end) w²/6.
                let own = at_a.plus(&at_b).plus(&at_b).times(&width).times(&width).over(&Fixed::whole(6));
                put(i, &force, &own.plus(&force.times(&a.minus(&left))));
            }
        }
    }
    for part in scene.load().point() {
        let (at, force) = (Fixed::of(part.at), Fixed::of(part.force));
        let i = (0..intervals - 1).find(|&i| at < node(i + 1)).unwrap_or(intervals - 1);
        put(i, &force, &force.times(&at.minus(&node(i))));
    }
    forces
}
