//! A beam that gives in shear is no beam of a scene file, but an elastic body: what becomes of the concentrated force at lift-off, and what
//! lifts the beam off inside contact.

use palkki::body::proof::prove;
use palkki::body::{Body, Kind, Verdict};
use palkki::qp::Profile;
use palkki::route::{Solver, Status};
use palkki::verdict::EXACT;
use palkki_evidence::authority::layer::Given;
use palkki_evidence::authority::number::{Fixed, Number};
use palkki_evidence::closed::{lifting_discontinuity, sheared};

/// The example of the paper.
const L: f64 = 10.0;
const EI: f64 = 500.0 / 384.0;
const DEPTH: f64 = 1.0;
const Q: f64 = 1.0;

/// Thirty digits that another program has found with fifty, by Newton's method for three unknowns: force of the support, lift-off point,
/// pressure beside it, resultant of the layer.
#[test]
fn the_layer_has_thirty_digits_of_another_program() {
    let digits = |value: &Fixed, expected: &str| {
        let places = expected.split_once('.').expect("a decimal number").1.len();
        assert_eq!(value.decimal(places), expected);
    };
    let rigid = Given::example(&Fixed::zero()).layer();
    digits(&rigid.reaction, "1.18217701125396976662712014986");
    digits(&rigid.lift_off, "2.36435402250793953325424029972");
    digits(&rigid.resultant, "1.18217701125396976662712014986");
    assert_eq!(rigid.pressure, None);
    for (parts, expected) in [
        (
            100,
            [
                "1.17909576176964914008479229474",
                "2.26242446311308786376743390697",
                "11.8332870134343872368264522226",
                "1.08332870134343872368264161223",
            ],
        ),
        (
            1000,
            [
                "1.18214537970065061199133338851",
                "2.35433305462692703125937795693",
                "118.218767492627641926804456842",
                "1.17218767492627641926804456842",
            ],
        ),
    ] {
        let layer = Given::example(&Fixed::fraction(1, parts)).layer();
        let pressure = layer.pressure.expect("it gives in shear");
        for (value, expected) in
            [&layer.reaction, &layer.lift_off, &pressure, &layer.resultant].into_iter().zip(expected)
        {
            digits(value, expected);
        }
    }
}

/// The closed form, with which the report draws and tabulates.
#[test]
fn the_closed_form_of_the_layer_has_its_digits() {
    /// Of `M` at lift-off, a difference of terms that are `l/s` times as large.
    const ROUNDINGS: f64 = 16.0;
    for parts in [10, 20, 50, 100, 200, 500, 1000, 10_000] {
        let width = L / f64::from(parts);
        let digits = ROUNDINGS * f64::EPSILON * f64::from(parts);
        let (form, layer) =
            (sheared(L, EI, DEPTH, Q, width), Given::example(&Fixed::fraction(1, i64::from(parts))).layer());
        for (what, found, expected) in [
            ("lift-off", form.lift_off, layer.lift_off),
            ("reaction", form.reaction, layer.reaction),
            ("pressure", form.pressure(form.lift_off), layer.pressure.expect("it gives in shear")),
            ("resultant", form.layer(), layer.resultant.clone()),
            ("all of the force", form.force_up_to(0.5 * L), Fixed::whole(5).minus(&Fixed::of(form.reaction))),
        ] {
            let expected = expected.to_double();
            assert!((found - expected).abs() <= digits * expected, "{what}, l/s = {parts}: {found} and {expected}");
        }
        // The resultant is what the pressure adds up to.
        const CELLS: u32 = 20_000;
        let cell = (0.5 * L - form.lift_off) / f64::from(CELLS);
        let middles = (0..CELLS).map(|i| form.lift_off + cell * (f64::from(i) + 0.5));
        let sum: f64 = middles.map(|x| (form.pressure(x) - Q) * cell).sum();
        // The midpoint rule is off by (cell/s)²/24.
        let off = (cell / width).powi(2) / 24.0 + digits;
        assert!((sum / form.layer() - 1.0).abs() < 2.0 * off, "l/s = {parts}: {sum} and {}", form.layer());
    }
}

