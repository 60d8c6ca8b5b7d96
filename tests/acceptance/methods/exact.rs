//! The discrete problem without rounding: in fractions up to n = 999, in integers of hundreds of bits at n = 9999.
//!
//! The data of the paper are fractions, and so is the answer. The contact set comes from the route that is tested. That it is *the*
//! contact set is then proven: equilibrium, elasticity, (34) and (35) are checked at every node, without rounding or with all of it
//! counted in. `A` is positive definite, so there is no other optimum, and floating-point answers are compared with this one; those of
//! all routes on the grid of the paper in the report (`report/pages/bounds.md`).

use palkki::route::{Method, Solver};
use palkki::scene::{Foundation, Scene};
use palkki::state::Discretisation;
use palkki_evidence::authority::RBig;

use crate::scenes::{example, nodes, run, scene, uniform};
use palkki_evidence::authority::clapeyron::{Problem, Solution};
use palkki_evidence::authority::forward::Forward;
use palkki_evidence::authority::given::{self, example_over};
use palkki_evidence::authority::number::{Fixed, Number};

/// What is asked of the force route: so much at n = 29, and so much at n = 9999 and below.
const AT_29: f64 = 1e-14;
const AT_9999: f64 = 1e-11;

/// The contact set of a raw solution that is solved.
#[track_caller]
fn contact(raw: &palkki::Solution<()>) -> Vec<bool> {
    assert!(raw.solved, "the route is certified");
    nodes(raw).contact_force.iter().map(|p| 0.0 < *p).collect()
}

/// The exact answer on the contact set of a route, with proof that it is the optimum.
#[track_caller]
fn proven<T: Number>(problem: &Problem<T>, raw: &palkki::Solution<()>) -> Solution<T> {
    let contact = contact(raw);
    let (exact, optimal, exchanges) = problem.optimum(contact.clone()).expect("an optimum is found");
    assert_eq!(exchanges, 0, "(34), (35) hold on {contact:?}, and not on {optimal:?} only");
    exact
}

#[track_caller]
fn within<T: Number>(problem: &Problem<T>, exact: &Solution<T>, raw: &palkki::Solution<()>, tolerance: f64) {
    let errors = Forward::errors(problem, exact, &raw.state).expect("all values are numbers");
    for (what, error) in errors.all() {
        assert!(error <= tolerance, "{what} is off by {error:.1e}: {errors:?}");
    }
}

/// In fractions: proven, and every route within `tolerance`.
#[track_caller]
fn fractions(scene: &Scene, intervals: i64, tolerance: f64, depth: impl Fn(&RBig) -> RBig + Copy) {
    let grid = usize::try_from(intervals).expect("positive");
    for method in Method::ALL {
        let problem = example_over(intervals, method.discretisation(), depth);
        let raw = run(scene, method, Solver::ActiveSet, grid);
        let exact = proven(&problem, &raw);
        assert!(exact.uncertainty() == RBig::zero(), "nothing is rounded");
        within(&problem, &exact, &raw, tolerance);
    }
}

/// The exact answer for the example on the grid of the paper, and its first node in contact.
#[track_caller]
fn paper(method: Method) -> (Solution<RBig>, usize) {
    let problem = example_over(30, method.discretisation(), |_| RBig::whole(1));
    let exact = proven(&problem, &run(&example(), method, Solver::ActiveSet, 30));
    let first = (1..30).find(|&i| RBig::zero() < exact.contact_force[i]).expect("the example touches");
    (exact, first)
}

/// Half a unit of the ninth decimal, with which the numbers below are written out.
const PRINTED: f64 = 5e-10;

#[test]
fn the_first_contact_force_of_the_paper_is_a_fraction() {
    let (exact, node) = paper(Method::Force);
    assert_eq!(node, 7, "node 7, x = 7/3");
    assert_eq!(exact.contact_force[node], RBig::fraction(79_510_997, 69_626_256));
    // Nine decimals are asked for, and two are printed: 1,14.
    assert!((exact.contact_force[node].to_double() - 1.141_968_584).abs() < PRINTED);
}

#[test]
fn the_end_reaction_of_the_paper_grid_is_a_fraction() {
    let (exact, _) = paper(Method::Force);
    // With the load of half an interval on the support itself: q₀Δ/2 = 1/6.
    let reaction = exact.left_reaction(&RBig::fraction(1, 6));
    let value = reaction.to_double();
    assert!((value - 1.186_044_111).abs() < PRINTED, "{value}");
    // The rest of the balance, exactly: twice the reaction and the contact forces carry q₀ l = 10.
    let carried = exact.contact_force.iter().fold(RBig::zero(), |sum, p| sum + p);
    assert_eq!(&reaction + &reaction + carried, RBig::whole(10));

    let found = run(&example(), Method::Force, Solver::ActiveSet, 30).state.reactions;
    assert!((found.left - value).abs() < ROUNDING * value, "{}", found.left);
}

#[test]
fn the_first_contact_force_by_differences_is_what_is_asked() {
    let (exact, node) = paper(Method::Complementarity);
    assert_eq!(node, 7);
    assert!((exact.contact_force[node].to_double() - 1.191_071_429).abs() < PRINTED);
}

/// A few hundred units in the last place: sums over some hundred nodes, and one tridiagonal solve of condition number below ten.
const ROUNDING: f64 = 1e-13;

