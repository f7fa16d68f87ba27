/** The library: the functions of goishi.h as methods of one class, which copies results out of its memory and throws its
 * messages. Arrays, places, units and frames are those of goishi.h; `../constants` has its GOISHI_… without the prefix. */
import * as C from "../constants";
import make from "../goishi.mjs";

export { C };

/** Numbers as goishi.h has them: a stone, a state, a motion … */
export type Numbers = Float64Array;
export type Vec = readonly [number, number, number];

/** What the library refused, in its words: "height = 0.03: must not exceed the width (0.022)". */
export class Refused extends Error {}

interface Module {
  HEAPU8: Uint8Array<ArrayBuffer>;
  _malloc(bytes: number): number;
  _free(at: number): void;
  UTF8ToString(at: number): string;
  [name: `_goishi_${string}`]: (...given: number[]) => number;
}

/** An output: `doubles`, `words` (32-bit integers) or `one` integer or pointer, which comes without a size. */
interface Out {
  kind: "doubles" | "words" | "one";
  size: number;
}
const doubles = (size: number): Out => ({ kind: "doubles", size });
const words = (size: number): Out => ({ kind: "words", size });
const one: Out = { kind: "one", size: 1 };

type Argument = number | Numbers | Int32Array | readonly number[] | Out;

const bytesOf = (size: number) => Math.max(8 * size, 8);

export class Goishi {
  readonly #module: Module;

  private constructor(module: Module) {
    this.#module = module;
  }

  static async start(wasmBinary: Uint8Array): Promise<Goishi> {
    return new Goishi((await make({ wasmBinary })) as Module);
  }

  get version(): string {
    return this.#module.UTF8ToString(this.#module._goishi_version());
  }

