/** One flight: exactly, and in steps by every method; from what the controls say to everything that is shown of it. */
import { C, vec, type Goishi, type Numbers, type Vec } from "../../core";
import type { Token } from "../../look";

export type Method = "published" | "euler" | "rk4" | "splitting";
export const methods: Record<Method, { label: string; scheme: number; token: Token }> = {
  published: { label: "the talk’s loop", scheme: C.PUBLISHED, token: "published" },
  euler: { label: "L kept, Euler step", scheme: C.EXPLICIT_EULER, token: "euler" },
  rk4: { label: "Runge–Kutta 4", scheme: C.RUNGE_KUTTA_4, token: "rk4" },
  splitting: { label: "splitting, order 6", scheme: C.SPLITTING_6, token: "splitting" },
};

/** What of the motion there is: the talk's demo could switch off either. */
export type Moves = "rotation" | "gravity" | "both";
const freedoms: Record<Moves, number> = { rotation: C.ANGULAR, gravity: C.LINEAR, both: C.BOTH };

/** In the units of the controls. */
export interface Launch {
  moves: Moves;
  method: Method;
  step: number;   // [ms]
  about: number;  // [rad/s] about its axis
  across: number; // [rad/s] across it
  up: number;     // [m/s] of a throw
}

/** The attitude at the start, to be normalised: the axis leans towards the reader. */
export const attitude = [0.11, 0.51, 0.09, 0.85] as const;
export const seconds = 10;  // of a rotation alone
export const sideways = 0.4; // of a throw: so much of its speed up goes along x
const samples = 600;        // of a graph, at most
const traced = 2400;        // points of `tips`, at most

/** The samples of the graphs: the same place in each array is one moment. Where a method has diverged: NaN. */
export interface Series {
  time: number[];
  attitude: Record<Method, number[]>; // [rad] from the exact one
  place: Record<Method, number[]>;    // [m]
  energy: number[];                   // of the method that is shown: share of its start by which it is off
  momentum: number[];                 // |L − L₀| / |L₀|
  size: number[];                     // |L| / |L₀| − 1
}

export class Flight {
  readonly gravity: Vec;
  readonly state: Numbers;
  readonly end: number;      // [s]
  readonly apex: number;     // [m] of a throw, over its start
  readonly step: number;     // [s]
  readonly steps: number;    // until the end
  readonly between: number;  // two points of `tips`, in steps
  readonly turns: boolean;
  readonly flies: boolean;
  readonly series: Series;
  readonly #goishi: Goishi;
  readonly #rows: Numbers;
  readonly #count: number;   // of its rows

  constructor(goishi: Goishi, readonly stone: Numbers, readonly launch: Launch) {
    this.#goishi = goishi;
    const { moves, up } = launch;
    this.turns = moves !== "gravity";
    this.flies = moves !== "rotation";
    this.gravity = vec(goishi.settings(), C.GRAVITY);
    this.end = this.flies ? (2 * up) / -this.gravity[2] : seconds;
    this.apex = this.flies ? (up * this.end) / 4 : 0;
    const velocity: Vec = this.flies ? [sideways * up, 0, up] : [0, 0, 0];
    this.state = goishi.state(stone, [-velocity[0] * this.end / 2, 0, 0, ...attitude], velocity,
      this.turns ? [launch.across, 0, launch.about] : [0, 0, 0]);
    this.step = launch.step * 1e-3;
    this.steps = Math.max(1, Math.floor(this.end / this.step + 1e-9));
    this.between = Math.ceil(this.steps / traced);
    const { rows, count } = this.#flight(launch.method, this.step, 1, this.steps + 1);
    this.#rows = rows;
    this.#count = count;
    this.series = this.#sample();
  }

