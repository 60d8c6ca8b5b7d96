//! Beam theory with free lift-off points, and closed forms that it is compared with.

use minijinja::context;
use palkki::plot::significant;
use palkki::scene::{Foundation, Scene};
use palkki::theory::closed::{incline, lifted, parabola};
use palkki::theory::{self, Exact};

use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::table::Table;
use crate::report::{numbers, scenes};

/// Twelve digits are what the check of the exact solution asks for.
const DIGITS: f64 = 1e-12;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut table = Table::new(["scene", "closed form", "right reaction by formula", "found"]);
    let (mut worst, mut count) = (0.0_f64, 0);
    for (_, scene) in scenes::all(study.root)? {
        let Some(closed) = closed(&scene) else { continue };
        let exact = theory::solve(&scene)?;
        worst = worst.max(difference(&scene, &exact, &closed));
        count += 1;
        let reactions = [closed.reactions[1], exact.state.reactions.right].map(|r| significant(r, 10));
        table = table.row([scene.title(), closed.form, &reactions[0], &reactions[1]]);
    }
    let example = palkki_evidence::paper::theory();
    Ok(Evidence::new(context! {
        closed => table,
        count,
        most => numbers::bound(DIGITS),
        agree => worst <= DIGITS,
        unknowns => theory::solve(&palkki_evidence::paper::example()?)?.unknowns,
        lift_off => example.lift_off,
        reaction => example.reaction,
    }))
}

/// Reactions and contact force in closed form.
struct Closed {
    form: &'static str,
    reactions: [f64; 2],
    contact_force: f64,
}

/// The closed form of a scene, if it has one that the library knows.
fn closed(scene: &Scene) -> Option<Closed> {
    let (l, ei, load) = (scene.beam().length(), scene.beam().bending_stiffness(), scene.load());
    let q = load.uniform();
    if !load.linear().is_empty() {
        return None;
    }
    match (scene.foundation()?, load.point()) {
        (&Foundation::Flat { depth }, []) => {
            let flat = theory::flat(l, ei, depth, q);
            Some(Closed { form: "flat", reactions: [flat.reaction; 2], contact_force: flat.contact_force })
        }
        (&Foundation::Flat { depth }, [lift]) if lift.force < 0.0 && (lift.at - 0.5 * l).abs() <= f64::EPSILON * l => {
            let lifted = lifted(l, ei, depth, q, -lift.force)?;
            let contact_force = 2.0 * lifted.zone_force;
            Some(Closed { form: "flat, lifted at mid-span", reactions: [lifted.reaction; 2], contact_force })
        }
        (Foundation::Polynomial { coefficients }, []) if coefficients.len() == 2 => {
            let incline = incline(l, ei, [coefficients[0], coefficients[0] + coefficients[1] * l], q)?;
            Some(Closed { form: "incline", reactions: incline.reactions, contact_force: incline.contact_force })
        }
        (Foundation::Polynomial { coefficients }, points) if coefficients.len() == 3 => {
            let &[depth, c1, c2] = coefficients.as_slice() else { return None };
            let is_symmetric = (c1 + c2 * l).abs() <= 4.0 * f64::EPSILON * c1.abs();
            let dish = parabola(l, ei, depth, 0.25 * c1 * l, q);
            let a = dish.lift_off.filter(|_| 0.0 < dish.end_force && is_symmetric)?;
            // A point load on the zone goes straight into the ground.
            let inside = points.iter().all(|p| a < p.at && p.at < l - a);
            let contact_force = dish.contact_force + points.iter().map(|p| p.force).sum::<f64>();
            inside.then_some(Closed { form: "parabola", reactions: [dish.reaction; 2], contact_force })
        }
        _ => None,
    }
}

/// The largest difference of the three forces, over the load.
fn difference(scene: &Scene, exact: &Exact, closed: &Closed) -> f64 {
    let found = [exact.state.reactions.left, exact.state.reactions.right, exact.state.contact_force()];
    let expected = [closed.reactions[0], closed.reactions[1], closed.contact_force];
    let load = scene.load().magnitude(scene.beam().length());
    found.iter().zip(expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs() / load))
}
