//! The command `explain`: the equations of the exact answer with their numbers, as text or as Markdown with formulas.

mod chain;

use clap::{Args, ValueEnum};
use palkki::explain::{Chain, Equation, Explanation, Law, Node, Overhang, Span, What};
use palkki::text::{magnitude, markdown_text};

use super::answer::Answer;
use super::arguments::SceneArgument;
use super::given::scene_lines;
use super::input::Input;
use super::table::{Labels, Row, list, table};
use super::text::heading;

pub(super) const EXAMPLE: &str = "\
Examples:
  palkki explain report/scenes/heinisuo-1984.toml
  palkki explain report/scenes/ridge.toml --format markdown";

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

/// Numbers up to this share of the largest related number are treated as rounding.
const ROUNDING: f64 = 1e-12;

/// The three-moment equation, and the equations of one span at its right end and at its left end.
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

/// The same for a beam whose stiffness changes between its nodes.
const CHANGING: [[&str; 2]; 3] = [
    [
        "Ba M(left) + (Ba,right + Bb,left) M(i) + Bb M(right) = 6 EI [(v(i) - v(left))/La - (v(right) - v(i))/Lb] - Sa - Sb",
        r"B_a M_{i-1} + (B_a^r + B_b^l) M_i + B_b M_{i+1} = 6EI\left[\frac{v_i - v_{i-1}}{L_a} - \frac{v_{i+1} - v_i}{L_b}\right] - S_a - S_b",
    ],
    [
        "B M(left) + Bright M(i-) = 6 EI [(v(i) - v(left))/L - v'(i)] - S",
        r"B M_{i-1} + B^r M_i^- = 6EI\left[\frac{v_i - v_{i-1}}{L} - v_i'\right] - S",
    ],
    [
        "Bleft M(i+) + B M(right) = 6 EI [v'(i) - (v(right) - v(i))/L] - S",
        r"B^l M_i^+ + B M_{i+1} = 6EI\left[v_i' - \frac{v_{i+1} - v_i}{L}\right] - S",
    ],
];

/// The equations of an exact answer.
pub(super) fn text(input: &Input, answer: &Answer, form: Explained) -> String {
    let (labels, verdict) = (input.labels(), &answer.solution.verdict);
    let Some(exact) = &answer.solution.exact else { return heading(verdict.status, &answer.reason(), input) };
    let lines = scene_lines(&input.scene, &labels);
    let head = match form {
        Explained::Text => heading(verdict.status, &answer.reason(), input) + &list(&lines),
        Explained::Markdown => {
            let lines = lines.iter().map(|(name, value)| format!("- {name}: {}\n", markdown_text(value)));
            let (title, warnings) = (markdown_text(input.title()), markdown_text(&input.warning_lines()));
            format!("# {title}\n\nStatus: {}.\n\n{warnings}{}", verdict.status, lines.collect::<String>())
        }
    };
    if let Some(chain) = Chain::of(&input.scene, exact) {
        return head + &chain::text(&chain, &labels, form);
    }
    let found = Explanation::of(&input.scene, exact);
    let changes = !input.scene.is_uniform();
    let page = Page { moment: found.moment(), found, labels, form, changes };
    let shaped = input.scene.beam().shape().is_some();
    head + &page.nodes(shaped)
        + &page.spans()
        + &page.overhangs()
        + &page.equations()
        + &laws(&page.found.laws, &page.labels, form)
        + &page.forces()
}

/// An explanation to be written.
struct Page {
    found: Explanation,
    labels: Labels,
    form: Explained,
    /// The moment with which moments are compared to detect rounding.
    moment: f64,
    /// Whether the stiffness of the beam changes along its length.
    changes: bool,
}

impl Page {
    fn table(&self, title: &str, header: &[&str], rows: &[Row]) -> String {
        tabled(self.form, title, header, rows)
    }

    fn number(&self, value: f64) -> String {
        self.labels.number(value)
    }

    /// A number, with 0 in place of rounding compared with `size`.
    fn beside(&self, value: f64, size: f64) -> String {
        self.number(if value.abs() <= ROUNDING * size { 0.0 } else { value })
    }

