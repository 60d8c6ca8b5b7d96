//! Matrix files as other programs write them: each is read as the same matrix.

use palkki::qp::Qp as _;
use palkki::scene::file::{Model, parse_model};
use palkki_evidence::texts::Files;

/// The same matrix in each layout that is read.
const LAYOUTS: [(&str, &str); 6] = [
    ("market.mtx", include_str!("../../corpus/layouts/market.mtx")),
    ("columns.txt", include_str!("../../corpus/layouts/columns.txt")),
    ("sized.txt", include_str!("../../corpus/layouts/sized.txt")),
    ("calculix.sti", include_str!("../../corpus/layouts/calculix.sti")),
    ("abaqus.mtx", include_str!("../../corpus/layouts/abaqus.mtx")),
    ("duplicates.mtx", include_str!("../../corpus/layouts/duplicates.mtx")),
];

fn read(matrix: &str, sums_duplicates: bool) -> Result<Vec<f64>, String> {
    let scene = format!("[body]\nstiffness = 'K'\nsum_duplicates = {sums_duplicates}\n");
    match parse_model("body.toml", &scene, &mut Files(&[("K", matrix)])) {
        Ok(Model::Body(body)) => {
            let found = body.program().matrix();
            Ok((0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| found.entry(i, j)).collect())
        }
        Ok(Model::Scene(_)) => Err("a beam".to_owned()),
        Err(error) => Err(error.to_string()),
    }
}

#[test]
fn every_layout_is_the_same_matrix() {
    for (name, matrix) in LAYOUTS {
        let found = read(matrix, true);
        assert_eq!(found, Ok(vec![4.0, -1.0, 0.5, -1.0, 3.0, -1.0, 0.5, -1.0, 5.0]), "{name}");
        // Entries that add up have to be asked for.
        let found = read(matrix, false);
        match name {
            "duplicates.mtx" => assert!(found.is_err_and(|error| error.contains("sum_duplicates = true")), "{name}"),
            _ => assert!(found.is_ok(), "{name}: {found:?}"),
        }
    }
}

/// Three equal numbers are an entry where the count of the lines that follow is another one.
#[test]
fn a_first_line_is_a_size_only_if_it_counts_the_others() {
    let entries = ["3 3 5", "1 1 4", "2 2 3", "2 1 -1", "3 1 0.5", "3 2 -1"];
    let right = Ok(vec![4.0, -1.0, 0.5, -1.0, 3.0, -1.0, 0.5, -1.0, 5.0]);
    // Five lines follow, none of which has the last diagonal: it is an entry all the same.
    assert_eq!(read(&entries.join("\n"), false), right);
    let last = [&entries[1..], &entries[..1]].concat().join("\n");
    assert_eq!(read(&last, false), right);
    assert_eq!(read(&format!("3 3 6\n{last}"), false), right);
}
