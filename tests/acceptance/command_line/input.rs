//! Files that are not what they should be: exit code 2, nothing printed, nothing written.

use std::fs;

use super::{EXAMPLE, Folder, SURVEYED};

#[test]
fn scene_files_that_cannot_be_read() {
    let folder = Folder::new("unreadable_scene");
    folder.write("binary.toml", b"[beam]\nlength = \xff\xfe\n");
    folder.write("empty.toml", "");
    fs::create_dir(folder.path("directory.toml")).expect("a directory");
    insta::assert_snapshot!(folder.refused("solve missing.toml"), @"
    error: cannot read the scene: there is no such file
    --> missing.toml
    ");
    insta::assert_snapshot!(folder.refused("compare missing.toml --format json"), @"
    error: cannot read the scene: there is no such file
    --> missing.toml
    ");
    insta::assert_snapshot!(folder.refused("solve directory.toml"), @"
    error: cannot read the scene: it is a directory, not a file
    --> directory.toml
    ");
    insta::assert_snapshot!(folder.refused("solve binary.toml"), @"
    error: cannot read the scene: it is not a text file: the byte at line 2, column 10 is not UTF-8
    --> binary.toml
    ");
    insta::assert_snapshot!(folder.refused("solve empty.toml"), @"
    error: the file is empty
    --> empty.toml
     = note: expected a scene in TOML, with at least a table [beam]
    ");
    insta::assert_snapshot!(folder.refused("solve example.toml/scene.toml"), @"
    error: cannot read the scene: it cannot be read (not a directory)
    --> example.toml/scene.toml
    ");
}

#[test]
fn a_scene_file_that_is_too_large() {
    let folder = Folder::new("large_scene");
    let file = fs::File::create(folder.path("large.toml")).expect("a file for the test");
    // A hole: it takes no room on the disk.
    file.set_len(16 * 1024 * 1024 + 1).expect("a large file");
    let run = folder.run("solve large.toml");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    insta::assert_snapshot!(run.err.trim_end(), @"
    error: cannot read the scene: it is larger than 16777216 bytes, the most that is read
    --> large.toml
    ");
}

#[test]
fn a_bad_scene_is_shown_with_file_line_and_column() {
    let folder = Folder::new("bad_scene");
    folder.write("bad.toml", EXAMPLE.replace("length = 10", "length = -10"));
    insta::assert_snapshot!(folder.refused("solve bad.toml --method force --csv nodes.csv"), @"
    error: `beam.length` must be positive and finite, but is -10
     --> bad.toml:3:10
      |
    3 | length = -10
      |          ^^^
    ");
}

#[test]
fn surveys_are_read_beside_the_scene_file() {
    let folder = Folder::new("survey");
    fs::create_dir(folder.path("site")).expect("a directory");
    folder.write("site/scene.toml", SURVEYED);
    insta::assert_snapshot!(folder.refused("solve site/scene.toml --method force"), @r#"
    error: cannot read the survey "levels.csv": there is no such file
     --> site/scene.toml:5:10
      |
    5 | survey = 'levels.csv'
      |          ^^^^^^^^^^^^
    "#);
    folder.write("site/levels.csv", "x,depth\n0,1\n10,one\n");
    insta::assert_snapshot!(folder.refused("solve site/scene.toml --method force"), @r#"
    error: `depth` must be a finite number, but is "one"
     --> site/levels.csv:3:4
      |
    3 | 10,one
      |    ^^^
    "#);
    folder.write("site/levels.csv", b"x,depth\n0,1\n10,\xb2\n");
    insta::assert_snapshot!(folder.refused("solve site/scene.toml --method force"), @r#"
    error: cannot read the survey "levels.csv": it is not a text file: the byte at line 3, column 4 is not UTF-8
     --> site/scene.toml:5:10
      |
    5 | survey = 'levels.csv'
      |          ^^^^^^^^^^^^
    "#);
    folder.write("site/levels.csv", "x,depth\n0,1\n10,1\n");
    assert_eq!(folder.run("solve site/scene.toml --method force").code, Some(0), "a survey that is one");
}
