//! The reference lines of a beam: through its supports, through positions where contact forces act, and through hinges connected to
//! parts that are held.

use super::contact_node::{EnclosedScene, EnclosedSupport};
use super::interval::Interval;
use super::polynomial::number;
use super::reference::{Datum, Line};

impl EnclosedScene<'_> {
    /// A support as a datum, with its reaction.
    pub(super) fn datum(&self, support: &EnclosedSupport, force: Interval) -> Datum {
        let Some(gives) = support.gives else { return Datum::at(support.x) };
        let soft =
            |of: Option<[Interval; 2]>| of.map_or(0.0, |[k, _]| (number(3) * Interval::exact(self.stiffness) / k).hi());
        let datum = Datum { soft: [soft(gives.spring), soft(gives.turning)], ..Datum::at(support.x) };
        let Some([k, d]) = gives.spring.filter(|_| gives.pushes) else { return datum };
        let sunk = (support.deflection - d).positive_part();
        Datum { presses: force.lo(), energy: (k * sunk.square() / number(2)).lo(), ..datum }
    }

    /// The supports that are not compression-only.
    pub(super) fn holding(&self) -> impl Iterator<Item = Datum> + '_ {
        self.supports.iter().filter(|support| !support.pushes()).map(|support| self.datum(support, Interval::ZERO))
    }

    /// Whether a hinge is at a position.
    pub(crate) fn is_hinge(&self, x: f64) -> bool {
        self.joints.iter().any(|joint| joint.1 <= 0.0 && joint.0.total_cmp(&x).is_eq())
    }

    /// Whether the beam has a hinge.
    pub(super) fn is_hinged(&self) -> bool {
        self.joints.iter().any(|joint| joint.1 <= 0.0)
    }
}

/// The lines that hold the beam, wherever it touches the foundation. They are pairs of neighbouring supports, and single positions:
/// those given `at`, where the beam cannot rotate or about which the loads are in balance, and rotational springs. If there are none,
/// the line through the best two of the `carriers`.
pub(super) fn lines(enclosed: &EnclosedScene<'_>, at: impl Iterator<Item = f64>, carriers: &mut [Datum]) -> Vec<Line> {
    let holding: Vec<Datum> = enclosed.holding().collect();
    let turning = holding.iter().copied().filter(|place| 0.0 < place.soft[1]);
    let alone: Vec<Datum> = at.map(Datum::at).chain(turning).collect();
    if enclosed.is_hinged() {
        return hinged(enclosed, &holding, &alone, carriers);
    }
    let held = held(&holding, &alone);
    if held.is_empty() { widest(carriers).into_iter().collect() } else { held }
}

/// The lines of positions that hold the beam, from left to right: all neighbouring pairs among supports of similar or greater stiffness,
/// and the positions that hold it `alone`.
fn held(places: &[Datum], alone: &[Datum]) -> Vec<Line> {
    /// Supports are similar if their flexibilities differ by at most this factor; a bound increases at most by its square root.
    const ALIKE: f64 = 100.0;
    let mut lines = Vec::new();
    let mut most = places.iter().fold(f64::INFINITY, |most, place| most.min(place.soft[0]));
    while most.is_finite() {
        let stiff: Vec<Datum> = places.iter().copied().filter(|place| place.soft[0] <= ALIKE * most).collect();
        lines.extend(stiff.windows(2).map(|w| Line(w[0], w[1])));
        let softer = places.iter().map(|place| place.soft[0]).filter(|soft| ALIKE * most < *soft);
        most = softer.fold(f64::INFINITY, f64::min);
    }
    lines.extend(alone.iter().map(|place| Line(*place, *place)));
    lines.sort_by(|a, b| a.0.from.total_cmp(&b.0.from));
    lines
}

/// The same for a beam with hinges, part by part. A part without a line of its own is also held by its hinges, if the neighbouring part
/// has lines.
fn hinged(enclosed: &EnclosedScene<'_>, holding: &[Datum], alone: &[Datum], carriers: &[Datum]) -> Vec<Line> {
    let hinges: Vec<f64> = enclosed.joints.iter().filter(|joint| joint.1 <= 0.0).map(|joint| joint.0).collect();
    let ends = [&[0.0][..], &hinges[..], &[enclosed.length][..]].concat();
    let parts: Vec<[f64; 2]> = ends.windows(2).map(|w| [w[0], w[1]]).collect();
    let within = |places: &[Datum], reach: [f64; 2]| -> Vec<Datum> {
        let inside = places.iter().filter(|place| reach[0] <= place.from && place.to <= reach[1]);
        inside.map(|place| Datum { reach, ..*place }).collect()
    };
    let mut lines: Vec<Vec<Line>> = vec![Vec::new(); parts.len()];
    for with_contacts in [false, true] {
        for _ in 0..parts.len() {
            for (i, reach) in parts.iter().enumerate() {
                if !lines[i].is_empty() {
                    continue;
                }
                let before = i.checked_sub(1).and_then(|i| hinge(&lines[i], reach[0], enclosed.soft()));
                let behind = lines.get(i + 1).and_then(|lines| hinge(lines, reach[1], enclosed.soft()));
                let mut places = within(holding, *reach);
                places.extend(before.into_iter().chain(behind).map(|hinge| Datum { reach: *reach, ..hinge }));
                places.sort_by(|a, b| a.from.total_cmp(&b.from));
                places.dedup_by(|b, a| b.from <= a.from);
                lines[i] = held(&places, &within(alone, *reach));
                if lines[i].is_empty() && with_contacts {
                    places.extend(within(carriers, *reach));
                    lines[i] = widest(&mut places).into_iter().collect();
                }
            }
        }
    }
    if lines.iter().any(Vec::is_empty) { Vec::new() } else { lines.concat() }
}

/// A hinge as a support of the part beyond it, from the lines of the part that holds it.
fn hinge(lines: &[Line], x: f64, soft: f64) -> Option<Datum> {
    let levers = lines.iter().map(|line| (line.lever([x; 2], soft), line));
    let (lever, line) = levers.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let Line(left, right) = line;
    Some(Datum {
        soft: [(lever * lever).next_up(), 0.0],
        uncertainty: line.shift([x; 2]),
        presses: line.presses(),
        energy: left.energy.min(right.energy),
        // The force at the two positions of the line together, since their deflections have the same uncertainty.
        spread: 2.0 * line.share([x; 2], 1.0, 0.0),
        ..Datum::at(x)
    })
}

/// The line through the two positions that hold the beam best: those with large contact forces and a large distance.
pub(super) fn widest(carriers: &mut [Datum]) -> Option<Line> {
    /// Number of positions with the largest forces among which the two are chosen.
    const MOST: usize = 64;
    carriers.sort_by(|a, b| b.presses.total_cmp(&a.presses));
    let strongest = &carriers[..carriers.len().min(MOST)];
    let pairs = strongest.iter().flat_map(|a| strongest.iter().map(move |b| Line(*a, *b)));
    let worth = |line: &Line| (line.1.from - line.0.to) * line.presses();
    pairs.filter(|Line(a, b)| a.to < b.from).max_by(|a, b| worth(a).total_cmp(&worth(b)))
}
