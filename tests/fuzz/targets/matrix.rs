//! Fuzz target: the matrix of a body.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    palkki_evidence::texts::matrix(bytes);
});
