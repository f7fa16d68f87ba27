/** A stone: its surface from the library's profile, in mm. Growth lines are fixed in it, so one sees how it turns. */
import { BufferAttribute, BufferGeometry, Color, Mesh, ShaderMaterial, type Object3D, type Raycaster } from "three";
import { C, type Goishi, type Numbers } from "../core";
import { rgb, type Token } from "../look";
import { lightGlsl, lightUniforms } from "./light";

const around = 40, along = 5; // facets about the axis, and along each part of the profile

/** The surface of a stone   [mm], or as much of it as a turn by `sweep` about the axis makes. */
export function stoneGeometry(goishi: Goishi, stone: Numbers, sweep = 2 * Math.PI): BufferGeometry {
  const profile = goishi.profile(stone, along);
  const rows = profile.length / C.PROFILE_SIZE;
  const points = new Float32Array(rows * (around + 1) * 3), normals = points.slice();
  const corners: number[] = [];
  for (let i = 0, k = 0; i < rows; ++i) {
    const at = (place: number) => profile[i * C.PROFILE_SIZE + place]!;
    for (let j = 0; j <= around; ++j, k += 3) {
      const angle = (sweep * j) / around, c = Math.cos(angle), s = Math.sin(angle);
      points.set([1e3 * at(C.RHO) * c, 1e3 * at(C.RHO) * s, 1e3 * at(C.ZETA)], k);
      normals.set([at(C.NORMAL_RHO) * c, at(C.NORMAL_RHO) * s, at(C.NORMAL_ZETA)], k);
      if (i + 1 < rows && j < around) {
        const a = i * (around + 1) + j, b = a + around + 1;
        corners.push(a, b, b + 1, a, b + 1, a + 1);
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(corners);
  return geometry;
}

// Growth lines are layers of the shell, so they go through the rim. Their phases are found at the corners.
const vertexShader = /* glsl */ `
varying vec3 vN, vW;
varying vec2 phases;
void main() {
  float bend = position.y + 0.3 * position.z + 0.014 * position.x * position.x + 0.35 * sin(position.x * 0.31 + 1.0);
  phases = vec2(bend * 2.1 + 0.8 * sin(bend * 0.53), bend * 6.3 + 1.7 * sin(bend * 0.9));
  vec4 w = modelMatrix * vec4(position, 1.0);
  vW = w.xyz;
  vN = mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * viewMatrix * w;
}`;

const growth = /* glsl */ `
varying vec2 phases;
float growth() {
  float wide = 0.5 + 0.5 * sin(phases.x), fine = 0.5 + 0.5 * sin(phases.y);
  return 0.65 * wide * wide + 0.35 * fine;
}
`;

const surface = /* glsl */ `
varying vec3 vN, vW;
uniform vec3 base;
uniform float gloss, lines;
${lightGlsl}${growth}
void main() {
  vec3 n = normalize(vN), v = normalize(cameraPosition - vW);
  vec3 c = base * (1.0 - lines * growth() * vec3(0.86, 0.95, 1.1));
  gl_FragColor = vec4(lit(c, n, v, gloss), 1.0);
}`;

const spirit = /* glsl */ `
varying vec3 vN, vW;
uniform vec3 base;
${growth}
void main() {
  vec3 n = normalize(vN), v = normalize(cameraPosition - vW);
  float side = 1.0 - abs(dot(n, v)), edge = side * sqrt(side);
  float stripe = smoothstep(0.44, 0.56, growth());
  gl_FragColor = vec4(base, (0.16 + 0.72 * edge) * (0.78 + 0.22 * stripe) + 0.07 * stripe);
}`;

/** Puts something where a motion or a pose says   [m]. */
export function put(object: Object3D, motion: Numbers, at = 0): void {
  object.position.set(1e3 * motion[at]!, 1e3 * motion[at + 1]!, 1e3 * motion[at + 2]!);
  const q = at + C.ATTITUDE;
  object.quaternion.set(motion[q + 1]!, motion[q + 2]!, motion[q + 3]!, motion[q]!);
  object.updateMatrixWorld();
}

export type Shell = "white" | "black";

abstract class Body extends Mesh<BufferGeometry, ShaderMaterial> {
  /** Another stone. */
  reshape(goishi: Goishi, stone: Numbers, sweep?: number): void {
    this.geometry.dispose();
    this.geometry = stoneGeometry(goishi, stone, sweep);
  }

  /** Puts it where a motion or a pose says   [m]. */
  place(motion: Numbers, at = 0): void {
    put(this, motion, at);
  }

  /** Whether a ray of the pointer meets it. */
  isMet(caster: Raycaster): boolean {
    return caster.intersectObject(this, false).length > 0;
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}

/** Shell or slate. */
export class StoneShape extends Body {
  constructor(goishi: Goishi, stone: Numbers, private shell: Shell = "white", private readonly lines = 1) {
    super(stoneGeometry(goishi, stone), new ShaderMaterial({
      vertexShader, fragmentShader: surface,
      uniforms: { base: { value: new Color() }, gloss: { value: 0 }, lines: { value: 0 }, ...lightUniforms() },
    }));
    this.paint();
  }

  /** In another shell, or theme. */
  paint(shell: Shell = this.shell): void {
    this.shell = shell;
    const u = this.material.uniforms;
    u["base"]!.value.set(shell === "white" ? "#f4efe4" : "#2a2b2e");
    u["gloss"]!.value = shell === "white" ? 0.85 : 0.4;
    u["lines"]!.value = shell === "white" ? 0.17 * this.lines : 0.18;
    u["bright"]!.value = lightUniforms().bright.value;
  }
}

/** What is compared with: seen through, in a colour of its own. */
export class GhostShape extends Body {
  constructor(goishi: Goishi, stone: Numbers, private readonly token: Token = "exact") {
    super(stoneGeometry(goishi, stone), new ShaderMaterial({
      vertexShader, fragmentShader: spirit, transparent: true, depthWrite: false,
      uniforms: { base: { value: new Color() } },
    }));
    this.renderOrder = 3;
    this.paint();
  }

  paint(): void {
    this.material.uniforms["base"]!.value.setRGB(...rgb(this.token));
  }
}
