//! What the paper says: how its methods converge, and that it fits into one file. Its claims and its example by every route are in the
//! report.

mod convergence;
mod in_one_file;
