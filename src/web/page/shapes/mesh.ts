/** A stone as the triangles that the library gives, with their edges, in mm. */
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, ShaderMaterial } from "three";
import type { Numbers } from "../core";
import { rgb } from "../look";
import { lightGlsl, lightUniforms } from "./light";

export type Look = "wire" | "flat" | "smooth";

const vertexShader = /* glsl */ `
attribute vec3 corner;
varying vec3 vN, vW, vCorner;
void main() {
  vCorner = corner;
  vN = mat3(modelMatrix) * normal;
  vec4 w = modelMatrix * vec4(position, 1.0);
  vW = w.xyz;
  gl_Position = projectionMatrix * viewMatrix * w;
}`;

// `corner` is 1 at one of the three, so the least of its parts is the distance from the nearest edge.
const fragmentShader = /* glsl */ `
varying vec3 vN, vW, vCorner;
uniform vec3 base, ink;
uniform float flatly, edges, solid, thick;
${lightGlsl}
void main() {
  vec3 v = normalize(cameraPosition - vW);
  vec3 face = normalize(cross(dFdx(vW), dFdy(vW)));
  vec3 n = mix(normalize(vN), face, flatly);
  vec3 pixel = max(fwidth(vCorner), vec3(1e-5));
  vec3 near = smoothstep(vec3(0.0), thick * pixel, vCorner);
  float edge = (1.0 - min(near.x, min(near.y, near.z))) * clamp(0.45 / max(pixel.x, max(pixel.y, pixel.z)) * 0.4, 0.12, 1.0);
  vec3 c = lit(base, n, v, 0.5);
  if (solid < 0.5) {
    float behind = dot(normalize(vN), v) < 0.0 ? 0.35 : 1.0;
    gl_FragColor = vec4(ink, edge * behind);
    return;
  }
  gl_FragColor = vec4(mix(c, ink, edges * edge), 1.0);
}`;

export class MeshShape extends Mesh<BufferGeometry, ShaderMaterial> {
  constructor() {
    super(new BufferGeometry(), new ShaderMaterial({
      vertexShader, fragmentShader, transparent: true,
      uniforms: { base: { value: new Color("#f4efe4") }, ink: { value: new Color() }, flatly: { value: 0 }, edges: { value: 0 },
        solid: { value: 1 }, thick: { value: 1.6 }, ...lightUniforms() },
    }));
    this.onBeforeRender = (_, scene) => {
      this.material.uniforms["thick"]!.value = 0.8 * ((scene.userData["scale"] as number | undefined) ?? 1);
    };
    this.paint();
  }

  /** Of triangles with vertices of their own, in m. */
  reshape({ points, normals, corners }: { points: Numbers; normals: Numbers; corners: Uint32Array }): void {
    const count = corners.length, places = new Float32Array(3 * count), ups = new Float32Array(3 * count), marks = new Float32Array(3 * count);
    corners.forEach((vertex, i) => {
      for (let k = 0; k < 3; ++k) {
        places[3 * i + k] = 1e3 * points[3 * vertex + k]!;
        ups[3 * i + k] = normals[3 * vertex + k]!;
      }
      marks[3 * i + (i % 3)] = 1;
    });
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(places, 3));
    this.geometry.setAttribute("normal", new BufferAttribute(ups, 3));
    this.geometry.setAttribute("corner", new BufferAttribute(marks, 3));
  }

  show(look: Look): void {
    const { material } = this, u = material.uniforms;
    u["flatly"]!.value = look === "flat" ? 1 : 0;
    u["edges"]!.value = look === "flat" ? 0.55 : 0;
    u["solid"]!.value = look === "wire" ? 0 : 1;
    material.depthWrite = look !== "wire";
    if ((material.side === DoubleSide) !== (look === "wire")) {
      material.side = look === "wire" ? DoubleSide : 0;
      material.needsUpdate = true;
    }
  }

  paint(): void {
    const u = this.material.uniforms;
    u["ink"]!.value.setRGB(...rgb("ink"));
    u["bright"]!.value = lightUniforms().bright.value;
  }
}
