//! Sketches of the given data: the foundation below the beam, the loads above it, supports, joints and units.

use super::curves::Curves;
use super::layer::{Divisions, Layer, LoadSketch, Place, SupportKind, SupportMark};
use super::{DIGITS, SAMPLES};
use crate::scene::{Foundation, Joint, Scene, Support, Units};
use crate::text::significant;

/// The drawn part of the foundation.
pub(super) struct Ground {
    /// The intervals that are drawn, from left to right.
    pub(super) pieces: Vec<Vec<Place>>,
    /// Labels with the depth where the foundation is below the drawing, one for each interval.
    pub(super) below: Vec<(Place, String)>,
    /// A sentence of the description that says why something is missing.
    pub(super) remark: Option<String>,
}

/// Depth limit as a multiple of the largest deflection. A deeper foundation would flatten the beam to a line, so it is not drawn and
/// a label gives its depth. A line at the border would look like the foundation.
const DEEPEST: f64 = 4.0;

pub(super) fn foundation_line(scene: &Scene, curves: &Curves) -> Ground {
    let length = scene.beam().length();
    let even = (0..=SAMPLES).map(|i| length * f64::from(i) / f64::from(SAMPLES));
    let line: Vec<Place> = match scene.foundation() {
        None => {
            let remark = Some("There is no foundation, so there is no clearance.".to_owned());
            return Ground { pieces: Vec::new(), below: Vec::new(), remark };
        }
        Some(Foundation::Polyline { points }) => points.clone(),
        Some(Foundation::Flat { depth }) => vec![[0.0, *depth], [length, *depth]],
        Some(smooth) => even.map(|x| [x, smooth.depth(x)]).collect(),
    };
    let deflected = curves.axis().iter().fold(0.0_f64, |most, p| most.max(p[1].abs()));
    let limit = if 0.0 < deflected { DEEPEST * deflected } else { f64::INFINITY };
    let (pieces, gaps) = cut(&line, limit);
    // An interval without a drawn foundation is marked at the bottom of the drawing.
    let bottom = if pieces.is_empty() { deflected } else { limit };
    let deepest = |[from, to]: [f64; 2]| {
        let inside = line.iter().filter(|p| from <= p[0] && p[0] <= to);
        inside.fold(limit, |most: f64, p| most.max(p[1]))
    };
    let shallowest = line.iter().fold(f64::INFINITY, |least, p| least.min(p[1]));
    let in_words = |depth: f64| with_unit(depth, &scene.units().length);
    let below: Vec<(Place, String)> = gaps
        .iter()
        .map(|&gap| {
            let depth = if pieces.is_empty() { shallowest } else { deepest(gap) };
            let word = if pieces.is_empty() { " or deeper" } else { "" };
            ([0.5 * (gap[0] + gap[1]), bottom], format!("ground at {}{word} ↓", in_words(depth)))
        })
        .collect();
    let remark = if pieces.is_empty() {
        let depth = in_words(shallowest);
        Some(format!("The foundation lies far below the beam, at {depth} or deeper, and is not drawn with it."))
    } else if below.is_empty() {
        None
    } else {
        Some(format!("The foundation is not drawn where it lies deeper than {}.", in_words(limit)))
    };
    Ground { pieces: above_ground(scene, pieces), below, remark }
}

/// The same without the parts above gaps in an elastic foundation.
fn above_ground(scene: &Scene, pieces: Vec<Vec<Place>>) -> Vec<Vec<Place>> {
    if scene.ground_parts().all(|(_, k)| 0.0 < k) {
        return pieces;
    }
    let at = |piece: &[Place], x: f64| {
        let next = piece.partition_point(|p| p[0] < x).clamp(1, piece.len() - 1);
        let [a, b] = [piece[next - 1], piece[next]];
        [x, a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0]))]
    };
    let within = |piece: &Vec<Place>, [from, to]: [f64; 2]| {
        let [from, to] = [from.max(piece[0][0]), to.min(piece[piece.len() - 1][0])];
        let inside = piece.iter().copied().filter(|p| from < p[0] && p[0] < to);
        let all = || std::iter::once(at(piece, from)).chain(inside).chain([at(piece, to)]).collect::<Vec<Place>>();
        (from < to && 2 <= piece.len()).then(all)
    };
    let grounded: Vec<[f64; 2]> = scene.ground_parts().filter(|(_, k)| 0.0 < *k).map(|(part, _)| part).collect();
    pieces.iter().flat_map(|piece| grounded.iter().filter_map(|part| within(piece, *part))).collect()
}

