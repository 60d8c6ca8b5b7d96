//! Errors in a survey and in the declaration of its columns.

use super::Found;
use super::problem::{excerpt, list};

/// An error in a survey, or in the columns that the scene file declares.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SurveyProblem {
    /// A survey without the header `x,depth` and without declared columns.
    #[error(
        "a survey must begin with the header `x,depth`, or the scene must declare its columns; it begins with {found}"
    )]
    Header {
        /// The first row of the file.
        found: Found,
        /// Columns that could be declared; [`None`] if no text of the file may be printed.
        declare: Option<Declaration>,
    },
    /// A survey without any row.
    #[error("the survey has neither header nor points")]
    WithoutHeader,
    /// A row that does not have the two fields of a point.
    #[error("a row of a survey must have 2 fields, x and depth, but this one has {found}")]
    Fields {
        /// The number of fields.
        found: usize,
    },
    /// A row with too few fields for the declared columns.
    #[error("a row of this survey must have at least {column} fields, but this one has {found}")]
    Row {
        /// The last declared column.
        column: usize,
        /// The number of fields.
        found: usize,
    },
    /// A row with more fields than the header, in a file whose commas may be decimal marks.
    #[error("a row of this survey must have at most {width} fields, as its header, but this one has {found}")]
    Wide {
        /// Number of fields in the header.
        width: usize,
        /// Number of fields in the row.
        found: usize,
    },
    /// A declared column that the survey does not have.
    #[error("no column of the survey is called {:?}", excerpt(column))]
    NoColumn {
        /// The name of the column.
        column: String,
        /// The columns of the survey; [`None`] if no text of the file may be printed.
        columns: Option<Vec<String>>,
    },
    /// A declared column name that occurs twice in the survey.
    #[error("two columns of the survey are called {:?}", excerpt(column))]
    ColumnTwice {
        /// The name of the columns.
        column: String,
    },
    /// A station with an ambiguous distance between stations.
    #[error("`x` is {found}, which may count hundreds or thousands")]
    Station {
        /// The text of the field.
        found: Found,
    },
    /// The declaration has both `depth` and `elevation`, or neither.
    #[error("a survey must have exactly one of `depth` and `elevation`")]
    DepthOrElevation,
    /// A datum for depths.
    #[error("`datum` belongs to `elevation`: a depth already counts downwards from the line of the supports")]
    DatumOfDepths,
    /// A direction without the origin from which chainage is measured.
    #[error("`direction = \"down\"` needs `origin`, the chainage of the left end of the beam")]
    DirectionWithoutOrigin,
}

impl SurveyProblem {
    /// Removes all text of the file from the message.
    pub(super) fn hide_text(&mut self) {
        match self {
            Self::Header { found, declare } => (*found, *declare) = (Found::NotShown, None),
            Self::NoColumn { columns, .. } => *columns = None,
            Self::Station { found } => *found = Found::NotShown,
            _ => {}
        }
    }

    /// The value expected at the marked location.
    pub(super) fn expected(&self) -> Option<String> {
        Some(match self {
            Self::Header { .. } | Self::WithoutHeader => {
                "expected `x,depth`, then one point in each row; depth counts downwards, elevations count upwards".to_owned()
            }
            Self::Fields { found: 3.. } => MARKS.to_owned(),
            Self::Wide { .. } => "expected quotes round a field that has a comma in it".to_owned(),
            Self::NoColumn { columns: Some(columns), .. } => {
                let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
                format!("expected one of {}", excerpt(&list(&columns)))
            }
            Self::ColumnTwice { .. } => "expected a name that is there once; a column can be declared by its number, too".to_owned(),
            Self::Station { .. } => {
                "expected two digits before the decimal mark behind `+` (12+34.5 is 1234.5), or three (1+234.5), alike in all rows"
                    .to_owned()
            }
            Self::DatumOfDepths => "expected no `datum`, or `elevation` in the place of `depth`".to_owned(),
            _ => return None,
        })
    }

    /// The line to write in the scene file.
    pub(super) fn help(&self) -> Option<String> {
        match self {
            Self::Header { declare, .. } => Some(Declaration::lines(declare.as_ref())),
            _ => None,
        }
    }
}

/// The message for rows with decimal commas between separating commas.
pub(super) const MARKS: &str =
    "expected decimal points; with decimal commas, `;` between the fields, in the header as well";

/// A survey without a declaration, with its columns, for a suggestion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Declaration {
    /// The name of the file in the scene file.
    pub file: String,
    /// The fields of its first row.
    pub columns: Vec<String>,
}

/// Prefixes of column names for positions and for depths or elevations, as other programs use them.
const PLACES: [&str; 9] = ["x", "chain", "stat", "dist", "km", "kp", "pk", "pos", "along"];
const VALUES: [&str; 11] = ["elev", "level", "depth", "height", "z", "rl", "y", "h", "alt", "niveau", "invert"];

/// The longest column name that a suggestion repeats \[bytes\]; a column with a longer name is given by its number.
const LONGEST_NAME: usize = 60;

impl Declaration {
    /// The two possible declarations as lines of the scene file.
    fn lines(declaration: Option<&Self>) -> String {
        let [file, x, value] = declaration.map_or_else(
            || ["…"; 3].map(str::to_owned),
            |declaration| {
                let [x, value] = declaration.guessed();
                [format!("{:?}", excerpt(&declaration.file)), x, value]
            },
        );
        let columns = declaration.map_or_else(String::new, |declaration| {
            let names: Vec<&str> = declaration.columns.iter().map(String::as_str).collect();
            format!("the columns are {}; ", excerpt(&list(&names)))
        });
        format!(
            "{columns}if the values count downwards, write\n\
             survey = {{ file = {file}, x = {x}, depth = {value} }}\n\
             and if they count upwards, with the elevation at which the depth is 0,\n\
             survey = {{ file = {file}, x = {x}, elevation = {value}, datum = … }}"
        )
    }

    /// The columns that are probably meant: those with a matching name, otherwise the first two. Columns are numbered if the
    /// first row contains numbers.
    fn guessed(&self) -> [String; 2] {
        let begins = |at: usize, with: &[&str]| {
            let name = self.columns[at].to_lowercase();
            with.iter().any(|beginning| name.starts_with(beginning))
        };
        let all = || 0..self.columns.len();
        let x = all().find(|&at| begins(at, &PLACES)).unwrap_or(0);
        let next = if x == 0 { 1 } else { 0 };
        let value = all().find(|&at| at != x && begins(at, &VALUES)).unwrap_or(next);
        let is_number =
            |at: usize| self.columns.get(at).is_none_or(|name| name.replace(',', ".").parse::<f64>().is_ok());
        let is_once = |at: usize| self.columns.iter().filter(|name| **name == self.columns[at]).count() == 1;
        [x, value].map(|at| {
            let is_name = !is_number(at) && is_once(at) && (1..=LONGEST_NAME).contains(&self.columns[at].len());
            if is_name { format!("{:?}", self.columns[at]) } else { (at + 1).to_string() }
        })
    }
}
