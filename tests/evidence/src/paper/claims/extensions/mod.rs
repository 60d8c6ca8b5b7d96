//! "The methods extend to any elastic body whose condensed stiffness or flexibility matrix can be computed, and to an elastic
//! foundation; further study is needed where the rigid motion of the body is not known beforehand. A curved beam (a ski) on a
//! straight base is almost the same problem."

mod curved_beam;
mod elastic_foundation;
mod string;
mod unsupported;

pub use curved_beam::{Curved, curved_beam};
pub use elastic_foundation::{Springs, elastic_foundation};
pub use string::{Taut, any_body};
pub use unsupported::{Unsupported, unknown_rigid_motion};
