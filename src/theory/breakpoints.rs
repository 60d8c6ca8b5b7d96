//! Division of a scene into cells and breakpoints, [`PiecewiseScene`].

use super::gauss::Gauss;
use super::piecewise::{AtSpring, AtSupport, Breakpoint, Cell, PiecewiseScene};
use super::pull::pulling_stretches;
use super::shape::Shape;
use crate::scene::axial::LONGEST;
use crate::scene::pieces::without_collinear_points;
use crate::scene::{Bearing, Foundation, Held, Load, Scene, polynomial};

/// Largest angle of a cell of a cosine \[rad\]: 22 terms of its Taylor series are then exact to `0.8²²/22! < 10⁻²³`, and its fourth
/// derivative to `0.8¹⁸/18! < 10⁻¹⁷`.
const CELL_ANGLE: f64 = 0.8;
/// Number of terms in the Taylor series of a cosine.
const COSINE_TERMS: usize = 22;
/// Ten-point Gauss quadrature over a cell of a cosine is exact to rounding.
const COSINE_DEGREE: usize = 19;
/// Between breakpoints the beam is a polynomial of degree 5: a load of degree 1, integrated four times.
const BEAM_TERMS: usize = 6;

impl PiecewiseScene {
    /// The profile, supports and load of a dimensionless scene.
    pub(super) fn new(scene: &Scene) -> Self {
        Self::with(scene, |_| true)
    }

    /// The same with only those elastic supports for which `acts` is true.
    pub(super) fn with(scene: &Scene, acts: impl Fn(usize) -> bool) -> Self {
        const NONE: Foundation = Foundation::Flat { depth: 0.0 };
        let foundation = scene.foundation().unwrap_or(&NONE);
        let own = scene.foundation().and(scene.beam().shape());
        let length = scene.beam().length();
        let stiffness = scene.beam().bending_stiffness();
        let (mut shapes, mut breaks) = gap_of(foundation, own, length);
        let joints =
            scene.beam().joints().iter().map(|joint| joint.at).filter(|at| is_curved_at(&shapes, &breaks, *at));
        let alone: Vec<f64> = scene.bearings().map(|bearing| bearing.at).chain(joints).collect();
        break_at(&alone, length, &mut shapes, &mut breaks);
        let ends: Vec<f64> = breaks.iter().map(|b| b.x).collect();
        let load = scene.load();
        let places = places(&[Some(foundation), own], load, scene, &ends);
        let cells = cells(load, scene, &places, &ends);
        let mut breakpoints = breakpoints(load, stiffness, &places, &cells, &shapes, &breaks);
        let bearings = stand(scene, &places, &mut breakpoints);
        let springs: Vec<AtSpring> =
            scene.springs().enumerate().map(|(i, spring)| AtSpring::of(&spring, &places, stiffness, acts(i))).collect();
        let tension = scene.beam().tension() / stiffness;
        let divisions = divisions(&cells, &breakpoints, &springs, tension);
        let degree = shapes.iter().map(Shape::degree).try_fold(0, |most, d| d.map(|d| d.max(most)));
        let (terms, [load_rule, energy_rule]) = orders(&shapes, degree, tension);
        let is_straight = tension == 0.0 && degree.is_some_and(|degree| degree < 2);
        let own_size = own.map_or(0.0, |own| own.magnitude(length));
        let mut given = Self {
            length,
            run_ends: run_ends(&cells, &breakpoints, &divisions, is_straight),
            divisions,
            roughest: roughest(&breakpoints),
            cells,
            breakpoints,
            shapes,
            ends,
            terms,
            load_rule,
            energy_rule,
            resultant: load.resultant(length) / stiffness,
            total_load: 0.0,
            magnitude: within_reach(foundation, length) + own_size,
            founded: scene.foundation().is_some(),
            bearings,
            free_ends: [0.0, length].map(|end| scene.beam().supports().iter().all(|s| s.at < end || end < s.at)),
            supports: scene
                .held()
                .iter()
                .map(|held| at_support(scene, [Some(foundation), own], &places, held))
                .collect(),
            turns: scene.held().iter().any(|held| held.turning.is_some())
                || springs.iter().any(|spring| spring.turning.is_some()),
            springs,
            pulling: Vec::new(),
            tension,
        };
        given.pulling = pulling_stretches(&given);
        given.total_load = load_between_supports(&given);
        given.meet_supports();
        given
    }