#[test]
fn the_paper_grid_in_fractions() {
    fractions(&example(), 30, AT_29, |_| RBig::whole(1));
}

#[test]
fn n_999_in_fractions() {
    fractions(&example(), 1000, AT_9999, |_| RBig::whole(1));
}

/// `u = 1/4 + 5/4 x − x²/8`: the contact carries a moment, the curvature of the dish times EI.
#[test]
fn n_999_over_a_dish_in_fractions() {
    let dish = Foundation::Polynomial { coefficients: vec![0.25, 1.25, -0.125] };
    fractions(&uniform(10.0, 500.0 / 384.0, 1.0, dish), 1000, AT_9999, |s| {
        let x = s.times(&RBig::whole(10));
        RBig::fraction(1, 4) + RBig::fraction(5, 4) * &x - RBig::fraction(1, 8) * &x * &x
    });
}

/// Flat ground at 1 with a ridge that rises to 1/2 at x = 4.
#[test]
fn n_999_over_a_ridge_in_fractions() {
    let points = [[0.0, 1.0], [3.0, 1.0], [4.0, 0.5], [5.0, 1.0], [10.0, 1.0]].to_vec();
    fractions(&uniform(10.0, 500.0 / 384.0, 1.0, Foundation::Polyline { points }), 1000, AT_9999, |s| {
        let from_ridge = s.times(&RBig::whole(10)).minus(&RBig::whole(4)).magnitude();
        let below = RBig::fraction(1, 2) + from_ridge.times(&RBig::fraction(1, 2));
        if below < RBig::whole(1) { below } else { RBig::whole(1) }
    });
}

/// The uncertainty of the integers has to be far below what is measured with them.
const CERTAIN: f64 = 1e-40;

/// In integers: proven, and the force route within `tolerance`.
#[track_caller]
fn integers(scene: &Scene, intervals: usize, tolerance: f64) {
    let problem = given::problem(scene, intervals, Discretisation::BeamElements).expect("no step");
    let raw = run(scene, Method::Force, Solver::ActiveSet, intervals);
    let exact = proven(&problem, &raw);
    assert!(exact.uncertainty().to_double() < CERTAIN, "{:e}", exact.uncertainty().to_double());
    within(&problem, &exact, &raw, tolerance);
}

#[test]
fn n_9999_in_integers() {
    integers(&example(), 10_000, AT_9999);
}

/// Residual times condition number promises four digits at most; the answer has nearly all that a number holds.
#[test]
fn the_active_set_has_an_error_of_rounding_where_the_condition_number_promises_nothing() {
    const INTERVALS: usize = 1000;
    for method in Method::ALL {
        let problem = given::problem(&example(), INTERVALS, method.discretisation()).expect("flat");
        let raw = run(&example(), method, Solver::ActiveSet, INTERVALS);
        let errors = Forward::errors(&problem, &proven(&problem, &raw), &raw.state).expect("numbers");
        let promised = raw.residual * method.condition(INTERVALS);
        assert!(1e-4 < promised, "{method}: {promised:.1e}");
        // A contact force near lift-off loses a factor n.
        assert!(errors.contact_force <= 3e-13, "{method}: {errors:?}");
        assert!(errors.reaction <= 3e-14 && errors.deflection <= 3e-15, "{method}: {errors:?}");
    }
}

/// Point contacts of a wave, the kinks of a survey, and a point load.
#[test]
fn uneven_foundations_in_integers() {
    for name in ["wave", "survey", "hump", "kink"] {
        integers(&scene(name), 1000, AT_9999);
    }
}

/// Fractions and integers are two kinds of the same numbers.
#[test]
fn fractions_and_integers_agree() {
    let raw = run(&example(), Method::Force, Solver::ActiveSet, 30);
    let fractions = proven(&example_over(30, Discretisation::BeamElements, |_| RBig::whole(1)), &raw);
    let integers = proven(&given::problem(&example(), 30, Discretisation::BeamElements).expect("flat"), &raw);
    for i in 1..30 {
        let (p, q) = (fractions.contact_force[i].to_double(), integers.contact_force[i].to_double());
        // 500/384 is rounded once before it becomes a multiple of 2⁻²⁵⁶.
        assert!((p - q).abs() <= 4.0 * f64::EPSILON, "node {i}: {p} and {q}");
    }
    let pi = Fixed::pi();
    assert!(pi.to_double().to_bits() == std::f64::consts::PI.to_bits(), "π");
    // cos(π/3) = 1/2 to the last places.
    let half = pi.over(&Fixed::whole(3)).cosine().minus(&Fixed::fraction(1, 2)).magnitude();
    assert!(half.to_double() < 1e-70, "{:e}", half.to_double());
}

/// What is called proven must be refutable: the contact set of the example with one node more, or one less.
#[test]
fn another_contact_set_is_refused() {
    let raw = run(&example(), Method::Force, Solver::ActiveSet, 10_000);
    let problem = given::problem(&example(), 10_000, Discretisation::BeamElements).expect("flat");
    let contact = contact(&raw);
    let first = contact.iter().position(|touches| *touches).expect("the example touches");
    for other in [first - 1, first] {
        let mut changed = contact.clone();
        changed[other] = !changed[other];
        let refuted = problem.solve(&changed);
        assert!(!refuted.is_optimal(&changed), "node {}", other + 1);
        assert!(!refuted.wrong(&changed).is_empty(), "and it is said where");
    }
}
