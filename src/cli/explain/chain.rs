//! The equations of a chain of links: on an elastic foundation or under an axial force.
//!
//! The output lists nodes, links, and the slope and force at each node from both adjacent links.

use palkki::explain::{Chain, ChainNode, Link, Parts};
use palkki::text::magnitude;

use super::{Explained, ROUNDING, tabled};
use crate::cli::table::{Labels, Row};

/// The two formulas for each end of a link, as text and in TeX.
const FORMULAS: [[&str; 2]; 4] = [
    [
        "v'(l) = c (v(r) - v(l)) - eta v(l) + w M(l) + omega M(r) + s(l)",
        r"v'_l = c\,(v_r - v_l) - \eta v_l + w M_l + \omega M_r + s_l",
    ],
    [
        "v'(r) = c (v(r) - v(l)) + eta v(r) - omega M(l) - w M(r) + s(r)",
        r"v'_r = c\,(v_r - v_l) + \eta v_r - \omega M_l - w M_r + s_r",
    ],
    [
        "V(l) = c (M(r) - M(l)) - eta M(l) - a v(l) - sigma v(r) + t(l)",
        r"V_l = c\,(M_r - M_l) - \eta M_l - a v_l - \sigma v_r + t_l",
    ],
    [
        "V(r) = c (M(r) - M(l)) + eta M(r) + sigma v(l) + a v(r) + t(r)",
        r"V_r = c\,(M_r - M_l) + \eta M_r + \sigma v_l + a v_r + t_r",
    ],
];

/// The whole text of a chain.
pub(super) fn text(chain: &Chain, labels: &Labels, form: Explained) -> String {
    let page = Page { chain, labels, form };
    page.tension()
        + &page.nodes()
        + &page.links()
        + &page.formulas()
        + &page.slopes()
        + &page.joints()
        + &super::laws(&chain.laws, labels, form)
        + &page.forces()
}

/// A chain to be written.
struct Page<'a> {
    chain: &'a Chain,
    labels: &'a Labels,
    form: Explained,
}