    /// Sets clearances next to supports, and slopes at supports with level foundation on both sides, along which the beam lies.
    fn meet_supports(&mut self) {
        for i in 0..self.supports.len() {
            let AtSupport { breakpoint, level, slope, tangent, .. } = self.supports[i];
            let Breakpoint { x, kink, .. } = self.breakpoints[breakpoint];
            let clearance = |cell| self.derivative(cell, x, 0) - level;
            self.supports[i].clearance = self.cells_beside(breakpoint).map(clearance);
            if slope.is_none() && tangent == [true; 2] && kink <= 0.0 {
                let [left, _] = self.cells_beside(breakpoint);
                self.supports[i].slope = Some(self.derivative(left, x, 1));
            }
        }
    }
}

/// The largest kink, and the largest step.
fn roughest(breakpoints: &[Breakpoint]) -> [f64; 2] {
    breakpoints.iter().fold([0.0; 2], |[kink, step], at| [at.kink.abs().max(kink), at.step.abs().max(step)])
}

/// The number of terms of a piece and the quadrature rules for loads and energies; `degree` of the profile is none for waves.
fn orders(shapes: &[Shape], degree: Option<usize>, tension: f64) -> (usize, [Gauss; 2]) {
    let is_smooth = degree.is_none() || tension != 0.0;
    let waves = if is_smooth { COSINE_DEGREE } else { 0 };
    let profile = shapes.iter().map(Shape::polynomial_degree).fold(waves, usize::max);
    let terms = match degree {
        None => COSINE_TERMS,
        Some(_) if tension != 0.0 => super::tension::TERMS,
        Some(_) => BEAM_TERMS,
    };
    let of_load = if is_smooth { profile } else { profile.saturating_sub(4).max(1) + 3 };
    let of_energy = if is_smooth { profile } else { (2 * profile).max(6) };
    ((profile + 1).max(terms), [of_load, of_energy].map(Gauss::exact_to))
}

/// Joints of the beam and supports that only push, at their breakpoints; those of the latter.
fn stand(scene: &Scene, places: &[f64], breakpoints: &mut [Breakpoint]) -> Vec<usize> {
    let at = |at: f64| places.partition_point(|&x| x < at);
    for joint in scene.beam().joints() {
        let flexibility = joint.stiffness.map_or(f64::INFINITY, |k| scene.beam().bending_stiffness() / k);
        breakpoints[at(joint.at)].joint = flexibility;
    }
    let stands = |bearing: Bearing| {
        let i = at(bearing.at);
        breakpoints[i].depth = bearing.gap;
        i
    };
    scene.bearings().map(stands).collect()
}

/// Where the beam changes: under an axial force everywhere.
fn divisions(cells: &[Cell], breakpoints: &[Breakpoint], springs: &[AtSpring], tension: f64) -> Vec<usize> {
    let springy =
        |i: usize| springs.binary_search_by_key(&i, |spring| spring.breakpoint).is_ok_and(|k| springs[k].acts);
    let changes = |i: usize| cells[i - 1].stiffness.total_cmp(&cells[i].stiffness).is_ne();
    let divides = |i: &usize| breakpoints[*i].is_jointed() || changes(*i) || springy(*i) || tension != 0.0;
    (1..cells.len()).filter(divides).collect()
}

/// A support at one of the breakpoints in `places`.
fn at_support(scene: &Scene, profiles: [Option<&Foundation>; 2], places: &[f64], held: &Held) -> AtSupport {
    let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
    let size = |profile: Option<&Foundation>| profile.map_or(0.0, |profile| profile.rounded_size(held.at, length));
    AtSupport {
        breakpoint: places.partition_point(|&x| x < held.at),
        level: held.deflection,
        slope: held.slope,
        built_in: held.slope.is_some(),
        turning: held.turning.map(|[k, slope]| [k / stiffness, slope]),
        clearance: [f64::INFINITY; 2],
        tangent: held.tangent,
        size: size(profiles[0]) + size(profiles[1]),
    }
}

