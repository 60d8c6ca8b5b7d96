//! The command `sweep`: one number of the scene varied, as a table, CSV, JSON or a figure.

use std::time::Instant;

use palkki::plot;
use palkki::route::Status;
use palkki::scene::{Beam, Quantity};
use palkki::state::Contact;
use palkki::sweep::{
    AtPlace, Envelope, Event, Events, Governing, MOST_WORK, Moment, SupportEnvelope, Sweep, SweepError, Walk,
};
use palkki::text::{magnitude, significant};

use super::answer::Answer;
use super::csv::field;
use super::given::scene_lines;
use super::input::Input;
use super::json::{self, SceneObject};
use super::output::Failure;
use super::table::{Labels, MOST_ROWS, Row, list, table};
use super::text::titled;

/// About this many rows are shown in a table if there are more.
const SHOWN: usize = 41;

/// Digits of the value of an event.
const DIGITS: usize = 12;

/// Digits of the value from which on there are answers.
const DIGITS_OF_BORDER: usize = 6;

/// The result of a sweep.
pub(super) struct Swept {
    quantity: Quantity,
    /// The paths of all varied numbers.
    paths: String,
    rows: Vec<SweptRow>,
    events: Vec<Event>,
    envelope: Option<Envelope>,
    /// Where and why the sweep is incomplete.
    stopped: Option<Stopped>,
    /// Number of values for which the beam buckles.
    buckled: usize,
    /// Time of all answers with their certificates, and of the events.
    seconds: [f64; 2],
}

/// A value with its answer, and the results at the positions of `--at`.
pub(super) struct SweptRow {
    pub(super) value: f64,
    pub(super) answer: Answer,
    pub(super) at: Vec<AtPlace>,
}

/// The extent of a sweep that reached its work limit or has values without an answer.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub(super) struct Stopped {
    /// Number of values with an answer.
    rows: usize,
    /// Number of values requested.
    of: usize,
    /// The events are complete up to this value.
    events_until: Option<f64>,
    /// The reason.
    reason: String,
}

/// Intervals of values without an answer.
#[derive(Debug, Default)]
struct Gaps {
    /// The reason why the first of these values has no answer.
    first: Option<SweepError>,
    /// The end of the first interval, if it ends.
    until: Option<f64>,
    /// The last value without an answer, if the value after it is not known to have one.
    open: Option<f64>,
    /// Number of intervals.
    count: usize,
    /// Number of values for which the beam buckles.
    buckled: usize,
}

impl Gaps {
    fn add(&mut self, value: f64, error: SweepError) {
        self.buckled += usize::from(error.buckles());
        self.first.get_or_insert(error);
        self.count += usize::from(self.open.is_none());
        self.open = Some(value);
    }

    /// Ends the interval: this value has an answer.
    fn end(&mut self, walk: &Walk<'_>, value: f64) {
        if let Some(without) = self.open.take() {
            self.until.get_or_insert_with(|| walk.border(value, without));
        }
    }

    /// The reason in words; none if every value has an answer.
    fn reason(&self) -> Option<String> {
        let from = |value: f64| format!("; there are answers from {} on", significant(value + 0.0, DIGITS_OF_BORDER));
        let until = self.until.map_or_else(String::new, from);
        let more = match self.count {
            0 | 1 => String::new(),
            2 => ", but for 1 more stretch of values".to_owned(),
            count => format!(", but for {} more stretches of values", count - 1),
        };
        Some(format!("{}{until}{more}", self.first.as_ref()?))
    }
}

/// Why a sweep is incomplete, and what to do.
pub(super) const REASON: &str =
    "the work that one sweep may take is done: a shorter range, fewer values or a simpler scene take less";

