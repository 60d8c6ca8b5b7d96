//! Intervals against exact rationals: whatever is computed encloses what is meant.

use std::cmp::Ordering;

use palkki::certificate::Interval;
use palkki_evidence::authority::RBig;
use palkki_evidence::random::Random;

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

fn contains(interval: Interval, value: f64) -> bool {
    interval.lo() <= value && value <= interval.hi()
}

/// A number of any size whose products stay in range, or an awkward one.
fn number(random: &mut Random) -> f64 {
    match random.below(8) {
        0 | 1 => random.between(-1e3, 1e3),
        2 | 3 => random.between(-1e3, 1e3) * random.between(-60.0, 60.0).round().exp2(),
        _ => random.pick(&[0.0, 1.0, f64::EPSILON, 1.0 / 3.0]),
    }
}

/// Random cases of each test.
const CASES: usize = 500;

#[test]
fn sums_products_and_quotients() {
    let mut random = Random::new(1);
    for _ in 0..CASES {
        let numbers = [(); 3].map(|()| number(&mut random));
        let [x, y, z] = numbers.map(Interval::exact);
        let [p, q, r] = numbers.map(exact);
        assert!(holds(x + y, &(&p + &q)), "{numbers:?}");
        assert!(holds(x - y, &(&p - &q)), "{numbers:?}");
        assert!(holds(x * y, &(&p * &q)), "{numbers:?}");
        assert!(holds((x * y - z) * x, &((&p * &q - &r) * &p)), "{numbers:?}");
        assert!(holds(x.square(), &(&p * &p)), "{numbers:?}");
        if !q.is_zero() {
            assert!(holds(x / y, &(&p / &q)), "{numbers:?}");
            assert!(holds((x + z) / y, &((&p + &r) / &q)), "{numbers:?}");
        }
    }
}

#[test]
fn intervals_hold_what_is_in_them() {
    let mut random = Random::new(2);
    for _ in 0..CASES {
        let [a, b, c, d] = [(); 4].map(|()| number(&mut random));
        let s = random.between(0.0, 1.0);
        let (x, y) = (Interval::between(a.min(b), a.max(b)), Interval::between(c.min(d), c.max(d)));
        // Two numbers in them, kept inside against rounding.
        let inside = |i: Interval| (i.lo() + s * (i.hi() - i.lo())).clamp(i.lo(), i.hi());
        let (p, q) = (exact(inside(x)), exact(inside(y)));
        assert!(holds(x + y, &(&p + &q)), "{x:?} {y:?}");
        assert!(holds(x - y, &(&p - &q)), "{x:?} {y:?}");
        assert!(holds(x * y, &(&p * &q)), "{x:?} {y:?}");
        assert!(holds(x.square(), &(&p * &p)), "{x:?}");
        if !q.is_zero() {
            assert!(holds(x / y, &(&p / &q)), "{x:?} {y:?}");
        }
    }
}

#[test]
fn roots() {
    let mut random = Random::new(3);
    for _ in 0..CASES {
        let a = random.between(0.0, 1e6);
        let root = Interval::exact(a).sqrt();
        assert!(exact(root.lo()) * exact(root.lo()) <= exact(a), "{a}");
        assert!(exact(a) <= exact(root.hi()) * exact(root.hi()), "{a}");
    }
}

/// `cos² + sin² = 1`, and what is known in closed form.
#[test]
fn cosines() {
    /// Some hundred roundings outwards of numbers of size one: the bounds hold, and are bounds worth having.
    const WIDTH: f64 = 1e-13;
    for k in -50..50 {
        let turns = Interval::exact(f64::from(k) / 12.0);
        let [cos, sin] = Interval::cos_sin(turns, Interval::ZERO);
        assert!(contains(cos.square() + sin.square(), 1.0), "{k}/12 of a turn");
        assert!(cos.hi() - cos.lo() < WIDTH, "{k}/12 of a turn: {cos:?}");
    }
    for (turns, value) in [(0.0, 1.0), (0.25, 0.0), (0.5, -1.0), (1000.5, -1.0)] {
        let [cos, _] = Interval::cos_sin(Interval::exact(turns), Interval::ZERO);
        assert!(contains(cos, value), "{turns} turns: {cos:?}");
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

/// A sum with zero and a product with zero are exact: coefficients that vanish cost nothing. The least number is not zero.
#[test]
fn zero_is_exact_and_nothing_else_is() {
    let three = Interval::exact(3.0);
    for zero in [Interval::ZERO, Interval::exact(-0.0)] {
        assert!(zero.is_zero());
        for exact in [zero * three, three * zero, zero.square(), zero.sqrt()] {
            assert_eq!(exact, Interval::ZERO);
        }
        for exact in [zero + three, three + zero, three - zero] {
            assert_eq!(exact, three);
        }
    }
    let least = f64::from_bits(1);
    for number in [least, -least, 1.0] {
        assert!(!Interval::exact(number).is_zero(), "{number:e}");
    }
    assert!(!Interval::between(0.0, least).is_zero() && !Interval::between(-least, 0.0).is_zero());
    // Zero times no bound is no bound.
    for open in [Interval::between(1.0, f64::INFINITY), Interval::between(f64::NEG_INFINITY, 1.0)] {
        assert!(!open.is_finite());
        assert_eq!(Interval::ZERO * open, Interval::WHOLE);
        assert_eq!(open * Interval::ZERO, Interval::WHOLE);
    }
    assert!(three.is_finite());
}

/// So are a number less itself and zero over a number; two intervals that are equal are no number.
#[test]
fn differences_and_quotients_that_vanish_are_exact() {
    let least = f64::from_bits(1);
    for number in [1.0, -1.0 / 3.0, f64::MAX, least].map(Interval::exact) {
        assert_eq!(number - number, Interval::ZERO, "{number:?}");
        assert_eq!(Interval::ZERO / number, Interval::ZERO, "{number:?}");
        assert_eq!(Interval::exact(0.0) - number, -number);
    }
    let (one, wide) = (Interval::exact(1.0), Interval::between(1.0, 2.0));
    let next = Interval::exact(1.0_f64.next_up());
    for (difference, [from, to]) in
        [(wide - wide, [-1.0, 1.0]), (one - wide, [-1.0, 0.0]), (next - one, [f64::EPSILON; 2])]
    {
        assert!(contains(difference, from) && contains(difference, to), "{difference:?}");
    }
    for open in [Interval::exact(f64::INFINITY), Interval::exact(f64::NAN)] {
        assert_eq!(open - open, Interval::WHOLE);
    }
    assert_eq!(Interval::ZERO / Interval::ZERO, Interval::WHOLE);
    assert!(!(Interval::between(0.0, least) / one).is_zero());
}
