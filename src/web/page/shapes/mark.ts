/** Marks in space: a dot, a plate that a stone touches, a cone of friction. */
import { CircleGeometry, Color, ConeGeometry, Mesh, ShaderMaterial, SphereGeometry, Vector3, type BufferGeometry } from "three";
import type { Vec } from "../core";
import { rgb, type Token } from "../look";

const vertexShader = /* glsl */ `
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const fragmentShader = /* glsl */ `
uniform vec3 base;
uniform float alpha;
void main() {
  gl_FragColor = vec4(base, alpha);
}`;

abstract class Flat extends Mesh<BufferGeometry, ShaderMaterial> {
  readonly #token: Token;

  constructor(geometry: BufferGeometry, token: Token, alpha: number, through: boolean) {
    super(geometry, new ShaderMaterial({
      vertexShader, fragmentShader, uniforms: { base: { value: new Color() }, alpha: { value: alpha } },
      transparent: true, depthTest: !through, depthWrite: false, side: 2,
    }));
    this.#token = token;
    this.renderOrder = through ? 6 : 2;
    this.visible = false;
    this.paint();
  }

  paint(): void {
    this.material.uniforms["base"]!.value.setRGB(...rgb(this.#token));
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}

/** A dot, seen through what stands before it. */
export class DotShape extends Flat {
  /** `radius` in mm. */
  constructor(token: Token, radius = 0.42) {
    super(new SphereGeometry(radius, 12, 8), token, 1, true);
  }

  /** At a point [mm]. */
  at(point: Vec): void {
    this.position.set(...point);
    this.visible = true;
  }
}

/** A round plate. */
export class PlateShape extends Flat {
  /** `radius` in mm. */
  constructor(token: Token, radius: number, alpha = 0.2) {
    super(new CircleGeometry(radius, 48), token, alpha, false);
  }

  /** Through a point [mm], across a unit normal. */
  at(point: Vec, normal: Vec): void {
    this.position.set(...point);
    this.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...normal));
    this.visible = true;
  }
}

/** A cone that opens upwards. */
export class ConeShape extends Flat {
  constructor(token: Token) {
    super(new ConeGeometry(1, 1, 48, 1, true).rotateX(-Math.PI / 2).translate(0, 0, 0.5), token, 0.16, true);
    this.renderOrder = 4;
  }

  /** Its tip at a point [mm], with a slope of `slope` across for 1 upwards, so high [mm]. */
  at(point: Vec, slope: number, high: number): void {
    this.position.set(...point);
    this.scale.set(slope * high, slope * high, high);
    this.visible = true;
  }
}
