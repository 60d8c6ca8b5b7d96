//! The methods against each other and against exact arithmetic: matrices, loads, digits, properties.

mod axial;
mod closed;
mod digits;
mod exact;
mod general;
mod giving;
mod matrices;
mod multigrid;
mod nodal_loads;
mod properties;
mod springs;
mod supports;
