//! The solution of a beam on springs: its parts, and where it is close to the foundation.

use super::Part;
use super::links::{Beam, Kind};
use crate::theory::divided::Parts;
use crate::theory::penetration::{by_blocks, is_clear};
use crate::theory::piece::{Piece, pieces_of};
use crate::theory::span::Span;

/// `h, h', M, V` at the two ends of a link.
pub(super) type Ends = [[f64; 4]; 2];

/// The solution of a beam on springs, as numbers at the ends of its links.
pub(super) struct Solved<'a> {
    pub(super) beam: Beam<'a>,
    /// The first link of the chain, and the end values of all links from there on; overhangs beyond the chain follow from statics.
    pub(super) held: usize,
    pub(super) ends: Vec<Ends>,
    pub(super) overhangs: [Vec<Span>; 2],
}

/// The shape of a link.
#[expect(clippy::large_enum_variant, reason = "there is one at a time")]
enum Course {
    /// Without pressure: the spans between changes of the beam.
    Hangs(Parts),
    /// Under pressure: Taylor coefficients of `h` and `v` about its left end.
    Pressed([Vec<f64>; 2]),
}

impl Solved<'_> {
    /// The number of links.
    pub(super) fn size(&self) -> usize {
        self.beam.links.len()
    }

    fn course(&self, i: usize) -> Option<Course> {
        let link = &self.beam.links[i];
        let Some(ends) = i.checked_sub(self.held).map(|i| self.ends.get(i)) else {
            return Some(Course::Hangs(Parts::of(self.overhangs[0].clone())));
        };
        let Some(ends) = ends else { return Some(Course::Hangs(Parts::of(self.overhangs[1].clone()))) };
        Some(match link.kind {
            Kind::Span => Course::Hangs(Parts::one(self.beam.between(i, ends))),
            Kind::Pressed => Course::Pressed(self.beam.taylor(link, self.beam.sheared(ends[0]))),
            Kind::Deep => Course::Pressed(self.beam.following(link)),
        })
    }

    /// Its parts, from left to right; [`None`] if numbers leave the range of `f64`.
    pub(super) fn parts(&self) -> Option<Vec<Part>> {
        let mut parts = Vec::new();
        for (i, link) in self.beam.links.iter().enumerate() {
            match self.course(i)? {
                Course::Hangs(spans) => spans.iter().for_each(|span| self.hanging(span, &mut parts)),
                Course::Pressed([h, deflection]) => {
                    let penetration = h.into_iter().map(|c| -c).collect();
                    let piece = Piece::of_part([link.lo, link.hi], link.lo, link.cells[0]);
                    parts.push(Part::new(self.beam.given, piece, true, [deflection, penetration]));
                }
            }
        }
        parts.iter().all(|part| (part.deflection[0] + part.deflection[3]).is_finite()).then_some(parts)
    }

    /// Adds the parts of a span without pressure.
    fn hanging(&self, span: &Span, parts: &mut Vec<Part>) {
        let given = self.beam.given;
        let mut pieces = Vec::new();
        pieces_of(given, span, &mut pieces);
        let mut pieces: Vec<Piece> = pieces.iter().flat_map(|piece| piece.parts(given)).collect();
        pieces.retain(|piece| piece.lo < piece.hi);
        pieces.sort_by(|a, b| a.lo.total_cmp(&b.lo));
        parts.extend(pieces.into_iter().map(|piece| {
            let (mut deflection, mut penetration) = (vec![0.0; given.terms], vec![0.0; given.terms]);
            piece.deflection(given, &mut deflection);
            piece.clearance(given, &mut penetration);
            penetration.iter_mut().for_each(|c| *c = -*c);
            Part::new(given, piece, false, [deflection, penetration])
        }));
    }

    /// The largest penetration at an end of a pressed link.
    pub(super) fn deepest(&self) -> f64 {
        let links = self.beam.links.iter().skip(self.held).zip(&self.ends);
        let pressed = links.filter(|(link, _)| link.kind != Kind::Span).flat_map(|(_, ends)| ends);
        pressed.fold(0.0, |most, [h, ..]| h.abs().max(most))
    }

    /// Visits, from left to right, each pressed part, and each other part that is not clear of the foundation by more than rounding.
    /// `see` gets the piece, whether it is pressed, and the Taylor coefficients of `h` about its anchor. [`None`] as for `parts`.
    pub(super) fn near_ground(&self, mut see: impl FnMut(&Piece, bool, &mut [f64])) -> Option<()> {
        /// As a share of the deflection, which is a sum of a few terms.
        const ROUNDING: f64 = 64.0 * f64::EPSILON;
        let given = self.beam.given;
        let (mut taylor, mut pieces) = (vec![0.0; given.terms], Vec::new());
        for (i, link) in self.beam.links.iter().enumerate() {
            let spans = match self.course(i)? {
                Course::Hangs(spans) => spans,
                Course::Pressed([mut h, v]) if (v[0] + v[3]).is_finite() => {
                    see(&Piece::of_part([link.lo, link.hi], link.lo, link.cells[0]), true, &mut h);
                    continue;
                }
                Course::Pressed(_) => return None,
            };
            for span in spans.iter() {
                if !(span.beam_a[0] + span.beam_a[3] + span.beam_b[0] + span.beam_b[3]).is_finite() {
                    return None;
                }
                let rounding = ROUNDING * span.beam_a[0].abs().max(span.beam_b[0].abs());
                pieces.clear();
                pieces_of(given, span, &mut pieces);
                for piece in &pieces {
                    by_blocks(given, piece, 0, |part| {
                        if 1 < part.count() {
                            return is_clear(given, part, -rounding, &mut taylor);
                        }
                        if part.lo < part.hi && 0.0 < given.cells[part.cell].ground {
                            part.clearance(given, &mut taylor);
                            see(part, false, &mut taylor);
                        }
                        true
                    });
                }
            }
        }
        Some(())
    }
}
