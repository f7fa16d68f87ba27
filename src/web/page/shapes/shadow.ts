/** The shadow of a stone on a level ground, without a shadow map: that of the ellipsoid with its half axes is an ellipse,
 *
 *     S = P R diag(a², a², c²) Rᵀ Pᵀ      P projects along the light
 *
 * softer the higher it is; and a second one straight below, darker the nearer it is. */
import { Matrix3, Matrix4, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector4, type Object3D } from "three";
import { C, type Numbers } from "../core";
import { towardsLight } from "./light";

const vertexShader = /* glsl */ `
varying vec2 vP;
void main() {
  vec4 w = modelMatrix * vec4(position, 1.0);
  vP = w.xy;
  gl_Position = projectionMatrix * viewMatrix * w;
}`;

// thrown, contact: inverse of S (xx, xy, yy) and how soft.
const fragmentShader = /* glsl */ `
varying vec2 vP;
uniform vec2 centre, below, limit;
uniform vec4 thrown, contact;
uniform float deep, dark;
float ellipse(vec2 x, vec4 s) {
  float q = sqrt(max(s.x * x.x * x.x + 2.0 * s.y * x.x * x.y + s.z * x.y * x.y, 0.0));
  return 1.0 - smoothstep(1.0 - s.w, 1.0 + s.w, q);
}
void main() {
  if (abs(vP.x) > limit.x || abs(vP.y) > limit.y) discard;
  float a = 0.42 * ellipse(vP - centre, thrown) * deep, b = 0.5 * ellipse(vP - below, contact) * dark;
  gl_FragColor = vec4(0.1, 0.06, 0.03, a + b - a * b);
}`;

export class ShadowShape extends Mesh<PlaneGeometry, ShaderMaterial> {
  readonly #ground: number;
  #a2 = 1;
  #c2 = 1;

  /** On the level `ground` [mm]; where the ground ends, `half` widths from the middle. */
  constructor(ground = 0, half = new Vector2(1e6, 1e6)) {
    super(new PlaneGeometry(1, 1), new ShaderMaterial({
      vertexShader, fragmentShader, transparent: true, depthWrite: false, depthTest: true,
      uniforms: {
        centre: { value: new Vector2() }, below: { value: new Vector2() }, limit: { value: half },
        thrown: { value: new Vector4() }, contact: { value: new Vector4() }, deep: { value: 1 }, dark: { value: 1 },
      },
    }));
    this.#ground = ground;
    this.renderOrder = 0;
  }

  /** Of a stone, by its measures. */
  of(measures: Numbers): void {
    this.#a2 = (500 * measures[C.OUTER_WIDTH]!) ** 2;
    this.#c2 = (500 * measures[C.MEASURE_HEIGHT]!) ** 2;
  }

  /** Follows the stone that is drawn. */
  follow(stone: Object3D): void {
    const r = new Matrix3().setFromMatrix4(new Matrix4().makeRotationFromQuaternion(stone.quaternion)).elements;
    const [a2, c2] = [this.#a2, this.#c2];
    // M = a² 1 + (c² − a²) u uᵀ, u the axis.
    const u = [r[6]!, r[7]!, r[8]!] as const;
    const m = (i: 0 | 1 | 2, j: 0 | 1 | 2) => (i === j ? a2 : 0) + (c2 - a2) * u[i] * u[j];
    const height = stone.position.z - this.#ground;
    // Inverse of S, how soft, and half the box that it needs.
    const shape = (lx: number, ly: number, soft: number) => {
      const xx = m(0, 0) - 2 * lx * m(0, 2) + lx * lx * m(2, 2);
      const yy = m(1, 1) - 2 * ly * m(1, 2) + ly * ly * m(2, 2);
      const xy = m(0, 1) - lx * m(1, 2) - ly * m(0, 2) + lx * ly * m(2, 2);
      const det = xx * yy - xy * xy;
      return { s: [yy / det, -xy / det, xx / det, soft] as const, box: [Math.sqrt(xx) * (1 + soft), Math.sqrt(yy) * (1 + soft)] as const };
    };
    const above = Math.max(0, height - Math.sqrt(c2));
    const [lx, ly] = [towardsLight.x / towardsLight.z, towardsLight.y / towardsLight.z];
    const uniforms = this.material.uniforms;
    const { x, y } = stone.position, far = [x - lx * height, y - ly * height] as const;
    const thrown = shape(lx, ly, Math.min(0.9, 0.12 + above / 90)), contact = shape(0, 0, 0.9);
    const faint = 0.12, dark = Math.max(0, Math.exp(-above / 7) - faint) / (1 - faint); // none from 15 mm on
    uniforms["centre"]!.value.set(...far);
    uniforms["below"]!.value.set(x, y);
    uniforms["thrown"]!.value.set(...thrown.s);
    uniforms["contact"]!.value.set(...contact.s);
    uniforms["deep"]!.value = 1 / (1 + above / 120);
    uniforms["dark"]!.value = dark;
    const ends = [0, 1].map((k) => { // of a box around both; the second only where it is seen
      const low = far[k]! - thrown.box[k]!, high = far[k]! + thrown.box[k]!, here = k === 0 ? x : y;
      return dark === 0 ? [low, high] : [Math.min(low, here - contact.box[k]!), Math.max(high, here + contact.box[k]!)];
    }) as [[number, number], [number, number]];
    this.position.set((ends[0][0] + ends[0][1]) / 2, (ends[1][0] + ends[1][1]) / 2, this.#ground + 0.05);
    this.scale.set(ends[0][1] - ends[0][0], ends[1][1] - ends[1][0], 1);
    this.visible = height > 0;
    this.updateMatrixWorld();
  }
}