  /** Calls a function: arrays become pointer and size. What its outputs hold, in their order. */
  #call(name: string, ...given: readonly Argument[]): Float64Array[] {
    const module = this.#module;
    const blocks: number[] = [], passed: number[] = [];
    const outs: { at: number; out: Out }[] = [];
    const block = (bytes: number) => {
      const at = module._malloc(bytes);
      if (at === 0) throw new Refused("out of memory");
      blocks.push(at);
      return at;
    };
    try {
      for (const argument of given) {
        if (typeof argument === "number") {
          passed.push(argument);
        } else if (argument instanceof Int32Array) {
          const at = block(bytesOf(argument.length));
          new Int32Array(module.HEAPU8.buffer, at, argument.length).set(argument);
          passed.push(at, argument.length);
        } else if ("kind" in argument) {
          const at = block(bytesOf(argument.size));
          new Uint8Array(module.HEAPU8.buffer, at, bytesOf(argument.size)).fill(0); // rows that are not filled
          outs.push({ at, out: argument });
          passed.push(at);
          if (argument.kind !== "one") passed.push(argument.size);
        } else {
          const at = block(bytesOf(argument.length));
          new Float64Array(module.HEAPU8.buffer, at, argument.length).set(argument);
          passed.push(at, argument.length);
        }
      }
      const status = module[`_goishi_${name}`]!(...passed);
      if (status !== C.OK) throw new Refused(module.UTF8ToString(module._goishi_message()));
      return outs.map(({ at, out }) => out.kind === "doubles"
        ? new Float64Array(module.HEAPU8.buffer, at, out.size).slice()
        : Float64Array.from(new Int32Array(module.HEAPU8.buffer, at, out.size)));
    } finally {
      blocks.forEach((at) => module._free(at));
    }
  }

  #numbers(name: string, ...given: readonly Argument[]): Numbers {
    return this.#call(name, ...given)[0]!;
  }

  // --- A stone

  catalogueStone(number: number, color: number, bevel: number): Numbers {
    return this.#numbers("catalogue_stone", number, color, bevel, doubles(C.STONE_SIZE));
  }

  measures(stone: Numbers): Numbers {
    return this.#numbers("measures", stone, doubles(C.MEASURES_SIZE));
  }

  publishedMeasures(stone: Numbers): Numbers {
    return this.#numbers("published_measures", stone, doubles(C.PUBLISHED_MEASURES_SIZE));
  }

  /** In W, row by row, about its origin. */
  tensor(stone: Numbers, pose: Numbers | readonly number[]): Numbers {
    return this.#numbers("tensor", stone, pose, doubles(9));
  }

  /** Rows of PROFILE_SIZE. */
  profile(stone: Numbers, steps: number): Numbers {
    const parts = stone[C.BEVEL] === 0 ? 2 : 3;
    return this.#numbers("profile", stone, steps, doubles(parts * (steps + 1) * C.PROFILE_SIZE));
  }

  // --- A stone as triangles

  /** By a level, or with level −1 by a tolerance [m]. */
  fineness(stone: Numbers, method: number, level: number, tolerance = 0): Int32Array {
    return Int32Array.from(this.#numbers("fineness", stone, method, level, tolerance, words(C.FINENESS_SIZE)));
  }

  meshFigures(stone: Numbers, method: number, fineness: Int32Array, weld: number): Numbers {
    return this.#numbers("mesh_figures", stone, method, fineness, weld, doubles(C.MESH_FIGURES_SIZE));
  }

  meshCounts(stone: Numbers, method: number, fineness: Int32Array, weld: number): { vertices: number; triangles: number } {
    const [vertices, triangles] = this.#call("mesh_counts", stone, method, fineness, weld, one, one);
    return { vertices: vertices![0]!, triangles: triangles![0]! };
  }

  mesh(stone: Numbers, method: number, fineness: Int32Array, weld: number) {
    const { vertices, triangles } = this.meshCounts(stone, method, fineness, weld);
    const [points, normals, corners] = this.#call("mesh", stone, method, fineness, weld,
      doubles(3 * vertices), doubles(3 * vertices), words(3 * triangles)) as [Numbers, Numbers, Numbers];
    return { points, normals, corners: Uint32Array.from(corners) };
  }

  // --- Motion

  /** `spin` is w_WB_B [rad/s]. */
  state(stone: Numbers, pose: Numbers | readonly number[], velocity: Vec, spin: Vec): Numbers {
    return this.#numbers("state", stone, pose, velocity, spin, doubles(C.STATE_SIZE));
  }

  freeFlight(stone: Numbers, state: Numbers, gravity: Vec, freedom: number, time: number): Numbers {
    return this.#numbers("free_flight", stone, state, gravity, freedom, time, doubles(C.MOTION_SIZE));
  }

  /** q_WB and ω in W of a body with these moments, axial and transverse. */
  freeRotation(moments: readonly [number, number], attitude: readonly number[], momentum: Vec, time: number): Numbers {
    return this.#numbers("free_rotation", moments, attitude, momentum, time, doubles(7));
  }

  /** Rows of FLIGHT_SIZE, those that were reached, and how it ended. */
  flight(stone: Numbers, state: Numbers, gravity: Vec, freedom: number, scheme: number, step: number, steps: number,
         rows: number): { rows: Numbers; count: number; ended: number } {
    const [all, done, ended] = this.#call("flight", stone, state, gravity, freedom, scheme, step, steps,
      doubles(rows * C.FLIGHT_SIZE), one, one) as [Numbers, Numbers, Numbers];
    return { rows: all.subarray(0, done[0]! * C.FLIGHT_SIZE), count: done[0]!, ended: ended[0]! };
  }

  // --- Contact

  board(): Numbers {
    return this.#numbers("board", doubles(C.BOARD_SIZE));
  }

  separation(stone: Numbers, pose: Numbers, ground: Numbers): Numbers {
    return this.#numbers("separation", stone, pose, ground, doubles(C.SEPARATION_SIZE));
  }

  publishedSeparation(stone: Numbers, pose: Numbers, board: Numbers): Numbers {
    return this.#numbers("published_separation", stone, pose, board, doubles(C.PUBLISHED_SEPARATION_SIZE));
  }

  separationStones(stone: Numbers, pose: Numbers, other: Numbers, otherPose: Numbers): Numbers {
    return this.#numbers("separation_stones", stone, pose, other, otherPose, doubles(C.SEPARATION_SIZE));
  }

  timeOfImpact(stone: Numbers, state: Numbers, gravity: Vec, ground: Numbers, horizon: number): Numbers {
    return this.#numbers("time_of_impact", stone, state, gravity, ground, horizon, doubles(C.HIT_SIZE));
  }

  timeOfImpactStones(stone: Numbers, state: Numbers, other: Numbers, otherState: Numbers, gravity: Vec,
                     horizon: number): Numbers {
    return this.#numbers("time_of_impact_stones", stone, state, other, otherState, gravity, horizon, doubles(C.HIT_SIZE));
  }

  // --- Impact

  impact(stone: Numbers, state: Numbers, law: number, restitution: number, friction: number, point: Vec | Numbers,
         normal: Vec | Numbers): Numbers {
    return this.#numbers("impact", stone, state, law, restitution, friction, point, normal, doubles(C.IMPACT_SIZE));
  }

  impactStones(stone: Numbers, state: Numbers, other: Numbers, otherState: Numbers, law: number, restitution: number,
               friction: number, point: Vec | Numbers, normal: Vec | Numbers): Numbers {
    return this.#numbers("impact_stones", stone, state, other, otherState, law, restitution, friction, point, normal,
      doubles(C.IMPACT_STONES_SIZE));
  }

  // --- The drop

  settings(): Numbers {
    return this.#numbers("settings", doubles(C.SETTINGS_SIZE));
  }

  /** To be freed by `free()`; what has been forgotten is freed with the page. */
  drop(stone: Numbers, state: Numbers, ground: Numbers, settings: Numbers, kept: number): Drop {
    const handle = this.#numbers("drop_create", stone, state, ground, settings, kept, one)[0]!;
    const call = (name: string, ...given: readonly Argument[]) => this.#call(`drop_${name}`, ...given)[0]!;
    return new Drop(handle, call, () => this.#module._goishi_drop_free!(handle));
  }

  holds(stone: Numbers, pose: Numbers, ground: Numbers, settings: Numbers): Numbers {
    return this.#numbers("holds", stone, pose, ground, settings, doubles(C.HOLD_SIZE));
  }

  // --- A scene

  sceneSettings(): Numbers {
    return this.#numbers("scene_settings", doubles(C.SCENE_SETTINGS_SIZE));
  }

  /** To be freed by `free()`. */
  scene(board: Numbers, settings: Numbers): StoneScene {
    return this.#scene(this.#numbers("scene_create", board, settings, one)[0]!);
  }

  #scene(handle: number): StoneScene {
    return new StoneScene(handle, (name, ...given) => this.#call(`scene_${name}`, ...given), (other) => this.#scene(other),
      () => this.#module._goishi_scene_free!(handle));
  }
}

