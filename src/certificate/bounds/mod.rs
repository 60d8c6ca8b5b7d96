//! Two-sided bounds for the continuous beam, guaranteed, from contact forces and the scene alone.
//!
//! For any deflection `v̂ ≤ u` with `v̂(0) = v̂(l) = 0`, and any contact load `p ≥ 0` with its moment field `M`
//! (`M'' = p − q`, `M(0) = M(l) = 0`), with `J` of (17) (Prager and Synge 1947, Repin 2000):
//!
//! ```text
//! D(p) ≤ J* ≤ J(v̂),     D(p) = −½ ∫ M²/EI dx − ∫ u dp
//! J(v̂) − D(p) = ½ ∫ (EI v̂'' + M)²/EI dx + ∫ (u − v̂) dp = gap           both terms ≥ 0: nothing cancels
//! ½ ∫ EI (v̂'' − v*'')² dx ≤ gap,     |v̂ − v*|(x) ≤ √( 2 gap x² (l − x)² / (3 EI l) )
//! ```
//!
//! This is the paper's closing remark, that the structural stiffness is bounded from both sides if there is no tension and no
//! penetration between the nodes, carried out: the forces given are made a load without tension, and a deflection without
//! penetration anywhere is built.
//!
//! How it is built decides how sharp the bounds are. The forces show a *pattern* of contact (module `pattern`): zones, points
//! and corners. Their places are refined (modules `refine`, `adjust`, `fill`), and from them alone follow a deflection and a moment field for which the gap is
//! of second order in whatever is left (modules `joints`, `proof`). The refinement may go wrong; admissibility is proven
//! afterwards in interval arithmetic, between all nodes and for every kind of profile, and what cannot be proven is amended
//! (modules `clearance`, `pressing`, `hold`). Where the amends are more than rounding, the deflection that the given forces
//! cause is lifted off the foundation as well (module `admissible`), which always works and is coarse; the better one counts.
//!
//! What is taken for given: a foundation is known to a few units in the last place of its terms. If its depth at a support is
//! zero but for that, it is level with it (module `ground`); points of a polyline that are on one line but for that, are on
//! one line (module `tidied`).
//!
//! All numbers are rounded outwards: the inequalities hold for what is printed.

mod adjust;
mod admissible;
mod best;
mod cells;
mod clearance;
mod contact_load;
mod curve;
mod error;
mod fill;
mod ground;
mod hold;
mod inner;
mod joints;
mod largest;
mod load;
mod lumped;
mod pattern;
mod polynomial;
mod pressing;
mod proof;
mod record;
mod refine;
mod span;
mod statics;
mod stiffness;
mod taylor;
mod tidied;
mod violations;

pub use contact_load::{ContactLoad, NotAForce};
pub use lumped::{Lumped, NotLumped};
pub use record::Certificate;
pub use stiffness::stiffness;
pub use violations::{Violation, ViolationKind, violations, violations_at_nodes};

use std::cell::LazyCell;

use self::best::Best;
use self::curve::{Curve, Piece};
use self::inner::Inner;
use self::joints::{Joint, Kind};
use self::record::Proven;
use self::statics::{Carried, deflection};
use super::interval::Interval;
use crate::scene::{Scene, SceneError};
use crate::state::{Contact, Nodes};

/// Share of its largest value to which a deflection has to be certain to be accepted from somebody who says nothing of a
/// grid: what can be read off a drawing, and a tenth of what the paper calls usable.
pub const ACCEPTED_ERROR: f64 = 1e-2;

/// The deflection that is judged.
#[derive(Debug, Clone, Copy)]
pub enum Judged<'a> {
    /// That of the nodes of a grid: the cubics that deflections and moments at the nodes make between them.
    Nodes(&'a Nodes),
    /// The one that the contact load causes, by statics and integration under the true load.
    Caused,
}

