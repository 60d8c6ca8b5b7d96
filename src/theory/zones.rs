//! Zones of contact, split where they would pull at the beam.

use super::gap::gap_around;
use super::given::Given;
use super::list::{AtSupport, Kind, List, Node};

/// Adds a zone; where its pressure would be negative it is split, and the beam rests on points under point loads there,
/// and at an end of the zone that lies there by more than `resolution`.
pub(super) fn add_zones(given: &Given, lifting: &[(f64, f64)], [from, to]: [f64; 2], resolution: f64, list: &mut List) {
    let mut start = from;
    for &(lo, hi) in lifting.iter().filter(|l| from <= l.1 && l.0 <= to) {
        if hi < start {
            continue;
        }
        let inside = from < lo && hi < to;
        let gap = if inside { gap_around(given, [lo, hi], [start, to]) } else { [lo, hi] };
        if start < gap[0] {
            add_zone(given, start, gap[0], list);
        } else if 0.0 < from && from + resolution < hi {
            add_point(given, from, list);
        }
        for load in given.joints.iter().filter(|j| lo <= j.x && j.x <= hi && from < j.x && j.x < to && 0.0 < j.force) {
            add_point(given, load.x, list);
        }
        start = gap[1];
        if to < given.length && lo + resolution < to && to <= start {
            add_point(given, to, list);
        }
    }
    if start < to {
        add_zone(given, start, to, list);
    }
}

fn add_point(given: &Given, x: f64, list: &mut List) {
    list.nodes.push(Node::new(Kind::Smooth, x, given.cell_from(x)));
}

fn add_zone(given: &Given, from: f64, to: f64, list: &mut List) {
    if from <= 0.0 {
        list.supports[0] = AtSupport::Zone;
    } else {
        list.nodes.push(Node::new(Kind::ZoneStart, from, given.cell_from(from)));
    }
    if given.length <= to {
        list.supports[1] = AtSupport::Zone;
    } else {
        list.nodes.push(Node::new(Kind::ZoneEnd, to, given.cell_to(to)));
    }
}