/// The parts of a line that are not deeper than `limit`, and the intervals in which it is deeper.
fn cut(line: &[Place], limit: f64) -> (Vec<Vec<Place>>, Vec<[f64; 2]>) {
    let (mut pieces, mut gaps) = (Vec::new(), Vec::new());
    let mut piece: Vec<Place> = Vec::new();
    let mut since: Option<f64> = line.first().filter(|p| limit < p[1]).map(|p| p[0]);
    for (i, &here) in line.iter().enumerate() {
        let before = i.checked_sub(1).map_or(here, |i| line[i]);
        if (limit < before[1]) != (limit < here[1]) {
            let x = before[0] + (here[0] - before[0]) * ((limit - before[1]) / (here[1] - before[1]));
            piece.push([x, limit]);
            match since.take() {
                Some(from) => gaps.push([from, x]),
                None => {
                    since = Some(x);
                    pieces.push(std::mem::take(&mut piece));
                }
            }
        }
        if here[1] <= limit {
            piece.push(here);
        }
    }
    if let (Some(from), Some(last)) = (since, line.last()) {
        gaps.push([from, last[0]]);
    }
    if !piece.is_empty() {
        pieces.push(piece);
    }
    (pieces, gaps)
}

/// The supports as engineering symbols. The first simple support is a hinge and the others are rollers, unless the beam is built in.
/// A compression-only support is a block that is not connected to the beam, and an elastic support is a spring.
pub(super) fn support_marks(scene: &Scene) -> Layer {
    let (beam, supports) = (scene.beam(), scene.beam().all_supports());
    let is_held = supports.iter().any(Support::is_built_in);
    let mark = |(i, support): (usize, &Support)| {
        let kind = match support.slope {
            _ if support.stiffness.is_some() => SupportKind::Spring(support.pushes_only),
            _ if support.turning_stiffness.is_some() => SupportKind::Turning,
            Some(_) => SupportKind::BuiltIn { ends: [support.at <= 0.0, beam.length() <= support.at] },
            None if support.pushes_only => SupportKind::Bearing,
            None if i == 0 && !is_held => SupportKind::Hinge,
            None => SupportKind::Roller,
        };
        SupportMark { at: [support.at, support.level], kind }
    };
    let both = |support: &&Support| support.stiffness.is_some() && support.turning_stiffness.is_some();
    let turning = supports.iter().filter(both).map(|s| SupportMark { at: [s.at, s.level], kind: SupportKind::Turning });
    Layer::Supports(supports.iter().enumerate().map(mark).chain(turning).collect())
}

/// The joints, on the deflected beam.
pub(super) fn joint_marks(scene: &Scene, curves: &Curves) -> Layer {
    let axis = curves.axis();
    let height = |x: f64| axis.iter().find(|p| x <= p[0]).map_or(0.0, |p| p[1]);
    let mark = |joint: &Joint| SupportMark {
        at: [joint.at, height(joint.at)],
        kind: SupportKind::Joint { open: joint.stiffness.is_none() },
    };
    Layer::Supports(scene.beam().joints().iter().map(mark).collect())
}

/// Positions at which the bending stiffness changes, and its values between them.
pub(super) fn changes(scene: &Scene, units: &UnitLabels) -> Divisions {
    let (beam, steps) = (scene.beam(), scene.beam().steps());
    if beam.changes().next().is_none() {
        return Divisions::default();
    }
    let ends = steps.iter().skip(1).map(|step| step[0]).chain([beam.length()]);
    let of = |([from, stiffness], to): (&[f64; 2], f64)| {
        ([*from, to], format!("EI = {}", with_unit(*stiffness, &units.stiffness)))
    };
    Divisions {
        lines: beam.changes().map(|x| (x, String::new())).collect(),
        between: steps.iter().zip(ends).map(of).collect(),
    }
}

