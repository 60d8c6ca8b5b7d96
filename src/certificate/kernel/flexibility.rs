//! A span over which the beam changes: its bending stiffness has steps, or it has joints.
//!
//! Between two nodes the moment field is the sum of two parts: the moments `m₀` of the load on the span with hinged ends, and a line
//! through the end moments. With the distances `a + b = L` from both ends, and the end slopes `φ` relative to the chord,
//!
//! ```text
//! φ_a = f_aa M_a + f_ab M_b + e_a,    −φ_b = f_ab M_a + f_bb M_b + e_b
//! f_aa = ∫ (b/L)²/EI + Σ (b_j/L)²/k_j,   f_ab = ∫ (ab/L²)/EI + Σ (a_j b_j/L²)/k_j,   f_bb = ∫ (a/L)²/EI + Σ (a_j/L)²/k_j
//! e_a = ∫ (b/L) m₀/EI + Σ (b_j/L) m₀(j)/k_j,    e_b = ∫ (a/L) m₀/EI + Σ (a_j/L) m₀(j)/k_j
//! ```
//!
//! A joint at the right end of a span is part of the span: the slope of the node is the slope beyond the joint.
//!
//! A span that is not a mechanism has at most two hinges. Each rotates by `κ` such that its moment is zero. With `ρ = (b/L, a/L)` at the
//! hinge, and `F` and `e` of everything else
//!
//! ```text
//! F M + Σ ρ_i κ_i = φ − e,   ρ_i · M = −m₀(i):     (ρ_i · F⁻¹ ρ_j) κ_j = ρ_i · F⁻¹ (φ − e) + m₀(i)
//! ```

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::polynomial::{Polynomial, number};

/// The flexibility of a span, the end rotations caused by its load, and the moments at its joints, hinges and steps.
#[derive(Debug)]
pub(super) struct Flexible {
    f: [Interval; 3],
    e: [Interval; 2],
    /// `M` at the joints: its shares of the moments at both ends, and `m₀`.
    joints: Vec<(f64, f64, [Interval; 3])>,
    /// The same at hinges.
    pub(super) hinges: Vec<(f64, [Interval; 3])>,
    /// `M` at the two ends of each cell, which has one stiffness, in the same form.
    pub(super) parts: Vec<([f64; 2], f64, [[Interval; 3]; 2])>,
}

