//! Any elastic body: answers known by construction beside what is proven.

mod known;
mod messages;
mod random;
mod slab;
