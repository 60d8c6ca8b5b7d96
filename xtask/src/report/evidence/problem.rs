//! The problem with a sketch, the three methods, and the three regimes of a flat foundation.

use std::fmt::Write as _;

use palkki::methods::Discrete;
use palkki::plot::{
    Arrow, Arrows, Axis, Color, Curves, Dash, Figure, Layer, LoadSketch, Marker, Panel, Place, PlotError, Reference,
    Style,
};
use palkki::scene::{Beam, Load};
use palkki::state::Regime;
use palkki_evidence::paper::{INTERVALS, beam, example, scene_over};

use super::prelude::*;

/// The problem, its notation and a sketch.
pub(super) fn sketch(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = scenes::read(study.root, "ridge")?;
    let exact = theory::solve(&scene)?;
    let curves = Curves::exact(&scene, &exact);
    let places = curves.x.iter().zip(&curves.deflection);
    let rows = places.map(|(&x, &v)| [fixed(x, 5), fixed(scene.depth(x), 5), fixed(v, 5)]);
    let data = Table::new(["x", "u", "v"]).rows(rows).one_a_place();
    let values = context! { title => scene.title(), contacts => exact.state.contacts.len() };
    Ok(Evidence::new(values).figure("problem", sketched(&scene, &curves)?, data))
}

fn sketched(scene: &Scene, curves: &Curves) -> Result<String, PlotError> {
    let l = scene.beam().length();
    let ground = match scene.foundation() {
        Some(Foundation::Polyline { points }) => points.clone(),
        _ => Vec::new(),
    };
    let deflected: Vec<[f64; 2]> = curves.x.iter().zip(&curves.deflection).map(|(&x, &v)| [x, v]).collect();
    let at = |x: f64| deflected.iter().find(|p| x <= p[0]).map_or(0.0, |p| p[1]);
    let arrow = |name: &str, force: f64, at: [f64; 2]| Arrow {
        at,
        force,
        text: format!("{name}{}", palkki::plot::significant(force, 3)),
        optional: true,
    };
    let full = curves.point_forces.iter().fold(0.0_f64, |most, f| most.max(f.force));
    let name = |force: f64| if force < full { "" } else { "contact force " };
    let contact = curves.point_forces.iter().map(|f| arrow(name(f.force), f.force, [f.at, at(f.at)])).collect();
    let names = std::iter::once("reaction ").chain(std::iter::repeat(""));
    let reactions = curves.supports.iter().zip(names).map(|(s, name)| arrow(name, s.force, [s.at, 0.0])).collect();
    let arrows = |arrows: Vec<Arrow>, color: Color| Layer::Arrows(Arrows { arrows, color, dash: Dash::Solid });
    let q = scene.load().uniform();
    let load = LoadSketch {
        level: 0.0,
        intensity: vec![[0.0, q], [l, q]],
        values: vec![(0.75 * l, q, "load q".to_owned())],
        points: Vec::new(),
    };
    let words = |at: [f64; 2], color: Color, text: &str| Layer::Series {
        points: vec![at],
        style: Style { dash: None, ..Style::solid(color) },
        label: text.to_owned(),
    };
    let lifted = 0.05 * l;
    let x = Axis { padding: 0.03, ..Axis::new("x, from the left support to the right one at l").including(&[0.0, l]) };
    let panel = Panel::new(x, Axis::new("depth and deflection, downwards").down().including(&[0.0]))
        .tall(880.0)
        .room(350.0, 130.0)
        .forces(Axis::new("").bare())
        .with(Layer::Foundation { points: ground })
        .with(Layer::Load(load))
        .with(Layer::Series {
            points: vec![[0.0, 0.0], [l, 0.0]],
            style: Style { width: 3, ..Style::theory() },
            label: String::new(),
        })
        .with(Layer::simple_supports(l))
        .with(Layer::Series { points: deflected.clone(), style: Style::solid(Color::BLUE), label: String::new() })
        .with(Layer::Series {
            points: vec![[lifted, at(lifted)], [lifted, scene.depth(lifted)]],
            style: Style { dash: Some(Dash::Dotted), ..Style::solid(Color::BLACK) },
            label: String::new(),
        })
        .with(words([lifted, 0.5 * (at(lifted) + scene.depth(lifted))], Color::BLACK, "clearance h = u − v"))
        .with(words([0.72 * l, 0.4 * scene.depth(0.72 * l)], Color::BLUE, "beam, deflection v(x)"))
        .with(words([0.5 * l, 1.2 * scene.depth(0.9 * l)], Color::BLACK, "rigid ground, depth u(x)"))
        .with(arrows(contact, Color::VERMILLION))
        .with(arrows(reactions, Color::GREEN));
    let description = "A beam on two supports, loaded from above, bends down to a foundation that is flat but for one ridge. It \
                       touches the flat ground at a point on one side and along a stretch on the other, and the ridge between them; \
                       elsewhere there is a clearance. Arrows show the concentrated contact forces and the reactions of the supports.";
    Figure::new(
        "The beam sags to the ground, rests where it touches, and spans what it cannot follow",
        description,
        vec![panel],
    )
    .svg()
}

