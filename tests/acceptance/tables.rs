//! Snapshots: tables for a person. They guard against unnoticed change, and are never the only test of a number.

use std::fmt::Write as _;

use palkki::route::{Method, Solver, Status};
use palkki::state::{Contact, Extremes};

use crate::scenes::{example, nodes, report, run};
use crate::support::assert_table;

/// A number with five significant decimals, without a minus on zero.
fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) { "0.0000".to_owned() } else { text }
}

fn zone(contact: &Contact) -> String {
    let place = if contact.from < contact.to {
        format!("{} … {}", number(contact.from), number(contact.to))
    } else {
        number(contact.from)
    };
    format!("  contact {place:<22} force {:>10}\n", number(contact.force))
}

/// Places are distances from the nearer support: of two places that mirror each other, rounding picks one.
fn extremes(name: &str, values: &Extremes, length: f64) -> String {
    let nearer = |x: f64| number(x.min(length - x));
    let Extremes { max, max_at, min, min_at } = *values;
    let (max, max_at, min, min_at) = (number(max), nearer(max_at), number(min), nearer(min_at));
    format!("  {name:<10} max {max:>10}, {max_at:>7} from a support   min {min:>10}, {min_at:>7} from a support\n")
}

#[test]
fn contacts_of_every_scene() {
    let mut table = String::new();
    for (name, scene) in report() {
        let outcome = run(&scene, Method::Force, Solver::ActiveSet, 30);
        let (state, length) = (outcome.state, scene.beam().length());
        let _ = writeln!(table, "{name}: {}, {}", outcome.status, state.regime.word());
        table.extend(state.contacts.iter().map(zone));
        let reactions = state.reactions;
        let _ = writeln!(
            table,
            "  reactions {} and {}, contact force {}, energy {}",
            number(reactions.left),
            number(reactions.right),
            number(state.contact_force()),
            number(state.energy)
        );
        table += &extremes("deflection", &state.deflection, length);
        table += &extremes("moment", &state.moment, length);
    }
    assert_table!("contacts", "Force method, active set, 30 intervals: every scene of the report", table);
}

#[test]
fn routes_of_the_example() {
    let mut table = format!("{:<16} {:<11} {:<14} {:>12}\n", "method", "solver", "status", "first force");
    for method in Method::ALL {
        for solver in Solver::ALL {
            let outcome = run(&example(), method, solver, 30);
            // Of an answer that is not certified no digit is promised.
            let force = match outcome.status {
                Status::Certified => outcome.state.contacts.first().map_or(0.0, |contact| {
                    let nodes = nodes(&outcome);
                    let first = nodes.x.iter().position(|x| contact.from <= *x);
                    first.map_or(f64::NAN, |i| nodes.contact_force[i])
                }),
                _ => f64::NAN,
            };
            let force = if force.is_nan() { "–".to_owned() } else { number(force) };
            let _ = writeln!(table, "{method:<16} {solver:<11} {:<14} {force:>12}", outcome.status);
        }
    }
    assert_table!("routes", "The example on 30 intervals by every route: status and first contact force", table);
}
