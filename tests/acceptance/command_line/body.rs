//! Any elastic body: what a program brings back for an exported beam, and for an instance with a known answer.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use palkki_evidence::compare::apart;
use serde_json::Value;

use super::Folder;

/// Numbers of a list.
pub(super) fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
}

/// `i,quantity`.
fn csv(quantity: &str, values: &[f64]) -> String {
    (1..).zip(values).fold(format!("i,{quantity}\n"), |mut text, (i, value)| {
        let _ = writeln!(text, "{i},{value:?}");
        text
    })
}

/// What rounding of its entries makes of a matrix: 16 digits less those of its condition, some 1e5 on 30 intervals, 1e7 on 100 and 1e9
/// on 300.
const ROUNDING: [(usize, f64); 3] = [(30, 1e-11), (100, 1e-9), (300, 1e-7)];

/// The program of each method, solved as a body without a beam, is that of the beam.
#[test]
fn an_exported_beam_is_the_same_body() {
    let folder = Folder::new("body_exported");
    for method in ["force", "displacement", "complementarity"] {
        for (intervals, rounding) in ROUNDING {
            let to = format!("{method}-{intervals}");
            let route = format!("--method {method} --intervals {intervals}");
            assert_eq!(folder.run(&format!("export ridge.toml {route} --to {to}")).code, Some(0));
            let (_, _, beam) = folder.json(&format!("solve ridge.toml {route}"));
            let (code, _, body) = folder.json(&format!("solve {to}/body.toml"));
            assert_eq!((code, &body["status"]), (Some(0), &Value::from("certified")), "{to}");
            assert_eq!(body["unknowns"], intervals - 1);
            for (quantity, size) in [("clearance", 1.0), ("contact_force", 10.0)] {
                let (a, b) = (numbers(&beam["nodes"][quantity]), numbers(&body["nodes"][quantity]));
                assert_eq!((a.len(), b.len()), (intervals - 1, intervals - 1), "{to}");
                let off = apart(&a, &b);
                assert!(off <= rounding * size, "{to}: {quantity} differs by {off:.1e}");
            }
            // What the beam found is brought back, as clearances or as forces.
            for (quantity, of) in [("clearance", "clearance"), ("contact_force", "force")] {
                folder.write("answer.csv", csv(of, &numbers(&beam["nodes"][quantity])));
                let (_, _, found) = folder.json(&format!("certify {to}/body.toml answer.csv"));
                let off = numbers(&found["off"]);
                let most = if of == "force" { 1e3 * rounding } else { rounding };
                assert!(off.len() == 2 && off[0] <= off[1] && off[1] <= most, "{to} {of}: {found}");
            }
        }
    }
    let units = folder.read("force-30/body.toml");
    assert!(units.ends_with("[units]\nlength = \"m\"\nforce = \"kN\"\n"), "{units}");
}

/// The sparse form has a row for each equation and each sign, and says what its variables are.
#[test]
fn a_sparse_form_is_whole() {
    let folder = Folder::new("body_sparse");
    let command = "export ridge.toml --method force --intervals 8 --form sparse --to program";
    assert_eq!(folder.run(command).code, Some(0));
    let read = |name: &str| folder.read(&format!("program/{name}"));
    // Seven moments and seven forces, with seven equations of balance and seven signs.
    assert!(read("P.mtx").lines().nth(1).is_some_and(|line| line.starts_with("14 14 ")));
    assert!(read("A.mtx").lines().nth(1).is_some_and(|line| line.starts_with("14 14 ")));
    let lines = |name: &str| read(name).lines().count();
    assert_eq!([lines("q.csv"), lines("bounds.csv"), lines("names.csv")], [15; 3]);
    assert!(read("names.csv").starts_with("i,what\n1,moment at x = 1.25 in units of "));
    assert!(read("bounds.csv").ends_with("14,0.0,inf\n"));
}

/// Where nothing can be proven of a matrix no answer of any solver is certified, and that is what comes back.
#[test]
fn a_comparison_without_a_certified_answer_fails() {
    let folder = Folder::new("body_unproven");
    folder.write("K.mtx", "%%MatrixMarket matrix array real general\n2 2\n1\n1\n1\n1.0000000000000002\n");
    folder.write("load.csv", "i,force\n1,1\n2,-1\n");
    folder.write("body.toml", "[body]\nstiffness = 'K.mtx'\nload = 'load.csv'\n");
    for command in ["compare body.toml", "compare body.toml --format json", "solve body.toml"] {
        assert_eq!(folder.run(command).code, Some(1), "{command}");
    }
    let (_, text, _) = folder.json("compare body.toml");
    assert!(!text.contains("\"certified\""), "{text}");
}

/// On ground that gives the programs of clearances have what the springs are pressed by as variables besides, and say so.
#[test]
fn a_sparse_form_names_its_springs() {
    let folder = Folder::new("body_sparse_soft");
    let soft = folder.read("ridge.toml").replace("[foundation]\n", "[foundation]\nstiffness = 50.0\n");
    folder.write("soft.toml", soft);
    for method in ["complementarity", "displacement", "force"] {
        let command = format!("export soft.toml --method {method} --intervals 8 --form sparse --to {method}");
        assert_eq!(folder.run(&command).code, Some(0));
        let names = folder.read(&format!("{method}/names.csv"));
        let matrix = folder.read(&format!("{method}/P.mtx"));
        let variables = names.lines().count() - 1;
        let size = format!("{variables} {variables} ");
        assert!(matrix.lines().nth(1).is_some_and(|line| line.starts_with(&size)), "{method}: {matrix}");
        let springs = names.lines().filter(|name| name.contains("penetration at")).count();
        assert_eq!(springs, if method == "force" { 0 } else { 7 }, "{method}: {names}");
    }
}

