/** The turning stone, and how far it reaches along an axis: from plate to plate. */
import { Vector3, type Raycaster } from "three";
import { NumberControl } from "../../controls";
import { C, vec, type Numbers, type Vec } from "../../core";
import { el } from "../../dom";
import { onTheme } from "../../look";
import { fixed, Shown } from "../../numbers";
import { Plot } from "../../plot";
import { PlateShape } from "../../shapes/mark";
import { TrailShape } from "../../shapes/trail";
import type { Mark } from "../../transport";
import { mm, plus, scaled } from "../../vector";
import { caption, within, type Bag, type Picture } from "./bag";

const period = 8, samples = 480; // [s]
const spin: Vec = [2.6, 0.7, 1.1]; // [rad/s], in B

export function extent(bag: Bag): Picture {
  const { goishi, figure, transport, shape } = bag;
  const lean = new NumberControl(bag.panel, { key: "axis", label: "axis leans by", unit: "°", least: 0, greatest: 90, step: 1, value: 0 }, bag.changed);
  const reach = new Shown("reach"), whole = new Shown("extent"), part = new Shown("part");
  const left = caption(bag, "left", reach, [part], "exact"), right = caption(bag, "right", whole, []);
  const plots = el("div", "plots");
  bag.wide.append(plots);
  const graph = new Plot(plots, { title: "Reach from the centre", unit: "mm along the axis; a mark above: from cap to rim, or back", lines: [{ label: "reach", token: "exact" }],
    scrub: (time) => transport.seek(time), across: " s", range: (least, greatest) => [Math.floor(least), Math.ceil(greatest)] });

  const plates = [new PlateShape("exact", 13), new PlateShape("exact", 13)] as const;
  const rail = new TrailShape("soft", 1.2), bar = new TrailShape("exact", 6);
  for (const line of [rail, bar]) line.through([0, 0, -0.5, 0, 0, 0.5]);
  const stretch = (line: TrailShape, middle: Vec, length: number) => {
    line.position.set(...middle);
    line.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...axis));
    line.scale.z = length;
    line.visible = true;
  };
  figure.scene.add(...plates, rail, bar);
  onTheme(() => [...plates, rail, bar].forEach((one) => one.paint()));

  let start: Numbers = new Float64Array(), axis: Vec = [0, 0, 1];

  /** How far the stone reaches one way: the plane there, its point, its part. */
  const end = (pose: Numbers, way: 1 | -1) => {
    const plane = Float64Array.from([...axis.map((x) => -way * x), 0]); // of which the stone is on the other side
    const found = goishi.separation(bag.stone(), pose.slice(0, C.POSE_SIZE), plane);
    return { reach: -found[C.GAP]!, point: vec(found, C.POINT), rim: found[C.FEATURE] === C.RIM };
  };
  const at = (time: number) => goishi.freeFlight(bag.stone(), start, [0, 0, 0], C.ANGULAR, time);

  return {
    says: `Two plates close on a turning stone. Where they touch it are its <b class="c-exact">support points</b>, and between
      them is all that can be seen of it along that axis. Two bodies are apart when on some axis their stretches do not overlap. Drag the
      stone to turn it.`,
    controls: [lean],
    elements: [lean.element, left, right, plots],
    onBoard: false,
    speed: 1,
    look: () => figure.frame({ target: [4, 0, 0], azimuth: -1.3, elevation: 0.16, distance: 80 }),
    update() {
      const angle = (lean.value * Math.PI) / 180;
      axis = [Math.sin(angle), 0, Math.cos(angle)];
      start = goishi.state(bag.stone(), [0, 0, 0, ...bag.attitude()], [0, 0, 0], spin);
      const times = Array.from({ length: samples + 1 }, (_, i) => (period * i) / samples);
      const ends = times.map((time) => end(at(time), 1));
      graph.set(times, [ends.map((one) => 1e3 * one.reach)], 0, period);
      const marks: Mark[] = [];
      ends.forEach(({ rim }, i) => {
        if (i > 0 && rim !== ends[i - 1]!.rim) marks.push({ time: times[i]!, token: rim ? "slip" : "stick", label: rim ? "onto its rim" : "onto its cap" });
      });
      transport.set(period, marks);
    },
    show(time, stopped) {
      const motion = at(time);
      shape.place(motion);
      const upper = end(motion, 1), lower = end(motion, -1);
      const side: Vec = [axis[2], 0, -axis[0]], foot: Vec = [22 * side[0], 0, 22 * side[2]];
      const along = (s: number): Vec => plus(foot, s, axis);
      plates[0].at(mm(scaled(upper.reach, axis)), axis);
      plates[1].at(mm(scaled(-lower.reach, axis)), axis);
      stretch(rail, along(0), 28);
      stretch(bar, along(500 * (upper.reach - lower.reach)), 1e3 * (upper.reach + lower.reach));
      bag.here.at(mm(upper.point));
      bag.there.at(mm(lower.point));
      reach.set(upper.reach, `reaches ${fixed(1e3 * upper.reach, 3)} mm`);
      part.set(upper.rim ? 1 : 0, `from its centre; the ${upper.rim ? "rim" : "cap"} touches`);
      whole.set(upper.reach + lower.reach, `${fixed(1e3 * (upper.reach + lower.reach), 3)} mm between the plates`);
      graph.now(time);
      if (stopped) figure.label = `A Go stone between two plates: it reaches ${fixed(1e3 * upper.reach, 3)} mm from its centre along the axis; its ${upper.rim ? "rim" : "cap"} touches.`;
      figure.invalidate();
    },
    grip(caster: Raycaster) {
      if (!shape.isMet(caster)) return null;
      let from: { tilt: number; heading: number } | null = null;
      return {
        move(_, dx, dy) {
          if (!from) {
            const up = new Vector3(0, 0, 1).applyQuaternion(shape.quaternion);
            from = { tilt: (Math.acos(Math.max(-1, Math.min(1, up.z))) * 180) / Math.PI, heading: (Math.atan2(up.y, up.x) * 180) / Math.PI };
          }
          bag.tilt.value = within(from.tilt + dy * 0.4, 0, 180, 1);
          bag.heading.value = within(((from.heading + dx * 0.6 + 540) % 360) - 180, -180, 180, 1);
          start = goishi.state(bag.stone(), [0, 0, 0, ...bag.attitude()], [0, 0, 0], spin);
          transport.seek(0);
        },
        end: () => {
          if (from) bag.changed();
        },
      };
    },
  };
}
