//! The examples of the help are complete: each is run as it stands.

use std::path::Path;
use std::process::Command;

use super::Folder;

/// The lines of the examples in the help of a command; a blank line parts what belongs together.
fn examples(help: &str) -> Vec<String> {
    let after = help.split("\nExamples:\n").nth(1).unwrap_or_default();
    let after = after.replace("\\\n", "");
    let lines = after.lines().take_while(|line| line.is_empty() || line.starts_with("  "));
    lines.map(str::trim).filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

#[cfg(unix)]
#[test]
fn every_example_of_the_help_runs_as_it_stands() {
    let folder = Folder::new("examples");
    let report = Path::new(env!("CARGO_MANIFEST_DIR")).join("report");
    std::os::unix::fs::symlink(report, folder.path("report")).expect("a link");
    let program = Path::new(env!("CARGO_BIN_EXE_palkki"));
    let path =
        format!("{}:{}", program.parent().expect("a folder").display(), std::env::var("PATH").unwrap_or_default());
    let commands = folder.run("--help").out;
    let commands = commands.split("Commands:\n").nth(1).expect("commands");
    let commands = commands.lines().take_while(|line| !line.is_empty());
    let commands: Vec<&str> = commands.filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).collect();
    let commands: Vec<&&str> = commands.iter().filter(|name| !name.is_empty() && **name != "help").collect();
    assert!(8 <= commands.len(), "{commands:?}");
    let mut run = 0;
    for command in commands {
        let lines = examples(&folder.run(&format!("{command} --help")).out);
        assert!(!lines.is_empty(), "{command} has no examples");
        for line in lines {
            let mut shell = Command::new("sh");
            shell.args(["-c", &line]).current_dir(folder.path("")).env("PATH", &path).env("HOME", folder.path(""));
            let output = shell.output().expect("a shell");
            let err = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(
                output.status.success() && err.is_empty(),
                "{line}: {err}{}",
                String::from_utf8_lossy(&output.stdout)
            );
            run += 1;
        }
    }
    assert!(20 <= run, "{run} lines");
}
