//! What must not matter: units, the side one looks from, and which of several descriptions of one beam a scene has.

use palkki::certificate::{ContactLoad, Judged, Lumped, certify};
use palkki::route::{Method, Solver, Status};
use palkki::scene::{Foundation, Scene, Support};
use palkki::state::ContactState;
use palkki::theory::{Exact, solve};
use palkki::verdict::{Demand, Verdict};
use palkki::{Settings, Witness, solve_raw};
use palkki_evidence::compare::{apart, largest};
use palkki_evidence::draft::{Draft, Units};
use palkki_evidence::random;

/// Scenes of all kinds, on two supports and on any.
fn drafts(count: u64) -> impl Iterator<Item = Draft> {
    let scenes =
        (0..count).flat_map(|i| [random::scene(i), random::on_lattice(i), random::held(i), random::coinciding(i)]);
    scenes.map(|scene| Draft::from(&scene))
}

/// Our own solvers; the libraries are only given dimensionless numbers, but nobody promises their bits.
const BY_HAND: [Solver; 3] = [Solver::FourStep, Solver::ActiveSet, Solver::Nsor];
/// Of the grids here; a multiple of it has a node at each support of the closed forms.
const INTERVALS: usize = 20;

/// Numbers of a state in units: places, depths, forces, moments, energy.
fn numbers(state: &ContactState, Units { length, depth, force }: Units) -> [Vec<f64>; 5] {
    let nodes = state.nodes.clone().unwrap_or_default();
    let over = |values: &[f64], unit: f64| values.iter().map(|v| v / unit).collect::<Vec<_>>();
    let ends: Vec<f64> = state.contacts.iter().flat_map(|c| [c.from, c.to]).collect();
    let supports: Vec<f64> = state.supports.iter().map(|s| s.force).collect();
    let couples: Vec<f64> = state.supports.iter().filter_map(|s| s.moment).collect();
    [
        over(&[&nodes.x[..], &ends].concat(), length),
        over(&nodes.deflection, depth),
        over(&[&nodes.contact_force[..], &supports, &[state.contact_force()]].concat(), force),
        over(&[&nodes.moment[..], &couples].concat(), force * length),
        vec![state.energy / (force * depth)],
    ]
}

/// Everything that is computed of a scene, as bits in units: states, and what is certified of answers, of forces and of nodes.
fn bits(scene: &Scene, units: Units) -> Vec<Vec<u64>> {
    let in_bits =
        |state: &ContactState| numbers(state, units).concat().into_iter().map(f64::to_bits).collect::<Vec<_>>();
    let mut all = Vec::new();
    let Ok(exact) = solve(scene) else { return all };
    all.push(in_bits(&exact.state));
    let witness = Witness::of(scene);
    for (method, solver) in Method::ALL.into_iter().flat_map(|method| BY_HAND.map(|solver| (method, solver))) {
        // Of NSOR the same bits are asked and not many digits.
        let tolerance = if solver == Solver::Nsor { 1e-4 } else { 1e-10 };
        let settings = Settings { tolerance, ..Settings::new(method, solver, INTERVALS) };
        let Ok(raw) = solve_raw(scene, &settings) else { continue };
        all.push(in_bits(&raw.state));
        let verdict = Verdict::of_raw(&raw, &witness, &Demand::default());
        all.push(vec![u64::from(verdict.status == Status::Certified), verdict.error.to_bits()]);
        if (method, solver) != (Method::Force, Solver::ActiveSet) {
            continue;
        }
        let nodes = raw.state.nodes.expect("a grid");
        let forces: Vec<(f64, f64)> = nodes.x.iter().copied().zip(nodes.contact_force.iter().copied()).collect();
        // A free beam that presses at one place alone is not held by its forces.
        let lumped = Lumped::new(scene, forces.iter().copied()).ok();
        let deflection = lumped.map(|lumped| lumped.nodes.deflection).unwrap_or_default();
        all.push(deflection.iter().map(|v| (v / units.depth).to_bits()).collect());
        let load = ContactLoad::new(scene.beam().length(), forces).expect("finite forces on the beam");
        let said = certify(scene, Judged::Forces(&load), &exact.state.contacts).expect("in range");
        let deflections = [said.deflection_error, said.best_deflection_error, said.deflection].map(|v| v / units.depth);
        let energies = [said.energy_lower, said.energy_upper, said.gap].map(|e| e / (units.force * units.depth));
        all.push(deflections.into_iter().chain(energies).map(f64::to_bits).collect());
    }
    all
}

