//! Conversion of a scene to dimensionless numbers: every method, beam theory and the certificate begin with [`Scene::scaled`].
//!
//! With the units `L` of length, `F` of force and `U = F L³ / E` of depth, the scene `x/L, u/U, q L/F, EI/E` satisfies the same
//! equations (5), (7), (8) as the original. All units are powers of two, so that scaling changes only exponents. Results are
//! bitwise equal in metres and in 1024ths of a metre.

use super::{Balance, Quantity, Scene, SceneError};

/// Units of length, depth and force. Those in which a scene is dimensionless are powers of two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Unit along the beam, `L`.
    pub length: f64,
    /// Unit of deflection and depth, `U`.
    pub depth: f64,
    /// Unit of force, `F`.
    pub force: f64,
}

impl Scale {
    /// Unit of moment, `F L`.
    #[must_use]
    pub(crate) fn moment(&self) -> f64 {
        self.force * self.length
    }

    /// Unit of energy, `F U`.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.force * self.depth
    }

    /// Unit of slope, `U/L`.
    pub(crate) fn slope(&self) -> f64 {
        self.depth / self.length
    }

    /// Unit of load and pressure, `F/L`.
    pub(crate) fn pressure(&self) -> f64 {
        self.force / self.length
    }
}

/// A scene in dimensionless numbers, with its units.
#[derive(Debug, Clone)]
pub struct Scaled {
    /// The dimensionless scene: `1 ≤ l < 2`, `1 ≤ EI < 2` (the smallest value), loads of order 1 if there are any.
    pub scene: Scene,
    /// The units of the scene.
    pub scale: Scale,
    /// The motions that the supports leave free, and the resultant that balances them; dimensionless.
    pub balance: Balance,
}

impl Scaled {
    /// The units of beam theory, which divides loads, forces, moments and energies by the least `EI`.
    pub(crate) fn units_over_stiffness(&self) -> Scale {
        Scale { force: self.scene.beam().bending_stiffness() * self.scale.force, ..self.scale }
    }
}

impl Scene {
    /// This scene in dimensionless numbers.
    ///
    /// `L` and `E` are the powers of two at or below `l` and `EI`, and `F` is the power of two at or below the magnitude of the
    /// loads. For a beam without loads, `U` is the power of two at or below the largest given depth or level (foundation,
    /// supports, initial shape), and `F` follows from it.
    ///
    /// # Errors
    ///
    /// [`SceneError::Overflow`] if one of the units, or a number measured in them, is outside the range of `f64`.
    /// [`SceneError::Unstable`] if the beam buckles under its compression. [`SceneError::Unheld`] if nothing balances the loads:
    /// such a scene has no solution by any method.
    pub fn scaled(&self) -> Result<Scaled, SceneError> {
        let length = power_of_two(self.beam().length());
        let stiffness = power_of_two(self.beam().bending_stiffness());
        // The order of the operations keeps every step in range as long as the result is.
        let bend = |force: f64| force * length / stiffness * length * length;
        let load = self.load().magnitude(self.beam().length());
        let depth = self.foundation().map_or(0.0, |f| f.magnitude(self.beam().length()));
        let depth = depth.max(self.beam().given_deflection());
        let (force, depth) = if 0.0 < load {
            let force = power_of_two(load);
            (force, bend(force))
        } else if 0.0 < depth {
            let depth = power_of_two(depth);
            (depth / length * stiffness / length / length, depth)
        } else {
            (1.0, bend(1.0))
        };
        let scale = Scale { length, depth, force };
        for (quantity, what, value) in [
            (Quantity::Length, "the unit of length", length),
            (Quantity::BendingStiffness, "the unit of depth", depth),
            (Quantity::TotalLoad, "the unit of force", force),
            (Quantity::TotalLoad, "the unit of moment", scale.moment()),
            (Quantity::TotalLoad, "the unit of energy", scale.energy()),
        ] {
            if !value.is_normal() {
                return Err(SceneError::Overflow { quantity, what, value });
            }
        }
        let tension = self.beam().tension() * length / stiffness * length;
        if !tension.is_finite() {
            let what = "the axial force in these units";
            return Err(SceneError::Overflow { quantity: Quantity::Tension, what, value: tension });
        }
        let scene = self.in_units(&scale, stiffness)?;
        scene.beam().check_compression().map_err(|unstable| unstable.times(stiffness / length / length))?;
        let balance = Balance::of(&scene).map_err(|unheld| unheld.in_units_of(&scale))?;
        Ok(Scaled { scene, scale, balance })
    }
}

/// The power of two at or below a positive number; the smallest normal number for subnormal ones.
fn power_of_two(value: f64) -> f64 {
    /// The exponent bits of a 64-bit floating-point number.
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    f64::from_bits(value.max(f64::MIN_POSITIVE).to_bits() & EXPONENT)
}
