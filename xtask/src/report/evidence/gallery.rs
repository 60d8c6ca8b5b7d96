//! The gallery: the exact solution of every scene file as a card, and all of them on one sheet.

use palkki::plot::{Curves, sheet};
use palkki::text::markdown_text;
use palkki::theory::Exact;
use palkki::verdict::{Demand, Verdict};

use super::closed::checked;
use super::prelude::*;
use crate::report::files;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let header =
        ["scene", "contact", "unknowns", "left reaction", "right reaction", "contact force", "deflection within"];
    let all = shown(study, scenes::GALLERY, "scene")?;
    let overview = Table::new(header).rows(all.iter().map(|Shown { name, scene, exact, within, .. }| {
        let (state, force) = (&exact.state, load(scene));
        let forces = [state.reactions.left, state.reactions.right, state.contact_force()];
        let [left, right, contact] = forces.map(|value| value_of(value, force, 5));
        let unit = scene.units().force.as_ref().map_or_else(String::new, |unit| format!(", {unit}"));
        let link = format!("[{}](#{name}){unit}", markdown_text(scene.title()));
        row![link, state.regime.name(), exact.unknowns, left, right, contact, within]
    }));
    let soft = shown(study, scenes::SOFT, "soft")?;
    let practice = shown(study, scenes::PRACTICE, "practice")?;
    let unknowns = || all.iter().map(|shown| shown.exact.unknowns);
    let context = context! {
        count => all.len(),
        exact => all.iter().filter(|shown| shown.certified).count(),
        fewest => unknowns().min(),
        most => unknowns().max(),
        residual => bound(largest(all.iter().map(|shown| shown.exact.residual))),
        overview,
        cards => all.iter().map(|shown| shown.card.clone()).collect::<Value>(),
        soft => soft.iter().map(|shown| shown.card.clone()).collect::<Value>(),
        practice_count => practice.len(),
        practice_certified => practice.iter().filter(|shown| shown.certified).count(),
        practice => practice.iter().map(|shown| shown.card.clone()).collect::<Value>(),
        soft_count => soft.len(),
        soft_certified => soft.iter().filter(|shown| shown.certified).count(),
    };
    let pictures = all.iter().map(|shown| (shown.name.as_str(), &shown.scene, &shown.curves));
    let Words { title, description, .. } = study.words("sheet", context! {})?;
    let svg = sheet(&title, &description, pictures)?;
    let forces = all.iter().flat_map(|Shown { name, curves, .. }| {
        curves.point_forces.iter().map(move |force| row![name, fixed(force.at, 5), fixed(force.force, 5)])
    });
    let forces = Table::new(["scene", "x", "contact_force"]).rows(forces);
    Evidence::new(context)
        .figure("sheet", svg, forces)?
        .figures(all.into_iter().chain(soft).chain(practice).map(|shown| shown.figure))
}

/// A scene that is solved and judged, with its card and its figure.
pub(super) struct Shown {
    pub(super) name: String,
    pub(super) scene: Scene,
    pub(super) exact: Exact,
    pub(super) certified: bool,
    /// The guaranteed error of the deflection over the largest one.
    within: String,
    /// Its story and its formula. Its values are one page of the snapshots.
    pub(super) card: Value,
    curves: Curves,
    pub(super) figure: Drawn<String>,
}

/// The scenes of a directory; the names of their figures begin with `prefix`.
pub(super) fn shown(study: &Study<'_>, directory: &str, prefix: &str) -> Result<Vec<Shown>, Cause> {
    let folder = directory.trim_start_matches(scenes::GALLERY).trim_start_matches('/');
    let shown = |(name, scene): (String, Scene)| -> Result<Shown, Cause> {
        let exact = theory::solve(&scene)?;
        let verdict = Verdict::of_exact(&scene, &exact, &Demand::default());
        let text = files::text(study.root, &format!("{directory}/{name}.toml"))?;
        let curves = Curves::exact(&scene, &exact);
        let within = verdict.certificate.as_ref().map(|c| bound((c.deflection_error / c.deflection).max(f64::EPSILON)));
        // The comment at the head of a scene file.
        let head = text.lines().take_while(|line| line.starts_with('#'));
        let story = head.map(|line| line.trim_start_matches('#').trim()).collect::<Vec<_>>().join(" ");
        let certified = verdict.status == Status::Certified;
        let formula = checked(&name, &scene, &exact)?;
        // Beside the scene.
        let readings = text.split('"').find(|word| word.ends_with(".csv"));
        let readings = readings.map(|name| format!("{directory}/{name}").replacen("report/", "", 1));
        let svg = palkki::plot::curves(&scene, &curves, "grid-free solution")?;
        let figure = format!("{prefix}-{name}");
        let file = if folder.is_empty() { name.clone() } else { format!("{folder}/{name}") };
        let (title, page) = (markdown_text(scene.title()), file.replace('/', "__"));
        Ok(Shown {
            within: within.unwrap_or_else(|| "–".to_owned()),
            certified,
            card: context! { name => name.as_str(), title, story, certified, formula, readings, file, page, figure => figure.as_str() },
            figure: (figure, svg, table(&curves)),
            curves,
            exact,
            name,
            scene,
        })
    };
    scenes::listed(study.root, directory)?.into_iter().map(shown).collect()
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
