//! Figure of the envelope of a sweep: the greatest and least moment and shear force along the beam.

use super::PlotError;
use super::axis::Axis;
use super::figure::Figure;
use super::layer::{Layer, Place};
use super::palette::{Color, Style};
use super::panel::Panel;
use super::sketch::UnitLabels;
use crate::scene::Scene;
use crate::sweep::Envelope;
use crate::text::significant;

/// Digits of a number in the title.
const DIGITS: usize = 5;

/// Draws moments, downwards on the side in tension, and shear forces along the beam; `vary` names the varied number.
///
/// # Errors
///
/// A [`PlotError`] for numbers that are not finite.
pub fn envelope(scene: &Scene, vary: &str, envelope: &Envelope) -> Result<String, PlotError> {
    let UnitLabels { length, force, moment, .. } = UnitLabels::of_axes(scene.units());
    let ends = [0.0, scene.beam().length()];
    let panel = |axis: Axis, most: &[f64], least: &[f64]| {
        let over =
            |values: &[f64]| envelope.x.iter().zip(values).map(|(x, value)| [*x, *value]).collect::<Vec<Place>>();
        Panel::new(Axis::along("x", ends).unit(length.clone()), axis)
            .tall(480.0)
            .room(40.0, 40.0)
            .with(Layer::zero_line(ends))
            .with(Layer::named(over(most), Style::solid(Color::BLUE), "largest"))
            .with(Layer::named(over(least), Style::solid(Color::VERMILLION), "least"))
    };
    let moments = Axis::new("bending moment, on the side in tension").unit(moment).down();
    let shears = Axis::new("shear force").unit(force);
    let panels = vec![
        panel(moments, &envelope.moment_max, &envelope.moment_min),
        panel(shears, &envelope.shear_max, &envelope.shear_min),
    ];
    let [max, min] = [&envelope.governing.moment_max, &envelope.governing.moment_min];
    let said = |moment: f64, at: f64| format!("{} at {}", significant(moment, DIGITS), significant(at, DIGITS));
    let title = format!("Moments between {} and {}", said(min.moment, min.at), said(max.moment, max.at));
    let description =
        format!("The largest and the least bending moment and shear force along the beam while {vary} is varied.");
    Figure::new(title, description, panels).svg()
}
