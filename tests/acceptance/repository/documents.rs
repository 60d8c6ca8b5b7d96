//! What the documents say about the code is so.

use std::process::Command;

use palkki::scene::file::ReadProblem;
use palkki::verdict::Status;
use palkki_evidence::numdiff::numdiff;
use palkki_evidence::random::{draws_all, rare_sample_of, sample_of};

use super::text::{files, root, rust_files, words};

/// The text of a document at the root.
fn document(name: &str) -> String {
    files(name, "").remove(name).unwrap_or_else(|| panic!("{name} is missing"))
}

/// What stands between single backticks, outside of fenced blocks.
fn code_spans(markdown: &str) -> Vec<&str> {
    let prose = markdown.split("```").step_by(2);
    prose.flat_map(|text| text.split('`').skip(1).step_by(2)).collect()
}

#[test]
fn the_map_is_the_territory() {
    let map = document("ARCHITECTURE.md");
    let spans = code_spans(&map);

    let tops = ["src/", "tests/", "xtask/", "report/"];
    let paths: Vec<_> = spans.iter().filter(|span| tops.iter().any(|top| span.starts_with(top))).collect();
    assert!(!paths.is_empty(), "the map names places");
    for path in paths {
        assert!(root().join(path).exists(), "ARCHITECTURE.md names {path}, which does not exist");
    }

    for path in rust_files("src").keys().chain(rust_files("tests").keys()) {
        // `src/scene/beam.rs` is in the part `src/scene`, `src/lib.rs` is a part of its own.
        let part: Vec<&str> = path.split('/').take(2).collect();
        let part = part.join("/");
        assert!(spans.contains(&part.as_str()), "ARCHITECTURE.md does not name {part}");
    }

    let tests = rust_files("tests/acceptance").into_values().collect::<String>();
    let named: Vec<_> = map
        .lines()
        .filter(|line| line.starts_with("| "))
        .filter_map(|line| line.trim_end_matches([' ', '|']).rsplit_once(" | "))
        .flat_map(|(_, last)| code_spans(last))
        .filter(|span| span.matches('_').count() >= 3 && words(span).count() == 1)
        .collect();
    assert!(named.len() > 10, "the table of invariants names tests: {named:?}");
    for name in named {
        assert!(tests.contains(&format!("fn {name}()")), "ARCHITECTURE.md names the test {name}, which does not exist");
    }
}

/// The lines of `excerpt` that are not found, in order, among those of `printed`; `…` stands for any lines.
fn not_printed<'a>(excerpt: &'a str, printed: &str) -> Vec<&'a str> {
    let mut rest = printed.lines();
    let shown = excerpt.lines().filter(|line| *line != "…");
    shown.filter(|line| !rest.by_ref().any(|other| numdiff(line, other).is_ok())).collect()
}

#[test]
fn the_readme_shows_what_is_printed() {
    let readme = document("README.md");
    let blocks = readme.split("```console\n").skip(1).filter_map(|rest| rest.split_once("```"));
    let mut shown = 0;
    for (block, _) in blocks {
        let Some((command, excerpt)) = block.split_once('\n') else { continue };
        let Some(arguments) = command.strip_prefix("$ palkki ") else { continue };
        let output = Command::new(env!("CARGO_BIN_EXE_palkki"))
            .args(arguments.split_whitespace())
            .current_dir(root())
            .output()
            .unwrap_or_else(|e| panic!("palkki does not start: {e}"));
        let printed = String::from_utf8_lossy(&output.stdout);
        let missing = not_printed(excerpt, &printed);
        assert!(missing.is_empty(), "`{command}` does not print, in this order: {missing:#?}\n{printed}");
        shown += 1;
    }
    assert!(0 < shown, "the README shows the command line");
}

/// `cargo test` draws a quarter, or a sixteenth, as the documents say; `.ci/run` draws all.
#[test]
fn the_documents_say_how_much_is_drawn() {
    assert_eq!([sample_of(400), rare_sample_of(400)], if draws_all() { [400; 2] } else { [100, 25] });
    for name in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] {
        let said = ["quarter", "sixteenth", "PALKKI_DRAW=all"];
        assert!(said.iter().all(|said| document(name).contains(said)), "{name}");
    }
    assert!(document(".ci/run").contains("\nexport PALKKI_DRAW=all\n"), ".ci/run");
}

/// The scene of the README, as its lines are, or with those of one of its comments that are keys.
fn scene_of_the_readme() -> String {
    let readme = document("README.md");
    readme.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap_or_default().to_owned()
}

/// The answer of a scene file, which is certified.
fn certified(text: &str) {
    let survey = |_: &str| Ok("x,depth\n0,1.0\n4,0.5\n10,1.0\n".to_owned());
    let scene = palkki::scene::file::parse("README.md", text, survey).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let solution = palkki::solve_exactly(&scene).unwrap_or_else(|e| panic!("{e}\n{text}"));
    assert_eq!(solution.verdict.status, Status::Certified, "{}\n{text}", solution.verdict);
}

/// As it stands, and with each line that is a comment, alone and all together.
#[test]
fn the_scene_of_the_readme_is_one() {
    let scene = scene_of_the_readme();
    let optional: Vec<&str> = scene.lines().filter(|line| line.starts_with("# ")).collect();
    assert_eq!(optional.len(), 3, "{optional:?}");
    let with = |lines: &[&str]| lines.iter().fold(scene.clone(), |text, line| text.replace(line, &line[2..]));
    certified(&scene);
    optional.iter().for_each(|line| certified(&with(&[line])));
    certified(&with(&optional));
}

