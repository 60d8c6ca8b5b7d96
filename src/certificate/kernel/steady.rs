//! The stability margin of a beam under compression.
//!
//! If a beam is stable under a compression `N' < N < 0`, then, where `‖w‖²` is `∫ EI w''²` plus the energy of springs and joints,
//!
//! ```text
//! ‖w‖² + N ∫ w'² = (1 − N/N') ‖w‖² + (N/N') (‖w‖² + N' ∫ w'²) ≥ α ‖w‖²,      α = 1 − N/N'
//! ```
//!
//! Sylvester's law of inertia decides whether it is stable. Deflections `y` and moments `M` are eliminated from left to right, as in
//! `scene::axial`. The beam is stable if there are as many negative pivots as moments. Usually deflection and moment of a position
//! together have one negative pivot, but one position may have two if another one has none. The number of negative pivots is proven:
//! where the product `−d` of the two pivots of a position is negative, one of them is, and otherwise the sign of each is proven. Where
//! `y` or `M` is zero its row is omitted, which is the limit of an infinite `b` or `g`:
//!
//! ```text
//! a = b + n,  h = c + e,  d = a g + h²        b' = (b (c² + n g) + n e²)/d,   e' = (b c (g + ω) + e (c e + c² − n ω))/d
//!                                             g' = w + (c² g + ω (c h + c e + c² − n ω) − b ω²)/d
//! y = 0      b' = n + c²/g,   e' = c + c ω/g,   g' = w − ω²/g
//! M = 0      b' = b n/a,      e' = b c/a,       g' = w + c²/a
//! both       b' = n,          e' = c,           g' = w
//! ```
//!
//! A rotational spring is an additional moment, with the pivot `−(g + 1/k)`. At a built-in support the elimination starts anew.

use super::contact_node::EnclosedScene;
use super::interval::Interval;
use super::load::cells;
use super::polynomial::number;
use crate::scene::Support;

/// Largest `|N'| ℓ²/EI` of a part, so that a few terms are enough.
const MOST: f64 = 0.64;

/// Terms of each series: the remainder is less than twice the next term, which is below `10⁻¹⁸`.
const TERMS: usize = 9;

/// `n`, `c`, `w`, `ω` and `c² − n ω` of a part of the beam.
fn law(length: Interval, stiffness: Interval, force: Interval) -> [Interval; 5] {
    let z = force * length * length / stiffness;
    let (mut sine, mut near, mut far, mut p) = (Interval::ZERO, Interval::ZERO, Interval::ZERO, number(1));
    for n in (0..TERMS).map(|n| 2 * n) {
        let next = p / number((n + 2) * (n + 3));
        (sine, near, far) = (sine + p, near + next * number(n + 2), far + next);
        p = next * z;
    }
    let rest = Interval::around_zero(2.0 * p.magnitude());
    let [sine, near, far] = [sine, near, far].map(|sum| sum + rest);
    let (c, flexibility) = (number(1) / length, length / stiffness);
    [force / length, c, flexibility * near / sine, flexibility * far / sine, c * c / sine]
}

/// The state of the elimination up to a position, and the number of negative pivots minus the number of moments.
#[derive(Default)]
struct Elimination {
    b: Interval,
    e: Interval,
    g: Interval,
    surplus: i32,
}

impl Elimination {
    /// Counts a pivot; [`None`] if its sign is not proven.
    fn sign(&mut self, pivot: Interval, of_moment: bool) -> Option<()> {
        let is_negative = pivot.hi() < 0.0;
        (is_negative || 0.0 < pivot.lo()).then_some(())?;
        self.surplus += i32::from(is_negative) - i32::from(of_moment);
        Some(())
    }

    /// Eliminates a rotational spring.
    fn turning(&mut self, k: f64) -> Option<()> {
        let share = number(1) + Interval::exact(k) * self.g;
        self.sign(-share, true)?;
        self.b = self.b + Interval::exact(k) * self.e.square() / share;
        (self.e, self.g) = (self.e / share, self.g / share);
        Some(())
    }

