//! What is no ordinary file: devices, pipes, a disk that fills up, a reader that has gone.

use std::fs;
use std::process::{Command, Stdio};

use super::hostile::check;
use super::{Folder, SURVEYED, no_reader};

#[cfg(target_os = "linux")]
#[test]
fn devices_and_pipes() {
    let folder = Folder::new("devices");
    check(&folder, "solve /dev/zero", "it is larger than");
    check(&folder, "solve /dev/null", "the file is empty");
    let made = Command::new("mkfifo").arg(folder.path("pipe")).status().expect("mkfifo");
    assert!(made.success(), "a pipe");
    // Nobody ever writes to it.
    let run = folder.run("solve pipe");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    insta::assert_snapshot!(run.err.trim_end(), @"
    error: cannot read the scene: it is a named pipe, which may wait forever; standard input is `-`
    --> pipe
    ");
    let reader = Command::new("cat").arg(folder.path("pipe")).stdout(Stdio::piped()).spawn().expect("a reader");
    let run = folder.run("solve example.toml --method force --csv pipe");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let read = reader.wait_with_output().expect("the reader ends").stdout;
    assert!(read.starts_with(b"x,") && read.ends_with(b"\n"), "a whole table came through the pipe");
    assert!(!folder.path("pipe").is_file(), "the pipe is still one");
    let run = folder.run("solve example.toml --method force --csv /dev/null");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let run = folder.run("solve example.toml --method force --csv /dev/full");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    assert!(run.err.contains("cannot write \"/dev/full\""), "{}", run.err);

    let mut child = folder
        .command("solve /dev/stdin --method force --format json")
        .stdin(Stdio::from(fs::File::open(folder.path("example.toml")).expect("the example")))
        .stdout(Stdio::null())
        .spawn()
        .expect("the program starts");
    assert_eq!(child.wait().expect("it ends").code(), Some(0), "standard input is a file like others");
}

#[cfg(unix)]
#[test]
fn a_disk_that_fills_up_leaves_the_old_file() {
    let folder = Folder::new("full_disk");
    folder.write("nodes.csv", "what was there before");
    // The shell limits the size of files to a few blocks: writing ends with a signal, in the middle.
    let program = env!("CARGO_BIN_EXE_palkki");
    let script = format!(
        "ulimit -c 0; ulimit -f 2; exec {program} solve example.toml --method force --intervals 3000 --csv nodes.csv"
    );
    let output =
        Command::new("sh").args(["-c", &script]).current_dir(folder.path("")).output().expect("the program runs");
    assert_ne!(output.status.code(), Some(0), "a file that is too large for the limit");
    assert!(output.stdout.is_empty(), "nothing is printed");
    assert_eq!(folder.read("nodes.csv"), "what was there before");
    assert!(folder.contents().iter().all(|(path, _)| !path.to_string_lossy().ends_with(".tmp")), "nothing is left");
}

/// `palkki … | head -1`: whoever has read enough closes the pipe, and the exit code says what it says otherwise.
#[test]
fn a_reader_that_has_read_enough_is_no_failure() {
    let folder = Folder::new("readers");
    folder.write("forces.csv", "x,force\n2.5,1\n7.5,1\n");
    for arguments in [
        "solve example.toml",
        "solve example.toml --method force --intervals 300 --format json",
        "solve example.toml --csv -",
        "solve ridge.toml --method displacement --solver four-step",
        "compare example.toml",
        "certify example.toml forces.csv",
        "sweep example.toml --vary load.uniform --from 1 --to 2 --steps 3",
        "--help",
        "--version",
        "solve --help",
    ] {
        let code = folder.run(arguments).code;
        assert!(code == Some(0) || code == Some(1), "{arguments}: {code:?}");
        let output = folder.command(arguments).stdout(no_reader()).output().expect("it runs");
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), code, "{arguments}: {err}");
        assert!(err.is_empty() || arguments.ends_with("--csv -"), "{arguments}: {err}");
        let output = folder.command(arguments).stdout(no_reader()).stderr(no_reader()).output().expect("it runs");
        assert_eq!(output.status.code(), code, "{arguments}, nobody reads anything");
    }
}

