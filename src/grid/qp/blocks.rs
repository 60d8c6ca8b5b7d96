//! A chain of symmetric 2 × 2 blocks, solved by an elimination that loses no digits:
//!
//! ```text
//! B y − W x = r₂        (B y)_i = c_i (y_{i+1} − y_i) − c_{i−1} (y_i − y_{i−1}) − η_i y_i
//! B x + Θ y = r₁        Θ ≥ 0 and W positive definite, tridiagonal with σ and ω beside the diagonal
//! ```
//!
//! With `h = c + e`, every pivot is a sum of positive numbers, except for differences that are small by construction:
//!
//! ```text
//! d = a g + h²,   a' = Θ' + (a c² + 2 c h σ − g σ²)/d,   g' = w' + (g c² + 2 c h ω − a ω²)/d
//! e' = η' + (c (a (g + ω) + h e) + σ (c g + h ω))/d
//! ```
//!
//! A row may instead be a rotational spring of stiffness `k` between the two sides of a node. `y` is then the same on both sides, and
//! `x` decreases by `k ψ` from left to right, with the slope `ψ = e y + g x + …` of the chain to its left. Nothing cancels:
//!
//! ```text
//! s = 1/(1 + k g):     a' = a + k s e²,   e' = s e,   g' = s g
//! ```

/// Large enough to fix the variable of its row to all digits. A power of two, so that nothing else is rounded.
pub(crate) const PENALTY: f64 = f64::from_bits(0x52b0_0000_0000_0000);

/// A member of the chain.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Block {
    /// The coupling to the next member; zero for the last one.
    pub(crate) c: f64,
    /// Diagonal entry of `W`.
    pub(crate) w: f64,
    /// Off-diagonal entry of `W` to the right: `ω`.
    pub(crate) off: f64,
    /// The off-diagonal entry `σ` of `Θ`, and the additional diagonal entry `η` of `B`, for a beam on springs.
    sigma: f64,
    eta: f64,
    /// The stiffness `k` of a rotational spring. Its `w` and `η` are those of the chain to its left.
    turning: f64,
    /// Pivot block `[[a, −h], [−h, −g]]` and `1/(a g + h²)`.
    a: f64,
    h: f64,
    g: f64,
    inverse: f64,
    /// The solution, `y` and `x`.
    pub(crate) step: [f64; 2],
}

impl Block {
    /// A member with its coupling to the next one and its entries of `W`.
    pub(crate) fn new(c: f64, w: f64, off: f64) -> Self {
        Self { c, w, off, ..Self::default() }
    }

    /// The same with the entries `σ` and `η` of a beam on springs.
    pub(crate) fn on_springs(self, sigma: f64, eta: f64) -> Self {
        Self { sigma, eta, ..self }
    }

    /// The same as a rotational spring, in a separate row before the row of its node.
    pub(crate) fn turning(self, stiffness: f64) -> Self {
        Self { turning: stiffness, ..self }
    }

    /// Whether the solution of this row is finite.
    pub(crate) fn is_finite(&self) -> bool {
        (self.step[0] + self.step[1]).is_finite()
    }

    /// Eliminates the row towards another under an axial force. `carried.a` excludes the string of the link.
    #[inline]
    fn eliminate_under_tension(&mut self, carried: Carried, theta: f64, between: Between, left: f64) -> Carried {
        if 0.0 < between.turning {
            return self.eliminate::<true>(carried, theta, between);
        }
        let [c, off, sigma] = between.entries;
        let (b, e, n) = (carried.a + theta, carried.e + self.eta, -sigma);
        self.pivot(Carried { a: b + n, ..carried }, 0.0, c);
        let bent = c * e + left;
        Carried {
            a: (b * (c * c + n * self.g) + n * e * e) * self.inverse,
            e: (b * c * (self.g + off) + e * bent) * self.inverse,
            g: (c * c * self.g + off * (c * self.h + bent) - b * off * off) * self.inverse,
        }
    }

    /// The pivot as a fraction of the sum of the magnitudes of its terms.
    fn left_of_pivot(&self, carried: Carried, theta: f64, between: Between) -> f64 {
        let ([c, _, sigma], g) = (between.entries, carried.g.abs() + self.w);
        let size = match 0.0 < between.turning {
            true => 1.0 + between.turning * g,
            false => (carried.a.abs() + theta + sigma.abs()) * g + (c + carried.e.abs()) * (c + carried.e.abs()),
        };
        1.0 / (self.inverse.abs() * size)
    }

