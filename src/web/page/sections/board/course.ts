/** The course of a scene: computed moment by moment, kept so that time can go back, and begun anew from any moment on. */
import { C, Refused, vec, type Goishi, type Numbers, type StoneScene } from "../../core";
import { pose } from "../../shapes/stones";
import { action, last, rate, unit, vector, type Action } from "./actions";
import { kindsOf, placedBy, settingsOf, type Kinds, type Start } from "./start";

export interface Moment {
  /** `pose.size` numbers a stone. */
  poses: Float32Array;
  energy: number;                // [J] above that of the stones lying flat on the board; NaN while gravity is another
  modes: readonly number[];      // how many stones go on so: C.MODE_FLIGHT …
  print: number;                 // of all numbers that the library gives of the stones, so that one may see whether two scenes are one
}

interface Event {
  at: number;
  run(scene: StoneScene): void;
}

interface Snapshot {
  at: number;
  done: number; // events
  scene: StoneScene;
}

const parts = 8;         // into which the way to the next moment is cut: after each the clock is looked at
const between = rate;    // moments from one snapshot to the next
const bumped = 2;        // moments for which gravity is another
const approach = 0.06;   // [m] over the board a stone that is laid down begins
const gentle = 0.4;      // [m/s]
const above = 3e-4;      // [m] over the board it is let go
const contactsMost = 4000;
const none = 1e9;        // no stone's id

export class Course {
  readonly kinds: Kinds;
  readonly moments: Moment[] = [];
  /** 0 white, 1 black: of each stone. */
  readonly colors: (0 | 1)[] = [];
  /** [ms] of computing. */
  took = 0;
  actions: readonly Action[] = [];
  readonly #goishi: Goishi;
  readonly #settings: Numbers;
  readonly #laid = new Map<Action, number>(); // which stone an action has laid down
  #scene: StoneScene;
  #part = 0;                   // of the way to the next moment
  #events: Event[] = [];
  #done = 0;
  #snapshots: Snapshot[] = [];
  #cursor: Snapshot | null = null; // of the moment that was asked for last
  #rests = false;

  constructor(goishi: Goishi, readonly board: Numbers, start: Start, actions: readonly Action[]) {
    this.#goishi = goishi;
    this.kinds = kindsOf(goishi);
    this.#settings = settingsOf(goishi, start);
    const placed = placedBy(goishi, board, this.kinds, start);
    this.#scene = goishi.scene(board, this.#settings);
    try {
      for (const { color, state } of placed) {
        this.#scene.add(this.kinds.stones[color], state);
        this.colors.push(color);
      }
      this.#do(actions);
      this.#record();
    } catch (error) {
      this.free();
      throw error;
    }
  }

