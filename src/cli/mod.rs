//! The command line: arguments in, table or JSON out. With `xtask` the only room that reads files, writes files or looks
//! at a clock.
//!
//! Exit codes: 0, an answer that is certified; 1, there is an answer and it is not; 2, bad input or usage, or
//! output that cannot be written. With 2 there is nothing on standard output and no file is written, unless it is standard output,
//! or a device, that fails: then files are already whole and in their places.

mod answer;
mod arguments;
mod busy;
mod certify;
mod compare;
mod csv;
mod files;
mod given;
mod held;
mod input;
mod json;
mod local;
mod output;
mod sweep;
mod table;
mod text;

use std::process::ExitCode;

use clap::{CommandFactory as _, Parser as _};
use palkki::adaptive::Request;
use palkki::plot::{self, Curves};
use palkki::route::Status;
use palkki::sweep::Sweep;
use palkki::verdict::Demand;

use self::answer::{Answer, Route};
use self::arguments::{Arguments, Command, Common, Format, Solve};
use self::files::Files;
use self::input::Input;
use self::local::Local;
use self::output::{Failure, Stream};

const CERTIFIED: u8 = 0;
const NOT_CERTIFIED: u8 = 1;
const FAILED: u8 = 2;

/// Runs the program on the arguments that it was started with.
pub(crate) fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        // `--help` and `--version` come this way too, with exit code 0; a usage error has 2.
        Err(message) => return finish_with_message(&message),
    };
    let done = match &arguments.command {
        Command::Solve(arguments) => solve(arguments),
        Command::Compare(arguments) => compare(arguments),
        Command::Certify(arguments) => certify(arguments),
        Command::Sweep(arguments) => sweep(arguments),
    };
    match done {
        Ok(code) => ExitCode::from(code),
        Err(Failure::Usage { command, kind, message }) => {
            let mut program = Arguments::command();
            program.build();
            let message = match program.find_subcommand_mut(command) {
                Some(command) => command.error(kind, message),
                None => program.error(kind, message),
            };
            finish_with_message(&message)
        }
        Err(failure) => {
            output::complain(&failure);
            ExitCode::from(FAILED)
        }
    }
}

fn finish_with_message(message: &clap::Error) -> ExitCode {
    // Nobody is left to tell if this does not reach anybody; help that was asked for and not given is no success.
    let code = if message.print().is_ok() { u8::try_from(message.exit_code()).unwrap_or(FAILED) } else { FAILED };
    ExitCode::from(code)
}

fn solve(arguments: &Solve) -> Result<u8, Failure> {
    let route = arguments.route()?;
    let input = Input::read(&arguments.common.scene)?;
    let mut files = Files::default();
    // Before the work, so that a bad name is not found out about after it.
    for path in [&arguments.csv, &arguments.plot].into_iter().flatten() {
        files.reserve(path, &input)?;
    }
    let scene = arguments.common.scene.display();
    let answer = busy::telling(format!("solving {scene}"), || Answer::of(&input, route))?;
    if let Some(path) = &arguments.csv {
        files.stage(path, csv::table(&input.scene, &answer))?;
    }
    if let Some(path) = &arguments.plot {
        files.stage(path, figure(&input, &answer)?)?;
    }
    let local = Local::of(&input.scene, &answer, arguments);
    let text = match arguments.common.format {
        Format::Text => text::solve(&input, &answer, arguments.nodes) + &local.text(&input),
        Format::Json => json::solve(&input, &answer, arguments.nodes, &local),
    };
    let stream = files.stream_of_answer();
    files.publish()?;
    output::print(stream, &text)?;
    Ok(if answer.solution.verdict.status == Status::Certified { CERTIFIED } else { NOT_CERTIFIED })
}

/// The figure of `--plot`.
fn figure(input: &Input, answer: &Answer) -> Result<String, Failure> {
    let curves = match &answer.solution.exact {
        Some(exact) => Curves::exact(&input.scene, exact),
        None => Curves::of(&input.scene, &answer.solution.state)?,
    };
    let subtitle = match answer.intervals {
        Some(intervals) => format!("{} method, {}, {intervals} intervals", answer.method, answer.solver),
        None => "beam theory".to_owned(),
    };
    Ok(plot::curves(&input.scene, &curves, &subtitle)?)
}

