/** A hand that carries a stone where the pointer is, and lets it go: each of its moves is an action. */
import { Plane, Vector3, type Ray } from "three";
import type { Vec } from "../../core";
import { scaled } from "../../vector";
import { action, rate, unit, type Action } from "./actions";

const often = 4;      // moments from one move to the next
const lasting = 8;    // in so many it would be where the pointer is now
const high = 0.02;    // [m] over the board it carries them
const fastest = 1.5;  // [m/s]

export class Hand {
  readonly id: number;
  readonly #level = new Plane(new Vector3(0, 0, 1), -1e3 * high);
  #to: Vec;
  #moved = -Infinity;

  /** Of a stone that is at a place [m] now. */
  constructor(id: number, at: Vec) {
    this.id = id;
    this.#to = [at[0], at[1], high];
  }

  /** Where the pointer is. */
  follow(ray: Ray): void {
    const hit = ray.intersectPlane(this.#level, new Vector3());
    if (hit) this.#to = [hit.x / 1e3, hit.y / 1e3, high];
  }

  /** What it does next; nothing as long as it is on its way. */
  next(moment: number, at: Vec): ((at: number) => Action[]) | null {
    if (moment < this.#moved + often) return null;
    this.#moved = moment;
    const way = this.#to.map((x, k) => ((x - at[k]!) * rate) / lasting) as unknown as Vec, speed = Math.hypot(...way);
    const velocity = scaled(unit.speed * Math.min(1, fastest / Math.max(speed, 1e-9)), way);
    return (when) => [action("h", when, this.id, ...velocity, lasting)];
  }

  release(): (at: number) => Action[] {
    return (when) => [action("r", when, this.id)];
  }
}
