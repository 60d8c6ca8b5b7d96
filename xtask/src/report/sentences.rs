//! What holds the sentences of the ten-minute report.
//!
//! A sentence says something over a domain: *all*, *never*, *at most*, *converges*. In its template it therefore ends with what would
//! fail if it were false, one of
//!
//! ```text
//! {{ checked(CONDITION, "over which data") }}   a condition on the values of the report: if it is false there is no report
//! {{ tested("name_of_a_test") }}              a test of the repository
//! {{ defined("where") }}                      nothing is claimed: what a word or an equation means
//! ```
//!
//! and a sentence with a quantifier and without one of these is refused. A sentence that only prints values is held by them.
//! On the pages that is asked where a reader decides: of what is in bold, and in the sections that give advice.

use std::collections::BTreeSet;
use std::path::Path;

use minijinja::{Environment, Error as TemplateError, ErrorKind, Value};

use super::{files, template};
use crate::Cause;
use crate::table::{Table, row};

/// The document whose sentences are listed, and the list.
pub(super) const DOCUMENT: &str = "report";
pub(super) const LIST: &str = "data/sentences.csv";

/// The sections of pages by which a reader decides what to do.
const DECISIONS: &[&str] = &[
    "The paper's recommendation, point by point",
    "Promised",
    "What follows",
    "When to stop",
    "What to use",
    "Which method and solver for which problem",
];

/// The words by which a sentence speaks of more than it shows.
const QUANTIFIERS: &[&str] = &[
    "all",
    "always",
    "any",
    "at least",
    "at most",
    "both",
    "confirmed",
    "converge",
    "converges",
    "each",
    "enough",
    "every",
    "everywhere",
    "fewest",
    "loosest",
    "neither",
    "never",
    "no",
    "none",
    "nothing",
    "only",
    "order",
    "quickest",
    "same",
    "up to",
    "whatever",
    "worst",
];

/// What is put into the text where a check stands, and taken out of it again.
const MARK: char = '\u{E000}';

/// The three functions. The tests that may be named are those of the repository.
pub(super) fn install(environment: &mut Environment<'_>, tests: BTreeSet<String>) {
    let invalid = |reason: String| TemplateError::new(ErrorKind::InvalidOperation, reason);
    environment.add_function("checked", move |condition: bool, domain: &str| {
        let said = if domain.is_empty() { None } else { Some(MARK) };
        said.filter(|_| condition).ok_or_else(|| invalid(format!("what is said over `{domain}` does not hold")))
    });
    environment.add_function("tested", move |name: &str| {
        let known = tests.contains(name).then_some(MARK);
        known.ok_or_else(|| invalid(format!("there is no test `{name}`")))
    });
    environment.add_function("defined", move |place: &str| {
        let said = (!place.is_empty()).then_some(MARK);
        said.ok_or_else(|| invalid("it is not said where this is defined".to_owned()))
    });
}

/// The names of all tests of the repository.
pub(super) fn tests(root: &Path) -> Result<BTreeSet<String>, Cause> {
    let sources = files::texts(root, &["src", "tests", "xtask/src"], &[".rs"])?;
    let name = |after: &str| Some(after.split_once("fn ")?.1.split_once('(')?.0.to_owned());
    Ok(sources.iter().flat_map(|(_, text)| text.split("#[test]").skip(1).filter_map(name)).collect())
}

/// A text without the places of its checks.
pub(super) fn without_marks(text: &str) -> String {
    text.replace([' ', MARK].iter().collect::<String>().as_str(), "").replace(MARK, "")
}

