//! From nodes to cells: the beam in its spans, on rigid ground and in ground that gives, with moments that are in equilibrium.

#![expect(clippy::float_cmp, reason = "a place is the same number wherever it is given")]

use dashu_ratio::RBig;

use super::contact_nodes::{HoldingNode, Part};
use super::equilibrium::{Equilibrium, without_pull};
use super::given::Given;
use super::polynomial::{
    Polynomial, at, between, derivative, exactly, is_nowhere_negative, jet, magnitude, plus, product, shifted, short,
};
use super::span::{Span, width};
use super::{Cell, Fields, Unproven};

/// What `size` is lifted by, from the share of rounding to some times itself, in powers of two: coarse steps first.
const LIFTS: std::ops::RangeInclusive<i32> = -56..=4;
/// Coarse steps of these powers.
const STEP: i32 = 4;

fn second(p: &[RBig]) -> Polynomial {
    derivative(&derivative(p))
}

/// The least of a few amounts of `size` that is enough; none if none is.
fn least_lift(size: &RBig, is_enough: impl Fn(&RBig) -> bool) -> Option<RBig> {
    let by = |power: i32| short(size) * exactly(libm::exp2(f64::from(power)));
    let enough = LIFTS.step_by(4).find(|power| is_enough(&by(*power)))?;
    (enough - STEP + 1..=enough).map(by).find(is_enough)
}

/// A cell, of a part without a break that is known in 64 bits.
fn cell(ends: [f64; 2], deflection: Polynomial, moment: Polynomial, pressed: bool) -> Cell {
    Cell { ends: ends.map(exactly), deflection, moment, pressed }
}

/// Nodes with all that is known of spans and moments, `T = M + N v`.
struct Assembly<'a> {
    given: &'a Given,
    nodes: &'a [HoldingNode],
    spans: &'a [Option<Span>],
    moments: Vec<[RBig; 2]>,
    /// `T` on the parts of each span.
    hanging: Vec<Vec<Polynomial>>,
}

impl Given {
    /// Whether a span is nowhere in the ground.
    fn is_above(&self, curve: &[([f64; 2], Polynomial)]) -> bool {
        curve.iter().all(|(part, v)| self.is_clear(*part, v))
    }

    /// Span `i` less `α s^a (L − s)^b`, with the least `α` of some sizes that puts it above the ground; [`None`] where it is above, and
    /// where none is enough. Moments are chosen after it: under an axial force they hang on the deflection.
    fn lifted(
        &self,
        nodes: &[HoldingNode],
        i: usize,
        span: &[([f64; 2], Polynomial)],
    ) -> Option<Vec<([f64; 2], Polynomial)>> {
        if self.is_above(span) {
            return None;
        }
        let ends = [span[0].0[0], span[span.len() - 1].0[1]];
        let power = |node: Option<&HoldingNode>| {
            let Some(node) = node else { return 0 };
            let at_end = node.x <= 0.0 || self.length <= node.x;
            let turns = node.along.is_none()
                && node.pressed.is_none()
                && self.support(node.x).is_none_or(|s| s.slope.is_none());
            if at_end && turns { 1 } else { 2 }
        };
        let powers = [power(i.checked_sub(1).and_then(|i| nodes.get(i))), power(nodes.get(i))];
        let l = width(ends);
        let shape = |part: [f64; 2]| {
            let offset = width([ends[0], part[0]]);
            let lines = [[offset.clone(), RBig::ONE], [&l - offset, -RBig::ONE]];
            let factors = powers.iter().zip(&lines).flat_map(|(power, line)| (0..*power).map(move |_| line));
            factors.fold(vec![RBig::ONE], |product_so_far, line| product(&product_so_far, line))
        };
        let sizes = span.iter().flat_map(|(part, v)| [jet(v, &RBig::ZERO), jet(v, &width(*part))]);
        let size = sizes.map(|[v, slope]| magnitude(&v) + magnitude(&slope) * &l).max().unwrap_or(RBig::ZERO);
        let size = (0..powers[0] + powers[1]).fold(size, |size, _| size / &l);
        let lifted = |by: &RBig| -> Vec<([f64; 2], Polynomial)> {
            span.iter().map(|(part, v)| (*part, plus(v, &-by, &shape(*part)))).collect()
        };
        least_lift(&size, |by| self.is_above(&lifted(by))).map(|by| lifted(&by))
    }