/// Bounds from forces at places.
///
/// # Errors
///
/// A [`SceneError`] if the scene leaves the range of `f64` when it is scaled.
pub fn certify(scene: &Scene, forces: &ContactLoad, judged: Judged<'_>) -> Result<Certificate, SceneError> {
    let scaled = scene.scaled()?;
    let (scene, scale) = (&scaled.scene, &scaled.scale);
    let forces = forces.scaled(scale);
    let tidied = scene.foundation().and_then(tidied::tidied);
    let inner = Inner::of(scene, tidied.as_ref().or(scene.foundation()));
    let length = scene.beam().length();
    let carried = LazyCell::new(|| Carried::of(&forces.pressing, &inner.load, inner.stiffness, length));
    let joints = inner.setting().map_or_else(
        || Some(vec![Joint::new(Kind::Support, 0.0), Joint::new(Kind::Support, length)]),
        |setting| {
            let pattern = pattern::of_forces(&setting, &forces.inside(length), forces.spacing);
            refine::refined(&setting, pattern)
        },
    );
    let pair = joints.as_ref().and_then(|joints| inner.pair(joints));
    let own = || carried.cells.iter().map(|c| (c.0, deflection(c, &inner.load, inner.stiffness)));

    let Best { curve, energy, gap: best } = inner.best(pair.as_ref(), || {
        let caused = Curve { pieces: own().map(|([from, to], v)| Piece { from, to, v, follows: false }).collect() };
        let drawn = joints.as_ref().zip(inner.setting()).and_then(|(joints, setting)| proof::drawn(&setting, joints));
        std::iter::once(caused).chain(drawn).collect()
    });
    let of_forces = || {
        if energy.hi().is_finite() {
            inner.mismatch(&curve, own()) + curve.idle_work(&forces.pressing, inner.ground.as_ref())
        } else {
            Interval::WHOLE
        }
    };
    let gap = match judged {
        // Of a grid nobody wants to know what its forces would do to a beam that feels them one by one, unless they show no
        // pattern: forces of the size of rounding all along a beam that hangs free do not.
        Judged::Nodes(_) if pair.as_ref().is_some_and(|pair| inner.is_sharp(pair)) => best,
        Judged::Nodes(_) => {
            let of_forces = of_forces();
            if of_forces.hi() < best.hi() { of_forces } else { best }
        }
        Judged::Caused => of_forces(),
    };
    let sharpest = best.hi().min(gap.hi());
    let error = match judged {
        Judged::Caused => error::deflection(&curve, own(), sharpest, inner.stiffness, length),
        Judged::Nodes(nodes) => error::of_nodes(&curve, nodes, scale, sharpest, inner.stiffness, length),
    };
    Ok(Proven { energy, gap, sharpest, error, pair: pair.as_ref() }.certificate(&inner, scene, scale))
}

/// Bounds from the contacts of an exact answer: its zones and points, at the places that it gives. The deflection that is
/// judged is the one that these places make; the pressure in a zone is `q − EI u''''`. Where no pattern can be made of the
/// places, it is the deflection that the forces of the contacts cause, those of zones spread over them.
///
/// # Errors
///
/// As [`certify`].
pub fn certify_contacts(given: &Scene, contacts: &[Contact]) -> Result<Certificate, SceneError> {
    let scaled = given.scaled()?;
    let (scene, scale) = (&scaled.scene, &scaled.scale);
    let tidied = scene.foundation().and_then(tidied::tidied);
    let inner = Inner::of(scene, tidied.as_ref().or(scene.foundation()));
    let length = scene.beam().length();
    let places = contacts.iter().map(|c| [c.from / scale.length, c.to / scale.length]);
    let places: Vec<[f64; 2]> = places.filter(|c| c[0] < c[1] || (0.0 < c[0] && c[0] < length)).collect();
    let (pair, judged) = match inner.setting() {
        Some(setting) => {
            let joints = refine::with_slopes(&setting, pattern::of_contacts(&setting, &places));
            let drawn = proof::drawn(&setting, &joints);
            // What is near the given places may bound better than they do themselves.
            let own = inner.pair(&joints);
            let refined = refine::refined(&setting, joints).and_then(|joints| inner.pair(&joints));
            let pair = [own, refined].into_iter().flatten().min_by(|a, b| a.gap.hi().total_cmp(&b.gap.hi()));
            (pair, drawn)
        }
        None => {
            let pair = inner.pair(&[]);
            let judged = pair.as_ref().map(|pair| pair.curve.clone());
            (pair, judged)
        }
    };
    let (energy, gap, error) = match (&pair, judged) {
        (None, _) | (_, None) => {
            return certify(given, &ContactLoad::of_contacts(given.beam().length(), contacts), Judged::Caused);
        }
        (Some(pair), Some(judged)) => {
            let judged = judged.pieces.iter().map(|p| ([p.from, p.to], p.v));
            let error = error::deflection(&pair.curve, judged, pair.gap.hi(), inner.stiffness, length);
            (pair.curve.energy(&inner.load, inner.stiffness), pair.gap, error)
        }
    };
    Ok(Proven { energy, gap, sharpest: gap.hi(), error, pair: pair.as_ref() }.certificate(&inner, scene, scale))
}
