//! What the concentrated force at lift-off is: the resultant of a layer of pressure in a beam that gives in shear, beside the strip of stiff springs.

use palkki::plot::{Axis, Color, Dash, Layer, Panel, Place, Style};
use palkki::solve_exactly;
use palkki_evidence::authority::layer::Given;
use palkki_evidence::authority::number::{Fixed, Number};
use palkki_evidence::closed::{Sheared, lifting_discontinuity, opened, sheared};
use palkki_evidence::paper::{beam, example};

use super::prelude::*;

/// `l/s` of the table, of the thirty digits, and of the drawing.
const PARTS: [u32; 6] = [20, 50, 100, 200, 500, 1000];
const WITH_DIGITS: [u32; 2] = [100, 1000];
const DRAWN: [u32; 2] = [50, 200];
/// Powers of ten of the stiffness of the springs beside them.
const SPRINGS: [i32; 2] = [5, 7];
/// Digits behind the point of a number with thirty.
const PLACES: usize = 29;
/// The drawn part of the beam, over its length.
const WINDOW: [f64; 2] = [0.18, 0.30];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (scene, rigid) = (example()?, palkki_evidence::paper::theory());
    let length = beam()?.length();
    let lift_off = rigid.lift_off.ok_or("the example has a zone")?;
    let form = |parts: u32| {
        let width = length / f64::from(parts);
        sheared(length, scene.beam().bending_stiffness(), scene.depth(0.0), scene.load().uniform(), width)
    };
    let values = context! {
        table => table(&PARTS.map(|parts| (parts, form(parts))), [lift_off, rigid.reaction]),
        digits => digits(),
        agree => bound(agree(form)?),
        factor => lifting_discontinuity([1.0, 1.0]),
        // The gap of a beam that is rigid in shear at that discontinuity, over s.
        least_gap => opened(1.0).length(lifting_discontinuity([1.0, 1.0]), 1.0),
        drawn => DRAWN.map(part),
        springs => SPRINGS.map(power_of_ten),
    };
    let curves = [springs(&scene, length)?, layers(DRAWN.map(|parts| (parts, form(parts))), length)].concat();
    let panels = panels(&curves, lift_off / length, rigid.reaction, length);
    let data = data(&curves);
    Evidence::new(values.clone()).figures([study.drawn("point-force", values, 2, panels, data)?])
}

/// `1/l·s` as a number with a point.
fn part(parts: u32) -> String {
    significant(1.0 / f64::from(parts), 1)
}

fn table(forms: &[(u32, Sheared)], [lift_off, reaction]: [f64; 2]) -> Table {
    let header = ["s/l", "T", "lift-off a", "p at lift-off, over q", "∫(p − q) dx, over T", "(a₀ − a)/s"];
    let mut table = Table::new(header.into_iter().chain(["(T₀ − T)/T₀ over 3s²/2a₀²"]));
    for (parts, form) in forms {
        let law = 1.5 * (form.width / lift_off).powi(2);
        table.push(row![
            part(*parts),
            fixed(form.reaction, 6),
            fixed(form.lift_off, 6),
            significant(form.pressure(form.lift_off), 4),
            fixed(form.layer() / form.reaction, 4),
            fixed((lift_off - form.lift_off) / form.width, 4),
            fixed((1.0 - form.reaction / reaction) / law, 4)
        ]);
    }
    table.push(row!["0: rigid in shear", fixed(reaction, 6), fixed(lift_off, 6), "none", fixed(1.0, 4), "–", "–"]);
    table
}

/// Thirty digits from the authority.
fn digits() -> Table {
    let mut table = Table::new(["s/l", "quantity", "value"]);
    let mut put = |name: &str, width: &Fixed| {
        let layer = Given::example(width).layer();
        let of_pressure = layer.pressure.as_ref().map(|pressure| ("p at lift-off", pressure));
        for (what, value) in [("T", &layer.reaction), ("lift-off a", &layer.lift_off)].into_iter().chain(of_pressure) {
            // So many digits before the point more than one.
            let before = value.decimal(0).len() - 2;
            table.push(row![name, what, value.decimal(PLACES - before)]);
        }
    };
    for parts in WITH_DIGITS {
        put(&part(parts), &Fixed::fraction(1, i64::from(parts)));
    }
    put("0: rigid in shear", &Fixed::zero());
    table
}

