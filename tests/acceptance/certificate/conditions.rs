//! Each condition of the verdict, alone: an answer that meets all others loses the word, and for this reason.

use palkki::certificate::Certificate;
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Foundation, LinearLoad, Scene};
use palkki::theory::{self, Exact};
use palkki::verdict::{Demand, Refusal, Verdict};
use palkki::{Settings, Witness, solve_raw};
use palkki_evidence::draft::{Draft, Units};
use palkki_evidence::random;

/// Scenes of several kinds that beam theory solves and certifies.
fn certified() -> impl Iterator<Item = (Scene, Exact)> {
    let scenes = (0..60).map(|i| if i % 2 == 0 { random::scene(i) } else { random::on_lattice(i) });
    scenes.filter_map(|scene| {
        let exact = theory::solve(&scene).ok()?;
        let bends = 0.0 < exact.state.deflection.magnitude() && exact.state.energy < 0.0;
        (bends && of_exact(&scene, &exact).status == Status::Certified).then_some((scene, exact))
    })
}

fn of_exact(scene: &Scene, exact: &Exact) -> Verdict {
    Verdict::of_exact(scene, exact, &Demand::default())
}

/// Those scenes with their certificates.
fn certificates() -> Vec<Certificate> {
    let found: Vec<Certificate> =
        certified().filter_map(|(scene, exact)| of_exact(&scene, &exact).certificate).collect();
    assert!(40 < found.len(), "only {} of 60 are certified", found.len());
    found
}

/// The refusal of a certificate after a change; there is none before.
#[track_caller]
fn refused(certificate: &Certificate, change: impl FnOnce(&mut Certificate)) -> Refusal {
    let before = Verdict::of_forces(certificate.clone());
    assert_eq!((before.status, before.refusal), (Status::Certified, None), "{certificate:?}");
    let mut changed = certificate.clone();
    change(&mut changed);
    let verdict = Verdict::of_forces(changed);
    assert_eq!(verdict.status, Status::NotCertified, "{verdict}");
    verdict.refusal.expect("not certified for a reason")
}

#[test]
fn every_bound_is_a_number() {
    for c in certificates() {
        for wrong in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(refused(&c, |c| c.energy_lower = wrong), Refusal::Unbounded);
            assert_eq!(refused(&c, |c| c.energy_upper = wrong), Refusal::Unbounded);
            assert_eq!(refused(&c, |c| c.gap = wrong), Refusal::Unbounded);
            assert_eq!(refused(&c, |c| c.deflection_error = wrong), Refusal::Unbounded);
        }
    }
}

#[test]
fn bounds_do_not_contradict_each_other() {
    for c in certificates() {
        let contradicts = |refusal: Refusal| matches!(refusal, Refusal::Contradiction { .. });
        assert!(contradicts(refused(&c, |c| c.energy_upper = c.energy_lower.next_down())));
        assert!(contradicts(refused(&c, |c| c.gap = -f64::MIN_POSITIVE)));
        assert!(contradicts(refused(&c, |c| c.deflection_error = -f64::MIN_POSITIVE)));
    }
}

#[test]
fn the_error_is_a_tenth_of_the_deflection_at_most() {
    for c in certificates() {
        let too_large = refused(&c, |c| c.deflection_error = 0.100_001 * c.deflection);
        assert!(matches!(too_large, Refusal::Error { most: 0.1, .. }), "{too_large:?}");
        let mut just = c.clone();
        just.deflection_error = 0.099_999 * c.deflection;
        assert_eq!(Verdict::of_forces(just).status, Status::Certified);
    }
}

/// Of beam theory a millionth is asked, whatever is demanded: contacts that are moved by a thousandth of the beam are not enough, though
/// deflection and energy are those that they make, within what they prove.
#[test]
fn beam_theory_has_to_be_certain_to_a_millionth() {
    let mut refused = 0;
    for (scene, exact) in certified() {
        let mut moved = exact.clone();
        for contact in moved.state.contacts.iter_mut().filter(|c| c.from < c.to) {
            contact.from += 1e-3 * (contact.to - contact.from);
        }
        let verdict = of_exact(&scene, &moved);
        let least = |demand: f64| Verdict::of_exact(&scene, &moved, &Demand::of_error(demand));
        if let Some(Refusal::Error { share, most }) = verdict.refusal {
            assert!(most.to_bits() == 1e-6_f64.to_bits() && 1e-6 < share, "{verdict}");
            refused += usize::from(share < 0.1);
        }
        assert_ne!(least(0.1).status == Status::Certified, 1e-6 < verdict.largest_error(), "{verdict}");
        // And less, where less is demanded.
        let share = of_exact(&scene, &exact).error;
        if 0.0 < share {
            let verdict = Verdict::of_exact(&scene, &exact, &Demand::of_error(0.5 * share));
            assert!(matches!(verdict.refusal, Some(Refusal::Error { .. })), "{verdict}");
        }
    }
    assert!(5 < refused, "{refused} answers between a millionth and a tenth");
}

