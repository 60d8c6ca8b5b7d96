//! What is written: files whole or not at all, and standard output.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use palkki::route::{Method, Solver};
use palkki::{Settings, solve_raw};

use super::{EXAMPLE, Folder, scene};

#[test]
fn csv_holds_the_nodes_to_the_last_bit() {
    let folder = Folder::new("csv");
    folder.write("nodes.csv", "what was there before");
    let run = folder.run("solve example.toml --method displacement --intervals 12 --csv nodes.csv");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let csv = folder.read("nodes.csv");
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("x,deflection,clearance,contact_force,moment"));
    let settings =
        Settings { method: Method::Displacement, solver: Solver::ActiveSet, intervals: 12, tolerance: 1e-10 };
    let nodes = solve_raw(&scene(EXAMPLE), &settings).expect("an answer").state.nodes.expect("nodes");
    let columns = [&nodes.x, &nodes.deflection, &nodes.clearance, &nodes.contact_force, &nodes.moment];
    let mut rows = 0;
    for (i, line) in lines.enumerate() {
        let read: Vec<u64> = line.split(',').map(|field| field.parse::<f64>().expect("a number").to_bits()).collect();
        assert_eq!(read, columns.map(|column| column[i].to_bits()), "row {i}");
        rows += 1;
    }
    assert_eq!(rows, 11, "one row for each interior node");
    let left = folder.contents().iter().filter(|(path, _)| path.to_string_lossy().contains(".tmp")).count();
    assert_eq!(left, 0, "no temporary file is left");
}

#[test]
fn without_a_foundation_the_clearance_is_left_empty() {
    let folder = Folder::new("csv_free");
    folder.write("free.toml", "[beam]\nlength = 2\nbending_stiffness = 1\n[load]\nuniform = 1\n");
    let run = folder.run("solve free.toml --method force --intervals 2 --csv nodes.csv");
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""), "two intervals are not certain to a tenth");
    let csv = folder.read("nodes.csv");
    let fields: Vec<&str> = csv.lines().nth(1).expect("one node").split(',').collect();
    assert_eq!(fields.len(), 5, "{csv}");
    assert_eq!([fields[0], fields[2]], ["1.0", ""], "x and the clearance in {csv}");
    let (_, _, json) = folder.json("solve free.toml --method force --intervals 2");
    assert_eq!(json["nodes"]["clearance"], serde_json::json!([null]), "JSON has no infinity");
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_stays_a_link() {
    let folder = Folder::new("link");
    folder.write("target.csv", "old");
    std::os::unix::fs::symlink("target.csv", folder.path("link.csv")).expect("a link");
    assert_eq!(folder.run("solve example.toml --method force --csv link.csv").code, Some(0));
    assert!(folder.read("target.csv").starts_with("x,"), "the file that the link names is written");
    assert!(folder.path("link.csv").is_symlink(), "the link is still one");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_a_failure() {
    let folder = Folder::new("full");
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has a full device");
    let output = folder.command("solve example.toml --method force").stdout(full).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stderr.starts_with(b"error: cannot print the answer: "), "it says why");
}

/// A link to a file that is not there yet leads there; the link stays, over any number of links.
#[cfg(unix)]
#[test]
fn a_link_to_no_file_yet_is_followed() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new("links");
    fs::create_dir(folder.path("data")).expect("a folder");
    for option in ["--csv", "--plot"] {
        for (target, name) in [
            ("new", "new"),
            ("data/new", "data/new"),
            ("next", "data/last"),
            ("data/../new", "new"),
            ("data/next", "new"),
        ] {
            for (file, to) in [("link", target), ("next", "data/last"), ("data/next", "../new")] {
                // What the round before left.
                let _ = fs::remove_file(folder.path(file));
                symlink(to, folder.path(file)).expect("a link");
            }
            let run = folder.run(&format!("solve example.toml {option} link"));
            assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{target}");
            assert!(folder.path("link").is_symlink(), "{target}: the link stays");
            let made = folder.path(name);
            assert!(made.is_file() && !made.is_symlink(), "{target}: {name} is there");
            fs::remove_file(made).expect("it was there");
        }
        symlink("circle", folder.path("circle")).expect("a link");
        assert!(folder.refused(&format!("solve example.toml {option} circle")).contains("a link that leads to itself"));
        fs::remove_file(folder.path("circle")).expect("the link");
        symlink("nowhere/new", folder.path("lost")).expect("a link");
        assert!(folder.refused(&format!("solve example.toml {option} lost")).contains("there is no such directory"));
        fs::remove_file(folder.path("lost")).expect("the link");
    }
}

