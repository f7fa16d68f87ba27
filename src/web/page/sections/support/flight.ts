/** When does it touch? The slider of time ends there. */
import type { Raycaster } from "three";
import { ChoiceControl, NumberControl } from "../../controls";
import { C, vec, type Numbers } from "../../core";
import { el } from "../../dom";
import { digits, fixed, Shown } from "../../numbers";
import { Plot } from "../../plot";
import { mm, scaled } from "../../vector";
import { caption, carry, within, type Bag, type Picture } from "./bag";

const horizon = 0.15; // [s], on until then if nothing touches
const samples = 300;
const aside = 42, apart = 76; // [mm]: where it starts, outside of the board; from one stone to the other

export function inFlight(bag: Bag): Picture {
  const { goishi, figure, transport, shape, other, board, gravity } = bag, edge = bag.half.x;
  const black = goishi.catalogueStone(33, C.BLACK, 1e-3);
  const number = (key: string, label: string, unit: string, least: number, greatest: number, step: number, value: number) =>
    new NumberControl(bag.panel, { key, label, unit, least, greatest, step, value }, bag.changed);
  const against = new ChoiceControl(bag.panel, { key: "against", label: "thrown at", value: "board",
    choices: [{ value: "board", label: "the board’s edge" }, { value: "stone", label: "another stone" }] }, bag.changed);
  const high = number("high", "height", "mm", 0, 60, 1, 22), speed = number("speed", "speed", "m/s", 0.2, 2, 0.01, 0.45);
  const across = number("across", "spin across it", "rad/s", -120, 120, 1, 40), about = number("about", "spin about its axis", "rad/s", -120, 120, 1, 20);
  const when = new Shown("touch"), how = new Shown("touch-part"), gap = new Shown("flight-gap"), cost = new Shown("normals");
  const left = caption(bag, "left", when, [how, cost], "exact"), right = caption(bag, "right", gap, []);
  const plots = el("div", "plots");
  bag.wide.append(plots);
  const graph = new Plot(plots, { title: "Gap", unit: "mm, up to the touch", lines: [{ label: "gap", token: "exact" }],
    scrub: (time) => transport.seek(time), across: " s", range: (_, greatest) => [0, Math.max(1, greatest * 1.05)] });

  let start: Numbers = new Float64Array(), second: Numbers | null = null, hit: Numbers = new Float64Array(), end = horizon;

  const motions = (time: number) => ({
    mine: goishi.freeFlight(bag.stone(), start, gravity, C.BOTH, time),
    its: second ? goishi.freeFlight(black, second, gravity, C.BOTH, time) : null,
  });
  const between = ({ mine, its }: ReturnType<typeof motions>): Numbers => its
    ? goishi.separationStones(bag.stone(), mine.slice(0, C.POSE_SIZE), black, its.slice(0, C.POSE_SIZE))
    : goishi.separation(bag.stone(), mine.slice(0, C.POSE_SIZE), board);

  function begin(): void {
    const stones = against.value === "stone", x = stones ? apart / 2 : edge + aside, lift = stones ? 70 : 0;
    start = goishi.state(bag.stone(), [1e-3 * x, 0, 1e-3 * (high.value + lift), ...bag.attitude()], [-speed.value, 0, 0.25], [across.value, 0, about.value]);
    second = stones ? goishi.state(black, [-1e-3 * x, 0, 0.09, 0.9, 0.3, 0.1, 0], [speed.value, 0, 0.25], [-30, 10, 20]) : null;
  }

  const where: Record<number, string> = { [C.ON_SURFACE]: "the board’s surface", [C.ON_SIDE]: "the board’s side", [C.ON_TOP_EDGE]: "the board’s edge",
    [C.ON_CORNER]: "the board’s corner", [C.ON_STONE]: "the other stone", [C.ON_VERTICAL_EDGE]: "the board’s upright edge" };

  return {
    says: `Both bodies fly, turn and fall, and the moment of the first touch is solved for. Nothing is stepped over, however
      fast it goes: the slider ends where the gap is zero. Lift the stone, or throw it faster, and see what it meets.`,
    controls: [against, high, speed, across, about],
    elements: [against.element, ...[high, speed, across, about].map((one) => one.element), left, right, plots],
    onBoard: true,
    speed: 25,
    look: () => figure.frame(against.value === "board"
      ? { target: [edge + 14, 0, 6], azimuth: -1.35, elevation: 0.16, distance: 125 }
      : { target: [0, 0, 64], azimuth: -1.35, elevation: 0.14, distance: 160 }),
    update() {
      begin();
      hit = second ? goishi.timeOfImpactStones(bag.stone(), start, black, second, gravity, horizon)
        : goishi.timeOfImpact(bag.stone(), start, gravity, board, horizon);
      const touches = hit[C.HIT_STATUS] === C.HIT;
      end = touches ? hit[C.HIT_TIME]! : hit[C.HIT_STATUS] === C.HIT_OVERLAPPING ? 0 : horizon;
      const times = Array.from({ length: samples + 1 }, (_, i) => (end * i) / samples);
      graph.set(times, [times.map((time) => 1e3 * between(motions(time))[C.GAP]!)], 0, end);
      when.set(end, touches ? `it touches after ${fixed(1e3 * end, 4)} ms` : end === 0 ? "touches from the start" : `no touch in ${fixed(1e3 * horizon, 0)} ms`);
      const part = hit[C.HIT_CONTACT + C.FEATURE] === C.RIM ? "rim" : "cap";
      how.set(touches ? hit[C.HIT_CONTACT + C.OTHER_FEATURE]! : NaN, touches ? `its ${part} on ${where[hit[C.HIT_CONTACT + C.OTHER_FEATURE]!] ?? "the board"}` : "");
      cost.set(hit[C.HIT_STEPS]!, `found in ${hit[C.HIT_STEPS]!} steps`);
      transport.set(end, touches ? [{ time: end, token: "exact", label: "the touch", high: true }] : []);
    },
    show(time, stopped) {
      const now = motions(time), found = between(now), distance = found[C.GAP]!;
      shape.place(now.mine);
      bag.shadow.follow(shape);
      if (now.its) other.place(now.its);
      other.visible = now.its !== null;
      const last = stopped && time === end && hit[C.HIT_STATUS] === C.HIT;
      if (last) {
        const n = vec(found, C.NORMAL), point = mm(vec(found, C.OTHER_POINT));
        bag.here.at(mm(vec(found, C.POINT)));
        bag.normal.point(point, scaled(12, n));
      }
      bag.here.visible = bag.normal.visible = last;
      gap.set(distance, Math.abs(distance) < 1e-7 ? `gap ${digits(1e3 * distance, 2)} mm` : `gap ${fixed(1e3 * distance, 3)} mm`);
      graph.now(time);
      if (stopped) figure.label = `A Go stone in flight, after ${fixed(1e3 * time, 3)} ms: ${gap.element.textContent}; ${when.element.textContent}.`;
      figure.invalidate();
    },
    grip(caster: Raycaster) {
      if (!shape.isMet(caster)) return null;
      let from: { z: number; value: number } | null = null;
      const hand = carry(bag, ([, , z]) => {
        from ??= { z, value: high.value };
        high.value = within(from.value + z - from.z, 0, 60, 1);
        begin();
        transport.seek(0);
      }, bag.changed);
      return hand;
    },
  };
}
