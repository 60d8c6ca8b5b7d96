//! The variable in which a span is computed: its clearance or its deflection.

use super::piecewise::PiecewiseScene;
use super::span::{End, EndCondition};

/// A condition at an end of a span.
#[derive(Debug, Clone, Copy)]
pub(super) enum Prescribed {
    /// The slope, relative to the straight line through both ends.
    Slope(f64),
    /// The second derivative, times `e`.
    Curvature(f64),
}

/// The variable in which a span is computed, and the conditions at its ends.
///
/// The equations are the same in `v`, with `e v'''' = q`. Over many waves or cliffs of a profile they must be solved in `v`. There `h''`
/// has the size of `u''`, and the rounding of `v''` would have this size too.
pub(super) struct Way {
    /// Whether the variable is the deflection, not the clearance.
    pub(super) in_beam: bool,
    pub(super) holds: [EndCondition; 2],
    /// `h` at both ends.
    pub(super) heights: [f64; 2],
    /// `v` at both ends.
    pub(super) levels: [f64; 2],
    /// The slope of the straight line through both ends.
    pub(super) incline: f64,
    /// `u, u', e u'', e u'''` at both ends.
    pub(super) profiles: [[f64; 4]; 2],
    /// The second condition at each end.
    pub(super) held: [Prescribed; 2],
}

impl Way {
    /// For a span between two ends.
    pub(super) fn of(given: &PiecewiseScene, a: &End, b: &End) -> Self {
        let profiles = [given.derivatives(a.cell, a.x), given.derivatives(b.cell, b.x)];
        let ends = [a, b];
        let heights = [0, 1].map(|i| ends[i].hold.height());
        let levels = [0, 1].map(|i| ends[i].hold.level(profiles[i][0]));
        let bends = curvatures(given, [*a, *b], &profiles);
        let in_beam = is_in_beam(given, ends, heights, levels, bends);
        let rise = if in_beam {
            let beyond =
                |i: usize| if ends[i].hold == EndCondition::Resting { profiles[i][1] * ends[i].low } else { 0.0 };
            levels[1] - levels[0] + (beyond(1) - beyond(0))
        } else {
            heights[1] - heights[0]
        };
        let incline = rise / (b.x - a.x);
        Self { heights, ..Self::with([*a, *b], profiles, bends, (in_beam, levels, incline)) }
    }

    /// For a span with one or both ends on springs: in its deflection, relative to the level of its node.
    pub(super) fn afloat(given: &PiecewiseScene, ends: [End; 2], node: Option<End>) -> Self {
        let level = node.map_or(0.0, |node| node.hold.level(given.derivative(node.cell, node.x, 0)));
        let profiles = ends.map(|end| given.derivatives(end.cell, end.x));
        let bends = curvatures(given, ends, &profiles);
        Self::with(ends, profiles, bends, (true, [level; 2], 0.0))
    }

    /// For an overhang under an axial force: in its deflection, relative to the tangent at its node if the slope there is known.
    ///
    /// Relative to another line, the moment at the node would be the difference of two slopes over the length of the first part, which
    /// may be short.
    pub(super) fn overhanging(given: &PiecewiseScene, ends: [End; 2], free: usize) -> Self {
        let whole = Self::of(given, &ends[0], &ends[1]);
        let held = 1 - free;
        let bends = curvatures(given, ends, &whole.profiles);
        let slope = match ends[held].hold {
            EndCondition::Edge { slope: [slope, _], .. } => slope,
            EndCondition::Resting if whole.in_beam => whole.profiles[held][1],
            _ => return whole,
        };
        let mut levels = whole.levels;
        levels[free] = levels[held] + slope * (ends[free].x - ends[held].x);
        Self { heights: whole.heights, ..Self::with(ends, whole.profiles, bends, (true, levels, slope)) }
    }

