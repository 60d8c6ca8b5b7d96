//! A table as part of a page: its header cells say what they are the header of, and each cell knows the name of its column, so
//! that a narrow screen can show each row as a card.

use pulldown_cmark::{Alignment, Event, Tag, TagEnd};

use super::{escaped, text_of};

/// The HTML of a table: `events` are those between its beginning and its end.
pub(super) fn cells<'t>(out: &mut Vec<Event<'t>>, events: impl Iterator<Item = Event<'t>>, alignments: &[Alignment]) {
    let (mut names, mut in_head, mut column) = (Vec::<String>::new(), false, 0);
    let html = |out: &mut Vec<Event<'t>>, text: String| out.push(Event::Html(text.into()));
    html(out, "<div class=\"table cards\"><table>".to_owned());
    for event in events {
        match event {
            Event::Start(Tag::TableHead) => {
                in_head = true;
                html(out, "<thead><tr>".to_owned());
            }
            Event::End(TagEnd::TableHead) => {
                in_head = false;
                html(out, "</tr></thead><tbody>\n".to_owned());
            }
            Event::Start(Tag::TableRow) => {
                column = 0;
                html(out, "<tr>".to_owned());
            }
            Event::End(TagEnd::TableRow) => html(out, "</tr>\n".to_owned()),
            Event::Start(Tag::TableCell) if in_head => {
                names.push(String::new());
                html(out, format!("<th scope=\"col\"{}>", style(alignments.get(names.len() - 1))));
            }
            Event::Start(Tag::TableCell) => {
                let style = style(alignments.get(column));
                let name = names.get(column).map(|name| escaped(name)).unwrap_or_default();
                let begin = match column {
                    0 => format!("<th scope=\"row\"{style}>"),
                    _ => format!("<td data-name=\"{name}\"{style}><span>"),
                };
                html(out, begin);
            }
            Event::End(TagEnd::TableCell) => {
                html(out, if in_head || column == 0 { "</th>" } else { "</span></td>" }.to_owned());
                column += usize::from(!in_head);
            }
            other => {
                if let (true, Some(text), Some(name)) = (in_head, text_of(&other), names.last_mut()) {
                    name.push_str(text);
                }
                out.push(other);
            }
        }
    }
    html(out, "</tbody></table></div>\n".to_owned());
}

/// The style of a cell.
fn style(alignment: Option<&Alignment>) -> &'static str {
    match alignment {
        Some(Alignment::Right) => " class=\"right\"",
        Some(Alignment::Center) => " class=\"middle\"",
        _ => "",
    }
}
