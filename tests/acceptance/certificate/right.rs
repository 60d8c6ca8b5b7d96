//! Answers of beam theory that are right in families that are hard to prove: each of them is certified.

use palkki::route::Status;
use palkki::scene::{Foundation, PointLoad, Scene, Support};
use palkki::theory::Exact;
use palkki::verdict::{Demand, Verdict};
use palkki::{solve_exactly, theory};
use palkki_evidence::draft::Draft;
use palkki_evidence::extremes::chebyshev;
use palkki_evidence::random::Random;

#[track_caller]
fn certified(scene: &Scene, what: &str) {
    let solution = solve_exactly(scene).expect("an answer");
    assert_eq!(
        solution.verdict.status,
        Status::Certified,
        "{what}: {}\n{}",
        solution.verdict,
        Draft::from(scene).text()
    );
}

fn power_of_ten(random: &mut Random, from: f64, to: f64) -> f64 {
    10.0_f64.powf(random.between(from, to))
}

/// A body without supports above some ground.
fn body(length: f64, ground: Foundation, uniform: f64, points: &[(f64, f64)]) -> Scene {
    let draft =
        Draft { length, stiffness: 1.3, uniform, ground: Some(ground), supports: Some(Vec::new()), ..Draft::default() };
    draft.with_points(points).scene().expect("well posed")
}

/// Chebyshev's polynomials of degrees 2 to 6 as ground, on supports and without.
#[test]
fn polynomials_of_any_degree() {
    let mut random = Random::new(5);
    for degree in 2..=6 {
        for k in 0..20 {
            let length = random.pick(&[1.0, 10.0, 7.3, 3.0]);
            let stiffness = random.pick(&[1.3, 500.0 / 384.0, 1.0, 77.0]);
            let amplitude = power_of_ten(&mut random, -3.0, 0.0);
            let free = k % 2 == 0;
            let mean = amplitude * if free { random.between(-1.0, 3.0) } else { random.between(1.0, 3.0) };
            let unit = std::iter::successors(Some(amplitude), |unit| Some(unit / length));
            let mut coefficients: Vec<f64> = chebyshev(degree).iter().zip(unit).map(|(c, unit)| c * unit).collect();
            coefficients[0] += mean;
            let uniform = power_of_ten(&mut random, 1.0, 5.0) * stiffness * amplitude / length.powi(4);
            let ground = Some(Foundation::Polynomial { coefficients });
            let supports = free.then(Vec::new);
            let draft = Draft { length, stiffness, uniform, ground, supports, ..Draft::default() };
            if let Ok(scene) = draft.scene() {
                certified(&scene, &format!("degree {degree}"));
            }
        }
    }
}

/// Cosines with an inflection at a free end: a quarter of a wave and up, from either side.
#[test]
fn inflections_at_free_ends() {
    let mut random = Random::new(8);
    for _ in 0..120 {
        let length = random.pick(&[10.0, 1.0, 7.3]);
        let waves = random.pick(&[0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0]);
        let quarter = random.pick(&[1.0, -1.0]) * std::f64::consts::FRAC_PI_2;
        let phase = if random.once_in(2) { quarter } else { quarter - 2.0 * std::f64::consts::PI * waves };
        let ground = Foundation::Cosine { mean: 1.0, amplitude: 0.5, wavelength: length / waves, phase };
        let uniform = power_of_ten(&mut random, -1.0, 4.0) * 1.3 / length.powi(4);
        certified(&body(length, ground, uniform, &[]), &format!("{waves} waves"));
    }
}

/// Level ground next to the beam: of the depth a millionth is known.
#[test]
fn ground_next_to_the_beam() {
    let mut random = Random::new(6);
    for power in 8..=14 {
        for _ in 0..20 {
            let length = random.pick(&[10.0, 1.0, 3.7]);
            let depth = random.between(1.0, 9.9) * format!("1e-{power}").parse::<f64>().expect("a number") * length;
            let stiffness = random.pick(&[500.0 / 384.0, 1.3, 1.0, 7e3]);
            let uniform = random.pick(&[1.0, 10.0, 100.0, 1e3, 1e4]);
            let ground = Some(Foundation::Flat { depth });
            let draft = Draft { length, stiffness, uniform, ground, ..Draft::default() };
            certified(&draft.scene().expect("well posed"), &format!("1e-{power}"));
        }
    }
}