impl Page<'_> {
    fn number(&self, value: f64) -> String {
        self.labels.number(value)
    }

    /// A number, with 0 in place of rounding compared with `size`.
    fn beside(&self, value: f64, size: f64) -> String {
        self.number(if value.abs() <= ROUNDING * size { 0.0 } else { value })
    }

    fn table(&self, title: &str, header: &[&str], rows: &[Row]) -> String {
        tabled(self.form, title, header, rows)
    }

    fn tension(&self) -> String {
        match self.chain.tension {
            0.0 => String::new(),
            tension => format!(
                "\nUnder the axial force N = {} V is the vertical force: the shear force and N v'.\n",
                self.number(tension)
            ),
        }
    }

    fn nodes(&self) -> String {
        let Chain { nodes, lifted, .. } = self.chain;
        let size = nodes.iter().flat_map(|node| node.moments).fold(0.0, |most: f64, moment| most.max(moment.abs()));
        let row = |(i, node): (usize, &ChainNode)| {
            let ChainNode { what, x, deflection, slope, moments: [left, right], .. } = *node;
            let slope = slope.map_or_else(|| "not given".to_owned(), |slope| self.number(slope));
            let [left, right] = [left, right].map(|moment| self.beside(moment, size));
            vec![
                (i + 1).to_string(),
                what.name().to_owned(),
                self.number(x),
                self.number(deflection),
                slope,
                left,
                right,
            ]
        };
        let rows: Vec<Row> = nodes.iter().enumerate().map(row).collect();
        let header = ["node", "what it is", "x", "deflection v", "slope v'", "M left", "M right"];
        let mut text = self.table("Nodes", &header, &rows);
        for x in lifted {
            text += &format!("\nThe beam has lifted off the support at x = {}, which is no node.\n", self.number(*x));
        }
        text
    }

    fn links(&self) -> String {
        let row = |(i, link): (usize, &Link)| {
            let Link { length, pressed, lies, stretch, bend, spring, slopes, shears } = *link;
            let numbers = [length].into_iter().chain([stretch, bend, spring, slopes, shears].into_iter().flatten());
            let kind = match (pressed, lies) {
                (_, true) => "along it",
                (true, _) => "pressed",
                _ => "free",
            };
            let names = [(i + 1).to_string(), (i + 2).to_string(), kind.to_owned()];
            names.into_iter().chain(numbers.map(|value| self.number(value))).collect::<Row>()
        };
        let rows: Vec<Row> = self.chain.links.iter().enumerate().map(row).collect();
        let header = [
            "from node",
            "to node",
            "foundation",
            "length L",
            "c",
            "eta",
            "w",
            "omega",
            "a",
            "sigma",
            "s left",
            "s right",
            "t left",
            "t right",
        ];
        self.table("Links", &header, &rows)
            + "\ns and t are the slopes and the shear forces at the ends of a link without v and M there: of the load, and of the foundation.\n"
    }

    fn formulas(&self) -> String {
        match self.form {
            Explained::Text => {
                let lines: String = FORMULAS.iter().map(|[plain, _]| format!("    {plain}\n")).collect();
                format!("\nFrom the ends l and r of a link\n\n{lines}")
            }
            Explained::Markdown => {
                let lines: Vec<&str> = FORMULAS.iter().map(|formula| formula[1]).collect();
                let lines = lines.join(" \\\\\n");
                format!(
                    "\nFrom the ends l and r of a link\n\n```math\n\\begin{{gathered}}\n{lines}\n\\end{{gathered}}\n```\n"
                )
            }
        }
    }

    /// The contributions of `v`, `M` and load to a number at an end of a link, and their sum.
    fn parts(&self, parts: Option<Parts>) -> [String; 4] {
        let Some(parts) = parts else { return ["", "", "", "none"].map(str::to_owned) };
        [parts.deflections, parts.moments, parts.load, parts.sum()].map(|part| self.beside(part, parts.size()))
    }

    /// The largest residual of one kind of equations, as a share of the largest contribution.
    fn holds(&self, kind: usize, of: impl Fn(usize) -> [Option<Parts>; 2]) -> String {
        let off = (0..self.chain.nodes.len()).map(|node| {
            let size =
                of(node).into_iter().flatten().fold(f64::MIN_POSITIVE, |most: f64, parts| most.max(parts.size()));
            self.chain.residuals(node)[kind] / size
        });
        format!("They differ by {} of the largest part at most.\n", magnitude(off.fold(0.0, f64::max)))
    }

    fn slopes(&self) -> String {
        let row = |node: usize| {
            let [left, right] = self.chain.slopes(node).map(|parts| self.parts(parts));
            std::iter::once((node + 1).to_string()).chain(left).chain(right).collect::<Row>()
        };
        let rows: Vec<Row> = (0..self.chain.nodes.len()).map(row).collect();
        let header = ["node", "of v", "of M", "s", "v' left", "of v", "of M", "s", "v' right"];
        self.table("Slopes, by the link to the left and by that to the right", &header, &rows)
            + "\nv' left = v' right, and both are the slope that a support holds. "
            + &self.holds(0, |node| self.chain.slopes(node))
    }

    /// The rotations of joints.
    fn joints(&self) -> String {
        let joints = self.chain.nodes.iter().enumerate().filter_map(|(i, node)| Some((i + 1, node, node.joint?)));
        let line = |(i, node, k): (usize, &ChainNode, f64)| match k {
            0.0 => format!("\nNode {i} is a hinge: M = 0, and v' has two values.\n"),
            _ => {
                let turned = [node.moments[0], k, node.moments[0] / k].map(|value| self.number(value));
                let [moment, k, turned] = turned;
                format!("\nNode {i} is a joint: v' left - v' right = M/k = {moment} / {k} = {turned}.\n")
            }
        };
        joints.map(line).collect()
    }

    fn forces(&self) -> String {
        let row = |(i, node): (usize, &ChainNode)| {
            let [left, right] = self.chain.shears(i).map(|parts| self.parts(parts));
            let ends = [node.load, node.force].map(|force| self.number(force));
            std::iter::once((i + 1).to_string()).chain(left).chain(right).chain(ends).collect::<Row>()
        };
        let rows: Vec<Row> = self.chain.nodes.iter().enumerate().map(row).collect();
        let header =
            ["node", "of v", "of M", "t", "V left", "of v", "of M", "t", "V right", "load P", "force R upwards"];
        self.table("Shear forces, by the link to the left and by that to the right", &header, &rows)
            + "\nV right - V left + P = R, with V = 0 beyond the ends of the beam. "
            + &self.holds(1, |node| self.chain.shears(node))
    }
}
