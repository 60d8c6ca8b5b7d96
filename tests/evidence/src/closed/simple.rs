//! The paper's beam, simply supported at both ends, above ground with a solution in closed form, each with its derivation.
//!
//! All use one result. Beside a zone let `s` be the distance from the lift-off point, where `h = h' = h'' = 0`, under a
//! uniform load and with `u''''= 0`:
//!
//! ```text
//! EI h'''' = −q,      h = R s³ / (6 EI) − q s⁴ / (24 EI)         R the concentrated force at the lift-off point
//! ```

use palkki::scene::{Beam, Foundation, SceneError};
use palkki::state::{Contact, Regime};

use super::Closed;
use super::forms::{EI, Q, at, zone};

/// Beam theory for a flat or parabolic foundation and a uniform load; made by [`flat`] and [`parabola`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatSolution {
    length: f64,
    bending_stiffness: f64,
    depth: f64,
    rise: f64,
    load: f64,
    /// Which of the three regimes.
    pub regime: Regime,
    /// Length `a` that is lifted off at each end; `l/2` with contact at mid-span, [`None`] without contact \[length\].
    pub lift_off: Option<f64>,
    /// Reaction `T` of each support, upwards \[force\].
    pub reaction: f64,
    /// Resultant of the contact, upwards \[force\].
    pub contact_force: f64,
    /// Concentrated force at each lift-off point, `R`; zero unless the regime is [`Regime::Zone`] \[force\].
    pub end_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// The exact solution for a beam of `length` \[length\] and `bending_stiffness` \[force · length²\], both positive, above a
/// flat foundation at `depth` ≥ 0 \[length\], under a uniform load \[force / length\], positive downwards.
#[must_use]
pub fn flat(length: f64, bending_stiffness: f64, depth: f64, load: f64) -> FlatSolution {
    parabola(length, bending_stiffness, depth, 0.0, load)
}

/// The same above `u = depth + 4 rise x (l − x)/l²`, `depth` ≥ 0: a dish for `rise` > 0, a crest for `rise` < 0, under a
/// uniform `load` ≥ 0. A crest that starts at the supports (`depth` = 0) would clamp the beam and has no closed form here.
///
/// With the curvature `w = u'' = −8 rise/l²` of the foundation a zone is pressed with `q`, since `u'''' = 0`. Beside it the beam is
/// lifted off over the length `a`; at the support `v'' = 0`, so `h'' = w`, and `h = u₀`:
///
/// ```text
/// R a/EI − q a²/(2 EI) = w,     R a³/(6 EI) − q a⁴/(24 EI) = u₀
/// R = q a/2 + EI w/a,     q a⁴/(24 EI) + w a²/6 = u₀,     T = q a − R = q a/2 − EI w/a,     M = x (T − q x/2)
/// J = q² a⁵/(30 EI) + EI w² (l/2 − 2a/3) − q l (u₀ + 2 rise/3)
/// ```
///
/// a quadratic equation for `a²`, on flat ground `a⁴ = 24 EI u₀/q`. It needs `a ≤ l/2`. Beyond that the beam touches at mid-span
/// only, with the force that brings the free beam back to the foundation, until that vanishes and the beam is free:
///
/// ```text
/// F = 5 q l/8 − 48 EI (u₀ + rise)/l³,     T = (q l − F)/2,     J = −q² l⁵/(240 EI) + F² l³/(96 EI)
/// ```
#[must_use]
pub fn parabola(length: f64, bending_stiffness: f64, depth: f64, rise: f64, load: f64) -> FlatSolution {
    let (l, ei, q) = (length, bending_stiffness, load);
    let free = FlatSolution {
        length,
        bending_stiffness,
        depth,
        rise,
        load,
        regime: Regime::None,
        lift_off: None,
        reaction: 0.5 * q * l,
        contact_force: 0.0,
        end_force: 0.0,
        energy: -q * q * l * l * l * l * l / (240.0 * ei),
    };
    // Multiplied out so that a beam without load needs no division, and the force factored so that it fades out without
    // cancellation at the border to the free beam.
    let unit = q * l * l * l * l;
    let force = (5.0 * unit - 384.0 * ei * (depth + rise)) / (8.0 * l * l * l);
    if force <= 0.0 {
        return free;
    }
    let w = -8.0 * rise / (l * l);
    let root = (w * w / 36.0 + q * depth / (6.0 * ei)).sqrt();
    // The positive root a², in the form that does not cancel.
    let square = if 0.0 < w { 2.0 * depth / (w / 6.0 + root) } else { 12.0 * ei / q * (root - w / 6.0) };
    let a = square.sqrt();
    if 128.0 * ei * (3.0 * depth + rise) <= unit && (0.0 < a || w <= 0.0) {
        let curved = if w == 0.0 { 0.0 } else { ei * w / a };
        let reaction = 0.5 * q * a - curved;
        return FlatSolution {
            regime: Regime::Zone,
            lift_off: Some(a),
            reaction,
            contact_force: q * l - 2.0 * reaction,
            end_force: 0.5 * q * a + curved,
            energy: q * q * a * a * a * a * a / (30.0 * ei) + ei * w * w * (0.5 * l - 2.0 * a / 3.0)
                - q * l * (depth + 2.0 * rise / 3.0),
            ..free
        };
    }
    FlatSolution {
        regime: Regime::Points,
        lift_off: Some(0.5 * l),
        reaction: 0.5 * (q * l - force),
        contact_force: force,
        energy: free.energy + force * force * l * l * l / (96.0 * ei),
        ..free
    }
}

