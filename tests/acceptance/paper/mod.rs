//! What the paper says: its claims, its closed form, how its methods converge, and tables for a person.

mod claims;
mod closed_form;
mod convergence;
mod in_one_file;
mod tables;
