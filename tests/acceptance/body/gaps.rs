//! Gaps that mean no ground, freedoms that are stiff beside soft ones: nothing is certified that is off, in clearance, force or energy.

use palkki::body::proof::{Brought, prove};
use palkki::body::{Body, Kind, Verdict};
use palkki::qp::Profile;
use palkki::route::{Solver, Status};
use palkki::verdict::EXACT;
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::number::Number as _;
use palkki_evidence::few::{Few, State};
use palkki_evidence::random::{Random, sample_of};

/// Rounding of one number of the answer.
const ROUNDED: f64 = 2.0 * f64::EPSILON;

/// What is right, and the largest of each kind.
struct Right {
    state: State,
    /// Displacement, force and energy.
    sizes: [RBig; 3],
}

fn largest(values: &[RBig]) -> RBig {
    values.iter().map(RBig::magnitude).fold(RBig::zero(), |most, value| if most < value { value } else { most })
}

/// The first that is not zero, or one.
fn first(sizes: [RBig; 2]) -> RBig {
    sizes.into_iter().find(|size| RBig::zero() < *size).unwrap_or_else(|| RBig::whole(1))
}

impl Right {
    fn of(few: &Few, guess: &[usize]) -> Self {
        let state = few.solution(guess);
        let free = few.touching(&[]).expect("definite");
        let load: Vec<RBig> = few.load.iter().copied().map(RBig::of).collect();
        let sizes = [
            first([largest(&state.displacement), largest(&free.displacement)]),
            first([largest(&state.force), largest(&load)]),
            first([state.energy.magnitude(), free.energy.magnitude()]),
        ];
        Self { state, sizes }
    }

    /// What is wrong with displacements, forces and energy that are called certified.
    fn flaw(&self, displacement: Option<&[RBig]>, force: &[RBig], energy: &RBig) -> Option<String> {
        let apart = |a: &[RBig], b: &[RBig]| largest(&a.iter().zip(b).map(|(a, b)| a.minus(b)).collect::<Vec<_>>());
        let State { displacement: own, force: own_force, energy: own_energy } = &self.state;
        let offs = [
            displacement.map_or(RBig::zero(), |displacement| apart(displacement, own)),
            apart(force, own_force),
            energy.minus(own_energy).magnitude(),
        ];
        let shares = offs.iter().zip(&self.sizes).map(|(off, size)| off.over(size).to_double());
        let wrong = ["displacement", "force", "energy"]
            .into_iter()
            .zip(shares)
            .find(|(_, share)| EXACT * (1.0 + 1e-9) < *share);
        wrong.map(|(what, share)| format!("{what} is off by {share:e} of the largest"))
    }
}

/// The state of some clearances; where a gap is so large that no displacement can be told from them, there is no force.
fn stated(few: &Few, right: &Right, clearance: &[f64]) -> State {
    let told = |i: usize| {
        let (gap, v) = (few.gap[i], &right.state.displacement[i]);
        let told = gap.is_finite().then(|| RBig::of(gap).minus(&RBig::of(clearance[i])))?;
        let is_near = gap.abs() <= 1e6 * right.sizes[0].to_double();
        let off = told.minus(v).magnitude().to_double();
        (is_near || ROUNDED * gap.abs() < off).then_some((i, told))
    };
    let (held, places): (Vec<usize>, Vec<RBig>) = (0..clearance.len()).filter_map(told).unzip();
    few.held_at(&held, &places).expect("definite")
}

/// Lists of forces that are wrong, and one that is right.
fn forged(random: &mut Random, right: &[f64], load: &[f64]) -> Vec<Vec<f64>> {
    let at = random.below(right.len());
    let most = right.iter().chain(load).fold(0.0_f64, |most, p| most.max(p.abs()));
    let amount = libm::pow(10.0, random.between(-9.0, 0.0));
    let changed =
        |change: &dyn Fn(usize, f64) -> f64| right.iter().enumerate().map(|(i, p)| change(i, *p)).collect::<Vec<_>>();
    vec![
        right.to_vec(),
        vec![0.0; right.len()],
        changed(&|i, p| if i == at { 0.0 } else { p }),
        changed(&|_, p| p * (1.0 + amount)),
        changed(&|i, p| if i == at { p + amount * most } else { p }),
        changed(&|i, p| if i == at { p - amount * most } else { p }),
        load.iter().map(|q| q.max(0.0)).collect(),
    ]
}

/// Of clearances, each freedom by its own gap and displacement.
fn forged_clearances(random: &mut Random, right: &[f64], gap: &[f64]) -> Vec<Vec<f64>> {
    let at = random.below(right.len());
    let amount = libm::pow(10.0, random.between(-9.0, 0.0));
    let most = right.iter().chain(gap).filter(|h| **h < 1e6).fold(0.0_f64, |most, h| most.max(h.abs()));
    let changed =
        |change: &dyn Fn(usize, f64) -> f64| right.iter().enumerate().map(|(i, h)| change(i, *h)).collect::<Vec<_>>();
    vec![
        right.to_vec(),
        vec![0.0; right.len()],
        gap.to_vec(),
        changed(&|i, h| if i == at { h + amount * most } else { h }),
        changed(&|_, h| h * (1.0 + amount)),
        changed(&|i, h| if i == at { h - amount * amount * most } else { h }),
    ]
}

