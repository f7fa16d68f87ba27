/** Vectors of three numbers. */
import type { Numbers, Vec } from "./core";

/** a + s b. */
export const plus = (a: Vec, s: number, b: Vec): Vec => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const scaled = (s: number, a: Vec): Vec => [s * a[0], s * a[1], s * a[2]];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a: Vec): Vec => scaled(1 / Math.hypot(...a), a);

/** The direction of a stone's axis, in W: q Bz of the attitude that stands at a place of an array. */
export const axisOf = (numbers: Numbers, at = 0): Vec => {
  const [w, x, y, z] = [0, 1, 2, 3].map((k) => numbers[at + k]!) as [number, number, number, number];
  return [2 * (x * z + w * y), 2 * (y * z - w * x), w * w + z * z - x * x - y * y];
};

/** [mm] of [m]. */
export const mm = (point: Vec | Numbers): Vec => [1e3 * point[0]!, 1e3 * point[1]!, 1e3 * point[2]!];
