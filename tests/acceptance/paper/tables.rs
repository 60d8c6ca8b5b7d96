//! Snapshots: tables for a person. They guard against unnoticed change, and are never the only test of a number.

use std::fmt::Write as _;

use palkki::Witness;
use palkki::adaptive::{End, Request, adapt};
use palkki::route::{Method, Solver};
use palkki::state::{Contact, ContactState, Extremes};
use palkki::verdict::{Demand, Verdict};

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

fn totals(state: &ContactState) -> String {
    let [left, right, contact, energy] =
        [state.reactions.left, state.reactions.right, state.contact_force(), state.energy].map(number);
    format!("  reactions {left} and {right}, contact force {contact}, energy {energy}\n")
}

#[test]
fn contacts_of_every_scene() {
    let mut table = String::new();
    for (name, scene) in report() {
        let raw = run(&scene, Method::Force, Solver::ActiveSet, 30);
        let (state, length) = (&raw.state, scene.beam().length());
        let _ = writeln!(table, "{name}: {}, {}", raw.ended(), state.regime.name());
        table.extend(state.contacts.iter().map(zone));
        table += &totals(state);
        table += &extremes("deflection", &state.deflection, length);
        table += &extremes("moment", &state.moment, length);
    }
    assert_table!("contacts", "Force method, active set, 30 intervals: every scene of the report", table);
}

/// The exact solution of every scene. Places are those of the solution itself: it has no grid that could prefer one of two
/// mirror images, and the library names the left one.
#[test]
fn exact_solutions_of_every_scene() {
    let mut table = String::new();
    for (name, scene) in report() {
        let exact = palkki::theory::solve(&scene).expect("the scene is in range");
        let state = &exact.state;
        let unknowns = exact.unknowns;
        let _ = writeln!(table, "{name}: {}, {}, unknowns {unknowns}", exact.ended(), state.regime.name());
        for contact in &state.contacts {
            table += zone(contact).trim_end();
            if let Some([from, to]) = contact.end_forces {
                let _ = write!(table, "   at its ends {} and {}", number(from), number(to));
            }
            table.push('\n');
        }
        for (at, force) in exact.forces_inside_zones() {
            let _ = writeln!(table, "  point load at {} carried by the ground, {}", number(at), number(force));
        }
        let [left, right] = exact.support_couples;
        if left != 0.0 || right != 0.0 {
            let _ = writeln!(table, "  moments at the supports {} and {}", number(left), number(right));
        }
        table += &totals(state);
        for (name, values) in [("deflection", &state.deflection), ("moment", &state.moment)] {
            let [max, max_at, min, min_at] = [values.max, values.max_at, values.min, values.min_at].map(number);
            let _ = writeln!(table, "  {name:<10} max {max:>10} at {max_at:>7}   min {min:>10} at {min_at:>7}");
        }
    }
    assert_table!("exact", "Beam theory with free lift-off points: every scene of the report", table);
}

#[test]
fn routes_of_the_example() {
    let mut table = format!("{:<16} {:<11} {:<14} {:>12}\n", "method", "solver", "ended", "first force");
    for method in Method::ALL {
        for solver in Solver::ALL {
            let raw = run(&example(), method, solver, 30);
            // Of an answer that does not solve its problem no digit is promised.
            let force = raw.solved.then(|| {
                raw.state.contacts.first().map_or(0.0, |contact| {
                    let nodes = nodes(&raw);
                    let first = nodes.x.iter().position(|x| contact.from <= *x);
                    first.map_or(f64::NAN, |i| nodes.contact_force[i])
                })
            });
            let force = force.map_or("–".to_owned(), number);
            let _ = writeln!(table, "{method:<16} {solver:<11} {:<14} {force:>12}", raw.ended());
        }
    }
    assert_table!("routes", "The example on 30 intervals by every route: how it ended and first contact force", table);
}

/// Beside them stand the true errors, in `bounds`: what is certified is at least the true error, and at most a tenth more.
#[test]
fn certified_errors_of_every_scene() {
    let grids = [10, 30, 100, 300, 1000];
    let mut table = format!("{:<30}", "scene, method, intervals");
    table.extend(grids.map(|n| format!("{n:>9}")));
    for (name, scene) in report() {
        let witness = Witness::of(&scene);
        for method in Method::ALL {
            let _ = write!(table, "\n{:<30}", format!("{name} {method}"));
            for intervals in grids {
                let raw = run(&scene, method, Solver::ActiveSet, intervals);
                let verdict = Verdict::of_raw(&raw, &witness, &Demand::default());
                let _ = write!(table, "{:>9.1e}", verdict.error);
            }
        }
    }
    table.push('\n');
    assert_table!("errors", "Certified error of the deflection over the largest one, by the active set", table);
}

/// Beside it stands the true error of what is taken, in `solvers::adaptive`.
#[test]
fn grids_for_a_demanded_error() {
    let errors = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];
    let mut table = format!("{:<30}", "scene, method, error demanded");
    table.extend(errors.map(|error| format!("{error:>9.0e}")));
    for (name, scene) in report() {
        for method in Method::ALL {
            let _ = write!(table, "\n{:<30}", format!("{name} {method}"));
            for error in errors {
                let taken = adapt(&scene, &Request::new(method, Solver::ActiveSet, error)).expect("in range");
                let intervals = taken.settings.intervals.to_string();
                let _ = write!(table, "{:>9}", if taken.end == End::Reached { intervals } else { "–".to_owned() });
            }
        }
    }
    table.push('\n');
    assert_table!("adaptive", "Intervals that a demanded error takes, by the active set", table);
}
