/** 4 Dynamics. */
import { Plane, Quaternion, Vector3, type Raycaster } from "three";
import { ChoiceControl, NumberControl, panel, type Control } from "../controls";
import { C, rowsOf, vec, type Numbers, type Vec } from "../core";
import { el, html } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme, type Token } from "../look";
import { digits, fixed, Shown } from "../numbers";
import { Plot } from "../plot";
import { Refusal } from "../refusal";
import { linkButton, remember, type Section } from "../section";
import { ArrowShape } from "../shapes/arrow";
import { ShadowShape } from "../shapes/shadow";
import { GhostShape, StoneShape } from "../shapes/stone";
import { TrailShape } from "../shapes/trail";
import { Transport } from "../transport";
import { Flight, methods, type Launch, type Method, type Moves } from "./dynamics/flight";
import { Strobe } from "./dynamics/strobe";
import { says } from "./dynamics/words";

const size = 33, bevel = 1e-3;               // [m]
const long = { omega: 25, momentum: 29 };    // [mm] of the arrows at the start
const ground = -20;                          // [mm] where the shadow falls
const flashes = { rotation: 0.1, throw: 9 }; // of the strobe: seconds between two, and how many in a throw
const parts = 120;                           // of the exact path of ω, and of the ways
const same = 0.2;                            // [mm] Arrows as near are one
const reach = 3;                             // [mm] from the arrow, to seize it
const slow = 10;                             // times, at first, of a throw

