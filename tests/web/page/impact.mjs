// Collision response: what it shows is what the native library gives.

import { difference, expect, fingerprint, near, settle, shown } from "./harness.mjs";

const inside = "[data-section=impact]";
const same = 1e-13; // the two libraries give the same bits; what is left are the page's own units
const ways = ["linear", "angular", "talk", "stronge", "default"];

export async function test({ browser, cases, native, C }) {
  const case_ = (name, run) => cases.run(`impact: ${name}`, run);
  const call = async (...given) => (await native.call(...given))[0];
  const laws = { linear: C.CHATTERJEE_RUINA, angular: C.CHATTERJEE_RUINA, talk: C.PUBLISHED_LAW, stronge: C.STRONGE, default: C.CHATTERJEE_RUINA };
  const seek = (page, share) => page.evaluate(([place, at]) => {
    const slider = document.querySelector(`${place} .timeline`);
    slider.value = String(at * 10000);
    slider.dispatchEvent(new Event("input"));
  }, [inside, share]);

  /** One impact, natively: by its definition, not by the page's way of asking for parts of it. */
  async function natively({ tilt = 40, down = 0.6, along = 0.25, tumble = 0, spin = 30, e = 0.5, mu = 0.3, bevel = 1 }) {
    const stone = await call("catalogue_stone", { whole: 33 }, { whole: C.WHITE }, bevel * 1e-3, { out: C.STONE_SIZE });
    const measures = await call("measures", stone, { out: C.MEASURES_SIZE }), half = (tilt * Math.PI) / 360;
    const pose = (z) => [0, 0, z, Math.cos(half), 0, Math.sin(half), 0];
    const plane = [0, 0, 1, 0], separation = (z) => call("separation", stone, pose(z), plane, { out: C.SEPARATION_SIZE });
    const z = 1 - (await separation(1))[C.GAP], touch = await separation(z);
    const state = await call("state", stone, pose(z), [along, 0, -down], [0, tumble, spin], { out: C.STATE_SIZE });
    const point = touch.slice(C.POINT, C.POINT + 3);
    const cross = ([a, b, c], [x, y, u]) => [b * u - c * y, c * x - a * u, a * y - b * x], inner = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
    const u = [Math.sin(2 * half), 0, Math.cos(2 * half)]; // its axis
    const turning = (L) => { // ω = L/I_t + (1/I_a − 1/I_t)(u · L) u
      const by = (1 / measures[C.AXIAL] - 1 / measures[C.TRANSVERSE]) * inner(u, L);
      return L.map((x, i) => x / measures[C.TRANSVERSE] + by * u[i]);
    };
    const pointVelocity = (v, L) => cross(turning(L), point.map((x, i) => x - state[i])).map((x, i) => x + v[i]);
    const energy = (v, L) => (measures[C.TRUE_MASS] * inner(v, v) + inner(L, turning(L))) / 2;
    const v = state.slice(C.VELOCITY, C.VELOCITY + 3), L = state.slice(C.MOMENTUM, C.MOMENTUM + 3);
    const answers = {};
    for (const way of ways) {
      const frictionless = way === "linear" || way === "angular";
      const found = way === "linear" // the talk's j = −(1 + e) p · n
        ? { impulse: [0, 0, (1 + e) * measures[C.TRUE_MASS] * down], v: [along, 0, e * down], L }
        : await call("impact", stone, state, { whole: laws[way] }, e, frictionless ? 0 : mu, point, [0, 0, 1], { out: C.IMPACT_SIZE })
          .then((row) => ({ impulse: row.slice(C.IMPULSE, C.IMPULSE + 3), v: row.slice(C.NEW_VELOCITY, C.NEW_VELOCITY + 3), L: row.slice(C.NEW_MOMENTUM, C.NEW_MOMENTUM + 3) }));
      const after = pointVelocity(found.v, found.L);
      answers[way] = { normal: found.impulse[2], across: Math.hypot(found.impulse[0], found.impulse[1]), slip: Math.hypot(after[0], after[1]),
        rebound: -after[2] / pointVelocity(v, L)[2], energy: energy(found.v, found.L) };
    }
    /** W x = x/m + (I⁻¹ (r × x)) × r. */
    const respond = (x) => pointVelocity(x.map((one) => one / measures[C.TRUE_MASS]), cross(point.map((one, i) => one - state[i]), x));
    return { before: energy(v, L), answers, mobility: [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(respond), velocity: pointVelocity(v, L) };
  }

  const scenes = [{}, { tilt: 0, spin: 0 }, { tilt: 75, down: 1.2, along: -0.4, e: 0.2, mu: 0.8 }, { tilt: 40, tumble: -40, spin: -90, e: 0.9, mu: 0.1 },
    { tilt: 20, e: 0, mu: 1, bevel: 0 }, { tilt: 90, spin: 0, mu: 0, e: 1 }];

  await case_("five answers are those of the native library", async () => {
    let coupled = 0;
    for (const scene of scenes) {
      const text = Object.entries(scene).map(([key, value]) => `${key}=${value}`).join("&");
      const page = await browser.section("impact", { hash: `#impact?${text}` });
      const now = await shown(page, "impact"), { before, answers } = await natively(scene), e = scene.e ?? 0.5, mu = scene.mu ?? 0.3;
      near(now["energy-before"], before, same, "the energy before");
      for (const way of ways) {
        for (const name of ["normal", "across"]) near(now[`${way}-${name}`], answers[way][name], same, `${text} ${way} ${name}`, answers[way].normal);
        near(now[`${way}-energy`], answers[way].energy, same, `${text} ${way} energy`, before);
        near(now[`${way}-rebound`], answers[way].rebound, same, `${text} ${way} rebound`, 1);
        if (way === "linear") continue;
        expect(Number(now[`${way}-across`]) <= mu * Number(now[`${way}-normal`]) * (1 + 1e-12), `${text} ${way}: out of the cone`);
        expect(Number(now[`${way}-energy`]) <= before * (1 + 1e-12), `${text} ${way} gains energy`);
      }
      for (const way of ["angular", "default"]) near(now[`${way}-rebound`], e, 1e-12, `${text} ${way}: the rebound`, 1);
      if (Math.abs(Number(now["talk-rebound"]) - e) > 0.05) coupled++;
      await page.context().close();
    }
    expect(coupled >= 3, `the talk's law rebounds with e but in ${coupled} scenes`);
  });

  await case_("a point that leaves gets no impulse", async () => {
    const page = await browser.section("impact", { hash: "#impact?down=0.05&tilt=60&tumble=-60&spin=0" });
    const now = await shown(page, "impact"), { before, velocity } = await natively({ down: 0.05, tilt: 60, tumble: -60, spin: 0 });
    expect(velocity[2] > 0, `it approaches with ${-velocity[2]} m/s`);
    for (const way of ["angular", "talk", "stronge", "default"]) {
      expect(Number(now[`${way}-normal`]) === 0 && Number(now[`${way}-across`]) === 0, `${way} gives an impulse`);
      near(now[`${way}-energy`], before, same, `${way}: the energy`);
    }
    expect(now.rebound === "NaN" && Number(now.outcome) === C.SEPARATING, `it rebounds with ${now.rebound}, outcome ${now.outcome}`);
    await page.context().close();
  });

  await case_("what is chosen is said over the picture", async () => {
    const page = await browser.section("impact", {});
    const { before, answers } = await natively({});
    const seen = new Set();
    for (const way of ways) {
      await page.locator(`${inside} fieldset[data-name=answer] input[value=${way}]`).check({ force: true });
      await settle(page);
      const now = await shown(page, "impact");
      near(now.rebound, answers[way].rebound, same, `${way}: the rebound`, 1);
      near(now.slips, answers[way].slip, same, `${way}: the slip`, 1);
      near(now.kept, answers[way].energy / before, same, `${way}: what is kept`);
      expect((await page.locator(`${inside} .answers tr.picked`).count()) === 1, "its row is not marked");
      seen.add(await fingerprint(page, "impact"));
    }
    expect(seen.size === ways.length, `${seen.size} different pictures of ${ways.length} answers`);
    await page.context().close();
  });

  await case_("time runs both ways, and a step leads to the impact", async () => {
    const page = await browser.section("impact", {});
    await page.locator(`${inside} .picture`).focus(); // its frame is seen in the pictures
    await seek(page, 0);
    const before = Number((await shown(page, "impact")).moment);
    expect(before < 0, `it begins ${before} s after`);
    const picture = async () => {
      await settle(page);
      return page.locator(`${inside} .frame`).screenshot();
    };
    const start = await picture();
    await page.keyboard.press(".");
    expect(Number((await shown(page, "impact")).moment) === 0, "a step does not lead to the impact");
    const there = await picture();
    await page.keyboard.press(".");
    const end = await shown(page, "impact");
    expect(Number(end.moment) > 0.001, `it ends ${end.moment} s after`);
    const after = await picture();
    for (const [a, b] of [[start, there], [there, after], [start, after]]) expect(await difference(page, a, b) > 100, "pictures are alike");
    await seek(page, 0);
    expect(await difference(page, await picture(), start) === 0, "it does not come back to where it was");
    await page.context().close();
  });

  await case_("impulse space turns by hand and by keys, its cone is as wide as friction", async () => {
    const page = await browser.section("impact", {});
    const space = page.locator(`${inside} .space`), drawn = () => space.innerHTML();
    const seen = [await drawn()];
    await space.focus();
    for (const key of ["ArrowLeft", "ArrowUp"]) {
      await page.keyboard.press(key);
      seen.push(await drawn());
    }
    await space.scrollIntoViewIfNeeded();
    const box = await space.boundingBox();
    await page.mouse.move(box.x + 100, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x + 160, box.y + 110, { steps: 3 });
    await page.mouse.up();
    seen.push(await drawn());
    expect(new Set(seen).size === 4, "a turn shows nothing");
    /** Half the angle of the cone as it is drawn, seen from the side: its slope, by the two lines. */
    const slope = async (mu) => {
      const one = await browser.section("impact", { hash: `#impact?mu=${mu}` });
      await one.locator(`${inside} .space`).focus();
      for (let i = 0; i < 3; ++i) await one.keyboard.press("ArrowDown");
      const [left, tip, right] = (await one.locator(`${inside} .space .cone-side`).getAttribute("d")).slice(1).split("L").map((text) => text.split(" ").map(Number));
      await one.context().close();
      return (right[0] - left[0]) / (2 * tip[1] - left[1] - right[1]);
    };
    for (const mu of [0.1, 0.3, 0.7]) near(await slope(mu), mu, 0.02, "the slope of the cone");
    await page.context().close();
  });

  await case_("the shell is where the energy stays the same", async () => {
    const solve = ([a, b, c], y) => { // by Cramer's rule
      const det = (p, q, r) => p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
      return [det(y, b, c), det(a, y, c), det(a, b, y)].map((one) => one / det(a, b, c));
    };
    const inner = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
    const [azimuth, elevation] = [-1.2, 0.22]; // as it is seen at first
    const right = [-Math.sin(azimuth), Math.cos(azimuth), 0];
    const upward = [-Math.cos(azimuth) * Math.sin(elevation), -Math.sin(azimuth) * Math.sin(elevation), Math.cos(elevation)];
    for (const scene of [{}, { tilt: 65, spin: -80, along: -0.5 }, { tilt: 10, tumble: 30, down: 1 }]) {
      const text = Object.entries(scene).map(([key, value]) => `${key}=${value}`).join("&");
      const page = await browser.section("impact", { hash: `#impact?${text}` });
      const { answers, mobility, velocity } = await natively(scene);
      const holding = solve(mobility, velocity).map((x) => -x), size = Math.sqrt(-inner(holding, velocity));
      const points = async (look) => (await page.locator(`${inside} .space .${look}`).first().getAttribute("d")).replace(/[MZ]/g, "").split("L").map((one) => one.split(" ").map(Number));
      const [, tip] = await points("cone-side"), spot = page.locator(`${inside} .space circle`).first(); // the linear answer's
      const scale = (tip[1] - Number(await spot.getAttribute("cy"))) / (answers.linear.normal * Math.cos(elevation));
      const shell = await points("shell");
      for (const [k, way, sign] of [[0, right, 1], [1, upward, -1]]) {
        const values = shell.map((one) => (sign * (one[k] - tip[k])) / scale), half = size * Math.sqrt(inner(way, solve(mobility, way)));
        near((Math.max(...values) + Math.min(...values)) / 2, inner(holding, way), 0.01, `${text}: its middle, ${k}`, half);
        near((Math.max(...values) - Math.min(...values)) / 2, half, 0.01, `${text}: half of it, ${k}`);
      }
      await page.context().close();
    }
  });

  await case_("a hand tilts the stone", async () => {
    const page = await browser.section("impact", {});
    const picture = page.locator(`${inside} .picture`), field = page.locator(`${inside} input.number[data-name=tilt]`);
    const box = await picture.boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.62 * box.height);
    await page.mouse.down();
    expect(await page.locator(`${inside} .picture.held`).count() === 1, "the stone is not held");
    await page.mouse.move(box.x + 0.5 * box.width + 60, box.y + 0.62 * box.height - 40, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(400);
    expect(Number(await field.getAttribute("data-value")) === 58, `the tilt is ${await field.inputValue()}`);
    const now = await shown(page, "impact"), { answers } = await natively({ tilt: 58, down: 0.8 });
    near(now["default-energy"], answers.default.energy, same, "the energy");
    expect(new URL(page.url()).hash.includes("tilt=58"), `the address is ${page.url()}`);
    await page.context().close();
  });
}
