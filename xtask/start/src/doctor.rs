//! `cargo xtask doctor`: the programs that a build starts, which of them this machine lacks, and what to do about it.
//!
//! What cargo says itself, that Rust is too old or a component or a folder is missing, is left to cargo.

use std::process::{Command, ExitCode, Stdio};

/// A program: what it is, the environment variable that names it, its usual names, and where it is not there what to do, or who
/// alone needs it.
type Program = (&'static str, &'static str, &'static [&'static str], &'static str);

const NEEDED: [Program; 3] = [
    ("Rust", "RUSTC", &["rustc"], "install it, for example with rustup"),
    (
        "C compiler",
        "CC",
        &["cc", "gcc", "clang"],
        "install one (Debian, Ubuntu: `apt-get install build-essential`; macOS: `xcode-select --install`)",
    ),
    ("archiver", "AR", &["ar"], "install binutils; it comes with most C compilers"),
];

const BROWSER: Program = (
    "browser",
    "CHROME",
    &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", MACOS_CHROME],
    "only `cargo xtask browser` needs one (Debian: `apt-get install chromium`; Ubuntu: `snap install chromium`; \
     macOS: `brew install --cask google-chrome`)",
);

/// Where Chrome is on a Mac, which has no command for it.
const MACOS_CHROME: &str = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

/// Prints one line for each program; code 1 if one is missing without which the repository does not build.
pub(crate) fn run() -> ExitCode {
    let lines = NEEDED.iter().map(|program| (program, "MISSING")).chain([(&BROWSER, "note")]);
    let mut missing = 0;
    for (program, otherwise) in lines {
        let found = found(program, starts);
        missing += usize::from(found.is_none() && otherwise == "MISSING");
        let verdict = if found.is_some() { "ok" } else { otherwise };
        let (what, variable, names, advice) = program;
        let text = found.unwrap_or_else(|| format!("none of ${variable}, {} starts; {advice}", names.join(", ")));
        println!("{verdict:<8} {what:<11} {text}");
    }
    if missing == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The name under which a browser starts that can be driven without a window.
pub(crate) fn browser() -> Option<String> {
    found(&BROWSER, starts)
}

/// The first of its names, the one in its variable before the usual ones, under which a program starts.
fn found(program: &Program, starts: impl Fn(&str) -> bool) -> Option<String> {
    let (_, variable, names, _) = program;
    let named = std::env::var(variable).ok().filter(|name| !name.is_empty());
    named.into_iter().chain(names.iter().map(|&name| name.to_owned())).find(|name| starts(name))
}

/// Whether a program is there and runs. The archiver of a Mac knows no `--version`, and says so with code 1.
fn starts(program: &str) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success() || program == "ar" && status.code() == Some(1))
}

#[cfg(test)]
mod tests {
    use super::{NEEDED, Program, found};

    #[test]
    fn what_is_not_there_is_missing() {
        let missing = |there: &[&str]| {
            let lacks = |program: &&Program| found(program, |name| there.contains(&name)).is_none();
            NEEDED.iter().filter(lacks).map(|program| program.0).collect::<Vec<_>>()
        };
        assert_eq!(missing(&["rustc", "cc", "ar"]), [""; 0], "neither make nor cmake is needed");
        assert_eq!(missing(&["rustc", "clang", "ar"]), [""; 0], "any C compiler");
        assert_eq!(missing(&["make", "cmake"]), ["Rust", "C compiler", "archiver"]);
    }
}
