//! Who may know whom, and who may touch the world.

use std::collections::BTreeMap;

use super::text::{code, files, first_word_of, none, offenders, words};

/// Words of mechanics. `solvers` and `problem` know the quadratic program (32) and nothing of what it stands for.
const MECHANICS: [&str; 14] = [
    "beam",
    "beams",
    "scene",
    "scenes",
    "moment",
    "moments",
    "foundation",
    "foundations",
    "deflection",
    "deflections",
    "bending",
    "clearance",
    "pressure",
    "methods",
];

/// Every name of a solver.
const SOLVERS: [&str; 8] = ["four_step", "FourStep", "active_set", "ActiveSet", "nsor", "psor", "clarabel", "osqp"];

/// The Rust files of a room.
#[track_caller]
fn room(name: &str) -> BTreeMap<String, String> {
    let found = files(name, ".rs");
    assert!(!found.is_empty(), "no file of {name} was read: it has moved, or its invariant is void");
    found
}

#[test]
fn solvers_never_mention_a_beam() {
    let found = offenders(&room("src/grid/solvers"), |line| {
        first_word_of(line, &MECHANICS).map(|word| format!("`{word}` is a word of mechanics"))
    });
    none(&found, "solvers know algorithms and no beam, not even in a comment");
}

#[test]
fn the_quadratic_program_knows_no_beam() {
    let found = offenders(&room("src/grid/qp"), |line| {
        first_word_of(code(line), &MECHANICS).map(|word| format!("`{word}` is a word of mechanics"))
    });
    none(&found, "the quadratic program (32) is plain mathematics; only comments may say what it stands for");
}

#[test]
fn methods_never_name_a_solver() {
    let found = offenders(&room("src/grid/methods"), |line| {
        let named = first_word_of(line, &SOLVERS);
        let used = first_word_of(code(line), &["solver", "solvers"]);
        named.or(used).map(|word| format!("`{word}` is a solver"))
    });
    none(&found, "methods know beams and no algorithm");
}

#[test]
fn the_certificate_uses_neither_methods_nor_solvers() {
    let found = offenders(&room("src/certificate"), |line| {
        first_word_of(code(line), &["methods", "solvers", "route", "theory", "solve"])
            .map(|word| format!("uses `{word}`"))
    });
    none(&found, "the judge is no contestant");
}

/// What the place of a contact node is written with, and the list that it stands in. `witness` makes the list, adds the supports,
/// and writes slopes and whether the ground holds them.
const MOVES: [&str; 9] =
    [".x = ", ".x += ", ".x -= ", "from = ", "to = ", "splice(", "retain(", ".remove(", ".insert("];

#[test]
fn the_certificate_moves_no_place() {
    let mut bounds = room("src/certificate");
    bounds.retain(|path, text| !path.ends_with("tests.rs") && text.contains("ContactNode"));
    assert!(bounds.keys().any(|path| path.ends_with("proof.rs")), "contact nodes have moved: {:?}", bounds.keys());
    let found = offenders(&bounds, |line| {
        let code = code(line).trim_start();
        let support = code.contains("nodes.insert(at, ") && code.contains("support.x");
        MOVES
            .iter()
            .find(|moves| code.contains(**moves) && !support && !code.starts_with("let "))
            .map(|m| format!("`{m}`"))
    });
    none(&found, "a witness stays as it is given");
}

/// Where all files are that a bound rests on, and how many lines of code they may have together.
const KERNEL: &str = "src/certificate/kernel";
/// Of these, 207 are there for elastic foundations of many readings, stretches that are walked along, groups of pressed parts and what these carry, 22 for the
/// moments of a pair on one, 37 for couples as loads, 235 for a bending stiffness in steps and joints, 60 for elastic foundations in steps and what changes
/// above them, 330 for supports that give and hinges, and 520 for axial forces: spans of parts, short ones among them, hinges,
/// strings, and the proof of what is left of buckling.
const MOST_LINES: usize = 2880;

/// The files of the kernel without their tests.
fn kernel() -> BTreeMap<String, String> {
    let mut kernel = room(KERNEL);
    kernel.retain(|path, _| !path.contains("/tests"));
    kernel
}

#[test]
fn the_kernel_is_short() {
    let kernel = kernel();
    let map = &files("ARCHITECTURE.md", "")["ARCHITECTURE.md"];
    let mut lines = 0;
    for (path, text) in &kernel {
        let name = path.rsplit('/').next().unwrap_or_default().trim_end_matches(".rs");
        assert!(name == "mod" || map.contains(&format!("`{name}`")), "ARCHITECTURE.md does not name {name}");
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        lines += text.lines().filter(|line| !code(line).trim().is_empty()).count();
    }
    assert!(lines <= MOST_LINES, "{lines} lines of code");
    assert!(MOST_LINES / 2 < lines, "only {lines} lines of code were found");
}

