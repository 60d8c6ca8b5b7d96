//! Derivatives of the beam on an elastic foundation with respect to the numbers of its scene.
//!
//! The pressure is zero at the ends of the pressed stretches, so to first order their movement does not affect the forces. The change
//! `v'` of the deflection is the deflection of the beam on springs on the same stretches, a linear problem with the same matrix:
//!
//! ```text
//! EI v'''' + k (v' − g') = q'        q' of a load;  g' = 1 as the foundation settles;  v' = 1 at a support that settles
//!                         = −k w     as k grows by its logarithm, w = v − g
//!                         = k w − q  as EI does
//! a load P that moves: v'' jumps by −P/EI where it is
//! ```
//!
//! An end of a stretch, `w = 0`, moves by `−w'(x)/(dw/dx)`. The energy is at its minimum, so its derivative is the derivative of the
//! functional alone.

use super::answer::{integral, rule};
use super::bearings::force;
use super::chain::solve;
use super::{Part, Springs};
use crate::scene::{Scene, Support};
use crate::theory::acts::Acts;
use crate::theory::derivatives::{ContactDerivative, Derivative, Missing};
use crate::theory::exact::Exact;
use crate::theory::piecewise::PiecewiseScene;
use crate::theory::sensitivity::Change;
use crate::theory::shape::Shape;
use crate::theory::variation::{NOTHING, Variation};

/// Whether each support is inside the foundation: when a support enters it, a contact begins there.
fn standing(scene: &Scene) -> impl Iterator<Item = bool> + '_ {
    scene.beam().supports().iter().map(|support| scene.stands_in_ground(support))
}

impl Exact {
    /// The requested derivatives of this solution of a scene on an elastic foundation.
    pub(in crate::theory) fn derivatives_on_springs(
        &self,
        springs: &Springs,
        scene: &Scene,
        variations: Vec<Variation>,
    ) -> Vec<Derivative> {
        let ties = self.has_ties(scene);
        let by = |variation: Variation| {
            let is_alike = |other: &Scene| standing(scene).eq(standing(other));
            let one_sided =
                ties || variation.neighbouring_scenes(scene).iter().any(|other| !other.as_ref().is_some_and(is_alike));
            self.on_springs_by(springs, variation, one_sided)
        };
        variations.into_iter().filter(|_| self.solved).filter_map(by).collect()
    }

    /// Whether some compression-only support neither presses nor has a clearance.
    fn has_ties(&self, scene: &Scene) -> bool {
        let largest = self.state.supports.iter().fold(self.state.contact_force(), |most, s| most.max(s.force.abs()));
        let deepest = self.state.deflection.magnitude();
        let is_tie = |at: &Support| {
            let pushed = self.state.supports.iter().find(|s| s.pushes_only && s.at.total_cmp(&at.at).is_eq());
            pushed.is_some_and(|s| match 0.0 < s.force {
                true => s.force <= NOTHING * largest,
                false => self.clearance(s.at) <= NOTHING * deepest,
            })
        };
        scene.beam().bearings().iter().any(is_tie)
    }

    /// The derivative with respect to one number; [`None`] if a number leaves the range of `f64`.
    fn on_springs_by(&self, springs: &Springs, variation: Variation, one_sided: bool) -> Option<Derivative> {
        let Self { given, units, .. } = self;
        let Variation { by, change: [of, _], unit, .. } = variation;
        let k = springs.stiffness;
        // When a stiffness changes, the penetration acts as a load.
        let sunk = match of {
            Change::Stiffen => Some((&springs.parts[..], -k)),
            Change::Unload => Some((&springs.parts[..], k)),
            _ => None,
        };
        let changed = self.changed(of);
        let parts = solve(&changed, k, &springs.stretches, sunk)?.parts()?;
        let of_force = |value: f64| value * units.force / unit + 0.0;
        let supports = self.state.supports.iter().map(|support| {
            let at = given.breakpoints.partition_point(|b| b.x < support.at / units.length);
            if given.support_at(at).is_none() {
                return 0.0;
            }
            let own = if of == Change::Unload { force(given, &springs.parts, at) } else { 0.0 };
            of_force(own + force(&changed, &parts, at))
        });
        let sunk = |parts: &[Part], [from, to]: [f64; 2]| -> f64 {
            let first = parts.partition_point(|part| part.piece.lo < from);
            let inside = parts[first..].iter().take_while(|part| part.piece.hi <= to);
            let force = |part: &Part| part.ground * k * integral(&part.penetration, part.piece.width());
            inside.filter(|part| part.pressed).map(force).sum()
        };
        let contact = |stretch: &[f64; 2]| {
            let own = if of == Change::Stiffen { sunk(&springs.parts, *stretch) } else { 0.0 };
            let [from, to] = [false, true]
                .map(|end| self.moved_end(springs, &parts, stretch[usize::from(end)], end) * units.length / unit + 0.0);
            ContactDerivative { from, to, force: of_force(own + sunk(&parts, *stretch)), end_forces: None }
        };
        let contacts: Vec<ContactDerivative> = springs.stretches.iter().map(contact).collect();
        let energy = self.energy_on_springs_by(springs, of) * units.energy() / unit + 0.0;
        let determined = contacts.iter().all(|contact| contact.from.is_finite() && contact.to.is_finite());
        Some(Derivative {
            by,
            one_sided,
            missing: (!determined).then_some(Missing::Undetermined),
            supports: supports.collect(),
            contact_force: contacts.iter().fold(0.0, |sum, contact| sum + contact.force),
            contacts,
            energy,
        })
    }

