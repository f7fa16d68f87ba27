/** Many stones in one picture, all of a colour in one drawing, by a place, an attitude and a mode for each. */
import { BufferAttribute, BufferGeometry, Color, InterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial,
  Vector2, Vector3, type Raycaster } from "three";
import { C, type Numbers } from "../core";
import { rgb, type Token } from "../look";
import { lightGlsl, lightUniforms, towardsLight } from "./light";

/** The numbers of a stone, `size` of them: x, y, z [m], the attitude w, x, y, z, and how it goes on, GOISHI_MODE_… */
export const pose = { place: 0, attitude: 3, mode: 7, size: 8 } as const;

/** The colours of the modes, in their order. */
export const modeTokens: readonly Token[] = ["momentum", "omega", "published", "exact", "normal"];

const numbers = /* glsl */ `
attribute vec3 place;
attribute vec4 attitude; // w, x, y, z
attribute float mode;
vec3 turned(vec3 v) {
  vec3 t = 2.0 * cross(attitude.yzw, v);
  return v + attitude.x * t + cross(attitude.yzw, t);
}
`;

// Each stone is a patch that faces the eye and is as large as what is seen of it. In it the eye's ray is cut with the two
// spheres whose intersection the stone is: a hundredth of the triangles, and round at any size.
const stoneVertex = /* glsl */ `
${numbers}
uniform vec3 modes[5];
uniform vec3 base;
uniform vec2 axes; // a², c²
uniform float byMode;
varying vec3 vW;
flat varying vec3 vU, vP, vC;
void main() {
  vP = 1000.0 * place;
  vU = turned(vec3(0.0, 0.0, 1.0));
  vC = mix(base, modes[int(mode + 0.5)], byMode);
  vec3 right = vec3(viewMatrix[0][0], viewMatrix[1][0], viewMatrix[2][0]), up = vec3(viewMatrix[0][1], viewMatrix[1][1], viewMatrix[2][1]);
  vec2 along = vec2(dot(vU, right), dot(vU, up)), reach = 2.05 * sqrt(axes.x + (axes.y - axes.x) * along * along);
  vW = vP + reach.x * position.x * right + reach.y * position.y * up;
  gl_Position = projectionMatrix * viewMatrix * vec4(vW, 1.0);
}`;

const stoneFragment = /* glsl */ `
varying vec3 vW;
flat varying vec3 vU, vP, vC;
uniform float gloss, radius, offset;
uniform mat4 projectionMatrix;
${lightGlsl}
void main() {
  vec3 ray = normalize(vW - cameraPosition), from = vW - vP;
  float b = dot(from, ray), k = dot(from, from) + offset * offset - radius * radius, bu = offset * dot(ray, vU), ku = 2.0 * offset * dot(from, vU);
  float b1 = b + bu, b2 = b - bu, s1 = b1 * b1 - k - ku, s2 = b2 * b2 - k + ku; // the sphere of the upper cap, and of the lower
  if (s1 < 0.0 || s2 < 0.0) discard;
  float r1 = sqrt(s1), r2 = sqrt(s2), in1 = -b1 - r1, in2 = -b2 - r2, into = max(in1, in2);
  if (into > min(r1 - b1, r2 - b2)) discard;
  vec3 at = from + into * ray, n = (at + (in1 > in2 ? offset : -offset) * vU) / radius;
  float z = dot(vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]), at + vP) + viewMatrix[3][2];
  gl_FragDepth = 0.5 - 0.5 * (projectionMatrix[2][2] + projectionMatrix[3][2] / z);
  gl_FragColor = vec4(lit(vC, n, -ray, gloss), 1.0);
}`;

