//! What a user sees: the whole output of each command on small scenes, one page for each.
//!
//! A page says how often a command looks different from before; whether its numbers are right is asked elsewhere.

use std::fs;

use super::steady::{in_short, steady};
use super::{EXAMPLE, Folder, Run, SURVEYED};
use crate::scenes;
use crate::support::{assert_table, assert_text};

/// Beam, supports, own shape and ground, in this order; all others are left out.
const SCENES: [(&str, &str); 7] = [
    (
        "cantilever",
        "supports = [{ at = 4, level = 0.3 }, { at = 0, built_in = true, slope = 0.02 }]\nshape = { polynomial = [0.0, 0.01] }\n[foundation]\ndepth = 1\n",
    ),
    ("lying", "supports = []\n[foundation]\npoints = [[0, 1], [3, 0.6], [10, 1.4]]\n"),
    ("balanced", "supports = [{ at = 5 }]\n"),
    (
        "three",
        "supports = [{ at = 1, built_in = true }, { at = 4 }, { at = 6, level = 0.1 }]\n[foundation]\ndepth = 9\n",
    ),
    ("one", "supports = [{ at = 0, built_in = true }]\n"),
    ("high", "[foundation]\ndepth = 90\n"),
    ("wave", "[foundation]\ncosine = { mean = 1, amplitude = 0.3, wavelength = 5 }\n"),
];

/// The scenes above under a uniform load, those that all tests have, and contact forces.
fn folder(test: &str) -> Folder {
    let folder = Folder::new(test);
    for (name, text) in SCENES {
        let beam = "[load]\nuniform = 1\n[beam]\nlength = 10\nbending_stiffness = 1.3\n";
        folder.write(&format!("{name}.toml"), [beam, text].concat());
    }
    folder.write("forces.csv", "x,force\n2.5,1\n5,-0.25\n7.5,1\n");
    folder.write("nodal.csv", "x,force\n2.5,2.333333333333\n5,2.666666666667\n7.5,2.333333333333\n");
    folder
}

/// Commands with what they print, without what changes, and their exit codes.
fn page(folder: &Folder, commands: &[&str]) -> String {
    page_of(folder, commands, |text| if text.starts_with('{') { in_short(&steady(text)) } else { steady(text) })
}

fn page_of(folder: &Folder, commands: &[&str], text: impl Fn(&str) -> String) -> String {
    let shown = |command: &&str| {
        let Run { code, out, err } = folder.run(command);
        assert!(err.is_empty() || out.is_empty(), "{command}: both streams: {err}");
        let stream = if err.is_empty() { "" } else { ", on standard error" };
        let code = code.expect("an exit code");
        format!("$ palkki {command}\n{}{}[exit code {code}{stream}]\n\n", text(&out), err)
    };
    commands.iter().map(shown).collect()
}

#[test]
fn solve_is_shown() {
    let exact = ["solve ridge.toml --derivatives --depth-tolerance 0.01", "solve wave.toml --digits 3"];
    assert_table!("shown@solve", "Beam theory", page(&folder("shown_solve"), &exact));
}

/// The first can be checked by hand: contact at all three nodes, `p_1 = q − 2 EI u / Δ⁴`, `p_2 = q + 2 EI u / Δ⁴`.
#[test]
fn grids_are_shown() {
    let grids = [
        "solve example.toml --method complementarity --intervals 4 --nodes",
        "solve example.toml -m force",
        "solve ridge.toml -m force -n 8 --nodes",
        "solve ridge.toml -m displacement -s four-step",
        "solve high.toml -m force -n 2",
        "solve lying.toml -m force -s nsor",
        "solve lying.toml -m force -n 4 --nodes",
    ];
    assert_table!("shown@grid", "Methods on grids", page(&folder("shown_grids"), &grids));
}

#[test]
fn refinement_is_shown() {
    let asked = [
        "solve example.toml -m force -t 1e-3",
        "solve ridge.toml -m force -s four-step -t 1e-3",
        "solve ridge.toml -t 1e-9",
        "solve ridge.toml -t 1e-16",
    ];
    assert_table!("shown@tolerance", "An error that is asked for", page(&folder("shown_tolerance"), &asked));
}