    /// The number of negative pivots in the row. The pivot of `x` is negative, and the pivot of `y` is not as long as the beam is stable.
    pub(crate) fn negative_pivots(&self) -> usize {
        match 0.0 < self.inverse {
            true => 1,
            false if 0.0 < self.turning => 0,
            false => 2 * usize::from(self.a < 0.0),
        }
    }

    /// The pivot, if it is not positive or the solution is not finite.
    pub(crate) fn failed(&self) -> Option<f64> {
        let sound = 0.0 < self.inverse && (self.inverse + self.step[0] + self.step[1]).is_finite();
        (!sound).then_some(self.a)
    }
}

impl AsMut<Self> for Block {
    fn as_mut(&mut self) -> &mut Self {
        self
    }
}

/// The contribution of all eliminated rows to the next pivot block.
#[derive(Debug, Clone, Copy, Default)]
struct Carried {
    a: f64,
    e: f64,
    g: f64,
}

/// The coupling between two rows: the entries `c`, `ω` and `σ`, or the stiffness of a rotational spring between the two sides of a node.
#[derive(Debug, Clone, Copy)]
struct Between {
    entries: [f64; 3],
    turning: f64,
}

impl Between {
    /// The contribution of a solution on one side to the equations on the other.
    #[inline]
    fn across<const SPRINGS: bool>(self, [y, x]: [f64; 2]) -> [f64; 2] {
        let [c, off, sigma] = self.entries;
        [if SPRINGS { sigma * y + c * x } else { c * x }, c * y - off * x]
    }
}

impl Block {
    /// The coupling between this row and the one to its right.
    #[inline]
    fn beside(&self) -> Between {
        Between { entries: [self.c, self.off, self.sigma], turning: self.turning }
    }

    /// Sets the pivot block.
    #[inline]
    fn pivot(&mut self, Carried { a, e, g }: Carried, theta: f64, c: f64) {
        self.a = a + theta;
        self.h = c + (e + self.eta);
        self.g = g + self.w;
        self.inverse = 1.0 / (self.a * self.g + self.h * self.h);
    }

    /// Eliminates the row towards another.
    #[inline]
    fn eliminate<const SPRINGS: bool>(&mut self, carried: Carried, theta: f64, between: Between) -> Carried {
        let k = between.turning;
        if SPRINGS && 0.0 < k {
            (self.h, self.g) = (carried.e + self.eta, carried.g + self.w);
            self.inverse = 1.0 / (1.0 + k * self.g);
            let (Carried { a, .. }, e) = (carried, self.h);
            return Carried { a: a + theta + k * self.inverse * e * e, e: e * self.inverse, g: self.g * self.inverse };
        }
        let [c, off, sigma] = between.entries;
        self.pivot(carried, theta, c);
        let e = carried.e + self.eta;
        let (scaled, turned) = (c * self.inverse, sigma * self.inverse);
        let [of_a, of_e] = match SPRINGS {
            true => [turned * (2.0 * c * self.h - self.g * sigma), turned * (c * self.g + self.h * off)],
            false => [0.0; 2],
        };
        Carried {
            a: c * scaled * self.a + of_a,
            e: scaled * (self.a * (self.g + off) + self.h * e) + of_e,
            g: scaled * (c * self.g + 2.0 * self.h * off) - self.a * off * off * self.inverse,
        }
    }

    /// The solution of the pivot block.
    #[inline]
    fn solved(&self, [y1, y2]: [f64; 2]) -> [f64; 2] {
        [(self.g * y1 - self.h * y2) * self.inverse, -(self.h * y1 + self.a * y2) * self.inverse]
    }

    /// Solves the equations of the row without the next row, and returns the contribution to the next row.
    #[inline]
    fn forwards<const SPRINGS: bool>(&mut self, [y1, y2]: [f64; 2], between: Between) -> [f64; 2] {
        if SPRINGS && 0.0 < between.turning {
            self.step = [0.0, y2];
            return [between.turning * self.inverse * self.h * y2 - y1, -(self.inverse * y2)];
        }
        self.step = self.solved([y1, y2]);
        between.across::<SPRINGS>(self.step)
    }

