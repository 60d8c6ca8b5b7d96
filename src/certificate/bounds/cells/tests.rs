//! The plain numbers of a cell against closed forms, in cells that are wide enough to see every term.

use super::*;

const LENGTH: f64 = 20.0;
const STIFFNESS: f64 = 70.0;
/// Width of a cell, and the arrow `w²/8` of a parabola of curvature one.
const WIDTH: f64 = 0.5;
const ARROW: f64 = 0.125 * WIDTH * WIDTH;
/// What rounding of the plain numbers adds to the bounds, and its own bound, which is generous.
const ROUNDING: f64 = 1e-9;

#[track_caller]
fn at_least(bound: f64, value: f64) {
    assert!((value..=value + ROUNDING * value.max(1.0)).contains(&bound), "{bound}, not {value}");
}

/// `c s⁴` all along the beam.
fn quartic(c: f64) -> Piece {
    let coefficients = [0.0, 0.0, 0.0, 0.0, c].map(Interval::exact);
    Piece { from: 0.0, to: LENGTH, v: Polynomial::new(&coefficients), follows: false }
}

/// Nodes at `first, first + w, …` on the deflection `c s⁴`, off by something.
fn nodes(c: f64, first: f64, off: [[f64; 2]; 3]) -> Vec<Node> {
    let at = |x: f64, [deflection, curvature]: [f64; 2]| Node {
        x,
        deflection: c * x * x * x * x + deflection,
        moment: -STIFFNESS * (12.0 * c * x * x + curvature),
    };
    off.into_iter().zip([0.0, WIDTH, 2.0 * WIDTH]).map(|(off, x)| at(first + x, off)).collect()
}

fn bound(c: f64, factor: f64, first: f64, off: [[f64; 2]; 3]) -> Error {
    let mut error = Error::UNKNOWN;
    (error.most, error.size) = (0.0, 0.0);
    narrow(&mut error, &quartic(c), &nodes(c, first, off), factor, STIFFNESS, LENGTH);
    error
}

const NOTHING: [f64; 2] = [0.0; 2];

#[test]
fn every_term_of_the_bound_is_there() {
    // A deflection that is off at one node, whichever of a cell it is.
    for off in [[[1.0, 0.0], NOTHING, NOTHING], [NOTHING, [-1.0, 0.0], NOTHING], [NOTHING, NOTHING, [1.0, 0.0]]] {
        at_least(bound(0.0, 0.0, 3.0, off).most, 1.0);
        at_least(bound(0.0, 0.0, 3.0, off).size, 1.0);
    }
    // A curvature that is off: a parabola between the nodes.
    for off in [[[0.0, 2.0], NOTHING, NOTHING], [NOTHING, [0.0, -2.0], NOTHING], [NOTHING, NOTHING, [0.0, 2.0]]] {
        at_least(bound(0.0, 0.0, 3.0, off).most, 2.0 * ARROW);
        at_least(bound(0.0, 0.0, 3.0, off).size, 2.0 * ARROW);
    }
    // A cubic cannot follow a fourth derivative 24 c.
    at_least(bound(1e-3, 0.0, 3.0, [NOTHING; 3]).most, ARROW * ARROW * 24e-3);
    // The factor, with the largest x (l − x) of a cell and the height of its arc.
    at_least(bound(0.0, 2.0, 3.0, [NOTHING; 3]).most, 2.0 * (4.0 * 16.0 + 2.0 * ARROW));
    at_least(bound(0.0, 2.0, 16.0, [NOTHING; 3]).most, 2.0 * (16.0 * 4.0 + 2.0 * ARROW));
    // All of them.
    let all = bound(1e-3, 2.0, 3.0, [[1.0, 2.0]; 3]).most;
    at_least(all, 2.0 * (64.0 + 2.0 * ARROW) + 1.0 + ARROW * (2.0 + ARROW * 24e-3));
}

#[test]
fn the_place_is_the_middle_of_the_cell() {
    let error = bound(0.0, 0.0, 3.0, [NOTHING, NOTHING, [1.0, 0.0]]);
    at_least(error.at, 3.75);
}

#[test]
fn no_number_in_a_node_is_no_bound() {
    for node in 0..3 {
        for part in 0..2 {
            let mut off = [NOTHING; 3];
            off[node][part] = f64::NAN;
            assert!(bound(0.0, 0.0, 3.0, off).most.is_infinite(), "part {part} of node {node}");
        }
    }
}

