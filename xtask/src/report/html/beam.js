// A beam above ground of straight lines: three-moment equations on a set of contacts, and an active set that finds the set. The
// answer without a grid has ever finer nodes where the beam begins and ceases to touch.

/// The ground at x: its depth below the line of the supports, its slope before x, and where the piece with that slope begins.
const groundAt = (ground, x) => {
  const i = Math.max(1, ground.findIndex(([end]) => x <= end));
  const [[from, there], [to, here]] = [ground[i - 1], ground[i]];
  const slope = (here - there) / (to - from);
  return { depth: x === to ? here : there + slope * (x - from), slope, from };
};

/// A scene on nodes: `load` are forces at nodes, `uniform` is what lies between them.
const onNodes = ({ stiffness, ground, ends }, x, load, uniform, touches) => ({ x, load, uniform, stiffness, touches,
  below: x.map((at) => groundAt(ground, at)), held: x.map((_, i) => (i === 0 && ends[0] !== "none") || (i === x.length - 1 && ends[1] !== "none")),
  fixed: ends.map((end) => end === "built in") });

/// Lists of zeros, the same ones each time: making them takes longer than filling them.
const pool = { size: 0 };
const zeros = (size) => {
  if (pool.size < size) [pool.size, pool.lists] = [2 * size, Array.from({ length: 14 }, () => new Float64Array(2 * size))];
  return pool.lists.map((list) => list.fill(0, 0, size));
};

