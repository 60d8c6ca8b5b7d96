//! The gallery: the exact solution of every scene file as a card, and all of them on one sheet.

use palkki::plot::{Curves, sheet};
use palkki::theory::Exact;
use palkki::verdict::{Demand, Verdict};

use super::closed::closed;
use super::prelude::*;
use crate::report::files;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let header =
        ["scene", "contact", "unknowns", "left reaction", "right reaction", "contact force", "deflection within"];
    let mut overview = Table::new(header);
    let (mut cards, mut figures, mut solved, mut unknowns) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut residual, mut certified) = (0.0_f64, 0);
    for (name, scene) in scenes::all(study.root)? {
        let shown = shown(study, scenes::GALLERY, &name, &scene)?;
        residual = residual.max(shown.exact.residual);
        certified += usize::from(shown.certified);
        unknowns.push(shown.exact.unknowns);
        let state = &shown.exact.state;
        let force = load(&scene);
        let forces = [state.reactions.left, state.reactions.right, state.contact_force()];
        let [left, right, contact] = forces.map(|value| value_of(value, force, 5));
        let unit = scene.units().force.as_ref().map_or_else(String::new, |unit| format!(", {unit}"));
        let link = format!("[{}](#{name}){unit}", scene.title());
        overview.push(row![link, state.regime.name(), shown.exact.unknowns, left, right, contact, shown.within]);
        cards.push(shown.card);
        let (svg, data) = shown.figure;
        figures.push((format!("scene-{name}"), svg, data));
        solved.push((name, scene, shown.curves));
    }
    let context = context! {
        count => cards.len(),
        exact => certified,
        fewest => unknowns.iter().min(),
        most => unknowns.iter().max(),
        residual => bound(residual),
        overview,
        cards,
    };
    let evidence = Evidence::new(context).figures(figures)?;
    let pictures = solved.iter().map(|(name, scene, drawn)| (name.as_str(), scene, drawn));
    let Words { title, description, .. } = study.words("sheet", context! {})?;
    let svg = sheet(&title, &description, pictures)?;
    let forces = solved.iter().flat_map(|(name, _, drawn)| {
        drawn.point_forces.iter().map(move |force| row![name, fixed(force.at, 5), fixed(force.force, 5)])
    });
    evidence.figure("sheet", svg, Table::new(["scene", "x", "contact_force"]).rows(forces))
}

/// A scene that is solved and judged, with its card and its figure.
pub(super) struct Shown {
    pub(super) exact: Exact,
    pub(super) certified: bool,
    /// The guaranteed error of the deflection over the largest one.
    within: String,
    pub(super) card: Value,
    curves: Curves,
    /// The drawing, and the numbers that it draws.
    pub(super) figure: (String, Table),
}

/// A scene of some directory as a page shows it: its story, its formula and its figure. Its values are one page of the snapshots.
pub(super) fn shown(study: &Study<'_>, directory: &str, name: &str, scene: &Scene) -> Result<Shown, Cause> {
    let exact = theory::solve(scene)?;
    let verdict = Verdict::of_exact(scene, &exact, &Demand::default());
    let file = files::text(study.root, &format!("{directory}/{name}.toml"))?;
    let curves = Curves::exact(scene, &exact);
    let within = verdict.certificate.as_ref().map(|c| bound((c.deflection_error / c.deflection).max(f64::EPSILON)));
    // The comment at the head of a scene file.
    let head = file.lines().take_while(|line| line.starts_with('#'));
    let story = head.map(|line| line.trim_start_matches('#').trim()).collect::<Vec<_>>().join(" ");
    let certified = verdict.status == Status::Certified;
    Ok(Shown {
        within: within.unwrap_or_else(|| "–".to_owned()),
        certified,
        card: context! { name, title => scene.title(), story, certified, formula => closed(scene).map(|(formula, _)| formula) },
        figure: (palkki::plot::curves(scene, &curves, "exact solution")?, table(&curves)),
        curves,
        exact,
    })
}

/// What a figure of the curves draws, row by row; no pressure where nothing touches, no clearance without a foundation.
fn table(curves: &Curves) -> Table {
    /// Places to which the numbers are printed.
    const PLACES: usize = 5;
    let number = |value: f64| if value.is_finite() { fixed(value, PLACES) } else { String::new() };
    let zones: Vec<[f64; 2]> = curves.pressure.iter().flatten().copied().collect();
    let rows = curves.x.iter().enumerate().map(|(i, &x)| {
        let at = zones.partition_point(|p| p[0] < x);
        let pressure = zones.get(at).filter(|p| p[0] <= x).map_or_else(String::new, |p| number(p[1]));
        let [deflection, clearance, moment] = [curves.deflection[i], curves.clearance[i], curves.moment[i]].map(number);
        [number(x), deflection, clearance, pressure, moment]
    });
    Table::new(["x", "deflection", "clearance", "pressure", "moment"]).rows(rows).one_a_place()
}

/// A number of a table to some significant digits; `0` for what is rounding beside `scale`.
fn value_of(value: f64, scale: f64, digits: usize) -> String {
    if value.abs() <= 1e-9 * scale { "0".to_owned() } else { cell(Some(value), digits) }
}