/// A load next to the ridge of a roof: the beam lies on the slope below the load.
#[test]
fn loads_next_to_a_ridge() {
    let mut random = Random::new(12);
    for power in 9..=15 {
        for _ in 0..16 {
            let length = random.pick(&[10.0, 1.0, 7.3]);
            let ridge = random.between(0.05, 0.95) * length;
            let beside = random.between(-1.0, 1.0) * format!("1e-{power}").parse::<f64>().expect("a number") * length;
            let ground = Foundation::Polyline { points: vec![[0.0, 2.0], [ridge, 1.0], [length, 2.5]] };
            let force = power_of_ten(&mut random, -1.0, 1.0);
            if (ridge + beside).to_bits() == ridge.to_bits() {
                continue;
            }
            certified(&body(length, ground, 0.0, &[(ridge + beside, force)]), &format!("1e-{power}"));
        }
    }
}

/// A weightless beam on sleepers in one line with its load above an inner one: the others carry nothing and leave one position.
#[test]
fn sleepers_in_one_line() {
    let mut random = Random::new(9);
    for _ in 0..120 {
        let count = random.pick(&[3, 3, 4, 5]);
        let height = 1.0 + random.between(-0.3, 0.3);
        let slope = if random.once_in(2) { 0.0 } else { random.between(-0.03, 0.03) };
        let mut at: Vec<f64> = (1..20).map(|k| 0.5 * f64::from(k)).collect();
        while count < at.len() {
            at.remove(random.below(at.len()));
        }
        let sleeper = |&x: &f64| [[x - 0.1, 3.0], [x, height + slope * x], [x + 0.1, 3.0]];
        let mut points = vec![[0.0, 3.0]];
        points.extend(at.iter().flat_map(sleeper));
        points.push([10.0, 3.0]);
        let inner = at[1 + random.below(count - 2)];
        let scene = body(10.0, Foundation::Polyline { points }, 0.0, &[(inner, power_of_ten(&mut random, -2.0, 2.0))]);
        certified(&scene, &format!("{count} sleepers"));
        let verdict = solve_exactly(&scene).expect("an answer").verdict;
        assert!(verdict.certificate.is_some_and(|c| c.up_to_a_turn.is_none()), "its position is known");
    }
}