// The shadow of the ellipsoid with a stone's half axes, as in shadow.ts: S = P R diag(a², a², c²) Rᵀ Pᵀ; by its root
// a circle becomes it, so that each stone has the smallest patch that its shadow needs.
const shadowVertex = /* glsl */ `
${numbers}
uniform vec2 slope;   // of the light
uniform vec2 axes;    // a², c²
uniform float floor_; // its height
varying vec2 vQ, vP;
varying float vSoft, vDeep;
void main() {
  vec3 p = 1000.0 * place, u = turned(vec3(0.0, 0.0, 1.0));
  float ground = p.z > 0.0 ? 0.0 : floor_, height = p.z - ground, above = max(0.0, height - sqrt(axes.y));
  vec2 v = u.xy - slope * u.z;   // P u
  mat2 s = axes.x * (mat2(1.0) + outerProduct(slope, slope)) + (axes.y - axes.x) * outerProduct(v, v);
  float l = sqrt(s[0][0]), m = s[0][1] / l, n = sqrt(max(s[1][1] - m * m, 0.0));
  vSoft = min(0.5, 0.15 + above / 160.0);
  vDeep = 0.5 / (1.0 + above / 120.0);
  vQ = 2.0 * position.xy * (1.0 + vSoft);
  vP = p.xy - slope * height + vec2(l * vQ.x, m * vQ.x + n * vQ.y);
  gl_Position = projectionMatrix * viewMatrix * vec4(vP, ground + 0.05, 1.0);
  if (ground < 0.0) vP = vec2(0.0); // no edge there
}`;

const shadowFragment = /* glsl */ `
varying vec2 vQ, vP;
varying float vSoft, vDeep;
uniform vec2 limit;
void main() {
  if (abs(vP.x) > limit.x || abs(vP.y) > limit.y) discard;
  float edge = clamp((1.0 + vSoft - length(vQ)) / (2.0 * vSoft), 0.0, 1.0);
  gl_FragColor = vec4(0.1, 0.06, 0.03, vDeep * edge);
}`;

/** A square patch for each stone, four corners that all have its numbers: one drawing in all. By instances it is told shorter,
 * but where a processor draws each instance costs as much as a drawing. */
function patches(poses: InterleavedBuffer, most: number): BufferGeometry {
  const geometry = new BufferGeometry(), corners = new Float32Array(12 * most), index = new Uint32Array(6 * most);
  for (let i = 0; i < most; ++i) {
    corners.set([-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0], 12 * i);
    index.set([0, 1, 2, 0, 2, 3].map((k) => 4 * i + k), 6 * i);
  }
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.setAttribute("place", new InterleavedBufferAttribute(poses, 3, pose.place));
  geometry.setAttribute("attitude", new InterleavedBufferAttribute(poses, 4, pose.attitude));
  geometry.setAttribute("mode", new InterleavedBufferAttribute(poses, 1, pose.mode));
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.setDrawRange(0, 0);
  return geometry;
}

/** The stones of one kind, and their shadows. */
export class StonesShape {
  readonly stones: Mesh<BufferGeometry, ShaderMaterial>;
  readonly shadows: Mesh<BufferGeometry, ShaderMaterial>;
  readonly #poses: InterleavedBuffer; // each stone four times
  readonly #a: number; // half axes   [mm]
  readonly #c: number;
  readonly #black: boolean;
  #ids: number[] = [];

