//! Lines as the drawing needs them: cut into dashes, and thinned to what whole pixels can show.

/// A place on the drawing, `[right, down]`.
pub(super) type Point = [f64; 2];

/// Distance of the points that stand for a line when labels are placed.
pub(super) const INK: f64 = 9.0;

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
            let distance = (dx * dx + dy * dy).sqrt();
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

/// At most four points in each column of pixels: where the line enters, its top, its bottom, and where it leaves.
pub(super) fn thinned(line: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for column in line.chunk_by(|a, b| a[0].round().to_bits() == b[0].round().to_bits()) {
        if column.len() <= 4 {
            kept.extend_from_slice(column);
            continue;
        }
        let by = |better: fn(f64, f64) -> bool| {
            (1..column.len()).fold(0, |best, i| if better(column[i][1], column[best][1]) { i } else { best })
        };
        let mut chosen = [0, by(|a, b| a < b), by(|a, b| b < a), column.len() - 1];
        chosen.sort_unstable();
        kept.extend(chosen.iter().map(|&i| column[i]));
    }
    kept.dedup_by_key(|p| [p[0].round().to_bits(), p[1].round().to_bits()]);
    kept
}

/// Points along a line, at most `step` apart: what a label should not cover.
pub(super) fn sampled(line: &[Point], step: f64) -> Vec<Point> {
    let mut points: Vec<Point> = line.first().copied().into_iter().collect();
    for pair in line.windows(2) {
        let ([x, y], [to_x, to_y]) = (pair[0], pair[1]);
        let distance = ((to_x - x) * (to_x - x) + (to_y - y) * (to_y - y)).sqrt();
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
    use super::{dashes, thinned};

    #[test]
    fn dashes_follow_the_line_round_a_corner() {
        let strokes = dashes(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]], &[8.0, 4.0]);
        assert_eq!(strokes, [vec![[0.0, 0.0], [8.0, 0.0]], vec![[10.0, 2.0], [10.0, 10.0]]]);
    }

    #[test]
    fn thinning_keeps_the_extremes_of_a_column() {
        let mut line: Vec<[f64; 2]> = (0..1000).map(|i| [f64::from(i) * 1e-4, 0.0]).collect();
        line[400][1] = -7.0;
        line[600][1] = 9.0;
        let kept = thinned(&line);
        assert!(kept.len() <= 4, "{} points are left", kept.len());
        assert!(kept.iter().any(|p| p[1] < -6.0) && kept.iter().any(|p| 8.0 < p[1]), "{kept:?}");
    }
}
