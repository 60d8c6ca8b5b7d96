//! The drawings of Figures 4, 7 and 8: contact forces and deflection of the paper's example, beside beam theory.

use palkki::plot::{Arrow, Arrows, Axis, Color, Dash, Divisions, Layer, Marker, Panel, Place, Style, significant};
use palkki::state::Nodes;
use palkki_evidence::closed::FlatSolution;

// Discrepancy: figures-redrawn
//
// The text speaks of contact pressure. Figures 4 and 7 show nodal forces, the pressure times the spacing. The panels of the left
// lift-off point, of the sums, and of the difference from beam theory are ours.

/// Digits of a value that is written beside the point that it belongs to.
const DIGITS: usize = 4;

/// Beam theory of the example: its length `l`, where it lifts off, the contact pressure between, and the rest of the solution.
#[derive(Debug, Clone, Copy)]
pub(super) struct Theory {
    length: f64,
    pub(super) lift_off: f64,
    pub(super) pressure: f64,
    solution: FlatSolution,
}

impl Theory {
    pub(super) fn new(length: f64, solution: FlatSolution) -> Self {
        let lift_off = solution.lift_off.unwrap_or_default();
        Self { length, lift_off, pressure: solution.pressure(0.5 * length), solution }
    }

    fn end_force(&self) -> f64 {
        self.solution.end_force
    }
}

/// Nodal values of one method, and its name in the figure.
pub(super) type Nodal<'a> = (&'a str, &'a Nodes);

/// Contact forces over the whole beam, at the left lift-off point, and summed from the left end: Figures 4 and 7.
pub(super) fn contact(theory: &Theory, (label, nodes): Nodal<'_>) -> Vec<Panel> {
    /// Intervals that are shown on either side of the lift-off point.
    const BEFORE: f64 = 1.4;
    const BEHIND: f64 = 4.4;
    let [first, second, ..] = nodes.x[..] else { return Vec::new() };
    let (l, a, step) = (theory.length, theory.lift_off, second - first);
    let whole = forces_panel(theory, (label, nodes), step, None, "contact force at each node [force]").wide();
    let near = [(a - BEFORE * step).max(0.0), (a + BEHIND * step).min(l)];
    let zoom = forces_panel(theory, (label, nodes), step, Some(near), "at the left lift-off point [force]");
    vec![whole, zoom, sum_panel(theory, nodes)]
}

/// Nodal forces and those of beam theory over the whole beam or between two places.
fn forces_panel(theory: &Theory, (method, nodes): Nodal<'_>, step: f64, window: Option<[f64; 2]>, name: &str) -> Panel {
    let (l, a) = (theory.length, theory.lift_off);
    let all = window.is_none();
    let [from, to] = window.unwrap_or([0.0, l]);
    let level = theory.pressure * step;
    let inside = |x: f64| from <= x && x <= to;
    let arrow = |x: f64, force: f64, text: String| Arrow { at: [x, 0.0], force, text, optional: false };
    // Over the whole beam T is written at the left end and the nodal force that stands for it at the right one; at the lift-off
    // point the first forces are written.
    const FIRST: usize = 3;
    let forces: Vec<(f64, f64)> = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect();
    let touching: Vec<f64> = forces.iter().filter(|node| node.1 != 0.0).map(|node| node.0).collect();
    let written = if all { touching.len().saturating_sub(1)..touching.len() } else { 0..FIRST.min(touching.len()) };
    let written = &touching[written];
    let forces = forces.into_iter().filter(|(x, _)| inside(*x)).map(|(x, force)| {
        let text = if written.contains(&x) { significant(force, DIGITS) } else { String::new() };
        arrow(x, force, text)
    });
    let forces = forces.collect();
    let ends = [(a, format!("T = {}", significant(theory.end_force(), DIGITS))), (l - a, String::new())];
    let ends = ends.into_iter().filter(|(x, _)| inside(*x));
    let theory_arrows = ends.map(|(x, text)| arrow(x, theory.end_force(), text)).collect();
    let arrows = |arrows: Vec<Arrow>, color: Color, dash: Dash| Layer::Arrows(Arrows { arrows, color, dash });
    let most = nodes.contact_force.iter().fold(theory.end_force(), |most, force| most.max(*force));
    let axis = Axis { padding: 0.02, ..Axis::new(name).including(&[0.0, most]) };
    let label =
        if all { format!("beam theory: q₀Δ = {} and T", significant(level, DIGITS)) } else { "q₀Δ".to_owned() };
    let mut panel = Panel::new(Axis::along("x [length]", [from, to]), axis)
        .tall(620.0)
        .room(85.0, 10.0)
        .with(Layer::zero_line([from, to]))
        .with(arrows(theory_arrows, Color::GRAY, Dash::Dashed))
        .with(arrows(forces, Color::BLUE, Dash::Solid))
        .with(Layer::line(vec![[a.max(from), level], [(l - a).min(to), level]], Style::theory()));
    if all {
        panel = panel.with(Layer::words([0.5 * l, 2.4 * level], Color::BLUE, method)).with(Layer::words(
            [0.5 * l, 1.4 * level],
            Color::GRAY,
            label,
        ));
    }
    panel
}

