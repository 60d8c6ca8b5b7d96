//! A beam under its loads and under given contact forces by finite elements: cubic, with nodes wherever something begins, ends or acts, and
//! so exact. It shares nothing with the library but the data types of a scene. Loads are uniform, and ground is straight in zones.

use palkki::scene::{Scene, Support};
use palkki::theory::Exact;

/// What the elements say.
pub(super) struct Found {
    /// `J`.
    pub(super) energy: f64,
    /// Places of the nodes, and deflections there.
    pub(super) deflection: Vec<[f64; 2]>,
    /// Of the supports that give, from left to right, the force that their law says.
    pub(super) springs: Vec<f64>,
}

struct Elements {
    places: Vec<f64>,
    /// Of each node the freedoms of its deflection, and of the slopes on its left and on its right.
    freedoms: Vec<[usize; 3]>,
    matrix: Vec<Vec<f64>>,
    /// By all forces, and by the loads.
    right: Vec<f64>,
    loads: Vec<f64>,
    /// What elements have of the energy beside their freedoms.
    own: f64,
    held: Vec<(usize, f64)>,
    /// `k` and `d` of springs at freedoms.
    springs: Vec<(usize, [f64; 2])>,
}

impl Elements {
    fn node(&self, x: f64) -> usize {
        self.places.iter().position(|place| place.total_cmp(&x).is_eq()).expect("a node")
    }

    fn force(&mut self, x: f64, force: f64, is_load: bool) {
        let [at, ..] = self.freedoms[self.node(x)];
        self.right[at] += force;
        self.loads[at] += if is_load { force } else { 0.0 };
    }

    /// A support, pressed or not.
    fn support(&mut self, support: &Support, presses: bool) {
        let [v, _, turn] = self.freedoms[self.node(support.at)];
        match support.stiffness {
            _ if support.pushes_only && !presses => {}
            Some(k) => self.springs.push((v, [k, support.level])),
            None => self.held.push((v, support.level)),
        }
        match (support.turning_stiffness, support.slope) {
            (Some(k), slope) => self.springs.push((turn, [k, slope.unwrap_or(0.0)])),
            (None, Some(slope)) => self.held.push((turn, slope)),
            (None, None) => {}
        }
    }

    fn element(&mut self, i: usize, stiffness: f64, [load, net]: [f64; 2]) {
        let h = self.places[i + 1] - self.places[i];
        let unit = stiffness / (h * h * h);
        let [a, b, c] = [12.0 * unit, 6.0 * h * unit, 2.0 * h * h * unit];
        let rows = [[a, b, -a, b], [b, 2.0 * c, -b, c], [-a, -b, a, -b], [b, c, -b, 2.0 * c]];
        let ([v, _, turn], [next, other, _]) = (self.freedoms[i], self.freedoms[i + 1]);
        let all = [v, turn, next, other];
        let shares = [h / 2.0, h * h / 12.0, h / 2.0, -h * h / 12.0];
        for (row, (i, share)) in rows.iter().zip(all.iter().zip(shares)) {
            row.iter().zip(all).for_each(|(value, j)| self.matrix[*i][j] += value);
            self.right[*i] += net * share;
            self.loads[*i] += load * share;
        }
        let bow = h * h * h * h * h / (720.0 * stiffness);
        self.own += (0.5 * net - load) * net * bow;
    }
}