    /// The fields of nodes with their slopes.
    ///
    /// # Errors
    ///
    /// What is not admissible, as [`Unproven`] has it.
    pub(super) fn assembled(&self, nodes: &[HoldingNode]) -> Result<Fields, Unproven> {
        let mut spans = (0..=nodes.len()).map(|i| self.span(nodes, i)).collect::<Result<Vec<_>, _>>()?;
        let mut is_lifted = false;
        for (i, span) in spans.iter_mut().enumerate().filter_map(|(i, span)| Some((i, span.as_mut()?))) {
            if let Some(curve) = self.lifted(nodes, i, &span.curve) {
                (span.curve, is_lifted) = (curve, true);
            }
        }
        let equilibrium = Equilibrium { given: self, nodes, spans: &spans };
        let chosen = equilibrium.corrected(equilibrium.near()?)?;
        let hanging = (0..spans.len()).map(|i| equilibrium.moments(i, &chosen).0).collect();
        let moved: Vec<_> = (0..spans.len()).map(|i| equilibrium.moved(i, &chosen)).collect();
        for (span, curve) in spans.iter_mut().zip(moved).filter_map(|(span, curve)| Some((span.as_mut()?, curve?))) {
            span.curve = curve;
        }
        let assembly = Assembly { given: self, nodes, spans: &spans, moments: chosen.nodes, hanging };
        let mut cells = Vec::new();
        for (i, span) in spans.iter().enumerate() {
            if span.is_some() {
                let (clear, touches) = assembly.clear_cells(i)?;
                is_lifted |= touches;
                cells.extend(clear);
            } else if 0 < i && i < nodes.len() {
                cells.extend(match &nodes[i - 1].right {
                    Part::Pressed(sunk) => vec![assembly.pressed(i, sunk)?],
                    _ => assembly.zone(i)?,
                });
            }
        }
        let mut cells = self.in_equilibrium(cells)?;
        for cell in &mut cells {
            cell.moment = without_pull(&cell.moment, &self.tension, &cell.deflection);
        }
        Ok(Fields { cells, is_lifted })
    }

    /// The cells, if forces and couples between them are such as ground and supports exert. Where ground begins at a support in the
    /// direction of the beam it exerts a couple with it: a force that is far nearer than rounding.
    fn in_equilibrium(&self, mut cells: Vec<Cell>) -> Result<Vec<Cell>, Unproven> {
        let mut coupled = Vec::new();
        for k in 0..=cells.len() {
            let [left, right] = [k.checked_sub(1).map(|k| &cells[k]), cells.get(k)];
            let x = left.map_or(0.0, |cell| cell.ends[1].to_f64().value());
            let before = left.map(|cell| (cell, &cell.ends[1] - &cell.ends[0]));
            let jets = |of: fn(&Cell) -> &Polynomial| {
                [before.as_ref().map(|(cell, l)| jet(of(cell), l)), right.map(|cell| jet(of(cell), &RBig::ZERO))]
            };
            if let [Some(v), Some(w)] = jets(|cell| &cell.deflection)
                && (v[0] != w[0] || v[1] != w[1] && self.joint(x).is_none())
            {
                return Err(Unproven::Kink { at: x });
            }
            let ends = jets(|cell| &cell.deflection);
            let pull = ends.into_iter().flatten().next().map_or(RBig::ZERO, |[v, _]| &self.tension * v);
            let [m, n] = jets(|cell| &cell.moment).map(|m| m.unwrap_or_else(|| [pull.clone(), RBig::ZERO]));
            let [load, turn] = self.acting(x);
            let (force, couple) = (&n[1] - &m[1] + load, &n[0] - &m[0] - turn);
            let support = self.support(x);
            let spring = self.elastic.iter().any(|spring| spring.x == x);
            let is_held = spring || support.is_some_and(|s| !s.pushes_only);
            if !is_held && (force < RBig::ZERO || !force.is_zero() && self.depth(x).is_none()) {
                return Err(Unproven::Tension { at: x });
            }
            if !couple.is_zero() && self.turning(x).is_none() && support.is_none_or(|s| s.slope.is_none()) {
                let on_left = RBig::ZERO < couple;
                let Some(below) = support
                    .filter(|support| support.tangent[usize::from(!on_left)])
                    .and_then(|support| Some(&self.side(x, on_left)?[0] - &support.level))
                else {
                    return Err(Unproven::Couple { at: x });
                };
                coupled.push((k, couple, below));
            }
        }
        for (k, couple, below) in coupled.into_iter().rev() {
            let i = if RBig::ZERO < couple { k - 1 } else { k };
            let arm = self.arm(&cells[i], &couple, &below);
            let parts = beside(&cells[i], couple, &arm);
            cells.splice(i..=i, parts);
        }
        Ok(cells)
    }

