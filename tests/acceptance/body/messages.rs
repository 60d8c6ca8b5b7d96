//! Everything that can be wrong with `[body]` and its files: one thing wrong in each case, and all messages, as a person reads them, in
//! `snapshots/body_messages.snap`.

use palkki::scene::file::{Model, parse_answers, parse_model};
use palkki_evidence::texts::Files;

use crate::support::assert_text;

const SCENE: &str = "title = 'Two springs'\n[body]\nflexibility = 'C.mtx'\ngap = 'gap.csv'\nload = 'load.csv'\n";
const MATRIX: &str =
    "%%MatrixMarket matrix coordinate real symmetric\n% two springs\n\n2 2 3\n1 1 2.0\n2 1 -1\n2 2 2.0\n";
const GAP: &str = "i,gap\n1,0.5\n";
const LOAD: &str = "i,force\n2,1.0\n";

fn read(scene: &str, matrix: &str, gap: &str, load: &str) -> Result<Model, String> {
    let small = "%%MatrixMarket matrix array real general\n1 1\n1\n";
    let files = [("C.mtx", matrix), ("gap.csv", gap), ("load.csv", load), ("small.mtx", small)];
    parse_model("site/body.toml", scene, &mut Files(&files)).map_err(|error| error.to_string())
}

/// What is replaced in the scene, and by what.
const SCENES: &[(&str, &str)] = &[
    ("title = 'Two springs'", "title = 'Two springs'\n[beam]\nlength = 1\nbending_stiffness = 1"),
    ("title = 'Two springs'", "title = 'Two springs'\n[load]\nuniform = 1"),
    ("title = 'Two springs'", "titel = 'Two springs'"),
    ("flexibility = 'C.mtx'\n", ""),
    ("flexibility = 'C.mtx'", "flexibility = 'C.mtx'\nstiffness = 'K.mtx'"),
    ("flexibility = 'C.mtx'", "flexibility = 'C.mtx'\nmass = 'M.mtx'"),
    ("flexibility = 'C.mtx'", "stiffness = 'C.mtx'\nfoundation = 'C.mtx'"),
    ("flexibility = 'C.mtx'", "flexibility = 'C.mtx'\nfoundation = 'small.mtx'"),
    ("flexibility = 'C.mtx'", "flexibility = 'missing.mtx'"),
    ("flexibility = 'C.mtx'", "flexibility = [[2, -1], [-1, 2]]"),
    ("gap.csv", "missing.csv"),
];

/// What is replaced in the matrix, and by what.
const MATRICES: &[(&str, &str)] = &[
    (MATRIX, ""),
    ("%%MatrixMarket", "%MatrixMarket"),
    ("real symmetric", "real skew-symmetric"),
    ("real symmetric", "complex symmetric"),
    ("2 2 3\n1 1 2.0\n2 1 -1\n2 2 2.0\n", ""),
    ("2 2 3", "2 3 3"),
    ("2 2 3", "2 2"),
    ("2 2 3", "2 2 1"),
    ("2 2 3", "0 0 0"),
    ("2 2 3", "99999999999 99999999999 3"),
    ("2 2 3", "3000000000 3000000000 9000000000"),
    ("2 1 -1", "2 1"),
    ("2 1 -1", "2 1 -1 0"),
    ("2 1 -1", "3 1 -1"),
    ("2 1 -1", "2 0 -1"),
    ("2 1 -1", "2.5 1 -1"),
    ("2 1 -1", "2 1 minus"),
    ("2 1 -1", "2 1 nan"),
    ("2 1 -1", "2 1 -1e999"),
    ("2 1 -1", "2 2 -1"),
    ("2 2 2.0\n", ""),
    ("2 2 2.0\n", "2 2 2.0\n1 1 2.0\n"),
    ("2 2 3", "2 2 4\n1 2 -1"),
    ("symmetric\n% two springs\n\n2 2 3", "general\n2 2 4\n1 2 -1.001"),
    ("symmetric\n% two springs\n\n2 2 3", "general\n2 2 3"),
    ("2 2 2.0", "2 2 0.4"),
    ("2 2 3\n1 1 2.0\n2 1 -1\n2 2 2.0\n", "2 2 2\n1 1 2.0\n1 2 0.0\n"),
    (
        "coordinate real symmetric\n% two springs\n\n2 2 3\n1 1 2.0\n2 1 -1\n2 2 2.0",
        "array real symmetric\n2 2\n2\n-1\n",
    ),
    (
        "coordinate real symmetric\n% two springs\n\n2 2 3\n1 1 2.0\n2 1 -1\n2 2 2.0",
        "array real general\n2 2\n2\n-1\n1\n2\n",
    ),
    ("1 1 2.0", "1 1 1e308"),
    (MATRIX, "1 1 2.0 4\n"),
    (MATRIX, "1 1\n"),
    (MATRIX, "1 1 2.0\n2 2 two\n"),
    (MATRIX, "0 0 2.0\n"),
    (MATRIX, "1 1 2.0\n5 5 2.0\n"),
    (MATRIX, "1 1 2.0\n2 2 2.0\n2 1 -1\n1 2 -1.5\n"),
    (MATRIX, "1 1 2.0\n2 2 2.0\n1 1 1.0\n"),
    (MATRIX, "1,1, 1,1, 2.0\n1,1, 2,1\n"),
    (MATRIX, "1,1, 1,1, 2.0\n1,1.5, 2,1, 1.0\n"),
];

