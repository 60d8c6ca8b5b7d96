// A beam above ground of straight lines: at each node the three-moment equation and equilibrium, and an active set that finds the
// contacts. The refined answer has ever finer nodes where the beam begins and ceases to touch.

/// More than the rounding of a solve is a pull, as a part of the load, and a place in the ground, as a part of the length.
const [PULL, DEEP] = [1e-9, 1e-12];
/// Springs, in loads per length: ground, supports and hinges are stiff; a soft one at a free end carries a beam that touches too little.
const [STIFF, SOFT] = [1e12, 1e-6];
/// Intervals that the refined answer begins with, and how often those beside a lift-off are halved.
const [FIRST, HALVINGS] = [80, 8];
/// Nodes that were eliminated so far: the work of a frame, on any machine.
let eliminated = 0;

const total = (values) => values.reduce((sum, value) => sum + value, 0);

/// The ground at x: its depth below the line of the supports, its slope before x, and where the piece with that slope begins.
const groundAt = (ground, x) => {
  const i = Math.max(1, ground.findIndex(([end]) => x <= end));
  const [[from, there], [to, here]] = [ground[i - 1], ground[i]];
  const slope = (here - there) / (to - from);
  return { depth: x === to ? here : there + slope * (x - from), slope, from };
};

/// A scene on nodes: `load` are forces at nodes, `uniform` is what lies between them. Span and slope of the ground are those before
/// a node. All is divided by 6 EI: `kink` is the right side of the three-moment equation, `push` that of equilibrium.
const onNodes = ({ length, stiffness, ground, ends }, x, load, uniform) => {
  const below = x.map((at) => groundAt(ground, at));
  const depth = below.map((place) => place.depth);
  const unit = 6 * stiffness;
  const span = [0, ...x.slice(1).map((at, i) => at - x[i]), 0];
  const rise = (place, i) => (place.from <= x[i] ? place.slope : (depth[i + 1] - depth[i]) / span[i + 1]);
  const slope = [0, ...below.slice(1).map(rise), 0];
  const kink = x.map((_, i) => slope[i] - slope[i + 1] - (uniform * (span[i] ** 3 + span[i + 1] ** 3)) / (4 * unit));
  const push = x.map((_, i) => (load[i] + (uniform * (span[i] + span[i + 1])) / 2) / unit);
  const end = x.map((at) => (at === 0 ? ends[0] : at === length ? ends[1] : "built in"));
  const turns = end.map((kind) => kind !== "built in");
  const held = end.map((kind, i) => kind !== "none" && (i === 0 || i === x.length - 1));
  const inner = [...x.keys()].filter((i) => !held[i]);
  const whole = total(load) + uniform * length;
  const spring = whole / (length * unit);
  const work = Array.from({ length: 6 }, () => new Float64Array(x.length));
  return { x, load, uniform, depth, unit, span, slope, kink, push, turns, held, inner, whole, spring, work, length, stiffness };
};

