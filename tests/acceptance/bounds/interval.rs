//! Intervals against exact rationals: whatever is computed encloses what is meant.

use std::cmp::Ordering;

use dashu_ratio::RBig;
use palkki::certificate::Interval;
use proptest::prelude::*;

/// A finite number, exactly.
fn exact(value: f64) -> RBig {
    RBig::try_from(value).expect("a finite number")
}

/// True if `interval` has `value`; an end that is infinite is no bound.
fn holds(interval: Interval, value: &RBig) -> bool {
    let below = !interval.lo().is_finite() || exact(interval.lo()).cmp(value) != Ordering::Greater;
    let above = !interval.hi().is_finite() || exact(interval.hi()).cmp(value) != Ordering::Less;
    below && above
}

/// Numbers of all sizes whose products stay in range, and some awkward ones.
fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e3..1e3_f64,
        (-1e3..1e3_f64, -60..60_i32).prop_map(|(m, e)| m * f64::from(e).exp2()),
        Just(0.0),
        Just(1.0),
        Just(f64::EPSILON),
        Just(1.0 / 3.0),
    ]
}

proptest! {
    #[test]
    fn sums_products_and_quotients(a in numbers(), b in numbers(), c in numbers()) {
        let [x, y, z] = [a, b, c].map(Interval::exact);
        let [p, q, r] = [a, b, c].map(exact);
        prop_assert!(holds(x + y, &(&p + &q)));
        prop_assert!(holds(x - y, &(&p - &q)));
        prop_assert!(holds(x * y, &(&p * &q)));
        prop_assert!(holds((x * y - z) * x, &((&p * &q - &r) * &p)));
        prop_assert!(holds(x.square(), &(&p * &p)));
        if !q.is_zero() {
            prop_assert!(holds(x / y, &(&p / &q)));
            prop_assert!(holds((x + z) / y, &((&p + &r) / &q)));
        }
    }

    #[test]
    fn intervals_hold_what_is_in_them(a in numbers(), b in numbers(), c in numbers(), d in numbers(), s in 0.0..1.0_f64) {
        let (x, y) = (Interval::between(a.min(b), a.max(b)), Interval::between(c.min(d), c.max(d)));
        // Two numbers in them, kept inside against rounding.
        let inside = |i: Interval| (i.lo() + s * (i.hi() - i.lo())).clamp(i.lo(), i.hi());
        let (p, q) = (exact(inside(x)), exact(inside(y)));
        prop_assert!(holds(x + y, &(&p + &q)));
        prop_assert!(holds(x - y, &(&p - &q)));
        prop_assert!(holds(x * y, &(&p * &q)));
        prop_assert!(holds(x.square(), &(&p * &p)));
        if !q.is_zero() {
            prop_assert!(holds(x / y, &(&p / &q)));
        }
    }

    #[test]
    fn roots(a in 0.0..1e6_f64) {
        let root = Interval::exact(a).sqrt();
        prop_assert!(exact(root.lo()) * exact(root.lo()) <= exact(a));
        prop_assert!(exact(a) <= exact(root.hi()) * exact(root.hi()));
    }
}

/// `cos² + sin² = 1`, and what is known in closed form.
#[test]
fn cosines() {
    for k in -50..50 {
        let turns = Interval::exact(f64::from(k) / 12.0);
        let [cos, sin] = Interval::cos_sin(turns, Interval::ZERO);
        assert!((cos.square() + sin.square()).contains(1.0), "{k}/12 of a turn");
        assert!(cos.hi() - cos.lo() < 1e-13, "{k}/12 of a turn: {cos:?}");
    }
    for (turns, value) in [(0.0, 1.0), (0.25, 0.0), (0.5, -1.0), (1000.5, -1.0)] {
        let [cos, _] = Interval::cos_sin(Interval::exact(turns), Interval::ZERO);
        assert!(cos.contains(value), "{turns} turns: {cos:?}");
    }
    let [cos, _] = Interval::cos_sin(Interval::exact(1.0 / 6.0), Interval::ZERO);
    assert!(cos.lo() <= 0.5 && 0.5 <= cos.hi() + 1e-16, "{cos:?}");
}

#[test]
fn what_has_no_value_is_the_whole_line() {
    let (one, around) = (Interval::exact(1.0), Interval::around_zero(1.0));
    assert_eq!(one / around, Interval::WHOLE);
    assert_eq!(one / Interval::ZERO, Interval::WHOLE);
    assert_eq!(Interval::ZERO * Interval::WHOLE, Interval::WHOLE);
    assert_eq!(Interval::exact(f64::NAN), Interval::WHOLE);
    assert!((Interval::exact(f64::MAX) + Interval::exact(f64::MAX)).hi().is_infinite());
}
