//! `cargo xtask doctor`: the programs that a build starts, which of them this machine lacks, and what to do about it.
//!
//! What cargo says itself, that Rust is too old or a component or a folder is missing, is left to cargo.

use std::process::{Command, ExitCode, Stdio};

/// A program that is started by one of several names.
struct Program {
    what: &'static str,
    /// The environment variable that names it.
    variable: &'static str,
    /// Its usual names.
    names: &'static [&'static str],
    /// Where it is not there: what to do, or who alone needs it.
    advice: &'static str,
}

const NEEDED: [Program; 3] = [
    Program { what: "Rust", variable: "RUSTC", names: &["rustc"], advice: "install it, for example with rustup" },
    Program {
        what: "C compiler",
        variable: "CC",
        names: &["cc", "gcc", "clang"],
        advice: "install one (Debian, Ubuntu: `apt-get install build-essential`; macOS: `xcode-select --install`)",
    },
    Program {
        what: "archiver",
        variable: "AR",
        names: &["ar"],
        advice: "install binutils; it comes with most C compilers",
    },
];

const BROWSER: Program = Program {
    what: "browser",
    variable: "CHROME",
    names: &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", MACOS_CHROME],
    advice: "only `cargo xtask browser` needs one (Debian: `apt-get install chromium`; Ubuntu: `snap install chromium`; \
             macOS: `brew install --cask google-chrome`)",
};

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
        let text =
            found.unwrap_or_else(|| format!("none of ${} starts; {}", names(program).join(", "), program.advice));
        println!("{verdict:<8} {:<11} {text}", program.what);
    }
    if missing == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The name under which a browser starts that can be driven without a window.
pub(crate) fn browser() -> Option<String> {
    found(&BROWSER, starts)
}

fn names(program: &Program) -> Vec<&'static str> {
    [program.variable].into_iter().chain(program.names.iter().copied()).collect()
}

/// The first of its names, the one in its variable before the usual ones, under which a program starts.
fn found(program: &Program, starts: impl Fn(&str) -> bool) -> Option<String> {
    let named = std::env::var(program.variable).ok().filter(|name| !name.is_empty());
    named.into_iter().chain(program.names.iter().map(|&name| name.to_owned())).find(|name| starts(name))
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
            NEEDED.iter().filter(lacks).map(|program| program.what).collect::<Vec<_>>()
        };
        assert_eq!(missing(&["rustc", "cc", "ar"]), [""; 0], "neither make nor cmake is needed");
        assert_eq!(missing(&["rustc", "clang", "ar"]), [""; 0], "any C compiler");
        assert_eq!(missing(&["make", "cmake"]), ["Rust", "C compiler", "archiver"]);
    }
}
