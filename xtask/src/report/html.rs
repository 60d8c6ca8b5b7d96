//! `index.html`: all documents in one file that loads nothing from outside, to be read in a browser and to be printed.
//!
//! Made of the rendered Markdown, drawings and data alone. Links between documents become links inside the page, drawings
//! become part of it, and formulas become MathML. Below its title is a beam to play with.

mod check;
mod drawing;
mod steps;
mod table;

use std::fmt::Write as _;

use minijinja::context;
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html::push_html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Storage, push_mathml};

use super::{DOCUMENTS, Rendered, links, path_of, template};
use crate::Cause;

/// The file, below `report/`.
pub(super) const PATH: &str = "index.html";

/// Scenes with the answers that the beam of the page is tried against, below `report/`.
pub(super) const SCENES: &str = "data/play.csv";

/// The figure that the page shows round by round, and its data, below `report/`.
const STEPS: [&str; 2] = ["figures/four-steps.svg", "data/four-steps.csv"];

/// The beam to play with, its equations and what one sees of it, and the four steps round by round.
const PLAYED: &str = concat!(include_str!("html/beam.js"), include_str!("html/play.js"), include_str!("html/steps.js"));

/// Nothing may be loaded, and nothing but what is in the page may run.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; \
                      base-uri 'none'; form-action 'none'";

/// A page with a link past each of its sections, for those who go by the tab key; behind the last one the next page follows.
fn with_ways_past(body: &str, next: &str) -> String {
    const SECTION: &str = "<h2 id=\"";
    let mut parts = body.split(SECTION);
    let before = parts.next().unwrap_or_default().to_owned();
    let sections: Vec<&str> = parts.collect();
    let id = |section: &&str| section.split('"').next().unwrap_or_default().to_owned();
    let mut all = before;
    for (i, section) in sections.iter().enumerate() {
        let to = sections.get(i + 1).map_or_else(|| next.to_owned(), id);
        let _ = write!(all, "<a class=\"skip\" href=\"#{to}\">Past this section</a>\n{SECTION}{section}");
    }
    all
}

/// The page; an error if it does not keep what [`check`] asks of it.
pub(super) fn page(rendered: &Rendered) -> Result<String, Cause> {
    let (mut navigation, mut articles, mut title) = (String::new(), String::new(), String::new());
    for name in DOCUMENTS {
        let path = path_of(name);
        let text = rendered.get(&path).ok_or_else(|| format!("{path} is not rendered"))?;
        let mut document = Document { name, path: &path, rendered, headings: Vec::new() };
        let body = document.html(text).map_err(|error| format!("{path}: {error}"))?;
        let next = DOCUMENTS.into_iter().skip_while(|other| *other != name).nth(1).unwrap_or(DOCUMENTS[0]);
        let _ = write!(
            articles,
            "<article id=\"{name}\">\n<a class=\"skip\" href=\"#{next}\">Past this page</a>\n{}</article>\n",
            with_ways_past(&body, next)
        );
        let _ = writeln!(navigation, "{}", document.navigation());
        if title.is_empty() {
            title = document.headings.first().map(|heading| heading.text.clone()).unwrap_or_default();
        }
    }
    let articles = articles.replacen("</h1>\n", &format!("</h1>\n{}", include_str!("html/play.html")), 1);
    let values = context! {
        generated => super::GENERATED,
        policy => POLICY,
        title => escaped(&title),
        style => format!("{}{}", include_str!("html/page.css"), drawing::style()),
        theme => include_str!("html/theme.js"),
        top => DOCUMENTS[0],
        navigation,
        articles,
        scenes => rendered.get(SCENES).ok_or_else(|| format!("{SCENES} is not made"))?,
        script => [include_str!("html/page.js"), PLAYED, include_str!("html/selftest.js")].concat(),
    };
    let page = template::filled(include_str!("html/page.html"), values)?;
    check::check(&page)?;
    Ok(page)
}

/// A heading that can be linked to.
#[derive(Debug)]
struct Heading {
    level: HeadingLevel,
    id: String,
    text: String,
}

/// One document on its way into the page.
#[derive(Debug)]
struct Document<'a> {
    name: &'a str,
    path: &'a str,
    rendered: &'a Rendered,
    headings: Vec<Heading>,
}

