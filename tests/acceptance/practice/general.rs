//! Random scenes of the general beam: nearly all are certified, and no certified number differs from that of finite elements.

use palkki::route::Status;
use palkki::scene::{Foundation, Scene};
use palkki::{proof::prove, solve_exactly};
use palkki_evidence::elements::{Found, reference};
use palkki_evidence::random::Feature::{Couple, Hinge, Joint, SoilSteps, Spring, Steps, Stop, Tension, Turning};
use palkki_evidence::random::{Feature, general, sample_of};

use super::Count;
use crate::scenes;
use crate::support::assert_table;

/// Scenes with some features.
struct Group {
    name: &'static str,
    of: &'static [Feature],
    on_soil: bool,
    /// How many there are, and which of them are not certified.
    cases: u32,
    open: &'static [u32],
    /// Seeds of scenes that finite elements know to `COARSE` only.
    coarse: &'static [u32],
}

const GROUPS: [Group; 6] = [
    Group { name: "couples, steps", of: &[Couple, Steps], on_soil: false, cases: 800, open: &[], coarse: &[] },
    Group { name: "and joints", of: &[Couple, Steps, Joint], on_soil: false, cases: 600, open: &[], coarse: &[] },
    Group {
        name: "and hinges",
        of: &[Couple, Steps, Joint, Hinge],
        on_soil: false,
        cases: 600,
        open: &[55, 346, 396],
        coarse: &[],
    },
    Group { name: "springs, stops", of: &[Spring, Turning, Stop], on_soil: false, cases: 600, open: &[], coarse: &[] },
    Group { name: "tension", of: &[Tension], on_soil: false, cases: 400, open: &[292, 309, 322], coarse: &[] },
    Group {
        name: "steps of soil",
        of: &[Couple, Steps, Joint, SoilSteps],
        on_soil: true,
        cases: 600,
        open: &[],
        coarse: &[],
    },
];

/// The row of the first quarter of a group, and what is wrong with as many as are drawn.
fn tried(group: &Group) -> (String, Vec<String>) {
    let (mut count, mut pinned) = (Count::default(), String::new());
    for i in 0..sample_of(group.cases) {
        let text = general(u64::from(i), group.of, group.on_soil).text;
        let before = count.certified + count.without;
        count.add(i, &text, group.coarse.contains(&i));
        if before == count.certified + count.without && !group.open.contains(&i) {
            count.wrong.push(format!("{i} is not certified"));
        }
        if count.cases == group.cases / 4 {
            pinned = count.row(group.name);
        }
    }
    let row = count.row(group.name);
    (pinned, count.wrong.into_iter().map(|wrong| format!("{row}\n{wrong}")).collect())
}

#[test]
fn general_beams_are_certified_and_right() {
    let groups = std::thread::scope(|scope| {
        GROUPS.each_ref().map(|group| scope.spawn(|| tried(group))).map(|group| group.join().expect("no panic"))
    });
    let rows = groups.each_ref().map(|(row, _)| row.as_str()).join("\n");
    let wrong: Vec<String> = groups.into_iter().flat_map(|(_, wrong)| wrong).collect();
    let head = super::head();
    assert!(wrong.is_empty(), "{head}\n{rows}\n{wrong:#?}");
    assert_table!(
        "general",
        "What becomes of random general beams, by features; differences from finite elements as shares of the largest of a kind",
        format!("{head}\n{rows}\n")
    );
}

/// The text of a scene, with the points of a survey in its place: the reference reads no surveys.
fn with_points(text: &str, scene: &Scene) -> String {
    let Some(Foundation::Polyline { points }) = scene.foundation() else { return text.to_owned() };
    let points = points.iter().map(|[x, depth]| format!("[{x}, {depth}]")).collect::<Vec<_>>().join(", ");
    let line =
        |line: &str| if line.starts_with("survey") { format!("points = [{points}]\n") } else { format!("{line}\n") };
    text.lines().map(line).collect()
}

/// One to four of all that a beam without an axial force may have, on rigid ground and, every second scene, on elastic ground; free, held
/// and pushed: of those that have an answer [`WANTED`](super::WANTED) are certified, and none is wrong.
#[test]
fn nearly_all_general_beams_are_certified() {
    const CASES: u32 = 1500;
    const ALL: [Feature; 8] = [Couple, Steps, Joint, Hinge, Spring, Turning, Stop, SoilSteps];
    let (mut counts, mut lost) = ([Count::default(), Count::default()], Vec::new());
    for i in 0..sample_of(CASES) {
        let (seed, on_soil) = (u64::from(i / 2), i % 2 == 1);
        let text = general(seed, if on_soil { &ALL } else { &ALL[..7] }, on_soil).text;
        let count = &mut counts[usize::from(on_soil)];
        let before = count.certified + count.without;
        count.add(i, &text, false);
        if before == count.certified + count.without {
            lost.push(i);
        }
    }
    let rows = [counts[0].row("all, rigid"), counts[1].row("all, elastic")].join("\n");
    let told = format!("{}\n{rows}\n{lost:?}", super::head());
    let [certified, answers] = counts.iter().fold([0; 2], |[certified, answers], count| {
        [certified + count.certified, answers + count.cases - count.without]
    });
    assert!(counts.iter().all(|count| count.wrong.is_empty()), "{told}\n{:#?}", counts.map(|count| count.wrong));
    assert!(super::WANTED * answers <= 1000 * certified, "{certified} of {answers}\n{told}");
}

/// Scenes of the report: each is certified, agrees with finite elements, and has a proof.
#[test]
fn scenes_from_practice_agree_with_finite_elements() {
    for (name, scene) in scenes::in_folder("practice") {
        let text = with_points(&scenes::text(&name), &scene);
        let solution = solve_exactly(&scene).expect("an answer");
        assert_eq!(solution.verdict.status, Status::Certified, "{name}: {}", solution.verdict);
        let Found::Answer(found) = reference(&text) else { panic!("{name}: the elements go on") };
        assert_eq!(super::differ(&found, &super::numbers(&solution, &found), false), None, "{name}");
        assert!(
            found.estimate.iter().take(3).all(|estimate| *estimate <= super::SHARP),
            "{name}: {:?}",
            found.estimate
        );
        let proof =
            prove(&scene, solution.exact.as_ref().expect("functions")).unwrap_or_else(|why| panic!("{name}: {why}"));
        let [low, up] = crate::proof::bracket(&scene, &proof).unwrap_or_else(|why| panic!("{name}: {why}"));
        let near = |energy: &palkki_evidence::authority::RBig| (energy.to_f64().value() - solution.state.energy).abs();
        assert!(near(&low).max(near(&up)) <= 1e-12 * solution.state.energy.abs(), "{name}: {low} {up}");
    }
}
