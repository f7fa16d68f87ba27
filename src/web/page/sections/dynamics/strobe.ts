/** A picture in flashes: bodies as they were before, which share the surface of one that moves. */
import { Group, Mesh } from "three";
import type { Numbers } from "../../core";
import { put } from "../../shapes/stone";

const most = 12;

export class Strobe extends Group {
  constructor(body: Mesh) {
    super();
    for (let i = 0; i < most; ++i) {
      const image = new Mesh(body.geometry, body.material);
      image.renderOrder = body.renderOrder;
      this.add(image);
    }
    this.show([], 0);
  }

  /** Where the poses [m] say that stand in the rows `from` a place on. */
  show(rows: readonly Numbers[], from: number): void {
    this.children.forEach((image, i) => {
      const row = rows[i];
      image.visible = row !== undefined;
      if (row) put(image, row, from);
    });
  }
}
