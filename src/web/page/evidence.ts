/** "Why it is right": claims of the verification suite, with the figures of its last full run. */
import { claims } from "../claims";
import { fold } from "./controls";
import { el } from "./dom";

/** A claim's id, and what it says in a sentence for this place. */
export type Evidence = readonly [id: string, sentence: string];

/** A fold with some words in trusted markup and a list of claims. An id that the suite does not have is an error. */
export function evidence(host: HTMLElement, title: string, words: string, list: readonly Evidence[]): void {
  const rows = list.map(([id, sentence]) => {
    const claim = claims[id];
    if (!claim) throw new Error(`the suite has no claim ${id}`);
    const { witness, check, error, bound } = claim;
    return el("li", "", {}, sentence, " ", el("span", "witness", {},
      `${id}, judged by ${article(witness)}: error ${error}, bound ${bound}${check ? ` (${check})` : ""}.`));
  });
  fold(host, title, (body) => {
    const text = el("p");
    text.innerHTML = words;
    body.append(text, el("ul", "evidence", {}, ...rows));
  });
}

const article = (witness: string) => (/^(published|integration|quadrature|another|rounding|brute)/.test(witness) ? "" : /^[aeiou]/.test(witness) ? "an " : "a ") + witness;
