//! The matrices against each other, against (26), against beam formulas; structured solves against dense ones.

use nalgebra::{DMatrix, DVector};
use palkki::adaptive::observed_order;
use palkki::methods::{Discrete, Method, flexibility};
use palkki::qp::{FreeSet, Qp};
use palkki::scene::{Foundation, Scene};
use palkki_evidence::compare;
use palkki_evidence::paper::claims::energy_methods::{dense, explicit};
use palkki_evidence::random::Random;

use crate::scenes::{apart, example, largest, report, uniform};

fn discrete(scene: &Scene, intervals: usize) -> Discrete {
    let scaled = scene.scaled().expect("numbers in range");
    Discrete::new(&scaled.scene, intervals).expect("enough intervals")
}

/// Rounding of `K C` per unit of the condition number, which is about `n⁴/10`: a few units in the last place.
fn product_rounding(intervals: usize) -> f64 {
    let n = f64::from(u32::try_from(intervals).expect("a few hundred"));
    f64::EPSILON * n * n * n * n
}

#[test]
fn stiffness_and_flexibility_are_inverse() {
    for intervals in [2, 3, 4, 10, 30, 100] {
        let discrete = discrete(&example(), intervals);
        let k = dense(Method::Displacement.qp(&discrete).as_ref());
        let c = dense(Method::Force.qp(&discrete).as_ref());
        let n = intervals - 1;
        let error = (k * c - DMatrix::identity(n, n)).amax();
        assert!(error <= product_rounding(intervals), "{intervals} intervals: K C − I has an entry of {error:.1e}");
    }
}

/// Six multiplications and a few additions on each side.
const FEW_OPERATIONS: f64 = 1e-14;

#[test]
fn eq_26_is_the_deflection_under_a_unit_force() {
    let (l, ei) = (7.0, 3.0);
    for n in [1_u32, 2, 5, 29, 99] {
        let place = |i: u32| l * f64::from(i) / f64::from(n + 1);
        for i in 1..=n {
            for j in 1..=n {
                // v(x) = b x (l² − b² − x²) / (6 EI l) for x ≤ a = l − b.
                let (x, a) = (place(i.min(j)), place(i.max(j)));
                let b = l - a;
                let v = b * x * (l * l - b * b - x * x) / (6.0 * ei * l);
                let c = flexibility(l, ei, n as usize, i as usize, j as usize);
                // The formula with b subtracts numbers of size l²: its own rounding is measured by that.
                let size = b * x * l / (6.0 * ei);
                assert!((c - v).abs() <= FEW_OPERATIONS * size, "n = {n}, c_{i},{j} = {c} and not {v}");
            }
        }
    }
}

#[test]
fn the_force_method_stores_eq_26() {
    let scene = uniform(1.5, 1.25, 1.0, Foundation::Flat { depth: 0.01 });
    for intervals in [2, 7, 30] {
        let discrete = discrete(&scene, intervals);
        let c = dense(Method::Force.qp(&discrete).as_ref());
        for ((i, j), entry) in c
            .row_iter()
            .enumerate()
            .flat_map(|(i, r)| r.iter().enumerate().map(|(j, e)| ((i, j), *e)).collect::<Vec<_>>())
        {
            let expected = flexibility(1.5, 1.25, intervals - 1, i + 1, j + 1);
            assert!((entry - expected).abs() <= FEW_OPERATIONS * expected, "c_{},{}", i + 1, j + 1);
        }
    }
}

/// The slope over four halvings; the next term of the error is Δ²(kπ/l)²/40 of the first, one per cent on the coarsest grid.
const ORDER_SLACK: f64 = 0.02;

/// On `v = sin(kπx/l)`, which has `v = v'' = 0` at both ends, `A v → EI v''''` with order 2 up to the nodes beside the supports.
#[test]
fn the_difference_operator_is_of_second_order() {
    for wave in [1.0, 2.0, 3.0] {
        let errors: Vec<(f64, f64)> = [32_u32, 64, 128, 256]
            .iter()
            .map(|&intervals| {
                let discrete = discrete(&example(), intervals as usize);
                let length = discrete.spacing * f64::from(intervals);
                let number = wave * std::f64::consts::PI / length;
                let v: Vec<f64> = (1..intervals).map(|i| (number * discrete.spacing * f64::from(i)).sin()).collect();
                let a = Method::Complementarity.qp(&discrete).matrix();
                let fourth = discrete.stiffness * number * number * number * number;
                let error = compare::largest((0..v.len()).map(|i| a.row_times(i, &v) / fourth - v[i]));
                (discrete.spacing, error)
            })
            .collect();
        let order = observed_order(&errors);
        assert!((order - 2.0).abs() < ORDER_SLACK, "k = {wave}: observed order {order:.3}");
    }
}

