//! Random beams on random supports, beside the definition of the problem.

use palkki::theory::{TheoryError, solve};
use palkki_evidence::definition::violated;
use palkki_evidence::random::held;

use super::OFF;

/// As in a series of 2000.
const COUNT: u64 = 800;

#[test]
fn random_beams_meet_the_definition() {
    let (mut certified, mut refused) = (0, 0);
    let mut open = Vec::new();
    for i in 0..COUNT {
        let scene = held(i);
        match solve(&scene) {
            Ok(exact) if exact.solved => {
                certified += 1;
                let wrong = violated(&scene, &exact, OFF);
                assert!(wrong.is_empty(), "{i}: {wrong:#?}\n{scene:#?}\n{:#?}", exact.state);
            }
            Ok(exact) => open.push((i, exact.violations)),
            Err(TheoryError::Scene(_)) => refused += 1,
            Err(error) => panic!("{i}: {error}"),
        }
    }
    assert!(10 * refused < COUNT, "{refused} are not held");
    assert!(COUNT <= certified + refused + 10, "{certified} certified, open: {open:#?}");
}