/// The sum of the contact forces from the left end.
fn sum_panel(theory: &Theory, nodes: &Nodes) -> Panel {
    let (l, a, t) = (theory.length, theory.lift_off, theory.end_force());
    let inner = t + theory.pressure * (l - 2.0 * a);
    let mut sum = 0.0;
    let mut steps = vec![[0.0, 0.0]];
    for (&x, &force) in nodes.x.iter().zip(&nodes.contact_force) {
        steps.push([x, sum]);
        sum += force;
        steps.push([x, sum]);
    }
    steps.push([l, sum]);
    let dashed = vec![[0.0, 0.0], [a, 0.0], [a, t], [l - a, inner], [l - a, inner + t], [l, inner + t]];
    let style = Style { color: Color::BLACK, ..Style::theory() };
    Panel::new(Axis::along("x [length]", [0.0, l]), Axis::new("sum of the forces from the left end [force]"))
        .tall(620.0)
        .with(Layer::line(steps, Style::solid(Color::BLUE)))
        .with(Layer::line(dashed, style))
}

/// Deflection by some methods beside beam theory, and the difference: Figure 8. The ground is at the depth of 1.
pub(super) fn shape(theory: &Theory, methods: &[Nodal<'_>]) -> Vec<Panel> {
    const LOOKS: [(Color, Marker); 2] = [(Color::BLUE, Marker::OpenCircle), (Color::VERMILLION, Marker::Plus)];
    const DEPTH: f64 = 1.0;
    /// Where the deflection of beam theory is evaluated for its dashed line.
    const SAMPLES: u32 = 400;
    /// By what the differences are multiplied.
    const LARGER: f64 = 1000.0;
    let (l, a) = (theory.length, theory.lift_off);
    let places = (0..=SAMPLES).map(|i| l * f64::from(i) / f64::from(SAMPLES));
    let line = places.map(|x| [x, theory.solution.deflection(x)]).collect();
    let axis = Axis::new("deflection v and depth u₀, downwards [length]").down().including(&[0.0]);
    let mut shapes = Panel::new(Axis::along("x [length]", [0.0, l]), axis)
        .with(Layer::Foundation { points: vec![[0.0, DEPTH], [l, DEPTH]] })
        .with(Layer::zero_line([0.0, l]))
        .with(Layer::simple_supports(l))
        .with(Layer::line(line, Style::theory()));
    let mut differences = Panel::new(
        Axis::along("x [length]", [0.0, l]),
        Axis::new("1000 × (v − v of beam theory) [length]").including(&[0.0]),
    )
    .tall(460.0)
    .with(Layer::zero_line([0.0, l]));
    // The names stand one above the other at mid-span, where there is room above the beam.
    let mut name = [0.5 * l, 0.1 * DEPTH];
    for ((label, nodes), (color, marker)) in methods.iter().zip(LOOKS) {
        let style = Style::marks(color, marker);
        let points: Vec<Place> = nodes.x.iter().zip(&nodes.deflection).map(|(&x, &v)| [x, v]).collect();
        let off = points.iter().map(|&[x, v]| [x, LARGER * (v - theory.solution.deflection(x))]).collect();
        name[1] += 0.25 * DEPTH;
        shapes = shapes.with(Layer::line(points, style)).with(Layer::named(vec![name], style, *label));
        differences = differences.with(Layer::line(off, style));
    }
    let lines = [("a", a), ("l − a", l - a)];
    let named = lines.map(|(name, x)| (x, format!("{name} = {}", significant(x, DIGITS)))).to_vec();
    let lift_off = Divisions { lines: named, between: Vec::new() };
    let headroom = lift_off.headroom();
    let shapes = shapes.with(Layer::Divisions(lift_off)).tall(560.0 + headroom).room(headroom, 60.0);
    let unnamed = lines.map(|(_, x)| (x, String::new())).to_vec();
    let differences = differences.with(Layer::Divisions(Divisions { lines: unnamed, between: Vec::new() }));
    vec![shapes, differences]
}
