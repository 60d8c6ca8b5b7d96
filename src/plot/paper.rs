//! The figures of the paper: contact forces and deflection of its example, beside beam theory.
//!
//! Plain numbers in, a drawing out: nothing here solves anything.

use super::DIGITS;
use super::axis::Axis;
use super::figure::Figure;
use super::layer::{Arrow, Arrows, Layer, Place, Reference};
use super::palette::{Color, Dash, Marker, Style};
use super::panel::Panel;
use super::{PlotError, finite, same_length};
use crate::text::significant;

// Discrepancy: figures-redrawn
//
// The drawings of the paper's figures are lost, and the text speaks of contact pressure. Figures 4 and 7 show contact forces
// at the nodes instead: beam theory has a point force at the lift-off point, which is no pressure, and forces at nodes and
// that force are read on one axis. The pressure of a node is its force over the spacing. Theory and method stand in the same
// place over the whole beam; a second panel shows the left lift-off point larger, and a third one the sum of the contact
// forces from the left end. Figure 8 has a second panel with the difference from beam theory.

/// Beam theory on a flat foundation with a contact zone: the paper's reference solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Theory<'a> {
    /// `l`.
    pub length: f64,
    /// `a`, length over which the beam is lifted off at each end.
    pub lift_off: f64,
    /// Contact pressure in the contact zone, `q₀`.
    pub pressure: f64,
    /// Concentrated force at each end of the contact zone, `T`.
    pub end_force: f64,
    /// Depth of the foundation, `u₀`.
    pub depth: f64,
    /// `[x, v]` over the whole beam, close enough to be joined by straight lines.
    pub deflection: &'a [Place],
}

/// Nodal values of one method on equal intervals, interior nodes only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nodal<'a> {
    /// Name in the figure.
    pub label: &'a str,
    /// Places.
    pub x: &'a [f64],
    /// `v`.
    pub deflection: &'a [f64],
    /// Contact forces `p_i`: forces, not densities.
    pub contact_force: &'a [f64],
}

/// Contact forces over the whole beam, at the left lift-off point, and summed from the left end: Figures 4 and 7.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, lists of unequal length and fewer than two nodes.
pub fn contact(title: &str, description: &str, theory: &Theory<'_>, nodal: &Nodal<'_>) -> Result<String, PlotError> {
    /// Intervals that are shown on either side of the lift-off point.
    const BEFORE: f64 = 1.4;
    const BEHIND: f64 = 4.4;
    same_length("the contact forces", nodal.contact_force, nodal.x)?;
    let [first, second, ..] = nodal.x else {
        return Err(PlotError::Empty { what: "a list of two or more nodes" });
    };
    let (l, a, step) = (theory.length, theory.lift_off, second - first);
    let whole = forces_panel(theory, nodal, step, None, "contact force at each node").wide();
    let near = [(a - BEFORE * step).max(0.0), (a + BEHIND * step).min(l)];
    let zoom = forces_panel(theory, nodal, step, Some(near), "at the left lift-off point");
    let description = format!(
        "{description} Beam theory, dashed: {} for each interval of the contact zone, and a point force T = {} at its end x = \
         {}. Arrows: nodal forces by {}.",
        significant(theory.pressure * step, DIGITS),
        significant(theory.end_force, DIGITS),
        significant(a, DIGITS),
        nodal.label,
    );
    let figure = Figure::new(title, description, vec![whole, zoom, sum_panel(theory, nodal)]);
    Figure { columns: 2, ..figure }.svg()
}

