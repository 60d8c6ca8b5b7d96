//! A witness that is wrong costs sharpness and never truth. The truth is none of beam theory's: fractions where the beam touches
//! corners only, closed forms in fractions and in integers of 256 binary places where it lies on the ground.

use palkki::certificate::{Certificate, Judged, certify};
use palkki::route::{Method, Solver};
use palkki::scene::{Foundation, Scene};
use palkki::state::{Contact, Nodes};
use palkki_evidence::authority::RBig;
use palkki_evidence::faults::every_contact_fault;

use super::SOME;
use crate::scenes::{nodes, run, uniform};
use palkki_evidence::authority::number::{Fixed, Number};
use palkki_evidence::random::Random;

/// The true deflection and energy of a scene.
struct Truth<T> {
    deflection: Box<dyn Fn(&T) -> T>,
    energy: T,
    reactions: [T; 2],
    /// Its contacts, and what their places may be off by as numbers of 64 bits.
    contacts: Vec<Contact>,
}

/// The cubic between two nodes, `v₀ r + v₁ s + Δ²/(6 EI) (M₀ r (1 − r²) + M₁ s (1 − s²))` with `r = 1 − s`.
fn cubic<T: Number>(scene: &Scene, given: &Nodes, x: &T) -> T {
    let at = |i: usize| match i.checked_sub(1) {
        None => [0.0; 3],
        Some(k) if k < given.x.len() => [given.x[k], given.deflection[k], given.moment[k]],
        Some(_) => [scene.beam().length(), 0.0, 0.0],
    };
    let after = given.x.iter().take_while(|node| T::of(**node) <= *x).count();
    let ([a, v0, m0], [b, v1, m1]) = (at(after).map(T::of), at(after + 1).map(T::of));
    let width = b.minus(&a);
    let s = x.minus(&a).over(&width);
    let one = T::whole(1);
    let r = one.minus(&s);
    let bent = |m: &T, z: &T| m.times(z).times(&one.minus(&z.times(z)));
    let factor = width.times(&width).over(&T::whole(6).times(&T::of(scene.beam().bending_stiffness())));
    v0.times(&r).plus(&v1.times(&s)).plus(&factor.times(&bent(&m0, &r).plus(&bent(&m1, &s))))
}

/// What is said is true, without any slack.
#[track_caller]
fn holds<T: Number>(what: &str, scene: &Scene, given: &Nodes, said: &Certificate, truth: &Truth<T>) {
    let [lower, upper, error] = [said.energy_lower, said.energy_upper, said.deflection_error].map(T::of);
    assert!(said.deflection_error.is_finite() && said.energy_lower.is_finite(), "{what}: there is always a bound");
    assert!(lower <= truth.energy && truth.energy <= upper, "{what}: J* = {} for {said:?}", truth.energy.to_double());
    for x in (1..20).map(|k| T::of(scene.beam().length()).times(&T::fraction(k, 20))) {
        let off = cubic(scene, given, &x).minus(&(truth.deflection)(&x)).magnitude();
        assert!(off <= error, "{what}: off by {} at {} for {said:?}", off.to_double(), x.to_double());
    }
    for (bracket, reaction) in said.reactions.iter().copied().zip(&truth.reactions) {
        let holds = bracket.is_none_or(|[least, most]| T::of(least) <= *reaction && *reaction <= T::of(most));
        assert!(holds, "{what}: a reaction of {} for {said:?}", reaction.to_double());
    }
}

/// An answer on a grid, from the right witness and from one with every fault in it.
#[track_caller]
fn check<T: Number>(what: &str, scene: &Scene, truth: &Truth<T>) {
    let raw = run(scene, Method::Force, Solver::ActiveSet, 20);
    let given = nodes(&raw);
    let said = |witness: &[Contact]| certify(scene, Judged::Nodes(given), witness).expect("the scene can be scaled");
    let right = said(&truth.contacts);
    assert!(right.contacts_proven, "{what}: {right:?}");
    holds(what, scene, given, &right, truth);
    holds(&format!("{what}, no witness"), scene, given, &said(&[]), truth);
    holds(&format!("{what}, its own contacts"), scene, given, &said(&raw.state.contacts), truth);
    for (fault, size, broken) in every_contact_fault(&truth.contacts, scene.beam().length(), &SOME) {
        holds(&format!("{what}, {}, {size:e}", fault.name), scene, given, &said(&broken), truth);
    }
}

