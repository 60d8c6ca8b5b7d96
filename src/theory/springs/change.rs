//! Derivatives of the beam on ground that gives by the numbers of its scene.
//!
//! At the ends of the pressed stretches the pressure is zero, so that they do not move to the first order in what they carry: the
//! change `v'` of the deflection is that of the beam on springs on the same stretches, a linear problem (`cells`) with the same matrix:
//!
//! ```text
//! EI v'''' + k (v' − g') = q'        q' of a load;  g' = 1 as the ground sinks;  v' = 1 at a support that sinks
//!                         = −k w     as k grows by its logarithm, w = v − g
//!                         = k w − q  as EI does
//! a load P that moves: v'' jumps by −P/EI where it is
//! ```
//!
//! An end of a stretch, `w = 0`, moves by `−w'(x)/(dw/dx)`. The energy is the least one: its derivative is that of the functional alone.

use super::Springs;
use super::answer::{integral, rule};
use super::bearings::force;
use super::cells::{Drive, solve_driven};
use super::part::Part;
use crate::scene::{Quantity, Scene, Support};
use crate::theory::derivatives::{By, ContactDerivative, Derivative, Missing};
use crate::theory::exact::Exact;
use crate::theory::piecewise::PiecewiseScene;
use crate::theory::shape::Shape;

/// A force or a clearance of a support that only pushes below this share of the largest one: on the other side of it the support lifts
/// off or is touched.
const TIE: f64 = 1e-9;

/// By what the beam changes, in dimensionless numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Number {
    Depth,
    /// The logarithms of `k` and `EI`.
    Ground,
    Bending,
    /// The load over `EI`.
    Uniform,
    /// Force and place of a load at a breakpoint, the second with its size.
    Force(usize),
    Place(usize, f64),
    /// The level of what stands at a breakpoint.
    Level(usize),
}

/// A number that is asked for, its unit, and whether the other side differs.
struct Asked {
    by: By,
    number: Number,
    unit: f64,
    one_sided: bool,
}

impl Exact {
    /// The derivatives of this solution of a scene on ground that gives: by the depth of the ground, its stiffness and that of the
    /// beam, the uniform load, force and place of each point load, and the level of each support.
    pub(in crate::theory) fn derivatives_on_springs(&self, springs: &Springs, scene: &Scene) -> Vec<Derivative> {
        if !self.solved {
            return Vec::new();
        }
        self.asked_on_springs(scene).iter().filter_map(|asked| self.on_springs_by(springs, asked)).collect()
    }

    fn asked_on_springs(&self, scene: &Scene) -> Vec<Asked> {
        let (given, scale) = (&self.given, &self.scale);
        let breakpoint = |at: f64| given.breakpoints.partition_point(|b| b.x < at / scale.length);
        let largest = self.state.supports.iter().fold(self.state.contact_force(), |most, s| most.max(s.force.abs()));
        let deepest = self.state.deflection.magnitude();
        let is_tie = |at: &Support| {
            let pushed = self.state.supports.iter().find(|s| s.pushes_only && s.at.total_cmp(&at.at).is_eq());
            pushed.is_some_and(|s| match 0.0 < s.force {
                true => s.force <= TIE * largest,
                false => self.clearance(s.at) <= TIE * deepest,
            })
        };
        let ties = scene.beam().bearings().iter().any(is_tie);
        let mut all = Vec::new();
        let mut add = |by, number, unit, one_sided| all.push(Asked { by, number, unit, one_sided: one_sided || ties });
        let meets = scene.held().iter().any(|held| held.meets != [false; 2]);
        add(By::Depth, Number::Depth, scale.depth, meets);
        let ground = scene.ground_stiffness().unwrap_or(f64::NAN);
        add(By::Number(Quantity::GroundStiffness), Number::Ground, ground, false);
        add(By::Number(Quantity::BendingStiffness), Number::Bending, scene.beam().bending_stiffness(), false);
        add(By::Number(Quantity::Uniform), Number::Uniform, scale.force / scale.length, false);
        for (i, load) in scene.load().point().iter().enumerate() {
            let at = breakpoint(load.at);
            add(By::Number(Quantity::PointForce(i)), Number::Force(at), scale.force, false);
            let (size, ends) = (load.force / scale.force / self.stiffness, [0, given.cells.len()].contains(&at));
            add(By::Number(Quantity::PointAt(i)), Number::Place(at, size), scale.length, ends);
        }
        for (i, support) in scene.beam().supports_as_given().into_iter().enumerate() {
            let number = Number::Level(breakpoint(support.at));
            add(By::Number(Quantity::SupportLevel(i)), number, scale.depth, meets);
        }
        all
    }