  #flight(method: Method, step: number, steps: number, rows: number, from: Numbers = this.state) {
    return this.#goishi.flight(this.stone, from, this.gravity, freedoms[this.launch.moves], methods[method].scheme, step, steps, rows);
  }

  /** The last step made at a time. */
  stepAt(time: number): number {
    return Math.min(this.last, Math.floor(time / this.step + 1e-9));
  }

  /** The last step there is. */
  get last(): number {
    return this.#count - 1;
  }

  /** Whether it comes before the end. */
  get diverged(): boolean {
    return this.last < this.steps;
  }

  /** A row of FLIGHT_SIZE after a number of steps. */
  row(step: number): Numbers {
    return this.#rows.subarray(step * C.FLIGHT_SIZE, (step + 1) * C.FLIGHT_SIZE);
  }

  /** The motion of the method: between two steps by a shorter step from the first. */
  readonly stepped = (time: number): Numbers => {
    const last = this.row(this.stepAt(time)), rest = time - last[C.FLIGHT_TIME]!;
    if (rest > 1e-9 * this.step && rest < this.step) {
      const from = last.slice(C.STEPPED, C.STEPPED + C.STATE_SIZE);
      const { rows, count } = this.#flight(this.launch.method, rest, 1, 2, from);
      if (count === 2) return rows.subarray(C.FLIGHT_SIZE + C.STEPPED, C.FLIGHT_SIZE + C.STEPPED + C.MOTION_SIZE);
    }
    return last.subarray(C.STEPPED, C.STEPPED + C.MOTION_SIZE);
  };

  readonly exact = (time: number): Numbers =>
    this.#goishi.freeFlight(this.stone, this.state, this.gravity, freedoms[this.launch.moves], time);

  /** Energy and angular momentum of a row against those of the start; NaN where there are none. */
  kept(row: Numbers): { energy: number; momentum: number; size: number } {
    if (row.length === 0) return { energy: NaN, momentum: NaN, size: NaN }; // it has diverged before
    const first = this.row(0), energy = first[C.STEPPED + C.ENERGY]!;
    const L0 = vec(first, C.STEPPED + C.MOMENTUM), L = vec(row, C.STEPPED + C.MOMENTUM), size = Math.hypot(...L0);
    return {
      energy: row[C.STEPPED + C.ENERGY]! / energy - 1,
      momentum: Math.hypot(...L.map((value, k) => value - L0[k]!)) / size,
      size: Math.hypot(...L) / size - 1,
    };
  }

  #sample(): Series {
    const each = Math.ceil(this.steps / samples), count = Math.floor(this.steps / each) + 1;
    const own = this.launch.method, names = Object.keys(methods) as Method[], places = Array.from({ length: count }, (_, i) => i);
    const errors = (place: number) => Object.fromEntries(names.map((name) => {
      const rows = others.get(name);
      return [name, places.map((i) => (rows ? rows[i * C.FLIGHT_SIZE + place] : this.row(i * each)[place]) ?? NaN)];
    })) as Record<Method, number[]>;
    const others = new Map(names.filter((name) => name !== own).map((name) => [name, this.#flight(name, this.step, each, count).rows]));
    const kept = places.map((i) => this.kept(this.row(i * each)));
    return {
      time: places.map((i) => i * each * this.step),
      attitude: errors(C.ATTITUDE_ERROR), place: errors(C.POSITION_ERROR),
      energy: kept.map((one) => one.energy), momentum: kept.map((one) => one.momentum), size: kept.map((one) => one.size),
    };
  }

  /** Where a vector of the rows points, x, y, z, after each `between` steps. */
  tips(place: number): number[] {
    const points: number[] = [];
    for (let k = 0; k < this.#count; k += this.between) points.push(...vec(this.row(k), place));
    return points;
  }

  /** The way of the centre, in equal parts of the time. */
  way(parts: number, of: (time: number) => Numbers): number[] {
    return Array.from({ length: parts + 1 }, (_, i) => [...vec(of((i * this.end) / parts), C.POSITION)]).flat();
  }

  /** The exact ω over the time in which it goes once round L, which it then repeats: x, y, z of each, and that time [s]. */
  round(parts: number): { points: number[]; period: number } {
    const L = Math.hypot(...vec(this.state, C.MOMENTUM));
    const period = (2 * Math.PI * this.#goishi.measures(this.stone)[C.TRANSVERSE]!) / L;
    if (!Number.isFinite(period)) return { points: [], period: 1 };
    const points = Array.from({ length: parts + 1 }, (_, i) => [...vec(this.exact((i * period) / parts), C.ANGULAR_VELOCITY)]).flat();
    return { points, period };
  }
}