#[test]
fn beam_theory_meets_its_own_conditions() {
    for (scene, exact) in certified() {
        let mut unsolved = exact.clone();
        unsolved.solved = false;
        let verdict = of_exact(&scene, &unsolved);
        assert!(matches!(verdict.refusal, Some(Refusal::Theory { .. })), "{verdict}");
        assert_eq!(verdict.status, Status::NotCertified);
        unsolved.converged = false;
        assert_eq!(of_exact(&scene, &unsolved).status, Status::NotConverged);
    }
}

/// The largest deflection is the one that the contacts make: neither less nor more.
#[test]
fn the_largest_deflection_is_that_of_the_contacts() {
    for (scene, exact) in certified() {
        // More than what is not known, and than the rounding of what the loads would do to a free beam.
        let (length, size) = (scene.beam().length(), exact.state.deflection.magnitude());
        let free = scene.load().magnitude(length) * length.powi(3) / (48.0 * scene.beam().bending_stiffness());
        let off = 1e-9 + 3.0 * of_exact(&scene, &exact).error + 1e-14 * free / size;
        for factor in [1.0 - off, 1.0 + off, 1e9] {
            let mut wrong = exact.clone();
            wrong.state.deflection.max *= factor;
            wrong.state.deflection.min *= factor;
            let verdict = of_exact(&scene, &wrong);
            assert!(matches!(verdict.refusal, Some(Refusal::Deflection { .. })), "{factor}: {verdict}");
        }
    }
}

/// But of a beam that may turn about its one support any position is as good as another: its deflection is no reason.
#[test]
fn of_a_beam_that_may_turn_any_position_is_as_good() {
    for length in [1.0, 10.0, 64.0] {
        let supports = Some(vec![palkki::scene::Support::simple(0.5 * length)]);
        let draft = Draft { length, stiffness: 1.3, uniform: 1.0, supports, ..Draft::default() };
        let scene = draft.scene().expect("well posed");
        let mut exact = theory::solve(&scene).expect("it is in balance");
        for factor in [0.5, 1.0, 3.0] {
            exact.state.deflection.max *= factor;
            let verdict = of_exact(&scene, &exact);
            assert_eq!(verdict.status, Status::Certified, "{verdict}");
        }
    }
}

/// A bound that is larger than half of the deflection recognises none: the answer is told that its deflection is another one.
#[test]
fn a_wide_bound_recognises_no_deflection() {
    let mut tried = 0;
    for (scene, exact) in certified() {
        let mut wrong = exact.clone();
        wrong.state.contacts.clear();
        let Some(c) = of_exact(&scene, &wrong).certificate else { continue };
        if c.up_to_a_turn.is_some() || !c.deflection.is_finite() || c.deflection_error <= 0.8 * c.deflection {
            continue;
        }
        for (factor, recognised) in [(1.4, true), (1.6, false)] {
            wrong.state.deflection.max = factor * c.deflection;
            wrong.state.deflection.min = 0.0;
            let refusal = of_exact(&scene, &wrong).refusal;
            assert_eq!(!matches!(refusal, Some(Refusal::Deflection { .. })), recognised, "{factor}: {refusal:?}");
        }
        tried += 1;
    }
    assert!(5 < tried, "{tried} scenes with a wide bound");
}

/// The energy lies between the bounds that the contacts prove: neither less nor more.
#[test]
fn the_energy_is_that_of_the_contacts() {
    for (scene, exact) in certified() {
        let size = scene.load().magnitude(scene.beam().length()) * exact.state.deflection.magnitude();
        let held: f64 = exact.state.contacts.iter().map(|c| c.force.abs()).sum::<f64>()
            * exact
                .state
                .contacts
                .iter()
                .fold(0.0, |most: f64, c| most.max(scene.gap(c.from).abs()).max(scene.gap(c.to).abs()));
        for off in [-1.0, 1.0] {
            let mut wrong = exact.clone();
            // A hundred times what rounding may make of the terms of its sum.
            wrong.state.energy += off * 1e-7 * (size + held);
            let verdict = of_exact(&scene, &wrong);
            assert!(matches!(verdict.refusal, Some(Refusal::Energy { .. })), "{off}: {verdict}");
        }
    }
}

