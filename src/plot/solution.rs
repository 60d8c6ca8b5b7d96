//! Figure of a beam in its final position: shape and foundation, clearance, contact forces, moment and shear force.

use super::axis::Axis;
use super::canvas::TEXT;
use super::curves::{Curves, PointForce};
use super::figure::Figure;
use super::layer::{Arrow, Arrows, Layer, Place};
use super::palette::{Color, Dash, Marker, Style};
use super::panel::Panel;
use super::sketch::{Ground, UnitLabels, changes, foundation_line, joint_marks, sketch, support_marks, with_unit};
use super::{PlotError, finite, same_length};
use crate::scene::Scene;
use crate::state::{Extremes, SupportForce};

/// Draws a solution given as curves. `subtitle`, for example the method, follows the title of the scene.
///
/// # Errors
///
/// A [`PlotError`] for lists of unequal length and for numbers that are not finite; a clearance may be infinite where there is no
/// foundation.
pub fn curves(scene: &Scene, curves: &Curves, subtitle: &str) -> Result<String, PlotError> {
    same_length("the deflections", &curves.deflection, &curves.x)?;
    same_length("the clearances", &curves.clearance, &curves.x)?;
    same_length("the moments", &curves.moment, &curves.x)?;
    let (units, axes) = (UnitLabels::of(scene.units()), UnitLabels::of_axes(scene.units()));
    let foundation = foundation_line(scene, curves);
    let title = if scene.title().is_empty() { "A beam above a foundation" } else { scene.title() };
    let title = if subtitle.is_empty() { title.to_owned() } else { format!("{title}: {subtitle}") };
    let mut panels = vec![shape(scene, curves, &foundation, &units)?];
    panels.extend(clearance(scene, curves, &units)?);
    panels.push(forces(scene, curves, &units));
    let y = Axis::new("bending moment M, on the side in tension").unit(axes.moment).down();
    let moment = ("M", zip(&curves.x, &curves.moment), Color::BLUE);
    panels.push(diagram(scene, (y, &units.moment), moment, &curves.moment_extremes, &units)?);
    let y = Axis::new("shear force V = dM/dx").unit(axes.force);
    let ends = Extremes::of(curves.shear.iter().map(|p| (p[0], p[1])));
    panels.push(diagram(scene, (y, &units.force), ("V", curves.shear.clone(), Color::GREEN), &ends, &units)?);
    if let Some(last) = panels.last_mut() {
        "x".clone_into(&mut last.x.label);
    }
    Figure::new(title, description(curves, &foundation, &units), panels).svg()
}

/// Draws small pictures of many solutions, four in a row: foundation, beam, contact zones as thick lines, contact points as dots, and
/// concentrated contact forces as arrows, all without numbers.
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
    let length = &units.length;
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
    let unit = &units.moment;
    parts.push(format!(
        "Bending moment from {} at {} to {} at {}.",
        with_unit(m.min, unit),
        with_unit(m.min_at, length),
        with_unit(m.max, unit),
        with_unit(m.max_at, length)
    ));
    if curves.supports.is_empty() {
        parts.push("It has no supports.".to_owned());
    } else {
        let force = |support: &SupportForce| {
            format!("{} at {}", with_unit(support.force, &units.force), with_unit(support.at, length))
        };
        let forces: Vec<String> = curves.supports.iter().map(force).collect();
        parts.push(format!("Forces of the supports: {}.", forces.join(", ")));
    }
    parts.join(" ")
}

fn zip(x: &[f64], y: &[f64]) -> Vec<Place> {
    x.iter().zip(y).map(|(&x, &y)| [x, y]).collect()
}

fn along(scene: &Scene) -> Axis {
    Axis::along("x", [0.0, scene.beam().length()]).unit(UnitLabels::of_axes(scene.units()).length)
}

/// An extreme, labelled with its value and its position.
fn extreme(name: &str, at: f64, value: f64, unit: &Option<String>, units: &UnitLabels) -> Layer {
    let text = format!("{name} = {} at x = {}", with_unit(value, unit), with_unit(at, &units.length));
    Layer::Note { at: [at, value], text, color: Color::BLACK, dot: true }
}

