//! Error bounds: how far an answer is from solving its discrete problem ([`Kkt`]), and how far it is from the true deflection
//! ([`certify`]).
//!
//! This module uses no method and no solver, only the scene, the answer and a candidate contact list from any source (the witness).
//!
//! [`certify`] proves two-sided bounds for the continuous beam. [`Proof`] does this once for any number of answers. The gap `g = u − w0`
//! is the distance of the foundation below the undeflected beam. Supports prescribe `v(x_s) = d_s`, and `v'(x_s) = φ_s` where the beam is
//! built in. Consider any deflection `v̂ ≤ g` that satisfies the support conditions, and any contact load `p ≥ 0` with reactions `R` of
//! any sign. Their moment field `M` satisfies `M'' = p + Σ R_s δ − q`, with couples where the beam is built in and `M = M' = 0` beyond
//! both ends. With `J` of (17) (Prager and Synge 1947, Repin 2000):
//!
//! ```text
//! D(p, R) ≤ J* ≤ J(v̂),     D(p, R) = −½ ∫ M²/EI dx − ∫ g dp − Σ R_s d_s [− Σ couples · φ_s]
//! J(v̂) − D(p, R) = ½ ∫ (EI v̂'' + M)²/EI dx + ∫ (g − v̂) dp = gap        the duality gap: both terms ≥ 0, nothing cancels
//! ½ ∫ EI (v̂'' − v*'')² dx + ∫ (g − v*) dp ≤ gap
//! |v̂ − v*|(x) ≤ √( 2 gap c(x, x) ),     c = x² (l − x)² / (3 EI l) on two supports at the ends
//! |v − v*| ≤ |v − v̂| + |v̂ − v*|                                          for the deflection v that is judged
//! ```
//!
//! A compression-only support counts as a point of the foundation: `g` is smaller there than next to it, and its force is a part of `p`.
//! Nothing above requires `g` to be continuous. Next to an elastic foundation such a support counts as a bilateral support, or as none
//! (module `bearings`).
//!
//! The flexibility `c` on other supports, and its replacement where only contact restrains the beam, are in `kernel/reference.rs`.
//!
//! This carries out the paper's closing remark: the structural stiffness is bounded from both sides if there is no tension and no
//! penetration between the nodes.
//!
//! The pair `(v̂, M)` follows from the **witness**. In its zones `v̂` is `g`. Between them `v̂` is the exact beam, with slopes that
//! follow from the positions by one linear system (module `witness`). For the true list the duality gap is zero. It grows with the square
//! of the error of a position. No position is changed. Interval arithmetic proves that `v̂` and `p` are admissible, everywhere and for
//! every kind of foundation. What cannot be proven is corrected, and the correction adds to the duality gap (modules `proof`,
//! `clearance`, `pressing` of the `kernel`). So a wrong witness makes the bounds wide, but never false.
//!
//! One assumption is made: a foundation is known to a few units in the last place of its terms. Three comparisons are made within this
//! rounding. If the depth of the foundation at a support equals the level of the support, the support is at the surface of the
//! foundation. If the slope of the foundation there equals the prescribed slope, the beam is built in along the foundation. Points of a
//! polyline that are on one line are treated as on one line. `scene::pieces` decides what is equal within rounding, `scene::balance`
//! whether loads are in balance.
//!
//! All numbers are rounded outwards: the inequalities are true for the printed numbers.

mod bearings;
mod beside;
mod contact_load;
mod double_sum;
mod enclosed;
mod judged;
mod kernel;
mod kkt;
mod largest;
mod lumped;
mod moments;
mod quantities;
pub(crate) mod spread;
mod standing;
mod stretches;
mod summed;
mod support_forces;
mod violations;
mod witness;

pub use contact_load::{ContactLoad, NotAForce};
pub use judged::Judged;
pub use kernel::interval::Interval;
pub(crate) use kkt::least_deflection;
pub use kkt::{CERTIFIED_RESIDUAL, Kkt};
pub use lumped::{Lumped, NotLumped};
pub use quantities::stiffness;
pub use stretches::Stretch;
pub(crate) use violations::violations_by;
pub use violations::{Violation, ViolationKind, violations, violations_at_nodes};

