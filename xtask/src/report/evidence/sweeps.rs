//! One number of a scene varied: a load that moves, a depth that grows, how an answer changes with what is given, and what is
//! known of it if the ground is not known exactly.

use palkki::plot::sweep;
use palkki::scene::{Load, PointLoad, Quantity};
use palkki::sweep::{Event, Row, Sweep};
use palkki::theory::{By, Derivative, Exact};
use palkki::tolerance::DepthTolerance;
use palkki_evidence::paper::{beam, example, scene_over};
use palkki_evidence::random::Random;

use super::prelude::*;

/// A sweep as its command says it: what its figure and its data are called, the scene, what is varied, from where to where, in
/// how many steps.
type Case = (&'static str, &'static str, &'static str, [f64; 2], usize);

const HOIST: Case = ("sweep-hoist", "swept/hoist", "load.point[0].at", [0.0, 10.0], 401);
/// The steps meet neither border.
const DEPTH: Case = ("sweep-depth", "heinisuo-1984", "foundation.depth", [1.0, 121.0], 240);

/// A sweep with its answers and events.
struct Swept {
    case: Case,
    scene: Scene,
    rows: Vec<Row>,
    events: Vec<Event>,
}

impl Swept {
    fn of(study: &Study<'_>, case: Case) -> Result<Self, Cause> {
        let (_, scene, vary, range, steps) = case;
        let scene = scenes::read(study.root, scene)?;
        let sweep = Sweep::new(&scene, vary, range, steps)?;
        let rows = sweep.rows()?;
        let events = sweep.events(&rows);
        Ok(Self { case, rows, events, scene })
    }

    /// What the templates see; `events` is their table.
    fn values(&self, events: Table) -> Value {
        let (name, scene, vary, [from, to], steps) = self.case;
        let command = format!(
            "palkki sweep {}/{scene}.toml --vary {vary} --from {from} --to {to} --steps {steps} --plot {name}.svg",
            scenes::GALLERY,
        );
        let certified = self.rows.iter().filter(|row| row.solution.verdict.status == Status::Certified).count();
        context! { command, steps, certified, events }
    }

    /// The figure, and the numbers that it draws.
    fn drawn(&self, study: &Study<'_>) -> Result<Drawn, Cause> {
        let (name, _, vary, range, steps) = self.case;
        let states: Vec<_> = self.rows.iter().map(|row| (row.value, &row.solution.state)).collect();
        let quantity = Sweep::new(&self.scene, vary, range, steps)?.quantity();
        let svg = sweep(&self.scene, quantity, &states, &self.events, &study.words(name, context! {})?.title)?;
        let supports = self.scene.beam().supports().len();
        let header = [vary, "regime", "contact_force", "deflection_max", "moment_max", "moment_min", "contacts"];
        let header = header.into_iter().map(str::to_owned);
        let header = header.chain((1..=supports).map(|i| format!("support_{i}")));
        let data = Table::new(header).rows(states.iter().map(|(value, state)| {
            let place =
                |from: f64, to: f64| if from < to { [fixed(from, 4), fixed(to, 4)].join("-") } else { fixed(from, 4) };
            let contacts: Vec<String> = state.contacts.iter().map(|c| place(c.from, c.to)).collect();
            let numbers = [state.contact_force(), state.deflection.max, state.moment.max, state.moment.min];
            let mut cells = vec![fixed(*value, 5), state.regime.name().to_owned()];
            cells.extend(numbers.map(|number| fixed(number, 5)));
            cells.push(contacts.join(" "));
            cells.extend(state.supports.iter().map(|support| fixed(support.force, 5)));
            cells
        }));
        Ok((name, svg, data))
    }

    /// The number of the event at a value, within [`SAME`] of it.
    fn event_at(&self, value: f64) -> Result<usize, Cause> {
        let found = self.events.iter().position(|event| (event.value - value).abs() <= SAME * value.abs());
        found.map(|i| i + 1).ok_or_else(|| format!("no event at {value}, where the closed form has one").into())
    }

    /// Its events, and beside them closed forms: formulas with their values.
    fn events(&self, at: &str, closed: &[(&str, f64)]) -> Result<Table, Cause> {
        let numbers = closed.iter().map(|(_, value)| self.event_at(*value)).collect::<Result<Vec<_>, _>>()?;
        let header = ["event", at, "what happens", "closed form", "difference, relative, below"];
        Ok(Table::new(header).rows(self.events.iter().enumerate().map(|(i, event)| {
            let [form, apart] = match numbers.iter().position(|number| *number == i + 1).map(|k| closed[k]) {
                Some((form, value)) => {
                    let apart = (event.value - value).abs() / value.abs();
                    [form.to_owned(), bound(apart.max(f64::EPSILON))]
                }
                None => ["–"; 2].map(str::to_owned),
            };
            row![i + 1, significant(event.value, DIGITS), event.what, form, apart]
        })))
    }
}

/// Digits of the value of an event.
const DIGITS: usize = 12;

/// Numbers that are the same but for rounding, relative.
const SAME: f64 = 1e-9;

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let (l, ei, q) = (beam()?.length(), beam()?.bending_stiffness(), example()?.load().uniform());
    let border = q * l * l * l * l / (384.0 * ei);
    let lift_off = palkki_evidence::paper::theory().lift_off.ok_or("the example has a zone")?;

    let hoist = Swept::of(study, HOIST)?;
    let lift = -hoist.scene.load().point()[0].force;
    let closes = lift_off + 0.75 * lift / q;
    let of_hoist = hoist.events("at", &[("a + 3P/(4q)", closes), ("l − a − 3P/(4q)", l - closes)])?;
    let between = [hoist.event_at(closes)?, hoist.event_at(l - closes)?];
    let count = hoist.events.len();
    let mirrored = (0..count).map(|i| (hoist.events[i].value + hoist.events[count - 1 - i].value - l).abs() / l);
    let mirrored = mirrored.fold(f64::EPSILON, f64::max);
    if SAME < mirrored {
        return Err("the events of the hoist are not symmetric".into());
    }

    let depth = Swept::of(study, DEPTH)?;
    for value in [border, 5.0 * border] {
        depth.event_at(value)?;
    }
    let closed = depth.rows.iter().map(|row| {
        let reaction = palkki_evidence::closed::flat(l, ei, row.value, q).reaction;
        (row.solution.state.reactions.left - reaction).abs() / (q * l)
    });
    let closed = closed.fold(f64::EPSILON, f64::max);

    let evidence = Evidence::new(context! {
        hoist => hoist.values(of_hoist),
        mirrored => bound(mirrored),
        // The events between which the hoist has a zone on either side.
        between,
        // Bound of the difference of the reactions from the closed form, over the load.
        closed => bound(closed),
        superposition => superposition()?,
        derivatives => derivatives()?,
        border => one_sided(5.0 * border)?,
        tolerance => tolerances(study)?,
    });
    evidence.figures([hoist.drawn(study)?, depth.drawn(study)?])
}

