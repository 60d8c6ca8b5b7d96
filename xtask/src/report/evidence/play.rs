//! Scene files such as the beam to play with in `index.html` makes, with the answers that its own are held against.

use palkki::scene::file::{ReadProblem, parse};
use palkki_evidence::random::Random;

use super::prelude::*;

/// Scenes.
const COUNT: u64 = 30;
/// Intervals of the grid beside.
const INTERVALS: usize = 30;
/// Length of the beam, which has no handle.
const LENGTH: f64 = 10.0;
/// Points of the ground.
const POINTS: u32 = 7;

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let header = [
        "scene",
        "left",
        "right",
        "contacts",
        "ground",
        "first_force",
        "largest_moment",
        "least_moment",
        "largest_deflection",
        "left_on_grid",
        "right_on_grid",
        "first_force_on_grid",
    ];
    let mut data = Table::new(header);
    let mut random = Random::new(COUNT);
    for _ in 0..COUNT {
        let text = text(&mut random);
        let scene = parse("scene.toml", &text, |_| Err(ReadProblem::Missing))?;
        let exact = theory::solve(&scene)?;
        let grid = on_grid(&scene, Method::Force, Solver::ActiveSet, INTERVALS)?;
        if !exact.solved || !grid.solved {
            return Err(format!("a scene is not solved:\n{text}").into());
        }
        let contact = exact.state.contacts.first();
        let node = nodes_of(&grid.state)?.contact_force.iter().copied().find(|force| 0.0 < *force);
        let [moment, deflection] = [exact.state.moment, exact.state.deflection];
        data.push(row![
            text,
            fixed(exact.state.reactions.left, 6),
            fixed(exact.state.reactions.right, 6),
            exact.state.contacts.len(),
            fixed(exact.state.contacts.iter().map(|contact| contact.force).sum(), 6),
            fixed(contact.map_or(0.0, |contact| contact.end_forces.map_or(contact.force, |[left, _]| left)), 6),
            fixed(moment.max, 6),
            fixed(moment.min, 6),
            fixed(deflection.max, 6),
            fixed(grid.state.reactions.left, 6),
            fixed(grid.state.reactions.right, 6),
            fixed(node.unwrap_or(0.0), 6),
        ]);
    }
    Evidence::new(context! { count => COUNT, intervals => INTERVALS }).data("play", data)
}

/// A scene file, letter by letter as the page writes it.
fn text(random: &mut Random) -> String {
    let round = |value: f64| (1000.0 * value).round() / 1000.0;
    let places: Vec<String> = (0..POINTS)
        .map(|i| {
            let inside = 0 < i && i < POINTS - 1;
            let away = if inside { random.between(-0.4, 0.4) } else { 0.0 };
            let x = LENGTH * (f64::from(i) + away) / f64::from(POINTS - 1);
            format!("[{}, {}]", round(x), round(random.between(if inside { -0.2 } else { 0.05 }, 2.0)))
        })
        .collect();
    let mut supports = Vec::new();
    for at in [0.0, LENGTH] {
        match random.below(3) {
            0 => {}
            1 => supports.push(format!("{{ at = {at} }}")),
            _ => supports.push(format!("{{ at = {at}, built_in = true }}")),
        }
    }
    format!(
        "title = \"A beam to play with\"\n\n[beam]\nlength = {LENGTH}\nbending_stiffness = {}\nsupports = [{}]\n\n\
         [load]\nuniform = {}\npoint = [{{ at = {}, force = {} }}]\n\n[foundation]\npoints = [{}]\n",
        round(10_f64.powf(random.between(-1.0, 2.0))),
        supports.join(", "),
        round(random.between(0.1, 3.0)),
        round(random.between(0.0, LENGTH)),
        round(random.between(0.0, 6.0)),
        places.join(", "),
    )
}
