//! Arithmetic that gives the same bits on every processor.

use std::collections::BTreeMap;

use super::text::{code, first_word_of, none, offenders, rust_files, words};

/// What makes a program take another path, or round differently, on another processor.
const FEATURES: [&str; 9] = [
    "mul_add",
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

/// Functions of the standard library whose last digit "varies by platform, Rust version, and can even differ within the same
/// execution", as its documentation says.
const VARY: [&str; 26] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "hypot", "cbrt",
];

/// The function of [`VARY`] that a line calls, as a method or by its path.
fn varying(line: &str) -> Option<String> {
    // A power of a half is exact, however it is computed; `log()` without a base is not the function.
    let code = code(line).replace("0.5_f64.powi(", "").replace(".log()", "");
    let called = |name: &&&str| {
        [format!(".{name}("), format!("f64::{name}"), format!("f32::{name}")].iter().any(|call| {
            code.find(call.as_str()).is_some_and(|at| {
                let behind = code[at + call.len()..].chars().next();
                call.ends_with('(') || !behind.is_some_and(|c| c.is_alphanumeric() || c == '_')
            })
        })
    };
    VARY.iter().find(called).map(|name| format!("`{name}` of the standard library; take it from libm"))
}

#[test]
fn elementary_functions_come_from_libm() {
    none(&offenders(&rust_files("src"), varying), "elementary functions give the same bits everywhere");
}

#[test]
fn varying_functions_are_recognised() {
    for line in
        ["let y = x.sin();", "let y = f64::exp(x);", "xs.map(f64::ln)", "x.powi(2)", "2.0_f64.powf(x)", "x.log(10.0)"]
    {
        assert!(varying(line).is_some(), "{line}");
    }
    for line in
        ["libm::sin(x)", "0.5_f64.powi(k)", "axis.log()", "// x.sin()", "x.sqrt()", "f64::expect", "f64::EPSILON"]
    {
        assert_eq!(varying(line), None, "{line}");
    }
}

/// Files of the library that name the matrix library, and what they take from it: nothing that
/// multiplies two matrices larger than five, for which it looks at the processor.
const MATRICES: [(&str, &str); 5] = [
    ("src/qp/matrix.rs", "entries and columns"),
    ("src/qp/dense.rs", "the product with a vector and Cholesky's factor, both plain loops"),
    ("src/methods/program.rs", "columns, and a sum"),
    ("src/methods/force.rs", "entries from a function"),
    ("src/methods/displacement.rs", "columns, and a sum"),
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