use self::enclosed::{Said, enclosed, in_intervals, with_springs};
use self::judged::{of_curves, of_nodes, of_witness};
use self::kernel::contact_node::EnclosedScene;
use self::kernel::distance::{self, Error};
use self::kernel::held::hold_by_zones;
use self::kernel::proof::{self, Pair, Piece};
pub(crate) use self::kernel::tension::{Hung, MOST_TERMS};
use self::largest::extremes;
use self::quantities::energy;
use self::standing::Standing;
use crate::scene::{Scale, Scaled, Scene, SceneError};
use crate::state::{Contact, ContactState};
pub(crate) use kernel::contact_node::Slope;
#[cfg(feature = "proof")]
pub(crate) use witness::tridiagonal;

/// Bounds for one deflection, proven from a witness: see [`Proof`].
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled, and [`SceneError::NotKnown`] for forces that alone do
/// not determine how the beam bends: a [`Witness`](crate::Witness) can judge some of these.
pub fn certify(scene: &Scene, judged: Judged<'_>, witness: &[Contact]) -> Result<Certificate, SceneError> {
    if matches!(judged, Judged::Forces(_)) {
        scene.has_to_bend_under_forces("a bound from a list of contacts")?;
    }
    Ok(Proof::of(scene, witness)?.judge(judged))
}

/// The pair that a witness proves for a scene, and the bounds that follow for any number of deflections.
#[derive(Debug)]
pub struct Proof {
    scaled: Scaled,
    /// With brackets of the greatest and the least deflection of `v̂`.
    pair: Option<(Pair, [Interval; 2])>,
    /// The bounds that do not depend on the judged deflection.
    known: Certificate,
}

impl Proof {
    /// Proves a pair from a witness: the contacts of the beam, from any source. Only their positions count. A contact with a length is a
    /// zone. A wrong witness makes the bounds wide, but never false.
    ///
    /// # Errors
    ///
    /// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled.
    pub(crate) fn of(scene: &Scene, witness: &[Contact]) -> Result<Self, SceneError> {
        Self::of_held(scene, witness, &[], &[], &[])
    }

    /// Proves a pair from a witness and more data: `held` contains the positions of supports at which the foundation fixes the slope, and
    /// whether it does so from the left; `springs` the forces of elastic supports from left to right, and the jump of the moment at each;
    /// `hung` the deflection between contacts under an axial force, in the units of [`Scene::scaled`].
    ///
    /// # Errors
    ///
    /// The errors of [`Proof::of`].
    pub(crate) fn of_held(
        scene: &Scene,
        witness: &[Contact],
        held: &[(f64, bool)],
        springs: &[[f64; 2]],
        hung: &[Hung],
    ) -> Result<Self, SceneError> {
        scene.on_rigid_ground("a certificate from a list of contacts")?;
        let scaled = scene.scaled()?;
        let Scale { length, force, .. } = scaled.scale;
        let said = scaled.scene.springs().enumerate().map(|(i, spring)| {
            /// If the clearance is below this share of gap or deflection, rounding leaves open whether the beam touches the foundation.
            const NEAR: f64 = 1e-9;
            let [pushed, turned] = springs.get(i).copied().unwrap_or_default();
            let (pushed, gap) = (pushed / force, scaled.scene.gap(spring.at));
            let sunk = spring.deflection + pushed / spring.stiffness;
            let touches = witness.iter().any(|c| c.from / length <= spring.at && spring.at <= c.to / length);
            let near = gap.is_finite() && gap - sunk <= NEAR * gap.abs().max(sunk.abs());
            (touches || near, [pushed, turned / scaled.scale.moment()])
        });
        let said: Vec<_> = said.collect();
        let (pair, known) = with_springs(&scaled.scene, scaled.balance, (&said, hung), |enclosed| {
            of_pair(enclosed, &scaled, best_pair(enclosed, witness, held, &scaled.scale))
        });
        Ok(Self { scaled, pair, known })
    }

    /// Proves a pair on an elastic foundation from stretches in the units of [`Scene::scaled`]: the parts in which the foundation is
    /// compressed, and the penetration of the beam there. Stretches of a wrong answer make the bounds wide, but never false.
    ///
    /// # Errors
    ///
    /// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled.
    pub fn of_stretches(scene: &Scene, witness: &[Stretch]) -> Result<Self, SceneError> {
        Self::of_stretches_on(scene, witness, (&[], &[]))
    }

