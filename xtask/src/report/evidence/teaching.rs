//! Numbers of the exercises and of their answers.

use minijinja::{Value, context};
use palkki::certificate::{ContactLoad, Judged, certify};
use palkki::methods::{Discrete, Method};
use palkki::paper::approach::{Quantity, approach};
use palkki::paper::{INTERVALS, example, theory};
use palkki::route::{Outcome, Solver, Status};
use palkki::scene::Scene;
use palkki::{DEFAULT_TOLERANCE, Settings, solve, theory as exact};

use crate::report::csv::fixed;
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::study::Study;
use crate::report::table::Table;
use crate::report::{numbers, scenes};

/// Intervals of the grid on which the four steps are done by hand: n = 5 interior nodes.
const BY_HAND: usize = UNKNOWNS.len() + 1;
const UNKNOWNS: [&str; 5] = ["x₁", "x₂", "x₃", "x₄", "x₅"];
/// Grids on which the first nodal force jumps.
const JUMPING: std::ops::RangeInclusive<usize> = 30..=37;
/// Grids of the smooth crest: halvings of the coarsest.
const CREST: [usize; 6] = [30, 60, 120, 240, 480, 960];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    Ok(Evidence::new(context! {
        lift_off => lift_off(&scene),
        four_steps => four_steps(&scene)?,
        failure => failure(&scene)?,
        jumps => jumps(&scene)?,
        crest => crest(&scenes::read(study.root, "hump")?)?,
        bounds => bounds(&scene)?,
    }))
}

/// Exercise 1: the closed form for the example.
fn lift_off(scene: &Scene) -> Value {
    let (l, ei, q) = (scene.beam().length(), scene.beam().bending_stiffness(), scene.load().uniform());
    let closed = theory();
    context! {
        a => closed.lift_off,
        reaction => closed.reaction,
        deepest => q * l * l * l * l / (384.0 * ei),
        deeper => exact::flat(l, ei, 16.0 * scene.depth(0.0), q).lift_off,
    }
}

/// Exercise 2: the rounds of the four steps by finite differences, as the library does them.
fn four_steps(scene: &Scene) -> Result<Value, Cause> {
    let discrete = Discrete::new(scene, BY_HAND)?;
    let programme = Method::Complementarity.programme(&discrete);
    let n = programme.dimension();
    let header = ["round"].into_iter().chain(UNKNOWNS).chain(["set to zero"]);
    let mut table = Table::new(header);
    let mut free = vec![true; n];
    let mut rounds = 0;
    let end = loop {
        let point = programme.stationary(&free)?;
        rounds += 1;
        let negative = (0..n).filter(|&i| free[i] && point.x[i] < 0.0);
        let smallest = negative.min_by(|&i, &j| point.x[i].total_cmp(&point.x[j]));
        let cell = |i: usize| if free[i] { fixed(point.x[i], 3) } else { "0".to_owned() };
        let named = smallest.map_or("none: stop", |i| UNKNOWNS[i]).to_owned();
        table = table.row([rounds.to_string()].into_iter().chain((0..n).map(cell)).chain([named]));
        match smallest {
            Some(i) => free[i] = false,
            None => break point,
        }
    };
    let answer = Solver::FourStep.run(programme.as_ref(), DEFAULT_TOLERANCE);
    if answer.x != end.x || answer.iterations != rounds {
        return Err("the four steps of the exercise are not those of the solver".into());
    }
    let forces = end.gradient.iter().map(|p| fixed(p * discrete.spacing, 3)).collect::<Vec<_>>();
    let unit = discrete.spacing.powi(4) / discrete.stiffness;
    Ok(context! {
        intervals => BY_HAND,
        nodes => n,
        table,
        rounds,
        scaled_load => scene.load().uniform() * unit,
        forces => forces.join(", "),
        optimal => end.gradient.iter().all(|&p| 0.0 <= p),
    })
}

/// Exercise 3: the last grid before the four steps fail for the first time, and that grid.
fn failure(scene: &Scene) -> Result<Value, Cause> {
    let run = |n: usize| solve(scene, &Settings::new(Method::Complementarity, Solver::FourStep, n));
    let mut before: Option<Outcome> = None;
    for intervals in 4..=200 {
        let outcome = run(intervals)?;
        if outcome.status == Status::Certified {
            before = Some(outcome);
            continue;
        }
        let header =
            ["intervals", "rounds", "residual", "least nodal force", "at x", "left reaction", "right reaction"];
        let mut table = Table::new(header);
        let mut least = (0.0, 0.0);
        for (n, outcome) in before.iter().map(|b| (intervals - 1, b)).chain([(intervals, &outcome)]) {
            let nodes = outcome.state.nodes.as_ref().ok_or("a method on a grid has nodes")?;
            let forces = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied());
            least = forces.min_by(|a, b| a.1.total_cmp(&b.1)).ok_or("there are nodes")?;
            let rounding = outcome.residual < 1e-12;
            let at = if rounding { "–".to_owned() } else { fixed(least.0, 3) };
            let residual = if rounding { "below 10⁻¹²".to_owned() } else { fixed(outcome.residual, 3) };
            let reactions = outcome.state.reactions;
            let [least, left, right] =
                [if rounding { 0.0 } else { least.1 }, reactions.left, reactions.right].map(|f| fixed(f, 4));
            table = table.row([n.to_string(), outcome.iterations.to_string(), residual, least, at, left, right]);
        }
        let best = solve(scene, &Settings::new(Method::Complementarity, Solver::ActiveSet, intervals))?;
        return Ok(context! {
            intervals,
            before => intervals - 1,
            table,
            pull => -least.1,
            at => least.0,
            active_set => best.status == Status::Certified,
            reaction => best.state.reactions.left,
        });
    }
    Err("the four steps do not fail any more".into())
}

