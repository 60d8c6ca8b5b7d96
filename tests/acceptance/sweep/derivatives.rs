//! Derivatives of exact answers beside differences of answers.

use palkki::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Quantity, Scene, Support, file};
use palkki::theory::{self, By, Missing};
use palkki_evidence::differences::Trial;
use palkki_evidence::draft::{Draft, Units};
use palkki_evidence::random;

use crate::scenes::{ends, on_supports};

/// A contact of no force, at the border of two regimes, has one derivative on either side.
#[test]
fn at_a_change_of_the_kind_derivatives_are_one_sided() {
    for (depth, one_sided) in [(20.0, true), (50.0, false), (100.0, true), (120.0, false)] {
        let scene = super::regimes(depth);
        let exact = theory::solve(&scene).expect("an answer");
        let by_depth = exact.derivatives(&scene).into_iter().find(|d| d.by == By::Depth).expect("by the depth");
        assert_eq!(by_depth.one_sided, one_sided, "{depth}: {:?}", exact.state.contacts);
    }
}

/// The same where the bend that vanishes is rounding alone: two fields of `q l/2`, one of them held down by a load on its support,
/// above ground at `q l⁴/(384 EI)`, at which the moment above the point in the middle is zero.
#[test]
fn at_a_change_that_is_rounded_derivatives_are_one_sided() {
    for k in 1..=60 {
        let (length, stiffness) = (1.0 + f64::from(k) / 7.0, f64::from(k) / 3.0);
        let ground = Some(Foundation::Flat { depth: length.powi(4) / (384.0 * stiffness) });
        let scene = on_supports([length, stiffness], &ends(length), (1.0, &[(length, -0.5 * length)]), ground);
        let exact = theory::solve(&scene).expect("an answer");
        for derivative in exact.derivatives(&scene) {
            let bends = matches!(derivative.by, By::Depth | By::Number(Quantity::SupportLevel(_) | Quantity::Uniform));
            assert!(derivative.one_sided || !bends, "{k}: {derivative:?}");
        }
    }
}

/// A beam without weight that lies along the ground may as well touch it anywhere: it has no derivatives.
#[test]
fn a_beam_that_lies_without_a_load_has_no_derivatives() {
    let level = |at: f64| Support::simple(at);
    let ground = Some(Foundation::Flat { depth: 0.0 });
    let all_along = on_supports([10.0, 2.0], &ends(10.0), (0.0, &[(5.0, 1.0)]), ground.clone());
    let supports = [level(0.0), level(10.0).at_level(-5.0)];
    let in_part = on_supports([10.0, 2.0], &supports, (0.0, &[(4.0, 3.0), (7.0, 2.0)]), ground);
    for scene in [all_along, in_part, random::held(44)] {
        let exact = theory::solve(&scene).expect("an answer");
        let all = exact.derivatives(&scene);
        assert!(exact.solved && !all.is_empty(), "{scene:?}");
        assert!(all.iter().all(|derivative| derivative.missing == Some(Missing::Ends)), "{all:?}");
    }
}

/// Whether a beam lies along the ground without pressing on it, as one without weight does beyond its contact, is asked in no unit: what is
/// one-sided or missing is the same however large a unit of depth is.
#[test]
fn units_of_depth_change_no_kind_of_derivative() {
    let flat = Some(Foundation::Flat { depth: 0.5 });
    let lying = on_supports([10.0, 2.0], &[], (0.0, &[(5.0, 1.0)]), flat);
    for scene in std::iter::once(lying).chain((0..12).map(random::held)) {
        let draft = Draft::from(&scene);
        let kinds = |power: i32| {
            let units = Units { depth: 2.0_f64.powi(power), ..Units::SAME };
            let scene = draft.in_units(units).scene().expect("in range");
            let Ok(exact) = theory::solve(&scene) else { return Vec::new() };
            exact.derivatives(&scene).iter().map(|of| (of.by, of.one_sided, of.missing)).collect()
        };
        let expected = kinds(0);
        for power in [-40, 40] {
            assert_eq!(kinds(power), expected, "2^{power}: {}", draft.text());
        }
    }
}

