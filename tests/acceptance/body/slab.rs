//! Slabs on ground that has settled on one side and on a crest; that a narrow one is a beam is evidence for a claim of the paper.

use std::fs;
use std::path::Path;

use palkki::body::Verdict;
use palkki::body::proof::prove;
use palkki::route::{Solver, Status};
use palkki::verdict::EXACT;
use palkki_evidence::numdiff::numdiff;
use palkki_evidence::slab::{Slab, files};

/// Clearances and contact forces, proven.
fn solved(slab: &Slab, load: f64, gap: impl Fn(f64, f64) -> f64) -> ([Vec<f64>; 2], Verdict) {
    let body = slab.above(load, gap);
    let answer = body.run(Solver::ActiveSet, 0.0);
    let proof = prove(&body, answer.x.iter().map(|x| 0.0 < *x)).expect("well conditioned");
    let state = body.clearance_and_force(&answer);
    let verdict = Verdict::new(Ok(proof.errors(&body, &answer)), EXACT, answer.run.reports_success);
    (state, verdict)
}

/// The ground has settled along y, and has a crest across: proven, and pressed where the ground is high.
#[test]
fn a_slab_on_settled_ground_with_a_crest_is_proven() {
    let slab = Slab { length: 10.0, width: 8.0, stiffness: 10.0, poisson: 0.2, elements: [21, 19] };
    let ground = |x: f64, y: f64| 0.3 + 0.05 * y - 0.2 * (1.0 - (x - 6.0).abs()).max(0.0);
    let ([clearance, contact_force], verdict) = solved(&slab, 1.0, ground);
    assert_eq!(clearance.len(), 400);
    assert_eq!(verdict.status, Status::Certified, "{}", verdict.reason);
    assert!(verdict.errors.clearance.share < 1e-13, "{}", verdict.reason);
    // The settled half carries less.
    let halves = slab.nodes().iter().zip(&contact_force).fold([0.0, 0.0], |mut halves, ([_, y, _], force)| {
        halves[usize::from(4.0 < *y)] += force;
        halves
    });
    assert!(0.0 < halves[1] && halves[1] < halves[0], "{halves:?}");
    let pressed = contact_force.iter().filter(|force| 0.0 < **force).count();
    assert!(20 < pressed && pressed < 200, "{pressed} nodes touch");
}

/// A square slab that bends to a cylinder carries what a beam does: 5 q l⁴/384 D at mid-span without Poisson's effect.
#[test]
fn elements_bend_as_the_closed_form_says() {
    let slab = Slab { length: 10.0, width: 10.0, stiffness: 2.0, poisson: 0.0, elements: [12, 12] };
    let ([clearance, _], _) = solved(&slab, 0.01, |_, _| 100.0);
    let middle = clearance[5 * 13 + 6];
    let expected = 100.0 - 5.0 * 0.01 * 1e4 / (384.0 * 2.0);
    assert!((middle - expected).abs() < 0.01 * (100.0 - expected), "{middle} and {expected}");
}

/// `INSTA_UPDATE=always` writes them, as it does snapshots.
#[test]
fn the_instances_are_what_the_program_makes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("report/scenes/bodies");
    for (name, text) in files() {
        let path = folder.join(&name);
        if std::env::var("INSTA_UPDATE").is_ok_and(|how| how == "always") {
            fs::write(&path, &text).expect("the folder of the instances can be written");
        }
        let found = fs::read_to_string(&path).unwrap_or_default();
        if let Err(difference) = numdiff(&found, &text) {
            panic!("report/scenes/bodies/{name} is not what the program makes: {difference}");
        }
    }
}