/// Intervals of the grid that is printed.
const PRINTED: u8 = 4;

/// The three methods, with their matrices on a grid that is small enough to be read.
pub(super) fn methods(study: &Study<'_>) -> Result<Evidence, Cause> {
    // Spacing and stiffness are 1, so that the numbers are multiples of EI/Δ⁴, EI/Δ³ and Δ³/EI.
    let beam = Beam::new(f64::from(PRINTED), 1.0)?;
    let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
    let discrete = Discrete::new(&scene, usize::from(PRINTED))?;
    let n = discrete.interior();
    let mut matrices = String::new();
    for (method, name) in Method::ALL.into_iter().zip(["A of method 1, in EI/Δ⁴", "K, in EI/Δ³", "C, in Δ³/EI"])
    {
        let matrix = method.qp(&discrete).matrix();
        writeln!(matrices, "{name}")?;
        for i in 0..n {
            let row: String = (0..n).map(|j| format!("{:>10}", fixed(matrix.entry(i, j), 4))).collect();
            writeln!(matrices, "{row}")?;
        }
    }
    // The condition of K and C, as orders of magnitude.
    let digits = &study.ledger()?.recommendation.digits;
    let conditions: Vec<String> = digits
        .iter()
        .map(|d| format!("{} with {} intervals", power_of_ten(nearest_exponent(d.condition)), d.intervals))
        .collect();
    Ok(Evidence::new(context! {
        intervals => PRINTED,
        nodes => PRINTED - 1,
        matrices => matrices.trim_end(),
        conditions => conditions.join(" and "),
    }))
}

/// Depths of the line, in equal steps of the fourth root: with it the length grows that is lifted off.
const DEPTHS: u32 = 160;
/// Every so many of them also by the force method.
const COMPUTED_EVERY: u32 = 8;
/// The deepest, over the depth 5/384 that a free beam just reaches.
const DEEPEST: f64 = 1.25;