impl Flexible {
    /// The flexibility of the beam between two positions; [`None`] if the beam does not change there.
    pub(super) fn of(enclosed: &EnclosedScene<'_>, [from, to]: [f64; 2]) -> Option<Self> {
        let joints = enclosed.joints.iter().filter(|(x, _)| from < *x && *x <= to);
        let is_changed = enclosed.changes.iter().any(|x| from < *x && *x < to) || joints.clone().next().is_some();
        is_changed.then_some(())?;
        let (load, length) = (enclosed.load, Interval::length(from, to));
        let cells = enclosed.cells(from, to, Vec::new());
        let point = |x: f64| [load.point(x), load.couple(x)];
        let line = |cell: [f64; 2]| load.line(cell[0], cell);
        // ∫ q a + Σ P a + Σ C up to each cell from the left, and ∫ q b + Σ P b − Σ C beyond it from the right.
        let mut left = vec![Interval::ZERO];
        for cell in &cells {
            let ([q, rise], w, a) = (line(*cell), Interval::length(cell[0], cell[1]), Interval::length(from, cell[0]));
            let spread = w * (q * (a + w / number(2)) + rise * w * (a / number(2) + w / number(3)));
            let [force, couple] = if cell[1] < to { point(cell[1]) } else { [Interval::ZERO; 2] };
            left.push(left[left.len() - 1] + spread + force * Interval::length(from, cell[1]) + couple);
        }
        let mut right = vec![Interval::ZERO];
        for cell in cells.iter().rev() {
            let ([q, rise], w, b) = (line(*cell), Interval::length(cell[0], cell[1]), Interval::length(cell[1], to));
            let spread = w * (q * (b + w / number(2)) + rise * w * (b / number(2) + w / number(6)));
            let [force, couple] = if from < cell[0] { point(cell[0]) } else { [Interval::ZERO; 2] };
            right.push(right[right.len() - 1] + spread + force * Interval::length(cell[0], to) - couple);
        }
        right.reverse();
        let (joints_of, hinges, parts) = (Vec::new(), Vec::new(), Vec::new());
        let mut found = Self { f: [Interval::ZERO; 3], e: [Interval::ZERO; 2], joints: joints_of, hinges, parts };
        for (i, cell) in cells.iter().enumerate() {
            let ([q, rise], w) = (line(*cell), Interval::length(cell[0], cell[1]));
            let [a, b] = [Interval::length(from, cell[0]) / length, Interval::length(cell[0], to) / length];
            let [near, far] = [a, b].map(|share| [share, Interval::exact(1.0) / length]);
            let (near, far) = (Polynomial::new(&near), Polynomial::new(&[far[0], -far[1]]));
            // m₀ about the left end of the cell: ∫ q a' and ∫ q b' within the cell are added to the sums outside it.
            let (a, b) = (a * length, b * length);
            let before = Polynomial::new(&[left[i], q * a, (q + rise * a) / number(2), rise / number(3)]);
            let [within, half, third] = [w, w * w / number(2), w * w * w / number(3)];
            let beyond = right[i + 1] + q * (b * within - half) + rise * (b * half - third);
            let behind = Polynomial::new(&[beyond, -(q * b), (q - rise * b) / number(2), rise / number(3)]);
            let unloaded = product(&far, &before).plus(&product(&near, &behind));
            let stiffness = enclosed.stiffness_between(*cell);
            let of = |p: &Polynomial, r: &Polynomial| p.integral_of_product(r, w) / Interval::exact(stiffness);
            found.add([of(&far, &far), of(&near, &far), of(&near, &near)], [of(&far, &unloaded), of(&near, &unloaded)]);
            let at = |s: Interval| [far.at(s), near.at(s), unloaded.at(s)];
            found.parts.push((*cell, stiffness, [at(Interval::ZERO), at(w)]));
            for &(x, k) in joints.clone().filter(|(x, _)| x.total_cmp(&cell[1]).is_eq()) {
                let [r, s, m] = at(w);
                if k <= 0.0 {
                    found.hinges.push((x, [r, s, m]));
                    continue;
                }
                let over = |value: Interval| value / Interval::exact(k);
                found.add([over(r * r), over(r * s), over(s * s)], [over(r * m), over(s * m)]);
                found.joints.push((x, k, [r, s, m]));
            }
        }
        Some(found)
    }

    fn add(&mut self, f: [Interval; 3], e: [Interval; 2]) {
        self.f = [0, 1, 2].map(|k| self.f[k] + f[k]);
        self.e = [0, 1].map(|k| self.e[k] + e[k]);
    }

    /// `F⁻¹` times the rotations of both ends.
    fn bent(&self, [a, b]: [Interval; 2]) -> [Interval; 2] {
        let [aa, ab, bb] = self.f;
        let determinant = aa * bb - ab * ab;
        [(bb * a - ab * b) / determinant, (aa * b - ab * a) / determinant]
    }

    /// The rotations of the hinges for given end rotations in excess of those caused by the load, with or without the moments of the
    /// load; empty if there are more than two hinges.
    fn turned(&self, turns: [Interval; 2], loaded: bool) -> Vec<Interval> {
        let times = |[r, s]: [Interval; 2], [x, y]: [Interval; 2]| r * x + s * y;
        let of = |(_, [r, s, _]): &(f64, [Interval; 3])| [*r, *s];
        let lacks = |hinge: &(f64, [Interval; 3])| {
            let moment = times(of(hinge), self.bent(turns));
            if loaded { moment + hinge.1[2] } else { moment }
        };
        match &self.hinges[..] {
            [one] => vec![lacks(one) / times(of(one), self.bent(of(one)))],
            [one, two] => {
                let [aa, ab, bb] = [(one, one), (one, two), (two, two)].map(|(i, j)| times(of(i), self.bent(of(j))));
                let (a, b, determinant) = (lacks(one), lacks(two), aa * bb - ab * ab);
                vec![(bb * a - ab * b) / determinant, (aa * b - ab * a) / determinant]
            }
            _ => Vec::new(),
        }
    }

