/** Impulse space: each answer is a point, the cone has what friction can do, the shell is where the energy stays the same.
 * A drawing in lines, seen from a direction that a hand can turn. */
import type { Vec } from "../../core";
import { el } from "../../dom";
import type { Token } from "../../look";
import { digits } from "../../numbers";
import { cross, dot, scaled } from "../../vector";

export interface Spot {
  at: Vec; // [N s], z along the normal
  token: Token;
  great: boolean;
}

export interface Space {
  spots: readonly Spot[];
  friction: number;
  holding: Vec;
  mobility: readonly [Vec, Vec, Vec];
}

const width = 460, height = 330, floor = 56; // of the drawing; its origin over its lower edge
type Flat = readonly [number, number];

export class ImpulseSpace {
  readonly element: HTMLElement;
  readonly #box: HTMLElement;
  #azimuth = -1.2;
  #elevation = 0.22;
  #space: Space | null = null;

  constructor(host: HTMLElement) {
    this.#box = el("div", "space", { tabindex: 0, role: "img", "aria-label": "impulse space" });
    this.element = el("div", "plot", {}, el("p", "plot-title", {}, el("b", "", {}, "Impulse space"), " ", el("span", "", {}, "each answer is a point; drag to turn")), this.#box,
      el("div", "space-legend", {}, el("span", "key", {}, el("i", "cone-key"), "what friction allows"), el("span", "key", {}, el("i", "shell-key"), "inside it energy is lost"),
        el("span", "key", {}, el("i", "holding-key"), "would hold the point")));
    host.append(this.element);
    this.#listen();
  }

  set label(text: string) {
    this.#box.setAttribute("aria-label", text);
  }

  show(space: Space): void {
    this.#space = space;
    this.#draw();
  }

