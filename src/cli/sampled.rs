//! The exact solution at places along the beam, for a table or a figure: it has no nodes of its own.

use palkki::plot::{Curves, PointForce};
use palkki::scene::{Foundation, Scene};
use palkki::theory::Exact;

/// Equal intervals between samples; a figure a hand wide shows no corners.
const INTERVALS: u32 = 240;

/// Values at one side of a place: where a force acts, shear has one value to the left of it and another to the right.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) x: f64,
    pub(super) deflection: f64,
    pub(super) slope: f64,
    pub(super) clearance: f64,
    /// Contact pressure, without concentrated forces.
    pub(super) pressure: f64,
    pub(super) moment: f64,
    pub(super) shear: f64,
}

/// Samples from support to support: equally spaced, and besides wherever something begins, ends or acts. There, and where
/// shear or pressure jump, a place has two samples, one for each side.
pub(super) fn samples(scene: &Scene, exact: &Exact) -> Vec<Sample> {
    let length = scene.beam().length();
    let mut samples = Vec::new();
    for x in places(scene, exact) {
        let [left, right] = exact.shear(x);
        let sample = |pressure, shear| Sample {
            x,
            deflection: exact.deflection(x),
            slope: exact.slope(x),
            clearance: exact.clearance(x),
            pressure,
            moment: exact.moment(x),
            shear,
        };
        // Pressure is that of the right-hand side; a step to the left is that of the other.
        let pressures = [exact.pressure(x.next_down()), exact.pressure(x)];
        let jumps = exact.state.contacts.iter().any(|c| sits_at(c.from, x) || sits_at(c.to, x));
        let loaded = scene.load().point().iter().any(|load| sits_at(load.at, x));
        let inside = 0.0 < x && x < length;
        if 0.0 < x && (!inside || jumps || loaded) {
            samples.push(sample(pressures[0], left));
        }
        if x < length {
            samples.push(sample(pressures[1], right));
        }
    }
    samples
}

/// The same places are computed in the same way: they are the same bits or they are other places.
fn sits_at(place: f64, x: f64) -> bool {
    place.total_cmp(&x).is_eq()
}

fn places(scene: &Scene, exact: &Exact) -> Vec<f64> {
    let length = scene.beam().length();
    let even = (0..=INTERVALS).map(|i| length * f64::from(i) / f64::from(INTERVALS));
    let mut places: Vec<f64> = even.collect();
    places.extend(exact.state.contacts.iter().flat_map(|c| [c.from, c.to]));
    places.extend(scene.load().point().iter().map(|load| load.at));
    places.extend(scene.load().linear().iter().flat_map(|load| [load.from, load.to]));
    if let Some(Foundation::Polyline { points }) = scene.foundation() {
        places.extend(points.iter().map(|point| point[0]));
    }
    places.retain(|x| (0.0..=length).contains(x));
    // −0.0 is a place on the beam as well.
    places.iter_mut().for_each(|x| *x += 0.0);
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// The exact solution as a figure needs it.
pub(super) fn curves(scene: &Scene, exact: &Exact) -> Curves {
    let samples = samples(scene, exact);
    let column = |value: fn(&Sample) -> f64| samples.iter().map(value).collect();
    let state = &exact.state;
    let zones = state.contacts.iter().filter(|c| c.from < c.to);
    let pressure = zones
        .map(|zone| {
            let within = samples.iter().filter(|s| zone.from <= s.x && s.x <= zone.to);
            // At its ends the samples outside of the zone are those without pressure.
            let outside = |s: &&Sample| !(s.pressure == 0.0 && (sits_at(zone.from, s.x) || sits_at(zone.to, s.x)));
            within.filter(outside).map(|s| [s.x, s.pressure]).collect()
        })
        .collect();
    Curves {
        x: column(|s| s.x),
        deflection: column(|s| s.deflection),
        clearance: column(|s| s.clearance),
        moment: column(|s| s.moment),
        shear: samples.iter().map(|s| [s.x, s.shear]).collect(),
        pressure,
        point_forces: point_forces(exact),
        contacts: state.contacts.iter().map(|c| [c.from, c.to]).collect(),
        reactions: state.reactions,
        deflection_extremes: state.deflection,
        moment_extremes: state.moment,
    }
}

/// Concentrated contact forces: point contacts, the ends of zones, and point loads that a zone carries.
fn point_forces(exact: &Exact) -> Vec<PointForce> {
    let mut forces = Vec::new();
    for contact in &exact.state.contacts {
        match contact.end_forces {
            Some([from, to]) => forces.extend([(contact.from, from), (contact.to, to)]),
            None => forces.push((contact.from, contact.force)),
        }
    }
    forces.extend(exact.forces_inside_zones());
    forces.sort_by(|a, b| a.0.total_cmp(&b.0));
    forces
        .into_iter()
        .filter(|&(_, force)| force != 0.0)
        .map(|(at, force)| PointForce { at, force, nodes: 1 })
        .collect()
}
