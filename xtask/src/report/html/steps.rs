//! The four steps round by round: all rounds as pictures of the page, from the data of the figure; a script shows one of them.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use minijinja::{Value, context};
use serde::Deserialize;

use super::template;
use crate::text::{as_number, fixed};
use crate::{Cause, data};

/// A line of the data: what a node is in a round, and the force of the ground there if it is held.
#[derive(Debug, Deserialize)]
struct Sign {
    round: usize,
    node: usize,
    sign: String,
    force: Option<f64>,
}

/// Signs as the data say them, with the styles of the page.
const STYLES: [(&str, &str); 5] =
    [("below the ground", "below"), ("set to zero", "zero"), ("held", "held"), (PULLS, "pulls"), (PUSHES, "force")];
const PULLS: &str = "held, would pull";
/// No sign: a force that does not pull.
const PUSHES: &str = "pushes";
/// What a box has of the place of its node, and of the height of its round.
const BOX: [f64; 2] = [0.9, 0.85];
/// Every so many rounds and nodes have their number beside them.
const NUMBERED: [usize; 2] = [5, 10];

/// The player for the data of the figure.
pub(super) fn player(data: &str) -> Result<String, Cause> {
    let signs: Vec<Sign> = data::parse(data)?;
    let last = |of: fn(&Sign) -> usize| signs.iter().map(of).max().unwrap_or(0);
    let (rounds, nodes) = (last(|sign| sign.round), last(|sign| sign.node));
    let forces = || signs.iter().filter_map(|sign| sign.force);
    let (least, most) = (forces().fold(0.0, f64::min), forces().fold(0.0, f64::max));
    let shown = signs.chunk_by(|a, b| a.round == b.round).map(|now| {
        context! {
            cells => boxes(now.iter().map(|sign| (&*sign.sign, sign.node, as_number(sign.round - 1), BOX[1]))),
            bars => boxes(now.iter().filter_map(|sign| {
                sign.force.map(|force| (if force < 0.0 { PULLS } else { PUSHES }, sign.node, -force.max(0.0), force.abs()))
            })),
            values => extremes(now, most),
            said => said(now, rounds),
        }
    });
    let numbered = |last: usize, step: usize| (step..=last).step_by(step).collect::<Vec<_>>();
    let values = context! {
        nodes,
        rounds => shown.collect::<Vec<_>>(),
        numbers => context! { rounds => numbered(rounds, NUMBERED[0]), nodes => numbered(nodes, NUMBERED[1]) },
        top => (-most).to_string(),
        height => (most - least).to_string(),
    };
    template::filled(include_str!("steps.html"), values)
}

/// Boxes of one style as one path: what each shows, its node, its upper end and its height.
fn boxes<'s>(all: impl Iterator<Item = (&'s str, usize, f64, f64)>) -> Vec<Value> {
    let mut paths: BTreeMap<&str, String> = BTreeMap::new();
    for (sign, node, up, height) in all {
        let _ = write!(paths.entry(sign).or_default(), "M{},{up}h{wide}v{height}h-{wide}z", node - 1, wide = BOX[0]);
    }
    let style = |sign: &str| STYLES.iter().find(|style| style.0 == sign).map_or("", |style| style.1);
    paths.into_iter().map(|(sign, path)| context! { style => style(sign), path }).collect()
}

/// The largest force of a round beside its bar, and the least one if it pulls.
fn extremes(now: &[Sign], most: f64) -> Vec<Value> {
    let forces = || now.iter().filter_map(|sign| Some((sign.node, sign.force?)));
    let largest = forces().max_by(|a, b| a.1.total_cmp(&b.1));
    let least = forces().min_by(|a, b| a.1.total_cmp(&b.1)).filter(|found| found.1 < 0.0);
    let value = |(node, force): (usize, f64)| {
        context! {
            node,
            style => if force < 0.0 { "pulls" } else { "force" },
            down => (most - force).to_string(),
            text => fixed(force, 3),
        }
    };
    largest.into_iter().chain(least).map(value).collect()
}

/// A round in words.
fn said(now: &[Sign], rounds: usize) -> String {
    let found = |sign: &str| now.iter().find(|found| found.sign == sign);
    let done = found("set to zero").map_or_else(
        || "no node is below the ground, and the steps end".to_owned(),
        |zero| format!("node {} is set to zero", zero.node),
    );
    let held = now.iter().filter(|sign| sign.force.is_some()).count();
    let held = if held == 1 { "1 node is held".to_owned() } else { format!("{held} nodes are held") };
    let pulls = now.iter().filter_map(|sign| Some((sign.node, sign.force.filter(|force| *force < 0.0)?)));
    let pulls: String =
        pulls.map(|(node, force)| format!("; node {node} would pull with {}", fixed(-force, 3))).collect();
    format!("Round {} of {rounds}: {done}; {held}{pulls}.", now[0].round)
}

#[cfg(test)]
mod tests {
    use super::player;

    const DATA: &str = "round,node,sign,force\n1,1,below the ground,\n1,3,set to zero,\n\
                        2,3,held,1.25\n2,1,\"held, would pull\",-0.5\n2,2,held,1\n";

    #[test]
    fn each_round_has_its_signs_its_forces_and_its_words() {
        let html = player(DATA).expect("two rounds");
        for part in [
            "viewBox=\"0 0 3 2\"",
            "data-said=\"Round 1 of 2: node 3 is set to zero; 0 nodes are held.\"",
            "<path class=\"below\" d=\"M0,0h0.9v0.85h-0.9z\"/><path class=\"zero\" d=\"M2,0h0.9v0.85h-0.9z\"/>",
            "data-said=\"Round 2 of 2: no node is below the ground, and the steps end; 3 nodes are held; \
             node 1 would pull with 0.500.\"",
            "<path class=\"held\" d=\"M2,1h0.9v0.85h-0.9zM1,1h0.9v0.85h-0.9z\"/>",
            "viewBox=\"0 -1.25 3 1.75\"",
            "<path class=\"force\" d=\"M2,-1.25h0.9v1.25h-0.9zM1,-1h0.9v1h-0.9z\"/>",
            "<path class=\"pulls\" d=\"M0,-0h0.9v0.5h-0.9z\"/>",
            "<span class=\"force\" style=\"--node:3;--down:0\">1.250</span>",
            "<span class=\"pulls\" style=\"--node:1;--down:1.75\">−0.500</span>",
        ] {
            assert!(html.contains(part), "{part} is not in\n{html}");
        }
        assert_eq!(html.matches("class=\"forces\"").count(), 2, "forces of each round");
    }
}
