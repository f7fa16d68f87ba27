/** 6 Collision response. */
import { Scene, type Raycaster } from "three";
import { ChoiceControl, NumberControl, panel, type Control } from "../controls";
import { C } from "../core";
import { el } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme } from "../look";
import { fixed, Shown } from "../numbers";
import { Refusal } from "../refusal";
import { linkButton, remember, type Section } from "../section";
import { ArrowShape } from "../shapes/arrow";
import { BoardShape } from "../shapes/board";
import { ConeShape } from "../shapes/mark";
import { ShadowShape } from "../shapes/shadow";
import { GhostShape, StoneShape } from "../shapes/stone";
import { Transport } from "../transport";
import { mm, scaled } from "../vector";
import { all, horizon, meet, rubs, ways, type Answer, type Met, type Way } from "./impact/answers";
import { ImpulseSpace } from "./impact/space";

const lasting = 0.4; // [s], real, for which the impulses are seen while it plays
const says: Record<Way, string> = {
  linear: `<b>Linear</b>: the board stops the centre of the stone and sends it back, as if it were a ball without size. It leaves
    without a change of its spin, and the point that touched need not even leave the board. Given at that point, so great an impulse can add energy: then it is outside the shell.`,
  angular: `<b class="c-omega">Angular</b>: the impulse at the point of contact turns the stone, too. So the point leaves e times as fast as it came.
    Without friction it goes on sliding.`,
  talk: `<b class="c-published">The talk’s law</b>: first the normal impulse, then one of friction against the slip. But friction turns the stone,
    and so changes how fast the point rebounds: e is not what comes out.`,
  stronge: `<b class="c-momentum">Stronge’s law</b>: the impulse grows bit by bit, pressing and releasing, and slip may stop or turn round on the way. The most
    careful of the three, and the dearest.`,
  default: `<b class="c-exact">Goishi’s default</b>, by Chatterjee and Ruina: of the impulses between “no friction” and “the point is held” the one that the cone allows.
    It rebounds with e exactly, and never gains energy.`,
};

