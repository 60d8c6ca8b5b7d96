//! How deep the beam is in the foundation, between contacts.

use super::bernstein::lowest_below;
use super::given::Given;
use super::measure::{Scale, TOLERANCE};
use super::piece::{Piece, derivatives};
use super::span::Span;

/// The deepest penetration in a span, if it is deeper than rounding: `(place, depth)`.
pub(super) fn penetration(given: &Given, pieces: &[Piece], span: &Span, scale: &Scale) -> Option<(f64, f64)> {
    let first = pieces.partition_point(|p| p.hi <= span.a.x);
    let mut taylor = vec![0.0; given.terms];
    let mut worst: Option<(f64, f64)> = None;
    for piece in pieces[first..].iter().take_while(|p| p.lo < span.b.x) {
        let bar =
            |worst: Option<(f64, f64)>| worst.map_or(TOLERANCE * scale.depth_at(given, piece.lo), |(_, depth)| depth);
        piece.clearance(given, &mut taylor);
        piece.outwards(&mut taylor);
        if let Some((s, value)) = lowest_below(&taylor, piece.width(), -bar(worst)) {
            worst = Some((piece.place(s), -value));
        }
        // An edge at the foot of cliffs: along them the clearance is a sum of their heights, at the edge it is what is given.
        let edge = given.joint_at(piece.hi).filter(|&joint| given.is_edge(joint) && piece.hi < span.b.x);
        if edge.is_some() {
            piece.deflection(given, &mut taylor);
            let depth = derivatives(&taylor, piece.hi - piece.anchor)[0] - given.depth(piece.hi);
            if bar(worst) < depth {
                worst = Some((piece.hi, depth));
            }
        }
    }
    worst
}
