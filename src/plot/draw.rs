//! Draws layers as lines on the sheet: a distributed load as a block, point loads as arrows.

use super::axis::Axes;
use super::canvas::{Align, Canvas, Point, SHAFT, TEXT, Type, text_width};
use super::label::{Frame, INK, Label, Labels, apart, sampled};
use super::layer::{Arrows, Cell, Divisions, LABEL_ROW, Layer, LoadSketch, Place, SupportKind};
use super::marks::{arc, support};
use super::palette::{Color, Dash, Style};
use super::{PlotError, count, finite};

/// Draws `layer` and requests its labels.
pub(super) fn draw(
    canvas: &mut Canvas,
    layer: &Layer,
    axes: &Axes,
    frame: &Frame,
    labels: &mut Labels,
) -> Result<(), PlotError> {
    match layer {
        Layer::Series { points, style, label } => series(canvas, &placed(points, axes), *style, label, frame, labels),
        Layer::Area { points, level, color } => {
            area(canvas, &placed(points, axes), axes.y.place(*level), *color, labels)
        }
        Layer::Band { from, to, color } => band(canvas, &placed(from, axes), &placed(to, axes), *color, labels),
        Layer::Arrows(layer) => arrows(canvas, layer, axes, labels),
        Layer::Foundation { points } => foundation(canvas, &placed(points, axes), frame, labels),
        Layer::Divisions(all) => divisions(canvas, all, axes, frame, labels),
        Layer::Note { at, text, color, dot } => {
            let at = axes.place(*at);
            if *dot {
                canvas.disc(at, 10.0, *color)?;
            }
            // In the upper half of the frame there is more room below the point.
            let below = *dot && at[1] < 0.5 * (frame.top + frame.bottom);
            labels.request(Label { below, ..Label::new(text, at, *color) });
            Ok(())
        }
        Layer::Supports(supports) => supports.iter().try_for_each(|mark| {
            let at = axes.place(mark.at);
            if !matches!(mark.kind, SupportKind::Joint { .. }) {
                labels.avoid(symbol(at));
            }
            support(canvas, at, mark.kind)
        }),
        Layer::Load(sketch) => {
            distributed(canvas, sketch, axes, labels)?;
            point_loads(canvas, sketch, axes, labels)?;
            couples(canvas, sketch, axes, labels)
        }
        Layer::Cells(all) => all.iter().try_for_each(|one| cell(canvas, one, axes)),
    }
}

