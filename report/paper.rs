//! # A simple beam on a rigid uneven foundation
//!
//! The whole of M. Heinisuo, "Yksinkertainen palkki jäykällä epätasaisella alustalla", *Rakenteiden Mekaniikka* 17
//! (1984) no. 1, pp. 1–16, in one file. Numbers in brackets are its equations; those of lost pages are rebuilt.
//!
//! A straight beam of length `l` and bending stiffness `EI` rests on two simple supports and carries a load `q`. Below,
//! at depth `u(x)`, lies rigid ground. Depth `u` and deflection `v` count downwards, the contact pressure `p` on the
//! beam upwards. There is neither friction nor adhesion. With the clearance `h = u − v`,
//!
//! ```text
//! p = q − EI v''''                                    (5)   equilibrium
//! p ≥ 0,   h ≥ 0,   p h = 0   for all x in [0, l]     (4)   the ground pushes, or it is not there
//! v(0) = v(l) = 0,   v''(0) = v''(l) = 0              (8)   simple supports
//! ```
//!
//! If we knew where the beam touches, the problem would be linear. The paper finds out in three ways.
#![allow(missing_docs, missing_debug_implementations, unreachable_pub, clippy::print_stdout, reason = "for readers")]
use nalgebra::{DMatrix as Matrix, DVector as Vector, Matrix4};

/// ## The scene
/// The grid has `n` interior nodes at spacing `Δ = l/(n+1)`. Load and depth are known at these: `q_i` and `p_i` are nodal
/// forces from here on, `q_i = q₀ Δ` for a uniform load (27).
pub struct Scene {
    pub length: f64,            // l
    pub bending_stiffness: f64, // EI
    pub load: Vector<f64>,      // q_i, i = 1 … n
    pub depth: Vector<f64>,     // u_i
}

/// ## Method 1. The complementarity problem, by finite differences
/// As `v = v'' = 0` at both ends, the fourth difference is the second taken twice: `D = tridiag(−1, 2, −1)` makes
/// `D² = pentadiag(1, −4, 6, −4, 1)`, with 5 in two corners, and (5) is `EI/Δ³ D² v = q − p`.
fn differences(l: f64, ei: f64, n: usize) -> Matrix<f64> {
    let delta = l / (n + 1) as f64;
    let d = Matrix::from_fn(n, n, |i, j| *[2.0, -1.0].get(i.abs_diff(j)).unwrap_or(&0.0));
    ei / delta.powi(3) * (&d * &d)
}

/// ## Method 2. Displacements: least potential energy, no penetration
/// Minimise `½∫EI v''² dx − ∫q v dx` over `v ≤ u` (17), (18), on cubic elements with `v` and `θ = v'` at each node. A
/// beam between nodal forces is a cubic, so these elements are exact. Rotations carry no load; eliminating them leaves
/// `K v = q − p` with the condensed stiffness `K = K_vv − K_vθ K_θθ⁻¹ K_θv` (20).
fn stiffness(l: f64, ei: f64, n: usize) -> Matrix<f64> {
    let (m, d) = (n + 2, l / (n + 1) as f64); // the supports are nodes as well
    #[rustfmt::skip]
    let element = ei / d.powi(3) * Matrix4::new(
         12.0,      6.0 * d,     -12.0,      6.0 * d,
         6.0 * d,   4.0 * d * d, -6.0 * d,   2.0 * d * d,
        -12.0,     -6.0 * d,      12.0,     -6.0 * d,
         6.0 * d,   2.0 * d * d, -6.0 * d,   4.0 * d * d,
    );
    let mut k = Matrix::<f64>::zeros(2 * m, 2 * m); // all deflections, then all rotations
    for unknowns in (0..=n).map(|left| [left, m + left, left + 1, m + left + 1]) {
        for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
            k[(unknowns[i], unknowns[j])] += element[(i, j)];
        }
    }
    let (k_vv, k_vt, k_tt) = (k.view((1, 1), (n, n)), k.view((1, m), (n, m)), k.view((m, m), (m, m)));
    k_vv - k_vt * k_tt.into_owned().cholesky().expect("K_θθ > 0").solve(&k_vt.transpose())
}

/// ## Method 3. Forces: least complementary energy, no tension
/// `v = C (q − p)` (25), (27), and `K C = I`: dual to method 2, with the same answer. In closed form,
///
/// ```text
/// c_ij = l³ (1+n−j) i (2 j (n+1) − j² − i²) / (6 EI (n+1)⁴),      i ≤ j,      symmetric      (26)
/// ```
fn flexibility(l: f64, ei: f64, n: usize) -> Matrix<f64> {
    let m = (n + 1) as f64;
    Matrix::from_fn(n, n, |row, column| {
        let (i, j) = ((row.min(column) + 1) as f64, (row.max(column) + 1) as f64);
        l.powi(3) * (m - j) * i * (2.0 * j * m - j * j - i * i) / (6.0 * ei * m.powi(4))
    })
}

/// ## One quadratic program for all three
/// ```text
/// minimise  ½ xᵀA x − bᵀx  subject to  x ≥ 0                     (32)     method  x   A         b        g
/// gradient  g = A x − b                                          (33)     1       h   EI/Δ³ D²  A u − q  p
/// optimum   g_i ≥ 0 where x_i = 0,  g_j = 0 where x_j > 0  (34), (35)     2       h   K         A u − q  p
///                                                                         3       p   C         A q − u  h
/// ```
pub struct Program {
    a: Matrix<f64>,
    b: Vector<f64>,
}

