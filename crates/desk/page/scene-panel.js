// The scene with its controls: what is coloured, exaggerated, cut, played; legend; the node that was clicked.

import { h, fill } from './dom.js';
import { t } from './words.js';
import './scene-words.js';
import { display, significant, unitFor, dimensionOf, withUnit } from './display.js';
import { titled } from './titles.js';
import { gradient } from './colours.js';
import { scaleOf } from './scene-data.js';
import { createView } from './scene.js';
import { createPlayer } from './player.js';
import { gapsOf } from './scene-gaps.js';
import { nodePanel } from './scene-node.js';
import { savePng, fileName } from './save.js';

/** Exaggerations: 1, 2, 5, 10, … */
const TIMES = [1, 2, 5].flatMap((digit) => [0, 1, 2, 3, 4, 5].map((power) => digit * 10 ** power)).sort((a, b) => a - b);
/** Displacement drawn over the size of the model that is aimed at. */
const AIM = 0.06;
/** Parts whose exaggeration is not chosen. */
const UNSAID = ['liquid', 'sides'];
/** Marks of the legend, from the top. */
const SHARES = [1, 0.75, 0.5, 0.25, 0];

/**
 * @param {object} scene of scene-data.js
 * @param {object} clock of clock.js
 * @param {{units: string, language: string}} settings
 * @param {string} name stem of saved files
 * @returns `{element, repaint(), destroy()}`
 * Errors: no WebGL.
 */
export function createScenePanel(scene, clock, settings, name) {
  const host = h('div.scene-host', { tabindex: '0', role: 'application', 'aria-label': t('scene-label') });
  const self = { scene, clock, settings, name, host, times: new Map(), shape: null, axes: h('div.scene-axes', { 'aria-hidden': 'true' }) };
  self.stated = h('p.scene-stated');
  self.fps = h('p.scene-fps', { 'aria-hidden': 'true' });
  self.legend = h('div.scene-legend', { hidden: true });
  self.node = h('div.scene-node', { hidden: true });
  self.dot = h('div.scene-dot', { hidden: true });
  self.view = createView(host, scene, {
    picked: (node) => pick(self, node),
    turned: () => turned(self),
    lost: () => {
      self.stated.textContent = t('scene-lost');
      self.player?.pause();
    },
  });
  host.append(self.legend, self.stated, self.fps, axesPicture(self), self.dot);
  self.player = createPlayer(clock, {
    times: scene.times,
    moving: (moving) => play(self, moving),
    frame: () => {
      self.view.draw();
      self.drawn += 1;
      follow(self);
    },
  });
  const tools = controls(self);
  self.element = h('div.scene', {}, h('div.scene-main', {}, host, self.player.element, remarks(self)), h('div.scene-side', {}, tools, self.node));
  for (const part of scene.parts) if (part.id !== 'sides') exaggerate(self, part, nice(part.most > 0 ? (AIM * scene.size) / part.most : 1, part));
  self.off = clock.on((time) => moment(self, time));
  if (scene.frames) moment(self, clock.time);
  else if (scene.modes.length) choose(self, 'mode:0');
  keys(self);
  turned(self);
  return {
    element: self.element,
    repaint: () => self.view.recolour(),
    play: () => self.player.play(),
    pause: () => self.player.pause(),
    get player() {
      return self.player;
    },
    destroy() {
      self.off();
      clearInterval(self.counting);
      self.chart?.destroy();
      self.player.destroy();
      self.view.destroy();
      self.element.remove();
    },
  };
}

/** What the pictures do not show. */
function remarks(self) {
  const { scene, player, clock, settings } = self;
  if (!scene.frames) return null;
  const seconds = (value) => display(value, 'time', settings.units);
  const gaps = gapsOf(scene);
  const said = [];
  if (gaps) {
    const words = { gap: seconds(gaps.gap), period: seconds(gaps.period) };
    const slowly = () => {
      clock.set(gaps.from, null);
      player.slow();
      player.play();
    };
    said.push(gaps.from === null ? h('p', {}, t('scene-gaps', words)) : h('p', {}, t('scene-gaps-but', { ...words, from: seconds(gaps.from), to: seconds(gaps.to) }), ' ',
      h('button.link', { type: 'button', onclick: slowly }, t('scene-gaps-show'))));
  }
  if (!scene.parts.some(({ id }) => id === 'surface')) said.push(h('p', {}, t('scene-no-surface')));
  return said.length ? h('div.hint.scene-remarks', {}, said) : null;
}

/** The free surface is not exaggerated where its true motion is seen. */
function nice(wanted, part) {
  const bounded = part.id === 'surface' && wanted < 5 ? 1 : wanted;
  return TIMES.findLast((times) => times <= bounded * 1.0001) ?? 1;
}

