//! Guaranteed signs, minima and roots of a polynomial on an interval, from its Bernstein form.
//!
//! On `[0, w]` write `Σ a_j t^j = Σ b_k B_k(t)` with the Bernstein polynomials `B_k ≥ 0`, `Σ B_k = 1`. The polynomial lies between the
//! least and the greatest `b_k` and equals `b_0` and `b_n` at the ends. It has at most as many roots inside as the `b_k` have changes
//! of sign. Halving the interval (de Casteljau) makes all three statements sharp.

/// Number of coefficients up to which a polynomial is kept on the stack: enough for a beam of degree 5 over a straight profile.
const SMALL: usize = 8;
/// Maximum number of halvings: 2⁻⁴⁸ of the interval is close to its last digit.
const DEPTH: usize = 48;
/// Number of halvings that is enough for most intervals; memory for their halves is reserved at once.
const USUAL_DEPTH: usize = 16;
/// Maximum number of parts of an interval that are examined. A few dozen are usual. The limit guards against a polynomial that follows
/// the floor within its rounding.
const PARTS: usize = 4000;

/// Converts the coefficients of `Σ a_j t^j` into the coefficients of its Bernstein form on `[0, w]`.
///
/// ```text
/// b_k = Σ_{j ≤ k} C(k, j) / C(n, j) a_j w^j
/// ```
#[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
fn to_bernstein(a: &mut [f64], width: f64) {
    let n = a.len().saturating_sub(1);
    // c_j = a_j w^j / C(n, j); then b_k = Σ_j C(k, j) c_j by the scheme of repeated sums.
    let mut factor = 1.0;
    for (j, a) in a.iter_mut().enumerate() {
        *a *= factor;
        factor *= width * (j + 1) as f64 / (n - j).max(1) as f64;
    }
    for pass in 0..n {
        for k in (pass + 1..=n).rev() {
            a[k] += a[k - 1];
        }
    }
}

/// The least and the greatest Bernstein coefficient of a polynomial with up to `SMALL` coefficients. They bound its values; both are
/// NaN if any coefficient is.
pub(super) fn range(monomial: &[f64], width: f64) -> Option<[f64; 2]> {
    let mut b = [0.0; SMALL];
    let b = b.get_mut(..monomial.len())?;
    b.copy_from_slice(monomial);
    to_bernstein(b, width);
    if b.iter().any(|b| b.is_nan()) {
        return Some([f64::NAN; 2]);
    }
    Some(b.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], &b| [b.min(lo), b.max(hi)]))
}

/// Bernstein coefficients of a polynomial of any degree.
fn form(monomial: &[f64], width: f64) -> Vec<f64> {
    let mut b = monomial.to_vec();
    to_bernstein(&mut b, width);
    b
}

/// Both halves of the Bernstein form `b`, by de Casteljau's scheme.
fn halves(b: Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let mut right = b;
    let mut left = Vec::with_capacity(right.len());
    for rest in (1..=right.len()).rev() {
        left.push(right[0]);
        for k in 1..rest {
            right[k - 1] = 0.5 * (right[k - 1] + right[k]);
        }
    }
    (left, right)
}

/// The least value of `Σ a_j t^j` on `[0, w]` and its position, if the polynomial is below `floor` anywhere; [`None`] proves that it is
/// not.
///
/// The value is the minimum to within a thousandth of its size. If no proof is found within a bounded number of parts, the remaining
/// bound is returned as if it were a value.
pub(super) fn lowest_below(monomial: &[f64], width: f64, floor: f64) -> Option<(f64, f64)> {
    /// Relative accuracy of a violation: it is reported and repaired, not used as a number, so a better value is not worth another
    /// halving.
    const CLOSE: f64 = 1e-3;
    if range(monomial, width).is_some_and(|[least, _]| floor <= least) {
        return None;
    }
    let whole = form(monomial, width);
    if whole.iter().all(|&b| floor <= b) {
        return None;
    }
    let mut best: Option<(f64, f64)> = None;
    let mut open = Vec::with_capacity(USUAL_DEPTH);
    open.push((whole, 0.0, width, 0));
    let mut parts = 0;
    while let Some((b, lo, hi, depth)) = open.pop() {
        parts += 1;
        let bar = best.map_or(floor, |(_, value)| value);
        let slack = best.map_or(0.0, |(_, value)| CLOSE * value.abs());
        if b.iter().all(|&b| bar - slack <= b) {
            continue;
        }
        for (at, value) in [(lo, b.first()), (hi, b.last())] {
            let bar = best.map_or(floor, |(_, value)| value);
            // A NaN counts as below every floor.
            if let Some(&value) = value
                && (value < bar || value.is_nan())
            {
                best = Some((at, value));
            }
        }
        if PARTS < parts {
            let bound = b.iter().fold(f64::INFINITY, |least, &b| least.min(b));
            return best.or(Some((lo, bound)));
        }
        if depth < DEPTH && b.iter().all(|b| b.is_finite()) {
            let (left, right) = halves(b);
            let middle = 0.5 * (lo + hi);
            open.push((right, middle, hi, depth + 1));
            open.push((left, lo, middle, depth + 1));
        }
    }
    best
}

