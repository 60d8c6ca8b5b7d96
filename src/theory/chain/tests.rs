//! Chains of few links, and those of beams with closed forms.

use super::*;

/// What a chain of equal links says above a flat foundation at depth 1, under the load 1 on a beam with `EI = 1`.
fn above_flat_ground(length: f64, links: u32, beam: bool) -> Guess {
    let step = length / f64::from(links);
    let n = links as usize - 1;
    // The end rotations of a beam under a uniform load, ½ at each node from either side.
    let turn = if beam { step * step * step / 12.0 } else { 0.0 };
    let x: Vec<f64> = (0..=links).map(|i| step * f64::from(i)).collect();
    simple(&x, &vec![turn; n], &vec![step; n], &vec![beam; n + 1])
}

/// What a chain on two supports says above a flat foundation at depth 1: bends and loads of the samples between, and of these.
fn simple(x: &[f64], bend: &[f64], load: &[f64], beam: &[bool]) -> Guess {
    let last = x.len() - 1;
    let at = |values: &[f64], i: usize| if i == 0 || i == last { 0.0 } else { values[i - 1] };
    let sample = |i: usize| ChainSample {
        x: x[i],
        bend: at(bend, i),
        load: at(load, i),
        held: (i == 0 || i == last).then_some(1.0),
        beam: i < last && beam[i],
        ..ChainSample::default()
    };
    let samples: Vec<ChainSample> = (0..=last).map(sample).collect();
    let guess = Chain { samples: &samples, built_in: [false; 2], tension: 0.0 }.solve();
    Guess { touches: guess.touches[1..last].to_vec(), force: guess.force[1..last].to_vec() }
}

#[test]
fn it_touches_where_the_closed_form_does() {
    let (length, links) = (10.0, 200);
    let guess = above_flat_ground(length, links, false);
    // a⁴ = 24 EI u₀ / q₀.
    let lift_off = 24.0_f64.sqrt().sqrt();
    let step = length / f64::from(links);
    for (i, touches) in (1..links).zip(&guess.touches) {
        let x = step * f64::from(i);
        let beside = (x.min(length - x) - lift_off).abs();
        assert!(*touches == (lift_off < x.min(length - x)) || beside < 2.0 * step, "{touches} at {x}");
    }
    let force: f64 = guess.force.iter().sum();
    assert!(0.0 < force && guess.force.iter().all(|f| -1e-12 * force <= *f));
}

#[test]
fn a_link_far_from_contact_is_exact() {
    // One sample at mid-span: it touches exactly if 5 q l⁴/(384 EI) exceeds the depth 1.
    let border = (384.0_f64 / 5.0).sqrt().sqrt();
    for (length, touches) in [(0.999 * border, false), (1.001 * border, true)] {
        assert_eq!(above_flat_ground(length, 2, true).touches, [touches], "length {length}");
    }
}

#[test]
fn links_of_very_different_lengths_lose_nothing() {
    // A link of 1e-9 beside one of the length of the beam.
    let guess = simple(&[0.0, 5.0, 5.0 + 1e-9, 10.0], &[(125.0 + 1e-27) / 24.0; 2], &[2.5; 2], &[true; 3]);
    assert!(guess.touches.iter().any(|&touches| touches));
    // The closed form for contact at mid-span: F = 5 q l/8 − 48 EI u/l³.
    let total: f64 = guess.force.iter().sum();
    let expected = 5.0 * 10.0 / 8.0 - 48.0 / 1000.0;
    assert!((total - expected).abs() < 1e-8 * expected, "{total} instead of {expected}");
}
