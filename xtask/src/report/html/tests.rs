//! Links, formulas, drawings, tables and the beam to play with on their way into the page.

use super::*;

const SVG: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"300\" viewBox=\"0 0 2400 900\" \
                   role=\"img\" aria-labelledby=\"title desc\" font-family=\"sans-serif\" font-size=\"58\">\n\
                   <title id=\"title\">t &lt; 1</title>\n<desc id=\"desc\">d</desc>\n\
                   <style>@media (prefers-color-scheme: dark) { [fill=\"#000000\"]{fill:#E6EDF3} }</style>\n\
                   <rect width=\"2400\" height=\"900\" fill=\"#FFFFFF\"/>\n\
                   <g class=\"title\">\n<text>t &lt; 1</text>\n</g>\n\
                   <g data-panel=\"0 100 1200 700\">\n<path d=\"M0,0\"/>\n</g>\n\
                   <g data-panel=\"1200 100 1200 700\">\n<path d=\"M1,1\"/>\n</g>\n\
                   <g class=\"note\">\n<text>A note</text>\n<text>on two lines.</text>\n</g>\n</svg>\n";

/// A report of which one document has a text, with all that the page needs.
fn report(name: &str, text: &str) -> Rendered {
    let mut rendered: Rendered =
        DOCUMENTS.iter().map(|document| (path_of(document), format!("# {document}: words\n\n## Part\n"))).collect();
    rendered.insert(path_of(name), text.to_owned());
    for (path, text) in
        [("figures/f.svg", SVG), (STEPS[0], SVG), (SCENES, "x\n"), (STEPS[1], "round,node,sign,force\n1,1,held,1\n")]
    {
        rendered.insert(path.to_owned(), text.to_owned());
    }
    rendered
}

/// The page with a document, between its beginning and its end.
fn article(name: &str, text: &str) -> Result<String, String> {
    let page = page(&report(name, text)).map_err(|error| error.to_string())?;
    let article =
        page.split_once(&format!("<article id=\"{name}\">\n")).and_then(|(_, rest)| rest.split_once("</article>"));
    Ok(article.map(|(article, _)| article.to_owned()).unwrap_or_default())
}

#[test]
fn links_to_documents_become_places_in_the_page_and_others_stay() {
    let text = "# Theory\n\n## A `b`, c\n\n[1](#a-b-c) [2](claims.md) [3](claims.md#part) [4](../README.md) \
                [5](../../src/lib.rs#L3) [6](../data/f.csv) [7](https://example.org/x?a=1&b) [8](../index.html)";
    let html = article("theory", text).expect("every link leads somewhere");
    for (n, target) in [
        "#theory-a-b-c",
        "#claims",
        "#claims-part",
        "#report",
        "../src/lib.rs#L3",
        "data/f.csv",
        "https://example.org/x?a=1&amp;b",
        "#report",
    ]
    .iter()
    .enumerate()
    {
        assert!(html.contains(&format!("href=\"{target}\">{}</a>", n + 1)), "{target}: {html}");
    }
    assert_eq!(html.matches("<a class=\"beside\" title=\"a file beside this page\"").count(), 2, "[5] and [6]: {html}");
    let nowhere = article("theory", "# Theory\n[x](claims.md#nothing)");
    assert_eq!(nowhere, Err("a link leads to #claims-nothing, which does not exist".to_owned()));
}

#[test]
fn the_navigation_has_all_documents_in_their_order() {
    let page = page(&report("theory", "# Theory: the problem\n\n## One & two\n\n### Three")).expect("all is there");
    let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("{text} is not in the page"));
    let entries =
        ["<a href=\"#report\">The report</a>", "<a href=\"#theory\">Theory</a>", "<a href=\"#claims\">claims</a>"];
    assert!(entries.map(at).is_sorted(), "reading order");
    at("<li><a href=\"#theory-one--two\">One &amp; two</a></li>");
    assert!(!page.contains("href=\"#theory-three\""), "two levels are enough");
}