/// Breakpoints of profile, supports and load from end to end; the smooth pieces of the profile end at `ends`.
fn places(profiles: &[Option<&Foundation>], load: &Load, scene: &Scene, ends: &[f64]) -> Vec<f64> {
    let (mut places, beam) = (ends.to_vec(), scene.beam());
    places.extend(scene.ground_changes());
    let supports = beam.supports().iter().chain(beam.bearings()).chain(beam.springs());
    places.extend(supports.map(|support| support.at));
    places.extend(load.places(beam.length()));
    places.extend(beam.changes().chain(beam.joints().iter().map(|joint| joint.at)));
    places.extend([0.0, beam.length()]);
    let cut = |most: f64, places: &mut Vec<f64>| {
        places.sort_by(f64::total_cmp);
        places.dedup();
        let cuts: Vec<f64> = places.windows(2).flat_map(|w| cuts(w[0], w[1], most)).collect();
        places.extend(cuts);
    };
    if beam.tension() != 0.0 {
        cut(LONGEST / (beam.tension().abs() / beam.bending_stiffness()).sqrt(), &mut places);
    }
    for profile in profiles.iter().flatten() {
        let Foundation::Cosine { wavelength, .. } = profile else { continue };
        let most = CELL_ANGLE * wavelength / (2.0 * std::f64::consts::PI);
        cut(most, &mut places);
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// Whether the smooth piece of the profile at a position is not a straight line.
fn is_curved_at(shapes: &[Shape], breaks: &[Break], at: f64) -> bool {
    shapes[breaks.partition_point(|b| b.x <= at)].degree().is_none_or(|degree| 2 <= degree)
}

/// Splits the smooth pieces at positions that no contact can pass: compression-only supports, and joints above a curved foundation.
fn break_at(places: &[f64], length: f64, shapes: &mut Vec<Shape>, breaks: &mut Vec<Break>) {
    for &at in places.iter().filter(|at| 0.0 < **at && **at < length) {
        let i = breaks.partition_point(|b| b.x < at);
        if breaks.get(i).is_none_or(|b| at < b.x) {
            breaks.insert(i, Break { x: at, step: 0.0 });
            shapes.insert(i, shapes[i].clone());
        }
    }
}

/// The cells between the breakpoints.
fn cells(load: &Load, scene: &Scene, places: &[f64], ends: &[f64]) -> Vec<Cell> {
    let beam = scene.beam();
    let (length, least) = (beam.length(), beam.bending_stiffness());
    let cell = |w: &[f64]| {
        let (lo, hi) = (w[0], w[1]);
        let shape = ends.partition_point(|&end| end <= lo);
        let (mut at_lo, mut slope) = (0.0, 0.0);
        for q in load.spread(length).filter(|q| q.from <= lo && hi <= q.to) {
            at_lo += q.intensity(lo);
            slope += (q.end - q.start) / (q.to - q.from);
        }
        let stiffness = beam.stiffness_between(lo, hi) / least;
        let ground = scene.ground_stiffness().map_or(1.0, |greatest| scene.ground_stiffness_beside(lo)[1] / greatest);
        Cell { lo, hi, shape, load: at_lo / least, load_slope: slope / least, stiffness, ground }
    };
    places.windows(2).map(cell).collect()
}

/// The loads, steps and kinks at the breakpoints.
fn breakpoints(
    load: &Load,
    stiffness: f64,
    places: &[f64],
    cells: &[Cell],
    shapes: &[Shape],
    breaks: &[Break],
) -> Vec<Breakpoint> {
    let mut breakpoints: Vec<Breakpoint> = places.iter().map(|&x| Breakpoint { x, ..Breakpoint::default() }).collect();
    for (i, breakpoint) in breakpoints.iter_mut().enumerate() {
        let [left, right] = [i.saturating_sub(1), i.min(cells.len() - 1)].map(|cell| cells[cell].shape);
        let (mut a, mut b) = ([0.0; 2], [0.0; 2]);
        shapes[left].taylor(breakpoint.x, &mut a);
        shapes[right].taylor(breakpoint.x, &mut b);
        breakpoint.depth = a[0].min(b[0]);
        if left != right {
            breakpoint.step = breaks[left].step;
            breakpoint.kink = b[1] - a[1];
        }
    }
    for acts in load.concentrated() {
        let i = places.partition_point(|&x| x < acts.at).min(breakpoints.len() - 1);
        breakpoints[i].acts.add(acts, stiffness);
    }
    breakpoints
}

/// The breakpoints at which the line of load ends, a force or couple acts, or the beam changes; all where the gap is not straight.
fn run_ends(cells: &[Cell], breakpoints: &[Breakpoint], divisions: &[usize], is_straight: bool) -> Vec<usize> {
    /// Rounding of a line evaluated in two cells, as a share of the load.
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    let mut start = &cells[0];
    let mut ends = |i: &usize| {
        let cell = &cells[*i];
        let jump = (start.load + start.load_slope * (cell.lo - start.lo) - cell.load).abs();
        let is_one = start.load_slope.to_bits() == cell.load_slope.to_bits() && jump <= ROUNDING * cell.load.abs();
        let ends = !is_straight || !is_one || breakpoints[*i].acts.is_any() || divisions.binary_search(i).is_ok();
        if ends {
            start = cell;
        }
        ends
    };
    (1..cells.len()).filter(|i| ends(i)).collect()
}

/// Positions that divide `lo` to `hi` into equal parts no longer than `most`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "the number of parts is limited just before"
)]
fn cuts(lo: f64, hi: f64, most: f64) -> impl Iterator<Item = f64> {
    let parts = ((hi - lo) / most).ceil().clamp(1.0, MOST_CELLS);
    (1..parts as usize).map(move |i| lo + (hi - lo) * (i as f64 / parts))
}