#[test]
fn units_that_are_powers_of_two_change_no_bit() {
    let of = |length: f64, depth: f64, force: f64| Units { length, depth, force };
    let all = [of(1024.0, 1.0, 1.0), of(1.0, 0.125, 1.0), of(1.0, 1.0, 65536.0), of(0.0625, 512.0, 0.5)];
    let mut compared = 0;
    for (k, draft) in drafts(12).enumerate() {
        let Ok(scene) = draft.scene() else { continue };
        let expected = bits(&scene, Units::SAME);
        compared += usize::from(10 < expected.len());
        for units in [all[k % 4], all[(k + 1) % 4]] {
            let found = bits(&draft.in_units(units).scene().expect("the same scene"), units);
            assert!(found == expected, "{units:?}: other bits\n{}", draft.text());
        }
    }
    assert!(20 < compared, "{compared} scenes");
}

/// A share of a deflection does not depend on units, at the ends of the range of numbers either, and the largest of all shares does not to
/// nine digits.
#[test]
fn no_unit_makes_an_answer_certain() {
    let two_to = |power: i32| 2.0_f64.powi(power);
    let narrow = vec![[0.0, 22.0], [3.1, 22.0], [3.15, 3.0], [3.2, 22.0], [10.0, 22.0]];
    let ground = Some(Foundation::Polyline { points: narrow });
    let found = Draft { length: 10.0, stiffness: 1.0, uniform: 1.0, ground, ..Draft::default() };
    let mut refused = 0;
    for draft in std::iter::once(found).chain(drafts(8)) {
        let of = |units: Units| {
            let scene = draft.in_units(units).scene().ok()?;
            let raw = solve_raw(&scene, &Settings::new(Method::Force, Solver::ActiveSet, INTERVALS)).ok()?;
            let verdict = Verdict::of_raw(&raw, &Witness::of(&scene), &Demand::default());
            Some((verdict.status, verdict.error.to_bits(), format!("{:.9e}", verdict.largest_error())))
        };
        let Some(expected) = of(Units::SAME) else { continue };
        refused += usize::from(expected.0 != Status::Certified);
        // Depths and forces of 1e-150 and 1e+150, alone and together, and lengths of 1e-30 and 1e+30.
        for [length, depth, force] in
            [[0, -490, -490], [0, -490, 0], [0, 0, -490], [0, 490, 490], [0, -300, 300], [-100, 0, 0], [100, 0, 0]]
        {
            let units = Units { length: two_to(length), depth: two_to(depth), force: two_to(force) };
            if let Some(verdict) = of(units) {
                assert_eq!(verdict, expected, "{units:?}: {}", draft.text());
            }
        }
    }
    assert!(0 < refused, "none is uncertain");
}

/// Two ways through the same numbers differ by rounding; close contacts magnify it.
const DIGITS: f64 = 1e-9;

/// By beam theory and by all methods, the states of some drafts that are one beam; none where a grid has no node on a support.
fn answers(drafts: [&Draft; 2]) -> Vec<(String, [ContactState; 2])> {
    let scenes = drafts.map(|draft| draft.scene().unwrap_or_else(|error| panic!("{error}\n{}", draft.text())));
    let certified = |scene: &Scene| solve(scene).ok().filter(|exact: &Exact| exact.solved).map(|exact| exact.state);
    let mut found = Vec::new();
    if let [Some(a), Some(b)] = scenes.each_ref().map(certified) {
        found.push(("theory".to_owned(), [a, b]));
    }
    for method in Method::ALL {
        let of = |scene: &Scene| solve_raw(scene, &Settings::new(method, Solver::ActiveSet, 2 * INTERVALS)).ok();
        if let [Some(a), Some(b)] = scenes.each_ref().map(of) {
            assert!(a.solved && b.solved, "{method}:\n{}", drafts[0].text());
            found.push((method.to_string(), [a.state, b.state]));
        }
    }
    found
}

/// Lists that are the same but for rounding, as shares of the larger of a size and the largest.
#[track_caller]
fn same(what: &str, a: &[f64], b: &[f64], size: f64) {
    let off = apart(a, b);
    assert!(off <= DIGITS * size.max(largest(a.iter().copied())), "{what}: off by {off:e}: {a:?}, {b:?}");
}

fn forces(state: &ContactState) -> Vec<f64> {
    let nodal = state.nodes.iter().flat_map(|nodes| nodes.contact_force.iter().copied());
    nodal.chain(state.supports.iter().map(|s| s.force)).chain([state.contact_force()]).collect()
}