#[test]
fn drawings_become_part_of_the_page_panel_by_panel() {
    let html = article("theory", "# Theory\n\n![f](../figures/f.svg)\n![f](../figures/f.svg)").expect("it is made");
    let font = "font-family=\"sans-serif\" font-size=\"58\" style=\"--share:0.5\"";
    let drawing = format!(
        "<p class=\"title\">t &lt; 1</p>\n\
         <div class=\"drawing\" role=\"img\" aria-label=\"d\" style=\"--ratio:2.6666666666666665\">\n\
         <svg viewBox=\"0 100 1200 700\" {font}>\n<path d=\"M0,0\"/>\n</svg>\n\
         <svg viewBox=\"1200 100 1200 700\" {font}>\n<path d=\"M1,1\"/>\n</svg>\n</div>\n\
         <p class=\"note\">A note on two lines.</p>\n"
    );
    assert!(html.contains(&format!("<figure>{drawing}\n{drawing}</figure>")), "{html}");
    let page = page(&report("theory", "# Theory")).expect("it is made");
    assert!(page.contains(":root[data-theme=dark] svg { [fill=\"#000000\"]{fill:#E6EDF3}"), "once for all drawings");
    let refused = |text: &str| article("theory", text).expect_err("it is refused");
    assert!(
        refused("# Theory\n![x](https://example.org/x.png)").contains("would have to be loaded"),
        "nothing is loaded"
    );
    assert!(refused("# Theory\n\nand ![f](../figures/f.svg)").contains("a paragraph of its own"), "nor inside a text");
}

#[test]
fn formulas_become_mathml_or_fail() {
    let html = article("theory", "# Theory\n\n```math\n\\frac{a}{b} < c,\\ d\n```\n\n```text\n\\frac\n```")
        .expect("it parses");
    assert!(html.contains("<math display=\"block\"><mfrac><mrow><mi>a</mi></mrow>"), "{html}");
    assert!(
        html.contains("<mo>&lt;</mo>") && html.contains("&#160;"),
        "signs that HTML would take for its own: {html}"
    );
    assert!(html.contains("<pre><code class=\"language-text\">\\frac"), "other code stays: {html}");
    let error = article("theory", "# Theory\n\n```math\na + \\nosuch b\n```").expect_err("no such command");
    assert!(error.starts_with("pages/theory.md: the formula\na + \\nosuch b\n"), "{error}");
}

#[test]
fn a_table_says_what_its_headers_are_of() {
    let html = article("theory", "# Theory\n\n| case | `x` & y |\n|---|--:|\n| **one** | 2 |\n").expect("it is made");
    let expected = "<div class=\"table cards\"><table><thead><tr><th scope=\"col\">case</th>\
                    <th scope=\"col\" class=\"right\"><code>x</code> &amp; y</th></tr></thead><tbody>\n\
                    <tr><th scope=\"row\"><strong>one</strong></th>\
                    <td class=\"right\">2</td></tr>\n</tbody></table></div>";
    assert!(html.contains(expected), "{html}");
}

#[test]
fn options_and_numbers_stay_on_one_line() {
    let html =
        article("theory", "# Theory\n\n0.9 % in 3 ms, `palkki solve A --method force` `--csv A`\n\n```text\n1 %\n```");
    let html = html.expect("it is made");
    assert!(html.contains("0.9\u{a0}% in 3\u{a0}ms, <code>"), "{html}");
    assert!(html.contains("palkki solve A</span> <span class=\"option\">--method force</span>"), "{html}");
    assert!(html.contains("<code><span class=\"option\">--csv A</span></code>"), "{html}");
    assert!(html.contains("1 %"), "code is to be copied: {html}");
}

/// What a reader has to go through who wants to know how the beam of the page is solved, and how the four steps are shown.
#[test]
fn the_scripts_that_play_are_short() {
    let code = PLAYED.lines().filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with("//"));
    let (count, longest) = code.fold((0, 0), |(count, longest), line| (count + 1, longest.max(line.chars().count())));
    assert!(count <= 300 && longest <= 150, "{count} lines of code, of at most {longest} characters");
}

#[test]
fn the_four_steps_are_played_in_the_report_alone() {
    let link = "# T\n\n![f](figures/four-steps.svg)";
    assert_eq!(article("report", link).map(|html| html.matches("class=\"steps\"").count()), Ok(1));
    let link = "# T\n\n![f](../figures/four-steps.svg)";
    assert_eq!(article("exercises", link).map(|html| html.matches("class=\"steps\"").count()), Ok(0));
}

#[test]
fn the_beam_stands_below_the_title_with_its_scenes() {
    let mut rendered = report("report", "# Title\n\nText");
    let whole = page(&rendered).expect("all is there");
    assert!(whole.contains("<h1 id=\"report-title\">Title</h1>\n<section class=\"play\""), "{whole}");
    assert!(whole.contains("<script type=\"text/csv\" id=\"data-play\">\nx\n</script>"), "with its scenes");
    rendered.remove(SCENES);
    assert_eq!(page(&rendered).map_err(|error| error.to_string()), Err(format!("{SCENES} is not made")));
}
