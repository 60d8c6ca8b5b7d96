//! What can be wrong with the files of a body.

use crate::qp::NotPositiveDefinite;
use crate::scene::file::{Found, ReadProblem};

/// What is wrong with `[body]`, or with one of its files.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BodyProblem {
    /// A table that belongs to a beam.
    #[error("[{0}] must not be there: a scene has a [beam], or a [body] with its own loads and gaps")]
    Beside(&'static str),
    /// No matrix, or two.
    #[error("[body] must have exactly one of `stiffness` and `flexibility`")]
    OneMatrix,
    /// An elastic foundation beside a stiffness.
    #[error(
        "`body.foundation` must not be there: flexibilities of body and ground add up, and `body.stiffness` is none"
    )]
    FoundationOfStiffness,
    /// A file that could not be read.
    #[error("cannot read `body.{key}`, {path:?}: {problem}")]
    Unreadable {
        /// Which key names it.
        key: &'static str,
        /// As the scene file has it.
        path: String,
        /// Why not.
        problem: ReadProblem,
    },
    /// The first line of a matrix.
    #[error(
        "a matrix must begin with `%%MatrixMarket matrix coordinate|array real symmetric|general`, or have `row column value` or \
         `node, freedom, node, freedom, value` in each line, but begins with {found}"
    )]
    Header {
        /// What is there.
        found: Found,
    },
    /// Not so many numbers in a line.
    #[error("this line must have {expected}, but has {found} fields")]
    Fields {
        /// What it must have.
        expected: &'static str,
        /// How many fields it has.
        found: usize,
    },
    /// Not a number.
    #[error("`{quantity}` must be {expected}, but is {found}")]
    Number {
        /// What the number is.
        quantity: &'static str,
        /// What it must be.
        expected: String,
        /// What is there.
        found: Found,
    },
    /// No square matrix.
    #[error("the matrix must be square, but has {rows} rows and {columns} columns")]
    NotSquare {
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
    },
    /// A file that ends too early, or does not end.
    #[error("the matrix must have {expected} entries, but has {found}")]
    Entries {
        /// As the size says.
        expected: String,
        /// What there are; of too many the first that is one too many.
        found: usize,
    },
    /// A place for the second time.
    #[error(
        "the entry at {i} {j} is there twice, or its mirror image is: first in line {line}; entries that add up need `sum_duplicates = true` in [body]"
    )]
    Twice {
        /// Row.
        i: usize,
        /// Column.
        j: usize,
        /// Where it is first.
        line: usize,
    },
    /// Two entries that should be the same.
    #[error("the matrix must be symmetric, but is {here:?} at {i} {j} and {there:?} at {j} {i}")]
    NotSymmetric {
        /// Row.
        i: usize,
        /// Column.
        j: usize,
        /// Entry.
        here: f64,
        /// The other one.
        there: f64,
    },
    /// Rows of a matrix that are too long to be factorised.
    #[error(
        "the matrix takes {numbers} numbers from the first entry of each row to its diagonal, more than {most} or than there is memory for: number neighbours one after the other"
    )]
    TooLarge {
        /// What it takes.
        numbers: usize,
        /// The limit.
        most: usize,
    },
    /// A pivot that is not positive.
    #[error("the matrix must be positive definite, but pivot {pivot} of its factorisation is {value:?}")]
    NotPositiveDefinite {
        /// Which pivot, from 1.
        pivot: usize,
        /// Its value.
        value: f64,
    },
    /// A matrix or a list of another size.
    #[error("the {what} must have as many rows as the matrix of the body, {body}, but has {found}")]
    Sizes {
        /// What has another size.
        what: &'static str,
        /// Rows of the matrix of the body.
        body: usize,
        /// Rows that it has.
        found: usize,
    },
    /// A table without its header.
    #[error("this file must begin with the header {expected}, but begins with {found}")]
    TableHeader {
        /// What should be there.
        expected: String,
        /// What is there.
        found: Found,
    },
    /// Products of its numbers that are too large.
    #[error("the product of the matrix with gaps or loads is beyond the range of 64-bit floating point")]
    Range,
    /// A freedom for the second time.
    #[error("the row of {0} is there twice")]
    RowTwice(usize),
}

impl BodyProblem {
    /// From here on the message repeats no text of the file.
    pub(crate) fn hide_text(&mut self) {
        if let Self::Header { found } | Self::Number { found, .. } | Self::TableHeader { found, .. } = self {
            *found = Found::NotShown;
        }
    }
}

impl From<NotPositiveDefinite> for BodyProblem {
    fn from(error: NotPositiveDefinite) -> Self {
        Self::NotPositiveDefinite { pivot: error.index + 1, value: error.pivot }
    }
}
