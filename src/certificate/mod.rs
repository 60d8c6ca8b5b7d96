//! The judge: how far an answer is from solving its discrete problem ([`Kkt`]), and how far from the truth ([`certify`]).
//!
//! The judge is no contestant: it uses no method and no solver, only the scene, the answer and a list of contacts from anybody.
//!
//! [`certify`] proves two-sided bounds for the continuous beam.
//! For any deflection `v̂ ≤ u` with `v̂(0) = v̂(l) = 0`, and any contact load `p ≥ 0` with its moment field `M`
//! (`M'' = p − q`, `M(0) = M(l) = 0`), with `J` of (17) (Prager and Synge 1947, Repin 2000):
//!
//! ```text
//! D(p) ≤ J* ≤ J(v̂),     D(p) = −½ ∫ M²/EI dx − ∫ u dp
//! J(v̂) − D(p) = ½ ∫ (EI v̂'' + M)²/EI dx + ∫ (u − v̂) dp = gap           both terms ≥ 0: nothing cancels
//! ½ ∫ EI (v̂'' − v*'')² dx ≤ gap,     |v̂ − v*|(x) ≤ √( 2 gap x² (l − x)² / (3 EI l) )
//! |v − v*| ≤ |v − v̂| + |v̂ − v*|                                          for the deflection v that is judged
//! ```
//!
//! This is the paper's closing remark, that the structural stiffness is bounded from both sides if there is no tension and no
//! penetration between the nodes, carried out.
//!
//! The pair `(v̂, M)` follows from a **witness**, a list of contacts from anybody: `v̂` is the foundation in its zones and the
//! exact beam between them, with slopes that one linear system gives (module `witness`). For the true list the gap is zero, and
//! it grows with the square of what a place is off by. Nothing is looked for here. That `v̂` and `p` are admissible is proven in
//! interval arithmetic, everywhere and for every kind of foundation, and what cannot be proven is corrected at its price (modules
//! `proof`, `clearance`, `pressing` of the `kernel`). So a witness may be wrong: that makes the bounds wide, and never untrue.
//!
//! What is taken for given: a foundation is known to a few units in the last place of its terms. If its depth at a support is
//! zero but for that, it is level with it; points of a polyline that are on one line but for that, are on one line. What a scene
//! is up to rounding is said in `scene::pieces`.
//!
//! All numbers are rounded outwards: the inequalities hold for what is printed.

mod contact_load;
mod kernel;
mod kkt;
mod lumped;
mod quantities;
mod violations;
mod witness;

pub use contact_load::{ContactLoad, NotAForce};
pub use kernel::interval::Interval;
pub use kkt::{CERTIFIED_RESIDUAL, Kkt};
pub use lumped::{Lumped, NotLumped};
pub use quantities::stiffness;
pub use violations::{Violation, ViolationKind, violations, violations_at_nodes};

use self::kernel::contact_node::EnclosedScene;
use self::kernel::distance::{self, Error};
use self::kernel::foundation::EnclosedFoundation;
use self::kernel::load::EnclosedLoad;
use self::kernel::proof::{self, Pair, Piece};
use self::quantities::{energy, reactions};
use crate::scene::{Foundation, Load, Scale, Scene, SceneError};
use crate::state::{Contact, Nodes};

