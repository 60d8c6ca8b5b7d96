// Two pictures that the reader changes. Their numbers were computed beforehand; nothing is computed here but places on the screen.
const rowsOf = (name) => {
  const [header, ...lines] = document.getElementById("data-" + name).textContent.trim().split("\n").map((line) => line.split(","));
  const value = (cell) => (cell.includes(" ") ? cell.split(" ").map(Number) : isNaN(cell) ? cell : Number(cell));
  return lines.map((cells) => Object.fromEntries(cells.map((cell, i) => [header[i], value(cell)])));
};
const line = (points, style) => `<polyline fill="none" points="${points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" ")}" ${style}/>`;
const text = (x, y, words, style = "") => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ${style}>${words}</text>`;
/// An arrow that ends at (x, y), from below.
const arrow = (x, y, length, color) => (length < 1 ? "" : `<path d="M${x - 5},${y + 9}L${x},${y}L${x + 5},${y + 9}Z" style="fill:${color}"/>`
  + line([[x, y + Math.min(8, length)], [x, y + length]], `style="stroke:${color};stroke-width:3"`));
const short = (value) => (value === 0 ? "0" : value < 0.01 ? value.toPrecision(2) : value.toPrecision(4));

/// A slider: `draw(row, rows, width)` makes the drawing with its height, and the numbers beside it as pairs.
const slider = (name, start, spoken, draw) => {
  const section = document.getElementById("slider-" + name);
  const [input, stage, list] = ["input", ".stage", "dl"].map((part) => section.querySelector(part));
  const rows = rowsOf(name);
  const show = () => {
    const row = rows[Number(input.value)];
    const width = Math.max(280, stage.clientWidth || 700);
    const { height, drawing, numbers } = draw(row, rows, width);
    const said = spoken(row);
    input.setAttribute("aria-valuetext", said);
    stage.innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${said}">${drawing}</svg>`;
    list.innerHTML = numbers.map(([what, number]) => `<div><dt>${what}</dt><dd>${number}</dd></div>`).join("");
  };
  input.max = rows.length - 1;
  input.value = Math.max(0, rows.findIndex(start));
  input.addEventListener("input", show);
  new ResizeObserver(show).observe(stage);
  show();
};

const REGIMES = { zone: "a zone touches", points: "mid-span alone touches", none: "nothing touches" };
slider("depth", (row) => row.depth === 1, (row) => `depth ${short(row.depth)}: ${REGIMES[row.regime]}`, (row, _, width) => {
  const [left, right, level, ground, height] = [34, width - 34, 74, 150, 250];
  const at = (x) => left + (right - left) * x / 10;
  const half = row.left_half_of_deflection_over_depth.map((v, i, all) => [at(5 * i / (all.length - 1)), level + v * (ground - level)]);
  const beam = half.concat(half.slice(0, -1).reverse().map(([x, y]) => [left + right - x, y]));
  const force = (x) => arrow(x, ground + 2, 16 * row.force_there, "var(--contact)")
    + text(x, ground + 18 + 16 * row.force_there, short(row.force_there), "text-anchor=\"middle\" class=\"contact\"");
  const reaction = (x) => arrow(x, level + 4, 16 * row.reaction, "var(--accent)") + text(x, level - 10, short(row.reaction), "text-anchor=\"middle\" class=\"reaction\"");
  const places = row.regime === "zone" ? [row.contact_from, 10 - row.contact_from] : row.regime === "points" ? [5] : [];
  const [from, to] = [at(row.contact_from), at(10 - row.contact_from)];
  const drawing = `<rect x="${left + 18}" y="${ground}" width="${right - left - 36}" height="${height - ground}" style="fill:var(--ground)"/>`
    + (row.regime === "zone" ? `<rect x="${from}" y="${ground}" width="${to - from}" height="8" style="fill:var(--contact);opacity:0.45"/>` : "")
    + `<rect x="${left}" y="26" width="${right - left}" height="8" style="fill:var(--soft);opacity:0.35"/>`
    + text(left, 18, "load 1 on every unit of length", "class=\"soft\"")
    + line([[left, level], [right, level]], "style=\"stroke:var(--soft);stroke-dasharray:2 5\"")
    + line(beam, "style=\"stroke:var(--beam);stroke-width:3.5;stroke-linejoin:round\"")
    + reaction(left) + reaction(right) + places.map((x) => force(at(x))).join("");
  const forces = { zone: "Force at each lift-off point", points: "Force at mid-span", none: "Contact force" };
  const lift = { zone: short(row.contact_from), points: "5 (half of the beam)", none: "the whole beam" };
  return { height, drawing, numbers: [
    ["Depth of the ground u₀", short(row.depth) + (row.depth === 1 ? " (the paper’s example)" : "")],
    ["EI u₀/(q₀l⁴)", short(row.ei_depth_over_q_l4)],
    ["Regime", REGIMES[row.regime]],
    ["Lifted off at each end", lift[row.regime]],
    [forces[row.regime], short(row.force_there)],
    ["Reaction of a support", short(row.reaction)],
    ["Largest deflection", short(row.largest_deflection)],
  ] };
});

