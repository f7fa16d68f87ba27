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
    const shape = (lx: number, ly: number) => {
      const xx = m(0, 0) - 2 * lx * m(0, 2) + lx * lx * m(2, 2);
      const yy = m(1, 1) - 2 * ly * m(1, 2) + ly * ly * m(2, 2);
      const xy = m(0, 1) - lx * m(1, 2) - ly * m(0, 2) + lx * ly * m(2, 2);
      const det = xx * yy - xy * xy;
      return [yy / det, -xy / det, xx / det] as const;
    };
    const size = Math.sqrt(a2), above = Math.max(0, height - Math.sqrt(c2));
    const [lx, ly] = [towardsLight.x / towardsLight.z, towardsLight.y / towardsLight.z];
    const uniforms = this.material.uniforms;
    const { x, y } = stone.position;
    uniforms["centre"]!.value.set(x - lx * height, y - ly * height);
    uniforms["below"]!.value.set(x, y);
    uniforms["thrown"]!.value.set(...shape(lx, ly), Math.min(0.9, 0.12 + above / 90));
    uniforms["contact"]!.value.set(...shape(0, 0), 0.9);
    uniforms["deep"]!.value = 1 / (1 + above / 120);
    uniforms["dark"]!.value = Math.exp(-above / 7);
    const reach = 2 * size + 0.5 * height;
    this.position.set(x - 0.5 * lx * height, y - 0.5 * ly * height, this.#ground + 0.05);
    this.scale.set(2 * reach, 2 * reach, 1);
    this.visible = height > 0;
    this.updateMatrixWorld();
  }
}
