/** 8 The board. */
import { Plane, Scene, Vector3, type Raycaster } from "three";
import { button, ChoiceControl, NumberControl, panel, Starts, SwitchControl, type Control } from "../controls";
import { C, type Vec } from "../core";
import { el } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme } from "../look";
import { fixed, Shown } from "../numbers";
import { Plot } from "../plot";
import { Refusal } from "../refusal";
import { linkButton, remember, type Section } from "../section";
import { ArrowsShape } from "../shapes/arrows";
import { BoardShape } from "../shapes/board";
import { modeTokens, pose, StonesShape } from "../shapes/stones";
import { Transport } from "../transport";
import { action, Deeds, last, rate, unit, type Action } from "./board/actions";
import { Course } from "./board/course";
import { Hand } from "./board/hand";
import { crossingsOf, kindsOf, starts, type Arrangement, type Start } from "./board/start";
import { floorOf } from "./drop/run";

const bump = 30;           // [m/s²] upwards, for a sixtieth of a second
const push = 1.5e-3;       // [N s]
const leastBudget = 8, mostBudget = 24; // [ms] of a frame for computing while it plays; between them a third of what a frame takes
const patience = 250;      // [ms] when one waits for it
const forceScale = 400;    // [mm/N] of an arrow: 20 mm for a stone's weight
const longest = 80;        // [mm] of an arrow
const graphEvery = 0.25;   // [s] between two graphs, while time goes on
const most = 361 + 2000;   // stones: those of the start, and one for each action

const modeWords = ["in flight", "alone on the board", "touch others", "at rest", "held by a hand"] as const;

