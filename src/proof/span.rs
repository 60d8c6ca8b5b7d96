//! The beam between two positions in rational arithmetic: a part without contact, with its loads, changes of stiffness, joints and
//! springs.
//!
//! ```text
//! v' = ψ      ψ' = −M/EI      M' = V      (V + N v')' = −q
//! load, couple       V falls by P, M grows by C           spring      V grows by k_s (v − d), M falls by k_t (ψ − φ)
//! joint              ψ falls by M/k_j                     hinge       ψ by any turn, and M = 0
//! ```

use dashu_ratio::RBig;

use super::given::Given;
use super::polynomial::{Polynomial, at, between, derivative, exactly, jet, trimmed};

/// `v` on the parts of a span, each about its left end.
pub(super) type Curve = Vec<([f64; 2], Polynomial)>;

/// `l` of a part.
pub(super) fn width([from, to]: [f64; 2]) -> RBig {
    exactly(to) - exactly(from)
}

/// `v, ψ, M, V`.
type State = [RBig; 4];

/// The computed beam between two positions.
#[derive(Debug)]
pub(super) struct Span {
    pub(super) curve: Curve,
    /// `M` at both ends.
    pub(super) moments: [RBig; 2],
}

/// The beam between two positions, of which one or both may be free ends.
#[derive(Debug)]
pub(super) struct Hanging<'a> {
    given: &'a Given,
    parts: Vec<[f64; 2]>,
    /// The parts that end at a hinge.
    hinges: Vec<usize>,
    is_free: [bool; 2],
}

impl<'a> Hanging<'a> {
    pub(super) fn new(given: &'a Given, ends: [f64; 2], is_free: [bool; 2]) -> Self {
        let parts = given.parts(ends, true);
        let is_hinge = |i: &usize| *i + 1 < parts.len() && given.joint(parts[*i][1]).is_some_and(Option::is_none);
        let hinges = (0..parts.len()).filter(is_hinge).collect();
        Self { given, parts, hinges, is_free }
    }

    /// Coefficients of `v` on a part, from the state at its left end.
    fn series(&self, part: [f64; 2], [v, slope, moment, shear]: State, is_loaded: bool) -> Polynomial {
        let (given, stiffness) = (self.given, self.given.bending(part));
        let load = if is_loaded { given.load(part) } else { Vec::new() };
        let mut p = vec![v, slope, -moment / (stiffness * RBig::from(2)), -shear / (stiffness * RBig::from(6))];
        let terms = if given.tension.is_zero() { load.len() } else { Given::TERMS };
        for j in 0..terms {
            let pull = &given.tension * RBig::from((j + 1) * (j + 2)) * &p[j + 2];
            let acts = load.get(j).cloned().unwrap_or(RBig::ZERO) + pull;
            p.push(acts / (stiffness * RBig::from((j + 1) * (j + 2) * (j + 3) * (j + 4))));
        }
        p
    }

    /// The state beyond a position; `turn` is the rotation of a hinge.
    fn across(&self, x: f64, [v, mut slope, mut moment, mut shear]: State, turn: &RBig, is_loaded: bool) -> State {
        let given = self.given;
        let off = |value: &RBig, zero: &RBig| if is_loaded { value - zero } else { value.clone() };
        if let Some(stiffness) = given.joint(x) {
            let turn = stiffness.as_ref().map_or_else(|| turn.clone(), |k| -&moment / k);
            shear -= &given.tension * &turn;
            slope += turn;
        }
        if let Some(spring) = given.elastic.iter().find(|spring| spring.x.total_cmp(&x).is_eq()) {
            shear += &spring.stiffness * off(&v, &spring.level);
            moment -= spring.turning.as_ref().map_or(RBig::ZERO, |[k, rest]| k * off(&slope, rest));
        }
        if is_loaded {
            let [force, couple] = given.acting(x);
            (shear, moment) = (shear - force, moment + couple);
        }
        [v, slope, moment, shear]
    }

    /// The states at both ends of each part, from the state at the left end of the first part.
    fn march(&self, start: State, turns: &[RBig], is_loaded: bool) -> Vec<[State; 2]> {
        let mut states = Vec::new();
        let mut state = start;
        for (i, part) in self.parts.iter().enumerate() {
            let (p, l) = (self.series(*part, state.clone(), is_loaded), width(*part));
            let second = derivative(&derivative(&p));
            let ([v, slope], [bend, third]) = (jet(&p, &l), jet(&second, &l));
            let stiffness = self.given.bending(*part);
            let mut end = [v, slope, -stiffness * bend, -stiffness * third];
            if i + 1 < self.parts.len() {
                end = end.map(|value| trimmed(&value));
            }
            let hinge = self.hinges.iter().position(|hinge| *hinge == i);
            let turn = hinge.map_or(RBig::ZERO, |hinge| turns[hinge].clone());
            let next = self.across(part[1], end.clone(), &turn, is_loaded);
            states.push([state, end]);
            state = next;
        }
        states
    }

    /// The quantities that must be zero: the errors at the right end, and the moments in hinges.
    fn misfit(&self, states: &[[State; 2]], end: &[RBig; 2], is_loaded: bool) -> Vec<RBig> {
        let last = &states[states.len() - 1][1];
        let mut misfit: Vec<RBig> = self.hinges.iter().map(|hinge| states[*hinge][1][2].clone()).collect();
        if self.is_free[1] {
            let to = self.parts[self.parts.len() - 1][1];
            let [_, slope, moment, shear] = self.across(to, last.clone(), &RBig::ZERO, is_loaded);
            misfit.extend([moment, shear + &self.given.tension * slope]);
        } else {
            misfit.extend([&last[0] - &end[0], &last[1] - &end[1]]);
        }
        misfit
    }

