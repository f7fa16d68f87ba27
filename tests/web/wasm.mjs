// The C interface as WebAssembly gives what it gives natively, to the last bit.
// usage: node wasm.mjs MODULE WASM TABLE   (TABLE: what goishi-web-table prints)

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [moduleFile, wasmFile, tableFile] = process.argv.slice(2);
const make = (await import(pathToFileURL(moduleFile).href)).default;
const goishi = await make({ wasmBinary: readFileSync(wasmFile) });
const table = JSON.parse(readFileSync(tableFile, "utf8"));

const scratch = new DataView(new ArrayBuffer(8));
const number = (bits) => (scratch.setBigUint64(0, BigInt("0x" + bits)), scratch.getFloat64(0));
const memory = () => new DataView(goishi.HEAPU8.buffer); // it moves when it grows

/** Calls a function with arguments as the table has them: its last output, and what it set by pointers to one integer. */
function call(name, given) {
  const blocks = [], passed = [], ones = [];
  let result = null;
  const block = (bytes) => {
    const at = goishi._malloc(Math.max(bytes, 8));
    blocks.push(at);
    new Uint8Array(goishi.HEAPU8.buffer, at, Math.max(bytes, 8)).fill(0); // rows that are not filled
    return at;
  };
  for (const argument of given) {
    if ("in" in argument) {
      const at = block(8 * argument.in.length);
      argument.in.forEach((bits, i) => memory().setBigUint64(at + 8 * i, BigInt("0x" + bits), true));
      passed.push(at, argument.in.length);
    } else if ("ints" in argument) {
      const at = block(4 * argument.ints.length);
      argument.ints.forEach((value, i) => memory().setInt32(at + 4 * i, value, true));
      passed.push(at, argument.ints.length);
    } else if ("out" in argument) {
      result = { at: block(8 * argument.out), size: argument.out };
      passed.push(result.at, result.size);
    } else if ("one" in argument) {
      ones.push(block(8));
      passed.push(ones.at(-1));
    } else {
      passed.push("number" in argument ? number(argument.number) : argument.whole);
    }
  }
  const status = goishi["_" + name](...passed);
  const values = Array.from({ length: result?.size ?? 0 }, (_, i) =>
    memory().getBigUint64(result.at + 8 * i, true).toString(16).padStart(16, "0"));
  const set = ones.map((at) => memory().getInt32(at, true));
  blocks.forEach((at) => goishi._free(at));
  if (status !== 0) throw new Error(`${name}: ${goishi.UTF8ToString(goishi._goishi_message())}`);
  return { values, set };
}

/** The info of a drop after a time. */
function drop([stone, state, ground, settings, dt, info]) {
  const [handle] = call("goishi_drop_create", [stone, state, ground, settings, { whole: 100 }, { one: 0 }]).set;
  call("goishi_drop_advance", [{ whole: handle }, dt]);
  const { values } = call("goishi_drop_info", [{ whole: handle }, info]);
  goishi._goishi_drop_free(handle);
  return values;
}

/** The stones of a scene after a hundred steps. */
function scene([board, settings, stones, dt, rows]) {
  const [handle] = call("goishi_scene_create", [board, settings, { one: 0 }]).set, one = { whole: handle };
  const each = 6 + 13; // a stone and its state
  for (let i = 0; i < stones.in.length; i += each) {
    call("goishi_scene_add", [one, { in: stones.in.slice(i, i + 6) }, { in: stones.in.slice(i + 6, i + each) }, { one: 0 }]);
  }
  for (let i = 0; i < 100; ++i) call("goishi_scene_advance", [one, dt]);
  const { values } = call("goishi_scene_stones", [one, { whole: 0 }, rows]);
  goishi._goishi_scene_free(handle);
  return values;
}

let failures = 0, numbers = 0;
const complain = (index, text) => {
  if (++failures <= 20) console.error(`case ${index}, ${table[index].function}: ${text}`);
};

table.forEach((one, index) => {
  const got = { drop, scene }[one.function]?.(one.arguments) ?? call(one.function, one.arguments).values;
  one.result.forEach((expected, i) => {
    ++numbers;
    const a = number(got[i]), b = number(expected);
    if (got[i] !== expected && !(Number.isNaN(a) && Number.isNaN(b))) complain(index, `${i} is ${a}, not ${b}`);
  });
});

console.log(`${table.length} cases: ${numbers} numbers, to the last bit`);
if (table.length < 1000) complain(0, `there are only ${table.length} cases`);
process.exit(failures === 0 ? 0 : 1);