    /// Corrects the solution of the row for the solution of the next row.
    #[inline]
    fn backwards<const SPRINGS: bool>(&mut self, next: [f64; 2], between: Between) -> [f64; 2] {
        if SPRINGS && 0.0 < between.turning {
            let [y, x] = next;
            self.step = [y, self.inverse * x - between.turning * self.inverse * (self.h * y + self.step[1])];
        } else {
            let [more_y, more_x] = self.solved(between.across::<SPRINGS>(next));
            self.step = [self.step[0] - more_y, self.step[1] - more_x];
        }
        self.step
    }
}

/// Factors the matrix from left to right, with `ratio` giving `Θ_i` of a row.
#[inline]
pub(crate) fn factor<R: AsMut<Block>>(rows: &mut [R], ratio: impl Fn(&R) -> f64) {
    let last = rows.len().saturating_sub(1);
    factor_towards(rows, last, ratio);
}

/// The same, with identical digits, for a chain in which no row has `σ`, `η` or a rotational spring.
#[inline]
pub(crate) fn factor_rigid<R: AsMut<Block>>(rows: &mut [R], ratio: impl Fn(&R) -> f64) {
    let last = rows.len().saturating_sub(1);
    factor_by::<false, _>(rows, last, ratio);
}

/// Factors the matrix from both ends towards a row. If a row is a hinge, with infinite `w`, elimination must not begin on a side that
/// is determined by statics alone and could move without the rest.
#[inline]
pub(crate) fn factor_towards<R: AsMut<Block>>(rows: &mut [R], meeting: usize, ratio: impl Fn(&R) -> f64) {
    factor_by::<true, _>(rows, meeting, ratio);
}

#[inline]
fn factor_by<const SPRINGS: bool, R: AsMut<Block>>(rows: &mut [R], meeting: usize, ratio: impl Fn(&R) -> f64) {
    let (left, right) = rows.split_at_mut(meeting);
    let mut from_left = Carried::default();
    for row in left {
        let theta = ratio(row);
        let row = row.as_mut();
        from_left = row.eliminate::<SPRINGS>(from_left, theta, row.beside());
    }
    let mut from_right = Carried::default();
    for i in (1..right.len()).rev() {
        let theta = ratio(&right[i]);
        let between = right[i - 1].as_mut().beside();
        from_right = right[i].as_mut().eliminate::<SPRINGS>(from_right, theta, between);
    }
    let Some(row) = right.first_mut() else { return };
    let theta = ratio(row);
    let (Carried { a, e, g }, right) = (from_left, from_right);
    row.as_mut().pivot(Carried { a: a + right.a, e, g: g + right.g }, theta, right.e);
}

/// The same for a beam under an axial force. There `σ = −n` is the stiffness of a string in each link, and `left`, which is
/// `c² − n ω`, is known without cancellation. With `a = n + b` no digit is lost under tension:
///
/// ```text
/// b' = Θ' + (b (c² + n g) + n e²)/d,   g' = w' + (c² g + ω (c h + c e + c² − n ω) − b ω²)/d
/// e' = (b c (g + ω) + e (c e + c² − n ω))/d
/// ```
///
/// From a free end on, only the string holds what has been eliminated, and a small axial force would lose its digits.
pub(crate) fn factor_under_tension<R: AsMut<Block>>(
    rows: &mut [R],
    meeting: usize,
    ratio: impl Fn(&R) -> f64,
    left: impl Fn(&R) -> f64,
) {
    let (before, behind) = rows.split_at_mut(meeting);
    let mut from_left = Carried::default();
    for row in before {
        let (theta, left) = (ratio(row), left(row));
        let row = row.as_mut();
        from_left = row.eliminate_under_tension(from_left, theta, row.beside(), left);
    }
    let mut from_right = Carried::default();
    for i in (1..behind.len()).rev() {
        let (theta, left) = (ratio(&behind[i]), left(&behind[i - 1]));
        let between = behind[i - 1].as_mut().beside();
        from_right = behind[i].as_mut().eliminate_under_tension(from_right, theta, between, left);
    }
    let Some(row) = behind.first_mut() else { return };
    let theta = ratio(row);
    let (Carried { a, e, g }, right) = (from_left, from_right);
    row.as_mut().pivot(Carried { a: a + right.a, e, g: g + right.g }, theta, right.e);
}

