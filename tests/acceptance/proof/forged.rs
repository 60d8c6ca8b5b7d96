//! Proofs with a fault: each is refused, or what it proves is still true.

use std::collections::BTreeMap;

use palkki::proof::{Cell, Fields, prove};
use palkki::scene::file::{ReadProblem, parse};
use palkki::theory;
use palkki_evidence::authority::RBig;
use palkki_evidence::authority::check::{Scene, check};
use palkki_evidence::random::{Feature, Random, general, sample_of};

use super::{read, text};
use crate::scenes::scene;

/// How many are forged, over all proofs.
const FORGED: usize = 16_000;

/// Scenes of zones, points and steps, held in all ways, on rigid ground and on ground that gives.
const SCENES: [&str; 10] = [
    "heinisuo-1984",
    "dish",
    "ridge",
    "step",
    "mid-span",
    "held/pipe-sleeper",
    "held/two-spans",
    "held/cantilever",
    "held/table-edge",
    "soft/bearings",
];

/// And random ones of the general beam, with these features and whether on elastic ground: the first two of each that have a proof.
const GENERAL: [(&[Feature], bool); 9] = [
    (&[Feature::Couple, Feature::Steps], false),
    (&[Feature::Steps, Feature::Joint], false),
    (&[Feature::Hinge], false),
    (&[Feature::Spring], false),
    (&[Feature::Turning, Feature::Stop], false),
    (&[Feature::Hinge, Feature::Tension], false),
    (&[Feature::SoilSteps], true),
    (&[Feature::SoilSteps, Feature::Steps, Feature::Hinge], true),
    (&[Feature::SoilSteps, Feature::Spring, Feature::Stop], true),
];
const OF_EACH: usize = 2;

/// A scene as the checker reads it, its text, its proof and what that proves.
struct Proven {
    text: String,
    scene: Scene,
    proof: Fields,
    bracket: [RBig; 2],
}

impl Proven {
    /// [`None`] for a text that is no scene, and for a scene without a proof, as one above a cosine.
    fn of(text: String) -> Option<Self> {
        let given = parse("scene.toml", &text, |_| Err(ReadProblem::Missing)).ok()?;
        let proof = prove(&given, &theory::solve(&given).ok()?).ok()?;
        let scene = read(&text);
        let bracket = checked(&scene, &proof.json()).ok()?;
        Some(Self { text, scene, proof, bracket })
    }
}

fn proofs() -> Vec<Proven> {
    let named = SCENES.map(|name| Proven::of(text(&scene(name))).unwrap_or_else(|| panic!("{name} has no proof")));
    let drawn = GENERAL.iter().flat_map(|(of, on_soil)| {
        let found: Vec<Proven> =
            (0..50).filter_map(|i| Proven::of(general(i, of, *on_soil).text)).take(OF_EACH).collect();
        assert_eq!(found.len(), OF_EACH, "{of:?}");
        found
    });
    named.into_iter().chain(drawn).collect()
}

/// The same text with another digit.
fn other_digit(random: &mut Random, text: &str) -> String {
    let digits: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(i, _)| i).collect();
    let (at, digit) = (digits[random.below(digits.len())], random.below(10));
    format!("{}{digit}{}", &text[..at], &text[at + 1..])
}

/// From 2⁻¹⁰⁰, which is 1e-30, to one.
fn fault(random: &mut Random, of: &RBig) -> RBig {
    let by = RBig::try_from(libm::exp2(-f64::from(u32::try_from(random.below(101)).unwrap_or(0)))).expect("finite");
    let by = if random.once_in(2) { -by } else { by };
    if of.is_zero() || random.once_in(2) { of + by } else { of * (RBig::ONE + by) }
}

/// A proof with a fault, and what it is called.
fn forge(random: &mut Random, proof: &Fields) -> (&'static str, Fields) {
    let mut forged = proof.clone();
    let count = forged.cells.len();
    let i = random.below(count);
    let cell = &mut forged.cells[i];
    let what = match random.below(10) {
        0 => change(random, &mut cell.deflection, "deflection"),
        1 => change(random, &mut cell.moment, "moment"),
        2 => {
            let side = random.below(2);
            cell.ends[side] = fault(random, &cell.ends[side]);
            "end"
        }
        3 if 1 < count => {
            // A place that both cells agree on.
            let i = i.min(count - 2);
            let place = fault(random, &forged.cells[i].ends[1]);
            (forged.cells[i].ends[1], forged.cells[i + 1].ends[0]) = (place.clone(), place);
            "place"
        }
        4 => {
            forged.cells.remove(i);
            "left out"
        }
        5 => {
            forged.cells.insert(i, forged.cells[i].clone());
            "doubled"
        }
        6 if 1 < count => {
            forged.cells.swap(i, (i + 1) % count);
            "swapped"
        }
        // A force and a kink of 2⁻¹⁰⁰, at a place between cells.
        7 => bent(&mut cell.moment, "pull"),
        8 => {
            cell.pressed = !cell.pressed;
            "pressed"
        }
        _ => bent(&mut cell.deflection, "kink"),
    };
    (what, forged)
}