/// A weightless beam at depth 0 on sleepers of one height, its load above one of them, wherever they stand: above an inner one nothing
/// moves, and above the first or the last one, or of two, it may turn. The same answer beside a load that bends or tilts the beam by
/// next to nothing is not certified, nor is one that says it were bent or sunk by next to nothing.
#[test]
fn bodies_at_rest_at_depth_zero() {
    /// Of what the load would do to a beam: more than rounding.
    const SLIGHT: f64 = 1e-12;
    let mut random = Random::new(26);
    let demand = Demand::default();
    let (mut rests, mut turns) = (0, 0);
    for _ in 0..200 {
        let length = random.pick(&[10.0, 1.0, 7.3]);
        let mut at: Vec<f64> = (0..random.pick(&[2, 3, 3, 4])).map(|_| random.between(0.05, 0.95) * length).collect();
        at.sort_by(f64::total_cmp);
        let last = at.len() - 1;
        // Sleepers at the ends, and the load above an inner one.
        let ends = [2, 4].map(|once| 1 < last && random.once_in(once));
        if ends[0] {
            at[0] = 0.0;
        }
        if ends[1] {
            at[last] = length;
        }
        let above = if ends == [false; 2] { random.below(at.len()) } else { 1 + random.below(last - 1) };
        let gaps = [[0.0, at[0]], [at[last], length]].into_iter().chain(at.windows(2).map(|w| [w[0], w[1]]));
        let width = 0.3 * gaps.map(|[a, b]| b - a).filter(|gap| 0.0 < *gap).fold(length, f64::min);
        let sleeper = |&x: &f64| [[x - width, 3.0], [x, 0.0], [x + width, 3.0]];
        let mut points: Vec<[f64; 2]> =
            at.iter().flat_map(sleeper).filter(|p| (0.0..=length).contains(&p[0])).collect();
        if 0.0 < at[0] {
            points.insert(0, [0.0, 3.0]);
        }
        if at[last] < length {
            points.push([length, 3.0]);
        }
        let force = power_of_ten(&mut random, -2.0, 2.0);
        let of = |loads: &[(f64, f64)]| body(length, Foundation::Polyline { points: points.clone() }, 0.0, loads);
        let scene = of(&[(at[above], force)]);
        certified(&scene, &format!("{} of {at:?}", at[above]));
        let exact = theory::solve(&scene).expect("an answer");
        let certificate = Verdict::of_exact(&scene, &exact, &demand).certificate.expect("bounds");
        let inner = 0 < above && above < last;
        assert_eq!(certificate.up_to_a_turn.is_none(), inner, "{certificate:?}");
        assert!(certificate.at_rest || !inner, "{certificate:?}");
        *(if inner { &mut rests } else { &mut turns }) += 1;
        let between = random.between(at[0], at[at.len() - 1]);
        let other = of(&[(at[above], force), (between, force * power_of_ten(&mut random, -10.0, -2.0))]);
        let refused = |scene: &Scene, forged: &Exact| {
            let verdict = Verdict::of_exact(scene, forged, &demand);
            assert_ne!(verdict.status, Status::Certified, "{verdict}\n{}", Draft::from(scene).text());
        };
        refused(&other, &exact);
        if inner {
            let [mut bent, mut sunk] = [exact.clone(), exact];
            bent.state.moment.max += SLIGHT * force * length;
            refused(&scene, &bent);
            sunk.state.deflection.max += SLIGHT * force * length * length * length / scene.beam().bending_stiffness();
            refused(&scene, &sunk);
        }
    }
    assert!(40 < rests && 40 < turns, "{rests} at rest and {turns} that may turn");
}

/// Loads on level ground, at depth 0 and below it.
#[test]
fn loads_on_level_ground() {
    let mut random = Random::new(10);
    for k in 0..60 {
        let length = random.pick(&[10.0, 1.0, 7.3]);
        let depth = random.pick(&[0.0, 0.0, 0.5, 1e-3]);
        let ground = match k % 3 {
            0 => Foundation::Flat { depth },
            1 => Foundation::Polyline { points: vec![[0.0, depth], [0.5 * length, depth], [length, depth]] },
            _ => Foundation::Polynomial { coefficients: vec![depth, 0.1] },
        };
        let count = 1 + random.below(3);
        let points: Vec<(f64, f64)> =
            (0..count).map(|_| (random.between(0.05, 0.95) * length, power_of_ten(&mut random, -1.0, 1.0))).collect();
        certified(&body(length, ground, 0.0, &points), "level");
    }
}

/// The largest deflection is the largest of all, also where it is an inner maximum of a zone that lies in the middle of it.
#[test]
fn the_largest_deflection_is_the_largest_of_all() {
    /// Of the largest: samples and extremes are rounded.
    const ROUNDING: f64 = 1e-13;
    let mut random = Random::new(11);
    let mut scenes = Vec::new();
    for k in 0..150 {
        let s = random.pick(&[1.0, 1.0, 2.0, 0.5]);
        let coefficients = vec![1.1, -0.32 * s, 0.16 * s, -0.0256 * s, 0.001_28 * s];
        let stiffness = if k == 0 { 1.3 } else { random.between(0.5, 3.0) };
        let draft = Draft::over(Foundation::Polynomial { coefficients });
        scenes.push(Draft { stiffness, uniform: 10_000.0, supports: Some(Vec::new()), ..draft });
    }
    for draft in scenes {
        let scene = draft.scene().expect("well posed");
        certified(&scene, "two hollows");
        let exact = theory::solve(&scene).expect("an answer");
        let extremes = exact.state.deflection;
        for k in 0..=1000 {
            let v = exact.deflection(0.001 * f64::from(k) * scene.beam().length());
            let within = extremes.min - ROUNDING <= v && v <= extremes.max + ROUNDING;
            assert!(within, "{v} is not between {} and {}: {}", extremes.min, extremes.max, draft.text());
        }
    }
}

