/** A graph against time: uPlot without cursor and legend. A line shows what is now, a veil lies over what is to come, and
 * dragging over it goes through time. */
import uPlot from "uplot";
import { el, fresh } from "./dom";
import { color, onTheme, type Token } from "./look";
import { digits, power } from "./numbers";

/** What all graphs and timelines leave free beside them   [px]. */
export const gutter = { left: 52, right: 10 } as const;

export interface Line {
  label: string;
  token: Token;
  /** [px]; 1.6 unless it is said. */
  width?: number;
  dash?: number[];
  /** Gaps are bridged: its points are some of x. */
  joined?: boolean;
}

export interface PlotOptions {
  title: string;
  /** Of the numbers at its side, in words: "µJ above rest". */
  unit: string;
  lines: Line[];
  height?: number;
  /** Powers of ten; what is smaller than `least` is drawn there. */
  log?: { least: number };
  /** The ends of the scale for the least and the greatest value; else what uPlot finds good. */
  range?: (least: number, greatest: number) => [number, number];
  /** Where numbers stand at the side; else what uPlot finds good. */
  splits?: number[];
  tick?: (value: number) => string;
  /** Behind the first number below it: " s"; or the text of each. */
  across?: string;
  tickAcross?: (value: number) => string;
  /** Whether the numbers below it are shown. */
  below?: boolean;
  /** Whether a line shows what is now, and may be dragged; the future is veiled, unless it is no time. */
  scrub?: (x: number) => void;
  veiled?: boolean;
}

const axis = 26; // [px] of the numbers below
const sans = '-apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

export class Plot {
  readonly element: HTMLElement;
  readonly #options: PlotOptions;
  readonly #field: HTMLElement;
  readonly #now = el("div", "now");
  readonly #veil = el("div", "veil");
  readonly #legend: HTMLElement;
  #lines: Line[];
  #plot: uPlot | null = null;
  #data: uPlot.AlignedData = [[]];
  #from = 0;
  #to = 1;
  #width = 0;
  #time = 0;

  constructor(host: HTMLElement, options: PlotOptions) {
    this.#options = options;
    this.#lines = options.lines;
    const name = fresh("plot");
    this.#field = el("div", "field");
    this.#legend = el("div", "legend");
    this.element = el("div", "plot", { role: "group", "aria-labelledby": name },
      el("p", "plot-title", { id: name }, el("b", "", {}, options.title), " ", el("span", "", {}, options.unit)),
      this.#field, this.#legend);
    host.append(this.element);
    new ResizeObserver(([entry]) => {
      const width = Math.floor(entry!.contentRect.width);
      if (width === this.#width || width === 0) return;
      this.#width = width;
      this.#build();
    }).observe(this.#field);
    onTheme(() => this.#build());
    if (options.scrub) this.#listen(options.scrub);
    this.#name();
  }

  /** One array of x and one of y for each line; NaN or null leaves a gap. x goes from … to, which need not be the data's. */
  set(x: ArrayLike<number>, ys: readonly ArrayLike<number | null>[], from = x[0] ?? 0, to = x[x.length - 1] ?? 1): void {
    const least = this.#options.log?.least;
    const clean = (value: number | null) =>
      value === null || !Number.isFinite(value) ? null : least === undefined ? value : Math.max(least, Math.abs(value));
    this.#data = [Array.from(x), ...ys.map((y) => Array.from(y, clean))] as uPlot.AlignedData;
    [this.#from, this.#to] = [from, to > from ? to : from + 1];
    if (this.#plot) {
      this.#plot.setData(this.#data, true);
      this.#move();
    } else {
      this.#build();
    }
  }

  /** Other lines: the next `set` has theirs. */
  set lines(lines: Line[]) {
    this.#lines = lines;
    this.#name();
    this.#plot?.destroy();
    this.#plot = null;
  }

  /** Where now is. */
  now(x: number): void {
    this.#time = x;
    this.#move();
  }

  #name(): void {
    this.#legend.replaceChildren(...(this.#lines.length < 2 ? [] : this.#lines.map((line) =>
      el("span", "key", {}, el("i", "", { style: `background: var(--${line.token})` }), line.label))));
  }

  #build(): void {
    if (this.#width === 0) return;
    this.#plot?.destroy();
    const { log, range, splits, tick, tickAcross, across = "", below = true, height = 118 } = this.#options;
    const ink = color("soft"), faint = color("line"), font = `12px ${sans}`;
    const label = tick ?? ((value: number) => (log ? tens(Math.round(Math.log10(value))) : plain(value)));
    this.#plot = new uPlot({
      width: this.#width, height, padding: [8, gutter.right, below ? 0 : 8, 0],
      cursor: { show: false }, legend: { show: false },
      scales: {
        x: { time: false, range: () => [this.#from, this.#to] },
        y: {
          distr: log ? 3 : 1,
          range: (_, least, greatest) => range
            ? range(least ?? 0, greatest ?? 1)
            : log
              ? [10 ** Math.floor(Math.log10(least ?? log.least)), 10 ** Math.ceil(Math.log10((greatest ?? 1) * 1.0001))]
              : padded(least ?? 0, greatest ?? 1),
        },
      },
      axes: [
        {
          show: below, stroke: ink, font, size: axis, gap: 4, grid: { show: false }, ticks: { show: true, stroke: faint, width: 1, size: 4 },
          space: 62, values: (_, values) => values.map((value, i) => (tickAcross ? tickAcross(value) : i === 0 ? plain(value) + across : plain(value))),
        },
        {
          stroke: ink, font, size: gutter.left, gap: 4, grid: { stroke: faint, width: 1 }, ticks: { show: false }, space: log ? 24 : 30,
          values: (_, values) => values.map((value) => (value === null ? "" : label(value))),
          ...(log ? { filter: (_: uPlot, values: (number | null)[]) => values } : {}),
          ...(splits ? { splits: () => splits } : log ? { splits: (_: uPlot, __: number, least: number, greatest: number) => powers(least, greatest) } : {}),
        },
      ],
      series: [{}, ...this.#lines.map((line) => ({
        stroke: color(line.token), width: line.width ?? 1.6, points: { show: false }, spanGaps: line.joined ?? false,
        ...(line.dash ? { dash: line.dash } : {}),
      }))],
    }, this.#data, this.#field);
    if (this.#options.scrub) this.#field.append(...(this.#options.veiled === false ? [] : [this.#veil]), this.#now);
    this.#now.style.bottom = `${below ? axis : 8}px`;
    this.#veil.style.bottom = `${(below ? axis : 8) - 2}px`; // a line along the lower edge is veiled, too
    this.#move();
  }

