//! A sweep as a figure: forces, extremes and places of contact over the number that is varied, with the events.

use super::PlotError;
use super::axis::Axis;
use super::figure::Figure;
use super::layer::{Layer, Place, Reference};
use super::palette::{Color, Dash, Style};
use super::panel::Panel;
use crate::scene::{Quantity, Scene};
use crate::state::{Contact, ContactState};
use crate::sweep::Event;
use crate::text::significant;

/// Digits of a value in the description.
const DIGITS: usize = 6;
/// Of more events only the lines are drawn, without numbers.
const MOST_NUMBERED: usize = 20;

/// Reactions, extremes, and where the beam touches, over the value of the number that is varied; events are dotted lines with
/// numbers, which the description names.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, and if there is no row.
pub fn sweep(
    scene: &Scene,
    quantity: Quantity,
    rows: &[(f64, &ContactState)],
    events: &[Event],
) -> Result<String, PlotError> {
    let units = scene.units();
    let (length, force) = (units.length.clone(), units.force.clone());
    let moment = length.as_ref().zip(force.as_ref()).map(|(length, force)| format!("{force}·{length}"));
    let series =
        |of: &dyn Fn(&ContactState) -> f64| rows.iter().map(|(x, state)| [*x, of(state)]).collect::<Vec<Place>>();
    let panel = |label: &str, unit: Option<String>| {
        Panel::new(Axis { padding: 0.0, ..Axis::new("") }, Axis::new(label).unit(unit)).room(60.0, 0.0)
    };

    let mut forces = panel("forces, upwards on the beam", force);
    let supports = rows.first().map_or(0, |(_, state)| state.supports.len());
    for i in 0..supports.min(4) {
        let of = |state: &ContactState| state.supports.get(i).map_or(0.0, |support| support.force);
        // Vermillion, the second colour, is that of contact.
        let style = line(if i == 0 { 0 } else { i + 1 });
        forces = forces.with(Layer::named(series(&of), style, format!("support {}", i + 1)));
    }
    if rows.iter().any(|(_, state)| !state.contacts.is_empty()) {
        let style = Style::solid(Color::VERMILLION);
        forces = forces.with(Layer::named(series(&ContactState::contact_force), style, "contact"));
    }
    let deflection = panel("largest deflection", length.clone())
        .tall(400.0)
        .with(Layer::line(series(&|state| state.deflection.max), line(0)));
    let moments = panel("bending moment", moment)
        .tall(460.0)
        .with(Layer::named(series(&|state| state.moment.max), line(0), "largest"))
        .with(Layer::named(series(&|state| state.moment.min), line(1), "least"));
    let map = map(scene, quantity, rows, panel("places of contact along the beam", length).tall(760.0));

    let mut panels = vec![forces, deflection, moments, map];
    for (i, event) in events.iter().enumerate() {
        for (k, panel) in panels.iter_mut().enumerate() {
            let text = if k == 0 && events.len() <= MOST_NUMBERED { (i + 1).to_string() } else { String::new() };
            panel.layers.push(Layer::Reference { at: Reference::X(event.value), text });
        }
    }
    if let Some(last) = panels.last_mut() {
        last.x.label = quantity.to_string();
    }
    let title = if scene.title().is_empty() { quantity.to_string() } else { scene.title().to_owned() };
    Figure::new(title, description(quantity, rows, events), panels).svg()
}

fn line(i: usize) -> Style {
    Style { dash: Some(Dash::Solid), marker: None, ..Style::of_series(i) }
}

/// Where the beam touches: lines for points, and hatched stretches for zones; with the place of a load or support that moves.
fn map(scene: &Scene, quantity: Quantity, rows: &[(f64, &ContactState)], panel: Panel) -> Panel {
    let mut panel = Panel { y: panel.y.including(&[0.0, scene.beam().length()]), ..panel };
    let ends = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |row| row.0));
    if matches!(quantity, Quantity::PointAt(_) | Quantity::SupportAt(_)) {
        let style = Style { dash: Some(Dash::Dashed), ..Style::solid(Color::GRAY) };
        let name = if matches!(quantity, Quantity::PointAt(_)) { "load" } else { "support" };
        panel = panel.with(Layer::named(ends.map(|x| [x, x]).into(), style, name));
    } else {
        // So that the panel has something to show where nothing touches.
        panel = panel.with(Layer::line(ends.map(|x| [x, 0.0]).into(), Style::solid(Color::GRID)));
    }
    for stretch in stretches(rows) {
        let contacts = stretch[0].1.contacts.len();
        for k in 0..contacts {
            let of = |row: &(f64, &ContactState)| (row.0, row.1.contacts[k]);
            let side =
                |end: &dyn Fn(Contact) -> f64| stretch.iter().map(of).map(|(x, c)| [x, end(c)]).collect::<Vec<Place>>();
            let (from, to) = (side(&|c| c.from), side(&|c| c.to));
            if from != to {
                let up_and_down = from.iter().zip(&to).enumerate();
                let hatch = up_and_down.flat_map(|(i, (&a, &b))| if i % 2 == 0 { [a, b] } else { [b, a] }).collect();
                panel = panel.with(Layer::line(hatch, Style { width: 3, ..Style::solid(Color::ORANGE) }));
                panel = panel.with(Layer::line(to, Style::solid(Color::VERMILLION)));
            }
            panel = panel.with(Layer::line(from, Style::solid(Color::VERMILLION)));
        }
    }
    panel
}

/// Neighbouring rows with the same kinds of contacts, in which each contact is followed.
fn stretches<'a>(rows: &'a [(f64, &'a ContactState)]) -> impl Iterator<Item = &'a [(f64, &'a ContactState)]> {
    let zone = |contact: &Contact| contact.from < contact.to;
    rows.chunk_by(move |(_, a), (_, b)| {
        a.contacts.len() == b.contacts.len() && a.contacts.iter().zip(&b.contacts).all(|(a, b)| zone(a) == zone(b))
    })
}

fn description(quantity: Quantity, rows: &[(f64, &ContactState)], events: &[Event]) -> String {
    let ends = [rows.first(), rows.last()].map(|row| row.map_or_else(String::new, |row| significant(row.0, DIGITS)));
    let mut text = format!(
        "Forces of supports and ground, largest deflection, bending moments and places of contact for {} values of {quantity} \
         from {} to {}.",
        rows.len(),
        ends[0],
        ends[1]
    );
    for (i, event) in events.iter().enumerate() {
        text += &format!(" Event {} at {}: {}.", i + 1, significant(event.value, DIGITS), event.what);
    }
    text
}