/// Nodal forces and those of beam theory over the whole beam or between two places.
fn forces_panel(theory: &Theory<'_>, nodal: &Nodal<'_>, step: f64, window: Option<[f64; 2]>, name: &str) -> Panel {
    let (l, a) = (theory.length, theory.lift_off);
    let all = window.is_none();
    let [from, to] = window.unwrap_or([0.0, l]);
    let level = theory.pressure * step;
    let inside = |x: f64| from <= x && x <= to;
    let arrow = |x: f64, force: f64, text: String| Arrow { at: [x, 0.0], force, text, optional: false };
    // Over the whole beam T is written at the left end and the nodal force that stands for it at the right one; at the lift-off
    // point the first forces are written.
    const FIRST: usize = 3;
    let nodes: Vec<(f64, f64)> = nodal.x.iter().copied().zip(nodal.contact_force.iter().copied()).collect();
    let touching: Vec<f64> = nodes.iter().filter(|node| node.1 != 0.0).map(|node| node.0).collect();
    let written = if all { touching.len().saturating_sub(1)..touching.len() } else { 0..FIRST.min(touching.len()) };
    let written = &touching[written];
    let forces = nodes.into_iter().filter(|(x, _)| inside(*x)).map(|(x, force)| {
        let text = if written.contains(&x) { significant(force, DIGITS) } else { String::new() };
        arrow(x, force, text)
    });
    let forces = forces.collect();
    let ends = [(a, format!("T = {}", significant(theory.end_force, DIGITS))), (l - a, String::new())];
    let ends = ends.into_iter().filter(|(x, _)| inside(*x));
    let theory_arrows = ends.map(|(x, text)| arrow(x, theory.end_force, text)).collect();
    let arrows = |arrows: Vec<Arrow>, color: Color, dash: Dash| Layer::Arrows(Arrows { arrows, color, dash });
    let most = nodal.contact_force.iter().fold(theory.end_force, |most, force| most.max(*force));
    let axis = Axis { padding: 0.02, ..Axis::new(name).including(&[0.0, most]) };
    let label =
        if all { format!("beam theory: q₀Δ = {} and T", significant(level, DIGITS)) } else { "q₀Δ".to_owned() };
    let words = |at: Place, color: Color, label: &str| {
        Layer::named(vec![at], Style { color, dash: None, marker: None, width: 0 }, label)
    };
    let mut panel = Panel::new(along([from, to]), axis)
        .tall(620.0)
        .room(70.0, 10.0)
        .with(beam([from, to]))
        .with(arrows(theory_arrows, Color::GRAY, Dash::Dashed))
        .with(arrows(forces, Color::BLUE, Dash::Solid))
        .with(Layer::line(vec![[a.max(from), level], [(l - a).min(to), level]], Style::theory()));
    if all {
        panel = panel.with(words([0.5 * l, 2.4 * level], Color::BLUE, nodal.label)).with(words(
            [0.5 * l, 1.4 * level],
            Color::GRAY,
            &label,
        ));
    }
    panel
}

/// The sum of the contact forces from the left end.
fn sum_panel(theory: &Theory<'_>, nodal: &Nodal<'_>) -> Panel {
    let (l, a, t) = (theory.length, theory.lift_off, theory.end_force);
    let inner = t + theory.pressure * (l - 2.0 * a);
    let mut sum = 0.0;
    let mut steps = vec![[0.0, 0.0]];
    for (&x, &force) in nodal.x.iter().zip(nodal.contact_force) {
        steps.push([x, sum]);
        sum += force;
        steps.push([x, sum]);
    }
    steps.push([l, sum]);
    let dashed = vec![[0.0, 0.0], [a, 0.0], [a, t], [l - a, inner], [l - a, inner + t], [l, inner + t]];
    let style = Style { color: Color::BLACK, ..Style::theory() };
    Panel::new(along([0.0, l]), Axis::new("their sum from the left end"))
        .tall(620.0)
        .with(Layer::line(steps, Style::solid(Color::BLUE)))
        .with(Layer::line(dashed, style))
}

/// Deflection by one or more methods beside beam theory, and the difference: Figure 8.
///
/// # Errors
///
/// As [`contact`].
pub fn shape(title: &str, description: &str, theory: &Theory<'_>, nodal: &[Nodal<'_>]) -> Result<String, PlotError> {
    const LOOKS: [(Color, Marker); 3] =
        [(Color::BLUE, Marker::OpenCircle), (Color::VERMILLION, Marker::Plus), (Color::GREEN, Marker::Cross)];
    /// By what the differences are multiplied.
    const LARGER: f64 = 1000.0;
    let (l, a) = (theory.length, theory.lift_off);
    let axis = Axis::new("deflection v, downwards, beside the depth u₀").down().including(&[0.0]);
    let mut shapes = Panel::new(along([0.0, l]), axis)
        .tall(560.0)
        .room(40.0, 60.0)
        .with(Layer::Foundation { points: vec![[0.0, theory.depth], [l, theory.depth]] })
        .with(beam([0.0, l]))
        .with(Layer::Supports { at: [[0.0, 0.0], [l, 0.0]] })
        .with(Layer::line(theory.deflection.to_vec(), Style::theory()));
    let mut differences = Panel::new(along([0.0, l]), Axis::new("1000 × (v − v of beam theory)").including(&[0.0]))
        .tall(460.0)
        .with(beam([0.0, l]));
    // The names stand one above the other at mid-span, where there is room above the beam.
    let mut name = [0.5 * l, 0.1 * theory.depth];
    for (nodal, &(color, marker)) in nodal.iter().zip(LOOKS.iter().cycle()) {
        same_length("the deflections", nodal.deflection, nodal.x)?;
        let style = Style::marks(color, marker);
        let points: Vec<Place> = nodal.x.iter().zip(nodal.deflection).map(|(&x, &v)| [x, v]).collect();
        let off = |&[x, v]: &Place| -> Result<Place, PlotError> {
            Ok([x, LARGER * (v - at(theory.deflection, finite("a place", x)?))])
        };
        let points_off = points.iter().map(off).collect::<Result<_, _>>()?;
        name[1] += 0.25 * theory.depth;
        shapes = shapes.with(Layer::line(points, style)).with(Layer::named(vec![name], style, nodal.label));
        differences = differences.with(Layer::line(points_off, style));
    }
    for (x, name) in [(a, "a"), (l - a, "l − a")] {
        let text = format!("{name} = {}", significant(x, DIGITS));
        shapes = shapes.with(Layer::Reference { at: Reference::X(x), text });
        differences = differences.with(Layer::Reference { at: Reference::X(x), text: String::new() });
    }
    Figure::new(title, description, vec![shapes, differences]).svg()
}

