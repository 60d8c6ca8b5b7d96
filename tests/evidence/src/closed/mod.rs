//! Closed forms: of the paper's beam, and of beams on any supports, with own shapes, free ends and none to hold them.
//!
//! Under a uniform load, above ground of at most the second degree, a deflection is a polynomial of the fourth degree between
//! neighbours among the ends of the beam, its supports and the ends of its contacts. Five values define it:
//!
//! ```text
//! v = c₀ + c₁ s + c₂ s² + c₃ s³ + c₄ s⁴              s from the middle of a piece, |s| ≤ a
//! J = Σ ½ EI ∫v''² ds − q ∫v ds                      (17)
//! R = EI (v'''(x − 0) − v'''(x + 0))                 at a support; v''' = 0 beyond the ends
//! ```
//!
//! Nothing is solved here, and nothing is shared with theory, which proposes the contacts of other answers.

mod forms;
mod opened;
mod shear;
mod simple;
mod stiff;

pub use forms::{EI, Q, between, built_in, overhang};
pub use opened::{Opened, opened};
pub use shear::{Sheared, lifting_discontinuity, sheared};
pub use simple::{FlatSolution, Incline, Lifted, flat, incline, lifted, parabola, simple};

pub use stiff::{Stiff, Strip, gap_opens, stiff, strip};

use palkki::scene::{Beam, Foundation, Load, Scene, SceneError};
use palkki::state::Contact;

/// A scene whose answer is known without solving it.
#[derive(Debug, Clone)]
pub struct Closed {
    /// What it is, in words.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// Its contacts; only their places count.
    pub contacts: Vec<Contact>,
    pieces: Vec<Quartic>,
}

/// All of them: [`simple()`] and [`held()`].
///
/// # Errors
///
/// None for these numbers; a [`SceneError`] would say which scene is not well posed.
pub fn all() -> Result<Vec<Closed>, SceneError> {
    Ok([simple()?, held()?].concat())
}

/// All that are held otherwise than by a simple support at each end.
///
/// # Errors
///
/// As of [`all`].
pub fn held() -> Result<Vec<Closed>, SceneError> {
    Ok([built_in()?, forms::spans()?, forms::own_shapes()?, forms::free()?].into_iter().flatten().collect())
}

/// The zero between two places of a function that rises there.
fn bisected(mut lo: f64, mut hi: f64, of: impl Fn(f64) -> f64) -> f64 {
    /// Until two neighbouring numbers are left.
    const HALVINGS: usize = 100;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (lo + hi);
        *(if of(middle) < 0.0 { &mut lo } else { &mut hi }) = middle;
    }
    0.5 * (lo + hi)
}

/// A polynomial of the fourth degree on a piece of the beam, in powers of the distance from the middle of the piece.
#[derive(Debug, Clone, Copy)]
struct Quartic {
    middle: f64,
    /// Half of the width of the piece.
    half: f64,
    c: [f64; 5],
}

impl Quartic {
    /// The one with five values of a function: both ends of the piece, its middle, and half way between.
    fn through(from: f64, to: f64, v: impl Fn(f64) -> f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let h = 0.5 * half;
        let [f0, f1, f2, f3, f4] = [from, middle - h, middle, middle + h, to].map(v);
        let c = [
            f2,
            (f0 - 8.0 * f1 + 8.0 * f3 - f4) / (12.0 * h),
            (-f0 + 16.0 * f1 - 30.0 * f2 + 16.0 * f3 - f4) / (24.0 * h * h),
            (-f0 + 2.0 * f1 - 2.0 * f3 + f4) / (12.0 * h * h * h),
            (f0 - 4.0 * f1 + 6.0 * f2 - 4.0 * f3 + f4) / (24.0 * h * h * h * h),
        ];
        Self { middle, half, c }
    }

    fn at(&self, x: f64) -> f64 {
        self.c.iter().rev().fold(0.0, |sum, c| sum * (x - self.middle) + c)
    }

    fn second(&self, x: f64) -> f64 {
        let s = x - self.middle;
        2.0 * self.c[2] + 6.0 * self.c[3] * s + 12.0 * self.c[4] * s * s
    }

