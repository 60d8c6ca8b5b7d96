//! Errors in the table `[body]` and in the files of a body.

use crate::qp::NotPositiveDefinite;
use crate::scene::file::{Found, ReadProblem};

/// An error in `[body]` or in one of its files.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BodyProblem {
    /// A table that belongs to a beam.
    #[error("[{0}] must not be there: a scene has a [beam], or a [body] with its own loads and gaps")]
    Beside(&'static str),
    /// No matrix, or two.
    #[error("[body] must have exactly one of `stiffness` and `flexibility`")]
    OneMatrix,
    /// An elastic foundation together with a stiffness.
    #[error(
        "`body.foundation` must not be there: flexibilities of body and ground add up, and `body.stiffness` is none"
    )]
    FoundationOfStiffness,
    /// A file that could not be read.
    #[error("cannot read `body.{key}`, {path:?}: {problem}")]
    Unreadable {
        /// The key that names the file.
        key: &'static str,
        /// The path as written in the scene file.
        path: String,
        /// The reason.
        problem: ReadProblem,
    },
    /// An invalid first line of a matrix.
    #[error(
        "a matrix must begin with `%%MatrixMarket matrix coordinate|array real symmetric|general`, or have `row column value` or \
         `node, freedom, node, freedom, value` in each line, but begins with {found}"
    )]
    Header {
        /// The first line of the file.
        found: Found,
    },
    /// A line with a wrong number of fields.
    #[error("this line must have {expected}, but has {found} fields")]
    Fields {
        /// The required fields.
        expected: &'static str,
        /// The number of fields.
        found: usize,
    },
    /// An invalid number.
    #[error("`{quantity}` must be {expected}, but is {found}")]
    Number {
        /// The name of the number.
        quantity: &'static str,
        /// The requirement.
        expected: String,
        /// The text of the field.
        found: Found,
    },
    /// A matrix that is not square.
    #[error("the matrix must be square, but has {rows} rows and {columns} columns")]
    NotSquare {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// A file with too few or too many entries.
    #[error("the matrix must have {expected} entries, but has {found}")]
    Entries {
        /// The number of entries according to the size.
        expected: String,
        /// The number of entries; if there are too many, the index of the first surplus entry.
        found: usize,
    },
    /// A duplicate entry.
    #[error(
        "the entry at {i} {j} is there twice, or its mirror image is: first in line {line}; entries that add up need `sum_duplicates = true` in [body]"
    )]
    Twice {
        /// Row.
        i: usize,
        /// Column.
        j: usize,
        /// Line of the first entry.
        line: usize,
    },
    /// Two entries that should be equal.
    #[error("the matrix must be symmetric, but is {here:?} at {i} {j} and {there:?} at {j} {i}")]
    NotSymmetric {
        /// Row.
        i: usize,
        /// Column.
        j: usize,
        /// The entry.
        here: f64,
        /// The entry mirrored at the diagonal.
        there: f64,
    },
    /// A matrix whose rows are too long to be factorised.
    #[error(
        "the matrix takes {numbers} numbers from the first entry of each row to its diagonal, more than {most} or than there is memory for: number neighbours one after the other"
    )]
    TooLarge {
        /// The number of stored values.
        numbers: usize,
        /// The limit.
        most: usize,
    },
    /// A pivot that is not positive.
    #[error("the matrix must be positive definite, but pivot {pivot} of its factorisation is {value:?}")]
    NotPositiveDefinite {
        /// The pivot, from 1.
        pivot: usize,
        /// Its value.
        value: f64,
    },
    /// A matrix or a list of a different size.
    #[error("the {what} must have as many rows as the matrix of the body, {body}, but has {found}")]
    Sizes {
        /// The matrix or list of a different size.
        what: &'static str,
        /// Number of rows of the matrix of the body.
        body: usize,
        /// Its number of rows.
        found: usize,
    },
    /// A table without the required header.
    #[error("this file must begin with the header {expected}, but begins with {found}")]
    TableHeader {
        /// The required header.
        expected: String,
        /// The first line of the file.
        found: Found,
    },
    /// A product of the matrix with gaps or loads that exceeds the range of `f64`.
    #[error("the product of the matrix with gaps or loads is beyond the range of 64-bit floating point")]
    Range,
    /// A degree of freedom that is listed twice.
    #[error("the row of {0} is there twice")]
    RowTwice(usize),
}

impl BodyProblem {
    /// Removes all text of the file from the message.
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
