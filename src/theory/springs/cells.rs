//! A beam on springs that press on given stretches: a linear problem, by cells on each of which it is one polynomial.
//!
//! Over `EI`, with `w = v − g` and `K = k/EI`, `K = 4λ⁴`:
//!
//! ```text
//! pressed cell       w'''' + K w = q − g''''        a Taylor polynomial, over a length of at most 1/λ
//! deep in a zone     w = Σ (−1)^m F^{(4m)}/K^{m+1},  F = q − g'''': nothing that grows or decays is left 44/λ away from its ends
//! free cell          v'''' = q
//! ```
//!
//! Unknown are `y, y', y'', y'''` at the left end of each cell and at the right end of the beam; `y` is `w` where the ground presses
//! and beside it, `v` elsewhere. Between cells `v, v', v''` are continuous, and `v'''` jumps by the force that acts there.

use super::Part;
use super::band::{self, Row, STATE};
use crate::theory::piece::{Piece, derivatives};
use crate::theory::piecewise::PiecewiseScene;

/// Coefficients of a pressed polynomial: over `1/λ` the next ones are less than `4⁷/28! < 10⁻²⁵` of it.
const PRESSED_TERMS: usize = 28;
/// Decay lengths `1/λ` from an end of a zone to where its effect is below rounding: `e⁻⁴⁴ < 10⁻¹⁹`.
const REACH: f64 = 44.0;

/// What a cell is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Free,
    Pressed,
    /// Pressed, and so far from the ends of its zone that it follows the load.
    Deep,
}

#[derive(Debug, Clone)]
struct Cell {
    lo: f64,
    hi: f64,
    /// In which cell of the scene.
    of: usize,
    kind: Kind,
    /// Whether its unknowns are those of `w` and not of `v`.
    from_ground: bool,
    /// Taylor coefficients about its left end of what drives it besides the load, where the ground presses.
    drive: Vec<f64>,
}

/// The beam on springs that press on stretches, from left to right; [`None`] if nothing holds it there.
pub(super) fn solve(given: &PiecewiseScene, springs: f64, stretches: &[[f64; 2]]) -> Option<Vec<Part>> {
    solve_driven(given, springs, stretches, &Drive::default())
}

/// What else acts on a beam.
#[derive(Debug, Default)]
pub(super) struct Drive<'a> {
    /// A breakpoint at which `v''` jumps, and by how much.
    pub(super) couple: Option<(usize, f64)>,
    /// The penetration of a beam that is pressed on the same stretches, times a factor: a load.
    pub(super) sunk: Option<(&'a [Part], f64)>,
}

/// The same under more than its load.
pub(super) fn solve_driven(
    given: &PiecewiseScene,
    springs: f64,
    stretches: &[[f64; 2]],
    drive: &Drive<'_>,
) -> Option<Vec<Part>> {
    let decay = (0.25 * springs).sqrt().sqrt();
    let problem = Problem { given, springs, decay, couple: drive.couple, cells: Vec::new() };
    let mut problem = Problem { cells: problem.cells(stretches), ..problem };
    if let Some((parts, factor)) = drive.sunk {
        let pressed = problem.cells.iter_mut().filter(|cell| cell.kind != Kind::Free);
        for (cell, part) in pressed.zip(parts.iter().filter(|part| part.pressed)) {
            cell.drive = part.penetration.iter().map(|c| factor * c).collect();
        }
    }
    let states = band::solve(&problem.rows(), &problem.sizes())?;
    Some((0..problem.cells.len()).flat_map(|i| problem.parts(i, &states)).collect())
}

struct Problem<'a> {
    given: &'a PiecewiseScene,
    /// `K`.
    springs: f64,
    /// `λ`.
    decay: f64,
    /// See [`Drive`].
    couple: Option<(usize, f64)>,
    cells: Vec<Cell>,
}

