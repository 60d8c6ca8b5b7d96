//! The three methods, as names.

use std::fmt;

/// The three methods of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Method {
    /// Complementarity problem by finite differences, (4)–(16).
    Complementarity,
    /// Potential energy, no penetration, (17)–(24).
    Displacement,
    /// Complementary energy, no tension, (25)–(31).
    Force,
}

impl Method {
    /// All of them, in the order of the paper.
    pub const ALL: [Self; 3] = [Self::Complementarity, Self::Displacement, Self::Force];

    /// The word that command line, JSON and report use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Complementarity => "complementarity",
            Self::Displacement => "displacement",
            Self::Force => "force",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}
