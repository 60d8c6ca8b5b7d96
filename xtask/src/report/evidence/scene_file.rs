//! The page of the scene file: its template has the keys and the examples, and the reader of scene files has to agree.

use std::ops::ControlFlow;

use palkki::scene::file::{Beside, Problem, ReadProblem, parse_model};

use super::prelude::*;
use crate::report::files;

/// The tables of the page in their order: a line with a key of the table in the place of `{}`, and one with an example.
const TABLES: [[&str; 2]; 15] = [
    ["{}", "{}"],
    ["units = { {} }", "{}"],
    ["beam.{}", "beam.{}"],
    ["beam.bending_stiffness = { {} }", "beam.{}"],
    ["beam.joints = [{ {} }]", "beam.{}"],
    ["beam.supports = [{ {} }]", "beam.{}"],
    ["load.{}", "load.{}"],
    ["load.linear = [{ {} }]", "load.{}"],
    ["load.point = [{ {} }]", "load.{}"],
    ["load.couple = [{ {} }]", "load.{}"],
    ["foundation.{}", "foundation.{}"],
    ["foundation.stiffness = { {} }", "foundation.{}"],
    ["foundation.cosine = { {} }", "foundation.{}"],
    ["foundation.survey = { {} }", "foundation.{}"],
    ["body.{}", "body.{}"],
];

pub(super) fn evidence(study: &Study<'_>) -> Result<Evidence, Cause> {
    let page = files::text(study.root, "report/templates/scene-file.md")?;
    for block in page.split("```toml\n").skip(1) {
        read(block.split("```").next().unwrap_or_default())?;
    }
    let tables = tables(&page);
    if tables.len() != TABLES.len() {
        return Err(format!("the page of the scene file has {} tables, not {}", tables.len(), TABLES.len()).into());
    }
    for (rows, [key, example]) in tables.iter().zip(TABLES) {
        let told: Vec<&str> = rows.iter().map(|row| row[0]).collect();
        let known = known(key)?;
        if told != known {
            return Err(format!("of `{key}` the page has the keys {told:?}, and the reader knows {known:?}").into());
        }
        for [key, line] in rows.iter().filter(|[_, line]| *line != "–") {
            if !line.contains(key) {
                return Err(format!("the example `{line}` is without its key `{key}`").into());
            }
            read(&file(&example.replace("{}", line)))?;
        }
    }
    Ok(Evidence::new(context! { keys => tables.iter().map(Vec::len).sum::<usize>() }))
}

/// Key and example, the first and the last cell, of the rows of each table.
fn tables(page: &str) -> Vec<Vec<[&str; 2]>> {
    let lines: Vec<&str> = page.lines().collect();
    let blocks = lines.chunk_by(|a, b| a.starts_with('|') == b.starts_with('|'));
    let tables = blocks.filter(|lines| lines[0].starts_with('|'));
    tables.map(|table| table.iter().skip(2).map(|row| ends(row)).collect()).collect()
}

fn ends(row: &str) -> [&str; 2] {
    let cells = row.trim_matches(['|', ' ']);
    let [first, last] = [cells.split(" | ").next(), cells.rsplit(" | ").next()];
    [first, last].map(|cell| cell.unwrap_or_default().trim_matches('`'))
}

/// The smallest file with this line.
fn file(line: &str) -> String {
    const LENGTH: &str = "beam.length = 10";
    const STIFFNESS: &str = "beam.bending_stiffness = 1";
    let beside: &[&str] = match line.split(" = ").next().unwrap_or_default() {
        "beam.length" => &[STIFFNESS],
        "beam.bending_stiffness" => &[LENGTH],
        "foundation.stiffness" => &[LENGTH, STIFFNESS, "foundation.depth = 1.0"],
        "body.gap" | "body.load" | "body.sum_duplicates" => &["body.stiffness = \"K.mtx\""],
        "body.foundation" => &["body.flexibility = \"C.mtx\""],
        key if key.starts_with("body.") => &[],
        _ => &[LENGTH, STIFFNESS],
    };
    format!("{line}\n{}", beside.join("\n"))
}

/// The keys that the reader knows beside one that it does not know, in this place.
fn known(place: &str) -> Result<Vec<&'static str>, Cause> {
    let text = file(&place.replace("{}", "unheard_of = 1"));
    match parse_model("scene.toml", &text, &mut Files).map_err(|error| error.problem) {
        Err(Problem::UnknownKey { known, .. }) => Ok(known.to_vec()),
        Err(other) => Err(format!("an unknown key in\n{text}\nis refused with: {other}").into()),
        Ok(_) => Err(format!("an unknown key is read in\n{text}").into()),
    }
}

/// Reads a scene file.
fn read(text: &str) -> Result<(), Cause> {
    let model = parse_model("scene.toml", text, &mut Files);
    model.map(drop).map_err(|error| format!("{}\n{text}", error.render(false)).into())
}

/// The files that examples name: surveys of two points, and one number in every other.
struct Files;

impl Beside for Files {
    fn text(&mut self, path: &str) -> Result<String, ReadProblem> {
        Ok(match path {
            "gap.csv" => "i,gap\n1,1\n",
            "load.csv" => "i,force\n1,1\n",
            "stations.csv" => "Chainage,Level\n1920,101\n1930,101\n",
            _ => "x,depth\n0,1\n10,1\n",
        }
        .to_owned())
    }

    fn lines(&mut self, _: &str, each: &mut dyn FnMut(&str) -> ControlFlow<()>) -> Result<(), ReadProblem> {
        // Nothing is left to read where it breaks off.
        let _ = ["%%MatrixMarket matrix array real symmetric", "1 1", "2"].into_iter().try_for_each(each);
        Ok(())
    }
}
