// The beam to play with: drawing, handles, and the scene as a file.
const section = document.getElementById("play");
const [form, svg, drawing, handles, numbers] = ["form", "svg", ".drawing", ".handles", "tbody"].map((part) => section.querySelector(part));
// How near points of the ground may come, to a support and to each other.
const [BELOW_SUPPORT, APART] = [0.05, 0.2];
// Places of the drawing [px]: margin, line of the supports, a unit of depth and of force, bottom of the ground; axis and half height
// of the moments; height.
const [MARGIN, TOP, DEPTH, FORCE, BOTTOM, AXIS, HALF, HEIGHT] = [22, 84, 62, 11, 256, 344, 46, 428];
let [scene, asked] = [null, 0];
const clamp = (value, least, most) => Math.round(Math.min(Math.max(value, least), most) * 1000) / 1000;
const shown = (value) => (Number.isFinite(value) ? value.toFixed(3).replace(/^-(?=0\.0+$)/, "").replace("-", "−") : "–");
const words = (x, y, text, style) => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" class="${style}">${text}</text>`;
const path = (style, way) => `<path class="${style}" d="${way}"/>`;
const through = (points) => points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)},${y.toFixed(1)}`).join("");
/// An arrow, as far from its tip as `back` says, which is negative for one that points down.
const arrow = (x, tip, back) => `M${x},${tip}l-5,${8 * Math.sign(back)}h3.8V${tip + back}h2.4V${tip + 8 * Math.sign(back)}h3.8z`;

const sceneText = ({ length, stiffness, uniform, point, ground, ends }) => {
  const support = (end, k) => `{ at = ${k * length}${end === "built in" ? ", built_in = true" : ""} }`;
  const supports = ends.map(support).filter((_, k) => ends[k] !== "none");
  return `title = "A beam to play with"\n\n[beam]\nlength = ${length}\nbending_stiffness = ${stiffness}\nsupports = [${supports.join(", ")}]\n\n`
    + `[load]\nuniform = ${uniform}\npoint = [{ at = ${point.at}, force = ${point.force} }]\n\n`
    + `[foundation]\npoints = ${JSON.stringify(ground).replaceAll(",", ", ")}\n`;
};

/// One frame: solves, draws, and writes the numbers.
const frame = () => {
  const { length, ground, point, ends, uniform } = scene;
  const exact = solveBeam(scene);
  const contacts = contactsOf(exact);
  const grid = form.grid.checked ? solveOnGrid(scene, Number(form.intervals.value), contacts) : null;
  const reactionsOf = ({ force }) => ends.map((end, k) => (end === "none" ? null : force.at(-k)));
  const reactions = reactionsOf(exact);

  const width = Math.max(280, svg.parentElement.clientWidth);
  const at = (x) => MARGIN + ((width - 2 * MARGIN) * x) / length;
  const down = (depth) => TOP + DEPTH * depth;
  const surface = (x) => down(groundAt(ground, x).depth) + 3;
  const [labels, largest] = [[], Math.max(exact.most, -exact.least, 1e-9)];
  const bent = (moment) => AXIS + (HALF * moment) / largest;
  const high = (force) => Math.min(66, 6 + FORCE * force);
  const curve = ({ x }, values, to) => through(x.map((place, i) => [at(place), to(values[i])]));
  /// A force of the ground; its lettering makes way for others, and is left out where there is no room.
  const push = (x, force) => {
    const rows = [16, 32, 48, 64].map((more) => Math.min(surface(x) + high(force) + more, BOTTOM - 4));
    const free = rows.find((y) => !labels.some((other) => Math.abs(at(x) - other[0]) < 48 && Math.abs(y - other[1]) < 15)) ?? -99;
    labels.push([at(x), free]);
    return path("contact", arrow(at(x), surface(x), high(force))) + words(at(x), free, shown(force), "contact");
  };
  const touch = ({ from, to, sides }) => sides.map((force, k) => push([from, to][k], force)).join("")
    + path("zone", through([from, to].map((x) => [at(x), surface(x)])));
  const reaction = (k) => words(at(k * length), TOP - 16, `reaction ${shown(reactions[k])}`, `reaction ${k ? "end" : "start"}`);
  const support = (end, k) => (end === "none" ? "" : reaction(k)
    + path("support", `M${at(k * length)},${end === "simple" ? `${TOP}l-8,13h16z` : `${TOP - 13}h4v26h-8v-26z`}`));
  const node = (x, i) => (grid.touches[i] ? `M${at(x) - 1.5},${down(grid.depth[i])}h3v${high(grid.force[i])}h-3z` : "");
  const extreme = (moment, of, away) => (Math.abs(moment) < 1e-3 * largest ? ""
    : words(at(exact.x[exact.moment.indexOf(of(...exact.moment))]), bent(moment) + away, shown(moment), "reaction"));
  const [pressed, head, tail] = [at(point.at), down(exact.deflection[exact.x.indexOf(point.at)]) - 2, 30 - 4 * point.force];
  svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
  drawing.innerHTML = [
    path("ground", `${through(ground.map(([x, depth]) => [at(x), down(depth)]))}V${BOTTOM}H${at(0)}z`),
    path("load", `M${MARGIN},48H${width - MARGIN}v${-5 * uniform}H${MARGIN}z`) + words(MARGIN, 42 - 5 * uniform, `load ${uniform}`, "soft start"),
    ...contacts.map(touch),
    path("beam", curve(exact, exact.deflection, down)),
    point.force ? path("force", arrow(pressed, head, tail - head)) + words(pressed + 16, tail + 5, shown(point.force), "start") : "",
    ...ends.map(support),
    path("moment", `M${at(0)},${AXIS}${curve(exact, exact.moment, bent).replace("M", "L")}V${AXIS}z`),
    extreme(exact.most, Math.max, 16) + extreme(exact.least, Math.min, -5),
    grid ? path("nodal", grid.x.map(node).join("")) + path("grid", curve(grid, grid.deflection, down) + curve(grid, grid.moment, bent)) : "",
  ].join("");

  const nodal = (beam) => beam.force.filter((_, i) => beam.touches[i]);
  const summary = (beam, first) => [...reactionsOf(beam), total(nodal(beam)), first, beam.most, beam.least, Math.max(...beam.deflection)];
  const columns = [summary(exact, contacts[0]?.sides[0])];
  if (grid) columns.push(summary(grid, nodal(grid)[0]));
  columns.forEach((column, k) => column.forEach((value, i) => { numbers.rows[i].cells[k + 1].textContent = shown(value); }));
  [...handles.children].forEach((handle, i) => {
    const [x, value] = ground[i] ?? Object.values(point);
    const said = `${ground[i] ? "depth" : "force"} ${value} at ${x}; ${contacts.length} contacts, supports ${reactions.map(shown).join(" and ")}`;
    const set = { cx: at(x), cy: ground[i] ? down(value) : tail, "aria-valuenow": value, "aria-valuetext": said };
    Object.entries(set).forEach((pair) => handle.setAttribute(...pair));
  });
  return { exact, grid, contacts, reactions };
};
const later = () => { asked ||= requestAnimationFrame(() => { asked = 0; frame(); }); };

/// Moves a handle to x and a value, as far as it may go.
const move = (i, x, value) => {
  section.querySelector(".copied").hidden = true;
  const { ground, point, length, ends } = scene;
  const { ariaValueMin: least, ariaValueMax: most } = handles.children[i];
  const end = { 0: ends[0], [ground.length - 1]: ends[1] }[i];
  if (i === ground.length) [point.at, point.force] = [clamp(x, 0, length), clamp(value, least, most)];
  else if (end) ground[i] = [ground[i][0], clamp(value, end === "none" ? least : BELOW_SUPPORT, most)];
  else ground[i] = [clamp(x, ground[i - 1][0] + APART, ground[i + 1][0] - APART), clamp(value, least, most)];
  later();
};
handles.addEventListener("keydown", (event) => {
  const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [];
  if (dx === undefined) return;
  event.preventDefault();
  const [i, step] = [[...handles.children].indexOf(event.target), event.shiftKey ? 0.5 : 0.05];
  const [x, value] = scene.ground[i] ?? Object.values(scene.point);
  move(i, x + dx * step, value + (scene.ground[i] ? dy : -dy) * step);
});
handles.addEventListener("pointerdown", ({ target, pointerId, isTrusted }) => isTrusted && target.setPointerCapture(pointerId));
handles.addEventListener("pointermove", (event) => {
  if (!event.buttons) return;
  const i = [...handles.children].indexOf(event.target);
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const along = ((x - MARGIN) / (svg.viewBox.baseVal.width - 2 * MARGIN)) * scene.length;
  move(i, along, scene.ground[i] ? (y - TOP) / DEPTH : (30 - y) / 4);
});

/// What a control says, into the scene. One that was not moved is not read: a slider has steps, and what a scene begins with may lie
/// between them.
const controls = (moved) => {
  if (moved === form.left || moved === form.right) scene.ends = [form.left.value, form.right.value];
  if (moved === form.stiffness) scene.stiffness = Number((10 ** Number(form.stiffness.value)).toPrecision(3));
  if (moved === form.uniform) scene.uniform = Number(form.uniform.value);
  scene.ground.forEach(([x, depth], i) => move(i, x, depth));
  Object.entries({ stiffness: scene.stiffness, uniform: scene.uniform, intervals: form.intervals.value }).forEach(([name, value]) => {
    form[name].ariaValueText = Number(value).toPrecision(3);
    form[name].previousElementSibling.textContent = Number(form[name].ariaValueText);
  });
};
const begin = () => {
  scene = JSON.parse(form.start.value);
  [form.left.value, form.right.value] = scene.ends;
  form.stiffness.value = Math.log10(scene.stiffness);
  form.uniform.value = scene.uniform;
  controls();
};
form.addEventListener("input", ({ target }) => (target.name === "start" ? begin() : controls(target)));
form.copy.addEventListener("click", () => {
  section.querySelector(".copied").hidden = false;
  form.elements.text.value = sceneText(scene);
  form.elements.text.select();
  navigator.clipboard?.writeText(form.elements.text.value).catch(() => { /* It is selected, to be copied by hand. */ });
});
begin();
new ResizeObserver(later).observe(svg.parentElement);
