//! The definition of the problem, asked of an answer of beam theory at some hundred places.
//!
//! The problem is convex: an answer that meets all of its conditions is the solution. Nothing here is taken from the search for
//! the answer, or from the check of theory.
//!
//! ```text
//! statics     V' = p − q, M' = V between places, V jumps by the forces there, M not but at a held slope; zero beyond both ends
//! beam        v(b) = v(a) + v'(a)(b − a) − ∫ M/EI (b − x) dx
//! supports    v = d_s, and v' = φ_s where built in
//! contact     h ≥ 0,  forces and pressure ≥ 0,  h = 0 where they act
//! ```

use palkki::scene::{Foundation, Scene};
use palkki::theory::Exact;

/// Parts into which a beam is cut at the most.
const MOST_PARTS: u32 = 10_000;

/// Places and weights of five-point Gauss quadrature on `[−1, 1]`: of a load, a pressure, a moment, over a two-hundredth of the beam.
pub(crate) const FIVE: [[f64; 2]; 5] = [
    [0.0, 0.568_888_888_888_888_9],
    [0.538_469_310_105_683_1, 0.478_628_670_499_366_5],
    [-0.538_469_310_105_683_1, 0.478_628_670_499_366_5],
    [0.906_179_845_938_664, 0.236_926_885_056_189_1],
    [-0.906_179_845_938_664, 0.236_926_885_056_189_1],
];

/// What loads and pressure between `a` and `b` do, `∫ (q − p) dx` and `∫ (q − p) (b − x) dx`, without concentrated forces.
fn carried(scene: &Scene, exact: &Exact, [a, b]: [f64; 2]) -> [f64; 2] {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    FIVE.iter().fold([0.0; 2], |[force, moment], [place, weight]| {
        let x = middle + half * place;
        let part = half * weight * (intensity(scene, x) - exact.pressure(x));
        [force + part, moment + part * (b - x)]
    })
}

/// The distributed load at a place where no part of it begins or ends.
pub(crate) fn intensity(scene: &Scene, x: f64) -> f64 {
    let here = scene.load().linear().iter().filter(|q| q.from < x && x < q.to);
    here.fold(scene.load().uniform(), |sum, q| sum + q.start + (q.end - q.start) * ((x - q.from) / (q.to - q.from)))
}

/// The same force over a distance of a few units in the last place, in which no place of a rule would be inside a load.
fn between(scene: &Scene, exact: &Exact, [a, b]: [f64; 2]) -> f64 {
    let parts = scene.load().linear().iter().map(|q| {
        let [from, to] = [a.max(q.from), b.min(q.to)];
        let middle = ((from - q.from) + 0.5 * (to - from)) / (q.to - q.from);
        if from < to { (to - from) * (q.start + (q.end - q.start) * middle) } else { 0.0 }
    });
    parts.sum::<f64>() + (b - a) * (scene.load().uniform() - exact.pressure(0.5 * (a + b)))
}

/// Forces upwards at places that differ by rounding: all that is concentrated there, and without loads inside a zone, which the ground
/// carries where they stand. Of a load beside the end of a zone rounding says which.
fn concentrated(scene: &Scene, exact: &Exact, [from, to]: [f64; 2]) -> [f64; 2] {
    let here = |at: f64| from <= at && at <= to;
    let state = &exact.state;
    let zoned = |at: f64| state.contacts.iter().any(|c| c.from < at && at < c.to);
    let loads = |counts: &dyn Fn(f64) -> bool| -> f64 {
        scene.load().point().iter().filter(|p| here(p.at) && counts(p.at)).map(|p| p.force).sum()
    };
    let supports: f64 = state.supports.iter().filter(|s| here(s.at)).map(|s| s.force).sum();
    let ends = state.contacts.iter().flat_map(|c| {
        let [first, last] = c.end_forces.unwrap_or([c.force, 0.0]);
        [(c.from, first), (c.to, last)]
    });
    let upwards = supports + ends.filter(|(at, _)| here(*at)).map(|(_, force)| force).sum::<f64>();
    [upwards - loads(&|_| true), upwards - loads(&|at| !zoned(at))]
}

/// Whether the moment may jump at a place, down and up: only at a support that holds the slope, built in, or by ground that pushes
/// beside it while the support pulls, which on its left makes the moment jump up and on its right down.
fn couples(scene: &Scene, [from, to]: [f64; 2]) -> [bool; 2] {
    let held = scene.held().into_iter().find(|held| from <= held.at && held.at <= to);
    held.map_or([false; 2], |held| [1, 0].map(|side| held.slope.is_some() || held.tangent[side]))
}

/// That of beam theory, as a share of the length: some units in the last place.
const SETTLED: f64 = 4e-15;

