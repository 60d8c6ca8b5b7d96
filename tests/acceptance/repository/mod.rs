//! The invariants of ARCHITECTURE.md, asked of the source text.

mod arithmetic;
mod dependencies;
mod documents;
mod examples;
mod inventory;
mod layers;
mod snapshots;
mod text;
mod tree;
