//! What two texts may differ in, and what not.

use super::*;

#[track_caller]
fn same(a: &str, b: &str) {
    assert_eq!(numdiff(a, b), Ok(()), "{a:?} and {b:?}");
    assert_eq!(numdiff(b, a), Ok(()), "{b:?} and {a:?}");
}

#[track_caller]
fn different(a: &str, b: &str) {
    assert!(numdiff(a, b).is_err(), "{a:?} and {b:?} must differ");
    assert!(numdiff(b, a).is_err(), "{b:?} and {a:?} must differ");
}

#[test]
fn decimals_may_move_by_one_unit() {
    same("T = 1.182177 (left)", "T = 1.182178 (left)");
    different("T = 1.182177 (left)", "T = 1.182179 (left)");
    same("| 0.10 | -2.50 |", "| 0.11 | -2.49 |");
    same("gap −0.01.", "gap 0.00.");
    same("x=2.364,3.5", "x=2.365,3.5");
}

#[test]
fn integers_and_words_may_not_move() {
    different("n = 29", "n = 30");
    different("certified", "not-certified");
    different("a b", "ab");
    different("1 2", "12");
    different("figure-4", "figure-5");
    different("nalgebra 0.35.0", "nalgebra 0.35.1");
    different("x86", "x87");
    different("1–16", "1–17");
}

#[test]
fn powers_of_ten_are_part_of_the_number() {
    same("residual 9.99·10⁻⁹ at 30", "residual 1.00·10⁻⁸ at 30");
    different("residual 1.2·10⁻⁹", "residual 1.2·10⁻⁸");
    different("residual 1.2·10⁻⁹", "residual 1.4·10⁻⁹");
    same("cond 4.0·10¹²", "cond 4.1·10¹²");
    same("3.0e-5,1", "3.1e-5,1");
    different("3.0e-5,1", "3.0e-5,2");
}

#[test]
fn the_sign_of_zero_moves_the_columns_and_nothing_else() {
    same("|  -0.0 |  1 |", "|   0.0 |  1 |");
    same("-0.0   9.99", " 0.0  10.00");
}

#[test]
fn indentation_is_structure() {
    different("- a\n  - b", "- a\n- b");
    different("    code", "code");
}

#[test]
fn a_word_instead_of_a_number_is_a_difference() {
    different("1.25", "nan");
    different("1.25 m", "1.25");
    different("1.25", "1.2");
}

#[test]
fn lines_are_counted() {
    let difference = numdiff("a\nb 1.0\nc", "a\nb 1.5\nc").expect_err("1.0 is not 1.5");
    assert_eq!(
        difference.to_string(),
        "line 2: 1.0 became 1.5, more than one unit of the last printed place\n  expected: b 1.0\n  actual:   b 1.5"
    );
    let mismatch = |a, b| numdiff(a, b).expect_err("one has a line more").mismatch;
    assert_eq!(mismatch("a\nb", "a"), Mismatch::MissingLine, "the second text is shorter");
    assert_eq!(mismatch("a", "a\n\nb"), Mismatch::ExtraLine, "the second text is longer");
    same("a\n", "a");
}

#[test]
fn pixels_may_move_by_one_and_labels_may_not() {
    let svg = |x, label, colour| {
        format!("<line x1=\"{x}\" stroke=\"#{colour}\"/>\n<path\n d=\"M{x},20L30,-4\"/><text>n = {label}</text>")
    };
    let drawn = svg(100, 29, "1f77b4");
    assert_eq!(numdiff_svg(&drawn, &svg(101, 29, "1f77b4")), Ok(()), "one pixel");
    assert!(numdiff_svg(&drawn, &svg(102, 29, "1f77b4")).is_err(), "two pixels");
    assert!(numdiff_svg(&drawn, &svg(100, 30, "1f77b4")).is_err(), "another label");
    assert!(numdiff_svg(&drawn, &svg(100, 29, "1f77b5")).is_err(), "another colour");
    assert!(numdiff_svg(&drawn, &drawn.replace("x1", "x2")).is_err(), "another attribute");
    assert!(numdiff(&drawn, &svg(101, 29, "1f77b4")).is_err(), "text has no pixels");
}

#[test]
fn any_text_is_read_without_panic() {
    for text in [
        "",
        "-",
        "−",
        "e",
        "1e",
        "1e-",
        "1e+",
        "+",
        "..",
        "1..2",
        "#",
        "·10",
        "·10⁻",
        "1·10",
        "1·10⁻",
        "ä1ö2",
        "<",
        "M",
        "1.5·10⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹",
    ] {
        same(text, text);
        assert_eq!(numdiff_svg(text, text), Ok(()), "{text:?}");
        assert_eq!(numdiff_svg(&format!("<{text}"), &format!("<{text}")), Ok(()), "{text:?} in a tag");
    }
}