impl Problem<'_> {
    fn cells(&self, stretches: &[[f64; 2]]) -> Vec<Cell> {
        let mut cells = Vec::new();
        for (of, whole) in self.given.cells.iter().enumerate() {
            let mut ends = vec![whole.lo];
            let inside = stretches.iter().flatten().copied().filter(|x| whole.lo < *x && *x < whole.hi);
            ends.extend(inside);
            ends.push(whole.hi);
            for end in ends.windows(2).filter(|w| w[0] < w[1]) {
                let (lo, hi) = (end[0], end[1]);
                let pressed = stretches.iter().any(|[from, to]| *from <= lo && hi <= *to);
                if pressed {
                    self.cut([lo, hi], of, &mut cells);
                } else {
                    cells.push(Cell { lo, hi, of, kind: Kind::Free, from_ground: false, drive: Vec::new() });
                }
            }
        }
        // Beside a zone a clearance is small, and is not the difference of two depths.
        let near =
            |a: &Cell, b: &Cell| a.kind != Kind::Free && self.given.cells[a.of].shape == self.given.cells[b.of].shape;
        let beside: Vec<bool> = (0..cells.len())
            .map(|i| {
                i.checked_sub(1).is_some_and(|left| near(&cells[left], &cells[i]))
                    || cells.get(i + 1).is_some_and(|right| near(right, &cells[i]))
            })
            .collect();
        cells.iter_mut().zip(beside).for_each(|(cell, beside)| cell.from_ground |= beside);
        cells
    }

    /// A pressed stretch of one cell of the scene.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 111 parts")]
    fn cut(&self, [lo, hi]: [f64; 2], of: usize, cells: &mut Vec<Cell>) {
        let mut push = |[lo, hi]: [f64; 2], parts: u32, kind| {
            let end = |k: u32| if k < parts { lo + (hi - lo) * (f64::from(k) / f64::from(parts)) } else { hi };
            let cell = |k| Cell { lo: end(k), hi: end(k + 1), of, kind, from_ground: true, drive: Vec::new() };
            cells.extend((0..parts).map(cell));
        };
        let lengths = (hi - lo) * self.decay;
        if lengths <= 2.5 * REACH {
            return push([lo, hi], lengths.ceil().max(1.0) as u32, Kind::Pressed);
        }
        let (a, b) = (lo + REACH / self.decay, hi - REACH / self.decay);
        push([lo, a], REACH as u32, Kind::Pressed);
        push([a, b], 1, Kind::Deep);
        push([b, hi], REACH as u32, Kind::Pressed);
    }

    /// What a derivative is measured in at each node: the shorter one of the cells beside it, and of `1/λ`.
    fn sizes(&self) -> Vec<f64> {
        let width = |cell: Option<&Cell>| cell.map_or(f64::INFINITY, |cell| cell.hi - cell.lo);
        let left = |i: usize| width(i.checked_sub(1).and_then(|i| self.cells.get(i)));
        (0..=self.cells.len()).map(|i| left(i).min(width(self.cells.get(i))).min(1.0 / self.decay)).collect()
    }

    /// The breakpoint of the scene at node `i`.
    fn breakpoint(&self, i: usize) -> Option<usize> {
        match (i.checked_sub(1).and_then(|left| self.cells.get(left)), self.cells.get(i)) {
            (None, _) => Some(0),
            (Some(_), None) => Some(self.given.cells.len()),
            (Some(left), Some(right)) => (left.of != right.of).then_some(right.of),
        }
    }

    /// The point load at node `i`.
    fn force(&self, i: usize) -> f64 {
        self.breakpoint(i).map_or(0.0, |breakpoint| self.given.breakpoints[breakpoint].force)
    }

    /// By how much `v''` jumps at node `i`.
    fn couple(&self, i: usize) -> f64 {
        self.couple.filter(|(at, _)| self.breakpoint(i) == Some(*at)).map_or(0.0, |(_, couple)| couple)
    }

    /// What a support at node `i` prescribes for `v`, and of `v'` if the beam is built in.
    fn support(&self, i: usize) -> Option<(f64, Option<f64>)> {
        let support = &self.given.supports[self.given.support_at(self.breakpoint(i)?)?];
        Some((support.level, support.slope.filter(|_| support.built_in)))
    }

    /// `v − y` with its derivatives at a place of a cell.
    fn base(&self, cell: &Cell, x: f64) -> [f64; 4] {
        if cell.from_ground { self.given.derivatives(cell.of, x) } else { [0.0; 4] }
    }

    /// By what `y` and its derivatives grow from cell `i − 1` to cell `i` because they are measured in another way.
    fn jump(&self, i: usize) -> [f64; 4] {
        let (left, right) = (&self.cells[i - 1], &self.cells[i]);
        let [a, b] = [left, right].map(|cell| self.base(cell, right.lo));
        let mut jump = [0, 1, 2, 3].map(|j| a[j] - b[j]);
        if left.from_ground && right.from_ground {
            let same = self.given.cells[left.of].shape == self.given.cells[right.of].shape;
            match self.breakpoint(i).filter(|_| !same) {
                None => jump = [0.0; 4],
                Some(at) => {
                    let breakpoint = &self.given.breakpoints[at];
                    (jump[0], jump[1]) = (-breakpoint.step, -breakpoint.kink);
                }
            }
        }
        jump
    }

    /// Taylor coefficients of `y` about a place of a cell, from its value and its first three derivatives there.
    #[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
    fn taylor(&self, cell: &Cell, x: f64, [y, y1, y2, y3]: [f64; 4]) -> Vec<f64> {
        let pressed = cell.kind != Kind::Free;
        let terms = if pressed { PRESSED_TERMS.max(self.given.terms) } else { self.given.terms };
        let mut taylor = vec![0.0; terms];
        if cell.from_ground {
            self.given.profile(cell.of, x, &mut taylor);
            taylor.iter_mut().for_each(|c| *c = -*c);
        }
        taylor[..4].copy_from_slice(&[y, y1, y2 / 2.0, y3 / 6.0]);
        let load = [self.given.load(cell.of, x), self.given.cells[cell.of].load_slope];
        for n in 0..terms - 4 {
            let springs = if pressed { self.springs * taylor[n] } else { 0.0 };
            let drive = load.get(n).unwrap_or(&0.0) + cell.drive.get(n).unwrap_or(&0.0) - springs;
            taylor[n + 4] += drive / ((n + 1) * (n + 2) * (n + 3) * (n + 4)) as f64;
        }
        taylor
    }

    /// The particular polynomial deep in a zone, about a place.
    fn deep(&self, cell: &Cell, x: f64) -> Vec<f64> {
        let mut profile = vec![0.0; self.given.terms];
        self.given.profile(cell.of, x, &mut profile);
        let mut drive: Vec<f64> = fourth(&profile).iter().map(|c| -c).collect();
        drive.resize(drive.len().max(2).max(cell.drive.len()), 0.0);
        drive.iter_mut().zip(&cell.drive).for_each(|(sum, c)| *sum += c);
        drive[0] += self.given.load(cell.of, x);
        drive[1] += self.given.cells[cell.of].load_slope;
        let mut sum = vec![0.0; self.given.terms.max(drive.len())];
        let mut unit = 1.0 / self.springs;
        while !drive.is_empty() {
            sum.iter_mut().zip(&drive).for_each(|(sum, c)| *sum += unit * c);
            drive = fourth(&drive);
            unit /= -self.springs;
        }
        sum
    }

    fn rows(&self) -> Vec<Row> {
        let mut rows = self.end(0, 1.0);
        for (i, cell) in self.cells.iter().enumerate() {
            rows.extend(if cell.kind == Kind::Deep { self.deep_rows(i) } else { self.cell_rows(i) });
        }
        rows.extend(self.end(self.cells.len(), -1.0));
        rows
    }

    /// The two conditions at an end of the beam; a force or a couple on one is on the right of the left end, on the left of the right end.
    fn end(&self, node: usize, side: f64) -> Vec<Row> {
        let cell = &self.cells[node.min(self.cells.len() - 1)];
        let base = self.base(cell, if node == 0 { cell.lo } else { cell.hi });
        let one = |j: usize, value: f64| {
            let mut entries = [0.0; 2 * STATE];
            entries[j] = 1.0;
            Row { node, entries, right: value - base[j] }
        };
        match self.support(node) {
            Some((level, Some(slope))) => vec![one(0, level), one(1, slope)],
            Some((level, None)) => vec![one(0, level), one(2, side * self.couple(node))],
            None => vec![one(2, side * self.couple(node)), one(3, side * self.force(node))],
        }
    }

    /// What the four solutions of a cell without load are at its far end, and what the load makes there.
    fn across(&self, cell: &Cell) -> ([[f64; 4]; 4], [f64; 4]) {
        let (width, springs) = (cell.hi - cell.lo, if cell.kind == Kind::Free { 0.0 } else { self.springs });
        // Σ (−K)^r s^(4r+m)/(4r+m)!, of which each is the derivative of the next one.
        let wave = |m: u32| {
            let (mut term, mut sum) = ((1..=m).fold(1.0, |product, n| product * width / f64::from(n)), 0.0);
            for r in 1..=6 {
                sum += term;
                let factor = (4 * r + m - 3..=4 * r + m).fold(-springs, |product, n| product * width / f64::from(n));
                term *= factor;
            }
            sum + term
        };
        let waves = [0, 1, 2, 3].map(wave);
        let far = |j: usize, m: usize| if j <= m { waves[m - j] } else { -springs * waves[m + 4 - j] };
        let matrix = [0, 1, 2, 3].map(|j| [0, 1, 2, 3].map(|m| far(j, m)));
        (matrix, derivatives(&self.taylor(cell, cell.lo, [0.0; 4]), width))
    }

    /// What joins the states at the two ends of a cell.
    fn cell_rows(&self, i: usize) -> Vec<Row> {
        let (cell, next) = (&self.cells[i], i + 1);
        let (matrix, own) = self.across(cell);
        let inner = self.cells.get(next).map(|right| (self.jump(next), right));
        let jump = inner.as_ref().map_or([0.0; 4], |(jump, _)| *jump);
        let acts = if inner.is_some() { [0.0, 0.0, self.couple(next), self.force(next)] } else { [0.0; 4] };
        let left = |j: usize| {
            let mut entries = [0.0; 2 * STATE];
            entries[..STATE].copy_from_slice(&matrix[j]);
            entries
        };
        let continuous = |j: usize| {
            let mut entries = left(j);
            entries[STATE + j] = -1.0;
            Row { node: i, entries, right: -own[j] - jump[j] - acts[j] }
        };
        let Some(((level, slope), (_, right))) = self.support(next).zip(inner) else {
            return (0..4).map(continuous).collect();
        };
        let [before, behind] = [cell, right].map(|cell| self.base(cell, right.lo));
        let known = |j: usize, value: f64| {
            let mut entries = [0.0; 2 * STATE];
            entries[STATE + j] = 1.0;
            let near = Row { node: i, entries: left(j), right: value - before[j] - own[j] };
            [near, Row { node: i, entries, right: value - behind[j] }]
        };
        match slope {
            None => known(0, level).into_iter().chain([continuous(1), continuous(2)]).collect(),
            Some(slope) => [known(0, level), known(1, slope)].concat(),
        }
    }

    /// Deep in a zone nothing grows into it from either end.
    fn deep_rows(&self, i: usize) -> Vec<Row> {
        let (cell, l) = (&self.cells[i], self.decay);
        let row = |at: usize, own: [f64; 4], [a, b, c, d]: [f64; 4]| {
            let mut entries = [0.0; 2 * STATE];
            entries[at..at + STATE].copy_from_slice(&[a, b, c, d]);
            Row { node: i, entries, right: a * own[0] + b * own[1] + c * own[2] + d * own[3] }
        };
        let particular = self.deep(cell, cell.lo);
        let [near, far] = [0.0, cell.hi - cell.lo].map(|s| derivatives(&particular, s));
        vec![
            row(0, near, [2.0 * l * l, 2.0 * l, 1.0, 0.0]),
            row(0, near, [-4.0 * l * l * l, -2.0 * l * l, 0.0, 1.0]),
            row(STATE, far, [2.0 * l * l, -2.0 * l, 1.0, 0.0]),
            row(STATE, far, [4.0 * l * l * l, -2.0 * l * l, 0.0, 1.0]),
        ]
    }

    /// The polynomials of a cell: of a free one from both of its ends to its middle.
    fn parts(&self, i: usize, states: &[[f64; STATE]]) -> Vec<Part> {
        let cell = &self.cells[i];
        let part = |[lo, hi]: [f64; 2], anchor: f64, y: Vec<f64>| {
            let mut profile = vec![0.0; y.len()];
            self.given.profile(cell.of, anchor, &mut profile);
            let sign = if cell.from_ground { 1.0 } else { -1.0 };
            let other = y.iter().zip(&profile).map(|(y, g)| y + sign * g).collect();
            let (deflection, penetration) = if cell.from_ground { (other, y) } else { (y, other) };
            let pressed = cell.kind != Kind::Free;
            Part { piece: Piece::of_part([lo, hi], anchor, cell.of), pressed, deflection, penetration }
        };
        let (ends, middle) = ([cell.lo, cell.hi], 0.5 * (cell.lo + cell.hi));
        match cell.kind {
            Kind::Deep => vec![part(ends, cell.lo, self.deep(cell, cell.lo))],
            Kind::Pressed => vec![part(ends, cell.lo, self.taylor(cell, cell.lo, states[i]))],
            // Too short to have a middle.
            Kind::Free if middle <= cell.lo || cell.hi <= middle => {
                vec![part(ends, cell.lo, self.taylor(cell, cell.lo, states[i]))]
            }
            Kind::Free => vec![
                part([cell.lo, middle], cell.lo, self.taylor(cell, cell.lo, states[i])),
                part([middle, cell.hi], cell.hi, self.taylor(cell, cell.hi, self.far_end(i, states))),
            ],
        }
    }

    /// `y` with its derivatives at the right end of a cell, from the state behind it as far as that is the same.
    fn far_end(&self, i: usize, states: &[[f64; STATE]]) -> [f64; 4] {
        let (cell, next) = (&self.cells[i], i + 1);
        if next == self.cells.len() {
            return states[next];
        }
        let (jump, force) = (self.jump(next), self.force(next));
        let mut end = [0, 1, 2, 3].map(|j| states[next][j] - jump[j]);
        end[2] -= self.couple(next);
        match self.support(next) {
            None => end[3] -= force,
            Some((level, slope)) => {
                let walked = derivatives(&self.taylor(cell, cell.lo, states[i]), cell.hi - cell.lo);
                let base = self.base(cell, cell.hi);
                end[0] = level - base[0];
                end[3] = walked[3];
                if let Some(slope) = slope {
                    (end[1], end[2]) = (slope - base[1], walked[2]);
                }
            }
        }
        end
    }
}

/// The fourth derivative.
#[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
fn fourth(taylor: &[f64]) -> Vec<f64> {
    let factor = |n: usize| ((n + 1) * (n + 2) * (n + 3) * (n + 4)) as f64;
    taylor.iter().skip(4).enumerate().map(|(n, c)| c * factor(n)).collect()
}