/// `q(x)` as a line with its steps, the point loads and the couples.
pub(super) fn sketch(scene: &Scene, curves: &Curves, units: &UnitLabels) -> LoadSketch {
    let (load, length) = (scene.load(), scene.beam().length());
    let mut cuts: Vec<f64> = load.linear().iter().flat_map(|q| [q.from, q.to]).chain([0.0, length]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by_key(|x| x.to_bits());
    let mut intensity = Vec::new();
    let mut values: Vec<(f64, f64, String)> = Vec::new();
    for pair in cuts.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let middle = 0.5 * (from + to);
        let q = |x: f64| {
            let linear = load.linear().iter().filter(|q| (q.from..=q.to).contains(&middle)).map(|q| q.intensity(x));
            load.uniform() + linear.sum::<f64>()
        };
        let (start, end) = (q(from), q(to));
        intensity.extend([[from, start], [to, end]]);
        let text = |value: f64| format!("q = {}", with_unit(value, &units.pressure));
        if start.to_bits() == end.to_bits() {
            if start != 0.0 {
                values.push((middle, start, text(start)));
            }
        } else if end.abs() < start.abs() {
            values.push((from, start, text(start)));
        } else {
            values.push((to, end, text(end)));
        }
    }
    let points = load.point().iter().map(|p| (p.at, p.force, with_unit(p.force.abs(), &units.force))).collect();
    // Above the highest point of the beam, which may rise above the line of its supports.
    let drawn = curves.axis().into_iter().map(|p| p[1]).chain(curves.shape.iter().copied());
    let level = drawn.fold(0.0_f64, f64::min);
    let couples = load.couple().iter().map(|c| (c.at, c.moment, with_unit(c.moment.abs(), &units.moment))).collect();
    LoadSketch { level, intensity, values, points, couples }
}

/// Units as they are printed; `None` if the scene has none.
pub(super) struct UnitLabels {
    pub(super) length: Option<String>,
    pub(super) force: Option<String>,
    pub(super) pressure: Option<String>,
    pub(super) moment: Option<String>,
    /// Unit of bending stiffness.
    pub(super) stiffness: Option<String>,
}

impl UnitLabels {
    pub(super) fn of(units: &Units) -> Self {
        let both = |join: &str| Some(format!("{}{join}{}", units.force.as_ref()?, units.length.as_ref()?));
        Self {
            length: units.length.clone(),
            force: units.force.clone(),
            pressure: both("/"),
            moment: both("·"),
            stiffness: both("·").map(|moment| moment + "²"),
        }
    }

    /// Units for axes: a scene without units has the dimension in place of each unit.
    pub(super) fn of_axes(units: &Units) -> Self {
        let named = |unit: &Option<String>, dimension: &str| unit.clone().or_else(|| Some(dimension.to_owned()));
        Self::of(&Units { length: named(&units.length, "length"), force: named(&units.force, "force") })
    }
}

/// A value with its unit, for example `1.182 kN`.
pub(super) fn with_unit(value: f64, unit: &Option<String>) -> String {
    let number = significant(value, DIGITS);
    unit.as_ref().map_or(number.clone(), |unit| format!("{number} {unit}"))
}

#[cfg(test)]
mod tests {
    use super::{SupportKind, cut, support_marks};
    use crate::plot::Layer;
    use crate::scene::{Beam, Load, Scene, Support};

    #[test]
    fn walls_close_the_ends_of_a_beam() {
        let supports = [0.0, 4.0, 10.0].map(Support::built_in).to_vec();
        let beam = Beam::new(10.0, 1.0).and_then(|beam| beam.with_supports(supports)).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        let Layer::Supports(marks) = support_marks(&Scene::new(beam, load, None).expect("a scene")) else {
            panic!("no supports")
        };
        let ends = marks.iter().map(|mark| match mark.kind {
            SupportKind::BuiltIn { ends } => ends,
            _ => panic!("{mark:?}"),
        });
        assert_eq!(ends.collect::<Vec<_>>(), [[true, false], [false; 2], [false, true]]);
    }

    #[test]
    fn a_pit_is_cut_out_where_it_is_too_deep() {
        let line = [[0.0, 1.0], [2.0, 3.0], [4.0, 1.0], [5.0, 1.0]];
        let (pieces, gaps) = cut(&line, 2.0);
        assert_eq!(pieces, [vec![[0.0, 1.0], [1.0, 2.0]], vec![[3.0, 2.0], [4.0, 1.0], [5.0, 1.0]]]);
        assert_eq!(gaps, [[1.0, 3.0]]);
    }

    #[test]
    fn ground_that_is_all_too_deep_is_one_gap() {
        let (pieces, gaps) = cut(&[[0.0, 9.0], [5.0, 8.0]], 2.0);
        assert!(pieces.is_empty(), "nothing is drawn");
        assert_eq!(gaps, [[0.0, 5.0]]);
    }
}
