//! Surveys as people have them: twenty files of our own making, each read to the same ground, or refused with the line to write.

use palkki::scene::Foundation;
use palkki::scene::file::{FileError, parse};

/// The ground that all of the files describe: chainages from 1920 to 1930, elevations below a datum of 102.35.
const GROUND: [[f64; 2]; 6] = [[0.0, 1.15], [2.5, 1.2], [4.0, 0.75], [4.0, 1.25], [7.68, 0.9], [10.0, 1.3]];
const ORIGIN: &str = "origin = 1920.0";
const DATUM: &str = "datum = 102.35";

/// The ground of a scene with this survey.
fn read(survey: &str, file: &str) -> Result<Vec<[f64; 2]>, Box<FileError>> {
    let text = format!("[beam]\nlength = 10\nbending_stiffness = 1\n[foundation]\nsurvey = {survey}\n");
    let scene = parse("scene.toml", &text, |path| {
        assert_eq!(path, "levels.csv");
        Ok(file.to_owned())
    })?;
    match scene.foundation() {
        Some(Foundation::Polyline { points }) => Ok(points.clone()),
        other => panic!("{other:?}"),
    }
}

/// Elevations with a header, fields parted by `separator`, written by `number`.
fn elevations(header: &str, row: impl Fn(f64, f64) -> String) -> String {
    let rows: String = GROUND.iter().map(|[x, depth]| row(1920.0 + x, 102.35 - depth) + "\n").collect();
    format!("{header}\n{rows}")
}

fn comma(value: f64) -> String {
    format!("{value:.2}").replace('.', ",")
}

/// Layouts that are read: what the scene says of them, and the file.
fn layouts() -> Vec<(&'static str, String, String)> {
    let named = format!("x = \"Chainage\", elevation = \"Level\", {DATUM}, {ORIGIN}");
    let plain = |x: f64, z: f64| format!("{x:.2},{z:.2}");
    let depths: String = GROUND.iter().map(|[x, depth]| format!("{x},{depth}\n")).collect();
    let descending = |text: String| {
        let mut lines: Vec<&str> = text.lines().collect();
        lines[1..].reverse();
        lines.join("\n") + "\n"
    };
    let base = elevations("Chainage,Level", plain);
    vec![
        ("depths by name", "x = \"Station\", depth = \"Depth\"".to_owned(), format!("Station,Depth\n{depths}")),
        ("depths by number", "x = 1, depth = 2".to_owned(), format!("Station,Depth\n{depths}")),
        ("no header", "x = 1, depth = 2".to_owned(), depths.clone()),
        ("elevations", named.clone(), base.clone()),
        ("elevations by number", format!("x = 1, elevation = 2, {DATUM}, {ORIGIN}"), base.clone()),
        (
            "other columns",
            named.clone(),
            elevations("Point,Level,Remark,Chainage", |x, z| format!("P{x},{z:.2},\"rock, wet\",{x:.2}")),
        ),
        ("quotes", named.clone(), elevations("\"Chainage\",\"Level\"", |x, z| format!("\"{x:.2}\",\"{z:.2}\""))),
        (
            "a quote in quotes",
            named.clone(),
            elevations("Remark,Chainage,Level", |x, z| format!("\"5\"\" pipe, \"\"old\"\"\",{x:.2},{z:.2}")),
        ),
        ("tabs", named.clone(), elevations("Chainage\tLevel", |x, z| format!("{x:.2}\t{z:.2}"))),
        ("a tab in front", named.clone(), elevations("Name\tChainage\tLevel", |x, z| format!("\t{x:.2}\t{z:.2}"))),
        (
            "semicolons and commas",
            named.clone(),
            elevations("Chainage;Level", |x, z| format!("{};{}", comma(x), comma(z))),
        ),
        (
            "sep=;",
            named.clone(),
            format!("sep=;\r\n{}", elevations("Chainage;Level", |x, z| format!("{};{}\r", comma(x), comma(z)))),
        ),
        ("sep= and a comma", named.clone(), format!("sep=,\n{base}")),
        (
            "decimal commas in quotes",
            named.clone(),
            elevations("Chainage,Level", |x, z| format!("\"{}\",\"{}\"", comma(x), comma(z))),
        ),
        ("line ends of old Macs", named.clone(), base.replace('\n', "\r")),
        ("a byte order mark", named.clone(), format!("\u{feff}{}", base.replace('\n', "\r\n"))),
        (
            "stations of hundreds",
            named.clone(),
            elevations("Chainage,Level", |x, z| format!("{}+{:05.2},{z:.2}", (x / 100.0).floor(), x % 100.0)),
        ),
        (
            "stations of thousands",
            named.clone(),
            elevations("Chainage,Level", |x, z| format!("{}+{:06.2},{z:.2}", (x / 1000.0).floor(), x % 1000.0)),
        ),
        (
            "the first station",
            format!("x = \"Chainage\", elevation = \"Level\", {DATUM}"),
            elevations("Chainage,Level", |x, z| format!("0+{:.2},{z:.2}", x - 1920.0)),
        ),
        ("descending rows", named.clone(), descending(base.clone())),
        (
            "from right to left",
            format!("x = \"Chainage\", elevation = \"Level\", {DATUM}, origin = 1930, direction = \"down\""),
            {
                let rows: String =
                    GROUND.iter().map(|[x, depth]| format!("{:.2},{:.2}\n", 1930.0 - x, 102.35 - depth)).collect();
                format!("Chainage,Level\n{rows}")
            },
        ),
        (
            "missing data",
            format!("{named}, no_data = -9999"),
            base.replace("1924.00,101.60", "1923.00,-9999\n1923.5,-9999.00\n1924.00,101.60"),
        ),
        ("missing data in words", format!("{named}, no_data = \"n/a\""), base.replace("1930.00", "1929,n/a\n1930.00")),
        ("titles before the header", named.clone(), format!("Survey of the bed\n# by boat\n\n2024,June\n{base}")),
        ("empty rows of a spreadsheet", named.clone(), format!("{base},\n,\n")),
        (
            "beyond the beam",
            named.clone(),
            format!("Chainage,Level\n1900,100\n1919,100\n1920,101.2\n{}", base.split_once("101.20\n").expect("rows").1)
                + "1931,99\n1950,99\n",
        ),
    ]
}

