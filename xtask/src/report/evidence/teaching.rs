//! Numbers of the exercises and of their answers.

use palkki::certificate::{Judged, certify};
use palkki::methods::Discrete;
use palkki::plot::{Arrow, Arrows, Axis, Color, Dash, Layer, Marker, Panel, Place, Style};
use palkki::qp::FreeSet;
use palkki::{DEFAULT_TOLERANCE, theory as exact_theory};
use palkki_evidence::paper::convergence::{Quantity, of_scene};
use palkki_evidence::paper::{INTERVALS, example, theory};

use super::prelude::*;
use super::taught;

/// Intervals of the grid on which the four steps are done by hand: n = 5 interior nodes.
const BY_HAND: usize = UNKNOWNS.len() + 1;
const UNKNOWNS: [&str; 5] = ["x₁", "x₂", "x₃", "x₄", "x₅"];
/// Grids on which the first nodal force jumps.
const JUMPING: [usize; 11] = [30, 31, 32, 33, 34, 35, 36, 37, 1000, 1001, 1002];
/// Bounds are printed with nine digits behind the point, rounded outwards.
const PRINTED: f64 = 1e9;
/// Grids of the smooth crest: halvings of the coarsest.
const CREST: [usize; 6] = [30, 60, 120, 240, 480, 960];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let (failure, figure) = failure(study, &scene)?;
    let (taught, figures) = taught::evidence(study)?;
    Evidence::new(context! {
        lift_off => lift_off(&scene),
        four_steps => four_steps(&scene)?,
        failure,
        jumps => jumps(&scene)?,
        crest => crest(&scenes::read(study.root, "hump")?)?,
        bounds => bounds(&scene)?,
        taught,
    })
    .figures(std::iter::once(figure).chain(figures))
}

/// Exercise 1: the closed form for the example.
fn lift_off(scene: &Scene) -> Value {
    let (l, ei, q) = (scene.beam().length(), scene.beam().bending_stiffness(), scene.load().uniform());
    let closed = theory();
    context! {
        a => closed.lift_off,
        reaction => closed.reaction,
        deepest => q * l * l * l * l / (384.0 * ei),
        deeper => palkki_evidence::closed::flat(l, ei, 16.0 * scene.depth(0.0), q).lift_off,
    }
}

/// A round of the four steps: the point, the contact forces there, and the variable that is set to zero after it.
struct Round {
    x: Vec<f64>,
    forces: Vec<f64>,
    smallest: Option<usize>,
}

/// The four steps by finite differences, round by round. They have to be those of the solver.
fn rounds(discrete: &Discrete) -> Result<Vec<Round>, Cause> {
    let qp = Method::Complementarity.qp(discrete);
    let mut free = FreeSet::all(qp.dimension());
    let mut rounds: Vec<Round> = Vec::new();
    loop {
        let point = qp.stationary(&free)?;
        let negative = free.variables().filter(|&i| point.x[i] < 0.0);
        let smallest = negative.min_by(|&i, &j| point.x[i].total_cmp(&point.x[j]));
        let forces = point.gradient.iter().map(|p| p * discrete.spacing).collect();
        rounds.push(Round { x: point.x, forces, smallest });
        let Some(smallest) = smallest else {
            let answer = Solver::FourStep.run(qp.as_ref(), DEFAULT_TOLERANCE);
            if rounds.last().is_none_or(|round| round.x != answer.x) || answer.run.iterations != rounds.len() {
                return Err("the four steps of the exercise are not those of the solver".into());
            }
            return Ok(rounds);
        };
        free.set(smallest, false);
    }
}

/// Exercise 2: the rounds of the four steps on a grid of five nodes.
fn four_steps(scene: &Scene) -> Result<Value, Cause> {
    let discrete = Discrete::new(scene, BY_HAND)?;
    let rounds = rounds(&discrete)?;
    let forces = &rounds[rounds.len() - 1].forces;
    let mut table = Table::new(["round"].into_iter().chain(UNKNOWNS).chain(["set to zero"]));
    let mut free = [true; UNKNOWNS.len()];
    for (k, Round { x, smallest, .. }) in rounds.iter().enumerate() {
        let cells = (0..free.len()).map(|i| if free[i] { fixed(x[i], 3) } else { "0".to_owned() });
        let named = smallest.map_or("none: stop", |i| UNKNOWNS[i]).to_owned();
        table.push(row![k + 1].into_iter().chain(cells).chain([named]));
        smallest.iter().for_each(|i| free[*i] = false);
    }
    Ok(context! {
        intervals => BY_HAND,
        nodes => UNKNOWNS.len(),
        table,
        rounds => rounds.len(),
        scaled_load => scene.load().uniform() * discrete.spacing.powi(4) / discrete.stiffness,
        forces => forces.iter().map(|f| fixed(*f, 3)).collect::<Vec<_>>().join(", "),
        optimal => forces.iter().all(|f| 0.0 <= *f),
    })
}

