//! How stiff is rigid: the example on ground of ever greater stiffness, beside the laws that its numbers follow.

use palkki::adaptive::observed_order;
use palkki::plot::{Axis, Color, Divisions, Layer, Marker, Panel, Place, Style};
use palkki::state::ContactState;
use palkki::sweep::Sweep;
use palkki::theory::Exact;
use palkki::{Solution, solve_exactly};
use palkki_evidence::closed::{gap_opens, stiff, strip};
use palkki_evidence::paper::{beam, example};

use super::prelude::*;

/// Powers of ten of the stiffness that are solved, and so many in each; those between which orders are measured.
const POWERS: [i32; 2] = [2, 16];
const IN_A_POWER: i32 = 4;
const MEASURED: [i32; 2] = [6, 12];
/// Powers of ten for which strip and gap are compared with their laws, and those of the drawings.
const WITH_GAP: [i32; 6] = [8, 10, 12, 14, 16, 18];
const DRAWN: [i32; 3] = [8, 11, 13];
/// Digits of the rule.
const DIGITS: [i32; 5] = [2, 3, 4, 6, 9];

/// The numbers of the example on rigid ground, and what they are measured by.
struct Rigid {
    bending: f64,
    depth: f64,
    load: f64,
    lift_off: f64,
    reaction: f64,
    force: f64,
}

/// An answer on ground of a stiffness.
#[derive(Clone)]
struct Answer {
    ground: f64,
    /// `λa`.
    lever: f64,
    solution: Solution,
}

impl Answer {
    fn of(rigid: &Rigid, ground: f64) -> Result<Self, Cause> {
        let solution = solve_exactly(&example()?.on_springs(ground)?)?;
        if solution.verdict.status != Status::Certified {
            return Err(format!("k = {ground}: {}", solution.verdict).into());
        }
        Ok(Self { ground, lever: (0.25 * ground / rigid.bending).sqrt().sqrt() * rigid.lift_off, solution })
    }

    fn state(&self) -> &ContactState {
        &self.solution.state
    }

    fn exact(&self) -> Result<&Exact, Cause> {
        self.solution.exact.as_deref().ok_or_else(|| "beam theory has functions".into())
    }

    fn pressure(&self) -> f64 {
        self.state().pressure.map_or(0.0, |pressure| pressure.max)
    }

    /// The relative errors of the left reaction and of lift-off, penetration over depth, and the largest pressure over the load.
    fn numbers(&self, rigid: &Rigid) -> [f64; 4] {
        let state = self.state();
        let lift_off = state.contacts.first().map_or(0.0, |contact| contact.from);
        [
            (rigid.reaction - state.reactions.left) / rigid.reaction,
            (rigid.lift_off - lift_off) / rigid.lift_off,
            self.pressure() / self.ground / rigid.depth,
            self.pressure() / rigid.load,
        ]
    }

    /// What their laws say; the last two with the constant of a zone without a gap.
    fn laws(&self, rigid: &Rigid) -> [f64; 4] {
        let x = self.lever;
        // √2 e^{−π/4} λF, F = qa/2.
        let pressure = std::f64::consts::FRAC_1_SQRT_2 * (-std::f64::consts::FRAC_PI_4).exp() * x;
        [0.5 / (x * x * x), 1.0 / x, pressure * rigid.load / self.ground / rigid.depth, pressure]
    }

    /// From the left: the ends of the strip, and where the zone begins.
    fn gap(&self) -> Result<[f64; 3], Cause> {
        match self.state().contacts[..] {
            [strip, zone, _] => Ok([strip.from, strip.to, zone.from]),
            _ => Err("a strip, a zone and a strip".into()),
        }
    }
}

