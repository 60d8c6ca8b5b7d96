//! Engineering symbols of supports and joints.

use super::canvas::{Canvas, Point};
use super::layer::SupportKind;
use super::palette::{Color, Dash};
use super::{PlotError, count};

pub(super) fn support(canvas: &mut Canvas, [x, y]: Point, kind: SupportKind) -> Result<(), PlotError> {
    let rolls = match kind {
        SupportKind::Hinge => false,
        SupportKind::Roller => true,
        SupportKind::BuiltIn { ends } => return walls(canvas, [x, y], ends),
        SupportKind::Bearing => return block(canvas, [x, y]),
        SupportKind::Spring(pushes_only) => return spring(canvas, [x, y], pushes_only),
        SupportKind::Turning => return spiral(canvas, [x, y]),
        SupportKind::Joint { open } => {
            canvas.disc([x, y], 14.0, Color::BLACK)?;
            return canvas.disc([x, y], if open { 9.0 } else { 4.0 }, Color::WHITE);
        }
    };
    let triangle = [[x, y], [x + 26.0, y + 42.0], [x - 26.0, y + 42.0]];
    canvas.fill(&triangle, Color::WHITE, 1.0)?;
    canvas.line(&[triangle[0], triangle[1], triangle[2], triangle[0]], Color::BLACK, 4, Dash::Solid)?;
    let ground = if rolls { y + 52.0 } else { y + 42.0 };
    canvas.line(&[[x - 36.0, ground], [x + 36.0, ground]], Color::BLACK, 4, Dash::Solid)
}

/// A block below its level, with a plate for the beam to rest on.
fn block(canvas: &mut Canvas, [x, y]: Point) -> Result<(), PlotError> {
    let corners = [[x - 20.0, y + 4.0], [x + 20.0, y + 4.0], [x + 20.0, y + 42.0], [x - 20.0, y + 42.0]];
    canvas.fill(&corners, Color::WHITE, 1.0)?;
    let [a, b, c, d] = corners;
    canvas.line(&[a, b, c, d, a], Color::BLACK, 4, Dash::Solid)?;
    canvas.line(&[[x - 30.0, y + 4.0], [x + 30.0, y + 4.0]], Color::BLACK, 6, Dash::Solid)?;
    canvas.line(&[[x - 36.0, y + 42.0], [x + 36.0, y + 42.0]], Color::BLACK, 4, Dash::Solid)
}

/// Walls that restrain the rotation of the beam: across its end, or above and below it elsewhere.
fn walls(canvas: &mut Canvas, [x, y]: Point, ends: [bool; 2]) -> Result<(), PlotError> {
    /// Half the height of a wall; half the width of a wall above or below the beam, and its distance from the axis.
    const HEIGHT: f64 = 52.0;
    const WIDTH: f64 = 34.0;
    const CLEAR: f64 = 12.0;
    /// Length of the hatching strokes.
    const STROKE: f64 = 16.0;
    let along = |from: f64, to: f64| {
        let count = 5_u32;
        (0..=count).map(move |k| from + (to - from) * f64::from(k) / f64::from(count))
    };
    let outwards = match ends {
        [true, _] => -STROKE,
        [_, true] => STROKE,
        [false, false] => {
            for side in [-1.0, 1.0] {
                let level = y + side * CLEAR;
                canvas.line(&[[x - WIDTH, level], [x + WIDTH, level]], Color::BLACK, 5, Dash::Solid)?;
                let strokes = along(x - WIDTH, x + WIDTH).map(|at| [[at, level], [at - STROKE, level + side * STROKE]]);
                canvas.lines(&strokes.collect::<Vec<_>>(), Color::BLACK, 3, Dash::Solid)?;
            }
            return Ok(());
        }
    };
    canvas.line(&[[x, y - HEIGHT], [x, y + HEIGHT]], Color::BLACK, 6, Dash::Solid)?;
    let strokes = along(y - HEIGHT, y + HEIGHT).map(|at| [[x, at], [x + outwards, at + STROKE]]);
    canvas.lines(&strokes.collect::<Vec<_>>(), Color::BLACK, 3, Dash::Solid)
}

