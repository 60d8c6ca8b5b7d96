//! The general beam: couples. Scenes are files, as a user writes them; numbers of 16 digits come from a 40-digit computation by an
//! engine that shares no code with this one, checked there by finite elements.

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};
use palkki::state::ContactState;
use palkki::verdict::Status;

/// What is asked for beside numbers of 16 digits.
const DIGITS: f64 = 1e-11;

fn scene(text: &str) -> Scene {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The exact answer, which has to be certified.
#[track_caller]
fn certified(text: &str) -> ContactState {
    let solution = palkki::solve_exactly(&scene(text)).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{text}");
    solution.state
}

#[track_caller]
fn check(what: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= DIGITS * expected.abs(), "{what}: {found} instead of {expected}, off by {error:e}");
}

/// `v = −C x (l² − 3 b² − x²)/6 EI l` to the left of a couple at `a = l − b` on two supports: reactions `∓C/l`, and of the beam built in
/// at its left end `v = C x²/2 EI` up to the couple.
#[test]
fn a_couple_on_a_beam_without_ground() {
    for at in [0.0, 1.0, 2.5, 3.0] {
        let couple = format!("[load]\ncouple = [{{ at = {at:?}, moment = 5.0 }}]\n");
        let simple = certified(&format!("[beam]\nlength = 3.0\nbending_stiffness = 2.0\n{couple}"));
        check("force at the left end", simple.reactions.left, -5.0 / 3.0);
        check("force at the right end", simple.reactions.right, 5.0 / 3.0);
        let (a, b) = (at, 3.0 - at);
        check("largest moment", simple.moment.max - simple.moment.min, 5.0);
        // Its work is half of C times the slope there, C (a³ + b³)/3 EI l² on two supports.
        check("energy", simple.energy, -0.5 * 25.0 * (a * a * a + b * b * b) / (3.0 * 2.0 * 9.0));
        if a > 0.0 {
            let wall = "supports = [{ at = 0.0, built_in = true }]\n";
            let held = certified(&format!("[beam]\nlength = 3.0\nbending_stiffness = 2.0\n{wall}{couple}"));
            check("deflection of the tip", held.deflection.max, 5.0 * a * (0.5 * a + b) / 2.0);
            check("moment at the wall", held.supports[0].moment.expect("built in"), -5.0);
        }
    }
}

/// A couple `C` in flat contact under a load `q` lifts the beam over `ℓ = √(2√3 C/q)`, of which `(3 + √3)/6` is on the side towards which
/// it does not turn; the ends of the gap press with these shares of `q ℓ`, the longer side with the lesser one.
#[test]
fn a_couple_opens_a_gap_in_contact() {
    let root = 3.0_f64.sqrt();
    for moment in [1e-9, 1e-4, 0.2, 1.0, -0.3_f64] {
        let load = format!("[load]\nuniform = 1.0\ncouple = [{{ at = 5.0, moment = {moment:?} }}]\n");
        let text = format!("[beam]\nlength = 10.0\nbending_stiffness = 1.3\n{load}[foundation]\ndepth = 1.0\n");
        let state = certified(&text);
        let [left, right] = [&state.contacts[0], &state.contacts[1]];
        let length = (2.0 * root * moment.abs()).sqrt();
        let [long, short] = [(3.0 + root) / 6.0, (3.0 - root) / 6.0];
        let [before, behind] = if moment > 0.0 { [long, short] } else { [short, long] };
        // Places have the digits of the beam.
        for (what, found, expected) in
            [("left part", 5.0 - left.to, before * length), ("right part", right.from - 5.0, behind * length)]
        {
            assert!((found - expected).abs() < 1e-14 * 10.0, "{what}: {found}, not {expected}");
        }
        let [from, to] = [left.end_forces.expect("a zone")[1], right.end_forces.expect("a zone")[0]];
        for (what, found, expected) in [("left force", from, behind * length), ("right force", to, before * length)] {
            assert!((found - expected).abs() < 1e-13 * 10.0, "{what}: {found}, not {expected}");
        }
    }
}

/// Numbers of 16 digits from another engine.
#[test]
fn a_couple_inside_contact() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 1.3020833333333333\n\n[load]\nuniform = 1.0\n\
                couple = [{ at = 5.0, moment = 0.2 }]\n\n[foundation]\ndepth = 1.0\n";
    let state = certified(text);
    for (what, found, expected) in [
        ("reaction", state.reactions.left, 1.182_177_011_253_969_8),
        ("to", state.contacts[0].to, 4.343_539_713_557_742_5),
        ("from", state.contacts[1].from, 5.175_898_003_615_306),
        ("force", state.contacts[0].force, 3.337_260_705_919_079_3),
        ("force", state.contacts[1].force, 4.298_385_271_572_982),
        ("moment", state.moment.max, 0.698_771_242_968_684_3),
        ("moment", state.moment.min, -0.1),
        ("energy", state.energy, -8.109_085_005_252_995),
    ] {
        check(what, found, expected);
    }
}

