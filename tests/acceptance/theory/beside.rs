//! Ground that starts at the level of a support: contact beside it may be as short as one likes, and its forces are not small.

use std::ops::ControlFlow;

use palkki::scene::{Beam, Foundation, Load, PointLoad, Scene, Support};
use palkki::theory::{Exact, solve};
use palkki_evidence::random::Random;

use crate::scenes::on_supports;

/// Halvings of the beam, from a quarter to some millionths of it: distances from a support at which the clearance is looked at.
const HALVINGS: std::ops::Range<i32> = 2..20;
/// Share of the loads, and of the forces of the supports, that a clearance below zero may stand for.
const FORCE: f64 = 1e-7;

/// The largest force that a clearance below zero beside a support stands for, as a share of the forces on the beam, with its
/// place. To lift a beam that is held at a support by `δ` at a distance `t` from it takes `3EI δ/t³` at most.
fn hidden(scene: &Scene, exact: &Exact) -> Option<(f64, f64)> {
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let supports = exact.state.supports.iter().map(|s| s.force.abs()).sum::<f64>();
    let all = scene.load().magnitude(length) + supports;
    let mut worst: Option<(f64, f64)> = None;
    for held in scene.held() {
        for (side, sign) in [(0, -1.0), (1, 1.0)].into_iter().filter(|&(side, _)| held.tangent[side]) {
            let others = exact.state.supports.iter().filter(|s| 0.0 < sign * (s.at - held.at));
            let end = if side == 0 { held.at } else { length - held.at };
            let next = others.map(|s| (s.at - held.at).abs()).fold(end, f64::min);
            for t in HALVINGS.map(|k| length * libm::exp2(-f64::from(k))).filter(|&t| t < 0.5 * next) {
                let force = -3.0 * stiffness * exact.clearance(held.at + sign * t) / (t * t * t) / all;
                if FORCE < force && worst.is_none_or(|(most, _)| most < force) {
                    worst = Some((force, held.at + sign * t));
                }
            }
        }
    }
    worst
}

/// A beam with a support on the ground; the level of another support, or the share of a load, is what varies.
struct Family {
    beam: Beam,
    ground: Foundation,
    supports: Vec<Support>,
    uniform: f64,
    point: Vec<PointLoad>,
    by_level: bool,
    /// From where to where it varies.
    range: [f64; 2],
}

impl Family {
    fn random(random: &mut Random) -> Option<Self> {
        let length = random.between(4.0, 16.0);
        let stiffness = libm::exp2(random.between(0.0, 8.0));
        let beam = Beam::new(length, stiffness).ok()?;
        let uniform = if random.once_in(2) { random.between(0.1, 1.0) } else { 0.0 };
        let point: Vec<PointLoad> = (0..1 + random.below(2))
            .map(|_| PointLoad { at: random.between(0.0, length), force: random.between(0.5, 3.0) })
            .collect();
        let weight = uniform * length + point.iter().map(|p| p.force).sum::<f64>();
        let sag = weight * length.powi(3) / (77.0 * stiffness);
        let rise = sag * libm::exp2(random.between(-6.0, 0.0));
        let profile = |random: &mut Random| match random.below(4) {
            0 => Foundation::Flat { depth: 0.0 },
            1 => Foundation::Polynomial {
                coefficients: vec![
                    0.0,
                    rise / length * random.between(-1.0, 1.0),
                    rise / length.powi(2) * random.between(-1.0, 1.0),
                ],
            },
            _ => Foundation::Cosine {
                mean: 0.0,
                amplitude: rise * random.between(0.1, 1.0),
                wavelength: length * random.between(0.5, 2.0),
                phase: if random.once_in(2) { 0.0 } else { random.between(0.0, 6.0) },
            },
        };
        let ground = profile(random);
        let beam = if random.once_in(2) { beam.with_shape(profile(random)).ok()? } else { beam };
        let at = match random.below(3) {
            0 => length,
            1 => length * f64::from(1 + u8::try_from(random.below(9)).ok()?) / 10.0,
            _ => random.between(0.2, 1.0) * length,
        };
        let [depth, slope] = ground.sides(at)[0];
        let own = beam.shape().map_or(0.0, |own| own.sides(at)[0][1]);
        let built_in = random.once_in(3).then_some(if own == 0.0 { slope } else { return None });
        let mut supports = vec![Support { level: depth, slope: built_in, ..Support::simple(at) }];
        supports.push(Support::simple(random.between(0.0, 0.8) * at));
        if random.once_in(4) {
            let other = 0.5 * (supports[0].at + supports[1].at);
            supports.push(Support::simple(other).at_level(ground.depth(other) - 0.1 * rise));
        }
        let by_level = random.once_in(2);
        let top = ground.depth(supports[1].at);
        let range = if by_level { [top - 2.0 * sag, top] } else { [0.0, 4.0] };
        supports[1].level = top - random.between(0.0, 1.0) * sag;
        Some(Self { beam, ground, supports, uniform, point, by_level, range })
    }