pub fn programs(scene: &Scene) -> [(&'static str, Program); 3] {
    let Scene { length: l, bending_stiffness: ei, load: q, depth: u } = scene;
    let [a, k, c] = [differences, stiffness, flexibility].map(|matrix| matrix(*l, *ei, u.len()));
    [
        ("complementarity", Program { b: &a * u - q, a }),
        ("displacement", Program { b: &k * u - q, a: k }),
        ("force", Program { b: &c * q - u, a: c }),
    ]
}

impl Program {
    pub fn gradient(&self, x: &Vector<f64>) -> Vector<f64> {
        &self.a * x - &self.b
    }

    /// How far `x ≥ 0` is from (34): the largest `min(a_ii x_i, g_i)`, as a share of the largest `b_i`.
    pub fn residual(&self, x: &Vector<f64>) -> f64 {
        self.a.diagonal().component_mul(x).inf(&self.gradient(x)).amax() / self.b.amax()
    }

    /// Solves `A x = b` for the variables that are free; the others are zero.
    fn solve(&self, free: &[usize]) -> Vector<f64> {
        let a = self.a.select_rows(free).select_columns(free).cholesky().expect("A > 0");
        let mut x = Vector::zeros(self.b.len());
        free.iter().zip(&a.solve(&self.b.select_rows(free))).for_each(|(&i, &value)| x[i] = value);
        x
    }
}

/// ## The paper's algorithm, as printed
pub fn four_steps(program: &Program) -> (Vector<f64>, usize) {
    let mut free: Vec<usize> = (0..program.b.len()).collect();
    loop {
        let x = program.solve(&free); //                      1° Solve A x = b.
        let smallest = x.imin();
        if 0.0 <= x[smallest] {
            return (x, program.b.len() - free.len() + 1); //  2° If x ≥ 0, the solution has been found.
        }
        free.retain(|&i| i != smallest); //                   3° Set min { x_i | i = 1 … n } = 0.   4° Return to 1°.
    }
}

/// They lead to the edge of the feasible set, "from where one can continue with some algorithm of nonlinear
/// optimisation". Here it is an active set: move towards the solution on the free variables until one reaches zero,
/// and fix it there. At a solution, free the fixed variable of most negative `g`. Each solution has less energy: it ends.
pub fn active_set(program: &Program) -> (Vector<f64>, usize) {
    let (mut x, mut steps) = four_steps(program);
    let mut free: Vec<usize> = (0..x.len()).filter(|&i| 0.0 < x[i]).collect();
    loop {
        let y = program.solve(&free);
        let reach = |i: usize| x[i] / (x[i] - y[i]);
        if let Some(i) = free.iter().copied().filter(|&i| y[i] < 0.0).min_by(|&i, &j| reach(i).total_cmp(&reach(j))) {
            x = &x + reach(i) * (&y - &x);
            free.retain(|&j| j != i);
        } else {
            let g = program.gradient(&y);
            if -1e-10 * program.b.amax() <= g.min() {
                return (y, steps);
            }
            x = y;
            free.push(g.imin());
        }
        steps += 1;
    }
}

/// NSOR, for large `n` (Mangasarian 1977): `x_i ← max(0, x_i − ω g_i / a_ii)`, sweep after sweep.
pub fn nsor(program: &Program) -> (Vector<f64>, usize) {
    let (omega, mut x, mut sweeps) = (1.8, Vector::zeros(program.b.len()), 0);
    while sweeps < 20_000 && 1e-10 < program.residual(&x) {
        for i in 0..x.len() {
            x[i] = f64::max(0.0, x[i] - omega * (program.a.column(i).dot(&x) - program.b[i]) / program.a[(i, i)]);
        }
        sweeps += 1;
    }
    (x, sweeps)
}

/// ## The example, and what must come out
/// On flat ground beam theory is exact. The beam hangs free over a length `a` at each end and comes to the ground with
/// `v = u₀`, `v' = v'' = 0`: so `EI v = q₀ x⁴/24 − T x³/6 + c x` has `a⁴ = 24 EI u₀/q₀`, and the end reaction is
/// `T = q₀ a/2`. Shear jumps by as much at each lift-off: a point force `T`, which a grid gives to one node or two.
/// The paper prints 1,18 for `T`, and 1,14 for the first contact force of method 3 with `n = 29`. Its four steps are
/// enough there; with `n = 99` they stop short of the optimum of method 2.
pub fn results() -> String {
    let (l, ei, q0, u0) = (10.0, 500.0 / 384.0, 1.0, 1.0);
    let a = f64::powf(24.0 * ei * u0 / q0, 0.25);
    let t = q0 * a / 2.0;
    let mut out = String::new();
    for n in [29, 99] {
        out += &format!("n = {n:<14}solver      touches at   contact force   end reaction   optimal to   steps\n");
        out += &format!("beam theory       exact      {a:11.5} {t:15.5} {t:14.5}\n");
        let [load, depth] = [q0 * l / (n + 1) as f64, u0].map(|value| Vector::from_element(n, value));
        for (method, program) in programs(&Scene { length: l, bending_stiffness: ei, load, depth }) {
            let answers = [four_steps(&program), active_set(&program), nsor(&program)];
            for (solver, (x, steps)) in ["four-step", "active-set", "nsor"].into_iter().zip(answers) {
                let p = if method == "force" { x.clone() } else { program.gradient(&x) };
                let first = p.iter().position(|&p| 1e-6 < p).expect("it touches");
                let place = Vector::from_fn(n, |i, _| (i + 1) as f64 / (n + 1) as f64);
                let reaction = q0 * l / 2.0 - p.sum() + p.dot(&place);
                let (at, force, residual) = (l * place[first], p[first], program.residual(&x).max(1e-14));
                out += &format!(
                    "{method:17} {solver:10} {at:11.5} {force:15.5} {reaction:14.5} {residual:12.0e} {steps:7}\n"
                );
            }
        }
    }
    out
}

fn main() {
    print!("{}", results());
}
