//! Counts over many runs.

use std::collections::BTreeMap;

use super::scenes::Family;
use super::trial::{self, Trial};

/// What became of the runs of one family.
#[derive(Debug, Default, Clone)]
pub struct Count {
    /// All runs.
    pub runs: usize,
    /// Runs whose text is no scene.
    pub refused: usize,
    /// Beam theory: solved, not solved, no answer.
    pub exact: [usize; 3],
    /// Of the solved answers of theory those that have a bound.
    pub bounded: usize,
    /// Those that the program calls certified in the end.
    pub certified: usize,
    /// Those without a bound, of beams that all but turn over.
    pub all_but_turns: usize,
    /// The active set on a grid: certified, not certified.
    pub reference: [usize; 2],
    /// A route with any method and solver: certified, not certified.
    pub route: [usize; 2],
    /// Runs in which a solver says success, or almost, and the judge does not.
    pub contradicted: usize,
    /// Runs in which an answer was compared with that in other units.
    pub rescaled: usize,
    /// Runs in which derivatives were compared with differences.
    pub derived: usize,
    /// Runs in which a sweep was compared with its rows.
    pub swept: usize,
    /// Sets of contact forces that were brought and judged.
    pub brought: usize,
    /// The most lists of contacts that theory tried, the most iterations of a route.
    pub work: [usize; 2],
    /// Runs in which something is wrong.
    pub wrong: usize,
    /// Runs that panicked.
    pub panics: usize,
}

/// Counts by family, and the runs that went wrong.
#[derive(Debug, Default)]
pub struct Tally {
    /// Counts of each family.
    pub families: BTreeMap<Family, Count>,
    /// Seed and message.
    pub wrong: Vec<(u64, String)>,
}

impl Tally {
    /// Runs one seed. A panic is caught here and counted: this is the one place that looks for it.
    pub fn run(&mut self, seed: u64) {
        match std::panic::catch_unwind(|| trial::run(seed)) {
            Ok((family, trial)) => self.add(seed, family, trial),
            Err(_) => {
                let (family, ..) = trial::draft(seed);
                let count = self.families.entry(family).or_default();
                count.runs += 1;
                count.panics += 1;
                self.wrong.push((seed, format!("{}: panic", family.name())));
            }
        }
    }

    /// With the counts of another part of the runs.
    pub fn join(&mut self, other: Self) {
        for (family, b) in other.families {
            let a = self.families.entry(family).or_default();
            let sums = [
                (&mut a.runs, b.runs),
                (&mut a.refused, b.refused),
                (&mut a.bounded, b.bounded),
                (&mut a.certified, b.certified),
                (&mut a.all_but_turns, b.all_but_turns),
                (&mut a.contradicted, b.contradicted),
                (&mut a.rescaled, b.rescaled),
                (&mut a.derived, b.derived),
                (&mut a.swept, b.swept),
                (&mut a.brought, b.brought),
                (&mut a.wrong, b.wrong),
                (&mut a.panics, b.panics),
            ];
            sums.into_iter().for_each(|(a, b)| *a += b);
            a.exact.iter_mut().zip(b.exact).for_each(|(a, b)| *a += b);
            a.reference.iter_mut().zip(b.reference).for_each(|(a, b)| *a += b);
            a.route.iter_mut().zip(b.route).for_each(|(a, b)| *a += b);
            a.work.iter_mut().zip(b.work).for_each(|(a, b)| *a = b.max(*a));
        }
        self.wrong.extend(other.wrong);
    }

    fn add(&mut self, seed: u64, family: Family, trial: Trial) {
        let count = self.families.entry(family).or_default();
        count.runs += 1;
        if !trial.accepted {
            count.refused += 1;
            return;
        }
        let index = |solved: bool| usize::from(!solved);
        count.exact[trial.exact.map_or(2, index)] += 1;
        if trial.exact == Some(true) {
            count.bounded += usize::from(trial.bounded);
            count.certified += usize::from(trial.certified);
            count.all_but_turns += usize::from(!trial.bounded && trial.all_but_turns);
        }
        if let Some(solved) = trial.reference {
            count.reference[index(solved)] += 1;
        }
        if let Some(solved) = trial.route {
            count.route[index(solved)] += 1;
        }
        count.contradicted += usize::from(trial.contradicted);
        count.rescaled += usize::from(trial.rescaled);
        count.derived += usize::from(trial.derived);
        count.swept += usize::from(trial.swept);
        count.brought += trial.brought;
        for (most, work) in count.work.iter_mut().zip(trial.work) {
            *most = work.max(*most);
        }
        count.wrong += usize::from(!trial.wrong.is_empty());
        self.wrong.extend(trial.wrong.into_iter().map(|what| (seed, format!("{}: {what}", family.name()))));
    }
}
