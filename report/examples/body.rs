//! Any elastic body in the place of the beam: solve it, and prove how far the answer is off.
#![expect(clippy::print_stdout, reason = "an example prints what it finds")]
use palkki::body::{Body, Kind, proof::prove};
use palkki::qp::Profile;
use palkki::solvers::Solver;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Five masses in a row, held to their neighbours and to two walls by springs of stiffness 1; the ground is flat.
    let n = 5;
    let stiffness = Profile::of_entries(
        n,
        (0..n).flat_map(move |i| [(i, i, 2.0)].into_iter().chain((0 < i).then(|| (i, i - 1, -1.0)))),
    );
    let body = Body::new(Kind::Stiffness, stiffness, None, vec![1.0; n], vec![0.5; n])?;

    let answer = body.run(Solver::ActiveSet, 1e-9);
    let [clearances, forces] = body.clearance_and_force(&answer);
    let proof = prove(&body, clearances.iter().map(|clearance| 0.0 < *clearance))?;
    println!("clearances {clearances:.4?}, contact forces {forces:.4?}");
    println!("off by at most {:.1e}", proof.off(&clearances).most);
    println!("an answer that says it touches nowhere: off by at least {:.3}", proof.off(&[0.5; 5]).least);
    Ok(())
}
