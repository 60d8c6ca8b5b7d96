//! Every file that is made is shown, every link leads somewhere, every drawing says what it shows.

use std::path::Path;

use super::error::Error;
use super::{Rendered, contents};

/// Checks the links of the report against the files made with it and the files of the repository.
pub(super) fn check(root: &Path, readme: &str, rendered: &Rendered) -> Result<(), Error> {
    let anchors = contents::anchors(readme)?;
    let targets = targets(readme);
    for &target in &targets {
        let alive = match target.split_once('#') {
            _ if target.contains("://") => true,
            Some(("", anchor)) => anchors.contains(anchor),
            _ if target.starts_with("figures/") || target.starts_with("data/") => rendered.contains_key(target),
            Some((file, _)) => root.join("report").join(file).exists(),
            None => root.join("report").join(target).exists(),
        };
        if !alive {
            return Err(Error::DeadLink { target: target.to_owned() });
        }
    }
    for (path, text) in rendered {
        if !targets.contains(&path.as_str()) {
            return Err(Error::NotShown { path: path.clone() });
        }
        for element in ["title", "desc"] {
            if path.ends_with(".svg") && !text.contains(&format!("<{element}")) {
                return Err(Error::NotDescribed { path: path.clone(), element });
            }
        }
    }
    Ok(())
}

/// The targets of `[text](target)` and `![text](target)`, and of `src="target"`.
fn targets(markdown: &str) -> Vec<&str> {
    let of = |opening: &str, closing: char| {
        let ends = markdown.split(opening).skip(1).filter_map(move |rest| rest.split_once(closing));
        ends.map(|(target, _)| target).collect::<Vec<_>>()
    };
    [of("](", ')'), of("src=\"", '"')].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(readme: &str, files: &[(&str, &str)]) -> Result<(), String> {
        let rendered = files.iter().map(|&(path, text)| (path.to_owned(), text.to_owned())).collect();
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        check(&root, readme, &rendered).map_err(|error| error.to_string())
    }

    #[test]
    fn links_that_lead_somewhere_pass() {
        let readme =
            "# A b\n[a](#a-b) ![f](figures/f.svg) [d](data/f.csv) [s](../src/lib.rs#L3) [w](https://example.org/x)";
        let files = [("figures/f.svg", "<svg><title>t</title><desc>d</desc></svg>"), ("data/f.csv", "x\n1.0\n")];
        assert_eq!(checked(readme, &files), Ok(()));
    }

    #[test]
    fn dead_links_and_hidden_files_are_found() {
        let dead = |target: &str| Err(format!("the report links to `{target}`, which does not exist"));
        assert_eq!(checked("# A\n[b](#b)", &[]), dead("#b"));
        assert_eq!(checked("![f](figures/f.svg)", &[]), dead("figures/f.svg"));
        assert_eq!(checked("[s](../src/no_such_file.rs)", &[]), dead("../src/no_such_file.rs"));
        assert_eq!(
            checked("# A", &[("data/f.csv", "")]),
            Err("data/f.csv is made, but no chapter shows or links it".to_owned())
        );
        let mute = checked("![f](figures/f.svg)", &[("figures/f.svg", "<svg><title>t</title></svg>")]);
        assert!(mute.is_err_and(|message| message.contains("no <desc>")), "a figure without description");
    }
}