/// The left reaction of the example under two loads, together and one by one.
fn superposition() -> Result<Value, Cause> {
    const FORCE: f64 = 5.0;
    const PLACES: [f64; 2] = [0.5, 1.0];
    let reaction = |loads: &[(f64, f64)]| -> Result<f64, Cause> {
        let (beam, example) = (beam()?, example()?);
        let points = loads.iter().map(|&(at, force)| PointLoad { at, force }).collect();
        let load = Load::new(&beam, example.load().uniform(), vec![], points)?;
        let scene = Scene::new(beam, load, example.foundation().cloned())?;
        Ok(theory::solve(&scene)?.state.reactions.left)
    };
    let [first, second] = PLACES;
    let alone = reaction(&[])?;
    let more = |loads: &[(f64, f64)]| reaction(loads).map(|reaction| reaction - alone);
    let (one, other) = (more(&[(first, FORCE)])?, more(&[(second, FORCE)])?);
    let both = more(&[(first, FORCE), (second, FORCE)])?;
    Ok(context! { force => FORCE, first, second, one, other, both, over => (one + other) / both - 1.0 })
}

/// The derivative by a number, or by the depth of the ground.
fn by(all: &[Derivative], number: By) -> Result<&Derivative, Cause> {
    all.iter().find(|derivative| derivative.by == number).ok_or_else(|| format!("no derivative by {number}").into())
}

/// Derivatives of the example beside their closed forms, which follow from `T = ½ q a` and `a⁴ = 24 EI u₀/q`.
fn derivatives() -> Result<Table, Cause> {
    let scene = example()?;
    let (l, ei, q, u) = (beam()?.length(), beam()?.bending_stiffness(), scene.load().uniform(), scene.depth(0.0));
    let all = theory::solve(&scene)?.derivatives(&scene);
    let [depth, uniform, stiffness] =
        [By::Depth, By::Number(Quantity::Uniform), By::Number(Quantity::BendingStiffness)]
            .map(|number| by(&all, number));
    let (depth, uniform, stiffness) = (depth?, uniform?, stiffness?);
    let t = palkki_evidence::paper::theory().reaction;
    let rows = [
        ("dT/du₀", depth.supports[0], "T/(4u₀)", t / (4.0 * u)),
        ("dT/dq", uniform.supports[0], "3T/(4q)", 0.75 * t / q),
        ("dT/dEI", stiffness.supports[0], "T/(4EI)", t / (4.0 * ei)),
        ("dJ/du₀", depth.energy, "−(q l − 2T)", -(q * l - 2.0 * t)),
    ];
    let table = Table::new(["derivative", "found", "closed form", "difference, relative, below"]);
    Ok(table.rows(rows.map(|(name, found, form, value)| {
        let apart = ((found - value).abs() / value.abs()).max(f64::EPSILON);
        row![name, significant(found, DIGITS), form, bound(apart)]
    })))
}