impl FlatSolution {
    /// `v(x)`, positive downwards \[length\].
    #[must_use]
    pub fn deflection(&self, x: f64) -> f64 {
        if self.regime == Regime::Zone {
            return self.ground(x) - self.clearance(x);
        }
        // From M = T x − q x²/2 and v'(l/2) = 0.
        let x = self.nearer_support(x);
        let (l, t, q) = (self.length, self.reaction, self.load);
        let slope = t * l * l / 8.0 - q * l * l * l / 48.0;
        x * (slope - x * x * (t / 6.0 - q * x / 24.0)) / self.bending_stiffness
    }

    /// `h(x) = u(x) − v(x)` \[length\].
    #[must_use]
    pub fn clearance(&self, x: f64) -> f64 {
        match (self.regime, self.lift_off) {
            (Regime::Zone, Some(a)) => {
                let s = (a - self.nearer_support(x)).max(0.0);
                s * s * s * (4.0 * self.end_force - self.load * s) / (24.0 * self.bending_stiffness)
            }
            _ => self.ground(x) - self.deflection(x),
        }
    }

    /// `M(x) = −EI v''`, positive with the underside in tension \[force · length\].
    #[must_use]
    pub fn moment(&self, x: f64) -> f64 {
        let x = self.nearer_support(x);
        match (self.regime, self.lift_off) {
            (Regime::Zone, Some(a)) if a <= x => 8.0 * self.bending_stiffness * self.rise / (self.length * self.length),
            _ => x * (self.reaction - 0.5 * self.load * x),
        }
    }

    /// Contact pressure `p(x)` without the concentrated forces: `q` inside the zone \[force / length\].
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        match (self.regime, self.lift_off) {
            (Regime::Zone, Some(a)) if a <= self.nearer_support(x) => self.load,
            _ => 0.0,
        }
    }

    /// `u(x)`.
    fn ground(&self, x: f64) -> f64 {
        self.depth + 4.0 * self.rise * (x / self.length) * (1.0 - x / self.length)
    }

    /// Distance of `x` from the nearer support: the solution is symmetric.
    fn nearer_support(&self, x: f64) -> f64 {
        x.min(self.length - x)
    }
}

/// Beam theory for an inclined foundation; made by [`incline`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Incline {
    /// Lengths that are lifted off at the left and the right end \[length\].
    pub lift_off: [f64; 2],
    /// Reactions, and the equal concentrated forces at the lift-off points \[force\].
    pub reactions: [f64; 2],
    /// Resultant of the contact \[force\].
    pub contact_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// A beam that rests with a zone on the plane through `depths` ≥ 0 below its two supports, under a uniform `load` > 0.
/// [`None`] if the plane is so deep that there is no zone.
///
/// A plane has `u'' = 0`, so at the support `h'' = 0` and `h = u` there:
///
/// ```text
/// R = q a / 2,     a⁴ = 24 EI u_end / q,     T = q a − R = q a / 2         at each end by itself
/// J = Σ (½∫ EI h''² + ∫ q h) − ∫ q u = Σ q² a⁵ / (60 EI) − q l (u_left + u_right) / 2
/// ```
#[must_use]
pub fn incline(length: f64, bending_stiffness: f64, depths: [f64; 2], load: f64) -> Option<Incline> {
    let (l, ei, q) = (length, bending_stiffness, load);
    let lift_off = depths.map(|u| (24.0 * ei * u / q).sqrt().sqrt());
    let reactions = lift_off.map(|a| 0.5 * q * a);
    let bent: f64 = lift_off.iter().map(|a| q * q * a * a * a * a * a / (60.0 * ei)).sum();
    (lift_off[0] + lift_off[1] <= l).then(|| Incline {
        lift_off,
        reactions,
        contact_force: q * l - reactions[0] - reactions[1],
        energy: bent - 0.5 * q * l * (depths[0] + depths[1]),
    })
}

/// Beam theory for a beam that is lifted off a flat foundation at mid-span; made by [`lifted`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lifted {
    /// The two zones, `[from, to]` \[length\].
    pub zones: [[f64; 2]; 2],
    /// Reaction of each support, and the equal concentrated force at the outer end of each zone \[force\].
    pub reaction: f64,
    /// Concentrated force at the inner end of each zone \[force\].
    pub inner_force: f64,
    /// Resultant of each zone \[force\].
    pub zone_force: f64,
    /// `J(v)` of (17) \[force · length\].
    pub energy: f64,
}

