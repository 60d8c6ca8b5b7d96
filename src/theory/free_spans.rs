//! The stretches of the beam between its contacts.

use super::exact::Exact;
use crate::state::Extremes;

/// A stretch of the beam without contact: between two contacts, or from one to an end of the beam. Supports that hold the beam may stand
/// in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSpan {
    /// Left end \[length\].
    pub from: f64,
    /// Right end \[length\].
    pub to: f64,
    /// Its clearance; [`None`] where there is no foundation \[length\].
    pub clearance: Option<Extremes>,
    /// Its moments, positive with the underside in tension \[force · length\].
    pub moment: Extremes,
}

impl Exact {
    /// The stretches of a beam of this length without contact, from left to right: neither do they press, nor does the beam lie there.
    #[must_use]
    pub fn free_spans(&self, length: f64) -> Vec<FreeSpan> {
        let touches = self.state.touches.iter().map(|touch| [touch.from, touch.to]);
        let mut contacts: Vec<[f64; 2]> =
            self.state.touched().iter().map(|contact| [contact.from, contact.to]).chain(touches).collect();
        contacts.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut spans, mut from) = (Vec::new(), 0.0);
        for [start, end] in contacts.into_iter().chain([[length; 2]]) {
            if from < start {
                let clearance = self.clearance_above_ground(from, start);
                spans.push(FreeSpan { from, to: start, clearance, moment: self.moment_extremes(from, start) });
            }
            from = from.max(end);
        }
        spans
    }
}
