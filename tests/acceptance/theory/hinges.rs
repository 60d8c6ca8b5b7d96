//! Beams with a hinge beside an end at which statics alone says what is there: elimination must not begin on that side.

use palkki::scene::file::{Problem, ReadProblem, parse};
use palkki::scene::{Scene, SceneError, Unheld};
use palkki::theory::{self, Exact};
use palkki::verdict::Status;

fn solved(beam: &str, ground: &str) -> Exact {
    let text = format!("[beam]\nlength = 10.0\n{beam}\n[load]\nuniform = 1.0\n{ground}");
    let scene: Scene = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).expect("a scene");
    let exact = theory::solve(&scene).expect("an answer");
    assert!(exact.solved, "{text}");
    exact
}

#[track_caller]
fn check(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-11 * expected.abs(), "{found} instead of {expected}");
}

/// A hinge at 1 hangs from the end at 0 and from the beam over 4 and 10: it presses on that with `q/2`. By hand.
#[test]
fn a_hinge_beside_an_end_on_a_support_hangs_from_the_beam_beyond() {
    let beam = "bending_stiffness = 100.0\njoints = [{ at = 1.0 }]\nsupports = [{ at = 0 }, { at = 4 }, { at = 10 }]";
    let exact = solved(beam, "");
    check(exact.deflection(1.0), 0.236_25);
    check(exact.state.energy, -4.0 / 15.0);
    check(exact.state.reactions.left, 0.5);
    // The middle support 0.3 deeper turns the left part about it: `0.3 − …` at the hinge by the slope of the beam over 4 and 10.
    let sunk = solved(&beam.replace("{ at = 4 }", "{ at = 4, level = 0.3 }"), "");
    check(sunk.deflection(1.0), 0.236_25 + 0.3 + 3.0 * 0.3 / 6.0);
    check(sunk.state.energy, -4.0 / 15.0 - 0.3 * sunk.state.supports[1].force);
    check(sunk.state.supports[1].force, 7.5);
}

/// Two hinges between a wall and a support: the link between them hangs from both.
#[test]
fn a_link_between_two_hinges_hangs_from_both_sides() {
    let beam = "bending_stiffness = 100.0\njoints = [{ at = 1.0 }, { at = 2.5 }]\nsupports = [{ at = 0, built_in = true }, { at = 4 }, { at = 10 }]";
    let exact = solved(beam, "");
    // Half of the link's load on the cantilever: `v = q x⁴/8 + P x³/3` over EI.
    check(exact.deflection(1.0), (1.0 / 8.0 + 0.75 / 3.0) / 100.0);
    check(exact.state.reactions.left, 1.75);
}

/// A hinge on flat ground of depth `d`: the right part, as if on two supports, lifts off where its load turns it level,
/// `q L³/24 EI = d/L`, and lies from the hinge up to there.
#[test]
fn a_beam_lies_on_the_ground_beside_a_hinge() {
    let exact = solved("bending_stiffness = 10.0\njoints = [{ at = 3.0 }]", "[foundation]\ndepth = 10");
    let free = (24.0 * 10.0 * 10.0_f64).sqrt().sqrt();
    let [contact] = exact.state.contacts[..] else { panic!("{:?}", exact.state.contacts) };
    assert!(contact.from.total_cmp(&3.0).is_eq(), "{}", contact.from);
    check(contact.to, 10.0 - free);
    check(exact.state.reactions.left, 1.5);
    check(exact.state.reactions.right, 0.5 * free);
    // Deeper it touches in the hinge alone.
    let deep = solved("bending_stiffness = 10.0\njoints = [{ at = 3.0 }]", "[foundation]\ndepth = 1000");
    let [point] = deep.state.contacts[..] else { panic!("{:?}", deep.state.contacts) };
    assert_eq!([point.from, point.to].map(f64::to_bits), [3.0_f64; 2].map(f64::to_bits));
    check(point.force, 5.0);
}