/// The deflection that is judged.
#[derive(Debug, Clone, Copy)]
pub enum Judged<'a> {
    /// That of the nodes of a grid: the cubics that deflections and moments at the nodes make between them.
    Nodes(&'a Nodes),
    /// The one that contact forces cause, by statics and integration under the true load.
    Forces(&'a ContactLoad),
    /// The one that the places of the witness make.
    Witness,
}

/// Bounds for a deflection, proven from a witness: the contacts of the beam, from anybody. Only their places count, and where
/// one of them has a length it is a zone. A witness that is wrong makes the bounds wide, and never wrong.
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled.
pub fn certify(scene: &Scene, judged: Judged<'_>, witness: &[Contact]) -> Result<Certificate, SceneError> {
    /// Where there is no foundation it is out of reach.
    const NONE: Foundation = Foundation::Flat { depth: f64::INFINITY };
    let scaled = scene.scaled()?;
    let (scene, scale) = (&scaled.scene, &scaled.scale);
    let fewer = scene.foundation().and_then(Foundation::without_collinear_points);
    let foundation = fewer.as_ref().or(scene.foundation()).unwrap_or(&NONE);
    let (stiffness, length) = (scene.beam().bending_stiffness(), scene.beam().length());
    let load = EnclosedLoad::of(scene);
    let enclosed =
        EnclosedScene { foundation: EnclosedFoundation::on(foundation, length), load: &load, stiffness, length };
    let Some(pair) = pair(&enclosed, witness, scale) else { return Ok(Certificate::UNKNOWN) };
    let error = match judged {
        Judged::Nodes(nodes) => distance::of_nodes(&pair, nodes, scale, stiffness, length),
        Judged::Forces(forces) => {
            let caused = contact_load::deflection(&forces.scaled(scale), &load, &[], stiffness, length);
            distance::of_pieces(&pair, &caused, stiffness, length)
        }
        Judged::Witness => distance::of_witness(&pair, stiffness, length),
    };
    Ok(Certificate::new(&enclosed, scene.load(), scale, &pair, error))
}

/// The pair that a list of contacts proves, or that of a beam that touches nowhere if that is better: whatever the list, there
/// is a bound.
fn pair(enclosed: &EnclosedScene<'_>, contacts: &[Contact], scale: &Scale) -> Option<Pair> {
    let of = |contacts: &[Contact]| proof::pair(enclosed, &witness::nodes(enclosed, contacts, scale));
    let pair = of(contacts);
    if pair.as_ref().is_some_and(|pair| is_sharp(enclosed, pair)) {
        return pair;
    }
    let none = of(&[]).map(|none| Pair { lifted: f64::INFINITY, ..none });
    pair.into_iter().chain(none).min_by(|a, b| a.gap.hi().total_cmp(&b.gap.hi()))
}

/// Whether a pair bounds the deflection to a millionth of its largest value.
fn is_sharp(enclosed: &EnclosedScene<'_>, pair: &Pair) -> bool {
    const SHARP: f64 = 1e-6;
    let width = |p: &Piece| Interval::exact(p.to) - Interval::exact(p.from);
    let size = pair.pieces.iter().fold(0.0, |most: f64, p| most.max(p.v.range(width(p)).magnitude()));
    distance::of_gap(pair.gap.hi(), enclosed.stiffness, enclosed.length) <= SHARP * size
}

/// Bounds that hold for the continuous beam, in the units of the scene. Infinite where nothing could be shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// At most `J*`: `D(p)` of the contact load.
    pub energy_lower: f64,
    /// At least `J*`: `J(v̂)` of an admissible deflection.
    pub energy_upper: f64,
    /// At least `J(v̂) − D(p)`, without cancellation.
    pub gap: f64,
    /// At least `max |v − v*|` over the whole beam.
    pub deflection_error: f64,
    /// Where that bound is largest.
    pub deflection_error_at: f64,
    /// At least `max |v̂ − v*|` of the admissible deflection `v̂` that was built: how well the true deflection is known, even
    /// if the one that was judged is far off.
    pub best_deflection_error: f64,
    /// The largest magnitude of the deflection that was judged, rounded up.
    pub deflection: f64,
    /// The same, rounded down: what is reached somewhere; zero for a deflection at the nodes of a grid.
    pub deflection_at_least: f64,
    /// What the reactions of the two supports lie between, left and right; [`None`] where nothing could be shown.
    pub reactions: [Option<[f64; 2]>; 2],
    /// What the structural stiffness `D` lies between; see [`stiffness`]. [`None`] if the sign of `J*` is open.
    pub stiffness: Option<[f64; 2]>,
    /// True if the true deflection is known to a millionth of its largest value: the contacts of the witness are those of the
    /// beam, but for what cannot be felt. Otherwise the bounds are coarse.
    pub contacts_proven: bool,
}

impl Certificate {
    /// Nothing could be shown.
    const UNKNOWN: Self = Self {
        energy_lower: f64::NEG_INFINITY,
        energy_upper: f64::INFINITY,
        gap: f64::INFINITY,
        deflection_error: f64::INFINITY,
        deflection_error_at: 0.0,
        best_deflection_error: f64::INFINITY,
        deflection: f64::INFINITY,
        deflection_at_least: 0.0,
        reactions: [None, None],
        stiffness: None,
        contacts_proven: false,
    };

    /// From what was proven, dimensionless. All factors are powers of two: only exponents change.
    fn new(enclosed: &EnclosedScene<'_>, load: &Load, scale: &Scale, pair: &Pair, error: Error) -> Self {
        let energy = energy(&pair.pieces, enclosed.load, enclosed.stiffness);
        let gap = pair.gap.hi();
        let energies = [(Interval::exact(energy.lo()) - Interval::exact(gap)).lo(), energy.hi()];
        let stiffness = stiffness(energies, load, enclosed.length);
        let force = |r: Interval| [r.lo() * scale.force, r.hi() * scale.force];
        Self {
            energy_lower: energies[0] * scale.energy(),
            energy_upper: energies[1] * scale.energy(),
            gap: gap * scale.energy(),
            deflection_error: error.most * scale.depth,
            deflection_error_at: error.at * scale.length,
            best_deflection_error: distance::of_gap(gap, enclosed.stiffness, enclosed.length) * scale.depth,
            deflection: error.size * scale.depth,
            deflection_at_least: error.least * scale.depth,
            reactions: reactions(enclosed, pair).map(|bracket| bracket.map(force)),
            stiffness: stiffness.map(|d| d.map(|d| d * (scale.force / scale.depth))),
            contacts_proven: is_sharp(enclosed, pair),
        }
    }
}
