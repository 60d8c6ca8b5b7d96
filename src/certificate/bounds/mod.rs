//! Two-sided bounds for the continuous beam, guaranteed, proven from a witness.
//!
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
//! exact beam between them, with slopes that one linear system gives (modules `witness`, `slopes`). For the true list the gap
//! is zero, and it grows with the square of what a place is off by. Nothing is looked for here. That `v̂` and `p` are admissible
//! is proven in interval arithmetic, everywhere and for every kind of profile, and what cannot be proven is amended at its price
//! (modules `proof`, `clearance`, `pressing`). So a witness may be wrong: that makes the bounds wide, and never untrue.
//!
//! What is taken for given: a foundation is known to a few units in the last place of its terms. If its depth at a support is
//! zero but for that, it is level with it (module `ground`); points of a polyline that are on one line but for that, are on
//! one line (module `tidied`).
//!
//! All numbers are rounded outwards: the inequalities hold for what is printed.

mod clearance;
mod contact_load;
mod contact_node;
mod curve;
mod distance;
mod ground;
mod largest;
mod load;
mod lumped;
mod polynomial;
mod pressing;
mod proof;
mod reactions;
mod record;
mod slopes;
mod span;
mod statics;
mod stiffness;
mod taylor;
mod tidied;
mod violations;
mod witness;

pub use contact_load::{ContactLoad, NotAForce};
pub use lumped::{Lumped, NotLumped};
pub use record::Certificate;
pub use stiffness::stiffness;
pub use violations::{Violation, ViolationKind, violations, violations_at_nodes};

use self::contact_node::EnclosedScene;
use self::ground::Ground;
use self::load::Pieces;
use self::proof::Pair;
use self::statics::{Carried, deflection};
use crate::scene::{Foundation, Scale, Scene, SceneError};
use crate::state::{Contact, Nodes};

/// Share of its largest value to which a deflection has to be certain to be accepted from somebody who says nothing of a
/// grid: what can be read off a drawing, and a tenth of what the paper calls usable.
pub const ACCEPTED_ERROR: f64 = 1e-2;

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
    let tidied = scene.foundation().and_then(tidied::tidied);
    let foundation = tidied.as_ref().or(scene.foundation()).unwrap_or(&NONE);
    let (stiffness, length) = (scene.beam().bending_stiffness(), scene.beam().length());
    let load = Pieces::of(scene);
    let enclosed = EnclosedScene { ground: Ground::on(foundation, length), load: &load, stiffness, length };
    let Some(pair) = pair(&enclosed, witness, scale) else { return Ok(Certificate::UNKNOWN) };
    let error = match judged {
        Judged::Nodes(nodes) => distance::of_nodes(&pair, nodes, scale, stiffness, length),
        Judged::Forces(forces) => {
            let carried = Carried::of(&forces.scaled(scale).pressing, &load, stiffness, length);
            let caused: Vec<_> = carried.cells.iter().map(|c| (c.0, deflection(c, &load, stiffness))).collect();
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
    if pair.as_ref().is_some_and(|pair| record::is_sharp(enclosed, pair)) {
        return pair;
    }
    let none = of(&[]).map(|none| Pair { lifted: f64::INFINITY, ..none });
    pair.into_iter().chain(none).min_by(|a, b| a.gap.hi().total_cmp(&b.gap.hi()))
}