/// A beam above a flat foundation at `depth` > 0 under a uniform `load` > 0 and a `lift` > 0 upwards at mid-span.
/// [`None`] unless it rests on two zones.
///
/// The outer ends are those of [`flat()`]. Over the gap of length `g` the beam is clamped at both ends (`h = h' = 0`), and
/// its clamping moments vanish as well (`h'' = 0`):
///
/// ```text
/// lift g/8 − q g²/12 = 0:     g = 3 lift/(2 q),     inner force = (q g − lift)/2 = lift/4
/// J = J_flat + lift u₀ − ½ (lift h_middle − q ∫h),     h_middle = lift g³/192 EI − q g⁴/384 EI,  ∫h = lift g⁴/384 EI − q g⁵/720 EI
/// ```
#[must_use]
pub fn lifted(length: f64, bending_stiffness: f64, depth: f64, load: f64, lift: f64) -> Option<Lifted> {
    let (l, ei, q, p) = (length, bending_stiffness, load, lift);
    let flat = flat(length, bending_stiffness, depth, load);
    let a = flat.lift_off?;
    let g = 1.5 * p / q;
    let (inner, outer) = (0.5 * (l - g), 0.5 * (l + g));
    if inner <= a {
        return None;
    }
    let middle = (p * g * g * g / 192.0 - q * g * g * g * g / 384.0) / ei;
    let area = (p * g * g * g * g / 384.0 - q * g * g * g * g * g / 720.0) / ei;
    Some(Lifted {
        zones: [[a, inner], [outer, l - a]],
        reaction: flat.reaction,
        inner_force: 0.25 * p,
        zone_force: flat.reaction + q * (inner - a) + 0.25 * p,
        energy: flat.energy + p * depth - 0.5 * (p * middle - q * area),
    })
}

/// The paper's beam on a zone, on a point, or nowhere: above flat ground, dishes and crests, and on a zone of inclines.
///
/// # Errors
///
/// None for these numbers.
pub fn simple() -> Result<Vec<Closed>, SceneError> {
    let l = 7.0;
    let beam = Beam::new(l, EI)?;
    // Here a zone on flat ground becomes a point.
    let unit = Q * l * l * l * l / (384.0 * EI);
    let mut found = Vec::new();
    let flat = [1e-4, 0.01, 0.5, 0.9, 1.1, 3.0, 4.9, 6.0].map(|depth| (depth, 0.0));
    // Dishes, two of them from the supports, and crests, one of them above the supports.
    let curved =
        [(0.05, 0.25), (0.0, 3.5), (0.0, 6.0), (0.15, -0.05), (1.0, -0.5), (3.0, -0.5), (0.05, -0.45), (10.0, -0.25)];
    for (depth, rise) in flat.into_iter().chain(curved) {
        let form = parabola(l, EI, depth * unit, rise * unit, Q);
        let contacts: Vec<Contact> = match (form.regime, form.lift_off) {
            (Regime::Zone, Some(a)) => vec![zone(a, l - a)],
            (_, Some(middle)) => vec![at(middle)],
            (_, None) => Vec::new(),
        };
        let coefficients = vec![depth * unit, 4.0 * rise * unit / l, -4.0 * rise * unit / (l * l)];
        let ground = match rise {
            0.0 => Foundation::Flat { depth: depth * unit },
            _ => Foundation::Polynomial { coefficients },
        };
        let name = format!("simple, {depth} deep with a rise of {rise}");
        found.push(Closed::new(&name, &beam, Q, Some(ground), &contacts, |x| form.deflection(x))?);
    }
    for depths in [[0.1, 0.4], [1.0, 0.001], [0.0, 0.5], [0.0, 0.0]] {
        let Some(Incline { lift_off: [a, b], .. }) = incline(l, EI, depths, Q) else { continue };
        let lifted = |a: f64, x: f64| {
            let s = (a - x).max(0.0);
            Q * s * s * s * (2.0 * a - s) / (24.0 * EI)
        };
        let ground = |x: f64| depths[0] + (depths[1] - depths[0]) / l * x;
        let v = |x: f64| ground(x) - lifted(a, x) - lifted(b, l - x);
        let points = Foundation::Polyline { points: vec![[0.0, depths[0]], [l, depths[1]]] };
        let plane = Foundation::Polynomial { coefficients: vec![depths[0], (depths[1] - depths[0]) / l] };
        for (kind, foundation) in [("points", points), ("a polynomial", plane)] {
            let name = format!("simple, inclined from {} to {}, by {kind}", depths[0], depths[1]);
            found.push(Closed::new(&name, &beam, Q, Some(foundation), &[zone(a, l - b)], v)?);
        }
    }
    Ok(found)
}
