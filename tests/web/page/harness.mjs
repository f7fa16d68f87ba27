// What the tests of all sections stand on: a browser with the page, the native library, and ways to look at both.

import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const flags = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** The library as it is compiled for this machine, see native.py. */
export class Native {
  #process;
  #lines;

  constructor(script, library) {
    this.#process = spawn("python3", [script, library], { stdio: ["pipe", "pipe", "inherit"] });
    this.#lines = createInterface({ input: this.#process.stdout })[Symbol.asyncIterator]();
  }

  /** Numbers are written so that NaN and infinities pass, too. */
  async call(name, ...given) {
    const text = JSON.stringify([name, ...given], (_, value) => (value === Infinity ? "∞" : value)).replaceAll('"∞"', "Infinity");
    this.#process.stdin.write(`${text}\n`);
    const { value } = await this.#lines.next();
    const answer = JSON.parse(value.replace(/-?\b(NaN|Infinity)\b/g, "null"));
    if ("message" in answer) throw new Error(`${name}: ${answer.message}`);
    return answer.outs;
  }

  end() {
    this.#process.stdin.end();
  }
}

export class Browser {
  #browser;
  #file;
  /** What the page said or asked for: it should be nothing. */
  said = [];

  /** `more` are flags for Chromium, besides those that all tests need. */
  static async start(file, more = []) {
    const one = new Browser();
    one.#file = pathToFileURL(file).href;
    one.#browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: [...flags, ...more] });
    return one;
  }

