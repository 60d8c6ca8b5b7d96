//! Units are labels: answers in other units are the same answers.

use palkki::Settings;
use palkki::route::{Method, Solver};
use palkki::scene::{LinearLoad, PointLoad};
use palkki::state::ContactState;

use super::{Parts, ROUNDING, some};
use crate::scenes::{apart, largest};

/// The scene in units of length, depth and force that are smaller by these factors.
#[derive(Debug, Clone, Copy)]
struct Factors {
    length: f64,
    depth: f64,
    force: f64,
}

impl Factors {
    fn applied(self, parts: &Parts) -> Parts {
        let Self { length, depth, force } = self;
        let density = force / length;
        Parts {
            length: parts.length * length,
            // EI has the unit force · length³ / depth.
            stiffness: parts.stiffness * (force * length * length * length / depth),
            uniform: parts.uniform * density,
            linear: parts
                .linear
                .iter()
                .map(|q| LinearLoad {
                    from: q.from * length,
                    to: q.to * length,
                    start: q.start * density,
                    end: q.end * density,
                })
                .collect(),
            point: parts.point.iter().map(|p| PointLoad { at: p.at * length, force: p.force * force }).collect(),
            points: parts.points.iter().map(|p| [p[0] * length, p[1] * depth]).collect(),
        }
    }

    /// Numbers of a state in the old units: places, depths, forces, moments, energy.
    fn undone(self, state: &ContactState) -> [Vec<f64>; 5] {
        let nodes = state.nodes.as_ref().expect("nodes");
        let over = |values: &[f64], unit: f64| values.iter().map(|v| v / unit).collect::<Vec<_>>();
        [
            over(&nodes.x, self.length),
            over(&nodes.deflection, self.depth),
            over(&[&nodes.contact_force[..], &[state.reactions.left, state.reactions.right]].concat(), self.force),
            over(&nodes.moment, self.force * self.length),
            vec![state.energy / (self.force * self.depth)],
        ]
    }
}

const SAME: Factors = Factors { length: 1.0, depth: 1.0, force: 1.0 };

/// Our own solvers; the libraries are only given dimensionless numbers, but nobody promises their bits.
const BY_HAND: [Solver; 3] = [Solver::FourStep, Solver::ActiveSet, Solver::Nsor];

fn state(parts: &Parts, method: Method, solver: Solver) -> ContactState {
    // A loose tolerance for NSOR: what is asked here is the same bits, not many digits.
    let settings = Settings { tolerance: 1e-4, ..Settings::new(method, solver, 14) };
    palkki::solve_raw(&parts.scene(), &settings).expect("numbers in range").state
}

#[test]
fn powers_of_two_do_not_change_a_bit() {
    let factors = [
        Factors { length: 1024.0, depth: 1.0, force: 1.0 },
        Factors { length: 1.0, depth: 0.125, force: 1.0 },
        Factors { length: 1.0, depth: 1.0, force: 65536.0 },
        Factors { length: 0.0625, depth: 512.0, force: 0.5 },
    ];
    for parts in some(6, 3) {
        for method in Method::ALL {
            for solver in BY_HAND {
                let reference = SAME.undone(&state(&parts, method, solver));
                for factors in factors {
                    let other = factors.undone(&state(&factors.applied(&parts), method, solver));
                    let same = reference.iter().flatten().zip(other.iter().flatten());
                    let differs = same.filter(|(a, b)| a.to_bits() != b.to_bits()).count();
                    assert_eq!(differs, 0, "{method} {solver} {factors:?}: bits differ");
                }
            }
        }
    }
}

#[test]
fn other_units_change_rounding_only() {
    // Feet, millimetres, pounds.
    let factors = [
        Factors { length: 3.280_839_895, depth: 3.280_839_895, force: 0.224_809 },
        Factors { length: 1.0, depth: 1000.0, force: 1.0 },
        Factors { length: 1000.0, depth: 1000.0, force: 1e-3 },
    ];
    for parts in some(20, 4) {
        for method in Method::ALL {
            let reference = SAME.undone(&state(&parts, method, Solver::ActiveSet));
            for factors in factors {
                let other = factors.undone(&state(&factors.applied(&parts), method, Solver::ActiveSet));
                for (a, b) in reference.iter().zip(&other) {
                    assert!(apart(a, b) <= ROUNDING * largest(a), "{method} {factors:?}: {:.1e}", apart(a, b));
                }
            }
        }
    }
}

/// Twice the loads on a foundation twice as deep: twice the forces and the deflection, in the same units.
#[test]
fn loads_and_depths_together_scale_the_answer() {
    for parts in some(10, 5) {
        for factor in [2.0, 3.7] {
            let scaled = Factors { length: 1.0, depth: factor, force: factor };
            for method in Method::ALL {
                let a = SAME.undone(&state(&parts, method, Solver::ActiveSet));
                // EI stays what it is.
                let bigger = scaled.applied(&parts);
                assert!((bigger.stiffness / parts.stiffness - 1.0).abs() <= 4.0 * f64::EPSILON, "EI is the same");
                let b = scaled.undone(&state(&bigger, method, Solver::ActiveSet));
                for (a, b) in a.iter().zip(&b) {
                    assert!(apart(a, b) <= ROUNDING * largest(a), "{method} × {factor}: {:.1e}", apart(a, b));
                }
            }
        }
    }
}
