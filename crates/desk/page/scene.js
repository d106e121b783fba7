// The tank in three dimensions: draws a scene of scene-data.js with three.js. All that is said about it is in scene-panel.js.

import {
  BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, LineBasicMaterial, LineSegments, Mesh, OrbitControls, PerspectiveCamera, Scene, Vector3,
  WebGLRenderer,
} from './vendor/three.js';
import { colour } from './dom.js';
import { scaleOf, SEQUENTIAL } from './colours.js';
import { cutHalf, material } from './scene-shader.js';
import { fieldAt } from './scene-data.js';
import { picked, place } from './scene-pick.js';
import { coarser } from './scene-coarse.js';
import { lower } from './series.js';

/** Directions from which the named views look. */
const VIEWS = { axonometric: [0.62, -0.78, 0.42], front: [0, -1, 0.001], side: [1, 0, 0.001], top: [0, -0.001, 1] };
/** Frame times between which the resolution stays while the picture moves [ms]. */
const SLOW = 29;
const FAST = 15;
/** Frame time aimed at [ms], and the lowest resolution (pixels over CSS pixels). */
const AIM = 22;
const LEAST = 0.45;

/**
 * A view of a scene.
 *
 * @param {HTMLElement} host takes the canvas and gives its size
 * @param {object} scene of scene-data.js
 * @param {{picked(node: number|null, time: number): void, turned(): void, lost(): void}} calls
 * Errors: no WebGL.
 */
export function createView(host, scene, calls) {
  const slow = software();
  const renderer = new WebGLRenderer(opaque(!slow));
  const view = { host, scene, calls, renderer, world: new Scene(), camera: new PerspectiveCamera(32, 1, 0.01, 1000), ratio: Math.min(2, devicePixelRatio), pending: 0, frame: -1, share: 0, coarse: false };
  view.best = view.ratio;
  if (slow) view.slow = 0.6;
  view.canvas = renderer.domElement;
  host.append(view.canvas);
  view.camera.up.set(0, 0, 1);
  view.controls = new OrbitControls(view.camera, view.canvas);
  view.controls.addEventListener('change', () => { calls.turned(); request(view); });
  build(view);
  look(view, 'axonometric');
  listen(view);
  recolour(view);
  return {
    canvas: view.canvas,
    get ratio() { return view.ratio; },
    get coarse() { return view.coarse; },
    setTime: (time) => setTime(view, time),
    setShape: (shape, amplitude) => setShape(view, shape, amplitude),
    setField: (field) => setField(view, field),
    setOwnRange: (own) => { view.ownRange = own; return setField(view, view.field ?? null); },
    setTimes: (part, times) => { view.parts.get(part).times = times; move(view); request(view); },
    setCut: (cut) => setCut(view, cut),
    setShown: (part, shown) => { view.parts.get(part).shown = shown; move(view); if (view.field) mixed(view); visible(view); },
    setMesh: (mesh) => { view.mesh = mesh; visible(view); },
    setBands: (bands) => { view.shared.bands.value = bands; request(view); },
    setMoving: (moving) => (moving ? begin(view) : rest(view)),
    look: (name) => look(view, name),
    project: (node, out) => project(view, node, out),
    axes: () => axes(view),
    turn: ([around, over]) => turn(view, around, over),
    nearer: (factor) => nearer(view, factor),
    scale: () => view.scale,
    picture: () => { draw(view); return view.canvas; },
    recolour: () => recolour(view),
    draw: () => draw(view),
    destroy: () => destroy(view),
  };
}

/** Whether WebGL is computed by the processor: smoothing of edges would then cost most of the time. */
function software() {
  const probe = document.createElement('canvas').getContext('webgl2');
  if (!probe) return false;
  const names = probe.getExtension('WEBGL_debug_renderer_info');
  const name = names ? probe.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  probe.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** A canvas that hides what is below it: three.js alone makes a transparent one, under which the browser composes the page in every frame. */
function opaque(antialias) {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { alpha: false, antialias, depth: true, stencil: false, powerPreference: 'high-performance' });
  if (!context) throw new Error('no WebGL');
  return { canvas, context };
}