/// What the README says is covered, with the lines of a scene that has it; a line that begins with `-` takes one away.
const COVERED: [(&str, &str); 22] = [
    ("uniform", "load.uniform = 0.7"),
    ("linear", "load.linear = [{ from = 1.0, to = 6.0, start = 0.5, end = 2.0 }]"),
    ("point loads", "load.point = [{ at = 3.0, force = 2.0 }]"),
    ("couples", "load.couple = [{ at = 3.0, moment = 0.5 }]"),
    ("a bending stiffness in steps", "beam.bending_stiffness = { steps = [[0, 1.3], [4, 2.6]] }"),
    ("elastic joints", "beam.joints = [{ at = 4.0, stiffness = 2.0 }]"),
    ("hinges", "beam.joints = [{ at = 4.0 }]\nbeam.supports = [{ at = 0.0, built_in = true }, { at = 10.0 }]"),
    ("an initial shape", "beam.shape = { polynomial = [0.0, 0.1, -0.01] }"),
    ("an axial force", "beam.tension = 2.0"),
    ("elastic bearings", "beam.supports = [{ at = 0.0 }, { at = 10.0, stiffness = 5.0 }]"),
    (
        "elastic stops",
        "beam.supports = [{ at = 0.0 }, { at = 5.0, stiffness = 5.0, pushes_only = true }, { at = 10.0 }]",
    ),
    ("flat", "foundation.depth = 1.0"),
    ("a polyline", "foundation.points = [[0, 1.0], [4, 0.5], [10, 1.0]]"),
    ("a survey", "foundation.survey = \"levels.csv\""),
    ("a polynomial", "foundation.polynomial = [1.0, -0.2, 0.02]"),
    ("a cosine", "foundation.cosine = { mean = 1.0, amplitude = 0.1, wavelength = 4.0 }"),
    ("rigid", "foundation.depth = 1.0"),
    ("elastic without tension", "foundation = { depth = 0.5, stiffness = 100.0 }"),
    ("supports anywhere", "beam.supports = [{ at = 2.0 }, { at = 7.0 }]"),
    ("with levels", "beam.supports = [{ at = 0.0, level = 0.1 }, { at = 10.0, level = -0.2 }]"),
    ("built in", "beam.supports = [{ at = 0.0, built_in = true }]"),
    ("compression-only", "beam.supports = [{ at = 0.0 }, { at = 5.0, pushes_only = true }, { at = 10.0 }]"),
];

/// Words of the two sentences between what they name.
const BETWEEN: [&str; 5] = ["foundations", "that", "or", "and", "are"];

/// What the README says is not covered, with a line that asks for it.
const NOT_COVERED: [(&str, &str); 5] = [
    ("friction", "foundation = { depth = 1.0, friction = 0.3 }"),
    ("shear deformation", "beam.shear_stiffness = 5.0"),
    ("large deflections", "beam.large_deflections = true"),
    ("a stiffness that changes gradually", "beam.bending_stiffness = [1.0, 2.0]"),
    ("anything that moves with time", "load.point = [{ at = 1.0, force = 1.0, speed = 20.0 }]"),
];

/// A scene file with a line of one of the tables.
fn scene_with(line: &str) -> String {
    let lines = ["beam.length = 10.0", "beam.bending_stiffness = 1.3", "load.uniform = 1.0"];
    let key = |line: &str| line.split(" = ").next().map(str::to_owned);
    let others = lines.into_iter().filter(|other| key(other) != key(line));
    others.chain([line]).map(|line| format!("{line}\n")).collect()
}

/// Each thing is solved and certified, or refused; nothing else is named.
#[test]
fn what_the_readme_says_is_covered_is() {
    let readme = document("README.md");
    let sentence = |begins: &str| {
        let line = readme.lines().find_map(|line| line.strip_prefix(begins)).unwrap_or_else(|| panic!("no {begins}"));
        line.to_owned()
    };
    let without = |sentence: String, named: &[(&str, &str)]| {
        let less = named.iter().fold(sentence, |rest, (name, _)| {
            assert!(rest.contains(name), "{name} is not named");
            rest.replacen(name, "", 1)
        });
        let rest = BETWEEN.iter().fold(less, |rest, word| rest.replace(word, ""));
        assert_eq!(rest.trim_matches(|c: char| c.is_whitespace() || ".,;".contains(c)), "", "named without a scene");
    };
    without(sentence("**Covered** "), &COVERED);
    without(sentence("**Not covered** "), &NOT_COVERED);
    COVERED.iter().for_each(|(_, line)| certified(&scene_with(line)));
    for (name, line) in NOT_COVERED {
        let parsed = palkki::scene::file::parse("README.md", &scene_with(line), |_| Err(ReadProblem::Missing));
        assert!(parsed.is_err(), "{name}");
    }
}

#[test]
fn what_is_not_printed_is_found() {
    let printed = "a\nb 1.00\nc\n";
    assert!(not_printed("…\nb 1.01\n…\nc", printed).is_empty(), "an excerpt, one unit off");
    assert_eq!(not_printed("b 1.02", printed), ["b 1.02"], "another number");
    assert_eq!(not_printed("c\na", printed), ["a"], "another order");
}

/// Who cites a version cites the one of the package.
#[test]
fn the_citation_names_the_version_of_the_package() {
    let citation = document("CITATION.cff");
    let version = citation.lines().find_map(|line| line.strip_prefix("version: "));
    assert_eq!(version, Some(env!("CARGO_PKG_VERSION")));
}