    /// Eliminates a position at which `y` or `M` may be zero, and adds the part to its right.
    fn place(&mut self, [y, m]: [bool; 2], [n, c, w, off, left]: [Interval; 5]) -> Option<()> {
        let (b, e, g) = (self.b, self.e, self.g + w);
        let (a, h) = (b + n, c + e);
        (self.b, self.e, self.g) = match (y, m) {
            (true, true) => (n, c, w),
            (true, false) => {
                self.sign(-g, true)?;
                (n + c * c / g, c + c * off / g, w - off * off / g)
            }
            (false, true) => {
                self.sign(a, false)?;
                (b * n / a, b * c / a, w + c * c / a)
            }
            (false, false) => {
                let d = a * g + h * h;
                // `−d` is the product of both pivots.
                if d.lo() <= 0.0 {
                    self.sign(d, false)?;
                    self.sign(a, false)?;
                    self.surplus += if a.hi() < 0.0 { -1 } else { -2 };
                }
                let bent = c * e + left;
                (
                    (b * (c * c + n * g) + n * e * e) / d,
                    (b * c * (g + off) + e * bent) / d,
                    w + (c * c * g + off * (c * h + bent) - b * off * off) / d,
                )
            }
        };
        Some(())
    }
}

impl EnclosedScene<'_> {
    /// A lower bound of `α`; not positive if none is proven.
    pub(crate) fn steadiness(&self) -> f64 {
        /// Shares by which the tried compression is below the computed buckling load.
        const LESS: [f64; 6] = [1e-9, 1e-6, 1e-3, 0.02, 0.1, 0.3];
        if 0.0 <= self.tension {
            return 1.0;
        }
        let at = self.beam.buckles_at();
        let borne = LESS.iter().map(|less| at * (1.0 - less)).find(|&force| force < self.tension && self.bears(force));
        borne.map_or(0.0, |force| (number(1) - Interval::exact(self.tension) / Interval::exact(force)).lo())
    }

    /// Whether the beam is proven to be stable under a compression.
    fn bears(&self, force: f64) -> bool {
        let built_in = self.beam.supports().iter().filter(|support| support.is_built_in()).map(|support| support.at);
        let mut from = 0.0;
        built_in.chain([self.length]).all(|to| {
            let bears = to <= from || self.bears_between([from, to], force).is_some_and(|surplus| surplus == 0);
            from = to;
            bears
        })
    }

    /// The surplus of negative pivots between two positions, at each of which the elimination starts or ends.
    fn bears_between(&self, [from, to]: [f64; 2], force: f64) -> Option<i32> {
        let held = self.beam.holding().map(|support| support.at);
        let places = held.chain(self.changes.iter().copied()).chain(self.joints.iter().map(|joint| joint.0));
        let mut chain = Elimination::default();
        for ends in cells(from, to, places.collect()) {
            let stiffness = self.stiffness_between(ends);
            let most = (MOST * stiffness / force.abs()).sqrt() * (1.0 - 1e-9);
            let parts = ((ends[1] - ends[0]) / most).ceil().max(1.0);
            let cut = |k: f64| if k < parts { ends[0] + (ends[1] - ends[0]) * (k / parts) } else { ends[1] };
            let mut k = 0.0;
            while k < parts {
                let length = Interval::length(cut(k), cut(k + 1.0));
                let law = law(length, Interval::exact(stiffness), Interval::exact(force));
                let vanishes = if k < 1.0 { self.pass(ends[0], &mut chain)? } else { [false; 2] };
                chain.place(vanishes, law)?;
                k += 1.0;
            }
        }
        let vanishes = self.pass(to, &mut chain)?;
        chain.place(vanishes, [Interval::ZERO; 5]).map(|()| chain.surplus)
    }

    /// Adds the springs and joints at a position; returns whether `y` and `M` are zero there.
    fn pass(&self, x: f64, chain: &mut Elimination) -> Option<[bool; 2]> {
        let support = self.beam.holding().find(|support| support.at.total_cmp(&x).is_eq());
        let turning = support.and_then(|support| support.turning_stiffness);
        let is_end = (x <= 0.0 || self.length <= x) && !support.is_some_and(Support::is_built_in);
        match turning {
            // Beyond an end there is no moment.
            Some(k) if is_end => chain.g = chain.g + number(1) / Interval::exact(k),
            Some(k) => chain.turning(k)?,
            None => {}
        }
        let joint = self.joint(x);
        let soft = joint.filter(|k| 0.0 < *k).map_or(Interval::ZERO, |k| number(1) / Interval::exact(k));
        chain.g = chain.g + soft;
        if let Some(k) = support.and_then(|support| support.stiffness) {
            chain.b = chain.b + Interval::exact(k);
        }
        let holds = support.is_some_and(|support| support.stiffness.is_none());
        Some([holds, joint == Some(0.0) || is_end && turning.is_none()])
    }
}
