/** The light that all shapes share: a key light from the left, the sky, and what the wood sends back. Colours are as shown. */
import { Vector3 } from "three";
import { brightness } from "../look";

/** Towards the light. */
export const towardsLight = new Vector3(-0.45, -0.35, 0.82).normalize();

export const lightUniforms = () => ({ light: { value: towardsLight }, bright: { value: brightness() } });

/** lit(base, normal, view, gloss): what is seen of a surface. Above 0.7 it is compressed, so that nothing burns out. Powers by
 * products: where a processor draws, exponentials are a good part of the picture. */
export const lightGlsl = /* glsl */ `
uniform vec3 light;
uniform float bright;
vec3 lit(vec3 base, vec3 n, vec3 v, float gloss) {
  float key = max(dot(n, light), 0.0);
  float up = 0.5 + 0.5 * n.z;
  vec3 around = mix(vec3(0.52, 0.43, 0.33), vec3(0.6, 0.61, 0.62), up);
  vec3 h = normalize(light + v);
  float s = max(dot(n, h), 0.0), s2 = s * s, s4 = s2 * s2, s8 = s4 * s4, s16 = s8 * s8, s64 = s16 * s16 * s16 * s16;
  float shine = (s64 * s8 * 0.45 + s8 * s4 * 0.08) * gloss;
  float e = 1.0 - max(dot(n, v), 0.0), e2 = e * e, edge = e2 * e2 * 0.22 * gloss;
  vec3 c = base * (around + vec3(0.56, 0.54, 0.5) * key) + vec3(shine) + edge * mix(vec3(0.6, 0.48, 0.33), vec3(0.85, 0.9, 1.0), up);
  c *= bright;
  float most = max(max(c.r, c.g), max(c.b, 1e-3)), over = max(most - 0.7, 0.0);
  return c * (0.7 + 0.3 * over / (over + 0.3) - max(0.7 - most, 0.0)) / most;
}
`;
