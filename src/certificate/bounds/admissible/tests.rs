//! Lifted deflections against what makes a deflection admissible, everywhere and at the supports above all.

use super::*;
use crate::scene::{Beam, Foundation, Load, Scene};

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// Of a few dozen sums.
const ROUNDING: f64 = 1e-13;

fn polynomial(coefficients: &[f64]) -> Polynomial {
    let coefficients: Vec<Interval> = coefficients.iter().map(|c| Interval::exact(*c)).collect();
    Polynomial::new(&coefficients)
}

/// One polynomial from support to support.
fn curve(coefficients: &[f64]) -> Curve {
    Curve { pieces: vec![Piece { from: 0.0, to: LENGTH, v: polynomial(coefficients), follows: false }] }
}

fn load(uniform: f64) -> Pieces {
    let beam = Beam::new(LENGTH, STIFFNESS).expect("positive");
    let load = Load::uniform_on(&beam, uniform).expect("finite");
    Pieces::of(&Scene::new(beam, load, None).expect("well posed"))
}

/// Value and slope at a place, from the piece on one side of it.
fn jet(curve: &Curve, x: f64, from_the_left: bool) -> [Interval; 2] {
    let pieces = &curve.pieces;
    let k = if from_the_left { pieces.partition_point(|p| p.to < x) } else { pieces.partition_point(|p| p.to <= x) };
    let Piece { from, v, .. } = &pieces[k.min(pieces.len() - 1)];
    let s = Interval::exact(x) - Interval::exact(*from);
    [v.at(s), v.derivative().at(s)]
}

/// Lifts a deflection and looks at what comes of it: it is not in the ground, smooth, held at both ends, and its energy is its
/// own. Returned with how much it was lifted at most.
#[track_caller]
fn admissible(given: &Curve, foundation: &Foundation) -> (Curve, f64) {
    let (ground, load) = (Ground::on(foundation, LENGTH), load(3.0));
    let (lifted, energy) = lifted(given, Some(&ground), &load, STIFFNESS, LENGTH).expect("a lifted deflection");
    let own = lifted.energy(&load, STIFFNESS);
    assert!((own.middle() - energy.middle()).abs() <= ROUNDING * own.magnitude(), "{energy:?}, not {own:?}");
    let mut places: Vec<f64> = (1..5000).map(|k| LENGTH * f64::from(k) / 5000.0).collect();
    places.extend((1..50).map(|k| LENGTH * 0.5_f64.powi(k)));
    places.extend((1..50).map(|k| LENGTH - LENGTH * 0.5_f64.powi(k)));
    places.extend(lifted.pieces.iter().map(|p| p.from).filter(|x| 0.0 < *x));
    let mut most = 0.0_f64;
    for x in places {
        let [[v, slope], [w, turn]] = [true, false].map(|left| jet(&lifted, x, left));
        // Near a support the depth is small and known to as many digits.
        let near = x.min(LENGTH - x).min(1.0);
        let size = 1.0 + slope.magnitude();
        assert!((v.middle() - w.middle()).abs() <= ROUNDING * size, "a jump at {x}: {v:?}, {w:?}");
        assert!((slope.middle() - turn.middle()).abs() <= ROUNDING * size, "a kink at {x}: {slope:?}, {turn:?}");
        let depth = ground.depth(x).lo();
        assert!(v.middle() - depth <= ROUNDING * near * size, "in the ground at {x}: {v:?} below {depth}");
        most = most.max(jet(given, x, false)[0].middle() - v.middle());
    }
    for x in [0.0, LENGTH] {
        let [v, slope] = jet(&lifted, x, true);
        assert!(v.contains(0.0) && v.magnitude() <= ROUNDING * (1.0 + slope.magnitude()), "held at {x}: {v:?}");
    }
    (lifted, most)
}

/// `c x (l − x)` as coefficients.
fn parabola(c: f64) -> Vec<f64> {
    vec![0.0, c * LENGTH, -c]
}

/// Deep in flat ground in the middle, beside one support only, and above a ridge.
#[test]
fn deflections_are_lifted_out_of_the_ground() {
    /// A parabola on top of steps, each as high as the deepest penetration in a part.
    const LOOSE: f64 = 2.1;
    for depth in [0.01, 0.2, 0.9] {
        let (_, most) = admissible(&curve(&parabola(0.01)), &Foundation::Flat { depth });
        assert!(((1.0 - depth)..=LOOSE * (1.0 - depth)).contains(&most), "{most} at {depth}");
    }
    // 0.001 x (l − x)², at most 1.185 at x = l/3.
    let left = [0.0, 0.001 * LENGTH * LENGTH, -0.002 * LENGTH, 0.001];
    let right = [0.0, 0.0, 0.001 * LENGTH, -0.001];
    for beside in [left, right] {
        let (_, most) = admissible(&curve(&beside), &Foundation::Flat { depth: 0.5 });
        assert!((0.68..=0.7 * LOOSE).contains(&most), "{most}");
    }
    let ridge = vec![[0.0, 2.0], [6.0, 2.0], [7.0, 0.3], [8.0, 2.0], [LENGTH, 2.0]];
    let (_, most) = admissible(&curve(&parabola(0.01)), &Foundation::Polyline { points: ridge });
    assert!((0.6..=0.7 * LOOSE).contains(&most), "{most}");
}

