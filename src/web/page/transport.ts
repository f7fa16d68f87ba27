/** Time in a section: playing both ways, slowly or not, marks, single steps, and dragging. */
import { el, html, icon } from "./dom";
import { iconButton } from "./controls";
import { movesByItself, type Token } from "./look";
import { fixed, Shown, words } from "./numbers";
import type { Stage } from "./stage";

/** Something that happened. */
export interface Mark {
  time: number;
  token: Token;
  /** For whoever steps there: "impact, 4.56 mN s". */
  label: string;
  /** A high mark; others are low. */
  high?: boolean;
}

export interface TransportOptions {
  /** Real seconds go by so many times slower: 1, 5, 25. */
  speeds: readonly number[];
  speed: number;
  decimals?: number;
  /** The grid that steps go along where there are no marks   [s]; a hundredth of all unless it is said. */
  step?: () => number;
  /** Where what is to come is not computed yet: goes on towards a time, and says how far it came, and whether nothing is after it. */
  reach?: (time: number) => { time: number; over: boolean };
  /** Shows the time. `stopped` says that it will not go on by itself, so words for screen readers may follow. */
  show: (time: number, stopped: boolean) => void;
}

const readable = 0.08; // [s] between two texts while it plays
const seen = 1 / 400;  // of the timeline: what its thumb moves at least, while it plays

let playing: Transport | null = null; // one at a time: there is one stage

export class Transport {
  readonly element: HTMLElement;
  /** For more buttons at the end of the row. */
  readonly extra: HTMLElement;
  readonly #stage: Stage;
  readonly #o: TransportOptions;
  readonly #slider: HTMLInputElement;
  readonly #marks: HTMLElement;
  readonly #play: HTMLButtonElement;
  readonly #back: HTMLButtonElement;
  readonly #time = new Shown("time");
  readonly #speeds = new Map<number, HTMLInputElement>();
  #list: Mark[] = [];
  #end = 1;
  #now = 0;
  #speed: number;
  #direction: 1 | -1 = 1;
  #unread = 0; // [s] since the last text
  #share = 0;  // where the thumb stands