/// The beam that touches where it is said to: moments, divided by 6 EI, and gaps, which make rounding as small as they are. At each
/// node a three-moment equation and equilibrium; what a node has is a constant less parts of the moment and gap of the next.
const onContacts = ({ x, depth, span, kink, push, turns, held, spring, work, length }, touches) => {
  const [moment, momentByMoment, momentByGap, gap, gapByMoment, gapByGap] = work;
  for (let i = 0; i < x.length; i += 1, eliminated += 1) {
    const left = span[i];
    const right = span[i + 1];
    const perLeft = left && 1 / left;
    const perRight = right && 1 / right;
    const stiff = spring * (touches[i] || held[i] ? STIFF : turns[i] ? SOFT : 0);
    // The equations: a · moment + b · gap = bend, and stiff · gap − b · moment = rest.
    let a = 2 * (left + right) + (turns[i] ? STIFF * length : 0);
    let b = perLeft + perRight;
    let c = stiff;
    let bend = kink[i];
    let rest = (touches[i] ? 0 : stiff * depth[i]) - push[i];
    if (i > 0) {
      a -= left * momentByMoment[i - 1] - perLeft * gapByMoment[i - 1];
      b += perLeft * momentByMoment[i - 1];
      c -= perLeft * momentByGap[i - 1];
      bend -= left * moment[i - 1] - perLeft * gap[i - 1];
      rest -= perLeft * moment[i - 1];
    }
    const inverse = 1 / (a * c + b * b);
    moment[i] = (c * bend - b * rest) * inverse;
    momentByMoment[i] = (c * right - b * perRight) * inverse;
    momentByGap[i] = -c * perRight * inverse;
    gap[i] = (a * rest + b * bend) * inverse;
    gapByMoment[i] = (a * perRight + b * right) * inverse;
    gapByGap[i] = -b * perRight * inverse;
  }
  for (let i = x.length - 2; i >= 0; i -= 1) {
    moment[i] -= momentByMoment[i] * moment[i + 1] + momentByGap[i] * gap[i + 1];
    gap[i] -= gapByMoment[i] * moment[i + 1] + gapByGap[i] * gap[i + 1];
  }
  return { moment, gap };
};

/// What else there is to say of an answer: forces of ground and supports, those on both sides of a node, and the extreme moments.
const described = (beam) => {
  const { x, load, uniform, depth, unit, span, slope, held, touches } = beam;
  const half = span.map((l) => (uniform * l) / 2);
  const grows = span.map((l, i) => (l > 0 ? (unit * (beam.moment[i] - beam.moment[i - 1])) / l : 0));
  const before = x.map((_, i) => half[i] - grows[i]);
  const behind = x.map((_, i) => half[i + 1] + grows[i + 1]);
  const force = x.map((_, i) => (touches[i] || held[i] ? before[i] + load[i] + behind[i] : 0));
  // A beam that lies on straight ground has no moment; what is left of it between the nodes is of no interest.
  const lies = (i) => uniform > 0 && touches[i - 1] && touches[i] && touches[i + 1] && Math.abs(slope[i + 1] - slope[i]) < DEEP;
  const moment = x.map((_, i) => (lies(i) ? 0 : unit * beam.moment[i]));
  const inside = x.map((_, i) => before[i] > 0 && behind[i - 1] > 0 && !(touches[i - 1] && touches[i]));
  const most = Math.max(...moment.map((m, i) => (inside[i] ? m + before[i] ** 2 / (2 * uniform) : m)));
  const gap = Array.from(beam.gap);
  const deflection = depth.map((level, i) => level - gap[i]);
  return { ...beam, before, behind, force, moment, most, least: Math.min(...moment), gap, deflection };
};

/// The active set of Lawson and Hanson: of neighbours in the ground the deepest node is taken in, and on the way to the
/// equilibrium with it those are let go that would pull. It ends, as the energy falls.
const equilibrium = (nodes, begun) => {
  const { x, held, inner, spring, length } = nodes;
  const touches = begun.map((is, i) => is && !held[i]);
  // Forces of an equilibrium without pull, as parts of the load.
  const feasible = new Float64Array(x.length);
  let beam = null;
  let one = false;
  for (let round = 0; round < 20 * x.length; round += 1) {
    beam = onContacts(nodes, touches);
    const { gap } = beam;
    const force = (i) => -STIFF * gap[i] / length;
    const on = inner.filter((i) => touches[i]);
    const out = on.filter((i) => force(i) < -PULL);
    if (out.length > 0) {
      const share = Math.min(...out.map((i) => feasible[i] / (feasible[i] - force(i))));
      on.forEach((i) => { feasible[i] += share * (force(i) - feasible[i]); });
      out.filter((i) => feasible[i] <= PULL).forEach((i) => { touches[i] = false; });
      one = share === 0;
      continue;
    }
    on.forEach((i) => { feasible[i] = force(i); });
    const deeper = (i, k) => held[k] || !(gap[k] < gap[i]);
    const into = inner.filter((i) => !touches[i] && gap[i] < -DEEP * length && deeper(i, i - 1) && deeper(i, i + 1));
    if (into.length === 0) break;
    // All of them at once, unless the last time that led nowhere.
    into.sort((i, k) => gap[i] - gap[k]).slice(0, one ? 1 : into.length).forEach((i) => {
      touches[i] = true;
      feasible[i] = 0;
    });
    one = false;
  }
  return described({ ...nodes, ...beam, touches });
};