/// The outline that labels should not cover at a support: a rectangle below its position.
fn symbol([x, y]: Point) -> Vec<Point> {
    let [left, right, top, bottom] = [x - 30.0, x + 30.0, y + 4.0, y + 52.0];
    sampled(&[[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], INK)
}

fn placed(points: &[Place], axes: &Axes) -> Vec<Point> {
    points.iter().map(|&p| axes.place(p)).collect()
}

fn series(
    canvas: &mut Canvas,
    line: &[Point],
    style: Style,
    name: &str,
    frame: &Frame,
    labels: &mut Labels,
) -> Result<(), PlotError> {
    if let Some(dash) = style.dash {
        canvas.line(line, style.color, style.width, dash)?;
        labels.avoid(sampled(line, INK));
    }
    if let Some(marker) = style.marker {
        for &at in line {
            canvas.mark(at, marker, style.color)?;
        }
        // A marker is wider than a point of a line.
        labels.avoid(
            line.iter().flat_map(|&[x, y]| [[x, y], [x - 12.0, y], [x + 12.0, y], [x, y - 12.0], [x, y + 12.0]]),
        );
    }
    let (Some(&first), Some(&last)) = (line.first(), line.last()) else {
        return Ok(());
    };
    let label = |at: Point| Label::new(name, at, style.color);
    match [last, first].into_iter().find(|end| style.dash.is_some() && frame.names_beside(end[0], name)) {
        Some(end) => labels.name(label(end)),
        None => labels.request(label(last)),
    }
    Ok(())
}

fn arrows(canvas: &mut Canvas, layer: &Arrows, axes: &Axes, labels: &mut Labels) -> Result<(), PlotError> {
    for arrow in &layer.arrows {
        let force = finite("the force of an arrow", arrow.force)?;
        if force == 0.0 {
            continue;
        }
        let tail = axes.place(arrow.at);
        let tip = [tail[0], tail[1] + axes.length(force)];
        canvas.arrow(tip[0], [tail[1], tip[1]], layer.color, SHAFT, layer.dash)?;
        labels.avoid(sampled(&[tail, tip], INK));
        let label = Label::new(&arrow.text, tip, layer.color);
        labels.request(Label { optional: arrow.optional, below: force < 0.0, ..label });
    }
    Ok(())
}

/// A cell of a map, with white space between it and its neighbours.
fn cell(canvas: &mut Canvas, cell: &Cell, axes: &Axes) -> Result<(), PlotError> {
    const GAP: f64 = 4.0;
    let [x, y] = cell.at;
    let ([left, above], [right, below]) = (axes.place([x - 0.5, y - 0.5]), axes.place([x + 0.5, y + 0.5]));
    canvas.rectangle([left + GAP, above + GAP], [right - GAP, below - GAP], cell.color, 0.45)?;
    canvas.text(&cell.text, axes.place(cell.at), Align::Center, Type::BOLD)
}

/// A line, and a light area between it and the level `base`.
fn area(canvas: &mut Canvas, line: &[Point], base: f64, color: Color, labels: &mut Labels) -> Result<(), PlotError> {
    if line.is_empty() {
        return Ok(());
    }
    canvas.fill(&closed(line, base), color, 0.25)?;
    canvas.line(line, color, 5, Dash::Solid)?;
    labels.avoid(sampled(line, INK));
    Ok(())
}

/// Two lines, and a light area between them.
fn band(canvas: &mut Canvas, from: &[Point], to: &[Point], color: Color, labels: &mut Labels) -> Result<(), PlotError> {
    let outline: Vec<Point> = from.iter().chain(to.iter().rev()).copied().collect();
    canvas.fill(&outline, color, 0.25)?;
    labels.avoid([from, to].iter().flat_map(|line| sampled(line, INK)));
    canvas.lines(&[from, to], color, 6, Dash::Solid)
}

/// Dotted vertical lines. Their labels are placed slightly apart in rows at the top, each with a stroke to its line.
fn divisions(
    canvas: &mut Canvas,
    all: &Divisions,
    axes: &Axes,
    frame: &Frame,
    labels: &mut Labels,
) -> Result<(), PlotError> {
    let rows = all.rows();
    let labelled = frame.top + LABEL_ROW * count(rows);
    let top = if rows == 0 { frame.top } else { labelled + 0.6 * TEXT };
    for (x, _) in &all.lines {
        let line = [[axes.x.place(*x), top], [axes.x.place(*x), frame.bottom]];
        canvas.line(&line, Color::GRAY, 4, Dash::Dotted)?;
        labels.avoid(sampled(&line, INK));
    }
    let named: Vec<(f64, &str)> =
        all.lines.iter().map(|(x, text)| (axes.x.place(*x), text.as_str())).filter(|line| !line.1.is_empty()).collect();
    let widest = named.iter().fold(0.0_f64, |most, line| most.max(text_width(line.1, Type::PLAIN)));
    let kind = Type { color: Color::GRAY, ..Type::PLAIN };
    let wanted: Vec<f64> = named.iter().map(|line| line.0).collect();
    // The strokes of the other rows pass between the labels of a row.
    let distance = (widest + 0.5 * TEXT) / count(rows.max(1));
    let places = apart(&wanted, [frame.left, frame.right], distance);
    for (i, ((x, text), at)) in named.iter().zip(places).enumerate() {
        let y = frame.top + LABEL_ROW * (count(i % rows.max(1)) + 0.5);
        canvas.text(text, [at, y], Align::Center, kind)?;
        canvas.line(&[[at, y + 0.5 * TEXT], [at, labelled], [*x, top]], Color::GRAY, 2, Dash::Solid)?;
    }
    let y = frame.top + all.headroom() - 0.5 * LABEL_ROW;
    for ([from, to], text) in &all.between {
        let [from, to] = [*from, *to].map(|x| axes.x.place(x));
        let half = 0.5 * text_width(text, Type::PLAIN);
        let middle = 0.5 * (from + to);
        if 2.0 * half < (to - from).abs() {
            let corners = [[middle - half, y - 0.5 * TEXT], [middle + half, y + 0.5 * TEXT]];
            canvas.rectangle(corners[0], corners[1], Color::WHITE, 0.8)?;
            labels.leave(corners[0], corners[1]);
            canvas.text(text, [middle, y], Align::Center, Type::PLAIN)?;
        }
    }
    Ok(())
}

/// The outline of the area between a line and the level `base`.
fn closed(line: &[Point], base: f64) -> Vec<Point> {
    line.iter().copied().chain(line.last().map(|p| [p[0], base])).chain(line.first().map(|p| [p[0], base])).collect()
}

/// The foundation below a line, hatched along the line as in engineering drawings.
fn foundation(canvas: &mut Canvas, line: &[Point], frame: &Frame, labels: &mut Labels) -> Result<(), PlotError> {
    let Some(first) = line.first() else { return Ok(()) };
    canvas.fill(&closed(line, frame.bottom), Color::GROUND, 1.0)?;
    let mut x = first[0] + 24.0;
    let mut strokes = Vec::new();
    for pair in line.windows(2) {
        let ([from, y], [to, to_y]) = (pair[0], pair[1]);
        while from <= x && x < to {
            let depth = y + (to_y - y) * (x - from) / (to - from);
            if depth + 26.0 < frame.bottom {
                strokes.push([[x, depth], [x - 20.0, depth + 26.0]]);
            }
            x += 40.0;
        }
    }
    canvas.lines(&strokes, Color::GRAY, 3, Dash::Solid)?;
    labels.avoid(strokes.iter().flat_map(|stroke| sampled(stroke, INK)));
    canvas.line(line, Color::BLACK, 4, Dash::Solid)?;
    labels.avoid(sampled(line, INK));
    Ok(())
}

fn distributed(canvas: &mut Canvas, sketch: &LoadSketch, axes: &Axes, labels: &mut Labels) -> Result<(), PlotError> {
    /// Height of the greatest intensity, distance from the beam, and spacing of the arrows.
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
        // A load that acts upwards is drawn below the base line, which is raised to make room for it.
        let base = beam - CLEAR - BLOCK * (-least / largest);
        let edge = |[x, q]: Place| [axes.x.place(x), base - BLOCK * (q / largest)];
        let outline: Vec<Point> = sketch.intensity.iter().map(|&p| edge(p)).collect();
        if let (Some(first), Some(last)) = (outline.first(), outline.last()) {
            canvas.fill(&closed(&outline, base), Color::SKY, 0.3)?;
            canvas.line(&outline, Color::BLUE, 3, Dash::Solid)?;
            canvas.line(&[[first[0], base], [last[0], base]], Color::BLUE, 3, Dash::Solid)?;
        }
        for pair in outline.windows(2) {
            let ([from, y], [to, to_y]) = (pair[0], pair[1]);
            let mut x = (from / APART).ceil() * APART;
            while x < to {
                let height = y + (to_y - y) * (x - from) / (to - from);
                if 20.0 < (height - base).abs() {
                    canvas.arrow(x, [height, base], Color::BLUE, 3, Dash::Solid)?;
                    labels.avoid(sampled(&[[x, height], [x, base]], INK));
                }
                x += APART;
            }
        }
        for (x, q, text) in &sketch.values {
            labels.request(Label::new(text, edge([*x, q.max(0.0)]), Color::BLUE));
        }
        labels.avoid(sampled(&outline, INK));
    }
    Ok(())
}

