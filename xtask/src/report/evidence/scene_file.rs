//! The keys of a scene file. What they mean is written here; which there are, the reader of scene files says, and the two have to
//! agree.

use std::ops::ControlFlow;

use palkki::scene::file::{Beside, Model, Problem, ReadProblem, parse_model};

use super::prelude::*;

/// A key: what it is and its unit, what it is if it is left out, what it means, an example.
type Key = [&'static str; 5];

const FILE: &[Key] = &[
    ["title", "a line of text", "none", "what figures and tables call the scene", "title = \"A shelf\""],
    ["beam", "a table", "needed", "the beam", ""],
    ["load", "a table", "no load", "what the beam carries", ""],
    ["foundation", "a table", "no ground", "what lies below", ""],
    [
        "units",
        "a table",
        "none",
        "labels of figures and tables: `length` and `force`",
        "units = { length = \"m\", force = \"kN\" }",
    ],
];
const BEAM: &[Key] = &[
    ["length", "length", "needed", "l, positive", "length = 10.0"],
    [
        "bending_stiffness",
        "force · length²",
        "needed",
        "EI, positive, the same along the beam",
        "bending_stiffness = 1.3",
    ],
    [
        "shape",
        "a table",
        "straight",
        "w₀(x), the line of the beam before it is loaded",
        "shape = { points = [[0, 0], [5, 0.1], [10, 0]] }",
    ],
    [
        "supports",
        "an array of tables",
        "one at each end",
        "what holds the beam",
        "supports = [{ at = 0.0 }, { at = 6.0, level = 0.1 }]",
    ],
];
const SUPPORT: &[Key] = &[
    ["at", "length", "needed", "its place x", "supports = [{ at = 0.0 }, { at = 10.0 }]"],
    ["level", "length", "0", "how deep it stands", "supports = [{ at = 0.0 }, { at = 10.0, level = 0.1 }]"],
    [
        "built_in",
        "true or false",
        "false",
        "whether it holds the slope too",
        "supports = [{ at = 0.0, built_in = true }]",
    ],
    [
        "slope",
        "none",
        "0",
        "that slope, positive where the beam goes down to the right; only with `built_in`",
        "supports = [{ at = 0.0, built_in = true, slope = -0.01 }]",
    ],
    [
        "pushes_only",
        "true or false",
        "false",
        "whether it lets the beam lift off, a bearing without hold-down; above the ground; not with `built_in`",
        "supports = [{ at = 0.0 }, { at = 6.0, level = 0.1, pushes_only = true }]",
    ],
];
const LOAD: &[Key] = &[
    ["uniform", "force / length", "0", "along the whole beam", "uniform = 1.0"],
    [
        "linear",
        "an array of tables",
        "none",
        "line loads between two places, straight between two intensities",
        "linear = [{ from = 2.0, to = 5.0, start = 0.0, end = 1.0 }]",
    ],
    ["point", "an array of tables", "none", "forces at places", "point = [{ at = 5.0, force = 3.0 }]"],
];
const LINEAR: &[Key] = &[
    ["from", "length", "needed", "where it begins", "linear = [{ from = 2.0, to = 5.0, start = 1.0, end = 1.0 }]"],
    [
        "to",
        "length",
        "needed",
        "where it ends, to the right of `from`",
        "linear = [{ from = 0.0, to = 10.0, start = 1.0, end = 0.0 }]",
    ],
    [
        "start",
        "force / length",
        "needed",
        "the intensity at `from`",
        "linear = [{ from = 2.0, to = 5.0, start = 2.0, end = 1.0 }]",
    ],
    [
        "end",
        "force / length",
        "needed",
        "the intensity at `to`",
        "linear = [{ from = 2.0, to = 5.0, start = 0.0, end = -1.0 }]",
    ],
];
const POINT: &[Key] = &[
    ["at", "length", "needed", "its place x", "point = [{ at = 2.5, force = 1.0 }]"],
    ["force", "force", "needed", "how large it is; negative upwards", "point = [{ at = 5.0, force = -0.5 }]"],
];
const PROFILE: &[Key] = &[
    ["depth", "length", "–", "level ground", "depth = 1.0"],
    ["polynomial", "length / lengthᵏ", "–", "c₀ + c₁ x + c₂ x² + …", "polynomial = [1.5, -0.2, 0.02]"],
    ["cosine", "a table", "–", "a wave", "cosine = { mean = 1.0, amplitude = 0.3, wavelength = 5.0 }"],
    [
        "points",
        "an array of [x, depth]",
        "–",
        "straight lines between points from one end to the other; two at one x are a step",
        "points = [[0, 1.0], [4, 0.5], [10, 1.0]]",
    ],
    ["survey", "a file name", "–", "the same from a CSV file", "survey = \"levels.csv\""],
    [
        "stiffness",
        "force / length²",
        "rigid",
        "of ground only: how stiff its springs are, which cannot pull; beside one of the others",
        "stiffness = 100.0",
    ],
];
const COSINE: &[Key] = &[
    [
        "mean",
        "length",
        "needed",
        "the depth about which it swings",
        "cosine = { mean = 2.0, amplitude = 0.3, wavelength = 5.0 }",
    ],
    [
        "amplitude",
        "length",
        "needed",
        "how far it swings",
        "cosine = { mean = 1.0, amplitude = 0.1, wavelength = 5.0 }",
    ],
    [
        "wavelength",
        "length",
        "needed",
        "from crest to crest, positive",
        "cosine = { mean = 1.0, amplitude = 0.3, wavelength = 2.5 }",
    ],
    [
        "phase",
        "radians",
        "0",
        "how far it is moved",
        "cosine = { mean = 1.0, amplitude = 0.3, wavelength = 5.0, phase = 1.57 }",
    ],
];

const UNITS: &[Key] = &[
    ["length", "a line of text", "none", "the unit of lengths and depths", "units = { length = \"mm\" }"],
    ["force", "a line of text", "none", "the unit of forces", "units = { force = \"N\" }"],
];

const BODY: &[Key] = &[
    ["stiffness", "a file name", "needed, or `flexibility`", "K, a Matrix Market file", "stiffness = \"K.mtx\""],
    ["flexibility", "a file name", "needed, or `stiffness`", "C, the inverse of that", "flexibility = \"C.mtx\""],
    ["gap", "a file name", "all 0", "a CSV file `i,gap`: how far each freedom may move, i from 1", "gap = \"gap.csv\""],
    ["load", "a file name", "all 0", "a CSV file `i,force`", "load = \"load.csv\""],
    [
        "foundation",
        "a file name",
        "rigid",
        "the flexibility of the ground, only beside one of the body",
        "foundation = \"G.mtx\"",
    ],
];

/// The tables of the file: name in the template, its keys, and how a scene with something in it is written: what `{}` stands for.
const TABLES: &[(&str, &[Key], &str)] = &[
    ("file", FILE, "{}\n[beam]\nlength = 10\nbending_stiffness = 1\n"),
    ("beam", BEAM, "[beam]\nlength = 10\nbending_stiffness = 1\n{}\n"),
    ("support", SUPPORT, "[beam]\nlength = 10\nbending_stiffness = 1\nsupports = [{ {} }]\n"),
    ("load", LOAD, "[beam]\nlength = 10\nbending_stiffness = 1\n[load]\n{}\n"),
    ("linear", LINEAR, "[beam]\nlength = 10\nbending_stiffness = 1\n[load]\nlinear = [{ {} }]\n"),
    ("point", POINT, "[beam]\nlength = 10\nbending_stiffness = 1\n[load]\npoint = [{ {} }]\n"),
    ("profile", PROFILE, "[beam]\nlength = 10\nbending_stiffness = 1\n[foundation]\n{}\n"),
    ("units", UNITS, "[beam]\nlength = 10\nbending_stiffness = 1\n[units]\n{}\n"),
    ("body", BODY, "[body]\n{}\n"),
    ("cosine", COSINE, "[beam]\nlength = 10\nbending_stiffness = 1\n[foundation]\ncosine = { {} }\n"),
];

const SMALLEST: &str = "[beam]\nlength = 10.0\nbending_stiffness = 1.3";
const EXAMPLE: &str = "title = \"Two spans above waves\"

[beam]
length = 10.0
bending_stiffness = 1.3
supports = [{ at = 0.0, built_in = true }, { at = 6.0, level = 0.1 }]

[load]
uniform = 1.0
linear = [{ from = 2.0, to = 5.0, start = 0.0, end = 1.0 }]
point = [{ at = 8.0, force = 3.0 }]

[foundation]
cosine = { mean = 1.0, amplitude = 0.3, wavelength = 5.0 }

[units]
length = \"m\"
force = \"kN\"";

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    for text in [SMALLEST, EXAMPLE] {
        read(text)?;
    }
    let mut values = vec![("smallest", Value::from(SMALLEST)), ("example", Value::from(EXAMPLE))];
    for (name, keys, frame) in TABLES {
        let known = known(frame)?;
        let told: Vec<&str> = keys.iter().map(|key| key[0]).collect();
        if told != known {
            return Err(format!("of `{name}` the page has the keys {told:?}, and the reader knows {known:?}").into());
        }
        for [.., example] in keys.iter().filter(|key| !key[4].is_empty()) {
            let holds = |keys: &[Key], frame: &str| is_of(example, keys) && !frame.contains("{ {} }");
            let own = holds(keys, frame).then_some(frame);
            let frame = own.or_else(|| TABLES.iter().find(|(_, keys, frame)| holds(keys, frame)).map(|table| &table.2));
            let frame = frame.ok_or_else(|| format!("`{example}` begins with no key"))?;
            // A key of the frame itself is not there twice.
            let key = example.split_once(" =").map_or("", |(key, _)| key);
            let rest = frame.lines().filter(|line| !line.starts_with(&format!("{key} =")));
            let text = rest.collect::<Vec<_>>().join("\n").replace("{}", example);
            // A body has a matrix, and a stiffness has no ground with a flexibility.
            let matrix = match key {
                "stiffness" if text.contains("[foundation]") => "depth = 1.0\n",
                "gap" | "load" if text.starts_with("[body]") => "stiffness = \"K.mtx\"\n",
                "foundation" if text.starts_with("[body]") => "flexibility = \"C.mtx\"\n",
                _ => "",
            };
            read(&(text + "\n" + matrix))?;
        }
        let rows = keys.iter().map(|[key, kind, default, meaning, example]| {
            let example = if example.is_empty() { "–".to_owned() } else { format!("`{example}`") };
            row![format!("`{key}`"), kind, default, meaning, example]
        });
        let header = ["key", "what it is, unit", "if left out", "meaning", "example"];
        values.push((name, Table::new(header).rows(rows).into()));
    }
    Ok(Evidence::new(Value::from_pairs(values)))
}

