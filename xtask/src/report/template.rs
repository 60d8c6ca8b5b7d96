//! The template engine, set so that nothing slips through.

use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, Error as TemplateError, ErrorKind, UndefinedBehavior, Value, escape_formatter};

use super::error::Error;
use super::numbers;

/// An engine in which a name that does not exist is an error, and so is a number with a point that no filter of
/// [`numbers`] has rounded: its last digits would differ from machine to machine.
pub(super) fn environment() -> Environment<'static> {
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
    numbers::add_filters(&mut environment);
    environment
}

/// Renders the template of a chapter. The name is what errors say.
pub(super) fn render(
    environment: &Environment<'_>,
    chapter: &'static str,
    template: &str,
    context: &Value,
) -> Result<String, Error> {
    environment
        .template_from_named_str(chapter, template)
        .and_then(|template| template.render(context.clone()))
        .map_err(|source| Error::Template { chapter, source })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    fn rendered(template: &str) -> Result<String, Error> {
        let context = BTreeMap::from([("x", Value::from(1.25)), ("n", Value::from(29)), ("none", Value::from(()))]);
        render(&environment(), "a", template, &context.into())
    }

    #[test]
    fn numbers_and_words_are_interpolated() {
        let text = rendered("{% if n == 29 %}\nn = {{ n }}, x = {{ x | fixed(1) }}, a < b\n{% endif %}\n");
        assert_eq!(text.expect("every name exists"), "n = 29, x = 1.2, a < b\n", "blocks leave no empty lines");
    }

    #[test]
    fn what_slips_through_elsewhere_is_an_error() {
        for template in
            ["{{ y }}", "{{ x.y }}", "{{ x }}", "{{ none }}", "{{ x | fxed(1) }}", "{{ x", "{{ 'a' | fixed(1) }}"]
        {
            assert!(rendered(template).is_err(), "{template}");
        }
    }
}
