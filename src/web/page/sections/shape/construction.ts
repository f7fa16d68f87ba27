/** How a stone is made: two circles, their lens, a turn about the axis, a ball along the rim. Drawn in the plane y = 0 of the
 * stone, which is cut open there, in mm. */
import { C, type Goishi, type Numbers, type Vec } from "../../core";
import { el } from "../../dom";
import type { Figure } from "../../figure";
import type { Token } from "../../look";
import { ArrowShape } from "../../shapes/arrow";
import { CutShape } from "../../shapes/cut";
import { StoneShape, type Shell } from "../../shapes/stone";
import { TrailShape } from "../../shapes/trail";

/** How far it has come. */
export interface Progress {
  apart: number; // [mm] by which each circle is still off its place
  sweep: number; // [rad] of the turn about the axis
  bevel: number; // of the bevel's height, from 0 to 1
}

const steps = 48;      // of each part of the profile
const front = -0.04;   // [mm] lines are as much before the face

/** A circle of radius 1 in the plane y = 0, to be moved and scaled. */
function circle(token: Token): TrailShape {
  const line = new TrailShape(token, 2), count = 180;
  line.through(Array.from({ length: count + 1 }, (_, i) => (2 * Math.PI * i) / count).flatMap((angle) => [Math.sin(angle), 0, Math.cos(angle)]));
  return line;
}

function place(line: TrailShape, rho: number, z: number, radius: number): void {
  line.visible = radius > 0;
  line.position.set(rho, front, z);
  line.scale.setScalar(radius > 0 ? radius : 1);
}

const tag = (markup: string, classes = "") => {
  const element = el("span", `tag ${classes}`);
  element.innerHTML = `<i>${markup}</i>`;
  return element;
};

export class Construction {
  /** To be pulled. */
  readonly pole = el("div", "handle up", { "aria-hidden": "true", title: "drag: thickness" });
  readonly rim = el("div", "handle across", { "aria-hidden": "true", title: "drag: width" });
  readonly #goishi: Goishi;
  readonly #figure: Figure;
  readonly #shape: StoneShape;
  readonly #faces = [new CutShape(1), new CutShape(-1), new CutShape(1)] as const; // right, left, and where the turn has come to
  readonly #circles = [circle("exact"), circle("exact")] as const;
  readonly #balls = [circle("normal"), circle("normal")] as const;
  readonly #wrong = [circle("published"), circle("published")] as const;
  readonly #inside = new TrailShape("soft", 1.3);
  readonly #normal = new ArrowShape("ink", { thick: 0.13 });
  readonly #tags = { r: tag("r"), d: tag("d"), wrong: tag("r<sub>2</sub>, wrong", "c-published"), ball: tag("r<sub>2</sub>", "c-normal") };
  readonly #dot = el("span", "dot");

