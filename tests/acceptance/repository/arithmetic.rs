//! Arithmetic that gives the same bits on every processor.

use std::collections::BTreeMap;

use super::text::{code, files, first_word_of, none, offenders, rust_files, words};

/// What makes a program take another path, or round differently, on another processor.
const FEATURES: [&str; 8] = [
    "target_feature",
    "target_arch",
    "is_x86_feature_detected",
    "is_aarch64_feature_detected",
    "simd",
    "arch",
    "algebraic_add",
    "algebraic_mul",
];

#[test]
fn nothing_asks_what_the_processor_can_do() {
    let found = offenders(&rust_files("src"), |line| {
        let word = first_word_of(code(line), &FEATURES);
        // `std::env::consts::ARCH` is a label, not a path; the library has not even that.
        word.map(|word| format!("`{word}`"))
    });
    none(&found, "every addition and multiplication rounds once, on every processor");
}

#[test]
fn elementary_functions_come_from_libm() {
    for place in ["src/lib.rs", "src/main.rs"] {
        assert!(files(place, "")[place].contains("#![warn(clippy::disallowed_methods)]"), "{place}: the lint is on");
    }
    let off = |line: &str| line.contains("disallowed_methods") && !line.starts_with("#![warn");
    let found = offenders(&rust_files("src"), |line| off(line).then(|| "turns the lint off".to_owned()));
    none(&found, "elementary functions give the same bits everywhere: `.clippy.toml` lists those that do not");
}

/// Files of the library that name the matrix library, and what they take from it: nothing that
/// multiplies two matrices larger than five, for which it looks at the processor.
const MATRICES: [(&str, &str); 4] = [
    ("src/grid/qp/matrix.rs", "entries and columns"),
    ("src/grid/methods/program.rs", "columns, and a sum"),
    ("src/grid/methods/force.rs", "entries from a function"),
    ("src/grid/methods/displacement.rs", "columns, and a sum"),
];

#[test]
fn our_own_routes_take_no_product_of_the_matrix_library() {
    let mut sources: BTreeMap<String, String> = rust_files("src");
    for (allowed, takes) in MATRICES {
        let source = sources.get(allowed).unwrap_or_else(|| panic!("{allowed} is not there: correct MATRICES"));
        assert!(source.contains("use nalgebra"), "{allowed} takes no {takes} of the matrix library: correct MATRICES");
    }
    sources.retain(|path, _| MATRICES.iter().all(|(allowed, _)| path != allowed));
    let found = offenders(&sources, |line| {
        words(code(line)).find(|word| *word == "nalgebra").map(|_| "names the matrix library".to_owned())
    });
    none(
        &found,
        "products of large matrices round as the processor likes: name the file in MATRICES with what it takes",
    );
}