  /** A page; `still`: the reader wants nothing to move. */
  async open({ width = 1400, height = 1000, scheme = "light", still = true, hash = "" } = {}) {
    const context = await this.#browser.newContext({ viewport: { width, height }, colorScheme: scheme,
      reducedMotion: still ? "reduce" : "no-preference", hasTouch: width < 500 });
    const page = await context.newPage();
    page.on("console", (message) => this.said.push(message.text()));
    page.on("pageerror", (error) => this.said.push(String(error.stack)));
    page.on("request", (request) => {
      if (request.url().split("#")[0] !== this.#file && !request.url().startsWith("data:")) this.said.push(`asks for ${request.url()}`);
    });
    await page.addInitScript(() => {
      globalThis.frames_ = 0;
      const request = globalThis.requestAnimationFrame.bind(globalThis);
      globalThis.requestAnimationFrame = (call) => (globalThis.frames_++, request(call));
    });
    await page.goto(this.#file + hash);
    await page.waitForSelector("html[data-ready]");
    return page;
  }

  /** One that has started a section, and has it in view. */
  async section(id, options = {}) {
    const page = await this.open({ hash: `#${id}`, ...options });
    await page.waitForSelector(`[data-section=${id}][data-ready]`);
    await settle(page, 120, options.still === false ? 1200 : 7200); // what moves by itself does not come to rest soon
    return page;
  }

  /** How long it takes until the page is there   [ms]: by the clock, and of the main thread's processor time. */
  async readyAfter() {
    const context = await this.#browser.newContext();
    const page = await context.newPage(), devtools = await context.newCDPSession(page);
    await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
    await page.goto(this.#file);
    await page.waitForSelector("html[data-ready]");
    const { metrics } = await devtools.send("Performance.getMetrics");
    const wall = await page.evaluate(() => Number(document.documentElement.dataset.ready));
    await context.close();
    return { wall, work: 1000 * metrics.find(({ name }) => name === "TaskDuration").value };
  }

  /** The processor time of what draws, pages and GPU process, so far   [ms]. */
  async work() {
    const session = await this.#browser.newBrowserCDPSession();
    const { processInfo } = await session.send("SystemInfo.getProcessInfo");
    await session.detach();
    return 1000 * processInfo.filter(({ type }) => type === "renderer" || type === "GPU").reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  }

  async close() {
    await this.#browser.close();
  }
}

/** Until nothing is drawn any more; and the address is written, unless it is asked more often. It gives up after a time. Both in ms. */
export async function settle(page, every = 120, most = 7200) {
  for (let still = 0, last = -1, tries = 0; still < 3 && tries < most / every; ++tries) {
    await page.waitForTimeout(every);
    const [now, rests] = await page.evaluate(() => [globalThis.frames_, globalThis.goishiStage?.atRest ?? true]);
    still = rests && now === last ? still + 1 : 0;
    last = now;
  }
}

/** Frames that are asked for in a time   [ms]. */
export async function framesIn(page, time) {
  const before = await page.evaluate(() => globalThis.frames_);
  await page.waitForTimeout(time);
  return (await page.evaluate(() => globalThis.frames_)) - before;
}

/** The numbers that a section shows, by their names. */
export const shown = (page, id) => page.evaluate((section) => Object.fromEntries(
  [...document.querySelectorAll(`[data-section=${section}] [data-name][data-value]:not(input, fieldset)`)].map((one) => [one.dataset.name, one.dataset.value])), id);

/** Numbers and graphs of a section, as one text that changes with them. */
export async function numbersAndGraphs(page, id) {
  await settle(page, 30);
  return page.evaluate((section) => [
    ...[...document.querySelectorAll(`[data-section=${section}] [data-name][data-value]:not(input, fieldset)`)].map((one) => `${one.dataset.name}=${one.dataset.value}`),
    ...[...document.querySelectorAll(`[data-section=${section}] .plot canvas`)].filter((one) => one.checkVisibility()).map((one) => one.toDataURL()),
  ].join(), id);
}

/** And its pictures. */
export async function fingerprint(page, id) {
  const hash = createHash("sha256").update(await numbersAndGraphs(page, id));
  for (const picture of await page.locator(`[data-section=${id}] .frame:visible`).all()) hash.update(await picture.screenshot());
  return hash.digest("hex");
}

/** What `see` says of the pixels (red, green, blue, alpha …) of pictures, as PNG; in a page of its own, so it sees nothing else. */
async function look(page, pictures, see) {
  const helper = await page.context().newPage();
  try {
    return await helper.evaluate(async ([all, text]) => {
      const decoded = [];
      for (const data of all) {
        const image = new Image();
        image.src = `data:image/png;base64,${data}`;
        await image.decode();
        const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
        const context = canvas.getContext("2d", { willReadFrequently: true });
        context.drawImage(image, 0, 0);
        decoded.push(context.getImageData(0, 0, canvas.width, canvas.height).data);
      }
      return new Function(`return (${text})`)()(...decoded);
    }, [pictures.map((picture) => picture.toString("base64")), String(see)]);
  } finally {
    await helper.close();
  }
}

/** What a picture holds: how many colours, and how much of it is not like its edge. */
export const pixels = async (page, locator) => look(page, [await locator.screenshot()], (all) => {
  const colors = new Map();
  for (let i = 0; i < all.length; i += 4) {
    const color = ((all[i] >> 3) << 10) | ((all[i + 1] >> 3) << 5) | (all[i + 2] >> 3);
    colors.set(color, (colors.get(color) ?? 0) + 1);
  }
  return { colors: colors.size, commonest: Math.max(...colors.values()) / (all.length / 4) };
});

/** The mean colour of a picture: red, green, blue. */
export const middle = (page, picture) => look(page, [picture], (all) =>
  [0, 1, 2].map((k) => all.filter((_, i) => i % 4 === k).reduce((sum, value) => sum + value, 0) / (all.length / 4)));

/** In how many pixels two pictures of one size differ clearly. */
export const difference = (page, one, other) => look(page, [one, other], (a, b) => {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) count += Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]) > 60;
  return count;
});

/** Runs cases, and tells which fail. */
export class Cases {
  failures = 0;
  count = 0;
  #which = new RegExp(process.env.GOISHI_PAGE_CASES ?? ""); // for those who write them: some only

  async run(name, test) {
    if (!this.#which.test(name)) return;
    this.count++;
    const began = Date.now();
    try {
      await test();
      console.log(`ok    ${name} (${Date.now() - began} ms)`);
    } catch (error) {
      this.failures++;
      console.log(`FAIL  ${name}: ${error.message}`);
    }
  }
}

export function expect(condition, text) {
  if (!condition) throw new Error(text);
}

/** Within `relative` of the expected value, or of `size` if that is greater. NaN is near nothing. */
export function near(value, expected, relative, what, size = 0) {
  const off = Math.abs(Number(value) - expected) / Math.max(Math.abs(expected), size);
  expect(Number(value) === expected || off <= relative, `${what} is ${value}, not ${expected}: ${off.toExponential(1)} off`);
}
