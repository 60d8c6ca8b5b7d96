//! Random bodies of whole numbers, conditioned up to 1e14, by every solver: bounds on errors that are known exactly.

use palkki::body::Verdict;
use palkki::body::proof::{Brought, Off, prove};
use palkki::route::{Solver, Status};
use palkki::verdict::EXACT;
use palkki_evidence::bodies::{Known, whole};
use palkki_evidence::random::Random;

/// The iterative solvers take seconds for each body that they do not solve.
const BODIES: [(usize, &[Solver]); 2] = [(300, &[Solver::ActiveSet, Solver::FourStep]), (12, &Solver::ALL)];

/// Errors below this share are rounding of the answers themselves.
const TOLD: f64 = 1e-13;

#[test]
fn no_bound_is_untrue() {
    let mut random = Random::new(14);
    for (count, solvers) in BODIES {
        let (mut ratios, mut unproven, mut bodies) = (Vec::new(), 0, 0);
        while bodies < count {
            let Some(Known { body, clearance, contact_force }) = whole(&mut random, 23) else { continue };
            bodies += 1;
            let own = body.run(Solver::ActiveSet, 0.0);
            let Ok(proof) = prove(&body, own.x.iter().map(|x| 0.0 < *x)) else {
                unproven += 1;
                continue;
            };
            for known in [Brought::Clearance(clearance.clone()), Brought::Force(contact_force.clone())] {
                let (_, Off { least, .. }) = proof.judge(&body, &known).expect("definite");
                assert!(least == 0.0, "the true answer is off by {least:e}");
            }
            assert!(proof.force_off(&contact_force)[0] == 0.0, "the true forces");
            for solver in solvers {
                let answer = body.run(*solver, 1e-10);
                // A library that refuses has no answer.
                if answer.x.iter().any(|x| x.is_nan()) {
                    assert!(!answer.reports_success, "{solver}");
                    continue;
                }
                let state = body.state(&answer);
                let found = proof.off(&state.clearance);
                let Off { least, most, .. } = found;
                let off = state.clearance.iter().zip(&clearance).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(least <= off && off <= most, "{solver}: {off:e} not in {least:e} … {most:e}");
                let verdict = Verdict::new(Ok(found), EXACT, answer.reports_success);
                assert!(
                    off <= 1e-3 * proof.size || verdict.status != Status::Certified,
                    "{solver}: {off:e} is certified"
                );
                ratios.extend((TOLD < off).then(|| most / off));
            }
        }
        ratios.sort_by(f64::total_cmp);
        let median = ratios.get(ratios.len() / 2).copied().unwrap_or(1.0);
        assert!(median <= 1.1, "bound over true error: {median} in the median of {}", ratios.len());
        assert!(10 * unproven <= 3 * count, "nothing proven of {unproven} of {count}");
    }
}
