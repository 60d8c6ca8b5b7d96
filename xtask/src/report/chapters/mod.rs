//! The chapters of the report, one module and one template each.
//!
//! To add one: `report/chapters/<number>-<name>.md`, a module `<name>` here with `evidence(study)`, and a line in
//! [`CHAPTERS`]. The numbers give the order; leave gaps. The template sees the values as `{{ <name>.field }}`, with `_`
//! for `-`, and those of all other chapters as well.

mod agreement;
mod bounds;
mod claims;
mod conditioning;
mod convergence;
mod dial;
mod discrepancies;
mod extremes;
mod figures;
mod front;
mod hostile;
mod judged;
mod methods;
mod problem;
mod recommendation;
mod regimes;
mod reproduce;
mod scenes;
mod solvers;
mod theory;
mod trade;

use super::error::Cause;
use super::evidence::Evidence;
use super::study::Study;

/// The chapters in their order. The first has the title of the report, the others are listed in the contents.
pub(super) const CHAPTERS: &[Chapter] = &[
    Chapter { name: "00-front", evidence: front::evidence },
    Chapter { name: "10-problem", evidence: problem::evidence },
    Chapter { name: "20-methods", evidence: methods::evidence },
    Chapter { name: "25-theory", evidence: theory::evidence },
    Chapter { name: "30-solvers", evidence: solvers::evidence },
    Chapter { name: "40-figures", evidence: figures::evidence },
    Chapter { name: "45-regimes", evidence: regimes::evidence },
    Chapter { name: "50-agreement", evidence: agreement::evidence },
    Chapter { name: "55-bounds", evidence: bounds::evidence },
    Chapter { name: "56-judged", evidence: judged::evidence },
    Chapter { name: "57-dial", evidence: dial::evidence },
    Chapter { name: "60-convergence", evidence: convergence::evidence },
    Chapter { name: "70-scenes", evidence: scenes::evidence },
    Chapter { name: "80-claims", evidence: claims::evidence },
    Chapter { name: "90-recommendation", evidence: recommendation::evidence },
    Chapter { name: "100-trade", evidence: trade::evidence },
    Chapter { name: "102-conditioning", evidence: conditioning::evidence },
    Chapter { name: "105-extremes", evidence: extremes::evidence },
    Chapter { name: "107-hostile", evidence: hostile::evidence },
    Chapter { name: "110-discrepancies", evidence: discrepancies::evidence },
    Chapter { name: "120-reproduce", evidence: reproduce::evidence },
];

/// One chapter.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chapter {
    /// Name of the template in `report/chapters`, without `.md`.
    pub(super) name: &'static str,
    /// Computes what the template interpolates.
    pub(super) evidence: fn(&Study<'_>) -> Result<Evidence, Cause>,
}

impl Chapter {
    /// The name under which templates see the values: that of the file without its number.
    pub(super) fn key(&self) -> String {
        self.name.trim_start_matches(|c: char| c.is_ascii_digit() || c == '-').replace('-', "_")
    }

    /// The number that orders the chapters.
    #[cfg(test)]
    pub(super) fn number(&self) -> Option<u32> {
        self.name.split_once('-')?.0.parse().ok()
    }
}