    /// The same with data on elastic supports and, under an axial force, with the deflection between contacts, as for `of_held`.
    pub(crate) fn of_stretches_on(scene: &Scene, witness: &[Stretch], of: Said<'_>) -> Result<Self, SceneError> {
        let (on, hung) = of;
        let scaled = scene.scaled()?;
        let held = bearings::held(&scaled.scene, witness)?;
        let units = [scaled.scale.force, scaled.scale.moment()];
        let said = |i: usize| (false, on.get(i).map_or([0.0; 2], |on| [on[0] / units[0], on[1] / units[1]]));
        let said: Vec<_> = (0..held.beam().springs().len()).map(said).collect();
        let proven = with_springs(&held, scaled.balance, (&said, hung), |enclosed| {
            let cut = stretches::cut(enclosed, witness);
            let (pair, known) = of_pair(enclosed, &scaled, kernel::springs::pair(enclosed, &cut));
            let known = bearings::of_scene(&scaled.scene, enclosed, &pair.as_ref()?.0, &known)?;
            Some((pair, known))
        });
        let supports = scaled.scene.beam().all_supports().len();
        let (pair, known) = proven.unwrap_or_else(|| (None, Certificate::unknown(supports)));
        Ok(Self { scaled, pair, known })
    }

    /// Bounds for a deflection. For forces that [`certify`] rejects, the bounds on the deflection are infinite.
    #[must_use]
    pub fn judge(&self, judged: Judged<'_>) -> Certificate {
        let Scaled { scene, scale, balance } = &self.scaled;
        let known = self.pair.as_ref().and_then(|(pair, ends)| match judged {
            Judged::Nodes(nodes) => in_intervals(scene, *balance, |enclosed| of_nodes(enclosed, scale, pair, nodes)),
            Judged::Forces(forces) => {
                scene.bends_under_forces().then_some(())?;
                let caused =
                    in_intervals(scene, *balance, |enclosed| spread::caused(scene, enclosed, &forces.scaled(scale)))?;
                of_curves(scene.beam(), pair, &caused)
            }
            Judged::Witness => of_witness(pair, *ends, scene.beam()),
        });
        // For a beam that can rotate, any position is as good as the position of the witness, which is not a given deflection.
        let given = !(self.known.up_to_a_turn.is_some() && matches!(judged, Judged::Witness));
        self.with(known, given)
    }

    /// Bounds for a deflection given by parts from end to end, in the units of [`Scene::scaled`].
    pub(crate) fn judge_curve(&self, curve: &[Hung]) -> Certificate {
        let curves: Vec<_> = curve.iter().map(Hung::curve).collect();
        self.with(self.pair.as_ref().and_then(|(pair, _)| of_curves(self.scaled.scene.beam(), pair, &curves)), true)
    }

    /// The bounds for any deflection, completed by the error bound of one.
    fn with(&self, known: Option<(Error, f64)>, given: bool) -> Certificate {
        let (certificate, scale) = (self.known.clone(), &self.scaled.scale);
        let Some((error, least)) = known else { return certificate };
        // A deflection is given in 64 bits: no bound on its error is below half a unit in its last place.
        let rounding = if given { 0.5 * f64::EPSILON * error.size } else { 0.0 };
        Certificate {
            deflection_error: error.most.max(rounding) * scale.depth,
            deflection_error_at: error.at * scale.length,
            deflection: error.size * scale.depth,
            deflection_at_least: least * scale.depth,
            at_rest: error.most.max(error.size) <= f64::MIN_POSITIVE,
            ..certificate
        }
    }
}

/// A pair with brackets of the greatest and the least deflection of `v̂`, and the bounds for any deflection.
fn of_pair(
    enclosed: &EnclosedScene<'_>,
    scaled: &Scaled,
    pair: Option<Pair>,
) -> (Option<(Pair, [Interval; 2])>, Certificate) {
    let Some(pair) = pair else { return (None, Certificate::unknown(enclosed.all_supports().len())) };
    let ends = extremes(pair.pieces.iter().map(|p| ([p.from, p.to], p.v)));
    let known = Certificate::of_any(enclosed, scaled, &pair, ends);
    (Some((pair, ends)), known)
}

