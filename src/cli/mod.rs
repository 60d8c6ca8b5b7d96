//! The command line: arguments in, table or JSON out. Only this part and `xtask` read files, write files or use a clock.
//!
//! Exit codes: 0, the answer is certified; 1, the answer is not certified, or `find` finds no value; 2, invalid input or usage, or
//! output that cannot be written. With code 2, standard output is empty and no file is written. The exception is a failure of
//! standard output or of a device: the files are then already complete and in place.

mod answer;
mod arguments;
mod body;
mod busy;
mod certify;
mod compare;
mod csv;
mod explain;
mod export;
mod files;
mod find;
mod given;
mod held;
mod input;
mod json;
mod local;
mod numbers;
mod output;
mod pages;
mod qps;
mod sweep;
mod table;
mod text;
mod values;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{CommandFactory as _, Parser as _};
use palkki::adaptive::Request;
use palkki::body::Body;
use palkki::plot::{self, Curves};
use palkki::route::Status;
use palkki::sweep::{Sweep, Until};
use palkki::text::Results;
use palkki::verdict::Demand;

use self::answer::{Answer, Route};
use self::arguments::{Arguments, Command, Common, Format, SceneArgument, Solve, Varied};
use self::files::Files;
use self::input::{Input, Loads, Read};
use self::local::Local;
use self::output::Failure;

/// Exit code: the requested answer is certified.
const CERTIFIED: u8 = 0;
/// Exit code: there is an answer, but it is not certified.
const NOT_CERTIFIED: u8 = 1;
/// Exit code: there is no answer.
const FAILED: u8 = 2;

/// The reason why a body cannot be swept.
const NOTHING_TO_VARY: &str = "a [body] has no number that could be varied";

/// Runs the program with its command-line arguments.
pub(crate) fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        // `--help` and `--version` also end here, with exit code 0; a usage error has code 2.
        Err(message) => return finish_with_message(&message),
    };
    let done = match &arguments.command {
        Command::Solve(arguments) => solve(arguments),
        Command::Compare(arguments) => compare(arguments),
        Command::Certify(arguments) => certify(arguments),
        Command::Sweep(arguments) => sweep(arguments),
        Command::Find(arguments) => find(arguments),
        Command::Explain(arguments) => explain(arguments),
        Command::Export(arguments) => export(arguments),
        Command::Completions { shell } => pages::completions(*shell),
        Command::Manual { command } => pages::manual(command.as_deref()),
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
    // An error on standard error cannot be reported. If help cannot be printed, the program fails.
    let open = if message.use_stderr() { Ok(()) } else { output::can_be_written() };
    let printed = open.and_then(|()| output::unless_closed(message.print()));
    let code = if printed.is_ok() { u8::try_from(message.exit_code()).unwrap_or(FAILED) } else { FAILED };
    ExitCode::from(code)
}

/// The result of a subcommand.
struct Outcome<'a> {
    /// The text to print.
    text: String,
    /// The files requested by options.
    files: Vec<Option<(&'a PathBuf, String)>>,
    /// Whether an answer passed our own check; for a sweep, whether all answers passed.
    is_certified: bool,
}

/// Reads the scene, does the work, writes the files at `places` and prints the answer. Returns the exit code of the answer. `what` is
/// printed if the work needs long.
fn run_on_scene<'a>(
    (scene, loads): (&SceneArgument, Loads),
    format: Format,
    what: String,
    places: &[&Option<PathBuf>],
    on_beam: impl FnOnce(&Input) -> Result<Outcome<'a>, Failure>,
    on_body: impl FnOnce(&Input<Body>) -> Result<Outcome<'a>, Failure>,
) -> Result<u8, Failure> {
    let read = Read::scene(&scene.path, Results::with_digits(scene.digits), loads)?;
    let mut files = Files::default();
    // Before the work, so that an invalid path is reported at once.
    for path in places.iter().copied().flatten() {
        files.reserve(path, read.files())?;
    }
    let outcome = busy::telling(what, || match &read {
        Read::Beam(input) => on_beam(input),
        Read::Body(input) => on_body(input),
    })?;
    for (path, text) in outcome.files.into_iter().flatten() {
        files.stage(path, text)?;
    }
    let stream = files.stream_of_answer();
    files.publish()?;
    match format {
        Format::Text => output::print_coloured(stream, &outcome.text)?,
        Format::Json => output::print(stream, &outcome.text)?,
    }
    Ok(if outcome.is_certified { CERTIFIED } else { NOT_CERTIFIED })
}