/// Labels for both extremes, each only if it is clearly different from zero.
fn extremes(name: &str, e: &Extremes, unit: &Option<String>, units: &UnitLabels) -> Result<Vec<Layer>, PlotError> {
    /// An extreme below this share of the larger one is on the zero line of the drawing.
    const VISIBLE: f64 = 0.02;
    for value in [e.max, e.max_at, e.min, e.min_at] {
        finite("an extreme or its place", value)?;
    }
    let most = e.magnitude();
    let mut notes = Vec::new();
    if VISIBLE * most < e.max {
        notes.push(extreme(name, e.max_at, e.max, unit, units));
    }
    if e.min < -VISIBLE * most {
        notes.push(extreme(name, e.min_at, e.min, unit, units));
    }
    Ok(notes)
}

/// Room for the foundation below its lowest line. There is none where the foundation is cut off, because it would look like its end.
fn footroom(ground: &Ground) -> f64 {
    if ground.below.is_empty() { 40.0 } else { 0.0 }
}

fn shape(scene: &Scene, curves: &Curves, ground: &Ground, units: &UnitLabels) -> Result<Panel, PlotError> {
    let has_ground = !(ground.pieces.is_empty() && ground.below.is_empty());
    let words = match (curves.shape.is_empty(), has_ground) {
        (true, true) => "deflection v and foundation u, downwards",
        (true, false) => "deflection v, downwards",
        (false, true) => "axis w0 + v of the beam and foundation u, downwards",
        (false, false) => "axis w0 + v of the beam, downwards",
    };
    let y = Axis::new(words).unit(UnitLabels::of_axes(scene.units()).length).down().including(&[0.0]);
    let mut panel = Panel::new(along(scene), y).tall(640.0);
    panel.layers.extend(ground.pieces.iter().map(|points| Layer::Foundation { points: points.clone() }));
    let below = ground.below.iter().map(|(at, text)| Layer::words(*at, Color::BLACK, text.as_str()));
    panel.layers.extend(below);
    let sketch = sketch(scene, curves, units);
    let load = !sketch.is_empty();
    // Room for a load block and its value, and for the longer arrows of point loads.
    let headroom = match (load, sketch.points.is_empty()) {
        (false, _) => 40.0,
        (true, true) => 190.0,
        (true, false) => 280.0,
    };
    let changes = changes(scene, units);
    panel = panel
        .room(headroom + changes.headroom(), footroom(ground))
        .with(Layer::Divisions(changes))
        .with(support_marks(scene))
        .with(Layer::line(curves.axis(), Style { width: 9, ..Style::solid(Color::BLACK) }))
        .with(joint_marks(scene, curves));
    if load {
        panel = panel.with(Layer::Load(sketch));
    }
    let unloaded = zip(&curves.x, &curves.shape);
    if !unloaded.is_empty() {
        let style = Style { width: 4, dash: Some(Dash::Dashed), ..Style::solid(Color::GRAY) };
        panel = panel.with(Layer::named(unloaded, style, "unloaded"));
    }
    let mut notes = extremes("v", &curves.deflection_extremes, &units.length, units)?;
    for note in &mut notes {
        if let (Layer::Note { at: [x, y], .. }, Some(shape)) = (note, scene.beam().shape()) {
            *y += shape.depth(*x);
        }
    }
    panel.layers.extend(notes);
    Ok(panel)
}