    /// [`None`] where a number leaves the range of `f64`.
    fn on_springs_by(&self, springs: &Springs, asked: &Asked) -> Option<Derivative> {
        let Self { given, scale, .. } = self;
        let &Asked { by, number, unit, one_sided } = asked;
        let k = springs.stiffness;
        let (changed, drive) = self.changed(springs, number);
        let parts = solve_driven(&changed, k, &springs.stretches, &drive)?;
        let of_force = |value: f64| value * self.stiffness * scale.force / unit + 0.0;
        let supports = self.state.supports.iter().map(|support| {
            let at = given.breakpoints.partition_point(|b| b.x < support.at / scale.length);
            if given.support_at(at).is_none() {
                return 0.0;
            }
            let own = if number == Number::Bending { force(given, &springs.parts, at) } else { 0.0 };
            of_force(own + force(&changed, &parts, at))
        });
        let sunk = |parts: &[Part], [from, to]: [f64; 2]| -> f64 {
            let inside = parts.iter().filter(|part| part.pressed && from <= part.piece.lo && part.piece.hi <= to);
            inside.map(|part| k * integral(&part.penetration, part.piece.width())).sum()
        };
        let contact = |stretch: &[f64; 2]| {
            let own = if number == Number::Ground { sunk(&springs.parts, *stretch) } else { 0.0 };
            let [from, to] = [false, true]
                .map(|end| self.moved_end(springs, &parts, stretch[usize::from(end)], end) * scale.length / unit + 0.0);
            ContactDerivative { from, to, force: of_force(own + sunk(&parts, *stretch)), end_forces: None }
        };
        let contacts: Vec<ContactDerivative> = springs.stretches.iter().map(contact).collect();
        let energy = self.energy_on_springs_by(springs, number) * self.stiffness * scale.energy() / unit + 0.0;
        let determined = contacts.iter().all(|contact| contact.from.is_finite() && contact.to.is_finite());
        let missing = (!determined).then_some(Missing::Undetermined);
        Some(Derivative { by, one_sided, missing, supports: supports.collect(), contacts, energy })
    }

    /// The scene of the change, and what else acts there.
    fn changed<'a>(&self, springs: &'a Springs, number: Number) -> (PiecewiseScene, Drive<'a>) {
        let (mut changed, mut drive) = (self.given.clone(), Drive::default());
        let (loads, depth) = match number {
            Number::Bending => (-1.0, 0.0),
            Number::Depth => (0.0, 1.0),
            _ => (0.0, 0.0),
        };
        for cell in &mut changed.cells {
            (cell.load, cell.load_slope) = (loads * cell.load, loads * cell.load_slope);
            cell.load += if number == Number::Uniform { 1.0 / self.stiffness } else { 0.0 };
        }
        changed.shapes.fill(Shape::Line { origin: 0.0, depth, slope: 0.0 });
        for at in &mut changed.breakpoints {
            (at.force, at.step, at.kink) = (loads * at.force, 0.0, 0.0);
        }
        for support in &mut changed.supports {
            let is_it = matches!(number, Number::Level(at) if at == support.breakpoint);
            (support.level, support.slope) = (f64::from(u8::from(is_it)), support.slope.map(|_| 0.0));
        }
        match number {
            Number::Force(at) => changed.breakpoints[at].force = 1.0 / self.stiffness,
            Number::Place(at, force) => drive.couple = Some((at, -force)),
            Number::Ground => drive.sunk = Some((&springs.parts, -springs.stiffness)),
            Number::Bending => drive.sunk = Some((&springs.parts, springs.stiffness)),
            Number::Depth | Number::Uniform | Number::Level(_) => {}
        }
        (changed, drive)
    }

    /// How an end of a stretch moves: not at all at an end of the beam or at a step of the ground.
    fn moved_end(&self, springs: &Springs, parts: &[Part], x: f64, is_right: bool) -> f64 {
        let stands = |i: usize| i == 0 || i == self.given.cells.len() || self.given.breakpoints[i].step != 0.0;
        if self.given.breakpoint_at(x).is_some_and(stands) {
            return 0.0;
        }
        let inside = |part: &&Part| part.pressed && if is_right { x <= part.piece.hi } else { x <= part.piece.lo };
        let [change, own] = [parts, &springs.parts].map(|parts| parts.iter().find(inside));
        change.zip(own).map_or(f64::NAN, |(change, own)| -change.sunk(x)[0] / own.sunk(x)[1])
    }

    /// The derivative of `J / EI`, of `J` by the logarithms of both stiffnesses.
    fn energy_on_springs_by(&self, springs: &Springs, number: Number) -> f64 {
        let (given, rule) = (&self.given, rule(&self.given));
        let sum = |of: &dyn Fn(&Part, f64) -> f64| -> f64 {
            let part = |part: &Part| rule.integral(part.piece.lo, part.piece.hi, |x| of(part, x));
            springs.parts.iter().map(part).sum()
        };
        let sunk = |part: &Part, x: f64| if part.pressed { part.sunk(x)[0] } else { 0.0 };
        let at = |i: usize| springs.part(given.breakpoints[i].x, false).beam(given.breakpoints[i].x);
        match number {
            Number::Depth => -springs.stiffness * sum(&sunk),
            Number::Ground => 0.5 * springs.stiffness * sum(&|part, x| sunk(part, x) * sunk(part, x)),
            Number::Bending => 0.5 * sum(&|part, x| part.beam(x)[2] * part.beam(x)[2]),
            Number::Uniform => -sum(&|part, x| part.beam(x)[0]) / self.stiffness,
            Number::Force(i) => -at(i)[0] / self.stiffness,
            Number::Place(i, force) => -force * at(i)[1],
            Number::Level(i) => given.support_at(i).map_or(0.0, |_| -force(given, &springs.parts, i)),
        }
    }
}