/// `σ⁴ + 2 σ² s² − 4 σ s³ − 3 s⁴ + 4 s⁵/σ = a₀⁴` with `σ = a + s`, as long as the ends of the zone do not feel each other; `T = T₀ (1 − 3 s²/2a₀²)`
/// and `a = a₀ − s − s²/2a₀` but for terms of third order.
#[test]
fn the_laws_of_the_layer_are_right_to_their_order() {
    let rigid = Given::example(&Fixed::zero()).layer();
    let [a0, t0] = [rigid.lift_off.to_double(), rigid.reaction.to_double()];
    for parts in [100.0, 200.0, 400.0, 800.0, 1600.0] {
        let s: f64 = L / parts;
        let form = sheared(L, EI, DEPTH, Q, s);
        let sigma = form.lift_off + s;
        let quintic = sigma.powi(4) + 2.0 * (sigma * s).powi(2) - 4.0 * sigma * s.powi(3) - 3.0 * s.powi(4)
            + 4.0 * s.powi(5) / sigma;
        assert!((quintic / a0.powi(4) - 1.0).abs() < 1e-13, "{parts}: {quintic}");
        let share = s / a0;
        let [reaction, lift_off] = [
            form.reaction / t0 - (1.0 - 1.5 * share * share),
            form.lift_off / a0 - (1.0 - share - 0.5 * share * share),
        ];
        // A third-order term of coefficient 2 at most, and rounding.
        for off in [reaction, lift_off] {
            assert!(off.abs() < 2.0 * share.powi(3) + 1e-14, "{parts}: {off}");
        }
    }
}

/// A simple beam that gives in shear, of two bending stiffnesses that meet at mid-span, by virtual work on equal cells.
struct Shearing {
    intervals: usize,
    /// Before and behind mid-span.
    stiffness: [f64; 2],
    /// `GA`.
    shear: f64,
}

#[expect(clippy::cast_precision_loss, reason = "some hundreds of intervals")]
impl Shearing {
    fn place(&self, i: usize) -> f64 {
        L * i as f64 / self.intervals as f64
    }

    /// `M` of a unit force at a node, at a place.
    fn unit(&self, node: usize, x: f64) -> f64 {
        let at = self.place(node);
        (x * (L - at) / L).min(at * (L - x) / L)
    }

    /// `∫M m/EI` for a moment of at most the second degree in each cell and `m` of a unit force at a node, exact by Simpson's rule. The moment
    /// is given with the cell, since it may be discontinuous at a node.
    fn work(&self, node: usize, moment: impl Fn(usize, f64) -> f64) -> f64 {
        let cell = |k: usize| {
            let [from, to] = [k, k + 1].map(|i| self.place(i));
            let value = |x: f64| moment(k, x) * self.unit(node, x);
            let stiffness = self.stiffness[usize::from(self.intervals <= 2 * k)];
            (to - from) / 6.0 * (value(from) + 4.0 * value(0.5 * (from + to)) + value(to)) / stiffness
        };
        (0..self.intervals).map(cell).sum()
    }

    /// The contact forces and clearances of the nodes above a ground, under the uniform load and a couple at mid-span, proven.
    fn solved(&self, ground: impl Fn(f64) -> f64, couple: f64) -> [Vec<f64>; 2] {
        let n = self.intervals - 1;
        let flexibility = Profile::full(n, |i, j| {
            let (bent, m) = (self.work(i + 1, |_, x| self.unit(j + 1, x)), self.unit(j + 1, self.place(i + 1)));
            bent + m / self.shear
        });
        let free = |node: usize| {
            let x = self.place(node);
            let moment = |k: usize, x: f64| {
                let behind = if self.intervals <= 2 * k { couple } else { 0.0 };
                0.5 * Q * x * (L - x) - couple * x / L + behind
            };
            self.work(node, moment) + 0.5 * Q * x * (L - x) / self.shear
        };
        let gaps = (1..=n).map(|node| ground(self.place(node)) - free(node)).collect();
        let body = Body::new(Kind::Flexibility, flexibility, None, gaps, vec![0.0; n]).expect("a beam on two supports");
        let answer = body.run(Solver::ActiveSet, 0.0);
        let proof = prove(&body, answer.x.iter().map(|x| 0.0 < *x)).expect("well conditioned");
        let verdict = Verdict::new(Ok(proof.errors(&body, &answer)), EXACT, answer.run.reports_success);
        assert_eq!(verdict.status, Status::Certified, "{}", verdict.reason);
        body.clearance_and_force(&answer)
    }

    /// Whether all nodes from the first to the last one that is pressed are; and the force of the node `beside` mid-span.
    fn lies_down(&self, ground: impl Fn(f64) -> f64, couple: f64, beside: usize) -> (bool, f64) {
        let [_, force] = self.solved(ground, couple);
        let pressed: Vec<usize> = (0..force.len()).filter(|i| 0.0 < force[*i]).collect();
        let (first, last) = (pressed[0], pressed[pressed.len() - 1]);
        assert!(2 * first < self.intervals && self.intervals < 2 * last, "mid-span is inside the zone");
        (pressed.len() == last - first + 1, force[beside - 1])
    }
}

