//! Random numbers from a fixed seed, the same on every machine, with no crate to change under us; and random scenes.

mod coinciding;
mod general;
mod held;
mod population;
mod scenes;

pub use coinciding::coinciding;
pub use general::{Feature, General, general, general_on_grid};
pub use held::held;
pub use population::Family;
pub use scenes::{on_lattice, rough, scene, smooth};

use std::ops::Div;

use palkki::scene::Scene;

/// The generator SplitMix64 (Steele, Lea and Flood 2014).
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// A generator that starts from `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// The next number, uniform between `from` and `to`.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// One of `0 … count − 1`; 0 if there is none.
    pub fn below(&mut self, count: usize) -> usize {
        let count = u64::try_from(count).unwrap_or(u64::MAX).max(1);
        // A remainder is smaller than the count, and so fits as well.
        usize::try_from(self.bits() % count).unwrap_or(0)
    }

    /// One of some values.
    pub fn pick<T: Copy, const N: usize>(&mut self, values: &[T; N]) -> T {
        const { assert!(0 < N, "there is nothing to pick from") };
        values[self.below(N)]
    }

    /// True once in `count`.
    pub fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }
}

/// How many of so many random scenes, or parts of a scene, the suite draws: the first quarter, for somebody who waits for it, and all
/// where the variable `PALKKI_DRAW` is `all`, as in `.ci/run`.
#[must_use]
pub fn sample_of<Count: Div<Output = Count> + From<u8>>(all: Count) -> Count {
    all / Count::from(if draws_all() { 1 } else { 4 })
}

/// The same of what takes long for each scene: the first sixteenth.
#[must_use]
pub fn rare_sample_of<Count: Div<Output = Count> + From<u8>>(all: Count) -> Count {
    all / Count::from(if draws_all() { 1 } else { 16 })
}

/// Whether [`sample_of`] and [`rare_sample_of`] draw all.
#[must_use]
pub fn draws_all() -> bool {
    std::env::var_os("PALKKI_DRAW").is_some_and(|wish| wish == "all")
}

/// The first scene of the attempts with the numbers of a seed: those may be refused.
fn first(seed: u64, attempt: impl Fn(&mut Random) -> Option<Scene>) -> Scene {
    let mut random = Random::new(seed);
    loop {
        if let Some(scene) = attempt(&mut random) {
            return scene;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// The first numbers for the seed 1234567, with which implementations of SplitMix64 are commonly tested; they come
    /// from the reference implementation in C, S. Vigna's `splitmix64.c`.
    #[test]
    fn the_numbers_are_those_of_the_reference() {
        let mut random = Random::new(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
        ];
        assert_eq!([(); 4].map(|()| random.bits()), expected);
    }
}
