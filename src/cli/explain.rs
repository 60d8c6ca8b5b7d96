//! `explain`: the equations of the exact answer, with their numbers, as text or as Markdown with formulas.

use clap::{Args, ValueEnum};
use palkki::explain::{Equation, Explanation, Node, Span, What};
use palkki::text::magnitude;

use super::answer::Answer;
use super::arguments::SceneArgument;
use super::given::given;
use super::input::Input;
use super::table::{list, table};
use super::text::heading;

pub(super) const EXAMPLE: &str = "\
Examples:
  palkki explain report/scenes/heinisuo-1984.toml
  palkki explain scene.toml --format markdown";

#[derive(Debug, Args)]
pub(super) struct Explain {
    /// Text to read, or Markdown with formulas
    #[arg(short, long, value_name = "FORMAT", value_enum, default_value_t = Explained::Text)]
    pub(super) format: Explained,
    #[command(flatten)]
    pub(super) scene: SceneArgument,
}

/// `--format` of `explain`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Explained {
    Text,
    Markdown,
}

/// What is no larger than this share of the largest part beside it is rounding.
const ROUNDING: f64 = 1e-12;

/// The formula of three moments, and those of one span at its right and at its left end.
const FORMULAS: [[&str; 2]; 3] = [
    [
        "La M(left) + 2 (La + Lb) M(i) + Lb M(right) = 6 EI [(v(i) - v(left))/La - (v(right) - v(i))/Lb] - Sa - Sb",
        r"L_a M_{i-1} + 2 (L_a + L_b) M_i + L_b M_{i+1} = 6EI\left[\frac{v_i - v_{i-1}}{L_a} - \frac{v_{i+1} - v_i}{L_b}\right] - S_a - S_b",
    ],
    [
        "L M(left) + 2 L M(i-) = 6 EI [(v(i) - v(left))/L - v'(i)] - S",
        r"L M_{i-1} + 2 L M_i^- = 6EI\left[\frac{v_i - v_{i-1}}{L} - v_i'\right] - S",
    ],
    [
        "2 L M(i+) + L M(right) = 6 EI [v'(i) - (v(right) - v(i))/L] - S",
        r"2 L M_i^+ + L M_{i+1} = 6EI\left[v_i' - \frac{v_{i+1} - v_i}{L}\right] - S",
    ],
];

