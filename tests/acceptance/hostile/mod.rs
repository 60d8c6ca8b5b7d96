//! Hostile input: what random and adversarial scenes, files and streams do to the program.

mod corpus;
mod draft;
mod mutate;
mod random;
mod scenes;
mod tally;
mod trial;

use tally::Tally;

/// Runs of the whole program in the suite; `cargo xtask hostile` makes more, with other seeds.
const RUNS: u64 = 200;

#[test]
fn random_scenes_get_right_answers_or_none() {
    let mut tally = Tally::default();
    for seed in 0..RUNS {
        let mut one = Tally::default();
        one.run(seed);
        tally.join(one);
    }
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    // Without answers there would be nothing to be right about.
    let certified: usize = tally.families.values().map(|count| count.exact[0]).sum();
    assert!(RUNS < 2 * certified as u64, "{certified} of {RUNS} scenes have a certified answer: {tally:#?}");
}
