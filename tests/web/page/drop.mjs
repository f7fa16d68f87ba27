// The drop: what it shows is what the native library gives.

import { expect, framesIn, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=drop]";
// The two libraries give the same bits; what is left are the page's own units.
const same = 1e-13;

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`drop: ${name}`, run);
  const seek = (page, share) => page.evaluate(([place, at]) => {
    const slider = document.querySelector(`${place} .timeline`);
    slider.value = String(at * 10000);
    slider.dispatchEvent(new Event("input"));
  }, [inside, share]);
  const start = async (page, name) => {
    await page.locator(`${inside} input[data-name=start][value=${name}]`).check({ force: true });
    await settle(page);
  };
  const step = (page, label) => page.locator(`${inside} button[aria-label="${label}"]`).click();

  /** The drop of the controls, natively. */
  async function natively({ height = 30, tilt = 25, spin = 12, tumble = 0, speed = 0, place = 0, e = 0.5, mu = 0.3, bevel = 1, law = "dry",
    stone: color = "white", rolling = 0.1, pivot = 0.05, until = 10 } = {}) {
    const [stone] = await native.call("catalogue_stone", { whole: 33 }, { whole: color === "white" ? C.WHITE : C.BLACK }, bevel * 1e-3, { out: C.STONE_SIZE });
    const [board] = await native.call("board", { out: C.BOARD_SIZE });
    const half = (tilt * Math.PI) / 360;
    const pose = (z) => [place * 1e-3, 0, z, Math.cos(half), -Math.sin(half), 0, 0];
    const [gap] = await native.call("separation", stone, pose(1), [0, 0, 1, 0], { out: C.SEPARATION_SIZE });
    const [state] = await native.call("state", stone, pose(1 - gap[C.GAP] + height * 1e-3), [speed, 0, 0], [tumble, 0, spin], { out: C.STATE_SIZE });
    const [settings] = await native.call("settings", { out: C.SETTINGS_SIZE });
    settings[C.RESTITUTION] = e;
    settings[C.FRICTION] = mu;
    settings[C.FRICTION_MODEL] = law === "dry" ? C.DRY : C.SLIP_PROPORTIONAL;
    settings[C.ROLLING_RESISTANCE] = rolling * 1e-3;
    settings[C.PIVOT_RADIUS] = pivot * 1e-3;
    settings[C.HORIZON] = until;
    const [handle] = await native.call("drop_create", stone, state, board, settings, { size: 60000 }, { one: 1 });
    await native.call("drop_advance", { handle }, Infinity);
    const [info] = await native.call("drop_info", { handle }, { out: C.DROP_SIZE });
    const [events] = await native.call("drop_events", { handle }, { size: 0 }, { out: info[C.DROP_EVENTS] * C.EVENT_SIZE });
    const at = async (time) => (await native.call("drop_motions", { handle }, [time], { whole: C.AFTER }, { out: C.MOTION_SIZE }))[0];
    return { stone, board, state, settings, info, at,
      times: Array.from({ length: info[C.DROP_EVENTS] }, (_, i) => events[i * C.EVENT_SIZE + C.EVENT_TIME]) };
  }
  /** The angle of the axis from the vertical   [°], by its parts across and along: the cosine alone tells small ones badly. */
  const tiltOf = (motion) => {
    const [w, x, y, z] = motion.slice(C.ATTITUDE);
    const across = 2 * Math.hypot(x * z + w * y, y * z - w * x);
    return (Math.atan2(across, w * w + z * z - x * x - y * y) * 180) / Math.PI;
  };

  await case_("events, their times and the end are those of the native library", async () => {
    const page = await browser.section("drop");
    const expected = await natively();
    const now = await shown(page, "drop");
    expect(expected.info[C.DROP_STATUS] === C.REST, "it does not come to rest");
    near(now.end, expected.info[C.DROP_TIME], same, "the end");
    for (const [name, place] of [["events", C.DROP_EVENTS], ["impacts", C.DROP_IMPACTS]]) {
      expect(Number(now[name]) === expected.info[place], `${name}: ${now[name]}, not ${expected.info[place]}`);
    }
    await seek(page, 0);
    for (const time of [...new Set(expected.times)].slice(1)) {
      await step(page, "step forward");
      const there = await shown(page, "drop");
      near(there.time, time, same, "the time of an event");
      const motion = await expected.at(Math.min(time, expected.info[C.DROP_TIME]));
      near(there.height, motion[C.POSITION + 2], same, `the height at ${time}`);
      near(there.tilt, tiltOf(motion), same, `the tilt at ${time}`, 1);
    }
    await page.context().close();
  });

  await case_("every control means what it says", async () => {
    for (const controls of [
      { height: 42, tilt: 70, spin: -20, tumble: 15, speed: 0.1, place: -50, e: 0.42, mu: 0.21, rolling: 0.37, pivot: 0.11, bevel: 1.7, stone: "black" },
      { height: 3, tilt: 8, spin: 25, e: 0.2, mu: 0.4, rolling: 0.01, pivot: 0.02, law: "slip", until: 1.5 },
    ]) {
      const page = await browser.section("drop", { hash: `#drop?${new URLSearchParams(controls)}` });
      const expected = await natively(controls), now = await shown(page, "drop");
      near(now.end, expected.info[C.DROP_TIME], same, "the end");
      expect(Number(now.events) === expected.info[C.DROP_EVENTS], `${now.events} events, not ${expected.info[C.DROP_EVENTS]}`);
      near(now.height, expected.info[C.DROP_MOTION + C.POSITION + 2], same, "the height in the end");
      near(now.tilt, tiltOf(expected.info.slice(C.DROP_MOTION, C.DROP_MOTION + C.MOTION_SIZE)), same, "the tilt in the end", 1);
      await page.context().close();
    }
  });

  await case_("between events it is where the native library says, and back again", async () => {
    const page = await browser.section("drop");
    const expected = await natively();
    const seen = [];
    for (const share of [0.01, 0.02, 0.1, 0.33, 0.5, 0.9]) {
      await seek(page, share);
      const there = await shown(page, "drop"), motion = await expected.at(Number(there.time));
      near(there.height, motion[C.POSITION + 2], same, `the height at ${there.time}`);
      near(there.tilt, tiltOf(motion), same, `the tilt at ${there.time}`, 1);
      seen.unshift([share, JSON.stringify(there)]);
    }
    for (const [share, what] of seen) {
      await seek(page, share);
      expect(JSON.stringify(await shown(page, "drop")) === what, `at ${share} it is another one on the way back`);
    }
    await page.context().close();
  });

  await case_("steps lead to the next event and the one before", async () => {
    const page = await browser.section("drop");
    const { times } = await natively();
    const different = [...new Set(times)];
    await seek(page, 0);
    await step(page, "step forward");
    await step(page, "step forward");
    const second = Number((await shown(page, "drop")).time);
    await step(page, "step forward");
    await step(page, "step back");
    expect(Number((await shown(page, "drop")).time) === second, "back is not where it was");
    near(second, different[2], same, "the second event");
    await page.locator(`${inside} .picture`).focus();
    await page.keyboard.press(".");
    near((await shown(page, "drop")).time, different[3], same, "the third event, by a key");
    await page.keyboard.press(",");
    expect(Number((await shown(page, "drop")).time) === second, "a key does not lead back");
    await page.context().close();
  });

  await case_("it plays forwards and backwards, stops at both ends, and rests then", async () => {
    const page = await browser.section("drop", { still: false });
    const time = async () => Number((await shown(page, "drop")).time);
    await page.locator(`${inside} .speeds input[value="1"]`).check({ force: true });
    await seek(page, 0.9);
    await page.locator(`${inside} .picture`).focus();
    await page.keyboard.press("Space");
    const end = Number((await shown(page, "drop")).end);
    await page.waitForFunction(([place, from]) => Number(document.querySelector(`${place} [data-name=time]`).dataset.value) > from, [inside, 0.9 * end],
      { timeout: 10000 });
    await page.waitForFunction((place) => document.querySelector(`${place} .round.main`).getAttribute("aria-label") === "play", inside);
    expect(await time() === end, `it stops at ${await time()}`);
    await seek(page, 0.05);
    await step(page, "play backwards");
    await page.waitForFunction((place) => document.querySelector(`${place} [data-name=time]`).dataset.value === "0.0000000000000000", inside);
    await settle(page);
    expect(await framesIn(page, 1000) === 0, "it goes on");
    await page.context().close();
  });

  await case_("spun, it rises to the tilt of Jellett's integral; with dry friction it does not", async () => {
    const page = await browser.section("drop");
    await start(page, "rises");
    const now = await shown(page, "drop");
    const [stone] = await native.call("catalogue_stone", { whole: 33 }, { whole: C.WHITE }, 0, { out: C.STONE_SIZE });
    const [m] = await native.call("measures", stone, { out: C.MEASURES_SIZE });
    // m g d D² = J² [I_t r² z + I_a r (d − r z)], D = I_t r² (1 − z²) + I_a (d − r z)², z = cos θ; J = I_a ω (r − d), spun flat.
    const [r, d, I_a, I_t, mass] = [C.SPHERE_RADIUS, C.SPHERE_OFFSET, C.AXIAL, C.TRANSVERSE, C.TRUE_MASS].map((place) => m[place]);
    const J = I_a * 60 * (r - d);
    const f = (z) => {
      const D = I_t * r * r * (1 - z * z) + I_a * (d - r * z) ** 2;
      return mass * 9.80665 * d * D * D - J * J * (I_t * r * r * z + I_a * r * (d - r * z));
    };
    let [low, high] = [Math.cos(0.7), Math.cos(0.5)];
    expect(f(low) * f(high) < 0, "the root is not there");
    for (let i = 0; i < 60; ++i) {
      const middle = (low + high) / 2;
      if (f(low) * f(middle) <= 0) high = middle;
      else low = middle;
    }
    const settled = (Math.acos(low) * 180) / Math.PI;
    near(now.tilt, settled, 1e-3, "the tilt"); // it was let go at half a degree, so J is a little less
    await start(page, "dry");
    expect(Number((await shown(page, "drop")).tilt) < 2, `with dry friction it rises to ${(await shown(page, "drop")).tilt}°`);
    await page.context().close();
  });

  await case_("rocking has its frequency", async () => {
    const page = await browser.section("drop", { hash: "#drop?height=0&tilt=0.5&spin=0&rolling=0&pivot=0&bevel=0&until=2" });
    await seek(page, 0.5);
    near((await shown(page, "drop")).wobble, 7.6869, 1e-3, "the frequency"); // ω² = m g d/(I_t + m a²), from the claims
    await page.context().close();
  });

  await case_("the talk's loop beside it is that of the library's parts", async () => {
    const page = await browser.section("drop");
    await page.locator(`${inside} input[data-name=loop]`).check();
    await seek(page, 0.5);
    const there = await shown(page, "drop"), expected = await natively();
    let state = expected.state, motion = null;
    const gravity = expected.settings.slice(C.GRAVITY, C.GRAVITY + 3);
    for (let i = 0; i <= Math.floor(Number(there.time) * 60 + 1e-9); ++i) {
      const [rows] = await native.call("flight", expected.stone, state, gravity, { whole: C.BOTH }, { whole: C.PUBLISHED }, 1 / 60, { whole: 1 },
        { out: 2 * C.FLIGHT_SIZE }, { one: 1 }, { one: 1 });
      motion = rows.slice(C.STEPPED, C.STEPPED + C.MOTION_SIZE);
      state = rows.slice(C.FLIGHT_SIZE + C.STEPPED, C.FLIGHT_SIZE + C.STEPPED + C.STATE_SIZE);
      const [touch] = await native.call("separation", expected.stone, state.slice(0, C.POSE_SIZE), expected.board, { out: C.SEPARATION_SIZE });
      if (touch[C.GAP] >= 0) continue;
      const normal = touch.slice(C.NORMAL, C.NORMAL + 3);
      normal.forEach((n, k) => (state[k] -= touch[C.GAP] * n));
      const [impact] = await native.call("impact", expected.stone, state, { whole: C.PUBLISHED_LAW }, 0.5, 0.3,
        touch.slice(C.OTHER_POINT, C.OTHER_POINT + 3), normal, { out: C.IMPACT_SIZE });
      state.splice(C.VELOCITY, 3, ...impact.slice(C.NEW_VELOCITY, C.NEW_VELOCITY + 3));
      state.splice(C.MOMENTUM, 3, ...impact.slice(C.NEW_MOMENTUM, C.NEW_MOMENTUM + 3));
    }
    const exact = await expected.at(Number(there.time));
    near(there.apart, Math.hypot(...[0, 1, 2].map((k) => exact[k] - motion[k])), same, "the distance");
    await page.context().close();
  });

  await case_("the stone can be lifted, tilted and let go", async () => {
    const page = await browser.section("drop");
    await seek(page, 0);
    await page.locator(`${inside} .frame`).scrollIntoViewIfNeeded();
    await settle(page);
    const before = await shown(page, "drop");
    const box = await page.locator(`${inside} .picture`).boundingBox();
    // Where the stone is: the hand looks for it, from above.
    let hit = null;
    for (let y = 0.1; y < 0.95 && !hit; y += 0.02) {
      const [px, py] = [box.x + box.width / 2, box.y + box.height * y];
      await page.mouse.move(px, py);
      await page.mouse.down();
      if (await page.locator(`${inside} .picture.held`).count()) hit = [px, py];
      else await page.mouse.up();
    }
    expect(hit, "there is no stone to seize");
    await page.mouse.move(hit[0] + 60, hit[1] - 50, { steps: 5 });
    await page.mouse.up();
    await settle(page);
    const after = await shown(page, "drop");
    const field = async (name) => Number(await page.locator(`${inside} input[data-name=${name}]`).inputValue());
    expect(await field("height") > 30 && await field("tilt") > 25, `height ${await field("height")}, tilt ${await field("tilt")}`);
    expect(after.end !== before.end, "it falls as before");
    await page.context().close();
  });

  await case_("every event is in the table, and leads there", async () => {
    const page = await browser.section("drop");
    await page.locator(`${inside} summary`).first().click();
    const rows = page.locator(`${inside} tbody tr`);
    expect(await rows.count() === Number((await shown(page, "drop")).events), `${await rows.count()} rows`);
    await rows.nth(5).locator("button").click();
    near(await rows.nth(5).locator("button").textContent(), Number((await shown(page, "drop")).time), 1e-4, "the time");
    await page.context().close();
  });

  await case_("what the graphics memory holds does not grow with the stones", async () => {
    const page = await browser.section("drop");
    const memory = () => page.evaluate(() => globalThis.goishiStage.memory.geometries);
    const slider = page.locator(`${inside} .control .slider[aria-label="bevel, mm"]`);
    await slider.focus();
    for (const key of ["ArrowUp", "ArrowDown", "ArrowUp"]) await page.keyboard.press(key);
    await settle(page);
    const before = await memory();
    for (let i = 0; i < 20; ++i) {
      await page.keyboard.press(i % 2 ? "ArrowUp" : "ArrowDown");
      await page.waitForTimeout(60);
    }
    await settle(page);
    expect(await memory() <= before, `${before} geometries, then ${await memory()}`);
    await page.context().close();
  });
}