  #draw(): void {
    if (!this.#space) return;
    const { spots, friction, holding, mobility } = this.#space;
    const [a, h] = [this.#azimuth, this.#elevation];
    const right: Vec = [-Math.sin(a), Math.cos(a), 0], upward: Vec = [-Math.cos(a) * Math.sin(h), -Math.sin(a) * Math.sin(h), Math.cos(h)];
    const flat = (p: Vec): Flat => [dot(p, right), dot(p, upward)];
    const seen = [...spots.map((one) => flat(one.at)), flat(holding), [0, 0] as Flat];
    const most = (of: (one: Flat) => number) => Math.max(1e-12, ...seen.map(of));
    const scale = Math.min((height - floor - 34) / most(([, y]) => y), (width / 2 - 50) / most(([x]) => Math.abs(x)));
    const put = ([x, y]: Flat): Flat => [width / 2 + scale * x, height - floor - scale * y];
    const path = (points: readonly Flat[], closed: boolean) => "M" + points.map((one) => put(one).map((value) => value.toFixed(1)).join(" ")).join("L") + (closed ? "Z" : "");
    const line = (from: Vec, to: Vec, look: string) => `<path d="${path([flat(from), flat(to)], false)}" ${look}/>`;
    const ring = (at: Vec, radius: number) => path(around.map(([c, s]) => flat([at[0] + radius * c, at[1] + radius * s, at[2]])), true);
    const top = (height - floor - 12) / (scale * Math.cos(h)), wide = friction * top;

    // The cone: the ring at its top, and the two lines that touch it, if the eye is outside.
    const [c, b] = [top * Math.cos(h), wide * Math.sin(h)];
    const reach = b < c ? wide * Math.sqrt(1 - (b / c) ** 2) : 0, level = b < c ? c - (b * b) / c : 0;
    const sides: Flat[] = [[-reach, level], [0, 0], [reach, level]];
    // The shell p · v + p · W p/2 = 0: its outline is an ellipse about the impulse that holds; none of a point that leaves.
    const inverse = inverseOf(mobility), size = dot(holding, times(mobility, holding));
    const [xx, xy, yy] = [dot(right, times(inverse, right)), dot(right, times(inverse, upward)), dot(upward, times(inverse, upward))];
    const l = Math.sqrt(size * xx), m = (size * xy) / l, n = Math.sqrt(Math.max(0, size * yy - m * m));
    const [x0, y0] = flat(holding);
    const shell = size === 0 ? "" : path(around.map(([cos, sin]) => [x0 + l * cos, y0 + m * cos + n * sin]), true);

    const unit = 10 ** Math.floor(Math.log10(90 / scale)), bar = [5, 2, 1].find((k) => k * unit * scale <= 90)! * unit;
    const tag = (at: Vec, text: string, dx = 0, dy = 0) => {
      const [x, y] = put(flat(at));
      return `<text x="${(x + dx).toFixed(1)}" y="${(y + dy).toFixed(1)}" text-anchor="middle">${text}</text>`;
    };
    const axis = 64 / scale;
    this.#box.innerHTML = `<svg viewBox="0 0 ${width} ${height}" aria-hidden="true">
      ${shell && `<path d="${shell}" class="shell"/>`}
      <path d="${path(sides, true)}" class="cone"/><path d="${ring([0, 0, top], wide)}" class="cone"/><path d="${path(sides, false)}" class="cone-side"/>
      ${line([-axis, 0, 0], [axis, 0, 0], 'class="axis"')}${line([0, -axis, 0], [0, axis, 0], 'class="axis"')}${line([0, 0, 0], [0, 0, top], 'class="axis"')}
      ${tag([axis, 0, 0], "along", 0, 16)}${tag([0, 0, top], "normal", 30, 12)}
      ${spots.map(({ at, token, great }) => line([0, 0, 0], at, `style="stroke: var(--${token})" class="${great ? "arrow great" : "arrow"}"`)).join("")}
      ${spots.map(({ at, token, great }) => `<circle cx="${put(flat(at))[0].toFixed(1)}" cy="${put(flat(at))[1].toFixed(1)}" r="${great ? 6 : 4}" style="fill: var(--${token})"/>`).join("")}
      ${shell && `<circle cx="${put(flat(holding))[0].toFixed(1)}" cy="${put(flat(holding))[1].toFixed(1)}" r="4" class="holding"/>`}
      <path d="M16 ${height - 14}h${(bar * scale).toFixed(1)}" class="bar"/><text x="${(16 + bar * scale + 8).toFixed(1)}" y="${height - 10}">${digits(1e3 * bar, 1)} mN s</text>
    </svg>`;
  }

  #turn(azimuth: number, elevation: number): void {
    this.#azimuth += azimuth;
    this.#elevation = Math.min(1.35, Math.max(0.02, this.#elevation + elevation));
    this.#draw();
  }

  #listen(): void {
    const box = this.#box;
    let held = -1, x = 0, y = 0;
    box.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      held = event.pointerId;
      [x, y] = [event.clientX, event.clientY];
      box.setPointerCapture(held);
    });
    box.addEventListener("pointermove", (event) => {
      if (event.pointerId !== held) return;
      this.#turn(-(event.clientX - x) * 0.01, (event.clientY - y) * 0.006);
      [x, y] = [event.clientX, event.clientY];
    });
    for (const end of ["pointerup", "pointercancel"] as const) box.addEventListener(end, () => (held = -1));
    box.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [0.12, 0], ArrowRight: [-0.12, 0], ArrowUp: [0, 0.12], ArrowDown: [0, -0.12] }[event.key];
      if (!way || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      this.#turn(way[0]!, way[1]!);
    });
  }
}

const around = Array.from({ length: 72 }, (_, i) => [Math.cos((i * Math.PI) / 36), Math.sin((i * Math.PI) / 36)] as const);
const times = (columns: readonly [Vec, Vec, Vec], p: Vec): Vec =>
  [0, 1, 2].map((k) => columns[0][k as 0] * p[0] + columns[1][k as 0] * p[1] + columns[2][k as 0] * p[2]) as unknown as Vec;

/** Of a symmetric matrix, by columns. */
function inverseOf([a, b, c]: readonly [Vec, Vec, Vec]): readonly [Vec, Vec, Vec] {
  const bc = cross(b, c), ca = cross(c, a), ab = cross(a, b), det = dot(a, bc);
  return [bc, ca, ab].map((one) => scaled(1 / det, one)) as unknown as readonly [Vec, Vec, Vec];
}
