/** What a hand can change: numbers, choices, folds, buttons. A wrong value shows the rule and changes nothing else. */
import { el, fresh, html, icon, type Icon } from "./dom";
import type { Token } from "./look";
import { exactly } from "./numbers";

export interface NumberOptions {
  /** In the address, and `data-name` of its field. */
  key: string;
  label: string;
  /** "mm"; none for a bare number. */
  unit?: string;
  least: number;
  greatest: number;
  step: number;
  value: number;
  /** The slider goes by equal factors; `least` > 0. */
  log?: boolean;
  /** How many digits its field shows; 4 unless it is said. */
  digits?: number;
  /** Whole numbers only. */
  whole?: boolean;
}

/** A control of a section: what is kept in the address. */
export interface Control {
  readonly key: string;
  /** As it stands in the address. */
  text: string;
  /** Takes a text from an address: false if it is not one of its values. */
  accept(text: string): boolean;
  /** Whether it is as it was at first. */
  readonly isDefault: boolean;
  /** Back to its first value, without a call. */
  reset(): void;
}

const steps = 1000; // of a slider

/** A slider, a field and a unit; below them the rule, where it is broken. */
export class NumberControl implements Control {
  readonly key: string;
  readonly element: HTMLElement;
  readonly #o: NumberOptions;
  readonly #slider: HTMLInputElement;
  readonly #field: HTMLInputElement;
  readonly #rule: HTMLElement;
  readonly #change: (value: number) => void;
  #value: number;

  constructor(host: HTMLElement, options: NumberOptions, change: (value: number) => void) {
    this.#o = options;
    this.#change = change;
    this.key = options.key;
    this.#value = options.value;
    const name = fresh("field"), rule = fresh("rule"), { label, unit = "" } = options;
    this.#slider = el("input", "slider", { type: "range", min: 0, max: steps, step: 1, "aria-label": unit ? `${label}, ${unit}` : label });
    this.#field = el("input", "number", { id: name, type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false",
      "aria-describedby": rule, "data-name": options.key });
    this.#rule = el("p", "rule", { id: rule, "aria-live": "polite" });
    this.element = el("div", "control", {},
      el("label", "", { for: name }, label), this.#slider, this.#field, el("span", "unit", {}, unit), this.#rule);
    host.append(this.element);
    this.#slider.addEventListener("input", () => this.#take(this.#at(Number(this.#slider.value) / steps)));
    this.#slider.addEventListener("keydown", (event) => this.#keys(event));
    this.#field.addEventListener("input", () => {
      const value = this.#parse(this.#field.value);
      this.#complain(value === null);
      if (value !== null) this.#take(value, false);
    });
    this.#field.addEventListener("blur", () => { // what is wrong may stay to be mended; what is right is written well
      if (this.#parse(this.#field.value) !== null) this.#show();
    });
    this.#field.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.#show();
      if (event.key === "ArrowUp" || event.key === "ArrowDown") this.#keys(event);
    });
    this.#show();
  }

  get value(): number {
    return this.#value;
  }

  /** Without a call. */
  set value(value: number) {
    this.#value = value;
    this.#show();
  }

  /** What it was at first. */
  get first(): number {
    return this.#o.value;
  }

  /** To the one of its slider's values that is nearest, without a call: for what a hand draws. */
  approach(value: number): void {
    const { least, greatest } = this.#o;
    this.value = this.#at(Math.min(1, Math.max(0, (value - least) / (greatest - least))));
  }

  get text(): string {
    return String(this.#value);
  }

  accept(text: string): boolean {
    const value = this.#parse(text);
    if (value !== null) this.value = value;
    return value !== null;
  }

  get isDefault(): boolean {
    return this.#value === this.#o.value;
  }

  reset(): void {
    this.value = this.#o.value;
  }

  get #words(): string {
    const { least, greatest, unit, whole, label } = this.#o;
    return `${label}: ${whole ? "a whole number" : "a number"} from ${least} to ${greatest}${unit ? ` ${unit}` : ""}`.replaceAll("-", "−");
  }

  #complain(wrong: boolean): void {
    this.#rule.textContent = wrong ? this.#words : "";
    this.#field.setAttribute("aria-invalid", String(wrong));
  }

  #parse(text: string): number | null {
    const clean = text.trim().replace("−", "-").replace(",", ".");
    if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(clean)) return null;
    const value = Number(clean);
    return value >= this.#o.least && value <= this.#o.greatest && (!this.#o.whole || Number.isInteger(value)) ? value : null;
  }

  #at(share: number): number {
    const { least, greatest, step, log } = this.#o;
    if (log) return Number((least * (greatest / least) ** share).toPrecision(3));
    const value = least + Math.round((share * (greatest - least)) / step) * step;
    return Number(Math.min(greatest, value).toPrecision(12));
  }

  get #share(): number {
    const { least, greatest, log } = this.#o;
    return log ? Math.log(this.#value / least) / Math.log(greatest / least) : (this.#value - least) / (greatest - least);
  }

  #keys(event: KeyboardEvent): void {
    const { least, greatest, step, log } = this.#o;
    const count = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    const next = event.key === "Home" ? least : event.key === "End" ? greatest : count === undefined ? null
      : log ? Number((this.#value * 1.1 ** count).toPrecision(3)) : Number((this.#value + count * step).toPrecision(12));
    if (next === null) return;
    event.preventDefault();
    this.#take(Math.min(greatest, Math.max(least, next)));
  }

  #take(value: number, write = true): void {
    const changed = value !== this.#value;
    this.#value = value;
    this.#show(write);
    if (changed) this.#change(value);
  }

  #show(write = true): void {
    if (write) {
      this.#field.value = String(Number(this.#value.toPrecision(Math.max(4, this.#o.digits ?? 4)))).replace("-", "−");
      this.#complain(false);
    }
    this.#field.dataset.value = exactly(this.#value);
    const share = this.#share;
    this.#slider.value = String(Math.round(share * steps));
    this.#slider.style.setProperty("--share", share.toFixed(4));
    this.#slider.setAttribute("aria-valuetext", `${this.#field.value} ${this.#o.unit ?? ""}`.trim());
  }
}

