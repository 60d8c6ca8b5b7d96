//! The axial force in the sparse forms, as a string through all nodes.

use std::collections::BTreeMap;

use super::spring_unit;
use crate::methods::Discrete;
use crate::qp::UpperColumns;

/// The force by which the axial force presses a node down on the polyline through all levels: `N` times its change of slope.
pub(super) fn pulled_down(discrete: &Discrete, node: usize) -> f64 {
    if discrete.tension == 0.0 {
        return 0.0;
    }
    let chord = |from: usize| (discrete.level(from + 1) - discrete.level(from)) / discrete.spacing;
    let bend = match node {
        0 => chord(0),
        _ if node == discrete.intervals => -chord(node - 1),
        _ => discrete.bend(node - 1, node, node + 1),
    };
    discrete.tension * bend
}

/// The variables of `potential` that move the clearance of each node, with their coefficients.
pub(super) struct PulledClearances {
    moved: Vec<Vec<(usize, f64)>>,
}

impl PulledClearances {
    /// No variables yet. Without an axial force none are stored.
    pub(super) fn of(discrete: &Discrete) -> Self {
        Self { moved: vec![Vec::new(); if discrete.tension == 0.0 { 0 } else { discrete.intervals + 1 }] }
    }

    pub(super) fn moves(&mut self, node: usize, variable: usize, share: f64) {
        if let Some(moved) = self.moved.get_mut(node) {
            moved.push((variable, share));
        }
    }

    /// The quadratic part plus the string across all intervals, with the given stiffness.
    pub(super) fn added_to(self, quadratic: UpperColumns, stiffness: f64) -> UpperColumns {
        if self.moved.is_empty() {
            return quadratic;
        }
        let columns = quadratic.starts.len() - 1;
        let mut entries = BTreeMap::new();
        for column in 0..columns {
            let here = quadratic.starts[column]..quadratic.starts[column + 1];
            entries.extend(here.map(|k| ((column, quadratic.rows[k]), quadratic.values[k])));
        }
        for ends in self.moved.windows(2) {
            let away = ends[0].iter().map(|(variable, share)| (*variable, -share));
            let rise: Vec<(usize, f64)> = away.chain(ends[1].iter().copied()).collect();
            for (j, a) in &rise {
                for (i, b) in rise.iter().filter(|(i, _)| i <= j) {
                    *entries.entry((*j, *i)).or_insert(0.0) += stiffness * a * b;
                }
            }
        }
        let mut all = UpperColumns::default();
        for ((column, row), value) in entries {
            all.starts.resize(column + 1, all.rows.len());
            all.rows.push(row);
            all.values.push(value);
        }
        all.starts.resize(columns + 1, all.rows.len());
        all
    }
}

/// The units of the string forces across the intervals, relative to the unit of forces. Empty without tension.
pub(super) fn string_forces(discrete: &Discrete, [depth, force]: [f64; 2]) -> Vec<f64> {
    let count = if 0.0 < discrete.tension { discrete.intervals } else { 0 };
    let unit = spring_unit(discrete.spacing / discrete.tension, depth, force);
    vec![(1.0 / unit).min(1.0); count]
}
