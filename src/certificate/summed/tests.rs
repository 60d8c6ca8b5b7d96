//! Moments and deflections beside the closed form of a beam, on both kinds of grids.

use super::*;

const LENGTH: f64 = 8.0;
const STIFFNESS: f64 = 3.0;

/// Forces at the nodes of a beam that is built in at its left end at a slope of 0.1, with a force 2 at its free end: the support exerts 2
/// upwards and a couple of −16.
fn cantilever(intervals: usize, discretisation: Discretisation) -> (Summed, f64) {
    #[expect(clippy::cast_precision_loss, reason = "a short grid")]
    let step = LENGTH / intervals as f64;
    let mut forces = vec![0.0; intervals + 1];
    (forces[0], forces[intervals]) = (-2.0, 2.0);
    let couples = vec![Change { node: 0, couple: Some(-2.0 * LENGTH), ..Change::default() }];
    (Summed::of(forces, couples, step, STIFFNESS, discretisation), step)
}

/// `v = 0.1 x + P x² (3 l − x) / 6 EI` with `P = 2`.
fn deflection(x: f64) -> f64 {
    0.1 * x + 2.0 * x * x * (3.0 * LENGTH - x) / (6.0 * STIFFNESS)
}

/// Moments and deflections of all nodes, from the slope of the tangent at the left end.
fn walked(summed: &Summed, step: f64) -> Vec<[f64; 2]> {
    let free = summed.walk(0.0, 0.0, &[], |_| ());
    let mut all = Vec::new();
    let tangents = summed.walk(0.0, 0.1 - free[0], &[], |walked| {
        assert_eq!(walked.first, all.len(), "from node to node");
        let jump = walked.jump;
        all.extend(walked.moments.iter().zip(walked.deflections).map(|(m, v)| [(m + jump) * step, *v]));
    });
    assert!((tangents[0] - 0.1).abs() < 1e-12, "{tangents:?}");
    all
}

/// On grids with less nodes than a batch, as many, and more.
#[test]
fn an_exact_beam_is_found() {
    for intervals in [2, 30, BATCH, BATCH + 1, 3 * BATCH] {
        let (summed, step) = cantilever(intervals, Discretisation::BeamElements);
        assert!(summed.left_over.iter().all(|rest| rest.abs() < 1e-12), "{:?}", summed.left_over);
        let nodes = walked(&summed, step);
        assert_eq!(nodes.len(), intervals + 1);
        for (x, [moment, v]) in (0_u32..).map(|i| f64::from(i) * step).zip(nodes) {
            assert!((moment + 2.0 * (LENGTH - x)).abs() < 1e-11, "a moment of {moment} at {x}");
            assert!((v - deflection(x)).abs() < 1e-10, "{v} at {x} of {intervals}");
        }
    }
}

/// They come to it with the square of the interval.
#[test]
fn finite_differences_come_to_the_exact_beam() {
    let off = |intervals| {
        let (summed, step) = cantilever(intervals, Discretisation::FiniteDifferences);
        (walked(&summed, step)[intervals][1] - deflection(LENGTH)).abs()
    };
    let (coarse, fine) = (off(16), off(32));
    assert!(1e-3 < coarse && (fine / coarse - 0.25).abs() < 0.01, "{coarse} and {fine}");
}

/// What the forces leave behind the right end, and a couple inside.
#[test]
fn what_is_not_in_equilibrium_is_left_over() {
    let couples = || vec![Change { node: 3, couple: Some(0.5), ..Change::default() }];
    let of = |forces: Vec<f64>, couples| Summed::of(forces, couples, 2.0, STIFFNESS, Discretisation::BeamElements);
    let bits = |left_over: [f64; 2]| left_over.map(f64::to_bits);
    assert_eq!(bits(of(vec![0.0, -1.0, 0.0, 0.0, 1.0], vec![]).left_over), bits([0.0, 6.0]), "a pair of forces");
    assert_eq!(bits(of(vec![0.0, -1.0, 0.0, 0.0, 0.5], couples()).left_over), bits([0.5, 6.5]), "and a couple");
    let mut seen = Vec::new();
    let tangents = of(vec![-1.0, 0.0, 0.0, 0.0, 1.0], couples()).walk(0.0, 0.0, &[], |walked| {
        seen.extend(walked.moments.iter().map(|m| [2.0 * m, 2.0 * (m + walked.jump)]));
    });
    assert_eq!(seen, [[0.0, 0.0], [2.0, 2.0], [4.0, 4.0], [6.0, 6.5], [8.5, 8.5]]);
    // φ = φ_0 − x²/2EI, where v(2) = 2 φ_0 − 8/6EI is zero as the slope in the first interval is.
    assert!((tangents[0] - (4.0 / 6.0 - 18.0) / STIFFNESS).abs() < 1e-12, "{tangents:?}");
}

/// A cantilever of two halves, of `EI` and of `2 EI`, with a joint of 5 between them: each turns the tip by its own part, the
/// joint by `P (l/2)²/k`.
#[test]
fn a_beam_that_changes_is_found() {
    let (half, force) = (0.5 * LENGTH, 2.0);
    let by_parts = |stiff: f64, soft: f64| force * half * half * half * (7.0 / stiff + 1.0 / soft) / 3.0;
    for intervals in [2, 30, 2 * BATCH + 2] {
        let step = LENGTH / f64::from(u32::try_from(intervals).expect("few"));
        let mut forces = vec![0.0; intervals + 1];
        (forces[0], forces[intervals]) = (-force, force);
        let wall = Change { node: 0, couple: Some(-force * LENGTH), soft: Some(0.5), joint: 0.0 };
        let joint = Change { node: intervals / 2, soft: Some(1.0), joint: 1.0 / 5.0, ..Change::default() };
        let summed = Summed::of(forces, vec![wall, joint], step, STIFFNESS, Discretisation::BeamElements);
        let tip = walked(&summed, step)[intervals][1] - 0.1 * LENGTH;
        let expected = by_parts(2.0 * STIFFNESS, STIFFNESS) + force * half * half / 5.0;
        assert!((tip - expected).abs() < 1e-10 * expected, "{tip}, not {expected}, of {intervals}");
    }
}