/// The sentences of a template that say something about data, with their values and what holds them, one in a line.
pub(super) fn list(environment: &Environment<'_>, text: &str, values: &Value) -> Result<Table, Cause> {
    let mut table = Table::new(["sentence", "over", "check"]);
    let mut unbound = Vec::new();
    for (_, line, Spoken { words, calls }) in sentences(text) {
        let [checks, printed] = [true, false].map(|of| calls.iter().filter(move |call| call.is_check() == of));
        let (checks, printed): (Vec<&Call<'_>>, Vec<&Call<'_>>) = (checks.collect(), printed.collect());
        match unheld(line, &words, &calls) {
            Some(without) => unbound.push(without),
            None if checks.is_empty() && printed.is_empty() => {}
            _ => {
                let sentence = template::line(environment, line, values)?;
                let [over, check]: [Vec<String>; 2] = if checks.is_empty() {
                    [printed.iter().map(|call| call.value().to_owned()).collect(), vec!["its values".to_owned()]]
                } else {
                    [0, 1].map(|part| checks.iter().map(|call| call.parts()[part].clone()).collect())
                };
                if let Some(call) = checks.iter().find(|call| call.is_constant(environment)) {
                    return Err(format!("`{}` asks nothing of the values", call.0).into());
                }
                table.push(row![without_marks(&sentence).trim(), over.join("; "), check.join("; ")]);
            }
        }
    }
    all_bound(&unbound).map(|()| table)
}

/// An error if a sentence of a page by which a reader decides has a quantifier and nothing that holds it.
pub(super) fn check_page(text: &str) -> Result<(), Cause> {
    let decides = |section: &str, line: &str| line.contains("**") || DECISIONS.contains(&section);
    let asked = sentences(text).filter(|(section, line, _)| decides(section, line));
    let unbound: Vec<String> =
        asked.filter_map(|(_, line, Spoken { words, calls })| unheld(line, &words, &calls)).collect();
    all_bound(&unbound)
}

/// The lines of a template that say something, each with the section that it is in.
fn sentences(text: &str) -> impl Iterator<Item = (&str, &str, Spoken<'_>)> {
    let (mut in_code, mut section) = (false, "");
    text.lines().map(str::trim).filter_map(move |line| {
        in_code ^= line.starts_with("```");
        section = line.strip_prefix("## ").filter(|_| !in_code).unwrap_or(section);
        let is_sentence = !in_code && !["```", "#", "![", "{%", "<"].iter().any(|start| line.starts_with(start));
        let spoken = is_sentence.then(|| Spoken::of(line)).filter(|spoken| !spoken.words.is_empty());
        spoken.map(|spoken| (section, line, spoken))
    })
}

/// The quantifier of a sentence that nothing holds.
fn unheld(line: &str, words: &[String], calls: &[Call<'_>]) -> Option<String> {
    let word = words.iter().find(|word| quantifies(word)).filter(|_| !calls.iter().any(Call::is_check));
    word.map(|word| format!("`{word}` in: {line}"))
}

fn all_bound(unbound: &[String]) -> Result<(), Cause> {
    if unbound.is_empty() {
        return Ok(());
    }
    let advice = "end the sentence with checked(…), tested(…) or defined(…)";
    Err(format!("sentences without a check; {advice}:\n  {}", unbound.join("\n  ")).into())
}

/// What a line of a template says itself, and the expressions in it.
struct Spoken<'a> {
    words: Vec<String>,
    calls: Vec<Call<'a>>,
}

/// An expression between `{{` and `}}`.
struct Call<'a>(&'a str);

impl<'a> Spoken<'a> {
    fn of(line: &'a str) -> Self {
        let (mut words, mut calls) = (String::new(), Vec::new());
        for part in line.split("{{") {
            let (call, rest) = part.split_once("}}").map_or((None, part), |(call, rest)| (Some(call.trim()), rest));
            calls.extend(call.filter(|call| !call.starts_with('"')).map(Call));
            words += rest;
            words.push(' ');
        }
        // Neither code nor the targets of links nor statements of the template are words.
        let plain: String = words.split('`').step_by(2).collect();
        let plain: String =
            plain.split("](").enumerate().map(|(k, part)| if k == 0 { part } else { after(part, ")") }).collect();
        let plain: String =
            plain.split("{%").enumerate().map(|(k, part)| if k == 0 { part } else { after(part, "%}") }).collect();
        let words = plain.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty());
        let words: Vec<String> = words.map(str::to_lowercase).collect();
        let pairs = words.windows(2).map(|pair| pair.join(" ")).collect::<Vec<_>>();
        Self { words: words.into_iter().chain(pairs).collect(), calls }
    }
}

/// What follows the first `end`.
fn after<'a>(text: &'a str, end: &str) -> &'a str {
    text.split_once(end).map_or("", |(_, rest)| rest)
}

fn quantifies(words: &str) -> bool {
    QUANTIFIERS.contains(&words)
}

