//! A witness on ground that gives: parts of the beam, and how the pressed ones are sunk, from any source; cut for the kernel.

use super::kernel::contact_node::EnclosedScene;
use super::kernel::springs::MOST_TERMS;
pub use super::kernel::springs::Stretch;

/// Cells in a length of `1/λ`, `4λ⁴ = k/EI`: what [`MOST_TERMS`] coefficients leave out is a billionth then (*tuned* with them).
const CELLS_IN_A_LENGTH: f64 = 8.0;

/// A stretch that is longer is deep in a zone, and its polynomial is known to the last coefficient.
const MOST_LENGTHS: f64 = 2.0;

/// Cells of a short stretch: a beam that ground holds at its end is held by those on which it is sunk all over.
const FEWEST: f64 = 3.0;

/// A stretch that hangs over so small a share of the beam is taken for pressed with the one beside it: shears over it are rounding.
const SHORT: f64 = 1e-5;

/// The stretches of a scene in dimensionless numbers, cut where ground or load have a break and into short cells; what hangs is one
/// stretch from support to support or pressed part.
pub(super) fn cut(enclosed: &EnclosedScene<'_>, ground: f64, given: &[Stretch]) -> Vec<Stretch> {
    let mut cut = Vec::new();
    let length = (0.25 * ground / enclosed.stiffness).sqrt().sqrt().recip();
    for stretch in joined(enclosed, length, given) {
        if stretch.sunk.is_empty() {
            cut.push(stretch);
        } else {
            cells(enclosed, length, &stretch, &mut cut);
        }
    }
    // From derivatives to moment and shear.
    for stretch in &mut cut {
        let (presses, at) = (!stretch.sunk.is_empty(), [(stretch.from, false), (stretch.to, true)]);
        for (end, (x, left)) in stretch.ends.iter_mut().zip(at) {
            let gap = enclosed.gap.jet(x, left).map(|g| if presses { g.middle() } else { 0.0 });
            (end[2], end[3]) = (-enclosed.stiffness * (end[2] + gap[2]), -enclosed.stiffness * (end[3] + gap[3]));
        }
    }
    cut
}

/// With what hangs in one, and without what hangs over next to nothing.
fn joined(enclosed: &EnclosedScene<'_>, length: f64, given: &[Stretch]) -> Vec<Stretch> {
    let mut hanging: Vec<Stretch> = Vec::new();
    for stretch in given {
        match hanging.last_mut() {
            Some(last)
                if last.sunk.is_empty() && stretch.sunk.is_empty() && enclosed.support(stretch.from).is_none() =>
            {
                (last.to, last.ends[1]) = (stretch.to, stretch.ends[1]);
            }
            _ => hanging.push(stretch.clone()),
        }
    }
    let mut joined: Vec<Stretch> = Vec::new();
    let mut stretches = hanging.into_iter().peekable();
    while let Some(stretch) = stretches.next() {
        let is_short = stretch.sunk.is_empty() && stretch.to - stretch.from <= SHORT * enclosed.length;
        let end = |side: usize, x: f64| {
            let (v, gap) = (stretch.ends[side], enclosed.gap.jet(x, side == 1));
            [0, 1, 2, 3].map(|j| v[j] - gap[j].middle())
        };
        let smooth = |x: f64| is_smooth(enclosed, x);
        if let Some(last) = joined.last_mut().filter(|last| is_short && !last.sunk.is_empty() && smooth(stretch.from)) {
            (last.to, last.ends[1]) = (stretch.to, end(1, stretch.to));
        } else if let Some(next) =
            stretches.peek_mut().filter(|next| is_short && !next.sunk.is_empty() && smooth(stretch.to))
        {
            next.sunk = shifted(&next.sunk, stretch.from - next.from);
            (next.from, next.ends[0]) = (stretch.from, end(0, stretch.from));
        } else {
            joined.push(stretch);
        }
    }
    without_slivers(enclosed, length, joined)
}

/// True where neither ground nor load nor a support makes a difference between the two sides.
fn is_smooth(enclosed: &EnclosedScene<'_>, x: f64) -> bool {
    let is_loaded_alike = enclosed.load.breaks(x.next_down(), x.next_up()).is_empty();
    enclosed.support(x).is_none() && enclosed.gap.is_smooth_at(x) && is_loaded_alike
}

/// Continues polynomials over what is far shorter beside them: over a short cell curvatures are rounding.
fn without_slivers(enclosed: &EnclosedScene<'_>, length: f64, stretches: Vec<Stretch>) -> Vec<Stretch> {
    /// Of the stretch beside it: so far a polynomial may be continued.
    const SLIVER: f64 = 0.2;
    let mut whole: Vec<Stretch> = Vec::new();
    let mut rest = stretches.into_iter().peekable();
    while let Some(stretch) = rest.next() {
        let far_shorter = |beside: &Stretch, x: f64| {
            let pressed = !stretch.sunk.is_empty() && !beside.sunk.is_empty();
            let decays = beside.to - beside.from <= MOST_LENGTHS * length;
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

/// A pressed stretch by short cells.
fn cells(enclosed: &EnclosedScene<'_>, length: f64, stretch: &Stretch, cut: &mut Vec<Stretch>) {
    let (from, to) = (stretch.from, stretch.to);
    let most = if to - from <= MOST_LENGTHS * length {
        (length / CELLS_IN_A_LENGTH).min((to - from) / FEWEST)
    } else {
        to - from
    };
    let (breaks, loads) = (enclosed.gap.breaks(from, to), enclosed.load.breaks(from, to));
    let (smooth, mut ends): (Vec<f64>, Vec<f64>) = breaks.into_iter().partition(|x| enclosed.gap.is_smooth_at(*x));
    // As many cells as a smooth profile has, and no other ends of its.
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
