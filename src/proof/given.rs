//! A scene in rational arithmetic: its supports, foundation and loads along the beam.

#![expect(clippy::float_cmp, reason = "a place is the same number wherever it is given")]

use dashu_ratio::RBig;

use super::Unproven;
use super::polynomial::{Polynomial, exactly, is_nowhere_negative, jet, plus, shifted};
use crate::scene::{Beam, Foundation, Profile as Of, Scene};

/// Polynomials in `x`, each with its part of the beam.
type Profile = Vec<([f64; 2], Polynomial)>;

/// The data of a beam. Positions are 64-bit numbers. All polynomials that are returned count from the left end of their part.
#[derive(Debug)]
pub(super) struct Given {
    pub(super) length: f64,
    /// `EI` on each part.
    bending: Vec<([f64; 2], RBig)>,
    /// Joints with their stiffness; a hinge has none.
    pub(super) joints: Vec<(f64, Option<RBig>)>,
    /// `N`, zero without tension.
    pub(super) tension: RBig,
    /// `k` of an elastic foundation, in parts; empty for a rigid one.
    soil: Vec<([f64; 2], RBig)>,
    loads: Profile,
    /// Point loads and couples.
    acting: Vec<(f64, [RBig; 2])>,
    ground: Profile,
    shape: Profile,
    /// Single positions that the beam must not be below: rigid compression-only supports, and the edge of a step at an end of the beam.
    alone: Vec<(f64, RBig)>,
    pub(super) supports: Vec<Support>,
    /// Elastic supports; of the compression-only ones, those that are pressed.
    pub(super) elastic: Vec<Elastic>,
    /// All positions at which a formula may change, from left to right; and those at which the formula of a beam without contact changes.
    breaks: Vec<f64>,
    hanging_breaks: Vec<f64>,
}

/// A rigid support, or a pressed compression-only one.
#[derive(Debug)]
pub(super) struct Support {
    pub(super) x: f64,
    pub(super) level: RBig,
    /// The slope that it prescribes.
    pub(super) slope: Option<RBig>,
    /// A rotational spring, `k_t` and `φ`.
    pub(super) turning: Option<[RBig; 2]>,
    /// Whether the foundation to the left and to the right begins at its level and in its direction.
    pub(super) tangent: [bool; 2],
    pub(super) pushes_only: bool,
}

/// An elastic support: `R = k_s (v − d)`, and `M` jumps by `−k_t (v' − φ)`.
#[derive(Debug)]
pub(super) struct Elastic {
    pub(super) x: f64,
    pub(super) stiffness: RBig,
    pub(super) level: RBig,
    pub(super) turning: Option<[RBig; 2]>,
}

/// The straight line between two points.
fn line(a: [f64; 2], b: [f64; 2]) -> ([f64; 2], Polynomial) {
    let ([x, u], [y, w]) = (a.map(exactly), b.map(exactly));
    let slope = (w - &u) / (y - &x);
    ([a[0], b[0]], vec![u - &slope * x, slope])
}

fn profile(of: Of, given: &Foundation, l: f64) -> Result<Profile, Unproven> {
    Ok(match given {
        Foundation::Flat { depth } => vec![([0.0, l], vec![exactly(*depth)])],
        Foundation::Polynomial { coefficients } => {
            vec![([0.0, l], coefficients.iter().map(|c| exactly(*c)).collect())]
        }
        Foundation::Polyline { points } => {
            points.windows(2).filter(|p| p[0][0] < p[1][0]).map(|p| line(p[0], p[1])).collect()
        }
        Foundation::Cosine { .. } => return Err(Unproven::Cosine { of }),
    })
}

/// The polynomial on a part.
fn on(profile: &Profile, ends: [f64; 2]) -> Option<&Polynomial> {
    let part = profile.get(profile.partition_point(|(part, _)| part[1] < ends[1]))?;
    (part.0[0] <= ends[0]).then_some(&part.1)
}

