//! Ask for an accuracy, and have the grid chosen.
#![expect(clippy::print_stdout, reason = "an example prints what it finds")]
use palkki::adaptive::{Request, adapt};
use palkki::route::{Method, Solver};
use palkki::scene::{Beam, Foundation, Load, Scene};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let beam = Beam::new(10.0, 1.3)?;
    let load = Load::uniform_on(&beam, 1.0)?;
    let wave = Foundation::Cosine { mean: 1.0, amplitude: 0.3, wavelength: 5.0, phase: 0.0 };
    let scene = Scene::new(beam, load, Some(wave))?;

    let found = adapt(&scene, &Request::new(Method::Force, Solver::ActiveSet, 1e-3))?;
    for trial in &found.trials {
        println!("{:5} intervals: guaranteed to {:.1e}", trial.intervals, trial.error);
    }
    let verdict = &found.solution.verdict;
    println!("{}, {}: {verdict}", found.end, verdict.status);
    Ok(())
}