impl Document<'_> {
    /// The document as HTML.
    fn html(&mut self, text: &str) -> Result<String, Cause> {
        let inline = self.inline(events(text))?;
        let mut html = String::new();
        push_html(&mut html, self.blocks(inline)?.into_iter());
        Ok(html)
    }

    /// Links and drawings, everywhere.
    fn inline<'t>(&self, events: impl Iterator<Item = Event<'t>>) -> Result<Vec<Event<'t>>, Cause> {
        let mut out = Vec::new();
        let (mut events, mut in_code) = (events, false);
        while let Some(event) = events.next() {
            out.push(match event {
                Event::Start(Tag::Link { dest_url, .. }) => {
                    let target = escaped(&self.target(&dest_url));
                    let beside = !target.starts_with('#') && !target.contains("://");
                    let class = if beside { " class=\"beside\" title=\"a file beside this page\"" } else { "" };
                    Event::InlineHtml(format!("<a{class} href=\"{target}\">").into())
                }
                Event::Start(Tag::CodeBlock(_)) | Event::End(TagEnd::CodeBlock) => {
                    in_code = matches!(event, Event::Start(_));
                    event
                }
                Event::Text(text) if !in_code => Event::Text(unbroken(&text).into()),
                Event::Code(code) if code.starts_with("--") || code.contains(" --") => {
                    // An option stays on one line, with what it is given.
                    let first = if code.starts_with("--") { " class=\"option\"" } else { "" };
                    let options = escaped(&code).replace(" --", "</span> <span class=\"option\">--");
                    Event::InlineHtml(format!("<code><span{first}>{options}</span></code>").into())
                }
                Event::Start(Tag::Image { dest_url, .. }) => {
                    // The drawing has a title and a description of its own.
                    events.by_ref().take_while(|event| *event != Event::End(TagEnd::Image)).for_each(drop);
                    Event::InlineHtml(self.drawing(&dest_url)?.into())
                }
                other => other,
            });
        }
        Ok(out)
    }

    /// Headings, formulas, tables and figures.
    fn blocks<'t>(&mut self, events: Vec<Event<'t>>) -> Result<Vec<Event<'t>>, Cause> {
        let mut out = Vec::new();
        let mut events = events.into_iter();
        let html = |out: &mut Vec<Event<'t>>, text: String| out.push(Event::Html(text.into()));
        while let Some(event) = events.next() {
            match event {
                Event::Start(Tag::Heading { level, .. }) => {
                    let inner: Vec<_> =
                        events.by_ref().take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_)))).collect();
                    let text: String = inner.iter().filter_map(text_of).collect();
                    let id = format!("{}-{}", self.name, links::anchor(&text));
                    let (classes, attrs) = (Vec::new(), Vec::new());
                    out.push(Event::Start(Tag::Heading { level, id: Some(id.clone().into()), classes, attrs }));
                    out.extend(inner);
                    out.push(Event::End(TagEnd::Heading(level)));
                    self.headings.push(Heading { level, id, text });
                }
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(kind))) if &*kind == "math" => {
                    let inner = events.by_ref().take_while(|event| *event != Event::End(TagEnd::CodeBlock));
                    let latex: String = inner.filter_map(|event| text_of(&event).map(str::to_owned)).collect();
                    html(&mut out, format!("<div class=\"formula\">{}</div>\n", formula(&latex)?));
                }
                Event::Start(Tag::Table(alignments)) => {
                    let inner = events.by_ref().take_while(|event| *event != Event::End(TagEnd::Table));
                    table::cells(&mut out, inner, &alignments);
                }
                Event::Start(Tag::Paragraph) => {
                    let inner: Vec<_> =
                        events.by_ref().take_while(|event| *event != Event::End(TagEnd::Paragraph)).collect();
                    let drawn = |event: &Event<'_>| matches!(event, Event::InlineHtml(html) if html.starts_with(drawing::BEGIN));
                    let figure = inner.iter().all(|event| drawn(event) || matches!(event, Event::SoftBreak));
                    if !figure && inner.iter().any(drawn) {
                        return Err("a drawing does not stand in a paragraph of its own".into());
                    }
                    let (open, close) = if figure { ("<figure>", "</figure>\n") } else { ("<p>", "</p>\n") };
                    html(&mut out, open.to_owned());
                    out.extend(inner);
                    html(&mut out, close.to_owned());
                }
                Event::Html(text) | Event::InlineHtml(text) if text.starts_with("<!--") => {}
                other => out.push(other),
            }
        }
        Ok(out)
    }

    /// Where a link leads: to a place in the page if its target is a document.
    fn target(&self, link: &str) -> String {
        if link.contains("://") {
            return link.to_owned();
        }
        let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
        let file = if file.is_empty() { self.path.to_owned() } else { links::resolved(self.path, file) };
        match (DOCUMENTS.into_iter().find(|name| path_of(name) == file), anchor) {
            (Some(name), "") => format!("#{name}"),
            (Some(name), anchor) => format!("#{name}-{anchor}"),
            (None, _) if file == PATH => format!("#{}", DOCUMENTS[0]),
            (None, "") => file,
            (None, anchor) => format!("{file}#{anchor}"),
        }
    }

    /// A drawing as part of the page.
    fn drawing(&self, link: &str) -> Result<String, Cause> {
        let path = links::resolved(self.path, link);
        let svg = self.rendered.get(&path).filter(|_| path.ends_with(".svg"));
        let svg = svg.ok_or_else(|| format!("{link} is no drawing of the report and would have to be loaded"))?;
        let data = self.rendered.get(STEPS[1]).filter(|_| path == STEPS[0] && self.name == DOCUMENTS[0]);
        let player = data.map(|data| steps::player(data)).transpose()?.unwrap_or_default();
        Ok(drawing::inlined(svg).map_err(|error| format!("{link}: {error}"))? + &player)
    }

    /// The entry of the document, with its sections.
    fn navigation(&self) -> String {
        let of_level = |level| self.headings.iter().filter(move |heading| heading.level == level);
        // What stands before a colon is the name, what stands behind it an explanation.
        let title = of_level(HeadingLevel::H1).next().map_or(self.name, |heading| &heading.text);
        let title = if self.name == DOCUMENTS[0] { "The report" } else { title.split(':').next().unwrap_or(title) };
        let link = |id: &str, text: &str| format!("<a href=\"#{id}\">{}</a>", escaped(text));
        let sections: Vec<String> = of_level(HeadingLevel::H2)
            .map(|heading| format!("<li>{}</li>", link(&heading.id, &heading.text)))
            .collect();
        let sections =
            if sections.is_empty() { String::new() } else { format!("\n<ol>\n{}\n</ol>\n", sections.join("\n")) };
        format!("<li>{}{sections}</li>", link(self.name, title))
    }
}

