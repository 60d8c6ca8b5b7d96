//! The envelope of a sweep: what governs, of one load and of several that move together.

use palkki::scene::{Foundation, Scene, Support};
use palkki::sweep::{Envelope, Gathered, Sweep, SweepError};
use palkki::theory;

use crate::scenes::on_supports;

/// A beam on supports, above ground or none, with axles of so much a distance behind the first.
fn axles(length: f64, supports: &[f64], ground: Option<Foundation>, axles: &[(f64, f64)]) -> Scene {
    let supports: Vec<Support> = supports.iter().copied().map(Support::simple).collect();
    on_supports([length, 5000.0], &supports, (0.0, axles), ground)
}

const PATHS: [&str; 2] = ["load.point[0].at", "load.point[0].at,load.point[1].at"];

/// All rows of a sweep.
pub(super) fn gathered<'a>(sweep: &'a Sweep<'a>) -> Gathered<'a> {
    let (mut walk, mut gathered) = (sweep.walk(), sweep.gathered());
    for value in sweep.values() {
        // A range may leave what has an answer.
        let Ok(step) = walk.solve(value) else { continue };
        gathered.add(&step);
        walk.row(step);
    }
    gathered
}

fn envelope(scene: &Scene, path: &str, to: f64, steps: usize) -> Envelope {
    let sweep = Sweep::new(scene, path, [0.0, to], steps).expect("a sweep");
    gathered(&sweep).envelope().expect("there are rows")
}

/// Two axles `P` a distance `d` apart on a span `l`: the largest moment is `P (l − d/2)² / (2 l)`, under one of them, which is `d/4`
/// from mid-span.
#[test]
fn two_axles_on_one_span_have_the_moment_of_the_textbook() {
    let (l, d, force) = (12.0, 1.8, 100.0);
    let scene = axles(l, &[0.0, l], None, &[(0.0, force), (d, force)]);
    for steps in [8, 57] {
        let found = envelope(&scene, PATHS[1], l - d, steps).governing.moment_max;
        let expected = force * (l - 0.5 * d) * (l - 0.5 * d) / (2.0 * l);
        assert!((found.moment - expected).abs() <= 1e-9 * expected, "{steps}: {found:?}, not {expected}");
        let off_middle = (found.at - 0.5 * l).abs();
        assert!((off_middle - 0.25 * d).abs() <= 1e-6, "{steps}: {found:?}");
    }
}

/// A force that rolls over one span: the influence lines of the textbook, `P x (l − x)/l` for the moment, `P (l − x)/l` and `−P x/l` for the
/// shear force. There is a row at each place.
#[test]
fn one_axle_on_one_span_has_the_envelope_of_the_textbook() {
    let (l, force) = (10.0, 80.0);
    let scene = axles(l, &[0.0, l], None, &[(0.0, force)]);
    let places = envelope(&scene, PATHS[0], l, 2).x.len();
    let found = envelope(&scene, PATHS[0], l, places);
    let listed = found.moment_max.iter().zip(&found.moment_min).zip(found.shear_max.iter().zip(&found.shear_min));
    // A force on a support shears nothing.
    let inside = found.x.iter().zip(listed).filter(|(x, _)| 0.0 < **x && **x < l);
    for (x, ((moment_max, moment_min), (shear_max, shear_min))) in inside {
        let expected = [force * x * (l - x) / l, 0.0, force * (l - x) / l, -force * x / l];
        for (found, expected) in [moment_max, moment_min, shear_max, shear_min].into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-11 * force * l, "{x}: {found}, not {expected}");
        }
    }
}

/// Largest and smallest moment and the forces of the supports at a position.
fn extremes(sweep: &Sweep<'_>, value: f64) -> Vec<[f64; 2]> {
    let state = theory::solve(&sweep.scene(value).expect("a scene")).expect("an answer").state;
    let supports = state.supports.iter().map(|support| [support.force; 2]);
    std::iter::once([state.moment.min, state.moment.max]).chain(supports).collect()
}

