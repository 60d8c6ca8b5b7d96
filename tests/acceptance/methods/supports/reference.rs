//! Beams on any supports against an authority that shares nothing with the methods: the stiffness of all deflections and rotations
//! as one dense matrix, and every set of contacts tried.

use nalgebra::{DMatrix, DVector};
use palkki::route::{Method, Solution, Solver, Status};
use palkki::scene::{Balance, Foundation, Grid, PointLoad, Scaled, Scene, Support};
use palkki::solve_exactly;
use palkki_evidence::draft::Draft;
use palkki_evidence::random::Random;

use crate::scenes::{nodes, run};

/// Intervals: few enough that every set of contacts can be tried.
const INTERVALS: usize = 8;

/// What is found by trying.
struct Optimum {
    deflection: Vec<f64>,
    /// What holds each node, upwards: contact or support.
    force: Vec<f64>,
    energy: f64,
}

/// A discrete beam as `½ dᵀK d − fᵀd + c`, with all deflections and, of beam elements, rotations in `d`.
struct Dense {
    stiffness: DMatrix<f64>,
    loads: DVector<f64>,
    constant: f64,
    /// Freedoms for each node: one or two.
    each: usize,
    gaps: Vec<f64>,
    /// Freedoms that supports fix, with their values.
    fixed: Vec<(usize, f64)>,
}

impl Dense {
    fn of(scene: &Scene, method: Method) -> Self {
        let grid = Grid::uniform(scene, INTERVALS).expect("enough intervals");
        let (spacing, stiffness) = (grid.spacing(), scene.beam().bending_stiffness());
        let each = if method == Method::Complementarity { 1 } else { 2 };
        let freedoms = each * (INTERVALS + 1);
        let mut dense = Self {
            stiffness: DMatrix::zeros(freedoms, freedoms),
            loads: DVector::zeros(freedoms),
            constant: 0.0,
            each,
            gaps: (0..=INTERVALS).map(|i| scene.gap(grid.place(i))).collect(),
            fixed: Vec::new(),
        };
        for (i, q) in grid.nodal_loads(scene.load()).into_iter().enumerate() {
            dense.loads[each * i] = q;
        }
        let cube = stiffness / (spacing * spacing * spacing);
        let held: Vec<_> = scene.held().iter().map(|h| (grid.node_at(h.at).expect("a node"), *h)).collect();
        for (node, held) in &held {
            dense.fixed.push((each * node, held.deflection));
            if each == 2 {
                dense.fixed.extend(held.slope.map(|slope| (2 * node + 1, slope)));
            }
        }
        if each == 2 {
            dense.elements(cube, spacing);
        } else {
            let slope = |node| held.iter().find(|(at, _)| *at == node).and_then(|(_, held)| held.slope);
            (0..=INTERVALS).for_each(|node| dense.cell(node, slope(node), cube, spacing));
        }
        dense
    }

    /// Beam elements between the nodes.
    fn elements(&mut self, cube: f64, d: f64) {
        let e = d * d;
        let element = [
            [12.0, 6.0 * d, -12.0, 6.0 * d],
            [6.0 * d, 4.0 * e, -6.0 * d, 2.0 * e],
            [-12.0, -6.0 * d, 12.0, -6.0 * d],
            [6.0 * d, 2.0 * e, -6.0 * d, 4.0 * e],
        ];
        for i in 0..INTERVALS {
            for (r, row) in element.iter().enumerate() {
                for (c, entry) in row.iter().enumerate() {
                    self.stiffness[(2 * i + r, 2 * i + c)] += cube * entry;
                }
            }
        }
    }

    /// The second difference at a node, or what holds its slope: a built-in node has half a cell on each side.
    fn cell(&mut self, node: usize, slope: Option<f64>, cube: f64, spacing: f64) {
        match slope {
            Some(slope) => {
                if 0 < node {
                    self.hinge(2.0 * cube, &[(node - 1, 1.0), (node, -1.0)], slope * spacing);
                }
                if node < INTERVALS {
                    self.hinge(2.0 * cube, &[(node, -1.0), (node + 1, 1.0)], -slope * spacing);
                }
            }
            None if 0 < node && node < INTERVALS => {
                self.hinge(cube, &[(node - 1, 1.0), (node, -2.0), (node + 1, 1.0)], 0.0);
            }
            None => {}
        }
    }

