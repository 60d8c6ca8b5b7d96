//! Beams on other supports than the paper's, by methods on grids: what is printed of them, and what is refused.

use serde_json::Value;

use super::Folder;

const CANTILEVER: &str = "\
[beam]
length = 10
bending_stiffness = 1.3
supports = [{ at = 4, level = 0.3 }, { at = 0, built_in = true, slope = 0.02 }]
shape = { polynomial = [0.0, 0.01] }
[load]
uniform = 1
[foundation]
depth = 1
";

const LYING: &str = "\
[beam]
length = 10
bending_stiffness = 1.3
supports = []
[load]
uniform = 1
point = [{ at = 3, force = 2 }]
[foundation]
points = [[0, 1], [3, 0.6], [10, 1.4]]
";

/// In balance on its one support, over ground that is out of reach.
const BALANCED: &str = "\
[beam]
length = 10
bending_stiffness = 1.3
supports = [{ at = 5 }]
[load]
uniform = 1
";

fn folder(test: &str) -> Folder {
    let folder = Folder::new(test);
    for (name, text) in [("cantilever.toml", CANTILEVER), ("lying.toml", LYING), ("balanced.toml", BALANCED)] {
        folder.write(name, text);
    }
    folder
}

#[track_caller]
fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn json_has_the_force_of_every_support() {
    let folder = folder("json_supports");
    let (_, text, json) = folder.json("solve cantilever.toml --method force --intervals 20");
    let supports = json["supports"].as_array().expect("a list");
    assert_eq!(supports.len(), 2, "{text}");
    assert_eq!([&supports[0]["at"], &supports[1]["at"]], [&Value::from(0.0), &Value::from(4.0)], "from left to right");
    assert!(number(&supports[0]["moment"]) < 0.0 && supports[1]["moment"].is_null(), "{text}");
    assert_eq!(json["reactions"]["left"], supports[0]["force"]);
    assert!(json["reactions"]["right"].is_null() && json.get("resultant").is_none(), "{text}");
    assert_eq!(json["unknowns"], 19, "21 nodes, 2 of them held");
    let forces: f64 = supports.iter().map(|support| number(&support["force"])).sum();
    assert!((forces + number(&json["contact_force"]) - 10.0).abs() < 1e-12, "in balance");
    // The tip is a node, the built-in end is none.
    let x = json["nodes"]["x"].as_array().expect("places");
    assert_eq!((x.len(), number(&x[0]), number(&x[19])), (20, 0.5, 10.0));
    // The paper's beam has its two supports in the list.
    let (_, _, json) = folder.json("solve example.toml --method force");
    let forces: Vec<&Value> = json["supports"].as_array().expect("a list").iter().map(|s| &s["force"]).collect();
    assert_eq!(forces, [&json["reactions"]["left"], &json["reactions"]["right"]]);
}

#[test]
fn json_says_how_a_beam_stands() {
    let folder = folder("json_standing");
    let (_, text, json) = folder.json("solve lying.toml --method force --intervals 20");
    assert_eq!(json["supports"].as_array().map(Vec::len), Some(0), "{text}");
    assert!(json["reactions"]["left"].is_null() && json["reactions"]["right"].is_null(), "{text}");
    assert!((number(&json["resultant"]["at"]) - 56.0 / 12.0).abs() < 1e-12, "{text}");
    assert!((number(&json["margin"]) - 5.6 / 12.0).abs() < 1e-12, "{text}");
    assert!(json.get("motion").is_none(), "it lies at more than one place: {text}");
    let (_, text, json) = folder.json("solve balanced.toml --method displacement --intervals 20");
    assert_eq!((number(&json["motion"]["about"]), number(&json["margin"])), (5.0, 0.0), "{text}");
    let slopes = json["motion"]["slope"].as_array().expect("two ends");
    assert!(slopes.len() == 2 && slopes.iter().all(Value::is_null), "without end on both sides: {text}");
}

#[test]
fn tables_name_supports_and_how_a_beam_stands() {
    let folder = folder("table_supports");
    let run = folder.run("solve cantilever.toml --method force --intervals 20");
    for expected in [
        "supports    at 0, built in at slope 0.02; at 4, level 0.3",
        "own shape   polynomial, w = 0 + 0.01 x",
        "left support  ",
        "support at 4  ",
        "Built in",
    ] {
        assert!(run.out.contains(expected), "{expected:?} in {}", run.out);
    }
    assert!(!run.out.contains("right support"), "{}", run.out);
    let run = folder.run("solve balanced.toml --method force --intervals 20");
    for expected in ["How it stands", "resultant of the loads  ", "with slopes there ", "from any to any"] {
        assert!(run.out.contains(expected), "{expected:?} in {}", run.out);
    }
}

#[test]
fn a_comparison_says_why_a_route_does_not_go() {
    let folder = folder("compare_lying");
    let run = folder.run("compare lying.toml --intervals 20");
    let why = "force/nsor  not tried: the supports leave the beam free to move as a whole, so that there is no flexibility matrix";
    assert!(run.out.contains(why), "{}", run.out);
    let alone = folder.run("solve lying.toml --method force --solver nsor");
    assert_eq!(alone.code, Some(1), "{}", alone.out);
    assert!(alone.out.contains("nsor, which says: not tried: the supports leave"), "{}", alone.out);
    // Nothing is told of an answer that there is not.
    assert!(alone.out.contains("there is no answer to its discrete problem"), "{}", alone.out);
    assert!(!alone.out.contains("Equilibrium"), "{}", alone.out);
    for text in [&alone.out, &run.out] {
        assert!(!text.contains("NaN") && !text.contains(" inf"), "{text}");
    }
}

#[test]
fn a_grid_that_misses_a_support_is_refused() {
    let folder = folder("missed_support");
    let message = folder.refused("solve cantilever.toml --method force --intervals 7");
    let expected = "no node of 7 equal intervals lies on the support at x = 4; the least number of intervals with a node at every \
                    support is 5 (--intervals 5)";
    assert!(message.contains(expected), "{message}");
    assert!(
        folder.refused("compare cantilever.toml --intervals 12").contains("(--intervals 5)"),
        "so does a comparison"
    );
    // An accuracy that is asked for finds a grid by itself.
    let (_, text, json) = folder.json("solve cantilever.toml --method force --tolerance 0.01");
    assert_eq!(json["intervals"].as_u64().map(|n| n % 5), Some(0), "{text}");
}

/// Two intervals on three supports: every node is held, by every route.
#[test]
fn where_every_node_is_a_support_there_is_nothing_to_solve() {
    let folder = Folder::new("all_held");
    let supports = "supports = [{ at = 0 }, { at = 5 }, { at = 10 }]";
    let beam = format!("[beam]\nlength = 10\nbending_stiffness = 1.3\n{supports}\n");
    folder.write("held.toml", beam + "[load]\nuniform = 1\n[foundation]\ndepth = 1\n");
    let (code, text, json) = folder.json("compare held.toml --intervals 2");
    assert_eq!(code, Some(0), "beam theory is certified: {text}");
    let routes = json["routes"].as_array().expect("routes");
    assert_eq!(routes.len(), 16, "{text}");
    for route in &routes[1..] {
        assert_eq!(route["unknowns"], 0, "{route}");
        // The nodes do not move, and so say nothing of the beam between them.
        assert_eq!(route["status"], "not-certified", "{route}");
        assert!(route["reason"].as_str().is_some_and(|reason| reason.contains("any share")), "{route}");
    }
}
