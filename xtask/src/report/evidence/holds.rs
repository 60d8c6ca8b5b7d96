//! What holds a beam: scenes with supports of every kind, and with none.

use palkki::scene::{Beam, Load, PointLoad};

use super::gallery::{Shown, shown};
use super::prelude::*;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let all = shown(study, scenes::HELD, "held")?;
    let named = |name: &str| all.iter().find(|shown| shown.name == name).ok_or_else(|| format!("there is no {name}"));
    let [stands, neutral] = ["table-edge", "balanced"].map(|name| standing(named(name)?));
    let (stands, neutral) = (stands?, neutral?);
    let context = context! {
        count => all.len(),
        certified => all.iter().filter(|shown| shown.certified).count(),
        cards => all.iter().map(|shown| shown.card.clone()).collect::<Value>(),
        stands,
        neutral,
        refusals => refusals()?,
    };
    Evidence::new(context).figures(all.into_iter().map(|shown| shown.figure))
}

/// How a beam stands that its supports do not hold.
fn standing(Shown { scene, exact, .. }: &Shown) -> Result<Value, Cause> {
    let standing = exact.state.standing.ok_or_else(|| format!("{} is held by its supports", scene.title()))?;
    Ok(context! {
        title => scene.title(),
        at => standing.resultant.at,
        margin => standing.margin,
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