    /// Adds `½ k (Σ a_i v_i + b)²`.
    fn hinge(&mut self, k: f64, shares: &[(usize, f64)], b: f64) {
        for &(i, a) in shares {
            for &(j, c) in shares {
                self.stiffness[(i, j)] += k * a * c;
            }
            self.loads[i] -= k * a * b;
        }
        self.constant += 0.5 * k * b * b;
    }

    /// The optimum, by trying every set of contacts.
    fn optimum(&self) -> Option<Optimum> {
        let supported = |node: usize| self.fixed.iter().any(|(freedom, _)| *freedom == self.each * node);
        // Where there is nothing to touch nothing is tried.
        let open: Vec<usize> =
            (0..=INTERVALS).filter(|&node| !supported(node) && self.gaps[node].is_finite()).collect();
        let built_in = self.fixed.len() > self.fixed.iter().filter(|(freedom, _)| freedom % self.each == 0).count();
        (0_usize..1 << open.len()).find_map(|set| {
            let contacts: Vec<usize> =
                open.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, node)| *node).collect();
            let places = contacts.len() + self.fixed.iter().filter(|(freedom, _)| freedom % self.each == 0).count();
            // Finite differences hold a built-in slope by a spring and no freedom.
            let turned = built_in || self.constant != 0.0 || self.slope_held();
            if places < 2 && !turned {
                return None;
            }
            let mut fixed = self.fixed.clone();
            fixed.extend(contacts.iter().map(|&node| (self.each * node, self.gaps[node])));
            let (d, force) = self.solved(&fixed)?;
            let deflection: Vec<f64> = (0..=INTERVALS).map(|node| d[self.each * node]).collect();
            let pressed = contacts.iter().all(|&node| -1e-10 <= force[self.each * node]);
            let above = open.iter().all(|&node| deflection[node] <= self.gaps[node] + 1e-10);
            (pressed && above).then(|| Optimum {
                deflection,
                force: (0..=INTERVALS).map(|node| force[self.each * node]).collect(),
                energy: 0.5 * (&self.stiffness * &d).dot(&d) - self.loads.dot(&d) + self.constant,
            })
        })
    }

    /// Whether a rotation of the whole beam costs energy.
    fn slope_held(&self) -> bool {
        let turn = DVector::from_fn(self.loads.len(), |i, _| match (self.each, i % self.each) {
            (1, _) => i as f64,
            (_, 0) => (i / 2) as f64,
            _ => 0.0,
        });
        self.each == 1 && 1e-9 < (&self.stiffness * &turn).dot(&turn)
    }

    /// All freedoms, and the forces that fix some of them.
    fn solved(&self, fixed: &[(usize, f64)]) -> Option<(DVector<f64>, DVector<f64>)> {
        let n = self.loads.len();
        let free: Vec<usize> = (0..n).filter(|i| fixed.iter().all(|(f, _)| f != i)).collect();
        let mut d = DVector::zeros(n);
        fixed.iter().for_each(|&(i, value)| d[i] = value);
        let right = (&self.loads - &self.stiffness * &d).select_rows(&free);
        let reduced = self.stiffness.select_rows(&free).select_columns(&free);
        let solution = if free.is_empty() { right } else { reduced.full_piv_lu().solve(&right)? };
        free.iter().zip(solution.iter()).for_each(|(&i, &value)| d[i] = value);
        let force = &self.loads - &self.stiffness * &d;
        Some((d, force))
    }
}

