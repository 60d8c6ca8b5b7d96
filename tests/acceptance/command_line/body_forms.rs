//! Bodies as practice has them: gaps without ground, stiff freedoms beside soft ones, beams that are exported.

use std::fmt::Write as _;

use serde_json::Value;

use super::Folder;
use super::body::numbers;

/// A body of three springs in a row, without ground in the middle.
fn springs(folder: &Folder, far: &str) {
    folder.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n3 3 5\n1 1 2e6\n2 1 -1e6\n2 2 2e6\n3 2 -1e6\n3 3 2e6\n");
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

/// Rows `i,…` of a file without its header.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let fields = |row: &str| row.split([',', ' ']).map(|field| field.parse().unwrap_or(f64::NAN)).collect();
    text.lines().filter(|line| !line.starts_with('%')).skip(1).map(fields).collect()
}

/// What `solve` prints, in the units that `names.csv` gives, satisfies the equations of the sparse form.
#[test]
fn units_of_a_sparse_form_are_those_of_solve() {
    let folder = Folder::new("body_units");
    let soft = folder.read("ridge.toml").replace("[foundation]\n", "[foundation]\nstiffness = 50.0\n");
    folder.write("soft.toml", soft);
    let (n, spacing, stiffness) = (8, 1.25, 1.302_083_333_333_333_3);
    for scene in ["ridge", "soft"] {
        let (_, _, solved) = folder.json(&format!("solve {scene}.toml --method complementarity --intervals {n}"));
        let nodes = |key: &str| numbers(&solved["nodes"][key]);
        let (v, h, p) = (nodes("deflection"), nodes("clearance"), nodes("contact_force"));
        let at = |values: &[f64], i: usize| i.checked_sub(1).and_then(|i| values.get(i)).copied().unwrap_or(0.0);
        let moment = |i: usize| -stiffness * (at(&v, i - 1) - 2.0 * at(&v, i) + at(&v, i + 1)) / spacing / spacing;
        assert_eq!(folder.run(&format!("export {scene}.toml --method complementarity --intervals {n} --form sparse --to {scene}")).code, Some(0));
        let names = folder.read(&format!("{scene}/names.csv"));
        let mut seen = String::new();
        let z: Vec<f64> = names.lines().skip(1).map(|line| {
            let (what, unit) = line.split_once(" in units of ").expect("a unit");
            let place = what.split("x = ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a place");
            let i = (1..n).find(|i| f64::from(u8::try_from(*i).expect("small")) * spacing == place.parse::<f64>().expect("a number"));
            let (i, what) = (i.expect("a node"), what.split_once(',').expect("a name").1);
            let give = if scene == "soft" { 1.0 / (50.0 * spacing) } else { 0.0 };
            let _ = write!(seen, "{} ", what.split(' ').next().unwrap_or(""));
            let value = match what.split(' ').next() {
                Some("moment") => moment(i),
                Some("penetration") => give * at(&p, i),
                Some("clearance") => at(&h, i) + give * at(&p, i),
                _ => panic!("{what}"),
            };
            assert_eq!(what.starts_with("clearance of the beam"), scene == "soft" && what.starts_with("clearance"), "{what}");
            value / unit.parse::<f64>().expect("a number")
        }).collect();
        let (matrix, bounds) = (rows(&folder.read(&format!("{scene}/A.mtx"))), rows(&folder.read(&format!("{scene}/bounds.csv"))));
        let mut product = vec![0.0; bounds.len()];
        for entry in &matrix {
            let place = |k: usize| (1..=bounds.len().max(z.len())).find(|i| *i as f64 == entry[k]).expect("a place") - 1;
            product[place(0)] += entry[2] * z[place(1)];
        }
        for (row, found) in bounds.iter().zip(product) {
            assert!(row[1] - 1e-9 <= found && found <= row[2] + 1e-9, "{scene}, row {row:?}: {found}, {seen}");
        }
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
    let rows = |value: &dyn Fn(i32) -> f64| (1..=n).fold(String::new(), |text, i| text + &format!("{i},{:?}\n", value(i)));
    folder.write("gap.csv", "i,gap\n".to_owned() + &rows(&|i| if i % 7 == 0 { 0.1 } else { 1.0 }));
    folder.write("load.csv", "i,force\n".to_owned() + &rows(&|i| f64::from(i % 5) - 1.0));
    folder.write("body.toml", "[body]\nstiffness = 'K.mtx'\ngap = 'gap.csv'\nload = 'load.csv'\n");
    let (code, _, json) = folder.json("solve body.toml");
    assert_eq!((code, &json["status"]), (Some(0), &Value::from("certified")), "{json}");
    // In the order of the file one factorisation takes 2.6e9 products, and the whole run 14 s.
    assert!(json["seconds"].as_f64().is_some_and(|seconds| seconds < 10.0), "{json}");
}