/// Largest number of cells of a profile; one that needs more is rejected: [`super::TheoryError::TooManyPieces`].
pub(super) const MOST_CELLS: f64 = 20_000.0;

/// The size of depths whose rounding affects contact positions: for polynomials and waves the sum of the terms of the depth, for
/// straight lines only the depth of the shallowest point, which is given.
fn within_reach(foundation: &Foundation, length: f64) -> f64 {
    match foundation {
        Foundation::Polyline { points } => points.iter().fold(f64::INFINITY, |least, p| least.min(p[1].abs())),
        smooth => smooth.magnitude(length),
    }
}

/// The boundary between two smooth pieces of a foundation.
struct Break {
    x: f64,
    /// Jump of the depth.
    step: f64,
}

/// Smooth pieces of the gap between a foundation and an initial shape, and the breaks between them.
fn gap_of(foundation: &Foundation, own: Option<&Foundation>, length: f64) -> (Vec<Shape>, Vec<Break>) {
    let (below, breaks_below) = shapes_of(foundation, length);
    let Some(own) = own else { return (below, breaks_below) };
    let (above, breaks_above) = shapes_of(own, length);
    let (mut i, mut j) = (0, 0);
    let (mut shapes, mut breaks) = (Vec::new(), Vec::new());
    loop {
        shapes.push(Shape::Gap { ground: Box::new(below[i].clone()), own: Box::new(above[j].clone()) });
        let next = [breaks_below.get(i), breaks_above.get(j)].map(|b| b.map_or(f64::INFINITY, |b| b.x));
        let x = next[0].min(next[1]);
        if !x.is_finite() {
            return (shapes, breaks);
        }
        let mut step = 0.0;
        if next[0] <= x {
            step += breaks_below[i].step;
            i += 1;
        }
        if next[1] <= x {
            step -= breaks_above[j].step;
            j += 1;
        }
        breaks.push(Break { x, step });
    }
}