#[test]
fn supports_are_shown() {
    let held = ["solve cantilever.toml -m force -n 20", "solve balanced.toml", "solve lying.toml"];
    assert_table!("shown@supports", "Beams on other supports", page(&folder("shown_supports"), &held));
}

#[test]
fn comparisons_are_shown() {
    let scenes = ["compare ridge.toml -n 12", "compare lying.toml -n 20"];
    assert_table!("shown@compare", "All methods with all solvers", page(&folder("shown_compare"), &scenes));
}

#[test]
fn certificates_are_shown() {
    let forces = [
        "certify example.toml forces.csv",
        "certify example.toml nodal.csv",
        "certify example.toml nodal.csv --load nodal",
        "certify example.toml forces.csv --format json",
    ];
    assert_table!("shown@certify", "Contact forces that somebody computed", page(&folder("shown_certify"), &forces));
}

#[test]
fn sweeps_are_shown() {
    let varied = [
        "sweep ridge.toml --vary load.uniform --from 0.5 --to 2 -n 4",
        "sweep three.toml --vary load.uniform --from 1 --to 2 -n 2",
        "sweep one.toml --vary load.uniform --from 1 --to 2 -n 2",
        "sweep three.toml --vary beam.supports[0].at,beam.supports[1].at --from 0 --to 0.5 -n 3 --envelope",
        "sweep example.toml --vary foundation.depth --from 1 --to 150 -n 3 --format json",
    ];
    assert_table!("shown@sweep", "One number varied", page(&folder("shown_sweep"), &varied));
}

#[test]
fn what_is_found_is_shown() {
    let asked = [
        "find example.toml --vary foundation.depth --from 1 --to 150 --until contact",
        "find example.toml --vary load.uniform --from 0.001 --to 1 --until deflection(5)=1",
        "find example.toml --vary load.uniform --from 0.001 --to 1 --until deflection(5)=2",
        "find one.toml --vary load.uniform --from 1 --to 2 --until support[0]=15 --format json",
    ];
    assert_table!("shown@find", "Inverse questions", page(&folder("shown_find"), &asked));
}

#[test]
fn explanations_are_shown() {
    let explained = ["explain example.toml", "explain three.toml", "explain cantilever.toml --format markdown"];
    assert_table!("shown@explain", "Equations with their numbers", page(&folder("shown_explain"), &explained));
}

/// The page *Teaching* takes them from here.
#[test]
fn taught_explanations_are_shown() {
    let folder = folder("shown_taught");
    folder.write("spans.toml", scenes::text("taught/spans"));
    folder.write("hump.toml", scenes::text("hump"));
    let explained = ["explain spans.toml", "explain hump.toml"];
    assert_table!("shown@taught", "Equations of the exercises", page(&folder, &explained));
}

#[test]
fn bodies_are_shown() {
    let folder = folder("shown_body");
    super::body::known(&folder);
    folder.write("answer.csv", "i,clearance\n1,1\n2,1.25\n3,1\n");
    let commands = ["solve body.toml --nodes", "certify body.toml answer.csv", "solve body.toml -f json"];
    assert_table!("shown@body", "A body that a matrix gives", page(&folder, &commands));
}

#[test]
fn json_is_shown() {
    let scenes = [
        "solve ridge.toml -f json",
        "solve example.toml -f json --derivatives --depth-tolerance 0.1",
        "solve example.toml -f json -m force -n 4",
        "solve example.toml -f json -m force -t 1e-2",
        "solve cantilever.toml -f json -m force -n 5",
        "solve lying.toml -f json -m force -n 4",
        "solve balanced.toml -f json",
    ];
    assert_table!("shown@json", "Answers for programs", page(&folder("shown_json"), &scenes));
}