/// The three regimes of a flat foundation as one picture: the end reaction over the depth.
pub(super) fn regimes(_: &Study<'_>) -> Result<Evidence, Cause> {
    let (beam, load) = (beam()?, example()?.load().uniform());
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let unit = load * l * l * l * l / ei;
    let (mut line, mut points) = (Vec::new(), Vec::new());
    let mut data = Table::new(["ei_depth_over_q_l4", "reaction_over_q_l", "regime", "force_method"]);
    // Name of the regime, and at which depths it is found: from, to, and the unknowns.
    let mut found: Vec<(&str, f64, f64, usize)> = Vec::new();
    let (mut exact, mut worst, mut closed) = (0, 0.0_f64, 0.0_f64);
    for i in 1..=DEPTHS {
        let part = f64::from(i) / f64::from(DEPTHS);
        let share = DEEPEST * 5.0 / 384.0 * part * part * part * part;
        let depth = share * unit;
        let scene = scene_over(Foundation::Flat { depth })?;
        let solution = theory::solve(&scene)?;
        exact += usize::from(solution.solved);
        let reaction = solution.state.reactions.left / (load * l);
        closed = closed.max((theory::flat(l, ei, depth, load).reaction / (load * l) - reaction).abs());
        line.push([share, reaction]);
        let regime = match solution.state.regime {
            Regime::None => "no contact",
            Regime::Points => "contact at mid-span only",
            Regime::Zone => "a zone of contact",
        };
        match found.last_mut() {
            Some((last, _, to, _)) if *last == regime => *to = share,
            _ => found.push((regime, share, share, solution.unknowns)),
        }
        let mut computed = String::new();
        if i % COMPUTED_EVERY == 0 {
            let discrete =
                on_grid(&scene, Method::Force, Solver::ActiveSet, INTERVALS)?.state.reactions.left / (load * l);
            worst = worst.max((discrete - reaction).abs());
            points.push([share, discrete]);
            computed = fixed(discrete, 6);
        }
        data.push(row![fixed(share, 8), fixed(reaction, 6), regime, computed]);
    }
    let paper = example()?;
    let paper = [paper.depth(0.0) / unit, theory::solve(&paper)?.state.reactions.left / (load * l)];
    let computed_points = points.len();
    let svg = regimes_drawn(&line, points, paper)?;
    let found = found.into_iter().map(|(regime, from, to, unknowns)| context! { regime, from, to, unknowns });
    let values = context! {
        // `[EI u₀/(q₀l⁴), reaction/(q₀l)]`
        example => paper,
        depths => line.len(),
        // How many of them are exact and checked.
        exact,
        points => computed_points,
        intervals => INTERVALS,
        found => found.collect::<Vec<_>>(),
        // Worst difference of the computed end reactions from theory, over `q₀l`.
        worst,
        // Bound of the difference of the exact solutions from the closed form, over `q₀l`.
        closed => bound(closed.max(f64::EPSILON)),
    };
    Ok(Evidence::new(values).figure("regimes", svg, data))
}

/// End reaction over `EI u₀ / (q₀ l⁴)` by theory and by the force method, with the three regimes and the paper's example.
fn regimes_drawn(theory: &[Place], computed: Vec<Place>, paper: Place) -> Result<String, PlotError> {
    /// One unit of the axis; the borders are at 1 and 5, the mid-span deflection of the free beam.
    const UNIT: f64 = 1.0 / 384.0;
    let scaled = |points: &[Place]| -> Vec<Place> { points.iter().map(|p| [p[0] / UNIT, p[1]]).collect() };
    let theory = scaled(theory);
    let reach = theory.iter().fold(6.0, |most: f64, p| most.max(p[0]));
    let x = Axis {
        padding: 0.0,
        ..Axis::new("384 EI u₀ / (q₀ l⁴): a stiffer beam or deeper ground to the right").including(&[0.0, reach])
    };
    let y = Axis { padding: 0.06, ..Axis::new("end reaction / (q₀ l)").including(&[0.0, 0.5]) };
    let mut panel = Panel::new(x, y).tall(820.0).room(110.0, 0.0);
    let borders = [0.0, 1.0, 5.0, reach];
    for at in &borders[1..3] {
        panel = panel.with(Layer::Reference { at: Reference::X(*at), text: String::new() });
    }
    for (pair, text) in borders.windows(2).zip(["contact zone", "contact at mid-span only", "no contact"]) {
        panel = panel.with(Layer::Note { at: [0.5 * (pair[0] + pair[1]), 0.55], text: text.to_owned(), dot: false });
    }
    let circles = Style::marks(Color::BLUE, Marker::OpenCircle);
    let star = Style::marks(Color::VERMILLION, Marker::Star);
    let panel = panel
        .with(Layer::line(theory, Style::theory()))
        .with(Layer::named(scaled(&computed), circles, format!("force method, {INTERVALS} intervals")))
        .with(Layer::named(scaled(&[paper]), star, "the paper's example"));
    Figure::new(
        "Three regimes: the end reaction grows until nothing touches",
        "The end reaction rises with the fourth root of the depth while the beam rests on a zone, then along a straight line \
         while it touches at mid-span only, and is constant when it touches nothing. Circles lie on the line. A star marks the \
         example of the paper, at the left end of the curve.",
        vec![panel],
    )
    .svg()
}

#[cfg(test)]
mod tests {
    use super::regimes_drawn;

    #[test]
    fn the_regimes_and_the_example_are_named() {
        let svg = regimes_drawn(&[[0.0, 0.0], [0.02, 0.5]], vec![[0.01, 0.2]], [0.001, 0.1]).expect("a figure");
        for text in ["contact zone", "contact at mid-span only", "no contact", ">the paper&apos;s example<"] {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }
}
