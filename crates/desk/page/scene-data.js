// What the scene draws, as typed arrays: from scene.json, or, without one, the modes that results.json holds.

/** Bytes of a base64 text. */
function bytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const out = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i += 1) out[i] = binary.charCodeAt(i);
  return out;
}

/** An array of a kind from base64 or from a plain list. */
function numbers(value, Kind) {
  if (typeof value !== 'string') return Kind.from((value ?? []).flat());
  const raw = bytes(value);
  const length = Math.floor(raw.byteLength / Kind.BYTES_PER_ELEMENT);
  // A copy of a scene has many megabytes: only where the bytes are not aligned.
  return raw.byteOffset % Kind.BYTES_PER_ELEMENT ? new Kind(raw.slice().buffer, 0, length) : new Kind(raw.buffer, raw.byteOffset, length);
}

/** The same of a key, whose text is let go: it is as large as all else. */
function taken(object, key, Kind) {
  const found = numbers(object[key], Kind);
  object[key] = null;
  return found;
}

/**
 * The scene of scene.json, whose long texts it takes.
 *
 * @returns `{nodes, count, parts, times, frames, scale, surfaceScale, apart, displacement, fields, modes, moments, size}`; `apart` are the nodes that take
 *   `surfaceScale`, null where there are none
 * Errors: a format that this viewer does not know, arrays of the wrong length.
 */
export function decoded(json) {
  if (!String(json?.format).startsWith('tankcheck-scene/')) throw new Error(`scene.json: format ${json?.format}`);
  const nodes = numbers(json.nodes, Float32Array);
  const count = nodes.length / 3;
  const times = Float64Array.from(json.times ?? []);
  const displacement = taken(json, 'displacement', Int16Array);
  if (displacement.length !== times.length * nodes.length) throw new Error('scene.json: displacement has the wrong length');
  const parts = (json.parts ?? []).map((part) => built(part.id, numbers(part.cells, Uint32Array), part.per_cell ?? 4, count));
  const fields = (json.fields ?? []).map((field) => fieldOf(field, parts, count, times.length));
  const modes = (json.modes ?? []).map((mode) => ({ title: mode.title, frequency: mode.frequency, displacement: numbers(mode.displacement, Float32Array) }));
  const frames = times.length;
  const [scale, surfaceScale] = [perFrame(json.scale, frames), json.surface_scale ? perFrame(json.surface_scale, frames) : null];
  return finished({ nodes, count, parts, times, frames, scale, surfaceScale, apart: surfaceScale && alone(parts, count), displacement, fields, modes, moments: [] });
}

/** Marks the nodes that only the surface has. */
function alone(parts, count) {
  const marks = new Uint8Array(count);
  for (const { id, own } of parts) if (id === 'surface') for (const node of own) marks[node] = 1;
  for (const { id, own } of parts) if (id !== 'surface') for (const node of own) marks[node] = 0;
  return marks;
}

/** The factors on the stored displacement of a node, by frame. */
export const scaleOf = (scene, node) => (scene.apart?.[node] ? scene.surfaceScale : scene.scale);

const perFrame = (scale, frames) => (typeof scale === 'number' ? new Float64Array(frames).fill(scale) : Float64Array.from(scale ?? []));

function fieldOf(field, parts, count, frames) {
  const values = taken(field, 'values', Int16Array);
  const part = parts.find(({ id }) => id === field.part);
  if (!part) throw new Error(`scene.json: field ${field.id} names the part ${field.part}`);
  const per = frames ? values.length / frames : 0;
  const places = per === count && field.at !== 'cell' ? null : part.own;
  const expected = field.at === 'cell' ? part.cells.length / part.per : (places ?? { length: count }).length;
  if (per !== expected) throw new Error(`scene.json: field ${field.id} has ${per} values a frame, expected ${expected}`);
  const scale = perFrame(field.scale, frames);
  let low = 0;
  let high = 0;
  for (let frame = 0; frame < frames; frame += 1) {
    let [least, most] = [0, 0];
    for (let i = frame * per; i < (frame + 1) * per; i += 1) {
      if (values[i] < least) least = values[i];
      if (values[i] > most) most = values[i];
    }
    low = Math.min(low, least * scale[frame]);
    high = Math.max(high, most * scale[frame]);
  }
  return { id: field.id, title: field.title, unit: field.unit, part: part.id, at: field.at, per, places, scale, values, low, high, around: field.at === 'cell' ? around(part, count) : null };
}

