/** What is done to the stones: each action with its moment, in whole numbers, so that a link has them exactly. */
import type { Control } from "../../controls";
import type { Vec } from "../../core";

/** Moments are numbered: so many are in a second. */
export const rate = 120;
/** The last moment there is. */
export const last = 40 * rate;

/** In units that need no fraction: 10 µm, mm/s, µN s, mm/s². */
export const unit = { length: 1e5, speed: 1e3, impulse: 1e6, strength: 1e3 } as const;

/** `of` are whole numbers: what they mean stands beside each kind. */
export interface Action {
  at: number;
  kind: Kind;
  of: readonly number[];
}

/** For each number the least and the greatest. */
const length = [-200000, 200000], speed = [-5000, 5000], impulse = [-20000, 20000], color = [0, 1], id = [0, 4000];
const kinds = {
  b: [[1, 100000]],                                                                // the board is bumped: strength
  p: [id, length, length, length, impulse, impulse, impulse],                      // a push: stone, point, impulse
  h: [id, speed, speed, speed, [1, rate]],                                         // a hand moves it: stone, velocity, for how many moments
  r: [id],                                                                         // and lets it go
  l: [color, length, length],                                                      // a hand lays one down: color, x, y
  t: [color, length, length, length, speed, speed, speed, [-100, 100], [-200, 200]], // one is thrown: color, place, velocity, tilt in %, spin [rad/s]
} as const satisfies Record<string, readonly (readonly number[])[]>;
export type Kind = keyof typeof kinds;

const most = 2000;

export const format = (actions: readonly Action[]): string =>
  actions.map(({ at, kind, of }) => [`${kind}${at}`, ...of].join(".")).join("~");

/** Null where something is not as it must be. */
export function parse(text: string): Action[] | null {
  if (text === "") return [];
  const actions: Action[] = [];
  for (const part of text.split("~")) {
    const match = /^([a-z])(\d{1,5})((?:\.-?\d{1,6})+)$/.exec(part), rules = kinds[match?.[1] as Kind] as readonly (readonly number[])[] | undefined;
    if (!match || !rules) return null;
    const at = Number(match[2]), of = match[3]!.slice(1).split(".").map(Number);
    const right = at <= last && at >= (actions.at(-1)?.at ?? 0) && of.length === rules.length &&
      of.every((value, i) => value >= rules[i]![0]! && value <= rules[i]![1]!);
    if (!right || actions.length === most) return null;
    actions.push({ at, kind: match[1] as Kind, of });
  }
  return actions;
}

/** The nearest action of a kind to these values. */
export const action = (kind: Kind, at: number, ...values: readonly number[]): Action =>
  ({ at, kind, of: values.map((value, i) => Math.min(kinds[kind][i]![1]!, Math.max(kinds[kind][i]![0]!, Math.round(value))) + 0) });

/** Three of its numbers in SI units. */
export const vector = (of: readonly number[], from: number, scale: number): Vec => [of[from]! / scale, of[from + 1]! / scale, of[from + 2]! / scale];

/** The actions in the address. */
export class Deeds implements Control {
  readonly key = "do";
  list: readonly Action[] = [];

  get text(): string {
    return format(this.list);
  }

  accept(text: string): boolean {
    const list = parse(text);
    if (list) this.list = list;
    return list !== null;
  }

  get isDefault(): boolean {
    return this.list.length === 0;
  }

  reset(): void {
    this.list = [];
  }
}
