//! Vary one number of a scene: an exact answer for each value, and the values at which contact is gained or lost.
#![expect(clippy::print_stdout, reason = "an example prints what it finds")]
use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene};
use palkki::sweep::Sweep;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let beam = Beam::new(10.0, 100.0)?;
    let load = Load::new(&beam, 0.0, vec![], vec![PointLoad { at: 1.0, force: 30.0 }])?;
    let step = Foundation::Polyline { points: vec![[0.0, 2.0], [6.0, 2.0], [6.0, 0.5], [10.0, 0.5]] };
    let scene = Scene::new(beam, load, Some(step))?;

    let sweep = Sweep::new(&scene, "load.point[0].at", [1.0, 9.0], 5)?;
    let rows = sweep.rows()?;
    for row in &rows {
        let state = &row.solution.state;
        println!(
            "load at {}: left support {:.4}, ground {:.4}",
            row.value,
            state.reactions.left,
            state.contact_force()
        );
    }
    for event in sweep.events(&rows) {
        println!("load at {:.6}: {}", event.value, event.what);
    }
    Ok(())
}
