/** Numbers for people, and for tests. */

const minus = (text: string) => text.replace("-", "−");

/** With a number of decimals. A negative zero is none. */
export const fixed = (value: number, decimals: number): string => {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  return minus(Number(text) === 0 ? text.replace("-", "") : text);
};

/** With a number of digits; very small or large ones as 1.2 · 10⁻⁵. */
export const digits = (value: number, count: number): string => {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) {
    const [mantissa, exponent] = value.toExponential(count - 1).split("e") as [string, string];
    return `${minus(mantissa)} · ${power(Number(exponent))}`;
  }
  return minus(value.toPrecision(count).includes("e") ? String(Number(value.toPrecision(count))) : value.toPrecision(count));
};

/** 10ⁿ. */
export const power = (exponent: number): string =>
  `10${[...String(exponent)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]!)).join("")}`;

/** While time goes by words are written as often as they can be read, for a new text costs as much as a picture: `due` says
 * whether they are. */
export const words = { due: true };

/** A number on the page: text for people, and all its digits for tests, which compare them with the native library. */
export class Shown {
  readonly element: HTMLElement;
  readonly #name: string;
  #text = "";

  constructor(name: string, element: HTMLElement = document.createElement("span")) {
    this.#name = name;
    this.element = element;
    element.dataset.name = name;
  }

  /** `value` is in SI units, `text` has its unit. */
  set(value: number, text: string): void {
    if (!words.due) return;
    if (text !== this.#text) this.element.textContent = this.#text = text;
    this.element.dataset.value = exactly(value);
  }

  get name(): string {
    return this.#name;
  }
}

/** The 17 digits that make a double. */
export const exactly = (value: number): string => (Number.isFinite(value) ? value.toPrecision(17) : String(value));