#[test]
fn seen_from_the_other_side_it_is_the_same() {
    let mut compared = 0;
    for draft in drafts(40) {
        let [Ok(scene), Ok(_)] = [draft.scene(), draft.mirrored().scene()] else { continue };
        // Of ground level with a support rounding decides on which side it is.
        if scene.held().iter().any(|held| held.tangent != [false; 2]) {
            continue;
        }
        let load = draft.load().expect("a load").magnitude(draft.length);
        for (who, [a, b]) in answers([&draft, &draft.mirrored()]) {
            let what = format!("{who}:\n{}", draft.text());
            let turned = |mut list: Vec<f64>| {
                list.reverse();
                list
            };
            let supports = |state: &ContactState| state.supports.iter().map(|s| s.force).collect::<Vec<_>>();
            let couples = |state: &ContactState| state.supports.iter().filter_map(|s| s.moment).collect::<Vec<_>>();
            same(&what, &supports(&a), &turned(supports(&b)), load);
            same(&what, &couples(&a), &turned(couples(&b)), load * draft.length);
            same(&what, &[a.energy], &[b.energy], load * a.deflection.magnitude());
            same(&what, &[a.contact_force()], &[b.contact_force()], load);
            if let (Some(a), Some(b)) = (a.nodes, b.nodes) {
                same(&what, &a.contact_force, &turned(b.contact_force), load);
                same(&what, &a.deflection, &turned(b.deflection), 0.0);
                same(&what, &a.moment, &turned(b.moment), load * draft.length);
            }
            compared += 1;
        }
    }
    assert!(200 < compared, "{compared} answers");
}

/// A beam of length 10 under a uniform load.
fn beam(supports: Vec<Support>, ground: Option<Foundation>) -> Draft {
    let supports = Some(supports);
    Draft { length: 10.0, stiffness: 3.0, uniform: 1.0, supports, ground, ..Draft::default() }
}

/// A support that presses may be replaced by a spike of the ground.
#[test]
fn a_pressing_support_is_a_spike_of_the_ground() {
    let ends = [Support::simple(0.0), Support::simple(10.0)];
    let held = beam(vec![ends[0], Support::simple(4.0).at_level(0.3), ends[1]], Some(Foundation::Flat { depth: 1.0 }));
    for width in [1e-2, 1e-6] {
        let points = vec![[0.0, 1.0], [4.0 - width, 1.0], [4.0, 0.3], [4.0 + width, 1.0], [10.0, 1.0]];
        let spiked = beam(ends.to_vec(), Some(Foundation::Polyline { points }));
        let found = answers([&held, &spiked]);
        assert_eq!(found.len(), 4, "theory and three methods");
        for (who, [a, b]) in found {
            let spike = b.contacts.iter().find(|c| c.from <= 4.0 && 4.0 <= c.to).expect("it touches");
            same(&who, &[a.supports[1].force, a.supports[0].force], &[spike.force, b.supports[0].force], 10.0);
            same(&who, &[a.contact_force() + a.supports[1].force, a.energy], &[b.contact_force(), b.energy], 10.0);
        }
    }
}

/// A free body feels nothing of ground that is raised and tilted as a whole.
#[test]
fn a_free_body_feels_no_plane() {
    let mut random = random::Random::new(11);
    for _ in 0..20 {
        let c = [random.between(-0.1, 0.1), random.between(-0.01, 0.01), random.between(-2e-4, 2e-4)];
        let ground = |a: f64, b: f64| Foundation::Polynomial { coefficients: vec![a, b, c[0], c[1], c[2]] };
        let body = |a: f64, b: f64| beam(Vec::new(), Some(ground(a, b))).with_points(&[(6.0, 1.0)]);
        for (who, [a, b]) in answers([&body(0.0, 0.0), &body(3.0, 0.2)]) {
            same(&who, &forces(&a), &forces(&b), 10.0);
        }
    }
}

/// A hump under a straight beam is level ground under a curled one, and what is certified of either holds for both.
#[test]
fn only_the_gap_counts() {
    let own = |sign: f64, from: f64| {
        let coefficients = [0.4, -0.3, 0.02, 0.003].map(|c| sign * c).to_vec();
        let raised = coefficients.iter().enumerate().map(|(j, c)| if j == 0 { from + c } else { *c });
        Foundation::Polynomial { coefficients: raised.collect() }
    };
    for supports in [vec![], vec![Support::built_in(0.0)], vec![Support::simple(2.0)]] {
        let straight = beam(supports.clone(), Some(own(1.0, 2.0)));
        // The supports of the curled beam hold what those of the straight one do.
        let lowered = supports.iter().map(|s| {
            let [level, slope] = own(-1.0, 0.0).sides(s.at)[1];
            Support { level: s.level + level, slope: s.slope.map(|held| held + slope), ..*s }
        });
        let shape = Some(own(-1.0, 0.0));
        let curled = Draft { shape, ..beam(lowered.collect(), Some(Foundation::Flat { depth: 2.0 })) };
        let found = answers([&straight, &curled]);
        assert_eq!(found.len(), 4, "theory and three methods");
        for (who, [a, b]) in found {
            same(&who, &forces(&a), &forces(&b), 10.0);
            same(&who, &[a.energy], &[b.energy], 10.0);
            let said = [&straight, &curled].map(|draft| {
                certify(&draft.scene().expect("well posed"), Judged::Witness, &a.contacts).expect("in range")
            });
            same(&who, &[said[0].deflection], &[said[1].deflection], 0.0);
            assert!(
                said[0].energy_lower <= said[1].energy_upper && said[1].energy_lower <= said[0].energy_upper,
                "{who}"
            );
        }
    }
}
