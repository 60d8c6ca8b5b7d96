//! The figures of the paper: contact pressure and deflection of its example, beside beam theory.
//!
//! Plain numbers in, a drawing out: nothing here solves anything.

use super::axis::Axis;
use super::error::{PlotError, finite, same_length};
use super::figure::Figure;
use super::layer::{Arrow, Arrows, Layer, Place, Reference};
use super::number::{DIGITS, significant};
use super::palette::{Color, Dash, Marker, Style};
use super::panel::Panel;

// Discrepancy: figures-halves
//
// The drawings of the paper's figures are lost. Figure 4 carried two labels, beam theory and finite differences; here
// they take a half of the beam each, in Figure 7 as well. The example is symmetric, so nothing is lost, and the point
// force of beam theory at the lift-off point does not cover the nodal force that stands for it, a fraction of an interval
// away. Tried: both over the whole beam; the arrows cannot be told apart.

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
    /// Name in the legend.
    pub label: &'a str,
    /// Places.
    pub x: &'a [f64],
    /// `v`.
    pub deflection: &'a [f64],
    /// Contact forces `p_i`: forces, not densities.
    pub contact_force: &'a [f64],
}

/// So many nodal forces at the end of the contact are drawn as arrows: a point force between two nodes is shared by them.
const END_NODES: usize = 2;

/// Contact pressure above, deflection below: Figure 4.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite, lists of unequal length and fewer than two nodes.
pub fn pressure_and_shape(
    title: &str,
    description: &str,
    theory: &Theory<'_>,
    nodal: &Nodal<'_>,
) -> Result<String, PlotError> {
    let panels = vec![pressure_panel(theory, nodal)?, shape_panel(theory, &[*nodal])?];
    Figure::new(title, described(description, theory, nodal), panels).svg()
}

/// Contact pressure: the first of Figures 7 and 8.
///
/// # Errors
///
/// As [`pressure_and_shape`].
pub fn pressure(title: &str, description: &str, theory: &Theory<'_>, nodal: &Nodal<'_>) -> Result<String, PlotError> {
    let panels = vec![pressure_panel(theory, nodal)?];
    Figure::new(title, described(description, theory, nodal), panels).svg()
}

/// Deflection by one or more methods: the second of Figures 7 and 8.
///
/// # Errors
///
/// As [`pressure_and_shape`].
pub fn shape(title: &str, description: &str, theory: &Theory<'_>, nodal: &[Nodal<'_>]) -> Result<String, PlotError> {
    Figure::new(title, description, vec![shape_panel(theory, nodal)?]).svg()
}

/// The arrows of the right half, outermost first.
fn end_forces(nodal: &Nodal<'_>, length: f64) -> Vec<(f64, f64)> {
    let right = nodal.x.iter().zip(nodal.contact_force).map(|(&x, &f)| (x, f)).rev();
    right.filter(|&(x, f)| 0.5 * length < x && f != 0.0).take(END_NODES).collect()
}

fn described(description: &str, theory: &Theory<'_>, nodal: &Nodal<'_>) -> String {
    let forces: Vec<String> = end_forces(nodal, theory.length)
        .iter()
        .map(|&(x, f)| format!("{} at x = {}", significant(f, DIGITS), significant(x, DIGITS)))
        .collect();
    format!(
        "{description} Left half: beam theory, pressure {} from x = {} with a point force {} there. Right half: {}, outermost \
         contact forces {}.",
        significant(theory.pressure, DIGITS),
        significant(theory.lift_off, DIGITS),
        significant(theory.end_force, DIGITS),
        nodal.label,
        forces.join(" and "),
    )
}

fn pressure_panel(theory: &Theory<'_>, nodal: &Nodal<'_>) -> Result<Panel, PlotError> {
    same_length("the contact forces", nodal.contact_force, nodal.x)?;
    let [first, second, ..] = nodal.x else {
        return Err(PlotError::Empty { what: "a list of two or more nodes" });
    };
    let step = second - first;
    let (l, a, middle) = (theory.length, theory.lift_off, 0.5 * theory.length);
    let ends = end_forces(nodal, l);
    let innermost = ends.iter().fold(l, |least, &(x, _)| least.min(x));
    let inner = pressures(nodal, step, middle, innermost);
    let steps = inner.iter().flat_map(|&[x, p]| [[(x - 0.5 * step).max(middle), p], [x + 0.5 * step, p]]).collect();
    let mut full = theory.end_force.abs();
    for &(_, f) in &ends {
        full = full.max(finite("a contact force", f)?.abs());
    }
    let arrow = |at: f64, force: f64, name: &str| Arrow {
        at: [at, 0.0],
        force,
        text: format!("{name}{}", significant(force, DIGITS)),
        optional: false,
    };
    let arrows = |arrows: Vec<Arrow>, color: Color, dash: Dash, label: &str| {
        Layer::Arrows(Arrows { arrows, full, part: 0.62, color, dash, label: label.to_owned() })
    };
    let axis = Axis::new("contact pressure p, force per length, and contact forces as arrows").including(&[0.0]);
    let panel = Panel::new(along(l, "x"), axis)
        .tall(560.0)
        .room(230.0, 40.0)
        .with(Layer::Area {
            points: steps,
            level: 0.0,
            color: Color::BLUE,
            label: format!("right half: {}", nodal.label),
        })
        .with(Layer::Series {
            points: inner.into_iter().filter(|p| middle <= p[0]).collect(),
            style: Style::marks(Color::BLUE, Marker::Circle),
            label: String::new(),
        })
        .with(Layer::Area {
            points: vec![[a, theory.pressure], [middle, theory.pressure]],
            level: 0.0,
            color: Color::PALE,
            label: String::new(),
        })
        .with(beam(l, 0.0))
        .with(Layer::Series {
            points: vec![[a, 0.0], [a, theory.pressure], [l - a, theory.pressure]],
            style: Style::theory(),
            label: "beam theory: p = q₀".to_owned(),
        })
        .with(Layer::Reference { at: Reference::X(middle), text: String::new() })
        .with(arrows(ends.iter().map(|&(x, f)| arrow(x, f, "")).collect(), Color::BLUE, Dash::Solid, "nodal force"))
        .with(arrows(vec![arrow(a, theory.end_force, "T = ")], Color::GRAY, Dash::Dashed, "beam theory: T"));
    Ok(panel)
}

