//! The sketch of a load above the beam: a block for what is distributed, arrows for point loads.

use super::axis::Axes;
use super::canvas::{Canvas, SHAFT};
use super::error::{PlotError, finite};
use super::label::{Label, Labels};
use super::layer::{LoadSketch, Place};
use super::palette::{Color, Dash};
use super::trace::{INK, Point, sampled};

/// Draws the load, and asks for the labels that it wants.
pub(super) fn load(
    canvas: &Canvas<'_>,
    sketch: &LoadSketch,
    axes: &Axes,
    labels: &mut Labels,
) -> Result<(), PlotError> {
    distributed(canvas, sketch, axes, labels)?;
    points(canvas, sketch, axes, labels)
}

fn distributed(canvas: &Canvas<'_>, sketch: &LoadSketch, axes: &Axes, labels: &mut Labels) -> Result<(), PlotError> {
    /// Height of the greatest intensity, distance from the beam, distance of the arrows.
    const BLOCK: f64 = 90.0;
    const CLEAR: f64 = 16.0;
    const APART: f64 = 80.0;
    let mut most: f64 = 0.0;
    let mut least: f64 = 0.0;
    for p in &sketch.intensity {
        let q = finite("the intensity of a load", p[1])?;
        (least, most) = (least.min(q), most.max(q));
    }
    let largest = most.max(-least);
    let beam = axes.y.place(sketch.level);
    if 0.0 < largest {
        // A load that acts upwards hangs below the base line, which makes room for it.
        let base = beam - CLEAR - BLOCK * (-least / largest);
        let edge = |[x, q]: Place| [axes.x.place(x), base - BLOCK * (q / largest)];
        let outline: Vec<Point> = sketch.intensity.iter().map(|&p| edge(p)).collect();
        if let (Some(first), Some(last)) = (outline.first(), outline.last()) {
            let closed: Vec<Point> = outline.iter().copied().chain([[last[0], base], [first[0], base]]).collect();
            canvas.fill(&closed, Color::SKY, 0.3)?;
            canvas.line(&outline, Color::BLUE, 3, Dash::Solid)?;
            canvas.line(&[[first[0], base], [last[0], base]], Color::BLUE, 3, Dash::Solid)?;
        }
        for pair in outline.windows(2) {
            let ([from, y], [to, to_y]) = (pair[0], pair[1]);
            let mut x = (from / APART).ceil() * APART;
            while x < to {
                let height = y + (to_y - y) * (x - from) / (to - from);
                if 20.0 < (height - base).abs() {
                    canvas.arrow([x, height], [x, base], Color::BLUE, 3, Dash::Solid)?;
                    labels.avoid(sampled(&[[x, height], [x, base]], INK));
                }
                x += APART;
            }
        }
        for (x, q, text) in &sketch.values {
            let at = edge([*x, q.max(0.0)]);
            labels.ask(Label { text: text.clone(), at, color: Color::BLUE, optional: false, below: false });
        }
        labels.avoid(sampled(&outline, INK));
    }
    Ok(())
}

fn points(canvas: &Canvas<'_>, sketch: &LoadSketch, axes: &Axes, labels: &mut Labels) -> Result<(), PlotError> {
    /// Length of the greatest point load, and of the shortest arrow.
    const POINT: f64 = 170.0;
    const SHORTEST: f64 = 60.0;
    let beam = axes.y.place(sketch.level);
    let mut greatest: f64 = 0.0;
    for p in &sketch.points {
        greatest = greatest.max(finite("a point load", p.1)?.abs());
    }
    for (x, force, text) in sketch.points.iter().filter(|p| p.1 != 0.0) {
        let length = (POINT * (force.abs() / greatest)).max(SHORTEST);
        let x = axes.x.place(*x);
        let (near, far) = ([x, beam - 6.0], [x, beam - 6.0 - length]);
        let (tail, tip) = if 0.0 < *force { (far, near) } else { (near, far) };
        canvas.arrow(tail, tip, Color::BLACK, SHAFT, Dash::Solid)?;
        labels.avoid(sampled(&[near, far], INK));
        labels.ask(Label { text: text.clone(), at: far, color: Color::BLACK, optional: false, below: false });
    }
    Ok(())
}
