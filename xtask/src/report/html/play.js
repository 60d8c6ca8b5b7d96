// The beam to play with: drawing, handles, and the scene as a file.
const section = document.getElementById("play");
const [form, svg, drawing, handles, numbers] = ["form", "svg", ".drawing", ".handles", "tbody"].map((part) => section.querySelector(part));
// Where handles may be: depths, below a support, the largest force, and how near two points may come.
const [HIGHEST, BELOW_SUPPORT, DEEPEST, HEAVIEST, APART] = [-0.5, 0.05, 2.4, 6, 0.2];
// Places of the drawing [px]: margin, line of the supports, a unit of depth and of force; bottom of the ground; axis and half height of the moments.
const [MARGIN, TOP, DEPTH, FORCE, BOTTOM, AXIS, HALF, HEIGHT] = [22, 84, 62, 11, 256, 344, 46, 428];
let [scene, asked] = [null, 0];
const clamp = (value, least, most) => Math.round(Math.min(Math.max(value, least), most) * 1000) / 1000;
const shown = (value) => (Number.isFinite(value) ? value.toFixed(3).replace(/^-(?=0\.0+$)/, "").replace("-", "−") : "–");

const sceneText = ({ length, stiffness, uniform, point, ground, ends }) => {
  const supports = ends.flatMap((end, k) => (end === "none" ? [] : [`{ at = ${k * length}${end === "simple" ? "" : ", built_in = true"} }`]));
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
  const reactionsOf = ({ x, force }) => ends.map((end, k) => (end === "none" ? null : force[k * (x.length - 1)]));
  const reactions = reactionsOf(exact);

  const width = Math.max(280, svg.parentElement.clientWidth);
  const at = (x) => MARGIN + ((width - 2 * MARGIN) * x) / length;
  const down = (depth) => TOP + DEPTH * depth;
  const largest = Math.max(exact.peak.most, -exact.peak.least, 1e-9);
  const bent = (moment) => AXIS + (HALF * moment) / largest;
  const high = (force) => Math.min(66, 6 + FORCE * force);
  const path = (points) => `points="${points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" ")}"`;
  const curve = ({ x }, values, to) => x.map((place, i) => [at(place), to(values[i])]);
  const words = (x, y, text, style) => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" class="${style}">${text}</text>`;
  let left = [-99, 0];
  /// A force of the ground; its lettering makes way for the lettering to its left.
  const push = (x, force) => {
    const y = down(groundAt(ground, x).depth) + 3;
    const beside = at(x) - left[0] < 48 && Math.abs(y + high(force) + 16 - left[1]) < 15;
    left = [at(x), Math.min(beside ? left[1] + 16 : y + high(force) + 16, BOTTOM - 4)];
    return `<path class="contact" d="M${at(x)},${y}l-5,8h3.8v${high(force) - 8}h2.4v${8 - high(force)}h3.8z"/>` + words(...left, shown(force), "contact");
  };
  const [x, y, tip] = [at(point.at), 30 - 4 * point.force, down(exact.deflection[exact.x.indexOf(point.at)]) - 2];
  drawing.innerHTML = `<polygon class="ground" ${path([...ground.map(([x, u]) => [at(x), down(u)]), [at(length), BOTTOM], [at(0), BOTTOM]])}/>`
    + `<rect class="load" x="${MARGIN}" y="${48 - 5 * uniform}" width="${width - 2 * MARGIN}" height="${5 * uniform}"/>`
    + contacts.map(({ from, to, force, ends }) => (ends ? push(from, ends[0]) + push(to, ends[1]) : push(from, force))
      + `<polyline class="zone" ${path([from, to].map((x) => [at(x), down(groundAt(ground, x).depth) + 3]))}/>`).join("")
    + (grid ? `<path class="nodal" d="${grid.x.map((x, i) => (!grid.touches[i] || grid.held[i] ? ""
      : `M${at(x) - 1.5},${down(grid.below[i].depth)}h3v${high(grid.force[i])}h-3z`)).join("")}"/>` : "")
    + `<polyline class="beam" ${path(curve(exact, exact.deflection, down))}/>`
    + (point.force ? `<path class="force" d="M${x},${tip}l-5,-8h3.8V${y}h2.4V${tip - 8}h3.8z"/>` + words(x + 16, y + 5, shown(point.force), "start") : "")
    + ends.map((end, k) => (end === "none" ? "" : words(at(k * length), TOP - 16, shown(reactions[k]), `reaction ${k ? "end" : "start"}`)
      + `<path class="support" d="M${at(k * length)},${end === "simple" ? `${TOP}l-8,13h16z` : `${TOP - 13}h4v26h-8v-26z`}"/>`)).join("")
    + `<polygon class="moment" ${path([[at(0), AXIS], ...curve(exact, exact.moment, bent), [at(length), AXIS]])}/>`
    + [[exact.peak.most, Math.max, 16], [exact.peak.least, Math.min, -5]].map(([m, of, away]) => (Math.abs(m) < 1e-3 * largest ? ""
      : words(at(exact.x[exact.moment.indexOf(of(...exact.moment))]), bent(m) + away, shown(m), "reaction"))).join("")
    + words(MARGIN, HEIGHT - 6, "bending moment, on the side in tension", "soft start")
    + (grid ? `<polyline class="grid" ${path(curve(grid, grid.deflection, down))}/><polyline class="grid" ${path(curve(grid, grid.moment, bent))}/>` : "");
  svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);

  const nodal = ({ force, touches, held }) => Array.from(force).filter((_, i) => touches[i] && !held[i]);
  const summary = (beam, first) => [...reactionsOf(beam), nodal(beam).reduce((sum, force) => sum + force, 0), first,
    beam.peak.most, beam.peak.least, Math.max(...beam.deflection)];
  const columns = [summary(exact, contacts[0]?.ends?.[0] ?? contacts[0]?.force), ...(grid ? [summary(grid, nodal(grid)[0])] : [])];
  [...numbers.rows].forEach((row, i) => columns.forEach((column, k) => { row.cells[k + 1].textContent = shown(column[i]); }));
  [...handles.children].forEach((handle, i) => {
    const [x, value] = ground[i] ?? Object.values(point);
    const said = `${ground[i] ? "depth" : "force"} ${value} at ${x}; ${contacts.length} contacts, supports ${reactions.map(shown).join(" and ")}`;
    [["cx", at(x)], ["cy", ground[i] ? down(value) : y], ["aria-valuenow", value], ["aria-valuetext", said]].forEach((pair) => handle.setAttribute(...pair));
  });
  return { exact, grid, contacts, reactions };
};
const later = () => { asked ||= requestAnimationFrame(() => { asked = 0; frame(); }); };

