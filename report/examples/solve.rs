//! Solve a scene exactly: where the beam touches and how hard, and what its supports carry.
#![expect(clippy::print_stdout, reason = "an example prints what it finds")]
use palkki::scene::{Beam, Foundation, Load, Scene, Support};
use palkki::solve_exactly;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let beam = Beam::new(10.0, 1.3)?.with_supports(vec![Support::simple(0.0), Support::built_in(10.0)])?;
    let load = Load::uniform_on(&beam, 1.0)?;
    let ridge = Foundation::Polyline { points: vec![[0.0, 1.0], [4.0, 0.5], [10.0, 1.0]] };
    let answer = solve_exactly(&Scene::new(beam, load, Some(ridge))?)?;

    println!("{}", answer.verdict.status);
    for support in &answer.state.supports {
        println!("support at {}: {:.5}", support.at, support.force);
    }
    for contact in &answer.state.contacts {
        println!("contact from {:.5} to {:.5}: {:.5}", contact.from, contact.to, contact.force);
    }
    Ok(())
}
