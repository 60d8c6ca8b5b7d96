//! Contact by penalty: tensionless springs at the nodes instead of a rigid foundation, as programs for structures do it.
//!
//! A spring of stiffness `k` gives way by `f/k`, so that the clearance of the force method, (28), becomes
//!
//! ```text
//! f ≥ 0,  (C + I/k) f + u − C q ≥ 0,  fᵀ((C + I/k) f + u − C q) = 0
//! ```
//!
//! the same quadratic program (32) with a matrix that is stiffer on its diagonal.

use nalgebra::{DMatrix, DVector};
use palkki::methods::{Discrete, Method};
use palkki::plot::{Axis, Figure, Layer, Panel, PlotError, Style};
use palkki::problem::Dense;
use palkki::scene::Scene;
use palkki::solvers::Solver;

use super::brought::Found;
use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::numbers::power;

/// Contact forces `(x, force)` of springs at the nodes; `ratio` is the stiffness of one of them over that of the free beam
/// in its middle, `48 EI / l³`.
pub(super) fn forces(scene: &Scene, intervals: usize, ratio: f64) -> Result<Vec<(f64, f64)>, Cause> {
    let scaled = scene.scaled()?;
    let beam = scaled.scene.beam();
    let length = beam.length();
    let spring = ratio * 48.0 * beam.bending_stiffness() / (length * length * length);
    let discrete = Discrete::new(&scaled.scene, intervals)?;
    let rigid = Method::Force.programme(&discrete);
    let (n, flexibility) = (rigid.dimension(), rigid.matrix());
    let softness = |i: usize, j: usize| if i == j { 1.0 / spring } else { 0.0 };
    let programme = Dense {
        matrix: DMatrix::from_fn(n, n, |i, j| flexibility.entry(i, j) + softness(i, j)),
        linear: DVector::from_vec(rigid.linear()),
        sizes: rigid.sizes(),
    };
    let answer = Solver::ActiveSet.run(&programme, 0.0);
    if !answer.claims_success {
        return Err(format!("springs of ratio {ratio}: {}", answer.words).into());
    }
    let scale = &scaled.scale;
    let place = |i: usize| discrete.grid.place(i + 1) * scale.length;
    Ok(answer.x.iter().enumerate().map(|(i, force)| (place(i), force * scale.force)).collect())
}

/// The figure of the springs, of which the first that are accepted have the stiffness 10ᵏ, and its numbers.
pub(super) fn figure(springs: &[Found], first_stiff: i32) -> Result<(String, String), PlotError> {
    let line =
        |value: fn(&Found) -> f64| springs.iter().map(|s| [10_f64.powi(s.exponent), value(s)]).collect::<Vec<_>>();
    let lines = [
        ("certified error of the deflection", line(Found::error)),
        ("worst violation at the nodes", line(Found::violation)),
        ("true error of the end reaction", line(|s| s.reaction)),
    ];
    let x = Axis::new("stiffness of a spring over that of the beam, k l³/48EI").log();
    let mut panel = Panel::new(x, Axis::new("relative error").log()).tall(700.0);
    let mut rows = Vec::new();
    for (i, (label, points)) in lines.into_iter().enumerate() {
        rows.extend(points.iter().map(|p| vec![label.to_owned(), scientific(p[0], 0), scientific(p[1], 2)]));
        panel = panel.with(Layer::Series { points, style: Style::of_series(i), label: label.to_owned() });
    }
    let svg = Figure::new(
        format!("Springs are accepted from {} times the stiffness of the beam on", power(first_stiff)),
        "Relative errors over the stiffness of the springs, both axes logarithmic. The violation at the nodes falls in proportion; \
         the certified error and the error of the end reaction fall until the error of the grid is left.",
        vec![panel],
    )
    .svg()?;
    Ok((svg, csv(&["quantity", "stiffness_ratio", "relative_error"], rows)))
}
