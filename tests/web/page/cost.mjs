// What a picture costs where no graphics card helps: processor time, which another program's work changes least.

import { Browser, expect } from "./harness.mjs";

// [ms] of page and GPU process together, for a frame of 800 × 500 pixels. What is aimed at is 16; beside other programs, which
// take its share of the caches, up to 20 were measured.
const most = 24;
const windows = 5;  // the least counts, for what else runs can only add
const lasts = 1200; // [ms] of each

/** In a browser of its own, whose pictures are put together without WebGL, as on a machine without a graphics card. */
export async function cost(id, file, cases) {
  await cases.run(`${id}: a frame costs at most ${most} ms of processor time`, async () => {
    const browser = await Browser.start(file, ["--disable-gpu-compositing"]);
    try {
      const page = await browser.section(id, { width: 832, height: 640, still: false });
      const inside = `[data-section=${id}]`;
      await page.addStyleTag({ content: ".picture { height: 500px !important; }" });
      await page.locator(`${inside} .frame`).first().scrollIntoViewIfNeeded();
      const play = page.locator(`${inside} .round.main`).first();
      const plays = await play.count() > 0;
      await page.evaluate(([place, turns]) => {
        globalThis.count_ = 0;
        const picture = document.querySelector(`${place} .picture`);
        const frame = () => {
          globalThis.count_++;
          if (turns) picture.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
          requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
      }, [inside, !plays]);
      const moves = async () => await play.getAttribute("aria-label") === "pause";
      const costs = [];
      for (let i = 0; costs.length < windows && i < 4 * windows; ++i) { // one that ends before its window does is not judged
        if (plays && await moves() === false) await play.click();
        const before = [await page.evaluate(() => globalThis.count_), await browser.work()];
        await page.waitForTimeout(lasts);
        const after = [await page.evaluate(() => globalThis.count_), await browser.work()];
        if (!plays || await moves()) costs.push((after[1] - before[1]) / (after[0] - before[0]));
      }
      const least = Math.min(...costs);
      console.log(`      ${costs.map((one) => one.toFixed(1)).join(", ")} ms`);
      expect(costs.length === windows && least > 0 && least <= most, `the least of them is ${least.toFixed(1)} ms`);
    } finally {
      await browser.close();
    }
  });
}
