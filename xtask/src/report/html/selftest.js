// `index.html#selftest` tries the page out, as `cargo xtask browser` does, and says what it found.
if (location.hash === "#selftest") {
  const failures = [];
  let checks = 0;
  const expect = (holds, what) => { checks += 1; if (!holds) failures.push(what); };
  addEventListener("error", (event) => failures.push("error: " + event.message));
  addEventListener("securitypolicyviolation", (event) => failures.push("would load " + event.blockedURI));
  const visible = (element) => element.getClientRects().length > 0;
  const pause = () => new Promise((done) => setTimeout(done, 100));
  const narrow = matchMedia("(max-width: 62rem)").matches;
  const paint = (element) => getComputedStyle(element);

  const run = async () => {
    expect(performance.getEntriesByType("resource").length === 0, "something was loaded");
    expect(root.scrollWidth <= innerWidth, `the page is ${root.scrollWidth} px wide on a screen of ${innerWidth}`);
    const small = [...document.querySelectorAll("main :is(p, li, td, th, code, dt, dd), nav a")].filter((e) => visible(e) && parseFloat(paint(e).fontSize) < 14.9);
    expect(small.length === 0, `${small.length} texts are smaller than 15 px, <${small[0]?.localName}> ${small[0]?.textContent.slice(0, 40)}`);
    const long = [...document.querySelectorAll("article > p")].filter((p) => p.clientWidth > 760);
    expect(long.length === 0, `${long.length} paragraphs have lines that are too long`);

    const menu = document.querySelector("#menu");
    expect(visible(menu) === narrow, "the menu is for narrow screens alone");
    expect(visible(contents) !== narrow, "the navigation is beside the text where there is room");
    for (const { link, target } of entries.filter((_, i) => i % 5 === 1)) {
      if (narrow) menu.click();
      expect(visible(contents), "the menu opens");
      link.click();
      await pause();
      const top = target.getBoundingClientRect().top;
      expect(location.hash === link.hash && Math.abs(top) < 120, `${link.hash} is at ${Math.round(top)} px`);
      expect(visible(contents) !== narrow, "the menu closes");
      expect(visible(link) || narrow, `${link.hash} is shown in the navigation`);
    }

    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    expect(root.dataset.theme === (dark ? "dark" : "light"), "the theme is that of the system");
    const paper = () => paint(document.body).backgroundColor;
    const isDark = () => paper().match(/\d+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0) < 384;
    const drawn = () => [...document.querySelectorAll("figure rect[fill='#FFFFFF']")].every((rect) => paint(rect).fill === paper());
    for (const expected of [dark, !dark, dark]) {
      expect(isDark() === expected, `the paper is ${expected ? "dark" : "light"}`);
      expect(drawn(), `the drawings are on ${expected ? "dark" : "light"} paper as well`);
      themeButton.click();
    }
    themeButton.click();
    try { localStorage.removeItem("theme"); } catch { /* There was none. */ }

    for (const section of document.querySelectorAll(".slider")) {
      const [input, stage, list] = ["input", ".stage", "dl"].map((part) => section.querySelector(part));
      const seen = new Set();
      for (let i = 0; i <= Number(input.max); i += 1) {
        input.value = i;
        input.dispatchEvent(new Event("input"));
        seen.add(stage.innerHTML + list.innerHTML);
        expect(!/NaN|undefined|Infinity/.test(stage.innerHTML + list.innerHTML), `${section.id} shows no number at ${i}`);
        // The layout of the whole page takes its time.
        if (i % 20 === 0) expect(root.scrollWidth <= innerWidth, `${section.id} is too wide at ${i}`);
      }
      expect(seen.size === Number(input.max) + 1 && seen.size > 50, `${section.id} has ${seen.size} pictures`);
      input.focus();
      expect(document.activeElement === input, `${section.id} takes the keyboard`);
    }
  };
  run().catch((error) => failures.push(String(error))).then(() => {
    const said = failures.length ? failures.slice(0, 20).join("; ") : "passed";
    root.dataset.selftest = said;
    parent.postMessage(`${innerWidth} px, ${checks} checks: ${said}`, "*");
  });
}
