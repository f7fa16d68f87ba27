// What each section must do, whatever it shows.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { difference, expect, fingerprint, framesIn, numbersAndGraphs, pixels, settle, shown } from "./harness.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** `browser` with the page, `cases` to run in, `report` a folder for pictures. */
export async function every(id, browser, cases, report) {
  const inside = `[data-section=${id}]`;
  const case_ = (name, test) => cases.run(`${id}: ${name}`, test);

  await case_("pictures and graphs are drawn", async () => {
    const page = await browser.section(id);
    const places = [...await page.locator(`${inside} .picture`).all(), ...await page.locator(`${inside} .plot .field:visible`).all()];
    expect(places.length > 0, "there is none");
    for (const place of places) {
      await place.scrollIntoViewIfNeeded();
      await settle(page);
      const { colors, commonest } = await pixels(page, place);
      const least = await place.evaluate((one) => one.classList.contains("picture")) ? 40 : 4;
      expect(colors >= least && commonest < 0.995, `${colors} colours, ${commonest} of it one`);
    }
    await page.context().close();
  });

  await case_("each control changes what is shown", async () => {
    const page = await browser.section(id);
    let count = 0;
    /** Whether numbers or graphs change, or else the picture; which takes longer to tell. */
    const changes = async (what, act, undo) => {
      const before = await numbersAndGraphs(page, id);
      await act();
      count++;
      if (await numbersAndGraphs(page, id) !== before) return;
      await undo();
      const picture = await fingerprint(page, id);
      await act();
      expect(await fingerprint(page, id) !== picture, `${what} changes nothing`);
    };
    for (const control of await page.locator(`${inside} .control:visible`).all()) {
      const slider = control.locator(".slider"), field = control.locator(".number"), good = await field.inputValue();
      const press = async (key) => {
        await slider.focus();
        await page.keyboard.press(key);
      };
      const before = await numbersAndGraphs(page, id);
      let changed = false;
      for (const end of ["Home", "End"]) { // at one of them it must show, if only in the picture
        await press(end);
        changed ||= await numbersAndGraphs(page, id) !== before;
        await field.fill(good);
        if (changed) break;
      }
      count++;
      if (!changed) await changes(await slider.getAttribute("aria-label"), () => press("Home"), () => press("End"));
      await field.fill(good);
    }
    for (const group of await page.locator(`${inside} fieldset.pills:not(.speeds):visible`).all()) {
      const pick = (value) => group.locator(`input[value="${value}"]`).check({ force: true });
      const chosen = () => group.evaluate((one) => one.querySelector("input:checked")?.value ?? null);
      for (const value of await group.evaluate((one) => [...one.querySelectorAll("input:not(:checked)")].map((input) => input.value))) {
        const last = await chosen();
        await changes(`${await group.locator("legend").textContent()} ${value}`, () => pick(value), async () => last === null || pick(last));
      }
    }
    for (const box of await page.locator(`${inside} .switch input:visible`).all()) {
      const turn = async () => box.setChecked(!(await box.isChecked()));
      await changes(await box.getAttribute("data-name"), turn, turn);
    }
    console.log(`      ${count} changes`);
    expect(count > 0, "there is no control");
    await page.context().close();
  });

  await case_("the picture goes with time, and back", async () => {
    const page = await browser.section(id);
    for (const timeline of await page.locator(`${inside} .timeline`).all()) {
      await page.evaluate(() => document.querySelectorAll(".overlay").forEach((one) => (one.style.visibility = "hidden"))); // its words change, too
      const at = async (share) => {
        await timeline.evaluate((one, value) => {
          one.value = String(value * 10000);
          one.dispatchEvent(new Event("input"));
        }, share);
        await settle(page);
        return Promise.all((await page.locator(`${inside} .picture:visible`).all()).map((one) => one.screenshot()));
      };
      /** Clearly: the browser's own gradients are not the same each time. */
      const differ = async (some, others) => (await Promise.all(some.map((one, i) => difference(page, one, others[i])))).reduce((sum, count) => sum + count, 0);
      const first = await at(0.03), second = await at(0.4);
      expect(await differ(first, second) > 100, "it stays as it is");
      const back = await differ(first, await at(0.03));
      expect(back === 0, `on the way back ${back} pixels are others`);
    }
    await page.context().close();
  });

  await case_("a wrong value says the rule and changes nothing", async () => {
    const page = await browser.section(id);
    for (const field of await page.locator(`${inside} input.number:visible`).all()) {
      const good = await field.inputValue(), before = JSON.stringify(await shown(page, id));
      for (const wrong of ["abc", "", "NaN", "1e99", "-1e99", "1/2", "Infinity", "0x1"]) {
        await field.fill(wrong);
        const rule = await field.locator("xpath=..").locator(".rule").textContent();
        expect(rule.includes("from") && rule.includes("to"), `“${wrong}” gives “${rule}”`);
        expect(await field.getAttribute("aria-invalid") === "true", "it is not marked as invalid");
        expect(JSON.stringify(await shown(page, id)) === before, `“${wrong}” changes what is shown`);
      }
      await field.fill(good);
      expect(await field.locator("xpath=..").locator(".rule").textContent() === "", "the rule stays");
    }
    await page.context().close();
  });

  await case_("no frame in 2 s at rest", async () => {
    for (const still of [true, false]) {
      const page = await browser.section(id, { still });
      if (!still) {
        const play = page.locator(`${inside} .round.main`).first();
        if (await play.count() && await play.getAttribute("aria-label") === "pause") await play.click();
      }
      await settle(page);
      const frames = await framesIn(page, 2000);
      expect(frames === 0, `${frames} frames${still ? " where nothing should move by itself" : ""}`);
      await page.context().close();
    }
  });

  await case_("the keyboard reaches everything", async () => {
    const page = await browser.section(id);
    const all = await page.evaluate((place) => {
      const list = [...document.querySelectorAll(`${place} :is(button, input, summary, .picture)`)].filter((one) => one.checkVisibility());
      // Of a group of radio buttons one is a stop.
      return list.filter((one) => one.type !== "radio" || one.checked || ![...list].some((other) => other.name === one.name && other.checked) )
        .filter((one, i, rest) => one.type !== "radio" || rest.findIndex((other) => other.name === one.name) === i).length;
    }, inside);
    await page.evaluate((place) => {
      const before = document.createElement("button");
      before.id = "before";
      document.querySelector(place).before(before);
      before.focus();
    }, inside);
    const reached = new Set();
    for (let i = 0; i < all + 10; ++i) {
      await page.keyboard.press("Tab");
      const here = await page.evaluate((place) => {
        const one = document.activeElement;
        if (!one.closest(place) || !one.matches("button, input, summary, .picture")) return null;
        one.dataset.reached ??= String(Math.random());
        const style = getComputedStyle(one.closest(".pill") ?? one);
        return { key: one.dataset.reached, seen: style.outlineStyle !== "none" || one.matches("input[type=range]") };
      }, inside);
      if (here === null) continue;
      expect(here.seen, "one cannot see where the focus is");
      reached.add(here.key);
    }
    expect(reached.size >= all, `${reached.size} of ${all} are reached`);
    await page.context().close();
  });

  await case_("a link shows the same again, nonsense the first picture", async () => {
    const page = await browser.section(id);
    const first = JSON.stringify(await shown(page, id));
    const slider = page.locator(`${inside} .control .slider:visible`).first();
    if (await slider.count()) {
      await slider.focus();
      await page.keyboard.press("PageUp");
      await page.keyboard.press("ArrowUp");
      await settle(page);
      const hash = new URL(page.url()).hash, changed = JSON.stringify(await shown(page, id));
      expect(hash.startsWith(`#${id}?`) && changed !== first, `the address is ${hash}`);
      const again = await browser.section(id, { hash });
      const there = JSON.stringify(await shown(again, id));
      expect(there === changed, `${there} is not ${changed}`);
      await again.context().close();
      const keys = await page.locator(`${inside} :is(input.number, fieldset.pills, .switch input)[data-name]`)
        .evaluateAll((all) => [...new Set(all.map((one) => one.dataset.name))]);
      const wrong = ["1e99", "NaN", "", "%00", "<b>", "-1e-400x"];
      expect(keys.length > 0, "no key is known");
      for (const from of [0, 1]) { // each key has two of them
        const query = keys.map((key, i) => `${key}=${wrong[(i + 3 * from) % wrong.length]}`).join("&");
        const odd = await browser.section(id, { hash: `#${id}?${query}&nothing=1&&=` });
        expect(JSON.stringify(await shown(odd, id)) === first, `${query} changes what is shown`);
        await odd.context().close();
      }
    }
    await page.context().close();
  });

  await case_("it pauses while the page is hidden", async () => {
    const page = await browser.section(id, { still: false });
    const play = page.locator(`${inside} .round.main`).first();
    if (await play.count()) {
      if (await play.getAttribute("aria-label") === "play") await play.click();
      const hide = (hidden) => page.evaluate((value) => {
        Object.defineProperty(document, "hidden", { configurable: true, get: () => value });
        document.dispatchEvent(new Event("visibilitychange"));
      }, hidden);
      await hide(true);
      await page.waitForTimeout(100);
      const time = () => page.locator(`${inside} .timeline`).inputValue();
      const [frames, before] = [await framesIn(page, 500), await time()];
      expect(frames === 0, `${frames} frames`);
      await hide(false);
      expect(await framesIn(page, 500) > 0 && await time() !== before, "it does not go on");
    }
    await page.context().close();
  });

  await case_("a finger turns the picture, and still scrolls the page", async () => {
    const page = await browser.section(id, { width: 390, height: 800 });
    const picture = page.locator(`${inside} .picture:visible`).first(), devtools = await page.context().newCDPSession(page);
    await page.evaluate(() => document.querySelectorAll(".overlay").forEach((one) => (one.style.visibility = "hidden")));
    await picture.scrollIntoViewIfNeeded();
    await settle(page);
    const swipe = async (dx, dy) => {
      const box = await picture.boundingBox(), [x, y] = [box.x + (dx < 0 ? box.width - 14 : 14), box.y + box.height - 24];
      const touch = (type, points) => devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points });
      await touch("touchStart", [{ x, y }]);
      for (let i = 1; i <= 10; ++i) await touch("touchMove", [{ x: x + (dx * i) / 10, y: y + (dy * i) / 10 }]);
      await touch("touchEnd", []);
      await settle(page);
    };
    const before = await picture.screenshot(), top = await page.evaluate(() => scrollY);
    await swipe(160, 0);
    expect(await difference(page, before, await picture.screenshot()) > 100, "it stays as it is");
    expect(await page.evaluate(() => scrollY) === top, "the page scrolls");
    await swipe(0, -200);
    expect(await page.evaluate(() => scrollY) > top, "the page does not scroll");
    await page.context().close();
  });

  await case_("a lost context comes back", async () => {
    const page = await browser.section(id);
    const picture = page.locator(`${inside} .frame`).first();
    if (await picture.count() === 0) return;
    const before = await picture.screenshot(), said = browser.said.length;
    await page.evaluate(() => {
      const canvas = document.querySelector("canvas.gl");
      globalThis.lose = (canvas.getContext("webgl2") ?? canvas.getContext("webgl")).getExtension("WEBGL_lose_context");
      globalThis.lose.loseContext();
    });
    await page.waitForTimeout(200);
    await page.evaluate(() => new Promise((restored) => {
      document.querySelector("canvas.gl").addEventListener("webglcontextrestored", restored);
      globalThis.lose.restoreContext();
    }));
    await settle(page);
    const after = await picture.screenshot();
    browser.said.splice(said, Infinity, ...browser.said.slice(said).filter((text) => !/context|CONTEXT_LOST/i.test(text))); // three tells of it
    const others = await difference(page, before, after);
    expect(others === 0, `${others} pixels are not as before`);
    await page.context().close();
  });

  for (const scheme of ["light", "dark"]) {
    await case_(`for everybody, ${scheme}`, async () => {
      const page = await browser.section(id, { scheme });
      for (const fold of await page.locator(`${inside} summary`).all()) await fold.click();
      await page.evaluate(axe);
      const { violations } = await page.evaluate((place) => globalThis.axe.run(place, { resultTypes: ["violations"] }), inside);
      expect(violations.length === 0, violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html).slice(0, 3).join(" ")}`).join("; "));
      await page.context().close();
    });
    for (const width of [1400, 390]) {
      await case_(`picture of it, ${width} wide, ${scheme}`, async () => {
        const page = await browser.section(id, { scheme, width, still: false });
        await page.locator(`${inside} .wide`).scrollIntoViewIfNeeded();
        await page.waitForTimeout(1500);
        const play = page.locator(`${inside} .round.main`).first();
        if (await play.count() && await play.getAttribute("aria-label") === "pause") await play.click();
        await settle(page);
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        expect(wider <= 0, `the page is ${wider} px wider than the window`);
        await page.locator(inside).evaluate((one) => one.scrollIntoView()); // now the sections around it are started, too, and it stays where it is
        await settle(page);
        await page.locator(inside).screenshot({ path: join(report, `${id}-${width}-${scheme}.png`) });
        await page.context().close();
      });
    }
  }
}
