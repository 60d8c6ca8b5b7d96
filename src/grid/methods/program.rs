//! The quadratic program (32) of a scene on a grid, for each method, from nothing but the beam on a set of contacts.
//!
//! ```text
//! methods 1 and 2    p = q − K v,  v = g − h     the forces that hold the beam at every node, at the level v
//! method 3           h = g − v,    v = C (q − p)  the beam on its supports alone, under loads q − p
//! ```
//!
//! On an elastic foundation `h` is the clearance of the foot of a spring, `g − v + p/kΔ`. `A` is `C + diag(1/kΔ)`, or its inverse.
//!
//! Both are linear in the unknown except for the terms from loads, gaps, levels and slopes. Without these terms they give the columns
//! of `A`. If the supports do not hold the beam there is no `C`: forces that are not in balance have no position of rest. The
//! complementary energy is then minimised over contact forces in balance.

use nalgebra::{DMatrix, DVector};

use super::contact_set::{ContactSet, OnContacts};
use super::{Discrete, Method, complementarity, displacement, force, held_beam, sparse};
use crate::qp::{FreeSet, Matrix, NotPositiveDefinite, Qp, Sizes, SparseForm, Stationary};
use crate::state::Discretisation;

/// The quadratic program of a method.
pub(super) struct Program<'a> {
    pub(super) method: Method,
    pub(super) discrete: &'a Discrete,
}

impl Program<'_> {
    /// Variables and gradient from contact forces and clearances at all nodes except supported ends.
    fn point(&self, OnContacts { contact_force, clearance }: OnContacts) -> Stationary {
        let contact_force = self.discrete.without_supports(contact_force);
        let clearance = self.discrete.without_supports(clearance);
        if self.method.is_free_in_contact() {
            return Stationary { x: contact_force, gradient: clearance };
        }
        let share = self.method.share(self.discrete);
        Stationary { x: clearance, gradient: contact_force.iter().map(|p| p / share).collect() }
    }
}

