//! Deterministic costs: solves, sweeps and iterations do not depend on the machine, and so they are asserted.
//!
//! The counts of our own routes are a table, integer by integer: who changes a solver sees what it does to them. Those of the
//! libraries are theirs, so they have a range.

use palkki::adaptive::{Request, adapt};
use palkki::route::{Method, Solver};
use palkki::scene::{Grid, Scene};
use palkki::sweep::Sweep;
use palkki::{Settings, Witness, solve_raw, solve_raw_near, theory};
use palkki_evidence::bodies::{five_diagonal, whole};
use palkki_evidence::extremes::{Ground, survey};
use palkki_evidence::random::{self, Random};
use palkki_evidence::sweeps;

use crate::scenes::{example, run, scene};
use crate::support::assert_table;

/// NSOR takes a second on the second grid, and the four steps on the last one.
fn too_long(solver: Solver, intervals: usize) -> bool {
    match solver {
        Solver::Nsor => 30 < intervals,
        Solver::FourStep => 1000 < intervals,
        _ => false,
    }
}

#[test]
fn the_counts_of_our_own_routes() {
    let grids = [30, 100, 300, 1000, 3000];
    let mut table = format!("{:<38}", "scene, route, intervals");
    table.extend(grids.map(|n| format!("{n:>8}")));
    for (name, scene) in [("example", example()), ("wave", scene("wave"))] {
        for method in Method::ALL {
            for solver in [Solver::ActiveSet, Solver::FourStep, Solver::Nsor] {
                table.push_str(&format!("\n{:<38}", format!("{name} {method}/{solver}")));
                for intervals in grids {
                    let count = if too_long(solver, intervals) {
                        "–".to_owned()
                    } else {
                        run(&scene, method, solver, intervals).run.iterations.to_string()
                    };
                    table.push_str(&format!("{count:>8}"));
                }
            }
        }
    }
    table.push('\n');
    assert_table!("costs", "Solves of the active set and the four steps, sweeps of NSOR", table);
}

/// Random ground of stiffnesses from 1 to 10⁸.
fn soft(i: u64) -> Scene {
    let stiffness = 10.0_f64.powi(i32::try_from(i % 9).unwrap_or(0));
    random::scene(i).on_springs(stiffness).expect("positive")
}

/// What searches take on random scenes, in sums: who changes where a search begins or what it tries sees it here, also where it finds
/// the same as before.
#[test]
fn the_counts_of_searches_on_random_scenes() {
    const SCENES: u64 = 20;
    /// The least grid of a scene; its supports may ask for a finer one.
    const INTERVALS: usize = 100;
    /// Supports at places of many digits ask for grids that take too long.
    const MOST: usize = 1000;
    type Draw = fn(u64) -> Scene;
    let kinds: [(&str, Draw); 6] = [
        ("plain", random::scene),
        ("lattice", random::on_lattice),
        ("held", random::held),
        ("coinciding", random::coinciding),
        ("rough", random::rough),
        ("soft", soft),
    ];
    let columns = ["lists", "steps", "work", "solves", "unknowns", "adapted"];
    let mut table = format!("{:<12}", "scenes");
    table.extend(columns.map(|column| format!("{column:>12}")));
    for (kind, scene) in kinds {
        let mut sums = [0_u64; 6];
        let mut add = |k: usize, count: usize| sums[k] += count as u64;
        for scene in (0..SCENES).map(scene) {
            let Ok(exact) = theory::solve(&scene) else { continue };
            add(0, exact.lists);
            add(1, exact.iterations);
            add(2, usize::try_from(exact.work()).expect("a count"));
            let Some(step) = Grid::least_fitting(&scene).filter(|step| *step <= MOST) else { continue };
            for method in Method::ALL {
                let settings = Settings::new(method, Solver::ActiveSet, step * INTERVALS.div_ceil(step));
                let Ok(raw) = solve_raw(&scene, &settings) else { continue };
                add(3, raw.run.iterations);
                add(4, raw.run.work);
            }
            let Ok(adapted) = adapt(&scene, &Request::new(Method::Force, Solver::ActiveSet, 1e-3)) else { continue };
            adapted.trials.iter().for_each(|trial| add(5, trial.work));
        }
        table.push_str(&format!("\n{kind:<12}"));
        table.extend(sums.map(|sum| format!("{sum:>12}")));
    }
    let mut random = Random::new(2026);
    let drawn = std::iter::repeat_with(|| whole(&mut random, 23)).flatten().take(40);
    let [mut solves, mut unknowns] = [0; 2];
    for known in drawn.chain([five_diagonal(1000)]) {
        let run = known.body.run(Solver::ActiveSet, 0.0).run;
        (solves, unknowns) = (solves + run.iterations, unknowns + run.work);
    }
    table.push_str(&format!("\n{:<12}{:>36}{solves:>12}{unknowns:>12}", "bodies", ""));
    let [mut rows, mut events] = [0; 2];
    for drawn in (0..10).map(sweeps::drawn) {
        let sweep = Sweep::new(&drawn.scene, &drawn.path, drawn.range, 11).expect("a sweep");
        let mut walk = sweep.walk();
        let solved = sweep.values().filter_map(|value| walk.solve(value).ok().map(|step| walk.row(step)));
        let kinds: Vec<_> = solved.map(|row| (row.value, row.pattern)).collect();
        rows += walk.work();
        events += sweep.events_and_work(&kinds, u64::MAX).1;
    }
    for (kind, work) in [("sweeps", rows), ("events", events)] {
        table.push_str(&format!("\n{kind:<12}{work:>36}"));
    }
    table.push('\n');
    assert_table!(
        "searches",
        "Sums over 20 random scenes of each kind: of beam theory lists of contacts, Newton steps and what sweeps count, and the latter of 10 sweeps and their events; of the active set \
         solves and the unknowns that they went through, on 100 intervals or a few more and for 41 bodies, and for an error of a thousandth",
        table
    );
}