/// How far the numbers of the table are off those with 256 binary places at most, relative.
fn agree(form: impl Fn(u32) -> Sheared) -> Result<f64, Cause> {
    /// What the table prints.
    const PRINTED: f64 = 1e-7;
    let mut most = f64::EPSILON;
    for parts in PARTS {
        let (form, layer) = (form(parts), Given::example(&Fixed::fraction(1, i64::from(parts))).layer());
        let pressure = layer.pressure.ok_or("it gives in shear")?;
        let found = [form.reaction, form.lift_off, form.pressure(form.lift_off), form.layer()];
        let expected = [layer.reaction, layer.lift_off, pressure, layer.resultant].map(|value| value.to_double());
        most = most.max(largest(found.iter().zip(expected).map(|(found, expected)| found / expected - 1.0)));
    }
    if PRINTED < most {
        return Err(format!("the closed form of the layer is off by {most:e}").into());
    }
    Ok(most)
}

/// A curve of the drawing: pressure over the load, and the force from the ground up to a place.
#[derive(Clone)]
struct Curve {
    /// Whether it is of the beam that gives in shear.
    shear: bool,
    name: String,
    /// `[x, p, ∫p dx]`.
    samples: Vec<[f64; 3]>,
}

fn places(length: f64) -> impl Iterator<Item = f64> {
    const SAMPLES: u32 = 600;
    (0..=SAMPLES).map(move |i| length * (WINDOW[0] + (WINDOW[1] - WINDOW[0]) * f64::from(i) / f64::from(SAMPLES)))
}

fn springs(scene: &Scene, length: f64) -> Result<Vec<Curve>, Cause> {
    let of = |power: i32| {
        let solution = solve_exactly(&scene.on_springs(ten_to(power))?)?;
        let exact = solution.exact.as_deref().ok_or("beam theory has functions")?;
        let reaction = exact.state.reactions.left;
        let sample = |x: f64| [x, exact.pressure(x), exact.shear(x)[1] - reaction + scene.load().uniform() * x];
        let name = format!("k = {}", power_of_ten(power));
        Ok(Curve { shear: false, name, samples: places(length).map(sample).collect() })
    };
    SPRINGS.map(of).into_iter().collect()
}

fn layers(forms: [(u32, Sheared); 2], length: f64) -> Vec<Curve> {
    let of = |(parts, form): (u32, Sheared)| {
        let mut places: Vec<f64> = places(length).chain([form.lift_off.next_down(), form.lift_off]).collect();
        places.sort_by(f64::total_cmp);
        let samples = places.into_iter().map(|x| [x, form.pressure(x), form.force_up_to(x)]).collect();
        Curve { shear: true, name: format!("s/l = {}", part(parts)), samples }
    };
    forms.map(of).into()
}

/// Left the beam on springs, right the one that gives in shear; above the pressure, below what it adds up to; dashed the beam that is rigid in shear on
/// rigid ground.
fn panels(curves: &[Curve], lift_off: f64, force: f64, length: f64) -> Vec<Panel> {
    let styles = [(Color::BLUE, Dash::LongDashed), (Color::VERMILLION, Dash::Solid)];
    let most = curves.iter().flat_map(|curve| &curve.samples).fold(0.0_f64, |most, sample| most.max(sample[1]));
    let x = || Axis { padding: 0.0, ..Axis::along("x/l", WINDOW) };
    let mut panels = Vec::new();
    for (k, what) in [(1, "p/q"), (2, "∫p dx/T₀")] {
        for (shear, whose) in [(false, "on springs"), (true, "with shear")] {
            let step = [[WINDOW[0], 0.0], [lift_off, 0.0], [lift_off, 1.0]];
            let end = if k == 1 { 1.0 } else { 1.0 + length * (WINDOW[1] - lift_off) / force };
            let rigid: Vec<Place> = step.into_iter().chain([[WINDOW[1], end]]).collect();
            let y = Axis::new(format!("{what} {whose}"));
            let y = if k == 1 { y.including(&[0.0, most]) } else { y };
            let mut panel = Panel::new(x(), y).with(Layer::line(rigid, Style::theory()));
            let of_it = curves.iter().filter(|curve| curve.shear == shear);
            for (i, (curve, (color, dash))) in of_it.zip(styles).enumerate() {
                let over = if k == 1 { 1.0 } else { force };
                let points = curve.samples.iter().map(|sample| [sample[0] / length, sample[k] / over]).collect();
                let style = Style { dash: Some(dash), ..Style::solid(color) };
                panel = panel.with(Layer::line(points, style));
                let row = 0.95 - 0.12 * as_number(i);
                let at = [WINDOW[0] + 0.003, if k == 1 { most } else { 1.6 } * row];
                panel = panel.with(Layer::words(at, color, curve.name.clone()));
            }
            panels.push(panel);
        }
    }
    panels
}

fn data(curves: &[Curve]) -> Table {
    let mut table = Table::new(["curve", "x", "pressure", "force_up_to_x"]);
    for curve in curves {
        for [x, pressure, force] in &curve.samples {
            table.push(row![curve.name, fixed(*x, 4), scientific(*pressure, 4), fixed(*force, 5)]);
        }
    }
    table
}