/// Names, and where there is room for them in the figure.
const NAMES: [(&str, Place); 4] = [
    ("reaction", [1e5, 1e-9]),
    ("lift-off", [1e11, 0.05]),
    ("penetration", [1e11, 1e-6]),
    ("largest pressure", [1e6, 300.0]),
];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let scene = example()?;
    let closed = palkki_evidence::paper::theory();
    let rigid = Rigid {
        bending: beam()?.bending_stiffness(),
        depth: scene.depth(0.0),
        load: scene.load().uniform(),
        lift_off: closed.lift_off.ok_or("the example has a zone")?,
        reaction: closed.reaction,
        force: closed.end_force,
    };
    let powers = (IN_A_POWER * POWERS[0]..=IN_A_POWER * POWERS[1]).map(|k| f64::from(k) / f64::from(IN_A_POWER));
    let answers = powers.map(|power| Answer::of(&rigid, 10_f64.powf(power))).collect::<Result<Vec<_>, _>>()?;
    let known = |ground: f64| answers.iter().find(|answer| answer.ground.total_cmp(&ground).is_eq()).cloned();
    let answer = |ground: f64| known(ground).map_or_else(|| Answer::of(&rigid, ground), Ok);
    let shown = |powers: &[i32]| powers.iter().map(|&power| answer(ten_to(power))).collect::<Result<Vec<_>, _>>();
    let orders: Vec<f64> = (0..NAMES.len()).map(|k| order(&answers, &rigid, k)).collect();
    let expected = [-0.75, -0.25, -0.75, 0.25];
    let within = largest(orders.iter().zip(expected).map(|(order, law)| order - law));

    let with_gap = shown(&WITH_GAP)?;
    let drawn = shown(&DRAWN)?;
    let values = context! {
        orders => orders.iter().map(|order| fixed(*order, 3)).collect::<Vec<_>>(),
        within => within,
        from => power_of_ten(POWERS[0]),
        to => power_of_ten(POWERS[1]),
        measured => MEASURED.map(power_of_ten),
        closed => bound(closed_form(&answers, &rigid)?),
        energy => energies(&answers, &rigid),
        rule => rule_table(&rigid)?,
        opens => opens(&scene, &rigid)?,
        strip => context! { length => strip().length, gap => strip().gap },
        approaches => approaches(&with_gap, &rigid)?,
        drawn => drawn.iter().map(|answer| told(answer)).collect::<Result<Vec<_>, _>>()?,
    };
    let data = numbers_data(&answers, &rigid);
    let figures = [
        study.drawn("how-stiff", values.clone(), 2, over_stiffness(&answers, &rigid), data)?,
        study.drawn("strip", values.clone(), 2, strips(&drawn)?, strips_data(&drawn)?)?,
    ];
    Evidence::new(values).figures(figures)
}

/// The power of `k` with which a number goes, between the powers that are measured.
fn order(answers: &[Answer], rigid: &Rigid, number: usize) -> f64 {
    let [from, to] = MEASURED.map(ten_to);
    let inside = answers.iter().filter(|answer| (0.99 * from..=1.01 * to).contains(&answer.ground));
    observed_order(&inside.map(|answer| (answer.ground, answer.numbers(rigid)[number])).collect::<Vec<_>>())
}

/// How far reaction, lift-off and largest pressure are off their closed form at most, relative, where it holds.
fn closed_form(answers: &[Answer], rigid: &Rigid) -> Result<f64, Cause> {
    /// Softer, the two ends of the zone feel each other.
    const APART: f64 = 1e4;
    /// What is asked of these numbers, and of the place of the largest pressure, beside which it hardly falls.
    const DIGITS: f64 = 1e-12;
    const PLACE: f64 = 1e-7;
    let length = beam()?.length();
    let mut most = f64::EPSILON;
    for answer in answers.iter().filter(|answer| APART <= answer.ground * 1.01 && answer.lever < gap_opens()) {
        let form = stiff(rigid.bending, rigid.depth, rigid.load, answer.ground);
        let state = answer.state();
        let (Some(contact), Some(pressure)) = (state.contacts.first(), state.pressure) else {
            return Err(format!("k = {}: no zone", answer.ground).into());
        };
        let pairs =
            [(state.reactions.left, form.reaction), (contact.from, form.lift_off), (pressure.max, form.pressure)];
        let off = largest(pairs.map(|(found, expected)| found / expected - 1.0));
        // Its mirror image is as large.
        let place = pressure.at.min(length - pressure.at) / form.at - 1.0;
        if DIGITS < off || PLACE < place.abs() {
            return Err(format!("k = {} is off its closed form by {off:e}, {place:e}", answer.ground).into());
        }
        most = most.max(off);
    }
    Ok(most)
}

