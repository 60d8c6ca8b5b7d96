// The four steps, round by round: all rounds are part of the page, and one is shown, with the signs of those before it. The figure
// stays where there is no script, and in print.
const steps = document.querySelector(".steps");
const [turn, saying] = ["input", ".said"].map((part) => steps.querySelector(part));
const [rows, bars] = [".round", ".forces"].map((part) => [...steps.querySelectorAll(part)]);

const showRound = (wanted) => {
  turn.value = wanted;
  const round = Number(turn.value);
  rows.forEach((row, i) => {
    row.classList.toggle("later", i >= round);
    row.classList.toggle("now", i + 1 === round);
  });
  bars.forEach((of, i) => { of.hidden = i + 1 !== round; });
  saying.textContent = rows[round - 1].dataset.said;
  turn.ariaValueText = saying.textContent;
};
turn.addEventListener("input", () => showRound(turn.value));
steps.querySelectorAll("button").forEach((button, i) => button.addEventListener("click", () => showRound(Number(turn.value) + 2 * i - 1)));
showRound(turn.max);
