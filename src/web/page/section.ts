/** A section: one idea, its figures and controls. Those that are near the reader are started. */
import { apply, format, parse, write } from "./address";
import { iconButton, type Control } from "./controls";
import type { Goishi } from "./core";
import { el } from "./dom";
import type { Stage } from "./stage";
import type { Transport } from "./transport";

/** What a section's file exports. */
export interface Section {
  /** In the address and as `data-section`: lower-case letters. */
  id: string;
  title: string;
  /** A few sentences, in trusted markup. `<b class="c-exact">` gives a word the colour of a token. */
  lead: string;
  /** Fills `place.wide` and `place.text`; called once, when the reader comes near. */
  start(place: Place): Live;
}

/** Where a section lives. */
export interface Place {
  goishi: Goishi;
  stage: Stage;
  section: HTMLElement;
  /** As wide as a figure: pictures, transport, graphs, panels. */
  wide: HTMLElement;
  /** As wide as the text, below: remarks and folds. */
  text: HTMLElement;
}

export interface Live {
  /** What is kept in the address. */
  controls: readonly Control[];
  /** Computes and shows all of it anew from the controls: called once after the address is applied. */
  update(): void;
  /** The section has come into view for the first time, or again: it may start to move. */
  enter?(): void;
  /** It has gone out of view. */
  leave?(): void;
}

export class Mounted {
  readonly element: HTMLElement;
  readonly #section: Section;
  readonly #place: Place;
  #live: Live | null = null;

  constructor(section: Section, number: number, goishi: Goishi, stage: Stage) {
    this.#section = section;
    const wide = el("div", "wide"), text = el("div", "column after"), lead = el("p", "lead column");
    lead.innerHTML = section.lead;
    this.element = el("section", "section", { id: section.id, "data-section": section.id, "aria-labelledby": `${section.id}-title` },
      el("h2", "column", { id: `${section.id}-title` }, el("span", "ordinal", {}, String(number)), section.title), lead, wide, text);
    this.#place = { goishi, stage, section: this.element, wide, text };
    new IntersectionObserver(([entry]) => {
      if (entry!.isIntersecting) this.start();
    }, { rootMargin: "600px" }).observe(this.element);
    new IntersectionObserver(([entry]) => {
      if (entry!.isIntersecting) this.#live?.enter?.();
      else this.#live?.leave?.();
    }, { threshold: 0.15 }).observe(wide);
  }

  start(): void {
    if (this.#live) return;
    this.#live = this.#section.start(this.#place);
    this.follow(location.hash);
    this.element.dataset["ready"] = "";
  }

  /** Takes what an address says of this section, and shows it. */
  follow(hash: string): void {
    const address = parse(hash);
    if (!this.#live) return;
    if (address?.section === this.#section.id) apply(this.#live.controls, address.values);
    this.#live.update();
  }
}

/** To be called when a control has changed. */
export const remember = (place: Place, controls: readonly Control[]) => write(place.section.id, controls);

/** The button that copies a link to what is seen. */
export function linkButton(transport: Transport, place: Place, controls: readonly Control[]): void {
  const said = el("span", "said", { role: "status" });
  iconButton(transport.extra, "link", "copy a link to this", () => {
    const hash = format(place.section.id, controls);
    history.replaceState(null, "", hash);
    const done = (text: string) => {
      said.textContent = text;
      setTimeout(() => (said.textContent = ""), 2500);
    };
    const link = location.href;
    if (navigator.clipboard) navigator.clipboard.writeText(link).then(() => done("link copied"), () => done("the link is in the address bar"));
    else done("the link is in the address bar");
  });
  transport.extra.prepend(said);
}
