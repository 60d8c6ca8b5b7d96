//! The exercise about the gap that a couple or a change of EI opens in contact.

use palkki::plot::{Axis, Color, Divisions, Layer, Panel, Place, Style};
use palkki::scene::Beam;
use palkki::solve_exactly;
use palkki::state::Contact;
use palkki::theory::Exact;
use palkki_evidence::closed::{Opened, opened};

use super::prelude::*;

/// Ratios of the two bending stiffnesses of the table.
const RATIOS: [f64; 4] = [1.01, 1.5, 2.0, 4.0];
/// Forces and places of the gap are computed to these digits of the beam; a gap that is a hundredth as long has two fewer.
const AGREES: f64 = 1e-10;

/// A gap and its law.
struct Found {
    name: String,
    /// Where the couple or the change of EI is.
    at: f64,
    /// The gap, and the forces at its ends.
    gap: [f64; 2],
    forces: [f64; 2],
    /// `D`, `p̄`, and the closed form.
    discontinuity: f64,
    pressure: f64,
    law: Opened,
    exact: Exact,
}

impl Found {
    /// Solves a scene whose contact is parted at mid-span.
    fn of(name: String, scene: &Scene) -> Result<Self, Cause> {
        let solution = solve_exactly(scene)?;
        if solution.verdict.status != Status::Certified {
            return Err(format!("{name}: {}", solution.verdict).into());
        }
        let exact = *solution.exact.ok_or("beam theory has functions")?;
        let [Contact { to, end_forces: Some([_, before]), .. }, Contact { from, end_forces: Some([behind, _]), .. }] =
            exact.state.contacts[..]
        else {
            return Err(format!("{name}: two zones with a gap between them").into());
        };
        let at = 0.5 * scene.beam().length();
        let ends = [scene.beam().bending_stiffness(), stiffness_behind(scene.beam())];
        // M in contact just beside the gap is −EI u''.
        let curved = -exact.moment(to) / ends[0];
        let discontinuity =
            scene.load().couple().iter().map(|couple| couple.moment).sum::<f64>() + (ends[1] - ends[0]) * curved;
        let (pressure, law) = (scene.load().uniform(), opened(ends[0] / ends[1]));
        Ok(Self { name, at, gap: [to, from], forces: [before, behind], discontinuity, pressure, law, exact })
    }

    fn length(&self) -> f64 {
        self.gap[1] - self.gap[0]
    }

    /// Length over the law for one bending stiffness, part before the discontinuity, forces at the ends over `p̄ℓ`.
    fn numbers(&self) -> [f64; 4] {
        let carried = self.pressure * self.length();
        let law = opened(1.0).length(self.discontinuity, self.pressure);
        let before = (self.at - self.gap[0]) / self.length();
        [self.length() / law, before, self.forces[0] / carried, self.forces[1] / carried]
    }

    /// The same by the closed form for both bending stiffnesses.
    fn closed(&self) -> [f64; 4] {
        let share = 1.0 / self.law.square;
        let length = (self.law.square / opened(1.0).square).sqrt();
        [length, self.law.before, 0.5 - share, 0.5 + share]
    }
}

fn stiffness_behind(beam: &Beam) -> f64 {
    beam.steps().last().map_or(beam.bending_stiffness(), |step| step[1])
}

