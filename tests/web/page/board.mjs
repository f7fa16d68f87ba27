// The board: what it shows is what the native library gives, and a link gives it again.

import { expect, framesIn, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=board]";
const rate = 120, bumped = 2;

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`board: ${name}`, run);
  const button = (page, label) => page.locator(`${inside} .hands button:has-text("${label}")`).click();
  const seek = async (page, time) => {
    await page.evaluate(([place, at]) => {
      const slider = document.querySelector(`${place} .timeline`);
      slider.value = String(at);
      slider.dispatchEvent(new Event("input"));
    }, [inside, time]);
    await settle(page);
  };
  const few = { stones: 24, height: 30, seed: 5 };
  const open = async (values, options = {}) => {
    const page = await browser.section("board", { hash: `#board?${new URLSearchParams(values)}`, ...options });
    await settle(page);
    return page;
  };

  // --- the scene of the controls, natively: what the page does is written here a second time

  const randomBy = (seed) => {
    let a = seed | 0;
    return () => {
      a = (a + 0x6d2b79f5) | 0;
      let t = Math.imul(a ^ (a >>> 15), 1 | a);
      t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
      return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
  };
  const printOf = (numbers) => {
    const words = new Uint32Array(Float64Array.from(numbers, (one) => one ?? NaN).buffer);
    let low = 0x811c9dc5, high = 0x01000193;
    for (const word of words) {
      low = Math.imul(low ^ word, 0x01000193);
      high = Math.imul(high ^ (word >>> 7) ^ low, 0x85ebca6b);
    }
    return (low >>> 0) + (high >>> 12) * 2 ** 32;
  };

  /** The scene of the controls and what is done to it, up to a moment, or until all rest. */
  async function natively({ stones = 180, height = 60, seed = 1, e = 0.4, mu = 0.3, as = "fall", do: deeds = "" } = {}, until = Infinity) {
    const [board] = await native.call("board", { out: C.BOARD_SIZE });
    const [settings] = await native.call("scene_settings", { out: C.SCENE_SETTINGS_SIZE });
    settings[C.RESTITUTION] = settings[C.STONES_RESTITUTION] = e;
    settings[C.FRICTION] = settings[C.STONES_FRICTION] = mu;
    settings[C.TOLERANCE] = 1e-4;
    const kinds = [], measures = [];
    for (const color of [C.WHITE, C.BLACK]) {
      kinds.push((await native.call("catalogue_stone", { whole: 33 }, { whole: color }, 1e-3, { out: C.STONE_SIZE }))[0]);
      measures.push((await native.call("measures", kinds.at(-1), { out: C.MEASURES_SIZE }))[0]);
    }
    const [handle] = await native.call("scene_create", board, settings, { one: 1 }), scene = { handle };
    const add = async (color, pose, velocity, spin) => {
      const [state] = await native.call("state", kinds[color], pose, velocity, spin, { out: C.STATE_SIZE });
      return (await native.call("scene_add", scene, kinds[color], state, { one: 1 }))[0] ?? 0;
    };
    const random = randomBy(seed), lines = board[C.BOARD_LINES], between = (least, greatest) => least + (greatest - least) * random();
    const all = Array.from({ length: lines * lines }, (_, i) => i);
    for (let i = all.length - 1; i > 0; --i) {
      const k = Math.floor(random() * (i + 1));
      [all[i], all[k]] = [all[k], all[i]];
    }
    const loose = as === "laid" ? 0 : 1;
    for (let i = 0; i < (as === "heap" ? Math.min(stones, 60) : stones); ++i) {
      const color = i % 2, at = (k, spacing) => (k - (lines - 1) / 2) * board[spacing];
      const place = as === "heap"
        ? [(i % 9 % 3 - 1) * 0.025, (Math.floor((i % 9) / 3) - 1) * 0.025, 1e-3 * height / 2 + 0.014 + 0.025 * Math.floor(i / 9)]
        : [at(all[i] % lines, C.BOARD_SPACING_X), at(Math.floor(all[i] / lines), C.BOARD_SPACING_Y),
          as === "laid" ? measures[color][C.MEASURE_HEIGHT] / 2 : 0.014 + 1e-3 * height * random()];
      const turned = () => loose * between(-0.25, 0.25), pace = () => loose * between(-0.05, 0.05), spin = () => loose * between(-5, 5);
      const pose = [...place, 1, turned(), turned(), turned()];
      await add(color, pose, [pace(), pace(), 0], [spin(), spin(), spin()]);
    }
    const due = [];
    for (const part of deeds.split("~").filter(Boolean)) {
      const [head, ...rest] = part.split("."), of = rest.map(Number), at = Number(head.slice(1));
      const put = (when, run) => due.push({ when, run });
      const si = (from, scale) => of.slice(from, from + 3).map((x) => x / scale);
      switch (head[0]) {
        case "b": {
          const raised = [...settings];
          raised[C.GRAVITY + 2] = of[0] / 1e3;
          put(at, () => native.call("scene_change", scene, raised));
          put(at + bumped, () => native.call("scene_change", scene, settings));
          break;
        }
        case "p": put(at, () => native.call("scene_push", scene, { size: of[0] }, si(1, 1e5), si(4, 1e6))); break;
        case "h": put(at, () => native.call("scene_hold", scene, { size: of[0] }, si(1, 1e3), [0, 0, 0], of[4] / rate)); break;
        case "r": put(at, () => native.call("scene_release", scene, { size: of[0] })); break;
        case "t": put(at, () => add(of[0], [...si(1, 1e5), 1, of[7] / 100, 0, 0], si(4, 1e3), [0, 0, of[8]])); break;
        case "l": {
          const low = measures[of[0]][C.MEASURE_HEIGHT] / 2 + 3e-4, moments = Math.ceil(((0.06 - low) / 0.4) * rate);
          let id = 0;
          put(at, async () => {
            id = await add(of[0], [of[1] / 1e5, of[2] / 1e5, 0.06, 1, 0, 0, 0], [0, 0, 0], [0, 0, 0]);
            await native.call("scene_hold", scene, { size: id }, [0, 0, -((0.06 - low) * rate) / moments], [0, 0, 0], moments / rate);
          });
          put(at + moments, () => native.call("scene_release", scene, { size: id }));
          break;
        }
        default: throw new Error(`what is ${part}?`);
      }
    }
    due.sort((a, b) => a.when - b.when);
    const info = async () => (await native.call("scene_info", scene, { out: C.SCENE_SIZE }))[0];
    let moment = 0, now = await info();
    while (moment < Math.min(until, 40 * rate) && (now[C.SCENE_MOVING] > 0 || due.length > 0)) {
      while (due.length > 0 && due[0].when <= moment) await due.shift().run();
      ++moment;
      await native.call("scene_advance_to", scene, moment / rate);
      now = await info();
    }
    const count = now[C.SCENE_STONES], [rows] = await native.call("scene_stones", scene, { size: 0 }, { out: count * C.SCENE_STONE_SIZE });
    let flat = 0;
    for (let i = 0; i < count; ++i) {
      const one = measures[rows[i * C.SCENE_STONE_SIZE + C.SCENE_STONE_ID] % 2]; // of those that were there at first
      flat -= (one[C.TRUE_MASS] * settings[C.GRAVITY + 2] * one[C.MEASURE_HEIGHT]) / 2;
    }
    const [, touching] = await native.call("scene_contacts", scene, { out: 4000 * C.SCENE_CONTACT_SIZE }, { one: 1 });
    const modes = [0, 0, 0, 0, 0];
    for (let i = 0; i < count; ++i) modes[rows[i * C.SCENE_STONE_SIZE + C.SCENE_STONE_MODE]]++;
    return { time: moment / rate, moment, info: now, energy: now[C.SCENE_ENERGY] - flat, print: printOf(rows), modes, count, touching: touching ?? 0 };
  }
  const compare = async (page, expected, energy = true) => {
    const now = await shown(page, "board");
    expect(Number(now.print) === expected.print, `the stones are others: ${now.print}, not ${expected.print}`);
    expect(Number(now.time) === expected.time, `the time is ${now.time}, not ${expected.time}`);
    expect(Number(now.stones) === expected.count, `${now.stones} stones, not ${expected.count}`);
    expected.modes.forEach((count, i) => expect(Number(now[`mode-${i}`]) === count, `${now[`mode-${i}`]} stones go on so (${i}), not ${count}`));
    for (const [name, place] of [["impacts", C.SCENE_PAIR_IMPACTS], ["steps", C.SCENE_STONE_STEPS], ["separations", C.SCENE_SEPARATIONS]]) {
      expect(Number(now[name]) === expected.info[place], `${name}: ${now[name]}, not ${expected.info[place]}`);
    }
    if (energy) near(now.energy, expected.energy, 1e-12, "the energy", 1);
  };

  await case_("where all stones are is what the native library says, to the last bit", async () => {
    for (const values of [few, { stones: 40, e: 0.6, mu: 0.15, seed: 77 }, { stones: 12, as: "heap", height: 20 }, { stones: 60, as: "laid" }]) {
      const page = await open(values);
      const expected = await natively(values);
      expect(expected.info[C.SCENE_MOVING] === 0, "it does not come to rest");
      await compare(page, expected);
      await page.context().close();
    }
  });

  await case_("so it is at a moment of the past, and the way back", async () => {
    const page = await open(few);
    const end = Number((await shown(page, "board")).time), expected = await natively(few, 30);
    await seek(page, 1e4 * (30 / rate) / end);
    const there = await shown(page, "board");
    expect(Math.floor(Number(there.time) * rate + 1e-6) === 30 && Number(there.print) === expected.print, `after ${there.time} s it is another scene`);
    near(there.energy, expected.energy, 1e-12, "the energy", 1);
    await page.context().close();
  });

  await case_("forces are those of the native library, also in the past", async () => {
    const page = await open(few);
    await page.locator(`${inside} input[data-name=forces]`).check();
    const end = Number((await shown(page, "board")).time);
    for (const until of [Infinity, 40, 20]) {
      const expected = await natively(few, until);
      await seek(page, until === Infinity ? 1e4 : 1e4 * (until / rate) / end);
      expect(Number((await shown(page, "board")).contacts) === expected.touching, `${(await shown(page, "board")).contacts} contacts, not ${expected.touching}`);
    }
    await page.context().close();
    // What was done before is done in the past, too.
    const laid = { stones: 9, as: "laid", do: "b3.60000" }, bumped_ = await open({ ...laid, forces: 1 });
    const whole = Number((await shown(bumped_, "board")).time), flying = await natively(laid, 12);
    expect(flying.touching === 0, "nothing hops");
    await seek(bumped_, 1e4 * (12 / rate) / whole);
    expect(Number((await shown(bumped_, "board")).contacts) === 0, `${(await shown(bumped_, "board")).contacts} contacts of stones in the air`);
    await bumped_.context().close();
  });

  await case_("whatever is done is in the link, which shows the same, to the last bit", async () => {
    const page = await open(few);
    for (const label of ["bump", "push", "throw", "lay"]) {
      const before = await shown(page, "board");
      await button(page, label);
      await settle(page);
      const after = await shown(page, "board");
      expect(after.print !== before.print && Number(after.time) > Number(before.time), `“${label}” does nothing`);
    }
    const hash = new URL(page.url()).hash, deeds = new URLSearchParams(hash.split("?")[1]).get("do");
    expect(/^b\d+\.\d+~p.*~t.*~l/.test(deeds ?? ""), `the address is ${hash}`);
    await compare(page, await natively({ ...few, do: deeds }), false);
    const again = await browser.section("board", { hash });
    await settle(again);
    expect((await shown(again, "board")).print === (await shown(page, "board")).print, "the link shows another scene");
    await again.context().close();
    // And while it plays, cut into frames as they come.
    const playing = await browser.section("board", { hash, still: false });
    await playing.waitForFunction((place) => document.querySelector(`${place} .round.main`).getAttribute("aria-label") === "play", inside, { timeout: 60000 });
    await settle(playing);
    expect((await shown(playing, "board")).print === (await shown(page, "board")).print, "played it is another scene");
    await playing.context().close();
    await page.context().close();
  });

  await case_("what is done in the past takes the place of what came after, and keeps what was before", async () => {
    const page = await open(few);
    const deeds = () => new URLSearchParams(new URL(page.url()).hash.split("?")[1]).get("do") ?? "";
    const at = async (share, label) => {
      await seek(page, 1e4 * share);
      const then = Number((await shown(page, "board")).time);
      await button(page, label);
      await settle(page);
      expect(Math.abs(Number(/(\d+)[^~]*$/.exec(deeds().split("~").at(-1).slice(1))[0].split(".")[0]) / rate - then) < 1 / rate, `${deeds()}: the last is not at ${then} s`);
      await compare(page, await natively({ ...few, do: deeds() }), false);
    };
    const kinds = () => deeds().split("~").map((one) => one[0]).join("");
    await at(0.05, "bump");
    await at(0.9, "throw");
    expect(kinds() === "bt", `${kinds()}: both are kept`);
    await at(0.3, "push");
    expect(kinds() === "bp", `${kinds()}: the throw came after`);
    await at(0.01, "lay");
    expect(kinds() === "l", `${kinds()}: all else came after`);
    await page.context().close();
  });

  /** Where a point [mm] is seen in the window. */
  const seen = (page, point) => page.evaluate(([place, at]) => {
    const element = document.querySelector(`${place} .picture`), { x, y } = globalThis.goishiStage.where(element, at), box = element.getBoundingClientRect();
    return [box.left + x, box.top + y];
  }, [inside, point]);

  await case_("a click pushes a stone, and lays one down where none is", async () => {
    const page = await open({ stones: 361, as: "laid" });
    await page.locator(`${inside} .frame`).scrollIntoViewIfNeeded();
    await settle(page);
    await page.mouse.click(...await seen(page, [0, 0, 6]));
    await settle(page);
    const deeds = () => new URLSearchParams(new URL(page.url()).hash.split("?")[1]).get("do") ?? "";
    expect(/^p\d+\./.test(deeds()), `a stone is there, and what is done is “${deeds()}”`);
    await page.context().close();
    const free = await open({ stones: 1, as: "laid", seed: 3 });
    await free.locator(`${inside} .frame`).scrollIntoViewIfNeeded();
    await settle(free);
    await free.mouse.click(...await seen(free, [22, 23.7, 0]));
    await settle(free);
    const done = new URLSearchParams(new URL(free.url()).hash.split("?")[1]).get("do");
    expect(/^l\d+\.0\.2200\.2370$/.test(done ?? ""), `what is done is “${done}”`);
    expect((await shown(free, "board"))["mode-3"] === "2.0000000000000000", "the two do not rest");
    await free.context().close();
  });

  await case_("a hand carries a stone and throws it", async () => {
    const page = await open({ stones: 361, as: "laid" });
    await page.locator(`${inside} .frame`).scrollIntoViewIfNeeded();
    await settle(page);
    const [x, y] = await seen(page, [0, 0, 6]);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 20; ++i) {
      await page.mouse.move(x + 6 * i, y - 2 * i);
      await page.waitForTimeout(30);
    }
    await page.mouse.up();
    await page.waitForFunction((place) => document.querySelector(`${place} .round.main`).getAttribute("aria-label") === "play", inside, { timeout: 30000 });
    await settle(page);
    const deeds = new URLSearchParams(new URL(page.url()).hash.split("?")[1]).get("do") ?? "";
    expect(/^h\d+\./.test(deeds) && /~r\d+\.\d+$/.test(deeds), `what is done is “${deeds}”`);
    await compare(page, await natively({ stones: 361, as: "laid", do: deeds }), false);
    expect(Number((await shown(page, "board"))["mode-4"]) === 0, "it is still held");
    await page.context().close();
  });

  await case_("nonsense in a link does nothing", async () => {
    const page = await open(few), print = (await shown(page, "board")).print;
    const follow = async (deeds) => {
      await page.evaluate((hash) => (location.hash = hash), `#board?${new URLSearchParams({ ...few, do: deeds })}`);
      await settle(page);
      return (await shown(page, "board")).print;
    };
    for (const deeds of ["x1.2", "b", "b1", "b1.0", "b1.999999", "p1.2.3", "b9999.5", "b5.100~b4.100", "b1.1e3", "p1.-1.0.0.0.0.0.0", "b1.5~", "~".repeat(50), "b1.100000 "]) {
      expect(await follow(deeds) === print, `“${deeds}” does something`);
    }
    // Right in form, and refused by the library: a stone that is not there, one that no hand holds.
    expect(await follow("r3.2~p5.3999.0.0.0.100.0.0") === print, "a stone that is not there is pushed");
    expect(await follow("b5.30000") !== print, "what is done by a link is not done");
    await page.context().close();
  });

  await case_("what it says of simulated time is true", async () => {
    const page = await browser.section("board", { still: false, hash: "#board?stones=361" });
    const read = () => page.evaluate((place) => ({ time: Number(document.querySelector(`${place} .clock [data-name=time], ${place} .clock`).dataset.value), at: performance.now(),
      pace: document.querySelector(`${place} [data-name=pace]`).textContent }), inside);
    await page.waitForTimeout(600);
    const one = await read();
    await page.waitForTimeout(2000);
    const two = await read(), share = (two.time - one.time) / ((two.at - one.at) / 1000), told = /× ([\d.]+)/.exec(two.pace);
    console.log(`      × ${share.toFixed(2)} by the clock; it says “${two.pace}”`);
    expect(told ? Number(told[1]) < 4 * share + 0.1 : share > 0.7 || /at rest/.test(two.pace), "it goes slowly and does not say so");
    await page.context().close();
  });

  await case_("a resting full board draws no frame, and no stone is computed", async () => {
    const page = await open({ stones: 361, as: "laid" });
    const before = await shown(page, "board"), frames = await framesIn(page, 2000);
    expect(frames === 0, `${frames} frames`);
    expect(Number(before.steps) === 0 && Number(before["mode-3"]) === 361, `${before.steps} steps, ${before["mode-3"]} rest`);
    await page.context().close();
  });
}
