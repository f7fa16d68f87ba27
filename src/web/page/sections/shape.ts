/** 1 The shape. */
import { ChoiceControl, iconButton, NumberControl, panel, Presets, SwitchControl, type Control } from "../controls";
import { C, rowsOf, type Numbers } from "../core";
import { el } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme } from "../look";
import { digits, fixed, Shown } from "../numbers";
import { Plot } from "../plot";
import { Readout } from "../readout";
import { Refusal } from "../refusal";
import { remember, type Section } from "../section";
import type { Shell } from "../shapes/stone";
import { Construction, type Progress } from "./shape/construction";
import { Magnifier } from "./shape/magnifier";

const sizes = [22, 25, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40] as const;
const near = { target: [0, 0, 0], azimuth: -Math.PI / 2 - 0.5, elevation: 0.5, distance: 62 } as const;
const far = { azimuth: -Math.PI / 2, elevation: 0.02, distance: 150 } as const;
const lasts = { meet: 1.3, turn: 1.7, round: 0.7 }; // [s] of the parts of the construction

const ease = (share: number) => {
  const x = Math.min(1, Math.max(0, share));
  return x * x * (3 - 2 * x);
};

export const shape: Section = {
  id: "shape",
  title: "The shape",
  lead: `Two equal <b class="c-exact">circles</b> overlap in a lens. Turned about its axis, the lens is a Go stone; a small
    <b class="c-normal">ball</b> that touches both faces rounds its rim. Pull the handles, turn the picture, or take another
    size: the higher its number, the thicker the stone.`,

  start(place) {
    const { goishi, stage, wide, text } = place;
    const sizesOf = (shell: Shell) => sizes.map((number) => {
      const stone = goishi.catalogueStone(number, shell === "white" ? C.WHITE : C.BLACK, 0);
      return { number, width: Number((1e3 * stone[C.WIDTH]!).toPrecision(9)), height: Number((1e3 * stone[C.HEIGHT]!).toPrecision(9)),
        density: stone[C.DENSITY]! };
    });
    const catalogue = { white: sizesOf("white"), black: sizesOf("black") };

    // --- the picture
    const sizePills = new Presets(wide, { name: "size", label: "size", choices: sizes.map((number) =>
      ({ value: String(number), label: number === 22 ? "size 22" : String(number) })) }, (number) => take(Number(number)));
    const figure = stage.figure(wide, { label: "Two circles that overlap in a lens.", view: near, elevations: [-1.4, 1.4] });
    const what = new Shown("size-of"), kind = el("div", "small"), weighs = new Shown("mass-of"), outer = new Shown("outer-of");
    const again = el("div", "corner");
    figure.overlay.append(
      el("div", "caption left", { "aria-hidden": "true" }, el("div", "great", {}, what.element), kind),
      el("div", "caption right", { "aria-hidden": "true" }, el("div", "great", {}, weighs.element), el("div", "small", {}, outer.element)), again);
    again.hidden = !movesByItself();
    iconButton(again, "restart", "show again how it is made", () => play());
    const magnifier = new Magnifier(figure.overlay);
    const first = catalogue.white.find(({ number }) => number === 33)!;
    const construction = new Construction(goishi, figure, goishi.catalogueStone(33, C.WHITE, 1e-3));

    // --- numbers
    const refused = new Refusal(wide);
    const numbers = new Readout(wide, [
      { name: "sphere-radius", symbol: "r", label: "radius of the circles" },
      { name: "sphere-offset", symbol: "d", label: "from their centres to the middle" },
      { name: "major-radius", symbol: "r<sub>1</sub>", label: "from the axis to the ball’s centre" },
      { name: "minor-radius", symbol: "r<sub>2</sub>", label: "radius of the ball" },
      { name: "volume", symbol: "V", label: "volume" },
      { name: "mass", symbol: "m", label: "mass" },
      { name: "axial", symbol: "I<sub>a</sub>", label: "moment of inertia about the axis" },
      { name: "transverse", symbol: "I<sub>t</sub>", label: "and across it" },
    ]);

    // --- curvature
    const plots = el("div", "plots");
    wide.append(plots);
    const curvature = new Plot(plots, { title: "How sharply the profile bends", unit: "curvature in 1/mm, from pole to pole; drag",
      lines: [{ label: "curvature", token: "normal" }], log: { least: 1e-3 }, across: " mm", veiled: false,
      range: (least, greatest) => [Math.min(0.01, least / 2), Math.max(10, greatest * 2)], splits: [0.01, 0.1, 1, 10, 100], tick: (value) => String(value),
      scrub: (arc) => {
        along = arc / length;
        mark();
      } });

    // --- controls
    const [left, right] = panel(wide, "The stone", "The rim") as [HTMLElement, HTMLElement];
    const changed = () => {
      settle();
      renew();
      remember(place, controls);
    };
    const number = (host: HTMLElement, key: string, label: string, least: number, greatest: number, step: number, value: number) =>
      new NumberControl(host, { key, label, unit: "mm", least, greatest, step, value, digits: 6 }, changed);
    const width = number(left, "width", "width", 10, 40, 0.1, first.width);
    const height = number(left, "height", "thickness", 1, 20, 0.1, first.height);
    const bevel = number(right, "bevel", "bevel, its height", 0, 6, 0.1, 1);
    const shell = new ChoiceControl<Shell>(left, { key: "stone", label: "made of", value: "white",
      choices: [{ value: "white", label: "shell, white" }, { value: "black", label: "slate, black" }] }, (chosen) => {
        const number = sizeOf(chosen === "white" ? "black" : "white");
        const same = catalogue[chosen].find((one) => one.number === number);
        if (same) [width.value, height.value] = [same.width, same.height];
        changed();
      });
    const choices = el("div", "choices");
    right.append(choices);
    const of = new ChoiceControl(choices, { key: "of", label: "the width is measured on", value: "lens",
      choices: [{ value: "lens", label: "the sharp lens, as the talk does" }, { value: "stone", label: "the finished stone, as a gauge does" }] }, changed);
    const talk = new SwitchControl(right, { key: "talk", label: "the bevel that the talk published, which is wrong", value: false, token: "published" }, changed);
    const open = new ChoiceControl(left, { key: "view", label: "show it", value: "open",
      choices: [{ value: "open", label: "cut open" }, { value: "whole", label: "whole" }] }, changed);
    const controls: Control[] = [width, height, bevel, shell, of, talk, open];

    const jump = el("p", "remark"), ratio = new Shown("jump"), bend = new Shown("bend");
    const jumps = el("span");
    jump.append("At the mark the profile bends ", bend.element, ". ", jumps, ratio.element);
    text.append(jump);
    const wrongWords = el("p", "remark c-published", { "aria-live": "polite" }), wrong = new Shown("published-minor-radius");
    text.append(wrongWords);

    evidence(text, "Why it is right",
      `The lens has closed forms; the bevel is a torus that touches both caps, so the rounded stone is exactly a smaller lens with a
       ball rolled over it. A computer-algebra program takes the library’s own formulas and proves them. As published, bevelling
       makes the stone narrower than the lens that it is made of; what a customer measures is the finished stone, which has a closed
       form of its own. Densities are assumed values.`, [
        ["SHAPE-1", "Radius and offset of the circles are right to the last bit but one."],
        ["SHAPE-2", "So is every length of a bevelled stone."],
        ["SHAPE-3", "And of one whose finished width is given."],
        ["LAW-6", "The measured stone has the width that was measured."],
        ["SURFACE-2", "Every point of the surface is where the solid ends."],
        ["GSL-2", "Volume, area and moments agree with integration of the profile."],
        ["CERTIFIED-1", "And with what rigorous integration encloses."],
        ["PUBLISHED-5", "The talk’s bevel function gives −5.85 mm where 0.68 mm touches both caps: a sign under a root."],
        ["PUBLISHED-6", "Black stones are 0.3 mm wider than white ones; in the talk it was 0.3 cm."],
      ]);

    // --- what it is about
    let stone: Numbers | null = null, measures: Numbers | null = null, published: Numbers | null = null, rows: Numbers[] = [];
    let length = 1, along = 0.3, moving: object | null = null; // [mm] of the profile; where the mark is, of it
    const settled = (): Progress => ({ apart: 0, sweep: open.value === "open" ? Math.PI : 2 * Math.PI, bevel: 1 });

    function sizeOf(made: Shell): number | null {
      return catalogue[made].find((one) => one.width === width.value && one.height === height.value)?.number ?? null;
    }
    function take(number: number): void {
      const one = catalogue[shell.value].find((entry) => entry.number === number)!;
      [width.value, height.value] = [one.width, one.height];
      changed();
    }

    /** Computes; what the library refuses keeps the last good picture. */
    function compute(): boolean {
      const next = Float64Array.from([width.value / 1e3, height.value / 1e3, bevel.value / 1e3, of.value === "stone" ? 1 : 0,
        catalogue[shell.value][0]!.density, 0]);
      return refused.takes(() => {
        const profile = goishi.profile(next, 48);
        measures = goishi.measures(next);
        published = goishi.publishedMeasures(next);
        const lens = Float64Array.from([measures[C.MEASURE_WIDTH]!, measures[C.MEASURE_HEIGHT]!, 0, 0, next[C.DENSITY]!, 0]);
        magnifier.show(measures, profile, goishi.profile(lens, 48));
        rows = rowsOf(profile, C.PROFILE_SIZE);
        stone = next;
      });
    }

    function renew(): boolean {
      const size = sizeOf(shell.value);
      sizePills.mark(size === null ? null : String(size));
      if (!compute()) return false;
      const m = measures!, mm = (place: number) => 1e3 * m[place]!;
      what.set(m[C.MEASURE_HEIGHT]!, `${digits(mm(of.value === "stone" ? C.OUTER_WIDTH : C.MEASURE_WIDTH), 4)} × ${digits(mm(C.MEASURE_HEIGHT), 3)} mm`);
      kind.textContent = size === null ? "no size of the catalogue" : `size ${size}, ${shell.value}`;
      weighs.set(m[C.TRUE_MASS]!, `${digits(1e3 * m[C.TRUE_MASS]!, 3)} g`);
      outer.set(m[C.OUTER_WIDTH]!, `lens ${fixed(mm(C.MEASURE_WIDTH), 2)}, finished ${fixed(mm(C.OUTER_WIDTH), 2)} mm`);
      const lengths: [string, number][] = [["sphere-radius", C.SPHERE_RADIUS], ["sphere-offset", C.SPHERE_OFFSET],
        ["major-radius", C.MAJOR_RADIUS], ["minor-radius", C.MINOR_RADIUS]];
      for (const [name, at] of lengths) numbers.set(name, m[at]!, `${fixed(mm(at), 4)} mm`);
      numbers.set("volume", m[C.VOLUME]!, `${digits(1e6 * m[C.VOLUME]!, 6)} cm³`);
      numbers.set("mass", m[C.TRUE_MASS]!, `${digits(1e3 * m[C.TRUE_MASS]!, 6)} g`);
      numbers.set("axial", m[C.AXIAL]!, `${digits(1e7 * m[C.AXIAL]!, 6)} g cm²`);
      numbers.set("transverse", m[C.TRANSVERSE]!, `${digits(1e7 * m[C.TRANSVERSE]!, 6)} g cm²`);
      length = 1e3 * rows.at(-1)![C.ARC]!;
      curvature.set(rows.map((row) => 1e3 * row[C.ARC]!), [rows.map((row) => 1e-3 * row[C.CURVATURE]!)], 0, length);
      const r2 = m[C.MINOR_RADIUS]!;
      jumps.textContent = r2 > 0 ? "Where cap and ball meet, the direction is the same and the bend is not: it jumps by a factor " : "A sharp rim bends without limit.";
      ratio.set(m[C.SPHERE_RADIUS]! / r2, r2 > 0 ? `${fixed(m[C.SPHERE_RADIUS]! / r2, 1)}.` : "");
      words();
      draw(settled(), moving === null);
      mark();
      return true;
    }

    function words(): void {
      const r2 = published![C.PUBLISHED_MINOR_RADIUS]!;
      wrong.set(r2, `${fixed(1e3 * r2, 2)} mm`);
      if (talk.value) {
        wrongWords.replaceChildren("The talk’s function takes √(r² + y²) where √(r² − y²) is meant, and gives r₂ = ", wrong.element,
          ": a ball of negative radius, which touches both circles from without, beside the stone.");
      } else {
        wrongWords.replaceChildren();
      }
    }

    function draw(progress: Progress, done: boolean): void {
      construction.show(stone!, measures!, progress, done, talk.value ? published : null);
      magnifier.element.hidden = !done;
      if (done) {
        construction.paint(shell.value);
        const m = measures!, mm = (at: number) => fixed(1e3 * m[at]!, 2);
        figure.label = `A Go stone ${open.value === "open" ? "cut open along its axis" : "between the two circles of its faces"}: width ${mm(C.OUTER_WIDTH)} mm, thickness ${mm(C.MEASURE_HEIGHT)} mm, the circles’ radius ${mm(C.SPHERE_RADIUS)} mm.`;
      }
      figure.invalidate();
    }

    function mark(): void {
      const at = along * length / 1e3;
      const row = rows.find((one) => one[C.ARC]! >= at) ?? rows.at(-1)!;
      curvature.now(along * length);
      construction.mark(moving === null ? row : null);
      bend.set(row[C.CURVATURE]!, `with a radius of ${digits(1e3 / row[C.CURVATURE]!, 4)} mm, a curvature of ${digits(1e-3 * row[C.CURVATURE]!, 4)} /mm`);
      figure.invalidate();
    }

    /** The construction, from two circles to the stone. */
    function play(): void {
      if (!movesByItself() || !stone) return settle();
      const owner = moving = {}, gap = 1e3 * (measures![C.SPHERE_RADIUS]! - measures![C.SPHERE_OFFSET]!);
      let time = 0;
      stage.animate(owner, (dt) => {
        if (moving !== owner) return false;
        time += dt;
        const meet = ease(time / lasts.meet), turn = ease((time - lasts.meet) / lasts.turn), round = ease((time - lasts.meet - lasts.turn) / lasts.round);
        for (const key of ["azimuth", "elevation", "distance"] as const) figure.view[key] = far[key] + (near[key] - far[key]) * turn;
        if (round >= 1) {
          settle();
          return false;
        }
        draw({ apart: (1 - meet) * 2.2 * gap, sweep: turn * settled().sweep, bevel: round }, false);
        return true;
      });
      mark();
    }

    /** To its end. */
    function settle(): void {
      if (moving) {
        stage.stop(moving);
        moving = null;
        if (stone) {
          draw(settled(), true);
          mark();
        }
      }
    }

    /** A handle: what its pull along x or z makes of a length. */
    function pull(handle: HTMLElement, axis: "x" | "y", control: NumberControl, least: number, greatest: number): void {
      let from: { at: number; value: number; scale: number } | null = null;
      handle.addEventListener("pointerdown", (event) => {
        if (event.button !== 0 || !measures) return;
        handle.setPointerCapture(event.pointerId);
        const half = axis === "x" ? 500 * measures[C.OUTER_WIDTH]! : 500 * measures[C.MEASURE_HEIGHT]!;
        const middle = figure.project([0, 0, 0]), end = figure.project(axis === "x" ? [half, 0, 0] : [0, 0, half]);
        from = { at: axis === "x" ? event.clientX : event.clientY, value: control.value, scale: half / ((end[axis] - middle[axis]) || 1) };
      });
      handle.addEventListener("pointermove", (event) => {
        if (!from) return;
        const by = 2 * from.scale * ((axis === "x" ? event.clientX : event.clientY) - from.at);
        const value = Number(Math.min(greatest, Math.max(least, from.value + by)).toFixed(1));
        if (value === control.value) return;
        control.value = value;
        changed();
      });
      for (const end of ["pointerup", "pointercancel"] as const) handle.addEventListener(end, () => (from = null));
    }
    pull(construction.pole, "y", height, 1, 20);
    pull(construction.rim, "x", width, 10, 40);
    figure.element.addEventListener("pointerdown", () => settle());
    figure.element.addEventListener("keydown", () => settle());
    onTheme(() => {
      construction.paint(shell.value);
      figure.invalidate();
    });

    let entered = false;
    return {
      controls,
      update() {
        settle();
        if (renew()) return;
        for (const control of controls) control.reset(); // an address whose numbers do not go together
        renew();
      },
      enter() {
        if (!entered) play();
        entered = true;
      },
      leave() {
        settle();
      },
    };
  },
};
