//! From a list of contacts to a deflection and a moment field, in fractions, as the kernel of the certificate makes them: the beam
//! on the ground in zones, and the exact beam under its load between the places. What [`energies`](super::energies) says of
//! the two does not rest on anything here.
//!
//! Places are taken as they are. Slopes at supports and corners follow from them, and are rounded to 64 bits as those of a
//! witness are. Where the deflection is in the ground it is lifted; what pulls is not cut off, and then nothing is said.

#![expect(clippy::float_cmp, reason = "a place is the same number wherever it is given")]

use dashu_ratio::RBig;
use palkki::scene::Scene;
use palkki::state::Contact;

use super::energies::{Beam, Cell, Unsaid, jet};
use super::number::Number;
use super::polynomial::{Polynomial, at, derivative, plus, product, shifted};

/// Random scenes that the acceptance suite asks fractions about.
pub const RANDOM: usize = 1000;

/// What a list of contacts says of a scene.
#[derive(Debug)]
pub struct Pair {
    /// `J(v̂)`.
    pub upper: RBig,
    /// `D`.
    pub lower: RBig,
    /// Whether the deflection that the places make was in the ground, and is lifted.
    pub is_lifted: bool,
    /// The sum of the magnitudes that `J(v̂)` is a sum of, in 64 bits.
    pub size: f64,
}

/// A place of the list, or a support.
#[derive(Debug, Clone)]
struct Node {
    x: f64,
    /// The slope is that of the ground on its left side, if true, or on its right side; none where it is the beam's own.
    along: Option<bool>,
    slope: RBig,
    /// Whether the beam lies on the ground from here to the next one.
    lies: bool,
}

/// `v` on the parts of a span.
type Curve = Vec<([f64; 2], Polynomial)>;

fn short(of: &RBig) -> RBig {
    RBig::of(of.to_double())
}

/// `v''` at a place.
fn bend(v: &[RBig], x: f64) -> RBig {
    at(&derivative(&derivative(v)), &RBig::of(x))
}

/// What a list of contacts says of a scene.
///
/// # Errors
///
/// Why it says nothing.
pub fn pair(scene: &Scene, contacts: &[Contact]) -> Result<Pair, Unsaid> {
    let beam = Beam::of(scene)?;
    let mut nodes = beam.nodes(contacts);
    let last = nodes.last().ok_or("a beam that nothing holds")?;
    if last.lies || nodes.windows(2).any(|pair| pair[1].x <= pair[0].x) {
        return Err("a list that is not in order");
    }
    // At a support that is level with the ground the beam is not steeper than the ground.
    for _ in 0..3 {
        beam.turn(&mut nodes)?;
        if !beam.follow(&mut nodes) {
            break;
        }
    }
    let (cells, is_lifted) = beam.cells(&nodes)?;
    let [upper, size] = beam.upper(&cells)?;
    Ok(Pair { upper, lower: beam.lower(&cells)?, size: size.to_double(), is_lifted })
}

impl Beam {
    fn nodes(&self, contacts: &[Contact]) -> Vec<Node> {
        let node = |x: f64, along: Option<bool>, lies: bool| Node { x, along, slope: RBig::ZERO, lies };
        let mut nodes: Vec<Node> = Vec::new();
        for &Contact { from, to, .. } in contacts {
            // Zones that share an end are one.
            if from < to && nodes.last().is_some_and(|last| last.x == from) {
                nodes.pop();
                nodes.push(node(to, Some(true), false));
            } else if from < to {
                nodes.extend([node(from, Some(false), true), node(to, Some(true), false)]);
            } else if self.support(from).is_none() {
                nodes.push(node(from, (!self.is_corner(from)).then_some(false), false));
            }
        }
        for support in &self.supports {
            let i = nodes.iter().position(|node| support.x <= node.x).unwrap_or(nodes.len());
            if nodes.get(i).is_none_or(|node| node.x != support.x) {
                let lies = 0 < i && nodes[i - 1].lies;
                nodes.insert(i, node(support.x, lies.then_some(false), lies));
            }
        }
        nodes
    }

    /// Whether the beam may turn where it touches: at an end, and where no side has the slope of the other.
    fn is_corner(&self, x: f64) -> bool {
        let [left, right] = [true, false].map(|left| self.side(x, left));
        x <= 0.0 || self.length <= x || left != right || left.is_some_and(|[g, _]| Some(g) != self.depth(x))
    }

