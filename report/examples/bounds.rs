//! Bound the error of contact forces that another program computed, or a hand.
#![expect(clippy::print_stdout, reason = "an example prints what it finds")]
use palkki::Witness;
use palkki::certificate::{ContactLoad, Judged};
use palkki::scene::{Beam, Foundation, Load, Scene};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let beam = Beam::new(10.0, 65.0)?;
    let load = Load::uniform_on(&beam, 1.0)?;
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 }))?;

    // Somebody says that the beam touches in the middle, with a force of 3.1.
    let forces = ContactLoad::new(10.0, [(5.0, 3.1)])?;
    let bounds = Witness::of(&scene).judge(Judged::Forces(&forces), &[])?;

    println!("the deflection that this force causes is off by at most {:.5}", bounds.deflection_error);
    if let Some([least, most]) = bounds.contact_force {
        println!("the contact force is between {least:.9} and {most:.9}");
    }
    Ok(())
}