    /// The state at the left end, with the unknowns there: `M` and `V`, or `v` and `ψ` of a free end.
    fn start(&self, [v, slope]: &[RBig; 2], [one, two]: [&RBig; 2], is_loaded: bool) -> State {
        if self.is_free[0] {
            let from = self.parts[0][0];
            let tip = [one.clone(), two.clone(), RBig::ZERO, -&self.given.tension * two];
            return self.across(from, tip, &RBig::ZERO, is_loaded);
        }
        [v.clone(), slope.clone(), one.clone(), two.clone()]
    }

    /// The states for given `v` and `ψ` at both ends, which are ignored at a free end. [`None`] if the beam can move freely.
    fn states(&self, ends: &[[RBig; 2]; 2], is_loaded: bool) -> Option<Vec<[State; 2]>> {
        let (zero, count) = (RBig::ZERO, 2 + self.hinges.len());
        let none = [RBig::ZERO, RBig::ZERO];
        let marched = |unknowns: &[RBig], ends: &[RBig; 2], is_loaded: bool| {
            self.march(self.start(ends, [&unknowns[0], &unknowns[1]], is_loaded), &unknowns[2..], is_loaded)
        };
        let nothing = vec![zero; count];
        let base = self.misfit(&marched(&nothing, &ends[0], is_loaded), &ends[1], is_loaded);
        let mut rows: Vec<Vec<RBig>> = base.into_iter().map(|value| vec![-value]).collect();
        for k in 0..count {
            let mut unit = nothing.clone();
            unit[k] = RBig::ONE;
            let column = self.misfit(&marched(&unit, &none, false), &none, false);
            rows.iter_mut().zip(column).for_each(|(row, value)| row.insert(k, value));
        }
        let unknowns: Vec<RBig> = solved(rows)?.iter().map(trimmed).collect();
        Some(marched(&unknowns, &ends[0], is_loaded))
    }

    /// The beam for given `v` and `ψ` at both ends; [`None`] if it can move freely.
    pub(super) fn span(&self, ends: &[[RBig; 2]; 2]) -> Option<Span> {
        let states = self.states(ends, true)?;
        let last = states.len() - 1;
        let mut curve = Curve::new();
        for (i, (part, [start, end])) in self.parts.iter().zip(&states).enumerate() {
            let tail = self.series(*part, start.clone(), true).split_off(4);
            let tail: Polynomial = tail.iter().map(|c| if tail.len() <= 2 { c.clone() } else { trimmed(c) }).collect();
            let of = |state: &State| [state[0].clone(), state[1].clone()];
            let mut given = [of(start), of(end)];
            if i == last && !self.is_free[1] {
                given[1].clone_from(&ends[1]);
            }
            curve.push((*part, between([&given[0], &given[1]], &tail, &width(*part))));
        }
        let [[_, _, start, _], [_, _, end, _]] = [&states[0][0], &states[last][1]].map(Clone::clone);
        Some(Span { curve, moments: [start, end] })
    }

    /// The increase of the end moments with the end slopes: `∂M_a/∂ψ_a, ∂M_a/∂ψ_b, −∂M_b/∂ψ_b`.
    pub(super) fn stiffness(&self) -> Option<[f64; 3]> {
        if let ([part], [false, false], true) = (&self.parts[..], self.is_free, self.given.tension.is_zero()) {
            let unit = self.given.bending(*part).to_f64().value() / width(*part).to_f64().value();
            return Some([4.0 * unit, 2.0 * unit, 4.0 * unit]);
        }
        let unit = |turned: usize| {
            let mut ends = [(); 2].map(|()| [RBig::ZERO, RBig::ZERO]);
            ends[turned][1] = RBig::ONE;
            let states = self.states(&ends, false)?;
            let moments = [&states[0][0][2], &states[states.len() - 1][1][2]];
            Some(moments.map(|moment| moment.to_f64().value()))
        };
        let [left, right] = [0, 1].map(|end| if self.is_free[end] { Some([0.0, 0.0]) } else { unit(end) });
        let ([a, _], [b, c]) = (left?, right?);
        Some([a, b, -c])
    }
}

/// `x` of `A x = b`, by elimination with the largest pivots; `b` is the last column. [`None`] without a unique solution.
pub(super) fn solved(mut rows: Vec<Vec<RBig>>) -> Option<Vec<RBig>> {
    let count = rows.len();
    for k in 0..count {
        let size = |i: &usize| super::polynomial::magnitude(&rows[*i][k]);
        let pivot = (k..count).max_by_key(size).filter(|i| !rows[*i][k].is_zero())?;
        rows.swap(k, pivot);
        let own = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1).filter(|row| !row[k].is_zero()) {
            let share = &row[k] / &own[k];
            row.iter_mut().zip(&own).skip(k).for_each(|(value, above)| *value -= &share * above);
        }
    }
    for k in (0..count).rev() {
        let known = (k + 1..count).fold(rows[k][count].clone(), |rest, j| rest - &rows[k][j] * &rows[j][count]);
        rows[k][count] = known / &rows[k][k];
    }
    Some(rows.into_iter().map(|mut row| row.swap_remove(count)).collect())
}

/// `v` and `v'` at a position on a curve, on its left side.
pub(super) fn on_curve(curve: &Curve, x: f64) -> [RBig; 2] {
    let i = curve.iter().position(|(part, _)| x <= part[1]).unwrap_or(curve.len() - 1);
    let (part, v) = &curve[i];
    let s = width([part[0], x]);
    [at(v, &s), at(&derivative(v), &s)]
}