/// Six freedoms of the five-diagonal matrix: three are lifted off by 1, one just touches, two are pressed by 1.
pub(super) fn known(folder: &Folder) {
    folder.write(
        "K.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n6 6 15\n1 1 6\n2 2 6\n3 3 6\n4 4 6\n5 5 6\n6 6 6\n2 1 -4\n3 2 -4\n4 3 -4\n5 4 -4\n6 5 -4\n3 1 1\n4 2 1\n5 3 1\n6 4 1\n",
    );
    folder.write("load.csv", "i,force\n1,-3\n2,2\n3,-3\n4,3\n5,0\n6,1\n");
    folder.write("body.toml", "title = 'Six freedoms'\n[body]\nstiffness = 'K.mtx'\nload = 'load.csv'\n");
}

#[test]
fn a_wrong_answer_is_refused_and_bounded_from_both_sides() {
    let folder = Folder::new("body_wrong");
    known(&folder);
    let (code, _, json) = folder.json("solve body.toml");
    assert_eq!((code, &json["status"], &json["method"]), (Some(0), &"certified".into(), &"displacement".into()));
    assert_eq!(numbers(&json["nodes"]["clearance"]), [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(numbers(&json["nodes"]["contact_force"]), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
    let bounds = ["energy_lower", "energy_upper", "gap", "error"].map(|key| json["certificate"][key].as_f64());
    assert!(bounds.iter().all(Option::is_some), "{json}");
    for (answer, off, code, violated) in [
        ("i,clearance\n1,1\n2,1\n3,1\n", 0.0, 0, &[][..]),
        ("i,clearance\n1,1\n2,1.25\n3,1\n", 0.25, 1, &[]),
        ("i,clearance\n1,1\n2,1\n3,1\n6,-0.5\n", 0.5, 1, &["penetration"]),
        ("i,force\n5,1\n6,1\n", 0.0, 0, &[]),
        // The largest entry of K⁻¹ e₆ is 5/6, by elimination in fractions.
        ("i,force\n5,1\n6,1.5\n", 0.5 * 5.0 / 6.0, 1, &["complementarity"]),
        ("i,force\n5,1\n6,-0.5\n", 1.5 * 5.0 / 6.0, 1, &["penetration", "tension"]),
    ] {
        folder.write("answer.csv", answer);
        let (exit, _, json) = folder.json("certify body.toml answer.csv");
        assert_eq!(exit, Some(code), "{answer}: {json}");
        let bounds = numbers(&json["off"]);
        assert!(
            bounds[0] <= off + 1e-15 && off <= bounds[1] + 1e-15 && bounds[1] - bounds[0] < 1e-12,
            "{answer}: {json}"
        );
        let found = json["violations"].as_array().cloned().unwrap_or_default();
        let found: Vec<_> = found.iter().filter_map(|violation| violation["condition"].as_str()).collect();
        assert_eq!(found, violated, "{answer}");
        let text = folder.run("certify body.toml answer.csv").out;
        assert!(code == 0 || text.starts_with("not-certified: the error of the clearances is at least "), "{text}");
    }
}

#[test]
fn all_solvers_are_compared() {
    let folder = Folder::new("body_compared");
    known(&folder);
    let (code, _, json) = folder.json("compare body.toml");
    let routes = json["routes"].as_array().cloned().unwrap_or_default();
    assert_eq!((code, routes.len()), (Some(0), palkki::route::Solver::ALL.len()));
    for route in &routes {
        let off = numbers(&route["off"]);
        assert!(off.len() == 2 && route["residual"].is_number(), "{route}");
        assert_eq!(route["status"] == "certified", off[1] <= 1e-6, "{route}");
    }
    folder.run("solve body.toml --csv nodes.csv --nodes");
    let table = folder.read("nodes.csv");
    assert_eq!(table.lines().nth(6), Some("6,0.0,1.0"));
}

/// What belongs to a beam is refused by name.
#[test]
fn options_of_beams_are_refused() {
    let folder = Folder::new("body_options");
    known(&folder);
    folder.write("answer.csv", "i,force\n");
    for command in [
        "solve body.toml --method force",
        "solve body.toml --intervals 30",
        "solve body.toml --derivatives",
        "solve body.toml --plot body.svg",
        "certify body.toml answer.csv --load nodal",
        "sweep body.toml --vary load.uniform --from 0 --to 1",
        "export body.toml --method force --to folder",
    ] {
        assert!(folder.refused(command).contains("[body]"), "{command}");
    }
}

/// The instances of `report/scenes/bodies`: each is solved, and the answer beside it is proven to be the optimum.
#[test]
fn every_instance_has_a_proven_answer() {
    let folder = Folder::new("body_instances");
    let bodies = Path::new(env!("CARGO_MANIFEST_DIR")).join("report/scenes/bodies");
    let files = fs::read_dir(&bodies).expect("the instances").map(|entry| entry.expect("an entry").path());
    let scenes: Vec<_> = files.filter(|path| path.extension().is_some_and(|extension| extension == "toml")).collect();
    assert!(4 <= scenes.len(), "{scenes:?}");
    for scene in scenes {
        let (name, answer) = (scene.display(), scene.with_extension("answer.csv"));
        let (code, _, solved) = folder.json(&format!("solve {name}"));
        assert_eq!(code, Some(0), "{solved}");
        let (code, _, found) = folder.json(&format!("certify {name} {}", answer.display()));
        let off = numbers(&found["off"]);
        // To the nearest number of 64 bits.
        assert!(code == Some(0) && off[1] < 1e-15, "{found}");
    }
}