/** Triangles, edges and own nodes of a part. */
function built(id, cells, per, count) {
  const faces = per === 8 ? skin(cells) : cells;
  const corners = per === 3 ? 3 : 4;
  const triangles = [];
  const edges = new Map();
  const own = new Uint8Array(count);
  for (let c = 0; c < faces.length; c += corners) {
    const corner = Array.from(faces.subarray(c, c + corners)).filter((node, i, all) => all.indexOf(node) === i);
    for (let i = 0; i < corner.length; i += 1) {
      own[corner[i]] = 1;
      const [a, b] = [corner[i], corner[(i + 1) % corner.length]];
      const key = a < b ? a * count + b : b * count + a;
      edges.set(key, (edges.get(key) ?? 0) + 1);
      if (i > 1) triangles.push(corner[0], corner[i - 1], corner[i]);
    }
  }
  const ends = (keys) => Uint32Array.from(keys.flatMap((key) => [Math.floor(key / count), key % count]));
  const keys = [...edges.keys()];
  return {
    id, cells, per, triangles: Uint32Array.from(triangles), edges: ends(keys), rim: ends(keys.filter((key) => edges.get(key) === 1)),
    own: Uint32Array.from(own.keys()).filter((node) => own[node]),
  };
}

/** Faces of hexahedra that only one of them has. */
function skin(cells) {
  const SIDES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
  const found = new Map();
  for (let c = 0; c < cells.length; c += 8) {
    for (const side of SIDES) {
      const face = side.map((i) => cells[c + i]);
      const key = [...face].sort((a, b) => a - b).join();
      found.set(key, found.has(key) ? null : face);
    }
  }
  return Uint32Array.from([...found.values()].filter(Boolean).flat());
}

/** The cells at each node: `list[start[node] .. start[node + 1]]`. */
function around(part, count) {
  const start = new Uint32Array(count + 1);
  const { cells, per } = part;
  for (const node of cells) start[node + 1] += 1;
  for (let i = 0; i < count; i += 1) start[i + 1] += start[i];
  const list = new Uint32Array(cells.length);
  const filled = start.slice();
  for (let i = 0; i < cells.length; i += 1) list[filled[cells[i]]++] = Math.floor(i / per);
  return { start, list };
}

/** Writes the values of a field at a frame (SI) to all nodes; element values are averaged at nodes. */
export function fieldAt(field, frame, out) {
  const { values, per, places, around: near } = field;
  const from = frame * per;
  const factor = field.scale[frame];
  if (!near) {
    for (let i = 0; i < per; i += 1) out[places ? places[i] : i] = values[from + i] * factor;
    return;
  }
  const { start, list } = near;
  for (let node = 0; node < out.length; node += 1) {
    const end = start[node + 1];
    if (end === start[node]) continue;
    let sum = 0;
    for (let i = start[node]; i < end; i += 1) sum += values[from + list[i]];
    out[node] = (sum * factor) / (end - start[node]);
  }
}

/** History of a field at a node, or null where the field has none there. */
export function historyAt(scene, field, node) {
  const { values, per, places, around: near, scale } = field;
  const at = near ? -1 : places ? places.indexOf(node) : node;
  if (near ? near.start[node] === near.start[node + 1] : at < 0) return null;
  const out = new Float64Array(scene.frames);
  for (let frame = 0; frame < scene.frames; frame += 1) {
    if (!near) out[frame] = values[frame * per + at] * scale[frame];
    else {
      const [from, to] = [near.start[node], near.start[node + 1]];
      for (let i = from; i < to; i += 1) out[frame] += (values[frame * per + near.list[i]] * scale[frame]) / (to - from);
    }
  }
  return out;
}

/** Displacement of a node in x, y, z over time [m]. */
export function motionOf(scene, node) {
  const out = [0, 1, 2].map(() => new Float64Array(scene.frames));
  const scale = scaleOf(scene, node);
  for (let frame = 0; frame < scene.frames; frame += 1) {
    const at = (frame * scene.count + node) * 3;
    for (let axis = 0; axis < 3; axis += 1) out[axis][frame] = scene.displacement[at + axis] * scale[frame];
  }
  return out;
}

/** Adds the size of the model and the largest displacement of each part. */
function finished(scene) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < scene.nodes.length; i += 1) {
    low[i % 3] = Math.min(low[i % 3], scene.nodes[i]);
    high[i % 3] = Math.max(high[i % 3], scene.nodes[i]);
  }
  scene.low = low;
  scene.high = high;
  scene.size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) || 1;
  for (const part of scene.parts) {
    let most = 0;
    for (let frame = 0; frame < scene.frames; frame += 1) {
      const here = [0, 0];
      for (const node of part.own) {
        const at = (frame * scene.count + node) * 3;
        const apart = scene.apart?.[node] ?? 0;
        for (let axis = 0; axis < 3; axis += 1) here[apart] = Math.max(here[apart], Math.abs(scene.displacement[at + axis]));
      }
      most = Math.max(most, here[0] * scene.scale[frame], here[1] * (scene.surfaceScale?.[frame] ?? 0));
    }
    part.most = most;
  }
  return scene;
}