    fn scene(&self, share: f64) -> Option<Scene> {
        let (mut supports, mut point) = (self.supports.clone(), self.point.clone());
        let value = self.range[0] + share * (self.range[1] - self.range[0]);
        if self.by_level {
            supports[1].level = value;
        } else {
            point[0].force *= value;
        }
        let beam = self.beam.clone().with_supports(supports).ok()?;
        let load = Load::new(&beam, self.uniform, Vec::new(), point).ok()?;
        Scene::new(beam, load, Some(self.ground.clone())).ok()
    }

    /// Whether the beam lies on the ground beside the support that is on it.
    fn lies(&self, exact: &Exact) -> bool {
        let ends = |x: f64| (x - self.supports[0].at).abs() <= 1e-15 * x;
        let contacts = exact.state.contacts.iter().map(|c| [c.from, c.to]);
        let mut all = contacts.chain(exact.state.touches.iter().map(|t| [t.from, t.to]));
        all.any(|[from, to]| from < to && (ends(from) || ends(to)))
    }

    /// Shares at which a zone beside the support begins or ends, each from without to within.
    fn borders(&self) -> Vec<[f64; 2]> {
        let lies =
            |share: f64| solve(&self.scene(share)?).ok().filter(|exact| exact.solved).map(|exact| self.lies(&exact));
        let known: Vec<(f64, bool)> =
            (0..=12).map(|k| f64::from(k) / 12.0).filter_map(|share| Some((share, lies(share)?))).collect();
        let pairs = known.windows(2).filter(|w| w[0].1 != w[1].1);
        let narrowed = pairs.map(|w| {
            let [mut out, mut inside] = if w[1].1 { [w[0].0, w[1].0] } else { [w[1].0, w[0].0] };
            let _ = (0..48).try_for_each(|_| {
                let middle = 0.5 * (out + inside);
                match lies(middle) {
                    Some(true) => inside = middle,
                    Some(false) => out = middle,
                    None => return ControlFlow::Break(()),
                }
                ControlFlow::Continue(())
            });
            [out, inside]
        });
        narrowed.collect()
    }
}

#[test]
fn however_short_contact_beside_a_support_is_its_forces_are_there() {
    let mut random = Random::new(31);
    let (mut solved, mut open, mut borders, mut wrong) = (0, Vec::new(), 0, Vec::new());
    for i in 0..200 {
        let Some(family) = Family::random(&mut random) else { continue };
        let mut shares: Vec<f64> = (0..=12).map(|k| f64::from(k) / 12.0).collect();
        for [out, inside] in family.borders() {
            borders += 1;
            let beside = (1..12).map(|k| libm::exp2(-2.0 * f64::from(k)) * (inside - out).signum());
            shares.extend(beside.flat_map(|step| [inside + step, out - step]));
        }
        for share in shares.into_iter().filter(|share| (0.0..=1.0).contains(share)) {
            let Some(scene) = family.scene(share) else { continue };
            let Ok(exact) = solve(&scene) else { continue };
            if !exact.solved {
                open.push((i, share, exact.violations));
                continue;
            }
            solved += 1;
            wrong.extend(hidden(&scene, &exact).map(|(force, at)| format!("{i}, {share}: {force:.1e} at {at}")));
        }
    }
    assert!(wrong.is_empty(), "{} of {solved}: {:#?}", wrong.len(), &wrong[..wrong.len().min(20)]);
    assert!(open.is_empty(), "{} of {solved} are not solved: {:#?}", open.len(), &open[..open.len().min(20)]);
    assert!(1500 < solved && 20 < borders, "{solved} {borders}");
}