  constructor(goishi: Goishi, figure: Figure, stone: Numbers) {
    this.#goishi = goishi;
    this.#figure = figure;
    this.#shape = new StoneShape(goishi, stone);
    this.#faces[1].rotation.z = Math.PI;
    figure.scene.add(this.#shape, ...this.#faces, ...this.#circles, ...this.#balls, ...this.#wrong, this.#inside, this.#normal);
    figure.overlay.append(...Object.values(this.#tags), this.#dot, this.pole, this.rim);
  }

  paint(shell: Shell): void {
    this.#shape.paint(shell);
    for (const face of this.#faces) face.paint(shell);
    for (const line of [...this.#circles, ...this.#balls, ...this.#wrong, this.#inside, this.#normal]) line.paint();
  }

  /** A stone by its measures; `settled` shows what belongs to the finished one, `published` the talk's bevel. */
  show(stone: Numbers, measures: Numbers, { apart, sweep, bevel }: Progress, settled: boolean, published: Numbers | null): void {
    const mm = (place: number) => 1e3 * measures[place]!;
    const r = mm(C.SPHERE_RADIUS), d = mm(C.SPHERE_OFFSET) + apart;
    const made = this.#made(stone, r, d, apart, bevel);
    this.#circles.forEach((line, side) => place(line, 0, side === 0 ? -d : d, r));
    const profile = made ? this.#goishi.profile(made, steps) : null;
    const turning = 0 < sweep && sweep < 2 * Math.PI && sweep !== Math.PI;
    this.#faces.forEach((face, i) => {
      face.visible = profile !== null && sweep < 2 * Math.PI && (i < 2 || turning);
      if (profile && face.visible) face.reshape(profile);
    });
    this.#faces[2].rotation.z = sweep;
    this.#shape.visible = made !== null && sweep > 0;
    if (made && sweep > 0) this.#shape.reshape(this.#goishi, made, sweep);
    const R1 = mm(C.MAJOR_RADIUS), R2 = mm(C.MINOR_RADIUS), ball = settled && R2 > 0;
    this.#balls.forEach((line, side) => place(line, side === 0 ? R1 : -R1, 0, ball ? R2 : 0));
    const wrong = settled && published ? [1e3 * published[C.PUBLISHED_MAJOR_RADIUS]!, 1e3 * published[C.PUBLISHED_MINOR_RADIUS]!] as const : null;
    this.#wrong.forEach((line, side) => place(line, wrong ? (side === 0 ? wrong[0] : -wrong[0]) : 0, 0, Math.abs(wrong?.[1] ?? 0)));
    const open = settled && sweep <= Math.PI;
    if (open) this.#lines(r, d);
    this.#inside.visible = open;
    const pin = (element: HTMLElement, point: Vec | null) => this.#figure.pin(element, point);
    pin(this.#tags.r, open ? [-0.5 * r * Math.sin(slant), front, -d + 0.5 * r * Math.cos(slant)] : null);
    pin(this.#tags.d, open && d > 2 ? [0.9, front, -d / 2] : null);
    pin(this.#tags.ball, ball && !wrong ? [-R1 - R2 - 1.3, front, 0] : null);
    pin(this.#tags.wrong, wrong ? [-wrong[0] + 0.75 * Math.abs(wrong[1]), front, Math.abs(wrong[1]) + 0.6] : null);
    pin(this.pole, settled ? [0, front, mm(C.MEASURE_HEIGHT) / 2 + 2] : null);
    pin(this.rim, settled ? [mm(C.OUTER_WIDTH) / 2 + 2, front, 0] : null);
  }

  /** Where one is on the profile: a row of it, or nothing. */
  mark(row: Numbers | null): void {
    if (!row) {
      this.#normal.visible = false;
      this.#figure.pin(this.#dot, null);
      return;
    }
    const at: Vec = [1e3 * row[C.RHO]!, front, 1e3 * row[C.ZETA]!];
    this.#normal.point(at, [3.2 * row[C.NORMAL_RHO]!, 0, 3.2 * row[C.NORMAL_ZETA]!]);
    this.#figure.pin(this.#dot, at);
  }

  /** The stone as far as it is made; null before the circles meet. */
  #made(stone: Numbers, r: number, d: number, apart: number, bevel: number): Numbers | null {
    if (apart > 0) { // the lens of two circles that are farther apart
      const height = 2e-3 * (r - d), width = 2e-3 * Math.sqrt(Math.max(0, (r - d) * (r + d)));
      return height > 1e-5 ? Float64Array.from([width, height, 0, 0, stone[C.DENSITY]!, 0]) : null;
    }
    if (bevel >= 1) return stone;
    const part = stone.slice();
    part[C.BEVEL]! *= bevel;
    return part;
  }

  /** The radius of the lower circle to the upper cap, the offset of its centre, and the axis. */
  #lines(r: number, d: number): void {
    const points: number[] = [];
    const segment = (x0: number, z0: number, x1: number, z1: number) => points.push(x0, front, z0, x1, front, z1, NaN, NaN, NaN);
    segment(0, -d, -r * Math.sin(slant), -d + r * Math.cos(slant));
    segment(0, -d, 0, 0);
    segment(-0.35, -d, 0.35, -d);
    for (let z = 0; z < r - d + 6; z += 2.4) { // the axis, in dashes
      segment(0, z, 0, z + 1.5);
      segment(0, z + 1.95, 0, z + 2.05);
    }
    this.#inside.through(points);
  }
}

const slant = 0.42; // [rad] of the radius that is drawn, from the axis
