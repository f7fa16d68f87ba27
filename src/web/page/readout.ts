/** Numbers in cells: a symbol, what it is, and its value, which follows. */
import { el } from "./dom";
import { Shown } from "./numbers";

export interface Cell {
  /** `data-name` of the number. */
  name: string;
  /** "r", trusted markup; may be empty. */
  symbol: string;
  label: string;
}

export class Readout {
  readonly element: HTMLElement;
  readonly #shown = new Map<string, Shown>();

  constructor(host: HTMLElement, cells: readonly Cell[]) {
    this.element = el("dl", "readout");
    for (const { name, symbol, label } of cells) {
      const shown = new Shown(name, el("dd")), term = el("dt", "", {}, label), mark = el("i", "symbol");
      mark.innerHTML = symbol;
      if (symbol) term.prepend(mark, " ");
      this.#shown.set(name, shown);
      this.element.append(el("div", "", {}, term, shown.element));
    }
    host.append(this.element);
  }

  /** `value` in SI units, `text` with its unit. */
  set(name: string, value: number, text: string): void {
    this.#shown.get(name)!.set(value, text);
  }
}
