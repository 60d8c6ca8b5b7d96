//! Figure of a sweep: contact positions, forces and extremes over the varied number, with the events.

use super::PlotError;
use super::axis::Axis;
use super::figure::Figure;
use super::layer::{Divisions, Layer, Place};
use super::palette::{Color, Dash, Style};
use super::panel::Panel;
use super::sketch::UnitLabels;
use crate::scene::{ProfileKey, Quantity, Scene};
use crate::state::{Contact, ContactState, Regime};
use crate::sweep::Event;
use crate::text::significant;

/// Digits of a value in text.
const DIGITS: usize = 5;
/// Up to this many events have their values beside their numbers, with fewer digits.
const FEW: usize = 6;
const FEW_DIGITS: usize = 3;
/// If there are more events than this, only their lines are drawn. Numbers and descriptions would need more room than the panels.
const MOST_NAMED: usize = 16;
/// Contacts of neighbouring rows closer together than this share of the beam are one moving contact.
const NEAR: f64 = 0.02;

/// Number of supports whose forces are drawn: more lines cannot be distinguished (*tuned* by eye).
const MOST_SUPPORTS: usize = 4;

/// Room above the data of a panel \[drawing units\].
const HEADROOM: f64 = 30.0;

/// A value of the varied number with its answer.
type Row<'a> = (f64, &'a ContactState);

/// Draws contact positions, forces, largest deflection and moments over the varied number.
///
/// An event is a dotted line with a number; its description is below the panels. If `title` is empty, the title consists of the title
/// of the scene and the varied number.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, and if there is no row.
pub fn sweep(
    scene: &Scene,
    quantity: Quantity,
    rows: &[(f64, &ContactState)],
    events: &[Event],
    title: &str,
) -> Result<String, PlotError> {
    let UnitLabels { length, force, moment, .. } = UnitLabels::of_axes(scene.units());
    let panel = |label: &str, unit: &Option<String>| {
        Panel::new(value_axis(), Axis::new(label).unit(unit.clone())).tall(360.0).room(HEADROOM, 0.0)
    };

    let forces = forces(scene, rows, panel("forces, upwards on the beam", &force).tall(480.0));
    let mut deflection = panel("largest deflection, downwards", &length);
    deflection.y = deflection.y.down();
    let deflection = deflection.with(Layer::line(series(rows, |state| state.deflection.max), line(0)));
    let mut moments = panel("largest and least bending moment, on the side in tension", &moment).tall(400.0);
    moments.y = moments.y.down();
    let moments = moments
        .with(Layer::named(series(rows, |state| state.moment.max), line(0), "largest"))
        .with(Layer::named(series(rows, |state| state.moment.min), line(2), "least"));

    let mut divisions = Divisions { lines: numbered(events), between: regimes(rows, events) };
    let map = map(scene, quantity, rows, events, panel("where the beam touches: x along the beam", &length));
    let headroom = divisions.headroom() + HEADROOM;
    let map = map.tall(560.0 + headroom).room(headroom, 0.0);
    let mut panels = vec![map.with(Layer::Divisions(divisions.clone()))];
    divisions.between.clear();
    divisions.lines.iter_mut().for_each(|line| line.1.clear());
    panels.extend([forces, deflection, moments].map(|panel| panel.with(Layer::Divisions(divisions.clone()))));
    if let Some(last) = panels.last_mut() {
        let (words, unit) = name(quantity, scene);
        last.x.label = if words.is_empty() { quantity.to_string() } else { format!("{words}, {quantity}") };
        last.x.unit = unit;
    }
    let named = if events.len() <= MOST_NAMED { events } else { &[] };
    let notes = named
        .iter()
        .enumerate()
        .map(|(i, event)| format!("{} at {}: {}", i + 1, significant(event.value, DIGITS), event.what));
    let title = match (title, scene.title()) {
        ("", "") => quantity.to_string(),
        ("", of_scene) => format!("{of_scene}: {quantity} varied"),
        (title, _) => title.to_owned(),
    };
    Figure::new(title, description(quantity, rows, events), panels).notes(notes.collect()).svg()
}