/// A symmetrical beam on flat ground with lift-off points at the distance `a`, where `a⁴ = 24 EI u/q`:
///
/// ```text
/// u − v = q s³ (2a − s)/24 EI  at the distance s from the lift-off point,   J* = −q u (l − 4a/5),   T = q a/2
/// ```
fn lying<T: Number + 'static>(scene: &Scene, a: T, [q, u, ei, l]: [f64; 4]) -> Truth<T> {
    let [load, depth, stiffness, length] = [q, u, ei, l].map(T::of);
    let at = a.to_double();
    let contacts = vec![Contact { from: at, to: l - at, force: 0.0, end_forces: None }];
    assert!(scene.beam().length() > 2.0 * at, "the beam lies on the ground");
    let energy = T::zero().minus(&load.times(&depth).times(&length.minus(&a.times(&T::fraction(4, 5)))));
    let reaction = load.times(&a).over(&T::whole(2));
    let reactions = [reaction.clone(), reaction];
    let deflection = move |x: &T| {
        let x = if length < x.plus(x) { length.minus(x) } else { x.clone() };
        if a <= x {
            return depth.clone();
        }
        let s = a.minus(&x);
        let twice = a.plus(&a).minus(&s);
        let clear = load.times(&s).times(&s).times(&s).times(&twice);
        depth.minus(&clear.over(&T::whole(24).times(&stiffness)))
    };
    Truth { deflection: Box::new(deflection), energy, reactions, contacts }
}

/// `a = 2`: `EI = q a⁴/24 u` is a number of 64 bits, and everything is a fraction.
#[test]
fn on_flat_ground_in_fractions() {
    let numbers @ [q, u, ei, l] = [3.0, 0.5, 4.0, 10.0];
    let scene = uniform(l, ei, q, Foundation::Flat { depth: u });
    check("flat", &scene, &lying(&scene, RBig::whole(2), numbers));
}

/// The example of the paper: `a = (24 EI u/q)^¼` by Newton's method in integers of 256 binary places.
#[test]
fn on_flat_ground_in_high_precision() {
    let numbers @ [q, u, ei, l] = [1.0, 1.0, 500.0 / 384.0, 10.0];
    let scene = uniform(l, ei, q, Foundation::Flat { depth: u });
    let [load, depth, stiffness] = [q, u, ei].map(Fixed::of);
    let fourth = Fixed::whole(24).times(&stiffness).times(&depth).over(&load);
    let mut a = Fixed::of((24.0 * ei * u / q).sqrt().sqrt());
    for _ in 0..6 {
        let cube = a.times(&a).times(&a);
        a = a.minus(&cube.times(&a).minus(&fourth).over(&Fixed::whole(4).times(&cube)));
    }
    check("the example", &scene, &lying(&scene, a, numbers));
}