  /** At most `most` stones; a board so wide, `half` [mm], over a floor [mm]. */
  constructor(measures: Numbers, black: boolean, most: number, half: Vector2, floor: number) {
    this.#black = black;
    [this.#a, this.#c] = [500 * measures[C.OUTER_WIDTH]!, 500 * measures[C.MEASURE_HEIGHT]!];
    this.#poses = new InterleavedBuffer(new Float32Array(4 * pose.size * most), pose.size);
    // A lens as high and as wide as the stone.
    const radius = (this.#a ** 2 + this.#c ** 2) / (2 * this.#c);
    const axes = { value: new Vector2(this.#a ** 2, this.#c ** 2) };
    this.stones = new Mesh(patches(this.#poses, most), new ShaderMaterial({
      vertexShader: stoneVertex, fragmentShader: stoneFragment,
      uniforms: { axes, radius: { value: radius }, offset: { value: radius - this.#c }, base: { value: new Color(black ? "#2a2b2e" : "#f4efe4") }, gloss: { value: black ? 0.4 : 0.85 }, byMode: { value: 0 },
        modes: { value: modeTokens.map(() => new Vector3()) }, ...lightUniforms() },
    }));
    this.shadows = new Mesh(patches(this.#poses, most), new ShaderMaterial({
      vertexShader: shadowVertex, fragmentShader: shadowFragment, transparent: true, depthWrite: false,
      polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -4,
      uniforms: { slope: { value: new Vector2(towardsLight.x, towardsLight.y).divideScalar(towardsLight.z) },
        axes, floor_: { value: floor }, limit: { value: half } },
    }));
    this.stones.frustumCulled = this.shadows.frustumCulled = false;
    this.paint();
  }

  paint(): void {
    const { uniforms } = this.stones.material;
    uniforms["bright"]!.value = lightUniforms().bright.value;
    modeTokens.forEach((token, i) => (uniforms["modes"]!.value as Vector3[])[i]!.set(...rgb(token)));
  }

  /** Whether their colours say how they go on. */
  set byMode(value: boolean) {
    this.stones.material.uniforms["byMode"]!.value = value ? 0.75 : 0;
  }

  /** Of all stones, `pose.size` numbers each, those of this colour. */
  place(poses: Float32Array, colors: readonly number[]): void {
    const count = poses.length / pose.size, mine = this.#black ? 1 : 0, array = this.#poses.array as Float32Array;
    this.#ids = [];
    for (let i = 0; i < count; ++i) {
      if (colors[i] !== mine) continue;
      const one = poses.subarray(pose.size * i, pose.size * (i + 1));
      for (let k = 0; k < 4; ++k) array.set(one, pose.size * (4 * this.#ids.length + k));
      this.#ids.push(i);
    }
    for (const { geometry } of [this.stones, this.shadows]) geometry.setDrawRange(0, 6 * this.#ids.length);
    this.#poses.clearUpdateRanges();
    this.#poses.addUpdateRange(0, 4 * pose.size * this.#ids.length);
    this.#poses.needsUpdate = true;
  }

  /** The first that a ray of the pointer meets, as ellipsoids: which, and where [mm]. */
  met(caster: Raycaster): { id: number; distance: number; point: Vector3 } | null {
    const { origin, direction } = caster.ray, array = this.#poses.array as Float32Array;
    let found: { id: number; distance: number; point: Vector3 } | null = null;
    const p = new Vector3(), u = new Vector3();
    this.#ids.forEach((id, k) => {
      const [x, y, z, qw, qx, qy, qz] = array.subarray(4 * pose.size * k, 4 * pose.size * k + pose.mode) as unknown as [number, number, number, number, number, number, number];
      u.set(2 * (qx * qz + qw * qy), 2 * (qy * qz - qw * qx), qw * qw + qz * qz - qx * qx - qy * qy);
      p.copy(origin).sub({ x: 1e3 * x, y: 1e3 * y, z: 1e3 * z });
      // |x|²/a² + (x·u)² (1/c² − 1/a²) = 1 along the ray.
      const more = 1 / this.#c ** 2 - 1 / this.#a ** 2, pu = p.dot(u), du = direction.dot(u);
      const a = 1 / this.#a ** 2 + more * du * du, b = p.dot(direction) / this.#a ** 2 + more * pu * du, c = p.lengthSq() / this.#a ** 2 + more * pu * pu - 1;
      const square = b * b - a * c;
      if (square < 0) return;
      const distance = (-b - Math.sqrt(square)) / a;
      if (distance > 0 && (!found || distance < found.distance)) found = { id, distance, point: caster.ray.at(distance, new Vector3()) };
    });
    return found;
  }

  dispose(): void {
    for (const one of [this.stones, this.shadows]) {
      one.geometry.dispose();
      one.material.dispose();
    }
  }
}
