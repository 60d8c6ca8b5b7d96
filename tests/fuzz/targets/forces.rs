//! Fuzz target: contact forces.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    palkki_evidence::texts::forces(bytes);
});