/// An interior-point method takes as many steps on a fine grid as on a coarse one.
#[test]
fn an_interior_point_takes_a_few_dozen_steps_on_any_grid() {
    /// Twice what it takes on the example, and far below what a grid of 3000 would do to any other method.
    const STEPS: usize = 80;
    for method in Method::ALL {
        for intervals in [30, 300, 3000] {
            let steps = run(&example(), method, Solver::Clarabel, intervals).run.iterations;
            assert!((5..=STEPS).contains(&steps), "{method}, {intervals} intervals: {steps} steps");
        }
    }
}

/// Work is what the counts are made of: each solve of the four steps and each sweep goes through all unknowns, solves of the
/// active set at most, and on a grid that is guessed from few do.
#[test]
fn work_is_counted_in_unknowns() {
    /// Solves of the whole that a fine grid is worth, those on coarser grids and in neighbourhoods included.
    const WORTH: usize = 3;
    for method in Method::ALL {
        for solver in [Solver::FourStep, Solver::Nsor] {
            let raw = run(&example(), method, solver, 30);
            assert_eq!(raw.run.work, raw.run.iterations * raw.unknowns, "{method}/{solver}");
        }
        let raw = run(&example(), method, Solver::ActiveSet, 300);
        let most = raw.run.iterations * raw.unknowns;
        assert!(raw.unknowns <= raw.run.work && raw.run.work < most, "{method}: {} of {most}", raw.run.work);
    }
    for method in Method::ALL {
        let raw = run(&example(), method, Solver::ActiveSet, 300_000);
        let most = WORTH * raw.unknowns;
        assert!(raw.unknowns <= raw.run.work && raw.run.work <= most, "{method}: {} of {most}", raw.run.work);
    }
}

/// Grids of some dozen intervals start from a coarser one as well.
#[test]
fn the_example_is_worth_a_handful_of_solves_on_small_grids() {
    const HANDFUL: usize = 5;
    for method in Method::ALL {
        for intervals in [20, 30, 60, 100, 300] {
            let raw = run(&example(), method, Solver::ActiveSet, intervals);
            let most = HANDFUL * raw.unknowns;
            assert!(raw.solved && raw.run.work <= most, "{method}, {intervals}: {} of {most}", raw.run.work);
        }
    }
}

/// Windows keep the number of solves from growing with the grid: ten times as many nodes, at most twice as many solves.
/// Up to some thousand nodes grids are solved as a whole and not in windows, in fewer solves.
#[test]
fn solves_do_not_grow_with_the_grid() {
    for name in ["heinisuo-1984", "wave"] {
        for method in Method::ALL {
            let count = |intervals| run(&scene(name), method, Solver::ActiveSet, intervals).run.iterations;
            let (coarse, fine) = (count(100_000), count(1_000_000));
            assert!(fine <= 2 * coarse, "{name}, {method}: {coarse} solves on 100 000 intervals, {fine} on 1 000 000");
        }
    }
}

/// On rough ground the contacts of a coarser grid say little. Where the certificate asks for those of beam theory as well, the active
/// set starts from them: a few solves instead of hundreds, to the same answer.
#[test]
fn a_survey_is_solved_from_the_contacts_of_beam_theory() {
    /// Solves of the whole that all of them are worth, windows around contacts included.
    const WORTH: usize = 3;
    for ground in [Ground::Walk, Ground::Noise] {
        for segments in [5_000, 20_000, 60_000] {
            for load in [1.0, 30.0] {
                let scene = survey(ground, segments, load).expect("a scene");
                for method in [Method::Complementarity, Method::Force] {
                    let settings = Settings::new(method, Solver::ActiveSet, segments as usize);
                    let far = solve_raw(&scene, &settings).expect("an answer");
                    let near = solve_raw_near(&Witness::of(&scene), &settings).expect("an answer");
                    let name = format!("{} of {segments}, {method}, load {load}", ground.name());
                    assert!(far.solved && near.solved, "{name}: residuals {:e}, {:e}", far.residual, near.residual);
                    assert!(near.run.work <= WORTH * near.unknowns, "{name}: {} of {}", near.run.work, near.unknowns);
                    assert!(
                        2 * near.run.iterations < far.run.iterations,
                        "{name}: {} of {}",
                        near.run.iterations,
                        far.run.iterations
                    );
                    assert!(near.run.message.ends_with("from the contacts of beam theory"), "{name}");
                    assert!(!far.run.message.contains("theory"), "{name}");
                    let [a, b] = [&near, &far].map(|raw| raw.state.energy);
                    // One optimum: what is left is rounding.
                    assert!((a - b).abs() <= 1e-11 * b.abs(), "{name}: energies {a:e}, {b:e}");
                }
            }
        }
    }
}
