/** The face of a stone that is cut open along its axis: one half of its meridian, hatched, in mm. */
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, ShaderMaterial } from "three";
import { C, type Numbers } from "../core";
import { brightness } from "../look";
import type { Shell } from "./stone";

const vertexShader = /* glsl */ `
varying vec3 vB;
void main() {
  vB = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = /* glsl */ `
varying vec3 vB;
uniform vec3 base, line;
uniform float side;
void main() {
  float at = (side * vB.x + vB.z) / 0.9, pixel = max(fwidth(at), 1e-4);
  float off = abs(fract(at) - 0.5);
  gl_FragColor = vec4(mix(base, line, clamp((0.06 - off) / pixel + 0.5, 0.0, 1.0)), 1.0);
}`;

export class CutShape extends Mesh<BufferGeometry, ShaderMaterial> {
  /** `side` is 1 or −1: of two halves the hatching goes through. */
  constructor(side: 1 | -1 = 1) {
    super(new BufferGeometry(), new ShaderMaterial({
      vertexShader, fragmentShader, side: DoubleSide,
      uniforms: { base: { value: new Color() }, line: { value: new Color() }, side: { value: side } },
    }));
    this.paint("white");
  }

  /** Of a profile, rows of PROFILE_SIZE. */
  reshape(profile: Numbers): void {
    const rows = profile.length / C.PROFILE_SIZE, points = new Float32Array(3 * (rows + 1)), corners: number[] = [];
    for (let i = 0; i < rows; ++i) {
      points[3 * i + 3] = 1e3 * profile[i * C.PROFILE_SIZE + C.RHO]!;
      points[3 * i + 5] = 1e3 * profile[i * C.PROFILE_SIZE + C.ZETA]!;
      if (i > 0) corners.push(0, i, i + 1);
    }
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(points, 3));
    this.geometry.setIndex(corners);
  }

  paint(shell: Shell): void {
    const { base, line } = this.material.uniforms, white = shell === "white";
    base!.value.set(white ? "#f8f2e4" : "#55565c").multiplyScalar(brightness());
    line!.value.set(white ? "#d8cbb2" : "#3d3e44").multiplyScalar(brightness());
  }
}