function build(view) {
  const { scene, world } = view;
  view.before = new Float32Array(scene.count);
  view.after = new Float32Array(scene.count);
  view.shared = { low: { value: 0 }, high: { value: 1 }, bands: { value: 0 }, colours: { value: SEQUENTIAL.map((c) => new Vector3(...c)) } };
  view.parts = new Map();
  const wall = scene.parts.find(({ id }) => id === 'wall');
  for (const part of scene.parts) {
    const made = placed(scene, part, part.id === 'surface' ? wall : null);
    const own = { plain: { value: new Color() }, coloured: { value: 0 } };
    const ink = { plain: { value: new Color() }, coloured: { value: 0 } };
    const surface = new Mesh(geometry(made, part.triangles), material(view.shared, own));
    const lines = new LineSegments(geometry(made, part.edges), material(view.shared, ink, true));
    const edge = new LineSegments(geometry(made, part.rim), lines.material);
    for (const object of [surface, lines, edge]) object.frustumCulled = false;
    world.add(surface, lines, edge);
    view.parts.set(part.id, { id: part.id, part, ...made, surface, lines, edge, plain: own.plain, ink: ink.plain, coloured: own.coloured, cut: false, times: 1, shown: part.id !== 'liquid' });
  }
  const ghost = new BufferGeometry();
  ghost.setAttribute('position', new BufferAttribute(scene.nodes, 3));
  ghost.setIndex(new BufferAttribute(Uint32Array.from(scene.parts.filter(({ id }) => id === 'wall' || id === 'bottom').flatMap((part) => [...part.rim])), 1));
  view.ghost = new LineSegments(ghost, new LineBasicMaterial({ color: 0x888888 }));
  view.ghost.frustumCulled = false;
  world.add(view.ghost);
  view.mesh = scene.count <= 6000;
  visible(view);
}

/** Arrays of the own nodes of a part, and the node of the wall whose sideways motion each node at the rim of the surface follows (−1: its own). */
function placed(scene, part, wall) {
  const { own } = part;
  const local = new Int32Array(scene.count).fill(-1);
  own.forEach((node, i) => { local[node] = i; });
  const rest = new Float32Array(3 * own.length);
  own.forEach((node, i) => rest.set(scene.nodes.subarray(3 * node, 3 * node + 3), 3 * i));
  const follow = new Int32Array(own.length).fill(-1);
  if (wall) for (const node of new Set(part.rim)) follow[local[node]] = beside(scene, node, wall.own);
  const changing = (size) => new BufferAttribute(new Float32Array(size * own.length), size).setUsage(DynamicDrawUsage);
  return { local, follow, attributes: { position: new BufferAttribute(rest, 3), moved: changing(3), level: changing(1) } };
}

/** The nearest of some nodes, −1 where none is near. */
function beside({ nodes, size }, node, among) {
  let best = -1;
  let least = (0.04 * size) ** 2;
  for (const other of among) {
    const [x, y, z] = [nodes[3 * other] - nodes[3 * node], nodes[3 * other + 1] - nodes[3 * node + 1], nodes[3 * other + 2] - nodes[3 * node + 2]];
    const distance = x * x + y * y + z * z;
    if (distance < least) [least, best] = [distance, other];
  }
  return best;
}

function geometry({ attributes, local }, index) {
  const made = new BufferGeometry();
  for (const [name, attribute] of Object.entries(attributes)) made.setAttribute(name, attribute);
  const Kind = attributes.position.count < 65_536 ? Uint16Array : Uint32Array;
  made.setIndex(new BufferAttribute(Kind.from(index, (node) => local[node]), 1));
  return made;
}

function visible(view) {
  for (const { id, surface, lines, edge, shown } of view.parts.values()) {
    surface.visible = shown;
    lines.visible = shown && view.mesh;
    edge.visible = shown && !view.mesh && id !== 'surface';
  }
  request(view);
}

function setCut(view, cut) {
  for (const part of view.parts.values()) {
    part.cut = cut === 'all' || (cut === 'wall' && part.id === 'wall');
    for (const made of [part.surface.material, part.lines.material]) cutHalf(made, part.cut);
  }
  request(view);
}