impl Swept {
    /// The answers of a sweep over a beam of this length, for all values that have one; an error if none has.
    pub(super) fn of(sweep: &Sweep<'_>, length: f64, places: &[f64], envelope: bool) -> Result<Self, Failure> {
        let begin = Instant::now();
        let mut walk = sweep.walk();
        let (mut rows, mut beside) = (Vec::new(), Vec::new());
        let mut gaps = Gaps::default();
        let mut gathered = envelope.then(|| sweep.gathered());
        for value in sweep.values() {
            if MOST_WORK < walk.work() {
                break;
            }
            let start = Instant::now();
            match walk.solve(value) {
                Ok(step) => {
                    gaps.end(&walk, value);
                    let at: Vec<AtPlace> = places.iter().map(|x| step.at(*x)).collect();
                    beside.push((at, start.elapsed().as_secs_f64()));
                    if let Some(gathered) = &mut gathered {
                        gathered.add(&step);
                    }
                    rows.push(walk.row(step));
                }
                Err(error) => gaps.add(value, error),
            }
        }
        if rows.is_empty()
            && let Some(error) = gaps.first
        {
            return Err(error.into());
        }
        // The work that the rows left over.
        let work = MOST_WORK.saturating_sub(walk.work());
        let (envelope, refined) = gathered.map_or((None, true), |gathered| gathered.envelope_within(work));
        let solved = begin.elapsed().as_secs_f64();
        let kinds: Vec<_> = rows.iter().map(|row| (row.value, row.pattern.clone())).collect();
        let Events { events, until } = sweep.events_within(&kinds, MOST_WORK);
        let of = sweep.values().len();
        // Buckling counts as an answer: an event gives the value.
        let stopped = (rows.len() + gaps.buckled < of || until.is_some() || !refined).then_some(Stopped {
            rows: rows.len(),
            of,
            events_until: until,
            reason: gaps.reason().unwrap_or_else(|| REASON.to_owned()),
        });
        let seconds = [solved, begin.elapsed().as_secs_f64() - solved];
        let rows = rows.into_iter().zip(beside).map(|(row, (at, time))| {
            let answer = Answer::without_grid(length, row.solution, time);
            SweptRow { value: row.value, answer, at }
        });
        let (quantity, paths, rows) = (sweep.quantity(), sweep.paths(), rows.collect());
        Ok(Self { quantity, paths, rows, events, envelope, stopped, buckled: gaps.buckled, seconds })
    }

    /// Whether every value for which the beam does not buckle has an answer, and every answer is certified.
    pub(super) fn is_certified(&self) -> bool {
        self.stopped.is_none() && self.rows.iter().all(|row| row.answer.is_certified())
    }

    pub(super) fn json(&self, input: &Input) -> String {
        let Self { paths, rows, events, envelope, stopped, .. } = self;
        let scene = SceneObject { scene: input.title(), warnings: &self.warnings(input) };
        json::sweep(scene, paths, rows, events, envelope.as_ref(), stopped.as_ref())
    }

    fn warnings(&self, input: &Input) -> Vec<String> {
        Answer::warnings_of(self.rows.iter().map(|row| &row.answer), input)
    }

    pub(super) fn figure(&self, input: &Input) -> Result<String, Failure> {
        if let Some(envelope) = &self.envelope {
            return Ok(plot::envelope(&input.scene, &self.paths, envelope)?);
        }
        let rows: Vec<_> = self.rows.iter().map(|row| (row.value, &row.answer.solution.state)).collect();
        Ok(plot::sweep(&input.scene, self.quantity, &rows, &self.events, "")?)
    }

    pub(super) fn text(&self, input: &Input) -> String {
        let labels = input.labels();
        let certified = self.rows.iter().filter(|row| row.answer.is_certified()).count();
        let ends = [self.rows.first(), self.rows.last()]
            .map(|row| row.map_or_else(String::new, |row| labels.number(row.value)));
        let [rows, events] = self.seconds.map(magnitude);
        let status = Status::of_several(self.is_certified());
        let varied = varied(&self.paths);
        let of = self.stopped.as_ref().map_or(self.rows.len(), |stopped| stopped.of);
        let ended = if self.stopped.is_some() { " are certified, and the sweep is not whole" } else { "" };
        let mut text = titled(status, &format!("{certified} of {of} answers{ended}"), input, &self.warnings(input));
        text += &list(&scene_lines(&input.scene, &labels));
        text.push('\n');
        text += &list(&[
            ("varied", format!("{varied}, {} values from {} to {}", self.rows.len(), ends[0], ends[1])),
            ("seconds", format!("{rows} for the answers with their bounds, {events} for the events")),
        ]);
        if let Some(Stopped { rows, of, events_until, reason }) = &self.stopped {
            let events =
                events_until.map_or_else(String::new, |value| format!(", events up to {}", labels.number(value)));
            text += &list(&[("stopped", format!("{rows} of {of} values have an answer{events}; {reason}"))]);
        }
        if 0 < self.buckled && self.stopped.is_none() {
            text += &list(&[("buckles", format!("for {} more values, which have no answer", self.buckled))]);
        }
        if self.events.is_empty() {
            text += "\nEvents: none found\n";
        } else {
            text += "\nEvents\n";
            let lines = self.events.iter().map(|event| (known(event), event.what.clone()));
            text += &list(&lines.collect::<Vec<_>>());
        }
        if let Some(envelope) = &self.envelope {
            text += &envelope_text(envelope, &labels);
        }
        let outermost = outermost(input.scene.beam());
        let header: Row = std::iter::once(self.quantity.to_string()).chain(header(&outermost, &labels)).collect();
        let step = self.rows.len().div_ceil(SHOWN);
        let last = self.rows.len() - 1;
        let shown = || self.rows.iter().enumerate().filter(|(i, _)| i % step == 0 || *i == last).map(|(_, row)| row);
        let of = |swept: &SweptRow| {
            let cells = row(&swept.answer, &outermost, &labels);
            std::iter::once(labels.number(swept.value)).chain(cells).collect()
        };
        let rows: Vec<Row> = shown().map(of).collect();
        let title = match rows.len() {
            all if all == self.rows.len() => "Answers".to_owned(),
            some => format!("Answers, {some} of {}; --csv and --format json have all", self.rows.len()),
        };
        text += &table(&title, &header, &rows);
        for k in 0..self.rows.first().map_or(0, |row| row.at.len()) {
            text += &self.at_place(shown().filter_map(|row| Some((row.value, row.at.get(k)?))), &labels);
        }
        text
    }

