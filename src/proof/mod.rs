//! A proof of an answer in rational arithmetic that anybody can check: a deflection and a moment field, polynomials on cells.
//!
//! `v` is an admissible deflection of the scene. The moments `M` are in equilibrium with the loads and with compressive contact
//! forces. Both give an energy without rounding, and the energy of the true beam lies between them:
//!
//! ```text
//! J(v) = ½∫EI v''² + ½∫N v'² − ∫q v − ΣP v − ΣC v' + ½∫k (v − g)₊² + ½Σk (v − d)² + ½Σk (v' − φ)² + ½Σk [v']²
//! D(M) = −½∫M²/EI − ½∫N v'² − ∫g p − ΣF d + ΣT φ − ½∫p²/k − ½ΣF²/k − ½ΣT²/k − ½ΣM²/k
//! p = M'' + q + N v'' ≥ 0,  F = [M'] + N [v'] + P,  T = [M] − C,     D ≤ J* ≤ J
//! ```
//!
//! The program `report/check.rs` reads a scene file and a proof. It shares no code with this library, and checks the proof against
//! the scene.
//!
//! The contact positions are those of the exact answer, unchanged. On a rigid foundation (`contact_nodes`) the beam follows the
//! foundation in its zones and is the exact beam in its spans, with slopes computed from the positions. On an elastic foundation
//! (`stretches`) it has the polynomials of the answer, and cubics that join the ends of cells. `span` computes the beam between two
//! positions, `equilibrium` its moments, and `assembly` the cells. A deflection that penetrates the foundation by rounding is lifted.
//! Two cases of tension by rounding are repaired: a contact point on a rigid foundation is dropped, and a pressure on an elastic
//! foundation is corrected. For any other tension there is no proof. Under an axial force the beam is no polynomial: `v` has many
//! terms on short parts, and the bracket shows how close it is.

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
    /// The cells from the left end of the beam to its right end.
    pub cells: Vec<Cell>,
    /// Whether the deflection for these contacts penetrated the foundation, and was lifted or counts as pressed there.
    pub is_lifted: bool,
}

/// A part of the beam.
#[derive(Debug, Clone)]
pub struct Cell {
    /// The positions where it begins and ends \[length\].
    pub ends: [RBig; 2],
    /// Coefficients of `v` in powers of `x − from` \[length, 1, …\].
    pub deflection: Vec<RBig>,
    /// Coefficients of `M` in the same powers \[force · length, force, …\].
    pub moment: Vec<RBig>,
    /// Whether the foundation may press on it.
    pub pressed: bool,
}

/// The reason why there is no proof of an answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unproven {
    /// A cosine has irrational values.
    #[error("`{}.cosine` has no values in fractions; a proof needs a polynomial, a polyline or a survey", of.path())]
    Cosine {
        /// The profile with the cosine.
        of: Profile,
    },
    /// In rational arithmetic no deflection is admissible.
    #[error(
        "at x = {at} the ground is above the support by less than rounding; in fractions no deflection is possible"
    )]
    AboveSupport {
        /// The position of the support \[length\].
        at: f64,
    },
    /// The scene leaves the range of `f64` when it is scaled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The answer does not satisfy all conditions of beam theory.
    #[error("the answer does not meet all conditions of beam theory, so there is nothing to prove")]
    NoSolution,
    /// Contact positions that are not in order, or where there is no foundation.
    #[error("the contact at x = {at} is not one that a beam can have")]
    Place {
        /// The position of the contact \[length\].
        at: f64,
    },
    /// The slope of the beam, or of a part of it, is not determined.
    #[error("the beam may turn about x = {at}, or no contact holds it")]
    Turns {
        /// A node of that part, or NaN if none is known \[length\].
        at: f64,
    },
    /// The foundation has a kink inside a contact zone, by rounding.
    #[error(
        "at x = {at} the ground has a kink by rounding inside a contact zone; in fractions the beam cannot follow it"
    )]
    Kink {
        /// The position of the kink \[length\].
        at: f64,
    },
    /// A contact pressure or contact force is in tension.
    #[error("at x = {at} the contact would be in tension by rounding")]
    Tension {
        /// The position \[length\].
        at: f64,
    },
    /// The moment jumps at a position where nothing exerts a couple.
    #[error("at x = {at} the moment jumps by rounding where nothing exerts a couple")]
    Couple {
        /// The position \[length\].
        at: f64,
    },
    /// A deflection penetrates the foundation and cannot be lifted.
    #[error("between x = {} and x = {} the deflection cannot be lifted out of the ground", .ends[0], .ends[1])]
    InGround {
        /// The ends of the span \[length\].
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
/// [`Unproven`] gives the reason why there is no proof.
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

/// The proof from a list of contacts on a rigid foundation, from any source. Only the positions are used, and all elastic
/// compression-only supports count as pressed.
///
/// # Errors
///
/// [`Unproven`] gives the reason why there is no proof.
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
    // A stop is a spring, not a contact with the foundation, unless the foundation next to it carries too.
    let is_stop = |contact: &Contact| contact.to <= contact.from && stops.iter().any(|at| is_at(*at, contact.from));
    let carries = |contact: &Contact| exact.is_some_and(|exact| exact.state.contacts.contains(contact));
    let mut contacts: Vec<Contact> =
        contacts.iter().filter(|contact| !is_stop(contact) || carries(contact)).cloned().collect();
    loop {
        let proven = given.nodes(&contacts, exact).and_then(|nodes| given.assembled(&nodes));
        let Err(Unproven::Tension { at }) = proven else { return proven };
        // A contact point without force may be in tension by rounding. The point is dropped, and the beam is lifted above it if
        // necessary.
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