fn change(random: &mut Random, p: &mut Vec<RBig>, what: &'static str) -> &'static str {
    p.resize(p.len().max(2), RBig::ZERO);
    let j = random.below(p.len());
    p[j] = fault(random, &p[j]);
    what
}

/// With a slope that is less by 2⁻¹⁰⁰.
fn bent(p: &mut Vec<RBig>, what: &'static str) -> &'static str {
    p.resize(p.len().max(2), RBig::ZERO);
    p[1] = &p[1] - RBig::try_from(libm::exp2(-100.0)).expect("finite");
    what
}

#[test]
fn a_forged_proof_is_refused_or_still_true() {
    let mut random = Random::new(0x000f_0496_ed00);
    let proofs = proofs();
    let mut found = BTreeMap::<&str, [usize; 2]>::new();
    for k in 0..sample_of(FORGED) {
        let Proven { text, scene, proof, bracket } = &proofs[k % proofs.len()];
        let mut other = None;
        let (what, forged) = match random.below(12) {
            0 => ("digit", other_digit(&mut random, &proof.json())),
            1 => {
                other = Proven::of(other_digit(&mut random, text));
                if other.is_none() {
                    continue;
                }
                ("other scene", proof.json())
            }
            _ => {
                let (what, forged) = forge(&mut random, proof);
                (what, forged.json())
            }
        };
        let (scene, [low, up]) = other.as_ref().map_or((scene, bracket), |other| (&other.scene, &other.bracket));
        let counts = found.entry(what).or_default();
        match checked(scene, &forged) {
            Err(_) => counts[0] += 1,
            Ok([least, most]) => {
                assert!(least <= *up && *low <= most && least <= most, "{what} of {text}: {least} {most}");
                counts[1] += 1;
            }
        }
    }
    assert_eq!(found.len(), 12, "{found:?}");
    for (what, [refused, _]) in &found {
        assert!(0 < *refused, "{what}: none is refused");
    }
    // A place that is passed over is no place: a proof with a cell less is none.
    for what in ["left out", "doubled", "end"] {
        assert!(100 * found[what][1] <= found[what][0], "{what}: {:?}", found[what]);
    }
}

fn checked(scene: &Scene, proof: &str) -> Result<[RBig; 2], String> {
    check(scene, &serde_json::from_str(proof).map_err(|error| error.to_string())?)
}

/// A cell of no length, one that goes back, and one that is no part of the beam.
#[test]
fn cells_that_are_none_are_refused() {
    let name = "heinisuo-1984";
    let scene = scene(name);
    let proof = prove(&scene, &theory::solve(&scene).expect("an answer")).expect("a proof");
    let read = read(&text(&scene));
    let with = |change: &dyn Fn(&mut Vec<Cell>)| {
        let mut forged = proof.clone();
        change(&mut forged.cells);
        checked(&read, &forged.json())
    };
    assert!(with(&|_| {}).is_ok());
    assert!(with(&|cells| cells.clear()).is_err());
    assert!(with(&|cells| cells[0].ends[1] = RBig::ZERO).is_err());
    assert!(with(&|cells| cells.reverse()).is_err());
    let beyond = RBig::from(11);
    assert!(with(&|cells| cells[2].ends[1] = beyond.clone()).is_err());
}

/// Texts that are no proof, or would take all memory or time: each is refused with a sentence that is short.
#[test]
fn hostile_proofs_are_refused() {
    let scene = read(&text(&scene("heinisuo-1984")));
    let cell = |from: &str, to: &str, v: &str, moment: &str| {
        format!(r#"{{"from": {from}, "to": {to}, "v": {v}, "moment": {moment}, "pressed": true}}"#)
    };
    let one = |cell: String| format!(r#"{{"version": 1, "cells": [{cell}]}}"#);
    let numbers = [
        "",
        "/",
        "1/",
        "/1",
        "0/0",
        "1/0",
        "1/-0",
        "-1/-0",
        "1/-2",
        "1/2/3",
        "1.5/2",
        "inf",
        "NaN",
        "x",
        "1..2",
        "0x1",
        "１",
        "1e99999",
        "1e-99999",
        "1e999999999",
        "1@999999999",
        "1e5/3",
    ];
    let long = ["9".repeat(1_000_000), format!("1/{}", "7".repeat(1_000_000))];
    let mut texts: Vec<String> =
        ["", "1", "null", "[]", "{}", r#"{"cells": 1}"#, r#"{"cells": [null]}"#].map(str::to_owned).into();
    texts.extend(["[".repeat(1_000_000), r#"{"cells": "#.repeat(1_000)]);
    for number in numbers.into_iter().chain(long.iter().map(String::as_str)) {
        let (given, none, ten) = (format!("\"{number}\""), "[\"0\"]", "\"10\"");
        texts.push(one(cell("\"0\"", ten, &format!("[{given}]"), none)));
        texts.push(one(cell("\"0\"", ten, none, &format!("[\"0\", {given}]"))));
        texts.push(one(cell("\"0\"", &given, none, none)));
        texts.push(one(cell(&given, ten, none, none)));
    }
    let whole = cell("\"0\"", "\"10\"", "[\"0\"]", "[\"0\"]");
    assert!(checked(&scene, &one(whole.clone())).is_ok(), "the straight beam, which the ground carries at once");
    for key in ["from", "to", "v", "moment"] {
        texts.push(one(whole.replace(key, "other")));
    }
    texts.push(one(cell("0", "10", "[0]", "[0]")));
    texts.push(one(cell("\"0\"", "\"10\"", &format!("[{}]", ["\"1/3\""; 20_000].join(", ")), "[]")));
    texts.push(one(vec![whole; 1_000].join(", ")));
    for text in texts {
        let why = checked(&scene, &text).expect_err(&text[..text.len().min(200)]);
        assert!(why.len() < 200, "{why}");
    }
}
