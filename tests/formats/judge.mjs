// What the scripts share: the program, a folder of files, and checks that are counted.

import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const program = process.argv[2];
export const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'goishi-formats-'));
process.on('exit', () => fs.rmSync(folder, { recursive: true }));

/** Runs `goishi WORDS`, the words between blanks, in the folder. */
export function goishi(words) {
  return execFileSync(program, words.split(' '), { cwd: folder, encoding: 'utf8' });
}

export const bytesOf = (name) => new Uint8Array(fs.readFileSync(path.join(folder, name)));
export const textOf = (name) => fs.readFileSync(path.join(folder, name), 'utf8');

let failures = 0;
let checks = 0;

export function check(holds, what) {
  checks += 1;
  if (holds !== true) {
    failures += 1;
    console.log(`failed: ${what}`);
  }
}

/** Text with one part exchanged, which must be there once. */
export function changed(text, from, to) {
  check(text.split(from).length === 2, `'${from}' stands once in what is changed`);
  return text.replace(from, to);
}

export function finish(least) {
  check(least <= checks, `at least ${least} checks are made`);
  console.log(`${checks} checks, ${failures} failed`);
  process.exitCode = failures === 0 ? 0 : 1;
}
