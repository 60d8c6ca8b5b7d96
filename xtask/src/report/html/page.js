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

