//! Closed forms of the general beam as proofs by hand: the checker knows more than the library. All are polynomials, and both energies one
//! fraction.

use palkki_evidence::authority::RBig;
use palkki_evidence::authority::check::check;
use serde_json::{Value, json};

use super::read;

/// The energies of cells `(from, to, v, M)`, of which all are pressed.
fn bracket(scene: &str, cells: &[[&str; 4]]) -> Result<[RBig; 2], String> {
    let list = |p: &str| p.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let cell = |[from, to, v, m]: &[&str; 4]| json!({"from": from, "to": to, "v": list(v), "moment": list(m)});
    check(&read(scene), &json!({"version": 1, "cells": cells.iter().map(cell).collect::<Vec<Value>>()}))
}

#[track_caller]
fn proves(scene: &str, cells: &[[&str; 4]], energy: &str) {
    let energy: RBig = energy.parse().expect("a fraction");
    assert_eq!(bracket(scene, cells), Ok([energy.clone(), energy]), "{scene}");
}

#[track_caller]
fn refuses(scene: &str, cells: &[[&str; 4]], why: &str) {
    let refused = bracket(scene, cells).expect_err("it is no proof");
    assert!(refused.contains(why), "{refused}");
}

/// A cantilever with a load at its tip, `v'' = P (l − x)/EI`: `J* = −P v(l)/2`.
#[test]
fn steps_of_the_bending_stiffness() {
    let scene = "[beam]\nlength = 2\nbending_stiffness = { steps = [[0, 1], [1, 2]] }\nsupports = [{ at = 0, built_in = true }]\n\
        [load]\npoint = [{ at = 2, force = 6 }]\n";
    let cells = [["0", "1", "0 0 6 -1", "-12 6"], ["1", "2", "5 9 3/2 -1/2", "-6 6"]];
    proves(scene, &cells, "-45");
    proves(scene, &[cells[0], ["1", "2", "5.0 9 1.5 -5e-1", "-6 6"]], "-45");
    refuses(scene, &[cells[0], ["1", "2", "5 9 3/2 -1/2", "-6 5"]], "a force of -1 that nothing exerts at 1");
    refuses(scene, &[["0", "1", "0 0 6 -1 1/10", "-12 6"], cells[1]], "the deflection has a step at 1");
    refuses(scene, &cells[..1], "the cells do not end with the beam");
}

/// Two cantilevers that a hinge joins carry half of its load each; a joint with a stiffness `k` turns by `−M/k`.
#[test]
fn joints() {
    let scene = |joint: &str, supports: &str| {
        format!(
            "[beam]\nlength = 2\nbending_stiffness = 1\njoints = [{{ at = 1{joint} }}]\nsupports = {supports}\n\
            [load]\npoint = [{{ at = 1, force = 6 }}]\n"
        )
    };
    let walls = scene("", "[{ at = 0, built_in = true }, { at = 2, built_in = true }]");
    let cells = [["0", "1", "0 0 3/2 -1/2", "-3 3"], ["1", "2", "1 -3/2 0 1/2", "0 -3"]];
    proves(&walls, &cells, "-3");
    let moment = [["0", "1", "0 0 3/2 -1/2", "-2 3"], ["1", "2", "1 -3/2 0 1/2", "1 -3"]];
    refuses(&walls, &moment, "a moment in the hinge at 1");
    let stiff = scene(", stiffness = 2", "[{ at = 0 }, { at = 2 }]");
    let cells = [["0", "1", "0 9/4 0 -1/2", "0 3"], ["1", "2", "7/4 -3/4 -3/2 1/2", "3 -3"]];
    proves(&stiff, &cells, "-21/4");
    let whole = "[beam]\nlength = 2\nbending_stiffness = 1\n[load]\npoint = [{ at = 1, force = 6 }]\n";
    refuses(whole, &cells, "the deflection has a kink at 1");
}

/// On two springs, which may hold or only push: `v = R/k + q (s − 2s³ + s⁴)/24 EI`.
#[test]
fn supports_that_give() {
    for pushes in ["", ", pushes_only = true"] {
        let scene = format!(
            "[beam]\nlength = 1\nbending_stiffness = 1\n\
            supports = [{{ at = 0, stiffness = 2{pushes} }}, {{ at = 1, stiffness = 2{pushes} }}]\n[load]\nuniform = 4\n"
        );
        proves(&scene, &[["0", "1", "1 1/6 0 -1/3 1/6", "0 2 -2"]], "-31/15");
    }
}

/// A couple `C` at the end of a beam that a turning spring of stiffness 3 holds at the other one.
#[test]
fn a_couple_and_a_turning_spring() {
    let scene = "[beam]\nlength = 1\nbending_stiffness = 1\nsupports = [{ at = 0, turning_stiffness = 3 }, { at = 1 }]\n\
        [load]\ncouple = [{ at = 1, moment = 24 }]\n";
    proves(scene, &[["0", "1", "0 -2 -3 5", "6 -30"]], "-84");
    refuses(scene, &[["0", "1", "0 -2 -3 5", "6 -29"]], "the moment jumps at 1");
}

