// A coarser mesh on the same nodes, for software rendering while the picture moves.

/** Triangles that are enough for a picture that moves. */
const ENOUGH = 7000;

/**
 * The triangles of a part between fewer of its nodes: all nodes within a cube of space are drawn as one of them, at edges one of the edge, so that rims stay smooth.
 * Null where the part is coarse enough.
 */
export function coarser(part, nodes, size) {
  const { triangles, own, rim } = part;
  if (triangles.length / 3 <= ENOUGH) return null;
  const order = [...new Set(rim), ...own];
  const best = new Int32Array(nodes.length / 3);
  let found = null;
  // Cubes grow until few enough triangles are left.
  for (let cell = size / 90; cell < size / 8; cell *= 1.25) {
    const first = new Map();
    for (const node of order) {
      const key = [0, 1, 2].map((axis) => Math.floor(nodes[3 * node + axis] / cell)).join();
      if (!first.has(key)) first.set(key, node);
      best[node] = first.get(key);
    }
    found = [];
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = [best[triangles[i]], best[triangles[i + 1]], best[triangles[i + 2]]];
      if (a !== b && b !== c && a !== c) found.push(a, b, c);
    }
    if (found.length / 3 <= ENOUGH) break;
  }
  return Uint32Array.from(found);
}
