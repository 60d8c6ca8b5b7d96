//! A snapshot of the example by every route. It guards against unnoticed change; the numbers are held by `claims`.

use std::fmt::Write as _;

use palkki::route::{Method, Solver};

use crate::scenes::{example, nodes, run};
use crate::support::assert_table;

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
            let force = force.map_or("–".to_owned(), |force| format!("{force:.4}"));
            let _ = writeln!(table, "{method:<16} {solver:<11} {:<14} {force:>12}", raw.ended());
        }
    }
    assert_table!("routes", "The example on 30 intervals by every route: how it ended and first contact force", table);
}