const named = (id) => t(`scene-${id}`);

function controls(self) {
  const { scene, view } = self;
  const tick = (text, on, act) => {
    const box = h('input', { type: 'checkbox', onchange: () => act(box.checked) });
    box.checked = on;
    return h('label.tick', {}, box, text);
  };
  const pick = (text, pairs, act) => {
    const select = h(
      'select',
      { onchange: () => act(select.value) },
      pairs.map(([value, title]) =>
        Array.isArray(title)
          ? h(
              'optgroup',
              { label: value },
              title.map(([id, one]) => h('option', { value: id }, one)),
            )
          : h('option', { value }, title),
      ),
    );
    return [h('label.scene-field', {}, h('span', {}, text), select), select];
  };
  const fields = [['', t('scene-plain')], ...allFields(self).map((field, i) => [String(i), field.title])];
  const [colour, colours] = pick(t('scene-colour'), fields, (value) => paint(self, value === '' ? null : allFields(self)[Number(value)]));
  const shapes = shapeChoices(self);
  const [shape] = pick(t('scene-shape'), shapes, (value) => choose(self, value));
  self.timed = [colours];
  const [cut] = pick(
    t('scene-cut'),
    ['none', 'wall', 'all'].map((id) => [id, t(`scene-cut-${id}`)]),
    (value) => view.setCut(value),
  );
  self.selects = new Map();
  const times = scene.parts
    .filter((part) => !UNSAID.includes(part.id))
    .map((part) => {
      const [label, select] = pick(
        t('scene-times', { part: named(part.id) }),
        TIMES.map((value) => [String(value), `× ${significant(value, 1)}`]),
        (value) => exaggerate(self, part, Number(value)),
      );
      self.selects.set(part.id, select);
      self.timed.push(select);
      return label;
    });
  const looks = ['axonometric', 'front', 'side', 'top'].map((id) => h('button', { type: 'button', onclick: () => view.look(id) }, t(`scene-${id}`)));
  const start = scene.fields.findIndex((field) => field.id === 'hoop_stress');
  if (scene.frames && scene.fields.length) {
    colours.value = String(Math.max(0, start));
    queueMicrotask(() => paint(self, allFields(self)[Math.max(0, start)]));
  }
  return h(
    'div.scene-tools',
    {},
    scene.modes.length || scene.moments.length ? shape : null,
    scene.frames ? colour : null,
    scene.frames ? times : null,
    cut,
    h(
      'span.scene-group',
      { role: 'group', 'aria-label': t('scene-parts') },
      scene.parts.map((part) => tick(named(part.id), part.id !== 'liquid', (on) => view.setShown(part.id, on))),
      tick(t('scene-mesh'), scene.count <= 6000, (on) => view.setMesh(on)),
      scene.frames
        ? tick(t('scene-bands'), false, (on) => {
            view.setBands(on ? 10 : 0);
          })
        : null,
      scene.frames ? tick(t('scene-own-range'), false, (on) => ownRange(self, on)) : null,
    ),
    h('span.scene-group', { role: 'group', 'aria-label': t('scene-view') }, looks),
    h('button', { type: 'button', onclick: () => picture(self) }, t('scene-picture')),
  );
}

/** Fields of the scene, and those that follow from the displacement. */
function allFields(self) {
  if (self.fields) return self.fields;
  const { scene, settings } = self;
  const most = Math.max(0, ...scene.parts.map((part) => part.most));
  const length = (scene_, frame, out) => {
    const from = frame * scene_.count * 3;
    const d = scene_.displacement;
    for (let i = 0, at = from; i < out.length; i += 1, at += 3)
      out[i] = Math.sqrt(d[at] * d[at] + d[at + 1] * d[at + 1] + d[at + 2] * d[at + 2]) * scaleOf(scene_, i)[frame];
  };
  const rise = (scene_, frame, out) => {
    for (let i = 0, at = frame * scene_.count * 3 + 2; i < out.length; i += 1, at += 3) out[i] = scene_.displacement[at] * scaleOf(scene_, i)[frame];
  };
  const surface = scene.parts.find(({ id }) => id === 'surface');
  const wall = scene.parts.find(({ id }) => id === 'wall');
  self.fields = scene.fields.map((field) => ({ ...field, title: titled(field.title, settings.language) }));
  if (surface)
    self.fields.push({ id: 'wave', title: t('scene-height'), unit: 'm', part: 'surface', low: -surface.most, high: surface.most, of: rise });
  self.fields.push({ id: 'motion', title: t('scene-motion'), unit: 'm', part: wall ? 'wall' : '', low: 0, high: wall?.most ?? most, of: length });
  return self.fields;
}

