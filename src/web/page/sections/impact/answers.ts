/** One impact, and what five ways to answer it make of it. All numbers are the library's. */
import { C, vec, type Goishi, type Numbers, type Vec } from "../../core";
import type { Token } from "../../look";
import { scaled } from "../../vector";

export const plane = Float64Array.from([0, 0, 1, 0]); // the board's surface
const up: Vec = [0, 0, 1];

export const ways = {
  linear: { label: "linear", short: "linear", token: "soft", law: C.CHATTERJEE_RUINA },
  angular: { label: "angular", short: "angular", token: "omega", law: C.CHATTERJEE_RUINA },
  talk: { label: "friction, the talk’s law", short: "the talk’s", token: "published", law: C.PUBLISHED_LAW },
  stronge: { label: "friction, Stronge’s law", short: "Stronge’s", token: "momentum", law: C.STRONGE },
  default: { label: "friction, Goishi’s default", short: "Goishi’s", token: "exact", law: C.CHATTERJEE_RUINA },
} as const satisfies Record<string, { label: string; short: string; token: Token; law: number }>;
export type Way = keyof typeof ways;
/** Whether it has friction. */
export const rubs = (way: Way) => way !== "linear" && way !== "angular";
export const all = Object.keys(ways) as Way[];

/** In the units of the controls. */
export interface Meeting {
  bevel: number;   // [mm]
  tilt: number;    // [°]
  down: number;    // [m/s]
  along: number;   // [m/s]
  tumble: number;  // [rad/s] about the level axis across the lean
  spin: number;    // [rad/s] about its own
  restitution: number;
  friction: number;
}

export interface Answer {
  impulse: Vec;    // [N s]
  after: Vec;      // [m/s] of the point of contact
  rebound: number; // −v⁺·n / v⁻·n of it; NaN if it does not approach
  slip: number;    // [m/s] across the normal, after
  moving: number;  // [J] of translation, after
  turning: number; // [J] of rotation, after
  rounds: number;
  outcome: number;
  state: Numbers;
  until: number;   // [s] after which it touches again, at most `horizon`
}

export interface Met {
  stone: Numbers;
  gravity: Vec;
  state: Numbers;   // at the impact, before it
  point: Vec;       // [m]
  before: Vec;      // [m/s] of the point of contact
  moving: number;   // [J] before
  turning: number;
  since: number;    // [s] for which it has been in the air, at most `horizon`
  holding: Vec;     // [N s] the impulse that would stop the point of contact
  mobility: readonly [Vec, Vec, Vec];  // W [1/kg], by columns: what an impulse changes of its velocity
  answers: Record<Way, Answer>;
}

/** Looked ahead and back   [s]. */
export const horizon = 0.06;

export function meet(goishi: Goishi, { bevel, tilt, down, along, tumble, spin, restitution, friction }: Meeting): Met {
  const gravity = vec(goishi.settings(), C.GRAVITY);
  const stone = goishi.catalogueStone(33, C.WHITE, 1e-3 * bevel), half = (tilt * Math.PI) / 360;
  const pose = (z: number) => Float64Array.from([0, 0, z, Math.cos(half), 0, Math.sin(half), 0]);
  const place = pose(1 - goishi.separation(stone, pose(1), plane)[C.GAP]!);
  const point = vec(goishi.separation(stone, place, plane), C.POINT);
  const state = goishi.state(stone, place, [along, 0, -down], [0, tumble, spin]);

  /** Of the state's velocities, those of a rigid body without gravity   [J]. */
  const energy = (of: Numbers) => goishi.freeFlight(stone, of, [0, 0, 0], C.BOTH, 0)[C.ENERGY]!;
  const still = (of: Numbers, place_: number) => {
    const result = of.slice();
    result.fill(0, place_, place_ + 3);
    return result;
  };
  const parts = (of: Numbers) => ({ moving: energy(still(of, C.MOMENTUM)), turning: energy(still(of, C.VELOCITY)) });
  /** How the point of contact moves   [m/s]. */
  const pointOf = (of: Numbers) => vec(goishi.impact(stone, of, C.CHATTERJEE_RUINA, 0, 0, point, up), C.VELOCITY_BEFORE);
  const touchesAfter = (of: Numbers) => {
    const hit = goishi.timeOfImpact(stone, of, gravity, plane, horizon);
    return hit[C.HIT_STATUS] === C.HIT ? hit[C.HIT_TIME]! : horizon;
  };

  const before = pointOf(state);
  const answer = (way: Way): Answer => {
    // Without rotation it is the impact of a stone that is touched right below its centre.
    const found = goishi.impact(stone, state, ways[way].law, restitution, rubs(way) ? friction : 0,
      way === "linear" ? vec(state, C.POSITION) : point, up);
    const next = state.slice();
    next.set(found.subarray(C.NEW_VELOCITY, C.NEW_VELOCITY + 3), C.VELOCITY);
    next.set(found.subarray(C.NEW_MOMENTUM, C.NEW_MOMENTUM + 3), C.MOMENTUM);
    const after = pointOf(next);
    return { impulse: vec(found, C.IMPULSE), after, rebound: before[2] < 0 ? -after[2] / before[2] : NaN, slip: Math.hypot(after[0], after[1]), ...parts(next),
      rounds: found[C.ROUNDS]!, outcome: found[C.OUTCOME]!, state: next, until: after[2] < 0 ? horizon : touchesAfter(next) };
  };

  // W by its columns: a plastic impact along each direction, of a stone that comes straight along it.
  const column = (n: Vec): Vec => {
    const found = goishi.impact(stone, goishi.state(stone, place, scaled(-1, n), [0, 0, 0]), C.CHATTERJEE_RUINA, 0, 0, point, n);
    return [0, 1, 2].map((k) => (found[C.VELOCITY_AFTER + k]! - found[C.VELOCITY_BEFORE + k]!) / found[C.NORMAL_IMPULSE]!) as unknown as Vec;
  };
  const back = state.slice();
  for (const k of [0, 1, 2]) {
    back[C.VELOCITY + k]! *= -1;
    back[C.MOMENTUM + k]! *= -1;
  }
  return {
    stone, gravity, state, point, before, ...parts(state), since: before[2] < 0 ? touchesAfter(back) : 0,
    holding: vec(goishi.impact(stone, state, C.CHATTERJEE_RUINA, 0, Infinity, point, up), C.IMPULSE),
    mobility: [column([1, 0, 0]), column([0, 1, 0]), column([0, 0, 1])],
    answers: Object.fromEntries(all.map((way) => [way, answer(way)])) as Record<Way, Answer>,
  };
}
