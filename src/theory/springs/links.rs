//! A beam on springs that press on given stretches: a linear problem, divided into links that are joined by two numbers at each node.
//!
//! Over `EI₀`, with `e = EI/EI₀`, the clearance `h = g − v`, the moment `M = −e v''`, the shear force `V = M'` and `K = k/EI = 4λ⁴`;
//! `e` and `K` are constant on a link:
//!
//! ```text
//! span              e v'''' = q                 between supports, zones and changes of the beam, in closed form as on a rigid foundation
//! pressed link      h'''' + K h = g'''' − q/e   a Taylor polynomial, over a length of at most 1/λ
//! deep in a zone    h = −Σ (−1)^m F^{(4m)}/K^{m+1},  F = q/e − g'''': nothing that grows or decays is left 44/λ away from its ends
//! ```
//!
//! `h` and `M` at both ends of a link determine `h'` and `V` there:
//!
//! ```text
//! h'_a = −(c + η) h_a + c h_b − w M_a − ω M_b + …      V_a = a h_a + σ h_b − (c + η) M_a + c M_b + …      mirrored at b
//!                   c      η    w       ω       a      σ
//! span              1/ℓ    0    ℓ/3e    ℓ/6e    0      0
//! pressed link      from its solutions without load, of which no two are subtracted from each other
//! deep in a zone    0      λ    1/2λe   0       2λ³e   0
//! ```
//!
//! In a joint of the flexibility `w_j` the slope `h'` grows by `w_j M`; in a hinge `M = 0`. For an axial force see `pulled`.

use super::pulled::following_under_tension;
use crate::theory::piece::derivatives;
use crate::theory::piecewise::{AtSpring, AtSupport, Cell, PiecewiseScene};
use crate::theory::span::{End, EndCondition, fixed_end_of_load};

/// Numbers of coefficients of a pressed polynomial, with the largest length in `1/λ` for each: the next coefficients are less than
/// `4ʳ ℓ⁴ʳ/(4r)! < 10⁻²⁰` of it.
const PRESSED_TERMS: [(f64, usize); 3] = [(1.0 / 64.0, 12), (0.25, 16), (f64::INFINITY, 28)];

/// The kind of a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Span,
    Pressed,
    /// Pressed, and so far from the ends of its zone that the penetration follows the load.
    Deep,
}

/// A part of the beam between two nodes.
#[derive(Debug, Clone)]
pub(super) struct Link {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// The first and the last cell of the scene in it; equal for a pressed link.
    pub(super) cells: [usize; 2],
    pub(super) kind: Kind,
    /// Taylor coefficients about its left end of a drive in addition to the load, where the foundation presses.
    pub(super) drive: Vec<f64>,
    /// Depth and slope from which `h` and `h'` are measured at its two ends: of the foundation where it presses and next to it; at a
    /// support at the end of a span the level of the support.
    pub(super) base: [[f64; 2]; 2],
    /// The coefficients `c, η, w, ω, a, σ` of the module documentation.
    pub(super) c: f64,
    pub(super) eta: f64,
    pub(super) w: f64,
    pub(super) off: f64,
    pub(super) a: f64,
    pub(super) sigma: f64,
    /// `n`, the stiffness as a string.
    pub(super) pull: f64,
    /// `h'` and `V` at its two ends for `h = M = 0` there.
    pub(super) own: [[f64; 2]; 2],
}

impl Link {
    pub(super) fn new([lo, hi]: [f64; 2], cell: usize, kind: Kind) -> Self {
        let (base, own) = ([[0.0; 2]; 2], [[0.0; 2]; 2]);
        let [c, eta, w, off, a, sigma, pull] = [0.0; 7];
        Self { lo, hi, cells: [cell; 2], kind, drive: Vec::new(), base, c, eta, w, off, a, sigma, pull, own }
    }

    /// An end of a link without pressure, with `h` and `v` there.
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
        let Self { eta, w, off, a, sigma, pull, .. } = *self;
        let (chord, rise) = (c * (k - h), c * (n - m));
        let rise = if pull == 0.0 { rise } else { rise + pull * (h - k) };
        [
            [chord - eta * h - w * m - off * n, rise + a * h + sigma * k - eta * m],
            [chord + eta * k + off * m + w * n, rise - sigma * h - a * k + eta * n],
        ]
    }
}

pub(super) struct Beam<'a> {
    pub(super) given: &'a PiecewiseScene,
    /// `k/EI₀` where the foundation is stiffest.
    pub(super) springs: f64,
    pub(super) links: Vec<Link>,
}