/// The pair that a list of contacts proves. If it is not sharp, the best of four: the pair of the list, of the list with touched corners
/// added, of the list without contacts of zero force, and of a beam without contact. So there is a bound for every beam that its supports
/// hold, whatever the list.
///
/// A beam in balance above a corner can rotate about it, unless the foundation next to it leaves only one position. This is tried first.
fn best_pair(enclosed: &EnclosedScene<'_>, contacts: &[Contact], held: &[(f64, bool)], scale: &Scale) -> Option<Pair> {
    if enclosed.balanced_at.is_some() {
        let stopped = EnclosedScene { balanced_at: None, ..*enclosed };
        let known = best_pair(&stopped, contacts, held, scale).filter(|pair| is_sharp(&stopped, pair));
        if known.is_some() {
            return known;
        }
    }
    let of = |contacts: &[Contact]| {
        let nodes = witness::nodes(enclosed, contacts, held, scale);
        let mut pair = proof::pair(enclosed, &nodes)?;
        let mut sharp = is_sharp(enclosed, &pair);
        if !sharp {
            hold_by_zones(enclosed, &nodes, &mut pair);
            sharp = is_sharp(enclosed, &pair);
        }
        Some((pair, sharp))
    };
    let better = |one: Option<(Pair, bool)>, other: Option<(Pair, bool)>| {
        one.into_iter().chain(other).min_by(|(a, _), (b, _)| a.gap.total_cmp(&b.gap))
    };
    let mut proven = of(contacts);
    let is_open = |proven: &Option<(Pair, bool)>| proven.as_ref().is_none_or(|(_, sharp)| !sharp);
    if is_open(&proven) && enclosed.supports.len() < 2 {
        let touched = proven.as_ref().and_then(|(pair, _)| witness::with_touched(enclosed, contacts, pair, scale));
        proven = better(proven, touched.and_then(|touched| of(&touched)));
    }
    // A touched position without a force is no contact if another contact is next to it.
    let presses = |contact: &&Contact| contact.from < contact.to || contact.force.abs() > 0.0;
    if is_open(&proven) && !contacts.iter().all(|contact| presses(&contact)) {
        proven = better(proven, of(&contacts.iter().filter(presses).copied().collect::<Vec<_>>()));
    }
    if is_open(&proven) {
        let none = of(&[]).map(|(none, sharp)| (Pair { lifted: f64::INFINITY, ..none }, sharp));
        proven = better(proven, none);
    }
    proven.map(|(pair, _)| pair)
}

/// Whether a pair bounds the deflection to a millionth of its largest value.
fn is_sharp(enclosed: &EnclosedScene<'_>, pair: &Pair) -> bool {
    /// The required accuracy of an exact answer ([`EXACT`](crate::verdict::EXACT)), repeated here because the certificate does not use
    /// the verdict.
    const SHARP: f64 = 1e-6;
    let width = |p: &Piece| Interval::exact(p.to) - Interval::exact(p.from);
    let size = pair.pieces.iter().fold(0.0, |most: f64, p| most.max(p.v.range(width(p)).magnitude()));
    distance::anywhere(pair, enclosed.stiffness, enclosed.length) <= SHARP * size
}

/// Bounds for the continuous beam, in the units of the scene. Infinite where nothing could be proven.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// A lower bound of `J*`: `D(p)` of the contact load.
    pub energy_lower: f64,
    /// An upper bound of `J*`: `J(v̂)` of an admissible deflection.
    pub energy_upper: f64,
    /// The duality gap: an upper bound of `J(v̂) − D(p)`, without cancellation.
    pub gap: f64,
    /// An upper bound of `max |v − v*|` over the whole beam; see [`up_to_a_turn`](Self::up_to_a_turn).
    pub deflection_error: f64,
    /// Position of the largest error bound.
    pub deflection_error_at: f64,
    /// An upper bound of `max |v̂ − v*|` for the constructed admissible deflection `v̂`. It shows how well the true deflection is known,
    /// even if the judged deflection is far from it.
    pub best_deflection_error: f64,
    /// The largest magnitude of the judged deflection, rounded up.
    pub deflection: f64,
    /// The largest magnitude of the judged deflection, rounded down: a value that is reached somewhere; zero for a deflection at grid
    /// nodes.
    pub deflection_at_least: f64,
    /// Whether the beam and the judged deflection are both proven to be at rest: in dimensionless numbers, deflection and error are zero
    /// except for the smallest normal number, by which bounds are rounded up.
    pub at_rest: bool,
    /// The position about which the beam can rotate without a force, if neither supports nor loads determine its position. The true
    /// deflection is then known up to such a rotation, and the errors of deflections are errors after the best rotation.
    pub up_to_a_turn: Option<f64>,
    /// Brackets of all reactions, from left to right; [`None`] where nothing could be proven.
    pub reactions: Vec<Option<[f64; 2]>>,
    /// A bracket of the total contact force, upwards; [`None`] if the force of a support is not known.
    pub contact_force: Option<[f64; 2]>,
    /// A bracket of the greatest deflection of the beam; [`None`] where nothing could be proven, and for a beam that can rotate.
    pub deflection_max: Option<[f64; 2]>,
    /// Brackets of the greatest and of the least moment of the beam; [`None`] where nothing could be proven.
    pub moments: [Option<[f64; 2]>; 2],
    /// A bracket of the structural stiffness `D`; see [`stiffness`]. [`None`] if the sign of `J*` is open, and for any beam other than
    /// the paper's, because the load does not do the work of a settlement.
    pub stiffness: Option<[f64; 2]>,
    /// Whether the true deflection is known to a millionth of its largest value. The contacts of the witness are then the contacts of the
    /// beam, except for smaller differences. Otherwise the bounds are coarse.
    pub contacts_proven: bool,
}

