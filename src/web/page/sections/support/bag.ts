/** What the four pictures of this section share: one stone, one figure, its marks and captions. */
import { Plane, Vector3, type Raycaster } from "three";
import type { Control } from "../../controls";
import type { Goishi, Numbers, Vec } from "../../core";
import { el } from "../../dom";
import type { Figure, Grip } from "../../figure";
import type { Token } from "../../look";
import type { Shown } from "../../numbers";
import type { Transport } from "../../transport";
import type { ArrowShape } from "../../shapes/arrow";
import type { DotShape } from "../../shapes/mark";
import type { ShadowShape } from "../../shapes/shadow";
import type { GhostShape, StoneShape } from "../../shapes/stone";
import type { TrailShape } from "../../shapes/trail";

/** One of the pictures. */
export interface Picture {
  /** What it shows, in trusted markup. */
  says: string;
  controls: Control[];
  /** Seen with it alone: controls, captions, graphs. */
  elements: HTMLElement[];
  /** Whether the board is. */
  onBoard: boolean;
  /** How many times slower it begins. */
  speed?: number;
  /** Makes the view its own. */
  look(): void;
  /** Computes and shows it. */
  update(): void;
  /** Shows a moment of it, if it has moments. */
  show?(time: number, stopped: boolean): void;
  grip(caster: Raycaster): Grip | null;
}

export interface Bag {
  goishi: Goishi;
  figure: Figure;
  transport: Transport;
  board: Numbers;
  /** Half of its surface   [mm]. */
  half: { readonly x: number; readonly y: number };
  gravity: Vec;
  /** Where its controls stand, and what is wide. */
  panel: HTMLElement;
  wide: HTMLElement;
  /** The stone of the controls, and its attitude. */
  stone(): Numbers;
  attitude(): readonly [number, number, number, number];
  tilt: { value: number };
  heading: { value: number };
  shape: StoneShape;
  other: StoneShape;
  shadow: ShadowShape;
  right: GhostShape;  // where the contact normal leads
  talks: GhostShape;  // where the talk's axis leads
  normal: ArrowShape;
  here: DotShape;     // the contact points
  there: DotShape;
  between: TrailShape;
  /** A control has changed. */
  changed(): void;
  /** The marks are not seen until they are placed. */
  clear(): void;
}

/** A caption over the picture: a great line and small ones. */
export function caption(bag: Bag, side: "left" | "right", great: Shown, small: readonly Shown[], token?: Token): HTMLElement {
  const element = el("div", `caption ${side}`, { "aria-hidden": "true" },
    el("div", "great", {}, ...(token ? [el("i", "spot", { style: `background: var(--${token})` })] : []), great.element),
    ...small.map((shown) => el("div", "small", {}, shown.element)));
  bag.figure.overlay.append(element);
  return element;
}

/** The axis of a stone leans by `tilt` towards `heading`, both in degrees. */
export function leaning(tilt: number, heading: number): readonly [number, number, number, number] {
  const t = (tilt * Math.PI) / 360, h = (heading * Math.PI) / 180;
  return [Math.cos(t), -Math.sin(h) * Math.sin(t), Math.cos(h) * Math.sin(t), 0];
}

/** A hand that carries the stone: in an upright plane across the view, or, seen from above, in a level one. */
export function carry(bag: Bag, moved: (to: Vec) => void, done: () => void): Grip {
  const plane = new Plane(), centre = bag.shape.position.clone();
  let offset: Vector3 | null = null;
  const across = bag.figure.view.elevation > 0.8 ? new Vector3(0, 0, 1)
    : bag.figure.camera.getWorldDirection(new Vector3()).setZ(0).normalize();
  plane.setFromNormalAndCoplanarPoint(across, centre);
  return {
    move(ray) {
      const hit = ray.intersectPlane(plane, new Vector3());
      if (!hit) return;
      offset ??= centre.clone().sub(hit);
      const to = hit.add(offset);
      moved([to.x, to.y, to.z]);
    },
    end() {
      if (offset) done();
    },
  };
}

/** A number from a control's range, to its step. */
export const within = (value: number, least: number, greatest: number, step: number): number =>
  Number(Math.min(greatest, Math.max(least, Math.round(value / step) * step)).toFixed(6));
