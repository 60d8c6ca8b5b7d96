//! A couple on a beam far longer than `1/λ`: what it bends the beam by has a closed form (Hetényi 1946), with `s` from the couple and `y = λ s`
//!
//! ```text
//! inside     u = C/4 EI λ² · e^(−y) sin y, and the negative mirror image,      u' = C/4 EI λ  at the couple
//! at an end  u = C/2 EI λ² · e^(−y) (cos y − sin y),                           u' = C/EI λ
//! J* = −q d l − q² l/2k − ½ C u'
//! ```

use super::*;

const LENGTH: f64 = 80.0;
const COUPLE: f64 = 0.01;
/// A polynomial of the most terms has thirteen digits of `u` over this.
const STEP: f64 = 0.25;

/// `λ`.
fn decay() -> f64 {
    (0.25 * GROUND / STIFFNESS).sqrt().sqrt()
}

/// What bends: a couple inside, or one so close to the right end that it might be there.
#[derive(Debug, Clone, Copy)]
struct Bends {
    at: f64,
    is_at_the_end: bool,
}

impl Bends {
    /// `u` and its derivatives, on the right side of the couple or on its left one: the real part of `z e^((−1 + i) y)`.
    fn derivatives(self, x: f64, on_the_right: bool) -> Vec<f64> {
        let (decay, side) = (decay(), if on_the_right { 1.0 } else { -1.0 });
        let unit = COUPLE / (4.0 * STIFFNESS * decay * decay);
        let y = decay * side * (x - if self.is_at_the_end { LENGTH } else { self.at });
        let (size, [cos, sin]) = (libm::exp(-y), [libm::cos(y), libm::sin(y)]);
        let [re, im] = if self.is_at_the_end { [2.0 * unit; 2] } else { [0.0, -side * unit] };
        let mut z = [size * (re * cos - im * sin), size * (re * sin + im * cos)];
        let next = |_| {
            let here = z[0];
            z = [-side * decay * (z[0] + z[1]), side * decay * (z[0] - z[1])];
            here
        };
        (0..MOST_TERMS).map(next).collect()
    }

    /// `u'` at the couple.
    fn turns(self) -> f64 {
        COUPLE / (if self.is_at_the_end { 1.0 } else { 4.0 } * STIFFNESS * decay())
    }

    /// Stretches between places, with this share of `u`, and a noise.
    fn witness(self, places: &[f64], share: f64, off: f64, random: &mut Noise) -> Vec<Stretch> {
        let mut noise = |value: f64| share * value + SUNK * off * random.next();
        let mut stretch = |from: f64, to: f64| {
            let on_the_right = self.at <= from;
            let over = [from, to].map(|x| self.derivatives(x, on_the_right && !self.is_at_the_end));
            let mut factorial = 1.0;
            let term = |(n, derivative): (usize, &f64)| {
                factorial *= if n == 0 { 1.0 } else { f64::from(u8::try_from(n).expect("few terms")) };
                if n < 3 { noise(derivative / factorial) } else { share * derivative / factorial }
            };
            let mut sunk: Vec<f64> = over[0].iter().enumerate().map(term).collect();
            sunk[0] += SUNK;
            // Behind a couple all but at the end there is no moment.
            let bends = if self.is_at_the_end && on_the_right { 0.0 } else { -STIFFNESS };
            let mut end = |u: &[f64]| [SUNK + noise(u[0]), noise(u[1]), noise(bends * u[2]), noise(bends * u[3])];
            let ends = [end(&over[0]), end(&over[1])];
            Stretch { from, to, sunk, ends }
        };
        places.windows(2).map(|w| stretch(w[0], w[1])).collect()
    }
}

/// Couples at nodes that short stretches are walked to, from the left and from the right, or that they begin at.
fn cases() -> Vec<(Bends, Vec<f64>)> {
    let middle = 0.5 * LENGTH;
    let mut cases = Vec::new();
    for apart in [1e-3, 1e-5, 1e-7, 1e-10, 1e-14] {
        let [before, behind] = [middle - apart, middle + apart];
        let inside = [vec![before], vec![behind], vec![before, behind], vec![before, middle - 0.5 * apart, behind]];
        cases.extend(inside.map(|more| (Bends { at: middle, is_at_the_end: false }, more)));
        let [at, farther] = [LENGTH - apart, LENGTH - 2.0 * apart];
        let ends = [vec![at], vec![at, farther]].into_iter().filter(|_| !(1e-12..=1e-8).contains(&apart));
        cases.extend(ends.map(|more| (Bends { at, is_at_the_end: true }, more)));
    }
    let regular = (0..=320).map(|i| STEP * f64::from(i));
    for (_, more) in &mut cases {
        more.extend(regular.clone());
        more.sort_by(f64::total_cmp);
        more.dedup();
    }
    cases
}

/// Whatever a witness says of a beam with a couple, `J(v̂) − gap ≤ J* ≤ J(v̂)`. One that leaves the couple out is believed if the moment does not
/// jump where it acts.
#[test]
fn a_wrong_witness_does_not_lose_a_couple() {
    const ROUNDING: f64 = 1e-12;
    let (mut random, mut found) = (Noise(5), 0);
    for (bends, places) in cases() {
        for (share, off) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1e-6), (0.5, 1e-9), (-1.0, 0.0), (1.0, 1e-4), (0.0, 1e-7)] {
            let witness = bends.witness(&places, share, off, &mut random);
            turned(LENGTH, &[], Some(CoupleLoad { at: bends.at, moment: COUPLE }), |enclosed| {
                let Some(pair) = pair(enclosed, &witness) else { return };
                found += 1;
                let sprung = pair.ground.as_ref().expect("of springs");
                let energy = energy(&pair.pieces, enclosed) + sprung.energy;
                let least = least_energy(LENGTH) - 0.5 * COUPLE * bends.turns();
                let beside =
                    if bends.is_at_the_end { 10.0 * (LENGTH - bends.at) * COUPLE * COUPLE / STIFFNESS } else { 0.0 };
                let rounding = ROUNDING * least.abs() + beside;
                assert!(least - rounding <= energy.hi(), "{bends:?}, {share}, {off}: {energy:?} for {least}");
                let lower = energy.lo() - pair.gap;
                assert!(lower <= least + rounding, "{bends:?}, {share}, {off}: {lower:?} for {least}");
            });
        }
    }
    assert!(150 < found, "only {found} witnesses prove anything");
}

/// A right witness proves its answer, however short the stretches beside the couple are.
#[test]
fn a_short_stretch_beside_a_couple_costs_nothing() {
    for (bends, places) in cases() {
        let witness = bends.witness(&places, 1.0, 0.0, &mut Noise(1));
        let couple = CoupleLoad { at: bends.at, moment: COUPLE };
        let gap = turned(LENGTH, &[], Some(couple), |enclosed| Some(pair(enclosed, &witness)?.gap));
        let beside = if bends.is_at_the_end { LENGTH - bends.at } else { 0.0 };
        let most = 1e-20 + 10.0 * beside * COUPLE * COUPLE / STIFFNESS;
        assert!(gap.is_some_and(|gap| gap <= most), "{bends:?}, {places:?}: {gap:?} for {most:e}");
    }
}