  #move(): void {
    const plot = this.#plot;
    if (!plot || !this.#options.scrub) return;
    const width = this.#width - gutter.left - gutter.right;
    const share = Math.min(1, Math.max(0, (this.#time - this.#from) / (this.#to - this.#from)));
    const at = Math.round(gutter.left + share * width), place = `translateX(${at}px)`;
    if (this.#now.style.transform === place) return;
    this.#now.style.transform = this.#veil.style.transform = place;
  }

  #listen(scrub: (x: number) => void): void {
    let held = -1;
    const to = (event: PointerEvent) => {
      const box = this.#field.getBoundingClientRect();
      const share = (event.clientX - box.left - gutter.left) / (box.width - gutter.left - gutter.right);
      scrub(this.#from + Math.min(1, Math.max(0, share)) * (this.#to - this.#from));
    };
    this.#field.classList.add("scrub");
    this.#field.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      held = event.pointerId;
      this.#field.setPointerCapture(held);
      to(event);
    });
    this.#field.addEventListener("pointermove", (event) => {
      if (event.pointerId === held) to(event);
    });
    for (const end of ["pointerup", "pointercancel"] as const) this.#field.addEventListener(end, () => (held = -1));
  }
}

const plain = (value: number | null) =>
  value === null ? "" : value === 0 ? "0" : Math.abs(value) >= 1000
    ? String(Math.round(value)).replace("-", "−").replace(/(\d)(?=(\d{3})+$)/g, "$1\u202f")
    : digits(Number(value.toPrecision(6)), 6).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");

const tens = (exponent: number) => (exponent === 0 ? "1" : exponent === 1 ? "10" : power(exponent));

/** At most six powers of ten in a range, evenly, 1 among them if it is in it. */
const powers = (least: number, greatest: number): number[] => {
  const low = Math.ceil(Math.log10(least) - 1e-9), high = Math.floor(Math.log10(greatest) + 1e-9), by = Math.ceil((high - low + 1) / 6);
  const first = Math.ceil(low / by);
  return Array.from({ length: Math.max(0, Math.floor(high / by) - first + 1) }, (_, i) => 10 ** ((first + i) * by));
};

const padded = (least: number, greatest: number): [number, number] => {
  const more = greatest > least ? 0.06 * (greatest - least) : Math.max(1e-12, 0.1 * Math.abs(least));
  return [least - more, greatest + more];
};