#[test]
fn every_layout_is_read_to_the_same_ground() {
    let all = layouts();
    assert!(20 <= all.len(), "{}", all.len());
    for (name, declared, file) in all {
        let survey = format!("{{ file = \"levels.csv\", {declared} }}");
        let points = read(&survey, &file).unwrap_or_else(|error| panic!("{name}: {error}\n{file}"));
        // To the last bit: a difference of two decimals is a decimal.
        let bits = |points: &[[f64; 2]]| points.iter().map(|point| point.map(f64::to_bits)).collect::<Vec<_>>();
        assert_eq!(bits(&points), bits(&GROUND), "{name}: {points:?}\n{file}");
    }
}

/// The same of an initial shape.
#[test]
fn a_shape_has_the_same_surveys() {
    let shape =
        "{ survey = { file = \"levels.csv\", x = \"Chainage\", elevation = \"Level\", datum = 1.5, origin = 20 } }";
    let text = format!("[beam]\nlength = 10\nbending_stiffness = 1\nshape = {shape}\n");
    let levels = "Chainage,Level\n30,1.5\n25,1.25\n20,1.5\n";
    let scene = parse("scene.toml", &text, |_| Ok(levels.to_owned())).expect("a scene");
    let points = vec![[0.0, 0.0], [5.0, 0.25], [10.0, 0.0]];
    assert_eq!(scene.beam().shape(), Some(&Foundation::Polyline { points }));
}

/// Without a declaration none of these files is read but that with the header `x,depth`: elevations are never taken for depths. The message
/// has the columns, and the line to write in both readings, which is then read.
#[test]
fn a_header_that_is_not_declared_is_answered_with_the_line_to_write() {
    let mut answered = 0;
    for (name, declared, file) in layouts() {
        let error = read("\"levels.csv\"", &file).expect_err(name);
        let help = error.problem.help().unwrap_or_else(|| panic!("{name}: {error}"));
        assert!(error.to_string().contains("count upwards"), "{name}: {error}");
        let lines: Vec<&str> = help.lines().filter(|line| line.starts_with("survey = ")).collect();
        let [depths, elevations] = &lines[..] else { panic!("{name}: {help}") };
        assert!(depths.contains("depth = ") && elevations.contains("elevation = "), "{help}");
        let is_simple = !["titles before the header", "missing data", "missing data in words"].contains(&name);
        if is_simple && !declared.contains("direction") {
            let rest = if declared.contains("origin") { format!("{DATUM}, {ORIGIN}") } else { DATUM.to_owned() };
            let (line, ground) = if declared.contains("elevation") {
                (elevations.replace("datum = …", &rest), GROUND.to_vec())
            } else {
                ((*depths).to_owned(), GROUND.to_vec())
            };
            let written = read(line.strip_prefix("survey = ").expect("a key"), &file);
            assert_eq!(written.unwrap_or_else(|error| panic!("{name}: {line}: {error}")), ground, "{name}");
            answered += 1;
        }
    }
    assert!(20 <= answered, "{answered}");
    for header in ["x,elevation", "x,level", "X,Depth", "depth,x", "x,z", "x,depth,remark", "x", "x;elevation"] {
        let error = read("\"levels.csv\"", &format!("{header}\n0,1\n10,1\n")).expect_err(header);
        assert!(error.to_string().contains("must begin with the header `x,depth`"), "{error}");
    }
}