/// Shape and contact of a scene at a glance.
fn small(name: &str, scene: &Scene, curves: &Curves) -> Panel {
    let length = scene.beam().length();
    let beam = curves.axis();
    let ground = foundation_line(scene, curves);
    let mut panel = Panel::new(Axis::along("", [0.0, length]).bare(), Axis::new(name).bare().down().including(&[0.0]))
        .tall(310.0)
        .room(150.0, footroom(&ground))
        .forces(Axis::new("").bare());
    panel.layers.extend(ground.pieces.into_iter().map(|points| Layer::Foundation { points }));
    let at = |x: f64| height(&beam, x);
    let forces = curves.point_forces.iter();
    let arrows = forces.map(|f| Arrow { at: [f.at, at(f.at)], force: f.force, text: String::new(), optional: true });
    let arrows = Arrows { arrows: arrows.collect(), color: Color::VERMILLION, dash: Dash::Solid };
    panel = panel.with(support_marks(scene));
    panel.layers.extend(touching(&beam, curves));
    let beam = Layer::line(beam, Style { width: 7, ..Style::solid(Color::BLACK) });
    panel.with(beam).with(joint_marks(scene, curves)).with(Layer::Arrows(arrows))
}

/// The height of a line at `x`, or at its first point beyond.
fn height(line: &[Place], x: f64) -> f64 {
    line.iter().find(|p| x <= p[0]).map_or(0.0, |p| p[1])
}

/// The contacts of the beam, drawn thick along a line; a dot for a contact too short to be visible.
fn touching(line: &[Place], curves: &Curves) -> Vec<Layer> {
    /// Length of the shortest zone that is drawn as a zone, over the length of the beam.
    const SHORTEST: f64 = 0.006;
    let length = curves.x.last().copied().unwrap_or_default();
    let zone = |&[from, to]: &[f64; 2]| {
        if to - from < SHORTEST * length {
            let middle = 0.5 * (from + to);
            let dot = Style::marks(Color::VERMILLION, Marker::Circle);
            return Layer::line(vec![[middle, height(line, middle)]], dot);
        }
        let inside = line.iter().copied().filter(|p| from < p[0] && p[0] < to);
        let ends = [from, to].map(|x| [x, height(line, x)]);
        let points = std::iter::once(ends[0]).chain(inside).chain([ends[1]]).collect();
        Layer::line(points, Style { width: 16, ..Style::solid(Color::VERMILLION) })
    };
    curves.contacts.iter().map(zone).collect()
}

/// The panels of the clearance: none without a foundation, and a second one if the clearance between the contacts is too small to be
/// visible in the first.
fn clearance(scene: &Scene, curves: &Curves, units: &UnitLabels) -> Result<Vec<Panel>, PlotError> {
    /// A clearance below this share of the largest one is drawn again on its own scale.
    const SMALL: f64 = 0.1;
    if scene.foundation().is_none() {
        return Ok(Vec::new());
    }
    let points = zip(&curves.x, &curves.clearance);
    let [most, small] = curves.clearance_extremes;
    finite("a clearance above a foundation", most.max)?;
    // A clearance may be infinite only above a gap in the foundation.
    if !scene.ground_parts().any(|(_, stiffness)| stiffness <= 0.0) {
        curves.clearance.iter().try_for_each(|h| finite("a clearance above a foundation", *h).map(|_| ()))?;
    }
    let panel = |name: &str, points: Vec<Place>, at: f64, value: f64| {
        let y = Axis::new(name).unit(UnitLabels::of_axes(scene.units()).length).including(&[0.0]);
        let touching = touching(&points, curves);
        let mut panel = Panel::new(along(scene), y).tall(380.0).room(1.75 * TEXT, 20.0);
        let stretches =
            points.chunk_by(|a, b| a[1].is_finite() && b[1].is_finite()).filter(|part| part[0][1].is_finite());
        panel.layers.extend(stretches.map(|part| Layer::line(part.to_vec(), Style::solid(Color::BLUE))));
        panel.layers.extend(touching);
        // A beam that lies on the foundation from end to end has no clearance to label.
        let note = extreme("h", at, value, &units.length, units);
        if value == 0.0 { panel } else { panel.with(note) }
    };
    let between: Vec<Place> = match &curves.contacts[..] {
        [first, .., last] => points.iter().copied().filter(|p| first[0] <= p[0] && p[0] <= last[1]).collect(),
        _ => Vec::new(),
    };
    let touching = !curves.contacts.is_empty();
    let (name, at, value) =
        if touching { (", thick where it touches", most.max_at, most.max) } else { ("", most.min_at, most.min) };
    let what = if curves.shape.is_empty() { "clearance h = u − v" } else { "clearance h = u − w0 − v" };
    let mut panels = vec![panel(&format!("{what}{name}"), points, at, value)];
    if 0.0 < small.max && small.max < SMALL * most.max {
        panels.push(panel("the same between the contacts, enlarged", between, small.max_at, small.max));
    }
    Ok(panels)
}

