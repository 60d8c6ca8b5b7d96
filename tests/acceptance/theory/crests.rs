//! Bodies whose loads are in balance exactly above a crest of the ground: the forces are certain, and the position is one of an
//! interval of slopes, from a calculation that knows no beam theory of ours.
//!
//! ```text
//! rests on the crest c alone:    max (g − v₀ − g_c)/(x − c) left of it  ≤  slope  ≤  min (g − v₀ − g_c)/(x − c) right of it
//! two forces F at c ∓ d:         EI v₀ = F t² (3d − t)/6 up to the distance t = d, F d² (3t − d)/6 beyond
//! ```

use palkki::route::Status;
use palkki::scene::Foundation;
use palkki::verdict::{Demand, Verdict};
use palkki_evidence::draft::{Draft, Units};
use palkki_evidence::random::Random;

use super::solved;

/// A body on its crest.
#[derive(Debug, Clone)]
struct Body {
    length: f64,
    stiffness: f64,
    points: Vec<[f64; 2]>,
    crest: usize,
    force: f64,
    /// Distance of two loads from the crest; of one above it zero.
    arm: f64,
}

impl Body {
    /// Places are multiples of a quarter: what is symmetric about the crest is so to the last bit.
    fn random(random: &mut Random) -> Self {
        let count = 4 + random.below(6);
        let quarters: Vec<usize> =
            (0..=count).map(|_| 1 + random.below(6)).scan(0, |x, step| Some(std::mem::replace(x, *x + step))).collect();
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        let place = |k: usize| 0.25 * k as f64;
        let points: Vec<[f64; 2]> = quarters.iter().map(|&k| [place(k), random.between(0.0, 3.0)]).collect();
        let length = points[count][0];
        // The highest inner point, or now and then any.
        let inner = 1..count;
        let highest = inner.clone().min_by(|&i, &j| points[i][1].total_cmp(&points[j][1])).unwrap_or(1);
        let crest = if random.once_in(3) { 1 + random.below(count - 1) } else { highest };
        let room = points[crest][0].min(length - points[crest][0]);
        let arm = if random.once_in(2) { 0.0 } else { 0.5 * room };
        let stiffness = libm::exp2(random.between(0.0, 14.0));
        Self { length, stiffness, points, crest, force: random.between(0.1, 3.0), arm }
    }

    /// Merely lying there.
    fn draft(&self) -> Draft {
        let [at, _] = self.points[self.crest];
        let loads = [(at - self.arm, self.force), (at + self.arm, self.force)];
        let loads = if self.arm == 0.0 { vec![(at, self.force)] } else { loads.to_vec() };
        let ground = Some(Foundation::Polyline { points: self.points.clone() });
        let (length, stiffness, supports) = (self.length, self.stiffness, Some(Vec::new()));
        Draft { length, stiffness, ground, supports, ..Draft::default() }.with_points(&loads)
    }

    /// The deflection at slope zero below the crest, at a distance from it.
    fn sag(&self, t: f64) -> f64 {
        let d = self.arm;
        let bent = if t < d { t * t * (3.0 * d - t) } else { d * d * (3.0 * t - d) };
        self.force * bent / (6.0 * self.stiffness)
    }

    /// The slopes that leave the beam clear of the ground, from many places.
    fn slopes(&self) -> [f64; 2] {
        /// Of each segment.
        const PARTS: i32 = 4000;
        let [c, depth] = self.points[self.crest];
        let mut slopes = [f64::NEG_INFINITY, f64::INFINITY];
        for w in self.points.windows(2) {
            for k in 0..=PARTS {
                let share = f64::from(k) / f64::from(PARTS);
                let x = w[0][0] + share * (w[1][0] - w[0][0]);
                let ground = w[0][1] + share * (w[1][1] - w[0][1]);
                let slope = (ground - depth - self.sag((x - c).abs())) / (x - c);
                if (x - c).abs() <= 1e-12 * c {
                    // The crest itself.
                } else if x < c {
                    slopes[0] = slopes[0].max(slope);
                } else {
                    slopes[1] = slopes[1].min(slope);
                }
            }
        }
        slopes
    }
}