/// Beside supports that the ground is level with, a deflection that is steeper than the ground: below one of them, below
/// both, and where the ground begins level.
#[test]
fn deflections_are_lifted_at_level_supports() {
    for (ground, given) in [
        (parabola(0.01), parabola(0.02)),
        (parabola(0.01), vec![0.0, 0.002 * LENGTH * LENGTH, -0.004 * LENGTH, 0.002]),
        (parabola(0.01), vec![0.0, 0.0, 0.002 * LENGTH, -0.002]),
        (vec![0.0, 0.1], parabola(0.02)),
        (vec![0.1 * LENGTH, -0.1], parabola(0.02)),
        (vec![0.0, 0.0, 0.01], parabola(0.002)),
    ] {
        admissible(&curve(&given), &Foundation::Polynomial { coefficients: ground });
    }
    admissible(&curve(&parabola(0.02)), &Foundation::Flat { depth: 0.0 });
    let polyline = Foundation::Polyline { points: vec![[0.0, 0.0], [8.0, 0.5], [LENGTH, 0.0]] };
    admissible(&curve(&parabola(0.02)), &polyline);
}

/// What is clear stays as it is, and so does what is the ground itself; without a foundation everything is clear.
#[test]
fn what_is_clear_is_not_lifted() {
    let (load, flat) = (load(3.0), Foundation::Flat { depth: 1.1 });
    let given = curve(&parabola(0.01));
    let mut lying = given.clone();
    lying.pieces[0].follows = true;
    let ground = Ground::on(&flat, LENGTH);
    for (given, ground) in [(&given, None), (&given, Some(&ground)), (&lying, Some(&Ground::on(&FLAT, LENGTH)))] {
        let (same, energy) = lifted(given, ground, &load, STIFFNESS, LENGTH).expect("as it is");
        assert_eq!(same.pieces.len(), 1, "one piece");
        assert_eq!(same.pieces[0].v.coefficients(), given.pieces[0].v.coefficients());
        assert_eq!(energy, given.energy(&load, STIFFNESS));
    }
}

const FLAT: Foundation = Foundation::Flat { depth: 0.5 };

/// Ground that is hardly below a support, and not level with it, leaves no room beside it either. At the right support there
/// was once no lift in the last of all parts, where the clearance of the support was divided by.
#[test]
fn deflections_are_lifted_beside_ground_that_is_hardly_below_a_support() {
    for points in [[[0.0, 1e-300], [LENGTH, 1.0]], [[0.0, 1.0], [LENGTH, 1e-300]]] {
        admissible(&curve(&parabola(0.1)), &Foundation::Polyline { points: points.to_vec() });
    }
}

/// In the ground only between a support and the next place that is looked at, by `c s (ε − s)`: the slope of the lift at the
/// support is the one that is missing, `c ε`, and as much more as it takes to have it at the end of that part as well.
#[test]
fn the_last_part_before_a_support_is_lifted_too() {
    /// `1/(1 − ε/l)`, and what is left of `c ε` in numbers near `l`.
    const LEVER: [f64; 2] = [1.5e-12, 1e-2];
    let c = 0.01;
    let tiny = LENGTH * 0.5_f64.powi(TOWARDS_A_SUPPORT - 1);
    let steep = c * tiny;
    // `a s − c s²` about the left support, and its mirror image.
    let beam = |a: f64, c: f64| [vec![0.0, a, -c], vec![(a - c * LENGTH) * LENGTH, 2.0 * c * LENGTH - a, -c]];
    // Ground c s² below a straight beam; and a line below a beam of the curvature −2c, with a support that is hardly above it.
    let arc = [vec![0.0, 0.0, c], vec![c * LENGTH * LENGTH, -2.0 * c * LENGTH, c]];
    let arc = arc.map(|coefficients| Foundation::Polynomial { coefficients });
    let line = [[[0.0, 1e-300], [LENGTH, 1.25]], [[0.0, 1.25], [LENGTH, 1e-300]]];
    let line = line.map(|points| Foundation::Polyline { points: points.to_vec() });
    for (grounds, beams) in [(arc, beam(steep, 0.0)), (line, beam(0.0625 + steep, c))] {
        for (k, (ground, given)) in grounds.iter().zip(beams).enumerate() {
            let depths = penetrations(&curve(&given), &Ground::on(ground, LENGTH), LENGTH);
            let ([from, to], depth, per) = depths[k * (depths.len() - 1)];
            assert!(from.min(LENGTH - to) <= 0.0 && to - from <= tiny * (1.0 + LEVER[1]), "{from} … {to}");
            let more = per / (steep / LENGTH) - 1.0;
            assert!(0.0 < depth && (LEVER[0]..=LEVER[1]).contains(&more), "{more:e} for {depth:e} in {from} … {to}");
        }
    }
}
