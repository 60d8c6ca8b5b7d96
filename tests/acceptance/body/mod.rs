//! Any elastic body: answers known by construction beside what is proven.

mod gaps;
mod known;
mod layouts;
mod messages;
mod random;
mod shear;
mod slab;