impl Common {
    /// The text to print, as a table or as JSON.
    fn shown(&self, text: impl FnOnce() -> String, json: impl FnOnce() -> String) -> String {
        match self.format {
            Format::Text => text(),
            Format::Json => json(),
        }
    }
}

fn solve(arguments: &Solve) -> Result<u8, Failure> {
    let Solve { common, csv, plot, proof, nodes, .. } = arguments;
    let what = format!("solving {}", input::called(&common.scene.path));
    let on_beam = |input: &Input| {
        let answer = Answer::of(input, arguments.route()?)?;
        let local = Local::of(&input.scene, &answer, arguments);
        let csv = csv.as_ref().map(|path| (path, csv::table(&input.scene, &answer)));
        let plot = plot.as_ref().map(|path| Ok::<_, Failure>((path, figure(input, &answer)?))).transpose()?;
        let proof = proof.as_ref().map(|path| Ok::<_, Failure>((path, answer.proof(input)?.json()))).transpose()?;
        let text = common.shown(
            || text::solve(input, &answer, *nodes) + &local.text(input),
            || json::solve(input, &answer, *nodes, &local),
        );
        Ok(Outcome { text, files: vec![csv, plot, proof], is_certified: answer.is_certified() })
    };
    let places = [csv, plot, proof];
    run_on_scene((&common.scene, Loads::OnBeam), common.format, what, &places, on_beam, |input| {
        body::solve(input, arguments)
    })
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
    let arguments::Compare { common, intervals } = arguments;
    let what = format!("comparing all routes for {} on {intervals} intervals", input::called(&common.scene.path));
    let on_beam = |input: &Input| {
        let found = compare::Comparison::of(input, *intervals)?;
        let text = common.shown(|| compare::text(input, &found), || json::compare(input, &found));
        Ok(Outcome { text, files: Vec::new(), is_certified: found.is_certified() })
    };
    run_on_scene((&common.scene, Loads::OnBeam), common.format, what, &[], on_beam, |input| {
        Ok(body::compare(input, common))
    })
}

fn certify(arguments: &arguments::Certify) -> Result<u8, Failure> {
    let common = &arguments.common;
    if [&common.scene.path, &arguments.forces].into_iter().all(|path| input::is_standard(path)) {
        let message = "the scene and the contact forces cannot both be read from standard input";
        return Err(Failure::refused("certify", message));
    }
    let what = format!("certifying {}", input::called(&arguments.forces));
    let on_beam = |input: &Input| {
        let found = certify::Finding::of(input, arguments)?;
        let text = common.shown(|| certify::text(input, &found), || json::certify(input, &found));
        Ok(Outcome { text, files: Vec::new(), is_certified: found.verdict.status == Status::Certified })
    };
    run_on_scene((&common.scene, Loads::OnBeam), common.format, what, &[], on_beam, |input| {
        body::certify(input, arguments)
    })
}

fn sweep(arguments: &arguments::Sweep) -> Result<u8, Failure> {
    let arguments::Sweep { common, varied: Varied { vary, from, to }, steps, at, envelope, csv, plot } = arguments;
    let what = format!("sweeping {vary} for {}", input::called(&common.scene.path));
    let on_beam = |input: &Input| {
        let sweep = Sweep::new(&input.scene, vary, [*from, *to], *steps)?;
        let length = input.scene.beam().length();
        if let Some(x) = at.iter().find(|x| !(0.0..=length).contains(*x)) {
            return Err(Failure::refused(
                "sweep",
                format!("--at must lie on the beam, between 0 and {length}, but is {x}"),
            ));
        }
        let swept = sweep::Swept::of(&sweep, length, at, *envelope)?;
        let csv = csv.as_ref().map(|path| (path, swept.csv()));
        let plot = plot.as_ref().map(|path| Ok::<_, Failure>((path, swept.figure(input)?))).transpose()?;
        let text = common.shown(|| swept.text(input), || swept.json(input));
        Ok(Outcome { text, files: vec![csv, plot], is_certified: swept.is_certified() })
    };
    run_on_scene((&common.scene, Loads::Anywhere), common.format, what, &[csv, plot], on_beam, |_| {
        Err(Failure::refused("sweep", NOTHING_TO_VARY))
    })
}

