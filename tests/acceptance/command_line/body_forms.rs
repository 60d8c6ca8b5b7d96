//! Bodies as practice has them: gaps without ground, stiff freedoms beside soft ones, beams that are exported.

use std::fmt::Write as _;

use serde_json::Value;

use super::Folder;
use super::body::numbers;

/// A body of three springs in a row, without ground in the middle.
fn springs(folder: &Folder, far: &str) {
    folder.write(
        "K.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n3 3 5\n1 1 2e6\n2 1 -1e6\n2 2 2e6\n3 2 -1e6\n3 3 2e6\n",
    );
    folder.write("gap.csv", format!("i,gap\n1,0.001\n2,{far}\n3,0.001\n"));
    folder.write("load.csv", "i,force\n1,5000\n2,3000\n3,5000\n");
    folder.write("body.toml", "[body]\nstiffness = 'K.mtx'\ngap = 'gap.csv'\nload = 'load.csv'\n");
}

/// However "no ground" is written, the other two carry 5500 each, and no other forces are certified.
#[test]
fn a_gap_without_ground_hides_no_force() {
    let folder = Folder::new("body_far");
    for (far, clearance) in [("1e9", "999999999.9975"), ("1e20", "1e20"), ("1e30", "1e30"), ("inf", "inf")] {
        springs(&folder, far);
        let (code, _, json) = folder.json("solve body.toml");
        assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")), "{far}: {json}");
        let forces = numbers(&json["nodes"]["contact_force"]);
        let right = [5500.0, 0.0, 5500.0];
        assert!(forces.iter().zip(right).all(|(p, right)| (p - right).abs() < 1e-8), "{far}: {forces:?}");
        assert_eq!(json["nodes"]["clearance"][1].is_null(), far == "inf");
        for (answer, code) in [
            ("i,force\n1,5500\n3,5500\n".to_owned(), 0),
            ("i,force\n".to_owned(), 1),
            ("i,force\n1,5500.1\n3,5500\n".to_owned(), 1),
            (format!("i,clearance\n2,{clearance}\n"), 0),
            (format!("i,clearance\n1,0.0001\n2,{clearance}\n"), 1),
            ("i,clearance\n2,5\n".to_owned(), if far == "inf" { 2 } else { 1 }),
        ] {
            folder.write("answer.csv", &answer);
            let run = folder.run("certify body.toml answer.csv");
            assert_eq!(run.code, Some(code), "{far}, {answer}: {} {}", run.out, run.err);
        }
    }
    assert_eq!(folder.run("solve body.toml --csv answer.csv").code, Some(0));
    assert!(folder.read("answer.csv").lines().nth(2).is_some_and(|row| row.starts_with("2,inf,0")), "infinite gap");
    // What is not listed has no ground either, where its gap is infinite.
    folder.write("answer.csv", "i,clearance\n");
    assert_eq!(folder.run("certify body.toml answer.csv").code, Some(0));
    folder.write("gap.csv", "i,gap\n2,-inf\n");
    assert!(folder.refused("solve body.toml").contains("`gap` must be a finite number"));
}

/// Clearances hardly change where a freedom is stiff; its force does.
#[test]
fn forces_on_stiff_freedoms_are_asked() {
    let folder = Folder::new("body_stiff");
    folder.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1e10\n2 2 1e3\n");
    folder.write("gap.csv", "i,gap\n1,0\n2,0.1\n");
    folder.write("load.csv", "i,force\n1,100\n");
    folder.write("body.toml", "[body]\nstiffness = 'K.mtx'\ngap = 'gap.csv'\nload = 'load.csv'\n");
    for (answer, code, off) in [
        ("i,force\n", 1, 100.0),
        ("i,force\n1,100\n", 0, 0.0),
        ("i,force\n1,95.4\n2,-4.6\n", 1, 4.6),
        ("i,clearance\n2,0.1\n", 0, 0.0),
        ("i,clearance\n1,-1e-8\n2,0.1\n", 1, 100.0),
    ] {
        folder.write("answer.csv", answer);
        let (exit, _, json) = folder.json("certify body.toml answer.csv");
        assert_eq!(exit, Some(code), "{answer}: {json}");
        let error = json["certificate"]["force_error"].as_f64().unwrap_or(f64::NAN);
        assert!((error - off).abs() < 1e-9, "{answer}: {json}");
        let violations = json["violations"].as_array().map_or(0, Vec::len);
        assert!(code == 1 || violations == 0, "{answer}: {json}");
    }
}