function shapeChoices(self) {
  const { scene, settings } = self;
  const hertz = (frequency) => display(frequency, 'frequency', 'si');
  const title = (mode) => (mode.kind ? t(`scene-${mode.kind}`, { number: mode.number, m: mode.harmonic }) : mode.title);
  const modes = scene.modes.map((mode, i) => [`mode:${i}`, t('scene-mode', { title: title(mode), frequency: hertz(mode.frequency) })]);
  const moments = scene.moments.map((one, i) => [
    `moment:${i}`,
    t('scene-moment', { title: one.title, time: display(one.time, 'time', settings.units) }),
  ]);
  return [
    ...(scene.frames ? [['history', t('scene-history')]] : []),
    ...(modes.length ? [[t('scene-modes'), modes]] : []),
    ...(moments.length ? [[t('scene-moments'), moments]] : []),
  ];
}

function choose(self, value) {
  const { scene, view, player, settings } = self;
  const [kind, index] = value.split(':');
  self.shape = kind === 'history' ? null : kind;
  for (const select of self.timed) select.disabled = Boolean(self.shape);
  const size = 0.05 * scene.size;
  if (kind === 'history') {
    player.oscillate(null);
    paint(self, self.painted ?? null);
    moment(self, self.clock.time);
    stated(self);
    return;
  }
  view.setField(null);
  self.legend.hidden = true;
  for (const part of scene.parts) view.setTimes(part.id, 1);
  if (kind === 'moment') {
    player.oscillate(null);
    view.setShape(scene.moments[index].displacement, size);
    self.stated.textContent = `${scene.moments[index].title}, ${display(scene.moments[index].time, 'time', settings.units)}`;
    return;
  }
  const mode = scene.modes[index];
  const wave = (seconds) => view.setShape(mode.displacement, size * Math.sin(Math.PI * seconds));
  player.oscillate(wave);
  view.setShape(mode.displacement, size);
  self.stated.textContent = t('scene-mode-drawn', {
    frequency: display(mode.frequency, 'frequency', 'si'),
    period: display(1 / mode.frequency, 'time', 'si'),
  });
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches && self.element?.isConnected) player.play();
}

function exaggerate(self, part, times) {
  self.times.set(part.id, times);
  // Side walls move as the wall does.
  if (part.id === 'wall' && self.scene.parts.some(({ id }) => id === 'sides')) self.times.set('sides', times);
  const select = self.selects.get(part.id);
  if (select) select.value = String(times);
  if (!self.shape) for (const [id, own] of self.times) self.view.setTimes(id, own);
  stated(self);
  follow(self);
}

function stated(self) {
  if (self.shape || !self.scene.frames) return;
  for (const [part, times] of self.times) self.view.setTimes(part, times);
  const list = [...self.times]
    .filter(([part]) => !UNSAID.includes(part))
    .map(([part, times]) => t('scene-times-of', { part: named(part), times: significant(times, 1) }));
  self.stated.textContent = t('scene-drawn', { list: list.join(', ') });
}

function moment(self, time) {
  if (self.shape) return;
  self.view.setTime(time);
  if (self.ownRange && self.painted && (!self.player.playing || performance.now() - (self.marked ?? 0) > 200)) {
    self.marked = performance.now();
    mark(self);
  }
  self.nodeAt?.(time);
  if (!self.player.playing) requestAnimationFrame(() => follow(self));
}

/** Colours by a field and its legend. */
function paint(self, field) {
  self.painted = field;
  self.view.setField(field);
  self.legend.hidden = !field;
  if (!field) return;
  self.bar = h('div.scene-bar');
  self.unit = h('span.scene-unit');
  self.marks = SHARES.map(() => h('span'));
  fill(self.legend, h('strong', {}, field.title), self.unit, h('div.scene-scale', {}, self.bar, h('div.scene-marks', {}, self.marks)));
  self.legend.title = field.at === 'cell' ? t('scene-averaged') : '';
  mark(self);
}

/** The legend spans the values of the moment, or those of the whole time. */
function ownRange(self, on) {
  self.ownRange = on;
  self.view.setOwnRange(on);
  if (self.painted) mark(self);
}

/** Numbers and colours of the legend for the present range. */
function mark(self) {
  const scale = self.view.scale();
  const { symbol, factor } = unitFor(Math.max(Math.abs(scale.low), Math.abs(scale.high)), dimensionOf(self.painted.unit), self.settings.units);
  self.unit.textContent = symbol;
  self.bar.style.background = gradient(scale.colours);
  SHARES.forEach((share, i) => {
    self.marks[i].textContent = significant((scale.low + share * (scale.high - scale.low)) / factor, 3);
  });
}