/// What a Markdown text consists of.
pub(super) fn events(text: &str) -> impl Iterator<Item = Event<'_>> {
    Parser::new_ext(text, Options::ENABLE_TABLES)
}

/// The text of an event.
pub(super) fn text_of<'e>(event: &'e Event<'_>) -> Option<&'e str> {
    match event {
        Event::Text(text) | Event::Code(text) => Some(text),
        _ => None,
    }
}

/// A displayed formula as MathML, in parts where it has wide spaces: browsers break no formula, but lay parts on several lines.
fn formula(latex: &str) -> Result<String, Cause> {
    // The lines of an aligned formula belong together.
    if latex.contains("\\begin") {
        return mathml(latex);
    }
    let latex = latex.replace("\\qquad", "\\quad");
    latex.split("\\quad").filter(|part| !part.trim().is_empty()).map(mathml).collect()
}

/// A formula, or a part of one.
fn mathml(latex: &str) -> Result<String, Cause> {
    let storage = Storage::new();
    let events: Result<Vec<_>, _> = pulldown_latex::Parser::new(latex, &storage).collect();
    let events = events.map_err(|error| format!("the formula\n{latex}\n{error}"))?;
    let mut mathml = String::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    push_mathml(&mut mathml, events.into_iter().map(Ok::<_, std::fmt::Error>), config)?;
    // The library writes the sign "less" and the blank `\ ` as they must not be in HTML.
    Ok(mathml.replace("<mo><</mo>", "<mo>&lt;</mo>").replace("&amp;nbsp;", "&#160;"))
}

/// Text whose numbers stay with their units.
fn unbroken(text: &str) -> String {
    ["%", "ms", "µs", "s", "kB", "MB"].iter().fold(text.to_owned(), |text, unit| {
        let pieces: Vec<&str> = text.split(&format!(" {unit}")).collect();
        pieces.windows(2).fold(pieces[0].to_owned(), |text, pair| {
            let unit_ends = !pair[1].starts_with(char::is_alphanumeric);
            let space = if pair[0].ends_with(|c: char| c.is_ascii_digit()) && unit_ends { '\u{a0}' } else { ' ' };
            format!("{text}{space}{unit}{}", pair[1])
        })
    })
}

/// Text as HTML, also inside an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests;