/// Whether a line sets one of these keys.
fn is_of(example: &str, keys: &[Key]) -> bool {
    keys.iter().any(|key| example.starts_with(&format!("{} =", key[0])))
}

/// Reads a scene file. A survey beside it has two points, and every other file one number.
fn read(text: &str) -> Result<Model, Cause> {
    parse_model("scene.toml", text, &mut Files).map_err(|error| format!("{}\n{text}", error.render(false)).into())
}

/// The files that examples name.
struct Files;

impl Beside for Files {
    fn text(&mut self, path: &str) -> Result<String, ReadProblem> {
        Ok(match path {
            "gap.csv" => "i,gap\n1,1\n",
            "load.csv" => "i,force\n1,1\n",
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

/// The keys that the reader knows where `frame` has a key that it does not know.
fn known(frame: &str) -> Result<Vec<&'static str>, Cause> {
    let text = frame.replace("{}", "unheard_of = 1");
    match parse_model("scene.toml", &text, &mut Files) {
        Err(error) => match error.problem {
            Problem::UnknownKey { known, .. } => Ok(known.to_vec()),
            other => Err(format!("an unknown key in\n{text}\nis refused with: {other}").into()),
        },
        Ok(_) => Err(format!("an unknown key is read in\n{text}").into()),
    }
}