  /** `section` is what its keys work in: space plays, comma and full stop step. */
  constructor(host: HTMLElement, section: HTMLElement, stage: Stage, options: TransportOptions) {
    this.#stage = stage;
    this.#o = options;
    this.#speed = options.speed;
    this.#slider = el("input", "slider timeline", { type: "range", min: 0, max: 10000, step: 1, value: 0, "aria-label": "time" });
    this.#marks = el("div", "marks", { "aria-hidden": "true" });
    const row = el("div", "transport-row"), buttons = el("div", "buttons"), speeds = el("fieldset", "pills speeds");
    speeds.append(el("legend", "unseen", {}, "speed"));
    for (const speed of options.speeds) {
      const label = speed === 1 ? "1×" : `1/${speed}`;
      const input = el("input", "", { type: "radio", name: `speed-${section.id}`, value: speed, "aria-label": speed === 1 ? "in real time" : `${speed} times slower` });
      input.checked = speed === options.speed;
      input.addEventListener("change", () => (this.#speed = speed));
      this.#speeds.set(speed, input);
      speeds.append(el("label", "pill", {}, input, label));
    }
    this.extra = el("div", "extra");
    iconButton(buttons, "restart", "to the start", () => this.restart());
    iconButton(buttons, "previous", "step back", () => this.step(-1));
    this.#back = iconButton(buttons, "back", "play backwards", () => this.#toggle(-1));
    this.#play = iconButton(buttons, "play", "play", () => this.#toggle(1), true);
    iconButton(buttons, "next", "step forward", () => this.step(1));
    this.#time.element.className = "clock";
    row.append(buttons, this.#time.element, speeds, this.extra);
    this.element = el("div", "transport", {}, el("div", "timeline-box", {}, this.#marks, this.#slider), row);
    host.append(this.element);
    this.#slider.addEventListener("input", () => this.seek((Number(this.#slider.value) / 10000) * this.#end));
    section.addEventListener("keydown", (event) => this.#keys(event));
    this.#write();
  }

  /** Another stretch of time, from 0 to `end` [s], with what happens in it. */
  set(end: number, marks: readonly Mark[] = []): void {
    this.#end = end > 0 ? end : 1;
    this.#list = [...marks].sort((a, b) => a.time - b.time);
    this.#marks.replaceChildren(...this.#list.map((mark) => el("i", mark.high ? "high" : "", {
      style: `left: ${((100 * mark.time) / this.#end).toFixed(3)}%; background: var(--${mark.token})` })));
    this.seek(Math.min(this.#now, this.#end));
  }

  /** The same with the time as it goes: its end has moved. */
  extend(end: number): void {
    if (end === this.#end) return;
    this.#list.forEach((mark, i) => ((this.#marks.children[i] as HTMLElement).style.left = `${((100 * mark.time) / end).toFixed(3)}%`));
    this.#end = end;
    this.#share = -1;
    if (!this.playing) this.#write();
  }

  get time(): number {
    return this.#now;
  }

  get end(): number {
    return this.#end;
  }

  get speed(): number {
    return this.#speed;
  }

  set speed(speed: number) {
    const input = this.#speeds.get(speed);
    if (!input) return;
    input.checked = true;
    this.#speed = speed;
  }

  get playing(): boolean {
    return playing === this;
  }

  /** To a time, and stays there. */
  seek(time: number): void {
    this.pause(false);
    this.#now = Math.min(this.#end, Math.max(0, time));
    if (this.#o.reach) this.#now = this.#o.reach(this.#now).time;
    this.#write();
    this.#o.show(this.#now, true);
  }

  /** The last mark at or before the time; none before the first. */
  get mark(): Mark | null {
    return this.#list.findLast((mark) => mark.time <= this.#now) ?? null;
  }

  /** To the next mark, or the one before; without marks to the next of `step`. */
  step(direction: 1 | -1): void {
    const tiny = 1e-12;
    if (this.#list.length === 0) {
      const by = this.#o.step?.() ?? this.#end / 100, near = 1e-9;
      this.seek(by * (direction > 0 ? Math.floor(this.#now / by + near) + 1 : Math.ceil(this.#now / by - near) - 1));
    } else {
      const next = direction > 0
        ? this.#list.find((mark) => mark.time > this.#now + tiny)?.time ?? this.#end
        : this.#list.findLast((mark) => mark.time < this.#now - tiny)?.time ?? 0;
      this.seek(next);
    }
  }

  restart(): void {
    this.seek(0);
    if (movesByItself()) this.play(1);
  }

  /** From its end it begins anew. */
  play(direction: 1 | -1 = 1): void {
    if (playing && playing !== this) playing.pause();
    playing = this;
    this.#direction = direction;
    if (direction > 0 && (this.#o.reach ? this.#o.reach(this.#now).over : this.#now >= this.#end)) this.#now = 0;
    if (direction < 0 && this.#now <= 0) this.#now = this.#end;
    this.#stage.animate(this, (dt) => this.#tick(dt));
    this.#label();
  }

  pause(show = true): void {
    if (playing !== this) return;
    playing = null;
    this.#stage.stop(this);
    this.#label();
    if (show) this.#o.show(this.#now, true);
  }

  #toggle(direction: 1 | -1): void {
    if (this.playing && this.#direction === direction) this.pause();
    else this.play(direction);
  }

  #tick(dt: number): boolean {
    if (playing !== this) return false;
    this.#now += (this.#direction * dt) / this.#speed;
    let over = this.#direction > 0 ? this.#now >= this.#end : this.#now <= 0;
    if (this.#o.reach && this.#direction > 0) ({ time: this.#now, over } = this.#o.reach(this.#now));
    this.#now = Math.min(this.#end, Math.max(0, this.#now));
    if (over) playing = null;
    this.#unread += dt;
    words.due = over || this.#unread >= readable;
    if (words.due) this.#unread = 0;
    try {
      this.#write();
      this.#o.show(this.#now, over);
    } finally {
      words.due = true;
    }
    if (over) this.#label();
    return !over;
  }

  #label(): void {
    const set = (element: HTMLButtonElement, direction: 1 | -1) => {
      const on = this.playing && this.#direction === direction;
      const label = on ? "pause" : direction > 0 ? "play" : "play backwards";
      if (element.getAttribute("aria-label") === label) return;
      element.setAttribute("aria-label", label);
      element.title = label;
      element.replaceChildren(html(icon(on ? "pause" : direction > 0 ? "play" : "back")));
    };
    set(this.#play, 1);
    set(this.#back, -1);
  }

  #write(): void {
    const share = this.#now / this.#end;
    if (!this.playing || Math.abs(share - this.#share) >= seen) {
      this.#share = share;
      this.#slider.value = String(Math.round(share * 10000));
      this.#slider.style.setProperty("--share", share.toFixed(4));
    }
    const text = `${fixed(this.#now, this.#o.decimals ?? 3)} s`;
    this.#time.set(this.#now, text);
    if (!this.playing) this.#slider.setAttribute("aria-valuetext", text);
  }

  #keys(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const busy = target.closest("button, input:not([type=range]), summary, a, select");
    if (event.key === " " && !busy) this.#toggle(1);
    else if (event.key === "," && !target.closest("input[type=text]")) this.step(-1);
    else if (event.key === "." && !target.closest("input[type=text]")) this.step(1);
    else return;
    event.preventDefault();
  }
}
