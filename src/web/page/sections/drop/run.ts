/** One drop: from what the controls say to everything that is shown of it. */
import { C, vec, type Drop, type Goishi, type Numbers, type Vec } from "../../core";
import { axisOf, cross, plus } from "../../vector";

/** In the units of the controls. */
export interface Start {
  shell: "white" | "black";
  bevel: number;    // [mm]
  height: number;   // [mm] from the board to the lowest point
  tilt: number;     // [°] of the axis
  spin: number;     // [rad/s] about its axis
  tumble: number;   // [rad/s] across it
  speed: number;    // [m/s] along the lines
  place: number;    // [mm] from the middle of the board
  restitution: number;
  friction: number;
  law: "dry" | "slip";
  rolling: number;  // [mm] δ
  pivot: number;    // [mm] κ
  horizon: number;  // [s] for which it is followed, at most; by then it may still be moving
}

const spacing = 1 / 240;   // [s] between samples
const kept = 60000;        // stretches, of 744 bytes; a drop with more is shown from its later part on
/** [m] A gap as small counts as contact in words, graph and track: contact keeps it at round-off. */
export const touching = 2e-6;

export const size = 33;

/** The stone of the controls. */
export function stoneOf(goishi: Goishi, { shell, bevel }: Pick<Start, "shell" | "bevel">): Numbers {
  return goishi.catalogueStone(size, shell === "white" ? C.WHITE : C.BLACK, bevel * 1e-3);
}

/** Where it is let go, so that its lowest point has the height. */
export function startState(goishi: Goishi, stone: Numbers, start: Start): Numbers {
  const half = (start.tilt * Math.PI) / 360, high = 1;
  const pose = (z: number) => Float64Array.from([start.place * 1e-3, 0, z, Math.cos(half), -Math.sin(half), 0, 0]);
  const plane = Float64Array.from([0, 0, 1, 0]); // beside the board, too, height is over its surface
  const gap = goishi.separation(stone, pose(high), plane)[C.GAP]!;
  return goishi.state(stone, pose(high - gap + start.height * 1e-3), [start.speed, 0, 0], [start.tumble, 0, start.spin]);
}

export function settingsOf(goishi: Goishi, start: Start): Numbers {
  const settings = goishi.settings();
  settings[C.RESTITUTION] = start.restitution;
  settings[C.FRICTION] = start.friction;
  settings[C.ROLLING_RESISTANCE] = start.rolling * 1e-3;
  settings[C.PIVOT_RADIUS] = start.pivot * 1e-3;
  settings[C.FRICTION_MODEL] = start.law === "dry" ? C.DRY : C.SLIP_PROPORTIONAL;
  settings[C.HORIZON] = start.horizon;
  return settings;
}

/** The samples of a graph: the same place in each array is one moment. At an event there are two, before and after. */
export interface Series {
  time: number[];
  energy: number[];   // [J] above that of the stone that lies flat
  tilt: number[];     // [°]
  jellett: number[];  // L·r [kg m³/s] on a cap, else NaN
  track: number[];    // x, y, z [mm] of the point of contact; NaN in the air
  ended: number[];    // for each segment of the track, its time [s]
  /** The moments at which it leans least [s], and whether it then swings over to the other side, as in plain rocking. */
  lows: { time: number; over: boolean }[];
}

export class Run {
  readonly stone: Numbers;
  readonly measures: Numbers;
  readonly state: Numbers;
  readonly settings: Numbers;
  readonly info: Numbers;
  readonly events: Numbers[];
  readonly end: number;
  readonly from: number;
  readonly took: number; // [ms]
  readonly series: Series;
  readonly #goishi: Goishi;
  readonly #surface = Float64Array.from([0, 0, 1, 0]);
  readonly #floor: Numbers;
  readonly #drop: Drop;

  constructor(goishi: Goishi, readonly board: Numbers, readonly start: Start) {
    this.#goishi = goishi;
    this.#floor = Float64Array.from([0, 0, 1, floorOf(board)]);
    this.stone = stoneOf(goishi, start);
    this.measures = goishi.measures(this.stone);
    this.state = startState(goishi, this.stone, start);
    this.settings = settingsOf(goishi, start);
    const began = performance.now();
    this.#drop = goishi.drop(this.stone, this.state, board, this.settings, kept);
    try {
      this.#drop.advance(Infinity);
      this.info = this.#drop.info();
      this.events = this.#drop.events();
    } catch (error) {
      this.#drop.free();
      throw error;
    }
    this.took = performance.now() - began;
    this.end = this.info[C.DROP_TIME]!;
    this.from = this.info[C.DROP_MOTION_BEGIN]!;
    this.series = this.#sample();
  }

  free(): void {
    this.#drop.free();
  }

  /** The motion at a time of the past. */
  at(time: number, side: number = C.AFTER): Numbers {
    return this.#drop.motions([Math.min(this.end, Math.max(this.from, time))], side)[0]!;
  }

  /** What a motion is over the board's surface, or from below that over the floor: gap [m], lowest point [m], part of the stone. */
  over(motion: Numbers): { gap: number; point: Vec; part: number } {
    const ground = motion[C.POSITION + 2]! > 0 ? this.#surface : this.#floor;
    const found = this.#goishi.separation(this.stone, motion.subarray(0, C.POSE_SIZE), ground);
    return { gap: found[C.GAP]!, point: vec(found, C.POINT), part: found[C.FEATURE]! };
  }