/// The scene with another ratio of its two bending stiffnesses.
fn with_ratio(scene: &Scene, ratio: f64) -> Result<Scene, Cause> {
    let [first, [at, _]] = scene.beam().steps()[..] else { return Err("two steps".into()) };
    let beam = scene.beam().clone().with_steps(vec![first, [at, ratio * first[1]]])?;
    Ok(Scene::new(beam, scene.load().clone(), scene.foundation().cloned())?)
}

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let of = |name: &str| scenes::of(study.root, scenes::TAUGHT, name);
    let (couple, stiffer) = (of("couple")?, of("stiffer")?);
    let drawn = [Found::of("couple".to_owned(), &couple)?, Found::of("change of EI".to_owned(), &stiffer)?];
    let mut all = vec![Found::of("couple, one EI".to_owned(), &couple)?];
    for ratio in RATIOS {
        all.push(Found::of(format!("EI₂ = {} EI₁", significant(ratio, 3)), &with_ratio(&stiffer, ratio)?)?);
    }
    let header = [
        "case",
        "D",
        "gap ℓ",
        "ℓ over √(2√3 D/p̄)",
        "left part over ℓ",
        "force at its left end over p̄ℓ",
        "at its right end",
    ];
    let mut table = Table::new(header);
    let mut off = f64::EPSILON;
    for found in &all {
        off = off.max(largest(found.numbers().into_iter().zip(found.closed()).map(|(number, law)| number - law)));
        let cells = [significant(found.discontinuity, 3), fixed(found.length(), 5)];
        let numbers = found.numbers().map(|number| fixed(number, 4));
        table.push([found.name.clone()].into_iter().chain(cells).chain(numbers));
    }
    if AGREES < off {
        return Err(format!("a gap is off its closed form by {off:e}").into());
    }
    let values = context! {
        table,
        off => bound(off),
        before => opened(1.0).before,
        behind => 1.0 - opened(1.0).before,
        couple => drawn[0].discontinuity,
        gap => drawn[0].length(),
        height => drawn[0].exact.clearance_extremes(drawn[0].gap[0], drawn[0].gap[1]).max,
    };
    let data = data(&drawn);
    Evidence::new(values.clone()).figures([study.drawn("opened-gap", values, 2, panels(&drawn), data)?])
}

/// Places in and beside the gap.
fn places(found: &Found) -> impl Iterator<Item = f64> {
    const SAMPLES: u32 = 400;
    /// What is drawn on either side, over the gap.
    const BESIDE: f64 = 0.15;
    let ([from, to], margin) = (found.gap, BESIDE * found.length());
    let width = to - from + 2.0 * margin;
    (0..=SAMPLES).map(move |i| from - margin + width * f64::from(i) / f64::from(SAMPLES))
}

fn samples(found: &Found) -> Vec<[f64; 3]> {
    let mut places: Vec<f64> = places(found).chain([found.at.next_down(), found.at]).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places.into_iter().map(|x| [x, found.exact.clearance(x), found.exact.moment(x)]).collect()
}

/// One column for each scene: the clearance of the gap above, the moment below, dashed that of the beam if it lay on the ground.
fn panels(all: &[Found]) -> Vec<Panel> {
    let mut panels = Vec::new();
    for (k, what, unit) in [(1, "clearance h", "length"), (2, "moment M", "force · length")] {
        for found in all {
            let samples = samples(found);
            let ends = [samples[0][0], samples[samples.len() - 1][0]];
            let points: Vec<Place> = samples.iter().map(|sample| [sample[0], sample[k]]).collect();
            let between = [("long", [found.gap[0], found.at]), ("short", [found.at, found.gap[1]])];
            let divisions = Divisions {
                lines: [found.gap[0], found.at, found.gap[1]].map(|x| (x, String::new())).to_vec(),
                between: between.map(|(name, ends)| (ends, name.to_owned())).to_vec(),
            };
            let headroom = divisions.headroom();
            let axis = Axis::new(format!("{}: {what}", found.name)).unit(Some(unit.to_owned()));
            let axis = if k == 1 { axis } else { axis.down() };
            let color = if k == 1 { Color::BLUE } else { Color::VERMILLION };
            let mut panel = Panel::new(Axis { padding: 0.0, ..Axis::along("x [length]", ends) }, axis);
            if k == 1 {
                panel =
                    panel.with(Layer::zero_line(ends)).with(Layer::Area { points: points.clone(), level: 0.0, color });
            } else {
                let [before, behind] = [samples[0][2], samples[samples.len() - 1][2]];
                let jump = vec![[ends[0], before], [found.at, before], [found.at, behind], [ends[1], behind]];
                panel = panel.with(Layer::line(jump, Style::theory()));
            }
            panel = panel.with(Layer::line(points, Style::solid(color))).with(Layer::Divisions(divisions));
            panels.push(panel.room(headroom, 10.0));
        }
    }
    panels
}

fn data(all: &[Found]) -> Table {
    let mut table = Table::new(["scene", "x", "clearance", "moment"]);
    for found in all {
        for [x, clearance, moment] in samples(found) {
            table.push(row![found.name, fixed(x, 5), scientific(clearance, 4), fixed(moment, 6)]);
        }
    }
    table
}