/** The modes of results.json on a cylinder, or of the three-dimensional engine; null where there are none. */
export function modesOf(results) {
  for (const run of results?.runs ?? []) if (run.fields?.nodes?.length && run.fields.modes?.length) return solid(run.fields);
  const radius = results?.tank?.tank?.shape?.radius;
  const run = (results?.runs ?? []).find((one) => one.modes?.some((mode) => mode.shape?.z?.length));
  const modes = run?.modes.filter((mode) => mode.shape?.z?.length === run.modes[0].shape.z.length);
  return radius && modes?.length ? revolved(modes, radius, results.tank.liquid?.fill_height) : null;
}

function solid(fields) {
  const nodes = Float32Array.from(fields.nodes.flat());
  const count = nodes.length / 3;
  const parts = [['wall', fields.wall], ['surface', fields.surface]].filter(([, cells]) => cells?.length)
    .map(([id, cells]) => built(id, Uint32Array.from(cells.flat()), 4, count));
  const modes = fields.modes.map((mode) => ({ title: mode.title, frequency: mode.omega / (2 * Math.PI), displacement: Float32Array.from(mode.displacement.flat()) }));
  const moments = (fields.moments ?? []).map((one) => ({ title: one.title, time: one.time, displacement: Float32Array.from(one.displacement.flat()) }));
  return finished({ nodes, count, parts, times: new Float64Array(0), frames: 0, scale: new Float64Array(0), displacement: new Int16Array(0), fields: [], modes, moments });
}

const AROUND = 64;

/** Shapes w(z) cos mθ of the wall and η(r) cos mθ of the surface, turned about the axis. */
function revolved(modes, radius, fill) {
  const { z, r } = modes[0].shape;
  const rings = z.length;
  const circles = r.length;
  const count = AROUND * (rings + circles);
  const nodes = new Float32Array(3 * count);
  const ring = (k, distance, height) => {
    for (let i = 0; i < AROUND; i += 1) {
      const angle = (2 * Math.PI * i) / AROUND;
      nodes.set([distance * Math.cos(angle), distance * Math.sin(angle), height], 3 * (k * AROUND + i));
    }
  };
  z.forEach((height, k) => ring(k, radius, height));
  r.forEach((distance, k) => ring(rings + k, distance, fill ?? z[rings - 1]));
  const parts = [built('wall', quads(0, rings), 4, count), ...(circles > 1 ? [built('surface', quads(rings, circles), 4, count)] : [])];
  const shaped = modes.map((mode) => ({ title: `${mode.kind} ${mode.number}, m = ${mode.harmonic}`, kind: mode.kind, number: mode.number, harmonic: mode.harmonic,
    frequency: mode.omega / (2 * Math.PI), displacement: shape(mode, rings, circles) }));
  return finished({ nodes, count, parts, times: new Float64Array(0), frames: 0, scale: new Float64Array(0), displacement: new Int16Array(0), fields: [], modes: shaped, moments: [] });
}

function quads(first, rings) {
  const cells = [];
  for (let k = 0; k + 1 < rings; k += 1) {
    for (let i = 0; i < AROUND; i += 1) {
      const next = (i + 1) % AROUND;
      cells.push((first + k) * AROUND + i, (first + k) * AROUND + next, (first + k + 1) * AROUND + next, (first + k + 1) * AROUND + i);
    }
  }
  return Uint32Array.from(cells);
}

function shape({ harmonic, shape: { wall, surface } }, rings, circles) {
  const out = new Float32Array(3 * AROUND * (rings + circles));
  for (let i = 0; i < AROUND; i += 1) {
    const angle = (2 * Math.PI * i) / AROUND;
    const wave = Math.cos(harmonic * angle);
    for (let k = 0; k < rings; k += 1) {
      const at = 3 * (k * AROUND + i);
      out[at] = wall[k] * wave * Math.cos(angle);
      out[at + 1] = wall[k] * wave * Math.sin(angle);
    }
    for (let k = 0; k < circles; k += 1) out[3 * ((rings + k) * AROUND + i) + 2] = (surface[k] ?? 0) * wave;
  }
  return out;
}
