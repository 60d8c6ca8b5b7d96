"use strict";
// Theme, menu, and the place in the navigation.
const root = document.documentElement;
const themeButton = document.getElementById("theme");
const menuButton = document.getElementById("menu");
const contents = document.getElementById("contents");

const nameTheme = () => { themeButton.textContent = root.dataset.theme === "dark" ? "Light" : "Dark"; };
themeButton.addEventListener("click", () => {
  root.dataset.theme = root.dataset.theme === "dark" ? "light" : "dark";
  try { localStorage.setItem("theme", root.dataset.theme); } catch { /* Then it is chosen for this visit alone. */ }
});
new MutationObserver(nameTheme).observe(root, { attributeFilter: ["data-theme"] });
nameTheme();

const openMenu = (open) => {
  contents.classList.toggle("open", open);
  menuButton.setAttribute("aria-expanded", String(open));
};
menuButton.addEventListener("click", () => openMenu(!contents.classList.contains("open")));
contents.addEventListener("click", (event) => { if (event.target.closest("a")) openMenu(false); });
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape" && contents.classList.contains("open")) { openMenu(false); menuButton.focus(); }
});

// The report alone on paper, and answers of exercises open there.
const printed = (only) => { if (only) root.dataset.print = "report"; else delete root.dataset.print; };
printed(location.hash === "#print");
document.getElementById("print").addEventListener("click", () => { printed(true); print(); printed(false); });
const closed = [...document.querySelectorAll("details:not([open])")];
addEventListener("beforeprint", () => closed.forEach((details) => { details.open = true; }));
addEventListener("afterprint", () => closed.forEach((details) => { details.open = false; }));

// What is wider than its box can be scrolled by keys; formulas shrink on narrow screens, figures grow at a touch.
const boxes = [...document.querySelectorAll(".table, .formula, figure, pre")];
const fit = () => {
  const formulas = boxes.filter((box) => box.matches(".formula"));
  let sizes = formulas.map(() => 1.1);
  // Signs do not shrink in proportion.
  for (let round = 0; round < 4; round += 1) {
    formulas.forEach((box, i) => { box.style.fontSize = `${sizes[i]}rem`; });
    sizes = formulas.map((box, i) => sizes[i] * (box.scrollWidth > box.clientWidth ? 0.98 * box.clientWidth / box.scrollWidth : 1));
  }
  formulas.forEach((box, i) => { box.style.fontSize = `${sizes[i]}rem`; });
  const wide = boxes.map((box) => box.scrollWidth > box.clientWidth);
  boxes.forEach((box, i) => { if (wide[i]) box.tabIndex = 0; else box.removeAttribute("tabindex"); });
};
document.querySelectorAll('figure:has([style="--share:1"]):not(:has(.steps))').forEach((figure) => figure.addEventListener("click", () => { figure.classList.toggle("large"); fit(); }));
addEventListener("resize", fit);
fit();

const entries = [...contents.querySelectorAll("a")].map((link) => ({ link, target: document.getElementById(link.hash.slice(1)) }));
const showPlace = () => {
  const passed = entries.filter(({ target }) => target.getBoundingClientRect().top < 120);
  const { link } = passed[passed.length - 1] ?? entries[0];
  if (link.hasAttribute("aria-current")) return;
  contents.querySelectorAll("[aria-current]").forEach((old) => old.removeAttribute("aria-current"));
  contents.querySelectorAll(".here").forEach((old) => old.classList.remove("here"));
  link.setAttribute("aria-current", "true");
  contents.querySelector("ol").querySelectorAll(":scope > li").forEach((item) => item.classList.toggle("here", item.contains(link)));
  if (getComputedStyle(menuButton).display === "none") link.scrollIntoView({ block: "nearest" });
};
addEventListener("scroll", showPlace, { passive: true });
addEventListener("hashchange", showPlace);
showPlace();

