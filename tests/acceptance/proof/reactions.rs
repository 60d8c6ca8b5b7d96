//! Reactions from proofs: three brackets of the energy are one of a reaction.
//!
//! As the level `d` of a support falls, the energy `J*` falls at the rate of the reaction `R`. Of deflections and levels that fit, J is convex,
//! so J*(d) is too:
//!
//! ```text
//! (J*(d) − J*(d + δ))/δ ≤ R ≤ (J*(d − δ) − J*(d))/δ
//! ```

use palkki::proof::prove;
use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::theory::{self, Exact};
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::number::Number;
use palkki_evidence::draft::Draft;
use palkki_evidence::random::{self, Feature, general, sample_of};

use super::{bracket, text};

/// How many reactions.
const REACTIONS: usize = 240;

/// The share of the largest deflection by which a support is moved, and of the largest reaction by which a bracket may be wide.
const MOVED: f64 = 1e-10;
const WIDE: f64 = 1e-6;

/// The bracket of the reaction at a place; none where rounding has a proof out of reach.
fn reaction(scene: &Scene, exact: &Exact, at: f64) -> Option<[f64; 2]> {
    let draft = Draft::from(scene);
    let supports = draft.all_supports();
    let i = supports.iter().position(|support| support.at.total_cmp(&at).is_eq())?;
    let energies = |level: f64| {
        let mut supports = supports.clone();
        supports[i].level = level;
        let moved = Draft { supports: Some(supports), ..draft.clone() }.scene().ok()?;
        let exact = theory::solve(&moved).ok().filter(|exact| exact.solved)?;
        bracket(&moved, &prove(&moved, &exact).ok()?).ok()
    };
    let by = MOVED * exact.state.deflection.magnitude();
    let levels = [-by, 0.0, by].map(|by| supports[i].level + by);
    let [up, here, down] = levels.map(energies);
    let ([up, here, down], [above, level, below]) =
        ([up?, here?, down?], levels.map(|x| RBig::try_from(x).expect("finite")));
    let (least, most) = ((&here[0] - &down[1]) / (&below - &level), (&up[1] - &here[0]) / (&level - &above));
    Some([least, most].map(|force| force.to_double()))
}

#[test]
fn three_proofs_bracket_a_reaction() {
    let drawn = (0_u64..).flat_map(|i| {
        let of = |on_soil: bool| {
            parse("scene.toml", &general(i, &Feature::ALL, on_soil).text, |_| Err(ReadProblem::Missing))
        };
        [Some(random::held(i)), Some(random::scene(i)), of(false).ok(), of(true).ok()]
    });
    let (mut count, mut wide) = (0, Vec::new());
    for scene in drawn.flatten() {
        let Ok(exact) = theory::solve(&scene) else { continue };
        let supports = &exact.state.supports;
        let largest = supports.iter().fold(exact.state.contact_force(), |most, support| most.max(support.force.abs()));
        for (at, force) in supports.iter().map(|support| (support.at, support.force)) {
            let Some([least, most]) = reaction(&scene, &exact, at) else { continue };
            let off = WIDE * largest;
            assert!(
                least - off <= force && force <= most + off,
                "{force} at {at} is not in [{least}, {most}]: {}",
                text(&scene)
            );
            assert!(least <= most);
            count += 1;
            if off < most - least {
                wide.push((most - least) / largest);
            }
        }
        if sample_of(REACTIONS) <= count {
            break;
        }
    }
    // Wide energies have wide derivatives: ground that is below a support by a rounding.
    assert!(20 * wide.len() <= count, "{wide:?} of {count}");
}
