//! What the paper shows and says: its figures, its claims and its advice, and how far all routes agree on its example.

pub(super) mod agreement;
pub(super) mod claims;
mod drawings;
pub(super) mod figures;
pub(super) mod flexibility;
