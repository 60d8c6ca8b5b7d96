//! The exact solution as data in the units of the scene, and its values along the beam for a table or a figure. There is no grid.

use super::list::{List, Node};
use super::piece::{Piece, derivatives};
use super::piecewise::PiecewiseScene;
use super::search::Candidate;
use super::span::Span;
use super::springs::Springs;
use super::summary;
use super::violation::Violation;
use crate::certificate::{Hung, Slope, Stretch};
use crate::scene::{Balance, Foundation, Scale, Scene};
use crate::state::{Contact, ContactState, Motion, Standing};

/// The exact solution of a scene; made by [`super::solve`].
#[derive(Debug, Clone)]
pub struct Exact {
    /// The beam in its final position; it has no nodes.
    pub state: ContactState,
    /// Whether every condition is satisfied along the whole beam, to 12 digits; otherwise this is the best answer that was found.
    pub solved: bool,
    /// Whether Newton's method converged for its contact list.
    pub converged: bool,
    /// Number of unknowns of the exact model: lift-off positions, and slopes at edges of the profile and at inner supports.
    pub unknowns: usize,
    /// Number of Newton steps, including steps on lists that failed their check.
    pub iterations: usize,
    /// Number of contact lists that were tried.
    pub lists: usize,
    /// Number of samples of the chains that proposed these lists.
    pub(super) samples: usize,
    /// Largest violation of any condition, relative to the largest deflection and moment, or to the forces next to a contact.
    pub residual: f64,
    /// The violated conditions; empty if the answer is solved.
    pub violations: Vec<Violation>,
    /// Moments that foundation and support together exert on the beam where the foundation starts at the level of a support and fixes
    /// the slope of the beam there. Each is the limit of a large downward reaction and a large upward contact force next to it. Not
    /// positive, mostly zero \[force · length\]. `state.reactions` contains the net force.
    pub support_couples: [f64; 2],
    pub(super) given: PiecewiseScene,
    pub(super) list: List,
    /// All contacts of the list, whether they press or not.
    pub(super) listed: Vec<Contact>,
    /// The contacts of the list that do not press, or press only in a part.
    pub(super) idle: Vec<Contact>,
    pub(super) spans: Vec<(usize, Span)>,
    /// Forces of the nodes of the list, over `EI`; at a support without a load directly on it.
    pub(super) forces: Vec<f64>,
    pub(super) pieces: Vec<Piece>,
    /// The answer on an elastic foundation, which has neither a list nor pieces.
    pub(super) springs: Option<Springs>,
    /// With loads, forces, moments and energies over the least `EI`.
    pub(super) units: Scale,
}