/// A stream that was opened for reading loses every answer.
#[cfg(unix)]
#[test]
fn a_standard_output_that_cannot_be_written_to_is_a_failure() {
    let folder = Folder::new("unwritable");
    folder.write("forces.csv", "x,force\n2.5,3\n7.5,3\n");
    for arguments in [
        "solve example.toml",
        "solve example.toml --format json",
        "solve example.toml --csv -",
        "certify example.toml forces.csv",
        "compare example.toml --intervals 4",
        "sweep example.toml --vary load.uniform --from 1 --to 2 --steps 3",
        "explain example.toml",
        "completions bash",
        "manual",
        "--help",
        "--version",
        "solve --help",
    ] {
        let read_only = fs::File::open("/dev/null").expect("a device");
        let output = folder.command(arguments).stdout(read_only).output().expect("it runs");
        assert_eq!(output.status.code(), Some(2), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

/// A file that is there keeps its mode, whatever the mask for new ones is; one that may not be written stays, unless the
/// user may write everything.
#[cfg(unix)]
#[test]
fn a_file_keeps_its_mode() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = Folder::new("modes");
    for mode in [0o600, 0o640, 0o644, 0o666, 0o660, 0o755, 0o444, 0o400] {
        for option in ["--csv", "--plot"] {
            folder.write("file", "what was there before");
            fs::set_permissions(folder.path("file"), fs::Permissions::from_mode(mode)).expect("a mode");
            let may_write = fs::OpenOptions::new().write(true).open(folder.path("file")).is_ok();
            let arguments = format!("solve example.toml --method force {option} file");
            if may_write {
                let run = folder.run(&arguments);
                assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{mode:o}");
                assert_ne!(folder.read("file"), "what was there before", "{mode:o}");
            } else {
                assert!(folder.refused(&arguments).contains("denied"), "{mode:o}");
            }
            let found = fs::metadata(folder.path("file")).expect("the file").permissions().mode() & 0o777;
            assert_eq!(found, mode, "{found:o} instead of {mode:o}");
            fs::remove_file(folder.path("file")).expect("the file goes");
        }
    }
}

/// A name may be as long as the file system takes: 255 bytes on those that are usual.
#[cfg(target_os = "linux")]
#[test]
fn a_name_may_be_as_long_as_a_name_can_be() {
    let folder = Folder::new("names");
    for length in [1, 200, 240, 249, 254, 255] {
        let name = "n".repeat(length);
        let run = folder.run(&format!("solve example.toml --method force --csv {name}"));
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{length} bytes");
        assert!(folder.read(&name).starts_with("x,"), "{length} bytes");
    }
    folder.refused(&format!("solve example.toml --method force --csv {}", "n".repeat(256)));
}

/// Standard output behind `-` and behind its names has the table, and the answer goes to standard error; both are whole, into
/// a pipe and into a file.
#[cfg(target_os = "linux")]
#[test]
fn a_table_to_standard_output_leaves_the_answer_to_standard_error() {
    let folder = Folder::new("dash");
    let answer = folder.run("solve example.toml --method force --intervals 12");
    for (option, begins) in [("--csv", "x,"), ("--plot", "<svg ")] {
        let solve = "solve example.toml --method force --intervals 12";
        assert_eq!(folder.run(&format!("{solve} {option} file")).code, Some(0));
        let file = folder.read("file");
        assert!(file.starts_with(begins), "{file}");
        for name in ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"] {
            let run = folder.run(&format!("{solve} {option} {name}"));
            assert_eq!(run.code, Some(0), "{name}: {}", run.err);
            assert!(run.out == file, "{name}: {}", run.out);
            assert_eq!(run.err.lines().count(), answer.out.lines().count(), "{name}: {}", run.err);
            let into = fs::File::create(folder.path("into")).expect("a file");
            let output = folder.command(&format!("{solve} {option} {name}")).stdout(into).output().expect("it runs");
            assert_eq!(output.status.code(), Some(0), "{name}");
            assert!(folder.read("into") == file && !output.stderr.is_empty(), "{name}");
        }
        let run = folder.run(&format!("{solve} {option} /dev/stderr"));
        assert_eq!((run.code, run.out.lines().count()), (Some(0), answer.out.lines().count()));
        assert!(run.err == file, "{}", run.err);
    }
    folder.refused("solve example.toml --method force --csv - --plot /dev/stdout");
    assert!(!fs::exists(folder.path("-")).expect("a folder"), "no file is called -");
}

/// A file into which the shell has sent a stream is that stream, by whichever name it is called: no text overwrites another.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_is_a_stream_as_well_loses_no_text() {
    let folder = Folder::new("same_file");
    let solve = "solve example.toml --method force --intervals 12";
    let table = folder.run(&format!("{solve} --csv -")).out;
    std::os::unix::fs::symlink("into", folder.path("link")).expect("a link");
    for name in ["into", "./into", "link", "/dev/stdout", "/proc/thread-self/fd/1"] {
        let into = fs::File::create(folder.path("into")).expect("a file");
        let output = folder.command(&format!("{solve} --csv {name}")).stdout(into).output().expect("it runs");
        let answer = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{name}: {answer}");
        assert!(folder.read("into") == table, "{name}: the table, and nothing else");
        assert!(answer.contains("Equilibrium"), "{name}: the answer goes to standard error: {answer}");
    }
    for (name, others) in [("into", ""), ("link", " --plot -"), ("/dev/stderr", " --plot -")] {
        let into = fs::File::create(folder.path("into")).expect("a file");
        let output = folder.command(&format!("{solve} --csv {name}{others}")).stderr(into).output().expect("it runs");
        let both = String::from_utf8_lossy(&output.stdout).into_owned() + &folder.read("into");
        assert_eq!(output.status.code(), Some(0), "{name}{others}: {both}");
        assert!(both.contains("Equilibrium") && both.contains(&table), "{name}{others}: {both}");
    }
}