fn point_loads(canvas: &mut Canvas, sketch: &LoadSketch, axes: &Axes, labels: &mut Labels) -> Result<(), PlotError> {
    /// Length of the greatest point load and of the shortest arrow.
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
        let ends = if 0.0 < *force { [far[1], near[1]] } else { [near[1], far[1]] };
        canvas.arrow(x, ends, Color::BLACK, SHAFT, Dash::Solid)?;
        labels.avoid(sampled(&[near, far], INK));
        labels.request(Label::new(text, far, Color::BLACK));
    }
    Ok(())
}

/// Couples as arcs around their positions on the beam, each with an arrow head.
fn couples(canvas: &mut Canvas, sketch: &LoadSketch, axes: &Axes, labels: &mut Labels) -> Result<(), PlotError> {
    /// Radius of an arc, and its start and end in quarters of a turn.
    const RADIUS: f64 = 46.0;
    const QUARTERS: [f64; 2] = [1.4, 4.1];
    const HEAD: f64 = 18.0;
    for (x, moment, text) in &sketch.couples {
        let center = [axes.x.place(*x), axes.y.place(sketch.level)];
        if finite("a couple", *moment)? == 0.0 {
            continue;
        }
        // Angles grow clockwise on the page, from the right.
        let mut line = arc(center, RADIUS, QUARTERS);
        if *moment < 0.0 {
            line.iter_mut().for_each(|p| p[0] = 2.0 * center[0] - p[0]);
        }
        let (Some(&tip), Some(&before)) = (line.last(), line.get(line.len().saturating_sub(2))) else { continue };
        let length = libm::hypot(tip[0] - before[0], tip[1] - before[1]);
        let [along, across] = [(tip[0] - before[0]) / length, (tip[1] - before[1]) / length];
        let corner = |side: f64| {
            [tip[0] - HEAD * along + side * 0.5 * HEAD * across, tip[1] - HEAD * across - side * 0.5 * HEAD * along]
        };
        canvas.line(&line, Color::BLACK, 5, Dash::Solid)?;
        canvas.fill(&[tip, corner(1.0), corner(-1.0)], Color::BLACK, 1.0)?;
        labels.avoid(sampled(&line, INK));
        labels.request(Label::new(text, [center[0], center[1] - RADIUS], Color::BLACK));
    }
    Ok(())
}
