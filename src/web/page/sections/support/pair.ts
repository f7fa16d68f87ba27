/** Two stones: the same rule, one number and one normal. */
import type { Raycaster } from "three";
import { NumberControl } from "../../controls";
import { C, vec, type Vec } from "../../core";
import { fixed, Shown } from "../../numbers";
import { mm, plus, scaled } from "../../vector";
import { caption, carry, within, type Bag, type Picture } from "./bag";

const reach = 30; // [mm]

export function pair(bag: Bag): Picture {
  const { goishi, figure, shape, other } = bag;
  const black = goishi.catalogueStone(33, C.BLACK, 1e-3);
  const centre = goishi.measures(black)[C.MEASURE_HEIGHT]! / 2;
  const below = Float64Array.from([0, 0, centre, 1, 0, 0, 0]);
  const number = (key: string, label: string, value: number) =>
    new NumberControl(bag.panel, { key, label, unit: "mm", least: -reach, greatest: reach, step: 0.1, value }, bag.changed);
  const place = [number("dx", "to the right", 14), number("dy", "to the back", 0), number("dz", "above", 8.5)] as const;
  const gap = new Shown("pair-gap"), parts = new Shown("pair-parts"), off = new Shown("pair-normal"), proved = new Shown("pair-certified");
  const left = caption(bag, "left", gap, [parts], "exact"), right = caption(bag, "right", off, [proved], "normal");
  const part = (feature: number) => (feature === C.RIM ? "rim" : "cap");

  function update(): void {
    const here = Float64Array.from([1e-3 * place[0].value, 1e-3 * place[1].value, centre + 1e-3 * place[2].value, ...bag.attitude()]);
    const found = goishi.separationStones(bag.stone(), here, black, below);
    const distance = found[C.GAP]!, n = vec(found, C.NORMAL), mine = vec(found, C.POINT), its = vec(found, C.OTHER_POINT);
    shape.place(here);
    other.place(below);
    bag.shadow.follow(shape);
    bag.here.at(mm(mine));
    bag.there.at(mm(its));
    bag.between.through([...mm(mine), ...mm(its)]);
    bag.normal.point(mm(its), scaled(12, n));
    bag.right.visible = distance < 0;
    if (distance < 0) {
      const out = here.slice();
      plus(vec(here, 0), -distance, n).forEach((value, i) => (out[i] = value));
      bag.right.place(out);
    }
    gap.set(distance, distance < 0 ? `${fixed(-1e3 * distance, 3)} mm deep` : `gap ${fixed(1e3 * distance, 3)} mm`);
    parts.set(found[C.FEATURE]!, `nearest is the ${part(found[C.FEATURE]!)} of the white stone`);
    const lean = (Math.acos(Math.max(-1, Math.min(1, n[2]))) * 180) / Math.PI;
    off.set(n[2], `normal ${fixed(lean, 1)}° off the vertical`);
    proved.set(found[C.CERTIFIED]!, found[C.CERTIFIED] === 1 ? "no direction separates more: proved" : "not proved: a lower bound");
    figure.label = `Two Go stones: ${gap.element.textContent}, ${off.element.textContent}.`;
    figure.invalidate();
  }

  return {
    says: `The same rule for every pair: of all directions the one that separates most. Its value is the gap, or, below zero, the depth;
      the direction is the <b class="c-normal">normal</b>; <b class="c-exact">the points</b> are where they are nearest. Drag the white
      stone through the black one: a ghost shows the shortest way out.`,
    controls: [...place],
    elements: [...place.map((one) => one.element), left, right],
    onBoard: true,
    look: () => figure.frame({ target: [5, 0, 8], azimuth: -1.25, elevation: 0.28, distance: 105 }),
    update,
    grip(caster: Raycaster) {
      if (!shape.isMet(caster)) return null;
      return carry(bag, (to: Vec) => {
        [to[0], to[1], to[2] - 1e3 * centre].forEach((value, i) => (place[i]!.value = within(value, -reach, reach, 0.1)));
        update();
      }, bag.changed);
    },
  };
}
