/** Many small arrows of one colour: forces, seen through what stands before them. */
import { BufferAttribute, Color, ConeGeometry, CylinderGeometry, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial,
  type BufferGeometry } from "three";
import { rgb, type Token } from "../look";

const vertexShader = /* glsl */ `
attribute vec3 from, along;
uniform float thick;
void main() {
  float length_ = length(along), head = min(6.0 * thick, 0.6 * length_);
  vec3 y = along / max(length_, 1e-6), x = normalize(cross(y, abs(y.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0))), z = cross(x, y);
  // The shaft goes from 0 to 1, the head from 1 to 2.
  float at = position.y < 1.001 ? position.y * (length_ - head) : length_ - head + (position.y - 1.001) * head;
  float wide = position.y < 1.0005 ? thick : 2.6 * thick;
  vec3 w = from + at * y + wide * (position.x * x + position.z * z);
  gl_Position = projectionMatrix * viewMatrix * vec4(w, 1.0);
}`;
const fragmentShader = /* glsl */ `
uniform vec3 base;
void main() { gl_FragColor = vec4(base, 1.0); }`;

export class ArrowsShape extends Mesh<InstancedBufferGeometry, ShaderMaterial> {
  readonly #token: Token;
  readonly #from: InstancedBufferAttribute;
  readonly #along: InstancedBufferAttribute;

  /** At most `most`; `thick` [mm] is the radius of a shaft. */
  constructor(token: Token, most: number, thick: number) {
    const geometry = new InstancedBufferGeometry();
    super(geometry, new ShaderMaterial({ vertexShader, fragmentShader, depthTest: false, transparent: true,
      uniforms: { base: { value: new Color() }, thick: { value: thick } } }));
    const [shaft, head] = [new CylinderGeometry(1, 1, 1, 6, 1, true).translate(0, 0.5, 0), new ConeGeometry(1, 1, 8).translate(0, 1.501, 0)];
    join(geometry, shaft, head);
    [this.#from, this.#along] = [0, 1].map(() => new InstancedBufferAttribute(new Float32Array(3 * most), 3)) as [InstancedBufferAttribute, InstancedBufferAttribute];
    geometry.setAttribute("from", this.#from);
    geometry.setAttribute("along", this.#along);
    geometry.instanceCount = 0;
    this.#token = token;
    this.frustumCulled = false;
    this.renderOrder = 5;
    this.paint();
  }

  paint(): void {
    this.material.uniforms["base"]!.value.setRGB(...rgb(this.#token));
  }

  /** From where and how long, x, y, z each   [mm]. */
  show(from: readonly number[], along: readonly number[]): void {
    const count = Math.min(from.length, this.#from.array.length) / 3;
    for (const [attribute, values] of [[this.#from, from], [this.#along, along]] as const) {
      attribute.array.set(values.slice(0, 3 * count));
      attribute.needsUpdate = true;
    }
    this.geometry.instanceCount = count;
    this.visible = count > 0;
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}

/** Positions and corners of two shapes in one. */
function join(into: BufferGeometry, ...shapes: readonly BufferGeometry[]): void {
  const points: number[] = [], corners: number[] = [];
  for (const shape of shapes) {
    const first = points.length / 3;
    corners.push(...Array.from(shape.index!.array, (corner) => first + corner));
    points.push(...shape.getAttribute("position").array);
    shape.dispose();
  }
  into.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  into.setIndex(corners);
}