    /// From the profile and its curvature `u''` (`bends`) at both ends.
    fn with(
        ends: [End; 2],
        profiles: [[f64; 4]; 2],
        bends: [f64; 2],
        (in_beam, levels, incline): (bool, [f64; 2], f64),
    ) -> Self {
        let held = [0, 1].map(|i| match (ends[i].hold, in_beam) {
            (EndCondition::Resting, true) => Prescribed::Slope(profiles[i][1] + bends[i] * ends[i].low - incline),
            (EndCondition::Resting, false) => Prescribed::Slope(-incline),
            (EndCondition::Edge { slope: [slope, rest], .. }, true) => Prescribed::Slope(slope - incline + rest),
            (EndCondition::Edge { slope: [slope, rest], .. }, false) => {
                Prescribed::Slope(profiles[i][1] - slope - rest - incline)
            }
            (EndCondition::Hinge { curvature, .. }, true) => Prescribed::Curvature(curvature),
            (EndCondition::Hinge { curvature, .. }, false) => Prescribed::Curvature(profiles[i][2] - curvature),
            (EndCondition::Free | EndCondition::Within, _) => Prescribed::Curvature(0.0),
        });
        Self { in_beam, holds: ends.map(|end| end.hold), heights: [0.0; 2], levels, incline, profiles, held }
    }

    /// Overwrites the computed values at an end by the given ones, which have no rounding error.
    pub(super) fn set_known(&self, i: usize, at: &mut [f64; 4], beam: &mut [f64; 4]) {
        if self.holds[i] == EndCondition::Free {
            return;
        }
        at[0] = self.heights[i];
        let profile = &self.profiles[i];
        match self.holds[i] {
            EndCondition::Resting => at[1] = 0.0,
            EndCondition::Edge { slope: [slope, rest], .. } => (at[1], beam[1]) = (profile[1] - slope - rest, slope),
            EndCondition::Hinge { curvature, .. } => (at[2], beam[2]) = (profile[2] - curvature, curvature),
            EndCondition::Free | EndCondition::Within => {}
        }
    }
}

/// The curvature `u''` of the profile at both ends.
fn curvatures(given: &PiecewiseScene, ends: [End; 2], profiles: &[[f64; 4]; 2]) -> [f64; 2] {
    [0, 1].map(|i| given.curvature(ends[i].cell, profiles[i][2]))
}

/// Whether a span is computed in its deflection, not in its clearance: the variable whose chord and curvature are smaller.
fn is_in_beam(given: &PiecewiseScene, [a, b]: [&End; 2], heights: [f64; 2], levels: [f64; 2], bends: [f64; 2]) -> bool {
    let chord = |at: [f64; 2]| 6.0 * at[0].abs().max(at[1].abs()) / ((b.x - a.x) * (b.x - a.x));
    // Between supports and edges the levels are given, and a clearance other than zero is the rounded difference of a depth and a level.
    let rests = [a, b].iter().any(|end| end.hold == EndCondition::Resting);
    let rounded = [0, 1].map(|i| if rests || heights[i] == 0.0 { 0.0 } else { levels[i].abs() });
    let terms = [0, 1].map(|i| heights[i].abs() + rounded[i]);
    let in_clearance = chord(terms).max(bends[0].abs().max(bends[1].abs()));
    chord(levels) < in_clearance || is_broken(given, a, b, chord(levels))
}

/// Whether one of the kinks and steps inside a span contributes more than this to `h''`. Over a cliff that goes down and up again the
/// contributions are huge and cancel, so that `h` is unsuitable for the computation.
fn is_broken(given: &PiecewiseScene, a: &End, b: &End, bend: f64) -> bool {
    let l = b.x - a.x;
    let more = |[kink, step]: [f64; 2]| bend < (4.0 * kink + 6.0 * step / l) / l;
    let inside = || given.breakpoints_between(a.cell, b.cell).iter();
    more(given.roughest) && inside().any(|j| more([j.kink.abs(), j.step.abs()]))
}