/// Contact forces per interval, `p_i / Δ`, from mid-span to the node before `end`.
fn pressures(nodal: &Nodal<'_>, step: f64, middle: f64, end: f64) -> Vec<Place> {
    let nodes = nodal.x.iter().zip(nodal.contact_force);
    let inside = nodes.filter(|&(&x, _)| middle <= x + 0.5 * step && x < end);
    inside.map(|(&x, &f)| [x, f / step]).collect()
}

fn shape_panel(theory: &Theory<'_>, nodal: &[Nodal<'_>]) -> Result<Panel, PlotError> {
    const MARKERS: [(Color, Marker); 3] =
        [(Color::BLUE, Marker::OpenCircle), (Color::VERMILLION, Marker::Plus), (Color::GREEN, Marker::Cross)];
    let (l, a) = (theory.length, theory.lift_off);
    let axis = Axis::new("deflection v, downwards").down().including(&[0.0]);
    let mut panel = Panel::new(along(l, "x"), axis)
        .tall(520.0)
        .room(40.0, 40.0)
        .with(Layer::Foundation {
            points: vec![[0.0, theory.depth], [l, theory.depth]],
            label: "foundation".to_owned(),
        })
        .with(beam(l, 0.0))
        .with(Layer::Supports { at: [[0.0, 0.0], [l, 0.0]] })
        .with(Layer::Series {
            points: theory.deflection.to_vec(),
            style: Style::theory(),
            label: "beam theory".to_owned(),
        });
    for (nodal, &(color, marker)) in nodal.iter().zip(MARKERS.iter().cycle()) {
        same_length("the deflections", nodal.deflection, nodal.x)?;
        let points = nodal.x.iter().zip(nodal.deflection).map(|(&x, &v)| [x, v]).collect();
        panel = panel.with(Layer::Series { points, style: Style::marks(color, marker), label: nodal.label.to_owned() });
    }
    for (x, name) in [(a, "a"), (l - a, "l − a")] {
        let text = format!("{name} = {}", significant(x, DIGITS));
        panel = panel.with(Layer::Reference { at: Reference::X(x), text });
    }
    Ok(panel)
}

fn along(length: f64, label: &str) -> Axis {
    Axis { padding: 0.03, ..Axis::new(label).including(&[0.0, length]) }
}

/// The line of the unloaded beam.
fn beam(length: f64, level: f64) -> Layer {
    let style = Style { width: 3, ..Style::solid(Color::BLACK) };
    Layer::Series { points: vec![[0.0, level], [length, level]], style, label: String::new() }
}

#[cfg(test)]
mod tests {
    use super::{Nodal, PlotError, Theory, pressure, pressure_and_shape, shape};

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
    fn point_forces_are_arrows_with_their_value() {
        let svg = pressure_and_shape("Figure", "The example.", &THEORY, &NODAL).expect("a figure");
        for text in [
            "T = 1.688",
            "\n2.125\n",
            "\n1.25\n",
            "a = 2.25",
            "right half: a &lt; b",
            "<desc id=\"desc\">The example. Left half",
        ] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }

    #[test]
    fn arrows_do_not_depend_on_the_spacing() {
        // The same forces on nodes that lie closer: the shafts keep their length.
        let shafts = |x: &[f64]| {
            let svg = pressure("Figure", "", &THEORY, &Nodal { x, ..NODAL }).expect("a figure");
            let heights = svg.lines().filter(|line| line.contains("#0072B2") && line.contains("stroke-width=\"7\""));
            heights
                .map(|line| line.split(',').skip(1).map(|y| y.split(' ').next().map(str::to_owned)).collect::<Vec<_>>())
                .collect::<Vec<_>>()
        };
        let close: Vec<f64> = X.iter().map(|x| 4.0 + 0.1 * (x - 4.0)).collect();
        assert_eq!(shafts(&X).len(), 3, "two arrows and one in the legend");
        assert_eq!(shafts(&X), shafts(&close));
    }

    #[test]
    fn broken_data_are_refused() {
        let nan = Theory { end_force: f64::NAN, ..THEORY };
        assert!(matches!(pressure("", "", &nan, &NODAL), Err(PlotError::NotFinite { .. })), "NaN");
        let short = Nodal { contact_force: &[1.0], ..NODAL };
        assert!(matches!(pressure("", "", &THEORY, &short), Err(PlotError::LengthMismatch { .. })), "lengths");
        let one = Nodal { x: &[4.0], contact_force: &[1.0], ..NODAL };
        assert!(matches!(pressure("", "", &THEORY, &one), Err(PlotError::Empty { .. })), "one node");
        assert!(shape("", "", &THEORY, &[]).is_ok(), "theory alone is a figure");
    }
}
