//! A depth that is no depth is named in the output; the grounds of the report have none.

use serde_json::Value;

use super::Folder;
use crate::scenes;

/// Grounds of many roughnesses, and how far off a mark for missing data is put into them.
#[test]
fn a_depth_far_from_all_others_is_named() {
    let folder = Folder::new("far_depths");
    let grounds: [fn(u32) -> f64; 6] = [
        |_| 1.0,
        |i| 1.0 + 0.1 * f64::from(i % 3),
        |i| 85.0 + 0.01 * f64::from(i * i % 7),
        |i| if i == 5 { 3.0 } else { 1.0 },
        |i| if i < 4 { 0.5 } else { 2.0 },
        |i| f64::from(1_u32 << (i % 11)),
    ];
    for (k, ground) in grounds.into_iter().enumerate() {
        for marks in [&[][..], &[4], &[2, 7], &[0, 1, 9]] {
            for mark in [9999.0, 999_999.0] {
                let depth = |i: u32| if marks.contains(&i) { mark * if k == 5 { 1e3 } else { 1.0 } } else { ground(i) };
                let points: Vec<String> = (0..=10).map(|i| format!("[{i}, {}]", depth(i))).collect();
                let beam = "[beam]\nlength = 10\nbending_stiffness = 1\n[load]\nuniform = 1\n";
                let scene = format!("{beam}[foundation]\npoints = [{}]\n", points.join(", "));
                folder.write("scene.toml", scene);
                let (_, _, json) = folder.json("solve scene.toml");
                let warnings = json.get("warnings").and_then(|list| list.as_array()).cloned().unwrap_or_default();
                // A beam that reaches so far down deflects by much besides.
                let is_of_depths = |warning: &Value| !warning.as_str().unwrap_or_default().contains("small slopes");
                let warnings: Vec<Value> = warnings.into_iter().filter(is_of_depths).collect();
                let (text, explained) = (folder.run("solve scene.toml").out, folder.run("explain scene.toml").out);
                let markdown = folder.run("explain scene.toml --format markdown").out;
                let Some(first) = marks.first() else {
                    assert!(warnings.is_empty() && !text.contains("far from all other depths"), "{k}: {warnings:?}");
                    continue;
                };
                let [warning] = &warnings[..] else { panic!("{k} {marks:?} {mark}: {warnings:?}") };
                let warning = warning.as_str().expect("a text");
                assert!(warning.contains(&format!("at x = {first}")), "{warning}");
                assert!(marks.len() == 1 || warning.starts_with(&format!("{} depths", marks.len())), "{warning}");
                for text in [text, explained, markdown.replace('\\', "")] {
                    assert!(text.contains(&format!("Warning: {warning}.")), "{text}");
                }
            }
        }
    }
}

#[test]
fn no_ground_of_the_report_has_a_depth_far_from_all_others() {
    for (name, scene) in scenes::report() {
        assert_eq!(scene.far_depths(), [], "{name}");
    }
}

/// On the old reader this message did not say in which direction depth counts.
#[test]
fn a_wrong_header_is_told_that_depth_counts_downwards() {
    let folder = Folder::new("wrong_headers");
    folder.write("surveyed.toml", super::SURVEYED);
    for header in ["x,level", "Chainage,Level", "x,z", "station,elevation", "x,height", "0,1", "depth,x"] {
        folder.write("levels.csv", format!("{header}\n0,1\n10,1\n"));
        let message = folder.refused("solve surveyed.toml");
        assert!(message.contains("depth counts downwards"), "{message}");
    }
}