/// `-` is standard input for each command, and a survey that such a scene names is looked for in the working directory.
#[test]
fn a_scene_is_read_from_standard_input() {
    let folder = Folder::new("standard_input");
    folder.write("levels.csv", "x,depth\n0,1\n10,1\n");
    folder.write("forces.csv", "x,force\n2.5,3\n7.5,3\n");
    folder.write("surveyed.toml", SURVEYED);
    folder.write("bad.toml", "[beam]\nlength = -10\nbending_stiffness = 1\n");
    let from = |arguments: &str, file: &str| {
        let file = fs::File::open(folder.path(file)).expect("a file for standard input");
        let output = folder.command(arguments).stdin(file).output().expect("it runs");
        let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        (output.status.code(), out, err)
    };
    for (arguments, scene) in [
        ("solve SCENE --method force", "example.toml"),
        ("solve SCENE --method force", "surveyed.toml"),
        ("certify SCENE forces.csv", "example.toml"),
        ("sweep SCENE --vary load.uniform --from 1 --to 2 --steps 3 --csv -", "example.toml"),
        ("compare SCENE --intervals 4", "ridge.toml"),
    ] {
        // Times differ from run to run, so they are not compared.
        let without_times =
            |text: &str| text.lines().filter(|line| !line.contains("e-")).collect::<Vec<_>>().join("\n");
        let named = folder.run(&arguments.replace("SCENE", scene));
        let (code, out, _) = from(&arguments.replace("SCENE", "-"), scene);
        assert_eq!(code, named.code, "{arguments}, {scene}");
        let called = without_times(&named.out).replace(scene, "standard input");
        let called = called.replace(&"=".repeat(scene.len()), "=");
        assert_eq!(
            without_times(&out).replace(&"=".repeat("standard input".len()), "="),
            called,
            "{arguments}, {scene}"
        );
    }
    let (code, out, _) = from("certify example.toml -", "forces.csv");
    let certified =
        |text: &str| text.lines().filter(|line| line.contains("energy J*")).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(code, folder.run("certify example.toml forces.csv").code);
    assert_eq!(certified(&out), certified(&folder.run("certify example.toml forces.csv").out));
    let (code, out, err) = from("solve -", "bad.toml");
    assert_eq!((code, out.as_str()), (Some(2), ""));
    insta::assert_snapshot!(err.trim_end(), @"
    error: `beam.length` must be positive and finite, but is -10
     --> standard input:2:10
      |
    2 | length = -10
      |          ^^^
    ");
    let (code, out, err) = from("certify - -", "example.toml");
    assert_eq!((code, out.as_str()), (Some(2), ""));
    assert!(err.contains("cannot both be read from standard input"), "{err}");
    let (code, _, err) = from("solve - --csv example.toml", "example.toml");
    assert!(code == Some(2) && err.contains("it is the scene itself"), "{err}");
}

/// Whether there are colours is decided as clap decides it; a terminal that has none is TERM=dumb.
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_without_colours_gets_no_escape_codes() {
    let folder = Folder::new("colours");
    let escaped = |arguments: &str, settings: &[(&str, &str)]| {
        let mut command = folder.command(arguments);
        command.env_remove("CI").env_remove("NO_COLOR").envs(settings.iter().copied());
        command.output().expect("it runs").stderr.contains(&0x1b)
    };
    for arguments in ["solve missing.toml", "solve --frobnicate"] {
        assert!(!escaped(arguments, &[]), "{arguments}: no terminal");
        assert!(escaped(arguments, &[("CLICOLOR_FORCE", "1")]), "{arguments}: asked for");
        assert!(!escaped(arguments, &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]), "{arguments}: not wanted");
    }
    // What an answer is worth is coloured, and nothing else, and not in JSON.
    let answer = |arguments: &str| {
        let output = folder.command(arguments).env("CLICOLOR_FORCE", "1").env_remove("NO_COLOR").output();
        String::from_utf8(output.expect("it runs").stdout).expect("text")
    };
    for (arguments, count) in [
        ("solve example.toml", 1),
        ("solve example.toml -m force -n 4", 1),
        ("sweep example.toml --vary load.uniform --from 1 --to 2 -n 2", 3),
        ("solve example.toml --format json", 0),
    ] {
        let text = answer(arguments);
        let plain =
            text.replace("\u{1b}[1m", "").replace("\u{1b}[32m", "").replace("\u{1b}[31m", "").replace("\u{1b}[0m", "");
        assert_eq!(text.matches("certified\u{1b}[0m").count(), count, "{arguments}: {text}");
        let times = |line: &&str| !line.contains("seconds");
        let alone = folder.run(arguments).out;
        assert_eq!(plain.lines().filter(times).collect::<Vec<_>>(), alone.lines().filter(times).collect::<Vec<_>>());
    }
    assert!(answer("solve example.toml").starts_with("\u{1b}[1m\u{1b}[32mcertified\u{1b}[0m: "));
    assert!(answer("solve example.toml -m force -n 4").starts_with("\u{1b}[1m\u{1b}[31mnot-certified\u{1b}[0m: "));
    // A terminal, if there is a program that imitates one.
    let on_terminal = |term: &str, arguments: &str| {
        let line = format!("{} {arguments}", env!("CARGO_BIN_EXE_palkki"));
        let mut command = Command::new("script");
        command.args(["-qec", &line, "/dev/null"]).current_dir(folder.path("")).stdin(Stdio::null());
        command.env("TERM", term).env_remove("CI").env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
        command.output().ok().map(|output| output.stdout)
    };
    for arguments in ["solve missing.toml", "solve --frobnicate", "solve --help", "solve example.toml"] {
        let Some(dumb) = on_terminal("dumb", arguments) else { return };
        assert!(!dumb.is_empty() && !dumb.contains(&0x1b), "{arguments}: {}", String::from_utf8_lossy(&dumb));
    }
    let coloured = on_terminal("xterm", "solve missing.toml").unwrap_or_default();
    assert!(coloured.contains(&0x1b), "{}", String::from_utf8_lossy(&coloured));
}