/// A curve between its points.
fn at(curve: &[Place], x: f64) -> f64 {
    let k = curve.partition_point(|p| p[0] <= x);
    match (k.checked_sub(1).and_then(|k| curve.get(k)), curve.get(k)) {
        (Some(&[from, start]), Some(&[to, end])) => start + (end - start) * (x - from) / (to - from),
        (Some(p), None) | (None, Some(p)) => p[1],
        (None, None) => 0.0,
    }
}

fn along(range: [f64; 2]) -> Axis {
    Axis { padding: 0.03, ..Axis::new("x").including(&range) }
}

/// The line of the unloaded beam.
fn beam([from, to]: [f64; 2]) -> Layer {
    let style = Style { width: 3, ..Style::solid(Color::BLACK) };
    Layer::line(vec![[from, 0.0], [to, 0.0]], style)
}

#[cfg(test)]
mod tests {
    use super::{Nodal, PlotError, Theory, contact, shape};

    const THEORY: Theory<'static> = Theory {
        length: 8.0,
        lift_off: 2.25,
        pressure: 1.5,
        end_force: 1.6875,
        depth: 1.0,
        deflection: &[[0.0, 0.0], [2.25, 1.0], [5.75, 1.0], [8.0, 0.0]],
    };
    const X: [f64; 7] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    const NODAL: Nodal<'static> = Nodal {
        label: "a < b",
        x: &X,
        deflection: &[0.5, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5],
        contact_force: &[0.0, 2.125, 1.25, 1.5, 1.25, 2.125, 0.0],
    };

    #[test]
    fn theory_and_method_stand_beside_each_other() {
        let svg = contact("Figure", "The example.", &THEORY, &NODAL).expect("a figure");
        for text in [">T = 1.688<", ">2.125<", ">1.25<", ">a &lt; b<", "<desc id=\"desc\">The example. Beam theory"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }

    /// Height of the arrow of a colour that is the longest, in drawing units, head included.
    fn longest(svg: &str, color: &str) -> f64 {
        // Where a shaft begins, and the tip, the first corner of its head.
        let first = |line: &str, before: &str| -> Option<f64> {
            line.split(before).nth(1)?.split([' ', '"', 'M']).next()?.split(',').nth(1)?.parse().ok()
        };
        let shaft = format!("stroke=\"{color}\" stroke-width=\"7\"");
        let lines: Vec<&str> = svg.lines().collect();
        let arrows = lines.windows(2).filter(|pair| pair[0].contains(&shaft));
        arrows.filter_map(|pair| Some(first(pair[0], " d=\"M")? - first(pair[1], "points=\"")?)).fold(0.0, f64::max)
    }

    #[test]
    fn arrows_of_theory_and_method_are_on_one_scale() {
        let svg = contact("Figure", "", &THEORY, &NODAL).expect("a figure");
        let (nodal, theory) = (longest(&svg, "#0072B2"), longest(&svg, "#5A5A5A"));
        assert!((nodal / theory - 2.125 / 1.6875).abs() < 0.01, "{nodal} for 2.125, {theory} for 1.6875");
    }

    #[test]
    fn broken_data_are_refused() {
        let nan = Theory { end_force: f64::NAN, ..THEORY };
        assert!(matches!(contact("", "", &nan, &NODAL), Err(PlotError::NotFinite { .. })), "NaN");
        let short = Nodal { contact_force: &[1.0], ..NODAL };
        assert!(matches!(contact("", "", &THEORY, &short), Err(PlotError::LengthMismatch { .. })), "lengths");
        let one = Nodal { x: &[4.0], contact_force: &[1.0], ..NODAL };
        assert!(matches!(contact("", "", &THEORY, &one), Err(PlotError::Empty { .. })), "one node");
        assert!(shape("", "", &THEORY, &[]).is_ok(), "theory alone is a figure");
    }
}