/// Moves a handle to x and a value, as far as it may go.
const move = (i, x, value) => {
  const { ground, point, length, ends } = scene;
  const end = [0, ground.length - 1].indexOf(i);
  if (i === ground.length) [point.at, point.force] = [clamp(x, 0, length), clamp(value, 0, HEAVIEST)];
  else if (end < 0) ground[i] = [clamp(x, ground[i - 1][0] + APART, ground[i + 1][0] - APART), clamp(value, HIGHEST, DEEPEST)];
  else ground[i] = [ground[i][0], clamp(value, ends[end] === "none" ? HIGHEST : BELOW_SUPPORT, DEEPEST)];
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
handles.addEventListener("pointerdown", ({ target, pointerId, isTrusted }) => { if (isTrusted) target.setPointerCapture(pointerId); });
handles.addEventListener("pointermove", (event) => {
  if (!event.buttons) return;
  const i = [...handles.children].indexOf(event.target);
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const along = ((x - MARGIN) / (svg.viewBox.baseVal.width - 2 * MARGIN)) * scene.length;
  move(i, along, scene.ground[i] ? (y - TOP) / DEPTH : (30 - y) / 4);
});

/// What the controls say, into the scene.
const controls = (stiffness) => {
  scene.ends = [form.left.value, form.right.value];
  scene.stiffness = stiffness ?? Number((10 ** Number(form.stiffness.value)).toPrecision(3));
  scene.uniform = Number(form.uniform.value);
  scene.ground.forEach(([x, depth], i) => move(i, x, depth));
  for (const [name, value] of [["stiffness", scene.stiffness], ["uniform", scene.uniform], ["intervals", Number(form.intervals.value)]]) {
    form[name].previousElementSibling.textContent = form[name].ariaValueText = Number(value.toPrecision(3));
  }
};
const begin = () => {
  scene = JSON.parse(form.start.value);
  const handle = (style, name, least, most) => `<circle r="11" tabindex="0" role="slider" class="${style}" aria-label="${name}"`
    + ` aria-valuemin="${least}" aria-valuemax="${most}"/>`;
  handles.innerHTML = scene.ground.map((_, i) => handle("", `ground, point ${i + 1}`, HIGHEST, DEEPEST)).join("") + handle("force", "load", 0, HEAVIEST);
  [form.left.value, form.right.value, form.stiffness.value, form.uniform.value] = [...scene.ends, Math.log10(scene.stiffness), scene.uniform];
  controls(scene.stiffness);
};
form.addEventListener("input", ({ target }) => (target.name === "start" ? begin() : controls()));
form.copy.addEventListener("click", () => {
  section.querySelector(".copied").hidden = false;
  form.elements.text.value = sceneText(scene);
  form.elements.text.select();
  navigator.clipboard?.writeText(form.elements.text.value).catch(() => { /* It is selected, to be copied by hand. */ });
});
begin();
frame();
new ResizeObserver(later).observe(svg.parentElement);