    /// `v'''` at one end, −1 for the left one and 1 for the right one.
    fn third(&self, end: f64) -> f64 {
        6.0 * self.c[3] + 24.0 * self.c[4] * self.half * end
    }

    /// `½ EI ∫v''² ds − q ∫v ds`.
    fn energy(&self, stiffness: f64, load: f64) -> f64 {
        let Self { half: a, c: [c0, _, c2, c3, c4], .. } = *self;
        let (cube, fifth) = (a * a * a / 3.0, a * a * a * a * a / 5.0);
        let bending =
            8.0 * c2 * c2 * a + 2.0 * cube * (36.0 * c3 * c3 + 48.0 * c2 * c4) + 2.0 * fifth * 144.0 * c4 * c4;
        0.5 * stiffness * bending - load * (2.0 * c0 * a + 2.0 * cube * c2 + 2.0 * fifth * c4)
    }
}

impl Closed {
    /// A beam under a uniform load with the deflection `v` and these contacts.
    fn new(
        name: &str,
        beam: &Beam,
        load: f64,
        ground: Option<Foundation>,
        contacts: &[Contact],
        v: impl Fn(f64) -> f64,
    ) -> Result<Self, SceneError> {
        let scene = Scene::new(beam.clone(), Load::uniform_on(beam, load)?, ground)?;
        let ends = [0.0, beam.length()].into_iter().chain(beam.supports().iter().map(|s| s.at));
        let mut places: Vec<f64> = ends.chain(contacts.iter().flat_map(|c| [c.from, c.to])).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let pieces = places.windows(2).map(|piece| Quartic::through(piece[0], piece[1], &v)).collect();
        Ok(Self { name: name.to_owned(), scene, contacts: contacts.to_vec(), pieces })
    }

    /// `v*(x)` \[length\].
    #[must_use]
    pub fn deflection(&self, x: f64) -> f64 {
        let piece = self.pieces.partition_point(|piece| piece.middle + piece.half < x).min(self.pieces.len() - 1);
        self.pieces[piece].at(x)
    }

    /// The largest magnitude of `v*` among a thousand places \[length\].
    #[must_use]
    pub fn largest(&self) -> f64 {
        let places = (0..=1000_u32).map(|k| self.scene.beam().length() * (f64::from(k) / 1000.0));
        places.map(|x| self.deflection(x).abs()).fold(0.0, f64::max)
    }

    /// `J*` \[force · length\].
    #[must_use]
    pub fn energy(&self) -> f64 {
        let (stiffness, load) = (self.scene.beam().bending_stiffness(), self.scene.load().uniform());
        self.pieces.iter().map(|piece| piece.energy(stiffness, load)).sum()
    }

    /// `M = −EI v''` \[force · length\].
    #[must_use]
    pub fn moment(&self, x: f64) -> f64 {
        let piece = self.pieces.partition_point(|piece| piece.middle + piece.half < x).min(self.pieces.len() - 1);
        -self.scene.beam().bending_stiffness() * self.pieces[piece].second(x)
    }

    /// The concentrated upward force at an end of a piece, of a support or of the ground \[force\].
    #[must_use]
    pub fn force(&self, x: f64) -> f64 {
        // The piece on the left ends at or before x + 0, the next one begins there.
        let right = self.pieces.partition_point(|piece| piece.middle < x);
        let third = |piece: Option<usize>, end| piece.and_then(|k| self.pieces.get(k)).map_or(0.0, |p| p.third(end));
        self.scene.beam().bending_stiffness() * (third(right.checked_sub(1), 1.0) - third(Some(right), -1.0))
    }

    /// Upward forces of the supports from left to right; [`None`] for one in a contact or at its end, which shares its force with
    /// the ground \[force\].
    #[must_use]
    pub fn reactions(&self) -> Vec<Option<f64>> {
        let touched = |x: f64| self.contacts.iter().any(|c| c.from <= x && x <= c.to);
        self.scene.beam().supports().iter().map(|s| (!touched(s.at)).then(|| self.force(s.at))).collect()
    }
}
