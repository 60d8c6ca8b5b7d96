//! Output without what changes from run to run.

use palkki::text::Results;

/// What changes from run to run is the word `time`, and what is left of rounding the word `tiny`; a number with a point has at
/// most six digits, so that it may be compared as printed.
pub(super) fn steady(text: &str) -> String {
    let mut columns: Vec<usize> = Vec::new();
    let mut lines = String::new();
    for line in text.lines() {
        let words = words(line);
        if words.len() < 2 {
            columns.clear();
        }
        // In a table numbers end where the name of their column ends.
        let timed = |&(at, word): &(usize, &str)| (word == "seconds" && 2 < words.len()).then_some(at + word.len());
        let of_header: Vec<usize> = words.iter().filter_map(timed).collect();
        let is_time = line.starts_with("  seconds ") || line.contains("\"seconds\":");
        let is_rest = ["equilibrium residual", "\"residual\":", "\"gap\":"].iter().any(|name| line.contains(name));
        let library = [" clarabel ", " osqp "].iter().any(|name| line.contains(name)) && !columns.is_empty();
        lines += &numbers(line, |end, number| {
            let value: f64 = number.parse().unwrap_or(f64::NAN);
            let real = number.contains(['.', 'e']);
            if (is_time && real) || columns.contains(&end) {
                Some("time".to_owned())
            } else if (0.0 < value && value < ROUNDING) || (value == 0.0 && (is_rest || library)) {
                Some("tiny".to_owned())
            } else if library && !real {
                // Another processor may take a library another iteration.
                Some("some".to_owned())
            } else {
                (real && MOST_DIGITS < significant(number)).then(|| rounded(value))
            }
        });
        lines.push('\n');
        if !of_header.is_empty() {
            columns = of_header;
        }
    }
    lines
}

/// JSON with an object or a list on one line where it fits there, and of a long list of numbers its ends and their count: the text
/// tables of the same answers show all of them.
pub(super) fn in_short(json: &str) -> String {
    /// Letters of a line.
    const WIDTH: usize = 120;
    /// Numbers of a list that are all shown.
    const NUMBERS: usize = 8;
    let (mut lines, mut open) = (Vec::<String>::new(), Vec::new());
    for line in json.lines() {
        lines.push(line.to_owned());
        let end = line.trim_start();
        if line.ends_with(['{', '[']) {
            open.push(lines.len() - 1);
        } else if end.starts_with(['}', ']'])
            && let Some(first) = open.pop()
        {
            let inside: Vec<&str> = lines[first + 1..lines.len() - 1].iter().map(|line| line.trim()).collect();
            let is_number = |item: &&str| !item.contains(['"', '[', '{']);
            let text = match inside[..] {
                [from, .., to] if NUMBERS < inside.len() && end.starts_with(']') && inside.iter().all(is_number) => {
                    format!("{from} …, {to} ({} numbers)", inside.len())
                }
                _ => inside.join(" "),
            };
            let gap = if end.starts_with('}') { " " } else { "" };
            let line = format!("{}{gap}{text}{gap}{end}", lines[first]);
            if line.chars().count() <= WIDTH {
                lines.truncate(first);
                lines.push(line);
            }
        }
    }
    lines.join("\n") + "\n"
}

/// No number of these scenes is as small, but for those that would be zero without rounding.
const ROUNDING: f64 = 2e-11;

/// Digits that are compared.
const MOST_DIGITS: usize = 6;

/// The digits of a printed number from the first that is not zero.
fn significant(number: &str) -> usize {
    let mantissa = number.split('e').next().unwrap_or_default();
    mantissa.chars().filter(char::is_ascii_digit).skip_while(|digit| *digit == '0').count()
}

/// A number with so many digits; it keeps its point, as a whole number is compared to the letter.
fn rounded(value: f64) -> String {
    let short = Results::with_digits(MOST_DIGITS).number(value);
    if short.contains(['.', 'e']) { short } else { short + ".0" }
}

/// The words of a line with the places, counted in letters, at which they begin.
fn words(line: &str) -> Vec<(usize, &str)> {
    let mut at = 0;
    let parts = line.split(' ').map(|word| {
        let begin = at;
        at += word.chars().count() + 1;
        (begin, word)
    });
    parts.filter(|(_, word)| !word.is_empty()).collect()
}

/// A line with other numbers; `other` has the place, counted in letters, at which a number ends.
fn numbers(line: &str, other: impl Fn(usize, &str) -> Option<String>) -> String {
    let (mut text, mut rest, mut before) = (String::new(), line, ' ');
    while let Some(first) = rest.chars().next() {
        let digits = |from: usize| rest[from..].bytes().take_while(u8::is_ascii_digit).count();
        let mut length = if before.is_alphanumeric() || "_.".contains(before) { 0 } else { digits(0) };
        if 0 < length {
            if rest[length..].starts_with('.') && 0 < digits(length + 1) {
                length += 1 + digits(length + 1);
            }
            for exponent in ["e-", "e"] {
                if rest[length..].starts_with(exponent) && 0 < digits(length + exponent.len()) {
                    length += exponent.len() + digits(length + exponent.len());
                }
            }
            let end = line[..line.len() - rest.len() + length].chars().count();
            let number = other(end, &rest[..length]).unwrap_or_else(|| rest[..length].to_owned());
            if number == "tiny" && text.ends_with('-') {
                // Which sign is left of rounding says nothing.
                text.pop();
            }
            text += &number;
        } else {
            length = first.len_utf8();
            text.push(first);
        }
        before = rest[..length].chars().last().unwrap_or(' ');
        rest = &rest[length..];
    }
    text
}

#[test]
fn what_flickers_is_masked() {
    let table = "  method  seconds  error\n  force    1.5e-4  1.5e-4\n  osqp      12  -3.1e-13\n\n  seconds  2.5\n0.12345678 4 1.0000000002";
    let expected = "  method  seconds  error\n  force    time  1.5e-4\n  osqp      some  tiny\n\n  seconds  time\n0.123457 4 1.0\n";
    assert_eq!(steady(table), expected, "times, rounding and digits");
    assert_eq!(steady("\"residual\": 0.0, \"gap\": 1e-20"), "\"residual\": tiny, \"gap\": tiny\n");
}

#[test]
fn json_is_shown_in_short() {
    let list = (1..=9).map(|i| format!("    {i}")).collect::<Vec<_>>().join(",\n");
    let json = format!(
        "{{\n  \"of\": {{\n    \"a\": [\n      1,\n      2\n    ],\n    \"b\": null\n  }},\n  \"x\": [\n{list}\n  ]\n}}"
    );
    let expected = "{ \"of\": { \"a\": [1, 2], \"b\": null }, \"x\": [1, …, 9 (9 numbers)] }\n";
    assert_eq!(in_short(&json), expected, "one line");
    let name = "n".repeat(120);
    assert_eq!(in_short(&format!("[\n  \"{name}\"\n]")), format!("[\n  \"{name}\"\n]\n"), "too long for one");
}
