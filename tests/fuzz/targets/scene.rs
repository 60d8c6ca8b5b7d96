//! Fuzz target: scene files.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    palkki_evidence::texts::scene(bytes);
});
