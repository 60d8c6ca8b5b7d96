//! A second opinion on the kernel of the certificate: the energies of a deflection and of forces in fractions, without rounding.
//!
//! With `J`, `D`, `g`, `d`, `φ` as at the head of `palkki::certificate`, for any `v` and any `M` that are polynomials on cells:
//!
//! - [`Beam::upper`] asks whether `v` is admissible (smooth, held by its supports, `v ≤ g` everywhere) and returns `J(v) ≥ J*`,
//! - [`Beam::lower`] asks whether `M` is admissible (contact only presses) and returns `D ≤ J*`.
//!
//! Who trusts fractions, these two and [`polynomial`](super::polynomial) knows that `J*` is between, wherever the two fields come
//! from. Numbers of 64 bits are taken as the fractions that they are. The scene says which supports stand where the ground is.

#![expect(clippy::float_cmp, reason = "a place is the same number wherever it is given")]

use dashu_ratio::RBig;
use palkki::scene::{Foundation, Scene};

use super::number::Number;
use super::polynomial::{Polynomial, at, derivative, integral, is_nowhere_negative, plus, product};

/// Polynomials in `x`, each with the part of the beam that it is for.
type Profile = Vec<([f64; 2], Polynomial)>;

/// Why nothing is said.
pub type Unsaid = &'static str;

/// What is given of a beam.
#[derive(Debug)]
pub struct Beam {
    pub(super) length: f64,
    pub(super) stiffness: RBig,
    loads: Profile,
    points: Vec<(f64, RBig)>,
    ground: Profile,
    shape: Profile,
    /// Supports that only push: places and levels.
    alone: Vec<(f64, RBig)>,
    pub(super) supports: Vec<Support>,
    /// All places at which a formula may change, from left to right.
    pub(super) breaks: Vec<f64>,
}

/// What a support asks.
#[derive(Debug)]
pub(super) struct Support {
    pub(super) x: f64,
    pub(super) level: RBig,
    pub(super) slope: Option<RBig>,
    /// Whether the ground on its left and on its right begins at its level, and in its direction.
    pub(super) tangent: [bool; 2],
}

/// `v` and `M` on a part of the beam without a break.
#[derive(Debug, Clone)]
pub struct Cell {
    pub(super) ends: [f64; 2],
    pub(super) v: Polynomial,
    pub(super) moment: Polynomial,
}

impl Cell {
    pub(super) fn places(&self) -> [RBig; 2] {
        self.ends.map(RBig::of)
    }
}

/// The straight line between two points.
fn line(a: [f64; 2], b: [f64; 2]) -> ([f64; 2], Polynomial) {
    let ([x, u], [y, w]) = (a.map(RBig::of), b.map(RBig::of));
    let slope = (w - &u) / (y - &x);
    ([a[0], b[0]], vec![u - &slope * x, slope])
}

fn profile(given: &Foundation, l: f64) -> Result<Profile, Unsaid> {
    Ok(match given {
        Foundation::Flat { depth } => vec![([0.0, l], vec![RBig::of(*depth)])],
        Foundation::Polynomial { coefficients } => {
            vec![([0.0, l], coefficients.iter().map(|c| RBig::of(*c)).collect())]
        }
        Foundation::Polyline { points } => {
            points.windows(2).filter(|p| p[0][0] < p[1][0]).map(|p| line(p[0], p[1])).collect()
        }
        Foundation::Cosine { .. } => return Err("a cosine"),
    })
}

/// The polynomial on a cell.
fn on(profile: &Profile, ends: [f64; 2]) -> Option<&Polynomial> {
    profile.iter().find(|(part, _)| part[0] <= ends[0] && ends[1] <= part[1]).map(|(_, p)| p)
}

/// A polynomial and its derivative at a place.
pub(super) fn jet(p: &[RBig], x: f64) -> [RBig; 2] {
    [at(p, &RBig::of(x)), at(&derivative(p), &RBig::of(x))]
}