export const board: Section = {
  id: "board",
  title: "The board",
  lead: `And now many. Each stone <b class="c-momentum">flies</b> and bounces by itself until it meets another; where stones
    <b class="c-published">touch others</b> and stay there, all forces between them are found at once; what <b class="c-exact">rests</b> is not computed any more. Click a stone
    to push it, drag it to throw it, click a free crossing to lay one down, or bump the board.`,

  start(place) {
    const { goishi, stage, section, wide, text } = place;
    const table = goishi.board(), kinds = kindsOf(goishi), crossings = crossingsOf(table);

    // --- what is drawn
    const still = new Scene(), wood = new BoardShape(table), occluder = wood.occluder();
    still.add(wood);
    const shapes = ([0, 1] as const).map((k) =>
      new StonesShape(kinds.measures[k], k === 1, most, wood.half, 1e3 * floorOf(table)));
    const arrows = new ArrowsShape("normal", 4000, 0.9);
    const starter = new Starts(wide, starts, (name) => take(name));
    const figure = stage.figure(wide, {
      label: "Go stones over a board.", still, view: { target: [0, 0, -45], azimuth: -1.35, elevation: 0.85, distance: 1200 }, grip, click,
    });
    figure.scene.add(occluder, ...shapes.flatMap(({ stones, shadows }) => [stones, shadows]), arrows);

    const count = new Shown("stones"), pace = new Shown("pace"), energyNow = new Shown("energy"), touches = new Shown("contacts");
    const modes = modeWords.map((_, i) => new Shown(`mode-${i}`));
    modes.forEach((shown, i) => (shown.element.style.cssText = `--of: var(--${modeTokens[i]})`));
    const lines = modes.map((shown) => el("div", "small spotted", {}, shown.element));
    figure.overlay.append(
      el("div", "caption left", { "aria-hidden": "true" }, el("div", "great", {}, count.element), ...lines),
      el("div", "caption right", { "aria-hidden": "true" }, el("div", "great", {}, pace.element), ...[energyNow, touches].map((shown) => el("div", "small", {}, shown.element))));

    // --- time, hands and graphs
    const transport = new Transport(wide, section, stage, { speeds: [1, 5], speed: 1, decimals: 3, step: () => 1 / rate, reach, show });
    const hands = el("div", "pills hands", { role: "group", "aria-label": "what a hand can do" });
    wide.append(hands);
    button(hands, "bump the board", () => act((at) => [action("b", at, bump * unit.strength)]));
    button(hands, "push one", () => pushOne());
    button(hands, "throw one in", () => act(thrown));
    button(hands, "lay one down", () => {
      const free = crossings.filter(isFree).sort((a, b) => Math.hypot(...a) - Math.hypot(...b))[0];
      if (free) lay(free);
      else refused.takes(() => refused.because("There is no free crossing."));
    });
    const plots = el("div", "plots");
    wide.append(plots);
    const scrub = (time: number) => transport.seek(time);
    const energy = new Plot(plots, { title: "Energy", unit: "mJ above all lying flat on the board", lines: [{ label: "all stones", token: "energy" }], scrub, below: false,
      height: 104, range: (least, greatest) => [Math.min(0, least), Math.max(1e-3, greatest * 1.05)] });
    const goings = new Plot(plots, { title: "How they go on", unit: "stones", across: " s", scrub, height: 130,
      lines: [0, 1, 2].map((i) => ({ label: modeWords[i]!, token: modeTokens[i]! })), range: (_, greatest) => [0, Math.max(1, greatest * 1.05)] });

    // --- controls
    const [left, right] = panel(wide, "The start", "Stones and wood") as [HTMLElement, HTMLElement];
    const changed = () => {
      deeds.reset();
      starter.mark();
      begin();
      remember(place, controls);
    };
    const number = (host: HTMLElement, key: string, label: string, unit_: string, least: number, greatest: number, step: number, value: number, whole = false) =>
      new NumberControl(host, { key, label, unit: unit_, least, greatest, step, value, whole }, changed);
    const c = {
      stones: number(left, "stones", "stones", "", 1, 361, 1, 180, true),
      height: number(left, "height", "from at most", "mm", 0, 200, 1, 60),
      seed: number(left, "seed", "another chance", "", 1, 9999, 1, 1, true),
      restitution: number(right, "e", "restitution", "", 0, 1, 0.01, 0.4),
      friction: number(right, "mu", "friction", "", 0, 1, 0.01, 0.3),
    };
    const choices = el("div", "choices");
    left.append(choices);
    const arrangement = new ChoiceControl<Arrangement>(choices, { key: "as", label: "how they begin", value: "fall",
      choices: [{ value: "fall", label: "over the crossings" }, { value: "heap", label: "as a heap" }, { value: "laid", label: "laid down" }] }, changed);
    const again = () => {
      show(transport.time, !transport.playing);
      remember(place, controls);
    };
    const forces = new SwitchControl(right, { key: "forces", label: "forces of contact", value: false, token: "normal" }, again);
    const byMode = new SwitchControl(right, { key: "modes", label: "colours say how each goes on", value: false }, again);
    const deeds = new Deeds();
    const controls: Control[] = [...Object.values(c), arrangement, forces, byMode, deeds];
    starter.controls = { ...c, arrangement };

    // --- words below
    const refused = new Refusal(wide);
    const impacts = new Shown("impacts"), steps = new Shown("steps"), looks = new Shown("separations"), print = new Shown("print"), took = el("span");
    text.append(
      el("p", "remark", {}, "Computed in ", took, ": ", impacts.element, ", ", steps.element, ", ", looks.element, ". Where all stones are, to the last bit, as one number: ",
        print.element, ". Whoever opens a link to this gets the same."));
    evidence(text, "Why it is right",
      `A stone by itself goes as in section 7: flights in closed form, impacts at moments that are solved for. Two stones meet at
       such a moment, too. Stones that stay together, or lean on each other, are a cluster: it goes by steps of 2 ms, shorter where
       they turn fast, and in each all forces of its contacts are found together, each in its cone of friction. That is of first
       order in the step, so whole scenes are less exact than one drop. Rest is a statement of statics: forces that hold every
       stone where it is.`, [
        ["SCENE-1", "A stone that touches no other falls, bounces and rolls as in section 7, to the last bit."],
        ["SCENE-2", "How time is cut does not matter, to the last bit: so a slow computer shows the same scene."],
        ["SCENE-4", "Two stones in flight meet where they touch first."],
        ["SCENE-5", "An impact of two stones keeps their momentum, and their angular momentum."],
        ["SCENE-6", "A row passes a hit on to its last stone."],
        ["SCENE-7", "A stone that lies on three others is carried by the forces that statics gives."],
        ["SCENE-8", "A heap comes to rest where every stone is held, and rests at no cost until something touches it."],
        ["SCENE-10", "The energy of a heap only falls, and nothing sinks into anything by more than micrometres."],
        ["SCENE-13", "Where stones touch several things, the error goes to nothing with the step."],
      ]);

    // --- what it is about
    let course: Course | null = null, hand: Hand | null = null, started = false, graphed = -1, lastCalled = -Infinity;
    const finishing = {};
    let clock: { time: number; real: number; share: number } | null = null;

    const values = (): Start => ({ arrangement: arrangement.value, stones: c.stones.value, seed: c.seed.value, height: c.height.value,
      restitution: c.restitution.value, friction: c.friction.value });

    function take(name: string): void {
      starter.take(name);
      changed();
    }

    /** From the controls, with what is done by a link. */
    function compute(): boolean {
      hand = null;
      return refused.takes(() => {
        const next = new Course(goishi, table, values(), deeds.list);
        course?.free();
        course = next;
        graphed = -1;
      });
    }

    function begin(): void {
      if (!compute()) return;
      transport.set(length());
      if (movesByItself() && started) transport.restart();
      else if (!movesByItself()) finish();
    }

    /** For who wants nothing to move: where it ends. */
    function finish(): void {
      stage.animate(finishing, () => {
        if (!course) return false;
        course.compute(last, patience);
        if (!course.over) return true;
        transport.set(length());
        transport.seek(course.head / rate);
        return false;
      });
    }

    /** How far the timeline goes: while something may come, a little further than what is known. */
    function length(): number {
      if (!course) return 1;
      return course.over ? Math.max(course.head, 1) / rate : Math.max(2, Math.ceil(course.head / rate + 0.5));
    }

    function reach(time: number): { time: number; over: boolean } {
      if (!course) return { time: 0, over: true };
      const to = Math.ceil(time * rate - 1e-6), before = course.head;
      if (hand) carry();
      const called = performance.now(), budget = Math.min(mostBudget, Math.max(leastBudget, (called - lastCalled) / 3));
      lastCalled = called;
      if (to > course.head && !course.over) course.compute(to, transport.playing ? budget : patience);
      const end = course.head / rate, now = Math.min(time, end);
      if (course.head !== before) transport.extend(length());
      return { time: now, over: course.over && now >= end };
    }

    // --- what is done to it

    function act(make: (at: number) => readonly Action[]): void {
      const now = Math.round(transport.time * rate - 1e-6);
      const done = refused.takes(() => {
        if (course) course.act(Math.min(now, course.head), make);
      });
      if (!course) return;
      deeds.list = course.actions;
      remember(place, controls);
      transport.extend(length());
      graphed = -1;
      if (!done) return show(transport.time, true);
      if (movesByItself() || hand) transport.play();
      else finish();
    }

    const placeOf = (id: number): Vec => {
      const { poses } = course!.moments[course!.momentAt(transport.time)]!;
      return [poses[pose.size * id]!, poses[pose.size * id + 1]!, poses[pose.size * id + 2]!];
    };

    /** A push across the board, away from who looks. */
    function pushAt(id: number, point: Vec, way: Vector3): void {
      const flat = way.setZ(0).normalize().multiplyScalar(push * unit.impulse);
      act((at) => [action("p", at, id, ...point.map((x) => x * unit.length), flat.x, flat.y, 0)]);
    }
    function pushOne(): void {
      if (!course) return;
      const ids = course.moments[course!.momentAt(transport.time)]!.poses.length / pose.size;
      const near = Array.from({ length: ids }, (_, id) => ({ id, at: placeOf(id) })).sort((a, b) => Math.hypot(...a.at) - Math.hypot(...b.at))[0];
      if (near) pushAt(near.id, near.at, figure.camera.getWorldDirection(new Vector3()));
    }

    /** From where one looks, over the edge, to the middle. */
    function thrown(at: number): Action[] {
      const way = figure.camera.getWorldDirection(new Vector3()).setZ(0).normalize(), nth = deeds.list.length;
      const aside = new Vector3(-way.y, way.x, 0).multiplyScalar(0.03 * ((nth % 5) - 2)), from = way.clone().multiplyScalar(-0.27).add(aside);
      return [action("t", at, nth % 2, from.x * unit.length, from.y * unit.length, 0.07 * unit.length, 1100 * way.x, 1100 * way.y, 100, 10, 30)];
    }

    function isFree([x, y]: readonly [number, number]): boolean {
      const { poses } = course!.moments[course!.momentAt(transport.time)]!, room = Math.max(...kinds.measures.map((one) => one[C.OUTER_WIDTH]!)) + 1e-4;
      for (let i = 0; i < poses.length; i += pose.size) {
        if (poses[i + 2]! > 0 && Math.hypot(poses[i]! - x, poses[i + 1]! - y) < room) return false;
      }
      return true;
    }
    function lay([x, y]: readonly [number, number]): void {
      act((at) => [action("l", at, deeds.list.length % 2, x * unit.length, y * unit.length)]);
    }

    function met(caster: Raycaster) {
      const found = shapes.map((one) => one.met(caster)).filter((one) => one !== null).sort((a, b) => a.distance - b.distance)[0];
      const wooden = caster.ray.intersectBox(woodBox, new Vector3());
      return found && !(wooden && caster.ray.origin.distanceTo(wooden) < found.distance - 30) ? found : null;
    }
    wood.geometry.computeBoundingBox();
    const woodBox = wood.geometry.boundingBox!;

    function click(caster: Raycaster): void {
      if (!course) return;
      const stone = met(caster);
      if (stone) return pushAt(stone.id, stone.point.multiplyScalar(1e-3).toArray() as unknown as Vec, caster.ray.direction.clone());
      const hit = caster.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), 0), new Vector3());
      if (!hit || Math.abs(hit.x) > wood.half.x || Math.abs(hit.y) > wood.half.y) return;
      const away = ([x, y]: readonly [number, number]) => Math.hypot(1e3 * x - hit.x, 1e3 * y - hit.y);
      const nearest = [...crossings].sort((a, b) => away(a) - away(b))[0]!;
      if (isFree(nearest)) lay(nearest);
      else refused.takes(() => refused.because("There is no room on this crossing."));
    }

    function grip(caster: Raycaster) {
      const stone = course && met(caster);
      if (!stone) return null;
      return {
        move(ray: Raycaster["ray"]) {
          if (!hand) {
            hand = new Hand(stone.id, placeOf(stone.id));
            hand.follow(ray);
            carry();
          }
          hand?.follow(ray);
        },
        end() {
          if (!hand) return;
          const letGo = hand.release();
          hand = null;
          act(letGo);
        },
      };
    }

    /** What the hand does next. */
    function carry(): void {
      const next = hand!.next(course!.head, placeOf(hand!.id));
      if (!next) return;
      if (transport.playing) { // it is called from within: only the deed itself
        refused.takes(() => void course!.act(course!.head, next));
        deeds.list = course!.actions;
        remember(place, controls);
      } else act(next);
    }

    // --- how it is shown

    /** How fast simulated time goes beside the clock, as it was over the last half second. */
    function measurePace(time: number, stopped: boolean): number {
      const real = performance.now();
      if (stopped || !clock || time < clock.time) clock = { time, real, share: NaN };
      else if (real - clock.real > 500) clock = { time, real, share: ((time - clock.time) * 1e3 * transport.speed) / (real - clock.real) };
      return clock.share;
    }

    function show(time: number, stopped: boolean): void {
      if (!course) return;
      const at = course.momentAt(time), moment = course.moments[at]!, poses = course.posesAt(time), all = poses.length / pose.size;
      for (const one of shapes) {
        one.byMode = byMode.value;
        one.place(poses, course.colors);
      }
      arrows.visible = forces.value;
      touches.element.hidden = !forces.value;
      if (forces.value) {
        const contacts = course.contacts(at), from: number[] = [], along: number[] = [];
        for (const one of contacts) {
          const force = [0, 1, 2].map((k) => one[C.SCENE_CONTACT_FORCE + k]!), size = forceScale * Math.hypot(...force);
          if (!(size > 0)) continue;
          const scale = forceScale * Math.min(1, longest / size);
          for (let k = 0; k < 3; ++k) {
            from.push(1e3 * one[C.SCENE_CONTACT_POINT + k]!);
            along.push(scale * force[k]!);
          }
        }
        arrows.show(from, along);
        touches.set(contacts.length, `${contacts.length} contacts`);
      }
      count.set(all, `${all} stone${all === 1 ? "" : "s"}`);
      modes.forEach((shown, i) => {
        const some = moment.modes[i]!;
        shown.set(some, some > 0 ? `${some} ${modeWords[i]}` : "");
        lines[i]!.hidden = some === 0;
      });
      energyNow.set(moment.energy, `energy ${fixed(1e3 * moment.energy, 3)} mJ`);
      const rests = course.over && at === course.head, share = measurePace(time, stopped);
      pace.set(NaN, rests ? (course.rests ? "at rest" : "followed no further") : stopped || !(share < 0.93) ? "" : `× ${fixed(share, 2)}: as fast as it can be computed`);
      const info = course.info();
      impacts.set(info[C.SCENE_PAIR_IMPACTS]!, plural(info[C.SCENE_PAIR_IMPACTS]!, "impact") + " of two stones");
      steps.set(info[C.SCENE_STONE_STEPS]!, plural(info[C.SCENE_STONE_STEPS]!, "step") + " of a stone in a cluster");
      looks.set(info[C.SCENE_SEPARATIONS]!, plural(info[C.SCENE_SEPARATIONS]!, "separation") + " of two stones");
      print.set(moment.print, moment.print.toString(36));
      if (stopped) took.textContent = `${plural(Math.round(course.took), "ms", "ms")} for ${fixed(course.head / rate, 2)} s`;
      const due = graphed < 0 || stopped || course.head > graphed + graphEvery * rate;
      if (due && graphed !== course.head) graph();
      for (const plot of [energy, goings]) plot.now(time);
      if (stopped) {
        figure.label = `${all} Go stones on a board, after ${fixed(time, 3)} s: ${moment.modes.map((some, i) => (some > 0 ? `${some} ${modeWords[i]}` : "")).filter(Boolean).join(", ")}.`;
      }
      figure.invalidate();
    }

    function graph(): void {
      const { moments, head } = course!, times = moments.map((_, i) => i / rate);
      energy.set(times, [moments.map((one) => 1e3 * one.energy)], 0, transport.end);
      goings.set(times, [0, 1, 2].map((i) => moments.map((one) => one.modes[i]!)), 0, transport.end);
      graphed = head;
    }

    linkButton(transport, place, controls);
    onTheme(() => {
      for (const painted of [wood, arrows, ...shapes]) painted.paint();
      figure.invalidate();
    });
    starter.mark();

    return {
      controls,
      update() {
        starter.mark();
        begin();
      },
      enter() {
        if (!started && movesByItself()) transport.play();
        started = true;
      },
      leave() {
        transport.pause();
      },
    };
  },
};

const plural = (count: number, word: string, words = `${word}s`) => `${String(count).replace(/(\d)(?=(\d{3})+$)/g, "$1\u202f")} ${count === 1 ? word : words}`;
