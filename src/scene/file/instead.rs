//! Suggestions for keys that users of other programs write: the equivalent key of a scene file.

/// Keys with the same meaning in one kind of table, and the suggestion for them.
struct Instead {
    /// Path of the table without indices, for example `load.point[]`.
    table: &'static str,
    /// The keys in lower case.
    keys: &'static [&'static str],
    /// Known keys, each with a suggestion. The first suggestion whose key the table accepts is printed. An empty key is always
    /// accepted.
    write: &'static [(&'static str, &'static str)],
}

const INSTEAD: &[Instead] = &[
    Instead {
        table: "",
        keys: &["support", "supports", "bearings"],
        write: &[("", "write the supports as `supports = [{ at = … }]` in [beam]")],
    },
    Instead { table: "", keys: &["loads", "forces"], write: &[("load", "write the loads in the table [load]")] },
    Instead {
        table: "",
        keys: &["ground", "soil", "obstacle", "bed"],
        write: &[("foundation", "write the foundation in the table [foundation]")],
    },
    Instead {
        table: "",
        keys: &["length", "bending_stiffness", "shape", "joints", "tension"],
        write: &[("beam", "write it below the line [beam]")],
    },
    Instead {
        table: "",
        keys: &["uniform", "linear", "point", "couple"],
        write: &[("load", "write it below the line [load]")],
    },
    Instead {
        table: "",
        keys: &["depth", "polynomial", "cosine", "points", "survey", "stiffness"],
        write: &[("foundation", "write it below the line [foundation]")],
    },
    Instead {
        table: "beam",
        keys: &[
            "e",
            "i",
            "ei",
            "stiffness",
            "modulus",
            "youngs_modulus",
            "inertia",
            "second_moment",
            "section",
            "material",
        ],
        write: &[("bending_stiffness", "write the product EI as `bending_stiffness`, in force times length squared")],
    },
    Instead { table: "beam", keys: &["l", "span"], write: &[("length", "write the length as `length`")] },
    Instead {
        table: "beam",
        keys: &["hinge", "hinges", "joint", "releases"],
        write: &[
            ("joints", "write hinges as `joints = [{ at = … }]`"),
            ("", "hinges inside a beam are not supported yet"),
        ],
    },
    Instead {
        table: "beam",
        keys: &["compression", "axial", "axial_force", "prestress", "n"],
        write: &[("tension", "write the axial force as `tension`, negative for compression")],
    },
    Instead {
        table: "beam",
        keys: &["weight", "self_weight", "selfweight", "mass", "density", "gravity", "load", "q", "uniform"],
        write: &[("", "write the weight per length as `uniform` in [load], with its other loads")],
    },
    Instead {
        table: "beam",
        keys: &["camber", "precamber", "temperature", "gradient", "shrinkage", "imperfection", "curvature"],
        write: &[(
            "shape",
            "write the shape of the unloaded beam as `shape`, for example `shape = { polynomial = [0, 0, c/2] }` for the curvature c",
        )],
    },
    Instead {
        table: "beam",
        keys: &["support", "bearings", "fixed", "pinned", "clamped", "built_in"],
        write: &[("supports", "write the supports as `supports = [{ at = …, built_in = true }, { at = … }]`")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["x", "position", "pos", "place"],
        write: &[("at", "write the position as `at`")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["fixed", "clamped", "encastre", "type", "kind"],
        write: &[("built_in", "write `built_in = true` for a fixed support; a support without it lets the beam turn")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["settlement", "depth", "z", "y", "height", "gap", "play"],
        write: &[("level", "write the level of the support as `level`, positive downwards")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["compression_only", "no_tension", "unilateral", "one_sided", "lift_off", "uplift"],
        write: &[("pushes_only", "write `pushes_only = true` for a support that cannot hold the beam down")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["rotation", "angle"],
        write: &[("slope", "write the slope of a fixed support as `slope`, with `built_in = true`")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["spring", "k", "kz"],
        write: &[("stiffness", "write the stiffness of the support as `stiffness`, a force per length")],
    },
    Instead {
        table: "beam.supports[]",
        keys: &["rotational_stiffness", "k_rot", "kr"],
        write: &[(
            "turning_stiffness",
            "write the rotational stiffness as `turning_stiffness`, a moment per unit of slope",
        )],
    },
    Instead {
        table: "load",
        keys: &["moment", "moments", "couples", "torque"],
        write: &[
            ("couple", "write a moment M at x as `couple = [{ at = x, moment = M }]`"),
            (
                "",
                "moments are not supported yet; write a moment M at x as two forces a small distance d apart: \
                 `point = [{ at = x - d/2, force = -M/d }, { at = x + d/2, force = M/d }]`",
            ),
        ],
    },
    Instead {
        table: "load",
        keys: &["weight", "self_weight", "selfweight", "dead", "q", "w", "distributed", "line"],
        write: &[(
            "uniform",
            "write a constant load per length as `uniform`; parts of the beam are loaded by `linear`",
        )],
    },
    Instead {
        table: "load",
        keys: &["temperature", "gradient", "shrinkage", "prestress"],
        write: &[(
            "",
            "write a temperature gradient, or shrinkage, as the shape of the unloaded beam: `shape = { polynomial = [0, 0, c/2] }` in \
             [beam] for the curvature c",
        )],
    },
    Instead {
        table: "load",
        keys: &["points", "force", "forces", "concentrated", "p", "f"],
        write: &[("point", "write concentrated forces as `point = [{ at = …, force = … }]`")],
    },
    Instead {
        table: "load",
        keys: &["trapezoid", "trapezoidal", "triangular", "partial"],
        write: &[("linear", "write a linear load as `linear = [{ from = …, to = …, start = …, end = … }]`")],
    },
    Instead {
        table: "load.point[]",
        keys: &["x", "position", "pos", "place"],
        write: &[("at", "write the position as `at`")],
    },
    Instead {
        table: "load.point[]",
        keys: &["p", "f", "load", "magnitude", "value", "weight"],
        write: &[("force", "write the force as `force`, positive downwards")],
    },
    Instead {
        table: "load.point[]",
        keys: &["moment", "couple"],
        write: &[(
            "",
            "a point force has no moment; write a moment M at x as `couple = [{ at = x, moment = M }]` in [load]",
        )],
    },
    Instead {
        table: "foundation",
        keys: &["k", "modulus", "subgrade", "winkler", "spring", "bedding"],
        write: &[(
            "stiffness",
            "write the stiffness of the foundation as `stiffness`, a force per length squared: modulus times width",
        )],
    },
    Instead {
        table: "foundation",
        keys: &["elevation", "elevations", "level", "levels", "height", "gap", "z"],
        write: &[(
            "depth",
            "write the depth below the line of the supports: depth = datum - elevation. A survey of elevations is read as \
             `survey = { file = …, x = …, elevation = …, datum = … }`",
        )],
    },
    Instead {
        table: "foundation",
        keys: &["file", "csv", "profile"],
        write: &[("survey", "write the name of the CSV file as `survey`")],
    },
    Instead {
        table: "foundation",
        keys: &["friction", "mu", "cohesion"],
        write: &[("", "friction is not part of the model")],
    },
];

/// The suggestion for `key` in the table with this path, which accepts the keys `known`.
pub(super) fn instead(key: &str, table: &str, known: &[&str]) -> Option<&'static str> {
    let path = without_indices(table);
    let key = key.to_lowercase();
    let found = INSTEAD.iter().find(|instead| instead.table == path && instead.keys.contains(&&*key))?;
    found.write.iter().find(|(real, _)| real.is_empty() || known.contains(real)).map(|(_, text)| *text)
}

/// The path without indices, for example `load.point[]` for `load.point[2]`.
fn without_indices(path: &str) -> String {
    path.chars().filter(|c| !c.is_ascii_digit()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::file::{ReadProblem, parse};

    /// A scene with this key in a table; the value is never read.
    fn scene(table: &str, key: &str) -> String {
        let key = format!("{key} = 0");
        match table {
            "" => format!("{key}\n[beam]\nlength = 1\nbending_stiffness = 1\n"),
            "beam" => format!("[beam]\nlength = 1\nbending_stiffness = 1\n{key}\n"),
            "beam.supports[]" => {
                format!("[beam]\nlength = 1\nbending_stiffness = 1\nsupports = [{{ at = 0 }}, {{ at = 1, {key} }}]\n")
            }
            "load.point[]" => {
                format!("[beam]\nlength = 1\nbending_stiffness = 1\n[load]\npoint = [{{ at = 0, force = 1, {key} }}]\n")
            }
            table => format!("[beam]\nlength = 1\nbending_stiffness = 1\n[{table}]\n{key}\n"),
        }
    }

    /// Each of these keys leads to its suggestion, in lower and upper case, and none of them is a known key.
    #[test]
    fn keys_of_other_programs_are_answered_with_what_to_write() {
        let mut asked = 0;
        for Instead { table, keys, write } in INSTEAD {
            for key in keys.iter().flat_map(|key| [(*key).to_owned(), key.to_uppercase()]) {
                let Err(error) = parse("scene.toml", &scene(table, &key), |_| Err(ReadProblem::Missing)) else {
                    panic!("{key} is known in {table:?}")
                };
                let message = error.to_string();
                assert!(message.contains("unknown key"), "{message}");
                let help = error.problem.help().unwrap_or_else(|| panic!("{key} in {table:?} has no help: {message}"));
                assert!(write.iter().any(|(_, text)| *text == help) && message.contains(&help), "{message}");
                asked += 1;
            }
        }
        assert!(250 < asked, "{asked}");
        let unheard = parse("scene.toml", &scene("load", "frobnicate"), |_| Err(ReadProblem::Missing));
        assert_eq!(unheard.expect_err("an unknown key").problem.help(), None);
    }

    #[test]
    fn a_key_is_in_one_row_of_a_table() {
        for (i, row) in INSTEAD.iter().enumerate() {
            for other in INSTEAD[..i].iter().filter(|other| other.table == row.table) {
                let twice: Vec<_> = row.keys.iter().filter(|key| other.keys.contains(key)).collect();
                assert!(twice.is_empty(), "{twice:?} in {:?}", row.table);
            }
        }
    }
}
