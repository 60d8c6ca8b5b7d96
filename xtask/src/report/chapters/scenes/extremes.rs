//! Extremes whose place does not depend on rounding.

use palkki::state::{ContactState, Extremes};

/// Values that differ by less than this share of the largest one are equal: the first of them counts. Of two mirror
/// images rounding may prefer either.
const EQUAL: f64 = 1e-8;

/// Extremes of deflection and moment at the nodes, supports included.
pub(super) fn nodal(state: &ContactState) -> (Extremes, Extremes) {
    let Some(nodes) = &state.nodes else { return (state.deflection, state.moment) };
    let of = |values: &[f64]| {
        let places: Vec<(f64, f64)> =
            std::iter::once((0.0, 0.0)).chain(nodes.x.iter().copied().zip(values.iter().copied())).collect();
        first(&places)
    };
    (of(&nodes.deflection), of(&nodes.moment))
}

fn first(places: &[(f64, f64)]) -> Extremes {
    let plain = Extremes::of(places.iter().copied());
    let slack = EQUAL * plain.max.abs().max(plain.min.abs());
    let place = |is: &dyn Fn(f64) -> bool| places.iter().find(|(_, value)| is(*value)).map_or(0.0, |(x, _)| *x);
    Extremes {
        max_at: place(&|value| plain.max - slack <= value),
        min_at: place(&|value| value <= plain.min + slack),
        ..plain
    }
}

#[cfg(test)]
mod tests {
    use super::first;

    #[test]
    fn the_first_of_equal_values_counts() {
        let found = first(&[(0.0, 0.0), (1.0, 1.0), (2.0, -1e-17), (3.0, 1.0 + 1e-15)]);
        assert_eq!([found.max_at, found.min_at].map(f64::to_bits), [1.0, 0.0].map(f64::to_bits));
    }
}