#[test]
fn the_library_has_no_evidence() {
    let modules = |path: &str| -> Vec<String> {
        let declared = |line: &str| {
            let name = line.trim_start_matches("pub ").strip_prefix("mod ")?;
            Some(name.trim_end_matches(';').to_owned())
        };
        files(path, "").get(path).into_iter().flat_map(|text| text.lines()).filter_map(declared).collect()
    };
    let (evidence, library) = (modules("tests/evidence/src/lib.rs"), modules("src/lib.rs"));
    assert!(
        evidence.contains(&"paper".to_owned()) && library.contains(&"scene".to_owned()),
        "{evidence:?} {library:?}"
    );
    let both: Vec<_> = evidence.into_iter().filter(|name| library.contains(name)).collect();
    none(&both, "a room of the evidence is one of the library");
    let used = offenders(&room("src"), |line| code(line).contains("palkki_evidence").then(|| "uses it".to_owned()));
    none(&used, "evidence is in tests/evidence, and the library does without");

    let manifest = &files("Cargo.toml", "")["Cargo.toml"];
    let needed = manifest.split("\n[").find(|table| table.starts_with("dependencies]")).unwrap_or_default();
    assert!(needed.contains("clarabel"), "the dependencies of the library were read");
    for only_tests in ["palkki-evidence", "insta", "divan"] {
        assert!(!needed.contains(only_tests), "{only_tests} is a dependency of the library");
    }
}

#[test]
fn the_kernel_rests_on_nothing_outside() {
    let found = offenders(&kernel(), |line| {
        let line = code(line);
        let outside = ["super::super", "crate::certificate::{", "certificate::kkt", "certificate::witness"];
        let of_the_crate = line.contains("crate::")
            && !["crate::scene", "crate::certificate::kernel"].iter().any(|own| line.contains(own));
        (of_the_crate || outside.iter().any(|path| line.contains(path))).then(|| "leaves the kernel".to_owned())
    });
    none(&found, "the kernel knows a scene and itself");
}

#[test]
fn theory_uses_no_grid() {
    let found = offenders(&room("src/theory"), |line| {
        first_word_of(code(line), &["grid", "methods"]).map(|word| format!("uses `{word}`"))
    });
    none(&found, "theory has free lift-off points and no grid");
}

#[test]
fn plots_know_no_method_and_no_solver() {
    let found = offenders(&room("src/plot"), |line| {
        first_word_of(code(line), &["methods", "solvers", "problem", "certificate"]).map(|w| format!("uses `{w}`"))
    });
    none(&found, "a figure draws what it is given");
}

/// What gives a status: a variant that is neither compared with nor matched.
fn gives_a_status(line: &str) -> Option<String> {
    let code = code(line).trim();
    let variants = ["Status::Certified", "Status::NotCertified", "Status::NotConverged"];
    variants.iter().find_map(|variant| {
        let (before, after) = code.split_once(variant)?;
        let compared = before.trim_end().ends_with("==") || before.trim_end().ends_with("!=");
        let matched = after.contains("=>") || after.trim_start().starts_with('|');
        (!compared && !matched).then(|| format!("gives `{variant}`"))
    })
}

#[test]
fn only_the_verdict_gives_a_status() {
    let mut library = files("src", ".rs");
    for text in library.values_mut() {
        *text = text.split("#[cfg(test)]").next().unwrap_or_default().to_owned();
    }
    let verdict = library.remove("src/verdict/mod.rs").expect("the verdict is there");
    assert!(verdict.lines().any(|line| code(line).contains("Self::Certified")), "the verdict gives it");
    none(&offenders(&library, gives_a_status), "an answer is certified in one place");
    assert!(gives_a_status("        let status = Status::Certified;").is_some(), "a status that is given is found");
    assert_eq!(gives_a_status("if exact.status == Status::Certified {"), None, "a comparison gives none");
}

/// Modules of the standard library that reach the world, and types that read a clock.
const WORLD: [&str; 7] = ["fs", "io", "env", "net", "process", "time", "thread"];
const CLOCKS: [&str; 2] = ["Instant", "SystemTime"];
const PRINTS: [&str; 5] = ["println", "print", "eprintln", "eprint", "dbg"];

/// What a line of library code does that only the outer rooms may do.
fn reaches_out(line: &str) -> Option<String> {
    let code = code(line);
    let mut previous = "";
    for word in words(code) {
        // `std::fs` as well as `use std::{fmt, fs}`.
        if WORLD.contains(&word) && (previous == "std" || code.contains("use std::{")) {
            return Some(format!("uses `std::{word}`"));
        }
        if CLOCKS.contains(&word) {
            return Some(format!("reads a clock, `{word}`"));
        }
        if PRINTS.contains(&word) && code.contains(&format!("{word}!")) {
            return Some(format!("prints, `{word}!`"));
        }
        previous = word;
    }
    None
}

#[test]
fn the_library_does_no_io_reads_no_clock_and_prints_nothing() {
    let mut library = files("src", ".rs");
    library.retain(|path, _| path != "src/main.rs" && !path.starts_with("src/cli/"));
    assert!(library.contains_key("src/lib.rs"), "the library was read");
    none(&offenders(&library, reaches_out), "only main, cli and xtask reach the outer world");
}

#[test]
fn reaching_out_is_recognised() {
    for line in [
        "use std::fs;",
        "use std::{fmt, io};",
        "use std::io::ErrorKind;",
        "let t = std::time::Duration::ZERO;",
        "    let start = Instant::now();",
        "println!(\"x\");",
    ] {
        assert!(reaches_out(line).is_some(), "{line}");
    }
    for line in ["use std::fmt;", "// std::fs is not used", "let time = 1.0;", "fn print(&self) {}"] {
        assert_eq!(reaches_out(line), None, "{line}");
    }
}
