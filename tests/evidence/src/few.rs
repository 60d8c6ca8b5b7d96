//! Bodies of a few freedoms, stiff and soft ones beside each other, above ground that is near, far or missing: solved in fractions by
//! trying which freedoms touch.

use dashu_ratio::RBig;
use palkki::body::{Body, Kind};
use palkki::qp::Profile;

use crate::authority::number::Number as _;
use crate::random::Random;

/// Numbers of a body, as the program is given them.
#[derive(Debug, Clone)]
pub struct Few {
    /// Which matrix it is.
    pub kind: Kind,
    /// The matrix.
    pub matrix: Vec<Vec<f64>>,
    /// Gaps, infinite where there is no ground.
    pub gap: Vec<f64>,
    /// Loads.
    pub load: Vec<f64>,
}

/// A state in fractions.
#[derive(Debug, Clone)]
pub struct State {
    /// Displacements.
    pub displacement: Vec<RBig>,
    /// Contact forces.
    pub force: Vec<RBig>,
    /// `½ vᵀ K v − qᵀ v`.
    pub energy: RBig,
}

/// A power of ten between two exponents.
fn power(random: &mut Random, from: f64, to: f64) -> f64 {
    libm::pow(10.0, random.between(from, to))
}

/// `A x = b` by elimination; none if `A` is singular.
fn solved(mut rows: Vec<Vec<RBig>>, mut b: Vec<RBig>) -> Option<Vec<RBig>> {
    let n = b.len();
    for k in 0..n {
        let pivot = rows[k].clone();
        if pivot[k] == RBig::zero() {
            return None;
        }
        let own = b[k].clone();
        for (row, value) in rows.iter_mut().zip(&mut b).skip(k + 1) {
            let share = row[k].over(&pivot[k]);
            (k..n).for_each(|j| row[j] = row[j].minus(&share.times(&pivot[j])));
            *value = value.minus(&share.times(&own));
        }
    }
    for k in (0..n).rev() {
        let rest = (k + 1..n).fold(b[k].clone(), |rest, j| rest.minus(&rows[k][j].times(&b[j])));
        b[k] = rest.over(&rows[k][k]);
    }
    Some(b)
}

fn inner(a: &[RBig], b: &[RBig]) -> RBig {
    a.iter().zip(b).fold(RBig::zero(), |sum, (a, b)| sum.plus(&a.times(b)))
}

fn all_of(values: &[f64]) -> Vec<RBig> {
    values.iter().copied().map(RBig::of).collect()
}

impl Few {
    /// A random one of two to five freedoms, diagonals from 1e3 to 1e10, gaps from 1e-6 to 1e30 and infinite ones.
    #[must_use]
    pub fn random(random: &mut Random) -> Self {
        let n = 2 + random.below(4);
        let sizes: Vec<f64> = (0..n).map(|_| power(random, 3.0, 10.0)).collect();
        let mut matrix = vec![vec![0.0; n]; n];
        match random.below(3) {
            // Springs to a wall and between neighbours.
            0 => {
                (0..n).for_each(|i| matrix[i][i] += sizes[i]);
                for i in 1..n {
                    let spring = power(random, 3.0, 10.0);
                    (matrix[i][i], matrix[i - 1][i - 1]) = (matrix[i][i] + spring, matrix[i - 1][i - 1] + spring);
                    (matrix[i][i - 1], matrix[i - 1][i]) = (-spring, -spring);
                }
            }
            form => {
                for i in 0..n {
                    matrix[i][i] = sizes[i];
                    for j in 0..if form == 1 { i } else { 0 } {
                        // Rows of less than the diagonal, so that it is definite.
                        let share = random.between(-0.24, 0.24);
                        matrix[i][j] = share * (sizes[i] * sizes[j]).sqrt();
                        matrix[j][i] = matrix[i][j];
                    }
                }
            }
        }
        let kind = if random.once_in(3) { Kind::Flexibility } else { Kind::Stiffness };
        if kind == Kind::Flexibility {
            matrix.iter_mut().flatten().for_each(|a| *a *= 1e-13);
        }
        let load: Vec<f64> = (0..n).map(|_| power(random, 0.0, 4.0) * [1.0, 1.0, -1.0, 0.0][random.below(4)]).collect();
        let mut few = Self { kind, matrix, gap: vec![f64::INFINITY; n], load };
        let free = few.touching(&[]).expect("definite").displacement;
        for (gap, free) in few.gap.iter_mut().zip(free) {
            *gap = match random.below(8) {
                0 => 0.0,
                1 => power(random, -6.0, 0.0),
                2 => power(random, -6.0, 30.0),
                3 => f64::INFINITY,
                4 => [1e9, 1e20, 1e30][random.below(3)],
                // Where the loads bring it, or nearly.
                _ => free.to_double().abs() * random.between(0.0, 1.2),
            };
        }
        few
    }

