//! What is no ordinary file: devices, pipes, a disk that fills up, a reader that has gone.

use std::fs;
use std::process::{Command, Stdio};

use super::Folder;
use super::hostile::check;

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
    let run = folder.run("solve example.toml --method force --csv pipe");
    assert!(run.err.contains("it is not a regular file"), "{}", run.err);
    let run = folder.run("solve example.toml --method force --csv /dev/full --plot beam.svg");
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("it is not a regular file") && !folder.path("beam.svg").exists(), "{}", run.err);

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
}

#[test]
fn every_subcommand_may_lose_its_reader() {
    let folder = Folder::new("readers");
    folder.write("forces.csv", "x,force\n2.5,1\n7.5,1\n");
    for arguments in ["compare example.toml", "certify example.toml forces.csv", "solve example.toml", "--help"] {
        let mut child =
            folder.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(!err.contains("panicked"), "{arguments}: {err}");
        assert!(matches!(output.status.code(), Some(0 | 1)), "{arguments}: {:?} {err}", output.status);
    }
}