/// A thousand bodies of two to five freedoms, by every solver, and answers that are forged: against the solution in fractions.
#[test]
fn nothing_is_certified_that_is_off() {
    let mut random = Random::new(46);
    let bodies = sample_of(1000);
    let (mut solved, mut brought, mut right_ones, mut refused) = (0, 0, [0; 2], 0);
    for case in 0..bodies {
        let few = Few::random(&mut random);
        let body = few.body();
        let own = body.run(Solver::ActiveSet, 0.0);
        let [clearance, force] = body.clearance_and_force(&own);
        let pressed: Vec<usize> = (0..force.len()).filter(|i| 0.0 < force[*i]).collect();
        let right = Right::of(&few, &pressed);
        let proof =
            prove(&body, own.x.iter().map(|x| 0.0 < *x)).unwrap_or_else(|error| panic!("{case}: {error}, {few:?}"));
        for solver in Solver::ALL {
            let answer = body.run(solver, 1e-10);
            let verdict = Verdict::new(Ok(proof.errors(&body, &answer)), EXACT, answer.run.reports_success);
            let is_own = solver == Solver::ActiveSet;
            solved += usize::from(is_own && verdict.status == Status::Certified);
            if verdict.status == Status::Certified {
                let [clearance, force] = body.clearance_and_force(&answer);
                let force: Vec<RBig> = force.iter().copied().map(RBig::of).collect();
                let State { displacement, .. } = stated(&few, &right, &clearance);
                let flaw = right.flaw(Some(&displacement), &force, &RBig::of(body.energy(&answer)));
                assert_eq!(flaw, None, "{case}, {solver}: {few:?}");
            }
        }
        let nearest = |values: &[RBig]| values.iter().map(RBig::to_double).collect::<Vec<_>>();
        for (k, list) in forged(&mut random, &nearest(&right.state.force), &few.load).into_iter().enumerate() {
            let (_, errors) = proof.judge(&body, &Brought::Force(list.clone())).expect("definite");
            let verdict = Verdict::new(Ok(errors), EXACT, true);
            brought += 1;
            if verdict.status == Status::Certified {
                let force: Vec<RBig> = list.iter().copied().map(RBig::of).collect();
                let State { displacement, energy, .. } = few.under(&force).expect("definite");
                assert_eq!(
                    right.flaw(Some(&displacement), &force, &energy),
                    None,
                    "{case}, forces {k} {list:?}: {few:?}"
                );
            }
            right_ones[0] += usize::from(k == 0 && verdict.status == Status::Certified);
            refused += usize::from(verdict.status != Status::Certified);
        }
        for (k, list) in forged_clearances(&mut random, &clearance, &few.gap).into_iter().enumerate() {
            let (_, errors) = proof.judge(&body, &Brought::Clearance(list.clone())).expect("definite");
            let verdict = Verdict::new(Ok(errors), EXACT, true);
            brought += 1;
            if verdict.status == Status::Certified {
                let State { displacement, force, energy } = stated(&few, &right, &list);
                assert_eq!(
                    right.flaw(Some(&displacement), &force, &energy),
                    None,
                    "{case}, clearances {k} {list:?}: {few:?}"
                );
            }
            right_ones[1] += usize::from(k == 0 && verdict.status == Status::Certified);
            refused += usize::from(verdict.status != Status::Certified);
        }
    }
    assert!(99 * bodies <= 100 * solved, "{solved} of {bodies}");
    assert!(2 * refused > brought, "{refused} of {brought} forged answers are refused");
    assert!(right_ones.iter().all(|right| 97 * bodies <= 100 * right), "{right_ones:?} right lists are certified");
}

/// Three springs in a row; the middle one has no ground, however that is written: 5500 on each of the others.
#[test]
fn a_gap_without_ground_stretches_nothing() {
    for far in [1.0, 1e9, 1e20, 1e30, 1e300, f64::INFINITY] {
        for kind in [Kind::Stiffness, Kind::Flexibility] {
            let entries = [2.0, -1.0, 2.0, -1.0, 2.0].map(|a| a * 1e6);
            let stiffness = [(0, 0), (1, 0), (1, 1), (2, 1), (2, 2)].into_iter().zip(entries);
            let matrix = match kind {
                Kind::Stiffness => Profile::of_entries(3, stiffness.map(|((i, j), a)| (i, j, a))),
                // The inverse of (2, −1) is ¼ (3, 2, 1; 2, 4, 2; 1, 2, 3).
                Kind::Flexibility => Profile::full(3, |i, j| {
                    let [i, j] = [i.min(j), i.max(j)].map(|k| f64::from(u8::try_from(k).expect("small")));
                    (i + 1.0) * (3.0 - j) / 4.0 * 1e-6
                }),
            };
            let body =
                Body::new(kind, matrix, None, vec![0.001, far, 0.001], vec![5000.0, 3000.0, 5000.0]).expect("definite");
            for solver in Solver::ALL {
                let answer = body.run(solver, 1e-12);
                let [clearance, force] = body.clearance_and_force(&answer);
                let witness = body.run(Solver::ActiveSet, 0.0);
                let proof = prove(&body, witness.x.iter().map(|x| 0.0 < *x)).expect("well conditioned");
                let verdict = Verdict::new(Ok(proof.errors(&body, &answer)), EXACT, true);
                let off = force
                    .iter()
                    .zip([5500.0, 0.0, 5500.0])
                    .map(|(p, right): (_, f64)| (p - right).abs())
                    .fold(0.0, f64::max);
                let certified = verdict.status == Status::Certified;
                assert!(!certified || off < 1e-6 * 5500.0, "{solver}, {far:e}: {force:?}");
                assert!(certified || solver != Solver::ActiveSet, "{solver}, {far:e}: {}", verdict.reason);
                assert!(
                    !certified
                        || (clearance[1] - (far - 0.0025)).abs() <= 1e-9
                        || clearance[1].total_cmp(&(far - 0.0025)).is_eq(),
                    "{far:e}"
                );
            }
        }
    }
}
