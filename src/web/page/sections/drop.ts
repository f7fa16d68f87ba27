/** 7 The drop. */
import { Scene } from "three";
import { C } from "../core";
import type { Section } from "../section";
import { StoneShape } from "../shapes/stone";
import { BoardShape } from "../shapes/board";
import { ShadowShape } from "../shapes/shadow";

export const drop: Section = {
  id: "drop",
  title: "The drop",
  lead: "x",
  start({ goishi, stage, wide }) {
    const stone = goishi.catalogueStone(33, C.WHITE, 0.001);
    const still = new Scene(), board = new BoardShape(goishi.board());
    still.add(board);
    const shape = new StoneShape(goishi, stone), shadow = new ShadowShape(0, board.half);
    shadow.of(goishi.measures(stone));
    const figure = stage.figure(wide, { label: "A stone", still, view: { target: [0, 0, 5], azimuth: -1, elevation: 0.45, distance: 180 } });
    figure.scene.add(shape, shadow);
    return { controls: [], update() {
      let t = 0;
      stage.animate(this, (dt) => { t += dt; shape.place(Float64Array.from([0,0,0.02, Math.cos(t/2), Math.sin(t/2)*.6, 0, Math.sin(t/2)*.8])); shadow.follow(shape); figure.invalidate(); return t < 3; });
    } };
  },
};
