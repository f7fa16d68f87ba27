/** A line through points, of a width in pixels, of which a first part may be shown. */
import type { InstancedBufferGeometry, Scene, WebGLRenderer } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { color, type Token } from "../look";

export class TrailShape extends LineSegments2 {
  readonly #token: Token | `#${string}`;
  readonly #wide: number;

  constructor(token: Token | `#${string}`, wide = 2.2) {
    super(new LineSegmentsGeometry(), new LineMaterial());
    this.#token = token;
    this.#wide = wide;
    this.frustumCulled = false;
    this.renderOrder = 1;
    this.visible = false;
    this.onBeforeRender = ((renderer: WebGLRenderer, scene: Scene) => { // in the pixels of the picture, of which there are more or fewer
      this.material.resolution.set(renderer.domElement.width, renderer.domElement.height);
      this.material.linewidth = this.#wide * ((scene.userData["scale"] as number | undefined) ?? 1);
    }) as unknown as LineSegments2["onBeforeRender"];
    this.paint();
  }

  paint(): void {
    this.material.color.set(this.#token.startsWith("#") ? this.#token : color(this.#token as Token));
  }

  /** Through points [mm], x, y, z each; a line breaks where a coordinate is NaN. */
  through(points: ArrayLike<number>): void {
    const segments = new Float32Array(Math.max(0, points.length / 3 - 1) * 6);
    let last = 0;
    for (let i = 0; i + 5 < points.length; i += 3) {
      const whole = [0, 1, 2, 3, 4, 5].every((k) => !Number.isNaN(points[i + k]!));
      for (let k = 0; k < 6; ++k) segments[2 * i + k] = whole ? points[i + k]! : points[last]! || 0;
      if (whole) last = i;
    }
    this.geometry.dispose();
    this.geometry = new LineSegmentsGeometry();
    if (segments.length > 0) this.geometry.setPositions(segments);
    this.show(segments.length / 6);
  }

  /** Only the first `count` segments. */
  show(count: number): void {
    (this.geometry as InstancedBufferGeometry).instanceCount = Math.max(0, count);
    this.visible = count > 0;
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