    /// The results at one position, row by row.
    fn at_place<'a>(&self, rows: impl Iterator<Item = (f64, &'a AtPlace)> + Clone, labels: &Labels) -> String {
        let x = rows.clone().next().map_or(0.0, |(_, place)| place.x);
        let of = |(value, place): (f64, &AtPlace)| -> Row {
            let AtPlace { deflection, slope, moment, shear, .. } = *place;
            [value, deflection, slope]
                .into_iter()
                .chain(moment)
                .chain(shear)
                .map(|number| labels.number(number))
                .collect()
        };
        let header = [
            self.quantity.to_string(),
            labels.length.name("deflection"),
            "slope".to_owned(),
            labels.moment.name("moment left"),
            labels.moment.name("moment right"),
            labels.force.name("shear left"),
            labels.force.name("shear right"),
        ];
        table(&format!("At x = {}", labels.length.value(x)), &header, &rows.map(of).collect::<Vec<_>>())
    }

    /// One row for each value. Supports and contacts are numbered from left to right; contacts that a row does not have are empty.
    pub(super) fn csv(&self) -> String {
        if let Some(envelope) = &self.envelope {
            return envelope_csv(envelope);
        }
        let states = || self.rows.iter().map(|row| &row.answer.solution.state);
        // All rows have the same supports.
        let supports = states().next().map_or(0, |state| state.supports.len());
        let contacts = states().map(|state| state.contacts.len()).max().unwrap_or(0);
        let mut header = String::from(
            "value,status,regime,contact_force,deflection_max,deflection_max_at,moment_max,moment_max_at,moment_min,\
             moment_min_at,energy,deflection_error",
        );
        header.extend((1..=supports).map(|i| format!(",support_{i}_at,support_{i}_force")));
        header.extend((1..=contacts).map(|i| format!(",contact_{i}_from,contact_{i}_to,contact_{i}_force")));
        let places = self.rows.first().map_or(0, |row| row.at.len());
        header.extend((1..=places).map(|i| {
            let names = ["x", "deflection", "slope", "moment_left", "moment_right", "shear_left", "shear_right"];
            names.map(|name| format!(",at_{i}_{name}")).concat()
        }));
        let mut text = header + "\n";
        for SweptRow { value, answer, at } in &self.rows {
            let (state, verdict) = (&answer.solution.state, &answer.solution.verdict);
            let error = verdict.certificate.as_ref().map_or(f64::INFINITY, |c| c.deflection_error);
            let (v, m) = (state.deflection, state.moment);
            let numbers =
                [state.contact_force(), v.max, v.max_at, m.max, m.max_at, m.min, m.min_at, state.energy, error];
            let mut cells = vec![field(*value), verdict.status.to_string(), state.regime.name().to_owned()];
            cells.extend(numbers.map(field));
            cells.extend(state.supports.iter().flat_map(|s| [s.at, s.force]).map(field));
            cells.extend(
                state.contacts.iter().flat_map(|&Contact { from, to, force, .. }| [from, to, force]).map(field),
            );
            cells.resize(12 + 2 * supports + 3 * contacts, String::new());
            cells.extend(at.iter().flat_map(|&AtPlace { x, deflection, slope, moment, shear }| {
                [x, deflection, slope, moment[0], moment[1], shear[0], shear[1]].map(field)
            }));
            text += &(cells.join(",") + "\n");
        }
        text
    }
}

