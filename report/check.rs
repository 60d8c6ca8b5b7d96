//! # A proof that anybody can check
//! A beam with loads `q`, point loads `P` and couples `C` has ground at the gap `g` below it. Of all deflections that supports and ground
//! admit, its deflection `v*` has the least potential energy `J*`. Two fields enclose `J*`: any admissible deflection `v`, and any moments
//! `M` in equilibrium with the loads and with contact forces that only press.
//! ```text
//! p = M'' + q + N v''      contact pressure: not negative, and zero where there is no ground
//! F = [M'] + N [v'] + P    force of a place on the beam, upwards: not negative, except at a support. [f] is right less left
//! T = [M] − C              couple of a place on the beam; M = M' = 0 beyond the ends of the beam
//! J = ½∫EI v''² + ½∫N v'² − ∫q v − ΣP v − ΣC v' + ½Σk (v − d)² + ½Σk (v' − φ)² + ½Σk [v']² + ½∫k (v − g)²
//! D = −½∫M²/EI − ½∫N v'² − ∫g p − ΣF d + ΣT φ − ½ΣF²/k − ½ΣT²/k − ½ΣM²/k − ½∫p²/k
//! D ≤ J* ≤ J,      |v − v*| ≤ √(2 (J − D) c)      c: deflection under a unit force
//! ```
//! A proof is JSON, `{"version": 1, "cells": [{"from", "to", "v", "moment", "pressed"}]}`: from left to right the coefficients of `v` and
//! `M` in powers of `x − from`, as strings. Where a cell is `pressed`, `v` may be below the surface of elastic ground.
#![allow(missing_docs, missing_debug_implementations, unreachable_pub, clippy::print_stdout, reason = "for readers")]
#![cfg_attr(rustfmt, rustfmt_skip)]
use std::{collections::{BTreeMap, BTreeSet}, ops::Bound::Excluded};
use dashu_ratio::RBig as Q;
use serde_json::{Value as Json, json};
type Result<T> = std::result::Result<T, String>;
/// ## Polynomials
/// Coefficients from the lowest on. A polynomial is nowhere negative from 0 to `l` if its Bernstein coefficients are not, on halves of
/// halves. Where 60 of these leave it open, the answer is no.
type Poly = Vec<Q>;
fn at(p: &[Q], x: &Q) -> Q { p.iter().rev().fold(Q::ZERO, |sum, c| sum * x + c) }
fn d(p: &[Q]) -> Poly { (1..).zip(p.iter().skip(1)).map(|(j, c)| c * Q::from(j)).collect() }
fn add(p: &[Q], k: &Q, q: &[Q]) -> Poly {
    let of = |p: &[Q], j: usize| p.get(j).cloned().unwrap_or(Q::ZERO);
    (0..p.len().max(q.len())).map(|j| of(p, j) + k * of(q, j)).collect()
}
fn shift(mut p: Poly, by: &Q) -> Poly { for i in 1..p.len() { for j in (i - 1..p.len() - 1).rev() { p[j] = &p[j] + by * &p[j + 1]; } } p }
fn integral(p: &[Q], q: &[Q], l: &Q) -> Q {
    let mut sum = vec![Q::ZERO; p.len() + q.len() + 1];
    for (i, a) in p.iter().enumerate() { for (j, b) in q.iter().enumerate() { sum[i + j + 1] += a * b; } }
    at(&sum.iter().enumerate().map(|(j, c)| c / Q::from(j.max(1))).collect::<Poly>(), l)
}
fn nonneg(p: &[Q], l: &Q) -> bool {
    let (mut share, mut form, n) = (Q::ONE, Poly::new(), p.len());
    for (j, c) in p.iter().enumerate() { form.push(c * &share); share = share * l * Q::from(j + 1) / Q::from((n - 1 - j).max(1)); }
    for j in (1..n).rev() { for k in j..n { form[k] = &form[k] + &form[k - 1]; } }
    halves(form, 60)
}
fn halves(mut form: Poly, left: usize) -> bool {
    if form.iter().all(|b| *b >= Q::ZERO) { return true; } else if left == 0 || form[0].clone().min(form[form.len() - 1].clone()) < Q::ZERO { return false; }
    let (mut first, two) = (vec![form[0].clone()], Q::from(2));
    for j in (1..form.len()).rev() { for k in 0..j { form[k] = (&form[k] + &form[k + 1]) / &two; } first.push(form[0].clone()); }
    halves(first, left - 1) && halves(form, left - 1)
}
/// ## The scene
/// As in its file. A number there is the fraction that its 64 bits are. A profile has a polynomial in `x` for each part of the beam. A step
/// of a polyline is a part without length, at the smaller depth.
type Profile = Vec<([Q; 2], Poly)>;
#[derive(Default)] pub struct Scene {
    l: Q, tension: Q, bending: Profile, shape: Profile, ground: Profile, springs: Profile, loads: Profile, supports: BTreeMap<Q, Json>,
    joints: BTreeMap<Q, Q>, points: BTreeMap<Q, Q>, couples: BTreeMap<Q, Q>, breaks: BTreeSet<Q>,
}
fn number(v: &Json) -> Result<Q> { v.as_i64().map(Q::from).or_else(|| Q::try_from(v.as_f64()?).ok()).ok_or(format!("{v} is no number")) }
fn positive(v: &Json) -> Result<Q> { number(v).and_then(|x| if x > Q::ZERO { Ok(x) } else { Err(format!("{v} is not positive")) }) }
fn or_zero(t: &Json, key: &str) -> Result<Q> { t.get(key).map_or(Ok(Q::ZERO), number) }
fn list(v: &Json) -> &[Json] { v.as_array().map_or(&[], Vec::as_slice) }
fn sums(all: &Json, what: &str) -> Result<BTreeMap<Q, Q>> {
    list(all).iter().try_fold(BTreeMap::new(), |mut sums, one| { *sums.entry(number(&one["at"])?).or_insert(Q::ZERO) += or_zero(one, what)?; Ok(sums) })
}
fn profile(t: &Json, l: &Q, file: &dyn Fn(&str) -> Result<String>) -> Result<Profile> {
    let numbers = |v: &Json| list(v).iter().map(number).collect::<Result<Poly>>();
    let mut points: Vec<Poly> = list(&t["points"]).iter().chain(list(&t["steps"])).map(numbers).collect::<Result<_>>()?;
    let one = Some(t.get("depth").unwrap_or(t)).filter(|one| one.is_number()).map(|one| Ok(vec![number(one)?]));
    if let Some(p) = one.or(t.get("polynomial").map(numbers)) { return Ok(vec![([Q::ZERO, l.clone()], p?)]); }
    if let Some(name) = t["survey"].as_str() {
        let (text, float) = (file(name)?, |x: &str| number(&x.trim().parse::<f64>().unwrap_or(f64::NAN).into()));
        let rows = text.lines().map(str::trim).filter(|row| !row.is_empty() && !row.starts_with('#')).skip(1);
        points = rows.map(|row| row.split(',').map(float).collect()).collect::<Result<_>>()?;
    }
    if points.is_empty() || points.iter().any(|p| p.len() != 2) || !points.is_sorted_by(|p, q| p[0] <= q[0]) {
        return Err(format!("no pairs from left to right, and nothing else for fractions: {t}"));
    }
    let line = |[x, u]: [&Q; 2], [y, w]: [&Q; 2]| match y - x {
        _ if t.get("steps").is_some() => ([x.clone(), y.clone()], vec![u.clone()]),
        run if run.is_zero() => ([x.clone(), y.clone()], vec![u.min(w).clone()]),
        run => ([x.clone(), y.clone()], vec![u - (w - u) / &run * x, (w - u) / run]),
    };
    if t.get("steps").is_some() { points.push(vec![l.clone(), Q::ZERO]); }
    Ok(points.windows(2).map(|p| line([&p[0][0], &p[0][1]], [&p[1][0], &p[1][1]])).collect())
}
fn on<'a>(profile: &'a Profile, [a, b]: [&Q; 2]) -> Option<&'a Poly> {
    profile.get(profile.partition_point(|(ends, _)| ends[1] < *b)).filter(|(ends, _)| ends[0] <= *a).map(|(_, p)| p)
}
impl Scene {
    /// From the text of a scene file; `file` reads a survey that it names.
    pub fn read(text: &str, file: &dyn Fn(&str) -> Result<String>) -> Result<Self> {
        let t: Json = toml::from_str(text).map_err(|e| e.to_string())?;
        let (beam, load, ground, l) = (&t["beam"], &t["load"], t.get("foundation"), number(&t["beam"]["length"])?);
        let part = |t: Option<&Json>| profile(t.unwrap_or(&json!(0)), &l, file);
        let mut s = Self { tension: or_zero(beam, "tension")?, joints: sums(&beam["joints"], "stiffness")?, ..Self::default() };
        (s.bending, s.shape, s.loads) = (part(beam.get("bending_stiffness"))?, part(beam.get("shape"))?, part(load.get("uniform"))?);
        if let Some(u) = ground { s.ground = part(ground)?; if let k @ Some(_) = u.get("stiffness") { s.springs = part(k)?; } }
        for one in list(beam.get("supports").unwrap_or(&json!([{"at": 0}, {"at": beam["length"]}]))) { s.supports.insert(number(&one["at"])?, one.clone()); }
        for q in list(&load["linear"]) { s.loads.extend(part(Some(&json!({"points": [[q["from"], q["start"]], [q["to"], q["end"]]]})))?); }
        (s.points, s.couples) = (sums(&load["point"], "force")?, sums(&load["couple"], "moment")?);
        let parts = [&s.bending, &s.shape, &s.ground, &s.springs, &s.loads].into_iter().flatten().flat_map(|(ends, _)| ends);
        let places = [&s.joints, &s.points, &s.couples].into_iter().flat_map(BTreeMap::keys).chain(s.supports.keys());
        Ok(Self { l, breaks: parts.chain(places).cloned().collect(), ..s })
    }
    fn least(&self) -> Q { self.bending.iter().filter_map(|(_, ei)| ei.first().cloned()).min().unwrap_or(Q::ZERO) }
    /// `ρ`: compression takes at most this share of the energy of the beam, which bears `N/ρ`.
    fn compressed(&self) -> Result<Q> {
        let (shares, stiff) = ([2, 10, 100].map(|n| Q::ONE - Q::ONE / Q::from(n)), |(_, k): &([Q; 2], Poly)| k.len() == 1 && k[0] >= Q::ZERO);
        let are_stiff = self.bending.iter().chain(&self.springs).all(stiff) && self.joints.values().all(|k| *k >= Q::ZERO);
        if self.least() <= Q::ZERO || !are_stiff { return Err("a stiffness is not positive".into()); } else if self.tension >= Q::ZERO { return Ok(Q::ZERO); }
        shares.into_iter().find(|share| self.bears(&(-&self.tension / share)).is_some()).ok_or("compression may buckle the beam".into())
    }
    /// It bears `n` if rigid links of length `h` do, which turn at springs of `2 (EI − n h²/π²)/h` at their ends (9.8 < π²). From left to
    /// right: the least energy `a v² + 2b v ψ + c ψ²` that `v` and the slope leave, rounded down. A rigid support is a stiff spring.
    fn bears(&self, n: &Q) -> Option<()> {
        let (rigid, mut at, mut form) = (Q::from(2).pow(200), Q::ZERO, [Q::ZERO, Q::ZERO, Q::ZERO]);
        let down = |[x, less]: [Q; 2]| (Q::from((x * &rigid).floor()) - less) / &rigid;
        let turn = |[a, b, c]: [Q; 3], k: &Q| Some(k + &c).filter(|d| *d > Q::ZERO).map(|d|
            [[a - b.sqr() / &d, Q::ONE], [b * k / &d, Q::ZERO], [c * k / d, Q::ONE]].map(down));
        if n * self.l.sqr() > self.least() * Q::from(100_000) { return None; }
        for x in self.breaks.range(Q::ZERO..=self.l.clone()) {
            let (ei, mut h) = (&on(&self.bending, [&at, x])?[0], x - &at);
            while h.sqr() * n * Q::from(256) > *ei { h /= Q::from(2); }
            while at < *x {
                let k = Q::from(2) * (ei / &h - n * &h * Q::from(10) / Q::from(98));
                let [a, b, c] = turn(form, &k)?;
                (form, at) = (turn([a.clone(), &b - &a * &h, c - (Q::from(2) * b - a * &h + n) * &h], &k)?, at + &h);
            }
            if let Some(t) = self.supports.get(x).filter(|t| t["pushes_only"] != true) {
                let k = |key: &str, held: bool| t.get(key).map_or(Ok(if held { rigid.clone() } else { Q::ZERO }), positive).ok();
                (form[0], form[2]) = (&form[0] + k("stiffness", true)?, &form[2] + k("turning_stiffness", t["built_in"] == true)?);
            }
            if let Some(k) = self.joints.get(x) { form = turn(form, k)?; }
        }
        (form[0] > Q::ZERO && &form[0] * &form[2] > form[1].sqr()).then_some(())
    }
    /// The error bound of `v`, with the largest `c` of a beam of the least `EI` on two rigid supports, or built in at one; none with joints.
    pub fn error(&self, [low, up]: &[Q; 2]) -> Option<f64> {
        let (l, rigid) = (&self.l, self.supports.iter().filter(|(_, t)| t["pushes_only"] != true && t.get("stiffness").is_none()));
        let over = |o: Q, span: &Q| o.sqr() * (span + o) / Q::from(3);
        let pairs = rigid.clone().flat_map(|(x, t)| rigid.clone().filter(move |(y, _)| x < *y || x == *y && t["built_in"] == true).map(move |(y, _)| [x, y]));
        let largest = pairs.map(|[x, y]| over(x.clone(), &(y - x)).max(over(l - y, &(y - x))).max((y - x).cubic() / Q::from(48)));
        let c = largest.min().filter(|_| self.joints.is_empty())? / self.least() / (Q::ONE - self.compressed().ok()?);
        Some((Q::from(2) * (up - low) * c).to_f64().value().sqrt() * (1.0 + 1e-12))
    }
}
/// ## The proof
/// Its cells are cut where the scene has a break. In the order of the checks: each cell by itself, then what is between them.
struct Cell { a: Q, b: Q, l: Q, v: Poly, moment: Poly, gap: Option<Poly>, pressed: bool }
fn place(x: &Q) -> f64 { x.to_f64().value() }
fn fraction(v: &Json) -> Result<Q> {
    let text = v.as_str().filter(|text| text.len() < 10_000 && text.split_once(['e', 'E', '@']).is_none_or(|(_, n)| n.len() < 5)).unwrap_or_default();
    let over = |(_, q): (&str, &str)| q.starts_with(|first| first > '0').then(|| text.parse().ok())?;
    text.split_once('/').map_or_else(|| Q::from_str_decimal(text).ok(), over).ok_or(format!("{:.40} is no fraction", v.to_string()))
}
fn cells(s: &Scene, proof: &Json) -> Result<Vec<Cell>> {
    let mut cells: Vec<Cell> = Vec::new();
    for c in list(&proof["cells"]) {
        let poly = |key: &str| c[key].as_array().filter(|p| p.len() < 100).ok_or(format!("no {key}"))?.iter().map(fraction).collect::<Result<Poly>>();
        let (from, to, v, moment) = (fraction(&c["from"])?, fraction(&c["to"])?, poly("v")?, poly("moment")?);
        if from != *cells.last().map_or(&Q::ZERO, |c| &c.b) || to <= from { return Err(format!("cells do not follow each other at {}", place(&from))); }
        let inside = s.breaks.range((Excluded(&from), Excluded(&to)));
        for w in [&from].into_iter().chain(inside).chain([&to]).collect::<Vec<_>>().windows(2) {
            let gap = on(&s.ground, [w[0], w[1]]).zip(on(&s.shape, [w[0], w[1]])).map(|(u, w0)| shift(add(u, &-Q::ONE, w0), w[0]));
            let [v, moment] = [&v, &moment].map(|p| shift(p.clone(), &(w[0] - &from)));
            cells.push(Cell { a: w[0].clone(), b: w[1].clone(), l: w[1] - w[0], v, moment, gap, pressed: c["pressed"] != false });
        }
    }
    if cells.last().is_some_and(|c| c.b == s.l) { Ok(cells) } else { Err("the cells do not end with the beam".into()) }
}
fn along(s: &Scene, Cell { a, b, l, v, moment, gap, pressed }: &Cell) -> Result<[Q; 2]> {
    let wrong = |what: &str| Err(format!("{what} between {} and {}", place(a), place(b)));
    let (two, ei, k) = (Q::from(2), &on(&s.bending, [a, b]).ok_or("no stiffness")?[0], on(&s.springs, [a, b]).map(|k| &k[0]));
    let acts = s.loads.iter().filter(|(ends, _)| ends[0] <= *a && *b <= ends[1]);
    let (q, slope, bend) = (shift(acts.fold(Poly::new(), |sum, (_, q)| add(&sum, &Q::ONE, q)), a), d(v), d(&d(v)));
    let (p, pull) = (add(&add(&d(&d(moment)), &Q::ONE, &q), &s.tension, &bend), &s.tension * integral(&slope, &slope, l) / &two);
    let (mut up, low) = (ei * integral(&bend, &bend, l) / &two + &pull - integral(&q, v, l), -&pull - integral(moment, moment, l) / (&two * ei));
    let Some(g) = gap.as_ref().filter(|_| k.is_none_or(|k| !k.is_zero())) else {
        return if p.iter().all(Q::is_zero) { Ok([low, up]) } else { wrong("a contact pressure without ground") };
    };
    if !nonneg(&p, l) { return wrong("the ground pulls"); }
    let (h, sinks) = (add(g, &-Q::ONE, v), k.filter(|_| *pressed));
    if let Some(k) = sinks { up += k * integral(&h, &h, l) / &two; } else if !nonneg(&h, l) { return wrong("the beam is below the ground"); }
    Ok([low - integral(g, &p, l) - k.map_or(Q::ZERO, |k| integral(&p, &p, l) / (&two * k)), up])
}
fn across(s: &Scene, beside: [Option<&Cell>; 2]) -> Result<[Q; 2]> {
    let x = beside[0].map_or(Q::ZERO, |c| c.b.clone());
    let wrong = |what: &str| Err(format!("{what} at {}", place(&x)));
    let end = |i: usize, c: &Cell| if i == 0 { c.l.clone() } else { Q::ZERO };
    let jets = |of: fn(&Cell) -> &Poly| [0, 1].map(|i| beside[i].map(|c| [of(c).clone(), d(of(c))].map(|p| at(&p, &end(i, c)))));
    let (fields, zero) = (jets(|c| &c.v), || [Q::ZERO, Q::ZERO]);
    let [[m0, v0], [m1, v1]] = jets(|c| &c.moment).map(|m| m.unwrap_or_else(zero));
    let [[y0, t0], [y1, t1]] = fields.clone().map(|v| v.unwrap_or_else(zero));
    let ([v, slope], inside) = (fields.iter().flatten().next().ok_or("no cell")?, fields.iter().all(Option::is_some));
    let (turn, half) = (if inside { &t1 - &t0 } else { Q::ZERO }, |c: Q| c / Q::from(2));
    let [load, twist] = [&s.points, &s.couples].map(|all| all.get(&x).cloned().unwrap_or(Q::ZERO));
    let (mut force, mut couple) = (v1 - v0 + &load + &s.tension * (t1 - t0), &m1 - &m0 - &twist);
    let (mut low, mut up) = (Q::ZERO, -(load * v) - &twist * slope);
    if inside && y0 != y1 { return wrong("the deflection has a step"); }
    match s.joints.get(&x) {
        None if !turn.is_zero() => return wrong("the deflection has a kink"),
        Some(_) if !couple.is_zero() || !twist.is_zero() => return wrong("a couple at the joint"),
        Some(k) if !k.is_zero() => { up += half(k * turn.sqr()); low -= half(m0.sqr() / k); }
        joint => if joint.is_some() && !m0.is_zero() { return wrong("a moment in the hinge"); }
    }
    let shape = on(&s.shape, beside.iter().flatten().next().map_or([&x, &x], |c| [&c.a, &c.b])).ok_or("no shape")?;
    let sides = [0, 1].iter().filter_map(|i| beside[*i].and_then(|c| Some(at(c.gap.as_ref()?, &end(*i, c)))));
    let steps = s.ground.first().into_iter().chain(s.ground.last()).filter(|(ends, _)| *ends == [x.clone(), x.clone()]);
    let mut depths: Vec<Q> = sides.chain(steps.map(|(_, u)| &u[0] - at(shape, &x))).filter(|_| s.springs.is_empty()).collect();
    if depths.iter().any(|g| v > g) { return wrong("the beam is below the ground"); }
    if let Some(t) = s.supports.get(&x) {
        let (level, phi) = (or_zero(t, "level")? - at(shape, &x), or_zero(t, "slope")? - at(&d(shape), &x));
        let [spring, turning] = ["stiffness", "turning_stiffness"].map(|key| t.get(key).map(positive).transpose());
        let (pushes, built_in, turning) = (t["pushes_only"] == true, t["built_in"] == true, turning?);
        match &spring? {
            Some(k) => { // The ground beside a spring takes what is more than the spring has at its depth.
                let mut own = depths.iter().fold(force.clone(), |own, g| own.min(k * (g - &level))); if pushes { own = own.max(Q::ZERO); }
                if !pushes || *v > level { up += half(k * (v - &level).sqr()); }
                (low, force) = (low - half(own.sqr() / k) - &own * level, force - own); }
            None if pushes => if *v > level { return wrong("the beam is below the support"); } else { depths.push(level) },
            None => if *v != level { return wrong("the support is not kept to"); } else { low -= std::mem::take(&mut force) * level; }
        }
        if built_in && (*slope != phi || !turn.is_zero()) { return wrong("the slope is not kept to"); }
        if let Some(k) = &turning { up += half(k * (slope - &phi).sqr()); low -= half(couple.sqr() / k); }
        if built_in || turning.is_some() { low += std::mem::take(&mut couple) * phi; }
    }
    if !couple.is_zero() { return wrong("the moment jumps"); }
    let depth = depths.iter().min().filter(|_| force >= Q::ZERO);
    if depth.is_none() && !force.is_zero() { return wrong(&format!("a force of {} that nothing exerts", place(&force))); }
    Ok([low - depth.map_or(Q::ZERO, |g| force * g), up])
}
pub fn check(s: &Scene, proof: &Json) -> Result<[Q; 2]> {
    let (cells, share) = (cells(s, proof)?, s.compressed()?);
    let places = (0..=cells.len()).map(|i| across(s, [i.checked_sub(1).map(|i| &cells[i]), cells.get(i)]));
    let [low, up] = cells.iter().map(|c| along(s, c)).chain(places).try_fold([Q::ZERO, Q::ZERO], |[low, up], part| part.map(|[l, u]| [low + l, up + u]))?;
    Ok([&low - &share / (Q::ONE - &share) * (&up - &low), up])
}
fn main() -> std::process::ExitCode {
    let paths: Vec<std::path::PathBuf> = std::env::args_os().skip(1).map(Into::into).collect();
    let [scene, proof] = &paths[..] else { println!("usage: check SCENE PROOF"); return 2.into() };
    let read = |path: &std::path::Path| std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()));
    let proven = || -> Result<()> {
        let s = Scene::read(&read(scene)?, &|name| read(&scene.with_file_name(name)))?;
        let bracket = check(&s, &serde_json::from_str(&read(proof)?).map_err(|e| e.to_string())?)?;
        let ([low, up], apart) = (bracket.each_ref().map(place), place(&(&bracket[1] - &bracket[0])));
        let error = s.error(&bracket).map_or(String::new(), |e| format!("; the deflection is off by at most {e:.1e}"));
        println!("proven: the energy lies between {low:?} and {up:?}, which are {apart:.1e} apart{error}");
        Ok(())
    };
    proven().map_or_else(|why| { println!("no proof: {why}"); 1.into() }, |()| 0.into())
}