export const impact: Section = {
  id: "impact",
  title: "Collision response",
  lead: `An impact is over at once: all that the board can give the stone is one <b class="c-impulse">impulse</b>. Friction
    keeps it inside a cone, restitution says how fast the point of contact leaves. Within that, laws differ. Here is one impact,
    answered in five ways.`,

  start(place) {
    const { goishi, stage, section, wide, text } = place;
    const still = new Scene(), wood = new BoardShape(goishi.board());
    still.add(wood);

    const way = new ChoiceControl<Way>(wide, { key: "answer", label: "how it is answered", value: "default", quiet: true,
      choices: all.map((value) => ({ value, label: ways[value].label, token: ways[value].token })) }, () => {
      show_();
      remember(place, controls);
    });
    const words = el("p", "remark says", { "aria-live": "polite" });
    wide.append(words);
    const figure = stage.figure(wide, {
      label: "A Go stone that meets the board.", still, view: { target: [0, 0, 12], azimuth: -1.2, elevation: 0.2, distance: 104 },
      elevations: [0.04, 1.5], grip,
    });
    const first = goishi.catalogueStone(33, C.WHITE, 1e-3);
    const shape = new StoneShape(goishi, first), shadow = new ShadowShape(0, wood.half), cone = new ConeShape("soft");
    const ghosts = new Map<Way, GhostShape>(), arrows = new Map<Way, ArrowShape>();
    for (const one of all) {
      ghosts.set(one, new GhostShape(goishi, first, ways[one].token));
      arrows.set(one, new ArrowShape(ways[one].token, { through: true, thick: 0.4 }));
    }
    figure.scene.add(shadow, cone, shape, ...ghosts.values(), ...arrows.values());

    const rebound = new Shown("rebound"), kept = new Shown("kept"), slips = new Shown("slips"), what = new Shown("outcome"), moment = new Shown("moment");
    const spot = el("i", "spot");
    figure.overlay.append(
      el("div", "caption left", { "aria-hidden": "true" }, el("div", "great", {}, spot, what.element), el("div", "small", {}, moment.element)),
      el("div", "caption right", { "aria-hidden": "true" }, el("div", "great", {}, rebound.element), ...[slips, kept].map((shown) => el("div", "small", {}, shown.element))));
    const transport = new Transport(wide, section, stage, { speeds: [5, 25, 100], speed: 25, decimals: 4, show });

    const below = el("div", "plots beside");
    wide.append(below);
    const space = new ImpulseSpace(below);
    const table = answerTable(below);

    const [left, right] = panel(wide, "The stone, as it meets the board", "Stone and board") as [HTMLElement, HTMLElement];
    const number = (host: HTMLElement, key: string, label: string, unit: string, least: number, greatest: number, step: number, value: number) =>
      new NumberControl(host, { key, label, unit, least, greatest, step, value }, changed);
    const c = {
      tilt: number(left, "tilt", "tilt of its axis", "°", 0, 90, 1, 40),
      down: number(left, "down", "speed down", "m/s", 0.05, 2, 0.01, 0.6),
      along: number(left, "along", "speed along", "m/s", -1, 1, 0.01, 0.25),
      tumble: number(left, "tumble", "spin across it", "rad/s", -60, 60, 1, 0),
      spin: number(left, "spin", "spin about its axis", "rad/s", -120, 120, 1, 30),
      restitution: number(right, "e", "restitution e", "", 0, 1, 0.01, 0.5),
      friction: number(right, "mu", "friction μ", "", 0, 1, 0.01, 0.3),
      bevel: number(right, "bevel", "bevel", "mm", 0, 4, 0.1, 1),
    };
    const controls: Control[] = [way, ...Object.values(c)];
    const refused = new Refusal(wide);

    evidence(text, "Why it is right",
      `The response of a point to an impulse is linear: v⁺ = v + W p, with W from mass, moments and the place of the point. Each
       law is a choice of p in the cone. None of them is the truth: e and μ are measured for a pair of bodies and stand for all that rigid theory
       leaves out. What can be proved is what a law promises: the rebound, the cone, that no energy comes from nowhere.`, [
        ["IMPACT-1", "The point of contact leaves e times as fast as it came: every law without friction, the default law with any."],
        ["IMPACT-4", "No law gains energy."],
        ["IMPACT-5", "The impulse is in the cone, against the slip, and the board never pulls."],
        ["IMPACT-6", "Stronge’s law in a plane has an exact construction."],
        ["IMPACT-7", "And out of the plane it obeys its equations."],
        ["IMPACT-8", "The default law stays near Stronge’s."],
        ["PUBLISHED-15", "One round of the talk’s law does not rebound with e."],
        ["PUBLISHED-14", "The talk’s linear response is right with the momentum of the centre; with the velocity of the contact point it would gain energy."],
      ]);

    let met: Met | null = null, started = false;

    function compute(): boolean {
      return refused.takes(() => {
        const next = meet(goishi, { bevel: c.bevel.value, tilt: c.tilt.value, down: c.down.value, along: c.along.value, tumble: c.tumble.value,
          spin: c.spin.value, restitution: c.restitution.value, friction: c.friction.value });
        if (met === null || next.stone.some((value, i) => value !== met!.stone[i])) for (const one of [shape, ...ghosts.values()]) one.reshape(goishi, next.stone);
        met = next;
      });
    }

    /** What does not depend on the moment. */
    function show_(): void {
      if (!met) return;
      shadow.of(goishi.measures(met.stone));
      const end = met.since + Math.min(horizon, Math.max(...all.map((one) => met!.answers[one].until)));
      transport.set(end, [{ time: met.since, token: "impact", label: "the impact", high: true }]);
      words.innerHTML = says[way.value];
      table.fill(met, way.value);
      space.show({ friction: c.friction.value, holding: met.holding, mobility: met.mobility,
        spots: [...all.filter((one) => one !== way.value), way.value].map((one) => ({ at: met!.answers[one].impulse, token: ways[one].token, great: one === way.value })) });
      const mine = met.answers[way.value];
      space.label = `Impulse space: a cone of friction with the impulses of five laws. ${ways[way.value].label}: ${fixed(1e3 * mine.impulse[2], 3)} mN s along the normal, ${fixed(1e3 * Math.hypot(mine.impulse[0], mine.impulse[1]), 3)} mN s across.`;
      spot.style.background = `var(--${ways[way.value].token})`;
      const leaves = met.before[2] < 0;
      rebound.set(mine.rebound, leaves ? `rebounds with ${fixed(mine.rebound, 3)}, asked: ${fixed(c.restitution.value, 2)}` : "it does not approach");
      slips.set(mine.slip, `the point of contact then slips at ${fixed(1e3 * mine.slip, 1)} mm/s`);
      const share = (mine.moving + mine.turning) / (met.moving + met.turning);
      kept.set(share, `keeps ${fixed(100 * share, 1)} % of its energy`);
      what.set(mine.outcome, !leaves ? "no impact" : mine.after[2] < 0 && mine.after[2] < 1e-6 * met.before[2] ? "still goes into the board" : !rubs(way.value) ? "no friction" : mine.outcome === C.STUCK ? "friction holds it" : mine.outcome === C.SLID ? "it slides all the while" : "not converged");
    }

    function show(time: number, stopped: boolean): void {
      if (!met) return;
      const since = time - met.since, at = since > -1e-9 && since < (stopped ? 1e-9 : lasting / transport.speed);
      const where = (answer: Answer) => goishi.freeFlight(met!.stone, since <= 0 ? met!.state : answer.state, met!.gravity, C.BOTH, since <= 0 ? since : Math.min(since, answer.until));
      shape.place(where(met.answers[way.value]));
      shadow.follow(shape);
      const lengths = Math.max(...all.filter((one) => one === way.value || rubs(one)).map((one) => Math.hypot(...met!.answers[one].impulse)));
      for (const one of all) {
        const ghost = ghosts.get(one)!, { impulse } = met.answers[one];
        ghost.visible = since > 0 && one !== way.value && rubs(one);
        if (ghost.visible) ghost.place(where(met.answers[one]));
        const shown = at && lengths > 0 && (one === way.value || rubs(one)); // the others are on the normal
        const scale = shown ? 26 / lengths : 0;
        arrows.get(one)!.point(mm(met.point), scaled(scale, impulse));
      }
      cone.visible = at && c.friction.value > 0;
      if (cone.visible) cone.at(mm(met.point), c.friction.value, 24);
      moment.set(since, Math.abs(since) < 5e-8 ? "at the impact" : `${fixed(1e3 * Math.abs(since), 2)} ms ${since < 0 ? "before" : "after"}`);
      if (stopped) figure.label = `A Go stone and the board, ${moment.element.textContent}: ${what.element.textContent}, ${rebound.element.textContent}, ${kept.element.textContent}.`;
      figure.invalidate();
    }

    function changed(): void {
      if (!compute()) return;
      show_();
      remember(place, controls);
      run();
    }

    function run(): void {
      if (movesByItself() && started) transport.restart();
      else transport.seek(met!.since);
    }

    /** Sideways it tilts, up it comes down faster. */
    function grip(caster: Raycaster) {
      if (!shape.isMet(caster)) return null;
      const from = { tilt: c.tilt.value, down: c.down.value };
      let moved = false;
      return {
        move(_: Raycaster["ray"], dx: number, dy: number) {
          moved = true;
          c.tilt.value = Math.round(Math.min(90, Math.max(0, from.tilt + dx * 0.3)));
          c.down.value = Number(Math.min(2, Math.max(0.05, from.down - dy * 0.005)).toFixed(2));
          if (!compute()) return;
          show_();
          transport.seek(met!.since);
        },
        end() {
          if (moved) changed();
        },
      };
    }

    linkButton(transport, place, controls);
    onTheme(() => {
      for (const one of [wood, shape, cone, ...ghosts.values(), ...arrows.values()]) one.paint();
      figure.invalidate();
    });

    return {
      controls,
      update() {
        if (!compute()) return;
        show_();
        run();
      },
      enter() {
        if (!started && movesByItself()) {
          transport.seek(0);
          transport.play();
        }
        started = true;
      },
      leave() {
        transport.pause();
      },
    };
  },
};