/// Exercise 4: the first nodal force on neighbouring grids, beside the resultant.
#[expect(clippy::cast_precision_loss, reason = "a few dozen intervals")]
fn jumps(scene: &Scene) -> Result<Value, Cause> {
    let closed = theory();
    let a = closed.lift_off.ok_or("the example has a zone")?;
    let header = [
        "intervals",
        "first node in contact",
        "(a − x₁)/Δ",
        "its force over T",
        "the next force over T",
        "resultant over T",
    ];
    let mut table = Table::new(header);
    let (mut least, mut most, mut steady) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    for n in JUMPING {
        let state = solve(scene, &Settings::new(Method::Force, Solver::ActiveSet, n))?.state;
        let nodes = state.nodes.as_ref().ok_or("a method on a grid has nodes")?;
        let first = (0..nodes.x.len()).find(|&i| 1e-9 < nodes.contact_force[i]).ok_or("there is contact")?;
        let spacing = scene.beam().length() / n as f64;
        let forces = [nodes.contact_force[first], nodes.contact_force[first + 1]].map(|f| f / closed.end_force);
        // Half of all contact, by symmetry, without the pressure of beam theory.
        let resultant = (0.5 * (nodes.contact_force.iter().sum::<f64>() - closed.contact_force) + closed.end_force)
            / closed.end_force;
        (least, most) = (least.min(forces[0]), most.max(forces[0]));
        steady = steady.max((resultant - 1.0).abs());
        let numbers = [(a - nodes.x[first]) / spacing, forces[0], forces[1]].map(|number| fixed(number, 2));
        let [between, one, two] = numbers;
        table = table.row([n.to_string(), (first + 1).to_string(), between, one, two, fixed(resultant, 3)]);
    }
    Ok(context! { table, least, most, steady, from => *JUMPING.start(), to => *JUMPING.end() })
}

/// Exercise 5: a contact at a single point of a smooth crest, which grids miss.
fn crest(scene: &Scene) -> Result<Value, Cause> {
    let solution = exact::solve(scene)?;
    let contact = solution.state.contacts.first().ok_or("the beam touches the crest")?;
    let header = [
        "intervals",
        "contact at",
        "off by",
        "error of the left reaction",
        "error over distance",
        "error of the energy",
    ];
    let mut table = Table::new(header);
    for n in CREST {
        let state = solve(scene, &Settings::new(Method::Force, Solver::ActiveSet, n))?.state;
        let nodes = state.nodes.as_ref().ok_or("a method on a grid has nodes")?;
        let forces = || nodes.contact_force.iter();
        let place = nodes.x.iter().zip(forces()).map(|(x, f)| x * f).sum::<f64>() / forces().sum::<f64>();
        let (apart, error) = (place - contact.from, state.reactions.left - solution.state.reactions.left);
        let energy = state.energy / solution.state.energy - 1.0;
        let row = [fixed(place, 4), fixed(apart, 4), fixed(error, 5), fixed(error / apart, 2), fixed(energy, 6)];
        table = table.row([n.to_string()].into_iter().chain(row));
    }
    let found = approach(scene, &solution, Method::Force, &CREST)?;
    let order = |quantity: Quantity| found.iter().find(|a| a.quantity == quantity).map(|a| a.order);
    Ok(context! {
        table,
        title => scene.title(),
        at => contact.from,
        force => contact.force,
        reaction => solution.state.reactions.left,
        of_reaction => order(Quantity::EndReaction),
        of_energy => order(Quantity::Energy),
    })
}

/// Exercise 6: bounds on the energy by hand, and those that are computed from the answer of the force method.
fn bounds(scene: &Scene) -> Result<Value, Cause> {
    let (l, ei) = (scene.beam().length(), scene.beam().bending_stiffness());
    let (q, u) = (scene.load().uniform(), scene.depth(0.0));
    let state = solve(scene, &Settings::new(Method::Force, Solver::ActiveSet, INTERVALS))?.state;
    let nodes = state.nodes.as_ref().ok_or("a method on a grid has nodes")?;
    let load = ContactLoad::new(l, nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()))?;
    let certificate = certify(scene, &load, Judged::Nodes(nodes))?;
    let energy = theory().energy;
    let by_hand = [-q * u * l, 32.0 * ei * u * u / (l * l * l) - 2.0 / 3.0 * q * u * l];
    let gap = by_hand[1] - by_hand[0];
    Ok(context! {
        intervals => INTERVALS,
        energy,
        by_hand,
        gap,
        // l²/4 √(2 gap/(3 EI l)), the bound on the deflection at mid-span.
        deflection => l * l / 4.0 * (2.0 * gap / (3.0 * ei * l)).sqrt(),
        lower => certificate.energy_lower,
        upper => certificate.energy_upper,
        width => numbers::bound((certificate.energy_upper - certificate.energy_lower) / energy.abs()),
        holds => certificate.energy_lower <= energy && energy <= certificate.energy_upper,
        error => certificate.deflection_error,
        discrete => state.energy,
        is_bound => energy <= state.energy,
    })
}
