//! Supports that give: springs against sinking and turning, and elastic stops. Scenes are files, as a user writes them.

use palkki::scene::Scene;
use palkki::scene::file::{ReadProblem, parse};

fn read(text: &str) -> Result<Scene, String> {
    parse("scene.toml", text, |_| Err(ReadProblem::Missing)).map_err(|error| error.to_string())
}

/// What a support that gives may not be, with words of the message.
#[test]
fn what_is_no_spring_is_refused() {
    for (supports, joints, words) in [
        ("{ at = 0.0, built_in = true, stiffness = 2.0 }, { at = 10.0 }", "", &["built_in", "turning_stiffness"][..]),
        (
            "{ at = 0.0, built_in = true, turning_stiffness = 2.0 }, { at = 10.0 }",
            "",
            &["turning_stiffness", "built_in"],
        ),
        ("{ at = 0.0, stiffness = 0.0 }, { at = 10.0 }", "", &["supports[0].stiffness", "positive"]),
        ("{ at = 10.0 }, { at = 0.0, stiffness = -1.0 }", "", &["supports[1].stiffness", "positive"]),
        ("{ at = 0.0, turning_stiffness = 0.0 }, { at = 10.0 }", "", &["supports[0].turning_stiffness", "positive"]),
        ("{ at = 0.0, stiffness = nan }, { at = 10.0 }", "", &["nan"]),
        ("{ at = 0.0, stiffness = 'soft' }, { at = 10.0 }", "", &["supports[0].stiffness", "number"]),
        ("{ at = 0.0, stiffness = 2.0, slope = 0.1 }, { at = 10.0 }", "", &["slope", "turning_stiffness"]),
        (
            "{ at = 0.0 }, { at = 5.0, turning_stiffness = 2.0, pushes_only = true }, { at = 10.0 }",
            "",
            &["turning_stiffness"],
        ),
        ("{ at = 0.0 }, { at = 4.0, turning_stiffness = 2.0 }", "joints = [{ at = 4.0 }]\n", &["joints[0].at"]),
        ("{ at = 4.0, stiffness = 2.0 }", "", &["turn", "4"]),
        ("{ at = 4.0, stiffness = 2.0, pushes_only = true }", "", &["turns over"]),
        ("{ at = 5.0, stiffness = 2.0 }", "", &["5", "rest"]),
        ("{ at = 0.0, stiffness = 1e300 }, { at = 10.0 }", "joints = [{ at = 4.0 }]\n", &["mechanism"]),
    ] {
        let load = "[load]\nuniform = 1.0\n";
        let text = format!("[beam]\nlength = 10.0\nbending_stiffness = 1.3\n{joints}supports = [{supports}]\n{load}");
        let Err(message) = read(&text) else { panic!("{text}") };
        for word in words {
            assert!(message.to_lowercase().contains(word), "{word} is not in {message}");
        }
    }
}

/// What hold a beam together do so alone: two springs, a spring that is a turning spring as well, a support and a turning spring.
#[test]
fn springs_hold_a_beam() {
    for supports in [
        "{ at = 1.0, stiffness = 2.0 }, { at = 7.0, stiffness = 2.0 }",
        "{ at = 1.0, stiffness = 2.0 }, { at = 7.0 }",
        "{ at = 1.0, stiffness = 2.0, turning_stiffness = 3.0 }",
        "{ at = 1.0, turning_stiffness = 3.0, slope = 0.1 }",
    ] {
        let text =
            format!("[beam]\nlength = 10.0\nbending_stiffness = 1.3\nsupports = [{supports}]\n[load]\nuniform = 1.0\n");
        assert!(read(&text).expect("a scene").beam().is_held(), "{supports}");
    }
}