/// Where contact is one point the force is linear in the depth: F = 5ql/8 − 48 EI u₀/l³.
#[test]
fn the_force_of_a_point_is_linear_in_the_depth() {
    let scene = super::regimes(50.0);
    let exact = theory::solve(&scene).expect("an answer");
    let by_depth = exact.derivatives(&scene).into_iter().find(|d| d.by == By::Depth).expect("by the depth");
    let expected = -48.0 * scene.beam().bending_stiffness() / 1000.0;
    let found = by_depth.contacts[0].force;
    assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{found} for {expected}");
    assert!((by_depth.supports[0] + 0.5 * expected).abs() <= 1e-12 * expected.abs());
    assert!((by_depth.energy + exact.state.contact_force()).abs() <= 1e-12 * exact.state.contact_force());
}

/// The zone starts exactly at the point load: stiffer, it starts beyond the load, and softer before it. By the stiffness its start
/// moves by 1 on one side and by 0.2 on the other, and beside the load on both sides alike. The left support can only move inwards,
/// and the start of the zone beyond the load with it.
#[test]
fn where_a_zone_ends_at_a_load_derivatives_are_one_sided() {
    let scene = |stiffness: f64| {
        let beam = Beam::new(8.0, stiffness).expect("positive");
        let linear = vec![LinearLoad { from: 20.0 / 3.0, to: 8.0, start: 0.0, end: 2.0 }];
        let point = vec![PointLoad { at: 4.0, force: 8.0 }];
        let load = Load::new(&beam, 1.0, linear, point).expect("finite");
        Scene::new(beam, load, Some(Foundation::Flat { depth: 32.0 / 3.0 })).expect("well posed")
    };
    for (stiffness, one_sided) in [(1.0, true), (0.9, false), (1.1, false)] {
        let scene = scene(stiffness);
        let exact = theory::solve(&scene).expect("in range");
        let derivatives = exact.derivatives(&scene);
        let by_stiffness = derivatives.iter().find(|d| d.by == By::Number(Quantity::BendingStiffness));
        assert_eq!(by_stiffness.map(|d| d.one_sided), Some(one_sided), "stiffness {stiffness}");
        if one_sided {
            for (quantity, expected) in [(Quantity::BendingStiffness, 0.2), (Quantity::SupportAt(0), 0.2)] {
                let derivative = derivatives.iter().find(|d| d.by == By::Number(quantity)).expect("of this number");
                let from = derivative.contacts[0].from;
                assert!((from - expected).abs() < 1e-12, "by {quantity} the zone starts {from} later");
                assert_eq!(derivative.missing, None, "{quantity}");
            }
        }
    }
}

/// On level ground under a load that falls to nothing at one place: where less load would lift the beam off there, and more would not.
/// At an end of the beam, with a support and without, and inside.
#[test]
fn where_a_zone_does_not_press_at_one_place_derivatives_are_one_sided() {
    for (supports, at) in [(true, 10.0), (false, 10.0), (true, 4.0), (false, 7.0)] {
        let beam = Beam::new(10.0, 3.0).expect("positive");
        let beam = if supports { beam } else { beam.with_supports(Vec::new()).expect("a body") };
        let falling = LinearLoad { from: 0.0, to: at, start: 0.0, end: -2.0 };
        let rising = LinearLoad { from: at, to: 10.0, start: -2.0, end: 0.0 };
        let linear = if at < 10.0 { vec![falling, rising] } else { vec![falling] };
        let load = Load::new(&beam, 2.0, linear, Vec::new()).expect("finite");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 0.0 })).expect("well posed");
        let exact = theory::solve(&scene).expect("in range");
        let derivatives = exact.derivatives(&scene);
        let flagged = |by| derivatives.iter().find(|d| d.by == by).map(|d| (d.one_sided, d.missing));
        assert_eq!(flagged(By::Number(Quantity::Uniform)), Some((true, None)), "{supports}, {at}");
        assert_eq!(flagged(By::Number(Quantity::BendingStiffness)), Some((false, None)), "{supports}, {at}");
    }
}