/// A beam under a uniform load above a polyline of which it touches some corners, in fractions: moments from the three-moment
/// equations, with `M = −EI v''` and slopes of chords `c`,
///
/// ```text
/// L₋ M₋ + 2 (L₋ + L₊) M + L₊ M₊ = 6 EI (c₋ − c₊) − q (L₋³ + L₊³)/4
/// p = (M₊ − M)/L₊ − (M − M₋)/L₋ + q (L₋ + L₊)/2
/// J* = −½ ∫ M²/EI dx − Σ p u
/// ```
///
/// None unless every force presses.
fn touching(scene: &Scene, points: &[[f64; 2]], touched: &[usize]) -> Option<Truth<RBig>> {
    let exact = RBig::of;
    let (l, ei, q) = (scene.beam().length(), exact(scene.beam().bending_stiffness()), exact(scene.load().uniform()));
    let mut x = vec![RBig::zero()];
    let mut u = vec![RBig::zero()];
    x.extend(touched.iter().map(|&i| exact(points[i][0])));
    u.extend(touched.iter().map(|&i| exact(points[i][1])));
    x.push(exact(l));
    u.push(RBig::zero());
    let last = x.len() - 1;
    let width = |i: usize| &x[i + 1] - &x[i];
    let moments = three_moments(&x, &u, &ei, &q);
    let half = RBig::fraction(1, 2);
    let turn = |i: usize| (&moments[i + 1] - &moments[i]) / width(i);
    let force = |i: usize| turn(i) - turn(i - 1) + &q * (width(i - 1) + width(i)) * &half;
    let mut energy = RBig::zero();
    for i in 0..last {
        let (w, a, b) = (width(i), &moments[i], &moments[i + 1]);
        let c = &q * &w * &w * &half;
        let ends = (a * a + a * b + b * b) / RBig::whole(3);
        let square = ends + &c * (a + b) / RBig::whole(6) + &c * &c / RBig::whole(30);
        energy -= w * square / &ei * &half;
    }
    for (i, depth) in u.iter().enumerate().take(last).skip(1) {
        let p = force(i);
        if p < RBig::zero() {
            return None;
        }
        energy -= p * depth;
    }
    let reactions = [turn(0) + &q * width(0) * &half, &q * width(last - 1) * &half - turn(last - 1)];
    let contacts = touched.iter().map(|&i| Contact::at(points[i][0], 1.0)).collect();
    let deflection = move |at: &RBig| {
        let i = (1..last).take_while(|&i| x[i] <= *at).count();
        let w = &x[i + 1] - &x[i];
        let s = (at - &x[i]) / &w;
        let r = RBig::whole(1) - &s;
        let one = RBig::whole(1);
        // The cubic of the two moments, and q L⁴ s (1 − 2 s² + s³)/24 EI of the load.
        let bent = |m: &RBig, z: &RBig| m * z * (&one - z * z);
        let cubic = &w * &w / (RBig::whole(6) * &ei) * (bent(&moments[i], &r) + bent(&moments[i + 1], &s));
        let load =
            &q * &w * &w * &w * &w / (RBig::whole(24) * &ei) * &s * (&one - RBig::whole(2) * &s * &s + &s * &s * &s);
        &u[i] * &r + &u[i + 1] * &s + cubic + load
    };
    Some(Truth { deflection: Box::new(deflection), energy, reactions, contacts })
}

/// The moments over the places of contact and at both ends: elimination of the three diagonals, then backwards.
fn three_moments(x: &[RBig], u: &[RBig], ei: &RBig, q: &RBig) -> Vec<RBig> {
    let last = x.len() - 1;
    let width = |i: usize| &x[i + 1] - &x[i];
    let chord = |i: usize| (&u[i + 1] - &u[i]) / width(i);
    let cube = |v: RBig| &v * &v * &v;
    let mut rows: Vec<[RBig; 3]> = Vec::new();
    for i in 1..last {
        let [left, right] = [width(i - 1), width(i)];
        let bend = RBig::whole(6) * ei * (chord(i - 1) - chord(i));
        let load = q * (cube(left.clone()) + cube(right.clone())) / RBig::whole(4);
        let mut row = [RBig::whole(2) * (&left + &right), right, bend - load];
        if let Some([diagonal, above, known]) = rows.last() {
            let factor = &left / diagonal;
            row[0] = &row[0] - &factor * above;
            row[2] = &row[2] - &factor * known;
        }
        rows.push(row);
    }
    let mut moments = vec![RBig::zero(); last + 1];
    for i in (1..last).rev() {
        let [diagonal, above, known] = &rows[i - 1];
        moments[i] = (known - above * &moments[i + 1]) / diagonal;
    }
    moments
}

