//! The three regimes of a flat foundation as one picture: the end reaction over the depth.

use palkki::plot::study::{Named, regimes};
use palkki::route::{Method, Solver, Status};
use palkki::scene::Foundation;
use palkki::state::Regime;
use palkki::{Settings, solve, theory};
use palkki_evidence::paper::{INTERVALS, beam, example, scene_over};
use serde::Serialize;

use crate::report::csv::{csv, fixed};
use crate::report::error::Cause;
use crate::report::evidence::Evidence;
use crate::report::numbers;
use crate::report::study::Study;

/// Depths of the line, in equal steps of the fourth root: with it the length grows that is lifted off.
const DEPTHS: u32 = 160;
/// Every so many of them also by the force method.
const EVERY: u32 = 8;
/// The deepest, over the depth 5/384 that a free beam just reaches.
const DEEPEST: f64 = 1.25;

#[derive(Debug, Serialize)]
struct Values {
    depths: usize,
    /// How many of them are exact and checked.
    exact: usize,
    points: usize,
    intervals: usize,
    /// Depths at which theory finds no contact, one point and a zone, as `EI u₀/(q₀l⁴)` from and to.
    found: Vec<Found>,
    /// Worst difference of the computed end reactions from theory, over `q₀l`.
    worst: f64,
    /// Bound of the difference of the exact solutions from the closed form, over `q₀l`.
    closed: String,
    /// The example of the paper, `[EI u₀/(q₀l⁴), reaction/(q₀l)]`.
    example: [f64; 2],
}

#[derive(Debug, Serialize)]
struct Found {
    regime: &'static str,
    from: f64,
    to: f64,
    unknowns: usize,
}

pub(super) fn evidence(_: &Study<'_>) -> Result<Evidence, Cause> {
    let (beam, load) = (beam()?, example()?.load().uniform());
    let (l, ei) = (beam.length(), beam.bending_stiffness());
    let unit = load * l * l * l * l / ei;
    let (mut line, mut points, mut rows) = (Vec::new(), Vec::new(), Vec::new());
    let mut found: Vec<Found> = Vec::new();
    let (mut exact, mut worst, mut closed) = (0, 0.0_f64, 0.0_f64);
    for i in 1..=DEPTHS {
        let part = f64::from(i) / f64::from(DEPTHS);
        let share = DEEPEST * 5.0 / 384.0 * part * part * part * part;
        let depth = share * unit;
        let scene = scene_over(Foundation::Flat { depth })?;
        let solution = theory::solve(&scene)?;
        exact += usize::from(solution.status == Status::Certified);
        let reaction = solution.state.reactions.left / (load * l);
        closed = closed.max((theory::flat(l, ei, depth, load).reaction / (load * l) - reaction).abs());
        line.push([share, reaction]);
        let regime = match solution.state.regime {
            Regime::None => "no contact",
            Regime::Points => "contact at mid-span only",
            Regime::Zone => "a zone of contact",
        };
        match found.last_mut() {
            Some(last) if last.regime == regime => last.to = share,
            _ => found.push(Found { regime, from: share, to: share, unknowns: solution.unknowns }),
        }
        let mut computed = String::new();
        if i % EVERY == 0 {
            let settings = Settings::new(Method::Force, Solver::ActiveSet, INTERVALS);
            let discrete = solve(&scene, &settings)?.state.reactions.left / (load * l);
            worst = worst.max((discrete - reaction).abs());
            points.push([share, discrete]);
            computed = fixed(discrete, 6);
        }
        rows.push(vec![fixed(share, 8), fixed(reaction, 6), regime.to_owned(), computed]);
    }
    let paper = example()?;
    let paper = [paper.depth(0.0) / unit, theory::solve(&paper)?.state.reactions.left / (load * l)];
    let computed_points = points.len();
    let svg = regimes(
        "Three regimes: the end reaction grows until nothing touches",
        "The end reaction rises with the fourth root of the depth while the beam rests on a zone, then along a straight line \
         while it touches at mid-span only, and is constant when it touches nothing. Circles lie on the line. A star marks the \
         example of the paper, at the left end of the curve.",
        &line,
        &Named { label: &format!("force method, {INTERVALS} intervals"), points },
        (paper, "the paper's example"),
    )?;
    let header = ["ei_depth_over_q_l4", "reaction_over_q_l", "regime", "force_method"];
    let values = Values {
        example: paper,
        depths: line.len(),
        exact,
        points: computed_points,
        intervals: INTERVALS,
        found,
        worst,
        closed: numbers::bound(closed.max(f64::EPSILON)),
    };
    Ok(Evidence::new(values).figure("regimes", svg, csv(&header, rows)))
}
