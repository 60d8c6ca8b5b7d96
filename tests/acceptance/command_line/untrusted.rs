//! Scenes that somebody else wrote: what they can make the program read, and what of it comes out.

use std::fs;
use std::os::unix::fs::symlink;

use super::hostile::check;
use super::{Folder, RIDGE, Run, SURVEYED};

/// A text that no message may show.
const SECRET: &str = "token-4f1d9";

/// Keys that name a file, with a scene for each.
fn naming(path: &str) -> Vec<(&'static str, String)> {
    let body = |keys: &str| format!("[body]\n{}\n", keys.replace("PATH", path));
    vec![
        ("foundation.survey", SURVEYED.replace("levels.csv", path)),
        ("columns by number", SURVEYED.replace("'levels.csv'", &format!("{{ file = '{path}', x = 1, depth = 2 }}"))),
        ("columns by name", SURVEYED.replace("'levels.csv'", &format!("{{ file = '{path}', x = 'x', depth = 'u' }}"))),
        (
            "beam.shape.survey",
            format!(
                "[beam]\nlength = 10\nbending_stiffness = 1\nshape = {{ survey = '{path}' }}\n[foundation]\ndepth = 1\n"
            ),
        ),
        ("body.stiffness", body("stiffness = 'PATH'")),
        ("body.flexibility", body("flexibility = 'PATH'")),
        ("body.foundation", body("flexibility = 'K.mtx'\nfoundation = 'PATH'")),
        ("body.gap", body("stiffness = 'K.mtx'\ngap = 'PATH'")),
        ("body.load", body("stiffness = 'K.mtx'\nload = 'PATH'")),
    ]
}

/// Files of many kinds with the secret in the header, in a row, in a field, in a line of a matrix.
fn secrets() -> Vec<String> {
    let matrix = "%%MatrixMarket matrix coordinate real symmetric";
    vec![
        SECRET.to_owned(),
        format!("{SECRET},2\n1,2\n"),
        format!("x,depth\n0,1\n10,{SECRET}\n"),
        format!("x,depth\n{SECRET},1\n10,1\n"),
        format!("x;depth\n0;1,5\n10;1.{SECRET}\n"),
        format!("i,gap\n{SECRET},0\n"),
        format!("i,force\n1,{SECRET}\n"),
        format!("{matrix}\n{SECRET} 1 1\n"),
        format!("{matrix}\n1 1 1\n1 1 {SECRET}\n"),
        format!("{matrix}\n1 1 1\n1 1 1 {SECRET}\n"),
        format!("# {SECRET}\nx,depth\n0\n"),
    ]
}

/// Of a file outside the folder of the scene a message says the place and what is wrong, and shows nothing of the text.
#[test]
fn text_of_files_outside_the_folder_of_the_scene_is_not_shown() {
    let folder = Folder::new("outside");
    super::body::known(&folder);
    fs::create_dir_all(folder.path("inner/deeper")).expect("a folder");
    fs::copy(folder.path("K.mtx"), folder.path("inner/K.mtx")).expect("a matrix");
    symlink("../secret", folder.path("inner/link")).expect("a link");
    let (mut hidden, mut shown) = (0, 0);
    for secret in secrets() {
        folder.write("secret", &secret);
        folder.write("inner/own", &secret);
        folder.write("inner/deeper/own", &secret);
        let absolute = folder.path("secret").display().to_string();
        for path in ["../secret", "link", "deeper/../../secret", &absolute] {
            for (key, scene) in naming(path) {
                folder.write("inner/scene.toml", scene);
                let Run { code, out, err } = folder.run("solve inner/scene.toml");
                assert_eq!((code, out.as_str()), (Some(2), ""), "{key} {path}");
                assert!(!err.contains(SECRET) && !err.contains("4f1d9"), "{key} {path}: {err}");
                assert!(err.contains("is not shown"), "{key} {path}: {err}");
                hidden += 1;
            }
        }
        for path in ["own", "deeper/own", "../inner/own"] {
            for (key, scene) in naming(path) {
                folder.write("inner/scene.toml", scene);
                let err = folder.run("solve inner/scene.toml").err;
                assert!(!err.contains("is not shown"), "{key} {path}: {err}");
                shown += usize::from(err.contains(SECRET));
            }
        }
    }
    assert!(250 < hidden && 100 < shown, "{hidden} hidden, {shown} shown");
}