/// `EI` of a beam, in parts.
fn bending(beam: &Beam) -> Vec<([f64; 2], RBig)> {
    let (l, least) = (beam.length(), [[0.0, beam.bending_stiffness()]]);
    let steps = if beam.steps().is_empty() { &least[..] } else { beam.steps() };
    let ends = steps.iter().skip(1).map(|step| step[0]).chain([l]);
    steps.iter().zip(ends).map(|(&[from, stiffness], to)| ([from, to], exactly(stiffness))).collect()
}

fn sorted(places: impl Iterator<Item = f64>, l: f64) -> Vec<f64> {
    let mut places: Vec<f64> = places.filter(|x| (0.0..=l).contains(x)).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

impl Given {
    /// Number of power series terms beyond the cubic under tension, on parts that are short enough for it.
    pub(super) const TERMS: usize = 9;

    /// The beam of a scene. `press` are the positions of the compression-only supports that are pressed.
    ///
    /// # Errors
    ///
    /// [`Unproven::Cosine`], and [`Unproven::AboveSupport`] if nothing is admissible without rounding.
    pub(super) fn of(scene: &Scene, press: &[f64]) -> Result<Self, Unproven> {
        let (beam, load, l) = (scene.beam(), scene.load(), scene.beam().length());
        let soil = scene.ground_parts().map(|(ends, k)| (ends, exactly(k))).collect();
        let parts = load.linear().iter().filter(|q| q.from < q.to).map(|q| line([q.from, q.start], [q.to, q.end]));
        let level = Foundation::Flat { depth: 0.0 };
        let mut given = Self {
            length: l,
            bending: bending(beam),
            joints: beam.joints().iter().map(|joint| (joint.at, joint.stiffness.map(exactly))).collect(),
            tension: exactly(beam.tension()),
            loads: parts.chain([([0.0, l], vec![exactly(load.uniform())])]).collect(),
            acting: load.concentrated().map(|acts| (acts.at, [acts.force, acts.couple].map(exactly))).collect(),
            ground: scene.foundation().map_or(Ok(Vec::new()), |ground| profile(Of::Foundation, ground, l))?,
            shape: profile(Of::Shape, beam.shape().unwrap_or(&level), l)?,
            soil,
            alone: Vec::new(),
            supports: Vec::new(),
            elastic: Vec::new(),
            breaks: Vec::new(),
            hanging_breaks: Vec::new(),
        };
        let ends = |profile: &Profile| profile.iter().flat_map(|(ends, _)| *ends).collect::<Vec<f64>>();
        let acts = given.acting.iter().map(|acts| acts.0).chain(given.joints.iter().map(|joint| joint.0));
        let changes = given.bending.iter().map(|(ends, _)| ends[0]).chain(beam.springs().iter().map(|s| s.at));
        given.hanging_breaks = sorted(ends(&given.loads).into_iter().chain(acts).chain(changes), l);
        let soil = given.soil.iter().map(|(ends, _)| ends[0]);
        let parts = [&given.ground, &given.shape].map(ends).concat().into_iter().chain(soil).collect::<Vec<f64>>();
        let single = beam.all_supports().into_iter().map(|s| s.at).chain(given.hanging_breaks.iter().copied());
        given.breaks = sorted(parts.into_iter().chain(single), l);
        given.cut_for_tension(scene);
        given.edges(scene);
        given.stand(scene, press)?;
        Ok(given)
    }

    /// Cuts parts without contact so short that a power series has enough digits.
    fn cut_for_tension(&mut self, scene: &Scene) {
        /// Parts per length `√(EI/N)`, over which a beam in tension decays. With [`TERMS`](Self::TERMS) the series has an error of 1e-14.
        const PARTS: f64 = 2.0;
        let decays = libm::sqrt(self.tension.to_f64().value().abs() / scene.beam().bending_stiffness());
        let count = libm::ceil(PARTS * self.length * decays);
        let places = (1_u32..).map(f64::from).take_while(|i: &f64| *i < count).map(|i| self.length * i / count);
        self.hanging_breaks = sorted(self.hanging_breaks.iter().copied().chain(places), self.length);
    }

    /// Records the edges of steps at the ends of the beam, where there is no part of the beam on the other side.
    fn edges(&mut self, scene: &Scene) {
        let Some(Foundation::Polyline { points }) = scene.foundation().filter(|_| !self.is_on_soil()) else {
            return;
        };
        for x in [0.0, self.length] {
            let depth = points.iter().filter(|point| point[0] == x).map(|point| exactly(point[1])).min();
            if let Some(depth) = depth {
                self.alone.push((x, depth - &self.own(x)[0]));
            }
        }
    }

    /// Records the supports.
    fn stand(&mut self, scene: &Scene, press: &[f64]) -> Result<(), Unproven> {
        let tangents = scene.held();
        let all = scene.beam().all_supports();
        for support in &all {
            let [own, turn] = self.own(support.at);
            let (x, level, pushes_only) = (support.at, exactly(support.level) - own, support.pushes_only);
            let slope = support.slope.map(|slope| exactly(slope) - turn);
            let turning = support.turning_stiffness.zip(slope.clone()).map(|(k, slope)| [exactly(k), slope]);
            let presses = !pushes_only || press.contains(&x);
            if let Some(k) = support.stiffness {
                let spring = Elastic { x, stiffness: exactly(k), level, turning };
                self.elastic.extend(presses.then_some(spring));
                continue;
            }
            if pushes_only {
                self.alone.push((x, level.clone()));
            }
            if presses {
                if !pushes_only && !self.is_on_soil() && self.depth(x).is_some_and(|g| g < level) {
                    return Err(Unproven::AboveSupport { at: x });
                }
                let tangent = tangents.iter().find(|held| held.at == x).map_or([false; 2], |h| h.tangent);
                let slope = slope.filter(|_| support.is_built_in());
                self.supports.push(Support { x, level, slope, turning, tangent, pushes_only });
            }
        }
        Ok(())
    }

    /// `w0` and `w0'` at a position.
    fn own(&self, x: f64) -> [RBig; 2] {
        on(&self.shape, self.beside(x, 0.0 < x)).map_or([RBig::ZERO, RBig::ZERO], |shape| jet(shape, &exactly(x)))
    }

    /// The ends of the part to the left or to the right of a position.
    fn beside(&self, x: f64, left: bool) -> [f64; 2] {
        let next = if left {
            self.breaks.partition_point(|y| *y < x).checked_sub(1).and_then(|i| self.breaks.get(i))
        } else {
            self.breaks.get(self.breaks.partition_point(|y| *y <= x))
        };
        next.map_or([x, f64::INFINITY], |y| [x.min(*y), x.max(*y)])
    }

    /// Whether the foundation is elastic.
    pub(super) fn is_on_soil(&self) -> bool {
        !self.soil.is_empty()
    }

    /// `k` on a part without a break; zero on a rigid foundation.
    pub(super) fn soil(&self, ends: [f64; 2]) -> RBig {
        let i = self.soil.partition_point(|(part, _)| part[1] < ends[1]);
        self.soil.get(i).or(self.soil.last()).map_or(RBig::ZERO, |(_, k)| k.clone())
    }

    /// `g` on a part without a break; [`None`] without a foundation.
    pub(super) fn gap(&self, ends: [f64; 2]) -> Option<Polynomial> {
        if self.is_on_soil() && self.soil(ends).is_zero() {
            return None;
        }
        let gap = plus(on(&self.ground, ends)?, &-RBig::ONE, on(&self.shape, ends)?);
        Some(shifted(&gap, &exactly(ends[0])))
    }

    /// `g` and its derivatives on one side of a position, as a polynomial about it.
    pub(super) fn about(&self, x: f64, left: bool) -> Option<Polynomial> {
        let ends = self.beside(x, left);
        Some(shifted(&self.gap(ends)?, &(exactly(x) - exactly(ends[0]))))
    }

    /// `g` and `g'` on one side of a position.
    pub(super) fn gap_beside(&self, x: f64, left: bool) -> Option<[RBig; 2]> {
        Some(jet(&self.about(x, left)?, &RBig::ZERO))
    }

    /// `g(x)` of everything rigid: at a step the smaller of the two gaps, or the gap of a compression-only support.
    pub(super) fn depth(&self, x: f64) -> Option<RBig> {
        let sides = [true, false].into_iter().filter(|_| !self.is_on_soil());
        let sides = sides.filter_map(|left| self.gap_beside(x, left)).map(|[g, _]| g);
        sides.chain(self.alone.iter().filter(|s| s.0 == x).map(|s| s.1.clone())).min()
    }

    /// `EI` on a part without a break.
    pub(super) fn bending(&self, ends: [f64; 2]) -> &RBig {
        let i = self.bending.partition_point(|(part, _)| part[1] < ends[1]).min(self.bending.len() - 1);
        &self.bending[i].1
    }

    /// `EI` on one side of a position.
    pub(super) fn bending_beside(&self, x: f64, left: bool) -> &RBig {
        self.bending(self.beside(x, left))
    }

    /// The joint at a position.
    pub(super) fn joint(&self, x: f64) -> Option<&Option<RBig>> {
        self.joints.iter().find(|joint| joint.0 == x).map(|joint| &joint.1)
    }

    /// The rotational spring at a position: `k_t` and `φ`.
    pub(super) fn turning(&self, x: f64) -> Option<&[RBig; 2]> {
        let springs = self.elastic.iter().map(|spring| (spring.x, &spring.turning));
        let supports = self.supports.iter().map(|support| (support.x, &support.turning));
        springs.chain(supports).find(|(at, _)| *at == x).and_then(|(_, turning)| turning.as_ref())
    }

    pub(super) fn support(&self, x: f64) -> Option<&Support> {
        let support = self.supports.get(self.supports.partition_point(|s| s.x < x))?;
        (support.x == x).then_some(support)
    }

    /// `q` on a part without a break of loads.
    pub(super) fn load(&self, ends: [f64; 2]) -> Polynomial {
        let acts = self.loads.iter().filter(|(part, _)| part[0] <= ends[0] && ends[1] <= part[1]);
        shifted(&acts.fold(Vec::new(), |sum, (_, q)| plus(&sum, &RBig::ONE, q)), &exactly(ends[0]))
    }

    /// The point load and the couple at a position.
    pub(super) fn acting(&self, x: f64) -> [RBig; 2] {
        let here = self.acting.iter().filter(|acts| acts.0 == x);
        here.fold([RBig::ZERO, RBig::ZERO], |[force, couple], (_, acts)| [force + &acts[0], couple + &acts[1]])
    }

    pub(super) fn point_load(&self, x: f64) -> RBig {
        let [force, _] = self.acting(x);
        force
    }

    /// The parts without a break between two positions. With `hangs` only breaks that affect a beam without contact count.
    pub(super) fn parts(&self, [from, to]: [f64; 2], hangs: bool) -> Vec<[f64; 2]> {
        let breaks = if hangs { &self.hanging_breaks } else { &self.breaks };
        let inside = breaks.iter().copied().filter(|x| from < *x && *x < to);
        let places: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
        places.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    /// Whether `v ≤ g` on a part, `v` about its left end.
    pub(super) fn is_clear(&self, ends: [f64; 2], v: &[RBig]) -> bool {
        let from = exactly(ends[0]);
        let below = |(x, level): &&(f64, RBig)| *level < jet(v, &(exactly(*x) - &from))[0];
        if self.alone.iter().filter(|(x, _)| (ends[0]..=ends[1]).contains(x)).any(|alone| below(&alone)) {
            return false;
        }
        self.parts(ends, false).into_iter().all(|part| {
            let Some(gap) = self.gap(part) else { return true };
            let [start, end] = part.map(exactly);
            let clear = plus(&gap, &-RBig::ONE, &shifted(v, &(&start - &from)));
            is_nowhere_negative(&clear, &(end - start))
        })
    }
}