impl Call<'_> {
    fn is_check(&self) -> bool {
        ["checked(", "tested(", "defined("].iter().any(|name| self.0.starts_with(name))
    }

    /// The value that is printed, without its filters.
    fn value(&self) -> &str {
        self.0.split('|').next().unwrap_or_default().trim()
    }

    /// Over what, and which check.
    fn parts(&self) -> [String; 2] {
        let text =
            |name: &str| self.0.strip_prefix(name)?.strip_suffix(')').map(|text| text.trim_matches('"').to_owned());
        if let Some(name) = text("tested(") {
            return ["what the test says".to_owned(), format!("test {name}")];
        }
        if let Some(place) = text("defined(") {
            return [place, "definition".to_owned()];
        }
        let inside = text("checked(").unwrap_or_default();
        let (condition, domain) = inside.rsplit_once(", \"").unwrap_or((&inside, ""));
        [domain.to_owned(), condition.to_owned()]
    }

    /// A condition in which no value occurs.
    fn is_constant(&self, environment: &Environment<'_>) -> bool {
        let [_, condition] = self.parts();
        self.0.starts_with("checked(")
            && template::names(environment, DOCUMENT, &format!("{{{{ {condition} }}}}"))
                .is_ok_and(|names| names.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TESTS: [&str; 1] = ["it_is_so"];

    fn listed(line: &str) -> Result<String, Cause> {
        let mut environment = template::environment([].into());
        install(&mut environment, TESTS.map(str::to_owned).into());
        let values = minijinja::context! { found => minijinja::context! { worst => 0.5, count => 3 } };
        list(&environment, line, &values)?.csv()
    }

    #[test]
    fn a_sentence_is_listed_with_what_holds_it() {
        for (line, expected) in [
            (
                "All {{ found.count }} are good {{ checked(found.worst < 1, \"three scenes\") }}.",
                "All 3 are good.,three scenes,found.worst < 1",
            ),
            ("It never pulls {{ tested(\"it_is_so\") }}.", "It never pulls.,what the test says,test it_is_so"),
            ("Any ground will do {{ defined(\"(4)\") }}.", "Any ground will do.,(4),definition"),
            ("There are {{ found.count }}.", "There are 3.,found.count,its values"),
        ] {
            assert_eq!(listed(line).expect(line), format!("sentence,over,check\n{expected}\n"));
        }
        for silent in
            ["A beam is long.", "## All of it", "```\nall\n```", "![All](a.svg)", "`all`", "{{ found.count }}"]
        {
            assert_eq!(listed(silent).expect(silent), "sentence,over,check\n", "{silent}");
        }
    }

    #[test]
    fn what_a_page_advises_is_held() {
        let said = |text: &str| check_page(text).map_err(|error| error.to_string());
        for held in [
            "All are good.",
            "**All are good.** {{ tested(\"it_is_so\") }}",
            "## What follows\nUse a grid.\n```\nall\n```\n## Data\nAll of them.",
        ] {
            assert_eq!(said(held), Ok(()), "{held}");
        }
        for unheld in ["**All are good.**", "## What follows\n- Use any grid.", "## When to stop\n### Later\nNever."] {
            assert!(said(unheld).is_err_and(|error| error.contains("sentences without a check")), "{unheld}");
        }
    }

    #[test]
    fn a_sentence_that_nothing_holds_is_refused() {
        for (line, reason) in [
            ("All are good.", "sentences without a check"),
            ("| it takes | at most | {{ found.count }} |", "sentences without a check"),
            ("All are good {{ checked(1 < found.worst, \"three scenes\") }}.", "does not hold"),
            ("All are good {{ checked(0 < 1, \"three scenes\") }}.", "asks nothing of the values"),
            ("All are good {{ checked(found.worst < 1, \"\") }}.", "does not hold"),
            ("All are good {{ tested(\"it_was_so\") }}.", "there is no test"),
            ("All are good {{ defined(\"\") }}.", "not said where"),
            ("All are good {{ checked(found.best < 1, \"three scenes\") }}.", "undefined"),
        ] {
            let error = listed(line).expect_err(line).to_string();
            assert!(error.contains(reason), "{line}: {error}");
        }
    }
}