/// Wherever a couple acts and however large it is, on symmetric grounds and beams: certified, and mirrored the same.
#[test]
fn couples_anywhere_are_certified_and_may_be_mirrored() {
    let grounds = [
        "",
        "[foundation]\ndepth = 0.4\n",
        "[foundation]\npolynomial = [1.1, -0.08, 0.008]\n",
        "[foundation]\npolynomial = [0.6, 0.16, -0.016]\n",
        "[foundation]\npoints = [[0, 0.7], [4, 0.7], [5, 0.4], [6, 0.7], [10, 0.7]]\n",
        "[foundation]\ncosine = { mean = 0.6, amplitude = 0.2, wavelength = 5.0 }\n",
        "[foundation]\ndepth = 0.1\nstiffness = 20.0\n",
    ];
    let held = ["", "supports = []\n", "supports = [{ at = 2.0 }, { at = 8.0 }]\n"];
    for (ground, supports) in grounds.iter().flat_map(|ground| held.map(|supports| (ground, supports))) {
        if ground.is_empty() && supports.contains("[]") {
            continue;
        }
        for (at, moment) in [0.0, 0.5, 2.0, 4.0, 4.7, 5.0].into_iter().flat_map(|at| [1e-3, -0.1, 0.5].map(|c| (at, c)))
        {
            let of = |at: f64, moment: f64| {
                let load = format!("[load]\nuniform = 1.0\ncouple = [{{ at = {at:?}, moment = {moment:?} }}]\n");
                certified(&format!("[beam]\nlength = 10.0\nbending_stiffness = 4.0\n{supports}{load}{ground}"))
            };
            let (one, other) = (of(at, moment), of(10.0 - at, -moment));
            let same = |what: &str, a: f64, b: f64| {
                assert!(
                    (a - b).abs() < 1e-10 * (1.0 + a.abs()),
                    "{what}: {a} and {b}, couple {moment} at {at} on {ground}"
                );
            };
            same("energy", one.energy, other.energy);
            same("moment", one.moment.max, other.moment.max);
            same("moment", one.moment.min, other.moment.min);
            assert_eq!(one.contacts.len(), other.contacts.len());
        }
    }
}

/// Two opposite forces close to each other are a couple, the closer the more so.
#[test]
fn a_couple_is_two_opposite_forces() {
    let of = |load: &str| {
        let text = format!(
            "[beam]\nlength = 10.0\nbending_stiffness = 4.0\n[load]\nuniform = 1.0\n{load}[foundation]\npolynomial = [1.1, -0.08, 0.008]\n"
        );
        palkki::theory::solve(&scene(&text)).expect("an answer").state.energy
    };
    let couple = of("couple = [{ at = 3.0, moment = 0.7 }]\n");
    let mut last = f64::INFINITY;
    for distance in [1e-2, 1e-3, 1e-4] {
        let (force, half) = (0.7 / distance, 0.5 * distance);
        let (before, behind) = (3.0 - half, 3.0 + half);
        let pair = format!(
            "point = [{{ at = {before:?}, force = {:?} }}, {{ at = {behind:?}, force = {force:?} }}]\n",
            -force
        );
        let off = (of(&pair) - couple).abs();
        assert!(off < 0.2 * last && off < 10.0 * distance, "{off:e} at a distance of {distance}");
        last = off;
    }
}

/// On finer grids the methods come nearer to the exact energy, with the first order of what a couple does in itself.
#[test]
fn couples_on_grids() {
    use palkki::methods::Method;
    use palkki::solvers::Solver;
    use palkki::{Settings, solve};
    let scene = scene(
        "[beam]\nlength = 10.0\nbending_stiffness = 4.0\n[load]\nuniform = 1.0\ncouple = [{ at = 2.2, moment = 0.7 }, { at = 10.0, moment = -0.4 }]\n\
         [foundation]\npolynomial = [1.1, -0.08, 0.008]\n",
    );
    let exact = palkki::theory::solve(&scene).expect("an answer").state.energy;
    for method in Method::ALL {
        let off = |intervals: usize| {
            let solution = solve(&scene, &Settings::new(method, Solver::ActiveSet, intervals)).expect("an answer");
            (solution.state.energy - exact).abs()
        };
        let [coarse, fine] = [off(20), off(320)];
        assert!(fine < 0.1 * coarse && fine < 2e-3 * exact.abs(), "{method:?}: {coarse:e} and {fine:e} of {exact}");
    }
}
