//! Fuzz target: surveys.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    palkki_evidence::texts::survey(bytes);
});