/// The node that pulls most, the round in which it was held, and the next node to the right that was held already.
fn pulling(rounds: &[Round]) -> Option<[usize; 3]> {
    let forces = &rounds.last()?.forces;
    let worst = (0..forces.len()).min_by(|&i, &j| forces[i].total_cmp(&forces[j]))?;
    let round = rounds.iter().position(|round| round.smallest == Some(worst))?;
    let before = rounds[..round].iter().filter_map(|round| round.smallest);
    Some([worst, round, before.filter(|i| worst < *i).min()?])
}

/// Exercise 3: the first grid on which the four steps fail, beside the one before.
fn failure(study: &Study<'_>, scene: &Scene) -> Result<(Value, Drawn), Cause> {
    let run = |solver: Solver, n: usize| on_grid(scene, Method::Complementarity, solver, n);
    let fails = |n: &usize| run(Solver::FourStep, *n).is_ok_and(|outcome| !outcome.solved);
    let intervals = (4..=200).find(fails).ok_or("the four steps do not fail any more")?;
    let mut table = Table::new(["intervals", "rounds", "passes our check", "left reaction", "right reaction"]);
    for n in [intervals - 1, intervals] {
        let outcome = run(Solver::FourStep, n)?;
        let passes = yes_no(outcome.solved);
        let reactions = [outcome.state.reactions.left, outcome.state.reactions.right].map(|r| fixed(r, 4));
        table.push(row![n, outcome.run.iterations, passes, reactions[0], reactions[1]]);
    }
    let discrete = Discrete::new(scene, intervals)?;
    let mut rounds = rounds(&discrete)?;
    // Scene and grid are symmetric, and rounding decides on which side the four steps begin: the exercise tells it from the left.
    let found = match pulling(&rounds) {
        Some(found) => found,
        None => {
            for Round { x, forces, smallest } in &mut rounds {
                x.reverse();
                forces.reverse();
                *smallest = smallest.map(|i| x.len() - 1 - i);
            }
            pulling(&rounds).ok_or("no node was held before")?
        }
    };
    let [worst, round, held] = found;
    let best = run(Solver::ActiveSet, intervals)?;
    let values = context! {
        intervals,
        before => intervals - 1,
        table,
        node => worst + 1,
        at => discrete.grid.place(worst + 1),
        pull => -rounds[rounds.len() - 1].forces[worst],
        clearance => rounds[round].x[worst],
        round => round + 1,
        held => held + 1,
        below => (worst + 1..held).all(|i| rounds[round].x[i] < 0.0),
        rounds => rounds.len(),
        active_set => best.solved,
        reaction => best.state.reactions.left,
    };
    let figure = at_work(study, &rounds, values.clone())?;
    Ok((values, figure))
}

/// The rounds of the four steps, one below the other: which nodes are below the ground, set to zero, held, or would pull; and the
/// forces at their end.
fn at_work(study: &Study<'_>, rounds: &[Round], values: Value) -> Result<Drawn, Cause> {
    const SIGNS: [(&str, Color, Marker); 4] = [
        ("below the ground", Color::BLUE, Marker::Plus),
        ("held", Color::GRAY, Marker::OpenCircle),
        ("set to zero", Color::BLACK, Marker::Square),
        ("held, would pull", Color::VERMILLION, Marker::Circle),
    ];
    let nodes = rounds[0].x.len();
    let mut held = vec![false; nodes];
    let mut places: [Vec<Place>; 4] = Default::default();
    let mut data = Table::new(["round", "node", "sign", "force"]);
    for (k, round) in rounds.iter().enumerate() {
        for (i, is_held) in held.iter().enumerate() {
            let sign = match (*is_held, round.smallest == Some(i)) {
                (true, _) if round.forces[i] < 0.0 => 3,
                (true, _) => 1,
                (false, true) => 2,
                (false, false) if round.x[i] < 0.0 => 0,
                (false, false) => continue,
            };
            places[sign].push([as_number(i + 1), as_number(k + 1)]);
            let force = if *is_held { fixed(round.forces[i], 3) } else { String::new() };
            data.push(row![k + 1, i + 1, SIGNS[sign].0, force]);
        }
        round.smallest.iter().for_each(|i| held[*i] = true);
    }
    let axis = || Axis::new("node").including(&[0.0, as_number(nodes + 1)]);
    let mut signs = Panel::new(axis(), Axis::new("round").down()).tall(900.0);
    for ((_, color, marker), places) in SIGNS.into_iter().zip(places) {
        signs = signs.with(Layer::line(places, Style::marks(color, marker)));
    }
    let last = &rounds[rounds.len() - 1].forces;
    let arrows = |pulls: bool, color: Color| {
        let of_sign = last.iter().enumerate().filter(|(_, force)| **force != 0.0 && (**force < 0.0) == pulls);
        let arrow = |(i, force): (usize, &f64)| {
            let at = [as_number(i + 1), 0.0];
            Arrow { at, force: *force, text: String::new(), optional: true }
        };
        Layer::Arrows(Arrows { arrows: of_sign.map(arrow).collect(), color, dash: Dash::Solid })
    };
    let [least, most] = range(last.iter().copied()).unwrap_or_default();
    let ends = Panel::new(axis(), Axis::new("contact force after the last round [force]").including(&[least, most]))
        .tall(460.0)
        .with(Layer::zero_line([0.0, as_number(nodes + 1)]))
        .with(arrows(false, Color::BLUE))
        .with(arrows(true, Color::VERMILLION));
    study.drawn("four-steps", values, 1, vec![signs, ends], data)
}

