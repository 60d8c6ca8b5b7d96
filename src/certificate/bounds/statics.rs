//! What contact forces do to the beam under the true load: moments by statics, deflections by integration.
//!
//! ```text
//! EI v'''' = q − Σ f_k δ(x − x_k),   v(0) = v(l) = 0,  v''(0) = v''(l) = 0,   M = −EI v''
//! ```

use super::load::{Pieces, cells};
use super::polynomial::{Polynomial, number};
use super::span::{Jet, step};
use crate::certificate::interval::Interval;

/// Forces at places, from left to right, one at a place, none negative.
pub(super) type Forces = [(f64, f64)];

/// The beam under its load and some contact forces: `v, …, v'''` at the left end of each cell.
#[derive(Debug, Clone)]
pub(super) struct Carried {
    pub(super) cells: Vec<([f64; 2], Jet)>,
}

impl Carried {
    pub(super) fn of(forces: &Forces, load: &Pieces, stiffness: f64, length: f64) -> Self {
        let mut breaks = load.breaks(0.0, length);
        breaks.extend(forces.iter().map(|f| f.0));
        let all = cells(0.0, length, breaks);
        let end = |start: Jet| through(&all, start, forces, load, stiffness, |_, _| ());
        let l = Interval::exact(length);
        // First as if nothing held it at the left end, then with the slope and the shear that bring the right end back.
        let free = end([Interval::ZERO; 4]);
        let third = -(free[2] / l);
        let slope = -(free[0] / l) - third * l * l / number(6);
        let start = [Interval::ZERO, slope, Interval::ZERO, third];
        let mut jets = Vec::with_capacity(all.len());
        through(&all, start, forces, load, stiffness, |cell, jet| jets.push((cell, jet)));
        Self { cells: jets }
    }
}

/// Marches along the beam; the values just before the right end.
fn through(
    all: &[[f64; 2]],
    start: Jet,
    forces: &Forces,
    load: &Pieces,
    stiffness: f64,
    mut visit: impl FnMut([f64; 2], Jet),
) -> Jet {
    let mut jet = start;
    let mut next = forces.iter().skip_while(|f| f.0 <= 0.0).peekable();
    for &cell in all {
        if 0.0 < cell[0] {
            let mut jump = load.point(cell[0]).unwrap_or(Interval::ZERO);
            if let Some(force) = next.next_if(|f| f.0 <= cell[0]) {
                jump = jump - Interval::exact(force.1);
            }
            if jump != Interval::ZERO {
                jet[3] = jet[3] + jump / Interval::exact(stiffness);
            }
        }
        visit(cell, jet);
        jet = step(&jet, cell, load, stiffness).1;
    }
    jet
}

/// The deflection on a cell from its values at the left end.
pub(super) fn deflection((cell, jet): &([f64; 2], Jet), load: &Pieces, stiffness: f64) -> Polynomial {
    step(jet, *cell, load, stiffness).0
}