/// The equations of an exact answer.
pub(super) fn text(input: &Input, answer: &Answer, form: Explained) -> String {
    let (labels, verdict) = (input.labels(), &answer.solution.verdict);
    let Some(exact) = &answer.solution.exact else { return heading(verdict.status, &answer.reason(), input) };
    let found = Explanation::of(&input.scene, exact);
    let is_text = form == Explained::Text;
    let mut text = match form {
        Explained::Text => heading(verdict.status, &answer.reason(), input) + &list(&given(&input.scene, &labels)),
        Explained::Markdown => {
            let title = input.title();
            let lines = given(&input.scene, &labels);
            let lines = lines.iter().map(|(name, value)| format!("- {}: {value}\n", AsRef::<str>::as_ref(name)));
            format!("# {title}\n\nStatus: {}.\n\n{}", verdict.status, lines.collect::<String>())
        }
    };
    let table = |title: &str, header: &[&str], rows: Vec<Vec<String>>| {
        if is_text { table(title, header, &rows) } else { markdown(title, header, &rows) }
    };
    let number = |value: f64| labels.number(value);
    // What is left of rounding is nothing.
    let beside = |value: f64, size: f64| number(if value.abs() <= ROUNDING * size { 0.0 } else { value });
    // A load of one span alone would bend it by `S/L`.
    let bent = found.spans.iter().map(|span| span.load[0].abs().max(span.load[1].abs()) / span.length);
    let moments = found.nodes.iter().flat_map(|node| node.moments).map(f64::abs);
    let moment = moments.chain(bent).fold(0.0, f64::max);
    let node = |(i, node): (usize, &Node)| {
        let Node { what, x, deflection, slope, moments: [left, right], force } = *node;
        let slope = slope.map_or_else(|| "found".to_owned(), number);
        vec![
            (i + 1).to_string(),
            what.name().to_owned(),
            number(x),
            number(deflection),
            slope,
            beside(left, moment),
            beside(right, moment),
            number(force),
        ]
    };
    let header = ["node", "what it is", "x", "deflection v", "slope v'", "M left", "M right", "force upwards"];
    text += &table("Nodes", &header, found.nodes.iter().enumerate().map(node).collect());
    let span = |(i, span): (usize, &Span)| {
        let Span { left, length, load: [a, b], .. } = *span;
        vec![letter(i), (left + 1).to_string(), (left + 2).to_string(), number(length), number(a), number(b)]
    };
    if found.spans.is_empty() {
        text += "\nNo part of the beam is between two nodes and off the ground: there is no equation.\n";
        return text;
    }
    let header = ["span", "from node", "to node", "length L", "S at its left end", "S at its right end"];
    text += &table("Spans", &header, found.spans.iter().enumerate().map(span).collect());
    text += "\nS is the load term of a span, q L^3 / 4 under a uniform load q; M(i-) and M(i+) are the moments just left and just right of node i.\n";
    text += if is_text { "\nEquations\n" } else { "\n## Equations\n" };
    text += &format!("\n6 EI = {}\n", number(found.stiffness));
    for equation in &found.equations {
        let which = match equation.spans {
            [Some(_), Some(_)] => 0,
            [Some(_), None] => 1,
            _ => 2,
        };
        let [plain, formula] = FORMULAS[which];
        let spans: Vec<String> = equation.spans.into_iter().flatten().map(letter).collect();
        let spans = format!("{} {}", if spans.len() == 1 { "span" } else { "spans" }, spans.join(" and "));
        let terms: Vec<String> = terms(equation, &found.nodes, moment)
            .iter()
            .map(|(name, factor)| format!("{} {name}", number(*factor)))
            .collect();
        let size = found.size(equation);
        let [settlement, load, sum] = [equation.settlement, equation.load.abs(), equation.settlement - equation.load]
            .map(|part| beside(part, size));
        let sign = if equation.load < 0.0 { '+' } else { '-' };
        let sum = format!("{} = {settlement} {sign} {load} = {sum}", terms.join(" + "));
        let off = found.residual(equation).abs() / size.max(f64::MIN_POSITIVE);
        let holds = match off {
            ..=ROUNDING => "The moments above fulfil it to twelve digits.".to_owned(),
            _ => format!("With the moments above the two sides differ by {} of the largest part.", magnitude(off)),
        };
        text += &match form {
            Explained::Text => {
                format!("\n  Node {}, {spans}\n    {plain}\n    {sum}\n    {holds}\n", equation.node + 1)
            }
            Explained::Markdown => format!(
                "\nNode {}, {spans}:\n\n```math\n{formula}\n```\n\n```text\n{sum}\n```\n\n{holds}\n",
                equation.node + 1
            ),
        };
    }
    if found.nodes.iter().any(|node| matches!(node.what, What::Point | What::ZoneEnd)) {
        text += "\nWhere the beam follows the ground its slope is given and its place is not: there the equations of both sides also give the place x. \
                 At the end of a zone the moment is that of the ground, -EI (u - w0)''.\n";
    }
    text += "\nThe force of a node is the jump of the shear force there: V = (M(right) - M(left))/L and the reactions of each span to its own load.\n";
    text
}

/// The moments of an equation with their factors; `size` is what moments are rounded beside.
fn terms(equation: &Equation, nodes: &[Node], size: f64) -> Vec<(String, f64)> {
    let mut found: Vec<(String, f64)> = Vec::new();
    for &(node, right, factor) in &equation.terms {
        let [left, behind] = nodes[node].moments;
        // A node at which both sides have one moment has no sides.
        let is_one = (left - behind).abs() <= ROUNDING * size;
        let side = if is_one { "" } else { ["-", "+"][usize::from(right)] };
        let name = format!("M{}{side}", node + 1);
        match found.last_mut().filter(|last| last.0 == name) {
            Some(last) => last.1 += factor,
            None => found.push((name, factor)),
        }
    }
    found
}

/// Spans are a, b, c, …, then 27, 28, ….
fn letter(i: usize) -> String {
    u8::try_from(i).ok().filter(|i| *i < 26).map_or_else(|| (i + 1).to_string(), |i| char::from(b'a' + i).to_string())
}

/// A table as Markdown.
fn markdown(title: &str, header: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let names: Vec<String> = header.iter().map(|name| (*name).to_owned()).collect();
    let dashes = vec!["---".to_owned(); header.len()];
    let rows: String = rows.iter().map(|row| line(row)).collect();
    format!("\n## {title}\n\n{}{}{rows}", line(&names), line(&dashes))
}