#[test]
fn help_is_shown() {
    let help = [
        "",
        "--version",
        "-h",
        "--help",
        "solve -h",
        "solve --help",
        "compare --help",
        "certify --help",
        "sweep --help",
        "find --help",
        "export --help",
        "completions --help",
        "manual --help",
    ];
    assert_text!("shown@help", "Help", page_of(&folder("shown_help"), &help, str::to_owned));
}

/// Whatever is refused: exit code 2, nothing on standard output, nothing written.
#[test]
fn refusals_are_shown() {
    let folder = folder("shown_refused");
    folder.write("surveyed.toml", SURVEYED);
    folder.write("levels.csv", "x,depth\n0,1\n10,1\n");
    folder.write("bad.toml", EXAMPLE.replace("length = 10", "length = -10"));
    folder.write("binary.toml", b"[beam]\nlength = \xff\xfe\n");
    folder.write("empty.toml", "");
    folder.write("word.csv", "x,force\n1,2\n3,much\n");
    folder.write("nan.csv", "x,force\n1,2\n3,NaN\n");
    folder.write("infinite.csv", "x,force\n1,1e999\n");
    folder.write("header.csv", "x,force\n");
    folder.write("gaps.csv", "x,force\n2.5,1\n5,1\n");
    folder.write("beside.csv", "x,force\n1,2\n30,1\n");
    // A survey is looked for beside its scene; the last is what an old spreadsheet writes.
    fs::create_dir(folder.path("site")).expect("a directory");
    for (name, last) in [("none", None), ("word", Some(b"10,one")), ("latin", Some(b"10,5\xb2\n"))] {
        folder.write(&format!("site/{name}.toml"), SURVEYED.replace("levels", name));
        if let Some(last) = last {
            folder.write(&format!("site/{name}.csv"), [b"x,depth\n0,1\n", &last[..]].concat());
        }
    }
    fs::create_dir(folder.path("directory.csv")).expect("a directory");
    // A hole: it takes no room on the disk.
    let large = fs::File::create(folder.path("large.toml")).expect("a file for the test");
    large.set_len(16 * 1024 * 1024 + 1).expect("a large file");
    let shown = REFUSED.iter().map(|command| format!("$ palkki {command}\n{}\n\n", folder.refused(command)));
    assert_text!("shown@refused", "What is refused", shown.collect::<String>());
}

