//! A table as part of a page: its header cells name what they are the header of.

use pulldown_cmark::{Alignment, Event, Tag, TagEnd};

/// The HTML of a table: `events` are those between its beginning and its end.
pub(super) fn cells<'t>(out: &mut Vec<Event<'t>>, events: impl Iterator<Item = Event<'t>>, alignments: &[Alignment]) {
    let (mut in_head, mut column) = (false, 0);
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
                html(out, format!("<th scope=\"col\"{}>", style(alignments.get(column))));
            }
            Event::Start(Tag::TableCell) => {
                let style = style(alignments.get(column));
                html(out, if column == 0 { format!("<th scope=\"row\"{style}>") } else { format!("<td{style}>") });
            }
            Event::End(TagEnd::TableCell) => {
                html(out, if in_head || column == 0 { "</th>" } else { "</td>" }.to_owned());
                column += 1;
            }
            other => out.push(other),
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
