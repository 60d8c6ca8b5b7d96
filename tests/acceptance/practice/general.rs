//! Random scenes of the general beam: nearly all are certified, and no certified number differs from that of finite elements.

use palkki_evidence::random::Feature::{Couple, Joint, Steps};
use palkki_evidence::random::{Feature, general, sample_of};

use super::Count;
use crate::support::assert_table;

/// Scenes with some features.
struct Group {
    name: &'static str,
    of: &'static [Feature],
    on_soil: bool,
    /// How many there are, and how many thousandths of them are certified at least.
    cases: u32,
    wanted: u32,
    /// Seeds of scenes that finite elements know to `COARSE` only.
    coarse: &'static [u32],
}

const GROUPS: [Group; 3] = [
    Group { name: "couples, steps", of: &[Couple, Steps], on_soil: false, cases: 2000, wanted: 995, coarse: &[] },
    Group { name: "joints", of: &[Couple, Steps, Joint], on_soil: false, cases: 1000, wanted: 970, coarse: &[] },
    Group { name: "couples on soil", of: &[Couple], on_soil: true, cases: 1000, wanted: 995, coarse: &[] },
];

/// The row of the first quarter of a group, and what is wrong with as many as are drawn.
fn tried(group: &Group) -> (String, Vec<String>) {
    let (mut count, mut pinned) = (Count::default(), String::new());
    for i in 0..sample_of(group.cases) {
        let text = general(u64::from(i), group.of, group.on_soil).text;
        count.add(i, &text, group.coarse.contains(&i));
        if count.cases == group.cases / 4 {
            pinned = count.row(group.name);
        }
    }
    if 1000 * count.certified < group.wanted * (count.cases - count.without) {
        count.wrong.push("too few are certified".to_owned());
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
