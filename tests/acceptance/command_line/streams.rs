//! What is no ordinary file: devices, pipes, a disk that fills up, a reader that has gone.

use std::fs;
use std::process::{Command, Stdio};

use super::hostile::check;
use super::{Folder, no_reader};

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
    error: cannot read the scene: it is a named pipe, which may wait forever; standard input is `/dev/stdin`
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

#[test]
fn a_subcommand_that_loses_its_reader_has_no_success() {
    let folder = Folder::new("readers");
    folder.write("forces.csv", "x,force\n2.5,1\n7.5,1\n");
    for arguments in ["compare example.toml", "certify example.toml forces.csv", "solve example.toml", "--help"] {
        let output = folder.command(arguments).stdout(no_reader()).output().expect("it runs");
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(!err.contains("panicked"), "{arguments}: {err}");
        assert!(output.status.code() == Some(2), "{arguments}: {:?} {err}", output.status);
    }
}

/// The shell limits the memory to less than a fine grid takes: that is said beforehand, and nothing is aborted.
#[cfg(target_os = "linux")]
#[test]
fn a_grid_that_there_is_no_memory_for_is_refused() {
    let folder = Folder::new("little_memory");
    let program = env!("CARGO_BIN_EXE_palkki");
    for (route, intervals, code, message) in [
        ("--method force", 10_000_000, 2, "there is no memory for 10000000 intervals, which take 1000 MB"),
        ("--method displacement --solver clarabel", 99_999, 1, "there is no memory for 99998 unknowns, which take"),
    ] {
        let script =
            format!("ulimit -c 0; ulimit -v 200000; exec {program} solve example.toml {route} --intervals {intervals}");
        let output =
            Command::new("sh").args(["-c", &script]).current_dir(folder.path("")).output().expect("the program runs");
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&text);
        assert_eq!(output.status.code(), Some(code), "{route}: {text}");
        assert!(text.contains(message), "{route}: {text}");
    }
}
