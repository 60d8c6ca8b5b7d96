//! The stretches of the beam between its contacts, and extremes on such a stretch.

use super::exact::Exact;
use super::piece::Piece;
use super::summary;
use crate::scene::{Beam, Scale};
use crate::state::Extremes;

/// A stretch of the beam without contact: between two contacts, or between a contact and an end of the beam. It may contain supports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSpan {
    /// Left end \[length\].
    pub from: f64,
    /// Right end \[length\].
    pub to: f64,
    /// Extremes of the clearance; [`None`] without a foundation \[length\].
    pub clearance: Option<Extremes>,
    /// `w0 + v` at the largest clearance, positive downwards; [`None`] without a foundation \[length\].
    pub position: Option<f64>,
    /// Extremes of the moment, positive with the underside in tension \[force · length\].
    pub moment: Extremes,
}

impl Exact {
    /// The stretches of this beam without contact, from left to right: the beam neither presses nor touches there.
    #[must_use]
    pub fn free_spans(&self, beam: &Beam) -> Vec<FreeSpan> {
        let shape = |x: f64| beam.shape().map_or(0.0, |shape| shape.depth(x));
        let touches = self.state.touches.iter().map(|touch| [touch.from, touch.to]);
        let mut contacts: Vec<[f64; 2]> =
            self.state.touched().iter().map(|contact| [contact.from, contact.to]).chain(touches).collect();
        contacts.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut spans, mut from) = (Vec::new(), 0.0);
        for [start, end] in contacts.into_iter().chain([[beam.length(); 2]]) {
            if from < start {
                let clearance = self.clearance_above_ground(from, start);
                let position = clearance.map(|clearance| clearance.max_at).map(|x| shape(x) + self.deflection(x));
                let moment = self.moment_extremes(from, start);
                spans.push(FreeSpan { from, to: start, clearance, position, moment });
            }
            from = from.max(end);
        }
        spans
    }

    /// The greatest and the least clearance from `from` to `to`, each an end of the beam or of a contact; at a step the values of both
    /// sides count. Zero without a foundation \[length\].
    #[must_use]
    pub fn clearance_extremes(&self, from: f64, to: f64) -> Extremes {
        self.clearance_above_ground(from, to).unwrap_or_default()
    }

    /// The same extremes; [`None`] if the beam has no foundation on the stretch.
    fn clearance_above_ground(&self, from: f64, to: f64) -> Option<Extremes> {
        if !self.given.founded {
            return None;
        }
        let Scale { length, depth, .. } = self.units;
        if let Some(springs) = &self.springs {
            let extremes = springs.clearance_extremes([from / length, to / length])?;
            return Some(extremes.in_units(depth, length));
        }
        let extremes = summary::clearance_extremes(&self.given, &self.pieces_between(from, to));
        Some(extremes.in_units(depth, length))
    }

    /// The greatest and the least moment from `from` to `to`, each an end of the beam or of a contact \[force · length\].
    #[must_use]
    pub(crate) fn moment_extremes(&self, from: f64, to: f64) -> Extremes {
        let length = self.units.length;
        let bent = match &self.springs {
            Some(springs) => springs.bend_extremes([from / length, to / length]),
            None => summary::bend_extremes(&self.given, &self.pieces_between(from, to)),
        };
        bent.in_units(self.units.moment(), length)
    }

    /// The pieces of the beam from `from` to `to`, in the units of the scene. A piece that extends beyond is replaced by its cells
    /// inside.
    fn pieces_between(&self, from: f64, to: f64) -> Vec<Piece> {
        let [from, to] = [from, to].map(|x| x / self.units.length);
        let inside = |piece: &Piece| {
            let middle = 0.5 * (piece.lo + piece.hi);
            from <= middle && middle <= to
        };
        let first = self.pieces.partition_point(|piece| piece.hi < from);
        let mut pieces = Vec::new();
        for piece in self.pieces[first..].iter().take_while(|piece| piece.lo <= to) {
            // Converted positions match the ends of pieces only to rounding.
            let ends = [0, piece.count() - 1].map(|k| piece.part(&self.given, k, k));
            if ends.iter().all(inside) {
                pieces.push(*piece);
                continue;
            }
            let start = pieces.len();
            pieces.extend(piece.parts(&self.given).filter(inside));
            if !piece.is_from_the_left() {
                pieces[start..].reverse();
            }
        }
        pieces
    }
}