impl Exact {
    /// The word in tables for how the solution ended: `solved`, `not solved`, or `gave up` if Newton's method did not converge either.
    #[must_use]
    pub fn ended(&self) -> &'static str {
        crate::route::ended(self.solved, self.converged)
    }

    /// The answer in the units of the scene, from the result of the search.
    pub(super) fn new(given: PiecewiseScene, found: Candidate, units: Scale) -> Self {
        let state = summary::state(&given, &found).in_units_of(&units);
        let overflow = (!state.is_finite()).then_some(Violation::Overflow);
        let solved = found.solved() && overflow.is_none();
        let nothing = found.checked.nothing();
        let Candidate { list, checked, steps, lists, samples, converged } = found;
        let faults = checked.faults.iter().map(|(_, fault)| fault.in_units_of(&units));
        let violations = faults.chain(overflow).collect();
        let support_couples =
            [0.0, given.length].map(|end| couple(&given, &list, &checked.moments, end) * units.moment());
        let exact = Self {
            listed: state.contacts.clone(),
            idle: Vec::new(),
            state,
            solved,
            converged,
            unknowns: list.unknowns(&given),
            iterations: steps,
            lists,
            samples,
            residual: checked.worst,
            violations,
            support_couples,
            pieces: checked.pieces,
            springs: None,
            spans: checked.spans,
            forces: checked.forces,
            list,
            given,
            units,
        };
        // An answer that is not a solution shows all forces of its list, including tensile ones.
        if solved { exact.with_touches(&nothing) } else { exact }
    }

    /// Adds what the supports leave undetermined: `balance` in the units of the scene, `slopes` dimensionless.
    pub(super) fn balanced(mut self, balance: Balance, slopes: Option<[f64; 2]>) -> Self {
        let unit = self.units.slope();
        let motion = match balance {
            Balance::Neutral { about, .. } => {
                let slope = |slope: f64| slope.is_finite().then_some(slope * unit);
                slopes.map(|slopes| Motion { about, slope: slopes.map(slope) })
            }
            _ => None,
        };
        self.state.standing = balance.resultant().map(|resultant| Standing::of(&self.state, resultant, motion));
        self
    }

    /// Deflection `v(x)`, positive downwards \[length\].
    #[must_use]
    pub fn deflection(&self, x: f64) -> f64 {
        self.beam(x, true)[0] * self.units.depth
    }

    /// Slope `v'(x)`.
    #[must_use]
    pub fn slope(&self, x: f64) -> f64 {
        self.beam(x, true)[1] * self.units.slope()
    }

    /// Bending moment `M(x) = −EI v''` \[force · length\].
    #[must_use]
    pub fn moment(&self, x: f64) -> f64 {
        let [_, right] = self.moments(x);
        right
    }

    /// Bending moments just left and just right of `x`: they differ where a support fixes the slope or a couple acts.
    pub(crate) fn moments(&self, x: f64) -> [f64; 2] {
        // Adding zero turns −0.0 into 0.0.
        [false, true].map(|right| -self.beam(x, right)[2] * self.units.moment() + 0.0)
    }

    /// Shear force `V(x) = M'`, just left and just right of `x` \[force\].
    #[must_use]
    pub fn shear(&self, x: f64) -> [f64; 2] {
        [false, true].map(|right| -self.beam(x, right)[3] * self.units.force + 0.0)
    }

    /// Clearance `h = g − v` \[length\]; at a step the smaller value. Above a rigid compression-only support it is the distance to the
    /// support; without a foundation also above an elastic one. Infinite where there is nothing to touch.
    #[must_use]
    pub fn clearance(&self, x: f64) -> f64 {
        let bearing = self.given.breakpoint_at(x / self.units.length).filter(|&i| self.given.is_bearing(i));
        if let Some(bearing) = bearing {
            return (self.given.breakpoints[bearing].depth - self.beam(x, true)[0]) * self.units.depth;
        }
        if !self.given.founded {
            let stop = self.given.breakpoint_at(x / self.units.length).and_then(|i| self.given.stop_at(i));
            return stop.map_or(f64::INFINITY, |stop| (stop.level - self.beam(x, true)[0]) * self.units.depth);
        }
        let [left, right] = [false, true].map(|right| {
            if let Some(springs) = &self.springs {
                let x = x / self.units.length;
                let part = springs.part(x, right);
                return if 0.0 < part.ground { -part.sunk(x)[0] } else { f64::INFINITY };
            }
            let (piece, place) = self.piece(x, right);
            // At a break, use the cell on the same side as the piece.
            let cell = if right { self.given.cell_from(place) } else { self.given.cell_to(place) };
            let part = piece.part_in(&self.given, cell);
            let mut taylor = vec![0.0; self.given.terms];
            part.clearance(&self.given, &mut taylor);
            derivatives(&taylor, place - part.anchor)[0]
        });
        left.min(right) * self.units.depth
    }

    /// Contact pressure `p = q − EI u''''` inside a zone, without concentrated forces; zero outside \[force / length\].
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        if let Some(springs) = &self.springs {
            return springs.pressure(x / self.units.length) * self.units.pressure();
        }
        let (piece, at) = self.piece(x, true);
        if piece.state.is_some() || !self.given.founded {
            return 0.0;
        }
        -self.given.drive(piece.cell, at) * self.units.pressure()
    }

    /// Concentrated contact forces inside zones, under point loads and over elastic supports: `(position, force)`, upwards \[length,
    /// force\].
    pub fn forces_inside_zones(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let rigid = self.springs.is_none();
        let inside = move |x: f64| rigid && self.state.contacts.iter().any(|c| c.from < x && x < c.to);
        self.given
            .forces()
            .map(|j| (j.x, j.acts.force()))
            .chain(self.given.springs_in_zone(0.0, self.given.length).map(|(x, force)| (x, -force)))
            .map(|(x, force)| (x * self.units.length, force * self.units.force))
            .filter(move |&(x, _)| inside(x))
    }

    /// The supports at which the foundation fixes the slope of the beam, each with whether it does so from the left. A certificate
    /// needs them in addition to the positions of contacts.
    pub(crate) fn held(&self) -> Vec<(f64, bool)> {
        let held = |node: &Node| match node.slope {
            Slope::OfGround { from_the_left } => {
                node.support(&self.given).map(|_| (node.x * self.units.length, from_the_left))
            }
            Slope::Free(_) => None,
        };
        self.list.nodes.iter().filter_map(held).collect()
    }

    /// Whether the foundation is not elastic, so that there is a contact list.
    pub(crate) fn is_rigid(&self) -> bool {
        self.springs.is_none()
    }

    /// The deflection by parts in other units, which are powers of two; empty on an elastic foundation.
    pub(crate) fn curve(&self, to: &Scale) -> Vec<Hung> {
        let [along, deep] = [self.units.length / to.length, self.units.depth / to.depth];
        let mut taylor = vec![0.0; self.given.terms];
        let of = |piece: &Piece| {
            piece.deflection(&self.given, &mut taylor);
            let part = piece.hung(&taylor);
            let mut unit = deep;
            let deflection = part.deflection.iter().map(|c| {
                let scaled = c * unit;
                unit /= along;
                scaled
            });
            Hung { from: part.from * along, to: part.to * along, deflection: deflection.collect() }
        };
        self.pieces.iter().map(of).collect()
    }

    /// The stretches of a beam on an elastic foundation, in the units of [`Scene::scaled`](crate::scene::Scene::scaled). A certificate
    /// is proven from them.
    #[must_use]
    pub fn stretches(&self) -> Option<Vec<Stretch>> {
        Some(self.springs.as_ref()?.stretches().collect())
    }

    /// `∫ f(v, v', v'', v''') dx`, dimensionless.
    pub(super) fn integral(&self, f: impl Fn([f64; 4]) -> f64) -> f64 {
        let mut taylor = vec![0.0; self.given.terms];
        let of = |piece: &Piece| {
            piece.deflection(&self.given, &mut taylor);
            self.given.energy_rule.integral(piece.lo, piece.hi, |x| f(derivatives(&taylor, x - piece.anchor)))
        };
        self.pieces.iter().map(of).sum()
    }

    /// The piece at `x`, at a boundary the left or the right one, and the dimensionless position on it.
    fn piece(&self, x: f64, right: bool) -> (&Piece, f64) {
        let x = x / self.units.length;
        let i =
            if right { self.pieces.partition_point(|p| p.hi <= x) } else { self.pieces.partition_point(|p| p.hi < x) };
        let piece = &self.pieces[i.min(self.pieces.len() - 1)];
        (piece, x.max(piece.lo).min(piece.hi))
    }

    /// `v, v', e v'', e v'''` at `x`, dimensionless.
    fn beam(&self, x: f64, right: bool) -> [f64; 4] {
        if let Some(springs) = &self.springs {
            return springs.part(x / self.units.length, right).beam(x / self.units.length);
        }
        let (piece, place) = self.piece(x, right);
        let mut taylor = vec![0.0; self.given.terms];
        piece.deflection(&self.given, &mut taylor);
        piece.beam(&self.given, &taylor, place - piece.anchor)
    }
}

