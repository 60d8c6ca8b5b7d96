//! Bodies of thousands of freedoms, a tenth of which just touches.

use palkki::body::proof::{Brought, Off, Proof, prove};
use palkki::body::{Body, BodyProblem, Kind, Verdict};
use palkki::qp::{Profile, Qp as _};
use palkki::route::{Solver, Status};
use palkki::solvers::Answer;
use palkki::verdict::EXACT;
use palkki_evidence::bodies::{Known, five_diagonal};
use palkki_evidence::compare::apart;
use palkki_evidence::random::{Random, sample_of};

fn solved(body: &Body) -> (Answer, Proof) {
    let answer = body.run(Solver::ActiveSet, 0.0);
    let proof = prove(body, answer.x.iter().map(|x| 0.0 < *x)).expect("well within the digits");
    (answer, proof)
}

/// What is promised at n = 5000.
const PROVEN: f64 = 1e-13;

#[test]
fn five_thousand_freedoms_are_solved_and_proven() {
    for n in [10, 100, 1000, 5000] {
        let Known { body, clearance, contact_force } = five_diagonal(n);
        let (answer, proof) = solved(&body);
        // Interior points find the face; without them it takes 1574 solves at n = 5000.
        assert!(answer.run.reports_success && answer.run.iterations <= 3, "{n}: {} solves", answer.run.iterations);
        assert!(proof.error <= PROVEN, "{n}: {:.1e}", proof.error);
        let Off { least, most, .. } = proof.off(&clearance);
        assert!(least == 0.0 && most <= 2.0 * PROVEN, "{n}: the answer is the optimum, {least:.1e} {most:.1e}");
        assert!(proof.force_off(&contact_force).least == 0.0, "{n}: and so are its forces");
        let verdict = Verdict::new(Ok(proof.errors(&body, &answer)), EXACT, true);
        assert_eq!(verdict.status, Status::Certified, "{n}: {}", verdict.reason);
        // J = ½ hᵀ K h + qᵀ h, as all gaps are zero: K is −1, 3, −3, 1 about the step, and 1, −3 at the end.
        assert!(proof.energy[0] <= -2.0 && -2.0 <= proof.energy[1], "{n}: {:?}", proof.energy);
        assert!(proof.energy[1] - proof.energy[0] <= 1e-9, "{n}: {:?}", proof.energy);
    }
}

/// Five diagonals and a spring at each freedom, which gives the condition, under random loads that lift it far off the ground: first
/// steps that began near it took 850 solves at 10,000 freedoms and a condition of 1e8.
#[test]
fn narrow_bands_are_solved_at_once_and_proven() {
    for (n, condition) in
        [(100, 1e4), (1000, 1e8), (10_000, 1e2), (10_000, 1e8), (10_000, 1e12), (sample_of(100_000), 1e10)]
    {
        let spring = 16.0 / (condition - 1.0);
        let rows = (0..n).flat_map(|i: usize| (0..3.min(i + 1)).map(move |k| (i, i - k, [6.0 + spring, -4.0, 1.0][k])));
        let mut random = Random::new(7);
        let mut each = |from: f64, to: f64| (0..n).map(|_| random.between(from, to)).collect::<Vec<_>>();
        let (gap, load) = (each(0.0, 2.0), each(-1.0, 1.0));
        let body =
            Body::new(Kind::Stiffness, Profile::of_entries(n, rows), None, gap, load).expect("positive definite");
        let (answer, proof) = solved(&body);
        let solves = answer.run.iterations;
        assert!(answer.run.reports_success && solves <= 3, "{n}, {condition:e}: {solves} solves");
        assert!(
            proof.error <= PROVEN * proof.sizes.clearance,
            "{n}, {condition:e}: {:.1e} of {:?}",
            proof.error,
            proof.sizes
        );
    }
}

/// Where the least eigenvalue is below the rounding of its proof nothing is certified, whatever the answer is.
#[test]
fn what_cannot_be_proven_is_said() {
    let Known { body, .. } = five_diagonal(20_000);
    let answer = body.run(Solver::ActiveSet, 0.0);
    let unproven = prove(&body, answer.x.iter().map(|x| 0.0 < *x)).expect_err("λ_min is about 3e-15");
    let verdict = Verdict::new(Err(unproven), EXACT, true);
    assert_eq!(verdict.status, Status::NotCertified);
    assert!(verdict.reason.starts_with("nothing could be proven: the least eigenvalue"), "{}", verdict.reason);
}

