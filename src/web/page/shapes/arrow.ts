/** An arrow, seen through what stands before it if it is asked to be. */
import { BufferGeometry, Color, ConeGeometry, CylinderGeometry, Group, Mesh, ShaderMaterial, Vector3 } from "three";
import type { Vec } from "../core";
import { rgb, type Token } from "../look";

const vertexShader = /* glsl */ `
varying vec3 vN;
void main() {
  vN = normalize(normalMatrix * normal);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const fragmentShader = /* glsl */ `
varying vec3 vN;
uniform vec3 base;
void main() {
  gl_FragColor = vec4(base * (0.82 + 0.18 * normalize(vN).y) + 0.06 * max(vN.z, 0.0), 1.0);
}`;

const along = new Vector3(0, 1, 0);

export class ArrowShape extends Group {
  readonly #material: ShaderMaterial;
  readonly #shaft: Mesh<BufferGeometry>;
  readonly #head: Mesh<BufferGeometry>;
  readonly #token: Token;
  readonly #thick: number;

  /** `thick` [mm] is the radius of its shaft. */
  constructor(token: Token, { thick = 0.45, through = false } = {}) {
    super();
    this.#token = token;
    this.#thick = thick;
    this.#material = new ShaderMaterial({
      vertexShader, fragmentShader, uniforms: { base: { value: new Color() } }, depthTest: !through, transparent: through,
    });
    this.#shaft = new Mesh(new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0), this.#material);
    this.#head = new Mesh(new ConeGeometry(1, 1, 16).translate(0, -0.5, 0), this.#material);
    this.add(this.#shaft, this.#head);
    if (through) this.#shaft.renderOrder = this.#head.renderOrder = 5;
    this.paint();
  }

  paint(): void {
    this.#material.uniforms["base"]!.value.setRGB(...rgb(this.#token));
  }

  /** Where it points to   [mm]. */
  readonly tip = new Vector3();

  /** From a point along a vector, both in mm. One of no length is not seen. */
  point(from: Vec, vector: Vec): void {
    const v = new Vector3(...vector), length = v.length();
    this.visible = length > 1e-9;
    if (!this.visible) return;
    const thick = this.#thick, head = Math.min(6 * thick, 0.6 * length);
    this.position.set(...from);
    this.tip.copy(v).add(this.position);
    this.quaternion.setFromUnitVectors(along, v.divideScalar(length));
    this.#shaft.scale.set(thick, length - 0.9 * head, thick);
    this.#head.position.y = length;
    this.#head.scale.set(2.5 * thick, head, 2.5 * thick);
    this.updateMatrixWorld(true);
  }

  override dispose(): void {
    this.#shaft.geometry.dispose();
    this.#head.geometry.dispose();
    this.#material.dispose();
  }
}
