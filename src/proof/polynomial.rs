//! Polynomials with rational coefficients, from the lowest power on.

use dashu_ratio::RBig;

/// `Σ c_j sʲ`.
pub(super) type Polynomial = Vec<RBig>;

/// A 64-bit number as a fraction, without rounding. The numbers of a scene are finite.
pub(super) fn exactly(value: f64) -> RBig {
    RBig::try_from(value).unwrap_or(RBig::ZERO)
}

/// The 64-bit number nearest to a fraction.
pub(super) fn short(of: &RBig) -> RBig {
    exactly(of.to_f64().value())
}

/// A sum of 64-bit numbers near a fraction, with sixty digits. Results computed from it stay short.
pub(super) fn trimmed(of: &RBig) -> RBig {
    /// Enough for a beam in tension to have the digits of 64 bits after a hundred decay lengths.
    const TERMS: usize = 4;
    (0..TERMS).fold(RBig::ZERO, |sum, _| &sum + short(&(of - &sum)))
}

/// `|of|`.
pub(super) fn magnitude(of: &RBig) -> RBig {
    if *of < RBig::ZERO { -of } else { of.clone() }
}

/// The value of `p` at `s`.
pub(super) fn at(p: &[RBig], s: &RBig) -> RBig {
    p.iter().rev().fold(RBig::ZERO, |sum, c| sum * s + c)
}

/// The value and the slope of `p` at `s`.
pub(super) fn jet(p: &[RBig], s: &RBig) -> [RBig; 2] {
    [at(p, s), at(&derivative(p), s)]
}

/// The derivative of `p`.
pub(super) fn derivative(p: &[RBig]) -> Polynomial {
    (1..).zip(p.iter().skip(1)).map(|(j, c)| c * RBig::from(j)).collect()
}

/// `p + factor q`.
pub(super) fn plus(p: &[RBig], factor: &RBig, q: &[RBig]) -> Polynomial {
    let of = |p: &[RBig], j: usize| p.get(j).cloned().unwrap_or(RBig::ZERO);
    (0..p.len().max(q.len())).map(|j| of(p, j) + factor * of(q, j)).collect()
}

/// `p q`.
pub(super) fn product(p: &[RBig], q: &[RBig]) -> Polynomial {
    let mut product = vec![RBig::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        q.iter().enumerate().for_each(|(j, b)| product[i + j] += a * b);
    }
    product
}

/// `p(by + s)`.
pub(super) fn shifted(p: &[RBig], by: &RBig) -> Polynomial {
    let mut shifted = p.to_vec();
    for i in 1..p.len() {
        for j in (i - 1..p.len() - 1).rev() {
            shifted[j] = &shifted[j] + by * &shifted[j + 1];
        }
    }
    shifted
}

/// The polynomial with the given values and slopes at `0` and `l`, and the given coefficients from the fourth power on.
pub(super) fn between([[y0, d0], [y1, d1]]: [&[RBig; 2]; 2], tail: &[RBig], l: &RBig) -> Polynomial {
    let mut p = vec![y0.clone(), d0.clone(), RBig::ZERO, RBig::ZERO];
    p.extend_from_slice(tail);
    let [end, slope] = jet(&p, l);
    let (rise, turn) = ((y1 - end) / l, d1 - slope);
    p[2] = (RBig::from(3) * &rise - &turn) / l;
    p[3] = (turn - RBig::from(2) * rise) / (l * l);
    p
}

/// Whether `p ≥ 0` from `0` to `l`: repeated halving must make all Bernstein coefficients non-negative. False if the halving does not
/// decide.
pub(super) fn is_nowhere_negative(p: &[RBig], l: &RBig) -> bool {
    /// Parts of this fraction of the whole are as small as the rounding of 64-bit numbers.
    const HALVINGS: u32 = 60;
    // The coefficients b_k = Σ_j C(k, j) d_j from d_j = c_j lʲ/C(n, j).
    let mut share = RBig::ONE;
    let mut form: Polynomial = Vec::new();
    for (j, c) in p.iter().enumerate() {
        form.push(c * &share);
        share = share * l * RBig::from(j + 1) / RBig::from((p.len() - 1 - j).max(1));
    }
    for j in (1..form.len()).rev() {
        (j..form.len()).for_each(|k| form[k] = &form[k] + &form[k - 1]);
    }
    halved(form, HALVINGS)
}

fn halved(mut form: Polynomial, halvings: u32) -> bool {
    if form.iter().all(|b| RBig::ZERO <= *b) {
        return true;
    }
    // The first and the last coefficient are values of `p`.
    if halvings == 0 || [form.first(), form.last()].into_iter().flatten().any(|b| *b < RBig::ZERO) {
        return false;
    }
    // De Casteljau's algorithm: the first coefficients belong to the left half, and the remaining ones to the right half.
    let mut left = vec![form[0].clone()];
    for j in (1..form.len()).rev() {
        (0..j).for_each(|k| form[k] = (&form[k] + &form[k + 1]) / RBig::from(2));
        left.push(form[0].clone());
    }
    halved(left, halvings - 1) && halved(form, halvings - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(p: &[i32]) -> Polynomial {
        p.iter().map(|c| RBig::from(*c)).collect()
    }

    #[test]
    fn a_polynomial_between_two_ends_has_their_values_and_slopes() {
        let (l, ends) = (RBig::from(3), [whole(&[2, -1]), whole(&[5, 7])].map(|p| [p[0].clone(), p[1].clone()]));
        let p = between([&ends[0], &ends[1]], &whole(&[1, -2]), &l);
        assert_eq!([jet(&p, &RBig::ZERO), jet(&p, &l)], ends);
        assert_eq!(p[4..], whole(&[1, -2]));
    }

    #[test]
    fn a_square_is_nowhere_negative_and_a_little_less_is() {
        // (2 s − 1)², with its zero in the middle.
        let mut square = whole(&[1, -4, 4]);
        assert!(is_nowhere_negative(&square, &RBig::ONE));
        square[0] = &square[0] - RBig::ONE / RBig::from(1_000_000_000);
        assert!(!is_nowhere_negative(&square, &RBig::ONE));
        assert!(is_nowhere_negative(&[], &RBig::ONE) && !is_nowhere_negative(&whole(&[-1]), &RBig::ONE));
    }
}