/** The bottom of a whole tank is not seen from above the liquid; it is as many triangles as the surface. */
function hideBottom({ parts, camera, scene, mesh }) {
  const [bottom, surface, wall] = ['bottom', 'surface', 'wall'].map((id) => parts.get(id));
  if (!bottom) return;
  const covered = surface?.shown && wall?.shown && !surface.cut && !wall.cut && camera.position.z > scene.high[2];
  bottom.surface.visible = bottom.shown && !covered;
  bottom.lines.visible = bottom.surface.visible && mesh;
}

/** Colours of the page, light or dark. */
function recolour(view) {
  view.world.background = new Color(colour('--scene-sky'));
  const raw = (target, variable) => {
    const [r, g, b] = (colour(variable).match(/[\d.]+/g) ?? [128, 128, 128]).map(Number);
    target.setRGB(r / 255, g / 255, b / 255, 'srgb-linear');
  };
  for (const { id, plain, ink } of view.parts.values()) {
    raw(plain.value, id === 'surface' || id === 'liquid' ? '--scene-liquid' : id === 'bottom' ? '--scene-bottom' : '--scene-wall');
    raw(ink.value, '--scene-ink');
  }
  view.ghost.material.color.set(colour('--scene-ghost'));
  request(view);
}

/** Shows the moment `time`: the frames before and after it, mixed. The processor mixes: software rendering is slow with 16-bit attributes. */
function setTime(view, time) {
  const { scene } = view;
  if (!scene.frames) return;
  const after = Math.min(Math.max(lower(scene.times, time), 1), scene.frames - 1);
  const before = Math.max(0, after - 1);
  const span = scene.times[after] - scene.times[before];
  view.share = span > 0 ? Math.min(Math.max((time - scene.times[before]) / span, 0), 1) : 0;
  view.shape = null;
  if (view.frame !== before) {
    view.frame = before;
    values(view);
  }
  move(view);
  if (view.field) mixed(view);
  request(view);
}

/** Shows a mode or a moment: `shape` are displacements of all nodes, drawn so that the largest component is `amplitude`. */
function setShape(view, shape, amplitude) {
  if (view.shape !== shape) {
    view.most = 0;
    for (let i = 0; i < shape.length; i += 1) view.most = Math.max(view.most, Math.abs(shape[i]));
    view.shape = shape;
    view.frame = -1;
  }
  view.amplitude = amplitude;
  move(view);
  request(view);
}

/** Displacements of all parts: of a shape, or of two frames. */
function move(view) {
  const { scene, shape, frame, share } = view;
  const apart = scene.apart ?? null;
  const wall = view.parts.get('wall')?.times ?? 1;
  if (!shape && frame < 0) return;
  const size = scene.nodes.length;
  const data = shape ?? scene.displacement;
  const after = Math.min(frame + 1, scene.frames - 1);
  // Factors of nodes, and of those of the surface alone.
  const drawn = view.most > 0 ? view.amplitude / view.most : 0;
  const scales = [scene.scale, scene.surfaceScale ?? scene.scale];
  const before = scales.map((scale) => (shape ? drawn : scale[frame] * (1 - share)));
  const then = scales.map((scale) => (shape ? 0 : scale[after] * share));
  const from = shape ? 0 : frame * size;
  const to = shape ? 0 : after * size;
  for (const one of view.parts.values()) {
    if (!one.shown) continue;
    const { part: { own }, follow, attributes: { moved } } = one;
    const out = moved.array;
    const times = shape ? 1 : one.times;
    for (let i = 0; i < own.length; i += 1) {
      const beside = follow[i] < 0 ? own[i] : follow[i];
      const sideways = 3 * beside;
      const factor = shape || follow[i] < 0 ? times : wall;
      const across = apart ? apart[beside] : 0;
      const up = apart ? apart[own[i]] : 0;
      out[3 * i] = factor * (before[across] * data[from + sideways] + then[across] * data[to + sideways]);
      out[3 * i + 1] = factor * (before[across] * data[from + sideways + 1] + then[across] * data[to + sideways + 1]);
      out[3 * i + 2] = times * (before[up] * data[from + 3 * own[i] + 2] + then[up] * data[to + 3 * own[i] + 2]);
    }
    moved.needsUpdate = true;
  }
}

