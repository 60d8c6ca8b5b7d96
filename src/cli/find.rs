//! The command `find`: the values of a number of the scene for which a target is reached.

use std::time::Instant;

use clap::Args;
use palkki::route::Status;
use palkki::sweep::{self, Beside, Found, MOST_WORK, Measure, Sweep, Until};
use palkki::text::{Results, magnitude};
use serde::Serialize;

use super::answer::Answer;
use super::arguments::{Common, Varied};
use super::given::scene_lines;
use super::input::Input;
use super::json::{self, RouteObject, SceneObject};
use super::output::Failure;
use super::sweep::{REASON, header, outermost, row, varied};
use super::table::{Row, list, table};
use super::text::heading;

pub(super) const EXAMPLES: &str = "\
CONDITION is `contact` or QUANTITY = NUMBER. `contact` is where contact with the foundation begins
or ends; without a foundation, where the beam lifts off a compression-only support or comes to bear
on it. The quantities are, x being a position along the beam:

  deflection(x)   positive downwards
  moment(x)       positive with the underside in tension; just right of x where it jumps
  shear(x)        the derivative of the moment; just right of x where it jumps
  clearance(x)    distance between beam and foundation
  support[i]      reaction, positive upwards; i counts from 0 on, from left to right

Examples:
  palkki find report/scenes/heinisuo-1984.toml --vary foundation.depth --from 1 --to 150 \\
    --until contact
  palkki find report/scenes/heinisuo-1984.toml --vary load.uniform --from 0.001 --to 1 \\
    --until 'deflection(4.0) = 0.95'
  palkki find report/scenes/kink.toml --vary load.point[0].at --from 0 --to 10 \\
    --until 'support[1] = 3.4' --format json";

#[derive(Debug, Args)]
pub(super) struct Find {
    #[command(flatten)]
    pub(super) common: Common,
    #[command(flatten)]
    pub(super) varied: Varied,
    /// What is to be reached
    #[arg(long, value_name = "CONDITION")]
    pub(super) until: String,
}

/// Digits of the values found: all that rounding leaves.
const DIGITS: usize = 15;

/// A number with these digits.
fn precise(number: f64) -> String {
    Results::with_digits(DIGITS).number(number)
}

/// The values found, with their answers.
pub(super) struct Finding {
    until: Until,
    paths: String,
    first: String,
    range: [f64; 2],
    found: Vec<(Found, [Option<Side>; 2])>,
    nearest: Option<Side>,
    is_whole: bool,
    /// Time of the search.
    seconds: f64,
}

/// The answer next to a value that was found, or at the nearest value.
struct Side {
    beside: Beside,
    answer: Answer,
}

impl Finding {
    /// Searches the range of a sweep.
    pub(super) fn of(sweep: &Sweep<'_>, input: &Input, until: Until, range: [f64; 2]) -> Result<Self, Failure> {
        let begin = Instant::now();
        let sweep::Finding { found, nearest, is_whole } = sweep.find(&until, MOST_WORK)?;
        let seconds = begin.elapsed().as_secs_f64();
        let length = input.scene.beam().length();
        let mut walk = sweep.walk();
        let mut side = |beside: Beside| {
            let start = Instant::now();
            let step = walk.solve(beside.value)?;
            let seconds = start.elapsed().as_secs_f64();
            let answer = Answer::without_grid(length, walk.row(step).solution, seconds);
            Ok::<Side, Failure>(Side { beside, answer })
        };
        let mut all = Vec::new();
        for found in found {
            let [below, above] = [found.below, found.above].map(|beside| beside.map(&mut side).transpose());
            all.push((found, [below?, above?]));
        }
        let nearest = nearest.map(side).transpose()?;
        let (paths, first) = (sweep.paths(), sweep.quantity().to_string());
        Ok(Self { until, paths, first, range, found: all, nearest, is_whole, seconds })
    }

    /// Whether the whole range was searched, at least one value was found, and all answers are certified.
    pub(super) fn is_certified(&self) -> bool {
        let mut sides = self.found.iter().flat_map(|(_, sides)| sides).flatten();
        self.is_whole && !self.found.is_empty() && sides.all(|side| side.answer.is_certified())
    }