fn find(arguments: &find::Find) -> Result<u8, Failure> {
    let find::Find { common, varied: Varied { vary, from, to }, until } = arguments;
    let what = format!("searching {vary} for {}", input::called(&common.scene.path));
    let on_beam = |input: &Input| {
        let until = Until::parse(until, &input.scene).map_err(|error| Failure::refused("find", error.to_string()))?;
        let sweep = Sweep::new(&input.scene, vary, [*from, *to], 2)?;
        let finding = find::Finding::of(&sweep, input, until, [*from, *to])?;
        let text = common.shown(|| finding.text(input), || finding.json(input));
        Ok(Outcome { text, files: Vec::new(), is_certified: finding.is_certified() })
    };
    run_on_scene((&common.scene, Loads::Anywhere), common.format, what, &[], on_beam, |_| {
        Err(Failure::refused("find", NOTHING_TO_VARY))
    })
}

fn explain(arguments: &explain::Explain) -> Result<u8, Failure> {
    let explain::Explain { scene, format } = arguments;
    let what = format!("explaining {}", input::called(&scene.path));
    let on_beam = |input: &Input| {
        let answer = Answer::of(input, Route::Exact(Demand::default()))?;
        let text = explain::text(input, &answer, *format);
        Ok(Outcome { text, files: Vec::new(), is_certified: answer.is_certified() })
    };
    run_on_scene((scene, Loads::OnBeam), Format::Text, what, &[], on_beam, |_| {
        Err(Failure::refused("explain", "the equations are those of a beam"))
    })
}

fn export(arguments: &arguments::Export) -> Result<u8, Failure> {
    let failed = |error| Failure::Write { path: arguments.to.clone(), error };
    let is_new = !arguments.to.exists();
    std::fs::create_dir_all(&arguments.to).map_err(failed)?;
    let (places, common) = (arguments.places(), &arguments.common);
    let what = format!("exporting {}", input::called(&common.scene.path));
    let places_of_files: Vec<_> = places.iter().collect();
    let on_beam = |input: &Input| export::export(input, arguments, &places);
    let on_body = |_: &Input<Body>| Err(Failure::refused("export", "a scene with a [body] is one of matrices already"));
    let done = run_on_scene((&common.scene, Loads::OnBeam), common.format, what, &places_of_files, on_beam, on_body);
    if is_new && done.is_err() {
        // The folder is empty. An error when removing it changes nothing.
        let _ = std::fs::remove_dir(&arguments.to);
    }
    done
}

impl Solve {
    /// The route that the arguments request. An option without effect is rejected.
    fn route(&self) -> Result<Route, Failure> {
        let refused = |message: String| Failure::refused("solve", message);
        let asked = |options: &[(&'static str, bool)]| options.iter().find(|(_, asked)| *asked).map(|(name, _)| *name);
        let Some(method) = self.method.discretised() else {
            let of_grids =
                [("solver", self.solver.is_some()), ("intervals", self.intervals.is_some()), ("nodes", self.nodes)];
            return match asked(&of_grids) {
                Some(option) => Err(refused(format!(
                    "--{option} belongs to a discretised method; --method exact has no use for it"
                ))),
                None => Ok(Route::Exact(self.tolerance.map_or_else(Demand::default, Demand::of_error))),
            };
        };
        let of_theory = [("derivatives", self.derivatives), ("depth-tolerance", self.depth_tolerance.is_some())];
        if let Some(option) = asked(&of_theory) {
            return Err(refused(format!(
                "--{option} belongs to --method exact; a discretised method has no use for it"
            )));
        }
        let written = [("nodes", self.nodes), ("csv", self.csv.is_some()), ("plot", self.plot.is_some())];
        if let Some(intervals) = self.intervals.filter(|intervals| arguments::MOST_INTERVALS_WRITTEN < *intervals)
            && let Some(option) = asked(&written)
        {
            let most = arguments::MOST_INTERVALS_WRITTEN;
            return Err(refused(format!("--{option} takes at most {most} intervals, but --intervals is {intervals}")));
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