/// A scene: supports at some nodes, built in now and then or, if `push` says so, most of them such that they only push, at uneven
/// levels; rough ground, or without it loads at nodes alone; now and then with a shape.
fn scene(random: &mut Random, supports: usize, push: bool, grounded: bool) -> Option<Scene> {
    let mut held: Vec<Support> = Vec::new();
    for _ in 0..supports {
        let at = random.below(INTERVALS + 1) as f64;
        if held.iter().all(|s| (s.at - at).abs() > 0.5) {
            let level = random.between(-0.2, 0.2);
            let pushes_only = push && !random.once_in(3);
            let slope = (!pushes_only && random.once_in(3)).then(|| random.between(-0.1, 0.1));
            held.push(Support { level, slope, pushes_only, ..Support::simple(at) });
        }
    }
    if push && !held.iter().any(|s| s.pushes_only) {
        return None;
    }
    let depth = |random: &mut Random, x: f64| {
        let level = held.iter().find(|s| (s.at - x).abs() < 0.5).map_or(-0.2, |s| s.level);
        [x, level + random.between(0.02, 0.8)]
    };
    let points = (0..=8).map(|k| depth(random, f64::from(k))).collect();
    let place = |random: &mut Random| {
        if grounded { random.between(0.0, 8.0) } else { random.below(INTERVALS + 1) as f64 }
    };
    let load = |random: &mut Random| PointLoad { at: place(random), force: random.between(-0.5, 2.0) };
    let shape = random.once_in(3).then(|| [0.0, random.between(-0.1, 0.1), random.between(-0.02, 0.02)].to_vec());
    let draft = Draft {
        length: 8.0,
        stiffness: random.between(0.3, 30.0),
        uniform: if grounded { random.between(0.1, 1.5) } else { 0.0 },
        point: (0..usize::from(push) + random.below(4)).map(|_| load(random)).collect(),
        ground: grounded.then_some(Foundation::Polyline { points }),
        supports: Some(held),
        shape: shape.map(|coefficients| Foundation::Polynomial { coefficients }),
        ..Draft::default()
    };
    let scene = draft.scene().ok()?;
    // One that may turn has no deflection to compare.
    let turns = |scaled: Scaled| matches!(scaled.balance, Balance::Neutral { .. });
    scene.scaled().is_ok_and(|scaled| !turns(scaled)).then_some(scene)
}

/// Scene number `i` on up to three supports above ground.
fn holding(i: u64) -> Option<Scene> {
    let random = &mut Random::new(0x50_0000 + i);
    let supports = random.below(4);
    scene(random, supports, false, true)
}

/// Scene number `i` on two to five supports, most of which only push; every other beam is above ground.
fn pushing(i: u64) -> Option<Scene> {
    let random = &mut Random::new(0x60_0000 + i);
    let supports = 2 + random.below(4);
    scene(random, supports, true, i.is_multiple_of(2))
}

/// The largest differences of forces, deflections and energy, each relative to the size of these.
fn differences(optimum: &Optimum, found: &Solution<()>) -> [f64; 3] {
    let (state, values) = (&found.state, nodes(found));
    let first = usize::from(values.x[0] > 0.0);
    let mut forces = [0.0; INTERVALS + 1];
    values.contact_force.iter().enumerate().for_each(|(k, p)| forces[k + first] = *p);
    for support in &state.supports {
        // On a beam of 8 in 8 intervals places are nodes.
        forces[(0..=INTERVALS).min_by_key(|k| ((*k as f64 - support.at).abs() * 1e6) as u64).expect("a node")] =
            support.force;
    }
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, v| most.max(v.abs()));
    let force = largest(&mut forces.iter().zip(&optimum.force).map(|(a, b)| a - b));
    let deflections = values.deflection.iter().zip(&optimum.deflection[first..]);
    let deflection = largest(&mut deflections.map(|(a, b)| a - b));
    [
        force / largest(&mut optimum.force.iter().copied()),
        deflection / largest(&mut optimum.deflection.iter().copied()),
        (state.energy - optimum.energy).abs() / optimum.energy.abs(),
    ]
}

/// Rounding of dense systems of condition up to 10⁶.
const ROUNDED: f64 = 1e-9;

/// A solver that stops at a residual of 1e-10, in forces that may be 10⁴ times as sensitive.
const ITERATED: f64 = 1e-5;

