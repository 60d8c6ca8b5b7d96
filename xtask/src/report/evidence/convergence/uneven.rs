//! The discrete methods approach the exact solutions of uneven scenes.

use palkki::methods::Method;
use palkki::paper::approach::{Approach, approach};
use palkki::plot::study::{ErrorSeries, convergence};
use palkki::theory;
use serde::Serialize;

use crate::report::csv::{csv, scientific};
use crate::report::error::Cause;
use crate::report::scenes;
use crate::report::study::Study;

/// Smooth crests at single points; one crest with a zone; kinks. With the kind of contact that decides on the order.
const SCENES: [(&str, &str); 3] = [("wave", "points on smooth crests"), ("crest", "one zone"), ("survey", "kinks")];
/// The first has a node at each reading of the survey, every fifth interval; each further one has twice as many.
const COARSEST: usize = 120;
const HALVINGS: u32 = 5;
/// The first scene goes on by the force method, whose three-moment equations do not mind.
const FINE_HALVINGS: u32 = 10;

#[derive(Debug, Serialize)]
pub(super) struct Uneven {
    grids: Vec<usize>,
    scenes: Vec<OfScene>,
    fine: Fine,
}

#[derive(Debug, Serialize)]
struct OfScene {
    title: String,
    contact: &'static str,
    figure: String,
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Row {
    quantity: &'static str,
    method: &'static str,
    errors: Vec<f64>,
    order: f64,
}

#[derive(Debug, Serialize)]
struct Fine {
    title: String,
    intervals: usize,
    rows: Vec<Row>,
}

/// A drawing: name, figure, numbers.
type Drawing = (String, String, String);

pub(super) fn measured(study: &Study<'_>) -> Result<(Uneven, Vec<Drawing>), Cause> {
    let grids: Vec<usize> = (0..=HALVINGS).map(|k| COARSEST << k).collect();
    let (mut of_scenes, mut drawings) = (Vec::new(), Vec::new());
    for (name, contact) in SCENES {
        let scene = scenes::read(study.root, name)?;
        let exact = theory::solve(&scene)?;
        let mut found = Vec::new();
        for method in [Method::Force, Method::Complementarity] {
            found.extend(approach(&scene, &exact, method, &grids)?);
        }
        let figure = format!("approach-{name}");
        drawings.push((figure.clone(), drawn(scene.title(), &found)?, table(&found)));
        of_scenes.push(OfScene {
            title: scene.title().to_owned(),
            contact,
            figure,
            rows: found.iter().map(row).collect(),
        });
    }
    let scene = scenes::read(study.root, SCENES[0].0)?;
    let intervals = COARSEST << FINE_HALVINGS;
    let every: Vec<usize> = (0..=FINE_HALVINGS).map(|k| COARSEST << k).collect();
    let found = approach(&scene, &theory::solve(&scene)?, Method::Force, &every)?;
    let fine = Fine { title: scene.title().to_owned(), intervals, rows: found.iter().map(row).collect() };
    Ok((Uneven { grids, scenes: of_scenes, fine }, drawings))
}

fn row(found: &Approach) -> Row {
    Row {
        quantity: found.quantity.word(),
        method: found.method.word(),
        errors: found.errors.iter().map(|(_, error)| *error).collect(),
        order: found.order,
    }
}

fn drawn(title: &str, found: &[Approach]) -> Result<String, Cause> {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand intervals")]
    let points: Vec<Vec<[f64; 2]>> =
        found.iter().map(|a| a.errors.iter().map(|&(n, error)| [n as f64, error]).collect()).collect();
    let labels: Vec<String> = found.iter().map(|a| format!("{}, {}", a.quantity.word(), a.method.word())).collect();
    let series: Vec<ErrorSeries<'_>> =
        labels.iter().zip(&points).map(|(label, points)| ErrorSeries { label, points, order: None }).collect();
    let orders: Vec<String> =
        found.iter().zip(&labels).map(|(a, l)| format!("{l} with order {:.1}", a.order)).collect();
    Ok(convergence(
        &format!("{title}: errors of discrete solutions against the exact one"),
        &format!(
            "Relative errors over the number of intervals, both axes logarithmic. They fall: {}.",
            orders.join("; ")
        ),
        "relative error",
        &series,
    )?)
}

fn table(found: &[Approach]) -> String {
    let rows = found.iter().flat_map(|a| {
        a.errors.iter().map(|(n, error)| {
            vec![a.quantity.word().to_owned(), a.method.word().to_owned(), n.to_string(), scientific(*error, 2)]
        })
    });
    csv(&["quantity", "method", "intervals", "relative_error"], rows)
}
