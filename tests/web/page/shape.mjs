// The shape: its numbers are the native library's, and the hand that pulls a handle changes them.

import { difference, expect, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=shape]";
const mass = 1e-13; // the two libraries give the same bits; what is left are the page's own units

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`shape: ${name}`, run);
  const field = (page, key) => page.locator(`${inside} input.number[data-name=${key}]`);
  const pick = (page, key, value) => page.locator(`${inside} [data-name=${key}] input[value="${value}"], ${inside} input[data-name=${key}][value="${value}"]`).check({ force: true });
  const picture = async (page) => { // what is out of view is drawn when it comes into it
    const frame = page.locator(`${inside} .frame`);
    await frame.scrollIntoViewIfNeeded();
    await settle(page);
    return frame.screenshot();
  };
  const natively = async (width, height, bevel, measured = 0, density = 2800) => {
    const stone = [width / 1e3, height / 1e3, bevel / 1e3, measured, density, 0];
    const [measures] = await native.call("measures", stone, { out: C.MEASURES_SIZE });
    const [published] = await native.call("published_measures", stone, { out: C.PUBLISHED_MEASURES_SIZE });
    return { measures, published };
  };
  const lengths = { "sphere-radius": "SPHERE_RADIUS", "sphere-offset": "SPHERE_OFFSET", "major-radius": "MAJOR_RADIUS", "minor-radius": "MINOR_RADIUS",
    "outer-of": "OUTER_WIDTH", "size-of": "MEASURE_HEIGHT" };
  const masses = { volume: "VOLUME", mass: "TRUE_MASS", axial: "AXIAL", transverse: "TRANSVERSE", "mass-of": "TRUE_MASS" };
  async function compare(page, what, ...stone) {
    const now = await shown(page, "shape"), { measures, published } = await natively(...stone);
    for (const [name, place] of Object.entries(lengths)) expect(Number(now[name]) === measures[C[place]], `${what}: ${name} is ${now[name]}, not ${measures[C[place]]}`);
    for (const [name, place] of Object.entries(masses)) near(now[name], measures[C[place]], mass, `${what}: ${name}`);
    expect(Number(now["jump"]) === measures[C.SPHERE_RADIUS] / measures[C.MINOR_RADIUS], `${what}: the jump is ${now["jump"]}`);
    return published;
  }

  await case_("every size, white and black, has the numbers of the native library", async () => {
    const page = await browser.section("shape");
    for (const [color, density] of [["white", 2800], ["black", 2750]]) {
      await pick(page, "stone", color);
      for (const number of [22, 25, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40]) {
        await pick(page, "size", number);
        const [stone] = await native.call("catalogue_stone", { whole: number }, { whole: color === "white" ? C.WHITE : C.BLACK }, 0.001, { out: C.STONE_SIZE });
        expect(stone[C.DENSITY] === density, `the density is ${stone[C.DENSITY]}`);
        await compare(page, `${number}, ${color}`, Number(await field(page, "width").inputValue()), Number(await field(page, "height").inputValue()), 1, 0, density);
        near(await field(page, "height").inputValue(), 1e3 * stone[C.HEIGHT], 1e-12, "its thickness");
      }
    }
    await page.context().close();
  });

  await case_("another material keeps the size", async () => {
    const page = await browser.section("shape", { hash: "#shape?width=22&height=7" });
    await pick(page, "stone", "black");
    expect(await page.locator(`${inside} input[data-name=size]:checked`).inputValue() === "25", "it is no 25 any more");
    expect(await field(page, "width").inputValue() === "22.3" && await field(page, "height").inputValue() === "7.6", "it has not the black one's measures");
    await field(page, "height").fill("7.7");
    expect(await page.locator(`${inside} input[data-name=size]:checked`).count() === 0, "a size is marked that it has not");
    await page.context().close();
  });

  await case_("as published it becomes narrower, as measured it does not", async () => {
    const page = await browser.section("shape");
    await compare(page, "published", 22, 9.2, 1);
    near((await shown(page, "shape"))["outer-of"], 0.0214, 2e-4, "the finished width");
    await pick(page, "of", "stone");
    await compare(page, "measured", 22, 9.2, 1, 1);
    near((await shown(page, "shape"))["outer-of"], 0.022, 1e-15, "the finished width");
    await page.context().close();
  });

  await case_("the talk's bevel is shown, and is what its function gives", async () => {
    const page = await browser.section("shape");
    await page.addStyleTag({ content: ".overlay { visibility: hidden }" }); // it is to be drawn, and not only named
    const before = await picture(page);
    await page.locator(`${inside} input[data-name=talk]`).check();
    const published = await compare(page, "with the talk's", 22, 9.2, 1);
    const now = await shown(page, "shape");
    expect(Number(now["published-minor-radius"]) === published[C.PUBLISHED_MINOR_RADIUS], now["published-minor-radius"]);
    expect((await page.locator(`${inside} .after`).textContent()).includes("−5.85 mm"), "the words do not say −5.85 mm");
    const drawn = await difference(page, before, await picture(page));
    expect(drawn > 500, `${drawn} pixels are drawn of it`);
    await page.context().close();
  });

  await case_("what the library refuses is said, and the last good picture stays", async () => {
    const page = await browser.section("shape");
    await field(page, "width").fill("10");
    await field(page, "height").focus();
    await settle(page);
    const before = JSON.stringify(await shown(page, "shape")), good = await picture(page);
    await field(page, "height").fill("12");
    await settle(page);
    const said = await page.locator(`${inside} .wide > .rule`).textContent(), now = await shown(page, "shape");
    expect(said.includes("height = 0.012: must not exceed the width (0.01)"), `it says “${said}”`);
    expect(JSON.stringify({ ...now, height: JSON.parse(before).height }) === before, "the numbers have changed");
    expect(await difference(page, good, await picture(page)) === 0, "the picture has changed");
    await field(page, "height").fill("9.2");
    expect(await page.locator(`${inside} .wide > .rule`).textContent() === "", "the rule stays");
    await compare(page, "mended", 10, 9.2, 1);
    await page.context().close();
  });

  await case_("an address whose numbers do not go together shows the first picture", async () => {
    const page = await browser.section("shape", { hash: "#shape?width=10&height=12" });
    await compare(page, "nonsense", 22, 9.2, 1);
    expect(await page.locator(`${inside} .wide > .rule`).textContent() === "", "it complains");
    await page.context().close();
  });

  await case_("handles are pulled", async () => {
    const page = await browser.section("shape");
    for (const [handle, key, dx, dy] of [[".handle.up", "height", 0, -40], [".handle.across", "width", 40, 0]]) {
      const before = Number(await field(page, key).inputValue()), { x, y } = await page.locator(`${inside} ${handle}`).boundingBox();
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + dx, y + dy, { steps: 4 });
      await page.mouse.up();
      await settle(page);
      const after = Number(await field(page, key).inputValue());
      expect(after > before + 1, `${key} goes from ${before} to ${after}`);
      const there = await page.locator(`${inside} ${handle}`).boundingBox();
      expect(Math.hypot(there.x - x - dx, there.y - y - dy) < 14, `the handle is ${Math.hypot(there.x - x - dx, there.y - y - dy)} px from the hand`);
    }
    await compare(page, "pulled", Number(await field(page, "width").inputValue()), Number(await field(page, "height").inputValue()), 1);
    expect(new URL(page.url()).hash.includes("height="), "the address does not have it");
    await page.context().close();
  });

  await case_("along the profile: the curvature there", async () => {
    const page = await browser.section("shape");
    const { measures } = await natively(22, 9.2, 1), box = await page.locator(`${inside} .plot .field`).boundingBox();
    for (const [share, radius] of [[0.1, measures[C.SPHERE_RADIUS]], [0.5, measures[C.MINOR_RADIUS]], [0.8, measures[C.SPHERE_RADIUS]]]) {
      await page.mouse.click(box.x + 52 + share * (box.width - 62), box.y + 30);
      near((await shown(page, "shape")).bend, 1 / radius, 1e-15, `the curvature at ${share}`);
    }
    await page.context().close();
  });

  await case_("it is made before one's eyes, and a hand stops that", async () => {
    const page = await browser.section("shape", { still: false });
    const frame = page.locator(`${inside} .frame`);
    await page.locator(`${inside} .corner button`).click();
    await page.waitForTimeout(400);
    const first = await frame.screenshot();
    await page.waitForTimeout(700);
    expect(await difference(page, first, await frame.screenshot()) > 100, "nothing moves");
    const there = () => page.locator(`${inside} .handle.up`).evaluate((handle) => !handle.hidden);
    expect(!(await there()), "handles are there already");
    await page.locator(`${inside} .picture`).focus();
    await page.keyboard.press("ArrowLeft");
    await settle(page);
    expect(await there(), "it does not stop");
    await page.context().close();
  });
}
