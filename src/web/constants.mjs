// The places in the arrays of the C interface, and its enumerators, from its header: name without GOISHI_, and value.

import { readFileSync } from "node:fs";

export function constants() {
  const header = readFileSync(new URL("goishi.h", import.meta.url), "utf8").replace(/\/\/.*$/gm, "");
  return [...header.matchAll(/\bGOISHI_([A-Z0-9_]+)\s*(?:=\s*(-?\d+)|\((-[\d.]+)\))/g)]
    .map(([, name, value, defined]) => [name, Number(value ?? defined)]);
}
