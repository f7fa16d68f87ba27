/** Vectors of three numbers. */
import type { Numbers, Vec } from "./core";

/** a + s b. */
export const plus = (a: Vec, s: number, b: Vec): Vec => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const scaled = (s: number, a: Vec): Vec => [s * a[0], s * a[1], s * a[2]];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a: Vec): Vec => scaled(1 / Math.hypot(...a), a);

/** [mm] of [m]. */
export const mm = (point: Vec | Numbers): Vec => [1e3 * point[0]!, 1e3 * point[1]!, 1e3 * point[2]!];
