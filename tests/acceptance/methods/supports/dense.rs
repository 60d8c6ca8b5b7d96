//! A discrete beam as one dense matrix of all deflections and rotations, with every set of contacts tried: it shares nothing with the
//! methods.

use nalgebra::{DMatrix, DVector};
use palkki::route::Method;
use palkki::scene::{Grid, Held, Scene};

/// What is found by trying.
pub(super) struct Optimum {
    pub(super) deflection: Vec<f64>,
    /// What holds each node, upwards: contact or support.
    pub(super) force: Vec<f64>,
    pub(super) energy: f64,
}

/// A discrete beam as `½ dᵀK d − fᵀd + c`, with the deflections of all nodes first in `d`, and rotations behind them.
#[derive(Clone)]
pub(super) struct Dense {
    stiffness: DMatrix<f64>,
    loads: DVector<f64>,
    constant: f64,
    gaps: Vec<f64>,
    /// Freedoms that supports fix, with their values.
    fixed: Vec<(usize, f64)>,
    /// Supports that give: node, stiffness and level; those that only push are stops.
    springs: Vec<(usize, f64, f64)>,
    stops: Vec<(usize, f64, f64)>,
    /// Springs against turning: node, stiffness and slope.
    turning: Vec<(usize, f64, f64)>,
}

impl Dense {
    /// Of a scene on a few intervals.
    pub(super) fn of(scene: &Scene, method: Method, intervals: usize) -> Self {
        let grid = Grid::uniform(scene, intervals).expect("enough intervals");
        let (beam, nodes) = (scene.beam(), intervals + 1);
        let held: Vec<_> = scene.held().iter().map(|h| (grid.node_at(h.at).expect("a node"), *h)).collect();
        // Three freedoms of each node: its deflection, and its rotation on the left and on the right side.
        let freedoms = 3 * nodes;
        let mut dense = Self {
            stiffness: DMatrix::zeros(freedoms, freedoms),
            loads: DVector::zeros(freedoms),
            constant: 0.0,
            gaps: (0..nodes).map(|i| scene.gap(grid.place(i))).collect(),
            fixed: Vec::new(),
            springs: Vec::new(),
            stops: Vec::new(),
            turning: Vec::new(),
        };
        for spring in scene.springs() {
            let found = (grid.node_at(spring.at).expect("a node"), spring.stiffness, spring.deflection);
            let kind = if spring.pushes_only { &mut dense.stops } else { &mut dense.springs };
            kind.push(found);
        }
        let turning =
            scene.springs().map(|s| (s.at, s.turning)).chain(scene.held().into_iter().map(|h| (h.at, h.turning)));
        let turning =
            turning.filter_map(|(at, turning)| turning.map(|[k, slope]| (grid.node_at(at).expect("a node"), k, slope)));
        dense.turning = turning.collect();
        for (i, q) in grid.nodal_loads(scene).into_iter().enumerate() {
            dense.loads[i] = q;
        }
        dense.fixed.extend(held.iter().map(|(node, held)| (*node, held.deflection)));
        let stiffness_of = |i: usize| {
            let middle = 0.5 * (grid.place(i) + grid.place(i + 1));
            let mut steps = beam.steps().iter().filter(|step| step[0] <= middle);
            steps.next_back().map_or(beam.bending_stiffness(), |step| step[1])
        };
        for i in 0..intervals {
            let rotations = [2 * nodes + i, nodes + i + 1];
            let stiffness = stiffness_of(i);
            if method == Method::Complementarity {
                dense.halves(i, rotations, stiffness / grid.spacing(), grid.spacing());
            } else {
                dense.element(i, rotations, stiffness, grid.spacing());
            }
        }
        dense.join(scene, &grid, &held);
        for (node, k, level) in dense.springs.clone() {
            dense.spring(k, &[(node, 1.0)], -level);
        }
        dense
    }

    /// What joins the rotations on both sides of each node, and holds them.
    fn join(&mut self, scene: &Scene, grid: &Grid, held: &[(usize, Held)]) {
        let nodes = self.gaps.len();
        let size = self.stiffness.diagonal().amax();
        for node in 0..nodes {
            let (left, right) = (nodes + node, 2 * nodes + node);
            if let Some(&(_, k, slope)) = self.turning.clone().iter().find(|turning| turning.0 == node) {
                self.spring(k, &[(if node == 0 { right } else { left }, 1.0)], -slope);
            }
            let joint = scene.beam().joints().iter().find(|joint| grid.node_at(joint.at) == Some(node));
            if let Some(slope) = held.iter().find(|(at, _)| *at == node).and_then(|(_, held)| held.slope) {
                self.fixed.extend([(left, slope), (right, slope)]);
            } else if node == 0 {
                self.fixed.push((left, 0.0));
            } else if node + 1 == nodes {
                self.fixed.push((right, 0.0));
            } else if let Some(joint) = joint {
                self.spring(joint.stiffness.unwrap_or(0.0), &[(left, -1.0), (right, 1.0)], 0.0);
            } else {
                self.merge(left, right, size);
            }
        }
    }

    /// Makes one freedom of two.
    fn merge(&mut self, kept: usize, gone: usize, size: f64) {
        let row = self.stiffness.row(gone).clone_owned();
        let mut into = self.stiffness.row_mut(kept);
        into += &row;
        let column = self.stiffness.column(gone).clone_owned();
        let mut into = self.stiffness.column_mut(kept);
        into += &column;
        self.stiffness.row_mut(gone).fill(0.0);
        self.stiffness.column_mut(gone).fill(0.0);
        self.stiffness[(gone, gone)] = size;
    }