    /// The body.
    ///
    /// # Panics
    ///
    /// If its matrix is not definite.
    #[must_use]
    pub fn body(&self) -> Body {
        let matrix = Profile::full(self.load.len(), |i, j| self.matrix[i][j]);
        Body::new(self.kind, matrix, None, self.gap.clone(), self.load.clone()).expect("definite")
    }

    fn rows(&self, rows: &[usize], columns: &[usize]) -> Vec<Vec<RBig>> {
        rows.iter().map(|i| columns.iter().map(|j| RBig::of(self.matrix[*i][*j])).collect()).collect()
    }

    /// The state under contact forces.
    #[must_use]
    pub fn under(&self, force: &[RBig]) -> Option<State> {
        let all: Vec<usize> = (0..force.len()).collect();
        let load = all_of(&self.load);
        let taken: Vec<RBig> = load.iter().zip(force).map(|(q, p)| q.minus(p)).collect();
        let rows = self.rows(&all, &all);
        let displacement = match self.kind {
            Kind::Stiffness => solved(rows, taken)?,
            Kind::Flexibility => rows.iter().map(|row| inner(row, &taken)).collect(),
        };
        // K v = q − p.
        let both: Vec<RBig> = load.iter().zip(force).map(|(q, p)| q.plus(p)).collect();
        let energy = RBig::zero().minus(&inner(&displacement, &both)).over(&RBig::whole(2));
        Some(State { displacement, force: force.to_vec(), energy })
    }

    /// The state in which some freedoms are held at their ground.
    #[must_use]
    pub fn touching(&self, held: &[usize]) -> Option<State> {
        let gaps: Vec<RBig> = held.iter().map(|i| RBig::of(self.gap[*i])).collect();
        self.held_at(held, &gaps)
    }

    /// The state in which some freedoms have given displacements, and no others have forces.
    #[must_use]
    pub fn held_at(&self, held: &[usize], places: &[RBig]) -> Option<State> {
        let mut force = vec![RBig::zero(); self.load.len()];
        // What the ground has to take away of the displacement without it.
        let free = self.under(&force)?.displacement;
        let away: Vec<RBig> = held.iter().zip(places).map(|(i, place)| free[*i].minus(place)).collect();
        let flexibility = match self.kind {
            Kind::Flexibility => self.rows(held, held),
            Kind::Stiffness => {
                let all: Vec<usize> = (0..self.load.len()).collect();
                let unit = |i: usize| all.iter().map(|j| RBig::whole(i64::from(*j == i))).collect::<Vec<_>>();
                let columns: Option<Vec<_>> = held.iter().map(|i| solved(self.rows(&all, &all), unit(*i))).collect();
                columns?.iter().map(|column| held.iter().map(|i| column[*i].clone()).collect()).collect()
            }
        };
        for (i, p) in held.iter().zip(solved(flexibility, away)?) {
            force[*i] = p;
        }
        self.under(&force)
    }

    /// Whether a state has no tension and no penetration.
    fn is_admissible(&self, state: &State) -> bool {
        let above = |(v, gap): (&RBig, &f64)| gap.is_infinite() || *v <= RBig::of(*gap);
        state.force.iter().all(|p| RBig::zero() <= *p) && state.displacement.iter().zip(&self.gap).all(above)
    }

    /// The solution: of all sets of freedoms that may touch the one without tension and penetration. One that is guessed is tried first.
    ///
    /// # Panics
    ///
    /// If there is none.
    #[must_use]
    pub fn solution(&self, guess: &[usize]) -> State {
        let may: Vec<usize> = (0..self.gap.len()).filter(|i| self.gap[*i].is_finite()).collect();
        let set = |bits: usize| (0..may.len()).filter(|k| bits >> k & 1 == 1).map(|k| may[k]).collect::<Vec<_>>();
        let mut sets = std::iter::once(guess.to_vec()).chain((0..1 << may.len()).map(set));
        let found = sets.find_map(|held| self.touching(&held).filter(|state| self.is_admissible(state)));
        found.expect("a definite body has a solution")
    }
}
