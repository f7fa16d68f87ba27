/** The board: kaya, its lines by the library's dimensions, in mm. It stands still: give its scene to a figure as `still`. */
import { BoxGeometry, Color, Mesh, ShaderMaterial, Vector2 } from "three";
import { C, type Numbers } from "../core";
import { lightGlsl, lightUniforms } from "./light";

const lineWidth = 0.84; // [mm], drawn

const vertexShader = /* glsl */ `
varying vec3 vP, vN;
void main() {
  vP = position;
  vN = normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = /* glsl */ `
varying vec3 vP, vN;
uniform vec2 spacing, extent;
uniform vec3 wood, late;
uniform float lineWidth;
${lightGlsl}
float hash(vec2 p) {
  vec3 q = fract(vec3(p.xyx) * 0.1031);
  q += dot(q, q.yzx + 33.33);
  return fract((q.x + q.y) * q.z);
}
float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
}
// How much of a pixel a line of the board covers, along one axis.
float covered(float at, float space, float reach, float width) {
  float line = abs(fract(at / space + 0.5) - 0.5) * space;
  float pixel = max(fwidth(at), 1e-3);
  float cover = clamp((0.5 * width - line) / pixel + 0.5, 0.0, 1.0) * min(1.0, width / pixel + 0.25);
  return cover * step(abs(at), reach + 0.5 * width);
}
void main() {
  vec3 n = normalize(vN), v = normalize(cameraPosition - vP);
  // The years of the tree run along y; seen from the end they are arcs.
  float across = vP.x + 0.002 * vP.z * vP.z + 7.0 * noise(vec2(vP.x * 0.011, vP.y * 0.0035));
  float year = fract(across * 0.085 + 0.6 * noise(vec2(vP.x * 0.03, vP.y * 0.004)));
  float grain = smoothstep(0.15, 0.85, year) * (1.0 - smoothstep(0.9, 1.0, year));
  float fibre = noise(vec2(vP.x * 2.6, vP.y * 0.06)) * 0.6 + noise(vec2(vP.x * 7.0, vP.y * 0.13)) * 0.4;
  vec3 c = mix(wood, late, 0.42 * grain + 0.3 * (fibre - 0.45));
  c *= 1.03;
  if (n.z > 0.5) {
    float ink = max(covered(vP.x, spacing.x, extent.x, lineWidth) * step(abs(vP.y), extent.y + 0.5 * lineWidth),
                    covered(vP.y, spacing.y, extent.y, lineWidth) * step(abs(vP.x), extent.x + 0.5 * lineWidth));
    vec2 star = (fract(vP.xy / (6.0 * spacing) + 0.5) - 0.5) * 6.0 * spacing;
    float off = length(star), pixel = max(fwidth(off), 1e-3);
    ink = max(ink, clamp((2.0 - off) / pixel + 0.5, 0.0, 1.0) * step(abs(vP.x), 6.5 * spacing.x) * step(abs(vP.y), 6.5 * spacing.y));
    c = mix(c, vec3(0.13, 0.105, 0.08), 0.88 * ink);
  } else {
    c *= 1.2; // they get little light
  }
  gl_FragColor = vec4(lit(c, n, v, 0.16), 1.0);
}`;

/** A board as the library describes it. */
export class BoardShape extends Mesh<BoxGeometry, ShaderMaterial> {
  /** Half of its playing surface   [mm]. */
  readonly half: Vector2;

  constructor(board: Numbers) {
    const mm = (place: number) => 1e3 * board[place]!;
    const lines = board[C.BOARD_LINES]! - 1;
    const extent = new Vector2(mm(C.BOARD_SPACING_X) * lines / 2, mm(C.BOARD_SPACING_Y) * lines / 2);
    const half = new Vector2(extent.x + mm(C.BOARD_BORDER_X), extent.y + mm(C.BOARD_BORDER_Y));
    const geometry = new BoxGeometry(2 * half.x, 2 * half.y, mm(C.BOARD_THICKNESS));
    geometry.translate(0, 0, -mm(C.BOARD_THICKNESS) / 2);
    super(geometry, new ShaderMaterial({
      vertexShader, fragmentShader,
      uniforms: {
        spacing: { value: new Vector2(mm(C.BOARD_SPACING_X), mm(C.BOARD_SPACING_Y)) }, extent: { value: extent },
        wood: { value: new Color("#dcae6a") }, late: { value: new Color("#b98243") },
        lineWidth: { value: lineWidth }, ...lightUniforms(),
      },
    }));
    this.half = half;
  }

  paint(): void {
    this.material.uniforms["bright"]!.value = lightUniforms().bright.value;
  }

  /** The same solid, which is not seen and hides what is behind it: for the scene of what moves. */
  occluder(): Mesh {
    const material = new ShaderMaterial({
      vertexShader, fragmentShader: "void main() { gl_FragColor = vec4(0.0); }", colorWrite: false,
    });
    const mesh = new Mesh(this.geometry, material);
    mesh.renderOrder = -1;
    return mesh;
  }
}
