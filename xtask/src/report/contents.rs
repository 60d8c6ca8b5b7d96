//! One document of all chapters, with a table of contents.

use std::collections::BTreeSet;

use super::error::Error;

/// Puts the chapters together: the first one, the contents, the others.
pub(super) fn assemble(first_line: &str, chapters: &[String]) -> Result<String, Error> {
    let mut contents = Vec::new();
    for (index, chapter) in chapters.iter().enumerate() {
        let expected = if index == 0 { "# " } else { "## " };
        let line = chapter.lines().next().unwrap_or_default();
        let Some(heading) = line.strip_prefix(expected) else {
            return Err(Error::NoHeading { chapter: index, expected, line: line.to_owned() });
        };
        if index != 0 {
            contents.push(format!("[{heading}](#{})", anchor(heading)));
        }
    }
    let mut parts = vec![first_line.to_owned()];
    for (index, chapter) in chapters.iter().enumerate() {
        parts.push(format!("{chapter}\n"));
        if index == 0 {
            parts.push(format!("Contents: {}\n", contents.join(" ·\n")));
        }
    }
    let document = parts.join("\n");
    anchors(&document)?;
    Ok(document)
}

/// The anchors of all headings of a document; two of the same name are an error.
pub(super) fn anchors(document: &str) -> Result<BTreeSet<String>, Error> {
    let mut found = BTreeSet::new();
    let mut fenced = false;
    for line in document.lines() {
        fenced ^= line.trim_start().starts_with("```");
        let heading = line.trim_start_matches('#');
        if !fenced && line.starts_with('#') && heading.starts_with(' ') && !found.insert(anchor(heading.trim())) {
            return Err(Error::TwoHeadings { heading: heading.trim().to_owned() });
        }
    }
    Ok(found)
}

/// The anchor that code hosts make of a heading: small letters, blanks as hyphens, signs dropped.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_contents_follow_the_first_chapter() {
        let chapters =
            ["# The paper".to_owned(), "## Figure 4: pressure\n\ntext".to_owned(), "## `K` and C".to_owned()];
        assert_eq!(
            assemble("<!-- x -->\n", &chapters).expect("every chapter has a heading"),
            "<!-- x -->\n\n# The paper\n\nContents: [Figure 4: pressure](#figure-4-pressure) ·\n[`K` and C](#k-and-c)\n\n\
             ## Figure 4: pressure\n\ntext\n\n## `K` and C\n",
            "one document"
        );
    }

    #[test]
    fn a_chapter_without_its_heading_is_refused() {
        assert!(assemble("", &["## a".to_owned()]).is_err(), "the first has the title");
        assert!(assemble("", &["# a".to_owned(), "text".to_owned()]).is_err(), "the second has no heading");
        assert!(assemble("", &["# a".to_owned(), "## A".to_owned()]).is_err(), "two anchors of one name");
    }

    #[test]
    fn code_blocks_have_no_headings() {
        let found = anchors("# a\n```\n# b\n```\n### c d\n#no").expect("all differ");
        assert_eq!(found, BTreeSet::from(["a".to_owned(), "c-d".to_owned()]), "two headings");
    }
}