  /** The energy of the stone that lies flat on the board   [J]. */
  get lying(): number {
    return -this.measures[C.TRUE_MASS]! * this.settings[C.GRAVITY + 2]! * this.measures[C.MEASURE_HEIGHT]! / 2;
  }

  #sample(): Series {
    const even = Array.from({ length: Math.floor((this.end - this.from) / spacing) + 1 }, (_, i) => this.from + i * spacing);
    const struck = [...new Set(this.events.map((event) => event[C.EVENT_TIME]!))].filter((time) => time >= this.from && time <= this.end);
    const moments = [
      ...even.map((time) => ({ time, side: C.AFTER })),
      ...struck.flatMap((time) => [{ time, side: C.BEFORE }, { time, side: C.AFTER }]),
    ].sort((a, b) => a.time - b.time || a.side - b.side);
    const motions = new Map<number, Numbers[]>();
    for (const side of [C.BEFORE, C.AFTER]) {
      motions.set(side, this.#drop.motions(moments.filter((m) => m.side === side).map((m) => m.time), side));
    }
    const next = new Map<number, number>([[C.BEFORE, 0], [C.AFTER, 0]]);
    const series: Series = { time: [], energy: [], tilt: [], jellett: [], track: [], ended: [], lows: [] };
    const axes: Vec[] = [];
    for (const { time, side } of moments) {
      const i = next.get(side)!;
      next.set(side, i + 1);
      const motion = motions.get(side)![i]!;
      const { gap, point, part } = this.over(motion);
      const inContact = gap < touching && (point[2] < -touching || this.#isOnBoard(point));
      const r = point.map((x, k) => x - motion[C.POSITION + k]!);
      series.time.push(time);
      series.energy.push(motion[C.ENERGY]! - this.lying);
      series.tilt.push(tiltOf(motion));
      axes.push(axisOf(motion, C.ATTITUDE));
      series.jellett.push(inContact && part !== C.RIM ? r.reduce((sum, x, k) => sum + x * motion[C.MOMENTUM + k]!, 0) : NaN);
      if (series.track.length > 0) series.ended.push(time);
      this.#low(series, axes);
      series.track.push(...(inContact ? [1e3 * point[0], 1e3 * point[1], 1e3 * point[2] + 0.12] : [NaN, NaN, NaN]));
    }
    return series;
  }

  /** Whether the last but one sample is a minimum: by the parabola through three, or, where the axis passes through the
   * vertical, by the line through the two that it lies between. */
  #low(series: Series, axes: readonly Vec[]): void {
    const n = series.time.length;
    if (n < 3) return;
    const [a, b, c] = [3, 2, 1].map((back) => Math.min(series.tilt[n - back]!, 180 - series.tilt[n - back]!)) as [number, number, number];
    const [before, now, after] = [3, 2, 1].map((back) => series.time[n - back]!) as [number, number, number];
    if (!(a > b && b <= c) || now === before || after === now) return;
    const u = axes[n - 3]!, along = (back: number) => u[0] * axes[n - back]![0] + u[1] * axes[n - back]![1];
    const [p, q, r] = [along(3), along(2), along(1)];
    if (r < 0) {
      const time = q < 0 ? before + ((now - before) * p) / (p - q) : now + ((after - now) * q) / (q - r);
      series.lows.push({ time, over: true });
    } else {
      const left = (b - a) / (now - before), right = (c - b) / (after - now);
      series.lows.push({ time: (before + now) / 2 - (left * (after - before)) / 2 / (right - left), over: false });
    }
  }

  /** How often it wobbles at a time   [Hz]; NaN where it does not. */
  wobble(time: number): number {
    const { lows } = this.series, next = lows.findIndex((low) => low.time > time);
    if (next < 1) return NaN;
    const [from, to] = [lows[next - 1]!, lows[next]!];
    return 1 / ((from.over && to.over ? 2 : 1) * (to.time - from.time));
  }

  #isOnBoard(point: Vec): boolean {
    const half = (spacingPlace: number, border: number) => this.board[spacingPlace]! * (this.board[C.BOARD_LINES]! - 1) / 2 + this.board[border]!;
    return Math.abs(point[0]) <= half(C.BOARD_SPACING_X, C.BOARD_BORDER_X) && Math.abs(point[1]) <= half(C.BOARD_SPACING_Y, C.BOARD_BORDER_Y);
  }
}

/** The level of the floor   [m]. */
export const floorOf = (board: Numbers): number => -board[C.BOARD_THICKNESS]! - board[C.BOARD_LEGS]!;

/** The angle of the axis from the vertical   [°], 0 … 180. */
export function tiltOf(motion: Numbers): number {
  const x = motion[C.ATTITUDE + 1]!, y = motion[C.ATTITUDE + 2]!, w = motion[C.ATTITUDE]!, z = motion[C.ATTITUDE + 3]!;
  return (2 * Math.atan2(Math.hypot(x, y), Math.hypot(w, z)) * 180) / Math.PI;
}

/** The speed at which the point of the stone moves that is `point` now   [m/s]. */
export function speedAt(motion: Numbers, point: Vec): number {
  const r = point.map((x, k) => x - motion[C.POSITION + k]!) as unknown as Vec;
  return Math.hypot(...plus(vec(motion, C.VELOCITY), 1, cross(vec(motion, C.ANGULAR_VELOCITY), r)));
}