/// `Cholesky` on a dense face against the structured solve, in units of the sizes: what the condition number of the dense
/// matrix, up to 10⁵ at 24 intervals, leaves of 16 digits.
const DENSE: f64 = 1e-9;

/// Where a face has next to no free variables, the numbers on it may all be next to nothing; they are measured by this.
const LEAST: f64 = 1e-3;

#[test]
fn structured_solves_agree_with_dense_ones_on_any_face() {
    let mut random = Random::new(26);
    for (name, scene) in report() {
        for method in Method::ALL {
            let discrete = discrete(&scene, 24);
            let qp = method.qp(&discrete);
            let sizes = qp.sizes();
            let other = explicit(qp.as_ref());
            for share in [0.0, 0.2, 0.5, 0.8, 1.0] {
                let free: FreeSet = (0..23).map(|_| random.between(0.0, 1.0) < share).collect();
                let a = qp.stationary(&free).expect("a definite face");
                let b = other.stationary(&free).expect("a definite face");
                let bound = |values: &[f64]| DENSE * largest(values).max(LEAST);
                let scale = |values: &[f64], size: f64| values.iter().map(|v| v / size).collect::<Vec<_>>();
                let (x, y) = (scale(&a.x, sizes.x), scale(&b.x, sizes.x));
                assert!(apart(&x, &y) <= bound(&y), "{name} {method}: x differs by {:.1e}", apart(&x, &y));
                let (g, h) = (scale(&a.gradient, sizes.gradient), scale(&b.gradient, sizes.gradient));
                assert!(apart(&g, &h) <= bound(&h), "{name} {method}: g differs by {:.1e}", apart(&g, &h));
                for (i, free) in free.iter().enumerate() {
                    let held = if free { a.gradient[i] } else { a.x[i] };
                    assert!(held.abs() <= DENSE * if free { sizes.gradient } else { sizes.x }, "{name} {method} {i}");
                }
            }
        }
    }
}

#[test]
fn condition_numbers_are_quotients_of_eigenvalues() {
    for intervals in [2, 3, 10, 30, 60] {
        let discrete = discrete(&example(), intervals);
        for method in Method::ALL {
            let expected = method.condition(intervals);
            let eigenvalues = dense(method.qp(&discrete).as_ref()).symmetric_eigenvalues();
            let found = eigenvalues.max() / eigenvalues.min();
            // The least eigenvalue has lost as many digits as the condition number has.
            let rounding = FEW_OPERATIONS * (1.0 + expected);
            assert!((found / expected - 1.0).abs() <= rounding, "{method}, {intervals}: {found:e} and {expected:e}");
        }
    }
}

#[test]
fn condition_numbers_grow_with_the_fourth_power() {
    /// `λ ~ 1/N²` up to `(π/N)²`, 10⁻⁷ on the coarser grid, a few times over.
    const NEXT_TERM: f64 = 1e-6;
    for method in Method::ALL {
        let growth = method.condition(100_000) / method.condition(10_000);
        assert!((growth / 1e4 - 1.0).abs() <= NEXT_TERM, "{method}: {growth}");
    }
}

#[test]
fn eq_33_is_the_product_with_the_matrix() {
    let mut random = Random::new(33);
    for (name, scene) in report() {
        for method in Method::ALL {
            let discrete = discrete(&scene, 24);
            let qp = method.qp(&discrete);
            let sizes = qp.sizes();
            let x: Vec<f64> = (0..23).map(|_| sizes.x * random.between(-1.0, 1.0)).collect();
            let product = dense(qp.as_ref()) * DVector::from_column_slice(&x);
            let expected: Vec<f64> = product.iter().zip(qp.linear()).map(|(ax, b)| ax - b).collect();
            // Cancellation is measured by the largest term of the sum, |A| |x|.
            let terms = dense(qp.as_ref()).abs() * DVector::from_column_slice(&x).abs();
            let size = terms.amax() + largest(&qp.linear());
            let error = apart(&qp.gradient(&x), &expected) / size;
            assert!(error <= FEW_OPERATIONS * 23.0, "{name} {method}: gradient off by {error:.1e}");
        }
    }
}