/// The moment that foundation and simple support together exert on the beam at one end.
fn couple(given: &PiecewiseScene, list: &List, moments: &[[f64; 2]], end: f64) -> f64 {
    let at_end = |node: &Node| node.is_held() && node.support(given).is_some() && node.x <= end && end <= node.x;
    let Some(i) = list.nodes.iter().position(at_end) else { return 0.0 };
    let ([left, right], own) = (moments[i], list.nodes[i].couple(given));
    if end <= 0.0 { right + own } else { left - own }
}

/// Values on one side of a position: where a force acts, the shear force differs between left and right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Position \[length\].
    pub x: f64,
    /// `v`, positive downwards \[length\].
    pub deflection: f64,
    /// `v'`.
    pub slope: f64,
    /// `h = g − v` \[length\]; infinite without a foundation.
    pub clearance: f64,
    /// Contact pressure, without concentrated forces \[force / length\].
    pub pressure: f64,
    /// `M = −EI v''`, positive with the underside in tension \[force · length\].
    pub moment: f64,
    /// `V = M'` \[force\].
    pub shear: f64,
}

impl Exact {
    /// Samples from end to end of `scene`, whose solution this is: the ends of equal intervals, and every position where something
    /// begins, ends or acts. At these positions, and where shear or pressure jumps, there are two samples, one for each side.
    #[must_use]
    pub fn samples(&self, scene: &Scene, intervals: u32) -> Vec<Sample> {
        let length = scene.beam().length();
        let mut samples = Vec::new();
        for x in self.places(scene, intervals) {
            let ([left, right], [bent_left, bent_right]) = (self.shear(x), self.moments(x));
            let turn = self.units.slope();
            let sample = |pressure, moment, shear, right| Sample {
                x,
                deflection: self.deflection(x),
                slope: self.beam(x, right)[1] * turn,
                clearance: self.clearance(x),
                pressure,
                moment,
                shear,
            };
            let jumps = self.state.contacts.iter().any(|c| sits_at(c.from, x) || sits_at(c.to, x));
            let loaded = scene.load().concentrated().any(|acts| sits_at(acts.at, x));
            let supported = scene.beam().all_supports().iter().any(|support| sits_at(support.at, x));
            let inside = 0.0 < x && x < length;
            let stiffened = scene.ground_changes().any(|at| sits_at(at, x));
            let joined = scene.beam().joints().iter().any(|joint| sits_at(joint.at, x));
            if 0.0 < x && (!inside || jumps || loaded || supported || joined || stiffened) {
                // The pressure at `x` is the value on its right side; one step to the left it is the value on the left side.
                let turned = scene.load().couple().iter().any(|load| sits_at(load.at, x));
                let moment = if supported || turned { bent_left } else { bent_right };
                samples.push(sample(self.pressure(x.next_down()), moment, left, !joined));
            }
            if x < length {
                samples.push(sample(self.pressure(x), bent_right, right, true));
            }
        }
        samples
    }