/// The beam of an answer under its contact forces; [`None`] of one that its supports do not hold alone.
pub(super) fn found(scene: &Scene, exact: &Exact) -> Option<Found> {
    let (beam, load, state) = (scene.beam(), scene.load(), &exact.state);
    let mut places: Vec<f64> = beam.all_supports().iter().map(|support| support.at).collect();
    places.extend(beam.joints().iter().map(|joint| joint.at).chain(beam.steps().iter().map(|step| step[0])));
    places.extend(load.point().iter().map(|p| p.at).chain(load.couple().iter().map(|c| c.at)));
    places.extend(state.contacts.iter().flat_map(|c| [c.from, c.to]).chain([0.0, beam.length()]));
    places.sort_by(f64::total_cmp);
    places.dedup();
    let mut count = 0;
    let mut freedom = |joint: bool| {
        let first = count;
        count += if joint { 3 } else { 2 };
        [first, first + 1, count - 1]
    };
    let joints: Vec<Option<Option<f64>>> =
        places.iter().map(|x| beam.joints().iter().find(|j| j.at.total_cmp(x).is_eq()).map(|j| j.stiffness)).collect();
    let freedoms: Vec<[usize; 3]> = joints.iter().map(|joint| freedom(joint.is_some())).collect();
    let (matrix, [right, loads]) = (vec![vec![0.0; count]; count], [vec![0.0; count], vec![0.0; count]]);
    let mut all = Elements { places, freedoms, matrix, right, loads, own: 0.0, held: Vec::new(), springs: Vec::new() };
    for i in 0..all.places.len() - 1 {
        let middle = 0.5 * (all.places[i] + all.places[i + 1]);
        let stiffness = beam.steps().iter().rfind(|step| step[0] < middle).map_or(beam.bending_stiffness(), |s| s[1]);
        let lies = state.contacts.iter().any(|c| c.from < middle && middle < c.to);
        all.element(i, stiffness, [load.uniform(), if lies { 0.0 } else { load.uniform() }]);
    }
    for (joint, [_, left, right]) in joints.iter().zip(all.freedoms.clone()) {
        let k = joint.flatten().unwrap_or(0.0);
        for (i, j, sign) in [(left, left, 1.0), (right, right, 1.0), (left, right, -1.0), (right, left, -1.0)] {
            all.matrix[i][j] += if left == right { 0.0 } else { sign * k };
        }
    }
    load.point().iter().for_each(|p| all.force(p.at, p.force, true));
    for couple in load.couple() {
        let [_, turn, _] = all.freedoms[all.node(couple.at)];
        all.right[turn] += couple.moment;
        all.loads[turn] += couple.moment;
    }
    for contact in &state.contacts {
        match contact.end_forces {
            None => all.force(contact.from, -contact.force, false),
            Some([from, to]) => {
                all.force(contact.from, -from, false);
                all.force(contact.to, -to, false);
            }
        }
    }
    exact.forces_inside_zones().for_each(|(x, force)| all.force(x, -force, false));
    for (support, force) in beam.all_supports().iter().zip(&state.supports) {
        all.support(support, 0.0 < force.force);
    }
    all.solved(beam.springs())
}

impl Elements {
    fn solved(mut self, springs: &[Support]) -> Option<Found> {
        let bending = self.matrix.clone();
        for (i, [k, without]) in &self.springs {
            self.matrix[*i][*i] += k;
            self.right[*i] += k * without;
        }
        for &(i, value) in &self.held {
            for (j, row) in self.matrix.iter_mut().enumerate() {
                let across = std::mem::take(&mut row[i]);
                self.right[j] -= if j == i { 0.0 } else { across * value };
            }
            self.matrix[i].fill(0.0);
            (self.matrix[i][i], self.right[i]) = (1.0, value);
        }
        let u = eliminated(self.matrix, self.right)?;
        let times = |row: &Vec<f64>| row.iter().zip(&u).map(|(a, b)| a * b).sum::<f64>();
        let bent: f64 = bending.iter().zip(&u).map(|(row, u)| 0.5 * u * times(row)).sum();
        let sprung: f64 = self.springs.iter().map(|(i, [k, d])| 0.5 * k * (u[*i] - d) * (u[*i] - d)).sum();
        let deflection: Vec<[f64; 2]> =
            self.places.iter().zip(&self.freedoms).map(|(x, [i, ..])| [*x, u[*i]]).collect();
        let of = |s: &Support| {
            let v = deflection.iter().find(|[x, _]| x.total_cmp(&s.at).is_eq()).expect("a node")[1];
            let force = s.stiffness.expect("it gives") * (v - s.level);
            if s.pushes_only { force.max(0.0) } else { force }
        };
        let springs = springs.iter().map(of).collect();
        Some(Found { energy: bent + sprung + self.own - times(&self.loads), deflection, springs })
    }
}

/// Gauss's elimination; [`None`] of a singular matrix.
fn eliminated(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    let size = matrix.iter().flatten().fold(0.0, |most: f64, a| most.max(a.abs()));
    for i in 0..n {
        let pivot = (i..n).max_by(|a, b| matrix[*a][i].abs().total_cmp(&matrix[*b][i].abs()))?;
        matrix.swap(i, pivot);
        right.swap(i, pivot);
        if matrix[i][i].abs() <= 1e-13 * size {
            return None;
        }
        let (above, below) = matrix.split_at_mut(i + 1);
        for (row, value) in below.iter_mut().zip(i + 1..) {
            let factor = row[i] / above[i][i];
            row.iter_mut().zip(&above[i]).for_each(|(a, b)| *a -= factor * b);
            right[value] -= factor * right[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| matrix[i][j] * right[j]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
    }
    Some(right)
}