/// A support that holds the slope of a beam with an own shape: `v = d − w0` and `v' = φ − w0'` change with its place.
#[test]
fn a_built_in_support_of_a_curved_beam_moves() {
    let held = Support { level: 0.3, slope: Some(0.1), ..Support::simple(2.0) };
    let supports = vec![held, Support::simple(10.0)];
    let shapes = [
        Foundation::Polynomial { coefficients: vec![0.1, -0.2, 0.03, 0.001] },
        Foundation::Cosine { mean: 0.1, amplitude: 0.2, wavelength: 7.0, phase: 0.4 },
        Foundation::Polyline { points: vec![[0.0, 0.1], [3.0, 0.4], [10.0, 0.0]] },
    ];
    for (shape, depth) in shapes.into_iter().flat_map(|shape| [(shape.clone(), 50.0), (shape, 2.0)]) {
        let beam = Beam::new(10.0, 20.0).and_then(|beam| beam.with_supports(supports.clone()));
        let beam = beam.and_then(|beam| beam.with_shape(shape)).expect("a beam");
        let load = Load::uniform_on(&beam, 1.0).expect("a load");
        let scene = Scene::new(beam, load, Some(Foundation::Flat { depth })).expect("a scene");
        let exact = theory::solve(&scene).expect("an answer");
        let by = By::Number(Quantity::SupportAt(0));
        let derivative = exact.derivatives(&scene).into_iter().find(|d| d.by == by).expect("by its place");
        assert!(exact.solved && !derivative.one_sided, "{scene:?}");
        let mut trial = Trial::default();
        trial.compare("curved", &scene);
        assert!(trial.wrong.is_empty() && 0 < trial.both, "{trial:?}");
    }
}

/// Things at one place: supports, ends of line loads, point loads, kinks, ends of zones; and, by index, zones without pressure and
/// forces that are small beside others; and a support beside whose level a force of 0.2 changes by 10⁶ for a unit. A thousand scenes take
/// half a minute.
#[test]
fn derivatives_hold_on_the_sides_that_are_said() {
    let mut trial = Trial::default();
    (0..160).chain([1335, 2535, 2558, 2659, 3100, 3154, 5159]).for_each(|i| trial.add(i));
    assert!(trial.wrong.is_empty(), "{}", trial.wrong.join("\n"));
    let Trial { scenes, both, one, cautious, .. } = trial;
    assert!(100 < scenes && 500 < both && 50 < one && 5 * cautious < one, "{trial:?}");
}

/// A load above a support, and a small one `f` on the tip, which lies on the ground and carries it: any other load that raises the tip,
/// by `f` at the least, lifts it off. Where that is less than a ten-millionth of the load above the support the derivative holds on
/// one side; the depth moves the tip, and no force.
#[test]
fn where_a_change_that_means_nothing_ends_the_kind_derivatives_are_one_sided() {
    for (i, share) in [1e-16, 1e-14, 1e-12, 1e-11, 1e-3].into_iter().enumerate() {
        for k in 1..=12_u32 {
            let (length, at) = (1.0 + f64::from(k) / 3.0, 0.5 + 0.4 * f64::from(k) / 12.0);
            let load: f64 = if k % 2 == 0 { 1.5 } else { -1.5 };
            let points = [(at * length, load), (length, share * load.abs())];
            let ground = Some(Foundation::Flat { depth: 0.1 * f64::from(k) });
            let scene = on_supports([length, 30.0], &[Support::simple(at * length)], (0.0, &points), ground);
            let exact = theory::solve(&scene).expect("an answer");
            let contacts = &exact.state.contacts;
            assert!(exact.solved && contacts.len() == 1, "{i} {k}: {contacts:?}");
            let lifts = share < 1e-8;
            for derivative in exact.derivatives(&scene) {
                let one_sided = match derivative.by {
                    By::Number(Quantity::Uniform | Quantity::PointAt(0) | Quantity::SupportAt(_)) => lifts,
                    By::Number(Quantity::PointForce(1)) => lifts,
                    By::Number(Quantity::PointAt(1)) => true,
                    _ => false,
                };
                assert_eq!(derivative.one_sided, one_sided, "{i} {k}: {derivative:?}");
            }
        }
    }
}

