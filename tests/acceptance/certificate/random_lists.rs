//! Random lists of contacts as witnesses of random beams on any supports: what is said of one list never contradicts another.

use palkki::certificate::{Judged, certify};
use palkki::scene::{Beam, Foundation, Load, Scene, Support};
use palkki::state::Contact;
use palkki_evidence::random::{Random, sample_of};

use super::supports::{flat, sampled, zone};

/// Random supports, shapes and grounds with random lists of contacts: any two lists say what can be true at once, of the
/// same deflection and of the energy.
#[test]
fn random_lists_do_not_contradict_each_other() {
    let mut random = Random::new(0x5_u64);
    let (mut bounded, mut asked) = (0, 0);
    for case in 0..sample_of(300) {
        let l = random.between(2.0, 12.0);
        let level = |random: &mut Random| if random.once_in(2) { 0.0 } else { random.between(-0.1, 0.1) };
        let mut supports: Vec<Support> = Vec::new();
        for k in 0..random.below(5) {
            let part = l / 5.0;
            #[expect(clippy::cast_precision_loss, reason = "at most four")]
            let at = if random.once_in(4) { k as f64 * part } else { (k as f64 + random.between(0.0, 1.0)) * part };
            let slope = random.once_in(3).then(|| random.between(-0.05, 0.05));
            supports.push(Support { level: level(&mut random), slope, ..Support::simple(at) });
        }
        let beam = Beam::new(l, random.between(0.5, 20.0)).and_then(|beam| beam.with_supports(supports));
        let mut beam = beam.expect("supports on the beam");
        if random.once_in(2) {
            let coefficients = [0.1, 0.05, 0.02].map(|size| random.between(-size, size)).to_vec();
            beam = beam.with_shape(Foundation::Polynomial { coefficients }).expect("an axis");
        }
        let load = Load::uniform_on(&beam, random.between(0.0, 3.0)).expect("finite");
        let ground = match random.below(4) {
            0 => None,
            1 => flat(random.between(0.1, 1.0)),
            2 => Some(Foundation::Cosine {
                mean: random.between(0.3, 1.0),
                amplitude: 0.15,
                wavelength: random.between(1.0, 20.0),
                phase: random.between(0.0, 6.0),
            }),
            _ => {
                let points = (0..=6_u32).map(|k| [l * f64::from(k) / 6.0, random.between(0.1, 1.5)]).collect();
                Some(Foundation::Polyline { points })
            }
        };
        let Ok(scene) = Scene::new(beam, load, ground) else { continue };
        let list = |random: &mut Random| {
            let mut places: Vec<f64> = (0..random.below(5)).map(|_| random.between(0.0, l)).collect();
            places.sort_by(f64::total_cmp);
            places.chunks(2).map(|c| zone(c[0], c[random.below(c.len())])).collect::<Vec<_>>()
        };
        let nodes = sampled(&scene, |x| 0.1 * x);
        let lists: Vec<Vec<Contact>> = (0..4).map(|_| list(&mut random)).chain([Vec::new()]).collect();
        let Ok(said) =
            lists.iter().map(|list| certify(&scene, Judged::Nodes(&nodes), list)).collect::<Result<Vec<_>, _>>()
        else {
            continue;
        };
        asked += 1;
        bounded += usize::from(said.iter().any(|said| said.gap.is_finite()));
        for (one, other) in said.iter().flat_map(|one| said.iter().map(move |other| (one, other))) {
            let slack = 1e-12 * (one.energy_upper.abs().min(1e9) + other.energy_upper.abs().min(1e9));
            assert!(one.energy_lower <= other.energy_upper + slack, "{case}: {one:?} and {other:?} of {scene:?}");
            for (one, other) in one.reactions.iter().zip(&other.reactions) {
                let (Some([a, _]), Some([_, d])) = (one, other) else { continue };
                assert!(*a <= d + 1e-9 * (1.0 + d.abs()), "{case}: {one:?} and {other:?} of {scene:?}");
            }
        }
    }
    assert!(sample_of(100) < asked && 2 * asked < 3 * bounded, "{bounded} of {asked}");
}