/// Exercise 4: the first nodal force on neighbouring grids, beside the resultant.
fn jumps(scene: &Scene) -> Result<Value, Cause> {
    let closed = theory();
    let a = closed.lift_off.ok_or("the example has a zone")?;
    let header = ["intervals", "first node in contact", "(a − x₁)/Δ", "its force over T", "the next force over T"];
    let mut table = Table::new(header.into_iter().chain(["resultant over T"]));
    let (mut least, mut most, mut steady) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    for n in JUMPING {
        let state = on_grid(scene, Method::Force, Solver::ActiveSet, n)?.state;
        let nodes = nodes_of(&state)?;
        let first = (0..nodes.x.len()).find(|&i| 1e-9 < nodes.contact_force[i]).ok_or("there is contact")?;
        let spacing = scene.beam().length() / as_number(n);
        let forces = [nodes.contact_force[first], nodes.contact_force[first + 1]].map(|f| f / closed.end_force);
        let resultant = Quantity::PointForce.of(&state) / closed.end_force;
        (least, most) = (least.min(forces[0]), most.max(forces[0]));
        steady = steady.max((resultant - 1.0).abs());
        let [between, one, two] = [(a - nodes.x[first]) / spacing, forces[0], forces[1]].map(|number| fixed(number, 2));
        table.push(row![n, first + 1, between, one, two, fixed(resultant, 3)]);
    }
    Ok(context! { table, least, most, steady, grids => JUMPING })
}

/// Exercise 5: a contact at a single point of a smooth crest, which grids miss.
fn crest(scene: &Scene) -> Result<Value, Cause> {
    let solution = exact_theory::solve(scene)?;
    let contact = solution.state.contacts.first().ok_or("the beam touches the crest")?;
    let header = ["intervals", "contact at", "position error", "error of the left reaction", "error over distance"];
    let mut table = Table::new(header.into_iter().chain(["relative error of the energy"]));
    for n in CREST {
        let state = on_grid(scene, Method::Force, Solver::ActiveSet, n)?.state;
        let nodes = nodes_of(&state)?;
        let forces = || nodes.contact_force.iter();
        let place = nodes.x.iter().zip(forces()).map(|(x, f)| x * f).sum::<f64>() / forces().sum::<f64>();
        let (apart, error) = (place - contact.from, state.reactions.left - solution.state.reactions.left);
        let energy = state.energy / solution.state.energy - 1.0;
        let (place, over) = (fixed(place, 4), fixed(error / apart, 2));
        table.push(row![n, place, fixed(apart, 4), fixed(error, 5), over, fixed(energy, 6)]);
    }
    let found = of_scene(scene, &solution, Method::Force, &CREST)?;
    let order = |quantity: Quantity| found.iter().find(|a| a.quantity == quantity).map(|a| a.order);
    Ok(context! {
        table,
        title => scene.title(),
        at => contact.from,
        force => contact.force,
        reaction => solution.state.reactions.left,
        of_reaction => order(Quantity::EndReaction),
        of_energy => order(Quantity::Energy),
        as_expected => [(Quantity::EndReaction, 1.0), (Quantity::Energy, 2.0)]
            .into_iter()
            .all(|(quantity, expected)| order(quantity).is_some_and(|found| (found - expected).abs() < 0.3)),
    })
}

/// Exercise 6: bounds on the energy by hand, and those that are computed from the answer of the force method.
fn bounds(scene: &Scene) -> Result<Value, Cause> {
    let (l, ei) = (scene.beam().length(), scene.beam().bending_stiffness());
    let (q, u) = (scene.load().uniform(), scene.depth(0.0));
    let state = on_grid(scene, Method::Force, Solver::ActiveSet, INTERVALS)?.state;
    let nodes = nodes_of(&state)?;
    let certificate = certify(scene, Judged::Nodes(nodes), &exact_theory::solve(scene)?.state.contacts)?;
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
        lower => (certificate.energy_lower * PRINTED).floor() / PRINTED,
        upper => (certificate.energy_upper * PRINTED).ceil() / PRINTED,
        width => bound((certificate.energy_upper - certificate.energy_lower) / energy.abs()),
        holds => certificate.energy_lower <= energy && energy <= certificate.energy_upper,
        error => certificate.deflection_error,
        discrete => state.energy,
        is_bound => energy <= state.energy,
    })
}