/// An answer of a method on a grid: each of its own conditions.
#[test]
fn a_method_solves_its_own_grid() {
    let mut tried = 0;
    for (scene, _) in certified().take(12) {
        let Ok(raw) = solve_raw(&scene, &Settings::new(Method::Force, Solver::ActiveSet, 64)) else { continue };
        let witness = Witness::of(&scene);
        let of = |residual: f64, demand: &Demand| {
            let raw = palkki::Solution { residual, ..raw.clone() };
            Verdict::of_raw(&raw, &witness, demand)
        };
        if of(raw.residual, &Demand::default()).status != Status::Certified {
            continue;
        }
        tried += 1;
        for demand in [Demand::default(), Demand::of_error(0.01)] {
            let above = of(1.01 * demand.residual, &demand);
            assert!(matches!(above.refusal, Some(Refusal::Residual { .. })), "{above}");
            assert_eq!(above.status, Status::NotCertified);
            assert!(!matches!(of(demand.residual, &demand).refusal, Some(Refusal::Residual { .. })));
        }
        for none in [f64::NAN, f64::INFINITY] {
            assert_eq!(of(none, &Demand::default()).refusal, Some(Refusal::NoAnswer));
        }
        let mut no_number = raw.clone();
        no_number.state.nodes.as_mut().expect("nodes").contact_force[1] = f64::INFINITY;
        assert_eq!(Verdict::of_raw(&no_number, &witness, &Demand::default()).refusal, Some(Refusal::NoNumbers));
        no_number.run.reports_success = false;
        assert_eq!(Verdict::of_raw(&no_number, &witness, &Demand::default()).status, Status::NotConverged);
    }
    assert!(4 < tried, "{tried} answers on a grid");
}

/// Ground so little below the beam that the load bends it by next to nothing: of this nothing, too, a share has to be known.
#[test]
fn next_to_nothing_is_not_nothing() {
    let mut refused = 0;
    for power in [-100, -135, -140, -145, -150, -160, -200, -250, -300] {
        let unit = format!("1e{power}").parse::<f64>().expect("a number");
        let points = [[0.0, 22.0], [3.1, 22.0], [3.15, 3.0], [3.2, 22.0], [10.0, 22.0]];
        for ground in [
            Foundation::Polyline { points: points.map(|[x, u]| [x, u * unit]).to_vec() },
            Foundation::Flat { depth: unit },
        ] {
            let draft = Draft { length: 10.0, stiffness: 1.0, uniform: 1.0, ground: Some(ground), ..Draft::default() };
            let scene = draft.scene().expect("well posed");
            let witness = Witness::of(&scene);
            for method in Method::ALL {
                let Ok(raw) = solve_raw(&scene, &Settings::new(method, Solver::ActiveSet, 30)) else { continue };
                let verdict = Verdict::of_raw(&raw, &witness, &Demand::default());
                let size = raw.state.deflection.magnitude();
                if verdict.status == Status::Certified {
                    let error = verdict.certificate.expect("certified").deflection_error;
                    assert!(error <= 0.1 * size, "{method}, {power}: {error:e} of {size:e}");
                } else {
                    refused += 1;
                }
            }
        }
    }
    assert!(0 < refused, "all are certain");
}

/// What is at rest is known to be, in any units: without a load, and where level ground at depth 0 carries the load.
#[test]
fn what_is_at_rest_is_certain() {
    let rest = |uniform: f64, depth: f64| {
        let ground = Some(Foundation::Flat { depth });
        Draft { length: 10.0, stiffness: 1.3, uniform, ground, ..Draft::default() }
    };
    // Pressure that vanishes at one place: on the right of a part of the load, on its left, on both sides.
    let vanishes = |parts: &[[f64; 4]]| {
        let part = |&[from, to, start, end]: &[f64; 4]| LinearLoad { from, to, start, end };
        Draft { linear: parts.iter().map(part).collect(), ..rest(1.0, 0.0) }
    };
    let drafts = [
        vanishes(&[[0.0, 2.3, 1.0, -1.0]]),
        vanishes(&[[2.1, 3.7, 0.0, -1.0]]),
        vanishes(&[[2.1, 3.7, -1.0, 0.3]]),
        vanishes(&[[7.7, 10.0, -1.0, 1.0]]),
        vanishes(&[[6.0, 10.0, 0.7, -1.0]]),
        vanishes(&[[2.3, 4.9, 0.0, -1.0], [4.9, 8.1, -1.0, 0.0]]),
        rest(0.0, 1.0),
        rest(0.0, 0.0),
        rest(1.0, 0.0),
        rest(0.0, 0.0).with_points(&[(4.0, 1.0)]),
        Draft { supports: Some(Vec::new()), ..rest(0.0, 0.0).with_points(&[(4.0, 1.0)]) },
        Draft { supports: Some(Vec::new()), ..rest(1.0, 0.0).with_points(&[(4.0, 1.0), (7.0, 0.3)]) },
    ];
    for draft in drafts {
        for unit in [1.0, 1e-140, 1e140, 1e-100] {
            let draft = draft.in_units(Units { length: 1.0, depth: unit, force: unit });
            let scene = draft.scene().expect("well posed");
            let exact = theory::solve(&scene).expect("an answer");
            let verdict = of_exact(&scene, &exact);
            assert_eq!(
                (verdict.status, verdict.error.to_bits()),
                (Status::Certified, 0.0_f64.to_bits()),
                "{}",
                draft.text()
            );
            assert!(verdict.certificate.is_some_and(|c| c.at_rest), "{}", draft.text());
        }
    }
}
