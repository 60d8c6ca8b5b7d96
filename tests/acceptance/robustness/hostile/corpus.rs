//! What the fuzzer found, replayed, and a fixed number of changes to it. No tools are needed for this; `cargo xtask fuzz` runs
//! the fuzzer itself, on the same properties.

use std::fs;
use std::path::Path;

use palkki_evidence::random::Random;
use palkki_evidence::texts;

use super::mutate::mutated;

/// Changed texts for each kind of file.
const CHANGES: u64 = 12_000;

/// The texts of `tests/corpus/<kind>` in the order of their names.
fn corpus(kind: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus").join(kind);
    let entries = fs::read_dir(&folder).expect("a folder of the corpus").map(|entry| entry.expect("an entry").path());
    let mut files: Vec<_> = entries.collect();
    files.sort();
    files.iter().map(|file| fs::read(file).expect("a file of the corpus")).collect()
}

/// Replays a corpus and changes of it; both must hold good texts and bad ones, or nothing would be tested.
#[track_caller]
fn check(kind: &str, property: fn(&[u8]) -> bool) {
    let corpus = corpus(kind);
    let accepted = corpus.iter().filter(|text| property(text)).count();
    assert!(0 < accepted && accepted < corpus.len(), "{accepted} of {} texts are accepted", corpus.len());
    let mut random = Random::new(1984);
    let mut accepted = 0;
    for _ in 0..CHANGES {
        let (text, other) = (&corpus[random.below(corpus.len())], &corpus[random.below(corpus.len())]);
        accepted += u64::from(property(&mutated(text, other, &mut random)));
    }
    assert!(0 < accepted && accepted < CHANGES, "{accepted} of {CHANGES} changed texts are accepted");
}

#[test]
fn scene_files_never_break_the_parser() {
    check("scene", texts::scene);
}

#[test]
fn surveys_never_break_the_parser() {
    check("survey", texts::survey);
}

#[test]
fn contact_forces_never_break_the_parser() {
    check("forces", texts::forces);
}

#[test]
fn matrices_never_break_the_parser() {
    check("matrix", texts::matrix);
}
