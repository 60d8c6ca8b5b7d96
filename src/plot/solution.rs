//! A beam in its final position: shape and foundation, clearance, contact forces, moment, shear.

use super::axis::Axis;
use super::curves::Curves;
use super::error::{PlotError, finite, same_length};
use super::figure::Figure;
use super::layer::{Arrow, Arrows, Layer, LoadSketch, Place};
use super::number::{DIGITS, significant};
use super::palette::{Color, Dash, Style};
use super::panel::Panel;
use crate::scene::{Foundation, Scene, Units};
use crate::state::{ContactState, Extremes};

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
    panels.push(forces(scene, curves, &units)?);
    panels.push(moment(scene, curves, &units)?);
    panels.push(shear(scene, curves, &units)?);
    if let Some(last) = panels.last_mut() {
        "x".clone_into(&mut last.x.label);
    }
    Figure::new(title, description(curves, &foundation, &units), panels).svg()
}

/// Units as they are printed; `None` where the scene names none.
struct UnitLabels {
    length: Option<String>,
    force: Option<String>,
    pressure: Option<String>,
    moment: Option<String>,
}

impl UnitLabels {
    fn of(units: &Units) -> Self {
        let both = |join: &str| Some(format!("{}{join}{}", units.force.as_ref()?, units.length.as_ref()?));
        Self { length: units.length.clone(), force: units.force.clone(), pressure: both("/"), moment: both("·") }
    }
}

/// `1.182 kN`
fn with_unit(value: f64, unit: Option<&String>) -> String {
    let number = significant(value, DIGITS);
    unit.map_or(number.clone(), |unit| format!("{number} {unit}"))
}

/// The foundation as far as it is drawn.
struct Ground {
    line: Vec<Place>,
    /// Why something is missing, as a sentence of the description.
    remark: Option<String>,
}

/// A foundation deeper than this many times the deflection would flatten the beam to a line: it is cut off there.
const DEEPEST: f64 = 4.0;

fn foundation_line(scene: &Scene, curves: &Curves) -> Ground {
    /// Places at which a smooth foundation is drawn; a drawing is 2400 units wide.
    const SAMPLES: u32 = 600;
    let length = scene.beam().length();
    let even = (0..=SAMPLES).map(|i| length * f64::from(i) / f64::from(SAMPLES));
    let line: Vec<Place> = match scene.foundation() {
        None => {
            let remark = Some("There is no foundation, so there is no clearance.".to_owned());
            return Ground { line: Vec::new(), remark };
        }
        Some(Foundation::Polyline { points }) => points.clone(),
        Some(Foundation::Flat { depth }) => vec![[0.0, *depth], [length, *depth]],
        Some(smooth) => even.map(|x| [x, smooth.depth(x)]).collect(),
    };
    let deflected = curves.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let limit = if 0.0 < deflected { DEEPEST * deflected } else { f64::INFINITY };
    let shallowest = line.iter().fold(f64::INFINITY, |least, p| least.min(p[1]));
    if limit < shallowest {
        let depth = significant(shallowest, DIGITS);
        let remark = format!("The foundation lies far below the beam, at {depth} or deeper, and is not drawn with it.");
        return Ground { line: Vec::new(), remark: Some(remark) };
    }
    if line.iter().any(|p| limit < p[1]) {
        let line = line.into_iter().map(|[x, u]| [x, u.min(limit)]).collect();
        let remark = format!("The foundation is cut off at the depth {}.", significant(limit, DIGITS));
        return Ground { line, remark: Some(remark) };
    }
    Ground { line, remark: None }
}

fn zip(x: &[f64], y: &[f64]) -> Vec<Place> {
    x.iter().zip(y).map(|(&x, &y)| [x, y]).collect()
}

fn along(scene: &Scene, units: &UnitLabels) -> Axis {
    Axis { padding: 0.03, ..Axis::new("").unit(units.length.clone()).including(&[0.0, scene.beam().length()]) }
}

/// An extreme, labelled with its value and its place.
fn extreme(name: &str, at: f64, value: f64, unit: Option<&String>, length: Option<&String>) -> Layer {
    let text = format!("{name} = {} at x = {}", with_unit(value, unit), with_unit(at, length));
    Layer::Note { at: [at, value], text, dot: true }
}

/// Labels for both extremes, each only if it stands out from zero.
fn extremes(name: &str, e: &Extremes, unit: Option<&String>, length: Option<&String>) -> Result<Vec<Layer>, PlotError> {
    /// A value below this part of the other extreme lies on the zero line of the drawing.
    const VISIBLE: f64 = 0.02;
    for value in [e.max, e.max_at, e.min, e.min_at] {
        finite("an extreme or its place", value)?;
    }
    let most = e.max.abs().max(e.min.abs());
    let mut notes = Vec::new();
    if VISIBLE * most < e.max {
        notes.push(extreme(name, e.max_at, e.max, unit, length));
    }
    if e.min < -VISIBLE * most {
        notes.push(extreme(name, e.min_at, e.min, unit, length));
    }
    Ok(notes)
}

