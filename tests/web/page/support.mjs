// Support and separating axis: what it shows is what the native library gives.

import { expect, fingerprint, near, numbersAndGraphs, settle, shown } from "./harness.mjs";

const inside = "[data-section=support]";
const w = 0.022; // [m] what lengths are compared with, where they are near 0
const same = 1e-13; // of it: the two libraries give the same bits; what is left are the page's own units

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`support: ${name}`, run);
  const gravity = [0, 0, -9.80665];
  const call = async (...given) => (await native.call(...given))[0];
  const stoneOf = (color = C.WHITE, bevel = 1) => call("catalogue_stone", { whole: 33 }, { whole: color }, bevel * 1e-3, { out: C.STONE_SIZE });
  const leaning = (tilt, heading) => {
    const t = (tilt * Math.PI) / 360, h = (heading * Math.PI) / 180;
    return [Math.cos(t), -Math.sin(h) * Math.sin(t), Math.cos(h) * Math.sin(t), 0];
  };
  const state = (stone, pose, velocity, spin) => call("state", stone, pose, velocity, spin, { out: C.STATE_SIZE });
  const flight = async (stone, from, g, freedom, time) =>
    (await call("free_flight", stone, from, g, { whole: freedom }, time, { out: C.MOTION_SIZE })).slice(0, C.POSE_SIZE);
  const separation = (stone, pose, ground) => call("separation", stone, pose, ground, { out: C.SEPARATION_SIZE });
  const pairOf = (stone, pose, other, otherPose) => call("separation_stones", stone, pose, other, otherPose, { out: C.SEPARATION_SIZE });
  const seek = (page, share) => page.evaluate(([place, at]) => {
    const slider = document.querySelector(`${place} .timeline`);
    slider.value = String(at * 10000);
    slider.dispatchEvent(new Event("input"));
  }, [inside, share]);
  const value = (page, key) => page.locator(`${inside} input.number[data-name=${key}]`).evaluate((one) => Number(one.dataset.value));
  const board = await call("board", { out: C.BOARD_SIZE });

  await case_("the turning stone reaches as far as the native library says", async () => {
    for (const [hash, tilt, axis, bevel] of [["", 12, 0, 1], ["?tilt=70&axis=35&bevel=0", 70, 35, 0], ["?tilt=100&axis=90&bevel=3", 100, 90, 3]]) {
      const page = await browser.section("support", { hash: `#support${hash}` });
      const stone = await stoneOf(C.WHITE, bevel), angle = (axis * Math.PI) / 180;
      const start = await state(stone, [0, 0, 0, ...leaning(tilt, 0)], [0, 0, 0], [2.6, 0.7, 1.1]);
      const parts = new Set();
      for (const share of [0, 0.1, 0.2, 0.35, 0.5, 0.77, 1]) {
        await seek(page, share);
        const now = await shown(page, "support");
        const pose = await flight(stone, start, [0, 0, 0], C.ANGULAR, Number(now.time));
        const ends = [];
        for (const way of [1, -1]) ends.push(await separation(stone, pose, [-way * Math.sin(angle), 0, -way * Math.cos(angle), 0]));
        near(now.reach, -ends[0][C.GAP], same, `the reach at ${now.time}`);
        near(now.extent, -ends[0][C.GAP] - ends[1][C.GAP], same, `the extent at ${now.time}`);
        expect(Number(now.part) === (ends[0][C.FEATURE] === C.RIM ? 1 : 0), `another part touches at ${now.time}`);
        parts.add(now.part);
      }
      expect(axis !== 0 || parts.size === 2, "it shows one part only");
      await page.context().close();
    }
  });

  await case_("in each region: gap, normal, all axes, and where the talk would push", async () => {
    const page = await browser.section("support", { hash: "#support?show=board" });
    const stone = await stoneOf(), regions = new Set();
    let denied = 0, deep = 0;
    for (const button of await page.locator(`${inside} .region`).all()) {
      await button.click();
      const z = await value(page, "z");
      for (const [push, lower] of [["most", 0], ["most", 1.7], ["least", 1.7], ["least", 0]]) {
        await page.locator(`${inside} input.number[data-name=z]`).fill(String(z - lower));
        await page.locator(`${inside} fieldset[data-name=push] input[value=${push}]`).check({ force: true });
        const now = await shown(page, "support");
        const pose = [1e-3 * await value(page, "x"), 1e-3 * await value(page, "y"), 1e-3 * await value(page, "z"), ...leaning(12, await value(page, "heading"))];
        const exact = await separation(stone, pose, board);
        const talk = await call("published_separation", stone, pose, board, { out: C.PUBLISHED_SEPARATION_SIZE });
        near(now.gap, exact[C.GAP], same, "the gap", w);
        expect(Number(now.region) === talk[C.REGION], `region ${now.region}, not ${talk[C.REGION]}`);
        expect(Number(now.verdict) === talk[C.COLLIDING], `the talk says ${talk[C.COLLIDING]}`);
        expect(Number(now.certified) === exact[C.CERTIFIED], `certified ${now.certified}`);
        const at = push === "least" ? C.LEAST_AXIS : C.MOST_AXIS;
        if (talk[C.COLLIDING] === 1) {
          near(now.pushed, talk[at + C.AXIS_DEPTH], same, "the push", w);
          const cosine = [0, 1, 2].reduce((sum, k) => sum + exact[C.NORMAL + k] * talk[at + k], 0);
          near(Math.cos((Number(now.off) * Math.PI) / 180), cosine, 1e-9, "how far the normal is off");
          near(now.lie, exact[C.GAP] > 0 ? exact[C.GAP] : talk[at + C.AXIS_DEPTH] + exact[C.GAP], same, "the lie", w);
          if (exact[C.GAP] > 1e-3) denied++;
          if (exact[C.GAP] < -1e-4) deep++;
        }
        const rows = await page.locator(`${inside} .axes tbody td.r`).allTextContents();
        expect(rows.length === talk[C.AXES] + 1, `${rows.length} rows for ${talk[C.AXES]} axes`);
        rows.slice(0, -1).forEach((text, i) => {
          const depth = 1e3 * talk[C.FIRST_AXIS + i * C.AXIS_SIZE + C.AXIS_DEPTH];
          expect(Math.abs(Number(text.replace("−", "-")) - depth) <= 0.000501, `axis ${i}: ${text} mm, not ${depth}`);
        });
        regions.add(now.region);
      }
      expect(await button.getAttribute("aria-pressed") === "true", "its button is not marked");
    }
    expect(regions.size === 9, `regions ${[...regions]}`);
    expect(deep >= 18, `it overlaps ${deep} times only`);
    expect(denied >= 16, `a gap of 1 mm is denied ${denied} times only`);
    await page.context().close();
  });

  await case_("two stones, apart and overlapping", async () => {
    for (const [dx, dy, dz, status] of [[14, 0, 8.5, C.SEPARATED], [14, -6, 3, C.OVERLAPPING], [1, 2, 9.1, C.OVERLAPPING]]) {
      const page = await browser.section("support", { hash: `#support?show=pair&dx=${dx}&dy=${dy}&dz=${dz}` });
      const white = await stoneOf(), black = await stoneOf(C.BLACK), now = await shown(page, "support");
      const [centre] = (await call("measures", black, { out: C.MEASURES_SIZE })).slice(C.MEASURE_HEIGHT).map((height) => height / 2);
      const found = await pairOf(white, [1e-3 * dx, 1e-3 * dy, centre + 1e-3 * dz, ...leaning(12, 0)], black, [0, 0, centre, 1, 0, 0, 0]);
      expect(found[C.SEPARATION_STATUS] === status, `status ${found[C.SEPARATION_STATUS]}`);
      near(now["pair-gap"], found[C.GAP], same, "the gap", w);
      near(now["pair-normal"], found[C.NORMAL + 2], 1e-9, "the normal", 1);
      expect(Number(now["pair-certified"]) === found[C.CERTIFIED], `certified ${now["pair-certified"]}`);
      await page.context().close();
    }
  });

  await case_("the slider ends at the touch, which is the native library's", async () => {
    const features = new Set();
    for (const [hash, speed, high] of [["", 0.45, 22], ["&high=6", 0.45, 6], ["&high=40", 0.45, 40], ["&speed=2&against=stone", 2, 22]]) {
      const page = await browser.section("support", { hash: `#support?show=flight${hash}` });
      const white = await stoneOf(), black = await stoneOf(C.BLACK), stones = hash.includes("stone");
      const x = stones ? 0.038 : 0.2121 + 0.042;
      const start = await state(white, [x, 0, 1e-3 * (high + (stones ? 70 : 0)), ...leaning(12, 0)], [-speed, 0, 0.25], [40, 0, 20]);
      const second = await state(black, [-x, 0, 0.09, 0.9, 0.3, 0.1, 0], [speed, 0, 0.25], [-30, 10, 20]);
      const hit = stones ? await call("time_of_impact_stones", white, start, black, second, gravity, 0.15, { out: C.HIT_SIZE })
        : await call("time_of_impact", white, start, gravity, board, 0.15, { out: C.HIT_SIZE });
      expect(hit[C.HIT_STATUS] === C.HIT, `status ${hit[C.HIT_STATUS]}`);
      await seek(page, 1);
      const end = await shown(page, "support");
      near(end.touch, hit[C.HIT_TIME], same, "the touch");
      expect(Number(end.time) === Number(end.touch), `the slider ends at ${end.time}, not ${end.touch}`);
      expect(Math.abs(Number(end["flight-gap"])) <= same * w, `the gap is ${end["flight-gap"]} then`);
      expect(Number(end["touch-part"]) === hit[C.HIT_CONTACT + C.OTHER_FEATURE], `it meets ${end["touch-part"]}`);
      features.add(end["touch-part"]);
      await seek(page, 0.6);
      const before = await shown(page, "support"), pose = await flight(white, start, gravity, C.BOTH, Number(before.time));
      const found = stones ? await pairOf(white, pose, black, await flight(black, second, gravity, C.BOTH, Number(before.time)))
        : await separation(white, pose, board);
      near(before["flight-gap"], found[C.GAP], same, "the gap before", w);
      await page.context().close();
    }
    expect(features.size === 4, `it only meets ${[...features]}: side, edge, surface and stone were meant`);
  });

  await case_("what misses is said to miss", async () => {
    const page = await browser.section("support", { hash: "#support?show=flight&against=stone&high=60&speed=0.2" });
    const now = await shown(page, "support");
    expect(Number(now.touch) === 0.15 && now["touch-part"] === "NaN", `it touches at ${now.touch}`);
    await page.context().close();
  });

  await case_("each control of each picture changes it, and a wrong value does not", async () => {
    for (const show of ["board", "pair", "flight"]) {
      const page = await browser.section("support", { hash: `#support?show=${show}&heading=10` });
      for (const control of await page.locator(`${inside} .control:visible`).all()) {
        const field = control.locator(".number"), good = await field.inputValue(), before = await numbersAndGraphs(page, "support");
        const picture = async () => (await page.locator(`${inside} .frame`).screenshot()).toString("base64"), seen = await picture();
        await field.fill("nonsense");
        expect((await control.locator(".rule").textContent()).includes("from"), "no rule is told");
        expect(await numbersAndGraphs(page, "support") === before, "nonsense changes something");
        await control.locator(".slider").focus();
        await page.keyboard.press("PageDown");
        await page.keyboard.press("PageDown");
        expect(await numbersAndGraphs(page, "support") !== before || await picture() !== seen, `${show}: ${await field.getAttribute("data-name")} changes nothing`);
        await field.fill(good);
      }
      await page.context().close();
    }
  });

  await case_("a hand carries the stone, and the link has where it is", async () => {
    for (const [show, key] of [["board", "x"], ["pair", "dx"], ["extent", "heading"], ["flight", "high"]]) {
      const page = await browser.section("support", { hash: `#support?show=${show}` });
      const box = await page.locator(`${inside} .picture`).boundingBox(), before = await value(page, key);
      if (show === "flight") await seek(page, 0);
      // Where the stone is: the point of the picture that holds it.
      const grid = Array.from({ length: 200 }, (_, i) => [box.x + box.width * (0.025 + 0.05 * (i % 20)), box.y + box.height * (0.15 + 0.08 * Math.floor(i / 20))]);
      let held = null;
      for (const [x, y] of grid) {
        await page.mouse.move(x, y);
        await page.mouse.down();
        if (await page.locator(`${inside} .picture.held`).count()) held = [x, y];
        if (held) break;
        await page.mouse.up();
      }
      expect(held, `${show}: nothing can be held`);
      const picture = await fingerprint(page, "support");
      await page.mouse.move(held[0] + 40, held[1] - 25, { steps: 4 });
      await page.mouse.up();
      await page.waitForTimeout(400);
      await settle(page);
      expect(await value(page, key) !== before, `${show}: ${key} stays at ${before}`);
      expect(await fingerprint(page, "support") !== picture, `${show}: the picture stays`);
      const again = await browser.section("support", { hash: new URL(page.url()).hash });
      if (show === "board" || show === "pair") expect(JSON.stringify(await shown(again, "support")) === JSON.stringify(await shown(page, "support")), `${show}: the link shows another one`);
      for (const one of [page, again]) await one.context().close();
    }
  });
}