    /// A beam element between two nodes.
    fn element(&mut self, i: usize, [left, right]: [usize; 2], stiffness: f64, d: f64) {
        let (unit, e) = (stiffness / (d * d * d), d * d);
        let entries = [
            [12.0, 6.0 * d, -12.0, 6.0 * d],
            [6.0 * d, 4.0 * e, -6.0 * d, 2.0 * e],
            [-12.0, -6.0 * d, 12.0, -6.0 * d],
            [6.0 * d, 2.0 * e, -6.0 * d, 4.0 * e],
        ];
        let freedoms = [i, left, i + 1, right];
        for (r, row) in entries.iter().enumerate() {
            for (c, entry) in row.iter().enumerate() {
                self.stiffness[(freedoms[r], freedoms[c])] += unit * entry;
            }
        }
    }

    /// A rigid link between two nodes with an elastic half cell at each of its ends.
    fn halves(&mut self, i: usize, rotations: [usize; 2], stiffness: f64, spacing: f64) {
        for rotation in rotations {
            let turned = [(i, -1.0 / spacing), (i + 1, 1.0 / spacing), (rotation, -1.0)];
            self.spring(2.0 * stiffness, &turned, 0.0);
        }
    }

    /// Adds `½ k (Σ a_i d_i + b)²`.
    fn spring(&mut self, k: f64, shares: &[(usize, f64)], b: f64) {
        for &(i, a) in shares {
            for &(j, c) in shares {
                self.stiffness[(i, j)] += k * a * c;
            }
            self.loads[i] -= k * a * b;
        }
        self.constant += 0.5 * k * b * b;
    }

    /// The same with some stops pressed.
    fn pressing(&self, stops: &[usize]) -> Self {
        let mut pressed = self.clone();
        for (node, k, level) in stops.iter().map(|stop| self.stops[*stop]) {
            pressed.spring(k, &[(node, 1.0)], -level);
        }
        pressed
    }

    /// The optimum, by trying every set of contacts and stops.
    pub(super) fn optimum(&self) -> Option<Optimum> {
        let nodes = self.gaps.len();
        let supported = |node: usize| self.fixed.iter().any(|(freedom, _)| *freedom == node);
        // Where there is nothing to touch nothing is tried.
        let open: Vec<usize> = (0..nodes).filter(|&node| !supported(node) && self.gaps[node].is_finite()).collect();
        let tried = open.len() + self.stops.len();
        (0_usize..1 << tried).find_map(|set| {
            let is_in = |k: usize| set >> k & 1 == 1;
            let contacts: Vec<usize> =
                open.iter().enumerate().filter(|(k, _)| is_in(*k)).map(|(_, node)| *node).collect();
            let stops: Vec<usize> = (0..self.stops.len()).filter(|k| is_in(open.len() + k)).collect();
            let (all, mut fixed) = (self.pressing(&stops), self.fixed.clone());
            fixed.extend(contacts.iter().map(|&node| (node, self.gaps[node])));
            let (d, mut force) = all.solved(&fixed)?;
            let deflection: Vec<f64> = d.iter().take(nodes).copied().collect();
            let pressed = contacts.iter().all(|&node| -1e-10 <= force[node]);
            let above = open.iter().all(|&node| deflection[node] <= self.gaps[node] + 1e-10);
            let pressing = |&(node, k, level): &(usize, f64, f64)| k * (deflection[node] - level);
            let stand = self.stops.iter().enumerate().all(|(i, stop)| {
                let by = pressing(stop) / stop.1;
                if stops.contains(&i) { -1e-10 <= by } else { by <= 1e-10 }
            });
            // Where the beam touches the ground as well, the support is what is compared.
            self.springs.iter().for_each(|spring| force[spring.0] = pressing(spring));
            self.stops.iter().for_each(|stop| force[stop.0] = pressing(stop).max(0.0));
            (pressed && above && stand).then(|| Optimum {
                deflection,
                force: force.iter().take(nodes).copied().collect(),
                energy: 0.5 * (&all.stiffness * &d).dot(&d) - all.loads.dot(&d) + all.constant,
            })
        })
    }

    /// All freedoms, and the forces that fix some of them; [`None`] where the rest can move.
    fn solved(&self, fixed: &[(usize, f64)]) -> Option<(DVector<f64>, DVector<f64>)> {
        /// Of the largest pivot: a motion without stiffness has one of rounding.
        const MOVES: f64 = 1e-12;
        let n = self.loads.len();
        let free: Vec<usize> = (0..n).filter(|i| fixed.iter().all(|(f, _)| f != i)).collect();
        let mut d = DVector::zeros(n);
        fixed.iter().for_each(|&(i, value)| d[i] = value);
        let right = (&self.loads - &self.stiffness * &d).select_rows(&free);
        let reduced = self.stiffness.select_rows(&free).select_columns(&free);
        let factor = reduced.cholesky()?;
        let pivots = factor.l_dirty().diagonal();
        if pivots.min() * pivots.min() <= MOVES * pivots.amax() * pivots.amax() {
            return None;
        }
        let solution = factor.solve(&right);
        free.iter().zip(solution.iter()).for_each(|(&i, &value)| d[i] = value);
        let force = &self.loads - &self.stiffness * &d;
        Some((d, force))
    }
}
