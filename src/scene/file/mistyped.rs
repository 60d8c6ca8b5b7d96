//! Suggestions for numbers that are not written as TOML writes them: a decimal comma, a unit, blanks between thousands.

/// Characters that look like a minus sign and are none.
const MINUS: [char; 4] = ['\u{2212}', '\u{2013}', '\u{2014}', '\u{ff0d}'];

/// Blanks that are none for TOML.
const BLANKS: [char; 3] = ['\u{a0}', '\u{202f}', '\u{2009}'];

/// The suggestion for a line that is not valid TOML.
pub(super) fn in_line(line: &str) -> Option<String> {
    let line = without_comment(line);
    let start = line.trim_start();
    if start.starts_with('{') {
        return Some(
            "this looks like JSON; a scene file is TOML: a line [beam], then lines such as `length = 10.0`".to_owned(),
        );
    }
    if start.starts_with([';', '%']) || start.starts_with("//") {
        return Some("begin a comment with `#`".to_owned());
    }
    let ends_of_keys = line.match_indices(['=', '[', ',']).map(|(i, mark)| (mark == "=", line[i + 1..].trim_start()));
    if let Some(hint) = ends_of_keys.into_iter().find_map(|(is_whole, value)| in_value(value, is_whole)) {
        return Some(hint);
    }
    if let Some(blank) = line.chars().find(|c| BLANKS.contains(c)) {
        return Some(format!("replace the character U+{:04X}, which looks like a blank, by a blank", u32::from(blank)));
    }
    if line.contains(['\u{201c}', '\u{201d}', '\u{201e}']) {
        return Some("write quotation marks as `\"`".to_owned());
    }
    match line.split_once(':') {
        Some((key, value)) if !line.contains('=') && is_key(key.trim()) => {
            let value = if value.trim().is_empty() { "…" } else { value.trim() };
            Some(format!(
                "write `{} = {value}`; a table begins with its name in brackets, for example [beam]",
                key.trim()
            ))
        }
        _ => None,
    }
}

/// The suggestion for a text in the place of a number.
pub(super) fn in_text(text: &str) -> Option<String> {
    let text = text.trim();
    if text.parse::<f64>().is_ok_and(f64::is_finite) {
        return Some(format!("write it without quotation marks: `{text}`"));
    }
    in_value(text, true).map(|hint| format!("{hint}, without quotation marks"))
}

/// The suggestion for a value that begins like a number. Only a value that is not within an array can have a decimal comma.
fn in_value(value: &str, is_whole: bool) -> Option<String> {
    if let Some(rest) = value.strip_prefix(MINUS).filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) {
        let (number, _) = number(rest);
        return Some(format!("write the minus sign as `-`: `-{number}`"));
    }
    let (number, rest) = number(value);
    let digits = number.trim_start_matches(['+', '-']);
    if !digits.contains(|c: char| c.is_ascii_digit()) {
        return None;
    }
    if digits.starts_with('.') || digits.ends_with('.') {
        let sign = &number[..number.len() - digits.len()];
        let [before, after] =
            [digits.starts_with('.'), digits.ends_with('.')].map(|is_bare| if is_bare { "0" } else { "" });
        return Some(format!("write a digit on both sides of the decimal point: `{sign}{before}{digits}{after}`"));
    }
    let rest_digits = |after: &str| after.chars().take_while(char::is_ascii_digit).count();
    let ends = |after: &str| after.trim_start().is_empty() || after.starts_with([' ', '\t', '}', ']', ',', ';']);
    if let Some(fraction) = rest.strip_prefix(',').filter(|_| is_whole && !digits.contains('.')) {
        let count = rest_digits(fraction);
        return (0 < count && ends(&fraction[count..]))
            .then(|| format!("write a decimal point instead of a decimal comma: `{number}.{}`", &fraction[..count]));
    }
    let next = rest.trim_start_matches(|c| matches!(c, ' ' | '\'') || BLANKS.contains(&c));
    if next.len() < rest.len() && rest_digits(next) == 3 {
        return Some(format!("write the number without blanks or marks between thousands: `{number}{}`", &next[..3]));
    }
    match next.chars().next()? {
        '*' | '/' | '^' | '(' => Some("write the result as one number: a scene file does not compute".to_owned()),
        ';' => Some(format!("remove the `;` behind `{number}`")),
        c if c.is_alphabetic() || matches!(c, '%' | '\u{b0}' | '"') => {
            Some(format!("write the number alone: `{number}`; the table [units] names the units of length and force"))
        }
        _ => None,
    }
}

/// The number at the beginning of a text, with sign, decimal point and exponent, and the rest.
fn number(text: &str) -> (&str, &str) {
    let signed = |text: &str| usize::from(text.starts_with(['+', '-']));
    let digits = |text: &str, more: &[char]| {
        text.find(|c: char| !c.is_ascii_digit() && !more.contains(&c)).unwrap_or(text.len())
    };
    let mut end = signed(text);
    end += digits(&text[end..], &['.', '_']);
    if let Some(power) = text[end..].strip_prefix(['e', 'E']) {
        let sign = signed(power);
        let count = digits(&power[sign..], &[]);
        end += if 0 < count { 1 + sign + count } else { 0 };
    }
    text.split_at(end)
}

/// The line without its comment.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    for (i, c) in line.char_indices() {
        match (quote, c) {
            (None, '#') => return &line[..i],
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), _) if open == c => quote = None,
            _ => {}
        }
    }
    line
}

fn is_key(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}
