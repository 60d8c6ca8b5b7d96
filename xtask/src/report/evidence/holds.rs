//! What holds a beam: scenes with supports of every kind, and with none.

use palkki::scene::{Beam, Load, PointLoad};

use super::gallery::{Shown, shown};
use super::prelude::*;

/// Grids of the table of methods.
const GRIDS: [usize; 2] = [30, 300];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let mut errors = Table::new([
        "scene",
        "energy, exact",
        "finite differences, 30",
        "finite differences, 300",
        "force method, 30",
        "force method, 300",
    ]);
    let all = shown(study, scenes::HELD, "held")?;
    for shown in &all {
        errors.push(error_row(shown)?);
    }
    let named = |name: &str| all.iter().find(|shown| shown.name == name).ok_or_else(|| format!("there is no {name}"));
    let [stands, neutral] = ["table-edge", "balanced"].map(|name| standing(named(name)?));
    let (stands, neutral) = (stands?, neutral?);
    let context = context! {
        count => all.len(),
        certified => all.iter().filter(|shown| shown.certified).count(),
        cards => all.iter().map(|shown| shown.card.clone()).collect::<Value>(),
        errors,
        stands,
        neutral,
        refusals => refusals()?,
    };
    Evidence::new(context).figures(all.into_iter().map(|shown| shown.figure))
}

/// The force and the displacement method are the same problem: their energies differ by rounding, which grows with the
/// condition number.
const SAME: f64 = 1e-8;

/// How far the energy of the two kinds of discrete problem is from that of beam theory, over its magnitude.
fn error_row(Shown { name, scene, exact, .. }: &Shown) -> Result<Vec<String>, Cause> {
    let energy = exact.state.energy;
    let mut row = vec![format!("[{}](#{name})", scene.title()), significant(energy, 6)];
    for method in [Method::Complementarity, Method::Force] {
        for intervals in GRIDS {
            let answer = on_grid(scene, method, Solver::ActiveSet, intervals)?;
            if !answer.solved {
                return Err(format!("{name} is not solved by {method} on {intervals} intervals").into());
            }
            if method == Method::Force {
                let other = on_grid(scene, Method::Displacement, Solver::ActiveSet, intervals)?.state.energy;
                if SAME * energy.abs() < (other - answer.state.energy).abs() {
                    return Err(format!("{name}: the energy methods differ on {intervals} intervals").into());
                }
            }
            row.push(error_cell(Some((answer.state.energy - energy).abs() / energy.abs())));
        }
    }
    Ok(row)
}

/// How a beam stands that its supports do not hold.
fn standing(Shown { scene, exact, .. }: &Shown) -> Result<Value, Cause> {
    let standing = exact.state.standing.ok_or_else(|| format!("{} is held by its supports", scene.title()))?;
    Ok(context! {
        title => scene.title(),
        force => standing.resultant.force,
        at => standing.resultant.at,
        margin => standing.margin,
        about => standing.motion.map(|motion| motion.about),
        from => standing.motion.and_then(|motion| motion.slope[0]),
        to => standing.motion.and_then(|motion| motion.slope[1]),
    })
}

/// Loads on a beam of length 10 without supports over flat ground for which there is no answer, and what the program says.
fn refusals() -> Result<Table, Cause> {
    let down = |at: f64, force: f64| PointLoad { at, force };
    let mut table = Table::new(["loads", "what the program says"]);
    for (words, point) in [
        ("6 down at x = 1, 1 up at x = 8", vec![down(1.0, 6.0), down(8.0, -1.0)]),
        ("2 up at x = 5", vec![down(5.0, -2.0)]),
        ("none", vec![]),
    ] {
        let beam = Beam::new(10.0, 1.0)?.with_supports(vec![])?;
        let load = Load::new(&beam, 0.0, vec![], point)?;
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 }))?;
        let Err(refusal) = theory::solve(&scene) else { return Err(format!("loads {words} are not refused").into()) };
        table.push(row![words, refusal]);
    }
    Ok(table)
}
