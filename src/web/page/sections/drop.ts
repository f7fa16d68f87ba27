/** 7 The drop. */
import { Plane, Scene, Vector3, type Raycaster } from "three";
import { ChoiceControl, fold, NumberControl, panel, Starts, SwitchControl, type Control } from "../controls";
import { C, vec, type Numbers } from "../core";
import { el } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme } from "../look";
import { fixed, Shown } from "../numbers";
import { Plot } from "../plot";
import { Refusal } from "../refusal";
import { linkButton, remember, type Section } from "../section";
import { ArrowShape } from "../shapes/arrow";
import { BoardShape } from "../shapes/board";
import { ShadowShape } from "../shapes/shadow";
import { GhostShape, StoneShape } from "../shapes/stone";
import { TrailShape } from "../shapes/trail";
import { Transport } from "../transport";
import { eventTable } from "./drop/events";
import { frame, publishedLoop, type Loop } from "./drop/loop";
import { floorOf, Run, speedAt, startState, stoneOf, tiltOf, touching, type Start } from "./drop/run";
import { ending, impulseOf, say, type Said } from "./drop/words";

/** Starts that show something; what is not said is as at first. */
const starts: Record<string, { label: string; says: string; speed?: number; jellett?: boolean; start: Partial<Start> }> = {
  dropped: { label: "dropped", start: {},
    says: "Let go from 30 mm, leaning and turning a little: it bounces, turns over, and wobbles to rest on its other side." },
  rocking: { label: "rocking", speed: 5, start: { height: 0, tilt: 12, spin: 0, rolling: 0.02 },
    says: "Laid down leaning and let go: it rocks, each swing a little lower, until rolling resistance holds it." },
  edge: { label: "rolled on its edge", start: { height: 0, tilt: 80, spin: 34, speed: 0.32, place: -100 },
    says: "Rolled like a coin: it circles, sinks, and rattles ever faster round its rim." },
  rises: { label: "spun: it rises", speed: 5, jellett: true,
    start: { height: 0, tilt: 0.5, spin: 60, bevel: 0, law: "slip", rolling: 0, pivot: 0, horizon: 4 },
    says: "Under friction in proportion to slip a flat spin of 60 rad/s is unstable: the stone rises, and settles near 36°, as Jellett’s integral says." },
  dry: { label: "the same, dry friction", speed: 5, jellett: true,
    start: { height: 0, tilt: 0.5, spin: 60, bevel: 0, law: "dry", rolling: 0, pivot: 0, horizon: 4 },
    says: "The same spin under dry friction: what little slip there is soon turns into rolling, which takes no energy, so nothing drives the stone up." },
  over: { label: "over the edge", start: { place: 200, height: 12, tilt: 20, speed: 0.5, spin: 0 },
    says: "Thrown near the edge of the board: it goes over, falls past the side, and comes to rest on the floor." },
};

