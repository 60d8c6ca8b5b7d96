//! The force method with the active set on other scenes, beside the interior point: also where it is not the quicker one.

use serde::Serialize;

use super::lines::{Lines, intervals};
use super::{ASKED, OURS};
use crate::measure::plan::{EXAMPLE, OTHERS};
use crate::measure::store::Store;

/// Coarser grids are a matter of microseconds.
const FROM: usize = 300;

#[derive(Debug, Serialize)]
pub(super) struct Scene {
    name: &'static str,
    rows: Vec<Row>,
    /// Grids on which the peer is quicker, and how many times as long ours takes there at worst.
    slower: usize,
    worst: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Row {
    intervals: usize,
    /// Solves, of the whole and of neighbourhoods.
    solves: String,
    milliseconds: f64,
    /// Time of clarabel on the force method over ours, and the verdict on it.
    times: Option<f64>,
    verdict: Option<String>,
}

/// Scene by scene.
pub(super) fn of(store: &Store) -> Vec<Scene> {
    let scene = |name| {
        let lines = Lines::of(store, name);
        let mut rows = Vec::new();
        for ours in lines.asked(OURS).into_iter().filter(|line| FROM <= intervals(line)) {
            let (Some(seconds), Some(solves)) = (ours.seconds(), ours.field("iterations")) else { continue };
            let peer = lines.find("force/clarabel", intervals(ours), ASKED).filter(|line| line.seconds().is_some());
            rows.push(Row {
                intervals: intervals(ours),
                solves: solves.to_owned(),
                milliseconds: 1e3 * seconds,
                times: peer.and_then(|peer| Some(peer.seconds()? / seconds)),
                verdict: peer.map(super::lines::verdict),
            });
        }
        let slower: Vec<f64> = rows.iter().filter_map(|row| row.times).filter(|times| *times < 1.0).collect();
        let worst = slower.iter().copied().min_by(f64::total_cmp).map(|least| 1.0 / least);
        Scene { name, slower: slower.len(), worst, rows }
    };
    std::iter::once(EXAMPLE).chain(OTHERS).map(scene).filter(|scene| !scene.rows.is_empty()).collect()
}
