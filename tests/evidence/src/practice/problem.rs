//! A case as the reference sees it: in shares of the length, over `EI`, with the ground read from its data by code of our own.

use palkki::scene::Foundation;

use super::Case;

/// Places closer than this share of the beam are one node: it is far above the rounding of `3 · 0.6`, and far below any result that is compared.
const ONE_PLACE: f64 = 1e-11;

/// The case with lengths along the beam as shares of it and forces over `EI/l³`: deflections keep their unit.
#[derive(Debug, Clone)]
pub(super) struct Problem<'a> {
    case: &'a Case,
    /// Stiffness of the soil, `k l⁴/EI`.
    pub(super) soil: Option<f64>,
    /// Where load or ground change, supports, ends, and some places between: nodes of every mesh.
    pub(super) places: Vec<f64>,
}

impl<'a> Problem<'a> {
    /// Of a case.
    pub(super) fn of(case: &'a Case) -> Self {
        /// Places at even distances, so that a long beam without loads is compared as well.
        const BETWEEN: u32 = 16;
        let draft = &case.draft;
        let length = draft.length;
        let supports = draft.all_supports();
        let mut places: Vec<f64> = (0..=BETWEEN).map(|i| f64::from(i) / f64::from(BETWEEN)).collect();
        places.extend(supports.iter().map(|support| support.at / length));
        places.extend(draft.places().iter().map(|x| x / length));
        places.extend(shape_points(draft.shape.as_ref()).iter().map(|point| point[0] / length));
        places.sort_by(f64::total_cmp);
        places.dedup_by(|b, a| *b - *a < ONE_PLACE);
        let soil = case.soil.map(|k| k * length * length * length * length / draft.stiffness);
        Self { case, soil, places }
    }

    /// Length of the beam.
    pub(super) fn length(&self) -> f64 {
        self.case.draft.length
    }

    /// Whether it is no survey: fewer places than a survey of many readings has.
    pub(super) fn has_few_places(&self) -> bool {
        self.places.len() < 100
    }

    /// Whether rigid ground stands above a support that holds the beam.
    pub(super) fn contradicts(&self) -> bool {
        let above = |&(at, level, _, pushes_only): &(f64, f64, Option<f64>, bool)| !pushes_only && self.gap(at) < level;
        self.soil.is_none() && self.supports().iter().any(above)
    }

    /// `F l³/EI` of a force of 1.
    pub(super) fn unit(&self) -> f64 {
        let length = self.case.draft.length;
        length * length * length / self.case.draft.stiffness
    }

    /// Intensity of the load, `q l⁴/EI`, at both ends of a stretch within which it is one line.
    pub(super) fn load(&self, from: f64, to: f64) -> [f64; 2] {
        let draft = &self.case.draft;
        let length = draft.length;
        let middle = 0.5 * (from + to) * length;
        let ends = [from, to].map(|x| {
            let parts = draft.linear.iter().filter(|part| part.from < middle && middle < part.to);
            let slope = |part: &palkki::scene::LinearLoad| (part.end - part.start) / (part.to - part.from);
            draft.uniform + parts.map(|part| part.start + slope(part) * (x * length - part.from)).sum::<f64>()
        });
        ends.map(|q| q * length * self.unit())
    }

    /// Point loads: where, and `F l³/EI`.
    pub(super) fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.case.draft.point.iter().map(|point| (point.at / self.case.draft.length, point.force * self.unit()))
    }

    /// The gap between ground and unloaded beam; at a step, or within rounding of one, the smaller one.
    pub(super) fn gap(&self, x: f64) -> f64 {
        let draft = &self.case.draft;
        let at = x * draft.length;
        let near = ONE_PLACE * draft.length;
        let shape = draft.shape.as_ref().map_or(0.0, |shape| depth(shape, at, near));
        draft.ground.as_ref().map_or(f64::INFINITY, |ground| depth(ground, at, near)) - shape
    }

    /// Supports: where, the deflection, the slope times the length if it is held, and whether it only pushes.
    pub(super) fn supports(&self) -> Vec<(f64, f64, Option<f64>, bool)> {
        let draft = &self.case.draft;
        let near = ONE_PLACE * draft.length;
        let mut supports = draft.all_supports();
        supports.sort_by(|a, b| a.at.total_cmp(&b.at));
        let held = supports.iter().map(|support| {
            let shape = draft.shape.as_ref().map_or(0.0, |shape| depth(shape, support.at, near));
            let slope = support.slope.map(|slope| slope * draft.length);
            (support.at / draft.length, support.level - shape, slope, support.pushes_only)
        });
        held.collect()
    }
}

fn shape_points(shape: Option<&Foundation>) -> &[[f64; 2]] {
    match shape {
        Some(Foundation::Polyline { points }) => points,
        _ => &[],
    }
}

/// Depth of a profile; the smallest one within `near` of the place.
fn depth(profile: &Foundation, x: f64, near: f64) -> f64 {
    match profile {
        Foundation::Flat { depth } => *depth,
        Foundation::Polynomial { coefficients } => coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c),
        Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            mean + amplitude * libm::cos(std::f64::consts::TAU * x / wavelength + phase)
        }
        Foundation::Polyline { points } => {
            let [from, to] =
                [points.partition_point(|p| p[0] < x - near), points.partition_point(|p| p[0] <= x + near)];
            if from < to {
                return points[from..to].iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
            }
            let ([a, u], [b, w]) = (points[from.saturating_sub(1)], points[from.min(points.len() - 1)]);
            if a < b { u + (w - u) * ((x - a) / (b - a)) } else { u }
        }
    }
}