/// Whether this process, and so what it starts, was told to ignore SIGINT, which is number 2. Only Linux says so in a file.
#[cfg(unix)]
fn ignores_interrupts() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).map(str::trim);
    ignored.and_then(|mask| u64::from_str_radix(mask, 16).ok()).is_some_and(|mask| mask & (1 << 1) != 0)
}

/// Whenever a signal comes, there is the old file or the new one, and no other. It comes while the program waits for its scene;
/// when a file is seen beside its place, or the program was faster; and while the program waits for a reader of its figure.
#[cfg(unix)]
#[test]
fn a_signal_leaves_nothing_behind() {
    const OLD: &str = "what was there before";
    let folder = Folder::new("signals");
    // A shell that puts a job into the background lets it ignore the first one, and what it starts as well.
    let signals: &[&str] = if ignores_interrupts() { &["TERM"] } else { &["INT", "TERM"] };
    let made = Command::new("mkfifo").arg(folder.path("pipe")).status().expect("mkfifo");
    assert!(made.success(), "a pipe");
    let on_its_way = |name: &Path| name.to_string_lossy().ends_with(".tmp");
    // Not what is in them: a pipe would wait for a writer.
    let names = || fs::read_dir(folder.path("")).expect("the folder").map(|entry| entry.expect("an entry").path());
    for (scene, plot, ends) in
        [("-", "beam.svg", true), ("example.toml", "beam.svg", false), ("example.toml", "pipe", true)]
    {
        for signal in signals.repeat(4) {
            folder.write("nodes.csv", OLD);
            let solve = format!("solve {scene} --method force --intervals 3000 --csv nodes.csv --plot {plot}");
            let mut command = folder.command(&solve);
            let mut child =
                command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts");
            let comes = |is_over: bool| match (scene, plot) {
                ("-", _) => true,
                (_, "pipe") => folder.read("nodes.csv") != OLD,
                _ => is_over || names().any(|name| on_its_way(&name)),
            };
            while !comes(child.try_wait().expect("its state").is_some()) {}
            let id = child.id().to_string();
            let _ = Command::new("kill").args([&format!("-{signal}"), &id]).stderr(Stdio::null()).status();
            let code = child.wait().expect("it ends").code();
            assert!(code.is_none() || !ends, "{solve}: the signal ends it, and not {code:?}");
            let table = folder.read("nodes.csv");
            assert!(table == OLD || table.lines().count() == 3000, "{solve}: half a table");
            assert!(!names().any(|name| on_its_way(&name)), "{solve}: {:?}", names().collect::<Vec<_>>());
        }
    }
}

#[test]
fn a_plot_is_written_and_says_what_it_shows() {
    let folder = Folder::new("plot");
    let run = folder.run("solve example.toml --method displacement --intervals 12 --csv nodes.csv --plot beam.svg");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let svg = folder.read("beam.svg");
    assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"), "a whole figure");
    assert!(svg.contains("Example: displacement method, active-set, 12 intervals"), "its title names the answer");
    assert!(folder.read("nodes.csv").lines().count() == 12, "and the table is written as well");
    assert_eq!(folder.run("solve example.toml --plot exact.svg").code, Some(0));
    assert!(folder.read("exact.svg").contains("Example: beam theory"), "of beam theory as well");
}