    fn nodes(&self, shaped: bool) -> String {
        let found = &self.found;
        let deepest = found.nodes.iter().fold(0.0, |most: f64, node| most.max(node.deflection.abs()));
        let last = found.nodes.len() - 1;
        let row = |(i, node): (usize, &Node)| {
            let Node { what, x, deflection, slope, moments: [left, right], .. } = *node;
            // Beyond an end there is no beam.
            let moment =
                |is_beam: bool, value| if is_beam { self.beside(value, self.moment) } else { "none".to_owned() };
            vec![
                (i + 1).to_string(),
                what.name().to_owned(),
                self.number(x),
                self.beside(deflection, deepest),
                slope.map_or_else(|| "not given".to_owned(), |slope| self.number(slope)),
                moment(0 < i, left),
                moment(i < last, right),
            ]
        };
        let header = ["node", "what it is", "x", "deflection v", "slope v'", "M left", "M right"];
        let mut text = self.table("Nodes", &header, &found.nodes.iter().enumerate().map(row).collect::<Vec<_>>());
        for x in &found.lifted {
            text += &format!("\nThe beam has lifted off the support at x = {}, which is no node.\n", self.number(*x));
        }
        for (i, node) in found.nodes.iter().enumerate().filter(|(_, node)| node.couple != 0.0) {
            let couple = self.number(node.couple);
            text += &format!(
                "\nA couple of {couple} acts at node {}: M right is M left + {couple}, and what a support adds.\n",
                i + 1
            );
        }
        if shaped {
            text += "\nv counts from the initial shape w0: it is level - w0 at a support and u - w0 on the ground.\n";
        }
        text
    }

    fn spans(&self) -> String {
        if self.found.spans.is_empty() {
            return String::new();
        }
        let bends = |span: &Span| if self.changes { span.bend.to_vec() } else { Vec::new() };
        let row = |(i, span): (usize, &Span)| {
            let numbers = [span.length].into_iter().chain(bends(span)).chain(span.load).chain(span.reactions);
            let names = [letter(i), (span.left + 1).to_string(), (span.left + 2).to_string()];
            names.into_iter().chain(numbers.map(|value| self.number(value))).collect::<Row>()
        };
        let bends = if self.changes { &["B left", "B", "B right"][..] } else { &[] };
        let (names, loads) = (["span", "from node", "to node", "length L"], ["S left", "S right", "A left", "A right"]);
        let header = [&names[..], bends, &loads].concat();
        let mut text = self.table("Spans", &header, &self.found.spans.iter().enumerate().map(row).collect::<Vec<_>>());
        text += "\nOf the load of a span: A are the reactions of a simple beam, S the terms of the equations, q L^3 / 4 under a uniform load q";
        text += if self.changes {
            " on a\nbeam with the least EI. B left, B and B right are the terms of its end moments, 2 L, L and 2 L on such a beam.\n"
        } else {
            ".\n"
        };
        text
    }

    fn overhangs(&self) -> String {
        if self.found.overhangs.is_empty() {
            return String::new();
        }
        let row = |overhang: &Overhang| {
            let Overhang { root, tip, length, load, moment } = *overhang;
            let [length, load, moment] = [length, load, moment].map(|value| self.number(value));
            vec![(root + 1).to_string(), (tip + 1).to_string(), length, load, moment]
        };
        let header = ["from node", "to its end, node", "length", "its load", "moment of that about the node"];
        self.table("Overhangs", &header, &self.found.overhangs.iter().map(row).collect::<Vec<_>>())
            + "\nStatics give M beside the node: minus the moment of the load beyond it.\n"
    }