    /// `v` and `v'` at a node.
    fn end(&self, node: &Node) -> Result<[RBig; 2], Unsaid> {
        let support = self.support(node.x);
        let level =
            support.map(|s| s.level.clone()).or_else(|| self.depth(node.x)).ok_or("a contact without ground")?;
        let built_in = support.and_then(|s| s.slope.clone());
        let along = node.along.and_then(|left| self.side(node.x, left)).map(|[_, slope]| slope);
        Ok([level, built_in.or(along).unwrap_or_else(|| node.slope.clone())])
    }

    /// What is between two places, by parts without a break.
    fn parts(&self, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let inside = self.breaks.iter().copied().filter(|x| from < *x && *x < to);
        let places: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
        places.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    /// The beam from `v, v', v'', v'''` at a place to another one, and what these are there.
    fn march(&self, [from, to]: [f64; 2], mut start: [RBig; 4]) -> (Curve, [RBig; 4]) {
        let mut curve = Curve::new();
        for ends in self.parts([from, to]) {
            let [v, slope, bend, third] = start;
            let near = RBig::of(ends[0]);
            let q = shifted(&self.load(ends), &near).into_iter().zip([24, 120]);
            let loaded = q.map(|(q, below)| q / (&self.stiffness * RBig::whole(below)));
            let local: Polynomial =
                [v, slope, bend / RBig::whole(2), third / RBig::whole(6)].into_iter().chain(loaded).collect();
            let v = shifted(&local, &(RBig::ZERO - near));
            let ([a, b], [c, d]) = (jet(&v, ends[1]), jet(&derivative(&derivative(&v)), ends[1]));
            let force = if ends[1] < to { self.point_load(ends[1]) / &self.stiffness } else { RBig::ZERO };
            start = [a, b, c, d + force];
            curve.push((ends, v));
        }
        (curve, start)
    }

    /// The exact beam between two places from `v` and `v'` at both of them, or at the one that is no free end.
    fn span(&self, [from, to]: [f64; 2], ends: [Option<[RBig; 2]>; 2]) -> Curve {
        let (zero, two, six, twelve) = (|| RBig::ZERO, RBig::whole(2), RBig::whole(6), RBig::whole(12));
        let l = RBig::of(to) - RBig::of(from);
        let tip = |x: f64| self.point_load(x) / &self.stiffness;
        let start = match ends {
            [Some([v, slope]), right] => {
                let (_, [e, f, g, h]) = self.march([from, to], [v.clone(), slope.clone(), zero(), zero()]);
                let (bend, third) = if let Some([w, end]) = right {
                    let (rise, turn) = (w - e, end - f);
                    let bend = (&six * &rise / &l - &two * &turn) / &l;
                    (bend, (&six * &l * &turn - &twelve * &rise) / (&l * &l * &l))
                } else {
                    let third = zero() - h - tip(to);
                    (zero() - g - &third * &l, third)
                };
                [v, slope, bend, third]
            }
            [None, right] => {
                let [w, end] = right.unwrap_or([RBig::ZERO, RBig::ZERO]);
                let (_, [e, f, ..]) = self.march([from, to], [zero(), zero(), zero(), tip(from)]);
                let slope = end - f;
                [w - e - &slope * &l, slope, zero(), tip(from)]
            }
        };
        self.march([from, to], start).0
    }

    /// The span on the left of node `i`; none where the beam lies on the ground, and where there is no beam.
    fn hangs(&self, nodes: &[Node], i: usize) -> Result<Option<Curve>, Unsaid> {
        let ends = [i.checked_sub(1).map(|i| &nodes[i]), nodes.get(i)];
        let places = [ends[0].map_or(0.0, |node| node.x), ends[1].map_or(self.length, |node| node.x)];
        if places[1] <= places[0] || ends[0].is_some_and(|node| node.lies) {
            return Ok(None);
        }
        let [left, right] = ends.map(|node| node.map(|node| self.end(node)).transpose());
        Ok(Some(self.span(places, [left?, right?])))
    }

    /// The slopes at which `v''` is the same on both sides: a system with three diagonals.
    fn turn(&self, nodes: &mut [Node]) -> Result<(), Unsaid> {
        let free: Vec<bool> = nodes
            .iter()
            .map(|node| node.along.is_none() && self.support(node.x).is_none_or(|s| s.slope.is_none()))
            .collect();
        for (node, _) in nodes.iter_mut().zip(&free).filter(|(_, free)| **free) {
            node.slope = RBig::ZERO;
        }
        let row = |free: &bool| [RBig::ZERO, if *free { RBig::ZERO } else { RBig::ONE }, RBig::ZERO, RBig::ZERO];
        let mut rows: Vec<[RBig; 4]> = free.iter().map(row).collect();
        for i in 0..=nodes.len() {
            let Some(curve) = self.hangs(nodes, i)? else { continue };
            let both = 0 < i && i < nodes.len();
            let ends = [curve[0].0[0], curve[curve.len() - 1].0[1]];
            let stiff = if both { RBig::whole(2) / (RBig::of(ends[1]) - RBig::of(ends[0])) } else { RBig::ZERO };
            if 0 < i && free[i - 1] {
                let row = &mut rows[i - 1];
                row[1] += RBig::whole(2) * &stiff;
                row[2] += &stiff;
                row[3] += bend(&curve[0].1, ends[0]);
            }
            if i < nodes.len() && free[i] {
                rows[i][0] += &stiff;
                rows[i][1] += RBig::whole(2) * &stiff;
                rows[i][3] -= bend(&curve[curve.len() - 1].1, ends[1]);
            }
        }
        for i in 0..rows.len() {
            if rows[i][1].is_zero() {
                return Err("a beam that may turn");
            }
            if let [.., above, own] = &mut rows[..=i]
                && !own[0].is_zero()
            {
                let factor = &own[0] / &above[1];
                own[1] -= &factor * &above[2];
                own[3] -= &factor * &above[3];
            }
        }
        let mut next = RBig::ZERO;
        for (i, row) in rows.iter().enumerate().rev() {
            next = (&row[3] - &row[2] * next) / &row[1];
            if free[i] {
                nodes[i].slope = short(&next);
            }
        }
        Ok(())
    }

    /// Puts the beam along ground that begins at a support, where it would be steeper or as steep but for rounding. True if it does.
    fn follow(&self, nodes: &mut [Node]) -> bool {
        let mut changed = false;
        for i in 0..nodes.len() {
            let beside_zone = nodes[i].lies || (0 < i && nodes[i - 1].lies);
            let node = &mut nodes[i];
            let Some(support) =
                self.support(node.x).filter(|s| s.slope.is_none() && node.along.is_none() && !beside_zone)
            else {
                continue;
            };
            for left in [true, false].into_iter().filter(|left| support.tangent[usize::from(!left)]) {
                let Some([_, ground]) = self.side(node.x, left) else { continue };
                let steeper = if left { &ground - &node.slope } else { &node.slope - &ground };
                if RBig::of(-1e-12) * (ground.magnitude() + node.slope.magnitude()) <= steeper {
                    node.along = Some(left);
                    changed = true;
                }
            }
        }
        changed
    }

    /// `M` on both sides of node `i`, of the spans and zones beside it.
    fn moments(&self, nodes: &[Node], spans: &[Option<Curve>], i: usize) -> Result<[RBig; 2], Unsaid> {
        let x = nodes[i].x;
        let outside = [i == 0, i + 1 == nodes.len()];
        let mut own = [RBig::ZERO, RBig::ZERO];
        for side in [0, 1] {
            let v = match &spans[i + side] {
                Some(span) => if side == 0 { span.last() } else { span.first() }.map(|(_, v)| v.clone()),
                None if outside[side] => continue,
                None => self.gap(self.beside(x, side == 0)),
            };
            own[side] = RBig::ZERO - &self.stiffness * bend(&v.ok_or("a zone without ground")?, x);
        }
        let given = [0, 1].map(|side| outside[side] || spans[i + side].is_none());
        if given == [true; 2] || self.support(x).is_some_and(|s| s.slope.is_some() || nodes[i].along.is_some()) {
            return Ok(own);
        }
        let one = match given {
            [true, _] => own[0].clone(),
            [_, true] => own[1].clone(),
            _ => short(&((&own[0] + &own[1]) / RBig::whole(2))),
        };
        Ok([one.clone(), one])
    }

    fn cells(&self, nodes: &[Node]) -> Result<(Vec<Cell>, bool), Unsaid> {
        let spans: Vec<Option<Curve>> = (0..=nodes.len()).map(|i| self.hangs(nodes, i)).collect::<Result<_, _>>()?;
        let moments: Vec<[RBig; 2]> =
            (0..nodes.len()).map(|i| self.moments(nodes, &spans, i)).collect::<Result<_, _>>()?;
        let (mut cells, mut is_lifted) = (Vec::new(), false);
        let minus = RBig::ZERO - &self.stiffness;
        for (i, span) in spans.iter().enumerate() {
            let Some(span) = span else {
                let zone = nodes.get(i).filter(|_| 0 < i).map(|end| self.parts([nodes[i - 1].x, end.x]));
                for ends in zone.into_iter().flatten() {
                    let v = self.gap(ends).ok_or("a zone without ground")?;
                    let moment = product(std::slice::from_ref(&minus), &derivative(&derivative(&v)));
                    cells.push(Cell { ends, v, moment });
                }
                continue;
            };
            let ends = [span[0].0[0], span[span.len() - 1].0[1]];
            let side =
                |i: Option<usize>, side: usize| i.and_then(|i| moments.get(i)).map_or(RBig::ZERO, |m| m[side].clone());
            // EI v'' + M is linear.
            let r = [
                &self.stiffness * bend(&span[0].1, ends[0]) + side(i.checked_sub(1), 1),
                &self.stiffness * bend(&span[span.len() - 1].1, ends[1]) + side(Some(i), 0),
            ];
            let slope = (&r[1] - &r[0]) / (RBig::of(ends[1]) - RBig::of(ends[0]));
            let misfit = [&r[0] - &slope * RBig::of(ends[0]), slope];
            let of = |(ends, v): &([f64; 2], Polynomial)| {
                let moment = plus(&misfit, &minus, &derivative(&derivative(v)));
                Cell { ends: *ends, v: v.clone(), moment }
            };
            let (lifted, lift) = self
                .lifted(span.iter().map(of).collect(), [i.checked_sub(1).and_then(|i| nodes.get(i)), nodes.get(i)])?;
            is_lifted |= lift;
            cells.extend(lifted);
        }
        Ok((cells, is_lifted))
    }

    /// A span less `α φ`, `φ = (s/L)^a (1 − s/L)^b`, with the least `α` of some sizes that puts it above the ground.
    fn lifted(&self, cells: Vec<Cell>, ends: [Option<&Node>; 2]) -> Result<(Vec<Cell>, bool), Unsaid> {
        let places = [cells[0].ends[0], cells[cells.len() - 1].ends[1]];
        let [from, to] = places.map(RBig::of);
        let l = &to - &from;
        let power = |node: Option<&Node>| {
            let Some(node) = node else { return 0 };
            let ends = node.x <= 0.0 || self.length <= node.x;
            let turns = node.along.is_none() && self.support(node.x).is_none_or(|s| s.slope.is_none());
            if ends && turns { 1 } else { 2 }
        };
        let mut shape = vec![RBig::ONE];
        for (end, line) in
            [[RBig::ZERO - &from / &l, RBig::ONE / &l], [&to / &l, RBig::whole(-1) / &l]].iter().enumerate()
        {
            (0..power(ends[end])).for_each(|_| shape = product(&shape, line));
        }
        let size = cells.iter().flat_map(|cell| cell.ends.map(|x| jet(&cell.v, x)));
        let size = size.map(|[v, slope]| v.magnitude() + slope.magnitude() * &l).max().unwrap_or(RBig::ZERO);
        let lifted = |power: i32| -> Vec<Cell> {
            let by = short(&size) * RBig::of(-f64::from(power).exp2());
            cells.iter().map(|cell| Cell { v: plus(&cell.v, &by, &shape), ..cell.clone() }).collect()
        };
        if cells.iter().all(|cell| self.is_clear(cell)) {
            return Ok((cells, false));
        }
        // Of the size of rounding at first, and then back to the least of those.
        let is_enough = |power: &i32| lifted(*power).iter().all(|cell| self.is_clear(cell));
        if let Some(enough) = (-56..=4).step_by(4).find(is_enough) {
            let least = (enough - 3..enough).find(is_enough).unwrap_or(enough);
            return Ok((lifted(least), true));
        }
        Err("a deflection that no lift brings out of the ground")
    }
}