/// A kink of the beam in a joint is no kink of the ground: what is known of the clearance before the joint is not known of its slope
/// beyond.
#[test]
fn a_beam_with_a_joint_above_ground_is_certified() {
    for at in (1..20).map(|i| 0.5 * f64::from(i)) {
        for stiffness in [1.0, 10.0, 1000.0] {
            let text = format!(
                "[beam]\nlength = 10.0\nbending_stiffness = 100.0\njoints = [{{ at = {at:?}, stiffness = {stiffness:?} }}]\n\
                 [load]\nuniform = 1.0\n[foundation]\ndepth = 1.0\n"
            );
            let scene: Scene = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).expect("a scene");
            let solution = palkki::solve_exactly(&scene).expect("an answer");
            assert_eq!(solution.verdict.status, Status::Certified, "{text}");
        }
    }
}

/// The left part is a beam on two supports, and the right one lies on the ground from the hinge to its free end: the beam is level behind
/// the hinge, and not before it.
#[test]
fn a_zone_from_a_hinge_to_a_free_end_is_certified() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 10.0\njoints = [{ at = 6.0 }]\nsupports = [{ at = 0 }]\n\
        [load]\nuniform = 1.0\ncouple = [{ at = 3.0, moment = -0.6 }]\n[foundation]\ndepth = 10.0\n";
    let scene: Scene = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a scene");
    let solution = palkki::solve_exactly(&scene).expect("an answer");
    assert_eq!(solution.verdict.status, Status::Certified, "{}", solution.verdict);
    let [contact] = solution.state.contacts[..] else { panic!("{:?}", solution.state.contacts) };
    assert_eq!([contact.from, contact.to].map(f64::to_bits), [6.0_f64, 10.0].map(f64::to_bits));
    // The couple turns the left part: 0.6/6 more on the support, and less in the hinge.
    check(solution.state.reactions.left, 3.1);
    check(contact.force, 6.9);
}

/// Behind a hinge the beam lies on a support that only pushes at its end, far above the ground there: no zone goes up to it.
#[test]
fn ground_below_a_support_that_only_pushes_at_an_end_holds_nothing_there() {
    let text = "[beam]\nlength = 10.0\nbending_stiffness = 6.116\njoints = [{ at = 8.7 }, { at = 1.897 }]\n\
        supports = [{ at = 2.85, level = 0.075, built_in = true }, { at = 10.0, level = 0.06, pushes_only = true }]\n\
        [load]\nuniform = 1.766\npoint = [{ at = 8.51, force = -0.98 }]\n[foundation]\ndepth = 1.442\n";
    let scene: Scene = parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a scene");
    let exact = theory::solve(&scene).expect("an answer");
    assert!(exact.solved);
    check(exact.state.supports[1].force, 1.766 * 1.3 / 2.0);
}

/// What happens to a beam of length 10 under its weight 1 and a load, if nothing balances them.
fn unheld(beam: &str, load: &str, ground: &str) -> Option<Unheld> {
    let text =
        format!("[beam]\nlength = 10.0\nbending_stiffness = 1.0\n{beam}\n[load]\nuniform = 1.0\n{load}\n{ground}");
    match parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).map_err(|error| error.problem) {
        Ok(_) => None,
        Err(Problem::Scene { error: SceneError::Unheld(why), .. }) => Some(why),
        Err(other) => panic!("{other}\n{text}"),
    }
}

