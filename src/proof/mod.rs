//! A proof of an answer, in fractions, that anybody can check: a deflection and a moment field, polynomials on cells.
//!
//! `v` is a deflection that the scene admits, and `M` are moments in equilibrium with the loads and with contact forces that only press.
//! Both energies follow from them without rounding, and the energy of the true beam lies between:
//!
//! ```text
//! J(v) = ½∫EI v''² + ½∫N v'² − ∫q v − ΣP v − ΣC v' + ½∫k (v − g)₊² + ½Σk (v − d)² + ½Σk (v' − φ)² + ½Σk [v']²
//! D(M) = −½∫M²/EI − ½∫N v'² − ∫g p − ΣF d + ΣT φ − ½∫p²/k − ½ΣF²/k − ½ΣT²/k − ½ΣM²/k
//! p = M'' + q + N v'' ≥ 0,  F = [M'] + N [v'] + P,  T = [M] − C,     D ≤ J* ≤ J
//! ```
//!
//! The program `report/check.rs` reads a scene file and a proof, knows nothing of this library, and believes neither.
//!
//! The places of contact are those of the exact answer, as they are. On rigid ground (`contact_nodes`) the beam is the ground in its zones
//! and the exact beam in its spans, with slopes that follow from the places. On ground that gives (`stretches`) it has the polynomials of
//! the answer, and cubics that make the ends of cells meet. `span` has the beam between two places, `equilibrium` its moments, `assembly` the
//! cells: what rounding leaves in the ground is lifted out of it. What pulls by rounding is not repaired, and there is no proof then.
//! Under tension the beam is no polynomial: `v` is one of many terms on short parts, and the bracket says how close it is.

mod assembly;
mod contact_nodes;
mod equilibrium;
mod given;
mod polynomial;
mod span;
mod stretches;

use dashu_ratio::RBig;

use self::given::Given;
use crate::scene::{Profile, Scene, SceneError};
use crate::state::Contact;
use crate::theory::Exact;

/// A deflection and a moment field that prove a bracket for the energy.
#[derive(Debug, Clone)]
pub struct Fields {
    /// From the left end of the beam to its right end.
    pub cells: Vec<Cell>,
    /// Whether the deflection that the contacts make was below the surface of the ground, and is lifted.
    pub is_lifted: bool,
}

/// A part of the beam.
#[derive(Debug, Clone)]
pub struct Cell {
    /// Where it begins and where it ends \[length\].
    pub ends: [RBig; 2],
    /// Coefficients of `v` in powers of `x − from` \[length, 1, …\].
    pub deflection: Vec<RBig>,
    /// Those of `M` \[force · length, force, …\].
    pub moment: Vec<RBig>,
    /// Whether the ground may press on it.
    pub pressed: bool,
}

/// Why there is no proof of an answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unproven {
    /// A cosine has no value that is a fraction.
    #[error("`{}.cosine` has no values in fractions; a proof needs a polynomial, a polyline or a survey", of.path())]
    Cosine {
        /// Which profile has it.
        of: Profile,
    },
    /// Exactly taken there is no admissible deflection.
    #[error(
        "at x = {at} the ground is above the support by less than rounding; in fractions no deflection is possible"
    )]
    AboveSupport {
        /// The support \[length\].
        at: f64,
    },
    /// The scene leaves the range of `f64` when it is scaled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The answer is no solution.
    #[error("the answer does not meet all conditions of beam theory, so there is nothing to prove")]
    NoSolution,
    /// Places of contact that are not in order, or have no ground.
    #[error("the contact at x = {at} is not one that a beam can have")]
    Place {
        /// The contact \[length\].
        at: f64,
    },
    /// Nothing says at which slope the beam rests.
    #[error("the beam may turn about x = {at}, or no contact holds it")]
    Turns {
        /// The only place that holds it \[length\].
        at: f64,
    },
    /// Ground with a kink inside a zone, by rounding.
    #[error(
        "at x = {at} the ground has a kink by rounding inside a contact zone; in fractions the beam cannot follow it"
    )]
    Kink {
        /// The kink \[length\].
        at: f64,
    },
    /// A pressure or force of contact that is in tension.
    #[error("at x = {at} the contact would be in tension by rounding")]
    Tension {
        /// Where \[length\].
        at: f64,
    },
    /// A couple at a place where nothing exerts one.
    #[error("at x = {at} the moment jumps by rounding where nothing exerts a couple")]
    Couple {
        /// Where \[length\].
        at: f64,
    },
    /// A deflection that stays below the surface of the ground.
    #[error("between x = {} and x = {} the deflection cannot be lifted out of the ground", .ends[0], .ends[1])]
    InGround {
        /// The span \[length\].
        ends: [f64; 2],
    },
}