const REFUSED: &[&str] = &[
    "frobnicate",
    "solve",
    "solve example.toml --frobnicate",
    "solve example.toml -m farce",
    "solve example.toml -m force -s simplex",
    "solve example.toml -f xml",
    "solve example.toml --digits 0",
    "solve example.toml --digits 18",
    "solve example.toml -m force -n 0",
    "solve example.toml -m force -n 1",
    "solve example.toml -m force -n -5",
    "solve example.toml -m force -n 2.5",
    "solve example.toml -m force -n many",
    "solve example.toml -m force -n 10000001",
    "solve example.toml -m force -n 99999999999999999999",
    "solve example.toml -m force -n 3000001 --nodes",
    "solve example.toml -m force -n 3000001 --csv nodes.csv",
    "solve example.toml -m force -t 0",
    "solve example.toml -m force -t -1e-9",
    "solve example.toml -m force -t nan",
    "solve example.toml -m force -t inf",
    "solve example.toml -s nsor",
    "solve example.toml -m exact -s nsor",
    "solve example.toml -m exact -n 30",
    "solve example.toml --nodes",
    "solve example.toml -m force --derivatives",
    "solve example.toml -m force --depth-tolerance 1",
    "solve example.toml --depth-tolerance -1",
    "solve cantilever.toml -m force -n 7",
    "compare cantilever.toml -n 12",
    "compare example.toml -n 1",
    "solve missing.toml",
    "compare missing.toml -f json",
    "solve directory.csv",
    "solve binary.toml",
    "solve empty.toml",
    "solve large.toml",
    "solve example.toml/scene.toml",
    "solve bad.toml --csv nodes.csv",
    "solve site/none.toml",
    "solve site/word.toml",
    "solve site/latin.toml",
    "solve example.toml --csv nowhere/nodes.csv",
    "solve example.toml --csv directory.csv",
    "solve example.toml --csv example.toml",
    "solve example.toml --csv example.toml/nodes.csv",
    "solve example.toml --csv ..",
    "solve example.toml --csv both --plot both",
    "solve surveyed.toml --csv levels.csv",
    "certify example.toml",
    "certify example.toml missing.csv",
    "certify missing.toml forces.csv",
    "certify example.toml word.csv",
    "certify example.toml nan.csv",
    "certify example.toml infinite.csv",
    "certify example.toml empty.toml",
    "certify example.toml beside.csv",
    "certify example.toml .",
    "certify example.toml gaps.csv --load nodal",
    "certify example.toml gaps.csv --load nodal -f json",
    "certify example.toml header.csv --load nodal",
    "certify example.toml gaps.csv --load lumped",
    "certify example.toml beside.csv --load nodal",
    "sweep example.toml --vary load.point[0].at --from 0 --to 1 --csv a.csv",
    "sweep example.toml --vary foundation.dept --from 0 --to 1",
    "sweep example.toml --vary depth --from 0 --to 1",
    "sweep example.toml --vary foundation.depth --from -2 --to -1 -n 5 --csv a.csv",
    "sweep example.toml --vary foundation.depth --from 1 --to 2 -n 1",
    "sweep example.toml --vary foundation.depth --from 1 --to 2 -n 0",
    "sweep example.toml --vary foundation.depth --from 1 --to 2 -n -3",
    "sweep example.toml --vary foundation.depth --from 1 --to 2 -n 1000002",
    "sweep example.toml --vary foundation.depth --from 1 --to 2 -n many",
    "sweep example.toml --vary foundation.depth --from nan --to 1",
    "sweep example.toml --vary foundation.depth --from 1 --to inf",
    "sweep example.toml --vary foundation.depth --from 1 --to 1",
    "sweep example.toml --vary foundation.depth --from x --to 1",
    "sweep example.toml --vary beam.length --from 1 --to 2",
    "sweep example.toml --vary foundation.depth --from 1 --to 2 --at 5,11",
    "find example.toml --vary foundation.depth --from 1 --to 2",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until contact=1",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until contact(5)",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until sag(5)=1",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until deflection(5)=much",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until deflection(5)=inf",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until deflection(11)=1",
    "find example.toml --vary foundation.depth --from 1 --to 2 --until support[2]=1",
    "find example.toml --vary foundation.depth --from -2 --to -1 --until contact",
    "find one.toml --vary load.uniform --from 1 --to 2 --until contact",
    "find one.toml --vary load.uniform --from 1 --to 2 --until clearance(5)=1",
    "completions frobsh",
    "manual frobnicate",
];

/// Every command and every option is in the completions of each shell, and in its man page.
#[test]
fn shells_and_manual_know_every_option() {
    let folder = Folder::new("shown_pages");
    let shells =
        ["bash", "zsh", "fish", "powershell", "elvish"].map(|shell| folder.run(&format!("completions {shell}")));
    let commands = ["solve", "compare", "certify", "sweep", "find", "explain"];
    let manual = folder.run("manual");
    assert_eq!((manual.code, manual.err.as_str()), (Some(0), ""));
    for command in commands {
        let help = folder.run(&format!("{command} --help")).out;
        let page = folder.run(&format!("manual {command}")).out;
        assert!(
            page.contains(&format!(".TH palkki-{command} 1")) && manual.out.contains(&format!("palkki\\-{command}"))
        );
        let options = help.split_whitespace().filter_map(|word| word.strip_prefix("--"));
        for option in options.map(|word| word.trim_end_matches(|c: char| !c.is_ascii_lowercase())) {
            assert!(page.contains(&format!("\\-\\-{}", option.replace('-', "\\-"))), "--{option} in {page}");
            for shell in &shells {
                assert_eq!((shell.code, shell.err.as_str()), (Some(0), ""));
                assert!(shell.out.contains(option) && shell.out.contains(command), "--{option} of {command}");
            }
        }
    }
}