impl Beam<'_> {
    /// `K` and `λ` in a cell.
    pub(super) fn rates(&self, cell: usize) -> (f64, f64) {
        let Cell { ground, stiffness, .. } = self.given.cells[cell];
        let springs = self.springs * ground / stiffness;
        (springs, (0.25 * springs).sqrt().sqrt())
    }

    /// The breakpoint of the scene at node `i`, the left end of link `i`.
    fn breakpoint(&self, i: usize) -> Option<usize> {
        match (i.checked_sub(1).and_then(|left| self.links.get(left)), self.links.get(i)) {
            (None, _) => Some(0),
            (Some(_), None) => Some(self.given.cells.len()),
            (Some(left), Some(right)) => (left.cells[1] != right.cells[0]).then_some(right.cells[0]),
        }
    }

    /// The jumps of `V` and `M` at node `i`, without support forces. With an axial force it is the jump of `T`, including the slope
    /// from which `h'` is measured.
    pub(super) fn acts(&self, i: usize) -> [f64; 2] {
        let at = self.breakpoint(i).map(|breakpoint| self.given.breakpoints[breakpoint]);
        let [force, couple] = at.map_or([0.0; 2], |at| [-at.acts.force(), -at.acts.couple()]);
        if self.given.tension == 0.0 {
            return [force, couple];
        }
        let slope =
            |i: Option<usize>, side: usize| i.and_then(|i| self.links.get(i)).map_or(0.0, |of| of.base[side][1]);
        [force - self.given.tension * (slope(Some(i), 0) - slope(i.checked_sub(1), 1)), couple]
    }

    /// `e` on a link.
    pub(super) fn stiffness(&self, link: &Link) -> f64 {
        self.given.cells[link.cells[0]].stiffness
    }

    /// The flexibility of a joint at node `i`, zero if there is none.
    pub(super) fn joint(&self, i: usize) -> f64 {
        self.breakpoint(i).map_or(0.0, |breakpoint| self.given.breakpoints[breakpoint].joint)
    }

    pub(super) fn support(&self, i: usize) -> Option<&AtSupport> {
        Some(&self.given.supports[self.given.support_at(self.breakpoint(i)?)?])
    }

    /// The active elastic support at node `i`.
    pub(super) fn spring(&self, i: usize) -> Option<&AtSpring> {
        self.given.spring_at(self.breakpoint(i)?)
    }

    /// Whether a support at node `i` exerts a force.
    pub(super) fn is_supported(&self, i: usize) -> bool {
        self.support(i).is_some() || self.spring(i).is_some()
    }

    /// The stiffness of a rotational spring at node `i`, and the slope at which its moment is zero.
    pub(super) fn turning(&self, i: usize) -> Option<[f64; 2]> {
        self.given.turning_at(self.breakpoint(i)?)
    }

    /// The prescribed slope of a built-in support at node `i`.
    pub(super) fn built_in(&self, i: usize) -> Option<f64> {
        self.support(i).filter(|support| support.built_in)?.slope
    }

    /// Depth and slope of the foundation at an end of a link, and two more derivatives.
    pub(super) fn profile(&self, link: &Link, side: usize) -> [f64; 4] {
        self.given.derivatives(link.cells[side], [link.lo, link.hi][side])
    }

    /// The jumps of depth and slope of the foundation at node `i`: zero on a smooth piece.
    fn broken(&self, i: usize) -> [f64; 2] {
        let shape = |cell: usize| self.given.cells[cell].shape;
        match self.breakpoint(i) {
            Some(at) if 0 < i && i < self.links.len() && shape(at - 1) != shape(at) => {
                [self.given.breakpoints[at].step, self.given.breakpoints[at].kink]
            }
            _ => [0.0; 2],
        }
    }

    /// The cell whose foundation is the base of `h` and `h'` at an end of link `i`; none at a support at the end of a span. Between two
    /// spans it is the cell of the left one.
    fn base_cell(&self, i: usize, side: usize) -> Option<usize> {
        let link = &self.links[i];
        let beside = if side == 0 { i.checked_sub(1) } else { Some(i + 1) };
        match beside.and_then(|beside| self.links.get(beside)) {
            _ if link.kind != Kind::Span => Some(link.cells[side]),
            Some(beside) if self.support(i + side).is_none() => {
                Some(if side == 1 && beside.kind == Kind::Span { link.cells[1] } else { beside.cells[1 - side] })
            }
            None if self.support(i + side).is_none() => Some(link.cells[side]),
            _ => None,
        }
    }

    /// The base of `h` and `h'` at an end of link `i`.
    fn base(&self, i: usize, side: usize) -> [f64; 2] {
        let x = [self.links[i].lo, self.links[i].hi][side];
        match (self.base_cell(i, side), self.support(i + side)) {
            (Some(cell), _) => self.ground(cell, x),
            (None, Some(support)) => [support.level, 0.0],
            (None, None) => [0.0; 2],
        }
    }

    fn ground(&self, cell: usize, x: f64) -> [f64; 2] {
        let [depth, slope, ..] = self.given.derivatives(cell, x);
        [depth, slope]
    }

    /// The difference of `h` and `h'` measured from the foundation below an end of link `i` and measured from its base.
    pub(super) fn below(&self, i: usize, side: usize) -> [f64; 2] {
        let link = &self.links[i];
        if link.kind != Kind::Span {
            return [0.0; 2];
        }
        if self.support(i + side).is_some() {
            let ([depth, slope, ..], [base, incline]) = (self.profile(link, side), link.base[side]);
            return [depth - base, slope - incline];
        }
        if self.base_cell(i, side) == Some(link.cells[side]) {
            return [0.0; 2];
        }
        let sign = if side == 0 { 1.0 } else { -1.0 };
        self.broken(i + side).map(|jump| sign * jump)
    }

    /// The jumps of `h` and `h'` at node `i` from one link to the next.
    pub(super) fn jump(&self, i: usize) -> [f64; 2] {
        let (left, right) = (&self.links[i - 1], &self.links[i]);
        match [left, right].map(|link| link.kind == Kind::Span) {
            [false, false] => self.broken(i),
            _ if self.support(i).is_none() => [0.0; 2],
            _ => [0, 1].map(|j| right.base[0][j] - left.base[1][j]),
        }
    }

    /// Computes the coefficients of a link and the effect of its loads.
    pub(super) fn measure(&mut self, i: usize) {
        self.links[i].base = [self.base(i, 0), self.base(i, 1)];
        let link = &self.links[i];
        let measured = match link.kind {
            Kind::Span if self.given.tension != 0.0 => self.span_under_tension(i),
            Kind::Span => self.span(i),
            Kind::Pressed if self.given.tension != 0.0 => self.pressed_under_tension(link),
            Kind::Pressed => self.pressed(link),
            Kind::Deep => self.deep(link),
        };
        self.links[i] = measured;
    }

    /// The rotation of the base profile from its slope at the left end of a link to its chord, and from the chord to its slope at the
    /// right end.
    pub(super) fn base_rotations(&self, i: usize) -> [f64; 2] {
        let (link, l) = (&self.links[i], self.links[i].hi - self.links[i].lo);
        let [left, right] =
            [0, 1].map(|side| Some(&self.given.shapes[self.given.cells[self.base_cell(i, side)?].shape]));
        let [[depth, slope], [next, last]] = link.base;
        match left.zip(right).filter(|(left, right)| left == right) {
            Some((shape, _)) if shape.is_one_series_over(l) => {
                [shape.bow(link.lo, l, false), shape.bow(link.hi, -l, false)]
            }
            _ => [(next - depth) / l - slope, last - (next - depth) / l],
        }
    }

    fn span(&self, i: usize) -> Link {
        let link = &self.links[i];
        let ([from, to], l) = ([0, 1].map(|side| link.end(side, 0.0, 0.0)), link.hi - link.lo);
        let ([g, k], [r, s]) = fixed_end_of_load(self.given, &from, &to);
        let flex = l / self.stiffness(link);
        let [turn_a, turn_b] = self.base_rotations(i);
        let own = [[-turn_a - flex * (g / 3.0 + k / 6.0), r], [turn_b + flex * (g / 6.0 + k / 3.0), -s]];
        Link { c: 1.0 / l, w: flex / 3.0, off: flex / 6.0, own, ..link.clone() }
    }

    /// With `W_m = Σ (−K)^r ℓ^(4r+m)/(4r+m)!`, where each is the derivative of the next, a link without load satisfies, with `M` and
    /// `V` over `e`,
    ///
    /// ```text
    /// h_b = W₀ h_a + W₁ h'_a + W₂ M_a + W₃ V_a          M_b = −K (W₂ h_a + W₃ h'_a) + W₀ M_a + W₁ V_a
    /// ```
    fn pressed(&self, link: &Link) -> Link {
        let (l, (k, _)) = (link.hi - link.lo, self.rates(link.cells[0]));
        let e = self.stiffness(link);
        // W_m without its first term, and the first term.
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
        // The beam that begins with depth and slope of the foundation, without moment and shear force.
        let [h, v] = self.taylor(link, [0.0; 4]);
        let ([h, h1, ..], [_, _, m, n]) = (derivatives(&h, l), derivatives(&v, l));
        let (turn, shear) = ((w3 * -m - w1 * h) * inverse, -(k * w3 * h + w1 * -m) * inverse);
        let far = [w0 * turn + w2 * shear + h1, w0 * shear - k * w2 * turn - n];
        let eta = (w1 * less + k * w2 * w3) * inverse;
        let own = [[turn, e * shear], [far[0], e * far[1]]];
        let (a, sigma) = (e * (k * w), e * (k * off));
        Link { c: w1 * inverse, eta, w: w / e, off: off / e, a, sigma, own, ..link.clone() }
    }

    /// Effects of its ends do not reach the other end.
    fn deep(&self, link: &Link) -> Link {
        let (_, l) = self.rates(link.cells[0]);
        let e = self.stiffness(link);
        let (eta, w, a) = match self.given.tension / e {
            0.0 => (l, 0.5 / l / e, e * (2.0 * l * l * l)),
            pull => Self::deep_under_tension(pull, l, e),
        };
        let [h, v] = self.following(link).map(|taylor| [0.0, link.hi - link.lo].map(|s| derivatives(&taylor, s)));
        let own = |i: usize, sign: f64| {
            let ([h, h1, ..], [_, _, m, n]) = (h[i], v[i].map(|c| -c * e));
            let n = self.vertical([h, h1, m, n])[3];
            [h1 + sign * (eta * h + w * m), n - sign * (a * h - eta * m)]
        };
        Link { eta, w, a, own: [own(0, 1.0), own(1, -1.0)], ..link.clone() }
    }

    /// Taylor coefficients of `h` and `v` of a pressed link about its left end, from `h, h', M, V` there.
    #[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
    pub(super) fn taylor(&self, link: &Link, [h, h1, moment, shear]: [f64; 4]) -> [Vec<f64>; 2] {
        let (springs, decay) = self.rates(link.cells[0]);
        let lengths = (link.hi - link.lo) * decay;
        let terms = PRESSED_TERMS.iter().find(|(most, _)| lengths <= *most).map_or(0, |(_, terms)| *terms);
        let terms = terms.max(self.given.terms);
        let (mut clear, mut deflection) = (vec![0.0; terms], vec![0.0; terms]);
        let (cell, e) = (link.cells[0], self.stiffness(link));
        let (bend, third) = (moment / 2.0 / e, shear / 6.0 / e);
        self.given.profile(cell, link.lo, &mut clear);
        deflection[..4].copy_from_slice(&[clear[0] - h, clear[1] - h1, -bend, -third]);
        (clear[0], clear[1]) = (h, h1);
        (clear[2], clear[3]) = (clear[2] + bend, clear[3] + third);
        let load = [self.given.load(cell, link.lo), self.given.cells[cell].load_slope];
        let pull = self.given.tension / e;
        for n in 0..terms - 4 {
            let drive = (load.get(n).unwrap_or(&0.0) + link.drive.get(n).unwrap_or(&0.0)) / e + springs * clear[n];
            let pulled = || pull * ((n + 1) * (n + 2)) as f64 * deflection[n + 2];
            let drive = if pull == 0.0 { drive } else { drive + pulled() };
            deflection[n + 4] = drive / ((n + 1) * (n + 2) * (n + 3) * (n + 4)) as f64;
            clear[n + 4] -= deflection[n + 4];
        }
        [clear, deflection]
    }

    /// The particular polynomials deep in a zone, `h` and `v` about its left end.
    pub(super) fn following(&self, link: &Link) -> [Vec<f64>; 2] {
        let (cell, size) = (link.cells[0], self.given.terms.max(link.drive.len()));
        let ((springs, _), e) = (self.rates(cell), self.stiffness(link));
        let mut profile = vec![0.0; size];
        self.given.profile(cell, link.lo, &mut profile);
        let mut drive = fourth(&profile);
        drive.resize(size, 0.0);
        drive.iter_mut().zip(&link.drive).for_each(|(sum, c)| *sum -= c / e);
        drive[0] -= self.given.load(cell, link.lo) / e;
        drive[1] -= self.given.cells[cell].load_slope / e;
        let (mut clear, mut unit) = (vec![0.0; size], 1.0 / springs);
        if self.given.tension != 0.0 {
            clear = following_under_tension(drive, &profile, [self.given.tension / e, springs]);
            drive = Vec::new();
        }
        while !drive.is_empty() {
            clear.iter_mut().zip(&drive).for_each(|(sum, c)| *sum += unit * c);
            drive = fourth(&drive);
            unit /= -springs;
        }
        let deflection = profile.iter().zip(&clear).map(|(g, h)| g - h).collect();
        [clear, deflection]
    }
}

/// The fourth derivative.
#[expect(clippy::cast_precision_loss, reason = "an order is a small number")]
pub(super) fn fourth(taylor: &[f64]) -> Vec<f64> {
    let factor = |n: usize| ((n + 1) * (n + 2) * (n + 3) * (n + 4)) as f64;
    taylor.iter().skip(4).enumerate().map(|(n, c)| c * factor(n)).collect()
}