/// A tip that a couple `P a` of two loads side by side lifts off level ground, `P a = q z²/2`: the beam above the short stretch `z` is
/// bent, and does not lie along the ground, however little it clears it. By the loads `z' = −1/q` and `−(1 − a/z)/q`, by `q` it is
/// `−z/2q`, and no change of them ends that; by `a` it is `P/q z`, as far as the load at the tip.
#[test]
fn a_short_tip_that_a_couple_lifts_is_no_change_of_the_kind() {
    for k in 0..20_i32 {
        let (length, load, q) =
            (1.0 + 0.5 * f64::from(k % 5), 0.5 + 0.1 * f64::from(k % 7), 1.0 + 0.3 * f64::from(k % 3));
        let a = length * 1e-12 * 10_f64.powf(f64::from(k) / 8.0);
        let z = (2.0 * load * a / q).sqrt();
        let ground = Some(Foundation::Flat { depth: 0.01 });
        let points = [(0.0, -load), (a, load)];
        let scene = on_supports([length, 0.01], &[Support::simple(length)], (q, &points), ground);
        let exact = theory::solve(&scene).expect("an answer");
        let contacts = &exact.state.contacts;
        assert!(exact.solved && (contacts[0].from - z).abs() <= 1e-6 * z, "{k}: {z} {contacts:?}");
        let all = exact.derivatives(&scene);
        let of = |by: Quantity| all.iter().find(|d| d.by == By::Number(by)).expect("a derivative");
        let expected = [
            (Quantity::PointForce(0), -1.0 / q, false),
            (Quantity::PointForce(1), -(1.0 - a / z) / q, false),
            (Quantity::Uniform, -0.5 * z / q, false),
        ];
        for (by, expected, one_sided) in expected {
            let found = of(by);
            let from = found.contacts[0].from;
            assert!(
                found.missing.is_none() && (from - expected).abs() <= 1e-6 * expected.abs(),
                "{k}, {expected}: {found:?}"
            );
            assert_eq!(found.one_sided, one_sided, "{k}: {found:?}");
        }
        assert!(!of(Quantity::BendingStiffness).one_sided, "{k}");
        // The load at the tip goes to one side only, and comes to the other load at once.
        assert_eq!(of(Quantity::PointAt(0)).missing, Some(Missing::Ends), "{k}");
    }
}

/// A load `P` that stands on a corner between spans `a` and `b` goes into it. Where it moves a couple `P` turns both spans, of which
/// `b/(a + b)` bends the left one and presses with `P b/(a (a + b))` on its support.
#[test]
fn a_load_on_an_edge_is_carried_there() {
    let ridge = Foundation::Polyline { points: vec![[0.0, 3.0], [4.0, 0.5], [10.0, 3.0]] };
    let scene = on_supports([10.0, 20.0], &ends(10.0), (1.0, &[(4.0, 3.0)]), Some(ridge));
    let derivatives = theory::solve(&scene).expect("an answer").derivatives(&scene);
    for (by, expected) in [(Quantity::PointForce(0), [0.0, 1.0, 0.0]), (Quantity::PointAt(0), [-0.45, 0.25, 0.2])] {
        let found = derivatives.iter().find(|d| d.by == By::Number(by)).expect("a derivative");
        let forces = [found.supports[0], found.contacts[0].force, found.supports[1]];
        let close = forces.iter().zip(expected).all(|(force, expected)| (force - expected).abs() < 1e-12);
        assert!(close && !found.one_sided, "{found:?}");
    }
}

