//! Answers computed beforehand for the two sliders of `index.html`: beam theory over the depth of a flat ground, and the
//! force method over the number of intervals.

use palkki_evidence::paper::convergence::Quantity;
use palkki_evidence::paper::{beam, example, scene_over};

use super::prelude::*;
use crate::report::html::slider_marker;

/// Depths with a zone of contact, in equal steps of the length that is lifted off, up to `l/2`; the shortest are left out.
const ZONES: u32 = 32;
/// The first of them.
const FIRST_ZONE: u32 = 4;
/// Depths with contact at mid-span only, in equal steps.
const POINTS: u32 = 24;
/// Depths that the beam does not reach, in the same steps.
const FREE: u32 = 6;
/// Places of the left half at which the deflection is given.
const SHAPE: u32 = 32;
/// Numbers of intervals.
const INTERVALS: std::ops::RangeInclusive<usize> = 10..=120;

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let markers = context! { depth => slider_marker("depth"), grid => slider_marker("grid") };
    Evidence::new(markers).data("slider-depth", depths()?)?.data("slider-grid", grids()?)
}

/// Exact answers over the depth. Beam and ground are symmetric, so that the left half is enough.
fn depths() -> Result<Table, Cause> {
    let (beam, load) = (beam()?, example()?.load().uniform());
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let unit = load * l * l * l * l / ei;
    let mut shares = vec![example()?.depth(0.0) / unit];
    shares.extend((FIRST_ZONE..ZONES).map(|i| (f64::from(i) / f64::from(ZONES)).powi(4) / 384.0));
    shares.extend((0..POINTS + FREE).map(|i| (1.0 + 4.0 * (f64::from(i) + 0.5) / f64::from(POINTS)) / 384.0));
    shares.sort_by(f64::total_cmp);

    let header = [
        "depth",
        "ei_depth_over_q_l4",
        "regime",
        "contact_from",
        "force_there",
        "reaction",
        "largest_deflection",
        "left_half_of_deflection_over_depth",
    ];
    let mut data = Table::new(header);
    for share in shares {
        let depth = share * unit;
        let exact = theory::solve(&scene_over(Foundation::Flat { depth })?)?;
        if !exact.solved {
            return Err(format!("the scene with depth {depth} is not solved").into());
        }
        let contact = exact.state.contacts.first();
        let shape = (0..=SHAPE).map(|i| exact.deflection(0.5 * l * f64::from(i) / f64::from(SHAPE)) / depth);
        data.push(row![
            fixed(depth, 6),
            fixed(share, 8),
            exact.state.regime.name(),
            fixed(contact.map_or(0.0, |c| c.from), 4),
            fixed(contact.map_or(0.0, |c| c.end_forces.map_or(c.force, |[left, _]| left)), 4),
            fixed(exact.state.reactions.left, 4),
            fixed(exact.state.deflection.max, 6),
            list(shape),
        ]);
    }
    Ok(data)
}

/// The example by the force method over the number of intervals, with its contact forces from the first node that touches
/// to mid-span.
fn grids() -> Result<Table, Cause> {
    let scene = example()?;
    let mut data = Table::new(["intervals", "first_place", "resultant", "reaction", "forces_from_there_to_mid_span"]);
    for intervals in INTERVALS {
        let outcome = on_grid(&scene, Method::Force, Solver::ActiveSet, intervals)?;
        let nodes = outcome.state.nodes.as_ref().filter(|_| outcome.solved);
        let nodes = nodes.ok_or_else(|| format!("the problem on {intervals} intervals is not solved"))?;
        let forces = &nodes.contact_force;
        let first = forces.iter().position(|force| 0.0 < *force).ok_or("no node touches")?;
        data.push(row![
            intervals,
            fixed(nodes.x[first], 4),
            fixed(Quantity::PointForce.of(&outcome.state), 4),
            fixed(outcome.state.reactions.left, 4),
            list(forces[first..intervals / 2].iter().copied()),
        ]);
    }
    Ok(data)
}

/// Numbers in one cell.
fn list(values: impl Iterator<Item = f64>) -> String {
    values.map(|value| fixed(value, 4)).collect::<Vec<_>>().join(" ")
}