/// What is not known of the coefficients, and twenty units of rounding of each, times powers of the width.
#[test]
fn values_are_as_good_as_their_coefficients() {
    /// Factors that only round outwards.
    const OUT: f64 = 1e-12;
    let (radius, width) = (0.25, 3.0);
    let unknown = |k: usize| {
        let mut coefficients = [Interval::ZERO; 4];
        coefficients[k] = Interval::around_zero(radius);
        Plain::of(&Polynomial::new(&coefficients), width).off
    };
    for (k, power) in [1.0, 3.0, 9.0, 27.0].into_iter().enumerate() {
        let least = radius * power;
        assert!((least..=least * (1.0 + OUT)).contains(&unknown(k)), "{k}: {}", unknown(k));
    }
    let known = Plain::of(&Polynomial::new(&[1.0, -2.0, 3.0].map(Interval::exact)), width).off;
    let least = ROUNDINGS * (1.0 + 6.0 + 27.0);
    assert!((least..=least * (1.0 + OUT)).contains(&known), "{known}");
    assert!(0.0 < Plain::of(&Polynomial::ZERO, width).off, "underflow is rounding as well");
}

/// Cells that lie in one piece, cells that end in the next one, and a list of pieces that does not go all the way.
#[test]
fn every_cell_is_compared() {
    let straight = |from: f64, to: f64| Piece { from, to, v: Polynomial::ZERO, follows: false };
    let pieces = [straight(0.0, 4.9), straight(4.9, 5.1), straight(5.1, 5.2), straight(5.2, LENGTH)];
    let node = |x: f64, deflection: f64| Node { x, deflection, moment: 0.0 };
    for off in 1..20 {
        let nodes: Vec<Node> = (0..=20_u32).map(|i| node(f64::from(i), if i == off { 1.0 } else { 0.0 })).collect();
        let compared = |pieces: &[Piece]| {
            let mut error = Error::UNKNOWN;
            (error.most, error.size) = (0.0, 0.0);
            compare(&mut error, pieces, &nodes, Interval::ZERO, STIFFNESS);
            error.most
        };
        // Where pieces meet, the range of the cubic may exceed its values at the nodes.
        let most = compared(&pieces);
        assert!((1.0..1.2).contains(&most), "node {off}: {most}");
        assert!(compared(&pieces[..3]).is_infinite(), "pieces that end on the way");
    }
}

#[test]
fn nodes_that_are_not_in_order_or_not_complete_are_none() {
    let scale = Scale { length: 1.0, depth: 1.0, force: 1.0 };
    let given = |x: &[f64], deflections: usize, moments: usize| Nodes {
        x: x.to_vec(),
        deflection: vec![1.0; deflections],
        moment: vec![1.0; moments],
        ..Nodes::default()
    };
    assert_eq!(nodes_of(&given(&[5.0, 6.0], 2, 2), &scale), Some(4));
    for (x, deflections, moments) in [
        (&[5.0, 6.0], 1, 2),
        (&[5.0, 6.0], 2, 1),
        (&[6.0, 5.0], 2, 2),
        (&[5.0, 5.0], 2, 2),
        (&[0.0, 5.0], 2, 2),
        (&[5.0, LENGTH], 2, 2),
        (&[f64::NAN, 5.0], 2, 2),
    ] {
        assert_eq!(nodes_of(&given(x, deflections, moments), &scale), None, "{x:?}, {deflections}, {moments}");
    }
}

fn nodes_of(given: &Nodes, scale: &Scale) -> Option<usize> {
    super::nodes(given, scale, LENGTH).map(|nodes| nodes.len())
}

/// A piece that lies within a cell is seen by no node, and counts.
#[test]
fn pieces_between_nodes_are_compared() {
    let constant =
        |from: f64, to: f64, v: f64| Piece { from, to, v: Polynomial::new(&[Interval::exact(v)]), follows: false };
    for cell in [0.0, 4.0, 19.0] {
        let pieces =
            [constant(0.0, cell + 0.4, 0.0), constant(cell + 0.4, cell + 0.6, 1.0), constant(cell + 0.6, LENGTH, 0.0)];
        let nodes: Vec<Node> = (0..=20_u32).map(|i| Node { x: f64::from(i), deflection: 0.0, moment: 0.0 }).collect();
        let mut error = Error::UNKNOWN;
        (error.most, error.size) = (0.0, 0.0);
        compare(&mut error, &pieces, &nodes, Interval::ZERO, STIFFNESS);
        at_least(error.most, 1.0);
    }
}