    fn places(&self, scene: &Scene, intervals: u32) -> Vec<f64> {
        let length = scene.beam().length();
        let even = (0..=intervals).map(|i| length * f64::from(i) / f64::from(intervals));
        let mut places: Vec<f64> = even.collect();
        places.extend(self.springs.iter().flat_map(Springs::places).map(|x| x * self.units.length));
        places.extend(self.state.contacts.iter().flat_map(|c| [c.from, c.to]));
        places.extend(scene.load().places(length));
        places.extend(scene.beam().joints().iter().map(|joint| joint.at));
        places.extend(scene.ground_changes());
        places.extend(scene.beam().all_supports().iter().map(|s| s.at).filter(|&at| 0.0 < at && at < length));
        for profile in scene.foundation().into_iter().chain(scene.beam().shape()) {
            if let Foundation::Polyline { points } = profile {
                places.extend(points.iter().map(|point| point[0]));
            }
        }
        places.retain(|x| (0.0..=length).contains(x));
        // −0.0 is a position on the beam as well.
        places.iter_mut().for_each(|x| *x += 0.0);
        places.sort_by(f64::total_cmp);
        places.dedup();
        places
    }
}

/// Whether two positions are the same bits: equal positions are computed in the same way.
fn sits_at(place: f64, x: f64) -> bool {
    place.total_cmp(&x).is_eq()
}