/// Loads on an overhang above level ground that balance each other and leave neither moment nor slope at the support: `v''` grows from
/// zero at first. The ground is pressed beside the support, by forces that do not depend on how far apart the loads are, and the
/// depth that they have without it is as the third power of that.
#[test]
fn the_shear_force_decides_where_slope_and_moment_vanish() {
    const AT: f64 = 5.0;
    let forces = |apart: f64| {
        let supports = [Support::simple(0.0).at_level(-1.0), Support::simple(AT)];
        // `v''` rises to the first, falls through zero to the second, and rises to zero at the last.
        let [a, b, c] = [(1.0, -2.0), (3.0, 5.0 / 3.0), (4.5, -2.0 / 3.0)].map(|(k, force)| (AT + k * apart, force));
        let ground = Some(Foundation::Flat { depth: 0.0 });
        let scene = on_supports([10.0, 20.0], &supports, (0.0, &[a, b, c, (2.0, 1.0)]), ground);
        let exact = solve(&scene).expect("an answer");
        assert!(exact.solved, "{apart}: {:?}", exact.violations);
        let [contact] = exact.state.contacts[..] else { panic!("{apart}: {:?}", exact.state.contacts) };
        [(contact.from - AT) / apart, contact.force, exact.state.supports[1].force]
    };
    let expected = forces(0.1);
    for apart in [1e-2, 1e-3, 1e-4, 1e-5] {
        for (found, expected) in forces(apart).into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-9, "{apart}: {found}, not {expected}");
        }
    }
}

/// The zone beside the support is shorter than a thousandth of the beam, and its length depends on the level of the other support; what
/// the support carries does not.
#[test]
fn the_force_of_a_support_does_not_depend_on_how_short_the_zone_beside_it_is() {
    let beam = Beam::new(10.0, 20.0).expect("a beam");
    let waves = Foundation::Cosine { mean: 0.0, amplitude: 0.05, wavelength: 10.0, phase: 0.0 };
    let beam = beam.with_shape(waves).expect("a shape");
    let load = Load::new(&beam, 0.0, Vec::new(), vec![PointLoad { at: 5.0, force: 3.0 }]).expect("a load");
    for level in (0..100).map(|k| -0.915 - 1e-5 * f64::from(k)) {
        let supports = vec![Support::simple(2.0).at_level(level), Support::simple(8.0)];
        let beam = beam.clone().with_supports(supports).expect("apart");
        let scene = Scene::new(beam, load.clone(), Some(Foundation::Flat { depth: 0.0 })).expect("a scene");
        let exact = solve(&scene).expect("an answer");
        assert!(exact.solved && exact.state.contacts.len() == 2, "{level}: {:?}", exact.state);
        let force = exact.state.supports[1].force;
        assert!((force - 0.235_909_771_9).abs() < 1e-9, "{level}: {force}");
    }
}

/// Loads right beside both ends of a span: `EI v(l/2) = 5 q l⁴/384 + Σ P c (3l² − 4c²)/48` with the distances `c` from the nearer end.
/// Beyond the larger one, what is left of its shear force is a difference of nearly equal numbers.
#[test]
fn a_load_beside_each_end_leaves_the_deflection_its_digits() {
    let (length, stiffness) = (10.0, 0.01);
    for forces in [[-5.0, -1e12], [-1e12, -5.0]] {
        let beam = Beam::new(length, stiffness).expect("a beam");
        let places = [1e-9, length - 1e-9];
        let point: Vec<PointLoad> = places.into_iter().zip(forces).map(|(at, force)| PointLoad { at, force }).collect();
        let of_load = |load: &PointLoad| {
            let c = load.at.min(length - load.at);
            load.force * c * (3.0 * length * length - 4.0 * c * c) / 48.0
        };
        let bent = 5.0 * length.powi(4) / 384.0 + point.iter().map(of_load).sum::<f64>();
        let load = Load::new(&beam, 1.0, Vec::new(), point).expect("a load");
        let exact = solve(&Scene::new(beam, load, None).expect("a scene")).expect("an answer");
        for x in [5.0_f64.next_down(), 5.0, 5.0_f64.next_up()] {
            let off = exact.deflection(x) * stiffness / bent - 1.0;
            assert!(off.abs() < 1e-9, "{forces:?} at {x}: {off:e}");
        }
    }
}