    fn equations(&self) -> String {
        let found = &self.found;
        if found.equations.is_empty() {
            return "\nNo moment is unknown: there is no equation to solve.\n".to_owned();
        }
        let title = match self.form {
            Explained::Text => "Equations",
            Explained::Markdown => "## Equations",
        };
        let least = if self.changes { ", with the least bending stiffness" } else { "" };
        let mut text = format!("\n{title}\n\n6 EI = {}{least}\n", self.number(found.stiffness));
        let unknown = |&(node, right): &(usize, Option<bool>)| match right {
            Some(right) => name(&found.nodes, node, right, self.moment),
            None if found.nodes[node].what == What::Hinge => format!("v{}", node + 1),
            None => format!("x{}", node + 1),
        };
        let of_law = |law: &Law| Some(format!("v{}{}", if law.turning { "'" } else { "" }, law.node? + 1));
        let unknowns = found.unknowns().into_iter().map(|of| unknown(&of)).chain(found.laws.iter().filter_map(of_law));
        let unknowns = unknowns.collect::<Vec<_>>().join(", ");
        let turns =
            if found.laws.iter().any(|law| law.turning) { " and that no spring keeps from turning" } else { "" };
        text += &format!("\nUnknown: {unknowns}. M = 0 at an end of the beam that is not built in{turns}.");
        let has_sides = found.equations.iter().any(|equation| equation.spans.contains(&None));
        text += if has_sides { " M(i-) and M(i+) are the moments just left and just right of node i.\n" } else { "\n" };
        text.extend(found.equations.iter().map(|equation| self.equation(equation)));
        if found.nodes.iter().any(|node| matches!(node.what, What::Point | What::ZoneEnd)) {
            text += "\nWhere the beam follows the ground its slope is given and its place x is not. \
                     At the end of a zone the moment is that of the ground, -EI (u - w0)''.\n";
        }
        for (i, k) in found.nodes.iter().enumerate().filter_map(|(i, node)| Some((i, node.joint?))) {
            text += &match found.nodes[i].what {
                What::Hinge => format!(
                    "\nNode {} is a hinge: M = 0, and its deflection v is the one for which it has no force.\n",
                    i + 1
                ),
                _ if k == 0.0 => {
                    format!("\nNode {} is a hinge as well: M = 0, and its slope has no equation.\n", i + 1)
                }
                _ => format!(
                    "\nNode {} is a joint as well: 6 EI / k = {} is a part of the factor of its moment.\n",
                    i + 1,
                    self.number(found.stiffness / k)
                ),
            };
        }
        text
    }

    fn forces(&self) -> String {
        let found = &self.found;
        let row = |(i, node): (usize, &Node)| {
            let Node { shears: [left, right], load, force, .. } = *node;
            let size = left.abs().max(right.abs()).max(load.abs());
            let [left, right, load, force] = [left, right, load, force].map(|value| self.beside(value, size));
            vec![(i + 1).to_string(), left, right, load, force]
        };
        let rows: Vec<Row> = found.nodes.iter().enumerate().map(row).collect();
        self.table("Forces", &["node", "V left", "V right", "load P", "force upwards"], &rows)
            + if found.spans.is_empty() {
                ""
            } else {
                "\nV is (M right - M left)/L + A left at the left end of a span, and (M right - M left)/L - A right at its right end.\n"
            }
            + "\nThe force is V right - V left + P.\n"
    }

    /// An equation with its formula, its numbers, and the difference between its two sides.
    fn equation(&self, equation: &Equation) -> String {
        let [plain, formula] = (if self.changes { CHANGING } else { FORMULAS })[match equation.spans {
            [Some(_), Some(_)] => 0,
            [Some(_), None] => 1,
            _ => 2,
        }];
        let spans: Vec<String> = equation.spans.into_iter().flatten().map(letter).collect();
        let spans = format!("{} {}", if spans.len() == 1 { "span" } else { "spans" }, spans.join(" and "));
        let (node, sum) = (equation.node + 1, self.sum(equation));
        let off = self.found.residual(equation).abs() / self.found.size(equation).max(f64::MIN_POSITIVE);
        let holds = match off {
            ..=ROUNDING => "The moments above fulfil it to twelve digits.".to_owned(),
            _ => format!("With the moments above the two sides differ by {} of the largest part.", magnitude(off)),
        };
        match self.form {
            Explained::Text => format!("\n  Node {node}, {spans}\n    {plain}\n    {sum}\n    {holds}\n"),
            Explained::Markdown => {
                format!("\nNode {node}, {spans}:\n\n```math\n{formula}\n```\n\n```text\n{sum}\n```\n\n{holds}\n")
            }
        }
    }