/// The edge of a load stays where it is when the support below it moves: of q from 2 to 8 on supports there, R = 3 and 3, and the
/// load's resultant at 5 is shared as the lever rule says.
#[test]
fn the_edge_of_a_load_does_not_move_with_the_support() {
    let beam = Beam::new(10.0, 1.3).and_then(|b| b.with_supports(vec![Support::simple(2.0), Support::simple(8.0)]));
    let beam = beam.expect("a beam");
    let load = Load::new(&beam, 0.0, vec![LinearLoad { from: 2.0, to: 8.0, start: 1.0, end: 1.0 }], Vec::new());
    let scene = Scene::new(beam, load.expect("a load"), None).expect("a scene");
    let exact = theory::solve(&scene).expect("an answer");
    for derivative in exact.derivatives(&scene) {
        if let By::Number(Quantity::SupportAt(_)) = derivative.by {
            let [left, right] = [derivative.supports[0], derivative.supports[1]];
            assert!((left - 0.5).abs() < 1e-12 && (right + 0.5).abs() < 1e-12, "{derivative:?}");
            assert!(!derivative.one_sided && derivative.missing.is_none(), "{derivative:?}");
        }
    }
}

/// Ground level with the supports: as it sinks forces grow as a root of the distance, and there is no derivative.
#[test]
fn where_ground_parts_from_a_support_there_is_no_derivative() {
    let scene = super::regimes(0.0);
    let exact = theory::solve(&scene).expect("an answer");
    let by_depth = exact.derivatives(&scene).into_iter().find(|d| d.by == By::Depth).expect("by the depth");
    assert_eq!(by_depth.missing, Some(Missing::Ends));
    assert!(by_depth.supports.iter().all(|force| force.is_nan()) && exact.spread(1e-3).is_none());
    // T = q a/2 with a⁴ = (8/3) EI u₀/q: ten thousand times the depth is ten times the force.
    let force = |depth: f64| theory::solve(&super::regimes(depth)).expect("an answer").state.reactions.left;
    assert!((force(1e-4) / force(1e-8) - 10.0).abs() < 1e-6);
}

/// A support that holds the beam down is no place about which it could turn.
#[test]
fn the_margin_of_a_body_that_stands_is_a_share() {
    // On a crest at 4 with a load of one at 8 and a support at 2, which pulls with 2: min(8 − 2, 4 − 8)/2 = −2 was its margin.
    let crest = vec![[0.0, 3.0], [3.0, 3.0], [4.0, 0.05], [5.0, 3.0], [10.0, 3.0]];
    let crest = Some(Foundation::Polyline { points: crest });
    let scene = on_supports([10.0, 20.0], &[Support::simple(2.0)], (0.0, &[(8.0, 1.0)]), crest);
    let held = theory::solve(&scene).expect("an answer").state;
    assert!((held.supports[0].force + 2.0).abs() < 1e-9 && held.standing.is_some_and(|s| s.margin.is_nan()));
    for i in 0..300 {
        let Ok(exact) = theory::solve(&random::held(i)) else { continue };
        let Some(standing) = exact.state.standing.filter(|_| exact.solved) else { continue };
        let pulls = exact.state.supports.iter().any(|support| support.force < 0.0);
        let within = (0.0..=0.5).contains(&standing.margin);
        assert!(within || pulls && standing.margin.is_nan(), "{i}: {standing:?}");
    }
}

/// A beam on two supports is turned by their levels and not bent, however near to each other they are: its forces do not change, nor does
/// the force of one that carries nothing with its place.
#[test]
fn a_beam_that_is_turned_keeps_its_forces() {
    for k in 1..=60 {
        let (at, apart) = (1.0 + f64::from(k) / 31.0, 5.0 / f64::from(k * k));
        let supports = [Support::simple(at).at_level(-0.02), Support::simple(at + apart)];
        let scene = on_supports([12.4, 927.0], &supports, (0.0, &[(at + apart, 1.0)]), None);
        let exact = theory::solve(&scene).expect("an answer");
        for derivative in exact.derivatives(&scene) {
            if matches!(derivative.by, By::Number(Quantity::SupportLevel(_) | Quantity::SupportAt(0))) {
                assert_eq!(derivative.supports, [0.0; 2], "{k}: {derivative:?}");
            }
        }
    }
}