/// What cannot be read is refused at its place.
#[test]
fn declarations_that_do_not_fit_are_refused() {
    let file = "Chainage,Level,Level2,Level2\n0,101,1,1\n10,101,1,1\n";
    let told = |declared: &str, file: &str| {
        read(&format!("{{ file = \"levels.csv\", {declared} }}"), file).expect_err(declared).to_string()
    };
    for (declared, says) in [
        ("x = \"Chainage\"", "exactly one of `depth` and `elevation`"),
        ("x = \"Chainage\", depth = 2, elevation = 3, datum = 1", "exactly one of `depth` and `elevation`"),
        ("x = \"Chainage\", elevation = \"Level\"", "the key `datum` is missing"),
        ("x = \"Chainage\", depth = \"Level\", datum = 3", "`datum` belongs to `elevation`"),
        ("depth = \"Level\"", "the key `x` is missing"),
        ("x = 0, depth = 1", "the name of a column, or its number from 1"),
        ("x = 1.5, depth = 1", "the name of a column, or its number from 1"),
        ("x = -1, depth = 1", "the name of a column, or its number from 1"),
        ("x = \"Chainage\", depth = \"Depth\"", "no column of the survey is called \"Depth\""),
        ("x = \"Chainage\", depth = \"Level2\"", "two columns of the survey are called \"Level2\""),
        ("x = 1, depth = 7", "must have at least 7 fields, but this one has 4"),
        ("x = 1, depth = 2, origin = nan", "a finite number"),
        ("x = 1, elevation = 2, datum = inf", "a finite number"),
        ("x = 1, depth = 2, direction = \"down\"", "needs `origin`"),
        ("x = 1, depth = 2, origin = 0, direction = \"left\"", "where x grows to the right"),
        ("x = 1, depth = 2, z = 3", "unknown key \"z\""),
        ("x = 1, depth = 2, origin = 5", "must reach from 0 to 10"),
    ] {
        let message = told(declared, file);
        assert!(message.contains(says), "{declared}: {message}");
    }
    let stations =
        |first: &str, second: &str| told("x = 1, depth = 2, origin = 0", &format!("x,depth\n{first},1\n{second},1\n"));
    for (first, second) in [("1+5.0", "1+15.0"), ("1+05.0", "1+015.0"), ("1+0015.0", "2+0015.0")] {
        let message = stations(first, second);
        assert!(message.contains("hundreds or thousands"), "{message}");
    }
    for row in ["0,1,5", "0,1,0,1"] {
        let message = told("x = 1, depth = 2", &format!("x,depth\n{row}\n10,1\n"));
        assert!(message.contains("at most 2 fields"), "{message}");
    }
    let first = told("x = 1, depth = 2", "O.0,1.25\n10,1\n");
    assert!(first.contains("`x` must be a finite number"), "{first}");
    let marks = told("x = 1, depth = 2", "x;depth\n0;1,5\n10;1.5\n");
    assert!(marks.contains("other numbers of this file have a decimal comma"), "{marks}");
}

/// Errors about points are shown at the row that they come from: in descending files, behind rows without data, beyond the beam.
#[test]
fn a_wrong_point_of_a_declared_survey_is_shown_in_its_row() {
    let survey = "{ file = \"levels.csv\", x = \"s\", elevation = \"z\", datum = 5, origin = 100, no_data = -1 }";
    for (file, line) in [
        ("s,z\n90,4\n100,4\n103,-1\n104,4\n103,4\n110,4\n", 6),
        ("s,z\n110,4\n104,4\n103,-1\n105,4\n100,4\n", 3),
        ("s,z\n100,4\n104,4\n104,-1\n104,3\n104,2\n110,4\n", 6),
        ("s,z\n100,6\n110,4\n", 2),
        ("s,z\n110,4\n100,6\n", 3),
    ] {
        let error = read(survey, file).expect_err("a wrong point");
        let place = error.place.as_ref().map(|place| place.line);
        assert_eq!((error.file.as_str(), place), ("levels.csv", Some(line)), "{error}");
    }
}

/// Chainages that end at the end of the beam but for rounding.
#[test]
fn a_last_place_is_the_end_but_for_rounding() {
    for (last, is_end) in [(10.0 + 9e-9, true), (10.0 - 9e-9, true), (10.0 + 3e-8, false), (10.0 - 3e-8, false)] {
        let points = read("\"levels.csv\"", &format!("x,depth\n0,1\n{last:?},1\n"));
        assert_eq!(points.is_ok_and(|points| points[1][0].total_cmp(&10.0).is_eq()), is_end, "{last:?}");
    }
}