/// The derivative of the end reaction by the depth on the two sides of the depth at which contact is lost, and what is given on
/// it.
fn one_sided(depth: f64) -> Result<Value, Cause> {
    let at = |depth: f64| -> Result<(f64, bool), Cause> {
        let scene = scene_over(Foundation::Flat { depth })?;
        let all = theory::solve(&scene)?.derivatives(&scene);
        let derivative = by(&all, By::Depth)?;
        Ok((derivative.supports[0], derivative.one_sided))
    };
    let ((before, _), (on, one_sided), (after, _)) = (at(0.999 * depth)?, at(depth)?, at(1.001 * depth)?);
    if !one_sided {
        return Err("the derivative at the border of two regimes is one-sided".into());
    }
    Ok(context! { depth, before, on, after })
}

/// Depths of the survey that may be off, by how much \[m\].
const TOLERANCES: [f64; 4] = [0.0001, 0.001, 0.003, 0.01];
/// Surveys with readings that are off by at most that, drawn for each tolerance.
const DRAWN: u32 = 200;

/// What is guaranteed and what is estimated on the survey, and what comes of surveys that are drawn within the tolerance.
fn tolerances(study: &Study<'_>) -> Result<Value, Cause> {
    let scene = scenes::read(study.root, "survey")?;
    let Some(Foundation::Polyline { points }) = scene.foundation() else { return Err("a survey is a polyline".into()) };
    let exact = theory::solve(&scene)?;
    let reaction = exact.state.reactions.left;
    let places = |exact: &Exact| exact.state.contacts.iter().flat_map(|c| [c.from, c.to]).collect::<Vec<f64>>();
    let mut table = Table::new([
        "tolerance [mm]",
        "proven J: from, to [kN m]",
        "estimated error of the left reaction [kN]",
        "surveys with the same contacts",
        "maximum error of these [kN]",
        "maximum error of all [kN]",
    ]);
    let mut random = Random::new(15);
    for tolerance in TOLERANCES {
        let known = DepthTolerance::of(&scene, &exact, tolerance);
        let estimate = known.estimates.as_ref().and_then(|estimates| estimates.supports.first().copied());
        // With the same contacts, and of all.
        let (mut same, mut farthest, mut kept) = (0.0_f64, 0.0_f64, 0);
        for _ in 0..DRAWN {
            // At its tolerance each reading is off the most, one way or the other.
            let off = points.iter().map(|&[x, u]| [x, u + random.pick(&[-1.0, 1.0]) * tolerance]).collect();
            let drawn =
                Scene::new(scene.beam().clone(), scene.load().clone(), Some(Foundation::Polyline { points: off }))?;
            let found = theory::solve(&drawn)?;
            let bounds = known.energy.map(|bound| bound.ok_or("an energy has no bound"));
            let (lower, upper) = (bounds[0]?, bounds[1]?);
            if !(lower..=upper).contains(&found.state.energy) {
                return Err(format!("an energy outside of its bounds for the tolerance {tolerance}").into());
            }
            let off = (found.state.reactions.left - reaction).abs();
            farthest = farthest.max(off);
            if apart_if_any(&places(&found), &places(&exact)) <= SAME {
                (same, kept) = (same.max(off), kept + 1);
            }
        }
        if estimate.is_some_and(|estimate| estimate * (1.0 + SAME) < same) {
            return Err(
                format!("a force beyond its estimate with the same contacts, for the tolerance {tolerance}").into()
            );
        }
        let energy = known.energy.map(|energy| cell(energy, 5));
        table.push(row![
            fixed(1000.0 * tolerance, 1),
            energy.join(", "),
            cell(estimate, 3),
            kept,
            if 0 < kept { significant(same, 3) } else { "–".to_owned() },
            significant(farthest, 3),
        ]);
    }
    Ok(context! { table, drawn => DRAWN, reaction, energy => exact.state.energy })
}
