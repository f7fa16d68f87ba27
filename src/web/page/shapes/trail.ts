/** A line through points, of a width in pixels, of which a first part may be shown: a ribbon of two triangles for each
 * segment, a third of what LineSegments2 of three.js draws; in software that was two fifths of a picture's time. */
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, ShaderMaterial, Vector2, type Scene, type WebGLRenderer } from "three";
import { color, type Token } from "../look";

const vertexShader = /* glsl */ `
attribute vec3 before, after;
attribute float side;
uniform vec2 pixels; // of the picture
uniform float wide;  // in them
void main() {
  mat4 m = projectionMatrix * modelViewMatrix;
  vec4 here = m * vec4(position, 1.0), a = m * vec4(before, 1.0), b = m * vec4(after, 1.0);
  vec2 way = (b.xy / b.w - a.xy / a.w) * pixels;
  vec2 across = dot(way, way) > 0.0 ? normalize(vec2(-way.y, way.x)) : vec2(0.0);
  here.xy += side * wide * across / pixels * here.w;
  gl_Position = here;
}`;
const fragmentShader = /* glsl */ `
uniform vec3 base;
void main() { gl_FragColor = vec4(base, 1.0); }`;

export class TrailShape extends Mesh<BufferGeometry, ShaderMaterial> {
  readonly #token: Token | `#${string}`;

  constructor(token: Token | `#${string}`, wide = 2.2) {
    super(new BufferGeometry(), new ShaderMaterial({
      vertexShader, fragmentShader, side: DoubleSide,
      uniforms: { pixels: { value: new Vector2() }, wide: { value: wide }, base: { value: new Color() } },
    }));
    this.#token = token;
    this.frustumCulled = false;
    this.renderOrder = 1;
    this.visible = false;
    this.onBeforeRender = ((renderer: WebGLRenderer, scene: Scene) => { // in the pixels of the picture, of which there are more or fewer
      const { uniforms } = this.material, { width, height } = renderer.domElement;
      uniforms["pixels"]!.value.set(width, height);
      uniforms["wide"]!.value = wide * ((scene.userData["scale"] as number | undefined) ?? 1);
      this.material.uniformsNeedUpdate = true;
    }) as unknown as TrailShape["onBeforeRender"];
    this.paint();
  }

  paint(): void {
    this.material.uniforms["base"]!.value.set(this.#token.startsWith("#") ? this.#token : color(this.#token as Token));
  }

  /** Through points [mm], x, y, z each; a line breaks where a coordinate is NaN. */
  through(points: ArrayLike<number>): void {
    const count = Math.floor(points.length / 3), segments = Math.max(0, count - 1);
    const whole = (i: number) => i >= 0 && i < count && !Number.isNaN(points[3 * i]! + points[3 * i + 1]! + points[3 * i + 2]!);
    const places = { position: new Float32Array(6 * count), before: new Float32Array(6 * count), after: new Float32Array(6 * count) };
    const side = new Float32Array(2 * count), corners = new Uint32Array(6 * segments); // of a broken segment all are 0
    for (let i = 0; i < count; ++i) {
      if (!whole(i)) continue;
      const put = (to: Float32Array, from: number) => {
        for (let k = 0; k < 6; ++k) to[6 * i + k] = points[3 * from + (k % 3)]!;
      };
      put(places.position, i);
      put(places.before, whole(i - 1) ? i - 1 : i);
      put(places.after, whole(i + 1) ? i + 1 : i);
      side.set([1, -1], 2 * i);
      if (whole(i + 1)) corners.set([2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3], 6 * i);
    }
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    for (const [name, values] of Object.entries(places)) this.geometry.setAttribute(name, new BufferAttribute(values, 3));
    this.geometry.setAttribute("side", new BufferAttribute(side, 1));
    this.geometry.setIndex(new BufferAttribute(corners, 1));
    this.show(segments);
  }

  /** Only the first `count` segments. */
  show(count: number): void {
    this.geometry.setDrawRange(0, 6 * Math.max(0, Math.floor(count)));
    this.visible = count >= 1;
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
