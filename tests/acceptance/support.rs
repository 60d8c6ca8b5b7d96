//! The one place that configures insta: snapshots are tables for a person, compared as printed numbers.

use insta::Snapshot;
use insta::comparator::Comparator;
use palkki_evidence::numdiff::numdiff;

/// Compares a table with its snapshot by [`numdiff`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Numdiff;

impl Comparator for Numdiff {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let (Some(expected), Some(actual)) = (reference.as_text(), test.as_text()) else {
            return false;
        };
        let raw = numdiff(&expected.to_string(), &actual.to_string());
        #[expect(clippy::print_stderr, reason = "insta shows both texts, but not which number made the difference")]
        if let Err(difference) = &raw {
            eprintln!("{difference}");
        }
        raw.is_ok()
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(*self)
    }
}

/// The settings of all snapshots, and the one place for them: a folder and a description, and how two texts are compared.
/// Macros and no functions, so that `source:` in a snapshot names the real test.
macro_rules! with_our_settings {
    ($description:literal, $comparator:expr, $asserted:expr) => {
        insta::with_settings!({
            snapshot_path => concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"),
            prepend_module_to_snapshot => false,
            omit_expression => true,
            description => $description,
            comparator => Box::new($comparator),
        }, { $asserted })
    };
}
pub(crate) use with_our_settings;

/// Asserts that a table equals the snapshot `snapshots/<name>.snap` as far as it is printed.
///
/// The name and the description are literals: a test reads the names of all snapshots from the source.
macro_rules! assert_table {
    ($name:literal, $description:literal, $table:expr $(,)?) => {
        $crate::support::with_our_settings!(
            $description,
            $crate::support::Numdiff,
            insta::assert_snapshot!($name, $table)
        )
    };
}
pub(crate) use assert_table;

/// Asserts that words equal the snapshot `snapshots/<name>.snap`, every letter of them.
macro_rules! assert_text {
    ($name:literal, $description:literal, $text:expr $(,)?) => {{
        let exact = insta::comparator::DefaultComparator;
        $crate::support::with_our_settings!($description, exact, insta::assert_snapshot!($name, $text))
    }};
}
pub(crate) use assert_text;