/// Couples at the ends that bend it like the parabola that a rope has: `N v'' = −q`. Under compression that may buckle it nothing is said.
#[test]
fn tension_and_compression() {
    let scene = |tension: &str, moment: &str| {
        format!(
            "[beam]\nlength = 1\nbending_stiffness = 1\ntension = {tension}\n[load]\nuniform = 4\n\
            couple = [{{ at = 0, moment = {moment} }}, {{ at = 1, moment = {} }}]\n",
            moment.strip_prefix('-').map_or(format!("-{moment}"), str::to_owned)
        )
    };
    proves(&scene("2.0", "2"), &[["0", "1", "0 1 -1", "2"]], "-7/3");
    proves(&scene("-2", "-2"), &[["0", "1", "0 -1 1", "-2"]], "-5/3");
    refuses(&scene("-12", "-2"), &[["0", "1", "0 -1 1", "-2"]], "compression may buckle the beam");
    // The same slopes by walls, between which the moment may be off: the bound is below the truth.
    let walls = "[beam]\nlength = 1\nbending_stiffness = 1\ntension = -2\n\
        supports = [{ at = 0, built_in = true, slope = -1.0 }, { at = 1, built_in = true, slope = 1.0 }]\n[load]\nuniform = 4\n";
    proves(walls, &[["0", "1", "0 -1 1", "-2"]], "7/3");
    let [low, up] = bracket(walls, &[["0", "1", "0 -1 1", "-1.9"]]).unwrap_or_else(|why| panic!("{why}"));
    let truth: RBig = "7/3".parse().expect("a fraction");
    assert!(low < truth && up == truth, "{low} {up}");
}

/// A beam that its load presses evenly into ground of two stiffnesses, or of none on one side.
#[test]
fn steps_of_the_stiffness_of_the_ground() {
    let scene = |second: &str| {
        format!(
            "[beam]\nlength = 2\nbending_stiffness = 1\nsupports = []\n[foundation]\ndepth = 0\n\
            stiffness = {{ steps = [[0, 4], [1, {second}]] }}\n[load]\n\
            linear = [{{ from = 0, to = 1, start = 4, end = 4 }}, {{ from = 1, to = 2, start = {second}, end = {second} }}]\n"
        )
    };
    proves(&scene("8"), &[["0", "2", "1", ""]], "-6");
    proves(&scene("0.0"), &[["0", "2", "1", ""]], "-2");
    refuses(&scene("8"), &[["0", "2", "1", "1/100"]], "the moment jumps at 0");
    refuses(&scene("-8"), &[["0", "2", "1", ""]], "a stiffness is not positive");
}

/// Ground with a step at the end of the beam, where the smaller depth governs.
#[test]
fn the_edge_of_a_step_at_an_end() {
    let scene = |depth: &str| {
        format!(
            "[beam]\nlength = 1\nbending_stiffness = 1\nsupports = [{{ at = 0, built_in = true }}]\n\
            [foundation]\npoints = [[0, 1], [1, 1], [1, {depth}]]\n[load]\npoint = [{{ at = 1, force = 6 }}]\n"
        )
    };
    let free = [["0", "1", "0 0 3 -1", "-6 6"]];
    proves(&scene("1"), &[["0", "1", "0 0 3/2 -1/2", "-3 3"]], "-9/2");
    refuses(&scene("0.5"), &[["0", "1", "0 0 3/2 -1/2", "-3 3"]], "the beam is below the ground at 1");
    refuses(&scene("1"), &free, "the beam is below the ground between 0 and 1");
}

/// What columns of `EI = 1` and `l = 1` bear.
const COLUMNS: [(&str, f64); 10] = [
    // π², 4 π², π²/4, and x² with tan x = x.
    ("supports = [{ at = 0 }, { at = 1 }]", 9.869_604_401_089_358),
    ("supports = [{ at = 0, built_in = true }, { at = 1, built_in = true }]", 39.478_417_604_357_43),
    ("supports = [{ at = 0, built_in = true }]", 2.467_401_100_272_34),
    ("supports = [{ at = 0, built_in = true }, { at = 1 }]", 20.190_728_556_426_63),
    ("supports = [{ at = 0 }, { at = 0.5 }, { at = 1 }]", 39.478_417_604_357_43),
    // A spring of stiffness k at the top, while k l is less than π².
    ("supports = [{ at = 0 }, { at = 1, stiffness = 2 }]", 2.0),
    // x² with x tan x = 1; and (2 x)² with a joint of stiffness 1 in the middle.
    ("supports = [{ at = 0, turning_stiffness = 1 }]", 0.740_173_884_394_967),
    ("supports = [{ at = 0 }, { at = 1 }]\njoints = [{ at = 0.5, stiffness = 1 }]", 2.960_695_537_579_868),
    // A hinge beside which each half is built in at one end.
    (
        "supports = [{ at = 0, built_in = true }, { at = 1, built_in = true }]\njoints = [{ at = 0.5 }]",
        9.869_604_401_089_358,
    ),
    // Of four times the stiffness in one half: tan² (x/4) = 2.
    ("bending_stiffness = { steps = [[0, 1], [0.5, 4]] }", 14.602_077_453_837_59),
];

/// Without loads it stays straight, in a proof without energy.
#[test]
fn what_a_column_bears_is_known_to_a_fiftieth() {
    for (held, most) in COLUMNS {
        let straight = |force: f64| {
            let stiffness = if held.contains("bending") { "" } else { "bending_stiffness = 1\n" };
            let scene = format!("[beam]\nlength = 1\n{stiffness}{held}\ntension = {:?}\n", -force);
            bracket(&scene, &[["0", "1", "", ""]])
        };
        for share in [0.3, 0.8, 0.98] {
            assert_eq!(straight(share * most), Ok([RBig::ZERO, RBig::ZERO]), "{share} of {most}: {held}");
        }
        for share in [1.0 + 1e-12, 1.5, 1e9, 1e200] {
            let refused = straight(share * most).expect_err(held);
            assert_eq!(refused, "compression may buckle the beam", "{share} of {most}: {held}");
        }
    }
}
