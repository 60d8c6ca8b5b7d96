//! What an event is, in words: the contacts on its two sides side by side.

use crate::state::Contact;
use crate::text::significant;
use crate::theory::{Exact, Touch, ZoneEnd};

/// What happens from one answer to the next.
pub(super) fn describe(before: &Exact, after: &Exact) -> String {
    let [old, new] = [before, after].map(|exact| exact.pattern());
    let mut sentences = Vec::new();
    for (left, right) in changes(&old.touches, &new.touches) {
        let contacts = [&before.state.contacts[left.clone()], &after.state.contacts[right.clone()]];
        sentences.push(change([&old.touches[left], &new.touches[right]], contacts));
    }
    for (i, support) in after.state.supports.iter().enumerate() {
        let place = at(support.at);
        let of = |pulls: &[bool]| pulls.get(i).copied();
        match (of(&old.pulls), of(&new.pulls)) {
            (Some(false), Some(true)) => sentences.push(format!("the support {place} begins to pull the beam down")),
            (Some(true), Some(false)) => sentences.push(format!("the support {place} ceases to pull the beam down")),
            _ => {}
        }
        match (old.clamped.get(i), new.clamped.get(i)) {
            (Some(a), Some(b)) if a != b => {
                let begins = if b.contains(&true) { "begins" } else { "ceases" };
                sentences.push(format!("the ground {begins} to hold the slope of the beam at the support {place}"));
            }
            _ => {}
        }
    }
    let [from, to] = [before.state.regime, after.state.regime];
    if from != to {
        sentences.push(format!("the regime changes from {} to {}", from.name(), to.name()));
    }
    sentences.join("; ")
}

type Range = std::ops::Range<usize>;

/// The stretches of two lists that differ, between the longest common subsequence of the two.
fn changes(old: &[Touch], new: &[Touch]) -> Vec<(Range, Range)> {
    // What is the same at the ends needs no table.
    let same = |(a, b): &(&Touch, &Touch)| a == b;
    let first = old.iter().zip(new).take_while(same).count();
    let last = old[first..].iter().rev().zip(new[first..].iter().rev()).take_while(same).count();
    let (a, b) = (&old[first..old.len() - last], &new[first..new.len() - last]);
    let mut longest = vec![vec![0_usize; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            longest[i][j] =
                if a[i] == b[j] { longest[i + 1][j + 1] + 1 } else { longest[i + 1][j].max(longest[i][j + 1]) };
        }
    }
    let mut found = Vec::new();
    let (mut i, mut j, mut from) = (0, 0, (0, 0));
    loop {
        let ended = i == a.len() && j == b.len();
        let common = i < a.len() && j < b.len() && a[i] == b[j];
        if (ended || common) && from != (i, j) {
            found.push((first + from.0..first + i, first + from.1..first + j));
        }
        if ended {
            return found;
        }
        if common {
            (i, j) = (i + 1, j + 1);
            from = (i, j);
        } else if j == b.len() || i < a.len() && longest[i][j + 1] <= longest[i + 1][j] {
            i += 1;
        } else {
            j += 1;
        }
    }
}

/// What happens to one group of contacts.
fn change([old, new]: [&[Touch]; 2], [before, after]: [&[Contact]; 2]) -> String {
    let places = |contacts: &[Contact]| contacts.iter().map(place).collect::<Vec<_>>().join(" and ");
    match (old, new) {
        ([], [Touch::Zone(_)]) => format!("a zone of contact appears {}", places(after)),
        ([], [_]) => format!("a contact appears {}", places(after)),
        ([], _) => format!("contacts appear {}", places(after)),
        ([Touch::Zone(_)], []) => format!("the zone {} goes", places(before)),
        ([_], []) => format!("the contact {} goes", places(before)),
        (_, []) => format!("the contacts {} go", places(before)),
        ([Touch::Zone(from)], [Touch::Zone(to)]) => format!("the zone {} {}", places(before), ends(from, to)),
        ([Touch::Zone(_)], [Touch::Edge(_)]) => format!("the zone {} becomes a contact at an edge", places(after)),
        ([Touch::Zone(_)], [_]) => format!("the zone {} becomes a point", places(after)),
        ([_], [Touch::Zone(_)]) => format!("the point {} becomes a zone", places(before)),
        ([Touch::Edge(_)], [Touch::Edge(_)]) => format!("the contact moves from the edge {} to the edge {}", places(before), places(after)),
        ([_], [Touch::Edge(_)]) => format!("the contact {} moves onto an edge", places(after)),
        ([Touch::Edge(_)], [_]) => format!("the contact {} moves off its edge", places(before)),
        ([_], [_]) => format!("the contact {} moves over an edge", places(before)),
        ([Touch::Zone(_)], _) => format!("the zone {} splits", places(before)),
        (_, [Touch::Zone(_)]) => format!("the contacts {} merge into a zone", places(before)),
        ([_], _) => format!("the contact {} splits", places(before)),
        (_, [_]) => format!("the contacts {} merge", places(before)),
        _ => format!("the contacts {} become contacts {}", places(before), places(after)),
    }
}

/// What happens at the ends of a zone that stays one.
fn ends(old: &[ZoneEnd; 2], new: &[ZoneEnd; 2]) -> String {
    let said = |(a, b): (&ZoneEnd, &ZoneEnd)| match (a, b) {
        (a, b) if a == b => None,
        (_, ZoneEnd::Support(_)) => Some("reaches a support"),
        (_, ZoneEnd::FreeEnd) => Some("reaches a free end of the beam"),
        (ZoneEnd::Support(_), _) => Some("leaves a support"),
        (ZoneEnd::FreeEnd, _) => Some("leaves a free end of the beam"),
        _ => Some("moves over an edge"),
    };
    old.iter().zip(new).filter_map(said).collect::<Vec<_>>().join(" and ")
}

fn place(contact: &Contact) -> String {
    let [from, to] = [contact.from, contact.to].map(|x| significant(x, DIGITS));
    if from == to { at(contact.from) } else { format!("from x = {from} to x = {to}") }
}

fn at(x: f64) -> String {
    format!("at x = {}", significant(x, DIGITS))
}

/// Digits of a place in words.
const DIGITS: usize = 6;