/// The extremes over many positions are nowhere beyond the refined ones, and come near to them: one axle and two, over three spans, on
/// uneven ground and without. The positions are a thousand, and around the best one of these for each number as near to each other as
/// 20,000 would be.
#[test]
fn refined_extremes_are_those_of_many_positions() {
    const TO: f64 = 28.0;
    const POSITIONS: u32 = 1000;
    const BETWEEN: i32 = 20;
    let ground = Foundation::Cosine { mean: 0.3, amplitude: 0.1, wavelength: 12.0, phase: 0.0 };
    for ground in [None, Some(ground)] {
        for (path, places) in [(PATHS[0], vec![(0.0, 100.0)]), (PATHS[1], vec![(0.0, 100.0), (1.8, 80.0)])] {
            let scene = axles(30.0, &[0.0, 10.0, 20.0, 30.0], ground.clone(), &places);
            let found = envelope(&scene, path, TO, 113);
            let sweep = Sweep::new(&scene, path, [0.0, TO], 2).expect("a sweep");
            let values: Vec<f64> = (0..=POSITIONS).map(|i| TO * f64::from(i) / f64::from(POSITIONS)).collect();
            let all: Vec<Vec<[f64; 2]>> = values.iter().map(|value| extremes(&sweep, *value)).collect();
            let moments = found.governing;
            let refined = std::iter::once([moments.moment_min.moment, moments.moment_max.moment]);
            let refined = refined.chain(found.supports.iter().map(|support| [support.min, support.max]));
            for (k, refined) in refined.enumerate() {
                let of = |position: &[[f64; 2]], side: usize| [-position[k][0], position[k][1]][side];
                let brute = [0, 1].map(|side| {
                    let best = (0..all.len()).max_by(|a, b| of(&all[*a], side).total_cmp(&of(&all[*b], side)));
                    let best = values[best.expect("positions")];
                    let near = (-BETWEEN..=BETWEEN).map(|j| best + f64::from(j) / f64::from(BETWEEN) * values[1]);
                    let near = near.filter(|value| (0.0..=TO).contains(value));
                    near.map(|value| of(&extremes(&sweep, value), side)).fold(f64::NEG_INFINITY, f64::max)
                });
                let size = brute[1].max(brute[0]);
                let beyond = [brute[0] + refined[0], brute[1] - refined[1]];
                assert!(beyond.iter().all(|by| *by <= 1e-9 * size), "{path}: {refined:?} and {brute:?}");
                // A position is at most 0.0007 from the one that governs; the moment changes by some 50 for each unit there.
                assert!(beyond.iter().all(|by| -2e-4 * size <= *by), "{path}: {refined:?} and {brute:?}");
            }
            let over = |values: &[f64]| values.iter().fold(f64::NEG_INFINITY, |most: f64, value| most.max(*value));
            assert!(over(&found.moment_max) <= moments.moment_max.moment, "the rows are within what governs");
        }
    }
}

/// Refinement ends with the work that is allowed, the moments first; what it has not come to is that of the rows.
#[test]
fn an_envelope_is_refined_with_the_work_that_is_allowed() {
    let supports: Vec<f64> = (0..40).map(f64::from).collect();
    let scene = axles(39.0, &supports, None, &[(0.0, 100.0)]);
    let sweep = Sweep::new(&scene, PATHS[0], [0.3, 38.9], 12).expect("a sweep");
    let [(rows, none), (some, few), (all, enough)] = [1, 4_000_000, u64::MAX].map(|work| {
        let (envelope, enough) = gathered(&sweep).envelope_within(work);
        (envelope.expect("there are rows"), enough)
    });
    assert_eq!((none, few, enough), (false, false, true));
    assert_eq!(some.governing, all.governing, "of the moments there is enough");
    let sum = |envelope: &Envelope| envelope.supports.iter().map(|support| support.max - support.min).sum::<f64>();
    assert!(sum(&rows) < sum(&some) && sum(&some) < sum(&all), "{} {} {}", sum(&rows), sum(&some), sum(&all));
}

/// Each number keeps what it has more than the first; places that coincide on the way are no error.
#[test]
fn numbers_that_move_together_keep_their_distance() {
    let scene = axles(30.0, &[0.0, 10.0, 20.0, 30.0], None, &[(2.0, 1.0), (5.0, 2.0)]);
    let sweep = Sweep::new(&scene, "load.point[1].at, load.point[0].at", [4.0, 29.0], 6).expect("a sweep");
    let places: Vec<f64> = sweep.scene(29.0).expect("a scene").load().point().iter().map(|p| p.at).collect();
    assert_eq!(places, [26.0, 29.0]);
    assert_eq!(sweep.paths(), "load.point[1].at,load.point[0].at");
    let scene = axles(40.0, &[0.0, 10.0, 20.0, 40.0], None, &[(2.0, 1.0)]);
    let supports = Sweep::new(&scene, "beam.supports[1].at,beam.supports[2].at", [15.0, 25.0], 4).expect("a sweep");
    let moved = supports.scene(20.0).expect("the second one is where the third one was");
    assert_eq!(moved.beam().supports().iter().map(|support| support.at).collect::<Vec<_>>(), [0.0, 20.0, 30.0, 40.0]);
    let refused = |path| Sweep::new(&scene, path, [0.0, 1.0], 3).expect_err(path);
    assert!(matches!(refused("load.uniform,load.uniform"), SweepError::Twice(_)));
    assert!(matches!(refused("load.point[0].at,load.point[0].force"), SweepError::Units { .. }));
    assert!(matches!(refused("load.point[0].at,"), SweepError::Path(_)));
}
