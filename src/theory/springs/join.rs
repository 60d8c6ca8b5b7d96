//! Division of the beam into links, from the pressed stretches: spans where nothing presses, and in each pressed cell of the scene as
//! many links as a Taylor polynomial needs, with one long link deep in a zone.

use super::links::{Beam, Kind, Link};

/// Distance in decay lengths `1/λ` from an end of a zone to where its effect is below rounding: `e⁻⁴⁴ < 10⁻¹⁹`.
const REACH: f64 = 44.0;

impl Beam<'_> {
    /// Makes the links, from left to right.
    pub(super) fn join(&mut self, stretches: &[[f64; 2]]) {
        let mut at = 0.0;
        for &[from, to] in stretches {
            self.hang([at, from]);
            for i in self.given.cell_from(from)..=self.given.cell_to(to) {
                let cell = &self.given.cells[i];
                let part = [cell.lo.max(from), cell.hi.min(to)];
                if 0.0 < cell.ground { self.press(part, i) } else { self.hang(part) }
            }
            at = to;
        }
        self.hang([at, self.given.length]);
    }

    /// Adds a part of the beam without pressure: one span between each two supports, springs or changes of the beam. An overhang beyond
    /// the last support, which follows from statics, is one span.
    fn hang(&mut self, [from, to]: [f64; 2]) {
        let (given, mut at) = (self.given, from);
        let x = |breakpoint: usize| given.breakpoints[breakpoint].x;
        let first = given.supports.partition_point(|support| x(support.breakpoint) <= from);
        let firm = given.supports[first..].iter().map(|support| x(support.breakpoint)).take_while(|x| *x <= to);
        let mut supports: Vec<f64> = firm.collect();
        if !given.springs.is_empty() {
            supports.extend(given.acting().map(|spring| x(spring.breakpoint)).filter(|x| from < *x && *x <= to));
            supports.sort_by(f64::total_cmp);
        }
        let mut inside: Vec<f64> = supports.iter().copied().filter(|x| *x < to).collect();
        if let [_, ..] = given.divisions_between(from, to) {
            let holds = |i: usize| given.support_at(i).is_some() || given.spring_at(i).is_some();
            let is_held = |end: f64| given.breakpoint_at(end).is_some_and(holds);
            // With an axial force an overhang does not follow from statics.
            let is_slack = given.tension == 0.0;
            let left =
                if is_slack && from <= 0.0 && !is_held(0.0) { supports.first().copied().unwrap_or(to) } else { from };
            let right = if is_slack && given.length <= to && !is_held(to) {
                supports.last().copied().unwrap_or(from)
            } else {
                to
            };
            let changes = given.divisions_between(left, right).iter().map(|&i| x(i));
            inside.extend(changes.filter(|change| !supports.contains(change)));
            inside.sort_by(f64::total_cmp);
        }
        for end in inside.into_iter().chain([to]) {
            if at < end {
                let cells = [given.cell_from(at), given.cell_to(end)];
                self.links.push(Link { cells, ..Link::new([at, end], cells[0], Kind::Span) });
            }
            at = end;
        }
    }

    /// Adds a part of a cell where the foundation presses.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 111 parts")]
    fn press(&mut self, [lo, hi]: [f64; 2], cell: usize) {
        let (_, decay) = self.rates(cell);
        let mut push = |[lo, hi]: [f64; 2], parts: u32, kind| {
            let end = |k: u32| if k < parts { lo + (hi - lo) * (f64::from(k) / f64::from(parts)) } else { hi };
            self.links.extend((0..parts).map(|k| Link::new([end(k), end(k + 1)], cell, kind)));
        };
        if hi <= lo {
            return;
        }
        let lengths = (hi - lo) * decay;
        if lengths <= 2.5 * REACH {
            return push([lo, hi], lengths.ceil().max(1.0) as u32, Kind::Pressed);
        }
        let (a, b) = (lo + REACH / decay, hi - REACH / decay);
        push([lo, a], REACH as u32, Kind::Pressed);
        push([a, b], 1, Kind::Deep);
        push([b, hi], REACH as u32, Kind::Pressed);
    }
}
