//! What text says of numbers: which is computed and which is proven, where a beam turns over, how many digits a message has.

use super::{EXAMPLE, Folder, RIDGE};

/// Every table with a bracket has the two headings, and no other for it.
#[test]
fn brackets_are_of_the_true_value() {
    let folder = Folder::new("headings");
    super::body::known(&folder);
    folder.write("forces.csv", "x,force\n2.5,3\n7.5,3\n");
    folder.write("answer.csv", "i,clearance\n1,0\n");
    folder.write("held.toml", EXAMPLE.replace("[load]", "supports = [{ at = 0, built_in = true }]\n[load]"));
    for (arguments, tables) in [
        ("solve example.toml", 2),
        ("solve ridge.toml", 2),
        ("solve held.toml", 2),
        ("solve ridge.toml --method force", 2),
        ("solve ridge.toml --method displacement --intervals 7", 2),
        ("solve ridge.toml --method complementarity --tolerance 1e-2", 2),
        ("certify example.toml forces.csv", 0),
        ("certify body.toml answer.csv", 0),
        ("solve body.toml", 0),
    ] {
        let text = folder.run(arguments).out;
        for old in ["at least", "at most  ", "  value  "] {
            assert!(
                !text.lines().any(|line| line.contains(old) && line.starts_with("   ")),
                "{arguments}: {old}: {text}"
            );
        }
        let headings: Vec<&str> = text.lines().filter(|line| line.contains("true value between")).collect();
        assert!(!headings.is_empty(), "{arguments}: {text}");
        let computed = headings.iter().filter(|line| line.contains("computed")).count();
        assert_eq!(computed, tables, "{arguments}: {headings:?}");
        assert!(
            headings
                .iter()
                .all(|line| line.split("true value between").nth(1).is_some_and(|rest| rest.contains("and")))
        );
    }
    let tolerance = folder.run("solve example.toml --depth-tolerance 0.01").out;
    assert!(tolerance.contains("true value between"), "{tolerance}");
}

/// Without ground a beam turns over a support, which may lie inside: the message names the place.
#[test]
fn a_beam_turns_over_the_outermost_support() {
    let folder = Folder::new("overturned");
    for [left, right] in [[0, 10], [2, 7], [0, 6], [3, 10], [5, 5]] {
        for (at, over) in [(left - 1, left), (right + 1, right), (0, left), (10, right)] {
            if !(0..=10).contains(&at) || (left..=right).contains(&at) {
                continue;
            }
            let mut supports = vec![format!("{{ at = {left}, pushes_only = true }}")];
            supports.extend((left < right).then(|| format!("{{ at = {right}, pushes_only = true }}")));
            let beam = format!("[beam]\nlength = 10\nbending_stiffness = 1\nsupports = [{}]\n", supports.join(", "));
            folder.write("scene.toml", beam + &format!("[load]\npoint = [{{ at = {at}, force = 1 }}]\n"));
            let message = folder.refused("solve scene.toml");
            assert!(message.contains(&format!("the beam turns over its support at x = {over}")), "{message}");
            assert_eq!(message.contains("the only support that pushes"), left == right, "{message}");
            assert!(!message.contains("end"), "{message}");
        }
    }
}

/// A beam with one support has no left and no right one.
#[test]
fn the_only_support_is_not_called_left_or_right() {
    let folder = Folder::new("only_support");
    for (supports, alone) in [
        ("{ at = 0, built_in = true }", true),
        ("{ at = 10, built_in = true }", true),
        ("{ at = 5, built_in = true }", true),
        ("{ at = 10 }", true),
        ("{ at = 0 }, { at = 10 }", false),
    ] {
        folder.write("scene.toml", EXAMPLE.replace("[load]", &format!("supports = [{supports}]\n[load]")));
        let text = folder.run("solve scene.toml").out;
        assert!(text.contains("Equilibrium"), "{text}");
        assert_eq!(!text.contains("left support") && !text.contains("right support"), alone, "{text}");
    }
}

/// Where the answers of a sweep end is computed: six digits say it.
#[test]
fn computed_numbers_of_messages_have_six_digits() {
    let folder = Folder::new("digits");
    let mut told = 0;
    for numerator in 1..=12 {
        let depth = f64::from(numerator) / 3.0;
        folder.write("scene.toml", RIDGE.replace("[4, 0.5]", &format!("[4, {depth}]")));
        let level = "supports = [{ at = 0 }, { at = 4 }, { at = 10 }]\n[load]";
        folder.write("scene.toml", folder.read("scene.toml").replace("[load]", level));
        let sweep = "sweep scene.toml --vary beam.supports[1].level --from -1 --to 5 --steps 10 --format json";
        let run = folder.run(sweep);
        let Some((_, rest)) = run.out.split_once("none from ") else { continue };
        let number = rest.split(' ').next().expect("a number");
        let digits = number.chars().filter(char::is_ascii_digit).collect::<String>();
        assert!(digits.trim_start_matches('0').len() <= 6, "{number}");
        told += 1;
    }
    assert!(3 < told, "{told}");
}