/** The five answers in numbers. */
function answerTable(host: HTMLElement): { fill(met: Met, way: Way): void } {
  const body = el("tbody");
  const cells = new Map<Way, { row: HTMLElement; shown: Shown[]; bars: HTMLElement[] }>();
  const heads = ["", "normal", "across [mN s]", "rebound", "energy"];
  const line = (name: string, ...rest: (Node | string)[]) => el("tr", "", {}, el("th", "", { scope: "row" }, name), ...rest.map((one) => el("td", "", {}, one)));
  for (const way of all) {
    const shown = ["normal", "across", "rebound", "energy"].map((name) => new Shown(`${way}-${name}`)), bars = [el("i"), el("i")];
    const row = el("tr", "", {}, el("th", "", { scope: "row" }, el("span", "key", {}, el("i", "", { style: `background: var(--${ways[way].token})` }), ways[way].short)),
      ...[0, 1, 2].map((k) => el("td", "r", {}, shown[k]!.element)), el("td", "", {}, el("div", "energy-bar", {}, ...bars), shown[3]!.element));
    cells.set(way, { row, shown, bars });
    body.append(row);
  }
  const start = new Shown("energy-before"), startBars = [el("i"), el("i")];
  body.append(line("before", "", "", "", el("div", "", {}, el("div", "energy-bar", {}, ...startBars), start.element)));
  host.append(el("div", "answers scroll", { tabindex: 0, role: "region", "aria-label": "the five answers" }, el("p", "plot-title", {}, el("b", "", {}, "The five answers"), " ",
    el("span", "", {}, "impulse, rebound of the point, energy after")), el("table", "", {}, el("thead", "", {}, el("tr", "", {},
    ...heads.map((head, i) => el(i === 0 ? "td" : "th", i > 0 && i < 4 ? "r" : "", i === 0 ? {} : { scope: "col" }, head)))), body),
    el("div", "space-legend", {}, el("span", "key", {}, el("i", "moving-key"), "of translation"), el("span", "key", {}, el("i", "turning-key"), "of rotation"))));
  return {
    fill(met, way) {
      const all_ = met.moving + met.turning;
      const put = (bars: HTMLElement[], moving: number, turning: number) => [moving, turning].forEach((energy, i) => (bars[i]!.style.width = `${((60 * energy) / all_).toFixed(2)}%`));
      put(startBars, met.moving, met.turning);
      start.set(all_, `${fixed(1e6 * all_, 1)} µJ`);
      for (const [one, { row, shown, bars }] of cells) {
        const { impulse, rebound, moving, turning } = met.answers[one], across = Math.hypot(impulse[0], impulse[1]);
        row.className = one === way ? "picked" : "";
        shown[0]!.set(impulse[2], fixed(1e3 * impulse[2], 3));
        shown[1]!.set(across, fixed(1e3 * across, 3));
        shown[2]!.set(rebound, fixed(rebound, 3));
        shown[3]!.set(moving + turning, `${fixed(1e6 * (moving + turning), 1)} µJ`);
        put(bars, moving, turning);
      }
    },
  };
}
