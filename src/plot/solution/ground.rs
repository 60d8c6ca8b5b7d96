//! The foundation as it is drawn below the beam.

use crate::plot::curves::Curves;
use crate::plot::layer::Place;
use crate::plot::number::{DIGITS, significant};
use crate::scene::{Foundation, Scene};

/// The foundation as far as it is drawn.
pub(super) struct Ground {
    pub(super) line: Vec<Place>,
    /// Why something is missing, as a sentence of the description.
    pub(super) remark: Option<String>,
}

/// A foundation deeper than this many times the deflection would flatten the beam to a line: it is cut off there.
const DEEPEST: f64 = 4.0;

pub(super) fn foundation_line(scene: &Scene, curves: &Curves) -> Ground {
    /// Places at which a smooth foundation is drawn; a drawing is 2400 units wide.
    const SAMPLES: u32 = 600;
    let length = scene.beam().length();
    let even = (0..=SAMPLES).map(|i| length * f64::from(i) / f64::from(SAMPLES));
    let line: Vec<Place> = match scene.foundation() {
        None => {
            let remark = Some("There is no foundation, so there is no clearance.".to_owned());
            return Ground { line: Vec::new(), remark };
        }
        Some(Foundation::Polyline { points }) => points.clone(),
        Some(Foundation::Flat { depth }) => vec![[0.0, *depth], [length, *depth]],
        Some(smooth) => even.map(|x| [x, smooth.depth(x)]).collect(),
    };
    let deflected = curves.deflection.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let limit = if 0.0 < deflected { DEEPEST * deflected } else { f64::INFINITY };
    let shallowest = line.iter().fold(f64::INFINITY, |least, p| least.min(p[1]));
    if limit < shallowest {
        let depth = significant(shallowest, DIGITS);
        let remark = format!("The foundation lies far below the beam, at {depth} or deeper, and is not drawn with it.");
        return Ground { line: Vec::new(), remark: Some(remark) };
    }
    if line.iter().any(|p| limit < p[1]) {
        let line = line.into_iter().map(|[x, u]| [x, u.min(limit)]).collect();
        let remark = format!("The foundation is cut off at the depth {}.", significant(limit, DIGITS));
        return Ground { line, remark: Some(remark) };
    }
    Ground { line, remark: None }
}