    pub(super) fn json(&self, input: &Input) -> String {
        #[derive(Debug, Serialize)]
        struct FindingObject<'a> {
            #[serde(flatten)]
            scene: SceneObject<'a>,
            vary: &'a str,
            until: String,
            found: Vec<FoundObject<'a>>,
            /// Only if no value was found.
            #[serde(skip_serializing_if = "Option::is_none")]
            nearest: Option<SideObject<'a>>,
            /// Only if the search is incomplete.
            #[serde(skip_serializing_if = "Option::is_none")]
            stopped: Option<&'a str>,
        }
        #[derive(Debug, Serialize)]
        struct FoundObject<'a> {
            value: f64,
            #[serde(skip_serializing_if = "Option::is_none")]
            until: Option<f64>,
            uncertainty: f64,
            jumps: bool,
            below: Option<SideObject<'a>>,
            above: Option<SideObject<'a>>,
        }
        #[derive(Debug, Serialize)]
        struct SideObject<'a> {
            value: f64,
            reached: f64,
            #[serde(flatten)]
            route: RouteObject<'a>,
        }
        impl<'a> From<&'a Side> for SideObject<'a> {
            fn from(Side { beside, answer }: &'a Side) -> Self {
                Self { value: beside.value, reached: beside.reached, route: answer.into() }
            }
        }
        let found = self.found.iter().map(|(found, [below, above])| {
            let Found { value, until, uncertainty, jumps, .. } = *found;
            let [below, above] = [below, above].map(|side| side.as_ref().map(SideObject::from));
            FoundObject { value, until, uncertainty, jumps, below, above }
        });
        json::print(&FindingObject {
            scene: input.into(),
            vary: &self.paths,
            until: self.until.to_string(),
            found: found.collect(),
            nearest: self.nearest.as_ref().map(SideObject::from),
            stopped: (!self.is_whole).then_some(REASON),
        })
    }

    pub(super) fn text(&self, input: &Input) -> String {
        let labels = input.labels();
        let reason = match self.found.len() {
            1 => "1 value was found".to_owned(),
            count => format!("{count} values were found"),
        };
        let mut text = if self.found.is_empty() {
            heading("not found", &self.missed(), input)
        } else {
            heading(Status::of_several(self.is_certified()), &reason, input)
        };
        text += &list(&scene_lines(&input.scene, &labels));
        text.push('\n');
        let [from, to] = self.range.map(|value| labels.number(value));
        text += &list(&[
            ("varied", format!("{}, from {from} to {to}", varied(&self.paths))),
            ("looked for", self.until.to_string()),
            ("seconds", magnitude(self.seconds)),
        ]);
        if !self.is_whole {
            text += &list(&[("stopped", format!("there may be more values; {REASON}"))]);
        }
        if !self.found.is_empty() {
            text += "\nFound\n";
            text += &self.found.iter().map(|(found, _)| format!("  {}\n", said(found))).collect::<String>();
        }
        let outermost = outermost(input.scene.beam());
        let words = [self.first.clone(), self.reached()];
        let header: Row = words.into_iter().chain(header(&outermost, &labels)).collect();
        let of = |side: &Side| -> Row {
            let numbers = [side.beside.value, side.beside.reached].map(precise);
            numbers.into_iter().chain(row(&side.answer, &outermost, &labels)).collect()
        };
        let sides: Vec<Row> = self.found.iter().flat_map(|(_, sides)| sides).flatten().map(of).collect();
        if !sides.is_empty() {
            text += &table("Answers just below and just above", &header, &sides);
        }
        if let Some(nearest) = &self.nearest {
            text += &table("Nearest", &header, &[of(nearest)]);
        }
        text
    }

    /// The statement that no value was found.
    fn missed(&self) -> String {
        match self.until.measure {
            measure if measure.is_contact() => "contact neither begins nor ends".to_owned(),
            _ => format!("no value was found for which {}", self.until),
        }
    }

    /// The column heading of the measured quantity.
    fn reached(&self) -> String {
        match self.until.measure {
            Measure::Contact => "contact force, or minus the least clearance".to_owned(),
            Measure::Bearings => "least force of a bearing, or minus the largest clearance".to_owned(),
            measure => measure.to_string(),
        }
    }
}

/// A value with its uncertainty and remarks.
fn said(found: &Found) -> String {
    let mut text = precise(found.value);
    if 0.0 < found.uncertainty {
        text += &format!(" ± {}", magnitude(found.uncertainty));
    }
    match found.until {
        Some(until) => text + &format!(", and as far as {}: the quantity stays there", precise(until)),
        None if found.jumps => text + ": the quantity jumps past the number",
        None => text,
    }
}
