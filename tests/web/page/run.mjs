// Tests the page in a browser.
// usage: node run.mjs SOURCE_DIR PAGE LIBRARY REPORT [PART…]
// PAGE is goishi.html, LIBRARY libgoishi.so, REPORT a folder for pictures; a part is a section, `whole`, or `cost`: of all
// sections what a picture costs, which each says of itself, too.

import { existsSync, mkdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { Browser, Cases, expect, Native } from "./harness.mjs";
import { cost } from "./cost.mjs";
import { every } from "./every.mjs";
import { whole } from "./whole.mjs";

const [source, page, library, report, ...only] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
mkdirSync(report, { recursive: true });

const { constants } = await import(pathToFileURL(join(resolve(source), "src/web/constants.mjs")).href);
const C = Object.fromEntries(constants());
const browser = await Browser.start(resolve(page));
const native = new Native(join(here, "native.py"), resolve(library));
const cases = new Cases();

const first = await browser.open();
const ids = await first.evaluate(() => [...document.querySelectorAll("[data-section]")].map((one) => one.dataset.section));
await first.context().close();

const parts = only.length > 0 ? only : ["whole", ...ids];
const unknown = parts.filter((part) => !["whole", "cost", ...ids].includes(part));
if (unknown.length > 0) {
  console.error(`run.mjs: no part is called ${unknown.join(", ")}`);
  process.exit(2);
}
if (parts.includes("whole")) await whole(browser, cases, ids, report);
if (parts.includes("cost")) for (const id of ids) await cost(id, resolve(page), cases);
for (const id of parts.filter((part) => ids.includes(part))) {
  await every(id, browser, cases, report);
  await cost(id, resolve(page), cases);
  await cases.run(`${id} has tests of its own`, async () => expect(existsSync(join(here, `${id}.mjs`)), `there is no ${id}.mjs`));
  if (existsSync(join(here, `${id}.mjs`))) await (await import(`./${id}.mjs`)).test({ browser, cases, native, C, source: resolve(source) });
}
await cases.run("the page says nothing and asks for nothing", async () => expect(browser.said.length === 0, [...new Set(browser.said)].join("; ")));

native.end();
await browser.close();
console.log(`${cases.count} cases, ${cases.failures} fail`);
process.exit(cases.failures === 0 && cases.count > 0 ? 0 : 1);
