//! Stiff ground: the closed form of a long zone, the way to rigid ground, and the strip and the gap that its concentrated force is.

use palkki::route::Status;
use palkki::sweep::Sweep;
use palkki::{Solution, solve_exactly};
use palkki_evidence::closed::{gap_opens, stiff, strip};
use palkki_evidence::paper;

/// The example of the paper on ground of a stiffness, certified.
#[track_caller]
fn example(stiffness: f64) -> Solution {
    let scene = paper::example().and_then(|scene| scene.on_springs(stiffness)).expect("a scene");
    let solution = solve_exactly(&scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{stiffness:e}: {}", solution.verdict);
    solution
}

fn bending_stiffness() -> f64 {
    paper::beam().expect("a beam").bending_stiffness()
}

/// Up to where the gap opens; below, the two ends of the zone begin to feel each other.
#[test]
fn a_long_zone_is_its_closed_form() {
    const DIGITS: f64 = 1e-13;
    for ground in [1e4, 3e4, 1e5, 1e6, 4.9e6] {
        let (state, expected) = (example(ground).state, stiff(bending_stiffness(), 1.0, 1.0, ground));
        let pressure = state.pressure.expect("of ground that gives");
        let pairs = [
            (state.reactions.left, expected.reaction),
            (state.contacts[0].from, expected.lift_off),
            (pressure.max, expected.pressure),
        ];
        for (found, expected) in pairs {
            assert!((found - expected).abs() <= DIGITS * expected, "{ground:e}: {found} for {expected}");
        }
        // Its mirror image is as large.
        let at = pressure.at.min(10.0 - pressure.at);
        assert!((at - expected.at).abs() <= 1e-7 * expected.at, "{ground:e}: {at} for {}", expected.at);
    }
}

/// The gap opens where the least pressure of the closed form is zero, and a sweep finds it.
#[test]
fn the_gap_opens_where_the_pressure_would_be_negative() {
    // k = 4 EI λ⁴, and a⁴ = 24 EI for this depth and load.
    let expected = libm::pow(gap_opens(), 4.0) / 6.0;
    let scene = paper::example().and_then(|scene| scene.on_springs(1.0)).expect("a scene");
    let sweep = Sweep::new(&scene, "foundation.stiffness", [4.9e6, 5.0e6], 2).expect("a sweep");
    let events = sweep.events(&sweep.rows().expect("answers"));
    let [event] = &events[..] else { panic!("one event: {events:?}") };
    assert!((event.value - expected).abs() <= 1e-9 * expected, "{event:?} for {expected}");
    assert!(event.what.ends_with("splits"), "{event:?}");
}

/// Strip, gap and largest pressure come to their limits like `λ^(−1/3)`, which is what the moment in the gap is beside that of the strip.
#[test]
fn strip_and_gap_come_to_their_law() {
    let rigid = paper::theory();
    let (lift_off, force) = (rigid.lift_off.expect("a zone"), rigid.end_force);
    let limit = strip();
    let off = |ground: f64| {
        let (state, decay) = (example(ground).state, (0.25 * ground / bending_stiffness()).sqrt().sqrt());
        let [strip, zone, _] = state.contacts[..] else { panic!("strip, zone, strip: {:?}", state.contacts) };
        let law = limit.gap * libm::cbrt(lift_off / (decay * decay));
        let pressure = state.pressure.expect("of ground that gives").max;
        [
            (strip.to - strip.from) * decay / limit.length - 1.0,
            (zone.from - strip.to) / law - 1.0,
            pressure / (decay * force) / limit.pressure - 1.0,
        ]
    };
    // λ grows by ten; terms of higher order are left.
    let [soft, hard] = [1e14, 1e18].map(off);
    for (soft, hard) in soft.into_iter().zip(hard) {
        let order = libm::log10(soft / hard);
        assert!((order - 1.0 / 3.0).abs() <= 0.06, "{soft} and {hard}: {order}");
    }
}

/// Rigid ground is the limit: the reaction converges with `k^(−3/4)`, and is that of rigid ground to 11 digits at last.
#[test]
fn stiff_ground_comes_to_rigid_ground() {
    let rigid = paper::theory().reaction;
    let off = |stiffness: f64| (example(stiffness).state.reactions.left - rigid).abs();
    let order = libm::log10(off(1e6) / off(1e12)) / 6.0;
    assert!((order - 0.75).abs() <= 0.01, "{order}");
    assert!(off(1e15) <= 1e-11 * rigid, "{:e}", off(1e15));
}