fn compare(arguments: &arguments::Compare) -> Result<u8, Failure> {
    let Common { scene, format } = &arguments.common;
    let input = Input::read(scene)?;
    let what = format!("comparing all routes for {} on {} intervals", scene.display(), arguments.intervals);
    let comparison = busy::telling(what, || compare::Comparison::of(&input, arguments.intervals))?;
    output::print(
        Stream::Output,
        &match format {
            Format::Text => compare::text(&input, &comparison),
            Format::Json => json::compare(&input, &comparison),
        },
    )?;
    let certified = comparison.routes.iter().any(|route| route.answer.solution.verdict.status == Status::Certified);
    Ok(if certified { CERTIFIED } else { NOT_CERTIFIED })
}

fn certify(arguments: &arguments::Certify) -> Result<u8, Failure> {
    let Common { scene, format } = &arguments.common;
    let input = Input::read(scene)?;
    let what = format!("certifying {}", arguments.forces.display());
    let finding = busy::telling(what, || certify::Finding::of(&input, arguments))?;
    output::print(
        Stream::Output,
        &match format {
            Format::Text => certify::text(&input, &finding),
            Format::Json => json::certify(&input, &finding),
        },
    )?;
    Ok(if finding.verdict.status == Status::Certified { CERTIFIED } else { NOT_CERTIFIED })
}

fn sweep(arguments: &arguments::Sweep) -> Result<u8, Failure> {
    let arguments::Sweep { common: Common { scene, format }, vary, from, to, steps, csv, plot } = arguments;
    let input = Input::read(scene)?;
    let varied = Sweep::new(&input.scene, vary, [*from, *to], *steps)?;
    let mut files = Files::default();
    for path in [csv, plot].into_iter().flatten() {
        files.reserve(path, &input)?;
    }
    let what = format!("sweeping {} for {}", varied.quantity(), scene.display());
    let swept = busy::telling(what, || sweep::Swept::of(&varied, input.scene.beam().length()))?;
    if let Some(path) = csv {
        files.stage(path, swept.csv())?;
    }
    if let Some(path) = plot {
        files.stage(path, swept.figure(&input)?)?;
    }
    let text = match format {
        Format::Text => swept.text(&input),
        Format::Json => swept.json(&input),
    };
    let stream = files.stream_of_answer();
    files.publish()?;
    output::print(stream, &text)?;
    Ok(if swept.is_certified() { CERTIFIED } else { NOT_CERTIFIED })
}

impl Solve {
    /// The route that the arguments ask for; an option that would have no effect is refused.
    fn route(&self) -> Result<Route, Failure> {
        let refuse = |option: &str| {
            let message = format!("--{option} belongs to a discretised method; --method exact has no use for it");
            Err(Failure::Usage { command: "solve", kind: clap::error::ErrorKind::ArgumentConflict, message })
        };
        let Some(method) = self.method.discretised() else {
            return match self {
                Self { solver: Some(_), .. } => refuse("solver"),
                Self { intervals: Some(_), .. } => refuse("intervals"),
                Self { nodes: true, .. } => refuse("nodes"),
                _ => Ok(Route::Exact(self.tolerance.map_or_else(Demand::default, Demand::of_error))),
            };
        };
        let of_theory = [("derivatives", self.derivatives), ("depth-tolerance", self.depth_tolerance.is_some())];
        if let Some((option, _)) = of_theory.into_iter().find(|(_, asked)| *asked) {
            let message = format!("--{option} belongs to --method exact; a discretised method has no use for it");
            return Err(Failure::Usage { command: "solve", kind: clap::error::ErrorKind::ArgumentConflict, message });
        }
        let written = [("nodes", self.nodes), ("csv", self.csv.is_some()), ("plot", self.plot.is_some())];
        if let Some(intervals) = self.intervals.filter(|intervals| arguments::MOST_INTERVALS_WRITTEN < *intervals)
            && let Some((option, _)) = written.into_iter().find(|(_, asked)| *asked)
        {
            let most = arguments::MOST_INTERVALS_WRITTEN;
            let message = format!("--{option} takes at most {most} intervals, but --intervals is {intervals}");
            return Err(Failure::Usage { command: "solve", kind: clap::error::ErrorKind::ArgumentConflict, message });
        }
        let solver = self.solver.map_or(arguments::DEFAULT_SOLVER, |solver| solver.0);
        if let Self { intervals: None, tolerance: Some(error), .. } = *self {
            return Ok(Route::Adaptive(Request::new(method, solver, error)));
        }
        Ok(Route::Discretised(palkki::Settings {
            method,
            solver,
            intervals: self.intervals.unwrap_or(arguments::DEFAULT_INTERVALS),
            tolerance: self.tolerance.unwrap_or(palkki::DEFAULT_TOLERANCE),
        }))
    }
}
