// The four steps, round by round: the signs of all nodes up to the round that is chosen, and the forces of the ground in it. All from
// the data of the figure, which stays where there is no script, and in print.

/// The rows of a table that is part of the page; a cell that looks like a number is one.
const tableOf = (id) => {
  const cells = [...document.getElementById(id).textContent.trim().matchAll(/("(?:[^"]|"")*"|[^,\n]*)(,|\n|$)/g)];
  const [header, ...rows] = cells.reduce((rows, [, cell, end]) => {
    rows[rows.length - 1].push(cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell);
    if (end === "\n") rows.push([]);
    return rows;
  }, [[]]);
  return rows.map((row) => Object.fromEntries(header.map((name, i) => [name, row[i] === "" || Number.isNaN(Number(row[i])) ? row[i] : Number(row[i])])));
};

const steps = document.querySelector(".steps");
const signs = tableOf("data-steps");
const forces = signs.filter(({ force }) => force !== "");
const [rounds, nodes] = ["round", "node"].map((name) => Math.max(...signs.map((row) => row[name])));
const [least, most] = [Math.min(0, ...forces.map(({ force }) => force)), Math.max(...forces.map(({ force }) => force))];
// Places of the drawing [px]: left of the nodes, above the first round, height of a round, of a unit of force, and of lettering.
const [LEFT, ABOVE, ROUND, UNIT, LETTER] = [34, 26, 10, 24, 18];
const ZERO = ABOVE + ROUND * rounds + 2 * LETTER + UNIT * most + LETTER;
const CLASSES = { "below the ground": "below", "set to zero": "zero", held: "held", "held, would pull": "pulls" };
const turn = steps.querySelector("input");

const showRound = (chosen) => {
  const round = Math.min(Math.max(chosen, 1), rounds);
  const drawn = steps.querySelector("svg");
  const width = Math.max(280, drawn.getBoundingClientRect().width);
  const cell = (width - LEFT - 4) / nodes;
  const at = (node) => LEFT + cell * (node - 1);
  const box = (x, y, wide, high) => `M${x.toFixed(2)},${y.toFixed(2)}h${wide.toFixed(2)}v${high.toFixed(2)}h${(-wide).toFixed(2)}z`;
  const words = (x, y, text, style = "") => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" class="${style}">${text}</text>`;
  const now = signs.filter((row) => row.round === round);
  const pressed = now.filter(({ force }) => force !== "");
  const bars = (pulls) => pressed.filter(({ force }) => (force < 0) === pulls)
    .map(({ node, force }) => box(at(node), ZERO - UNIT * Math.max(force, 0), cell - 1, UNIT * Math.abs(force))).join("");
  const extreme = (of, away) => pressed.filter(({ force }) => force === of && (away < 0 || force < 0)).slice(0, 1)
    .map(({ node, force }) => words(Math.min(at(node) + cell / 2, width - 24), ZERO - UNIT * force + away, shown(force))).join("");
  drawn.setAttribute("viewBox", `0 0 ${width} ${ZERO - UNIT * least + 2.5 * LETTER}`);
  drawn.innerHTML = words(0, LETTER - 4, "round", "start")
    + `<path class="now" d="${box(LEFT - 2, ABOVE + ROUND * (round - 1) - 1, width - LEFT, ROUND + 1)}"/>`
    + Object.entries(CLASSES).map(([sign, style]) => `<path class="${style}" d="${signs.filter((row) => row.sign === sign && row.round <= round)
      .map((row) => box(at(row.node), ABOVE + ROUND * (row.round - 1), cell - 1, ROUND - 1)).join("")}"/>`).join("")
    + Array.from({ length: rounds }, (_, k) => k + 1).filter((k) => k === 1 || k % 5 === 0)
      .map((k) => words(LEFT - 8, ABOVE + ROUND * (k - 0.5) + 5, k, "end")).join("")
    + words(0, ABOVE + ROUND * rounds + LETTER + 6, "force of the ground in this round", "start")
    + `<path class="axis" d="M${LEFT},${ZERO}H${width}"/><path class="force" d="${bars(false)}"/><path class="pulls" d="${bars(true)}"/>`
    + extreme(Math.max(...pressed.map(({ force }) => force)), -6) + extreme(Math.min(...pressed.map(({ force }) => force)), LETTER)
    + Array.from({ length: nodes }, (_, i) => i + 1).filter((i) => i % 10 === 0)
      .map((i) => words(at(i) + cell / 2, ZERO - UNIT * least + 2 * LETTER, i === 10 ? "node 10" : i)).join("");
  const zero = now.find(({ sign }) => sign === "set to zero");
  const pulling = pressed.filter(({ force }) => force < 0).map(({ node, force }) => `; node ${node} would pull with ${shown(-force)}`);
  const said = `Round ${round} of ${rounds}: ${zero ? `node ${zero.node} is set to zero` : "no node is below the ground, and the steps end"}`
    + `; ${pressed.length} ${pressed.length === 1 ? "node is" : "nodes are"} held${pulling.join("")}.`;
  if (steps.querySelector(".said").textContent !== said) steps.querySelector(".said").textContent = said;
  [turn.max, turn.value, turn.ariaValueText] = [rounds, round, said];
};
const turnBy = (by) => showRound(Number(turn.value) + by);
[...steps.querySelectorAll("button")].forEach((button, i) => button.addEventListener("click", () => turnBy(2 * i - 1)));
turn.addEventListener("input", () => turnBy(0));
steps.addEventListener("keydown", (event) => {
  const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, Home: -rounds, End: rounds }[event.key];
  if (by === undefined) return;
  event.preventDefault();
  turnBy(by);
});
steps.addEventListener("click", (event) => event.stopPropagation());
steps.querySelector(".title").textContent = steps.parentElement.querySelector("title").textContent;
showRound(rounds);
new ResizeObserver(() => turnBy(0)).observe(steps);