impl Certificate {
    /// The certificate of a beam on some number of supports for which nothing could be proven.
    fn unknown(supports: usize) -> Self {
        Self {
            energy_lower: f64::NEG_INFINITY,
            energy_upper: f64::INFINITY,
            gap: f64::INFINITY,
            deflection_error: f64::INFINITY,
            deflection_error_at: 0.0,
            best_deflection_error: f64::INFINITY,
            deflection: f64::INFINITY,
            deflection_at_least: 0.0,
            at_rest: false,
            up_to_a_turn: None,
            reactions: vec![None; supports],
            contact_force: None,
            deflection_max: None,
            moments: [None; 2],
            stiffness: None,
            contacts_proven: false,
        }
    }

    /// The brackets of the greatest and the least moment, for a state of beam theory. [`None`] for the moments of a grid, for which
    /// nothing is proven.
    #[must_use]
    pub fn moments_beside(&self, state: &ContactState) -> Option<[Option<[f64; 2]>; 2]> {
        state.nodes.is_none().then_some(self.moments)
    }

    /// The bounds for any deflection. All unit factors are powers of two: only exponents change.
    fn of_any(enclosed: &EnclosedScene<'_>, scaled: &Scaled, pair: &Pair, [greatest, _]: [Interval; 2]) -> Self {
        let (scene, scale, gap) = (&scaled.scene, &scaled.scale, pair.gap);
        let standing = Standing::of(enclosed, scene.load());
        let ground = pair.ground.as_ref().map_or(Interval::ZERO, |sprung| sprung.energy);
        let energy = standing.energy(energy(&pair.pieces, enclosed) + ground + pair.turned);
        let energies = [(Interval::exact(energy.lo()) - Interval::exact(gap)).lo(), energy.hi()];
        let stiffness =
            if scene.beam().is_simple() { stiffness(energies, scene.load(), enclosed.length) } else { None };
        let in_units = |unit: f64| move |of: Interval| [of.lo() * unit, of.hi() * unit];
        let (mut reactions, contact_force) = support_forces::forces(scene, &standing.others, enclosed, pair);
        for (x, force) in enclosed.all_supports().into_iter().zip(&mut reactions) {
            *force = force.map(|force| standing.force(x, force));
        }
        let error = distance::anywhere(pair, enclosed.stiffness, enclosed.length);
        let deflection = Some(greatest + Interval::around_zero(error)).filter(|_| pair.turns_about.is_none());
        Self {
            energy_lower: energies[0] * scale.energy(),
            energy_upper: energies[1] * scale.energy(),
            gap: gap * scale.energy(),
            best_deflection_error: error * scale.depth,
            up_to_a_turn: pair.turns_about.map(|x| x * scale.length),
            contact_force: contact_force.map(in_units(scale.force)),
            reactions: reactions.into_iter().map(|bracket| bracket.map(in_units(scale.force))).collect(),
            deflection_max: deflection.filter(|bracket| bracket.is_finite()).map(in_units(scale.depth)),
            moments: moments::moments(enclosed, pair).map(|bracket| bracket.map(in_units(scale.moment()))),
            stiffness: stiffness.map(|d| d.map(|d| d * (scale.force / scale.depth))),
            contacts_proven: is_sharp(enclosed, pair),
            ..Self::unknown(0)
        }
    }
}
