/** Where a section says what the library refuses. The last good picture stays. */
import { Refused } from "./core";
import { el } from "./dom";

export class Refusal {
  readonly #said = el("p", "rule", { role: "alert" });

  constructor(host: HTMLElement) {
    host.append(this.#said);
  }

  /** What the page refuses by itself. */
  because(text: string): never {
    throw new Refused(text);
  }

  /** Whether the library takes what is asked of it. */
  takes(compute: () => void): boolean {
    try {
      compute();
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      this.#said.textContent = error.message;
      return false;
    }
    this.#said.textContent = "";
    return true;
  }
}
