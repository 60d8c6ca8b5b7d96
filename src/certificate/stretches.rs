//! A candidate contact list on an elastic foundation: parts of the beam and the penetration of the pressed ones, from any source; cut
//! for the kernel.

use super::kernel::contact_node::EnclosedScene;
use super::kernel::springs::MOST_TERMS;
pub use super::kernel::springs::Stretch;

/// Cells in a length of `1/λ`, `4λ⁴ = k/EI`: the terms beyond [`MOST_TERMS`] coefficients are then a billionth (*tuned* with them).
const CELLS_IN_A_LENGTH: f64 = 8.0;

/// A stretch longer than this number of lengths `1/λ` is deep in a zone, and its polynomial is known to the last coefficient.
const MOST_LENGTHS: f64 = 2.0;

/// Smallest number of cells of a short stretch, and of all short stretches together if there are many. If the foundation holds the beam
/// in one stretch, two of its cells hold it that are apart and pressed everywhere.
const FEWEST: [f64; 2] = [6.0, 24.0];

/// A stretch shorter than this share of all pressed stretches is not cut into several cells.
const SHORTEST: f64 = 1e-3;

/// A part that hangs over less than this share of the beam may be treated as pressed, together with the stretch next to it.
const SHORT: f64 = 1e-5;

/// The stretches of a scene in dimensionless numbers, cut at the breaks of foundation and load and into short cells. A part that hangs
/// is one stretch, from one support or pressed part to the next.
pub(super) fn cut(enclosed: &EnclosedScene<'_>, given: &[Stretch]) -> Vec<Stretch> {
    let mut cut = Vec::new();
    let joined = joined(enclosed, given);
    let widths = joined.iter().filter(|s| !s.sunk.is_empty()).map(|s| s.to - s.from);
    let [together, count] = widths.fold([0.0, 0.0], |[sum, count], width| [sum + width, count + 1.0]);
    let fewest = (FEWEST[1] / count).clamp(1.0, FEWEST[0]);
    for stretch in joined {
        let (width, length) = (stretch.to - stretch.from, length(enclosed, &stretch));
        if stretch.sunk.is_empty() {
            cut.push(stretch);
        } else if width <= MOST_LENGTHS * length {
            let most = (width / fewest).max(SHORTEST * together).min(length / CELLS_IN_A_LENGTH);
            cells(enclosed, most, &stretch, &mut cut);
        } else {
            cells(enclosed, width, &stretch, &mut cut);
        }
    }
    // Replaces derivatives by moment and vertical force.
    for stretch in &mut cut {
        let (presses, at) = (!stretch.sunk.is_empty(), [(stretch.from, false), (stretch.to, true)]);
        for (end, (x, left)) in stretch.ends.iter_mut().zip(at) {
            let gap = enclosed.gap.jet(x, left).map(|g| if presses { g.middle() } else { 0.0 });
            let stiffness = enclosed.stiffness_beside(x, left).middle();
            (end[2], end[3]) = (-stiffness * (end[2] + gap[2]), -stiffness * (end[3] + gap[3]));
            if enclosed.tension != 0.0 {
                end[3] += enclosed.tension * (end[1] + gap[1]);
            }
        }
    }
    cut
}

/// `1/λ` of a stretch, infinite where there is no foundation, and at most `1/μ` under an axial force.
fn length(enclosed: &EnclosedScene<'_>, stretch: &Stretch) -> f64 {
    let ends = [stretch.from, stretch.to];
    let stiffness = enclosed.stiffness_between(ends);
    let decay = (0.25 * enclosed.ground_between(ends) / stiffness).sqrt().sqrt().recip();
    if enclosed.tension == 0.0 { decay } else { decay.min((stiffness / enclosed.tension.abs()).sqrt()) }
}

/// Joins the parts that hang between two supports or pressed stretches into one stretch.
fn spans(enclosed: &EnclosedScene<'_>, given: &[Stretch]) -> Vec<Stretch> {
    let mut spans: Vec<Stretch> = Vec::new();
    for stretch in given {
        let hang = |last: &Stretch| last.sunk.is_empty() && stretch.sunk.is_empty();
        match spans.last_mut() {
            Some(last) if hang(last) && enclosed.support(stretch.from).is_none() => {
                (last.to, last.ends[1]) = (stretch.to, stretch.ends[1]);
            }
            _ => spans.push(stretch.clone()),
        }
    }
    spans
}

/// The stretches with each hanging part as one stretch, and without parts that hang over a negligible length.
fn joined(enclosed: &EnclosedScene<'_>, given: &[Stretch]) -> Vec<Stretch> {
    let mut joined: Vec<Stretch> = Vec::new();
    let mut stretches = spans(enclosed, given).into_iter().peekable();
    while let Some(stretch) = stretches.next() {
        let sunk = [(stretch.from, false), (stretch.to, true)].map(|(x, left)| {
            let (v, gap) = (stretch.ends[usize::from(left)], enclosed.gap.jet(x, left));
            [0, 1, 2, 3].map(|j| v[j] - gap[j].middle())
        });
        let joins = is_negligible(enclosed, &stretch, sunk.map(|w| w[0]));
        let with = |beside: &Stretch, x: f64| joins && !beside.sunk.is_empty() && is_smooth(enclosed, x);
        if let Some(last) = joined.last_mut().filter(|last| with(last, stretch.from)) {
            (last.to, last.ends[1]) = (stretch.to, sunk[1]);
        } else if let Some(next) = stretches.peek_mut().filter(|next| with(next, stretch.to)) {
            next.sunk = shifted(&next.sunk, stretch.from - next.from);
            (next.from, next.ends[0]) = (stretch.from, sunk[0]);
        } else {
            joined.push(stretch);
        }
    }
    without_slivers(enclosed, joined)
}

