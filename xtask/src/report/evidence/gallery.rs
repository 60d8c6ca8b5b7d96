//! The gallery: the exact solution of every scene file as a card, and all of them on one sheet.

pub(super) mod card;

use palkki::plot::{Curves, sheet};
use palkki::theory::Exact;
use palkki::verdict::{Demand, Verdict};

use super::prelude::*;
use crate::report::files;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let header =
        ["scene", "contact", "unknowns", "left reaction", "right reaction", "contact force", "deflection within"];
    let (mut overview, mut values) = (Table::new(header), card::values());
    let (mut cards, mut figures, mut solved, mut unknowns) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut residual, mut certified) = (0.0_f64, 0);
    for (name, scene) in scenes::all(study.root)? {
        let shown = shown(study, scenes::GALLERY, &name, &scene, &mut values)?;
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
    let evidence = Evidence::new(context).figures(figures)?.data("cards", values)?;
    let pictures = solved.iter().map(|(name, scene, drawn)| (name.as_str(), scene, drawn));
    let svg = sheet(
        "The gallery: the exact solution of every scene",
        "Small pictures of all scenes: ground, deflected beam, contact zones as thick lines, contact points as dots, concentrated contact \
         forces as arrows, to scale within a picture.",
        pictures,
    )?;
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

/// A scene of some directory as a page shows it; the values of its card become rows of `values`.
pub(super) fn shown(
    study: &Study<'_>,
    directory: &str,
    name: &str,
    scene: &Scene,
    values: &mut Table,
) -> Result<Shown, Cause> {
    let exact = theory::solve(scene)?;
    let verdict = Verdict::of_exact(scene, &exact, &Demand::default());
    let file = files::text(study.root, &format!("{directory}/{name}.toml"))?;
    let curves = Curves::exact(scene, &exact);
    let within = verdict.certificate.as_ref().map(|c| bound((c.deflection_error / c.deflection).max(f64::EPSILON)));
    Ok(Shown {
        within: within.unwrap_or_else(|| "–".to_owned()),
        certified: verdict.status == Status::Certified,
        card: card::card(name, scene, &exact, &verdict, &file, values)?,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_example_is_flat_between_its_lift_off_points() {
        let scene = palkki_evidence::paper::example().expect("the example is well posed");
        let exact = theory::solve(&scene).expect("it has an exact solution");
        let curves = Curves::exact(&scene, &exact);
        assert_eq!(curves.point_forces.len(), 2, "one force at each lift-off point");
        let table = table(&curves).csv().expect("text");
        let middle: Vec<&str> = table.lines().filter(|line| line.starts_with("5.00000,")).collect();
        assert_eq!(middle, ["5.00000,1.00000,0.00000,1.00000,0.00000"], "{table}");
        assert!(table.contains("0.00000,0.00000,1.00000,,0.00000"), "no pressure beside a support: {table}");
    }
}