impl Beam {
    /// The beam of a scene.
    ///
    /// # Errors
    ///
    /// What it has that fractions have not.
    pub fn of(scene: &Scene) -> Result<Self, Unsaid> {
        let (beam, load, l) = (scene.beam(), scene.load(), scene.beam().length());
        if scene.ground_stiffness().is_some() {
            return Err("ground that gives");
        }
        let parts = load.linear().iter().filter(|q| q.from < q.to).map(|q| line([q.from, q.start], [q.to, q.end]));
        let mut of = Self {
            length: l,
            stiffness: RBig::of(beam.bending_stiffness()),
            loads: parts.chain([([0.0, l], vec![RBig::of(load.uniform())])]).collect(),
            points: load.point().iter().map(|p| (p.at, RBig::of(p.force))).collect(),
            ground: scene.foundation().map_or(Ok(Vec::new()), |ground| profile(ground, l))?,
            shape: profile(beam.shape().unwrap_or(&Foundation::Flat { depth: 0.0 }), l)?,
            alone: Vec::new(),
            supports: Vec::new(),
            breaks: Vec::new(),
        };
        let parts = [&of.loads, &of.ground, &of.shape].into_iter().flatten().flat_map(|(ends, _)| *ends);
        let single = beam.all_supports().into_iter().map(|s| s.at).chain(of.points.iter().map(|p| p.0));
        of.breaks = parts.chain(single).filter(|x| (0.0..=l).contains(x)).collect();
        of.breaks.sort_by(f64::total_cmp);
        of.breaks.dedup();
        let own = |x: f64| on(&of.shape, of.beside(x, l <= x)).map_or([RBig::ZERO, RBig::ZERO], |shape| jet(shape, x));
        let alone = beam.bearings().iter().map(|s| (s.at, RBig::of(s.level) - &own(s.at)[0])).collect();
        let supports = beam.supports().iter().zip(scene.held()).map(|(s, held)| {
            let [level, slope] = own(s.at);
            let ground = |on: [bool; 2]| [0, 1].into_iter().find(|k| on[*k]).and_then(|k| of.side(s.at, k == 0));
            Support {
                x: s.at,
                level: ground(held.at_level).map_or_else(|| RBig::of(s.level) - level, |[g, _]| g),
                slope: s.slope.map(|own| ground(held.tangent).map_or_else(|| RBig::of(own) - slope, |[_, g]| g)),
                tangent: held.tangent,
            }
        });
        (of.supports, of.alone) = (supports.collect(), alone);
        Ok(of)
    }

    /// The ends of the cell beside a place.
    pub(super) fn beside(&self, x: f64, left: bool) -> [f64; 2] {
        let next = if left { self.breaks.iter().rfind(|y| **y < x) } else { self.breaks.iter().find(|y| x < **y) };
        next.map_or([x, f64::INFINITY], |y| [x.min(*y), x.max(*y)])
    }

    /// `g` on a cell; none without ground.
    pub(super) fn gap(&self, ends: [f64; 2]) -> Option<Polynomial> {
        Some(plus(on(&self.ground, ends)?, &RBig::whole(-1), on(&self.shape, ends)?))
    }

    /// `g` and `g'` on one side of a place.
    pub(super) fn side(&self, x: f64, left: bool) -> Option<[RBig; 2]> {
        Some(jet(&self.gap(self.beside(x, left))?, x))
    }

    /// `g(x)`: at a step the smaller of the two, and that of a support that only pushes.
    pub(super) fn depth(&self, x: f64) -> Option<RBig> {
        let sides = [true, false].into_iter().filter_map(|left| self.side(x, left)).map(|[g, _]| g);
        sides.chain(self.alone.iter().filter(|s| s.0 == x).map(|s| s.1.clone())).min()
    }

    pub(super) fn support(&self, x: f64) -> Option<&Support> {
        self.supports.iter().find(|s| s.x == x)
    }

    /// `q` on a cell.
    pub(super) fn load(&self, ends: [f64; 2]) -> Polynomial {
        let acts = self.loads.iter().filter(|(part, _)| part[0] <= ends[0] && ends[1] <= part[1]);
        acts.fold(Vec::new(), |sum, (_, q)| plus(&sum, &RBig::ONE, q))
    }

    pub(super) fn point_load(&self, x: f64) -> RBig {
        self.points.iter().filter(|p| p.0 == x).fold(RBig::ZERO, |sum, p| sum + &p.1)
    }