#[test]
fn a_body_in_balance_above_a_crest_may_turn_about_it() {
    /// Slopes between which samples miss the least value, as a share.
    const SAMPLED: f64 = 1e-6;
    let mut random = Random::new(725);
    let (mut turned, mut held) = (0, 0);
    for i in 0..400 {
        let body = Body::random(&mut random);
        let [crest, depth] = body.points[body.crest];
        let slopes = body.slopes();
        // In units that are no powers of two.
        let [length, unit, force] = [0; 3].map(|_| random.between(0.1, 9.0));
        let units = Units { length, depth: unit, force };
        // As it is, from the other side, in units: the draft, the slopes, the place and depth of the crest, the unit of force.
        for (draft, expected, [c, depth], force) in [
            (body.draft(), slopes, [crest, depth], 1.0),
            (body.draft().mirrored(), [-slopes[1], -slopes[0]], [body.length - crest, depth], 1.0),
            (
                body.draft().in_units(units),
                slopes.map(|slope| slope * unit / length),
                [crest * length, depth * unit],
                force,
            ),
        ] {
            let size = expected[0].abs().max(expected[1].abs());
            let what = format!("{i}: {expected:?}, {draft:?}");
            if (expected[1] - expected[0]).abs() <= 1e-3 * size {
                continue;
            }
            let scene = draft.scene().expect("a scene");
            let exact = solved(&scene);
            let standing = exact.state.standing.expect("not held by supports");
            if expected[1] < expected[0] {
                held += 1;
                assert!(standing.motion.is_none(), "{what}: {:?}", standing.motion);
                continue;
            }
            turned += 1;
            let motion = standing.motion.unwrap_or_else(|| panic!("no motion, {what}: {:?}", exact.state.contacts));
            assert!((motion.about - c).abs() <= 1e-14 * c, "{what}: {motion:?}");
            for (found, expected) in motion.slope.into_iter().zip(expected) {
                let off = (found.expect("ground on both sides") - expected).abs();
                assert!(off <= SAMPLED * size, "{what}: {motion:?}");
            }
            let [contact] = exact.state.contacts[..] else { panic!("{what}: {:?}", exact.state.contacts) };
            let all = force * if body.arm == 0.0 { body.force } else { 2.0 * body.force };
            assert!(
                (contact.force - all).abs() <= 1e-13 * all && contact.from.total_cmp(&contact.to).is_eq(),
                "{what}"
            );
            assert!((exact.deflection(c) - depth).abs() <= 1e-13 * depth, "{what}");
            let verdict = Verdict::of_exact(&scene, &exact, &Demand::default());
            assert_eq!(verdict.status, Status::Certified, "{what}: {verdict}");
        }
    }
    assert!(500 < turned && 100 < held, "{turned} {held}");
}

/// Two posts and a load above one of them; three sleepers that leave the beam above the middle one a single slope, level or not; a
/// crest of the beam's own.
#[test]
fn what_carries_a_body_may_be_a_post_or_its_own_shape() {
    let body = |points: &[[f64; 2]], crest: usize| Body {
        length: 10.0,
        stiffness: 20.0,
        points: points.to_vec(),
        crest,
        force: 1.0,
        arm: 0.0,
    };
    let motion =
        |draft: Draft| solved(&draft.scene().expect("a scene")).state.standing.and_then(|standing| standing.motion);
    let crests = body(&[[0.0, 2.0], [2.0, 0.4], [4.5, 2.0], [7.0, 0.1], [10.0, 2.0]], 3).draft();
    for (draft, expected) in [(crests.mirrored(), [-1.9 / 3.0, 0.06]), (crests, [-0.06, 1.9 / 3.0])] {
        let [from, to] = motion(draft).expect("it may turn").slope.map(|slope| slope.expect("ground on both sides"));
        assert!((from - expected[0]).abs() <= 1e-15 && (to - expected[1]).abs() <= 1e-15, "{from} {to}");
    }
    let posts =
        body(&[[0.0, 9.0], [2.0, 9.0], [2.0, 0.0], [3.0, 9.0], [6.0, 9.0], [7.0, 0.0], [8.0, 9.0], [10.0, 9.0]], 5);
    let [from, to] =
        motion(posts.draft()).expect("it may turn").slope.map(|slope| slope.expect("ground on both sides"));
    assert!(from.abs() <= 1e-15 && (to - 3.0).abs() <= 1e-14, "{from} {to}");
    for incline in [0.0, 0.1, 0.3] {
        let mut sleepers = [[0.0, 4.0], [2.0, 0.0], [4.0, 4.0], [5.0, 0.0], [6.0, 4.0], [9.0, 0.0], [10.0, 4.0]];
        sleepers.iter_mut().for_each(|[x, depth]| *depth += incline * *x);
        assert_eq!(motion(body(&sleepers, 3).draft()), None, "one slope alone, {incline}");
    }
    // Bent down at its ends by its shape, above level ground: `w0 = |x − 4| / 10`, highest above the ground there in the middle.
    let shape = Foundation::Polyline { points: vec![[0.0, -0.4], [4.0, 0.0], [10.0, -0.6]] };
    let rocker = Draft {
        length: 10.0,
        stiffness: 20.0,
        ground: Some(Foundation::Flat { depth: 1.0 }),
        supports: Some(Vec::new()),
        shape: Some(shape),
        ..Draft::default()
    };
    let rocker = solved(&rocker.with_points(&[(4.0, 1.0)]).scene().expect("a scene"));
    let motion = rocker.state.standing.and_then(|standing| standing.motion).expect("it may rock");
    assert_eq!(motion.slope.map(|slope| slope.map(|slope| (slope * 1e12).round() / 1e12)), [Some(-0.1), Some(0.1)]);
}