/// Gaps, and answers of other programs.
const TABLES: &[&str] = &[
    "",
    "i;gap\n1;0,5\n2;0.5\n",
    "x,gap\n1,0.5\n",
    "i,gap\n1\n",
    "i,gap\n0,0.5\n",
    "i,gap\n1.0,0.5\n",
    "i,gap\n1,-inf\n",
    "i,gap\n1,1\n2,1\n1,1\n",
];

#[test]
fn every_message_of_a_body() {
    let changed = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "the valid file does not contain {from:?}");
        text.replacen(from, to, 1)
    };
    let refused = |read: Result<Model, String>| read.expect_err("one thing is wrong in it");
    let mut messages: Vec<String> =
        SCENES.iter().map(|(from, to)| refused(read(&changed(SCENE, from, to), MATRIX, GAP, LOAD))).collect();
    messages.extend(
        MATRICES.iter().map(|(from, to)| refused(read(SCENE, &changed(MATRIX, from, to), GAP, "i,force\n1,10\n"))),
    );
    messages.extend(TABLES.iter().map(|gap| refused(read(SCENE, MATRIX, gap, LOAD))));
    let Ok(Model::Body(body)) = read(SCENE, MATRIX, GAP, LOAD) else { panic!("a valid body") };
    messages.extend(
        ["i,gap\n1,0\n", "i,force\n3,0\n"].map(|answer| {
            parse_answers("answer.csv", answer, &body).expect_err("one thing is wrong in it").to_string()
        }),
    );
    assert_text!("body_messages", "Every message about a body", messages.join("\n\n"));
}

/// Both forms and both kinds are the same matrix, and what is left out is zero.
#[test]
fn every_way_to_write_a_matrix_is_read() {
    let head = "%%MatrixMarket matrix";
    let ways = [
        MATRIX.to_owned(),
        format!("{head} coordinate integer symmetric\n2 2 3\n2 2 2\n1 2 -1\n1 1 2\n"),
        format!("{head} coordinate real general\n2 2 4\n2 2 2\n1 2 -1\n1 1 2\n2 1 -1.00000000001\n"),
        format!("{head} array real general\n2 2\n2\n-1\n-1\n2\n"),
        format!("{head} array double symmetric\n2 2\n2\n-1\n2\n"),
    ];
    for matrix in ways {
        let Ok(Model::Body(body)) = read(SCENE, &matrix, GAP, LOAD) else { panic!("{matrix}") };
        let found = palkki::qp::Qp::matrix(body.program());
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| found.entry(i, j));
        let apart = entries.iter().zip([2.0, -1.0, -1.0, 2.0]).all(|(a, b)| (a - b).abs() < 1e-11);
        assert!(apart, "{entries:?} of {matrix}");
        // C load − gap.
        let linear = palkki::qp::Qp::linear(body.program());
        assert!((linear[0] + 1.5).abs() < 1e-11 && (linear[1] - 2.0).abs() < 1e-11, "{linear:?} of {matrix}");
    }
}