    /// Whether `v ≤ g` on a cell.
    pub(super) fn is_clear(&self, cell: &Cell) -> bool {
        let below = |(x, level): &(f64, RBig)| !cell.ends.contains(x) || at(&cell.v, &RBig::of(*x)) <= *level;
        let clear = |g: Polynomial| is_nowhere_negative(&plus(&g, &RBig::whole(-1), &cell.v), &cell.places());
        self.gap(cell.ends).is_none_or(clear) && self.alone.iter().all(below)
    }

    /// `J(v) = ½∫EI v''² − ∫q v − ΣP v`, and the sum of the magnitudes of these, if `v` is admissible.
    ///
    /// # Errors
    ///
    /// What it is not.
    pub fn upper(&self, cells: &[Cell]) -> Result<[RBig; 2], Unsaid> {
        let [mut energy, mut size] = [RBig::ZERO, RBig::ZERO];
        let mut add = |part: RBig| {
            energy += &part;
            size += part.magnitude();
        };
        for (i, cell) in cells.iter().enumerate() {
            let bend = derivative(&derivative(&cell.v));
            add(RBig::fraction(1, 2) * &self.stiffness * integral(&product(&bend, &bend), &cell.places()));
            add(RBig::ZERO - integral(&product(&self.load(cell.ends), &cell.v), &cell.places()));
            let before = i.checked_sub(1).map_or((0.0, cell), |i| (cells[i].ends[1], &cells[i]));
            let last = (i + 1 == cells.len()).then_some((self.length, cell.ends[1]));
            for (x, end) in [(before.0, cell.ends[0])].into_iter().chain(last) {
                let [v, slope] = jet(&cell.v, x);
                add(RBig::ZERO - self.point_load(x) * &v);
                if x != end || jet(&before.1.v, cell.ends[0]) != jet(&cell.v, cell.ends[0]) {
                    return Err("a deflection with a kink");
                }
                if self.support(x).is_some_and(|s| s.level != v || s.slope.as_ref().is_some_and(|s| *s != slope)) {
                    return Err("a support that does not hold");
                }
            }
            if !self.is_clear(cell) {
                return Err("a deflection in the ground");
            }
        }
        Ok([energy, size])
    }

    /// `D = −½∫M²/EI − ∫g p − ΣF g − ΣR d + ΣC φ`, if contact only presses: `p = M'' + q` in cells, and between them forces `F`, those
    /// of supports `R`, and couples `C`, by which `M'` and `M` jump.
    ///
    /// # Errors
    ///
    /// What does not.
    pub fn lower(&self, cells: &[Cell]) -> Result<RBig, Unsaid> {
        let mut energy = RBig::ZERO;
        let mut before = [RBig::ZERO, RBig::ZERO];
        for cell in cells.iter().map(Some).chain([None]) {
            let x = cell.map_or(self.length, |cell| cell.ends[0]);
            let [m, shear] = cell.map_or([RBig::ZERO, RBig::ZERO], |cell| jet(&cell.moment, x));
            let (couple, force) = (m - &before[0], shear - &before[1] + self.point_load(x));
            let support = self.support(x);
            if let Some(support) = support {
                energy -= force * &support.level;
            } else if !force.is_zero() {
                energy -= self.depth(x).filter(|_| RBig::ZERO < force).ok_or("a force that pulls")? * &force;
            }
            if !couple.is_zero() {
                // Ground that begins at a support makes a couple: the limit of forces that are nearer and nearer to it.
                let left = RBig::ZERO < couple;
                let ground = support.filter(|s| s.tangent[usize::from(!left)]).and_then(|_| self.side(x, left));
                let slope = support.and_then(|s| s.slope.clone()).or(ground.map(|[_, slope]| slope));
                energy += slope.ok_or("a couple")? * couple;
            }
            let Some(cell) = cell else { break };
            energy -=
                integral(&product(&cell.moment, &cell.moment), &cell.places()) / (RBig::whole(2) * &self.stiffness);
            let pressure = plus(&derivative(&derivative(&cell.moment)), &RBig::ONE, &self.load(cell.ends));
            if pressure.iter().any(|c| !c.is_zero()) {
                let gap = self.gap(cell.ends).filter(|_| is_nowhere_negative(&pressure, &cell.places()));
                energy -= integral(&product(&gap.ok_or("a pressure that pulls")?, &pressure), &cell.places());
            }
            before = jet(&cell.moment, cell.ends[1]);
        }
        Ok(energy)
    }
}