/** A stone under way. */
export class Drop {
  readonly #handle: number;
  readonly #call: (name: string, ...given: readonly Argument[]) => Numbers;
  readonly free: () => void;

  constructor(handle: number, call: (name: string, ...given: readonly Argument[]) => Numbers, free: () => void) {
    this.#handle = handle;
    this.#call = call;
    this.free = free;
  }

  advance(dt: number): void {
    this.#call("advance", this.#handle, dt);
  }

  push(point: Vec, impulse: Vec): void {
    this.#call("push", this.#handle, point, impulse);
  }

  change(settings: Numbers): void {
    this.#call("change", this.#handle, settings);
  }

  info(): Numbers {
    return this.#call("info", this.#handle, doubles(C.DROP_SIZE));
  }

  /** One array of EVENT_SIZE for each event. */
  events(): Numbers[] {
    const count = this.info()[C.DROP_EVENTS]!;
    if (count === 0) return [];
    return rowsOf(this.#call("events", this.#handle, 0, doubles(count * C.EVENT_SIZE)), C.EVENT_SIZE);
  }

  /** One array of MOTION_SIZE for each time [s]. */
  motions(times: readonly number[] | Numbers, side: number = C.AFTER): Numbers[] {
    if (times.length === 0) return [];
    return rowsOf(this.#call("motions", this.#handle, times, side, doubles(times.length * C.MOTION_SIZE)), C.MOTION_SIZE);
  }
}

/** A board with many stones: a scene of the library, whose name the drawings have, too. */
export class StoneScene {
  readonly #handle: number;
  readonly #call: (name: string, ...given: readonly Argument[]) => Numbers[];
  readonly #other: (handle: number) => StoneScene;
  readonly free: () => void;

  constructor(handle: number, call: (name: string, ...given: readonly Argument[]) => Numbers[], other: (handle: number) => StoneScene,
              free: () => void) {
    this.#handle = handle;
    this.#call = call;
    this.#other = other;
    this.free = free;
  }

  /** To be freed, too. */
  copy(): StoneScene {
    return this.#other(this.#call("copy", this.#handle, one)[0]![0]!);
  }

  /** Its id. */
  add(stone: Numbers, state: Numbers): number {
    return this.#call("add", this.#handle, stone, state, one)[0]![0]!;
  }

  advanceTo(time: number): void {
    this.#call("advance_to", this.#handle, time);
  }

  push(id: number, point: Vec, impulse: Vec): void {
    this.#call("push", this.#handle, id, point, impulse);
  }

  /** With a velocity and without turning, for a time. */
  hold(id: number, velocity: Vec, duration: number): void {
    this.#call("hold", this.#handle, id, velocity, [0, 0, 0], duration);
  }

  release(id: number): void {
    this.#call("release", this.#handle, id);
  }

  change(settings: Numbers): void {
    this.#call("change", this.#handle, settings);
  }

  info(): Numbers {
    return this.#call("info", this.#handle, doubles(C.SCENE_SIZE))[0]!;
  }

  /** Rows of SCENE_STONE_SIZE, of `count` stones, which it has. */
  stones(count: number): Numbers {
    return count === 0 ? new Float64Array() : this.#call("stones", this.#handle, 0, doubles(count * C.SCENE_STONE_SIZE))[0]!;
  }

  /** One array of SCENE_CONTACT_SIZE for each contact, of which there are at most `most`. */
  contacts(most: number): Numbers[] {
    const [rows, count] = this.#call("contacts", this.#handle, doubles(most * C.SCENE_CONTACT_SIZE), one) as [Numbers, Numbers];
    return rowsOf(rows, C.SCENE_CONTACT_SIZE).slice(0, count[0]!);
  }
}

/** An array cut into rows, which share its memory. */
export const rowsOf = (all: Numbers, size: number): Numbers[] =>
  Array.from({ length: all.length / size }, (_, i) => all.subarray(i * size, (i + 1) * size));

/** Three numbers from a place on. */
export const vec = (numbers: Numbers, at: number): Vec => [numbers[at]!, numbers[at + 1]!, numbers[at + 2]!];