/// A load above a support of the ground is one that no other place shares.
#[test]
fn loads_next_to_the_only_place() {
    let mut random = Random::new(7);
    for power in 9..=14 {
        for _ in 0..12 {
            let length = random.pick(&[10.0, 1.0]);
            let width = 0.02 * length;
            let at = [random.between(0.1, 0.45) * length, random.between(0.55, 0.9) * length];
            let other = random.between(0.9, 1.1);
            let points = vec![
                [0.0, 2.0],
                [at[0] - width, 2.0],
                [at[0], 1.0],
                [at[0] + width, 2.0],
                [at[1] - width, 2.0],
                [at[1], other],
                [at[1] + width, 2.0],
                [length, 2.0],
            ];
            let beside = format!("1e-{power}").parse::<f64>().expect("a number") * length;
            let loads = at.map(|x| PointLoad {
                at: x + random.between(-1.0, 1.0) * beside,
                force: power_of_ten(&mut random, -1.0, 1.0),
            });
            let loads = loads.map(|p| (p.at, p.force));
            certified(&body(length, Foundation::Polyline { points }, 0.0, &loads), &format!("1e-{power}"));
        }
    }
}

/// A force so near to one support of a span that next to nothing of it bends the beam: beside the left and the right end of the beam,
/// beside an inner support and at the root of an overhang, alone and far larger than the other loads.
#[test]
fn loads_next_to_a_support() {
    let mut random = Random::new(25);
    for power in 4..=13 {
        for [left, right] in [[0.0, 1.0], [0.0, 0.7], [0.25, 1.0], [0.25, 0.7]] {
            for k in 0..8 {
                let length = random.pick(&[1.0, 10.0, 7.3]);
                let near = 10.0_f64.powi(-power) * length;
                let [left, right] = [left, right].map(|share| share * length);
                let place = [left - near, left + near, right - near, right + near][k % 4].clamp(near, length - near);
                let supports = Some(vec![Support::simple(left), Support::simple(right)]);
                let uniform = if k < 4 { 0.0 } else { 1.0 };
                let force = if k < 4 { 1.0 } else { 10.0_f64.powi(power) };
                let draft = Draft { length, stiffness: 1.3, uniform, supports, ..Draft::default() };
                let scene = draft.with_points(&[(place, force)]).scene().expect("well posed");
                certified(&scene, &format!("{place} of {length}"));
            }
        }
    }
}

/// Ground that the beam lies on to the left of an inner support, and that bends away from its unloaded end to the right of it: the force
/// of the support is that of the pair.
#[test]
fn ground_beside_an_inner_support_of_an_unloaded_end() {
    let mut random = Random::new(21);
    let mut lies = 0;
    for _ in 0..200 {
        let (length, right) = (random.pick(&[10.0, 1.0, 7.3]), random.between(0.76, 0.9));
        let height = 0.005 * length * random.between(0.5, 1.5);
        let shape = Foundation::Cosine { mean: 0.0, amplitude: height, wavelength: length, phase: 0.0 };
        let supports = vec![
            Support { level: -random.between(0.08, 0.1) * length, ..Support::simple(0.2 * length) },
            Support::simple(right * length),
        ];
        let stiffness = random.pick(&[20.0, 1.3, 500.0]);
        let ground = Some(Foundation::Flat { depth: 0.0 });
        let draft =
            Draft { length, stiffness, shape: Some(shape), supports: Some(supports), ground, ..Draft::default() };
        let force = 15.0 * stiffness / (length * length) * random.between(0.9, 1.1);
        let Ok(scene) = draft.with_points(&[(0.5 * length, force)]).scene() else { continue };
        let contacts = theory::solve(&scene).expect("an answer").state.contacts;
        if contacts.last().is_some_and(|zone| zone.from < zone.to && (zone.to - right * length).abs() < 1e-12 * length)
        {
            certified(&scene, "an unloaded end");
            lies += 1;
        }
    }
    assert!(20 < lies, "{lies}");
}