/// Whether a stretch that hangs may be treated as pressed. It must be short, foundation and load must have one formula on it, and the
/// tension that this cuts off must cost less than the rounding of its curvature, a difference of two given depths or slopes over its
/// width.
fn is_negligible(enclosed: &EnclosedScene<'_>, stretch: &Stretch, sunk: [f64; 2]) -> bool {
    let ends = [stretch.from, stretch.to];
    let [ground, stiffness] = [enclosed.ground_between(ends), enclosed.stiffness_between(ends)];
    let width = stretch.to - stretch.from;
    let one_formula = || {
        enclosed.gap.is_smooth_between(stretch.from, stretch.to)
            && enclosed.breaks(stretch.from, stretch.to).is_empty()
            && 0.0 < ground
    };
    if !stretch.sunk.is_empty() || SHORT * enclosed.length < width || !one_formula() {
        return false;
    }
    let most = |of: [f64; 2]| of[0].abs().max(of[1].abs());
    let rounding = |derivative: usize| f64::EPSILON * most(stretch.ends.map(|end| end[derivative]));
    // At a support the kernel knows the depth, elsewhere the rise of the foundation.
    let is_held = [stretch.from, stretch.to].iter().any(|x| enclosed.support(*x).is_some());
    let bent = 6.0 / width * if is_held { rounding(0) / width } else { rounding(1) };
    ground * most(sunk) * most(sunk) <= stiffness * bent * bent
}

/// True if foundation, load and beam are smooth at a position and there is no support.
fn is_smooth(enclosed: &EnclosedScene<'_>, x: f64) -> bool {
    let is_loaded_alike = enclosed.breaks(x.next_down(), x.next_up()).is_empty();
    enclosed.support(x).is_none() && enclosed.gap.is_smooth_at(x) && is_loaded_alike
}

/// Extends polynomials over far shorter neighbouring stretches: over a short cell curvatures consist of rounding.
fn without_slivers(enclosed: &EnclosedScene<'_>, stretches: Vec<Stretch>) -> Vec<Stretch> {
    /// Share of the neighbouring stretch over which its polynomial may be extended.
    const SLIVER: f64 = 0.2;
    let mut whole: Vec<Stretch> = Vec::new();
    let mut rest = stretches.into_iter().peekable();
    while let Some(stretch) = rest.next() {
        let far_shorter = |beside: &Stretch, x: f64| {
            let pressed = !stretch.sunk.is_empty() && !beside.sunk.is_empty();
            let decays = beside.to - beside.from <= MOST_LENGTHS * length(enclosed, beside);
            pressed
                && decays
                && stretch.to - stretch.from <= SLIVER * (beside.to - beside.from)
                && is_smooth(enclosed, x)
        };
        if let Some(last) = whole.last_mut().filter(|last| far_shorter(last, stretch.from)) {
            (last.to, last.ends[1]) = (stretch.to, stretch.ends[1]);
        } else if let Some(next) = rest.peek_mut().filter(|next| far_shorter(next, stretch.to)) {
            next.sunk = shifted(&next.sunk, stretch.from - next.from);
            (next.from, next.ends[0]) = (stretch.from, stretch.ends[0]);
        } else {
            whole.push(stretch);
        }
    }
    whole
}

/// Divides a pressed stretch into cells of at most this width.
fn cells(enclosed: &EnclosedScene<'_>, most: f64, stretch: &Stretch, cut: &mut Vec<Stretch>) {
    let (from, to) = (stretch.from, stretch.to);
    let most = most.min(to - from);
    let (breaks, loads) = (enclosed.gap.breaks(from, to), enclosed.breaks(from, to));
    let (smooth, mut ends): (Vec<f64>, Vec<f64>) = breaks.into_iter().partition(|x| enclosed.gap.is_smooth_at(*x));
    // The breaks of a smooth profile determine only the number of cells, not their ends.
    let most =
        smooth.iter().fold((to - from, 1.0), |(_, count), _| ((to - from) / (count + 1.0), count + 1.0)).0.min(most);
    ends.extend(loads.into_iter().chain([from, to]));
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let parts = |w: &[f64]| {
        let (a, b) = (w[0], w[1]);
        let parts = ((b - a) / most * (1.0 - f64::EPSILON)).ceil().max(1.0);
        let inside = (1_u32..).map(f64::from).take_while(move |k| *k < parts).map(move |k| a + (b - a) * (k / parts));
        std::iter::once(a).chain(inside)
    };
    let mut ends: Vec<f64> = ends.windows(2).flat_map(parts).collect();
    ends.push(to);
    for [a, b] in ends.windows(2).map(|w| [w[0], w[1]]) {
        let mut sunk = shifted(&stretch.sunk, a - from);
        let first = if a <= from { stretch.ends[0] } else { jet(&sunk) };
        let last = if to <= b { stretch.ends[1] } else { jet(&shifted(&stretch.sunk, b - from)) };
        sunk.truncate(MOST_TERMS);
        cut.push(Stretch { from: a, to: b, sunk, ends: [first, last] });
    }
}

/// The coefficients about another origin.
fn shifted(taylor: &[f64], s: f64) -> Vec<f64> {
    let mut taylor = taylor.to_vec();
    for start in 0..taylor.len() {
        for j in (start..taylor.len() - 1).rev() {
            taylor[j] += taylor[j + 1] * s;
        }
    }
    taylor
}

/// Value and three derivatives at the origin.
fn jet(taylor: &[f64]) -> [f64; 4] {
    [1.0, 1.0, 2.0, 6.0].map({
        let mut terms = taylor.iter();
        move |factor| factor * terms.next().unwrap_or(&0.0)
    })
}