/// A beam that nothing holds has a singular stiffness, whatever rounding makes of it.
#[test]
fn no_singular_stiffness_is_exported() {
    let folder = Folder::new("body_unheld");
    for supports in ["[]", "[{ at = 4 }]"] {
        for stiffness in ["", "stiffness = 50.0\n"] {
            let scene = format!(
                "[beam]\nlength = 10\nbending_stiffness = 1.3\nsupports = {supports}\n[load]\nuniform = 1\n[foundation]\ndepth = 0.0\n{stiffness}"
            );
            folder.write("unheld.toml", scene);
            for method in ["force", "displacement", "complementarity"] {
                for intervals in [10, 15, 30, 65] {
                    let intervals = if supports == "[]" { intervals } else { intervals / 5 * 5 };
                    let route = format!("export unheld.toml --method {method} --intervals {intervals} --to out");
                    let message = folder.refused(&route);
                    assert!(message.contains("free to move as a whole"), "{route}: {message}");
                    assert_eq!(folder.run(&format!("{route} --form sparse")).code, Some(0), "{route}");
                }
            }
        }
    }
}

/// Intervals of the grid that is exported, their length, and the bending stiffness.
const GRID: (u8, f64, f64) = (8, 1.25, 1.302_083_333_333_333_3);

/// What `solve` prints of the difference equations.
struct Solved {
    deflection: Vec<f64>,
    clearance: Vec<f64>,
    contact_force: Vec<f64>,
    energy: f64,
    /// How far a spring of the foundation is compressed by a unit force.
    give: f64,
}

impl Solved {
    fn of(folder: &Folder, scene: &str) -> Self {
        let (_, _, json) = folder.json(&format!("solve {scene}.toml --method complementarity --intervals {}", GRID.0));
        let nodes = |key: &str| numbers(&json["nodes"][key]);
        Self {
            deflection: nodes("deflection"),
            clearance: nodes("clearance"),
            contact_force: nodes("contact_force"),
            energy: json["energy"].as_f64().expect("an energy"),
            give: if scene == "soft" { 1.0 / (50.0 * GRID.1) } else { 0.0 },
        }
    }

    /// The value of a variable by its name.
    fn value(&self, what: &str) -> f64 {
        let place: f64 = what.split("x = ").nth(1).and_then(|rest| rest.split(' ').next()).map_or(f64::NAN, parsed);
        let node = (1..GRID.0).find(|i| (f64::from(*i) * GRID.1 - place).abs() < 1e-12).expect("a node");
        let at =
            |values: &[f64], i: u8| i.checked_sub(1).and_then(|i| values.get(usize::from(i))).copied().unwrap_or(0.0);
        let v = |i: u8| at(&self.deflection, i);
        let compressed = self.give * at(&self.contact_force, node);
        match what.split(' ').next() {
            Some("moment") => -GRID.2 * (v(node - 1) - 2.0 * v(node) + v(node + 1)) / GRID.1 / GRID.1,
            Some("penetration") => compressed,
            Some("clearance") => {
                assert_eq!(what.starts_with("clearance of the beam"), 0.0 < self.give, "{what}");
                at(&self.clearance, node) + compressed
            }
            _ => panic!("{what}"),
        }
    }
}

fn parsed(text: &str) -> f64 {
    text.parse().unwrap_or(f64::NAN)
}

/// A row or a column, from 1, as an index.
fn index(text: &str) -> usize {
    text.parse::<usize>().expect("a whole number") - 1
}

/// Exports a form, and returns the names of its variables.
fn exported(folder: &Folder, scene: &str, form: &str) -> Vec<String> {
    let command =
        format!("export {scene}.toml --method complementarity --intervals {} --form {form} --to {scene}", GRID.0);
    assert_eq!(folder.run(&command).code, Some(0));
    let names = folder.read(&format!("{scene}/names.csv"));
    names.lines().skip(1).map(|line| line.split_once(',').expect("a name").1.to_owned()).collect()
}

/// Two scenes, on rigid ground and on springs.
fn beams(folder: &Folder) -> [&'static str; 2] {
    let soft = folder.read("ridge.toml").replace("[foundation]\n", "[foundation]\nstiffness = 50.0\n");
    folder.write("soft.toml", soft);
    ["ridge", "soft"]
}