/// The shell limits the memory to less than a fine grid, or a long survey, takes: that is said beforehand, and nothing is aborted.
#[cfg(target_os = "linux")]
#[test]
fn what_there_is_no_memory_for_is_refused() {
    let folder = Folder::new("little_memory");
    let program = env!("CARGO_BIN_EXE_palkki");
    for points in [600_000, 3_000_000] {
        let rows: String = (0..points).map(|i| format!("{},{}\n", f64::from(i) / 10.0, 1 + i % 7)).collect();
        folder.write(&format!("{points}.csv"), format!("x,depth\n{rows}"));
        let beam = format!("[beam]\nlength = {}\nbending_stiffness = 1.0\n", f64::from(points - 1) / 10.0);
        let rest = format!("[load]\nuniform = 1.0\n[foundation]\nsurvey = \"{points}.csv\"\n");
        folder.write(&format!("{points}.toml"), &(beam + &rest));
    }
    for (arguments, code, message) in [
        ("example.toml --method force --intervals 10000000", 2, "no memory for 10000000 intervals, which take 1000 MB"),
        ("example.toml --method displacement --solver clarabel --intervals 99999", 1, "no memory for 99998 unknowns"),
        ("600000.toml", 2, "600000 points of a profile and 0 places near contact, which take 252 MB, of"),
        ("3000000.toml", 2, "it cannot be read (out of memory)"),
    ] {
        let script = format!("ulimit -c 0; ulimit -v 200000; exec {program} solve {arguments}");
        let output =
            Command::new("sh").args(["-c", &script]).current_dir(folder.path("")).output().expect("the program runs");
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&text);
        assert_eq!(output.status.code(), Some(code), "{arguments}: {text}");
        assert!(text.contains(message), "{arguments}: {text}");
    }
}
