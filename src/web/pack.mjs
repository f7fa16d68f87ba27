// Makes the page: type check, bundle, and one HTML file with everything in it.
// usage: node pack.mjs BUILD_DIR   (which has goishi.mjs, goishi.wasm and node_modules, and gets goishi.html)

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync, renameSync, symlinkSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { constants } from "./constants.mjs";

const source = dirname(fileURLToPath(import.meta.url));
const build = resolve(process.argv[2]);
const largest = 0.8e6; // bytes of the packed page

// The sources as the build folder sees them, so that modules are found there and nothing is written beside the sources.
for (const name of ["page", "tsconfig.json"]) {
  const link = join(build, name);
  if (!existsSync(link)) symlinkSync(join(source, name), link);
}

writeFileSync(join(build, "constants.ts"),
  constants().map(([name, value]) => `export const ${name} = ${value};\n`).join(""));

// The claims that the page names, from the suite's table.
const sourceText = readdirSync(join(source, "page"), { recursive: true }).filter((name) => name.endsWith(".ts"))
  .map((name) => readFileSync(join(source, "page", name), "utf8")).join("");
const claims = {};
for (const line of readFileSync(join(source, "../../verify/README.md"), "utf8").split("\n")) {
  const cells = line.split(/(?<!\\)\|/).map((cell) => cell.trim().replaceAll("\\", ""));
  const [, id, , witness, check, error, bound] = cells;
  if (/^[A-Z]+-\d+$/.test(id ?? "") && new RegExp(`"${id}"`).test(sourceText)) claims[id] = { witness, check, error, bound };
}
writeFileSync(join(build, "claims.ts"), "export const claims: Record<string, { witness: string; check: string; error: string; bound: string }> = " +
  `${JSON.stringify(claims, null, 1)};\n`);

writeFileSync(join(build, "goishi.d.mts"), "declare const make: (given: { wasmBinary: Uint8Array }) => Promise<unknown>;\nexport default make;\n");

try {
  execFileSync(join(build, "node_modules/.bin/tsc"), ["--project", join(build, "tsconfig.json")], { stdio: "inherit" });
} catch {
  process.exit(1); // it has said why
}

const esbuild = createRequire(join(build, "node_modules/"))("esbuild");
const options = { bundle: true, write: false, minify: true, preserveSymlinks: true, target: "es2022", logLevel: "warning" };
const text = (result) => result.outputFiles[0].text;
const script = text(await esbuild.build({
  ...options, entryPoints: [join(build, "page/main.ts")], format: "iife", globalName: "GoishiPage", legalComments: "eof",
}));
const style = text(await esbuild.build({ ...options, entryPoints: [join(build, "page/page.css")] }));

const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");
const parts = {
  style: style.trim(),
  script: packed(script),
  wasm: packed(readFileSync(join(build, "goishi.wasm"))),
};
const page = readFileSync(join(source, "page/page.html"), "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => {
  if (!(name in parts)) throw new Error(`page.html asks for ${name}`);
  return parts[name];
});
if (page.length > largest) throw new Error(`the page has ${page.length} bytes, more than ${largest}`);
const target = join(build, "goishi.html");
writeFileSync(`${target}.new`, page);
renameSync(`${target}.new`, target);
console.log(`${target}: ${Math.round(page.length / 1000)} kB (script ${Math.round(script.length / 1000)} kB before packing)`);