/** Colours the parts by a field; null takes the colours away. Returns the scale for the legend. */
function setField(view, field) {
  view.field = field;
  for (const part of view.parts.values()) part.coloured.value = field && (field.part === part.id || field.part === '') ? 1 : 0;
  if (field) {
    apply(view, scaleOf(field.low, field.high));
  }
  if (view.frame >= 0) {
    values(view);
    mixed(view);
  }
  request(view);
  return field ? view.scale : null;
}

function apply(view, scale) {
  view.shared.low.value = scale.low;
  view.shared.high.value = scale.high;
  scale.colours.forEach((c, i) => view.shared.colours.value[i].set(...c));
  view.scale = scale;
}

/** Values of the field at the frames before and after the moment. */
function values(view) {
  const { field, scene, frame } = view;
  if (!field || frame < 0) return;
  const after = Math.min(frame + 1, scene.frames - 1);
  if (field.of) {
    field.of(scene, frame, view.before);
    field.of(scene, after, view.after);
  } else {
    fieldAt(field, frame, view.before);
    fieldAt(field, after, view.after);
  }
}

function mixed(view) {
  const { parts, before, after, share } = view;
  let [low, high] = [0, 0];
  for (const { part: { own }, coloured, shown, attributes: { level } } of parts.values()) {
    if (!shown || !coloured.value) continue;
    for (let i = 0; i < own.length; i += 1) {
      const value = before[own[i]] + share * (after[own[i]] - before[own[i]]);
      level.array[i] = value;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    level.needsUpdate = true;
  }
  if (view.ownRange && view.field) apply(view, scaleOf(low, high));
}

function look(view, name) {
  const { scene, camera, controls } = view;
  const direction = VIEWS[name] ?? VIEWS.axonometric;
  const length = Math.hypot(...direction);
  const fit = (0.45 * scene.size) / Math.tan((camera.fov * Math.PI) / 360) / Math.min(1, camera.aspect);
  for (const [i, axis] of ['x', 'y', 'z'].entries()) {
    controls.target[axis] = (scene.low[i] + scene.high[i]) / 2;
    camera.position[axis] = controls.target[axis] + (fit * direction[i]) / length;
  }
  camera.near = scene.size / 500;
  camera.far = scene.size * 50;
  camera.updateProjectionMatrix();
  controls.update();
  request(view);
}

const seen = new Vector3();

/** Turns by angles [rad]. */
function turn(view, around, over) {
  const { camera, controls } = view;
  seen.copy(camera.position).sub(controls.target);
  const distance = seen.length();
  const theta = Math.atan2(seen.y, seen.x) + around;
  const phi = Math.min(Math.PI - 0.01, Math.max(0.01, Math.acos(seen.z / distance) + over));
  camera.position.set(Math.sin(phi) * Math.cos(theta), Math.sin(phi) * Math.sin(theta), Math.cos(phi)).multiplyScalar(distance).add(controls.target);
  controls.update();
}

function nearer(view, factor) {
  const { camera, controls } = view;
  camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
  controls.update();
}

function listen(view) {
  const { canvas, host } = view;
  view.resize = new ResizeObserver(() => size(view));
  view.resize.observe(host);
  size(view);
  let down = null;
  canvas.addEventListener('pointerdown', (event) => { down = [event.clientX, event.clientY]; });
  canvas.addEventListener('pointerup', (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
    const box = canvas.getBoundingClientRect();
    view.calls.picked(picked(view, ((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2));
  });
  canvas.addEventListener('webglcontextlost', (event) => { event.preventDefault(); view.calls.lost(); });
  canvas.addEventListener('webglcontextrestored', () => request(view));
}

function size(view) {
  const [width, height] = [view.host.clientWidth, view.host.clientHeight];
  if (width < 2 || height < 2) return;
  const aspect = view.camera.aspect;
  view.renderer.setPixelRatio(view.ratio);
  view.renderer.setSize(width, height, false);
  view.camera.aspect = width / height;
  view.camera.updateProjectionMatrix();
  if (Math.abs(aspect - view.camera.aspect) > 0.3) look(view, 'axonometric');
  draw(view);
}

/** Draws once before the next paint; a moving scene draws itself. */
function request(view) {
  if (view.pending || view.moving) return;
  view.pending = requestAnimationFrame(() => {
    view.pending = 0;
    draw(view);
  });
}

function draw(view) {
  const start = performance.now();
  hideBottom(view);
  view.renderer.render(view.world, view.camera);
  if (view.moving) adapt(view, start);
}

/** Lowers the resolution while the picture moves where frames take too long; a picture at rest is sharp again. */
function adapt(view, now) {
  const frame = now - view.last;
  view.last = now;
  if (!(frame > 0) || frame > 500) return;
  view.average = view.average ? view.average + 0.25 * (frame - view.average) : frame;
  view.since += 1;
  if (view.since < 6) return;
  const wanted = view.average > SLOW || view.average < FAST ? view.ratio * Math.sqrt(AIM / view.average) : view.ratio;
  const bounded = Math.min(view.best, Math.max(LEAST, wanted));
  view.since = 0;
  if (bounded === LEAST && view.ratio === LEAST && view.average > SLOW && !view.coarse) coarsen(view, true);
  if (Math.abs(bounded / view.ratio - 1) < 0.05) return;
  view.ratio = bounded;
  view.average = 0;
  view.renderer.setPixelRatio(bounded);
}

/** Draws fewer triangles, where the lowest resolution is still too slow, or all of them. */
function coarsen(view, coarse) {
  view.coarse = coarse;
  view.average = 0;
  for (const one of view.parts.values()) {
    one.fine ??= one.surface.geometry;
    if (one.coarse === undefined) {
      const triangles = coarser(one.part, view.scene.nodes, view.scene.size);
      one.coarse = triangles && geometry(one, triangles);
    }
    one.surface.geometry = coarse && one.coarse ? one.coarse : one.fine;
  }
}

function begin(view) {
  view.moving = true;
  view.last = performance.now();
  view.since = 0;
  view.average = 0;
  if (view.slow) view.renderer.setPixelRatio(view.ratio = view.slow);
  if (view.slowest) coarsen(view, true);
}

function rest(view) {
  if (!view.moving) return;
  view.moving = false;
  view.slow = view.ratio;
  view.slowest = view.coarse;
  if (view.coarse) coarsen(view, false);
  view.ratio = view.best;
  view.renderer.setPixelRatio(view.best);
  request(view);
}

const point = new Vector3();

/** Place of a node on the screen [px], as drawn now; `out` gets x, y and whether it is in front. */
function project(view, node, out) {
  let drawn = null;
  for (const one of view.parts.values()) if (!drawn && one.shown && one.local[node] >= 0) drawn = one;
  out.front = Boolean(drawn);
  if (!drawn) return;
  place(drawn, node, point);
  point.project(view.camera);
  out.x = ((point.x + 1) / 2) * view.host.clientWidth;
  out.y = ((1 - point.y) / 2) * view.host.clientHeight;
  out.front = point.z < 1;
}

/** Directions of x, y and z on the screen. */
function axes(view) {
  const { camera } = view;
  camera.updateMatrixWorld();
  return [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => {
    point.set(...axis).transformDirection(camera.matrixWorldInverse);
    return [point.x, -point.y, point.z];
  });
}

function destroy(view) {
  view.moving = false;
  cancelAnimationFrame(view.pending);
  view.resize.disconnect();
  view.controls.dispose();
  for (const one of view.parts.values()) for (const shape of [one.fine, one.coarse]) shape?.dispose();
  for (const object of [...view.world.children]) {
    object.geometry.dispose();
    object.material.dispose();
  }
  view.renderer.dispose();
  view.renderer.forceContextLoss();
  view.canvas.remove();
}
