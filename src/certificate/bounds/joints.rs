//! The pattern of contact as a list of joints, and Newton's method for their places.
//!
//! Between two neighbouring joints the beam either hangs free or lies on the foundation. Each joint has one unknown, a
//! slope or a place, and one equation:
//!
//! | joint | given | unknown | equation |
//! |---|---|---|---|
//! | support | `v = 0` | slope | `v'' = 0` |
//! | clamp: a support that the foundation is level with and holds the slope at | `v = 0`, `v' = u'` | none | |
//! | corner | `v = u` | slope | `v''` continuous |
//! | touch | `v = u`, `v' = u'` | place | `v''` continuous |
//! | start, end of a zone | `v = u`, `v' = u'` | place | `v'' = u''` |
//!
//! An equation that holds nearly is as good for a bound: the gap grows with the square of what is missing.

use super::ground::Ground;
use super::load::Pieces;
use super::span::Span;
use crate::certificate::interval::Interval;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Support,
    Clamp,
    Corner,
    Touch,
    Start,
    End,
}

impl Kind {
    /// True where the slope of the beam is not that of the foundation.
    pub(super) fn is_hinge(self) -> bool {
        matches!(self, Self::Support | Self::Corner)
    }
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    pub(super) kind: Kind,
    pub(super) x: f64,
    /// Of the beam, at a support or a corner.
    pub(super) slope: f64,
}

impl Joint {
    pub(super) fn new(kind: Kind, x: f64) -> Self {
        Self { kind, x, slope: 0.0 }
    }

    fn has_place_unknown(&self) -> bool {
        matches!(self.kind, Kind::Touch | Kind::Start | Kind::End)
    }
}

/// What the joints are asked in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Setting<'a> {
    pub(super) ground: Ground<'a>,
    pub(super) load: &'a Pieces,
    pub(super) stiffness: f64,
    pub(super) length: f64,
}

impl Setting<'_> {
    /// `v` and `v'` of the beam at a joint.
    pub(super) fn end(&self, joint: &Joint) -> [Interval; 2] {
        match joint.kind {
            Kind::Support => [Interval::ZERO, Interval::exact(joint.slope)],
            Kind::Corner => [self.ground.depth(joint.x), Interval::exact(joint.slope)],
            Kind::Clamp => [Interval::ZERO, self.ground.jet(joint.x)[1]],
            Kind::Touch | Kind::Start | Kind::End => {
                let [u, slope, ..] = self.ground.jet(joint.x);
                [u, slope]
            }
        }
    }

    /// The part between two joints; [`None`] where the beam lies on the foundation.
    pub(super) fn span(&self, left: &Joint, right: &Joint) -> Option<Span> {
        (left.kind != Kind::Start)
            .then(|| Span::new([left.x, right.x], [self.end(left), self.end(right)], self.load, self.stiffness))
    }
}

/// The derivatives of `[v'' at the left end, v'' at the right end]` of a span by the unknown of its left or right joint.
fn by_left(setting: &Setting<'_>, span: &Span, joint: &Joint) -> [f64; 2] {
    let length = span.length();
    if joint.has_place_unknown() {
        let missing = setting.ground.jet(joint.x)[2].middle() - span.start[2].middle();
        [span.start[3].middle() - 4.0 / length * missing, 2.0 / length * missing]
    } else {
        [-4.0 / length, 2.0 / length]
    }
}

fn by_right(setting: &Setting<'_>, span: &Span, joint: &Joint) -> [f64; 2] {
    let length = span.length();
    if joint.has_place_unknown() {
        let missing = setting.ground.jet(joint.x)[2].middle() - span.end[2].middle();
        [-2.0 / length * missing, span.end[3].middle() + 4.0 / length * missing]
    } else {
        [-2.0 / length, 4.0 / length]
    }
}

/// What Newton's method may change besides slopes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Places {
    /// Nothing: the equations of joints whose places are unknown are left out.
    Given,
    /// The places of joints that touch the foundation with its own slope.
    Free,
}

/// One step of Newton's method; the largest change, in units of length and slope.
///
/// Each equation reads `α v''(left span, right end) + β v''(right span, left end) + γ u'' = 0` and knows the unknowns of
/// its own joint and of the two beside it: a tridiagonal system.
pub(super) fn newton(setting: &Setting<'_>, joints: &mut [Joint], places: Places) -> Option<f64> {
    let n = joints.len();
    let spans: Vec<Option<Span>> = joints.windows(2).map(|w| setting.span(&w[0], &w[1])).collect();
    let mut rows = vec![[0.0, 1.0, 0.0, 0.0]; n];
    for (i, joint) in joints.iter().enumerate() {
        if places == Places::Given && joint.has_place_unknown() {
            continue;
        }
        let left = i.checked_sub(1).and_then(|k| spans[k].as_ref());
        let right = spans.get(i).and_then(Option::as_ref);
        let u = || setting.ground.jet(joint.x);
        let (alpha, beta, gamma) = match joint.kind {
            Kind::Support if i == 0 => (0.0, 1.0, 0.0),
            Kind::Support => (1.0, 0.0, 0.0),
            Kind::Corner | Kind::Touch => (1.0, -1.0, 0.0),
            Kind::Clamp => continue,
            Kind::Start if i == 0 => continue,
            Kind::End if i + 1 == n => continue,
            Kind::Start => (-1.0, 0.0, 1.0),
            Kind::End => (0.0, -1.0, 1.0),
        };
        let row = &mut rows[i];
        *row = [0.0; 4];
        if let Some(span) = left.filter(|_| alpha != 0.0) {
            row[3] += alpha * span.end[2].middle();
            row[0] += alpha * by_left(setting, span, &joints[i - 1])[1];
            row[1] += alpha * by_right(setting, span, joint)[1];
        }
        if let Some(span) = right.filter(|_| beta != 0.0) {
            row[3] += beta * span.start[2].middle();
            row[1] += beta * by_left(setting, span, joint)[0];
            row[2] += beta * by_right(setting, span, &joints[i + 1])[0];
        }
        if gamma != 0.0 {
            row[3] += gamma * u()[2].middle();
            row[1] += gamma * u()[3].middle();
        }
    }
    let change = tridiagonal(rows)?;
    let places: Vec<f64> = joints.iter().map(|j| j.x).collect();
    let mut most: f64 = 0.0;
    for (i, (joint, change)) in joints.iter_mut().zip(change).enumerate() {
        if joint.has_place_unknown() {
            // No joint may overtake its neighbour.
            let room = |k: Option<&f64>| k.map_or(0.0, |x| 0.4 * (x - places[i]).abs());
            let (back, forth) = (room(i.checked_sub(1).map(|k| &places[k])), room(places.get(i + 1)));
            let limited = (-change).clamp(-back, forth);
            joint.x += limited;
            most = most.max(limited.abs());
        } else {
            joint.slope -= change;
            most = most.max(change.abs() * setting.length);
        }
    }
    most.is_finite().then_some(most)
}

/// Solves rows `[below, diagonal, above, right side]`.
fn tridiagonal(mut rows: Vec<[f64; 4]>) -> Option<Vec<f64>> {
    for i in 1..rows.len() {
        let [_, pivot, above, right] = rows[i - 1];
        let factor = rows[i][0] / pivot;
        rows[i][1] -= factor * above;
        rows[i][3] -= factor * right;
    }
    let mut x = vec![0.0; rows.len() + 1];
    for (i, row) in rows.iter().enumerate().rev() {
        x[i] = (row[3] - row[2] * x[i + 1]) / row[1];
    }
    x.pop();
    x.iter().all(|x| x.is_finite()).then_some(x)
}