/// The nodal force at lift-off on a grid: of a beam that is rigid in shear it stays a large part of `T`, however fine the grid is; of one that is not it
/// is a pressure times `Δ`, and forces and lift-off are those of the layer.
#[test]
fn a_beam_that_gives_in_shear_has_no_concentrated_force() {
    let s = 0.05 * L;
    let form = sheared(L, EI, DEPTH, Q, s);
    for intervals in [50_u32, 100, 200] {
        let spacing = L / f64::from(intervals);
        let at = |shear: f64| {
            let beam = Shearing { intervals: intervals as usize, stiffness: [EI; 2], shear };
            let [_, force] = beam.solved(|_| DEPTH, 0.0);
            let largest = force.iter().copied().fold(0.0, f64::max);
            let first = force.iter().position(|force| 0.0 < *force).expect("it touches");
            (largest, 0.5 * (Q * L - force.iter().sum::<f64>()), beam.place(first + 1))
        };
        let (largest, reaction, first) = at(EI / (s * s));
        // Beside the first node the force may come from almost two cells.
        assert!(largest < 1.5 * form.pressure(form.lift_off) * spacing, "{intervals}: {largest}");
        assert!((first - form.lift_off).abs() < spacing, "{intervals}: {first}, not {}", form.lift_off);
        assert!((reaction - form.reaction).abs() < spacing * spacing, "{intervals}: {reaction}, not {}", form.reaction);
        let (largest, reaction, _) = at(1e12);
        assert!(0.4 * reaction < largest, "{intervals}: {largest} of {reaction}");
    }
}

/// A couple inside contact lifts the beam beyond `2 s² p̄`, and a change of EI beyond `s (s₁ + s₂) p̄` with `s` of the softer side of a crest and of
/// the stiffer side of a dish. On a grid the node beside mid-span is released at a `D` that approaches this law with the first order.
#[test]
fn a_discontinuity_inside_contact_lifts_a_beam_that_gives_in_shear_beyond_its_law() {
    /// Two and four cells are as long as `s`; what may be left after the first order is taken away.
    const GRIDS: [usize; 2] = [80, 160];
    const PART: f64 = 0.06;
    let s = 0.025 * L;
    let shear = EI / (s * s);
    let [soft, stiff] = [s, 2.0_f64.sqrt() * s];
    // A crest lifts the softer side, a dish the stiffer one; a positive couple the side before it.
    // The ground is deep enough for the ends of a dish to be below the supports.
    for (what, depth, stiffness, side, widths) in [
        ("couple", 1.0, [EI; 2], 1.0, [s, s]),
        ("couple", 1.0, [EI; 2], -1.0, [s, s]),
        ("crest", 1.0, [EI, 2.0 * EI], 1.0, [soft, stiff]),
        ("dish", 3.5, [EI, 2.0 * EI], -1.0, [stiff, soft]),
    ] {
        let released = GRIDS.map(|intervals| {
            let beam = Shearing { intervals, stiffness, shear };
            let beside = if side > 0.0 { intervals / 2 - 1 } else { intervals / 2 + 1 };
            // Whether the beam lies down under a discontinuity over its law, and the force beside it.
            let under = |over: f64| {
                let discontinuity = side * over * lifting_discontinuity(widths) * Q;
                if what == "couple" {
                    return beam.lies_down(|_| depth, discontinuity, beside);
                }
                let curvature = discontinuity / (stiffness[1] - stiffness[0]);
                beam.lies_down(|x| depth + 0.5 * curvature * (x - 0.5 * L).powi(2), 0.0, beside)
            };
            let ((lies, force), (lies_more, less)) = (under(0.25), under(0.5));
            assert!(lies && lies_more && less < force, "{what} {side}: {force}, {less}");
            // The force falls in proportion, but for what the ends of the zone add, which are at least three `s` away.
            let released = 0.25 + 0.25 * force / (force - less);
            for (over, lies) in [(0.95, true), (1.05, false)] {
                assert_eq!(under(over * released).0, lies, "{what} {side}, {intervals} intervals, {over}");
            }
            released
        });
        let [coarse, fine] = released;
        assert!(1.0 < fine && fine < coarse, "{what} {side}: {released:?}");
        assert!((2.0 * fine - coarse - 1.0).abs() < PART, "{what} {side}: {released:?}");
    }
}
