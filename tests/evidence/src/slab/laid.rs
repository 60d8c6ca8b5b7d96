//! A slab of 10 m by 8 m above ground that has settled towards one side, and above a crest: two instances, with their files.

use std::fmt::Write as _;

use palkki::body::proof::prove;
use palkki::body::{Body, Kind};
use palkki::qp::Profile;
use palkki::solvers::Solver;

use super::Slab;

/// What a slab of concrete has that is 20 cm thick: `D = E t³/12(1 − ν²)` in kN m with E = 30 GPa, rounded.
const SLAB: Slab = Slab { length: 10.0, width: 8.0, stiffness: 20_000.0, poisson: 0.2, elements: [10, 8] };

/// kN/m²: its weight and as much again.
const LOAD: f64 = 10.0;

/// The ground below the slab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Laid {
    /// Level from one supported edge to the other, deeper towards one free edge.
    Settled,
    /// Level, with a crest that crosses it obliquely.
    Crest,
}

impl Laid {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Settled, Self::Crest];

    /// As files have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Settled => "slab-settled",
            Self::Crest => "slab-crest",
        }
    }

    /// What it is, for a person.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Settled => "A slab above ground that has settled towards one side",
            Self::Crest => "A slab above an oblique crest",
        }
    }

    /// The least depth of either ground \[m\], along an edge of the slab or along the crest.
    pub const HIGHEST: f64 = 0.01;

    /// Depth of the ground below the supports \[m\].
    #[must_use]
    pub fn gap(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Settled => Self::HIGHEST + 0.01 * y,
            Self::Crest => Self::HIGHEST + 0.04 * (0.5 * (x - 3.0 - 0.5 * y).abs()).min(1.0),
        }
    }

    /// The body, whose stiffness and gaps have as many digits as their files.
    ///
    /// # Panics
    ///
    /// Never: the slab is held.
    #[must_use]
    pub fn body(self) -> Body {
        let nodes = SLAB.nodes();
        let gaps = nodes.iter().map(|[x, y, _]| printed(depth(self.gap(*x, *y)))).collect();
        let loads = nodes.iter().map(|[_, _, area]| LOAD * area).collect();
        Body::new(Kind::Stiffness, stiffness(), None, gaps, loads).expect("held")
    }

    /// Places of the columns of its map and of the rows \[m\]; [freedoms](Self::body) go through it column by column.
    #[must_use]
    pub fn places() -> [Vec<f64>; 2] {
        let nodes = SLAB.nodes();
        let rows = SLAB.elements[1] + 1;
        [
            nodes.iter().step_by(rows).map(|node| node[0]).collect(),
            nodes.iter().take(rows).map(|node| node[1]).collect(),
        ]
    }
}

/// Nine digits of an entry of the stiffness: an instance is a matrix as it is written.
fn entry(value: f64) -> String {
    format!("{value:.8e}")
}

/// Tenths of a millimetre.
fn depth(value: f64) -> String {
    format!("{value:.4}")
}

/// The number that a reader takes from a text.
fn printed(text: String) -> f64 {
    text.parse().expect("a number")
}

fn stiffness() -> Profile {
    let exact = SLAB.stiffness();
    Profile::full(exact.dimension(), |i, j| printed(entry(exact.entry(i, j))))
}

/// `i,quantity`.
fn csv(quantity: &str, values: impl IntoIterator<Item = String>) -> String {
    (1..).zip(values).fold(format!("i,{quantity}\n"), |mut text, (i, value)| {
        let _ = writeln!(text, "{i},{value}");
        text
    })
}

/// The files of both instances: name and text. The answers are those numbers of 64 bits that are next to what is proven.
///
/// # Panics
///
/// If an answer cannot be proven.
#[must_use]
pub fn files() -> Vec<(String, String)> {
    let matrix = stiffness();
    let n = matrix.dimension();
    let mut text = format!("%%MatrixMarket matrix array real symmetric\n{n} {n}\n");
    for j in 0..n {
        (j..n).for_each(|i| text += &(entry(matrix.entry(i, j)) + "\n"));
    }
    let load = SLAB.nodes().into_iter().map(|[_, _, area]| format!("{:?}", LOAD * area));
    let mut files = vec![("slab.K.mtx".to_owned(), text), ("slab.load.csv".to_owned(), csv("force", load))];
    for laid in Laid::ALL {
        let (name, title) = (laid.name(), laid.title());
        let scene = format!(
            "title = \"{title}\"\n\n[body]\nstiffness = \"slab.K.mtx\"\ngap = \"{name}.gap.csv\"\nload = \"slab.load.csv\"\n\n[units]\nlength = \"m\"\nforce = \"kN\"\n"
        );
        let gap = SLAB.nodes().into_iter().map(|[x, y, _]| depth(laid.gap(x, y)));
        let answer = solved(&laid.body()).into_iter().map(|h| format!("{h:?}"));
        files.push((format!("{name}.toml"), scene));
        files.push((format!("{name}.gap.csv"), csv("gap", gap)));
        files.push((format!("{name}.answer.csv"), csv("clearance", answer)));
    }
    files
}

/// Clearances by the active set, proven to the last bits.
fn solved(body: &Body) -> Vec<f64> {
    let answer = body.run(Solver::ActiveSet, 0.0);
    let proof = prove(body, answer.x.iter().map(|x| 0.0 < *x)).expect("well conditioned");
    let [clearance, _] = body.clearance_and_force(&answer);
    let off = proof.off(&clearance).most;
    assert!(off <= 2.0 * f64::EPSILON * proof.sizes.clearance, "off by up to {off:e}");
    clearance
}
