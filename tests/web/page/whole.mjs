// The page as a whole: how soon it is there, and its colours.

import { join } from "node:path";
import { expect, settle } from "./harness.mjs";

const soon = 500; // [ms] of processor time: another program's work does not count

export async function whole(browser, cases, ids, report) {
  await cases.run("sections have one name each, and are in the contents", async () => {
    expect(ids.length > 0 && new Set(ids).size === ids.length, ids.join());
    const page = await browser.open();
    const links = await page.evaluate(() => [...document.querySelectorAll(".contents a")].map((one) => one.getAttribute("href")));
    expect(links.join() === ids.map((id) => `#${id}`).join(), links.join());
    await page.context().close();
  });

  await cases.run("it is ready soon", async () => {
    const times = [];
    for (let i = 0; i < 5; ++i) times.push(await browser.readyAfter());
    const median = (key) => times.map((one) => one[key]).sort((a, b) => a - b)[2];
    console.log(`      ready after ${Math.round(median("wall"))} ms, with ${Math.round(median("work"))} ms of the main thread's work: medians of ${times.length}`);
    expect(median("work") > 0 && median("work") <= soon, `${median("work")} ms of work`);
  });

  await cases.run("text is told from its ground", async () => {
    for (const scheme of ["light", "dark"]) {
      const page = await browser.open({ scheme });
      const weak = await page.evaluate(() => {
        const probe = document.createElement("i");
        document.body.append(probe);
        const luminance = (name) => {
          probe.style.color = `var(--${name})`;
          const parts = getComputedStyle(probe).color.match(/[\d.]+/g).slice(0, 3).map((value) => value / 255)
            .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
          return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
        };
        const against = { ink: ["paper", "panel", "field", "stage", "stage-edge"], soft: ["paper", "panel", "stage"] };
        for (const name of ["exact", "published", "euler", "rk4", "splitting", "momentum", "omega", "normal", "energy"]) against[name] = ["paper", "panel"];
        return Object.entries(against).flatMap(([text, grounds]) => grounds.map((ground) => {
          const [a, b] = [luminance(text), luminance(ground)].sort((x, y) => y - x);
          return { text, ground, contrast: (a + 0.05) / (b + 0.05) };
        })).filter(({ contrast }) => !(contrast >= 4.5));
      });
      expect(weak.length === 0, `${scheme}: ${weak.map((one) => `${one.text} on ${one.ground} ${one.contrast.toFixed(2)}`).join(", ")}`);
      await page.context().close();
    }
  });

  for (const width of [1400, 390]) {
    await cases.run(`picture of the whole, ${width} wide`, async () => {
      const page = await browser.open({ width });
      for (const id of ids) {
        await page.locator(`#${id}`).scrollIntoViewIfNeeded();
        await settle(page);
      }
      const { hash } = new URL(page.url());
      expect(hash === "", `a section that comes into sight writes ${hash}`);
      await page.evaluate(() => scrollTo(0, 0));
      await settle(page);
      await page.screenshot({ path: join(report, `page-${width}.png`), fullPage: true });
      await page.context().close();
    });
  }
}