/// A part beyond a hinge that its loads turn up, and one that sinks into a gap: a scene without an answer says which, about what and by how much.
#[test]
fn a_part_beyond_a_hinge_has_to_rest() {
    let level = "[foundation]\ndepth = 1.0";
    let at_end = "joints = [{ at = 8.0 }]\nsupports = [{ at = 0 }, { at = 6 }]";
    // The weight of two lengths turns down by 2, and a force at the end up by twice as much as it is.
    for (force, moment) in [(-0.9, None), (-1.5, Some(1.0)), (-1.001, Some(0.002))] {
        let found = unheld(at_end, &format!("point = [{{ at = 10.0, force = {force} }}]"), level);
        assert_eq!(found.is_some(), moment.is_some(), "{force}: {found:?}");
        let Some(moment) = moment else { continue };
        let Some(Unheld::Turned { hinge, moment: found, right: true, up: true }) = found else { panic!("{found:?}") };
        check(hinge, 8.0);
        assert!((found - moment).abs() <= 1e-12, "{found}");
        let said = Unheld::Turned { hinge, moment: found, right: true, up: true }.to_string();
        assert!(said.contains("to the right of its hinge at x = 8 up about it"), "{said}");
    }
    let mirrored = unheld(
        "joints = [{ at = 2.0 }]\nsupports = [{ at = 4 }, { at = 10 }]",
        "couple = [{ at = 1.0, moment = 7.0 }]",
        level,
    );
    assert!(matches!(mirrored, Some(Unheld::Turned { right: false, up: true, .. })), "{mirrored:?}");
    // Something that holds it down, or against turning, is enough; what only pushes is not, and neither is a stiff joint needed.
    let held = "joints = [{ at = 8.0 }]\nsupports = [{ at = 0 }, { at = 6 }, { at = 9 }]";
    let up = "point = [{ at = 10.0, force = -1.5 }]";
    assert_eq!(unheld(held, up, level), None);
    assert!(unheld(&held.replace("at = 9", "at = 9, pushes_only = true, level = 0.5"), up, level).is_some());
    assert_eq!(unheld(&held.replace("at = 9", "at = 9, stiffness = 0.1"), up, level), None);
    assert_eq!(unheld(&at_end.replace("at = 8.0", "at = 8.0, stiffness = 1e-3"), up, level), None);
    assert_eq!(unheld(&format!("tension = 1.0\n{at_end}"), up, level), None);
    // Without foundation below it the part falls.
    let hole = "[foundation]\ndepth = 1.0\nstiffness = { steps = [[0, 10.0], [8.0, 0.0]] }";
    let found = unheld(at_end, "", hole);
    assert!(matches!(found, Some(Unheld::Turned { right: true, up: false, .. })), "{found:?}");
    assert_eq!(unheld(at_end, "", &hole.replace("8.0, 0.0", "9.5, 0.0")), None);
}

/// A load belongs to one part alone, one at an end of the beam or in a hinge too: pressed down everywhere a beam rests.
#[test]
fn a_load_acts_on_one_part() {
    let level = "[foundation]\ndepth = 1.0";
    for at in [0.0, 3.0, 6.5, 10.0] {
        for supports in ["[]", "[{ at = 0 }, { at = 10 }]"] {
            let beam = format!("joints = [{{ at = 3.0 }}, {{ at = 6.5 }}]\nsupports = {supports}");
            assert_eq!(
                unheld(&beam, &format!("point = [{{ at = {at:?}, force = 5.0 }}]"), level),
                None,
                "{at}, {beam}"
            );
        }
    }
}

/// A link that is pulled up between two hinges takes its neighbours along, as far as these are not heavy enough.
#[test]
fn parts_between_hinges_have_to_rest() {
    let beam = "joints = [{ at = 3.0 }, { at = 7.0 }]\nsupports = []";
    let level = "[foundation]\ndepth = 1.0";
    // With the ends down the neighbours turn about these: their weight of 3 at half of what the link rises by.
    for (force, moves) in [(-6.9, false), (-7.1, true)] {
        let found = unheld(beam, &format!("point = [{{ at = 5.0, force = {force} }}]"), level);
        let is_moved = matches!(found, Some(Unheld::Moved { up: true, from, to }) if from <= 0.0 && 7.0 <= to);
        assert_eq!(is_moved, moves, "{force}: {found:?}");
        assert_eq!(found.is_some(), moves, "{force}: {found:?}");
    }
    // One hinge up, the other one down: 2 of the link and 1.5 beyond against 0.75 of the load.
    for (force, moves) in [(-4.6, false), (-4.7, true)] {
        let found = unheld(beam, &format!("point = [{{ at = 4.0, force = {force} }}]"), level);
        assert_eq!(found.is_some(), moves, "{force}: {found:?}");
        let said = found.map_or_else(String::new, |why| why.to_string());
        assert!(!moves || said.contains("between x = 0 and x = 7 up"), "{said}");
    }
}
