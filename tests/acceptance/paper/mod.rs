//! What the paper says: its claims, how its methods converge, and tables for a person.

mod claims;
mod convergence;
mod in_one_file;
mod tables;