/// Smooth pieces of a foundation, and the breaks between them.
fn shapes_of(foundation: &Foundation, length: f64) -> (Vec<Shape>, Vec<Break>) {
    match foundation {
        &Foundation::Flat { depth } => (vec![Shape::Line { origin: 0.0, depth, slope: 0.0 }], Vec::new()),
        Foundation::Polynomial { coefficients } => {
            (vec![Shape::Polynomial(polynomial::used(coefficients).to_vec())], Vec::new())
        }
        &Foundation::Cosine { mean, amplitude, wavelength, phase } => {
            (vec![Shape::Cosine { mean, amplitude, wavelength, phase }], Vec::new())
        }
        Foundation::Polyline { points } => lines_of(&without_collinear_points(points), length),
    }
}

/// The segments of a polyline; a step is not a segment.
fn lines_of(points: &[[f64; 2]], length: f64) -> (Vec<Shape>, Vec<Break>) {
    let segments = || points.windows(2).filter(|w| w[0][0] < w[1][0] && w[0][0] < length && 0.0 < w[1][0]);
    let shapes = segments().map(|w| Shape::line(w[0], w[1])).collect();
    let breaks = segments().zip(segments().skip(1)).map(|(a, b)| Break { x: b[0][0], step: b[0][1] - a[1][1] });
    (shapes, breaks.collect())
}

/// Sum of the magnitudes of loads that are not directly on a support (couples over the beam length), which sets the size of forces and
/// moments. A force directly on a support passes through it, however large it is.
fn load_between_supports(given: &PiecewiseScene) -> f64 {
    let between =
        |(i, breakpoint): (usize, &Breakpoint)| breakpoint.acts.size(given.length, given.support_at(i).is_some());
    let spread = |cell: &Cell| {
        let width = cell.hi - cell.lo;
        0.5 * width * (cell.load.abs() + (cell.load + width * cell.load_slope).abs())
    };
    let points: f64 = given.breakpoints.iter().enumerate().map(between).sum();
    points + given.cells.iter().map(spread).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Beam, LinearLoad, Load, PointLoad};
    use crate::theory::acts::Acts;

    #[test]
    fn cells_carry_profile_and_load() {
        let beam = Beam::new(4.0, 2.0).expect("a beam");
        let linear = vec![LinearLoad { from: 1.0, to: 3.0, start: 2.0, end: 6.0 }];
        let load = Load::new(&beam, 1.0, linear, vec![PointLoad { at: 2.0, force: 5.0 }]).expect("a load");
        let points = vec![[0.0, 1.0], [1.0, 1.0], [2.0, 0.0], [2.0, 0.5], [4.0, 2.5]];
        let foundation = Foundation::Polyline { points };
        let scene = Scene::new(beam, load, Some(foundation)).expect("a scene");
        let given = PiecewiseScene::new(&scene);
        let places: Vec<f64> = given.breakpoints.iter().map(|j| j.x).collect();
        assert_eq!(places, [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(given.cells.iter().map(|c| c.shape).collect::<Vec<_>>(), [0, 1, 2, 2]);
        assert_eq!(given.breakpoints[1], Breakpoint { x: 1.0, depth: 1.0, kink: -1.0, ..Breakpoint::default() });
        assert_eq!(
            given.breakpoints[2],
            Breakpoint { x: 2.0, acts: Acts::new([0.0, 2.5]), step: 0.5, kink: 2.0, ..Breakpoint::default() }
        );
        // q = 1 + 2 + 2 (x − 1), over EI.
        let found = [given.load(1, 1.5), given.load(3, 3.5), given.depth(2.0)];
        assert_eq!(found.map(f64::to_bits), [2.0_f64, 0.5, 0.0].map(f64::to_bits));
        assert_eq!(given.reach(3), (2.0, 4.0));
        assert!(given.is_edge(2) && !given.is_edge(1));
        assert_eq!([0, 1, 2, 3, 4].map(|i| given.load_changes_at(i)), [false, true, true, true, false]);
    }
}
