//! Polynomials with fractions for coefficients, from the lowest.

use dashu_ratio::RBig;

use super::number::Number;

/// `Σ c_j xʲ`.
pub type Polynomial = Vec<RBig>;

/// Its value at a place.
#[must_use]
pub fn at(p: &[RBig], x: &RBig) -> RBig {
    p.iter().rev().fold(RBig::ZERO, |sum, c| sum * x + c)
}

/// Its derivative.
#[must_use]
pub fn derivative(p: &[RBig]) -> Polynomial {
    (1..).zip(p.iter().skip(1)).map(|(j, c)| RBig::whole(j) * c).collect()
}

/// `p + factor q`.
#[must_use]
pub fn plus(p: &[RBig], factor: &RBig, q: &[RBig]) -> Polynomial {
    let of = |p: &[RBig], j: usize| p.get(j).cloned().unwrap_or(RBig::ZERO);
    (0..p.len().max(q.len())).map(|j| of(p, j) + factor * of(q, j)).collect()
}

/// `p q`.
#[must_use]
pub fn product(p: &[RBig], q: &[RBig]) -> Polynomial {
    p.iter().rev().fold(Vec::new(), |sum: Polynomial, c| {
        let raised: Polynomial = [RBig::ZERO].into_iter().chain(sum).collect();
        plus(&raised, c, q)
    })
}

/// `p(by + x)`.
#[must_use]
pub fn shifted(p: &[RBig], by: &RBig) -> Polynomial {
    p.iter().rev().fold(Vec::new(), |sum, c| plus(&product(&sum, &[by.clone(), RBig::ONE]), c, &[RBig::ONE]))
}

/// `∫ p dx` between two places.
#[must_use]
pub fn integral(p: &[RBig], [from, to]: &[RBig; 2]) -> RBig {
    let of: Polynomial = [RBig::ZERO].into_iter().chain((1..).zip(p).map(|(j, c)| c / RBig::whole(j))).collect();
    at(&of, to) - at(&of, from)
}

/// Whether `p ≥ 0` between two places: its coefficients in Bernstein's form are, on parts of parts. False if that is open.
#[must_use]
pub fn is_nowhere_negative(p: &[RBig], [from, to]: &[RBig; 2]) -> bool {
    /// Parts of this share of the whole are as small as rounding is in 64 bits.
    const HALVINGS: u32 = 60;
    let (degree, width) = (i64::try_from(p.len()).unwrap_or(1) - 1, to - from);
    // The coefficients b_k = Σ_j C(k, j) d_j from d_j = c_j wʲ/C(n, j).
    let mut share = RBig::ONE;
    let mut form: Polynomial = Vec::new();
    for (j, c) in (0..).zip(shifted(p, from)) {
        form.push(c * &share);
        share = share * &width * RBig::fraction(j + 1, (degree - j).max(1));
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
    // The first and the last of them are values.
    if halvings == 0 || [form.first(), form.last()].into_iter().flatten().any(|b| *b < RBig::ZERO) {
        return false;
    }
    // De Casteljau's algorithm: the first ones are those of the left half, and what remains those of the right half.
    let mut left = vec![form[0].clone()];
    for j in 1..form.len() {
        (0..form.len() - j).for_each(|k| form[k] = (&form[k] + &form[k + 1]) / RBig::whole(2));
        left.push(form[0].clone());
    }
    halved(left, halvings - 1) && halved(form, halvings - 1)
}