    /// The moments at both ends, and the rotations of the hinges.
    fn solved(&self, turns: [Interval; 2], loaded: bool) -> ([Interval; 2], Vec<Interval>) {
        let kinks = self.turned(turns, loaded);
        let rest = self
            .hinges
            .iter()
            .zip(&kinks)
            .fold(turns, |[a, b], ((_, [r, s, _]), kink)| [a - *r * *kink, b - *s * *kink]);
        (self.bent(rest), kinks)
    }

    /// The derivatives of the end moments with respect to the end slopes: `[end][slope]`.
    pub(super) fn answer(&self) -> [[Interval; 2]; 2] {
        let [one, none] = [Interval::exact(1.0), Interval::ZERO];
        let ([aa, ba], _) = self.solved([one, none], false);
        let ([ab, bb], _) = self.solved([none, -one], false);
        [[aa, ab], [ba, bb]]
    }

    /// The end rotations in excess of those caused by the load.
    fn turns_beyond(&self, [a, b]: [Interval; 2]) -> [Interval; 2] {
        [a - self.e[0], -b - self.e[1]]
    }

    /// The moments at both ends, for the end slopes relative to the chord.
    pub(super) fn moments(&self, slopes: [Interval; 2]) -> [Interval; 2] {
        self.solved(self.turns_beyond(slopes), true).0
    }

    /// The jump of the slope at each hinge, for these end slopes.
    pub(super) fn kinks_of_hinges(&self, slopes: [Interval; 2]) -> Vec<(f64, Interval)> {
        let kinks = self.solved(self.turns_beyond(slopes), true).1;
        self.hinges.iter().zip(kinks).map(|(hinge, kink)| (hinge.0, -kink)).collect()
    }

    /// The moment in each hinge, for these end moments.
    pub(super) fn in_hinges(&self, ends: [Interval; 2]) -> impl Iterator<Item = (f64, Interval)> + '_ {
        self.hinges.iter().map(move |(x, shares)| (*x, at(*shares, ends)))
    }

    /// The end slopes relative to the chord, for these end moments.
    pub(super) fn turns(&self, [a, b]: [Interval; 2]) -> [Interval; 2] {
        let ([aa, ab, bb], [turn_a, turn_b]) = (self.f, self.e);
        [aa * a + ab * b + turn_a, -(ab * a + bb * b + turn_b)]
    }

    /// The jump of the slope at each joint, `−M/k`.
    pub(super) fn kinks(&self, ends: [Interval; 2]) -> Vec<(f64, Interval)> {
        self.joints.iter().map(|(x, k, shares)| (*x, -(at(*shares, ends) / Interval::exact(*k)))).collect()
    }

    /// `½∫ r²/EI + Σ r²/2k` for an `r` that is linear from one end to the other.
    pub(super) fn work(&self, ends: [Interval; 2]) -> Interval {
        let linear = |[r, s, _]: [Interval; 3]| at([r, s, Interval::ZERO], ends);
        let part = |sum: Interval, &([from, to], stiffness, shares): &([f64; 2], f64, [[Interval; 3]; 2])| {
            let [r, s] = shares.map(linear);
            let squares = r.square() + s.square() + (r + s).square();
            sum + Interval::length(from, to) * squares / (number(12) * Interval::exact(stiffness))
        };
        let joint = |sum: Interval, &(_, k, shares): &(f64, f64, [Interval; 3])| {
            sum + linear(shares).square() / (number(2) * Interval::exact(k))
        };
        self.joints.iter().fold(self.parts.iter().fold(Interval::ZERO, part), joint)
    }
}

/// A moment from its shares of the end moments and `m₀`.
fn at([a, b, unloaded]: [Interval; 3], ends: [Interval; 2]) -> Interval {
    a * ends[0] + b * ends[1] + unloaded
}

/// The product of a line and a cubic.
fn product(line: &Polynomial, cubic: &Polynomial) -> Polynomial {
    let [c, d] = [line.coefficients()[0], line.coefficients()[1]];
    let raised: Vec<Interval> =
        std::iter::once(Interval::ZERO).chain(cubic.coefficients().iter().map(|of| *of * d)).collect();
    cubic.times(c).plus(&Polynomial::new(&raised))
}
