//! The report in the tree is fresh, and the machine notices when it is not.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use pulldown_cmark::{Event, Tag, TagEnd};

use super::*;
use crate::table::Table;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn the_report_is_fresh() {
    if let Err(error) = check(&root()) {
        panic!("{error}");
    }
}

#[test]
fn templates_and_documents_are_the_same_set() {
    let listed = files::list(&root(), "report/templates").expect("the directory can be read");
    let stems = listed.iter().filter_map(|path| path.strip_prefix("report/templates/")?.strip_suffix(".md"));
    assert_eq!(
        stems.collect::<BTreeSet<_>>(),
        DOCUMENTS.into_iter().chain(PARTS).chain([words::NAME]).collect(),
        "templates (left), DOCUMENTS and PARTS (right)"
    );
}

fn text(document: &str) -> String {
    fs::read_to_string(root().join("report").join(document)).expect("the document can be read")
}

#[test]
fn the_report_can_be_read_in_ten_minutes() {
    let text = text("README.md");
    // Without code and formulas.
    let prose: String = text.split("```").step_by(2).collect();
    let words = prose.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count();
    let figures = html::events(&text).filter(|event| matches!(event, Event::Start(Tag::Image { .. }))).count();
    let rows = html::events(&text).filter(|event| *event == Event::Start(Tag::TableRow)).count();
    assert!(
        (2000..=2400).contains(&words) && figures <= 13 && rows <= 110,
        "{words} words, {figures} figures, {rows} rows of tables"
    );
}

#[test]
fn every_column_of_a_table_has_a_name() {
    let (begins, ends) = (Event::Start(Tag::TableCell), Event::End(TagEnd::TableCell));
    for document in DOCUMENTS.map(path_of) {
        let text = text(&document);
        let mut in_head = false;
        for pair in html::events(&text).collect::<Vec<_>>().windows(2) {
            in_head = (in_head || pair[0] == Event::Start(Tag::TableHead)) && pair[0] != Event::End(TagEnd::TableHead);
            assert!(!in_head || pair[0] != begins || pair[1] != ends, "{document} has a column without a name");
        }
    }
}

/// What a comparison with `rendered` says, a line each.
fn stale(root: &Path, rendered: &Rendered) -> Vec<String> {
    let stale = files::compare(root, rendered).expect("the files can be read");
    stale.iter().map(|stale| stale.lines().next().unwrap_or_default().to_owned()).collect()
}

fn rendered(files: &[(&str, &str)]) -> Rendered {
    files.iter().map(|&(path, text)| (path.to_owned(), text.to_owned())).collect()
}

#[test]
fn stale_missing_and_left_over_files_are_named_and_repaired() {
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    let wanted =
        rendered(&[("README.md", "T = 1.18\n"), ("data/a.csv", "x\n1.0\n"), ("figures/a.svg", "<svg x=\"5\"/>")]);
    files::replace(&scratch.path().join("report/README.md"), "T = 1.14\n").expect("it can be written");
    files::replace(&scratch.path().join("report/figures/a.svg"), "<svg x=\"5\"/>").expect("it can be written");
    files::replace(&scratch.path().join("report/figures/old.svg"), "<svg/>").expect("it can be written");
    files::replace(&scratch.path().join("report/by-hand.md"), "not ours").expect("it can be written");
    assert_eq!(
        stale(scratch.path(), &wanted),
        [
            "stale:     report/README.md, line 1: `1.14` became `1.18`",
            "missing:   report/data/a.csv",
            "left over: report/figures/old.svg",
        ],
        "one of each kind"
    );

    assert_eq!(files::write(scratch.path(), &wanted).expect("it can be written"), 3, "three changes");
    assert_eq!(stale(scratch.path(), &wanted), [""; 0], "all fresh");
    assert_eq!(files::write(scratch.path(), &wanted).expect("it can be written"), 0, "nothing to do");
    let left = files::list(scratch.path(), "report").expect("it can be listed");
    let expected = ["README.md", "by-hand.md", "data/a.csv", "figures/a.svg"].map(|path| format!("report/{path}"));
    assert_eq!(left, expected, "no temporary files, and nothing removed that is not ours");
}

#[test]
fn another_processor_may_round_differently() {
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    files::replace(&scratch.path().join("report/README.md"), "T = 1.18, n = 29\n").expect("it can be written");
    files::replace(&scratch.path().join("report/figures/a.svg"), "<svg x=\"5\"/>").expect("it can be written");
    let drawn = |readme, svg| stale(scratch.path(), &rendered(&[("README.md", readme), ("figures/a.svg", svg)])).len();
    assert_eq!(drawn("T = 1.19, n = 29\n", "<svg x=\"6\"/>"), 0, "one unit and one pixel");
    assert_eq!(drawn("T = 1.20, n = 29\n", "<svg x=\"7\"/>"), 2, "two units and two pixels");
    assert_eq!(drawn("T = 1.18, n = 30\n", "<svg x=\"5\"/>"), 1, "another integer");
}

#[test]
fn a_template_that_no_list_names_is_refused() {
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    files::replace(&scratch.path().join("report/templates/stray.md"), "# Stray\n").expect("it can be written");
    let error = render(scratch.path()).expect_err("the template is in no list").to_string();
    assert!(error.starts_with("report/templates/stray.md is no template"), "{error}");
}

#[test]
fn a_figure_comes_with_its_data() {
    let evidence = Evidence::new(()).figure("a", "<svg/>".to_owned(), Table::new(["x"])).expect("a table");
    assert_eq!(evidence.files.keys().collect::<Vec<_>>(), ["data/a.csv", "figures/a.svg"], "both files");
}

/// Each claim has its sentence as it is printed. Where the surviving text of the paper is at hand, as the file that `PALKKI_PAPER`
/// names, each of these sentences is in it.
#[test]
fn every_claim_has_its_sentence_in_the_paper() {
    let claims = files::text(&root(), "report/templates/claims.md").expect("the template can be read");
    let sections: Vec<&str> = claims.split("\n## ").filter(|section| section.contains(".verdict")).collect();
    assert!(12 <= sections.len(), "{} claims", sections.len());
    let paper = std::env::var_os("PALKKI_PAPER").map(|path| fs::read_to_string(path).expect("the paper can be read"));
    let plain = |text: &str| text.replace('$', "");
    for section in sections {
        let title = section.lines().next().unwrap_or_default();
        let printed = section.lines().find_map(|line| line.strip_prefix("> *")?.strip_suffix('*'));
        let printed = printed.unwrap_or_else(|| panic!("{title} has no sentence of the paper"));
        // Between sentences of different pages stands `…`.
        for sentence in printed.split(" … ").flat_map(|part| part.split(". ")) {
            let sentence = sentence.trim_end_matches('.');
            assert!(paper.as_ref().is_none_or(|paper| plain(paper).contains(&plain(sentence))), "{title}: {sentence}");
        }
    }
}
