/** The colours of page.css as the drawings and graphs need them, and what the reader prefers. */

const dark = matchMedia("(prefers-color-scheme: dark)");
const reduced = matchMedia("(prefers-reduced-motion: reduce)");

/** The names of the colours, `--name` in page.css. */
export type Token = "paper" | "ink" | "soft" | "line" | "panel" | "field" | "stage" | "stage-edge" | "exact" | "published"
  | "euler" | "rk4" | "splitting" | "momentum" | "momentum-loop" | "omega" | "normal" | "energy" | "stick" | "slip"
  | "impact" | "rest" | "impulse";

/** "#rrggbb" in the present theme. */
export function color(token: Token): string {
  let name: string = token;
  for (;;) {
    const value = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    const other = /^var\(--([\w-]+)\)$/.exec(value);
    if (!other) {
      const pair = /^light-dark\((.+?),(.+)\)$/.exec(value);
      return full((pair ? pair[dark.matches ? 2 : 1]! : value).trim());
    }
    name = other[1]!;
  }
}

/** A minifier may write #fff. */
const full = (hex: string) => hex.length === 4 ? `#${[...hex.slice(1)].map((digit) => digit + digit).join("")}` : hex;

/** The same as three numbers from 0 to 1. */
export function rgb(token: Token): [number, number, number] {
  const value = Number.parseInt(color(token).slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

/** How bright things are on the stage. */
export const brightness = () => (dark.matches ? 0.86 : 1);

/** Whether things may move by themselves. */
export const movesByItself = () => !reduced.matches;

/** Calls when the theme changes. */
export function onTheme(call: () => void): void {
  dark.addEventListener("change", call);
}
