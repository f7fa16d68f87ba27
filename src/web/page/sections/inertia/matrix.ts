/** A symmetric 3 × 3 matrix as it is written, with a name over it; each entry is a number of the library. */
import { el } from "../../dom";
import { digits, fixed, Shown } from "../../numbers";
import type { Token } from "../../look";

export class Matrix {
  readonly element: HTMLElement;
  readonly #entries: Shown[];

  /** Entries are named `name` with row and column, 1 to 3. */
  constructor(host: HTMLElement, name: string, title: string, token: Token) {
    this.#entries = Array.from({ length: 9 }, (_, i) => new Shown(`${name}-${Math.floor(i / 3) + 1}${(i % 3) + 1}`));
    this.element = el("div", "matrix", { role: "group", "aria-label": title },
      el("p", "", {}, el("i", "spot", { style: `background: var(--${token})` }), title),
      el("div", "entries", {}, ...this.#entries.map(({ element }) => element)));
    host.append(this.element);
  }

  /** Row by row, in m². */
  set(values: ArrayLike<number>): void {
    const size = Math.max(...Array.from(values, Math.abs));
    this.#entries.forEach((entry, i) => {
      const value = values[i]!, nothing = Math.abs(value) < 1e-14 * size;
      entry.set(value, nothing ? "0" : fixed(1e4 * value, 6));
    });
  }
}

export const squareCm = (value: number) => `${digits(1e4 * value, 6)} cm²`;
