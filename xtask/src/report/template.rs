//! The template engine, set so that nothing slips through.

use std::collections::{BTreeMap, HashSet};

use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, Error as TemplateError, ErrorKind, State, UndefinedBehavior, Value, escape_formatter};

use super::excerpt::Excerpt;
use crate::{Cause, text};

/// An engine in which a name that does not exist is an error, and so is a number with a point that no filter has rounded: its
/// last digits would differ from machine to machine. The filters are `fixed(3)`, `digits(3)`, `sci(1)`, `percent(1)` and
/// `thousands`; see [`text`].
///
/// `{{ source("name") }}` is an excerpt of the code.
pub(super) fn environment(excerpts: BTreeMap<String, Excerpt>) -> Environment<'static> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    if let Ok(syntax) = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build() {
        environment.set_syntax(syntax);
    }
    environment.set_formatter(|out, state, value| {
        if value.is_number() && !value.is_integer() {
            let reason =
                format!("{value} is printed without saying how many digits; use fixed, digits, sci or percent");
            return Err(TemplateError::new(ErrorKind::InvalidOperation, reason));
        }
        if value.is_none() {
            return Err(TemplateError::new(ErrorKind::InvalidOperation, "there is no value to print"));
        }
        escape_formatter(out, state, value)
    });
    environment.add_filter("fixed", |value: f64, places: usize| Ok(text::fixed(finite(value)?, places)));
    environment.add_filter("digits", |value: f64, digits: usize| Ok(text::significant(finite(value)?, digits)));
    environment.add_filter("sci", |value: f64, places: usize| Ok(text::times_ten(finite(value)?, places)));
    environment.add_filter("bound", |value: f64| Ok(text::bound(finite(value)?)));
    environment.add_filter("percent", |value: f64, places: usize| {
        Ok(format!("{} %", text::fixed(100.0 * finite(value)?, places)))
    });
    environment.add_filter("thousands", |value: i64| text::count(value));
    environment.add_function("source", move |state: &State<'_, '_>, name: &str| {
        let missing = || TemplateError::new(ErrorKind::UndefinedError, format!("no source marks an excerpt `{name}`"));
        let up = state.lookup("up").ok_or_else(missing)?;
        excerpts.get(name).map(|excerpt| excerpt.markdown(&up.to_string())).ok_or_else(missing)
    });
    environment
}

/// `value`, or an error that stops the report: a number that is none must not look like a result.
fn finite(value: f64) -> Result<f64, TemplateError> {
    if value.is_finite() {
        Ok(value)
    } else {
        let reason = format!("a number of the report must be finite, but is {value}");
        Err(TemplateError::new(ErrorKind::InvalidOperation, reason))
    }
}

/// The names at the top of what a template uses.
pub(super) fn names(environment: &Environment<'_>, document: &str, template: &str) -> Result<HashSet<String>, Cause> {
    let parsed = environment.template_from_named_str(document, template);
    parsed.map(|parsed| parsed.undeclared_variables(false)).map_err(|error| failed(document, &error))
}

/// One line of a document.
pub(super) fn line(environment: &Environment<'_>, line: &str, values: &Value) -> Result<String, Cause> {
    let rendered = environment.render_str(line, values);
    rendered.map_err(|error| format!("{error:#}, in: {line}").into())
}

fn failed(document: &str, error: &TemplateError) -> Cause {
    format!("report/templates/{document}.md: {error}").into()
}

/// Renders the template of a document, from which the root of the repository is reached by `up`.
pub(super) fn render(
    environment: &Environment<'_>,
    document: &str,
    template: &str,
    values: &BTreeMap<String, Value>,
    up: &str,
) -> Result<String, Cause> {
    let mut values = values.clone();
    values.insert("up".to_owned(), up.into());
    environment
        .template_from_named_str(document, template)
        .and_then(|template| template.render(Value::from(values)))
        .map_err(|error| failed(document, &error))
}

/// A piece of HTML with its values, which are HTML already.
pub(super) fn filled(html: &str, values: Value) -> Result<String, Cause> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    // The engine leaves out the end of the last line.
    Ok(environment.render_str(html, values)? + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rendered(template: &str) -> Result<String, Cause> {
        let values = [
            ("x", Value::from(1.25)),
            ("n", Value::from(29)),
            ("none", Value::from(())),
            ("nan", Value::from(f64::NAN)),
        ];
        let values = values.map(|(name, value)| (name.to_owned(), value)).into();
        let excerpt = Excerpt { path: "src/a.rs".to_owned(), code: "f()".to_owned() };
        render(&environment([("a".to_owned(), excerpt)].into()), "a", template, &values, "..")
    }

    #[test]
    fn numbers_and_words_are_interpolated() {
        let text = rendered("{% if n == 29 %}\nn = {{ n }}, x = {{ x | fixed(1) }}, a < b\n{% endif %}\n");
        assert_eq!(text.expect("every name exists"), "n = 29, x = 1.2, a < b\n", "blocks leave no empty lines");
        let text = rendered("{{ x | sci(1) }} {{ x | digits(2) }} {{ 0.034 | percent(1) }} {{ 20000 | thousands }}");
        assert_eq!(text.expect("finite"), "1.2·10⁰ 1.2 3.4 % 20\u{202f}000");
    }

    #[test]
    fn code_is_shown_with_its_place() {
        let text = rendered("{{ source('a') }}").expect("it is marked");
        assert_eq!(text, "```rust\nf()\n```\n\nFrom [src/a.rs](../src/a.rs).");
    }

    #[test]
    fn what_slips_through_elsewhere_is_an_error() {
        for template in [
            "{{ y }}",
            "{{ x.y }}",
            "{{ x }}",
            "{{ none }}",
            "{{ nan | fixed(1) }}",
            "{{ nan | digits(3) }}",
            "{{ -1e999 | sci(1) }}",
            "{{ x | fxed(1) }}",
            "{{ x",
            "{{ 'a' | fixed(1) }}",
            "{{ source('b') }}",
        ] {
            assert!(rendered(template).is_err(), "{template}");
        }
    }
}