/// By how much moment and shear force change at a contact that moves by so much on the waves of a scene.
pub(crate) fn moved_on_waves(scene: &Scene, by: f64) -> [f64; 2] {
    let by = by * scene.beam().bending_stiffness();
    let profiles = scene.foundation().into_iter().chain(scene.beam().shape());
    profiles.fold([0.0; 2], |sums, profile| match *profile {
        Foundation::Cosine { amplitude, wavelength, .. } => {
            let wave = 2.0 * std::f64::consts::PI / wavelength;
            let third = by * amplitude.abs() * wave * wave * wave;
            [sums[0] + third, sums[1] + third * wave]
        }
        _ => sums,
    })
}

/// The conditions that an answer fails by more than the share `most` of the largest deflection, moment or force, with by how much.
#[must_use]
pub fn violated(scene: &Scene, exact: &Exact, most: f64) -> Vec<String> {
    let mut asked = Asked::of(scene, exact, most);
    asked.supports();
    asked.contacts();
    let places = places(scene, exact);
    asked.shape(&places);
    asked.statics(&places);
    asked.balance();
    asked.wrong
}

/// Places where something begins, and points between: so many that a wave has twenty.
fn places(scene: &Scene, exact: &Exact) -> Vec<f64> {
    let length = scene.beam().length();
    let profiles = || scene.foundation().into_iter().chain(scene.beam().shape());
    let mut parts = 200;
    for profile in profiles() {
        if let Foundation::Cosine { wavelength, .. } = profile {
            let enough = (parts..MOST_PARTS).find(|parts| 20.0 * length <= f64::from(*parts) * wavelength);
            parts = enough.unwrap_or(MOST_PARTS);
        }
    }
    let mut places: Vec<f64> = (0..=parts).map(|k| length * f64::from(k) / f64::from(parts)).collect();
    places.extend(exact.state.contacts.iter().flat_map(|c| [c.from, c.to]));
    places.extend(scene.load().point().iter().map(|p| p.at));
    places.extend(scene.load().linear().iter().flat_map(|q| [q.from, q.to]));
    places.extend(scene.held().iter().map(|held| held.at));
    for profile in profiles() {
        if let Foundation::Polyline { points } = profile {
            places.extend(points.iter().map(|p| p[0]));
        }
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// An answer with the sizes that its violations are measured against, and what is wrong with it so far.
struct Asked<'a> {
    scene: &'a Scene,
    exact: &'a Exact,
    most: f64,
    deflection: f64,
    moment: f64,
    force: f64,
    wrong: Vec<String>,
}

impl<'a> Asked<'a> {
    fn of(scene: &'a Scene, exact: &'a Exact, most: f64) -> Self {
        let (length, stiffness) = (scene.beam().length(), scene.beam().bending_stiffness());
        let deflection = exact.state.deflection.magnitude().max(1e-3 * size(scene));
        let moment = exact.state.moment.magnitude().max(1e-3 * scene.load().magnitude(length) * length);
        // A unit in the last place of a moment bends the beam by so much.
        let deflection = deflection.max(f64::EPSILON * moment * length * length / stiffness / most);
        Self { scene, exact, most, deflection, moment, force: moment / length, wrong: Vec::new() }
    }

    fn check(&mut self, what: String, off: f64, scale: f64) {
        if off.is_nan() || self.most * scale < off {
            self.wrong.push(format!("{what}: {off:e} of {scale:e}"));
        }
    }

    fn length(&self) -> f64 {
        self.scene.beam().length()
    }

    /// On both sides of a place; beyond the ends of the beam there is none.
    fn shear(&self, x: f64) -> [f64; 2] {
        let [left, right] = self.exact.shear(x);
        [if x <= 0.0 { 0.0 } else { left }, if self.length() <= x { 0.0 } else { right }]
    }

    fn supports(&mut self) {
        let (exact, length, deflection) = (self.exact, self.length(), self.deflection);
        for held in self.scene.held() {
            self.check(
                format!("level at {}", held.at),
                (exact.deflection(held.at) - held.deflection).abs(),
                deflection,
            );
            if let Some(slope) = held.slope {
                let off = (exact.slope(held.at) - slope).abs() * length;
                self.check(format!("slope at {}", held.at), off, deflection);
            }
        }
    }

    fn contacts(&mut self) {
        let (exact, deflection, force) = (self.exact, self.deflection, self.force);
        for contact in &exact.state.contacts {
            let [first, last] = contact.end_forces.unwrap_or([contact.force; 2]);
            self.check(format!("pull at {}", contact.from), -first.min(last), force);
            for x in [contact.from, 0.5 * (contact.from + contact.to), contact.to] {
                self.check(format!("gap in contact at {x}"), exact.clearance(x).abs(), deflection);
                self.check(format!("pressure at {x}"), -exact.pressure(x), force / self.length());
            }
        }
    }

    /// A unit in the last place of a place.
    fn unit(&self) -> f64 {
        f64::EPSILON * self.length()
    }

    /// The beam is above the ground, and outside of zones bent by its moments.
    fn shape(&mut self, places: &[f64]) {
        let (exact, stiffness) = (self.exact, self.scene.beam().bending_stiffness());
        let zoned = |x: f64| exact.state.contacts.iter().any(|c| c.from < x && x < c.to);
        for pair in places.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            self.check(format!("penetration at {a}"), -exact.clearance(a), self.deflection);
            // M is continuous but for the couples of built-in supports and of ground beside a support.
            let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
            let turned = FIVE.iter().map(|[place, weight]| {
                let x = middle + half * place;
                half * weight * exact.moment(x) / stiffness * (x - a)
            });
            let bent = exact.deflection(a) + exact.slope(b) * (b - a) + turned.sum::<f64>();
            if !zoned(middle) {
                // A place that is off by a unit moves the moment by so much of the shear force.
                let shear = self.shear(a)[1].abs().max(self.shear(b)[0].abs());
                let moved = self.unit() * shear / stiffness * (b - a) * (b - a);
                let size = self.deflection.max(moved / self.most);
                self.check(format!("bending from {a} to {b}"), (exact.deflection(b) - bent).abs(), size);
            }
        }
    }

    /// Every part of the beam is in equilibrium, and every place, with nothing beyond the ends. A contact that would have to move by
    /// less than `SETTLED` of the length is where it should be; on a wave, which bends the beam by its own curvature, that moves the
    /// moment by so much of its third derivative, and the shear force by so much of its fourth.
    fn statics(&mut self, places: &[f64]) {
        let (scene, exact, length) = (self.scene, self.exact, self.length());
        let shears = places.iter().flat_map(|&x| self.shear(x)).fold(self.force, |most, v| most.max(v.abs()));
        let [third, fourth] = moved_on_waves(scene, SETTLED * length).map(|change| change / self.most);
        let moment = self.moment.max(self.unit() * shears / self.most).max(third);
        // Places that differ by rounding are one.
        let same = |a: &f64, b: &f64| b - a <= 4.0 * f64::EPSILON * length;
        let places: Vec<[f64; 2]> = places.chunk_by(same).map(|group| [group[0], group[group.len() - 1]]).collect();
        for pair in places.windows(2) {
            let (a, b) = (pair[0][1], pair[1][0]);
            let (from, to) = (self.shear(a)[1], self.shear(b)[0]);
            let [turned, sheared] = [moment_before(exact, b) - exact.moment(a), to - from];
            let [load, lever] = carried(scene, exact, [a, b]);
            let size = moment.max(shears.max(fourth) * (b - a));
            self.check(format!("shear from {a} to {b}"), (sheared + load).abs(), shears.max(fourth));
            self.check(format!("moment from {a} to {b}"), (turned - from * (b - a) + lever).abs(), size);
        }
        for &[from, to] in &places {
            // With the load between places that differ by rounding, which is more than nothing beside a load that is hardly longer.
            let jump = self.shear(to)[1] - self.shear(from)[0] + between(scene, exact, [from, to]);
            let off = concentrated(scene, exact, [from, to]).map(|force| (jump - force).abs());
            self.check(format!("force at {from}"), off[0].min(off[1]), shears);
            if 0.0 < from && to < length {
                let jump = exact.moment(to) - moment_before(exact, from);
                let [down, up] = couples(scene, [from, to]);
                // The spans on either side have the place each with its own last unit.
                let size = moment.max(2.0 * self.unit() * shears / self.most);
                self.check(format!("moment that jumps up at {from}"), if up { 0.0 } else { jump }, size);
                self.check(format!("moment that jumps down at {from}"), if down { 0.0 } else { -jump }, size);
            }
        }
        for (end, at) in [("left", 0.0), ("right", length)] {
            let off = couple_free(scene, at) * exact.moment(at).abs();
            self.check(format!("moment at the {end} end"), off, moment);
        }
    }

    fn balance(&mut self) {
        let state = &self.exact.state;
        let carried: f64 = state.supports.iter().map(|s| s.force).sum::<f64>() + state.contact_force();
        let forces: f64 = state.supports.iter().map(|s| s.force.abs()).sum();
        let off = (self.scene.load().resultant(self.length()) - carried).abs();
        self.check("balance".to_owned(), off, 100.0 * self.force.max(forces));
    }
}

/// The size of what is given across the beam.
fn size(scene: &Scene) -> f64 {
    let length = scene.beam().length();
    let profiles = scene.foundation().into_iter().chain(scene.beam().shape());
    profiles.map(|profile| profile.magnitude(length)).fold(0.0, f64::max)
}

/// 1 at an end of the beam where nothing can hold its slope, and 0 elsewhere.
fn couple_free(scene: &Scene, end: f64) -> f64 {
    // A place nearer to zero than the rounding of the beam's length is at its end.
    let held = scene.held().into_iter().find(|held| (held.at - end).abs() <= f64::EPSILON * scene.beam().length());
    f64::from(held.is_none_or(|held| held.slope.is_none() && held.tangent == [false; 2]))
}

/// The moment just to the left of `x`.
fn moment_before(exact: &Exact, x: f64) -> f64 {
    exact.moment(x.next_down())
}