/// A zigzag below its level; if it is compression-only, with a plate for the beam to rest on.
fn spring(canvas: &mut Canvas, [x, y]: Point, pushes_only: bool) -> Result<(), PlotError> {
    /// Half the width of the zigzag, the number of its turns, and the depths of its ends.
    const HALF: f64 = 16.0;
    const TURNS: u32 = 6;
    const HEIGHTS: [f64; 2] = [10.0, 46.0];
    let turn = |k: u32| {
        let side = if k.is_multiple_of(2) { -HALF } else { HALF };
        [x + side, y + HEIGHTS[0] + (HEIGHTS[1] - HEIGHTS[0]) * (f64::from(k) + 0.5) / f64::from(TURNS)]
    };
    let ends = [[x, y], [x, y + HEIGHTS[0]], [x, y + HEIGHTS[1]], [x, y + HEIGHTS[1] + 8.0]];
    let line: Vec<Point> =
        ends[..2].iter().copied().chain((0..TURNS).map(turn)).chain(ends[2..].iter().copied()).collect();
    canvas.line(&line, Color::BLACK, 4, Dash::Solid)?;
    if pushes_only {
        canvas.line(&[[x - 30.0, y + 4.0], [x + 30.0, y + 4.0]], Color::BLACK, 6, Dash::Solid)?;
    }
    let ground = y + HEIGHTS[1] + 8.0;
    canvas.line(&[[x - 36.0, ground], [x + 36.0, ground]], Color::BLACK, 4, Dash::Solid)
}

/// A spiral around a position, on a short strut.
fn spiral(canvas: &mut Canvas, [x, y]: Point) -> Result<(), PlotError> {
    /// Number of quarter turns and final radius.
    const QUARTERS: usize = 9;
    const RADIUS: f64 = 30.0;
    const PARTS: usize = 6;
    let parts = QUARTERS * PARTS;
    let point = |k: usize| arc([x, y], RADIUS * count(k) / count(parts), [count(k) / count(PARTS); 2])[0];
    canvas.line(&(0..=parts).map(point).collect::<Vec<_>>(), Color::BLACK, 3, Dash::Solid)?;
    canvas.line(&[[x, y + RADIUS], [x, y + 50.0]], Color::BLACK, 4, Dash::Solid)?;
    canvas.line(&[[x - 36.0, y + 50.0], [x + 36.0, y + 50.0]], Color::BLACK, 4, Dash::Solid)
}

/// An arc around a position between two angles in quarters of a turn, clockwise on the page from the right.
pub(super) fn arc([x, y]: Point, radius: f64, [from, to]: [f64; 2]) -> Vec<Point> {
    const PARTS: u32 = 24;
    let at = |k: u32| {
        let quarters = from + (to - from) * f64::from(k) / f64::from(PARTS);
        let angle = 0.5 * std::f64::consts::PI * quarters;
        [x + radius * libm::cos(angle), y + radius * libm::sin(angle)]
    };
    (0..=PARTS).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::{Canvas, walls};

    /// Each stroke points away from the beam, which is at 100.
    #[test]
    fn where_the_beam_goes_on_there_is_a_wall_above_and_one_below() {
        let mut svg = String::new();
        let mut canvas = Canvas::new(&mut svg);
        walls(&mut canvas, [100.0, 100.0], [false; 2]).expect("walls");
        canvas.present().expect("a drawing");
        assert_eq!(svg.matches("<polyline").count(), 14, "{svg}");
        for line in
            ["66,88 134,88", "66,112 134,112", "66,88 50,72", "66,112 50,128", "134,88 118,72", "134,112 118,128"]
        {
            assert!(svg.contains(line), "{line} is missing in {svg}");
        }
    }
}