    /// How far from a support the force is that makes a couple `T` with it. The duality gap has `T²a/2EI` of the moment over the arm `a`,
    /// and `T/a` times what the ground is below the support by rounding.
    fn arm(&self, cell: &Cell, couple: &RBig, below: &RBig) -> RBig {
        /// Of the cell: far less than rounding.
        const LEAST: f64 = f64::EPSILON * f64::EPSILON;
        let width = &cell.ends[1] - &cell.ends[0];
        let stiffness = self.bending([0, 1].map(|end| cell.ends[end].to_f64().value()));
        let best = libm::sqrt((RBig::from(2) * below * stiffness / magnitude(couple)).to_f64().value());
        exactly(best).max(&width * exactly(LEAST)).min(width / RBig::from(2))
    }
}

/// A cell in two, with a moment that goes over to that behind the support at its end: at its right end for a positive couple.
fn beside(cell: &Cell, couple: RBig, arm: &RBig) -> [Cell; 2] {
    let [from, to] = &cell.ends;
    let (at_end, rise) = (RBig::ZERO < couple, &couple / arm);
    let place = if at_end { to - arm } else { from + arm };
    let step = if at_end { vec![RBig::ZERO, rise] } else { vec![-couple, rise] };
    let [first, second] = [[from, &place], [&place, to]].map(|[a, b]| Cell {
        ends: [a.clone(), b.clone()],
        deflection: shifted(&cell.deflection, &(a - from)),
        moment: shifted(&cell.moment, &(a - from)),
        pressed: cell.pressed,
    });
    let turned = |part: Cell| Cell { moment: plus(&part.moment, &RBig::ONE, &step), ..part };
    if at_end { [first, turned(second)] } else { [turned(first), second] }
}

