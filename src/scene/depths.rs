//! Depths of the foundation at many positions: bitwise equal to single evaluations, but faster.

use super::Foundation;
use super::foundation::between;

impl Foundation {
    /// Writes `u(x)` at positions in ascending order, each as [`depth`](Self::depth) computes it \[length\]. `depths` and
    /// `places` have the same length.
    pub(crate) fn depths(&self, places: &[f64], depths: &mut [f64]) {
        match self {
            Self::Flat { depth } => depths.fill(*depth),
            Self::Polynomial { coefficients } => {
                // Horner's scheme: each coefficient at all positions, one after the other.
                depths.fill(0.0);
                for c in coefficients.iter().rev() {
                    depths.iter_mut().zip(places).for_each(|(sum, x)| *sum = *sum * x + c);
                }
            }
            Self::Cosine { .. } => depths.iter_mut().zip(places).for_each(|(u, x)| *u = self.depth(*x)),
            Self::Polyline { points } => {
                // The first point that is not to the left of the position: found once, then advanced with the positions.
                let mut after = places.first().map_or(0, |x| points.partition_point(|p| p[0] < *x));
                for (u, &x) in depths.iter_mut().zip(places) {
                    after += points[after..].iter().take_while(|p| p[0] < x).count();
                    let here = points[after..].iter().take_while(|p| p[0] <= x).count();
                    *u = between(points, after..after + here, x);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Positions at, between and beyond the points; some segments contain several positions and others none.
    #[test]
    fn many_depths_are_the_bits_of_single_ones() {
        let points = vec![[0.0, 1.0], [2.0, 0.5], [3.0, 1.5], [3.0, 0.75], [3.1, 0.8], [3.2, 0.1], [10.0, 2.0]];
        let profiles = [
            Foundation::Flat { depth: 1.5 },
            Foundation::Polynomial { coefficients: vec![1.0, -0.5, 0.25, 0.125, -0.03] },
            Foundation::Cosine { mean: 1.0, amplitude: 0.5, wavelength: 3.0, phase: 0.7 },
            Foundation::Polyline { points },
        ];
        for profile in &profiles {
            for intervals in [3, 10, 77, 1000_u32] {
                let places: Vec<f64> =
                    (0..=intervals + 1).map(|i| 10.0 * f64::from(i) / f64::from(intervals)).collect();
                for part in [&places[..], &places[1..], &places[places.len() / 3..]] {
                    let mut depths = vec![f64::NAN; part.len()];
                    profile.depths(part, &mut depths);
                    let single: Vec<u64> = part.iter().map(|x| profile.depth(*x).to_bits()).collect();
                    assert_eq!(depths.iter().map(|u| u.to_bits()).collect::<Vec<_>>(), single, "{profile:?}");
                }
            }
        }
    }
}
