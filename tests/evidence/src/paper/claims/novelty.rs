//! "To our knowledge a solution of the contact problem based on the force method has not been presented in the literature in
//! this form."

use super::{Claim, Verdict};

/// A claim about the literature of 1984: nothing is measured, and no search can show that something was never printed.
pub(super) fn claim() -> Claim {
    Claim {
        name: "novelty_of_the_force_method",
        statement: "To our knowledge a solution of the contact problem based on the force method has not been presented in the \
                    literature in this form.",
        verdict: Verdict::Open,
        reading: None,
        summary: "a claim about the literature of 1984; the principle was known, and we know of no earlier flexibility form for a beam"
            .to_owned(),
        evidence: "What can be said: the principle was not new. The paper itself says that the minimum of complementary energy under \
                   its constraints had long been known, and claims to have discretised it. That the minimum of potential energy under \
                   unilateral constraints has such a dual was known in general form (Prager 1963, Moreau 1968), and Kalker and van \
                   Randen (1972) computed the contact of half-spaces from a minimum over contact pressures that are not negative. \
                   We know of no earlier work that does this for a beam above a rigid foundation, with the flexibility matrix of the \
                   simply supported beam in closed form (26). What cannot be said: that there is none. We searched little, and the \
                   paper's own references of this kind, /11/ to /13/, are not available to us."
            .to_owned(),
    }
}
