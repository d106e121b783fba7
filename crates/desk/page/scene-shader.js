// Materials of the scene: the vertex shader moves the nodes, the fragment shader colours, lights and cuts.

import { ShaderMaterial, DoubleSide } from './vendor/three.js';

const VERTEX = `
attribute vec3 moved;
attribute float level;
varying vec3 seen;
varying float value;
#ifdef CUT
varying float side;
#endif
void main() {
#ifdef CUT
  side = position.y;
#endif
  value = level;
  vec4 place = modelViewMatrix * vec4(position + moved, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

const FRAGMENT = `
uniform vec3 colours[11];
uniform vec3 plain;
uniform float low, high, coloured, bands, lit;
varying vec3 seen;
varying float value;
#ifdef CUT
varying float side;
#endif
vec3 map(float at) {
  if (bands > 0.0) at = (min(floor(at * bands), bands - 1.0) + 0.5) / bands;
  at = clamp(at, 0.0, 1.0) * 10.0;
  int i = int(min(floor(at), 9.0));
  return mix(colours[i], colours[i + 1], at - float(i));
}
void main() {
#ifdef CUT
  if (side < 0.0) discard;
#endif
  vec3 colour = coloured > 0.5 ? map((value - low) / (high - low)) : plain;
  if (lit > 0.5) {
    vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
    float light = abs(dot(normal, vec3(0.25, 0.45, 0.857)));
    colour *= mix(coloured > 0.5 ? 0.82 : 0.62, 1.0, light);
  }
  gl_FragColor = vec4(colour, 1.0);
}`;

/**
 * A material; `shared` are the uniforms that all of them have (`low`, `high`, `colours`, `bands`), the own ones are `plain` and `coloured`.
 */
export function material(shared, own, lines = false) {
  return new ShaderMaterial({
    vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide, defines: {},
    uniforms: { ...shared, ...own, lit: { value: lines ? 0 : 1 } },
    polygonOffset: !lines, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
}

/** Cuts the half y < 0 away, or not. Only a shader that cuts discards, which makes each pixel slower. */
export function cutHalf(made, cut) {
  if (cut === 'CUT' in made.defines) return;
  if (cut) made.defines.CUT = '';
  else delete made.defines.CUT;
  made.needsUpdate = true;
}
