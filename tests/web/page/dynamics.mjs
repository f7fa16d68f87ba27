// Dynamics: what it shows is what the native library gives.

import { difference, expect, framesIn, middle, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=dynamics]";
const attitude = [0.11, 0.51, 0.09, 0.85], g = 9.80665;
// The two libraries give the same bits; what is left are the page's own units.
const close = 1e-13;

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`dynamics: ${name}`, run);
  const schemes = { published: C.PUBLISHED, euler: C.EXPLICIT_EULER, rk4: C.RUNGE_KUTTA_4, splitting: C.SPLITTING_6 };
  const freedoms = { rotation: C.ANGULAR, gravity: C.LINEAR, both: C.BOTH };
  const seek = (page, share) => page.evaluate(([place, at]) => {
    const slider = document.querySelector(`${place} .timeline`);
    slider.value = String(at * 10000);
    slider.dispatchEvent(new Event("input"));
  }, [inside, share]);
  const pick = (page, name, value) => page.locator(`${inside} fieldset[data-name=${name}] input[value=${value}]`).check({ force: true });
  const write = (page, name, value) => page.locator(`${inside} input.number[data-name=${name}]`).fill(String(value));

  /** The flight of the controls, natively: rows of FLIGHT_SIZE, one after each step. */
  async function natively({ loop = "published", moves = "rotation", step = 1000 / 60, about = 6, across = 5, up = 1.2 } = {}) {
    const [stone] = await native.call("catalogue_stone", { whole: 33 }, { whole: C.WHITE }, 1e-3, { out: C.STONE_SIZE });
    const flies = moves !== "rotation", turns = moves !== "gravity";
    const end = flies ? (2 * up) / g : 10, velocity = flies ? [0.4 * up, 0, up] : [0, 0, 0];
    const [state] = await native.call("state", stone, [(-velocity[0] * end) / 2, 0, 0, ...attitude], velocity, turns ? [across, 0, about] : [0, 0, 0],
      { out: C.STATE_SIZE });
    const steps = Math.floor(end / (step * 1e-3) + 1e-9);
    const [all] = await native.call("flight", stone, state, [0, 0, -g], { whole: freedoms[moves] }, { whole: schemes[loop] }, step * 1e-3, { whole: 1 },
      { out: (steps + 1) * C.FLIGHT_SIZE }, { one: 1 }, { one: 1 });
    const row = (k) => all.slice(k * C.FLIGHT_SIZE, (k + 1) * C.FLIGHT_SIZE);
    const norm = (v) => Math.hypot(...v);
    const L = (k) => row(k).slice(C.STEPPED + C.MOMENTUM, C.STEPPED + C.MOMENTUM + 3);
    return {
      steps, row, end,
      energy: (k) => row(k)[C.STEPPED + C.ENERGY] / row(0)[C.STEPPED + C.ENERGY] - 1,
      momentum: (k) => norm(L(k).map((value, i) => value - L(0)[i])) / norm(L(0)),
    };
  }
  /** What is shown is the native row of its step. */
  async function compare(page, given) {
    const there = await shown(page, "dynamics"), expected = await natively(given), step = Number(there["step-count"]);
    const row = expected.row(step), what = `${JSON.stringify(given)} after step ${step}`;
    const due = Math.floor(Number(there.time) / expected.row(1)[C.FLIGHT_TIME] + 1e-9);
    expect(due - step < (given.every ?? 1) && step <= due, `the step is ${step} at ${there.time} s, which is in step ${due}`);
    if (given.moves !== "gravity") {
      near(there["attitude-error"], row[C.ATTITUDE_ERROR], close, `the attitude's error, ${what}`, 1);
      near(there.momentum, expected.momentum(step), close, `the momentum, ${what}`, 1);
    }
    if ((given.moves ?? "rotation") !== "rotation") near(there["place-error"], row[C.POSITION_ERROR], close, `the distance, ${what}`, 1e-3);
    near(there.energy, expected.energy(step), close, `the energy, ${what}`, 1);
    return { there, expected, step };
  }

  await case_("loop and ghost are seen where their numbers say", async () => {
    const page = await browser.section("dynamics", { hash: "#dynamics?moves=gravity&step=50" });
    const flight = await natively({ moves: "gravity", step: 50 });
    await seek(page, (flight.steps * 0.05) / flight.end);
    await settle(page);
    const row = flight.row(flight.steps), place = (from) => row.slice(from + C.POSITION, from + C.POSITION + 3).map((value) => 1e3 * value);
    const picture = page.locator(`${inside} .picture`), color = async (point) => {
      const [x, y] = await page.evaluate(([where, at]) => {
        const element = document.querySelector(where), { x, y } = globalThis.goishiStage.where(element, at);
        return [x, y];
      }, [`${inside} .picture`, point]);
      const box = await picture.boundingBox();
      return middle(page, await page.screenshot({ clip: { x: box.x + x - 3, y: box.y + y - 3, width: 6, height: 6 } }));
    };
    const [ghost, loop] = [await color(place(C.EXACTLY)), await color(place(C.STEPPED))];
    const teal = ([red, green]) => green - red;
    expect(teal(ghost) > 12, `the ghost's middle is ${ghost}`);
    expect(teal(loop) < 4, `the loop's middle is ${loop}`);
    await page.context().close();
  });

  await case_("errors, energy and momentum are those of the native library, by each loop and motion", async () => {
    const page = await browser.section("dynamics");
    for (const moves of Object.keys(freedoms)) {
      await pick(page, "moves", moves);
      for (const loop of Object.keys(schemes)) {
        await pick(page, "loop", loop);
        for (const share of [0.13, 0.77]) {
          await seek(page, share);
          await compare(page, { moves, loop });
        }
      }
    }
    await page.context().close();
  });

  await case_("so they are with other values", async () => {
    const page = await browser.section("dynamics");
    for (const given of [{ step: 4 }, { about: -11.5 }, { across: 0 }, { about: 19.25, across: 9.14, loop: "euler" }, { step: 50, loop: "rk4", about: 40 },
      { up: 1.9, moves: "both" }, { up: 0.5, moves: "gravity", step: 1 }]) {
      await page.evaluate((hash) => (location.hash = hash), `dynamics?${Object.entries(given).map(([name, value]) => `${name}=${value}`).join("&")}`);
      await settle(page);
      await compare(page, given);
    }
    await page.evaluate(() => (location.hash = "dynamics"));
    await settle(page);
    await write(page, "step", 7);
    await write(page, "about", 9);
    await compare(page, { step: 7, about: 9 });
    await page.context().close();
  });

  await case_("what was published: energy and the size of L stay, L goes round, and a smaller step changes nothing", async () => {
    const page = await browser.section("dynamics");
    for (const step of [16, 4, 1]) {
      await write(page, "step", step);
      await seek(page, 0.04);
      const there = await shown(page, "dynamics");
      expect(Math.abs(there.energy) < 1e-12, `the energy is off by ${there.energy}`);
      expect(there.momentum > 0.4, `L is off by ${there.momentum}`);
      near(there["attitude-error"], 1.03, 0.1, "the error"); // after 0.4 s, whatever the step
    }
    await page.context().close();
  });

  await case_("Euler with L kept gains energy as the talk's other program did", async () => {
    const page = await browser.section("dynamics", { hash: "#dynamics?loop=euler&about=19.2499&across=9.1408" });
    const there = await shown(page, "dynamics");
    expect(Number(there.momentum) === 0, `L is off by ${there.momentum}`);
    near(there.energy, 0.614, 0.005, "the energy"); // 61.7 % of the sharp stone, PUBLISHED-9; this one has a bevel
    await page.context().close();
  });

  await case_("Runge and Kutta's error goes with the fourth power of the step, the splitting's with the sixth", async () => {
    const page = await browser.section("dynamics");
    for (const [loop, order] of [["rk4", 4], ["splitting", 6]]) {
      await pick(page, "loop", loop);
      const errors = [];
      for (const step of [20, 10]) {
        await write(page, "step", step);
        await seek(page, 0.5);
        errors.push(Number((await shown(page, "dynamics"))["attitude-error"]));
      }
      near(Math.log2(errors[0] / errors[1]), order, 0.06, `the order of ${loop}`);
    }
    await page.context().close();
  });

  await case_("the talk's parabola falls behind by g t Δt/2", async () => {
    const page = await browser.section("dynamics", { hash: "#dynamics?moves=gravity&step=10" });
    const there = await shown(page, "dynamics");
    near(there.time, (2 * 1.2) / g, close, "the end, where it is exactly as high as at first");
    near(there["place-error"], (g * Number(there["step-count"]) * 0.01 * 0.01) / 2, 1e-9, "the distance");
    await page.context().close();
  });

  await case_("a flash of the strobe shows one step, and goes on with the next", async () => {
    const page = await browser.section("dynamics", { hash: "#dynamics?moves=both&seen=strobe" });
    const seen = new Set();
    for (let i = 0; i <= 20; ++i) {
      await seek(page, i / 20);
      seen.add((await compare(page, { moves: "both", every: 2 })).step);
    }
    const steps = [...seen];
    expect(steps.length === 8 && steps.every((step, i) => step === 2 * i), `flashes after ${steps.join()}`);
    await page.context().close();
  });

  await case_("between two steps it is drawn on the way, by strobe with what was before", async () => {
    const page = await browser.section("dynamics", { hash: "#dynamics?step=50" });
    await page.evaluate(() => document.querySelectorAll(".overlay").forEach((one) => (one.style.visibility = "hidden")));
    const at = async (share) => {
      await seek(page, share);
      await settle(page);
      return page.locator(`${inside} .picture`).screenshot();
    };
    const [first, nearly, next] = [await at(0.2), await at(0.2049), await at(0.205)];
    const [little, much] = [await difference(page, nearly, next), await difference(page, first, next)];
    expect(much > 1000 && little < 0.2 * much, `${little} pixels change in 1 ms, ${much} in 50`);
    await pick(page, "seen", "strobe");
    expect(await difference(page, await at(0.2049), first) === 0, "a flash does not last");
    await pick(page, "moves", "both");
    await write(page, "step", 10);
    const flashes = await at(0.981); // just after step 24, a flash
    await pick(page, "seen", "smooth");
    const before = await difference(page, flashes, await at(0.981));
    expect(before > 5000, `of what was before there are ${before} pixels`);
    await page.context().close();
  });

  await case_("single steps are those of the loop", async () => {
    const page = await browser.section("dynamics");
    await seek(page, 0.1001);
    const press = (label) => page.locator(`${inside} button[aria-label="${label}"]`).click();
    for (const [label, step] of [["step forward", 61], ["step forward", 62], ["step back", 61], ["step back", 60]]) {
      await press(label);
      const there = await shown(page, "dynamics");
      expect(Number(there["step-count"]) === step, `${label}: ${there["step-count"]}, not ${step}`);
      near(there.time, step / 60, 1e-12, "the time");
    }
    await page.locator(`${inside} .picture`).focus();
    await page.keyboard.press(".");
    expect((await shown(page, "dynamics"))["step-count"] === "61.000000000000000", "a key makes no step");
    await page.context().close();
  });

  await case_("another loop at the same moment, another spin from the start", async () => {
    const page = await browser.section("dynamics", { still: false });
    await seek(page, 0.3);
    await pick(page, "loop", "euler");
    await settle(page);
    near((await shown(page, "dynamics")).time, 3, 1e-12, "the time");
    await write(page, "across", 7);
    await page.waitForTimeout(400);
    const { time } = await shown(page, "dynamics");
    expect(Number(time) < 3, `it goes on at ${time} s`);
    await page.locator(`${inside} button[aria-label=pause]`).click();
    await settle(page);
    expect(await framesIn(page, 500) === 0, "it goes on when it is paused");
    await page.context().close();
  });

  await case_("the arrow of the spin can be drawn, and the stone thrown", async () => {
    for (const [hash, names] of [["#dynamics", ["about", "across"]], ["#dynamics?moves=gravity", ["up"]]]) {
      const page = await browser.section("dynamics", { hash });
      await seek(page, 0);
      await page.locator(`${inside} .frame`).scrollIntoViewIfNeeded();
      await settle(page);
      const box = await page.locator(`${inside} .picture`).boundingBox();
      const value = async () => Promise.all(names.map(async (name) => Number(await page.locator(`${inside} input.number[data-name=${name}]`).inputValue())));
      const before = await value(), error = await shown(page, "dynamics");
      let hit = null; // where the stone is: the hand looks for it
      for (let x = 0.3; x < 0.7 && !hit; x += 0.02) {
        for (let y = 0.4; y < 0.9 && !hit; y += 0.05) {
          const at = [box.x + box.width * x, box.y + box.height * y];
          await page.mouse.move(...at);
          await page.mouse.down();
          if (await page.locator(`${inside} .picture.held`).count()) hit = at;
          else await page.mouse.up();
        }
      }
      expect(hit, "there is no stone to seize");
      await page.mouse.move(hit[0] + 50, hit[1] - 40, { steps: 4 });
      await page.mouse.up();
      await settle(page);
      const after = await value(), other = await shown(page, "dynamics");
      expect(after.every((one, i) => one > before[i]), `${names}: ${before}, then ${after}`); // drawn along with the arrow, or up
      expect(JSON.stringify(error) !== JSON.stringify(other), "it flies as before");
      await page.context().close();
    }
  });

  await case_("a stone that does not turn", async () => {
    const page = await browser.section("dynamics", { hash: "#dynamics?about=0&across=0" });
    const there = await shown(page, "dynamics");
    expect(Number(there["attitude-error"]) < 1e-15, `it turns by ${there["attitude-error"]}`);
    await page.context().close();
  });
}