impl Qp for Program<'_> {
    fn dimension(&self) -> usize {
        self.discrete.unknowns()
    }

    /// The matrix of the paper for the paper's beam; for any other beam, column by column.
    fn matrix(&self) -> Matrix {
        if self.discrete.is_simple() {
            return match self.method {
                Method::Complementarity => complementarity::matrix(self.discrete),
                Method::Displacement => displacement::matrix(self.discrete),
                Method::Force => force::matrix(self.discrete),
            };
        }
        let n = self.dimension();
        let bare = self.discrete.bare();
        let column = |j: usize| {
            let mut unit = vec![0.0; n];
            unit[j] = 1.0;
            DVector::from_vec(Program { method: self.method, discrete: &bare }.gradient(&unit))
        };
        let matrix = DMatrix::from_columns(&(0..n).map(column).collect::<Vec<_>>());
        // Symmetric up to rounding, and callers need exact symmetry.
        let matrix = (&matrix + matrix.transpose()) * 0.5;
        match self.method {
            // Open nodes between the others make the matrix of the difference equations full.
            _ if self.discrete.has_open_nodes() => Matrix::Dense(matrix),
            Method::Complementarity if !self.discrete.gives() && self.discrete.supports().stops().is_empty() => {
                let entry = |i: usize, k: usize| if i + k < n { matrix[(i, i + k)] } else { 0.0 };
                Matrix::Pentadiagonal((0..n).map(|i| [0, 1, 2].map(|k| entry(i, k))).collect())
            }
            Method::Complementarity | Method::Displacement | Method::Force => Matrix::Dense(matrix),
        }
    }

    fn sparse(&self) -> Option<SparseForm> {
        let in_contact = self.method.is_free_in_contact();
        // For clearances at a few nodes the matrix is the better form: nothing has to be eliminated. Under compression the other form
        // is not convex.
        let few = self.discrete.has_open_nodes() && !self.discrete.gives() && !in_contact;
        if few || self.discrete.tension < 0.0 {
            return Some(SparseForm::of_matrix(self));
        }
        let form = if in_contact { sparse::complementary } else { sparse::potential };
        Some(form(self.discrete, self.method.discretisation(), self.sizes()))
    }

    /// The forces that hold the beam at every node, or the clearances of the beam on its supports alone.
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let (discrete, discretisation) = (self.discrete, self.method.discretisation());
        let x = discrete.with_supports(x.to_vec());
        if self.method.is_free_in_contact() {
            let deflection = deflection(discrete, &x, discretisation);
            let mut open = discrete.clearances(&deflection);
            for ((h, node), p) in
                open.iter_mut().zip(discrete.nodes()).zip(&x).filter(|(_, p)| discrete.gives() && **p != 0.0)
            {
                *h += discrete.give(node) * p;
            }
            let stops = discrete.supports().stops().iter().zip(&x[open.len()..]);
            let first = discrete.nodes().start;
            open.extend(
                stops.map(|(stop, force)| stop.deflection - deflection[stop.node - first] + force / stop.stiffness),
            );
            return discrete.without_supports(open);
        }
        let (at_nodes, feet) = x.split_at(discrete.nodes().len());
        let held = discrete.above(discrete.clearances(at_nodes), feet);
        let forces = ContactSet::at(&held, held.places()).solve(&held, discretisation);
        forces.map_or_else(|_| vec![f64::NAN; self.dimension()], |forces| self.point(forces).gradient)
    }

    /// The beam, or chain of links, in contact where forces are free or clearances are not.
    fn stationary(&self, free: &FreeSet) -> Result<Stationary, NotPositiveDefinite> {
        let in_contact = self.method.is_free_in_contact();
        let contacts = free.iter().enumerate().filter(|(_, free)| *free == in_contact);
        let contacts = ContactSet::at(self.discrete, contacts.map(|(i, _)| self.discrete.place(i)));
        Ok(self.point(contacts.solve(self.discrete, self.method.discretisation())?))
    }

    fn make_definite(&self, free: &mut FreeSet) {
        self.discrete.hold(free, self.method.is_free_in_contact(), |i| self.discrete.place(i));
    }

    fn without_matrix(&self) -> Option<&'static str> {
        (self.method.is_free_in_contact() && !self.discrete.is_held()).then_some(NO_FLEXIBILITY)
    }

    fn sizes(&self) -> Sizes {
        let Sizes { x: clearance, gradient: force } = self.discrete.sizes();
        if self.method.is_free_in_contact() {
            return Sizes { x: force, gradient: clearance };
        }
        Sizes { x: clearance, gradient: force / self.method.share(self.discrete) }
    }
}

/// The reason why a beam that its supports do not hold has no flexibility matrix.
const NO_FLEXIBILITY: &str =
    "the supports leave the beam free to move as a whole, so that there is no flexibility matrix";

/// The deflection at all nodes except supported ends, for the beam on its supports under its loads less contact forces given at slots.
pub(super) fn deflection(discrete: &Discrete, forces: &[f64], discretisation: Discretisation) -> Vec<f64> {
    let unknown = || vec![f64::NAN; discrete.nodes().len()];
    if !discrete.is_held() {
        return unknown();
    }
    let basic = discrete.basic(remaining(discrete, forces));
    held_beam::on_supports(&basic, discretisation).map_or_else(|_| unknown(), |beam| beam.deflection())
}

/// `q − p` at all nodes, for contact forces given at slots.
fn remaining(discrete: &Discrete, forces: &[f64]) -> Vec<f64> {
    let mut loads = discrete.loads.clone();
    let (at_nodes, stops) = forces.split_at(discrete.nodes().len());
    loads[discrete.nodes()].iter_mut().zip(at_nodes).for_each(|(q, p)| *q -= p);
    discrete.supports().stops().iter().zip(stops).for_each(|(stop, p)| loads[stop.node] -= p);
    loads
}