slider("grid", (row) => row.intervals === 30, (row) => `${row.intervals} intervals`, (row, rows, width) => {
  // Beam theory of the example is in the data of the other slider.
  const exact = rowsOf("depth").find(({ depth }) => depth === 1);
  const [left, right, top, base, from, to, most] = [34, width - 12, 44, 210, 262, 400, 1.9];
  const at = (x) => left + (right - left) * x / 5;
  const up = (value, low, high) => low - (low - high) * value / most;
  const forces = [row.forces_from_there_to_mid_span].flat();
  const step = 10 / row.intervals;
  const thick = Math.max(1.5, Math.min(14, 0.55 * (at(step) - at(0))));
  const bars = forces.map((force, i) => {
    const [x, y] = [at(row.first_place + i * step), up(force, base, top)];
    return `<rect x="${(x - thick / 2).toFixed(1)}" y="${y.toFixed(1)}" width="${thick.toFixed(1)}" height="${(base - y).toFixed(1)}" style="fill:var(--contact);opacity:${i ? 0.5 : 1}"/>`;
  }).join("");
  const dashes = "style=\"stroke:var(--soft);stroke-width:1.5;stroke-dasharray:6 5\"";
  const axis = (y) => line([[left, y], [right, y]], "style=\"stroke:var(--soft)\"") + text(left - 8, y + 5, "0", "text-anchor=\"end\" class=\"soft\"");
  const [low, high] = [rows[0].intervals, rows[rows.length - 1].intervals];
  const along = (n) => left + 8 + (right - left - 16) * (n - low) / (high - low);
  const first = ({ forces_from_there_to_mid_span: all }) => [all].flat()[0];
  const dots = rows.map((each) => `<circle cx="${along(each.intervals).toFixed(1)}" cy="${up(first(each), to, from).toFixed(1)}" r="2.2" style="fill:var(--contact)"/>`).join("");
  const here = `<circle cx="${along(row.intervals).toFixed(1)}" cy="${up(first(row), to, from).toFixed(1)}" r="6" style="fill:var(--contact);stroke:var(--field);stroke-width:2"/>`;
  const drawing = text(left, 18, "Nodal forces of the left half", "class=\"soft\"")
    + line([[left, up(exact.force_there, base, top)], [right, up(exact.force_there, base, top)]], dashes)
    + text(left + 4, up(exact.force_there, base, top) - 7, `T = ${exact.force_there.toFixed(3)}`)
    + line([[at(exact.contact_from), top - 8], [at(exact.contact_from), base]], dashes)
    + axis(base) + bars
    + `<circle cx="${at(exact.contact_from)}" cy="${up(row.resultant, base, top)}" r="5" style="fill:var(--accent)"/>`
    + text(at(exact.contact_from) + 10, up(row.resultant, base, top) - 9, "resultant", "class=\"reaction\"")
    + text(left, base + 19, "support", "class=\"soft\"") + text(right, base + 19, "mid-span", "text-anchor=\"end\" class=\"soft\"")
    + text(left, from - 8, `First node’s force, ${low} to ${high} intervals`, "class=\"soft\"")
    + line([[left, up(exact.force_there, to, from)], [right, up(exact.force_there, to, from)]], dashes)
    + axis(to) + dots
    + line(rows.map((each) => [along(each.intervals), up(each.resultant, to, from)]), "style=\"stroke:var(--accent);stroke-width:2.5\"") + here
    + text(along(low), to + 19, String(low), "text-anchor=\"middle\" class=\"soft\"") + text(along(high), to + 19, String(high), "text-anchor=\"end\" class=\"soft\"");
  const against = (value) => `${value.toFixed(3)} (${value < exact.force_there ? "−" : "+"}${Math.abs(100 * (value / exact.force_there - 1)).toFixed(1)} %)`;
  return { height: to + 28, drawing, numbers: [
    ["Intervals", row.intervals],
    ["First node that touches", `x = ${row.first_place.toFixed(3)}`],
    ["Its force, against T", against(forces[0])],
    ["Force at the next node", (forces[1] ?? 0).toFixed(3)],
    ["Resultant, against T", against(row.resultant)],
    ["Reaction of a support, against T", against(row.reaction)],
  ] };
});