    /// The scene of the change.
    fn changed(&self, of: Change) -> PiecewiseScene {
        let mut changed = self.given.clone();
        let (loads, depth, more) = match of {
            Change::Unload => (-1.0, 0.0, 0.0),
            Change::Ground => (0.0, 1.0, 0.0),
            Change::Uniform(more) => (0.0, 0.0, more),
            _ => (0.0, 0.0, 0.0),
        };
        for cell in &mut changed.cells {
            (cell.load, cell.load_slope) = (loads * cell.load + more, loads * cell.load_slope);
        }
        changed.shapes.fill(Shape::Line { origin: 0.0, depth, slope: 0.0 });
        for at in &mut changed.breakpoints {
            (at.acts, at.step, at.kink) = (at.acts.times(loads), 0.0, 0.0);
        }
        for support in &mut changed.supports {
            let is_it = matches!(of, Change::Level(at) if at == support.breakpoint);
            (support.level, support.slope) = (f64::from(u8::from(is_it)), support.slope.map(|_| 0.0));
            support.turning = support.turning.map(|[k, _]| [k, 0.0]);
        }
        for spring in &mut changed.springs {
            let is_it = matches!(of, Change::Level(at) if at == spring.breakpoint);
            (spring.level, spring.turning) = (f64::from(u8::from(is_it)), spring.turning.map(|[k, _]| [k, 0.0]));
        }
        let breakpoint = |x: f64| self.given.breakpoints.partition_point(|at| at.x < x);
        let mut act = |x: f64, jumps: [f64; 2]| changed.breakpoints[breakpoint(x)].acts = Acts::new(jumps);
        match of {
            Change::Force(x, more) => act(x, [0.0, more]),
            Change::Move(x, force) => act(x, [-force, 0.0]),
            _ => {}
        }
        changed
    }

    /// The movement of an end of a stretch: zero at an end of the beam, at a step, and at an end of the foundation.
    fn moved_end(&self, springs: &Springs, parts: &[Part], x: f64, is_right: bool) -> f64 {
        let ends = |i: usize| self.given.cells_beside(i).iter().any(|&cell| self.given.cells[cell].ground <= 0.0);
        let stands =
            |i: usize| i == 0 || i == self.given.cells.len() || self.given.breakpoints[i].step != 0.0 || ends(i);
        if self.given.breakpoint_at(x).is_some_and(stands) {
            return 0.0;
        }
        let before = |part: &Part| if is_right { part.piece.hi < x } else { part.piece.lo < x };
        let [change, own] = [parts, &springs.parts[..]]
            .map(|parts| parts[parts.partition_point(before)..].iter().find(|part| part.pressed));
        change.zip(own).map_or(f64::NAN, |(change, own)| -change.sunk(x)[0] / own.sunk(x)[1])
    }

    /// The derivative of `J / EI`; for both stiffnesses the derivative of `J` with respect to their logarithms.
    fn energy_on_springs_by(&self, springs: &Springs, of: Change) -> f64 {
        let (given, rule) = (&self.given, rule(&self.given));
        let sum = |of: &dyn Fn(&Part, f64) -> f64| -> f64 {
            let part = |part: &Part| rule.integral(part.piece.lo, part.piece.hi, |x| of(part, x));
            springs.parts.iter().map(part).sum()
        };
        let sunk = |part: &Part, x: f64| if part.pressed { part.sunk(x)[0] } else { 0.0 };
        let pushed = |part: &Part, x: f64| part.ground * sunk(part, x);
        let at = |x: f64| springs.part(x, false).beam(x);
        match of {
            Change::Ground => -springs.stiffness * sum(&pushed),
            Change::Stiffen => 0.5 * springs.stiffness * sum(&|part, x| pushed(part, x) * sunk(part, x)),
            Change::Unload => 0.5 * sum(&|part, x| part.beam(x)[2] * part.beam(x)[2] / part.stiffness),
            Change::Uniform(more) => -more * sum(&|part, x| part.beam(x)[0]),
            Change::Force(x, more) => -more * at(x)[0],
            Change::Move(x, force) => -force * at(x)[1],
            Change::Level(i) => given.support_at(i).map_or(0.0, |_| -force(given, &springs.parts, i)),
            // These derivatives are never requested here.
            Change::GroundUnder(..) | Change::Support(..) => 0.0,
        }
    }
}
