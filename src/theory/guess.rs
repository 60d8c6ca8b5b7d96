//! From the contacts of a chain of samples to a list of points and zones.

use super::chain::{Chain, Guess};
use super::edge::edge_node;
use super::given::Given;
use super::list::{AtSupport, Kind, List, Node};
use super::tidy::consistent;
use super::zones::add_zones;

/// The list that a chain with about `intervals` links suggests.
pub(super) fn list(given: &Given, lifting: &[(f64, f64)], intervals: u32) -> List {
    let x = samples(given, intervals);
    let n = x.len() - 2;
    let depth: Vec<f64> = x[1..=n].iter().map(|&x| given.depth(x)).collect();
    let load = loads(given, &x);
    let guess = Chain { x: &x, depth: &depth, load: &load }.solve();
    let mut list = List::free();
    let mut i = 0;
    while i < n {
        if guess.touches(i) {
            let first = i;
            while i < n && guess.touches(i) {
                i += 1;
            }
            add_run(given, lifting, &x, &guess, first..i, &mut list);
        } else {
            i += 1;
        }
    }
    consistent(given, list)
}

/// Sample places: all joints, and cells cut into parts of about equal length.
fn samples(given: &Given, intervals: u32) -> Vec<f64> {
    let aim = given.length / f64::from(intervals);
    let mut x = vec![0.0];
    for cell in &given.cells {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most `intervals`")]
        let parts = ((cell.hi - cell.lo) / aim).ceil() as u32;
        for part in 1..parts {
            x.push(cell.lo + (cell.hi - cell.lo) * (f64::from(part) / f64::from(parts)));
        }
        x.push(cell.hi);
    }
    if x.len() < 3 {
        x.insert(1, 0.5 * given.length);
    }
    x
}

/// Loads at the samples between the supports, by the law of the lever.
fn loads(given: &Given, x: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; x.len()];
    let mut cell = 0;
    for (i, w) in x.windows(2).enumerate() {
        while cell + 1 < given.cells.len() && given.cells[cell].hi <= w[0] {
            cell += 1;
        }
        let (start, end, width) = (given.load(cell, w[0]), given.load(cell, w[1]), w[1] - w[0]);
        force[i] += width * (2.0 * start + end) / 6.0;
        force[i + 1] += width * (start + 2.0 * end) / 6.0;
    }
    for joint in &given.joints {
        let i = x.partition_point(|&x| x < joint.x).min(x.len() - 1);
        force[i] += joint.force;
    }
    force[1..x.len() - 1].to_vec()
}

/// Adds the contacts of one run of touching samples.
fn add_run(
    given: &Given,
    lifting: &[(f64, f64)],
    x: &[f64],
    guess: &Guess,
    run: std::ops::Range<usize>,
    list: &mut List,
) {
    // The run falls apart at every break of the profile.
    let mut first = run.start;
    let mut beside_edge = false;
    for i in run.clone() {
        let place = x[i + 1];
        let joint = given.joints.partition_point(|j| j.x < place);
        let at_joint = given.joints.get(joint).is_some_and(|j| j.x <= place);
        if at_joint && given.breaks_at(joint) {
            let edge = given.is_edge(joint);
            add_stretch(given, lifting, x, guess, first..i, [beside_edge, edge], list);
            if edge {
                list.nodes.push(edge_node(given, joint));
            }
            (first, beside_edge) = (i + 1, edge);
        }
    }
    add_stretch(given, lifting, x, guess, first..run.end, [beside_edge, false], list);
}

/// Adds a point or zones for a run of samples on one smooth piece of the profile.
fn add_stretch(
    given: &Given,
    lifting: &[(f64, f64)],
    x: &[f64],
    guess: &Guess,
    run: std::ops::Range<usize>,
    beside_edge: [bool; 2],
    list: &mut List,
) {
    let n = x.len() - 2;
    if run.is_empty() {
        return;
    }
    let touches_left = run.start == 0 && given.starts_at_zero(0);
    let touches_right = run.end == n && given.starts_at_zero(1);
    if run.len() <= 2 && !touches_left && !touches_right {
        // The force of an edge spreads to its neighbours.
        if beside_edge == [false; 2] {
            let (force, moment) = run.fold((0.0, 0.0), |(f, m), i| (f + guess.force[i], m + guess.force[i] * x[i + 1]));
            let mut place = moment / force;
            // Contact beside a support that lies just above the foundation, closer to it than any sample: from h'' linear
            // between u'' at the support and as much again at the contact, depth = u'' x²/2.
            let closest = |depth: f64, bend: f64| if 0.0 < bend { (2.0 * depth / bend).sqrt() } else { f64::INFINITY };
            let last = given.cells.len() - 1;
            if place <= x[2] {
                place = place.min(closest(given.derivative(0, 0.0, 0), given.derivative(0, 0.0, 2)));
            } else if x[n - 1] <= place {
                let (depth, bend) = (given.derivative(last, given.length, 0), given.derivative(last, given.length, 2));
                place = place.max(given.length - closest(depth, bend));
            }
            let cell = given.cell_from(place);
            list.nodes.push(Node::new(Kind::Smooth, place, cell));
        }
        return;
    }
    if touches_left && run.len() <= 2 {
        list.supports[0] = AtSupport::Clamped;
        return;
    }
    if touches_right && run.len() <= 2 {
        list.supports[1] = AtSupport::Clamped;
        return;
    }
    let from = if touches_left { 0.0 } else { lift_off(x, guess, run.clone().take(4)) };
    let to = if touches_right { given.length } else { lift_off(x, guess, run.clone().rev().take(4)) };
    let resolution = 2.0 * (x[run.end] - x[run.start + 1]) / f64::from(u32::try_from(run.len()).unwrap_or(u32::MAX));
    add_zones(given, lifting, [from, to], resolution, list);
}

/// Where the concentrated force at the end of a zone acts, from the end samples of its run: what they have more than the
/// innermost of them.
fn lift_off(x: &[f64], guess: &Guess, samples: impl Iterator<Item = usize>) -> f64 {
    let samples: Vec<usize> = samples.collect();
    let inner = samples.last().map_or(0.0, |&i| guess.force[i]);
    let outer = samples.first().map_or(0.0, |&i| x[i + 1]);
    let (mut sum, mut moment) = (0.0, 0.0);
    for &i in &samples {
        let more = (guess.force[i] - inner).max(0.0);
        sum += more;
        moment += more * x[i + 1];
    }
    if 0.0 < sum { moment / sum } else { outer }
}
