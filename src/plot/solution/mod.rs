//! A beam in its final position: shape and foundation, clearance, contact forces, moment, shear.

mod ground;
mod panels;
mod sketch;
mod units;

use self::ground::{Ground, foundation_line};
use self::panels::{clearance, forces, moment, shape, shear, small};
use self::units::{UnitLabels, with_unit};
use super::curves::Curves;
use super::error::{PlotError, same_length};
use super::figure::Figure;
use crate::scene::Scene;
use crate::state::ContactState;

/// Draws a discretised solution.
///
/// # Errors
///
/// Those of [`Curves::of`] and of [`curves`].
pub fn solution(scene: &Scene, state: &ContactState) -> Result<String, PlotError> {
    curves(scene, &Curves::of(scene, state)?, "")
}

/// Draws a solution given as curves; `subtitle`, the method for example, follows the title of the scene.
///
/// # Errors
///
/// A [`PlotError`] for lists of unequal length and for numbers that are not finite; a clearance may be infinite.
pub fn curves(scene: &Scene, curves: &Curves, subtitle: &str) -> Result<String, PlotError> {
    same_length("the deflections", &curves.deflection, &curves.x)?;
    same_length("the clearances", &curves.clearance, &curves.x)?;
    same_length("the moments", &curves.moment, &curves.x)?;
    let units = UnitLabels::of(scene.units());
    let foundation = foundation_line(scene, curves);
    let title = if scene.title().is_empty() { "A beam above a foundation" } else { scene.title() };
    let title = if subtitle.is_empty() { title.to_owned() } else { format!("{title}: {subtitle}") };
    let mut panels = vec![shape(scene, curves, &foundation, &units)?];
    panels.extend(clearance(scene, curves, &units)?);
    panels.push(forces(scene, curves, &units));
    panels.push(moment(scene, curves, &units)?);
    panels.push(shear(scene, curves, &units)?);
    if let Some(last) = panels.last_mut() {
        "x".clone_into(&mut last.x.label);
    }
    Figure::new(title, description(curves, &foundation, &units), panels).svg()
}

/// Small pictures of many solutions, four in a row: ground, beam, contact zones as thick lines and concentrated contact forces
/// as arrows, all without numbers.
///
/// # Errors
///
/// As [`curves`].
pub fn sheet<'a>(
    title: &str,
    description: &str,
    solutions: impl IntoIterator<Item = (&'a str, &'a Scene, &'a Curves)>,
) -> Result<String, PlotError> {
    let panels = solutions.into_iter().map(|(name, scene, curves)| small(name, scene, curves)).collect();
    Figure { columns: 4, ..Figure::new(title, description, panels) }.svg()
}

/// The figure in words.
fn description(curves: &Curves, ground: &Ground, units: &UnitLabels) -> String {
    let length = units.length.as_ref();
    let mut parts = vec![format!(
        "From top to bottom: deflected beam{}, contact forces, bending moment and shear force along the beam; deflection \
         and moment are positive downwards.",
        if ground.pieces.is_empty() { "" } else { " above its foundation, clearance" }
    )];
    parts.extend(ground.remark.clone());
    let v = &curves.deflection_extremes;
    parts.push(format!("Largest deflection {} at {}.", with_unit(v.max, length), with_unit(v.max_at, length)));
    if curves.contacts.is_empty() {
        parts.push("The beam touches nowhere.".to_owned());
    } else {
        let stretches: Vec<String> = curves
            .contacts
            .iter()
            .take(12)
            .map(|&[from, to]| {
                let from_text = with_unit(from, length);
                if from < to { format!("{from_text} to {}", with_unit(to, length)) } else { from_text }
            })
            .collect();
        let more = if stretches.len() < curves.contacts.len() { ", and further places" } else { "" };
        parts.push(format!("It touches at {}{more}.", stretches.join(", ")));
    }
    let m = &curves.moment_extremes;
    let unit = units.moment.as_ref();
    parts.push(format!(
        "Bending moment from {} at {} to {} at {}.",
        with_unit(m.min, unit),
        with_unit(m.min_at, length),
        with_unit(m.max, unit),
        with_unit(m.max_at, length)
    ));
    let r = curves.reactions;
    let force = units.force.as_ref();
    parts.push(format!("Reactions {} left and {} right.", with_unit(r.left, force), with_unit(r.right, force)));
    parts.join(" ")
}