/// The beam that touches where it is said to: forces at these nodes and at supports, deflections and moments. Nothing if it can move.
const onContacts = ({ x, below, load, uniform: q, stiffness, held, fixed }, touches) => {
  const [last, at] = [x.length - 1, []];
  for (let i = 0; i <= last; i += 1) if (touches[i] || held[i]) at.push(i);
  const count = at.length;
  if (count === 0 || (count === 1 && !fixed[0] && !fixed[1])) return null;
  const [l, chord, left, right, diagonal, above, moment, turns, turned, ...results] = zeros(last + 1);
  const level = (i) => (held[i] ? 0 : below[i].depth);
  // Spans as simple beams: reactions, and rotations times 6 EI. On one piece of ground the chord has its slope without rounding.
  for (let k = 0; k + 1 < count; k += 1) {
    const [from, to] = [at[k], at[k + 1]];
    l[k] = x[to] - x[from];
    chord[k] = below[to].from <= x[from] && !held[from] && !held[to] ? below[to].slope : (level(to) - level(from)) / l[k];
    left[k] = right[k] = (q * l[k]) / 2;
    turns[k] = turned[k] = (q * l[k] ** 3) / 4;
    for (let i = from + 1; i < to; i += 1) if (load[i] !== 0) {
      const [a, b] = [x[i] - x[from], x[to] - x[i]];
      left[k] += (load[i] * b) / l[k];
      right[k] += (load[i] * a) / l[k];
      turns[k] += (load[i] * a * b * (l[k] + b)) / l[k];
      turned[k] += (load[i] * a * b * (l[k] + a)) / l[k];
    }
    diagonal[k] += 2 * l[k];
    diagonal[k + 1] += 2 * l[k];
    above[k] = l[k];
    moment[k] -= 6 * stiffness * (chord[k] - (k ? chord[k - 1] : 0)) + turns[k];
    moment[k + 1] -= turned[k] - (k === count - 2 ? 6 * stiffness * chord[k] : 0);
  }
  // Where the beam is not built in, the moment at the outermost nodes is that of what hangs over.
  const over = [[at[0], 0], [at[count - 1], last]].map(([node, end]) => {
    const sum = { force: q * Math.abs(x[end] - x[node]), moment: (-q * (x[end] - x[node]) ** 2) / 2 };
    for (let i = end, step = Math.sign(node - end); i !== node; i += step) {
      [sum.force, sum.moment] = [sum.force + load[i], sum.moment - load[i] * Math.abs(x[i] - x[node])];
    }
    return sum;
  });
  const free = [!(held[at[0]] && at[0] === 0 && fixed[0]), !(held[at[count - 1]] && at[count - 1] === last && fixed[1])];
  if (free[0] || count === 1) [diagonal[0], above[0], moment[0]] = [1, 0, over[free[0] ? 0 : 1].moment];
  if (free[1] && count > 1) [diagonal[count - 1], moment[count - 1]] = [1, over[1].moment];
  for (let k = 1; k < count; k += 1) {
    const factor = free[1] && k === count - 1 ? 0 : l[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * above[k - 1];
    moment[k] -= factor * moment[k - 1];
  }
  for (let k = count - 1; k >= 0; k -= 1) moment[k] = (moment[k] - (k + 1 < count ? above[k] * moment[k + 1] : 0)) / diagonal[k];

  const [deflection, bending, force, before, behind] = results;
  const peak = { most: 0, least: 0 };
  const see = (m) => { if (m > peak.most) peak.most = m; else if (m < peak.least) peak.least = m; };
  /// From a node with known deflection, slope, moment and shear to another.
  const walk = (from, to, v, slope, m, shear) => {
    const step = Math.sign(to - from);
    for (let i = from + step; i !== to + step; i += step) {
      const h = Math.abs(x[i] - x[i - step]);
      v += slope * h - (m / 2 + (shear * h) / 6 - (q * h * h) / 24) * ((h * h) / stiffness);
      slope -= (m + (shear * h) / 2 - (q * h * h) / 6) * (h / stiffness);
      if (0 < shear && shear < q * h) see(m + (shear * shear) / (2 * q));
      m += shear * h - (q * h * h) / 2;
      shear -= q * h + load[i];
      [deflection[i], bending[i]] = [v, m];
      if (i !== to) see(m);
    }
  };
  for (let k = 0; k + 1 < count; k += 1) {
    const grows = (moment[k + 1] - moment[k]) / l[k];
    behind[at[k]] = left[k] + grows;
    before[at[k + 1]] = right[k] - grows;
    const slope = chord[k] + (turns[k] + l[k] * (2 * moment[k] + moment[k + 1])) / (6 * stiffness);
    const end = chord[k] - (turned[k] + l[k] * (moment[k] + 2 * moment[k + 1])) / (6 * stiffness);
    if (at[k + 1] - at[k] > 1) walk(at[k], at[k + 1], level(at[k]), slope, moment[k], behind[at[k]]);
    if (k === 0) walk(at[0], 0, level(at[0]), -slope, moment[0], over[0].force);
    if (k === count - 2) walk(at[k + 1], last, level(at[k + 1]), end, moment[k + 1], over[1].force);
  }
  if (count === 1) walk(at[0], last - at[0], 0, 0, moment[0], over[free[0] ? 0 : 1].force);
  before[at[0]] = over[0].force;
  behind[at[count - 1]] = over[1].force;
  at.forEach((i, k) => {
    // A beam that lies on straight ground has no moment; what is left of it between the nodes is of no interest.
    const lies = q > 0 && touches[i - 1] && touches[i + 1] && Math.abs(chord[k] - chord[k - 1]) < 1e-12;
    [deflection[i], bending[i], force[i]] = [level(i), lies ? 0 : moment[k], load[i] + before[i] + behind[i]];
    see(bending[i]);
  });
  return { deflection, moment: bending, force, before, behind, peak };
};

/// Contacts that carry the beam as a rigid body where supports do not: the highest line over two nodes on both sides of the load.
const rigid = ({ x, below, load, uniform, held, fixed }) => {
  const [touches, last, level] = [x.map(() => false), x.length - 1, (i) => (held[i] ? 0 : below[i].depth)];
  if (fixed[0] || fixed[1]) return touches;
  const middle = load.reduce((sum, p, i) => sum + p * x[i], (uniform * x[last] ** 2) / 2) / load.reduce((sum, p) => sum + p, uniform * x[last]);
  const there = ([i, j]) => level(i) + ((level(j) - level(i)) * (middle - x[i])) / (x[j] - x[i]);
  const [left, right] = [(i) => (held[0] ? i === 0 : x[i] <= middle), (i) => (held[last] ? i === last : x[i] > middle)].map((is) => [...x.keys()].filter(is));
  const best = left.flatMap((i) => right.map((j) => [i, j])).reduce((a, b) => (there(b) < there(a) ? b : a));
  touches[best[0]] = touches[best[1]] = true;
  return touches;
};

/// The active set of Lawson and Hanson: of neighbours in the ground the deepest node is taken in, and on the way to the
/// equilibrium with it those are let go that would pull. It ends, as the energy falls.
const equilibrium = (nodes) => {
  const { x, below, load, uniform, held } = nodes;
  // What counts as a pull and as a place in the ground is more than the rounding of a solve: as parts of the load and of the length.
  const [least, deep] = [-1e-9 * load.reduce((sum, p) => sum + p, uniform * x[x.length - 1]), -1e-12 * x[x.length - 1]];
  let [touches, one] = [nodes.touches.slice(), false];
  let beam = onContacts(nodes, touches);
  const those = (is) => { const list = []; for (let i = 0; i < x.length; i += 1) if (!held[i] && is(i)) list.push(i); return list; };
  const pulls = () => those((i) => touches[i] && beam.force[i] < least);
  const gap = (i) => (held[i] ?? true ? Infinity : below[i].depth - beam.deflection[i]);
  for (let out; beam && (out = pulls()).length > 0; beam = onContacts(nodes, touches)) out.forEach((i) => { touches[i] = false; });
  if (!beam) beam = onContacts(nodes, (touches = rigid(nodes)));
  const feasible = new Float64Array(x.length);
  for (let round = 0; beam && round < 20 * x.length; round += 1, beam = onContacts(nodes, touches)) {
    const out = pulls();
    if (out.length === 0) {
      feasible.set(beam.force.subarray(0, x.length));
      const into = those((i) => !touches[i] && gap(i) < deep && gap(i) <= gap(i - 1) && gap(i) < gap(i + 1)).sort((a, b) => gap(a) - gap(b));
      if (into.length === 0) {
        const kept = Object.entries(beam).map(([name, value]) => [name, value.slice?.(0, x.length) ?? value]);
        return { ...nodes, ...Object.fromEntries(kept), touches };
      }
      // All of them at once, unless the last time that led nowhere.
      into.slice(0, one ? 1 : into.length).forEach((i) => { [touches[i], feasible[i]] = [true, 0]; });
      one = false;
    } else {
      const share = Math.min(...out.map((i) => feasible[i] / (feasible[i] - beam.force[i])));
      one = share === 0;
      for (let i = 0; i < x.length; i += 1) feasible[i] += touches[i] ? share * (beam.force[i] - feasible[i]) : 0;
      out.filter((i) => feasible[i] <= -least).forEach((i) => { touches[i] = false; });
    }
  }
  return null;
};

/// Nodes for the answer without a grid, how often those beside a lift-off are halved, and what is no clearance, in lengths of the beam.
const [FIRST, HALVINGS, NEAR] = [80, 8, 1e-10];

/// The answer without a grid.
const solveBeam = (scene) => {
  const { length, uniform, point, ground, stiffness } = scene;
  const corners = [...ground.map(([x]) => x), point.at];
  const equal = Array.from({ length: FIRST + 1 }, (_, i) => (i * length) / FIRST);
  const first = corners.concat(equal.filter((x) => corners.every((at) => Math.abs(x - at) > length / FIRST / 4)));
  const places = new Map(first.map((x) => [x, false]));
  for (let halving = 0; ; halving += 1) {
    const sorted = [...places.keys()].sort((a, b) => a - b);
    const load = sorted.map((x) => (x === point.at ? point.force : 0));
    const beam = equilibrium(onNodes(scene, sorted, load, uniform, sorted.map((x) => places.get(x))));
    if (!beam || halving === HALVINGS) return beam;
    const { x, below, held, deflection, moment } = beam;
    const gaps = x.map((_, i) => (held[i] ? Infinity : below[i].depth - deflection[i]));
    const near = gaps.map((gap, i) => beam.touches[i] || gap < NEAR * length);
    x.forEach((at, i) => {
      places.set(at, beam.touches[i]);
      const [a, b, c, d] = [-2, -1, 1, 2].map((k) => near[i + k]);
      // So far the beam may sag between nodes.
      const sag = ((Math.abs(moment[i]) + uniform * length) * Math.max(at - (x[i - 1] ?? at), (x[i + 1] ?? at) - at) ** 2) / (2 * stiffness);
      const clear = (k) => !(gaps[k] < sag);
      const straight = [-1, 1, 2].every((k) => Math.abs(below[i + k]?.slope - below[i].slope) < 1e-12);
      const ends = near[i] ? !(a && b && c && d && straight) && !(corners.includes(at) && clear(i - 1) && clear(i + 1))
        : gaps[i] < sag && !(gaps[i] > gaps[i - 1]) && !(gaps[i] > gaps[i + 1]);
      if (ends) for (const k of [i, i + 1]) if (k > 0 && k < x.length) places.set((x[k - 1] + x[k]) / 2, near[k - 1] && near[k]);
    });
    if (places.size === x.length) return beam;
  }
};

/// The answer on a grid, which begins with the contacts of another.
const solveOnGrid = (scene, intervals, contacts) => {
  const { length, uniform, point } = scene;
  const x = Array.from({ length: intervals + 1 }, (_, i) => (i * length) / intervals);
  const step = length / intervals;
  const load = x.map((at, i) => uniform * step * (i % intervals ? 1 : 0.5) + point.force * Math.max(0, 1 - Math.abs(at - point.at) / step));
  return equilibrium(onNodes(scene, x, load, 0, x.map((at) => contacts.some(({ from, to }) => from - step < at && at < to + step))));
};

/// Contacts from left to right: neighbouring nodes are one, and so are those between which the beam rises no more than it sags there. Only a zone has a length.
const contactsOf = ({ x, below, touches, deflection, force, before, behind, held, uniform, stiffness }) => {
  const [contacts, length] = [[], x[x.length - 1]];
  const sag = NEAR * length + (uniform * (length / FIRST) ** 4) / (1000 * stiffness);
  for (let i = 0; i < x.length; i += 1) {
    if (!touches[i] || held[i]) continue;
    let [j, total, first] = [i, 0, 0];
    for (let k = i; k < x.length && !held[k] && (touches[k] || below[k].depth - deflection[k] < sag); k += 1) {
      if (touches[k]) [j, total, first] = [k, total + force[k], first + force[k] * x[k]];
    }
    const zone = { from: x[i], to: x[j], force: total, ends: [before[i], behind[j]] };
    contacts.push(x[j] - x[i] > 1e-3 * length ? zone : { from: first / total, to: first / total, force: total });
    i = j;
  }
  return contacts;
};
