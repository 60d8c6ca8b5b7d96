//! What can be wrong with a survey, and with what the scene file says of its columns.

use super::Found;
use super::problem::{excerpt, list};

/// Why a survey is none, or does not have the columns that the scene file names.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SurveyProblem {
    /// A survey without its header, whose columns are not declared.
    #[error(
        "a survey must begin with the header `x,depth`, or the scene must declare its columns; it begins with {found}"
    )]
    Header {
        /// What is there.
        found: Found,
        /// What could be declared, unless no text of the file is to be shown.
        declare: Option<Declaration>,
    },
    /// A survey without anything in it.
    #[error("the survey has neither header nor points")]
    WithoutHeader,
    /// A row of a survey that is not a point.
    #[error("a row of a survey must have 2 fields, x and depth, but this one has {found}")]
    Fields {
        /// How many it has.
        found: usize,
    },
    /// A row that is too short for the declared columns.
    #[error("a row of this survey must have at least {column} fields, but this one has {found}")]
    Row {
        /// The last column that is read.
        column: usize,
        /// How many fields it has.
        found: usize,
    },
    /// A row that is longer than the header, in a file whose commas may be decimal marks.
    #[error("a row of this survey must have at most {width} fields, as its header, but this one has {found}")]
    Wide {
        /// Fields of the header.
        width: usize,
        /// Fields of the row.
        found: usize,
    },
    /// A declared column that the survey does not have.
    #[error("no column of the survey is called {:?}", excerpt(column))]
    NoColumn {
        /// Its name.
        column: String,
        /// The columns, unless no text of the file is to be shown.
        columns: Option<Vec<String>>,
    },
    /// A declared column that the survey has twice.
    #[error("two columns of the survey are called {:?}", excerpt(column))]
    ColumnTwice {
        /// Their name.
        column: String,
    },
    /// A station that can be read in two ways.
    #[error("`x` is {found}, which may count hundreds or thousands")]
    Station {
        /// What is there.
        found: Found,
    },
    /// Both readings of a column, or none.
    #[error("a survey must have exactly one of `depth` and `elevation`")]
    DepthOrElevation,
    /// A datum beside depths.
    #[error("`datum` belongs to `elevation`: a depth already counts downwards from the line of the supports")]
    DatumOfDepths,
    /// A direction without the place that it counts from.
    #[error("`direction = \"down\"` needs `origin`, the chainage of the left end of the beam")]
    DirectionWithoutOrigin,
}

impl SurveyProblem {
    /// From here on the message repeats no text of the file.
    pub(super) fn hide_text(&mut self) {
        match self {
            Self::Header { found, declare } => (*found, *declare) = (Found::NotShown, None),
            Self::NoColumn { columns, .. } => *columns = None,
            Self::Station { found } => *found = Found::NotShown,
            _ => {}
        }
    }

    /// What is expected at the place of the message.
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

    /// The line to write.
    pub(super) fn help(&self) -> Option<String> {
        match self {
            Self::Header { declare, .. } => Some(Declaration::lines(declare.as_ref())),
            _ => None,
        }
    }
}

/// What is expected of rows with decimal commas between commas.
pub(super) const MARKS: &str =
    "expected decimal points; with decimal commas, `;` between the fields, in the header as well";

/// A survey without a declaration, and what could be declared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Declaration {
    /// The name of the file in the scene.
    pub file: String,
    /// What the fields of its first row are.
    pub columns: Vec<String>,
}

/// How columns of places and of depths or elevations begin, as programs name them.
const PLACES: [&str; 9] = ["x", "chain", "stat", "dist", "km", "kp", "pk", "pos", "along"];
const VALUES: [&str; 11] = ["elev", "level", "depth", "height", "z", "rl", "y", "h", "alt", "niveau", "invert"];

/// Bytes of the longest name that a line to write repeats; a column with a longer one has a number.
const LONGEST_NAME: usize = 60;

impl Declaration {
    /// Both readings as lines of the scene file.
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

    /// The columns that are probably meant: by their names, or else the first two. Where the first row has numbers there are no names.
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