/// What the energy lacks over its law, just before the gap opens and at the stiffest ground but for rounding.
fn energies(answers: &[Answer], rigid: &Rigid) -> Vec<Value> {
    /// A thousandth of what it lacks is rounding of the energy, 2·10⁻¹⁶ of 8, up to here.
    const DIGITS: f64 = 1e12;
    let rigid_energy = palkki_evidence::paper::theory().energy;
    let told = |answer: &Answer| {
        let decay = answer.lever / rigid.lift_off;
        let law = 2.0 * rigid.force * rigid.force / (12.0 * rigid.bending * decay * decay * decay);
        let over = (rigid_energy - answer.state().energy) / law;
        context! { stiffness => tolerance(answer.ground), over }
    };
    let at = |ground: f64| answers.iter().find(move |answer| (answer.ground / ground - 1.0).abs() < 1e-6);
    [1e6, DIGITS].into_iter().filter_map(at).map(told).collect()
}

fn numbers_data(answers: &[Answer], rigid: &Rigid) -> Table {
    let header = ["stiffness", "reaction_off", "lift_off_off", "penetration", "pressure", "contacts"];
    Table::new(header).rows(answers.iter().map(|answer| {
        let numbers = answer.numbers(rigid).map(|number| scientific(number, 4));
        let mut cells = row![scientific(answer.ground, 4)].to_vec();
        cells.extend(numbers);
        cells.extend(row![answer.state().contacts.len()]);
        cells
    }))
}

/// The stiffness for a number of digits, `k u/q = (10ⁿ/2)^{4/3}/6`, and what is lost there.
fn rule_table(rigid: &Rigid) -> Result<Table, Cause> {
    let mut table = Table::new([
        "digits",
        "λa",
        "k u/q",
        "settlement under the load alone, over u",
        "error of the reaction",
        "error of the largest moment",
    ]);
    for digits in DIGITS {
        let lever = (0.5 * ten_to(digits)).cbrt();
        let stiffness = lever.powi(4) / 6.0;
        let answer = Answer::of(rigid, stiffness * rigid.load / rigid.depth)?;
        let off = answer.numbers(rigid)[0];
        // R²/2q, where the shear force is zero.
        let largest = 0.5 * rigid.reaction * rigid.reaction / rigid.load;
        let moment = 1.0 - answer.state().moment.max / largest;
        if 1.1 * ten_to(-digits) < off {
            return Err(format!("{digits} digits are promised, and the reaction is off by {off:e}").into());
        }
        let numbers = [significant(lever, 3), significant(stiffness, 3), times_ten(1.0 / stiffness, 1)];
        table.push(row![digits].into_iter().chain(numbers).chain([off, moment].map(|off| times_ten(off, 1))));
    }
    Ok(table)
}

/// Where the gap opens: by the closed form, and by a sweep.
fn opens(scene: &Scene, rigid: &Rigid) -> Result<Value, Cause> {
    let lever = gap_opens();
    let stiffness = lever.powi(4) / 6.0 * rigid.load / rigid.depth;
    let scene = scene.on_springs(stiffness)?;
    let sweep = Sweep::new(&scene, "foundation.stiffness", [0.99 * stiffness, 1.01 * stiffness], 2)?;
    let events = sweep.events(&sweep.rows()?);
    let [event] = &events[..] else { return Err("one event where the gap opens".into()) };
    let apart = (event.value / stiffness - 1.0).abs();
    if 1e-9 < apart || !event.what.ends_with("splits") {
        return Err(format!("{}: {}, by the closed form the gap opens at {stiffness}", event.value, event.what).into());
    }
    Ok(context! { lever, stiffness => significant(stiffness, 6), apart => bound(apart.max(f64::EPSILON)) })
}

/// Length of the strip and of the gap over their laws.
fn over_laws(answer: &Answer, rigid: &Rigid) -> Result<[f64; 2], Cause> {
    let [from, to, zone] = answer.gap()?;
    let (decay, limit) = (answer.lever / rigid.lift_off, strip());
    let gap = limit.gap * (rigid.lift_off / (decay * decay)).cbrt();
    Ok([(to - from) * decay / limit.length, (zone - to) / gap])
}

/// Whether strip and gap come nearer to their laws from each stiffness to the next.
fn approaches(answers: &[Answer], rigid: &Rigid) -> Result<bool, Cause> {
    let off = answers.iter().map(|answer| Ok(over_laws(answer, rigid)?.map(|over| (over - 1.0).abs())));
    let off = off.collect::<Result<Vec<_>, Cause>>()?;
    Ok(off.windows(2).all(|pair| (0..2).all(|k| pair[1][k] < pair[0][k])))
}