export interface Choice<V extends string> {
  value: V;
  label: string;
  /** A spot of this colour before it. */
  token?: Token;
}

/** One of several, as pills; `quiet`: its label is only read aloud. */
export class ChoiceControl<V extends string> implements Control {
  readonly key: string;
  readonly element: HTMLElement;
  readonly #inputs = new Map<V, HTMLInputElement>();
  readonly #first: V;
  #value: V;

  constructor(host: HTMLElement, options: { key: string; label: string; choices: readonly Choice<V>[]; value: V; quiet?: boolean },
              change: (value: V) => void) {
    this.key = options.key;
    this.#first = this.#value = options.value;
    const name = fresh("choice");
    this.element = el("fieldset", "pills", { "data-name": options.key }, el("legend", options.quiet ? "unseen" : "", {}, options.label));
    for (const { value, label, token } of options.choices) {
      const input = el("input", "", { type: "radio", name, value });
      input.addEventListener("change", () => {
        this.#value = value;
        this.#mark();
        change(value);
      });
      this.#inputs.set(value, input);
      this.element.append(el("label", "pill", {}, input,
        ...(token ? [el("i", "spot", { style: `background: var(--${token})` })] : []), label));
    }
    host.append(this.element);
    this.#mark();
  }

  get value(): V {
    return this.#value;
  }

  set value(value: V) {
    this.#value = value;
    this.#mark();
  }

  get first(): V {
    return this.#first;
  }

  get text(): string {
    return this.#value;
  }

  accept(text: string): boolean {
    if (!this.#inputs.has(text as V)) return false;
    this.value = text as V;
    return true;
  }

  get isDefault(): boolean {
    return this.#value === this.#first;
  }

  reset(): void {
    this.value = this.#first;
  }

  #mark(): void {
    const input = this.#inputs.get(this.#value);
    if (input) input.checked = true;
    this.element.dataset["value"] = this.#value;
  }
}

/** Ready-made settings of other controls, as pills: what is chosen is no state of its own, so none need be marked. */
export class Presets<V extends string> {
  readonly element: HTMLElement;
  readonly #inputs = new Map<V, HTMLInputElement>();

  constructor(host: HTMLElement, options: { name: string; label: string; choices: readonly Choice<V>[] }, choose: (value: V) => void) {
    const group = fresh(options.name);
    this.element = el("fieldset", "pills", {}, el("legend", "unseen", {}, options.label));
    for (const { value, label } of options.choices) {
      const input = el("input", "", { type: "radio", name: group, value, "data-name": options.name });
      input.addEventListener("change", () => choose(value));
      this.#inputs.set(value, input);
      this.element.append(el("label", "pill", {}, input, label));
    }
    host.append(this.element);
  }