/// Of many supports a number moves those near by: its derivatives are there on both sides, and those of differences. Between two supports
/// there is a load here and there, and some supports only push. The outermost ones can only move inwards.
#[test]
fn of_many_supports_derivatives_are_those_of_differences() {
    let fields = 200_u32;
    let level = |i: u32| 0.004 * f64::from(i * i % 7);
    let support = |i: u32| match i % 9 {
        4 => Support { level: level(i) + 0.02, ..Support::pushing(f64::from(i)) },
        _ => Support { level: level(i), ..Support::simple(f64::from(i)) },
    };
    let beam =
        Beam::new(f64::from(fields), 1.0).and_then(|beam| beam.with_supports((0..=fields).map(support).collect()));
    let beam = beam.expect("a beam");
    let point = (2..fields).step_by(40).map(|i| PointLoad { at: f64::from(i) + 0.3, force: 0.5 }).collect();
    let load = Load::new(&beam, 1.0, Vec::new(), point).expect("a load");
    let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 })).expect("a scene");
    let mut trial = Trial::default();
    trial.compare("many supports", &scene);
    assert!(trial.wrong.is_empty(), "{}", trial.wrong.join("\n"));
    assert!(400 < trial.both && trial.one == 2 && trial.none == 0, "{trial:?}");
}

/// Supports that give, joints, steps, couples and axial forces, above rigid ground and on elastic foundations: derivatives by all of their numbers
/// are those of differences, on the sides that are said.
#[test]
fn derivatives_of_general_beams_are_those_of_differences() {
    let mut trial = Trial::default();
    for (i, on_soil) in (0..random::sample_of(60_u64)).flat_map(|i| [(i, false), (i, true)]) {
        let general = random::general(i, &random::Feature::ALL, on_soil);
        let scene = file::parse("scene.toml", &general.text, |_| unreachable!("no survey")).expect("a scene");
        trial.compare(&format!("{i}, {on_soil}\n{}", general.text), &scene);
    }
    assert!(trial.wrong.is_empty(), "{}", trial.wrong.join("\n"));
    let Trial { both, one, none, alone, .. } = trial;
    let all = both + one + none + alone;
    assert!(random::sample_of(600) < both && 9 * all <= 10 * both, "{both} of {all}");
}

/// A bearing `k` below the middle of a beam: `R = k f/(1 + k c)` with `f = 5 q l⁴/384 EI` and `c = l³/48 EI`.
#[test]
fn the_force_of_a_bearing_by_its_stiffness() {
    let (length, stiffness, q, k) = (12.0, 40.0, 3.0, 5.0);
    let held = [Support::simple(0.0), Support::spring(0.5 * length, k), Support::simple(length)];
    let scene = on_supports([length, stiffness], &held, (q, &[]), None);
    let exact = theory::solve(&scene).expect("an answer");
    let cube = length * length * length;
    let (free, soft) = (5.0 * q * cube * length / (384.0 * stiffness), 1.0 + k * cube / (48.0 * stiffness));
    // By the level, a deflection as much as `f` is.
    let expected = [
        (Quantity::SupportStiffness(1), free / soft / soft),
        (Quantity::SupportLevel(1), -k / soft),
        (Quantity::Uniform, k * free / soft / q),
        (Quantity::BendingStiffness, -k * free / soft / soft / stiffness),
    ];
    let all = exact.derivatives(&scene);
    for (quantity, expected) in expected {
        let derivative = all.iter().find(|derivative| derivative.by == By::Number(quantity)).expect("of this number");
        let found = derivative.supports[1];
        assert!((found - expected).abs() <= 1e-8 * expected.abs(), "{quantity}: {found} for {expected}");
        assert!(!derivative.one_sided && derivative.missing.is_none(), "{derivative:?}");
    }
}
