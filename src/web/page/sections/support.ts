/** 5 Support and separating axis. */
import { Scene } from "three";
import { ChoiceControl, NumberControl, panel, type Control } from "../controls";
import { C, vec } from "../core";
import { el } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme } from "../look";
import { Refusal } from "../refusal";
import { linkButton, remember, type Section } from "../section";
import { ArrowShape } from "../shapes/arrow";
import { BoardShape } from "../shapes/board";
import { DotShape } from "../shapes/mark";
import { ShadowShape } from "../shapes/shadow";
import { GhostShape, StoneShape } from "../shapes/stone";
import { TrailShape } from "../shapes/trail";
import { Transport } from "../transport";
import { leaning, type Bag, type Picture } from "./support/bag";
import { atBoard } from "./support/board";
import { extent } from "./support/extent";
import { inFlight } from "./support/flight";
import { pair } from "./support/pair";

export const support: Section = {
  id: "support",
  title: "Support and separating axis",
  lead: `To know whether two bodies touch, look along an axis: if what you see of one ends before the other begins, they are
    apart. The talk looks along a few fixed axes. Goishi finds <b class="c-exact">the one that separates most</b>: its value is the
    true gap, its direction the normal of the contact.`,

  start(place) {
    const { goishi, stage, section, wide, text } = place;
    const board = goishi.board(), still = new Scene(), wood = new BoardShape(board), occluder = wood.occluder();
    still.add(wood);
    const white = () => goishi.catalogueStone(33, C.WHITE, 1e-3 * bevel.value);
    let stone = goishi.catalogueStone(33, C.WHITE, 1e-3);

    const what = new ChoiceControl(wide, { key: "show", label: "what is shown", value: "extent", quiet: true, choices: [
      { value: "extent", label: "how far it reaches" }, { value: "board", label: "at the board" },
      { value: "pair", label: "stone against stone" }, { value: "flight", label: "when it touches" } ] }, changed);
    const says = el("p", "remark says", { "aria-live": "polite" });
    wide.append(says);
    const figure = stage.figure(wide, {
      label: "A Go stone and how far it reaches.", still, view: { target: [0, 0, 0], azimuth: -1.3, elevation: 0.16, distance: 90 },
      elevations: [0.04, 1.5], grip: (caster) => picture().grip(caster),
    });
    const shape = new StoneShape(goishi, stone), other = new StoneShape(goishi, goishi.catalogueStone(33, C.BLACK, 1e-3), "black");
    const shadow = new ShadowShape(0, wood.half), right = new GhostShape(goishi, stone, "exact"), talks = new GhostShape(goishi, stone, "published");
    const normal = new ArrowShape("normal", { thick: 0.45, through: true }), between = new TrailShape("exact", 3);
    const here = new DotShape("exact"), there = new DotShape("exact");
    figure.scene.add(occluder, shadow, shape, other, right, talks, normal, between, here, there);

    const transport = new Transport(wide, section, stage, { speeds: [1, 5, 25], speed: 1, decimals: 4,
      show: (time, stopped) => picture().show?.(time, stopped) });
    const [common, own] = panel(el("div"), "The stone", "The picture") as [HTMLElement, HTMLElement];
    const number = (key: string, label: string, unit: string, least: number, greatest: number, step: number, value: number) =>
      new NumberControl(common, { key, label, unit, least, greatest, step, value }, changed);
    const tilt = number("tilt", "tilt of its axis", "°", 0, 180, 1, 12), heading = number("heading", "leaning towards", "°", -180, 180, 1, 0);
    const bevel = number("bevel", "bevel", "mm", 0, 4, 0.1, 1);

    const bag: Bag = {
      goishi, figure, transport, board, half: wood.half, gravity: vec(goishi.settings(), C.GRAVITY), panel: own, wide, stone: () => stone, attitude: () => leaning(tilt.value, heading.value), tilt, heading,
      shape, other, shadow, right, talks, normal, here, there, between, changed,
      clear() {
        for (const one of [right, talks, normal, between, here, there, other]) one.visible = false;
      },
    };
    const pictures: Record<string, Picture> = { extent: extent(bag), board: atBoard(bag), pair: pair(bag), flight: inFlight(bag) };
    wide.append(common.parentElement!);
    const picture = () => pictures[what.value]!;
    const controls: Control[] = [what, tilt, heading, bevel, ...Object.values(pictures).flatMap((one) => one.controls)];
    const refused = new Refusal(wide);

    evidence(text, "Why it is right",
      `Support is a formula of two pieces, cap and rim, that join smoothly. The separation of two convex bodies is the greatest, over all
       unit normals, of what lies between their supports; a concave problem, so a candidate is the answer when no direction near it is
       better, and that is proved each time. The first touch of a flight is the first root of a function with a known bound on how fast it
       can bend, so no step can jump over a root.`, [
        ["SURFACE-1", "How far a stone reaches, and where it is touched."],
        ["CONTACT-2", "The gap, or depth, at the board: against all normals."],
        ["CONTACT-3", "Pushed out along the normal by its depth, the stone touches."],
        ["CONTACT-4", "Two stones."],
        ["PUBLISHED-11", "The talk’s axes deny gaps of up to 1.273 mm at an edge and 1.979 mm at a corner."],
        ["PUBLISHED-12", "And push a stone that is 0.04 mm deep out by 1.2 mm."],
        ["PUBLISHED-13", "The talk’s support was wrong by up to 2.116 mm, at size 22; at size 33 it hardly shows."],
        ["TOI-1", "The first touch is the first."],
      ]);

    let shown: Picture | null = null, started = false;

    /** Another picture: what belongs to it is seen, and nothing else. */
    function enter(): void {
      const now = picture();
      for (const one of Object.values(pictures)) for (const element of one.elements) element.hidden = one !== now;
      transport.element.hidden = !now.show;
      transport.pause(false);
      if (now.speed) transport.speed = now.speed;
      for (const object of figure.scene.children) object.visible = object === shape;
      bag.clear();
      wood.visible = occluder.visible = shadow.visible = now.onBoard;
      other.visible = now === pictures["pair"];
      figure.forget();
      says.innerHTML = now.says;
      shown = now;
      now.look();
    }

    /** What the library refuses keeps the last good picture. */
    function compute(): boolean {
      return refused.takes(() => {
        const next = white();
        if (next.some((value, i) => value !== stone[i])) {
          stone = next;
          for (const one of [shape, right, talks]) one.reshape(goishi, stone);
        }
        shadow.of(goishi.measures(stone));
        picture().update();
      });
    }

    function changed(): void {
      if (shown !== picture()) enter();
      if (!compute()) return;
      remember(place, controls);
      run();
    }

    function run(): void {
      if (!picture().show) return;
      if (movesByItself() && started) transport.restart();
      else transport.seek(movesByItself() ? 0 : transport.end);
    }

    linkButton(transport, place, controls);
    onTheme(() => {
      for (const one of [wood, shape, other, right, talks, normal, between, here, there]) one.paint();
      figure.invalidate();
    });

    return {
      controls,
      update() {
        enter();
        if (compute()) run();
      },
      enter() {
        started = true;
        if (picture().show && movesByItself() && transport.time < transport.end) transport.play();
      },
      leave() {
        transport.pause();
      },
    };
  },
};
