//! The tasks of the repository that need the library: `cargo xtask report`, `certificates`, `measure`, `mutants`, `fuzz` and `hostile`.
#![expect(clippy::print_stderr, clippy::print_stdout, reason = "a command that talks to a person")]

mod certificates;
mod data;
mod fuzz;
mod hostile;
mod measure;
mod mutants;
mod report;
mod scenes;
mod table;
mod text;

use std::path::Path;
use std::process::ExitCode;

use clap::Parser;

/// Why a task did not do what it was to do.
pub(crate) type Cause = Box<dyn std::error::Error + Send + Sync>;

/// What `cargo xtask` passes on; its help says what the tasks are for.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask")]
enum Task {
    Report {
        #[arg(long, conflicts_with = "page")]
        check: bool,
        #[arg(long)]
        page: Option<String>,
    },
    Certificates,
    Measure(measure::Wish),
    Fuzz {
        #[arg(long, default_value_t = 3_500_000)]
        runs: u64,
    },
    Mutants(mutants::Wish),
    Hostile {
        #[arg(long, default_value_t = 100_000)]
        runs: u64,
        /// The first run; the counts of later ones are not those of the report.
        #[arg(long, default_value_t = 0)]
        from: u64,
        /// Shows one scene instead.
        #[arg(long)]
        seed: Option<u64>,
    },
}

impl Task {
    fn run(self, root: &Path) -> Result<(), Cause> {
        match self {
            Self::Report { check: true, .. } => report::check(root)?,
            Self::Report { page: Some(page), .. } => report::preview(root, &page)?,
            Self::Report { .. } => report::write(root)?,
            Self::Certificates => certificates::run(root)?,
            Self::Measure(wish) => measure::run(root, &wish)?,
            Self::Mutants(wish) => mutants::run(root, &wish)?,
            Self::Fuzz { runs } => fuzz::run(root, runs)?,
            Self::Hostile { seed: Some(seed), .. } => println!("{}", palkki_evidence::hostile::scene(seed)),
            Self::Hostile { runs, from, .. } => hostile::run(root, from..from.saturating_add(runs))?,
        }
        Ok(())
    }
}

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    match Task::parse().run(&root) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Tells of the progress, one line per step.
fn tell(step: &str) {
    eprintln!("xtask: {step}");
}
