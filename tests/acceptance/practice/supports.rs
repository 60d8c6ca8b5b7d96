//! What the page of the scene file says of supports, stops and the axial force, against formulas of simple beams.

use std::f64::consts::PI;

use palkki::scene::file::{ReadProblem, parse};
use palkki::theory::{Exact, solve};

const LENGTH: f64 = 10.0;
const EI: f64 = 1.3;

/// Formulas and answers round some dozen operations.
const ROUNDING: f64 = 1e-12;

/// The answer of the beam with more lines, or the message.
fn answer(lines: &str) -> Result<Exact, String> {
    let text = format!("beam.length = {LENGTH:?}\nbeam.bending_stiffness = {EI:?}\n{lines}\n");
    let scene = parse("beam.toml", &text, |_| Err(ReadProblem::Missing)).map_err(|error| error.to_string())?;
    solve(&scene).map_err(|error| error.to_string())
}

fn solved(lines: &str) -> Exact {
    answer(lines).unwrap_or_else(|error| panic!("{lines}: {error}"))
}

fn forces(lines: &str) -> Vec<f64> {
    solved(lines).state.supports.iter().map(|support| support.force).collect()
}

fn close(what: &str, found: &[f64], formula: &[f64]) {
    let apart = found.iter().zip(formula).map(|(found, formula)| (found - formula).abs()).fold(0.0, f64::max);
    assert!(found.len() == formula.len() && apart <= ROUNDING, "{what}: {found:?}, by the formula {formula:?}");
}

/// The message names what is wrong.
fn refused(lines: &str, words: &str) {
    match answer(lines) {
        Ok(found) => panic!("{lines} is solved: {:?}", found.state.supports),
        Err(message) => assert!(message.contains(words), "{lines}: {message}"),
    }
}

/// Two equal spans with a force at the middle of the right one: `−3/32`, `11/16` and `13/32` of it; each half, if the left one pushes only.
#[test]
fn supports_act_both_ways_unless_they_push_only() {
    let three = |first: &str| {
        forces(&format!(
            "beam.supports = [{{ at = 0.0{first} }}, {{ at = 5.0 }}, {{ at = 10.0 }}]\nload.point = [{{ at = 7.5, force = 1.0 }}]"
        ))
    };
    close("both ways", &three(""), &[-3.0 / 32.0, 11.0 / 16.0, 13.0 / 32.0]);
    close("pushes only", &three(", pushes_only = true"), &[0.0, 0.5, 0.5]);

    let load = "load.linear = [{ from = 0.0, to = 10.0, start = 0.0, end = 0.03 }]";
    close("without a list", &forces(load), &[0.05, 0.1]);
    close(
        "in another order",
        &forces(&format!("beam.supports = [{{ at = 10.0 }}, {{ at = 0.0 }}]\n{load}")),
        &[0.05, 0.1],
    );
    let lying = solved("beam.supports = []\nload.uniform = 1.0\nfoundation.depth = 0.0");
    close("lying", &[lying.state.contact_force()], &[LENGTH]);
    assert!(lying.state.supports.is_empty(), "{:?}", lying.state.supports);
}

#[test]
fn a_support_has_a_position_of_its_own_above_the_foundation() {
    let on = |support: &str, foundation: &str| {
        format!(
            "beam.supports = [{{ at = 0.0 }}, {{ {support} }}]\nload.uniform = 0.1\nfoundation = {{ {foundation} }}"
        )
    };
    refused(&on("at = 0.0", "depth = 1.0"), "two supports must be more than");
    refused(&on("at = 10.0, level = 1.01", "depth = 1.0"), "level");
    for (support, foundation) in
        [("at = 10.0, level = 1.0", "depth = 1.0"), ("at = 10.0, level = 1.01", "depth = 1.0, stiffness = 5.0")]
    {
        solved(&on(support, foundation));
    }
}

/// A spring at mid-span takes `R = (w − level)/(1/k + l³/(48 EI))`, where `w = 5 q l⁴/(384 EI)` is the free deflection.
#[test]
fn elastic_supports_and_stops_follow_their_law() {
    const STIFFNESS: f64 = 0.7;
    let middle = |load: f64, level: f64, more: &str| {
        let beam = solved(&format!(
            "beam.supports = [{{ at = 0.0 }}, {{ at = 5.0, level = {level:?}, stiffness = {STIFFNESS:?}{more} }}, {{ at = 10.0 }}]\nload.uniform = {load:?}"
        ));
        let (force, depth) = (beam.state.supports[1].force, beam.deflection(5.0) - level);
        (force, depth)
    };
    let free = |load: f64| 5.0 * load * LENGTH.powi(4) / (384.0 * EI);
    let formula = |load: f64, level: f64| (free(load) - level) / (1.0 / STIFFNESS + LENGTH.powi(3) / (48.0 * EI));
    let stop = ", pushes_only = true";
    for (load, level, more, expected) in [
        (0.1, 0.1, "", formula(0.1, 0.1)),
        (-0.1, 0.1, "", formula(-0.1, 0.1)),
        (0.1, 0.1, stop, formula(0.1, 0.1)),
        (-0.1, 0.1, stop, 0.0),
        (0.1, 1.01 * free(0.1), stop, 0.0),
    ] {
        let (force, depth) = middle(load, level, more);
        close(&format!("load {load}, level {level}{more}"), &[force], &[expected]);
        let acts = more.is_empty() || 0.0 < depth;
        close("stiffness times depth", &[force], &[if acts { STIFFNESS * depth } else { 0.0 }]);
    }
    let turning = solved(
        "beam.supports = [{ at = 0.0, level = 0.2, turning_stiffness = 3.0 }, { at = 10.0 }]\nload.uniform = 0.1",
    );
    close("a fixed level", &[turning.deflection(0.0)], &[0.2]);
}

/// Without tension a beam on one support turns about it. With tension it comes to rest, and the support carries the load.
#[test]
fn tension_needs_one_support() {
    let beam = |tension: f64| {
        answer(&format!("beam.supports = [{{ at = 4.0 }}]\nbeam.tension = {tension:?}\nload.uniform = 0.01"))
    };
    assert!(beam(0.0).is_err(), "a beam that turns about its only support is solved");
    let found = beam(2.0).expect("tension restrains it");
    close("the load", &[found.state.supports[0].force], &[0.01 * LENGTH]);
}

/// `π² EI/l²` of a simple beam, and four times that with a third support at mid-span. What only pushes does not raise it.
#[test]
fn compression_is_limited_by_the_supports_alone() {
    let euler = PI * PI * EI / (LENGTH * LENGTH);
    let beam =
        |share: f64, more: &str| answer(&format!("beam.tension = {:?}\nload.uniform = 0.0001\n{more}", -share * euler));
    let third = |more: &str| format!("beam.supports = [{{ at = 0.0 }}, {{ at = 5.0{more} }}, {{ at = 10.0 }}]");
    for (most, more) in [
        (1.0, String::new()),
        (1.0, "foundation.depth = 0.0".to_owned()),
        (1.0, "foundation = { depth = 0.0, stiffness = 100.0 }".to_owned()),
        (1.0, third(", pushes_only = true")),
        (4.0, third("")),
    ] {
        if let Err(message) = beam(0.999 * most, &more) {
            panic!("{more}: {message}");
        }
        match beam(1.001 * most, &more) {
            Ok(_) => panic!("{more}: more than {most} of the buckling load"),
            Err(message) => assert!(message.contains("buckles"), "{more}: {message}"),
        }
    }
}