/// The varied numbers in words.
pub(super) fn varied(paths: &str) -> String {
    match paths.split_once(',') {
        Some((first, others)) => format!("{first}, and by as much {}", others.replace(',', ", ")),
        None => paths.to_owned(),
    }
}

/// The governing moments and the reactions.
fn envelope_text(envelope: &Envelope, labels: &Labels) -> String {
    let Governing { moment_max, moment_min } = &envelope.governing;
    let moment = |moment: &Moment| {
        let at = format!("at x = {} for the value", labels.length.value(moment.at));
        let [left, right] = moment.shear.map(|shear| labels.force.value(shear));
        let shear = format!("shear force {left} on its left and {right} on its right");
        let supports = moment.supports.iter().take(MOST_ROWS).map(|force| labels.number(*force)).collect::<Vec<_>>();
        let supports = if supports.is_empty() { String::new() } else { format!(", supports {}", supports.join(", ")) };
        let value = labels.number(moment.value);
        format!("{} {at} {value}, with {shear}{supports}", labels.moment.value(moment.moment))
    };
    let governing = [("largest moment", moment(moment_max)), ("least moment", moment(moment_min))];
    let mut text = String::from("\nEnvelope\n") + &list(&governing);
    if !envelope.supports.is_empty() {
        let header = ["support at", "largest force", "for the value", "least force", "for the value"];
        let row = |support: &SupportEnvelope| {
            let SupportEnvelope { at, max, max_value, min, min_value } = *support;
            [at, max, max_value, min, min_value].map(|number| labels.number(number)).to_vec()
        };
        text += &table("Supports over all values", &header, &envelope.supports.iter().map(row).collect::<Vec<_>>());
    }
    text
}

/// One row for each position.
fn envelope_csv(envelope: &Envelope) -> String {
    let Envelope { x, moment_max, moment_min, shear_max, shear_min, .. } = envelope;
    let rows =
        (0..x.len()).map(|i| [x[i], moment_max[i], moment_min[i], shear_max[i], shear_min[i]].map(field).join(","));
    let header = "x,moment_max,moment_min,shear_max,shear_min".to_owned();
    std::iter::once(header).chain(rows).map(|row| row + "\n").collect()
}

/// The value of an event with its uncertainty.
fn known(event: &Event) -> String {
    let value = significant(event.value, DIGITS);
    if 0.0 < event.uncertainty { format!("{value} ± {}", magnitude(event.uncertainty)) } else { value }
}

/// The first and the last support, whose reactions the table shows, with name and index.
pub(super) fn outermost(beam: &Beam) -> Vec<(&'static str, usize)> {
    match beam.all_supports()[..] {
        [] => Vec::new(),
        [_] => vec![("support", 0)],
        [first, .., last] => {
            let at_ends = first.at <= 0.0 && beam.length() <= last.at;
            let names = if at_ends { ["left", "right"] } else { ["first support", "last support"] };
            vec![(names[0], 0), (names[1], beam.all_supports().len() - 1)]
        }
    }
}

/// The column headings of an answer.
pub(super) fn header(outermost: &[(&str, usize)], labels: &Labels) -> Row {
    let mut header = ["status", "regime", "contacts"].map(str::to_owned).to_vec();
    header.push(labels.force.name("contact"));
    header.extend(outermost.iter().map(|(name, _)| labels.force.name(name)));
    header.extend([labels.length.name("deflection"), labels.moment.name("moment"), labels.moment.name("least moment")]);
    header
}

/// The cells of an answer below these headings.
pub(super) fn row(answer: &Answer, outermost: &[(&str, usize)], labels: &Labels) -> Row {
    let state = &answer.solution.state;
    let mut cells = vec![
        answer.solution.verdict.status.to_string(),
        state.regime.name().to_owned(),
        state.contacts.len().to_string(),
    ];
    cells.push(labels.number(state.contact_force()));
    // Two supports that come too close in a sweep are an error, so each row has all of them.
    cells.extend(
        outermost.iter().map(|&(_, i)| state.supports.get(i).map_or_else(String::new, |s| labels.number(s.force))),
    );
    cells.extend([state.deflection.max, state.moment.max, state.moment.min].map(|value| labels.number(value)));
    cells
}
