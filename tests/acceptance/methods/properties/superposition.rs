//! More load where the beam lies on the ground anyway, no contact, contact everywhere, deeper ground.

use palkki::route::{Method, Solution, Solver};
use palkki::scene::{Foundation, PointLoad};
use palkki::state::Regime;

use palkki_evidence::draft::Draft;

use super::{ROUNDING, points, scene, some};
use crate::scenes::{apart, largest, nodes, run, uniform};

const INTERVALS: usize = 40;

fn solved(draft: &Draft, method: Method) -> Solution<()> {
    let raw = run(&scene(draft), method, Solver::ActiveSet, INTERVALS);
    assert!(raw.solved, "{method}: {draft:?}");
    raw
}

/// A load on a node in contact goes straight into the ground: the force there grows by it, and nothing else changes.
#[test]
fn load_on_a_part_in_contact_bends_nothing() {
    let mut tried = 0;
    for draft in some(20, 6) {
        for method in Method::ALL {
            let before = solved(&draft, method);
            let a = nodes(&before);
            let Some(node) = a.contact_force.iter().rposition(|p| 0.0 < *p) else { continue };
            tried += 1;
            let added = 0.7 * draft.uniform * draft.length;
            let mut heavier = draft.clone();
            heavier.point.push(PointLoad { at: a.x[node], force: added });
            let after = solved(&heavier, method);
            let b = nodes(&after);
            let mut expected = a.contact_force.clone();
            expected[node] += added;
            let load = scene(&heavier).load().magnitude(draft.length);
            assert!(apart(&b.contact_force, &expected) <= ROUNDING * load, "{method}: {draft:?}");
            assert!(apart(&b.clearance, &a.clearance) <= ROUNDING * largest(&a.deflection), "{method}: {draft:?}");
            let reactions = (before.state.reactions.left - after.state.reactions.left).abs();
            assert!(reactions <= ROUNDING * load, "{method}: reactions move by {reactions:e}");
        }
    }
    assert!(30 < tried, "most scenes touch, {tried} were tried");
}

#[test]
fn ground_out_of_reach_is_not_touched() {
    for mut draft in some(10, 7) {
        // The depths are at most a fifth of the free deflection under the uniform part of the load, all loads below three times it.
        points(&mut draft).iter_mut().for_each(|p| p[1] *= 1e4);
        for method in Method::ALL {
            let raw = solved(&draft, method);
            assert_eq!(raw.state.regime, Regime::None, "{method}: {draft:?}");
            assert!(raw.state.contacts.is_empty(), "{method}: {draft:?}");
            assert!(largest(&nodes(&raw).contact_force) <= 0.0, "{method}: {draft:?}");
        }
    }
}

/// Ground with the shape of the free beam, raised by half: the deflection is that shape, and each node carries half its load.
#[test]
fn ground_in_the_shape_of_the_beam_carries_its_share() {
    let (l, ei, q) = (8.0, 2.0, 3.0);
    // ½ q x (l³ − 2 l x² + x³)/(24 EI), and no more.
    let c = 0.5 * q / (24.0 * ei);
    let shape = Foundation::Polynomial { coefficients: vec![0.0, c * l * l * l, 0.0, -2.0 * c * l, c] };
    // The fourth difference of a polynomial of degree 4 is its derivative, so that finite differences reproduce it exactly:
    // all but the nodes beside the supports, where v_{−1} = −v_1 leaves out v''''. The energy methods have no such luck.
    let raw = run(&uniform(l, ei, q, shape), Method::Complementarity, Solver::ActiveSet, 16);
    assert!(raw.solved);
    let p = &nodes(&raw).contact_force;
    let inner = vec![0.5 * q * l / 16.0; 13];
    assert!(apart(&p[1..14], &inner) <= ROUNDING * q * l, "half of q₀Δ inside: {p:?}");
}

/// More room lowers the energy: the minimum is taken over a larger set.
#[test]
fn deeper_ground_means_less_energy() {
    for draft in some(10, 8) {
        for method in Method::ALL {
            let mut previous = f64::INFINITY;
            for deeper in [0.0, 0.01, 0.1, 0.5, 2.0, 10.0] {
                let mut lower = draft.clone();
                let depth = largest(&points(&mut lower).iter().map(|p| p[1]).collect::<Vec<_>>());
                points(&mut lower).iter_mut().for_each(|p| p[1] += deeper * depth);
                let energy = solved(&lower, method).state.energy;
                assert!(energy <= previous, "{method}: {energy} after {previous}");
                previous = energy;
            }
        }
    }
}