/// The positions inside `[0, w]` at which `Σ a_j t^j` changes its sign (or happens to be exactly zero), from left to right.
pub(super) fn sign_changes(monomial: &[f64], width: f64) -> Vec<f64> {
    let mut found = Vec::new();
    if range(monomial, width).is_some_and(|[least, most]| 0.0 < least || most < 0.0) {
        return found;
    }
    let mut open = vec![(form(monomial, width), 0.0, width, 0)];
    let mut parts = 0;
    while let Some((b, lo, hi, depth)) = open.pop() {
        parts += 1;
        match variations(&b) {
            0 => {}
            1 => found.push(bracketed(monomial, [lo, hi], starts_positive(&b))),
            // Below this width rounding decides: an odd number of changes counts as one, an even number as none.
            many if DEPTH <= depth || PARTS < parts => {
                if many % 2 == 1 {
                    found.push(0.5 * (lo + hi));
                }
            }
            _ => {
                let (left, right) = halves(b);
                let middle = 0.5 * (lo + hi);
                // A root exactly at the middle appears in neither half.
                if left.last() == Some(&0.0) {
                    found.push(middle);
                }
                open.push((right, middle, hi, depth + 1));
                open.push((left, lo, middle, depth + 1));
            }
        }
    }
    found.sort_by(f64::total_cmp);
    found.dedup();
    found
}

/// The number of sign changes in a sequence, without its zeros.
fn variations(b: &[f64]) -> usize {
    let mut signs = b.iter().filter(|&&b| b != 0.0 && !b.is_nan()).map(|&b| 0.0 < b);
    let Some(mut last) = signs.next() else {
        return 0;
    };
    signs.filter(|&sign| std::mem::replace(&mut last, sign) != sign).count()
}

/// Whether a form with one change of sign is positive just inside its left end. At the end itself the polynomial may be zero to
/// rounding, and another way to compute it may round to the other side.
fn starts_positive(b: &[f64]) -> bool {
    b.iter().find(|&&b| b != 0.0 && !b.is_nan()).is_some_and(|&b| 0.0 < b)
}

/// `Σ a_j t^j`.
pub(super) fn value(monomial: &[f64], t: f64) -> f64 {
    monomial.iter().rev().fold(0.0, |sum, &a| sum * t + a)
}

/// The only root in `[lo, hi]`, by bisection and, once it is faster, by Newton's method inside the bracket; `positive_before` is the
/// sign of the polynomial before the root.
#[expect(clippy::cast_precision_loss, reason = "a degree is a small number")]
fn bracketed(monomial: &[f64], [mut lo, mut hi]: [f64; 2], positive_before: bool) -> f64 {
    let slope: Vec<f64> = monomial.iter().enumerate().skip(1).map(|(j, &a)| a * j as f64).collect();
    let mut t = 0.5 * (lo + hi);
    // Newton's method needs a few steps; bisection alone would need one for each bit.
    for _ in 0..100 {
        let f = value(monomial, t);
        if f == 0.0 {
            return t;
        }
        if (0.0 < f) == positive_before {
            lo = t;
        } else {
            hi = t;
        }
        let newton = t - f / value(&slope, t);
        let next = if lo < newton && newton < hi { newton } else { 0.5 * (lo + hi) };
        if (next - t).abs() <= f64::EPSILON * hi.abs() {
            return next;
        }
        t = next;
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUNDING: f64 = 1e-13;

    /// Coefficients of `Π (t − r)`.
    fn with_roots(roots: &[f64]) -> Vec<f64> {
        let mut c = vec![1.0];
        for r in roots {
            let mut next = vec![0.0; c.len() + 1];
            for (j, a) in c.iter().enumerate() {
                next[j + 1] += a;
                next[j] -= r * a;
            }
            c = next;
        }
        c
    }

    #[test]
    fn sign_changes_are_the_odd_roots_inside() {
        let roots = [-0.5, 0.1, 0.125, 0.5, 0.9, 1.3];
        let found = sign_changes(&with_roots(&roots), 1.0);
        assert_eq!(found.len(), 4, "{found:?}");
        for (found, root) in found.iter().zip(&roots[1..]) {
            assert!((found - root).abs() < ROUNDING, "{found} for {root}");
        }
        assert_eq!(sign_changes(&with_roots(&[0.3, 0.3]), 1.0), Vec::<f64>::new());
    }

    /// A root at the position where an interval is halved, to rounding: it is found there whatever signs the two ways of computing
    /// give.
    #[test]
    fn a_root_where_an_interval_is_halved_is_found_there() {
        for i in 1..=2000_u32 {
            let width = 0.371 * f64::from(i) / 7.0;
            let middle = 0.5 * width;
            // (t − m)(k m² − (t − m)²), with or without roots next to the middle.
            for k in [-0.3, 0.11, 0.37] {
                let c = k * middle * middle;
                let cubed = middle * middle * middle;
                let p = [cubed - c * middle, c - 3.0 * middle * middle, 3.0 * middle, -1.0];
                let found = sign_changes(&p, width);
                assert_eq!(found.len(), if k < 0.0 { 1 } else { 3 }, "{found:?} for {p:?}");
                let inner = found[found.len() / 2];
                assert!((inner - middle).abs() <= ROUNDING * width, "{inner} for {middle}: {p:?}");
            }
        }
    }

    #[test]
    fn the_least_value_is_found_or_proved_harmless() {
        // (t − 0.3)² − 0.01 has its least value −0.01 at 0.3.
        let p = [0.08, -0.6, 1.0];
        let (at, least) = lowest_below(&p, 1.0, -1e-12).expect("it is negative between 0.2 and 0.4");
        assert!((at - 0.3).abs() < 0.01 && (least + 0.01).abs() < 1e-4, "{least} at {at}");
        assert_eq!(lowest_below(&[0.0901, -0.6, 1.0], 1.0, 0.0), None);
        assert_eq!(lowest_below(&[0.0, 0.0, 0.0, 1.0, -0.5], 1.0, 0.0), None, "a triple root at the end");
    }
}