fn zero_line(scene: &Scene) -> Layer {
    let points = vec![[0.0, 0.0], [scene.beam().length(), 0.0]];
    let style = Style { width: 3, ..Style::solid(Color::BLACK) };
    Layer::Series { points, style, label: String::new() }
}

fn shape(scene: &Scene, curves: &Curves, ground: &Ground, units: &UnitLabels) -> Result<Panel, PlotError> {
    let length = scene.beam().length();
    let y = Axis::new("deflection v and foundation u, downwards").unit(units.length.clone()).down().including(&[0.0]);
    let mut panel = Panel::new(along(scene, units), y).tall(640.0);
    if !ground.line.is_empty() {
        panel = panel.with(Layer::Foundation { points: ground.line.clone(), label: "foundation u(x)".to_owned() });
    }
    let sketch = sketch(scene, curves, units);
    let load = !sketch.is_empty();
    // For a block of load and its value, and for the longer arrows of point loads.
    let headroom = match (load, sketch.points.is_empty()) {
        (false, _) => 40.0,
        (true, true) => 190.0,
        (true, false) => 280.0,
    };
    panel = panel
        .with(Layer::Supports { at: [[0.0, 0.0], [length, 0.0]] })
        .with(Layer::Series {
            points: zip(&curves.x, &curves.deflection),
            style: Style { width: 9, ..Style::solid(Color::BLACK) },
            label: "beam v(x)".to_owned(),
        })
        .room(headroom, 30.0);
    if load {
        panel = panel.with(Layer::Load(sketch));
    }
    for note in extremes("v", &curves.deflection_extremes, units.length.as_ref(), units.length.as_ref())? {
        panel = panel.with(note);
    }
    Ok(panel)
}

/// `q(x)` as a line with its steps, and the point loads.
fn sketch(scene: &Scene, curves: &Curves, units: &UnitLabels) -> LoadSketch {
    let (load, length) = (scene.load(), scene.beam().length());
    let mut cuts: Vec<f64> = load.linear().iter().flat_map(|q| [q.from, q.to]).chain([0.0, length]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by_key(|x| x.to_bits());
    let mut intensity = Vec::new();
    let mut values: Vec<(f64, f64, String)> = Vec::new();
    for pair in cuts.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let middle = 0.5 * (from + to);
        let q = |x: f64| {
            let linear = load.linear().iter().filter(|q| (q.from..=q.to).contains(&middle)).map(|q| q.intensity(x));
            load.uniform() + linear.sum::<f64>()
        };
        let (start, end) = (q(from), q(to));
        intensity.extend([[from, start], [to, end]]);
        let text = |value: f64| format!("q = {}", with_unit(value, units.pressure.as_ref()));
        if start.to_bits() == end.to_bits() {
            if start != 0.0 {
                values.push((middle, start, text(start)));
            }
        } else if end.abs() < start.abs() {
            values.push((from, start, text(start)));
        } else {
            values.push((to, end, text(end)));
        }
    }
    let points = load.point().iter().map(|p| (p.at, p.force, with_unit(p.force.abs(), units.force.as_ref()))).collect();
    // Above the highest point of the beam, which may rise above the line of its supports.
    let level = curves.deflection.iter().fold(0.0_f64, |least, v| least.min(*v));
    LoadSketch { level, intensity, values, points }
}

/// No panel where there is no foundation.
fn clearance(scene: &Scene, curves: &Curves, units: &UnitLabels) -> Result<Option<Panel>, PlotError> {
    if scene.foundation().is_none() {
        return Ok(None);
    }
    let points = zip(&curves.x, &curves.clearance);
    let most = Extremes::of(points.iter().map(|p| (p[0], p[1])));
    finite("a clearance above a foundation", most.max)?;
    let y = Axis::new("clearance h = u − v").unit(units.length.clone()).including(&[0.0]);
    let mut panel = Panel::new(along(scene, units), y).tall(330.0).room(50.0, 20.0).with(Layer::Series {
        points,
        style: Style::solid(Color::BLUE),
        label: String::new(),
    });
    if !curves.contacts.is_empty() {
        let intervals = curves.contacts.clone();
        panel = panel.with(Layer::Zones { intervals, level: 0.0, label: "contact".to_owned() });
    }
    if curves.contacts.is_empty() {
        panel = panel.with(extreme("h", most.min_at, most.min, units.length.as_ref(), units.length.as_ref()));
    } else if 0.0 < most.max {
        panel = panel.with(extreme("h", most.max_at, most.max, units.length.as_ref(), units.length.as_ref()));
    }
    Ok(Some(panel))
}