export const dynamics: Section = {
  id: "dynamics",
  title: "Dynamics",
  lead: `A spinning stone keeps its <b class="c-momentum">angular momentum</b>, not its <b class="c-omega">angular velocity</b>.
    A game loop that keeps <i class="c-omega">ω</i> turns the stone about the wrong line, and no smaller step will mend it.
    The <b class="c-exact">ghost</b> is the exact motion. Watch them part, and drag the arrow <i class="c-omega">ω</i> to spin it otherwise.`,

  start(place) {
    const { goishi, stage, section, wide, text } = place;
    const stone = goishi.catalogueStone(size, C.WHITE, bevel), measures = goishi.measures(stone);

    const moves = new ChoiceControl<Moves>(wide, { key: "moves", label: "what there is of motion", value: "rotation", quiet: true,
      choices: [{ value: "rotation", label: "rotation alone" }, { value: "gravity", label: "gravity alone" }, { value: "both", label: "both" }] },
      () => { transport.speed = moves.value === "rotation" ? 2 : slow; changed(true); });

    // --- what is drawn
    const figure = stage.figure(wide, { label: "A Go stone that turns in space.", elevations: [-0.2, 1.5], grip,
      view: { target: [3, 2, 7], azimuth: -1.05, elevation: 0.3, distance: 132 } });
    const shape = new StoneShape(goishi, stone), ghost = new GhostShape(goishi, stone), shadow = new ShadowShape(ground);
    shadow.of(measures);
    const images = new Strobe(shape), spirits = new Strobe(ghost);
    const arrows = {
      momentum: new ArrowShape("momentum", { thick: 0.75 }), momentumLoop: new ArrowShape("momentum-loop", { thick: 0.6 }),
      omega: new ArrowShape("exact", { thick: 0.45 }), omegaLoop: new ArrowShape("omega", { thick: 0.6 }),
    };
    const trails = {
      omega: new TrailShape("exact"), omegaLoop: new TrailShape("omega"), momentumLoop: new TrailShape("momentum-loop"),
      way: new TrailShape("exact"), wayLoop: new TrailShape("soft"),
    };
    figure.scene.add(shadow, shape, ghost, images, spirits, ...Object.values(arrows), ...Object.values(trails));

    const key = (mark: string, words: string) => el("span", "key", {}, html(mark), html(`<span>${words}</span>`));
    const bar = (token: Token) => `<i style="background: var(--${token})"></i>`;
    const vectors = [key(bar("momentum"), "<i>L</i>, exact: fixed"), key(bar("momentum-loop"), "<i>L</i> of the loop"),
      key(bar("exact"), "<i>ω</i>, exact"), key(bar("omega"), "<i>ω</i> of the loop")];
    const great = el("div", "great"), apart = el("div", "small"), angle = new Shown("attitude-angle");
    const turned = new Shown("attitude-error"), away = new Shown("place-error"), energy = new Shown("energy"), momentum = new Shown("momentum"), count = new Shown("step-count");
    figure.overlay.append(
      el("div", "keys", { "aria-hidden": "true" },
        key('<i class="body"></i>', "the loop"), key('<i class="ghost"></i>', "exact"), ...vectors),
      el("div", "caption bare right", { "aria-hidden": "true" }, great, apart,
        ...[energy, momentum, count].map((shown) => el("div", "small", {}, shown.element))));

    // --- time and graphs
    const transport = new Transport(wide, section, stage, { speeds: [1, 2, 10, 25], speed: 2, decimals: 3, show,
      step: () => flight?.step ?? 1 });
    const plots = el("div", "plots beside");
    wide.append(plots);
    const scrub = (time: number) => transport.seek(time);
    const errors = { lines: [], log: { least: 1e-16 }, scrub, across: " s", height: 168,
      range: (least: number, greatest: number): [number, number] => [10 ** Math.floor(Math.log10(least)), Math.max(10, 2 * greatest)] };
    const astray = new Plot(plots, { ...errors, title: "Attitude error", unit: "rad, every method at this step" });
    const off = new Plot(plots, { ...errors, title: "Distance", unit: "mm from the exact place" });
    const kept = new Plot(plots, { title: "What must not change", unit: "% away from its start", lines: [], scrub, across: " s", height: 168,
      range: (least, greatest) => [Math.min(-1, least * 1.08), Math.max(5, greatest * 1.08)],
      tick: (value) => `${value > 0 ? "+" : ""}${fixed(value, 0)}` });

    // --- controls
    const [left, right] = panel(wide, "", "") as [HTMLElement, HTMLElement];
    const loop = new ChoiceControl<Method>(left, { key: "loop", label: "the loop", value: "published",
      choices: Object.entries(methods).map(([value, { label, token }]) => ({ value: value as Method, label, token })) }, () => changed(false));
    const seen = new ChoiceControl<"smooth" | "strobe">(left, { key: "seen", label: "seen", value: "smooth",
      choices: [{ value: "smooth", label: "smoothly" }, { value: "strobe", label: "by strobe" }] },
      () => { show(transport.time, !transport.playing); remember(place, controls); });
    const number = (name: string, label: string, unit: string, least: number, greatest: number, step: number, value: number, log = false) =>
      new NumberControl(right, { key: name, label, unit, least, greatest, step, value, log }, () => changed(name !== "step"));
    const c = {
      step: number("step", "step", "ms", 1, 50, 0.1, 1000 / 60, true),
      about: number("about", "spin about the axis", "rad/s", -40, 40, 0.1, 6),
      across: number("across", "spin across it", "rad/s", 0, 40, 0.1, 5),
      up: number("up", "thrown up at", "m/s", 0.4, 2, 0.01, 1.2),
    };
    const controls: Control[] = [loop, moves, seen, ...Object.values(c)];

    // --- words below
    const remark = el("p", "remark", { "aria-live": "polite" });
    const refused = new Refusal(wide);
    text.append(remark);
    evidence(text, "Why the ghost is right",
      `A stone is a symmetric top, and a symmetric top in free flight needs no time step: it turns about its angular momentum at the
       rate |L|/I<sub>t</sub>, and about its own axis at a constant one, while its centre follows a parabola. So <i>ω</i> goes round
       <i>L</i>. The ghost is drawn from that closed form at each moment; errors are angles and distances from it.`, [
        ["FLIGHT-3", "The closed form solves the equations of Newton and Euler."],
        ["FLIGHT-1", "In double precision its attitude is right within round-off."],
        ["FLIGHT-5", "So is its parabola."],
        ["PUBLISHED-7", "The talk’s loop keeps the angular velocity, and not the angular momentum."],
        ["PUBLISHED-8", "Its parabola falls behind by g t Δt/2."],
        ["PUBLISHED-9", "With L as state, explicit Euler gains energy until the axis lies across L."],
        ["ORDER-1", "Each scheme converges with its order; the talk’s, to a motion of its own."],
        ["MOTION-6", "All of them but the talk’s keep L."],
      ]);

    // --- what it is about
    let flight: Flight | null = null, round = 1, scale = { omega: 0, momentum: 0 };
    let started = false, held = false, drawn = NaN;

    const values = (): Launch => ({ moves: moves.value, method: loop.value, step: c.step.value, about: c.about.value,
      across: c.across.value, up: c.up.value });

    /** Computes; what the library refuses keeps the last good picture. */
    function compute(): boolean {
      const taken = refused.takes(() => (flight = new Flight(goishi, stone, values())));
      if (!taken || !flight) return false;
      graph(flight);
      const { turns, flies } = flight;
      if (!held) scale = { omega: long.omega / (length(flight, C.ANGULAR_VELOCITY) || 8), momentum: long.momentum / (length(flight, C.MOMENTUM) || 1) };
      const scaled = (points: number[], by: number) => (turns ? points.map((value) => by * value) : []);
      const first = flight.round(parts);
      round = first.period;
      trails.omega.through(scaled(first.points, scale.omega));
      trails.omegaLoop.through(scaled(flight.tips(C.STEPPED + C.ANGULAR_VELOCITY), scale.omega));
      trails.momentumLoop.through(scaled(flight.tips(C.STEPPED + C.MOMENTUM), scale.momentum));
      trails.way.through(flies ? flight.way(parts, flight.exact).map((value) => 1e3 * value) : []);
      trails.wayLoop.through(flies ? flight.way(parts, flight.stepped).map((value) => 1e3 * value) : []);
      great.replaceChildren(turns ? turned.element : away.element);
      apart.replaceChildren(...(turns ? [angle.element] : ["apart"]), ...(turns && flies ? [", centres ", away.element] : []));
      for (const one of vectors) one.hidden = !turns;
      for (const one of [c.about, c.across]) one.element.hidden = !turns;
      c.up.element.hidden = !flies;
      remark.textContent = says(values());
      return true;
    }

    function graph({ series, turns, flies, end }: Flight): void {
      const names = Object.keys(methods) as Method[];
      astray.lines = off.lines = names.map((name) => ({ label: methods[name].label, token: methods[name].token, width: name === loop.value ? 2.6 : 1.2 }));
      kept.lines = [{ label: "energy", token: "energy", width: 2 }, ...(turns ? [{ label: "L, as a vector", token: "momentum" as const, width: 2 },
        { label: "its size, |L|", token: "omega" as const, dash: [5, 4] }] : [])];
      astray.set(series.time, names.map((name) => later(series.attitude[name], 1)), 0, end);
      off.set(series.time, names.map((name) => later(series.place[name], 1e3)), 0, end);
      kept.set(series.time, [series.energy, ...(turns ? [series.momentum, series.size] : [])].map((list) => list.map((value) => 100 * value)), 0, end);
      astray.element.hidden = !turns;
      off.element.hidden = !flies;
    }

    /** The picture's middle and distance for what moves: a throw is seen whole. */
    function frame(): void {
      if (!flight) return;
      const { apex, flies, exact, stepped } = flight;
      const ways = flies ? [exact, stepped].flatMap((of) => rowsOf(Float64Array.from(flight!.way(12, of)), 3)) : [];
      figure.frame({ target: [3, 2, 7 + 400 * apex], distance: 132 }, ways.map((point) => vec(point, 0).map((value) => 1e3 * value) as unknown as Vec));
    }

    /** Another flight; `anew` from its start. */
    function changed(anew: boolean): void {
      const playing = transport.playing, time = transport.time;
      if (!compute()) return;
      frame();
      transport.set(flight!.end);
      remember(place, controls);
      if (!anew) {
        transport.seek(time);
        if (playing) transport.play();
      } else if (movesByItself()) {
        transport.restart();
      } else {
        transport.seek(flight!.end);
      }
    }

    /** The moment. By strobe: that of the last flash. */
    function show(time: number, stopped: boolean): void {
      if (!flight) return;
      const { turns, flies } = flight, strobe = seen.value === "strobe";
      const every = Math.max(1, flies ? Math.round(flight.steps / flashes.throw) : Math.round(flashes.rotation / flight.step));
      const step = strobe ? Math.floor(flight.stepAt(time) / every) * every : flight.stepAt(time);
      const row = flight.row(step), moment = strobe ? row[C.FLIGHT_TIME]! : time;
      const motion = flight.stepped(moment), exact = flight.exact(moment);
      shape.place(motion);
      ghost.place(exact);
      shadow.follow(shape);
      const before = strobe && flies ? Array.from({ length: step / every }, (_, i) => flight!.row(i * every)) : [];
      images.show(before, C.STEPPED);
      spirits.show(before, C.EXACTLY);

      const at = (of: Numbers) => vec(of, C.POSITION).map((value) => 1e3 * value) as unknown as Vec;
      const along = (of: Numbers, from: number, by: number) => vec(of, from).map((value) => (turns ? by * value : 0)) as unknown as Vec;
      // Two arrows at one place would flicker: the loop's L hides in the exact one, the exact ω in the loop's.
      arrows.momentum.point(at(exact), along(exact, C.MOMENTUM, scale.momentum));
      arrows.momentumLoop.point(at(motion), along(motion, C.MOMENTUM, scale.momentum));
      arrows.omega.point(at(exact), along(exact, C.ANGULAR_VELOCITY, scale.omega));
      arrows.omegaLoop.point(at(motion), along(motion, C.ANGULAR_VELOCITY, scale.omega));
      const apart_ = Math.hypot(...at(exact).map((value, k) => value - at(motion)[k]!));
      arrows.momentumLoop.visible &&= apart_ + arrows.momentum.tip.distanceTo(arrows.momentumLoop.tip) > same;
      arrows.omega.visible &&= apart_ + arrows.omega.tip.distanceTo(arrows.omegaLoop.tip) > same;
      trails.omega.position.set(...at(exact));
      for (const trail of [trails.omegaLoop, trails.momentumLoop]) {
        trail.position.set(...at(motion));
        trail.show(turns ? (held ? flight.steps : step) / flight.between : 0);
      }
      const share = (part: number) => Math.floor(parts * Math.min(1, held ? 1 : part));
      trails.omega.show(turns ? share(moment / round) : 0);
      for (const trail of [trails.way, trails.wayLoop]) trail.show(flies ? share(moment / flight.end) : 0);

      const turn = row[C.ATTITUDE_ERROR]!, far = row[C.POSITION_ERROR]!, changed_ = flight.kept(row);
      turned.set(turn, `${small(turn)} rad`);
      angle.set(turn, `apart · ${fixed((turn * 180) / Math.PI, 0)}°`);
      away.set(far, `${small(1e3 * far)} mm`);
      energy.set(changed_.energy, `energy ${percent(changed_.energy)}`);
      momentum.set(changed_.momentum, turns ? `L off by ${percent(changed_.momentum).replace("+", "")}` : "");
      const over = flight.diverged && step === flight.last;
      count.set(step, over ? `diverged after step ${step}` : `after step ${step} of ${flight.steps}`);
      for (const plot of [astray, off, kept]) plot.now(time);
      if (stopped) {
        figure.label = `A Go stone in free flight after ${fixed(moment, 3)} s, by ${methods[loop.value].label}, and its exact motion as a ghost: ` +
          `${turns ? `${small(turn)} rad` : ""}${turns && flies ? " and " : ""}${flies ? `${small(1e3 * far)} mm` : ""} apart.`;
      }
      if (stopped || moment !== drawn) figure.invalidate(); // between two flashes nothing moves
      drawn = moment;
    }

    /** The tip of ω is a control, and so is the stone: it draws ω, or the throw, with it. */
    function grip(caster: Raycaster) {
      if (!flight) return null;
      const { state } = flight, omega = arrows.omegaLoop;
      const onArrow = omega.visible && caster.ray.distanceSqToSegment(omega.position, omega.tip) < reach * reach;
      if (!onArrow && !shape.isMet(caster)) return null;
      const spins = flight.turns && (onArrow || !flight.flies);
      const q = new Quaternion(state[C.ATTITUDE + 1], state[C.ATTITUDE + 2], state[C.ATTITUDE + 3], state[C.ATTITUDE]);
      const about = new Vector3(0, 0, 1).applyQuaternion(q), across = new Vector3(1, 0, 0).applyQuaternion(q), up = new Vector3(0, 0, 1);
      const normal = spins ? new Vector3().crossVectors(about, across) : figure.camera.getWorldDirection(new Vector3()).setZ(0).normalize();
      const plane = new Plane().setFromNormalAndCoplanarPoint(normal, shape.position);
      if (Math.abs(caster.ray.direction.dot(normal)) < 0.2) return null; // on edge: nothing to be drawn in
      const first = caster.ray.intersectPlane(plane, new Vector3());
      if (!first) return null;
      const from = { about: c.about.value, across: c.across.value, apex: flight.apex };
      return {
        move(ray: Raycaster["ray"]) {
          const way = ray.intersectPlane(plane, new Vector3())?.sub(first);
          if (!way) return;
          held = true;
          if (spins) {
            c.about.approach(from.about + way.dot(about) / scale.omega);
            c.across.approach(from.across + way.dot(across) / scale.omega);
          } else {
            c.up.approach(Math.sqrt(Math.max(0, -2 * flight!.gravity[2] * (from.apex + 1e-3 * way.dot(up)))));
          }
          if (!compute()) return;
          transport.set(flight!.end);
          transport.seek(0);
        },
        end() {
          if (!held) return;
          held = false;
          changed(true);
        },
      };
    }

    linkButton(transport, place, controls);
    onTheme(() => {
      for (const painted of [shape, ghost, ...Object.values(arrows), ...Object.values(trails)]) painted.paint();
      figure.invalidate();
    });

    return {
      controls,
      update() {
        if (!compute()) return;
        frame();
        transport.set(flight!.end);
        transport.speed = flight!.flies ? slow : 2;
        if (!movesByItself()) transport.seek(flight!.end);
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

/** The length of a vector of the motion at the start. */
const length = (flight: Flight, place: number) => Math.hypot(...vec(flight.row(0), C.STEPPED + place));

/** Scaled, without the first: at the start there is no error, and a logarithm of it neither. */
const later = (list: readonly number[], by: number) => list.map((value, i) => (i === 0 ? NaN : by * value));
const small = (value: number) => (Math.abs(value) >= 0.0995 ? fixed(value, 2) : value === 0 ? "0" : digits(value, 2));
const percent = (value: number) => (Number.isFinite(value) ? `${value > 0 ? "+" : ""}${Math.abs(value) < 5e-4 ? small(100 * value) : fixed(100 * value, 1)} %` : "–");