/// A number of each answer over the varied number.
fn series(rows: &[Row<'_>], of: impl Fn(&ContactState) -> f64) -> Vec<Place> {
    rows.iter().map(|(x, state)| [*x, of(state)]).collect()
}

/// The reactions of the first supports and the total contact force.
fn forces(scene: &Scene, rows: &[Row<'_>], mut panel: Panel) -> Panel {
    let supports = rows.first().map_or(0, |(_, state)| state.supports.len());
    for i in 0..supports.min(MOST_SUPPORTS) {
        let place = scene.beam().supports_as_given().get(i).map(|support| support.at);
        let of = |state: &ContactState| state.supports.get(i).map_or(0.0, |support| support.force);
        // Vermillion, the second colour, is used for contact.
        let style = line(if i == 0 { 0 } else { i + 1 });
        let name = format!("support {}", i + 1);
        let name = place.map_or(name, |x| format!("support at {}", significant(x, FEW_DIGITS)));
        panel = panel.with(Layer::named(series(rows, of), style, name));
    }
    if rows.iter().any(|(_, state)| !state.contacts.is_empty()) {
        let style = Style::solid(Color::VERMILLION);
        panel = panel.with(Layer::named(series(rows, ContactState::contact_force), style, "contact"));
    }
    panel
}

fn value_axis() -> Axis {
    Axis { padding: 0.0, ..Axis::new("") }
}

fn line(i: usize) -> Style {
    Style { dash: Some(Dash::Solid), marker: None, ..Style::of_series(i) }
}

/// The varied number in words, and its unit; empty if its path is clear enough.
fn name(quantity: Quantity, scene: &Scene) -> (&'static str, Option<String>) {
    let UnitLabels { length, force, pressure, moment, stiffness } = UnitLabels::of_axes(scene.units());
    match quantity {
        Quantity::Length => ("length of the beam", length),
        Quantity::BendingStiffness | Quantity::StepStiffness(_) => ("bending stiffness", stiffness),
        Quantity::GroundStepAt(_) => ("position where the foundation stiffness changes", length),
        Quantity::StepAt(_) => ("position where the bending stiffness changes", length),
        Quantity::JointAt(_) => ("position of the joint", length),
        Quantity::Tension => ("tension", force),
        Quantity::JointStiffness(_) => ("stiffness of the joint", moment),
        Quantity::Uniform => ("uniform load", pressure),
        Quantity::LinearFrom(_) | Quantity::LinearTo(_) => ("end of the distributed load", length),
        Quantity::LinearStart(_) | Quantity::LinearEnd(_) => ("distributed load at its end", pressure),
        Quantity::PointAt(_) => ("position of the point load", length),
        Quantity::PointForce(_) => ("point load", force),
        Quantity::CoupleAt(_) => ("position of the couple", length),
        Quantity::CoupleMoment(_) => ("couple", moment),
        Quantity::SupportAt(_) => ("position of the support", length),
        Quantity::SupportLevel(_) => ("level of the support", length),
        Quantity::SupportStiffness(_) => ("stiffness of the support", None),
        Quantity::SupportTurningStiffness(_) => ("turning stiffness of the support", None),
        Quantity::SupportSlope(_) => ("slope at the support", None),
        Quantity::Profile(_, ProfileKey::Depth) => ("depth of the foundation", length),
        Quantity::Profile(..)
        | Quantity::Supports
        | Quantity::TotalLoad
        | Quantity::GroundStiffness
        | Quantity::GroundStepStiffness(_) => ("", None),
    }
}

/// A line for each event, with its number.
fn numbered(events: &[Event]) -> Vec<(f64, String)> {
    let (few, many) = (events.len() <= FEW, MOST_NAMED < events.len());
    let text = |i: usize, value: f64| match (i + 1).to_string() {
        _ if many => String::new(),
        number if few => format!("{number} at {}", significant(value, FEW_DIGITS)),
        number => number,
    };
    let mut lines: Vec<_> = events.iter().enumerate().map(|(i, e)| (e.value, text(i, e.value))).collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    lines
}

/// The interval of each regime, if there are several.
fn regimes(rows: &[Row<'_>], events: &[Event]) -> Vec<([f64; 2], String)> {
    let mut found: Vec<([f64; 2], Regime)> = Vec::new();
    for row in rows.iter() {
        match found.last_mut() {
            Some((ends, regime)) if *regime == row.1.regime => ends[1] = row.0,
            Some((ends, _)) => {
                let border = events_between(events, ends[1], row.0).last().unwrap_or(row.0);
                ends[1] = border;
                found.push(([border, row.0], row.1.regime));
            }
            None => found.push(([row.0; 2], row.1.regime)),
        }
    }
    let words = |regime| match regime {
        Regime::None => "nowhere",
        Regime::Points => "points",
        Regime::Zone => "zone",
    };
    let several = 1 < found.len();
    let sorted = |[a, b]: [f64; 2]| [a.min(b), a.max(b)];
    found.into_iter().filter(|_| several).map(|(ends, regime)| (sorted(ends), words(regime).to_owned())).collect()
}

/// Values of events between two rows, in the order of the sweep.
fn events_between(events: &[Event], a: f64, b: f64) -> impl Iterator<Item = f64> {
    events.iter().map(|event| event.value).filter(move |value| (a.min(b)..=a.max(b)).contains(value))
}

/// The contact positions, as lines for points and bands for zones, with the position of a moving load or support.
fn map(scene: &Scene, quantity: Quantity, rows: &[Row<'_>], events: &[Event], panel: Panel) -> Panel {
    let mut panel = Panel { y: panel.y.including(&[0.0, scene.beam().length()]), ..panel };
    let ends = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |row| row.0));
    if matches!(quantity, Quantity::PointAt(_) | Quantity::SupportAt(_)) {
        let style = Style { dash: Some(Dash::LongDashed), ..Style::solid(Color::BLACK) };
        let name = if matches!(quantity, Quantity::PointAt(_)) { "load" } else { "support" };
        panel = panel.with(Layer::named(ends.map(|x| [x, x]).into(), style, name));
    } else {
        // A line that gives the panel a range if the beam touches nowhere.
        panel = panel.with(Layer::line(ends.map(|x| [x, 0.0]).into(), Style::solid(Color::GRID)));
    }
    for stretch in rows.chunk_by(|a, b| are_alike(a.1, b.1)) {
        for k in 0..stretch[0].1.contacts.len() {
            let side = |end: fn(&Contact) -> f64| stretch.iter().map(|row| [row.0, end(&row.1.contacts[k])]).collect();
            panel.layers.push(moving(side(|contact| contact.from), side(|contact| contact.to)));
        }
    }
    for pair in rows.windows(2).filter(|pair| !are_alike(pair[0].1, pair[1].1)) {
        panel.layers.extend(joined(pair[0], pair[1], events, NEAR * scene.beam().length()));
    }
    panel
}

/// Whether two answers have the same number of contacts of the same kinds, so that each contact can be followed.
fn are_alike(a: &ContactState, b: &ContactState) -> bool {
    let is_zone = |contact: &Contact| contact.from < contact.to;
    a.contacts.len() == b.contacts.len() && a.contacts.iter().zip(&b.contacts).all(|(a, b)| is_zone(a) == is_zone(b))
}

/// A moving contact: its two ends over the varied number.
fn moving(from: Vec<Place>, to: Vec<Place>) -> Layer {
    let color = Color::VERMILLION;
    if from == to { Layer::line(from, Style::solid(color)) } else { Layer::Band { from, to, color } }
}

/// Joins neighbouring rows whose contacts differ. A contact is joined to the contacts near it in the other row. A contact without one
/// there ends or begins at the event between the rows.
fn joined(a: Row<'_>, b: Row<'_>, events: &[Event], near: f64) -> Vec<Layer> {
    let are_near = |c: &Contact, d: &Contact| c.from <= d.to + near && d.from <= c.to + near;
    let between = |(x, c): (f64, &Contact), (y, d): (f64, &Contact)| {
        moving(vec![[x, c.from], [y, d.from]], vec![[x, c.to], [y, d.to]])
    };
    let middle = 0.5 * (a.0 + b.0);
    let goes = events_between(events, a.0, b.0).next().unwrap_or(middle);
    let appears = events_between(events, a.0, b.0).last().unwrap_or(middle);
    let mut layers = Vec::new();
    for c in &a.1.contacts {
        layers.extend(b.1.contacts.iter().filter(|d| are_near(c, d)).map(|d| between((a.0, c), (b.0, d))));
        if !b.1.contacts.iter().any(|d| are_near(c, d)) {
            layers.push(between((a.0, c), (goes, c)));
        }
    }
    let new = b.1.contacts.iter().filter(|d| !a.1.contacts.iter().any(|c| are_near(c, d)));
    layers.extend(new.map(|d| between((appears, d), (b.0, d))));
    layers
}

fn description(quantity: Quantity, rows: &[Row<'_>], events: &[Event]) -> String {
    let ends = [rows.first(), rows.last()].map(|row| row.map_or_else(String::new, |row| significant(row.0, DIGITS)));
    let mut text = format!(
        "Places of contact, forces of supports and ground, largest deflection and bending moments for {} values of {quantity} \
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
