//! Lines as the drawing needs them: cut into dashes, and without the points that nobody would miss.

use super::error::{PlotError, finite};

/// A place on the drawing, `[right, down]`.
pub(super) type Point = [f64; 2];

/// Distance of the points that stand for a line when labels are placed.
pub(super) const INK: f64 = 9.0;

/// How far a line may pass beside a point that is left out \[drawing units\].
const BESIDE: f64 = 0.6;

/// The line through fewer of its points, none of the others farther from it than [`BESIDE`]
/// (Douglas and Peucker 1973).
pub(super) fn simplified(line: &[Point]) -> Result<Vec<Point>, PlotError> {
    for &[x, y] in line {
        finite("a place on the drawing", x)?;
        finite("a place on the drawing", y)?;
    }
    let Some(last) = line.len().checked_sub(1) else { return Ok(Vec::new()) };
    let mut kept = vec![false; line.len()];
    (kept[0], kept[last]) = (true, true);
    let mut pending = vec![(0, last)];
    while let Some((from, to)) = pending.pop() {
        let distance = |k: usize| (k, from_segment(line[k], line[from], line[to]));
        let farthest = (from + 1..to).map(distance).fold((from, BESIDE), |far, k| if far.1 < k.1 { k } else { far });
        if farthest.0 != from {
            kept[farthest.0] = true;
            pending.extend([(from, farthest.0), (farthest.0, to)]);
        }
    }
    Ok(line.iter().zip(kept).filter(|(_, kept)| *kept).map(|(&point, _)| point).collect())
}

/// Distance of a point from the segment between `a` and `b`.
fn from_segment([x, y]: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let s = if 0.0 < square { (((x - a[0]) * dx + (y - a[1]) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(x - a[0] - s * dx, y - a[1] - s * dy)
}

/// The strokes of a dashed line; the line itself if the pattern is empty.
pub(super) fn dashes(line: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    let Some(&first) = line.first().filter(|_| !pattern.is_empty()) else {
        return vec![line.to_vec()];
    };
    let mut strokes = Vec::new();
    let mut stroke = vec![first];
    let (mut phase, mut left) = (0, pattern[0]);
    for pair in line.windows(2) {
        let ([mut x, mut y], [to_x, to_y]) = (pair[0], pair[1]);
        loop {
            let (dx, dy) = (to_x - x, to_y - y);
            let distance = libm::hypot(dx, dy);
            if distance < left {
                left -= distance;
                if phase % 2 == 0 {
                    stroke.push([to_x, to_y]);
                }
                break;
            }
            (x, y) = (x + dx * left / distance, y + dy * left / distance);
            if phase % 2 == 0 {
                stroke.push([x, y]);
                strokes.push(std::mem::take(&mut stroke));
            } else {
                stroke = vec![[x, y]];
            }
            phase += 1;
            left = pattern[phase % pattern.len()];
        }
    }
    if 1 < stroke.len() {
        strokes.push(stroke);
    }
    strokes
}

/// Points along a line, at most `step` apart: what a label should not cover.
pub(super) fn sampled(line: &[Point], step: f64) -> Vec<Point> {
    let mut points: Vec<Point> = line.first().copied().into_iter().collect();
    for pair in line.windows(2) {
        let ([x, y], [to_x, to_y]) = (pair[0], pair[1]);
        let distance = libm::hypot(to_x - x, to_y - y);
        let mut done = step;
        while done < distance {
            points.push([x + (to_x - x) * done / distance, y + (to_y - y) * done / distance]);
            done += step;
        }
        points.push([to_x, to_y]);
    }
    points
}

#[cfg(test)]
mod tests {
    use super::{PlotError, dashes, simplified};

    #[test]
    fn dashes_follow_the_line_round_a_corner() {
        let strokes = dashes(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]], &[8.0, 4.0]);
        assert_eq!(strokes, [vec![[0.0, 0.0], [8.0, 0.0]], vec![[10.0, 2.0], [10.0, 10.0]]]);
    }

    #[test]
    fn a_line_keeps_its_corners_and_its_extremes() {
        let mut line: Vec<[f64; 2]> = (0..1000).map(|i| [f64::from(i) * 0.1, 0.0]).collect();
        line[400][1] = -7.0;
        line[600][1] = 9.0;
        let kept = simplified(&line).expect("finite places");
        assert!(kept.len() < 10, "{} points are left", kept.len());
        assert!(kept.contains(&[40.0, -7.0]) && kept.contains(&[60.0, 9.0]), "{kept:?}");
        assert!(matches!(simplified(&[[0.0, 0.0], [1.0, f64::NAN]]), Err(PlotError::NotFinite { .. })), "NaN");
    }
}
