//! What the paper says: how its methods converge, and tables for a person. Its claims are measured by the report.

mod convergence;
mod in_one_file;
mod tables;
