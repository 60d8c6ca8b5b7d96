//! The problem with a sketch, the three methods, and the solvers with their settings.

use std::fmt::Write as _;

use palkki::DEFAULT_TOLERANCE;
use palkki::certificate::CERTIFIED_RESIDUAL;
use palkki::methods::Discrete;
use palkki::plot::{Arrow, Arrows, Axis, Color, Curves, Dash, Layer, LoadSketch, Panel, Style};
use palkki::scene::{Beam, Load};

use super::prelude::*;

/// The problem, its notation and a sketch.
pub(super) fn sketch(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = scenes::read(study.root, "ridge")?;
    let exact = theory::solve(&scene)?;
    let curves = Curves::exact(&scene, &exact);
    let places = curves.x.iter().zip(&curves.deflection);
    let rows = places.map(|(&x, &v)| [fixed(x, 5), fixed(scene.depth(x), 5), fixed(v, 5)]);
    let data = Table::new(["x", "u", "v"]).rows(rows).one_a_place();
    let values = context! { title => scene.title() };
    Evidence::new(values).figures([study.drawn("problem", context! {}, 1, vec![sketched(&scene, &curves)], data)?])
}

fn sketched(scene: &Scene, curves: &Curves) -> Panel {
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
        couples: Vec::new(),
    };
    let lifted = 0.05 * l;
    let x = Axis::along("x [length], from the left support to the right one at l", [0.0, l]);
    Panel::new(x, Axis::new("depth and deflection, downwards [length]").down().including(&[0.0]))
        .tall(880.0)
        .room(350.0, 130.0)
        .forces(Axis::new("").bare())
        .with(Layer::Foundation { points: ground })
        .with(Layer::Load(load))
        .with(Layer::line(vec![[0.0, 0.0], [l, 0.0]], Style { width: 3, ..Style::theory() }))
        .with(Layer::simple_supports(l))
        .with(Layer::line(deflected.clone(), Style::solid(Color::BLUE)))
        .with(Layer::line(
            vec![[lifted, at(lifted)], [lifted, scene.depth(lifted)]],
            Style { dash: Some(Dash::Dotted), ..Style::solid(Color::BLACK) },
        ))
        .with(Layer::words([lifted, 0.5 * (at(lifted) + scene.depth(lifted))], Color::BLACK, "clearance h = u − v"))
        .with(Layer::words([0.72 * l, 0.4 * scene.depth(0.72 * l)], Color::BLUE, "beam, deflection v(x)"))
        .with(Layer::words([0.5 * l, 1.2 * scene.depth(0.9 * l)], Color::BLACK, "rigid ground, depth u(x)"))
        .with(arrows(contact, Color::VERMILLION))
        .with(arrows(reactions, Color::GREEN))
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
    // The condition of K and C.
    let digits = &study.ledger()?.digits;
    let conditions: Vec<String> =
        digits.iter().map(|d| format!("{} with {} intervals", times_ten(d.condition, 1), d.intervals)).collect();
    Ok(Evidence::new(context! {
        intervals => PRINTED,
        matrices => matrices.trim_end(),
        conditions => conditions.join(" and "),
    }))
}

/// The solvers with their settings, and the threshold of our check.
pub(super) fn solvers(_: &Study<'_>) -> Result<Evidence, Cause> {
    let settings = Solver::ALL.map(|solver| row![solver, solver.settings(DEFAULT_TOLERANCE)]);
    Ok(Evidence::new(context! {
        settings => Table::new(["solver", "settings"]).rows(settings),
        threshold => tolerance(CERTIFIED_RESIDUAL),
        asked => tolerance(DEFAULT_TOLERANCE),
    }))
}