/// What `solve` prints, in the units that `names.csv` gives, satisfies the equations of the sparse form.
#[test]
fn units_of_a_sparse_form_are_those_of_solve() {
    let folder = Folder::new("body_units");
    for scene in beams(&folder) {
        let solved = Solved::of(&folder, scene);
        let names = exported(&folder, scene, "sparse");
        let named = names.iter().map(|name| name.split_once(" in units of ").expect("a unit"));
        let z: Vec<f64> = named.map(|(what, unit)| solved.value(what) / parsed(unit)).collect();
        let bounds = folder.read(&format!("{scene}/bounds.csv"));
        let mut product = vec![0.0; bounds.lines().count() - 1];
        for line in folder.read(&format!("{scene}/A.mtx")).lines().skip(2) {
            let entry: Vec<&str> = line.split(' ').collect();
            product[index(entry[0])] += parsed(entry[2]) * z[index(entry[1])];
        }
        for (row, found) in bounds.lines().skip(1).zip(product) {
            let row: Vec<f64> = row.split(',').map(parsed).collect();
            assert!(row[1] - 1e-9 <= found && found <= row[2] + 1e-9, "{scene}, row {row:?}: {found}");
        }
    }
}

/// In the file for other solvers variables have no units of their own: what `solve` prints satisfies its equations, and the objective is the
/// energy with that of the loads at the level of the ground.
#[test]
fn a_program_in_mps_has_the_numbers_of_solve() {
    let folder = Folder::new("body_mps");
    for scene in beams(&folder) {
        let solved = Solved::of(&folder, scene);
        let x: Vec<f64> = exported(&folder, scene, "qps").iter().map(|what| solved.value(what)).collect();
        let (mut rows, mut objective, mut section) = (std::collections::BTreeMap::new(), 0.0, String::new());
        let text = folder.read(&format!("{scene}/program.mps"));
        for line in text.lines() {
            let fields: Vec<&str> = line.split_whitespace().collect();
            match (line.starts_with(' '), section.as_str(), &fields[..]) {
                (false, ..) => section = fields[0].to_owned(),
                (_, "COLUMNS", [of, "energy", value]) => objective += parsed(value) * x[index(&of[1..])],
                (_, "COLUMNS", [of, row, value]) => {
                    *rows.entry(*row).or_insert(0.0) += parsed(value) * x[index(&of[1..])]
                }
                (_, "RHS", [_, row, value]) => *rows.entry(*row).or_insert(0.0) -= parsed(value),
                (_, "QUADOBJ", [one, other, value]) => {
                    let share = if one == other { 0.5 } else { 1.0 };
                    objective += share * parsed(value) * x[index(&one[1..])] * x[index(&other[1..])];
                }
                (_, "BOUNDS", [kind, _, of]) => assert!(*kind == "FR" && index(&of[1..]) < x.len() - 7, "{line}"),
                (_, "ROWS", _) => {}
                _ => panic!("{line}"),
            }
        }
        assert!(text.ends_with("\nENDATA\n") && section == "ENDATA" && rows.len() >= 7, "{text}");
        assert!(rows.values().all(|left| left.abs() < 1e-9), "{scene}: {rows:?}");
        // Depths are 1 but for the ridge, which is 0.5 deep at 4 and falls to 1 at 3 and 5.
        let depth = |i: u8| 1.0 - 0.5 * (1.0 - (f64::from(i) * GRID.1 - 4.0).abs()).max(0.0);
        let lowered: f64 = (1..GRID.0).map(|i| GRID.1 * depth(i)).sum();
        let off = objective - lowered - solved.energy;
        assert!(off.abs() < 1e-9 * lowered, "{scene}: {objective} and {}", solved.energy);
    }
}

/// Two thousand five hundred freedoms, all of which meet the first: eliminated last, it fills nothing.
#[test]
fn a_full_first_column_is_eliminated_last() {
    let folder = Folder::new("body_arrow");
    let n = 2500;
    let mut matrix = format!("%%MatrixMarket matrix coordinate real symmetric\n{n} {n} {}\n1 1 3000\n", 3 * n - 3);
    for i in 2..=n {
        let _ = writeln!(matrix, "{i} 1 -1\n{i} {i} 4");
        if 2 < i {
            let _ = writeln!(matrix, "{i} {} -1", i - 1);
        }
    }
    folder.write("K.mtx", matrix);
    let rows =
        |value: &dyn Fn(i32) -> f64| (1..=n).fold(String::new(), |text, i| text + &format!("{i},{:?}\n", value(i)));
    folder.write("gap.csv", "i,gap\n".to_owned() + &rows(&|i| if i % 7 == 0 { 0.1 } else { 1.0 }));
    folder.write("load.csv", "i,force\n".to_owned() + &rows(&|i| f64::from(i % 5) - 1.0));
    folder.write("body.toml", "[body]\nstiffness = 'K.mtx'\ngap = 'gap.csv'\nload = 'load.csv'\n");
    let (code, _, json) = folder.json("solve body.toml");
    assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")), "{json}");
    // In the order of the file one factorisation takes 2.6e9 products, and the whole run 14 s.
    assert!(json["seconds"].as_f64().is_some_and(|seconds| seconds < 10.0), "{json}");
}
