/** A stone at the board: the talk's axes and what it would do, beside the contact normal. */
import type { Raycaster } from "three";
import { ChoiceControl, NumberControl } from "../../controls";
import { C, vec, type Numbers, type Vec } from "../../core";
import { el } from "../../dom";
import { onTheme } from "../../look";
import { fixed, Shown } from "../../numbers";
import { ArrowShape } from "../../shapes/arrow";
import { dot, mm, plus, scaled, unit } from "../../vector";
import { caption, carry, within, type Bag, type Picture } from "./bag";

const names = ["primary", "left side", "right side", "bottom side", "top side", "bottom-left corner", "bottom-right corner",
  "top-left corner", "top-right corner", "out of reach"];
/** As they lie, seen from above. */
const grid = [C.TOP_LEFT, C.TOP, C.TOP_RIGHT, C.LEFT, C.PRIMARY, C.RIGHT, C.BOTTOM_LEFT, C.BOTTOM, C.BOTTOM_RIGHT];
const long = 9; // [mm] of an arrow

export function atBoard(bag: Bag): Picture {
  const { goishi, figure, shape, board, half } = bag;

  /** Where to put a stone to see a region: near its edge or corner, and not touching. */
  const outward = (region: number): readonly [number, number] => {
    const place = grid.indexOf(region);
    return [(place % 3) - 1, 1 - Math.floor(place / 3)];
  };
  const spot = (region: number): Vec => {
    const [x, y] = outward(region), n = unit([0.41 * x, 0.41 * y, x !== 0 && y !== 0 ? 0.97 : 1]);
    const m = goishi.measures(bag.stone()), [w, i, j, k] = bag.attitude();
    const u = unit([2 * (i * k + w * j), 2 * (j * k - w * i), w * w - i * i - j * j + k * k]), up = u[2] < 0 ? -1 : 1;
    const sphere = plus([x * half.x, y * half.y, 0], 1e3 * m[C.SPHERE_RADIUS]! + 1.1, n); // of the lower cap, so far from the edge
    return plus(sphere, -1e3 * up * m[C.SPHERE_OFFSET]!, u).map((value) => Number(value.toFixed(1))) as unknown as Vec;
  };

  const first = spot(C.RIGHT);
  const number = (key: string, label: string, least: number, greatest: number, value: number) =>
    new NumberControl(bag.panel, { key, label, unit: "mm", least, greatest, step: 0.1, value }, bag.changed);
  const place = [number("x", "place, left to right", -240, 240, first[0]), number("y", "place, bottom to top", -260, 260, first[1]),
    number("z", "height of its centre", -20, 40, first[2])] as const;
  const push = new ChoiceControl(bag.panel, { key: "push", label: "the talk pushes out along the axis of", value: "least",
    choices: [{ value: "least", label: "least penetration" }, { value: "most", label: "most" }] }, bag.changed);

  const map = el("fieldset", "regions", { "data-name": "regions" }, el("legend", "", {}, "the nine regions, from above"));
  const buttons = grid.map((region) => {
    const button = el("button", "region", { type: "button", "aria-pressed": "false" }, names[region]!);
    button.addEventListener("click", () => {
      const [x, y] = outward(region);
      if (x !== 0 || y !== 0) bag.heading.value = Math.round((Math.atan2(y, x) * 180) / Math.PI); // it leans away from the board
      spot(region).forEach((value, i) => (place[i]!.value = value));
      look(region);
      bag.changed();
    });
    map.append(button);
    return button;
  });
  const rows = el("tbody");
  const table = el("div", "axes", {}, el("p", "plot-title", {}, el("b", "", {}, "Along each axis of the region"), " ", el("span", "", {}, "how deep the two overlap; a negative depth separates them")),
    el("table", "", {}, el("thead", "", {}, el("tr", "", {}, el("th", "", { scope: "col" }, "axis"), el("th", "r", { scope: "col" }, "depth [mm]"), el("th", "", { scope: "col" }, "the test"))), rows));
  bag.wide.append(el("div", "plots two", {}, map, table));
  const below = map.parentElement!;

  const verdict = new Shown("verdict"), where = new Shown("region"), pushes = new Shown("pushed"), lie = new Shown("lie");
  const gap = new Shown("gap"), off = new Shown("off"), proved = new Shown("certified");
  const left = caption(bag, "left", verdict, [where, pushes, lie], "published"), right = caption(bag, "right", gap, [off, proved], "exact");

  const arrows = Array.from({ length: 7 }, () => new ArrowShape("published", { thick: 0.22, through: true }));
  const chosen = new ArrowShape("published", { thick: 0.5, through: true });
  figure.scene.add(...arrows, chosen);
  onTheme(() => [...arrows, chosen].forEach((one) => one.paint()));

  function look(region: number): void {
    const [x, y] = outward(region), [px, py] = spot(region);
    const flat = x === 0 && y === 0;
    figure.frame({ target: [px - 3 * x, py - 3 * y, 6.5], azimuth: flat ? -1.2 : Math.atan2(y, x) - 1.3, elevation: flat ? 0.2 : 0.22, distance: 76 });
  }

  let region: number = C.RIGHT;
  const pose = () => Float64Array.from([...place.map((one) => 1e-3 * one.value), ...bag.attitude()]);
  const moved = (from: Numbers, along: Vec, by: number) => {
    const to = from.slice();
    plus(vec(from, 0), by, along).forEach((value, i) => (to[i] = value));
    return to;
  };

  function update(): void {
    const here = pose(), stone = bag.stone();
    const found = goishi.separation(stone, here, board), talk = goishi.publishedSeparation(stone, here, board);
    const at = push.value === "least" ? C.LEAST_AXIS : C.MOST_AXIS;
    const colliding = talk[C.COLLIDING] === 1, distance = found[C.GAP]!, n = vec(found, C.NORMAL);
    const axis = vec(talk, at), depth = talk[at + C.AXIS_DEPTH]!;
    region = talk[C.REGION]!;
    const away = region === C.OUT_OF_REACH;
    shape.place(here);
    bag.shadow.follow(shape);
    bag.here.at(mm(vec(found, C.POINT)));
    bag.there.at(mm(vec(found, C.OTHER_POINT)));
    bag.between.through([...mm(vec(found, C.POINT)), ...mm(vec(found, C.OTHER_POINT))]);
    const origin = mm(vec(found, C.OTHER_POINT));
    bag.normal.point(origin, scaled(long + 5, n));
    arrows.forEach((arrow, i) => {
      const one = C.FIRST_AXIS + i * C.AXIS_SIZE;
      arrow.point(origin, i < talk[C.AXES]! ? scaled(long, vec(talk, one)) : [0, 0, 0]);
    });
    chosen.point(origin, colliding ? scaled(long + 3, axis) : [0, 0, 0]);
    bag.talks.visible = colliding;
    if (colliding) bag.talks.place(moved(here, axis, depth));
    bag.right.visible = distance < 0;
    if (distance < 0) bag.right.place(moved(here, n, -distance));

    verdict.set(talk[C.COLLIDING]!, colliding ? "the talk: collision" : "the talk: apart");
    where.set(region, away ? "out of reach of the board" : `region: ${names[region]!}, ${talk[C.AXES] === 1 ? "1 axis" : `${talk[C.AXES]!} axes`}`);
    pushes.set(colliding ? depth : NaN, colliding ? `pushed out by ${fixed(1e3 * depth, 3)} mm` : "");
    const wrong = colliding ? (distance > 0 ? distance : depth + distance) : NaN;
    lie.set(wrong, !colliding ? "" : distance > 0 ? `a gap of ${fixed(1e3 * wrong, 3)} mm is denied` : `${fixed(1e3 * wrong, 3)} mm more than it is deep`);
    gap.set(distance, distance < 0 ? `${fixed(-1e3 * distance, 3)} mm deep` : `gap ${fixed(1e3 * distance, 3)} mm`);
    const between = colliding ? (Math.acos(Math.min(1, dot(n, axis))) * 180) / Math.PI : NaN;
    off.set(between, colliding ? `normal ${fixed(between, 1)}° off the talk’s axis` : "along the contact normal");
    proved.set(found[C.CERTIFIED]!, found[C.CERTIFIED] === 1 ? "no direction separates more: proved" : "a lower bound");
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(grid[i] === region)));
    const listed = Array.from({ length: talk[C.AXES]! }, (_, i) => talk.subarray(C.FIRST_AXIS + i * C.AXIS_SIZE, C.FIRST_AXIS + (i + 1) * C.AXIS_SIZE));
    rows.replaceChildren(...listed.map((one) => {
      const d = one[C.AXIS_DEPTH]!, same = [0, 1, 2].every((k) => one[k] === axis[k]);
      return row(axisName(one), d, d < 0 ? "separates" : same && colliding ? "pushed out along it" : "overlap", same ? "picked" : "");
    }), row("contact normal", -distance, distance < 0 ? "the true depth" : "a true gap", "c-normal"));
    figure.label = `A Go stone near the board. ${verdict.element.textContent}; truly ${gap.element.textContent}.`;
    figure.invalidate();
  }

  return {
    says: `Where the stone is picks one of nine regions, and the region the talk’s <b class="c-published">axes</b>: up, out of a side,
      and at 45° over an edge. But a stone meets an edge along a <b class="c-normal">normal</b> of its own. So the test calls stones
      colliding that do not touch, and pushes others out the wrong way. Drag the stone, or choose a region.`,
    controls: [...place, push],
    elements: [...place.map((one) => one.element), push.element, below, left, right],
    onBoard: true,
    look() {
      const now = goishi.publishedSeparation(bag.stone(), pose(), board)[C.REGION]!;
      look(now === C.OUT_OF_REACH ? C.RIGHT : now);
      if (now === C.OUT_OF_REACH || now === C.PRIMARY) figure.frame({ target: [place[0].value, place[1].value, 6.5] });
    },
    update,
    grip(caster: Raycaster) {
      if (!shape.isMet(caster)) return null;
      return carry(bag, ([x, y, z]) => {
        [x, y, z].forEach((value, i) => (place[i]!.value = within(value, [-240, -260, -20][i]!, [240, 260, 40][i]!, 0.1)));
        update();
      }, bag.changed);
    },
  };
}

function row(name: string, depth: number, says: string, look: string): HTMLElement {
  return el("tr", look, {}, el("th", "", { scope: "row" }, name), el("td", "r", {}, fixed(1e3 * depth, 3)), el("td", "", {}, says));
}

/** An axis by its parts that are not 0. */
function axisName(axis: Numbers): string {
  const x = axis[0]!, y = axis[1]!, upwards = axis[2] !== 0;
  if (x !== 0 && y !== 0) return upwards ? "corner" : "upright edge, 45°";
  if (x === 0 && y === 0) return "up";
  const side = x !== 0 ? (x < 0 ? "left side" : "right side") : y < 0 ? "bottom side" : "top side";
  return upwards ? `edge of the ${side}, 45°` : side;
}