fn told(answer: &Answer) -> Result<Value, Cause> {
    let [from, to, zone] = answer.gap()?;
    Ok(context! { stiffness => tolerance(answer.ground), from, to, zone })
}

/// What falls, and what grows, over the stiffness; the laws are dashed.
fn over_stiffness(answers: &[Answer], rigid: &Rigid) -> Vec<Panel> {
    /// One in so many answers is marked, one for each power of ten.
    const EACH: usize = 4;
    let points = |number: usize, law: bool| -> Vec<Place> {
        let of = |answer: &Answer| if law { answer.laws(rigid)[number] } else { answer.numbers(rigid)[number] };
        answers.iter().map(|answer| [answer.ground, of(answer)]).collect()
    };
    let panel = |label: &str, numbers: &[usize]| {
        let x = Axis { padding: 0.0, ..Axis::new("stiffness k [force/length²]").log() };
        let mut panel = Panel::new(x, Axis::new(label).log()).tall(900.0);
        for &number in numbers {
            let (color, whole) = (Style::of_series(number).color, points(number, false));
            let marks = whole.into_iter().step_by(EACH).collect();
            panel = panel
                .with(Layer::line(points(number, true), Style::theory()))
                .with(Layer::line(marks, Style::marks(color, Marker::OpenCircle)))
                .with(Layer::words(NAMES[number].1, color, NAMES[number].0));
        }
        panel
    };
    vec![panel("relative error, penetration over u", &[0, 1, 2]), panel("largest pressure over q", &[3])]
}

/// Places of a drawing: before and behind strip, gap and the beginning of the zone.
fn window(answer: &Answer) -> Result<[f64; 2], Cause> {
    let [from, to, zone] = answer.gap()?;
    let margin = to - from;
    Ok([from - margin, zone + 2.0 * margin])
}

const SAMPLES: u32 = 400;

/// Places of a drawing, with pressure and clearance there.
fn sampled(answer: &Answer) -> Result<Vec<[f64; 3]>, Cause> {
    let ([from, to], exact) = (window(answer)?, answer.exact()?);
    let places = (0..=SAMPLES).map(|i| from + (to - from) * f64::from(i) / f64::from(SAMPLES));
    Ok(places.map(|x| [x, exact.pressure(x), exact.clearance(x)]).collect())
}

/// Strip, gap and zone: pressure and clearance for each stiffness.
fn strips(answers: &[Answer]) -> Result<Vec<Panel>, Cause> {
    let mut panels = Vec::new();
    for answer in answers {
        let [from, to, zone] = answer.gap()?;
        let (samples, [start, end]) = (sampled(answer)?, window(answer)?);
        for (k, name, unit, color) in
            [(1, "pressure", "force/length", Color::VERMILLION), (2, "clearance", "length", Color::BLUE)]
        {
            // Where the beam hangs before the strip, its clearance is far greater than in the gap.
            let start = if k == 1 { start } else { from };
            let inside = samples.iter().filter(|sample| start <= sample[0]);
            let points: Vec<Place> = inside.map(|sample| [sample[0], sample[k]]).collect();
            let between = [([from, to], "strip"), ([to, zone], "gap"), ([zone, end], "zone")];
            let divisions = Divisions {
                lines: [from, to, zone].map(|x| (x, String::new())).to_vec(),
                between: between.map(|(ends, name)| (ends, name.to_owned())).to_vec(),
            };
            let (headroom, label) = (divisions.headroom(), format!("{name}, k = {}", tolerance(answer.ground)));
            panels.push(
                Panel::new(Axis::along("x [length]", [start, end]), Axis::new(label).unit(Some(unit.to_owned())))
                    .with(Layer::zero_line([start, end]))
                    .with(Layer::Area { points: points.clone(), level: 0.0, color })
                    .with(Layer::line(points, Style::solid(color)))
                    .with(Layer::Divisions(divisions))
                    .room(headroom, 10.0),
            );
        }
    }
    Ok(panels)
}

fn strips_data(answers: &[Answer]) -> Result<Table, Cause> {
    let mut table = Table::new(["stiffness", "x", "pressure", "clearance"]);
    for answer in answers {
        for [x, pressure, clearance] in sampled(answer)? {
            table.push(row![
                scientific(answer.ground, 0),
                fixed(x, 7),
                scientific(pressure, 4),
                scientific(clearance, 4)
            ]);
        }
    }
    Ok(table)
}
