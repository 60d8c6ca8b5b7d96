//! From nodes to cells: the beam in its spans, on a rigid and in an elastic foundation, with moments in equilibrium.

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

/// Exponents of the powers of two of `size` by which a deflection is lifted, from the size of rounding to several times `size`.
/// Coarse steps come first.
const LIFTS: std::ops::RangeInclusive<i32> = -56..=4;
/// Increment of the exponent in a coarse step.
const STEP: i32 = 4;

fn second(p: &[RBig]) -> Polynomial {
    derivative(&derivative(p))
}

/// The smallest of these multiples of `size` that is enough; [`None`] if none is.
fn least_lift(size: &RBig, is_enough: impl Fn(&RBig) -> bool) -> Option<RBig> {
    let by = |power: i32| short(size) * exactly(libm::exp2(f64::from(power)));
    let enough = LIFTS.step_by(4).find(|power| is_enough(&by(*power)))?;
    (enough - STEP + 1..=enough).map(by).find(is_enough)
}

/// A cell on a part without a break, whose ends are 64-bit numbers.
fn cell(ends: [f64; 2], deflection: Polynomial, moment: Polynomial, pressed: bool) -> Cell {
    Cell { ends: ends.map(exactly), deflection, moment, pressed }
}

/// Nodes with everything known about spans and moments, `T = M + N v`.
struct Assembly<'a> {
    given: &'a Given,
    nodes: &'a [HoldingNode],
    spans: &'a [Option<Span>],
    moments: Vec<[RBig; 2]>,
    /// `T` on the parts of each span.
    hanging: Vec<Vec<Polynomial>>,
}

impl Given {
    /// Whether a span is nowhere below the surface of the foundation.
    fn is_above(&self, curve: &[([f64; 2], Polynomial)]) -> bool {
        curve.iter().all(|(part, v)| self.is_clear(*part, v))
    }

    /// Span `i` less `α s^a (L − s)^b`, with the smallest `α` of some sizes that lifts it out of the foundation. [`None`] if it is
    /// not in the foundation, or if no `α` is enough. Moments are chosen afterwards, because under an axial force they depend on the
    /// deflection.
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

    /// The fields for nodes with known slopes.
    ///
    /// # Errors
    ///
    /// [`Unproven`] with whatever is not admissible.
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
        let moved: Vec<_> = (0..spans.len()).map(|i| equilibrium.with_chosen(i, &chosen)).collect();
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

    /// The cells, if foundation and supports can exert the forces and couples between them. If the foundation begins at a support in
    /// the direction of the beam, the foundation can exert a couple together with the support. Its force is then at a distance far
    /// below rounding.
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
                    .and_then(|support| Some(&self.gap_beside(x, on_left)?[0] - &support.level))
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

    /// The distance from a support of the force that forms a couple `T` with it. The duality gap contains `T²a/2EI` from the moment
    /// over the arm `a`, and `T/a` times the distance by which the foundation is below the support by rounding.
    fn arm(&self, cell: &Cell, couple: &RBig, below: &RBig) -> RBig {
        /// As a fraction of the cell: far below rounding.
        const LEAST: f64 = f64::EPSILON * f64::EPSILON;
        let width = &cell.ends[1] - &cell.ends[0];
        let stiffness = self.bending([0, 1].map(|end| cell.ends[end].to_f64().value()));
        let best = libm::sqrt((RBig::from(2) * below * stiffness / magnitude(couple)).to_f64().value());
        exactly(best).max(&width * exactly(LEAST)).min(width / RBig::from(2))
    }
}

/// Splits a cell, so that near one end its moment changes to the moment behind the support there. This is the right end for a
/// positive couple.
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

    /// The cells of span `i`, and whether its ends count as pressed.
    fn clear_cells(&self, i: usize) -> Result<(Vec<Cell>, bool), Unproven> {
        let cells = self.hanging_cells(i);
        let Some(Span { curve, .. }) = &self.spans[i] else { return Ok((cells, false)) };
        if self.given.is_above(curve) {
            return Ok((cells, false));
        }
        let ends = [curve[0].0[0], curve[curve.len() - 1].0[1]];
        Ok((self.touching(curve, &cells).ok_or(Unproven::InGround { ends })?, true))
    }

    /// On an elastic foundation the ends of a span may be below the surface by rounding. There they count as pressed, with zero pressure.
    fn touching(&self, span: &[([f64; 2], Polynomial)], cells: &[Cell]) -> Option<Vec<Cell>> {
        /// Fractions of the first and the last part of a span, as exponents of two, beginning with the shortest part that 64-bit
        /// positions can resolve.
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

    /// `v` and `v'` at the ends of a zone and at the breaks in it. They are those of the foundation, except at a kink by rounding.
    /// There the beam has the mean slope, and is so far above the foundation that a cubic does not reach it.
    fn places(&self, nodes: &[HoldingNode], parts: &[[f64; 2]]) -> Result<Vec<[RBig; 2]>, Unproven> {
        let given = self.given;
        let mut places = vec![given.end(&nodes[0], 1)?];
        for two in parts.windows(2) {
            let x = two[0][1];
            let (Some([g, before]), Some([_, behind])) = (given.gap_beside(x, true), given.gap_beside(x, false)) else {
                return Err(Unproven::Place { at: x });
            };
            let kink = magnitude(&(&behind - &before));
            let l = width(two[0]).max(width(two[1]));
            places.push([g - kink * l, (before + behind) / RBig::from(2)]);
        }
        places.push(given.end(&nodes[1], 0)?);
        Ok(places)
    }

    /// The cells of the zone to the left of node `i`: `v = g`, except for the effects of rounding at supports and kinks.
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

    /// `M'` at node `i` of a part that is pressed into an elastic foundation, to the right or to the left of the node.
    fn shear(&self, i: usize, on_right: bool) -> RBig {
        let (node, load) = (&self.nodes[i], self.given.point_load(self.nodes[i].x));
        let is_held = self.given.elastic.iter().any(|spring| spring.x == node.x);
        let own = |side: usize| node.pressed.as_ref().map_or(RBig::ZERO, |end| end.shear[side].clone());
        if is_held || self.given.support(node.x).is_some() {
            return own(usize::from(on_right));
        }
        // No force can act here, so `M'` on the right is that on the left less the load.
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

    /// The cell to the left of node `i`, pressed into an elastic foundation by approximately a polynomial. If rounding makes the
    /// pressure negative at an end, a little more moment in the middle makes it positive.
    fn pressed(&self, i: usize, sunk: &[RBig]) -> Result<Cell, Unproven> {
        let (given, [a, b]) = (self.given, [&self.nodes[i - 1], &self.nodes[i]]);
        let part = [a.x, b.x];
        // Where the foundation continues along a line up to rounding, the beam follows its first part.
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
