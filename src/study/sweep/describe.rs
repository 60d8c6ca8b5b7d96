//! Descriptions of events in words, from the contacts just before and just after.

use crate::state::{Contact, Regime};
use crate::text::significant;
use crate::theory::{ContactKind, Exact, Pattern, ZoneEnd};

/// The changes from one answer to the next, as sentences.
pub(super) fn describe(before: &Exact, after: &Exact) -> String {
    let [old, new] = [before, after].map(|exact| exact.pattern());
    let mut sentences = Vec::new();
    for [left, right] in changes(before, after) {
        let ((old, left), (new, right)): ((Vec<_>, Vec<_>), (Vec<_>, Vec<_>)) =
            (left.into_iter().unzip(), right.into_iter().unzip());
        sentences.push(change([&old, &new], [&left, &right]));
    }
    let bearings = after.state.supports.iter().filter(|support| support.pushes_only);
    for (i, support) in bearings.enumerate() {
        let place = at(support.at);
        match [&old, &new].map(|pattern| pattern.kinds.contains(&ContactKind::Bearing(i))) {
            [true, false] => sentences.push(format!("the beam lifts off its support {place}")),
            [false, true] => sentences.push(format!("the beam comes to bear on its support {place}")),
            _ => {}
        }
    }
    for (i, support) in after.state.supports.iter().filter(|support| !support.pushes_only).enumerate() {
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
    let [from, to] = [&old, &new].map(|pattern| regime(&pattern.kinds));
    if from != to {
        sentences.push(format!("the regime changes from {} to {}", from.name(), to.name()));
    }
    sentences.join("; ")
}

/// Whether this is a contact with the foundation.
fn is_ground(kind: &ContactKind) -> bool {
    !matches!(kind, ContactKind::Bearing(_))
}

/// Whether the beam touches the foundation.
pub(super) fn touches(pattern: &Pattern) -> bool {
    pattern.kinds.iter().any(is_ground)
}

/// The compression-only supports that the beam bears on.
pub(super) fn pressed(pattern: &Pattern) -> Vec<ContactKind> {
    pattern.kinds.iter().filter(|kind| !is_ground(kind)).copied().collect()
}

/// The regime from the kinds of the contacts: near an event the length of a zone may be below the last digit of its position.
fn regime(kinds: &[ContactKind]) -> Regime {
    match kinds {
        _ if !kinds.iter().any(is_ground) => Regime::None,
        _ if kinds.iter().any(|kind| matches!(kind, ContactKind::Zone(_))) => Regime::Zone,
        _ => Regime::Points,
    }
}

/// The contacts of two answers, grouped by position; only groups that differ between the two.
fn changes(before: &Exact, after: &Exact) -> Vec<[Vec<(ContactKind, Contact)>; 2]> {
    let mut all = Vec::new();
    for (side, exact) in [before, after].into_iter().enumerate() {
        let ground = exact.contacts_by_kind().into_iter().filter(|(kind, _)| is_ground(kind));
        all.extend(ground.map(|(kind, contact)| (side, kind, contact)));
    }
    all.sort_by(|a, b| a.2.from.total_cmp(&b.2.from));
    let reach = NEAR * all.iter().fold(0.0, |most: f64, (.., contact)| most.max(contact.to));
    let mut groups: Vec<[Vec<(ContactKind, Contact)>; 2]> = Vec::new();
    let mut end = f64::NEG_INFINITY;
    for (side, kind, contact) in all {
        if end + reach < contact.from {
            groups.push([Vec::new(), Vec::new()]);
        }
        end = end.max(contact.to);
        if let Some(group) = groups.last_mut() {
            group[side].push((kind, contact));
        }
    }
    let kinds = |side: &[(ContactKind, Contact)]| side.iter().map(|(kind, _)| *kind).collect::<Vec<_>>();
    groups.retain(|[old, new]| kinds(old) != kinds(new));
    groups
}

/// Contacts just before and just after an event that are closer together than this share of the beam are at one position.
const NEAR: f64 = 1e-5;

/// The change of one group of contacts, in words.
fn change([old, new]: [&[ContactKind]; 2], [before, after]: [&[Contact]; 2]) -> String {
    let places = |contacts: &[Contact]| contacts.iter().map(place).collect::<Vec<_>>().join(" and ");
    match (old, new) {
        ([], [ContactKind::Zone(_)]) => format!("a zone of contact appears {}", places(after)),
        ([], [_]) => format!("a contact appears {}", places(after)),
        ([], _) => format!("contacts appear {}", places(after)),
        ([ContactKind::Zone(_)], []) => format!("the zone {} is lost", places(before)),
        ([_], []) => format!("the contact {} is lost", places(before)),
        (_, []) => format!("the contacts {} are lost", places(before)),
        ([ContactKind::Zone(from)], [ContactKind::Zone(to)]) => {
            format!("the zone {} {}", places(before), ends(from, to))
        }
        ([ContactKind::Zone(_)], [ContactKind::Edge(_)]) => {
            format!("the zone {} becomes a contact at an edge", places(after))
        }
        ([ContactKind::Zone(_)], [_]) => format!("the zone {} becomes a point", places(after)),
        ([_], [ContactKind::Zone(_)]) => format!("the point {} becomes a zone", places(before)),
        ([ContactKind::Edge(_)], [ContactKind::Edge(_)]) => {
            format!("the contact moves from the edge {} to the edge {}", places(before), places(after))
        }
        ([_], [ContactKind::Edge(_)]) => format!("the contact {} moves onto an edge", places(after)),
        ([ContactKind::Edge(_)], [_]) => format!("the contact {} moves off its edge", places(before)),
        ([_], [_]) => format!("the contact {} moves over an edge", places(before)),
        ([ContactKind::Zone(_)], _) => format!("the zone {} splits", places(before)),
        (_, [ContactKind::Zone(_)]) => format!("the contacts {} merge into a zone", places(before)),
        ([_], _) => format!("the contact {} splits", places(before)),
        (_, [_]) => format!("the contacts {} merge", places(before)),
        _ => format!("the contacts {} become contacts {}", places(before), places(after)),
    }
}

/// The changes at the ends of a zone that stays a zone.
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

/// Digits of a position in words.
const DIGITS: usize = 6;