function play(self, moving) {
  self.view.setMoving(moving);
  clearInterval(self.counting);
  if (!moving) return;
  let since = performance.now();
  self.drawn = 0;
  self.counting = setInterval(() => {
    const now = performance.now();
    const fps = Math.round((self.drawn * 1000) / (now - since));
    const percent = Math.round((100 * self.view.ratio) / Math.min(2, devicePixelRatio));
    self.fps.textContent = t(self.view.coarse ? 'scene-fps-coarse' : percent < 100 ? 'scene-fps-less' : 'scene-fps', { fps, percent });
    self.host.dataset.fps = String(fps);
    self.drawn = 0;
    since = now;
  }, 1000);
}

/** The node that was clicked. */
function pick(self, node) {
  self.chosen = node;
  self.chart?.destroy();
  self.chart = null;
  self.nodeAt = null;
  self.node.hidden = node === null;
  self.dot.hidden = node === null;
  if (node === null) return;
  const made = nodePanel({
    scene: self.scene,
    fields: self.scene.frames ? allFields(self) : [],
    node,
    clock: self.clock,
    settings: self.settings,
    close: () => pick(self, null),
  });
  fill(self.node, made.element);
  self.chart = made;
  made.draw();
  self.nodeAt = made.at;
  follow(self);
}

const spot = { x: 0, y: 0, front: true };

/** Keeps the dot on its node. */
function follow(self) {
  if (self.chosen === null || self.chosen === undefined) return;
  self.view.project(self.chosen, spot);
  self.dot.hidden = !spot.front;
  self.dot.style.transform = `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`;
}

const SVG = 'http://www.w3.org/2000/svg';

/** Directions of x, y and z in the corner. */
function axesPicture(self) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '-34 -34 68 68');
  self.arrows = ['x', 'y', 'z'].map((axis) => {
    const line = document.createElementNS(SVG, 'line');
    const text = document.createElementNS(SVG, 'text');
    text.textContent = axis;
    svg.append(line, text);
    return { line, text };
  });
  self.axes.append(svg);
  return self.axes;
}

function turned(self) {
  if (!self.arrows || !self.view) return;
  self.view.axes().forEach(([x, y], i) => {
    const { line, text } = self.arrows[i];
    line.setAttribute('x2', String(22 * x));
    line.setAttribute('y2', String(22 * y));
    text.setAttribute('x', String(29 * x));
    text.setAttribute('y', String(29 * y + 4));
  });
  follow(self);
}

function keys(self) {
  self.element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = event.target.closest('button, select, input:not([type="range"])');
    if (event.key === ' ' && !typing) self.player.toggle();
    else if (event.target !== self.host) return;
    else if (event.key === ',') self.player.step(-1);
    else if (event.key === '.') self.player.step(1);
    else if (event.key.startsWith('Arrow'))
      self.view.turn({ ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key]);
    else if (event.key === '+' || event.key === '-') self.view.nearer(event.key === '+' ? 0.85 : 1 / 0.85);
    else return;
    event.preventDefault();
  });
}

/** The picture with what the legend says. */
function picture(self) {
  const source = self.view.picture();
  const canvas = h('canvas', { width: source.width, height: source.height });
  const draw = canvas.getContext('2d');
  draw.drawImage(source, 0, 0);
  const ratio = source.width / self.host.clientWidth;
  const style = getComputedStyle(self.host);
  draw.scale(ratio, ratio);
  draw.font = `12px ${style.fontFamily}`;
  draw.fillStyle = style.color;
  draw.fillText(
    `${self.stated.textContent}${self.shape ? '' : `; t = ${withUnit(significant(self.clock.time, 4), { symbol: 's' })}`}`,
    12,
    self.host.clientHeight - 12,
  );
  if (self.painted && !self.legend.hidden) legendInto(self, draw);
  savePng(fileName(self.name, 'png'), canvas);
}

function legendInto(self, draw) {
  const unit = self.legend.querySelector('.scene-unit').textContent;
  draw.fillText(`${self.painted.title} [${unit}]`, 12, 22);
  const scale = self.view.scale();
  const fade = draw.createLinearGradient(0, 186, 0, 32);
  scale.colours.forEach((c, i) => fade.addColorStop(i / 10, `rgb(${c.map((v) => Math.round(v * 255)).join(' ')})`));
  draw.fillStyle = fade;
  draw.fillRect(12, 32, 16, 154);
  draw.fillStyle = getComputedStyle(self.host).color;
  self.legend.querySelectorAll('.scene-marks span').forEach((mark, i) => draw.fillText(mark.textContent, 34, 40 + i * 37));
}
