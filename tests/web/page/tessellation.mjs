// Tessellation: counts and distances are the native library's.

import { difference, expect, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=tessellation]";

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`tessellation: ${name}`, run);
  const pick = (page, key, value) => page.locator(`${inside} [data-name=${key}] input[value="${value}"]`).check({ force: true });
  const level = (page) => page.locator(`${inside} input.number[data-name=level]`);

  async function natively(method, at, bevel) {
    const [stone] = await native.call("catalogue_stone", { whole: 33 }, { whole: C.WHITE }, bevel / 1e3, { out: C.STONE_SIZE });
    const how = { whole: method === "rings" ? C.RINGS : C.SUBDIVISION };
    const [ints] = await native.call("fineness", stone, how, { whole: at }, 0, { words: C.FINENESS_SIZE });
    const figures = async (weld) => (await native.call("mesh_figures", stone, how, { ints }, { whole: weld }, { out: C.MESH_FIGURES_SIZE }))[0];
    const [measures] = await native.call("measures", stone, { out: C.MEASURES_SIZE });
    return { loose: await figures(C.UNWELDED), welded: await figures(C.WELDED), whole: await figures(C.WELDED_BY_POSITION), volume: measures[C.VOLUME] };
  }

  await case_("every method, level and rim has the numbers of the native library", async () => {
    const page = await browser.section("tessellation");
    for (const bevel of [1, 0]) {
      await page.locator(`${inside} input.number[data-name=bevel]`).fill(String(bevel));
      for (const method of ["rings", "subdivision"]) {
        await pick(page, "by", method);
        for (const at of [0, 1, 2, 3, 4, 5]) {
          await level(page).fill(String(at));
          const now = await shown(page, "tessellation"), { loose, welded, whole, volume } = await natively(method, at, bevel);
          const counts = { triangles: whole[C.MESH_TRIANGLES], unwelded: loose[C.MESH_VERTICES], welded: welded[C.MESH_VERTICES], points: whole[C.MESH_POINTS], loose: 0 };
          for (const [name, count] of Object.entries(counts)) expect(Number(now[name]) === count, `${method} ${at}: ${name} is ${now[name]}, not ${count}`);
          near(now.deviation, whole[C.MESH_DEVIATION], 1e-9, `${method} ${at}: the distance`);
          near(now["mesh-volume"], whole[C.MESH_VOLUME], 1e-12, `${method} ${at}: the volume`);
          near(now["volume-low"], 1 - whole[C.MESH_VOLUME] / volume, 1e-9, `${method} ${at}: how much it is low`);
          expect(loose[C.MESH_VERTICES] === 3 * whole[C.MESH_TRIANGLES], "not three vertices for each triangle");
          expect(at === 0 || (bevel === 0) === (welded[C.MESH_VERTICES] > whole[C.MESH_POINTS]), "only a sharp rim has two normals at one place");
        }
      }
    }
    await page.context().close();
  });

  await case_("a level is chosen in the graph", async () => {
    const page = await browser.section("tessellation");
    const box = await page.locator(`${inside} .plot .field`).boundingBox(), at = async (decade) => {
      await page.mouse.click(box.x + 52 + ((decade - 1) / 3.45) * (box.width - 62), box.y + 30);
      return Number(await level(page).inputValue());
    };
    expect(await at(1) === 0 && await at(4.4) === 5, "not at its ends");
    const { whole } = await natively("subdivision", 3, 1);
    expect(await at(Math.log10(whole[C.MESH_TRIANGLES])) === 3, "not in its middle");
    await page.context().close();
  });

  await case_("three ways to draw it", async () => {
    const page = await browser.section("tessellation"), seen = [];
    for (const look of ["wire", "flat", "smooth"]) {
      await pick(page, "look", look);
      const picture = page.locator(`${inside} .picture`);
      await picture.scrollIntoViewIfNeeded();
      await settle(page);
      seen.push(await picture.screenshot());
    }
    for (const [one, other] of [[0, 1], [1, 2], [2, 0]]) {
      const count = await difference(page, seen[one], seen[other]);
      expect(count > 2000, `${one} and ${other} differ in ${count} pixels`);
    }
    await page.context().close();
  });

  await case_("it refines by itself, and a hand stops that", async () => {
    const page = await browser.section("tessellation", { still: false });
    await page.locator(`${inside} .corner button`).click();
    const counts = new Set();
    for (let i = 0; i < 30 && counts.size < 3; ++i) {
      counts.add((await shown(page, "tessellation")).triangles);
      await page.waitForTimeout(150);
    }
    expect(counts.size >= 3, `${[...counts].join()} triangles`);
    await page.locator(`${inside} .picture`).focus();
    await page.keyboard.press("ArrowLeft");
    await settle(page);
    expect(Number((await shown(page, "tessellation")).triangles) === (await natively("subdivision", 3, 1)).whole[C.MESH_TRIANGLES], "it does not go to its level");
    await page.context().close();
  });
}
