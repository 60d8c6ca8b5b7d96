//! Slabs: a narrow one is a beam, a wide one lies on ground that has settled on one side and on a crest.

use palkki::body::proof::prove;
use palkki::body::{Body, Kind, State, Verdict};
use palkki::route::{Solver, Status};
use palkki::scene::Foundation;
use palkki::verdict::EXACT;
use palkki::{Settings, route::Method, solve};
use palkki_evidence::compare::largest;
use palkki_evidence::slab::Slab;

use crate::scenes::uniform;

/// Solves and proves.
fn solved(slab: &Slab, load: f64, gap: impl Fn(f64, f64) -> f64) -> (State, Verdict) {
    let nodes = slab.nodes();
    let gaps = nodes.iter().map(|[x, y, _]| gap(*x, *y)).collect();
    let loads = nodes.iter().map(|[_, _, area]| load * area).collect();
    let body = Body::new(Kind::Stiffness, slab.stiffness(), None, gaps, loads).expect("held");
    let answer = body.run(Solver::ActiveSet, 0.0);
    let proof = prove(&body, answer.x.iter().map(|x| 0.0 < *x)).expect("well conditioned");
    let state = body.state(&answer);
    let verdict = Verdict::new(Ok(proof.off(&state.clearance)), EXACT, answer.reports_success);
    (state, verdict)
}

/// A strip of width b without Poisson's effect is a beam of stiffness D b: beam elements are what its elements are along it. Loads on
/// the two edges alone, in place of all across, bend it across by a share of (b/l)².
#[test]
fn a_long_narrow_slab_is_a_beam() {
    let depth = |x: f64| 1.0 - 0.5 * (1.0 - (x - 4.0).abs()).max(0.0);
    let points = vec![[0.0, 1.0], [3.0, 1.0], [4.0, 0.5], [5.0, 1.0], [10.0, 1.0]];
    let stiffness = 1.302_083_333_333_333_3;
    let scene = uniform(10.0, stiffness, 1.0, Foundation::Polyline { points });
    let of_beam = solve(&scene, &Settings::new(Method::Displacement, Solver::ActiveSet, 40)).expect("in range");
    let nodes = of_beam.state.nodes.expect("a grid");
    let mut errors = Vec::new();
    for width in [0.8, 0.4, 0.2] {
        let slab = Slab { length: 10.0, width, stiffness: stiffness / width, poisson: 0.0, elements: [40, 1] };
        let (state, verdict) = solved(&slab, 1.0 / width, |x, _| depth(x));
        assert_eq!(verdict.status, Status::Certified, "{}", verdict.reason);
        let across = state.clearance.chunks(2).zip(&nodes.clearance);
        errors.push(largest(across.map(|(pair, h)| 0.5 * (pair[0] + pair[1]) - h)));
        let total: f64 = state.contact_force.iter().sum();
        let expected: f64 = nodes.contact_force.iter().sum();
        assert!((total - expected).abs() < 1e-3 * expected, "{width}: {total} and {expected}");
    }
    assert!(
        errors.windows(2).all(|pair| 4.0 * pair[1] < pair[0]),
        "half the width, a quarter of the error: {errors:?}"
    );
}

/// The ground has settled along y, and has a crest across: proven, and pressed where the ground is high.
#[test]
fn a_slab_on_settled_ground_with_a_crest_is_proven() {
    let slab = Slab { length: 10.0, width: 8.0, stiffness: 10.0, poisson: 0.2, elements: [21, 19] };
    let ground = |x: f64, y: f64| 0.3 + 0.05 * y - 0.2 * (1.0 - (x - 6.0).abs()).max(0.0);
    let (state, verdict) = solved(&slab, 1.0, ground);
    assert_eq!(state.clearance.len(), 400);
    assert_eq!(verdict.status, Status::Certified, "{}", verdict.reason);
    assert!(verdict.off.share < 1e-13, "{}", verdict.reason);
    // The settled half carries less.
    let halves = slab.nodes().iter().zip(&state.contact_force).fold([0.0, 0.0], |mut halves, ([_, y, _], force)| {
        halves[usize::from(4.0 < *y)] += force;
        halves
    });
    assert!(0.0 < halves[1] && halves[1] < halves[0], "{halves:?}");
    let pressed = state.contact_force.iter().filter(|force| 0.0 < **force).count();
    assert!(20 < pressed && pressed < 200, "{pressed} nodes touch");
}

/// A square slab that bends to a cylinder carries what a beam does: 5 q l⁴/384 D at mid-span without Poisson's effect.
#[test]
fn elements_bend_as_the_closed_form_says() {
    let slab = Slab { length: 10.0, width: 10.0, stiffness: 2.0, poisson: 0.0, elements: [12, 12] };
    let (state, _) = solved(&slab, 0.01, |_, _| 100.0);
    let middle = state.clearance[5 * 13 + 6];
    let expected = 100.0 - 5.0 * 0.01 * 1e4 / (384.0 * 2.0);
    assert!((middle - expected).abs() < 0.01 * (100.0 - expected), "{middle} and {expected}");
}