/// The row towards which the factorisation of a compressed beam loses the fewest digits. On the way from an end, the pivots are those
/// of a part that is hinged behind it. This part may buckle where the whole beam does not.
pub(crate) fn best_meeting<R: AsMut<Block>>(
    rows: &mut [R],
    ratio: impl Fn(&R) -> f64 + Copy,
    left: impl Fn(&R) -> f64 + Copy,
) -> usize {
    let last = rows.len() - 1;
    let mut left_over = |ends: [usize; 2]| -> Vec<f64> {
        let (mut all, mut carried, towards_left) = (vec![0.0; last + 1], Carried::default(), ends[1] < ends[0]);
        for k in 0..=last {
            let i = if towards_left { last - k } else { k };
            // Beyond the last row there is no link.
            let beside = if towards_left { i.saturating_sub(1) } else { i };
            let (theta, fall, between) = (ratio(&rows[i]), left(&rows[beside]), rows[beside].as_mut().beside());
            let mut block = *rows[i].as_mut();
            let next = block.eliminate_under_tension(carried, theta, between, fall);
            all[i] = block.left_of_pivot(carried, theta, between);
            carried = next;
        }
        all
    };
    let (from_left, from_right) = (left_over([0, last]), left_over([last, 0]));
    let mut worst_behind = vec![f64::INFINITY; last + 1];
    (0..last).rev().for_each(|i| worst_behind[i] = worst_behind[i + 1].min(from_right[i + 1]));
    let (mut best, mut worst_before) = ((f64::NEG_INFINITY, last), f64::INFINITY);
    for (i, own) in from_left.into_iter().enumerate() {
        let worst = worst_before.min(worst_behind[i]);
        if best.0 <= worst {
            best = (worst, i);
        }
        worst_before = worst_before.min(own);
    }
    best.1
}

/// Solves with these factors for `step`; `right` gives `r₁` and `r₂` of each row.
#[inline]
pub(crate) fn solve<R: AsMut<Block>>(rows: &mut [R], right: impl Fn(&R) -> [f64; 2]) {
    let last = rows.len().saturating_sub(1);
    solve_towards(rows, last, right);
}

/// The same with the factors of [`factor_rigid`].
#[inline]
pub(crate) fn solve_rigid<R: AsMut<Block>>(rows: &mut [R], right: impl Fn(&R) -> [f64; 2]) {
    let last = rows.len().saturating_sub(1);
    solve_by::<false, _>(rows, last, right);
}

/// The same with the factors of [`factor_towards`].
#[inline]
pub(crate) fn solve_towards<R: AsMut<Block>>(rows: &mut [R], meeting: usize, right: impl Fn(&R) -> [f64; 2]) {
    solve_by::<true, _>(rows, meeting, right);
}

#[inline]
fn solve_by<const SPRINGS: bool, R: AsMut<Block>>(rows: &mut [R], meeting: usize, right: impl Fn(&R) -> [f64; 2]) {
    let less = |[r1, r2]: [f64; 2], [c1, c2]: [f64; 2]| [r1 - c1, r2 - c2];
    let (before, behind) = rows.split_at_mut(meeting);
    let mut from_left = [0.0; 2];
    for row in before.iter_mut() {
        let rest = less(right(row), from_left);
        let row = row.as_mut();
        from_left = row.forwards::<SPRINGS>(rest, row.beside());
    }
    let mut from_right = [0.0; 2];
    for i in (1..behind.len()).rev() {
        let rest = less(right(&behind[i]), from_right);
        let between = behind[i - 1].as_mut().beside();
        from_right = behind[i].as_mut().forwards::<SPRINGS>(rest, between);
    }
    let Some(middle) = behind.first_mut() else { return };
    let rest = less(less(right(middle), from_left), from_right);
    let middle = middle.as_mut();
    middle.step = middle.solved(rest);
    let (mut next, step) = (middle.step, middle.step);
    for row in before.iter_mut().rev() {
        let row = row.as_mut();
        next = row.backwards::<SPRINGS>(next, row.beside());
    }
    let mut next = step;
    for i in 1..behind.len() {
        let between = behind[i - 1].as_mut().beside();
        next = behind[i].as_mut().backwards::<SPRINGS>(next, between);
    }
}