/// Whether a beam that is bent as in [`touching`] is above the polyline everywhere: on each segment the clearance is a
/// polynomial of the fourth degree, and its Bernstein coefficients, from five of its values, are not negative.
fn is_clear(points: &[[f64; 2]], truth: &Truth<RBig>) -> bool {
    // Inverse of the Bernstein basis of degree 4 at 0, ¼, ½, ¾, 1, in twelfths … exact.
    let values_to_coefficients = [
        [36, 0, 0, 0, 0],
        [-39, 144, -108, 48, -9],
        [26, -128, 240, -128, 26],
        [-9, 48, -108, 144, -39],
        [0, 0, 0, 0, 36],
    ];
    points.windows(2).all(|w| {
        let [[a, from], [b, to]] = [w[0], w[1]].map(|p| p.map(RBig::of));
        // Halves of halves: the coefficients come close to the values.
        (0..16).all(|part| {
            let clear: Vec<RBig> = (0..5)
                .map(|k| {
                    let s = RBig::fraction(4 * part + k, 64);
                    let x = &a + (&b - &a) * &s;
                    &from + (&to - &from) * &s - (truth.deflection)(&x)
                })
                .collect();
            values_to_coefficients.iter().all(|row| {
                let sum = row.iter().zip(&clear).fold(RBig::zero(), |sum, (&c, h)| sum + RBig::whole(c) * h);
                RBig::zero() <= sum
            })
        })
    })
}

/// Random polylines whose corners carry the beam: which of them is tried out, all subsets of them, and proven in fractions.
#[test]
fn on_corners_in_fractions() {
    let mut found = 0;
    for seed in 0..20 {
        let mut random = Random::new(0xc0_47e4 + seed);
        let count = 2 + random.below(3);
        let mut points = vec![[0.0, 1.0]];
        // Eighths, so that no point is on the line of two others by rounding.
        let eighths = |k: usize| f64::from(u32::try_from(k).unwrap_or(0)) / 8.0;
        points.extend((0..2 * count + 1).map(|k| {
            let depth = if k % 2 == 1 { 0.25 * eighths(random.below(8)) } else { 1.0 + eighths(random.below(8)) };
            [eighths(8 + 4 * k + random.below(3)), depth]
        }));
        let length = points[points.len() - 1][0] + 1.0;
        points.push([length, 1.0]);
        let stiffness = 0.5 + eighths(random.below(64));
        let ground = Foundation::Polyline { points: points.clone() };
        let scene = uniform(length, stiffness, 1.0 + eighths(random.below(16)), ground);
        let peaks: Vec<usize> = (0..count).map(|k| 2 + 2 * k).collect();
        let truth = (0..1_u32 << count).find_map(|mask| {
            let touched: Vec<usize> = (0..count).filter(|k| mask >> k & 1 == 1).map(|k| peaks[k]).collect();
            touching(&scene, &points, &touched).filter(|truth| is_clear(&points, truth))
        });
        // In the others the beam touches elsewhere too, or only just.
        if let Some(truth) = truth {
            check(&format!("corners {seed}"), &scene, &truth);
            found += 1;
        }
    }
    assert!(10 <= found, "{found} scenes are proven");
}

/// Of a list that is worse than none the bounds are those of the beam that touches nowhere, and the deflection that the list
/// makes is not theirs to judge.
#[test]
fn a_list_that_is_worse_than_none_is_not_judged() {
    let scene = uniform(10.0, 4.0, 3.0, Foundation::Flat { depth: 100.0 });
    let all = [Contact { from: 1.0, to: 9.0, force: 0.0, end_forces: None }];
    let said = certify(&scene, Judged::Witness, &all).expect("the scene can be scaled");
    let none = certify(&scene, Judged::Witness, &[]).expect("the scene can be scaled");
    assert!(none.contacts_proven && none.deflection_error <= 1e-9 * none.deflection, "{none:?}");
    assert!(said.deflection_error.is_infinite() && said.energy_upper <= none.energy_upper, "{said:?}");
}