/// The proof of an exact answer.
///
/// ```
/// use palkki::proof::prove;
/// use palkki::scene::{Beam, Foundation, Load, Scene};
/// use palkki::theory;
///
/// let beam = Beam::new(10.0, 500.0 / 384.0)?;
/// let scene = Scene::new(beam.clone(), Load::uniform_on(&beam, 1.0)?, Some(Foundation::Flat { depth: 1.0 }))?;
/// let proof = prove(&scene, &theory::solve(&scene)?)?;
/// // Two spans and the zone between them.
/// assert_eq!(proof.cells.len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`Unproven`] says why there is no proof.
pub fn prove(scene: &Scene, exact: &Exact) -> Result<Fields, Unproven> {
    if !exact.solved {
        return Err(Unproven::NoSolution);
    }
    match exact.stretches() {
        Some(stretches) => {
            let press: Vec<f64> =
                exact.state.supports.iter().filter(|s| s.pushes_only && 0.0 < s.force).map(|s| s.at).collect();
            let given = Given::of(scene, &press)?;
            let mut nodes = given.nodes_of_stretches(&stretches, &scene.scaled()?.scale);
            given.turn(&mut nodes)?;
            given.assembled(&nodes)
        }
        None => of_places(scene, &exact.state.touched(), Some(exact)),
    }
}

/// What a list of contacts proves on rigid ground, from any source: only their places count, and all springs that only push are pressed.
///
/// # Errors
///
/// [`Unproven`] says why there is no proof.
pub fn of_contacts(scene: &Scene, contacts: &[Contact]) -> Result<Fields, Unproven> {
    scene.on_rigid_ground("a proof from a list of contacts")?;
    of_places(scene, contacts, None)
}

fn of_places(scene: &Scene, contacts: &[Contact], exact: Option<&Exact>) -> Result<Fields, Unproven> {
    let stops: Vec<f64> = scene.beam().springs().iter().filter(|s| s.pushes_only).map(|support| support.at).collect();
    let is_at = |at: f64, other: f64| at.total_cmp(&other).is_eq();
    let pushes =
        |at: &f64| exact.is_none_or(|exact| exact.state.supports.iter().any(|s| is_at(s.at, *at) && 0.0 < s.force));
    let press: Vec<f64> = stops.iter().copied().filter(pushes).collect();
    let given = Given::of(scene, &press)?;
    // A stop is a spring, and no place of the ground, unless the ground beside it carries as well.
    let is_stop = |contact: &Contact| contact.to <= contact.from && stops.iter().any(|at| is_at(*at, contact.from));
    let carries = |contact: &Contact| exact.is_some_and(|exact| exact.state.contacts.contains(contact));
    let mut contacts: Vec<Contact> =
        contacts.iter().filter(|contact| !is_stop(contact) || carries(contact)).cloned().collect();
    loop {
        let proven = given.nodes(&contacts, exact).and_then(|nodes| given.assembled(&nodes));
        let Err(Unproven::Tension { at }) = proven else { return proven };
        // A point that carries nothing may be in tension by rounding; the beam is lifted above it instead.
        let before = contacts.len();
        contacts.retain(|contact| contact.from < contact.to || contact.from < at || at < contact.from);
        if contacts.len() == before {
            return proven;
        }
    }
}

impl Fields {
    /// The proof as JSON, with fractions as strings.
    #[must_use]
    pub fn json(&self) -> String {
        let list = |p: &[RBig]| p.iter().map(|c| format!("\"{c}\"")).collect::<Vec<_>>().join(", ");
        let cell = |Cell { ends: [from, to], deflection, moment, pressed }: &Cell| {
            let (v, moment) = (list(deflection), list(moment));
            format!(
                "{{ \"from\": \"{from}\", \"to\": \"{to}\", \"v\": [{v}], \"moment\": [{moment}], \"pressed\": {pressed} }}"
            )
        };
        let cells: Vec<String> = self.cells.iter().map(cell).collect();
        format!("{{ \"version\": 1, \"cells\": [\n  {}\n] }}\n", cells.join(",\n  "))
    }
}