/// Devices, pipes, sockets and folders that a scene names are not opened.
#[cfg(target_os = "linux")]
#[test]
fn a_scene_names_regular_files_only() {
    let folder = Folder::new("regular");
    super::body::known(&folder);
    let made = std::process::Command::new("mkfifo").arg(folder.path("pipe")).status().expect("mkfifo");
    assert!(made.success(), "a pipe");
    let _socket = std::os::unix::net::UnixListener::bind(folder.path("socket")).expect("a socket");
    symlink("/dev/zero", folder.path("link")).expect("a link");
    for path in ["/dev/zero", "/dev/ptmx", "/dev/random", "/dev/tty", "/dev/stdin", "pipe", "socket", "link"] {
        for (_, scene) in naming(path) {
            folder.write("scene.toml", scene);
            check(&folder, "solve scene.toml", "it is not a regular file");
        }
    }
    for (_, scene) in naming(".") {
        folder.write("scene.toml", scene);
        check(&folder, "solve scene.toml", "it is a directory");
    }
}

/// A sparse file claims any size and takes no room.
#[test]
fn a_file_that_a_scene_names_has_a_largest_size() {
    let folder = Folder::new("sized");
    super::body::known(&folder);
    fs::File::create(folder.path("huge")).and_then(|file| file.set_len(3 << 30)).expect("a large file");
    for (_, scene) in naming("huge") {
        folder.write("scene.toml", scene);
        check(&folder, "solve scene.toml", "it is larger than");
    }
}

/// What is special in Markdown, in XML or in JSON.
const TITLES: [&str; 9] = [
    "<script>alert(1)</script>",
    "a | b",
    "*x* _y_ `z` ~~w~~",
    "[link](javascript:alert)",
    "![image](file:///etc/passwd)",
    "&lt;b&gt; & $x$",
    "]]> --> #",
    "\"quoted\" 'twice'",
    "back\\\\slash \\\\<b>",
];

/// A title and a unit are shown as they are written, and mean nothing in any format.
#[test]
fn titles_are_escaped_in_every_format() {
    let folder = Folder::new("titles");
    for written in TITLES {
        let quoted = written.replace('\\', "\\\\").replace('"', "\\\"");
        let units = format!("[units]\nlength = \"{quoted}\"\nforce = \"{quoted}\"\n");
        let scene = RIDGE.split("[units]").next().expect("a scene");
        folder.write("titled.toml", format!("title = \"{quoted}\"\n{scene}{units}"));
        let markdown = folder.run("explain titled.toml --format markdown").out;
        let heading = markdown.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a heading");
        let (plain, meant) = unescaped(heading);
        assert_eq!(plain, written);
        assert!(!meant.contains(|c| r"\`*_[]<>&|~$#".contains(c)), "{heading}");
        let lines = markdown.lines().filter(|line| line.starts_with("- "));
        for line in lines.take(3) {
            let (plain, meant) = unescaped(line);
            assert!(plain.contains(written) || plain.starts_with("- foundation"), "{line}");
            assert!(!meant.contains(|c| r"\`*_[]<>&|~$#".contains(c)), "{line}");
        }
        for command in
            ["solve titled.toml --plot -", "sweep titled.toml --vary load.uniform --from 1 --to 2 -n 3 --plot -"]
        {
            let svg = folder.run(command).out;
            assert!(svg.starts_with("<svg"), "{svg}");
            for raw in ["<script", "<b>", "]]>", "& $"] {
                assert!(!svg.contains(raw), "{command} has {raw}");
            }
        }
        assert_eq!(folder.json("solve titled.toml").2["scene"], written);
        assert!(folder.run("solve titled.toml").out.contains(written));
    }
}

/// A text without its backslashes, and what of it had none.
fn unescaped(text: &str) -> (String, String) {
    let (mut plain, mut meant) = (String::new(), String::new());
    let mut characters = text.chars();
    while let Some(character) = characters.next() {
        if character == '\\' {
            plain.extend(characters.next());
        } else {
            plain.push(character);
            meant.push(character);
        }
    }
    (plain, meant)
}