/// The refined answer.
const solveBeam = (scene) => {
  const { length, uniform, point, ground, stiffness } = scene;
  const corners = [...ground.map(([x]) => x), point.at];
  const equal = Array.from({ length: FIRST + 1 }, (_, i) => (i * length) / FIRST);
  const first = corners.concat(equal.filter((x) => corners.every((at) => Math.abs(x - at) > length / FIRST / 4)));
  // Places of nodes, and whether the beam is thought to touch there.
  const places = new Map(first.map((x) => [x, false]));
  for (let halving = 0; ; halving += 1) {
    const sorted = [...places.keys()].sort((a, b) => a - b);
    const load = sorted.map((x) => (x === point.at ? point.force : 0));
    const beam = equilibrium(onNodes(scene, sorted, load, uniform), sorted.map((x) => places.get(x)));
    const { x, span, held, moment, gap, touches } = beam;
    for (let i = 0; i < x.length; i += 1) {
      // So far the beam may sag between nodes.
      const sag = ((Math.abs(moment[i]) + uniform * length) * Math.max(span[i], span[i + 1]) ** 2) / (2 * stiffness);
      const low = !held[i] && gap[i] < sag && !(gap[i] > gap[i - 1]) && !(gap[i] > gap[i + 1]);
      const within = [-2, -1, 1, 2].every((k) => touches[i + k]);
      const halved = (touches[i] || low) && !within ? [i, i + 1] : [];
      halved.filter((k) => k > 0 && k < x.length).forEach((k) => places.set((x[k - 1] + x[k]) / 2, touches[k - 1] && touches[k]));
      places.set(x[i], touches[i]);
    }
    if (halving === HALVINGS || places.size === x.length) return beam;
  }
};

/// The answer on a grid, which begins with the contacts of another.
const solveOnGrid = (scene, intervals, contacts) => {
  const { length, uniform, point } = scene;
  const step = length / intervals;
  const x = Array.from({ length: intervals + 1 }, (_, i) => (i * length) / intervals);
  const share = (at) => Math.max(0, 1 - Math.abs(at - point.at) / step);
  const load = x.map((at, i) => uniform * step * (i % intervals ? 1 : 0.5) + point.force * share(at));
  const begun = x.map((at) => contacts.some(({ from, to }) => from - step < at && at < to + step));
  return equilibrium(onNodes(scene, x, load, 0), begun);
};

/// Contacts from left to right: neighbouring nodes are one, and so are those between which the beam rises no more than it sags
/// there. Only a zone has a length, and a force on either side.
const contactsOf = ({ x, gap, touches, force, before, behind, held, uniform, stiffness, length }) => {
  const contacts = [];
  const sag = (uniform * (length / FIRST) ** 4) / (1000 * stiffness);
  const joined = (i) => touches[i] || (!held[i] && gap[i] < sag);
  for (let i = 0; i < x.length; i += 1) {
    if (!touches[i]) continue;
    const nodes = [];
    for (let k = i; k < x.length && joined(k); k += 1) if (touches[k]) nodes.push(k);
    const last = nodes[nodes.length - 1];
    const carried = total(nodes.map((k) => force[k]));
    const middle = total(nodes.map((k) => force[k] * x[k])) / carried;
    const zone = { from: x[i], to: x[last], force: carried, sides: [before[i], behind[last]] };
    contacts.push(x[last] - x[i] > 1e-3 * length ? zone : { from: middle, to: middle, force: carried, sides: [carried] });
    i = last;
  }
  return contacts;
};
