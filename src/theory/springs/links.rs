//! A beam on springs that press on given stretches: a linear problem, by links that are joined by two numbers at each node.
//!
//! Over `EI`, with the clearance `h = g − v`, the moment `M = −v''`, the shear force `V = M'` and `K = k/EI = 4λ⁴`:
//!
//! ```text
//! span              v'''' = q                 between supports and zones, in closed form as on rigid ground
//! pressed link      h'''' + K h = g'''' − q   a Taylor polynomial, over a length of at most 1/λ
//! deep in a zone    h = −Σ (−1)^m F^{(4m)}/K^{m+1},  F = q − g'''': nothing that grows or decays is left 44/λ away from its ends
//! ```
//!
//! What `h` and `M` are at both ends of a link says what `h'` and `V` are there:
//!
//! ```text
//! h'_a = −(c + η) h_a + c h_b − w M_a − ω M_b + …      V_a = a h_a + σ h_b − (c + η) M_a + c M_b + …      mirrored at b
//!                   c      η    w      ω      a    σ
//! span              1/ℓ    0    ℓ/3    ℓ/6    0    0
//! pressed link      from its solutions without load, of which no two are subtracted from each other
//! deep in a zone    0      λ    1/2λ   0      2λ³  0
//! ```

use crate::theory::piece::derivatives;
use crate::theory::piecewise::{AtSupport, PiecewiseScene};
use crate::theory::span::{End, EndCondition, fixed_end_of_load};

/// Coefficients of a pressed polynomial over so many decay lengths `1/λ` at most: the next ones are less than `4ʳ ℓ⁴ʳ/(4r)! < 10⁻²⁰` of it.
const PRESSED_TERMS: [(f64, usize); 3] = [(1.0 / 64.0, 12), (0.25, 16), (f64::INFINITY, 28)];
/// Decay lengths `1/λ` from an end of a zone to where its effect is below rounding: `e⁻⁴⁴ < 10⁻¹⁹`.
const REACH: f64 = 44.0;

/// What a link is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Span,
    Pressed,
    /// Pressed, and so far from the ends of its zone that it follows the load.
    Deep,
}

/// A part of the beam between two nodes.
#[derive(Debug, Clone)]
pub(super) struct Link {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// The first and the last cell of the scene in it: of a pressed link the same.
    pub(super) cells: [usize; 2],
    pub(super) kind: Kind,
    /// Taylor coefficients about its left end of what drives it besides the load, where the ground presses.
    pub(super) drive: Vec<f64>,
    /// From which depth and which slope `h` and `h'` count at its two ends: those of the ground where it presses and beside it, at a
    /// support that a span ends at its level.
    pub(super) base: [[f64; 2]; 2],
    /// See the module.
    pub(super) c: f64,
    pub(super) eta: f64,
    pub(super) w: f64,
    pub(super) off: f64,
    pub(super) a: f64,
    pub(super) sigma: f64,
    /// `h'` and `V` at its two ends where `h` and `M` are zero.
    pub(super) own: [[f64; 2]; 2],
}

impl Link {
    fn new([lo, hi]: [f64; 2], cell: usize, kind: Kind) -> Self {
        let (base, own) = ([[0.0; 2]; 2], [[0.0; 2]; 2]);
        let [c, eta, w, off, a, sigma] = [0.0; 6];
        Self { lo, hi, cells: [cell; 2], kind, drive: Vec::new(), base, c, eta, w, off, a, sigma, own }
    }

    /// An end of one that hangs, with `h` there and `v`.
    pub(super) fn end(&self, side: usize, height: f64, level: f64) -> End {
        let hold = EndCondition::Hinge { height, level, curvature: 0.0 };
        End { x: [self.lo, self.hi][side], low: 0.0, cell: self.cells[side], hold }
    }

    /// `h'` and `V` at its two ends from `h` and `M` there, with this `c`.
    pub(super) fn ends(&self, c: f64, h: [f64; 2], m: [f64; 2]) -> [[f64; 2]; 2] {
        let bent = self.bent(c, h, m);
        [0, 1].map(|side| [0, 1].map(|j| bent[side][j] + self.own[side][j]))
    }

    /// The same without its loads.
    pub(super) fn bent(&self, c: f64, [h, k]: [f64; 2], [m, n]: [f64; 2]) -> [[f64; 2]; 2] {
        let Self { eta, w, off, a, sigma, .. } = *self;
        let (chord, rise) = (c * (k - h), c * (n - m));
        [
            [chord - eta * h - w * m - off * n, rise + a * h + sigma * k - eta * m],
            [chord + eta * k + off * m + w * n, rise - sigma * h - a * k + eta * n],
        ]
    }
}