impl Assembly<'_> {
    /// The cells of span `i`.
    fn hanging_cells(&self, i: usize) -> Vec<Cell> {
        let Some(span) = &self.spans[i] else { return Vec::new() };
        let of =
            |((part, v), moment): (&([f64; 2], Polynomial), &Polynomial)| cell(*part, v.clone(), moment.clone(), false);
        span.curve.iter().zip(&self.hanging[i]).map(of).collect()
    }

    /// The cells of span `i`, and whether ends of it count as pressed.
    fn clear_cells(&self, i: usize) -> Result<(Vec<Cell>, bool), Unproven> {
        let cells = self.hanging_cells(i);
        let Some(Span { curve, .. }) = &self.spans[i] else { return Ok((cells, false)) };
        if self.given.is_above(curve) {
            return Ok((cells, false));
        }
        let ends = [curve[0].0[0], curve[curve.len() - 1].0[1]];
        Ok((self.touching(curve, &cells).ok_or(Unproven::InGround { ends })?, true))
    }

    /// On ground that gives, a span whose ends may be below the surface by rounding: there they count as pressed, without a pressure.
    fn touching(&self, span: &[([f64; 2], Polynomial)], cells: &[Cell]) -> Option<Vec<Cell>> {
        /// Of the first and the last part of a span, in powers of two: from the shortest that a place of 64 bits can tell.
        const SHARES: [i32; 4] = [-40, -30, -20, -12];
        let given = self.given;
        if !given.is_on_soil() {
            return None;
        }
        let last = span.len() - 1;
        SHARES.into_iter().find_map(|share| {
            let inner = |i: usize| {
                let [from, to] = span[i].0;
                let by = (to - from) * libm::exp2(f64::from(share));
                [if i == 0 { from + by } else { from }, if i == last { to - by } else { to }]
            };
            let mut parts = Vec::new();
            for (i, (cell, (part, _))) in cells.iter().zip(span).enumerate() {
                let inner = inner(i);
                for ends in
                    [[part[0], inner[0]], inner, [inner[1], part[1]]].into_iter().filter(|ends| ends[0] < ends[1])
                {
                    let by = width([part[0], ends[0]]);
                    let [deflection, moment] = [&cell.deflection, &cell.moment].map(|p| shifted(p, &by));
                    if ends == inner && !given.is_clear(ends, &deflection) {
                        return None;
                    }
                    parts.push(Cell { ends: ends.map(exactly), deflection, moment, pressed: ends != inner });
                }
            }
            Some(parts)
        })
    }

    /// `v` and `v'` at the places of a zone that its ends and the breaks in it are: those of the ground, but at a kink by rounding, where the
    /// beam has the slope between and is so much above the ground that a cubic does not reach it.
    fn places(&self, nodes: &[HoldingNode], parts: &[[f64; 2]]) -> Result<Vec<[RBig; 2]>, Unproven> {
        let given = self.given;
        let mut places = vec![given.end(&nodes[0], 1)?];
        for two in parts.windows(2) {
            let x = two[0][1];
            let (Some([g, before]), Some([_, behind])) = (given.side(x, true), given.side(x, false)) else {
                return Err(Unproven::Place { at: x });
            };
            let kink = magnitude(&(&behind - &before));
            let l = width(two[0]).max(width(two[1]));
            places.push([g - kink * l, (before + behind) / RBig::from(2)]);
        }
        places.push(given.end(&nodes[1], 0)?);
        Ok(places)
    }

    /// The cells of the zone on the left of node `i`: `v = g`, but for what rounding does to supports and kinks.
    fn zone(&self, i: usize) -> Result<Vec<Cell>, Unproven> {
        let (given, nodes) = (self.given, &self.nodes[i - 1..=i]);
        let parts = given.parts([nodes[0].x, nodes[1].x], false);
        let places = self.places(nodes, &parts)?;
        let mut cells = Vec::new();
        for (part, ends) in parts.iter().zip(places.windows(2)) {
            let (gap, l) = (given.gap(*part).ok_or(Unproven::Place { at: part[0] })?, width(*part));
            let places = [RBig::ZERO, l.clone()];
            let with = |p: Polynomial, ends: &[[RBig; 2]; 2]| match ends.iter().flatten().all(RBig::is_zero) {
                true => p,
                false => plus(&p, &RBig::ONE, &between([&ends[0], &ends[1]], &[], &l)),
            };
            let above = [0, 1].map(|side| {
                let ([v, slope], [g, turn]) = (&ends[side], jet(&gap, &places[side]));
                [v - g, slope - turn]
            });
            let bent: Polynomial = second(&gap).iter().map(|c| -given.bending(*part) * c).collect();
            let v = with(gap, &above);
            let own = without_pull(&bent, &-&given.tension, &v);
            let mut more = [(); 2].map(|()| [RBig::ZERO, RBig::ZERO]);
            for (side, _) in nodes.iter().enumerate().filter(|(side, node)| node.x == part[*side]) {
                more[side][0] = &self.moments[i - 1 + side][1 - side] - at(&own, &places[side]);
            }
            let moment = with(own, &more);
            if !given.is_clear(*part, &v) {
                return Err(Unproven::InGround { ends: *part });
            }
            if !self.presses(*part, &moment) {
                return Err(Unproven::Tension { at: part[0] });
            }
            cells.push(cell(*part, v, moment, true));
        }
        Ok(cells)
    }

    /// Whether `p = M'' + q ≥ 0` on a part.
    fn presses(&self, part: [f64; 2], moment: &[RBig]) -> bool {
        let pressure = plus(&second(moment), &RBig::ONE, &self.given.load(part));
        is_nowhere_negative(&pressure, &width(part))
    }

    /// `M'` at node `i` of a part that is pressed into ground that gives, on the right of the node or on its left.
    fn shear(&self, i: usize, on_right: bool) -> RBig {
        let (node, load) = (&self.nodes[i], self.given.point_load(self.nodes[i].x));
        let is_held = self.given.elastic.iter().any(|spring| spring.x == node.x);
        let own = |side: usize| node.pressed.as_ref().map_or(RBig::ZERO, |end| end.shear[side].clone());
        if is_held || self.given.support(node.x).is_some() {
            return own(usize::from(on_right));
        }
        // Nothing takes a force: on the right there is that of the left less the load.
        let less = |left: RBig| left - &load;
        let is_end = [node.x <= 0.0, self.given.length <= node.x];
        match (on_right, is_end) {
            (true, [true, _]) => less(RBig::ZERO),
            (false, [_, true]) => load.clone(),
            (true, _) if self.spans[i].is_some() => {
                let cells = self.hanging_cells(i);
                cells.last().map_or(RBig::ZERO, |c| less(jet(&c.moment, &(&c.ends[1] - &c.ends[0]))[1].clone()))
            }
            (false, _) if self.spans[i + 1].is_some() => {
                self.hanging_cells(i + 1).first().map_or(RBig::ZERO, |c| jet(&c.moment, &RBig::ZERO)[1].clone() + &load)
            }
            (true, _) => less(own(0)),
            (false, _) => own(0),
        }
    }

    /// The cell on the left of node `i`, pressed into ground that gives by about a polynomial. A little less moment in its middle makes
    /// a pressure that rounding has below zero at an end of it positive.
    fn pressed(&self, i: usize, sunk: &[RBig]) -> Result<Cell, Unproven> {
        let (given, [a, b]) = (self.given, [&self.nodes[i - 1], &self.nodes[i]]);
        let part = [a.x, b.x];
        // Where the ground goes on along a line, but for rounding, the beam follows its first part.
        let first = given.parts(part, false)[0];
        let (gap, l) = (given.gap(first).ok_or(Unproven::Place { at: a.x })?, width(part));
        let k = given.soil(part);
        let ends = [given.end(a, 1)?, given.end(b, 0)?];
        let below = [0, 1].map(|side| {
            let [g, turn] = jet(&gap, &if side == 0 { RBig::ZERO } else { l.clone() });
            [&ends[side][0] - g, &ends[side][1] - turn]
        });
        let tail = sunk.get(4..).unwrap_or_default();
        let deflection = plus(&gap, &RBig::ONE, &between([&below[0], &below[1]], tail, &l));
        // M'' = k (v − g) − q, from its fourth coefficient on.
        let load = given.load(part);
        let curved = (4..).zip(sunk.iter().skip(2)).map(|(j, c)| {
            let less = load.get(j - 2).cloned().unwrap_or(RBig::ZERO);
            short(&((&k * c - less) / RBig::from(j * (j - 1))))
        });
        let [m, n] =
            [[&self.moments[i - 1][1], &self.shear(i - 1, true)], [&self.moments[i][0], &self.shear(i, false)]]
                .map(|[m, shear]| [m.clone(), shear.clone()]);
        let moment = between([&m, &n], &curved.collect::<Vec<_>>(), &l);
        if self.presses(part, &moment) {
            return Ok(cell(part, deflection, moment, true));
        }
        let lines = [[RBig::ZERO, RBig::ONE], [l.clone(), -RBig::ONE]];
        let bubble = lines.iter().fold(vec![RBig::ONE], |p, line| product(&product(&p, line), line));
        let size = [jet(sunk, &RBig::ZERO), jet(sunk, &l)].map(|[w, turn]| magnitude(&w) + magnitude(&turn) * &l);
        let size = size.into_iter().max().unwrap_or(RBig::ZERO) * &k / (&l * &l);
        let raised = |by: &RBig| plus(&moment, by, &bubble);
        let by = least_lift(&size, |by| self.presses(part, &raised(by))).ok_or(Unproven::Tension { at: a.x })?;
        Ok(cell(part, deflection, raised(&by), true))
    }
}