export const drop: Section = {
  id: "drop",
  title: "The drop",
  lead: `A stone falls on the board, bounces, slides, rolls and wobbles until it rests. Each mark below is something that
    happened: an <b class="c-impact">impact</b>, the end of <b class="c-slip">slip</b>, the beginning of
    <b class="c-stick">rolling</b>, at a moment that is solved for and not the end of a frame. Drag through time in either
    direction, or take the stone, lift it, tilt it, and let go.`,

  start(place) {
    const { goishi, stage, section, wide, text } = place;
    const board = goishi.board();

    // --- what is drawn
    const still = new Scene(), wood = new BoardShape(board), occluder = wood.occluder();
    still.add(wood);
    let stone = stoneOf(goishi, { shell: "white", bevel: 1 });
    const shape = new StoneShape(goishi, stone), shadow = new ShadowShape(0, wood.half), below = new ShadowShape(1e3 * floorOf(board)), track = new TrailShape("#0b5c53");
    const ghost = new GhostShape(goishi, stone, "published"), arrow = new ArrowShape("impulse", { through: true, thick: 0.55 });
    const starter = new Starts(wide, starts, (name) => take(name));
    const figure = stage.figure(wide, {
      label: "A Go stone over a board.", still, view: { target: [0, 0, 4], azimuth: -1.05, elevation: 0.42, distance: 190 },
      elevations: [0.06, 1.5], grip,
    });
    figure.scene.add(occluder, below, shadow, track, shape, ghost, arrow);
    arrow.visible = ghost.visible = false;

    const what = new Shown("event"), when = el("div", "small"), spot = el("i", "spot");
    const tilt = new Shown("tilt"), where = new Shown("height"), slip = new Shown("slip"), wobble = new Shown("wobble"), apart = new Shown("apart");
    apart.element.hidden = true;
    figure.overlay.append(
      el("div", "caption left", { "aria-hidden": "true" }, el("div", "great", {}, spot, what.element), when),
      el("div", "caption right", { "aria-hidden": "true" }, el("div", "great", {}, tilt.element),
        ...[where, slip, wobble, apart].map((shown) => el("div", "small", {}, shown.element))));

    // --- time and graphs
    const transport = new Transport(wide, section, stage, { speeds: [1, 5, 25], speed: 5, decimals: 4, show });
    const plots = el("div", "plots");
    wide.append(plots);
    const scrub = (time: number) => transport.seek(time);
    const energyLines = [{ label: "the stone", token: "energy" as const }];
    const tiltLines = [{ label: "the stone", token: "omega" as const }];
    const talk = { label: "the talk’s loop", token: "published" as const, width: 1.3, dash: [5, 3] };
    const energy = new Plot(plots, { title: "Energy", unit: "µJ above lying flat on the board", lines: energyLines, scrub, below: false, height: 104,
      range: (least, greatest) => [Math.min(0, least), Math.max(1, greatest * 1.05)] });
    const lean = new Plot(plots, { title: "Tilt of the axis", unit: "degrees", lines: tiltLines, scrub, across: " s",
      range: (least, greatest) => (greatest > 90 ? [0, 185] : [Math.min(0, least), Math.max(1, greatest * 1.08)]), tick: (value) => `${value}°` });
    const jellett = new Plot(plots, { title: "Jellett’s integral", unit: "L · r, % of its first value, while it touches with a cap",
      lines: [{ label: "L · r", token: "momentum" }], scrub, across: " s", height: 104,
      range: (least, greatest) => [Math.min(0, least), Math.max(110, greatest * 1.05)] });

    // --- controls
    const [left, right] = panel(wide, "The start", "Stone and wood") as [HTMLElement, HTMLElement];
    const changed = () => {
      starter.mark();
      again();
    };
    const number = (host: HTMLElement, key: string, label: string, unit: string, least: number, greatest: number, step: number, value: number) =>
      new NumberControl(host, { key, label, unit, least, greatest, step, value }, changed);
    const c = {
      height: number(left, "height", "height", "mm", 0, 150, 1, 30),
      tilt: number(left, "tilt", "tilt", "°", 0, 180, 1, 25),
      spin: number(left, "spin", "spin about its axis", "rad/s", -120, 120, 1, 12),
      tumble: number(left, "tumble", "spin across it", "rad/s", -120, 120, 1, 0),
      speed: number(left, "speed", "speed along", "m/s", -1, 1, 0.01, 0),
      place: number(left, "place", "from the middle", "mm", -230, 230, 1, 0),
      restitution: number(right, "e", "restitution", "", 0, 1, 0.01, 0.5),
      friction: number(right, "mu", "friction", "", 0, 1, 0.01, 0.3),
      rolling: number(right, "rolling", "rolling resistance", "mm", 0, 1, 0.01, 0.1),
      pivot: number(right, "pivot", "pivot friction", "mm", 0, 1, 0.01, 0.05),
      bevel: number(right, "bevel", "bevel", "mm", 0, 4, 0.1, 1),
      horizon: number(right, "until", "followed for", "s", 1, 30, 0.5, 10),
    };
    const choices = el("div", "choices");
    right.append(choices);
    const law = new ChoiceControl(choices, { key: "law", label: "friction while it lasts", value: "dry",
      choices: [{ value: "dry", label: "dry" }, { value: "slip", label: "in proportion to slip" }] }, changed);
    const shell = new ChoiceControl(choices, { key: "stone", label: "stone, size 33", value: "white",
      choices: [{ value: "white", label: "shell" }, { value: "black", label: "slate" }] }, changed);
    const compare = new SwitchControl(left, { key: "loop", label: "beside it a game loop, the talk’s, 60 steps a second", value: false, token: "published" },
      () => { arrange(); remember(place, controls); });
    const integral = new SwitchControl(left, { key: "jellett", label: "Jellett’s integral", value: false, token: "momentum" },
      () => { arrange(); remember(place, controls); });
    const controls: Control[] = [...Object.values(c), law, shell, compare, integral];
    starter.controls = { ...c, law };

    // --- words below
    const about = el("p", "remark");
    const impacts = new Shown("impacts"), events = new Shown("events"), ended = new Shown("end"), evaluations = new Shown("evaluations");
    const took = el("span"), how = el("span");
    about.append("Computed in ", took, ": ", impacts.element, ", ", events.element, ", ", evaluations.element, "; ", how, " ", ended.element, ".");
    const refused = new Refusal(wide);
    text.append(about);
    let table: { fill(): void } | null = null;
    fold(text, "Every event", (body) => {
      table = eventTable(body, () => run, (time) => transport.seek(time));
    });
    evidence(text, "Why it is right",
      `In the air a stone needs no time step: its motion has a closed form, and the next impact is the first root of a function
       that cannot be stepped over. In contact the equations are integrated with error control, and each change, slip, rolling,
       the passage from cap to rim, lifting off, is located as a root. Rest is statics: forces within the cone of friction, torques
       within the resistance. Restitution, friction and resistance are assumed values; the laws are those of rigid bodies.`, [
        ["DROP-18", "Each flight, each impact and the stretches of contact of drops from 5 cm are right."],
        ["DROP-19", "Bounces magnify errors, so where it comes to rest is less certain than each link."],
        ["DROP-21", "The energy only falls."],
        ["DROP-3", "Rocking has its exact period."],
        ["DROP-4", "Jellett’s integral is constant while a stone slides on its cap."],
        ["DROP-8", "A flat spin under friction in proportion to slip settles at the tilt that Jellett’s integral says: 60 rad/s at 35.970°."],
        ["DROP-9", "Without friction a spun stone does not rise."],
        ["DROP-28", "Over the edge of the board: a scheme of lower order."],
      ]);

    // --- what it is about
    let run: Run | null = null, loop: Loop | null = null, said: Said[] = [], greatest = 1, started = false;

    const values = (): Start => ({
      shell: shell.value, bevel: c.bevel.value, height: c.height.value, tilt: c.tilt.value, spin: c.spin.value, tumble: c.tumble.value,
      speed: c.speed.value, place: c.place.value, restitution: c.restitution.value, friction: c.friction.value, law: law.value,
      rolling: c.rolling.value, pivot: c.pivot.value, horizon: c.horizon.value,
    });

    function take(name: string): void {
      const { speed, jellett: showing } = starts[name]!;
      starter.take(name);
      integral.value = showing ?? false;
      transport.speed = speed ?? 5;
      starter.mark();
      again();
    }

    /** Computes; what the library refuses keeps the last good picture. */
    function compute(): boolean {
      const taken = refused.takes(() => {
        const next = new Run(goishi, board, values());
        run?.free();
        run = next;
      });
      if (!taken || !run) return false;
      if (run.stone.some((value, i) => value !== stone[i])) {
        stone = run.stone;
        shape.reshape(goishi, stone);
        ghost.reshape(goishi, stone);
      }
      shape.paint(shell.value);
      for (const one of [shadow, below]) one.of(run.measures);
      loop = null;
      const count = run.events.filter((event) => event[C.EVENT_KIND] === C.KIND_IMPACT).length;
      let nth = 0;
      said = run.events.map((event) => say(event, event[C.EVENT_KIND] === C.KIND_IMPACT ? ++nth : nth, count));
      greatest = Math.max(1e-12, ...run.events.map(impulseOf));
      impacts.set(count, plural(count, "impact"));
      events.set(run.events.length, plural(run.events.length, "event"));
      const asked = run.info[C.DROP_CONTACT_EVALUATIONS]!;
      evaluations.set(asked, plural(asked, "evaluation") + " of the contact");
      ended.set(run.end, `${fixed(run.end, 4)} s`);
      how.textContent = ending(run.info[C.DROP_STATUS]!);
      took.textContent = `${fixed(run.took, 1)} ms`;
      track.through(run.series.track);
      table?.fill();
      return true;
    }

    /** Graphs, marks and what stands beside, without a change of time. */
    function arrange(): void {
      if (!run) return;
      const { series } = run;
      loop = compare.value ? loop ?? publishedLoop(goishi, run) : null;
      ghost.visible = loop !== null;
      apart.element.hidden = loop === null;
      energy.lines = loop ? [...energyLines, talk] : energyLines;
      lean.lines = loop ? [...tiltLines, talk] : tiltLines;
      const also = (of: (motion: Numbers) => number): number[][] =>
        loop ? [series.time.map((time) => { const motion = at(loop!, time); return motion ? of(motion) : NaN; })] : [];
      energy.set(series.time, [series.energy.map((value) => 1e6 * value), ...also((motion) => 1e6 * (motion[C.ENERGY]! - run!.lying))], 0, run.end);
      lean.set(series.time, [series.tilt, ...also(tiltOf)], 0, run.end);
      const first = series.jellett.find((value) => Number.isFinite(value) && value !== 0) ?? NaN;
      jellett.set(series.time, [series.jellett.map((value) => (100 * value) / first)], 0, run.end);
      jellett.element.hidden = !integral.value;
      show(transport.time, true);
    }

    function again(): void {
      if (!compute()) return;
      present();
      remember(place, controls);
      if (movesByItself()) transport.restart();
      else transport.seek(run!.end);
    }

    function present(): void {
      look();
      transport.set(run!.end, run!.events.map((event, i) => ({
        time: event[C.EVENT_TIME]!, token: said[i]!.token, high: said[i]!.high, label: said[i]!.great })));
      arrange();
    }

    /** Frames the whole track. */
    function look(): void {
      const { end, from } = run!, far = 900; // [mm]
      const track = Array.from({ length: 41 }, (_, i) => vec(run!.at(from + ((end - from) * i) / 40), C.POSITION)
        .map((value) => Math.min(far, Math.max(-far, 1e3 * value))) as [number, number, number]);
      const [low, high] = [Math.min, Math.max].map((of) => [0, 1, 2].map((k) => of(...track.map((p) => p[k]!)))) as [number[], number[]];
      const middle = (k: number) => (low[k]! + high[k]!) / 2, falls = low[2]! < 0;
      figure.frame({ target: [middle(0), middle(1), falls ? middle(2) : Math.max(3, 0.32 * high[2]!)], elevation: 0.36, distance: 115,
        azimuth: falls ? Math.atan2(middle(1), middle(0)) - 0.5 : -1.05 }, track);
    }

    function at(of: Loop, time: number): Numbers | null {
      return of.motions[Math.floor(time / frame + 1e-9)] ?? of.motions.at(-1) ?? null;
    }

    /** The moment: at an event, its impulse, too. */
    function show(time: number, stopped: boolean): void {
      if (!run) return;
      const motion = run.at(time);
      shape.place(motion);
      occluder.visible = shape.position.z < 0;
      for (const one of [shadow, below]) one.follow(shape);
      below.visible = occluder.visible;
      const latest = lastBefore(run.events, time), event = run.events[latest], words = said[latest];
      if (event && words) {
        what.set(event[C.EVENT_TIME]!, words.great);
        if (when.textContent !== words.small) when.textContent = words.small;
        spot.style.background = `var(--${words.token})`;
        const since = time - event[C.EVENT_TIME]!, impulse = vec(event, C.EVENT_IMPULSE);
        const seen = impulseOf(event) > 0 && since <= (stopped ? 1e-9 : 0.22 / transport.speed);
        const scale = seen ? (5 + 24 * (impulseOf(event) / greatest)) / impulseOf(event) : 0;
        arrow.point(vec(event, C.EVENT_POINT).map((value) => 1e3 * value) as [number, number, number],
          impulse.map((value) => scale * value) as [number, number, number]);
      }
      track.show(lastBefore(run.series.ended, time, (ends) => ends) + 1);
      const over = run.over(motion), angle = tiltOf(motion);
      tilt.set(angle, `tilt ${fixed(angle, 1)}°`);
      where.set(motion[C.POSITION + 2]!, `centre ${fixed(1e3 * motion[C.POSITION + 2]!, 2)} mm high`);
      const touches = over.gap < touching;
      const speed = speedAt(motion, over.point);
      slip.set(touches ? speed : NaN, touches ? `contact slips at ${fixed(1e3 * speed, 1)} mm/s` : "in the air");
      const often = touches ? run.wobble(time) : NaN;
      wobble.set(often, Number.isFinite(often) ? `wobbles ${fixed(often, 2)} times a second` : "");
      if (loop) {
        const other = at(loop, time);
        if (other) {
          ghost.place(other);
          const off = Math.hypot(...[0, 1, 2].map((k) => motion[k]! - other[k]!));
          apart.set(off, `${fixed(1e3 * off, 1)} mm from the loop’s`);
        }
      }
      for (const plot of [energy, lean, jellett]) plot.now(time);
      if (stopped && words) {
        figure.label = `A Go stone on a board, after ${fixed(time, 4)} s: ${words.great}; tilt ${fixed(angle, 1)} degrees, centre ${fixed(1e3 * motion[2]!, 2)} mm high.`;
      }
      figure.invalidate();
    }

    /** The stone is the control: up lifts, sideways tilts, letting go drops. */
    function grip(caster: Raycaster) {
      if (!shape.isMet(caster)) return null;
      let from: { z: number; height: number; tilt: number } | null = null;
      const upright = new Plane();
      return {
        move(ray: Raycaster["ray"], dx: number) {
          if (!from) {
            transport.pause(false);
            upright.setFromNormalAndCoplanarPoint(figure.camera.getWorldDirection(new Vector3()).setZ(0).normalize(), shape.position);
            from = { z: NaN, height: transport.time === 0 ? c.height.value : Math.max(0, 1e3 * run!.over(run!.at(transport.time)).gap), tilt: c.tilt.value };
          }
          const hit = ray.intersectPlane(upright, new Vector3());
          if (!hit) return;
          if (Number.isNaN(from.z)) from.z = hit.z;
          c.height.approach(from.height + hit.z - from.z);
          c.tilt.approach(from.tilt + dx * 0.35);
          const state = startState(goishi, stone, values());
          shape.place(state);
          shadow.follow(shape);
          arrow.visible = false;
          figure.invalidate();
        },
        end() {
          if (from) changed();
        },
      };
    }

    linkButton(transport, place, controls);
    onTheme(() => {
      for (const painted of [wood, shape, ghost, arrow, track]) painted.paint();
      figure.invalidate();
    });
    starter.mark();

    return {
      controls,
      update() {
        if (!compute()) return;
        starter.mark();
        present();
        if (!movesByItself()) transport.seek(run!.end);
        else if (started) transport.restart();
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

const plural = (count: number, word: string) => `${String(count).replace(/(\d)(?=(\d{3})+$)/g, "$1\u202f")} ${word}${count === 1 ? "" : "s"}`;

/** The place of the last that is not after the time; −1 if there is none. */
function lastBefore<T>(list: readonly T[], time: number, of: (one: T) => number = (one) => (one as Numbers)[C.EVENT_TIME]!): number {
  let low = -1, high = list.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (of(list[middle]!) <= time + 1e-12) low = middle;
    else high = middle;
  }
  return low;
}