/// A simple beam of length 10 deflects by `5 q l⁴/(384 EI)`: 1 is a tenth of its length, 1.02 is more.
#[test]
fn a_deflection_beyond_linear_theory_is_named() {
    let folder = Folder::new("large");
    for (deflection, is_large) in [(1.0, false), (1.02, true)] {
        let load = deflection * 384.0 / 5e4;
        folder.write("scene.toml", format!("[beam]\nlength = 10\nbending_stiffness = 1\n[load]\nuniform = {load}\n"));
        let half = format!("--vary load.uniform --from {} --to {load} --steps 2", 0.5 * load);
        for command in ["solve", "solve --method force", &format!("sweep {half}")] {
            let (name, rest) = command.split_once(' ').unwrap_or((command, ""));
            let command = format!("{name} scene.toml {rest}");
            let text = folder.run(&command).out;
            let said = text.lines().filter(|line| line.starts_with("Warning: the deflection varies by")).count();
            assert_eq!(said, usize::from(is_large), "{command}: {text}");
            let (_, _, json) = folder.json(&command);
            assert_eq!(json.get("warnings").is_some(), is_large, "{command}");
        }
    }
}

/// Depths and loads of the other convention are named where they are valid, and whoever means them gets no warning.
#[test]
fn a_sign_of_the_other_convention_is_named() {
    let folder = Folder::new("signs");
    let [up, down] = ["every load is negative", "every depth of `foundation` is negative"];
    for (beam, load, foundation, expected) in [
        ("", "uniform = -1e-3", "depth = 1", Some(up)),
        ("", "point = [{ at = 5, force = -1e-3 }]", "depth = 1", Some(up)),
        ("", "linear = [{ from = 0, to = 5, start = 0, end = -1e-3 }]", "depth = 1", Some(up)),
        ("", "uniform = -1e-3", "", None),
        ("", "uniform = -1e-3\npoint = [{ at = 5, force = 1e-3 }]", "depth = 1", None),
        ("", "couple = [{ at = 5, moment = -1e-3 }]", "depth = 1", None),
        ("supports = []", "uniform = 1e-3", "depth = -1", Some(down)),
        ("supports = []", "uniform = 1e-3", "points = [[0, -2], [5, -1], [10, -2]]", Some(down)),
        ("supports = []", "uniform = 1e-3", "cosine = { mean = -2, amplitude = 0.1, wavelength = 20 }", Some(down)),
        ("supports = []", "uniform = 1e-3", "points = [[0, -2], [5, 0], [10, -2]]", None),
        ("supports = [{ at = 0, level = -1.1 }]", "uniform = 1e-3", "depth = -1", None),
        ("supports = []\nshape = { polynomial = [-2] }", "uniform = 1e-3", "depth = -1", None),
    ] {
        let foundation = if foundation.is_empty() { String::new() } else { format!("[foundation]\n{foundation}\n") };
        let scene = format!("[beam]\nlength = 10\nbending_stiffness = 1000\n{beam}\n[load]\n{load}\n{foundation}");
        folder.write("scene.toml", &scene);
        let (_, _, json) = folder.json("solve scene.toml");
        let warnings: Vec<&str> = json
            .get("warnings")
            .and_then(|list| list.as_array())
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
            .collect();
        match (expected, &warnings[..]) {
            (None, []) => {}
            (Some(expected), [warning]) => assert!(warning.starts_with(expected), "{warning}\n{scene}"),
            _ => panic!("{warnings:?}\n{scene}"),
        }
    }
    for (beam, load, foundation, expected) in [
        ("", "uniform = 1", "depth = -1", "depths are positive downwards"),
        ("supports = []", "uniform = -1", "depth = 1", "loads are positive downwards"),
    ] {
        let scene =
            format!("[beam]\nlength = 10\nbending_stiffness = 1\n{beam}\n[load]\n{load}\n[foundation]\n{foundation}\n");
        folder.write("scene.toml", scene);
        let message = folder.refused("solve scene.toml");
        assert!(message.contains(&format!("help: {expected}")), "{message}");
    }
}

#[test]
fn no_scene_of_the_report_has_a_sign_of_the_other_convention() {
    for (name, scene) in scenes::report() {
        assert_eq!(scene.doubtful_signs(), [], "{name}");
    }
}