#[test]
fn every_route_finds_what_trying_all_contacts_finds() {
    let scenes: Vec<Scene> = (0..120).filter_map(holding).collect();
    let [held, free] = every_route_is_right(&scenes);
    let is_built_in = |scene: &&Scene| scene.beam().supports().iter().any(|s| s.slope.is_some());
    let built_in = scenes.iter().filter(is_built_in).count();
    assert!(40 <= held && 20 <= free && 20 <= built_in, "{held} held, {free} free, {built_in} built in");
}

/// How many of the scenes are held by their supports, and how many are not.
fn every_route_is_right(scenes: &[Scene]) -> [usize; 2] {
    let ([mut held, mut free], [mut asked, mut solved]) = ([0; 2], [0; 2]);
    for scene in scenes {
        let supports = scene.beam().all_supports();
        let is_held = scene.scaled().expect("balanced").balance.resultant().is_none();
        *(if is_held { &mut held } else { &mut free }) += 1;
        for method in Method::ALL {
            let optimum = Dense::of(scene, method).optimum().expect("an optimum");
            for solver in Solver::OPTIMAL {
                let found = run(scene, method, solver, INTERVALS);
                let told = format!("{method}, {solver}, {supports:?}: {}", found.run.message);
                if solver == Solver::Nsor && method == Method::Force && !is_held {
                    assert!(!found.solved && found.run.message.starts_with("not tried: the supports leave"), "{told}");
                    continue;
                }
                asked += 1;
                assert!(found.solved || solver != Solver::ActiveSet, "{told}");
                if found.solved {
                    solved += 1;
                    let most = if solver == Solver::ActiveSet { ROUNDED } else { ITERATED };
                    let apart = differences(&optimum, &found);
                    assert!(apart.iter().all(|apart| *apart <= most), "{told}: {apart:?}");
                }
            }
        }
    }
    assert!(95 * asked <= 100 * solved, "only {solved} of {asked} are solved");
    [held, free]
}

/// How many random scenes with supports that only push there are.
const PUSHING: usize = 500;

#[test]
fn supports_that_only_push_are_right_by_every_route() {
    let scenes: Vec<Scene> = (0..).filter_map(pushing).take(PUSHING).collect();
    let [held, free] = every_route_is_right(&scenes);
    assert!(100 <= held && 100 <= free, "{held} held, {free} free");
}

/// Beam theory beside the same authority, which is beam theory where all loads stand at nodes and there is no ground: each force is
/// in its bracket, and what is lifted off has none.
#[test]
fn beam_theory_knows_what_only_pushes() {
    let (mut lifted, mut pressed) = (0, 0);
    for scene in (0..).filter(|i: &u64| !i.is_multiple_of(2)).filter_map(pushing).take(PUSHING) {
        let told = format!("{:?} {:?}", scene.beam().all_supports(), scene.load());
        let solution = solve_exactly(&scene).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{told}: {}", solution.verdict);
        let optimum = Dense::of(&scene, Method::Displacement).optimum().expect("an optimum");
        let size = optimum.force.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let certificate = solution.verdict.certificate.expect("bounds");
        for (support, bracket) in solution.state.supports.iter().zip(certificate.reactions) {
            let truth = optimum.force[support.at.round() as usize];
            assert!((support.force - truth).abs() <= ROUNDED * size, "{told}: {truth} at {}", support.at);
            let [least, most] = bracket.expect("a bracket");
            let rounding = ROUNDED * size;
            assert!(least - rounding <= truth && truth <= most + rounding, "{told}: {truth} in {least} … {most}");
            if support.pushes_only {
                *(if support.force == 0.0 { &mut lifted } else { &mut pressed }) += 1;
            }
        }
        let energy = optimum.energy;
        assert!((solution.state.energy - energy).abs() <= ROUNDED * energy.abs().max(size), "{told}: {energy}");
        assert!(
            certificate.energy_lower <= energy + ROUNDED * size && energy - ROUNDED * size <= certificate.energy_upper
        );
    }
    assert!(300 <= lifted && 300 <= pressed, "{lifted} lifted off, {pressed} press");
}