  free(): void {
    for (const { scene } of [...this.#snapshots, ...(this.#cursor ? [this.#cursor] : [])]) scene.free();
    this.#scene.free();
    [this.#snapshots, this.#cursor] = [[], null];
  }

  /** The last moment that is computed. */
  get head(): number {
    return this.moments.length - 1;
  }

  /** The last moment that is not after a time. */
  momentAt(time: number): number {
    return Math.min(this.head, Math.floor(time * rate + 1e-6));
  }

  /** How the stones are drawn at a time: between two moments, between their places. */
  posesAt(time: number): Float32Array {
    const i = this.momentAt(time), share = time * rate - i, poses = this.moments[i]!.poses, next = this.moments[i + 1]?.poses;
    if (!next || share < 1e-3) return poses;
    const result = poses.slice();
    for (let k = 0; k < poses.length; k += pose.size) {
      const at = k + pose.attitude, turn = [0, 1, 2, 3].reduce((sum, j) => sum + poses[at + j]! * next[at + j]!, 0) < 0 ? -1 : 1; // q and −q are one attitude
      for (let j = k; j < k + pose.mode; ++j) result[j] = poses[j]! + share * ((j < at ? 1 : turn) * next[j]! - poses[j]!);
      const norm = Math.hypot(result[at]!, result[at + 1]!, result[at + 2]!, result[at + 3]!);
      for (let j = at; j < at + 4; ++j) result[j]! /= norm;
    }
    return result;
  }

  /** Whether nothing comes after the head. */
  get over(): boolean {
    return (this.#rests && this.#done === this.#events.length) || this.head >= last;
  }

  /** Whether it is over because all stones rest. */
  get rests(): boolean {
    return this.#rests;
  }

  /** Goes on up to a moment, for about so long   [ms]. */
  compute(to: number, most: number): void {
    const began = performance.now();
    for (let now = began; this.head < to && !this.over && now - began < most; now = performance.now()) {
      if (this.#part === 0) this.#act(this.#scene, this.head);
      this.#scene.advanceTo((this.head * parts + this.#part + 1) / (parts * rate));
      this.#part = (this.#part + 1) % parts;
      if (this.#part === 0) this.#record();
    }
    this.took += performance.now() - began;
  }

  /** Something is done at a moment, or, where the next is begun already, then. What was after it is forgotten. The moment; what
   * the library refuses is thrown, and nothing is done. */
  act(moment: number, make: (at: number) => readonly Action[]): number {
    if (moment < this.head) this.#back(moment);
    const at = this.#part === 0 ? this.head : this.head + 1;
    if (at > last) throw new Refused(`A scene is followed for ${last / rate} s.`);
    const before = this.#until(at);
    this.#do([...before, ...make(at)]);
    if (at > this.head) return at;
    try {
      this.#act(this.#scene, at, true);
    } catch (error) { // some of it may be done: back to before it
      if (!(error instanceof Refused)) throw error;
      this.#do(before);
      this.#restore(at);
      throw error;
    }
    return at;
  }

  /** What touches at a moment. */
  contacts(moment: number): Numbers[] {
    if (moment === this.head && this.#part === 0) return this.#scene.contacts(contactsMost);
    let from = this.#cursor;
    if (!from || from.at > moment) {
      from?.scene.free();
      const near = this.#snapshots.findLast(({ at }) => at <= moment)!;
      from = { at: near.at, done: near.done, scene: near.scene.copy() };
    }
    this.#cursor = from;
    for (; from.at < moment; ++from.at) {
      from.done = this.#act(from.scene, from.at, false, from.done);
      from.scene.advanceTo((from.at + 1) / rate);
    }
    return from.scene.contacts(contactsMost);
  }

  /** The counters of the last moment that is computed. */
  info(): Numbers {
    return this.#scene.info();
  }

  // --- inside

  #do(actions: readonly Action[]): void {
    this.actions = actions;
    this.#events = this.#planned();
  }

  /** What is done up to a moment. If more was to come, hands let go what they hold then. */
  #until(moment: number): readonly Action[] {
    const kept = this.actions.filter(({ at }) => at <= moment), held = new Set<number>();
    if (kept.length === this.actions.length) return kept;
    for (const { kind, of } of kept) {
      if (kind === "h") held.add(of[0]!);
      if (kind === "r") held.delete(of[0]!);
    }
    return [...kept, ...[...held].map((id) => action("r", moment, id))];
  }

  /** All that is done, by its moment. */
  #planned(): Event[] {
    const { stones, measures } = this.kinds, events: Event[] = [];
    const gravity = vec(this.#settings, C.GRAVITY);
    const raised = (g: number) => {
      const settings = this.#settings.slice();
      settings.set([gravity[0], gravity[1], g], C.GRAVITY);
      return settings;
    };
    for (const one of this.actions) {
      const { at, kind, of } = one;
      const put = (when: number, run: Event["run"]) => events.push({ at: when, run });
      switch (kind) {
        case "b": {
          put(at, (scene) => scene.change(raised(of[0]! / unit.strength)));
          put(at + bumped, (scene) => scene.change(this.#settings));
          break;
        }
        case "p": put(at, (scene) => scene.push(of[0]!, vector(of, 1, unit.length), vector(of, 4, unit.impulse))); break;
        case "h": put(at, (scene) => scene.hold(of[0]!, vector(of, 1, unit.speed), of[4]! / rate)); break;
        case "r": put(at, (scene) => scene.release(of[0]!)); break;
        case "l": {
          const color = of[0] as 0 | 1, low = measures[color][C.MEASURE_HEIGHT]! / 2 + above;
          const moments = Math.ceil(((approach - low) / gentle) * rate), speed = ((approach - low) * rate) / moments;
          const state = this.#goishi.state(stones[color], [of[1]! / unit.length, of[2]! / unit.length, approach, 1, 0, 0, 0], [0, 0, 0], [0, 0, 0]);
          put(at, (scene) => {
            const id = this.#add(scene, color, state);
            this.#laid.set(one, id);
            scene.hold(id, [0, 0, -speed], moments / rate);
          });
          put(at + moments, (scene) => scene.release(this.#laid.get(one) ?? none));
          break;
        }
        case "t": {
          const color = of[0] as 0 | 1, place = vector(of, 1, unit.length);
          const state = this.#goishi.state(stones[color], [...place, 1, of[7]! / 100, 0, 0], vector(of, 4, unit.speed), [0, 0, of[8]!]);
          put(at, (scene) => void this.#add(scene, color, state));
          break;
        }
      }
    }
    return events.map((event, i) => ({ event, i })).sort((a, b) => a.event.at - b.event.at || a.i - b.i).map(({ event }) => event);
  }

  #add(scene: StoneScene, color: 0 | 1, state: Numbers): number {
    const id = scene.add(this.kinds.stones[color], state);
    this.colors[id] = color;
    return id;
  }

  /** Does what is due at a moment; what the library refuses is left out, or thrown. How much is done. */
  #act(scene: StoneScene, at: number, strict = false, done = this.#done): number {
    for (; done < this.#events.length && this.#events[done]!.at <= at; ++done) {
      try {
        this.#events[done]!.run(scene);
      } catch (error) {
        if (strict || !(error instanceof Refused)) throw error;
      }
    }
    if (scene === this.#scene && done > this.#done) {
      this.#done = done;
      this.#rests = false;
    }
    return done;
  }

  #record(): void {
    const info = this.#scene.info(), count = info[C.SCENE_STONES]!, rows = this.#scene.stones(count);
    const poses = new Float32Array(pose.size * count), modes = [0, 0, 0, 0, 0];
    let flat = 0;
    for (let i = 0; i < count; ++i) {
      const at = i * C.SCENE_STONE_SIZE, mode = rows[at + C.SCENE_STONE_MODE]!, measures = this.kinds.measures[this.colors[i]!];
      poses.set(rows.subarray(at + C.SCENE_STONE_MOTION, at + C.SCENE_STONE_MOTION + C.POSE_SIZE), pose.size * i);
      poses[pose.size * i + pose.mode] = mode;
      modes[mode]!++;
      flat -= (measures[C.TRUE_MASS]! * this.#settings[C.GRAVITY + 2]! * measures[C.MEASURE_HEIGHT]!) / 2;
    }
    const at = this.moments.length, bumps = this.actions.some((one) => one.kind === "b" && one.at < at && at <= one.at + bumped);
    this.moments.push({ poses, energy: bumps ? NaN : info[C.SCENE_ENERGY]! - flat, modes, print: printOf(rows) });
    this.#rests = info[C.SCENE_MOVING] === 0;
    if (this.head % between === 0) this.#snapshots.push({ at: this.head, done: this.#done, scene: this.#scene.copy() });
  }

  /** Back to a moment of the past. */
  #back(moment: number): void {
    this.#do(this.#until(moment));
    this.#restore(moment);
    this.moments.length = moment + 1;
  }

  /** The scene as it is at a moment, after what was done then. */
  #restore(moment: number): void {
    this.#cursor?.scene.free();
    this.#cursor = null;
    while (this.#snapshots.at(-1)!.at > moment) this.#snapshots.pop()!.scene.free();
    const { at, done, scene } = this.#snapshots.at(-1)!;
    this.#scene.free();
    this.#scene = scene.copy();
    [this.#done, this.#part] = [done, 0];
    for (let i = at; i < moment; ++i) {
      this.#act(this.#scene, i);
      this.#scene.advanceTo((i + 1) / rate);
    }
    this.#act(this.#scene, moment);
    this.#rests = this.#scene.info()[C.SCENE_MOVING] === 0;
  }
}

/** One number of many, so that hardly two lists have the same (FNV-1a, 32 bits at a time). */
export function printOf(numbers: Numbers): number {
  const words = new Uint32Array(numbers.buffer, numbers.byteOffset, 2 * numbers.length);
  let low = 0x811c9dc5, high = 0x01000193;
  for (const word of words) {
    low = Math.imul(low ^ word, 0x01000193);
    high = Math.imul(high ^ (word >>> 7) ^ low, 0x85ebca6b);
  }
  return (low >>> 0) + (high >>> 12) * 2 ** 32;
}