  mark(chosen: V | null): void {
    for (const [value, input] of this.#inputs) input.checked = value === chosen;
  }
}

/** A control that has a value, as ready-made starts set it. */
interface Settable extends Control {
  value: unknown;
  readonly first: unknown;
}

/** Ready-made values of several controls, as pills, and what the chosen ones show. What a start does not say is as at first. */
export class Starts {
  readonly #starts: Readonly<Record<string, { label: string; says: string; start: object }>>;
  readonly #presets: Presets<string>;
  readonly #says = el("p", "remark says", { "aria-live": "polite" });
  /** By the names that they have in a start. */
  controls: Readonly<Record<string, Settable>> = {};

  constructor(host: HTMLElement, starts: Readonly<Record<string, { label: string; says: string; start: object }>>, choose: (name: string) => void) {
    this.#starts = starts;
    this.#presets = new Presets(host, { name: "start", label: "ready-made starts",
      choices: Object.entries(starts).map(([value, { label }]) => ({ value, label })) }, choose);
    host.append(this.#says);
  }

  /** What a start has of a control. */
  #value(name: string, key: string): unknown {
    return (this.#starts[name]!.start as Record<string, unknown>)[key] ?? this.controls[key]!.first;
  }

  /** Marks the one that the controls have now, if one does. */
  mark(): void {
    const keys = Object.keys(this.controls);
    const chosen = Object.keys(this.#starts).find((name) => keys.every((key) => this.controls[key]!.value === this.#value(name, key))) ?? null;
    this.#presets.mark(chosen);
    this.#says.textContent = chosen ? this.#starts[chosen]!.says : "";
  }

  take(name: string): void {
    for (const [key, control] of Object.entries(this.controls)) control.value = this.#value(name, key);
  }
}

/** Yes or no. */
export class SwitchControl implements Control {
  readonly key: string;
  readonly element: HTMLElement;
  readonly #input: HTMLInputElement;
  readonly #first: boolean;

  constructor(host: HTMLElement, options: { key: string; label: string; value: boolean; token?: Token }, change: (value: boolean) => void) {
    this.key = options.key;
    this.#first = options.value;
    this.#input = el("input", "", { type: "checkbox", "data-name": options.key });
    this.#input.checked = options.value;
    this.#input.addEventListener("change", () => change(this.#input.checked));
    this.element = el("label", "switch", {}, this.#input,
      ...(options.token ? [el("i", "spot", { style: `background: var(--${options.token})` })] : []), options.label);
    host.append(this.element);
  }

  get value(): boolean {
    return this.#input.checked;
  }

  set value(value: boolean) {
    this.#input.checked = value;
  }

  get text(): string {
    return this.value ? "1" : "0";
  }

  accept(text: string): boolean {
    if (text !== "0" && text !== "1") return false;
    this.value = text === "1";
    return true;
  }

  get isDefault(): boolean {
    return this.value === this.#first;
  }

  reset(): void {
    this.value = this.#first;
  }
}

/** Something to unfold. Its content is made when it is opened first. */
export function fold(host: HTMLElement, title: string, fill: (body: HTMLElement) => void): HTMLDetailsElement {
  const body = el("div", "fold-body");
  const details = el("details", "fold", {}, el("summary", "", {}, title), body);
  details.addEventListener("toggle", () => {
    if (details.open && body.childNodes.length === 0) fill(body);
  });
  host.append(details);
  return details;
}

/** A button with words. */
export function button(host: HTMLElement, label: string, press: () => void): HTMLButtonElement {
  const element = el("button", "pill", { type: "button" }, label);
  element.addEventListener("click", press);
  host.append(element);
  return element;
}

/** A round button with a picture; its label is what it does. */
export function iconButton(host: HTMLElement, name: Icon, label: string, press: () => void, main = false): HTMLButtonElement {
  const element = el("button", main ? "round main" : "round", { type: "button", "aria-label": label, title: label }, html(icon(name)));
  element.addEventListener("click", press);
  host.append(element);
  return element;
}

/** A panel of controls in columns; `title` may be empty. */
export function panel(host: HTMLElement, ...titles: string[]): HTMLElement[] {
  const columns = titles.map((title) => el("div", "column-of-controls", {}, ...(title ? [el("p", "group", {}, title)] : [])));
  host.append(el("div", "panel", {}, ...columns));
  return columns;
}