/// A hundred answers that are off by a thousandth and more: each is refused, and how far it is off is known to all digits that are
/// asked. Most of them have next to no residual: the matrix hardly resists what is wrong with them.
#[test]
fn wrong_answers_are_refused() {
    let Known { body, clearance, .. } = five_diagonal(5000);
    let (_, proof) = solved(&body);
    let mut random = Random::new(30);
    for k in 0..100 {
        let mut wrong = clearance.clone();
        let amount = random.between(1e-3, 1.0);
        let [from, to] = [random.below(2500), 2500 + random.below(2500)];
        #[expect(clippy::cast_precision_loss, reason = "5000 freedoms")]
        for (i, h) in wrong.iter_mut().enumerate() {
            let wave = (std::f64::consts::PI * i as f64 / 5000.0).sin();
            *h += match k % 5 {
                0 => amount * wave * wave,
                1 if i == from => amount,
                2 if i == to => -amount,
                3 if from <= i && i < to => amount,
                4 => amount * *h,
                _ => 0.0,
            };
        }
        let off = apart(&wrong, &clearance);
        let (_, errors) = proof.judge(&body, &Brought::Clearance(wrong.clone())).expect("definite");
        let found = errors.clearance;
        assert!(
            found.least <= off && off <= found.most && found.most - found.least <= 1e-12,
            "{k}: {off} in {found:?}"
        );
        let verdict = Verdict::new(Ok(errors), EXACT, true);
        assert_eq!(verdict.status, Status::NotCertified, "{k}: {}", verdict.reason);
    }
}

/// What the libraries make of it, for whom all residuals are small.
#[test]
#[cfg(feature = "clarabel")]
fn an_answer_of_a_library_that_is_off_is_refused() {
    let Known { body, clearance, .. } = five_diagonal(5000);
    let (_, proof) = solved(&body);
    let answer = body.run(Solver::Clarabel, 1e-10);
    let off = apart(&answer.x, &clearance);
    let found = proof.off(&answer.x);
    let residual = palkki::qp::residual(body.program().sizes(), &answer.x, &answer.gradient);
    assert!(residual < 1e-11 && 1e-3 < off, "residual {residual:.1e}, off by {off:.1e}");
    assert!(found.least <= off && off <= found.most, "{off} in {found:?}");
    assert_eq!(Verdict::new(Ok(proof.errors(&body, &answer)), EXACT, true).status, Status::NotCertified);
}

/// Two springs in a row above ground that gives as well, each by one under a unit force: the closed form of a pair.
#[test]
fn an_elastic_foundation_adds_its_flexibility() {
    let diagonal = |c: f64| Profile::of_entries(2, [(0, 0, c), (1, 1, c)].into_iter());
    let (body, ground) = (diagonal(3.0), diagonal(1.0));
    // Free, the first would move by 12, which is 8 more than its gap: 8 = (3 + 1) p.
    let body = Body::new(Kind::Flexibility, body, Some(&ground), vec![4.0, 4.0], vec![4.0, 1.0]).expect("definite");
    let (answer, proof) = solved(&body);
    assert_eq!(body.clearance_and_force(&answer), [[0.0, 1.0], [2.0, 0.0]]);
    // ½ · 6²/3 + ½ · 2² · 1 − 4 · 6, and ½ · 3²/3 − 3.
    let energy = 6.0 + 2.0 - 24.0 + 1.5 - 3.0;
    assert!((body.energy(&answer) - energy).abs() < 1e-12 && proof.energy[0] <= energy && energy <= proof.energy[1]);
    assert!(proof.energy[1] - proof.energy[0] < 1e-12, "{:?}", proof.energy);
}

#[test]
fn sizes_that_differ_are_an_error() {
    let one = Profile::of_entries(1, [(0, 0, 1.0)].into_iter());
    let body = |foundation, gaps, loads| Body::new(Kind::Flexibility, one.clone(), foundation, gaps, loads);
    let two = Profile::of_entries(2, [(0, 0, 1.0), (1, 1, 1.0)].into_iter());
    for (body, of, rows) in [
        (body(Some(&two), vec![0.0], vec![1.0]), "matrix of the foundation", 2),
        (body(None, vec![0.0; 3], vec![1.0]), "list of gaps", 3),
        (body(None, vec![0.0], vec![]), "list of loads", 0),
    ] {
        assert!(
            matches!(body, Err(BodyProblem::Sizes { what, body: 1, found }) if what == of && found == rows),
            "{of}: {body:?}"
        );
    }
}
