//! What was asked of the force method with the active set, and what it is.

use serde::Serialize;

use super::lines::{Lines, SOLVER, finite, intervals, verdict, worst};
use super::{METHODS, OURS, tolerance};
use crate::measure::store::Line;

/// A requirement: at most, or at least, so much.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Asked {
    limit: f64,
    found: f64,
    pub(super) met: bool,
    /// By how much it is met or missed, a factor of at least 1; none for nothing.
    pub(super) factor: Option<f64>,
}

impl Asked {
    pub(super) fn at_most(limit: f64, found: f64) -> Self {
        Self { limit, found, met: found <= limit, factor: factor(found, limit) }
    }

    pub(super) fn at_least(limit: f64, found: f64) -> Self {
        Self { limit, found, met: limit <= found, factor: factor(found, limit) }
    }
}

fn factor(found: f64, limit: f64) -> Option<f64> {
    Some((found / limit).max(limit / found)).filter(|factor| factor.is_finite())
}

/// The finest grid.
#[derive(Debug, Serialize)]
pub(super) struct Million {
    intervals: usize,
    milliseconds: f64,
    certified: bool,
    /// Milliseconds of one tridiagonal solve, and the time as a multiple of it: medians of both, taken in turns.
    tridiagonal: Option<f64>,
    times: Option<Asked>,
    /// Distance of the end reaction from beam theory.
    reaction: Option<Asked>,
    residual: Option<Asked>,
    /// Megabytes.
    memory: Option<Asked>,
    /// Intervals of a grid that is ten times coarser, and how many times as long the finer one takes.
    coarser: usize,
    growth: Option<Asked>,
}

/// Seconds of the median run.
fn median(line: &Line) -> Option<f64> {
    line.number("median_s")
}

/// The finest grid of our route that was measured.
pub(super) fn million(lines: &Lines<'_>) -> Option<Million> {
    let ours = lines.asked(OURS);
    let finest = ours.iter().rfind(|line| line.seconds().is_some())?;
    let seconds = median(finest)?;
    let coarser = intervals(finest) / 10;
    let before = lines.find(OURS, coarser, "0e0").and_then(median);
    let yardstick = finest.number("tridiagonal_s");
    Some(Million {
        intervals: intervals(finest),
        milliseconds: 1e3 * seconds,
        certified: finest.field("status") == Some("certified"),
        tridiagonal: yardstick.map(|yardstick| 1e3 * yardstick),
        times: yardstick.map(|yardstick| Asked::at_most(5.0, seconds / yardstick)),
        reaction: finite(finest, "reaction_total").map(|error| Asked::at_most(1e-9, error)),
        residual: finite(finest, "residual").map(|residual| Asked::at_most(1e-12, residual)),
        memory: finest.number("peak_kb").map(|kilobytes| Asked::at_most(300.0, 1e-3 * kilobytes)),
        coarser,
        growth: before.map(|before| Asked::at_most(13.0, seconds / before)),
    })
}

/// Errors of our route against exact arithmetic.
#[derive(Debug, Serialize)]
pub(super) struct Exactness {
    interior: usize,
    /// The largest of the four observables.
    error: Asked,
}

/// On the two grids that are asked for.
pub(super) fn exactness(lines: &Lines<'_>) -> Vec<Exactness> {
    let on = |(intervals, limit): (usize, f64)| {
        let line = lines.find(OURS, intervals, "0e0")?;
        Some(Exactness { interior: intervals - 1, error: Asked::at_most(limit, worst(line, &SOLVER)?) })
    };
    [(30, 1e-14), (10_000, 1e-11)].into_iter().filter_map(on).collect()
}

/// What a certificate costs beside the solve whose answer it is about.
#[derive(Debug, Serialize)]
pub(super) struct Certificate {
    intervals: usize,
    /// Milliseconds of both, and the certificate as a multiple of the solve: medians, taken in turns.
    solve: f64,
    milliseconds: f64,
    times: Asked,
}

/// On the grid that is asked for.
pub(super) fn certificate(lines: &Lines<'_>) -> Option<Certificate> {
    let intervals = 100_000;
    let line = lines.find(OURS, intervals, "0e0")?;
    let (solve, certificate) = (median(line)?, line.number("certificate_s")?);
    let times = Asked::at_most(1.0, certificate / solve);
    Some(Certificate { intervals, solve: 1e3 * solve, milliseconds: 1e3 * certificate, times })
}

/// Interior-point peers on the finest grid on which one of them ends.
#[derive(Debug, Serialize)]
pub(super) struct Interior {
    intervals: usize,
    milliseconds: f64,
    /// Megabytes of ours and of the peer that was weighed.
    megabytes: Option<[f64; 2]>,
    peers: Vec<Peer>,
    /// The quickest of them over ours.
    best: Asked,
    /// The quickest that our judge certifies, over ours.
    certified: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Peer {
    method: &'static str,
    tolerance: String,
    seconds: f64,
    times: f64,
    iterations: String,
    verdict: String,
    error: Option<f64>,
}

/// See [`Interior`].
pub(super) fn interior(lines: &Lines<'_>) -> Option<Interior> {
    let route = |method: &str| format!("{method}/clarabel");
    let routes = METHODS.map(route);
    let ends = |line: &&Line| line.seconds().is_some() && line.field("claims") == Some("success");
    let of_peers = || routes.iter().flat_map(|route| lines.of_route(route)).filter(ends);
    let finest = of_peers().map(intervals).max()?;
    let ours = lines.find(OURS, finest, "0e0")?;
    let seconds = ours.seconds()?;
    let mut peers = Vec::new();
    for (method, route) in METHODS.into_iter().zip(&routes) {
        for line in lines.of_route(route).filter(ends).filter(|line| intervals(line) == finest) {
            peers.push(Peer {
                method,
                tolerance: tolerance(line.field("tolerance")?),
                seconds: line.seconds()?,
                times: line.seconds()? / seconds,
                iterations: line.field("iterations")?.to_owned(),
                verdict: verdict(line),
                error: worst(line, &SOLVER),
            });
        }
    }
    let best = peers.iter().map(|peer| peer.times).min_by(f64::total_cmp)?;
    let certified =
        peers.iter().filter(|peer| peer.verdict == "certified").map(|peer| peer.times).min_by(f64::total_cmp);
    let weighed = of_peers().filter(|line| intervals(line) == finest).find_map(|line| line.number("peak_kb"));
    let megabytes = ours.number("peak_kb").zip(weighed).map(|(ours, theirs)| [1e-3 * ours, 1e-3 * theirs]);
    Some(Interior {
        intervals: finest,
        milliseconds: 1e3 * seconds,
        megabytes,
        peers,
        best: Asked::at_least(30.0, best),
        certified,
    })
}
