// Which node of the scene is under the pointer: the drawn triangles are met by the ray of sight, then the nearest corner is taken.

import { Vector3 } from './vendor/three.js';

const start = new Vector3();
const along = new Vector3();
const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
const [ab, ac, normal, to, cross] = [0, 1, 2, 3, 4].map(() => new Vector3());

/** The node at x, y in −1 … 1 of the picture, or null. */
export function picked(view, x, y) {
  start.setFromMatrixPosition(view.camera.matrixWorld);
  along.set(x, y, 0.5).unproject(view.camera).sub(start).normalize();
  let best = { distance: Infinity, node: null };
  for (const one of view.parts.values()) if (one.shown) best = nearest(view, one, best);
  return best.node;
}

function nearest(view, { part, times, cut }, best) {
  const { nodes } = view.scene;
  const corner = (node, out) => place(view, node, times[0].value, out);
  const { triangles } = part;
  for (let i = 0; i < triangles.length; i += 3) {
    const distance = met(corner(triangles[i], a), corner(triangles[i + 1], b), corner(triangles[i + 2], c));
    if (!(distance < best.distance)) continue;
    to.copy(along).multiplyScalar(distance).add(start);
    const apart = [a.distanceTo(to), b.distanceTo(to), c.distanceTo(to)];
    const node = triangles[i + apart.indexOf(Math.min(...apart))];
    if (cut.value > 0.5 && nodes[3 * node + 1] < 0) continue;
    best = { distance, node };
  }
  return best;
}

/** Distance at which the ray meets a triangle (Möller and Trumbore 1997), or NaN. */
function met(p, q, r) {
  ab.subVectors(q, p);
  ac.subVectors(r, p);
  normal.crossVectors(along, ac);
  const det = ab.dot(normal);
  if (Math.abs(det) < 1e-12) return NaN;
  to.subVectors(start, p);
  const u = to.dot(normal) / det;
  if (u < 0 || u > 1) return NaN;
  cross.crossVectors(to, ab);
  const v = along.dot(cross) / det;
  if (v < 0 || u + v > 1) return NaN;
  const distance = ac.dot(cross) / det;
  return distance > 0 ? distance : NaN;
}

/** Where a node is drawn with displacements `times` times as large. */
export function place(view, node, times, out) {
  const { attributes: { now, next }, scene: { nodes }, shared } = view;
  const at = 3 * node;
  const [a, b] = [times * shared.a.value, times * shared.b.value];
  return out.set(nodes[at] + a * now.array[at] + b * next.array[at], nodes[at + 1] + a * now.array[at + 1] + b * next.array[at + 1],
    nodes[at + 2] + a * now.array[at + 2] + b * next.array[at + 2]);
}
