// Inertia: both tensors, and how they turn, are the native library's.

import { expect, framesIn, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=inertia]";
const mass = 1e-13, turn = 1e-13; // the two libraries give the same bits; what is left are the page's own units

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`inertia: ${name}`, run);
  const pick = (page, key, value) => page.locator(`${inside} [data-name=${key}] input[value="${value}"]`).check({ force: true });
  const seek = (page, share) => page.evaluate(([place, at]) => {
    const slider = document.querySelector(`${place} .timeline`);
    slider.value = String(at * 10000);
    slider.dispatchEvent(new Event("input"));
  }, [inside, share]);

  async function natively(size = 33, spin = [5, 0, 6], sameSpin = false) {
    const [stone] = await native.call("catalogue_stone", { whole: size }, { whole: C.WHITE }, 0, { out: C.STONE_SIZE });
    const [m] = await native.call("measures", stone, { out: C.MEASURES_SIZE });
    const [p] = await native.call("published_measures", stone, { out: C.PUBLISHED_MEASURES_SIZE });
    const [state] = await native.call("state", stone, [0, 0, 0, 1, 0, 0, 0], [0, 0, 0], spin, { out: C.STATE_SIZE });
    const L = state.slice(C.MOMENTUM), right = [m[C.AXIAL], m[C.TRANSVERSE]];
    const wrong = [m[C.TRUE_MASS] * p[C.PUBLISHED_SUM_AXIAL], m[C.TRUE_MASS] * p[C.PUBLISHED_SUM_TRANSVERSE]];
    const wrongL = sameSpin ? [wrong[1] * spin[0], 0, wrong[0] * spin[2]] : L;
    const turned = async (moments, momentum, time) => (await native.call("free_rotation", moments, [1, 0, 0, 0], momentum, time, { out: 7 }))[0];
    return { stone, m, p, rates: [Math.hypot(...L) / right[1], Math.hypot(...wrongL) / wrong[1]].map((rate) => rate / (2 * Math.PI)),
      at: async (time) => [await turned(right, L, time), await turned(wrong, wrongL, time)] };
  }

  await case_("every size has the tensors of the native library", async () => {
    const page = await browser.section("inertia");
    for (const size of [22, 25, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40]) {
      await pick(page, "size", size);
      const now = await shown(page, "inertia"), { m, p } = await natively(size);
      const [a, t] = [m[C.AXIAL_PER_MASS], m[C.TRANSVERSE_PER_MASS]];
      for (const [i, value] of [["own-11", t], ["own-22", t], ["own-33", a], ["axial", a], ["volume", m[C.VOLUME]]]) near(now[i], value, mass, `${size}: ${i}`);
      const printed = { "printed-11": "PUBLISHED_SUM_TRANSVERSE", "printed-33": "PUBLISHED_SUM_AXIAL", "published-axial": "PUBLISHED_SUM_AXIAL",
        "published-volume": "PUBLISHED_VOLUME", "closed-form": "PUBLISHED_AXIAL" };
      for (const [name, place] of Object.entries(printed)) near(now[name], p[C[place]], mass, `${size}: ${name}`);
      near(now["axial-low"], 1 - p[C.PUBLISHED_SUM_AXIAL] / a, mass, `${size}: how low`, 1);
    }
    await page.context().close();
  });

  await case_("size 33 has what was printed, and what is right", async () => {
    const page = await browser.section("inertia");
    const text = (name) => page.locator(`${inside} [data-name=${name}]`).textContent();
    const entries = { "printed-11": "0.177721", "printed-22": "0.177721", "printed-33": "0.304776", "own-11": "0.244624", "own-33": "0.415607", "printed-12": "0" };
    for (const [name, said] of Object.entries(entries)) expect(await text(name) === said, `${name} says ${await text(name)}`);
    expect(await text("closed-form") === "0.303588 cm²", await text("closed-form"));
    await page.context().close();
  });

  await case_("at any time: turns, tensor from the room, and what is between the two", async () => {
    const page = await browser.section("inertia");
    for (const same of ["push", "spin"]) {
      await pick(page, "same", same);
      const expected = await natively(33, [5, 0, 6], same === "spin");
      for (const share of [0, 0.123, 0.5, 1]) {
        await seek(page, share);
        const now = await shown(page, "inertia"), time = Number(now.time), [right, wrong] = await expected.at(time);
        near(now.turns, expected.rates[0] * time, turn, "turns");
        near(now["published-turns"], expected.rates[1] * time, turn, "turns with the talk's");
        const dot = Math.abs(right.slice(0, 4).reduce((sum, x, i) => sum + x * wrong[i], 0));
        near(now.apart, 2 * Math.acos(Math.min(1, dot)), 1e-7, "between them", 1);
        const [tensor] = await native.call("tensor", expected.stone, [0, 0, 0, ...right.slice(0, 4)], { out: 9 });
        tensor.forEach((value, i) => near(now[`seen-${Math.floor(i / 3) + 1}${(i % 3) + 1}`], value / expected.m[C.TRUE_MASS], turn, "the tensor", expected.m[C.AXIAL_PER_MASS]));
      }
    }
    await page.context().close();
  });

  await case_("the same push parts them, the same spin hardly", async () => {
    const page = await browser.section("inertia");
    await seek(page, 0.1);
    const pushed = Number((await shown(page, "inertia")).apart);
    await pick(page, "same", "spin");
    await seek(page, 0.1);
    const spun = Number((await shown(page, "inertia")).apart);
    expect(pushed > 1 && spun < 0.1, `${pushed} and ${spun} rad`);
    await page.context().close();
  });

  await case_("a size is chosen in the graph", async () => {
    const page = await browser.section("inertia"), box = await page.locator(`${inside} .plot .field`).nth(1).boundingBox();
    await page.mouse.click(box.x + 54, box.y + 30);
    expect(await page.locator(`${inside} [data-name=size] input:checked`).inputValue() === "22", "it is no 22");
    await page.context().close();
  });

  await case_("it plays, and stops", async () => {
    const page = await browser.section("inertia", { still: false });
    await page.locator(`${inside} .picture`).scrollIntoViewIfNeeded();
    await page.waitForTimeout(1000);
    const time = async () => Number((await shown(page, "inertia")).time), before = await time();
    await page.waitForTimeout(700);
    expect(await time() > before, `it stays at ${before}`);
    await page.locator(`${inside} .round.main`).click();
    await settle(page);
    const there = await time();
    expect(await framesIn(page, 500) === 0 && await time() === there, "it does not stop");
    await page.context().close();
  });
}
