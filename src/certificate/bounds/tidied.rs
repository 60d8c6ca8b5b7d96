//! A polyline without the points that make no corner ([`without_collinear_points`]): a beam that lies across a corner of the size
//! of rounding could not be told from one that hangs on it.

use crate::scene::Foundation;
use crate::scene::pieces::without_collinear_points;

/// The foundation, if it is a polyline that can do without some of its points.
pub(super) fn tidied(foundation: &Foundation) -> Option<Foundation> {
    let Foundation::Polyline { points } = foundation else { return None };
    let kept = without_collinear_points(points);
    (kept.len() < points.len()).then_some(Foundation::Polyline { points: kept })
}
