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

function nearest(view, one, best) {
  const { part, cut } = one;
  const { nodes } = view.scene;
  const corner = (node, out) => place(one, node, out);
  const { triangles } = part;
  for (let i = 0; i < triangles.length; i += 3) {
    const distance = met(corner(triangles[i], a), corner(triangles[i + 1], b), corner(triangles[i + 2], c));
    if (!(distance < best.distance)) continue;
    to.copy(along).multiplyScalar(distance).add(start);
    const apart = [a.distanceTo(to), b.distanceTo(to), c.distanceTo(to)];
    const node = triangles[i + apart.indexOf(Math.min(...apart))];
    if (cut && nodes[3 * node + 1] < 0) continue;
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

/** Where a node of a part is drawn. */
export function place({ local, attributes: { position, moved } }, node, out) {
  const at = 3 * local[node];
  return out.set(position.array[at] + moved.array[at], position.array[at + 1] + moved.array[at + 1], position.array[at + 2] + moved.array[at + 2]);
}