fn forces(scene: &Scene, curves: &Curves, units: &UnitLabels) -> Result<Panel, PlotError> {
    /// Of more forces than this only the largest are written, and only where there is room.
    const CROWD: usize = 12;
    /// Length of the arrow of the largest force \[drawing units\].
    const LONGEST: f64 = 280.0;
    let length = scene.beam().length();
    let distributed = curves.pressure.iter().any(|zone| !zone.is_empty());
    let y = if distributed {
        Axis::new("contact pressure p, and forces as arrows").unit(units.pressure.clone()).including(&[0.0])
    } else {
        Axis::new("contact forces and reactions, as arrows").including(&[0.0]).bare()
    };
    let reactions = [(0.0, curves.reactions.left), (length, curves.reactions.right)];
    let all = || curves.point_forces.iter().map(|f| f.force).chain(reactions.map(|r| r.1));
    // A number that is not finite must reach the check when it is drawn, which `max` would hide.
    let full = all().fold(0.0_f64, |most, f| if f.is_finite() { most.max(f.abs()) } else { f });
    // Arrows that point downwards, at a support that holds the beam down, need room of their own.
    let down = if 0.0 < full { LONGEST * all().fold(0.0_f64, |most, f| most.max(-f)) / full } else { 0.0 };
    let height = 430.0 + down;
    let above = if distributed { 150.0 } else { 330.0 };
    let mut panel = Panel::new(along(scene, units), y).tall(height).room(above, 50.0 + down);
    for (i, zone) in curves.pressure.iter().enumerate() {
        let label = if i == 0 { "contact pressure" } else { "" };
        panel = panel.with(Layer::Area {
            points: zone.clone(),
            level: 0.0,
            color: Color::VERMILLION,
            label: label.to_owned(),
        });
    }
    let arrow = |at: f64, force: f64, optional: bool| Arrow {
        at: [at, 0.0],
        force,
        text: with_unit(force, units.force.as_ref()),
        optional,
    };
    let layer = |arrows: Vec<Arrow>, color: Color, label: &str| {
        Layer::Arrows(Arrows {
            arrows,
            full,
            part: LONGEST / height,
            color,
            dash: Dash::Solid,
            label: label.to_owned(),
        })
    };
    panel = panel.with(zero_line(scene));
    let shared = curves.point_forces.iter().map(|f| f.nodes).max().unwrap_or(1);
    let name = if 1 < shared {
        format!("contact force (at the ends of a zone: {shared} nodes as one)")
    } else {
        "contact force".to_owned()
    };
    // Of many forces only the largest are written.
    let mut by_size: Vec<usize> = (0..curves.point_forces.len()).collect();
    by_size.sort_by(|&i, &j| curves.point_forces[j].force.abs().total_cmp(&curves.point_forces[i].force.abs()));
    let crowd = CROWD < by_size.len();
    let mut contact: Vec<Arrow> = curves.point_forces.iter().map(|f| arrow(f.at, f.force, crowd)).collect();
    for &i in by_size.iter().skip(CROWD) {
        contact[i].text.clear();
    }
    if !contact.is_empty() {
        panel = panel.with(layer(contact, Color::VERMILLION, &name));
    }
    let supports = reactions.map(|(at, force)| arrow(at, force, false)).to_vec();
    Ok(panel.with(layer(supports, Color::BLACK, "reaction")))
}

fn moment(scene: &Scene, curves: &Curves, units: &UnitLabels) -> Result<Panel, PlotError> {
    let y = Axis::new("bending moment M, on the side in tension").unit(units.moment.clone()).down().including(&[0.0]);
    let mut panel = Panel::new(along(scene, units), y).tall(400.0).room(50.0, 50.0).with(zero_line(scene));
    panel = panel.with(Layer::Area {
        points: zip(&curves.x, &curves.moment),
        level: 0.0,
        color: Color::BLUE,
        label: String::new(),
    });
    for note in extremes("M", &curves.moment_extremes, units.moment.as_ref(), units.length.as_ref())? {
        panel = panel.with(note);
    }
    Ok(panel)
}

fn shear(scene: &Scene, curves: &Curves, units: &UnitLabels) -> Result<Panel, PlotError> {
    let y = Axis::new("shear force V = dM/dx").unit(units.force.clone()).including(&[0.0]);
    let mut panel = Panel::new(along(scene, units), y).tall(400.0).room(50.0, 50.0).with(zero_line(scene));
    panel =
        panel.with(Layer::Area { points: curves.shear.clone(), level: 0.0, color: Color::GREEN, label: String::new() });
    let ends = Extremes::of(curves.shear.iter().map(|p| (p[0], p[1])));
    for note in extremes("V", &ends, units.force.as_ref(), units.length.as_ref())? {
        panel = panel.with(note);
    }
    Ok(panel)
}

/// The figure in words.
fn description(curves: &Curves, ground: &Ground, units: &UnitLabels) -> String {
    let length = units.length.as_ref();
    let mut parts = vec![format!(
        "From top to bottom: deflected beam{}, contact forces, bending moment and shear force along the beam; deflection \
         and moment are positive downwards.",
        if ground.remark.is_some() && ground.line.is_empty() { "" } else { " above its foundation, clearance" }
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