fn forces(scene: &Scene, curves: &Curves, units: &UnitLabels) -> Panel {
    /// Height shared by all arrows \[drawing units\].
    const HEIGHT: f64 = 480.0;
    let all = || curves.point_forces.iter().map(|f| f.force).chain(curves.supports.iter().map(|support| support.force));
    let [least, most] = all().fold([0.0_f64; 2], |[least, most], f| [least.min(f), most.max(f)]);
    // Arrows that point downwards, at a support in tension, need their share of the height.
    let footroom = if least < 0.0 { 90.0 + HEIGHT * (-least / (most - least)) } else { 40.0 };
    let axes = UnitLabels::of_axes(scene.units());
    let arrows = Axis::new("forces, as arrows").unit(axes.force);
    let mut panel = if curves.pressure.is_empty() {
        let axis = Axis { padding: 0.0, ..arrows }.including(&[0.0, least, most]);
        Panel::new(along(scene), axis).room(1.6 * TEXT, if least < 0.0 { 1.6 * TEXT } else { 40.0 })
    } else {
        let axis = Axis::new("contact pressure p, as an area").unit(axes.pressure).including(&[0.0]);
        let panel = Panel::new(along(scene), axis).room(1.6 * TEXT, footroom);
        // The axis of arrows is drawn only if there are arrows.
        if least < most { panel.forces(arrows) } else { panel }
    };
    panel = panel.tall(HEIGHT);
    let area = |zone: &Vec<Place>| Layer::Area { points: zone.clone(), level: 0.0, color: Color::VERMILLION };
    panel.layers.extend(curves.pressure.iter().map(area));
    let layer = |arrows: Vec<Arrow>, color: Color| Layer::Arrows(Arrows { arrows, color, dash: Dash::Solid });
    let supports = curves.supports.iter().map(|support| arrow(support.at, support.force, false, units)).collect();
    panel
        .with(Layer::zero_line([0.0, scene.beam().length()]))
        .with(layer(contact_arrows(&curves.point_forces, units), Color::VERMILLION))
        .with(layer(supports, Color::BLACK))
}

fn arrow(at: f64, force: f64, optional: bool, units: &UnitLabels) -> Arrow {
    Arrow { at: [at, 0.0], force, text: with_unit(force, &units.force), optional }
}

/// Arrows for contact forces. If there are many, only the largest are labelled, and only if there is room.
fn contact_arrows(forces: &[PointForce], units: &UnitLabels) -> Vec<Arrow> {
    /// Largest number of labelled forces.
    const CROWD: usize = 12;
    let mut by_size: Vec<usize> = (0..forces.len()).collect();
    by_size.sort_by(|&i, &j| forces[j].force.abs().total_cmp(&forces[i].force.abs()));
    let crowd = CROWD < by_size.len();
    let mut arrows: Vec<Arrow> = forces.iter().map(|f| arrow(f.at, f.force, crowd, units)).collect();
    for &i in by_size.iter().skip(CROWD) {
        arrows[i].text.clear();
    }
    arrows
}

/// A quantity along the beam as an area between its curve and the beam, with its extremes.
fn diagram(
    scene: &Scene,
    (y, unit): (Axis, &Option<String>),
    (name, points, color): (&str, Vec<Place>, Color),
    e: &Extremes,
    units: &UnitLabels,
) -> Result<Panel, PlotError> {
    let mut panel = Panel::new(along(scene), y.including(&[0.0])).tall(470.0).room(1.75 * TEXT, 1.75 * TEXT);
    panel = panel.with(Layer::zero_line([0.0, scene.beam().length()])).with(Layer::Area { points, level: 0.0, color });
    panel.layers.extend(extremes(name, e, unit, units)?);
    Ok(panel)
}
