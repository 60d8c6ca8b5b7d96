//! Errors on a population of scenes, which are the same on every machine: a first draw for what is told of the families, and a second
//! one with other seeds, which tries what is promised.

use std::path::Path;

use palkki::methods::Method;
use palkki::solve_exactly;
use palkki::solvers::Solver;
use palkki_evidence::observables::errors;
use palkki_evidence::random::Family;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::advice::{self, Advice};
use super::job;
use super::plan::Route;
use crate::data::rounded;
use crate::{Cause, data};

/// What `--only` calls it.
pub(super) const NAME: &str = "population";

/// Where the file is, below the root.
pub(crate) const PATH: &str = "report/data/population.csv";

/// Scenes of each family in the first draw, and in the second: one in a hundred may miss what is promised.
pub(crate) const SCENES: [u32; 2] = [20, 100];

/// Grids of the first draw, multiples of ten: nodes at the supports.
pub(crate) const GRIDS: [usize; 7] = [10, 30, 100, 300, 1000, 3000, 10_000];

/// The two discretisations, finite differences and beam elements. Displacement and force method have the same.
pub(crate) const METHODS: [Method; 2] = [Method::Complementarity, Method::Force];

/// One answer to one scene, and its [errors]; none where beam theory is not certified, or there is no answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) draw: u8,
    pub(crate) family: String,
    pub(crate) scene: u32,
    pub(crate) method: String,
    pub(crate) solver: String,
    pub(crate) intervals: usize,
    pub(crate) tolerance: f64,
    /// Our check; of beam theory and of the adaptive grid the verdict.
    pub(crate) status: String,
    supports: Option<f64>,
    contact: Option<f64>,
    deflection: Option<f64>,
    moment: Option<f64>,
    energy: Option<f64>,
}

impl Line {
    /// In the order of [`palkki_evidence::observables::NAMES`].
    pub(crate) fn errors(&self) -> Option<[f64; 5]> {
        Some([self.supports?, self.contact?, self.deflection?, self.moment?, self.energy?])
    }

    /// With the same error of all observables.
    #[cfg(test)]
    pub(crate) fn with_error(self, error: f64) -> Self {
        let [supports, contact, deflection, moment, energy] = [Some(error); 5];
        Self { supports, contact, deflection, moment, energy, ..self }
    }

    /// Whether its problem is solved, and certified where that is asked.
    pub(crate) fn succeeded(&self) -> bool {
        self.status == "solved" || self.status == "certified"
    }
}

/// What a scene is solved by.
type Run = (Route, usize, f64);

/// The runs on the scenes of a family: in the second draw those that are advised.
fn runs(draw: u8, family: Family, advice: &[Advice]) -> Vec<Run> {
    if draw == 1 {
        let on_grids = |method| GRIDS.map(|intervals| (Route::Solver(method, Solver::ActiveSet), intervals, 0.0));
        return METHODS.into_iter().flat_map(on_grids).collect();
    }
    let of_family = advice.iter().filter(|advice| advice.families().any(|name| name == family.name()));
    of_family.filter_map(|advice| Some((advice.route()?, advice.intervals, advice.tolerance))).collect()
}

/// The lines of a scene.
fn lines(draw: u8, family: Family, index: u32, advice: &[Advice]) -> Result<Vec<Line>, Cause> {
    let scene = family.scene(draw, index);
    let theory = solve_exactly(&scene)?;
    let certified = theory.verdict.status.name();
    let exact = theory.exact.filter(|_| certified == "certified");
    let line = |(route, intervals, tolerance): Run| {
        let (status, errors) = match route {
            Route::Exact => (certified.to_owned(), exact.as_ref().map(|_| [0.0; 5])),
            _ => match job::once(&scene, route, intervals, tolerance) {
                Ok(answer) => (answer.status.to_owned(), exact.as_ref().map(|exact| errors(exact, &answer.state))),
                Err(error) => (format!("refused: {error}"), None),
            },
        };
        let name = route.name();
        let (method, solver) = name.split_once('/').unwrap_or((&name, ""));
        let [method, solver] = [method, solver].map(str::to_owned);
        let [supports, contact, deflection, moment, energy] =
            errors.map_or([None; 5], |errors| errors.map(|error| rounded(error, 1)));
        let family = family.name().to_owned();
        Line {
            draw,
            family,
            scene: index,
            method,
            solver,
            intervals,
            tolerance,
            status,
            supports,
            contact,
            deflection,
            moment,
            energy,
        }
    };
    Ok(runs(draw, family, advice).into_iter().map(line).collect())
}

/// Measures all of it.
pub(super) fn run(root: &Path) -> Result<(), Cause> {
    let advice = advice::read(root)?;
    let members = [1, 2].into_iter().zip(SCENES).flat_map(|(draw, count)| {
        Family::ALL.into_iter().flat_map(move |family| (0..count).map(move |index| (draw, family, index)))
    });
    let members: Vec<(u8, Family, u32)> = members.collect();
    let found = members.into_par_iter().map(|(draw, family, index)| lines(draw, family, index, &advice));
    data::write(root, PATH, &found.collect::<Result<Vec<_>, _>>()?.concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The file is that of this code: a scene of each family and draw is solved anew. Of the library the last digits may differ.
    #[test]
    fn the_population_is_what_this_code_measures() {
        const SCENE: u32 = 7;
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let advice = advice::read(&root).expect("advice can be read");
        let (_, file): (_, Vec<Line>) = data::read(&root, PATH).expect("the population can be read");
        for (draw, family) in [1, 2].into_iter().flat_map(|draw| Family::ALL.map(|family| (draw, family))) {
            let own = |line: &Line| {
                (line.draw, line.family.as_str(), line.scene) == (draw, family.name(), SCENE)
                    && line.solver != Solver::Clarabel.name()
            };
            let anew = lines(draw, family, SCENE, &advice).expect("the scene is solved");
            let [kept, anew] =
                [&file, &anew].map(|lines| lines.iter().filter(|line| own(line)).cloned().collect::<Vec<_>>());
            assert_eq!(kept, anew, "{} of draw {draw}: run `cargo xtask measure --only {NAME}`", family.name());
        }
    }

    /// Every scene of the first draw is solved on every grid, and has a certified solution to compare with.
    #[test]
    fn every_scene_of_the_first_draw_has_a_certified_reference() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let (_, file): (_, Vec<Line>) = data::read(&root, PATH).expect("the population can be read");
        let first: Vec<Line> = file.into_iter().filter(|line| line.draw == 1).collect();
        assert_eq!(first.len(), Family::ALL.len() * SCENES[0] as usize * METHODS.len() * GRIDS.len());
        assert!(first.iter().all(|line| line.succeeded() && line.errors().is_some()), "all answers");
    }
}