    /// The moments with their factors, the contributions of deflections and load, and their sum.
    fn sum(&self, equation: &Equation) -> String {
        let terms = terms(equation, &self.found.nodes, self.moment);
        let terms: Vec<String> =
            terms.iter().map(|(name, factor)| format!("{} {name}", self.number(*factor))).collect();
        let (load, size) = (equation.load, self.found.size(equation));
        let [settlement, part, sum] =
            [equation.settlement, load.abs(), equation.settlement - load].map(|part| self.beside(part, size));
        let sign = if load < 0.0 { '+' } else { '-' };
        format!("{} = {settlement} {sign} {part} = {sum}", terms.join(" + "))
    }
}

/// The moments of an equation with their factors; `size` is the moment with which they are compared to detect rounding.
fn terms(equation: &Equation, nodes: &[Node], size: f64) -> Vec<(String, f64)> {
    let mut found: Vec<(String, f64)> = Vec::new();
    for &(node, right, factor) in &equation.terms {
        let name = name(nodes, node, right, size);
        match found.last_mut().filter(|last| last.0 == name) {
            Some(last) => last.1 += factor,
            None => found.push((name, factor)),
        }
    }
    found
}

/// The name of a moment; it has no sign for the side if both sides of the node have the same moment.
fn name(nodes: &[Node], node: usize, right: bool, size: f64) -> String {
    let [left, behind] = nodes[node].moments;
    let is_one = (left - behind).abs() <= ROUNDING * size;
    format!("M{}{}", node + 1, if is_one { "" } else { ["-", "+"][usize::from(right)] })
}

/// The name of a span: a, b, c, …, then 27, 28, ….
fn letter(i: usize) -> String {
    u8::try_from(i).ok().filter(|i| *i < 26).map_or_else(|| (i + 1).to_string(), |i| char::from(b'a' + i).to_string())
}

/// The laws of elastic supports, with their numbers.
fn laws(all: &[Law], labels: &Labels, form: Explained) -> String {
    if all.is_empty() {
        return String::new();
    }
    let mut text = match form {
        Explained::Text => "\nSupports that give\n".to_owned(),
        Explained::Markdown => "\n## Supports that give\n".to_owned(),
    };
    for law in all {
        let at = law
            .node
            .map_or_else(|| format!("At x = {}, on the ground", labels.number(law.x)), |i| format!("Node {}", i + 1));
        let [k, now, without, says] =
            [law.stiffness, law.now, law.without.abs(), law.says()].map(|value| labels.number(value));
        let less = if law.without < 0.0 { '+' } else { '-' };
        let (formula, sign) = match law.turning {
            false => ("R = k (v - d)", ""),
            true => ("M right - M left = -k (v' - slope)", "-"),
        };
        text += &format!("\n{at}: {formula} = {sign}{k} ({now} {less} {without}) = {says}.\n");
    }
    if all.iter().any(|law| law.turning) {
        text += "\nA couple that acts there adds to the difference of the moments.\n";
    }
    if all.iter().any(|law| law.node.is_none()) {
        text += "\nOn the ground v and v' are those of the ground, which takes what the support does not.\n";
    }
    text
}

/// A table in one of the two formats.
fn tabled(form: Explained, title: &str, header: &[&str], rows: &[Row]) -> String {
    match form {
        Explained::Text => table(title, header, rows),
        Explained::Markdown => markdown(title, header, rows),
    }
}

/// A table as Markdown.
fn markdown(title: &str, header: &[&str], rows: &[Row]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let names: Vec<String> = header.iter().map(|name| (*name).to_owned()).collect();
    let dashes = vec!["---".to_owned(); header.len()];
    let rows: String = rows.iter().map(|row| line(row)).collect();
    format!("\n## {title}\n\n{}{}{rows}", line(&names), line(&dashes))
}