pub(super) struct Beam<'a> {
    pub(super) given: &'a PiecewiseScene,
    /// `K`.
    pub(super) springs: f64,
    /// `λ`.
    pub(super) decay: f64,
    pub(super) links: Vec<Link>,
}

impl Beam<'_> {
    /// Its links, from left to right.
    pub(super) fn join(&mut self, stretches: &[[f64; 2]]) {
        let mut at = 0.0;
        for &[from, to] in stretches {
            self.hang([at, from]);
            for i in self.given.cell_from(from)..=self.given.cell_to(to) {
                let cell = &self.given.cells[i];
                self.press([cell.lo.max(from), cell.hi.min(to)], i);
            }
            at = to;
        }
        self.hang([at, self.given.length]);
    }

    /// A part of the beam where nothing presses: a span between two supports each.
    fn hang(&mut self, [from, to]: [f64; 2]) {
        let (given, mut at) = (self.given, from);
        let first = given.supports.partition_point(|support| given.breakpoints[support.breakpoint].x <= from);
        let inside = given.supports[first..].iter().map(|support| given.breakpoints[support.breakpoint].x);
        for end in inside.take_while(|x| *x < to).chain([to]) {
            if at < end {
                let cells = [given.cell_from(at), given.cell_to(end)];
                self.links.push(Link { cells, ..Link::new([at, end], cells[0], Kind::Span) });
            }
            at = end;
        }
    }

    /// A part of a cell where the ground presses.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 111 parts")]
    fn press(&mut self, [lo, hi]: [f64; 2], cell: usize) {
        let mut push = |[lo, hi]: [f64; 2], parts: u32, kind| {
            let end = |k: u32| if k < parts { lo + (hi - lo) * (f64::from(k) / f64::from(parts)) } else { hi };
            self.links.extend((0..parts).map(|k| Link::new([end(k), end(k + 1)], cell, kind)));
        };
        if hi <= lo {
            return;
        }
        let lengths = (hi - lo) * self.decay;
        if lengths <= 2.5 * REACH {
            return push([lo, hi], lengths.ceil().max(1.0) as u32, Kind::Pressed);
        }
        let (a, b) = (lo + REACH / self.decay, hi - REACH / self.decay);
        push([lo, a], REACH as u32, Kind::Pressed);
        push([a, b], 1, Kind::Deep);
        push([b, hi], REACH as u32, Kind::Pressed);
    }

    /// The breakpoint of the scene at node `i`, the left end of link `i`.
    fn breakpoint(&self, i: usize) -> Option<usize> {
        match (i.checked_sub(1).and_then(|left| self.links.get(left)), self.links.get(i)) {
            (None, _) => Some(0),
            (Some(_), None) => Some(self.given.cells.len()),
            (Some(left), Some(right)) => (left.cells[1] != right.cells[0]).then_some(right.cells[0]),
        }
    }

    /// By what `V` and `M` jump at node `i`, but for what a support does.
    pub(super) fn acts(&self, i: usize) -> [f64; 2] {
        let at = self.breakpoint(i).map(|breakpoint| self.given.breakpoints[breakpoint]);
        at.map_or([0.0; 2], |at| [-at.force, -at.couple])
    }

    pub(super) fn support(&self, i: usize) -> Option<&AtSupport> {
        Some(&self.given.supports[self.given.support_at(self.breakpoint(i)?)?])
    }

    /// The slope in which the beam is built in at node `i`.
    pub(super) fn built_in(&self, i: usize) -> Option<f64> {
        self.support(i).filter(|support| support.built_in)?.slope
    }

    /// Depth and slope of the ground at an end of a link, and two more derivatives.
    pub(super) fn profile(&self, link: &Link, side: usize) -> [f64; 4] {
        self.given.derivatives(link.cells[side], [link.lo, link.hi][side])
    }

    fn ground(&self, link: &Link, side: usize) -> [f64; 2] {
        let [depth, slope, ..] = self.profile(link, side);
        [depth, slope]
    }

    /// By what depth and slope of the ground grow at node `i` from one link to the next: nothing on a smooth piece of it.
    fn broken(&self, i: usize) -> [f64; 2] {
        let shape = |cell: usize| self.given.cells[cell].shape;
        match self.breakpoint(i) {
            Some(at) if 0 < i && i < self.links.len() && shape(at - 1) != shape(at) => {
                [self.given.breakpoints[at].step, self.given.breakpoints[at].kink]
            }
            _ => [0.0; 2],
        }
    }

    /// From what `h` and `h'` count at an end of link `i`.
    fn base(&self, i: usize, side: usize) -> [f64; 2] {
        let link = &self.links[i];
        let beside = if side == 0 { i.checked_sub(1) } else { Some(i + 1) };
        match (self.support(i + side), beside.and_then(|beside| self.links.get(beside))) {
            _ if link.kind != Kind::Span => self.ground(link, side),
            (Some(support), _) => [support.level, 0.0],
            (None, Some(beside)) => self.ground(beside, 1 - side),
            (None, None) => [0.0; 2],
        }
    }

    /// By what `h` and `h'` of the ground below an end of link `i` are more than those that count from its base.
    pub(super) fn below(&self, i: usize, side: usize) -> [f64; 2] {
        let link = &self.links[i];
        if link.kind != Kind::Span {
            return [0.0; 2];
        }
        if self.support(i + side).is_some() {
            let ([depth, slope], [base, incline]) = (self.ground(link, side), link.base[side]);
            return [depth - base, slope - incline];
        }
        let sign = if side == 0 { 1.0 } else { -1.0 };
        self.broken(i + side).map(|jump| sign * jump)
    }

    /// By what `h` and `h'` grow at node `i` from one link to the next.
    pub(super) fn jump(&self, i: usize) -> [f64; 2] {
        let (left, right) = (&self.links[i - 1], &self.links[i]);
        match [left, right].map(|link| link.kind == Kind::Span) {
            [false, false] => self.broken(i),
            _ if self.support(i).is_none() => [0.0; 2],
            _ => [0, 1].map(|j| right.base[0][j] - left.base[1][j]),
        }
    }

    /// The six numbers of a link, and what its loads do.
    pub(super) fn measure(&mut self, i: usize) {
        self.links[i].base = [self.base(i, 0), self.base(i, 1)];
        let link = &self.links[i];
        let measured = match link.kind {
            Kind::Span => self.span(i),
            Kind::Pressed => self.pressed(link),
            Kind::Deep => self.deep(link),
        };
        self.links[i] = measured;
    }

    fn span(&self, i: usize) -> Link {
        let link = &self.links[i];
        let ([from, to], l) = ([0, 1].map(|side| link.end(side, 0.0, 0.0)), link.hi - link.lo);
        let ([g, k], [r, s]) = fixed_end_of_load(self.given, &from, &to);
        let shape = |i: Option<usize>| Some(&self.given.shapes[self.given.cells[self.links.get(i?)?.cells[0]].shape]);
        let (left, right) = (shape(i.checked_sub(1)), shape(Some(i + 1)));
        let on_ground = self.support(i).is_none() && self.support(i + 1).is_none();
        let [[depth, slope], [next, last]] = link.base;
        let [turn_a, turn_b] = match left.zip(right).filter(|(left, right)| on_ground && std::ptr::eq(*left, *right)) {
            Some((shape, _)) if shape.is_one_series_over(l) => {
                [shape.bow(link.lo, l, false), shape.bow(link.hi, -l, false)]
            }
            _ => [(next - depth) / l - slope, last - (next - depth) / l],
        };
        let own = [[-turn_a - l * (g / 3.0 + k / 6.0), r], [turn_b + l * (g / 6.0 + k / 3.0), -s]];
        Link { c: 1.0 / l, w: l / 3.0, off: l / 6.0, own, ..link.clone() }
    }

    /// With `W_m = Σ (−K)^r ℓ^(4r+m)/(4r+m)!`, of which each is the derivative of the next one, a link without load has
    ///
    /// ```text
    /// h_b = W₀ h_a + W₁ h'_a + W₂ M_a + W₃ V_a          M_b = −K (W₂ h_a + W₃ h'_a) + W₀ M_a + W₁ V_a
    /// ```
    fn pressed(&self, link: &Link) -> Link {
        let (l, k) = (link.hi - link.lo, self.springs);
        // W_m without its first term, and that.
        let wave = |m: u32| {
            let first = (1..=m).fold(1.0, |product, n| product * l / f64::from(n));
            let (mut term, mut sum) = (first, 0.0);
            for r in 1..=6 {
                term *= (4 * r + m - 3..=4 * r + m).fold(-k, |product, n| product * l / f64::from(n));
                sum += term;
            }
            [sum, first]
        };
        let [[less, _], one, two, three] = [0, 1, 2, 3].map(wave);
        let [w0, w1, w2, w3] = [1.0 + less, one[0] + one[1], two[0] + two[1], three[0] + three[1]];
        let inverse = 1.0 / (w1 * w1 + k * w3 * w3);
        let (w, off) = ((w1 * w2 - w0 * w3) * inverse, w3 * inverse);
        // The beam that begins with the ground, without moment and shear.
        let [h, v] = self.taylor(link, [0.0; 4]);
        let ([h, h1, ..], [_, _, m, n]) = (derivatives(&h, l), derivatives(&v, l));
        let (turn, shear) = ((w3 * -m - w1 * h) * inverse, -(k * w3 * h + w1 * -m) * inverse);
        let far = [w0 * turn + w2 * shear + h1, w0 * shear - k * w2 * turn - n];
        let eta = (w1 * less + k * w2 * w3) * inverse;
        Link { c: w1 * inverse, eta, w, off, a: k * w, sigma: k * off, own: [[turn, shear], far], ..link.clone() }
    }

    /// Nothing grows into it from either end.
    fn deep(&self, link: &Link) -> Link {
        let l = self.decay;
        let (eta, w, a) = (l, 0.5 / l, 2.0 * l * l * l);
        let [h, v] = self.following(link).map(|taylor| [0.0, link.hi - link.lo].map(|s| derivatives(&taylor, s)));
        let own = |i: usize, sign: f64| {
            let ([h, h1, ..], [_, _, m, n]) = (h[i], v[i].map(|c| -c));
            [h1 + sign * (eta * h + w * m), n - sign * (a * h - eta * m)]
        };
        Link { eta, w, a, own: [own(0, 1.0), own(1, -1.0)], ..link.clone() }
    }

    /// Taylor coefficients of `h` and `v` of a pressed link about its left end, from `h, h', M, V` there.
    #[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
    pub(super) fn taylor(&self, link: &Link, [h, h1, moment, shear]: [f64; 4]) -> [Vec<f64>; 2] {
        let lengths = (link.hi - link.lo) * self.decay;
        let terms = PRESSED_TERMS.iter().find(|(most, _)| lengths <= *most).map_or(0, |(_, terms)| *terms);
        let terms = terms.max(self.given.terms);
        let (mut clear, mut deflection) = (vec![0.0; terms], vec![0.0; terms]);
        let cell = link.cells[0];
        self.given.profile(cell, link.lo, &mut clear);
        deflection[..4].copy_from_slice(&[clear[0] - h, clear[1] - h1, -moment / 2.0, -shear / 6.0]);
        (clear[0], clear[1]) = (h, h1);
        (clear[2], clear[3]) = (clear[2] + moment / 2.0, clear[3] + shear / 6.0);
        let load = [self.given.load(cell, link.lo), self.given.cells[cell].load_slope];
        for n in 0..terms - 4 {
            let drive = load.get(n).unwrap_or(&0.0) + link.drive.get(n).unwrap_or(&0.0) + self.springs * clear[n];
            deflection[n + 4] = drive / ((n + 1) * (n + 2) * (n + 3) * (n + 4)) as f64;
            clear[n + 4] -= deflection[n + 4];
        }
        [clear, deflection]
    }

    /// The particular polynomials deep in a zone, `h` and `v` about its left end.
    pub(super) fn following(&self, link: &Link) -> [Vec<f64>; 2] {
        let (cell, size) = (link.cells[0], self.given.terms.max(link.drive.len()));
        let mut profile = vec![0.0; size];
        self.given.profile(cell, link.lo, &mut profile);
        let mut drive = fourth(&profile);
        drive.resize(size, 0.0);
        drive.iter_mut().zip(&link.drive).for_each(|(sum, c)| *sum -= c);
        drive[0] -= self.given.load(cell, link.lo);
        drive[1] -= self.given.cells[cell].load_slope;
        let (mut clear, mut unit) = (vec![0.0; size], 1.0 / self.springs);
        while !drive.is_empty() {
            clear.iter_mut().zip(&drive).for_each(|(sum, c)| *sum += unit * c);
            drive = fourth(&drive);
            unit /= -self.springs;
        }
        let deflection = profile.iter().zip(&clear).map(|(g, h)| g - h).collect();
        [clear, deflection]
    }
}

/// The fourth derivative.
#[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
fn fourth(taylor: &[f64]) -> Vec<f64> {
    let factor = |n: usize| ((n + 1) * (n + 2) * (n + 3) * (n + 4)) as f64;
    taylor.iter().skip(4).enumerate().map(|(n, c)| c * factor(n)).collect()
}
