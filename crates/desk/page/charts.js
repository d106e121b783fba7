// Charts of histories, spectra, profiles and curves: a wrapper around uPlot with zoom, linked cursors, keyboard and saving.

import uPlot from './vendor/uplot.js';
import { h, colour } from './dom.js';
import { add, t, localised } from './words.js';
import { unitFor, largest, significant, withUnit } from './display.js';
import { nearest, peak, thinned } from './series.js';
import { saveCsv, savePng, fileName } from './save.js';

add({
  'chart-keys': ['Arrow keys move the cursor, Shift in larger steps, + and − zoom, Escape shows all, Enter sets the time of the scene.',
    'Pfeiltasten bewegen den Zeiger, mit Umschalt in größeren Schritten, + und − vergrößern und verkleinern, Escape zeigt alles, Eingabe setzt die Zeit der Szene.'],
  'chart-reset': ['Show all', 'Alles zeigen'],
  'chart-csv': ['CSV', 'CSV'],
  'chart-csv-long': ['Save the values as CSV', 'Werte als CSV sichern'],
  'chart-png': ['PNG', 'PNG'],
  'chart-png-long': ['Save the picture as PNG', 'Bild als PNG sichern'],
  'chart-peak': ['{value} at {at}', '{value} bei {at}'],
  'chart-sample': ['largest sample {value} at {at}', 'größter gespeicherter Wert {value} bei {at}'],
  'chart-hide': ['Show or hide {title}', '{title} zeigen oder verbergen'],
});

const COLOURS = 8;
const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3]];
const FONT = '12px system-ui, -apple-system, "Segoe UI", Roboto, "Liberation Sans", sans-serif';

/** Charts whose cursors and zoom move together. */
export function createGroup(clock = null) {
  return { charts: new Set(), clock };
}

/**
 * Draws a chart into an element.
 *
 * @param {HTMLElement} element
 * @param {object} spec `{title, x: {title, values, dimension}, y: {title?, dimension}, series: [{title, values, look?, peak?: {value, at}}], kind: 'history'|'profile'|'curve', height?,
 *   logarithmic?, scrub?, sampled?}`; values in SI; `look` is the number of a colour; with `sampled` a peak is called the largest sample where the series
 *   brings none. Of a profile x is the height and drawn upwards; of a curve each series has its own `x`.
 * @param {object} settings `{units}`
 * @param {object} group of `createGroup`
 * @returns `{element, show(x), clear(), zoom(from, to), repaint(), destroy()}`
 */
export function chart(element, spec, settings, group = createGroup()) {
  const state = prepare(spec, settings);
  const parts = frame(state);
  element.append(parts.root);
  const self = { element: parts.root, state, parts, group, plot: null, colours: [], zoomed: null };
  self.colours = palette(state.series);
  self.plot = new uPlot(options(self), data(self, state.from, state.to), parts.canvas);
  legend(self);
  listen(self);
  group.charts.add(self);
  Object.assign(self, {
    show: (x) => show(self, x),
    clear: () => clear(self),
    zoom: (from, to) => zoom(self, from, to),
    repaint() {
      self.colours = palette(state.series);
      paintLegend(self);
      self.plot.redraw();
    },
    destroy() {
      group.charts.delete(self);
      self.size.disconnect();
      self.off?.();
      self.plot.destroy();
      parts.root.remove();
    },
  });
  return self;
}

/** Units and ranges of a chart; curves are put on one list of x with gaps. */
function prepare(spec, settings) {
  const { x, y, series } = spec;
  const kind = spec.kind ?? 'history';
  const curve = kind === 'curve';
  const xs = curve ? series.flatMap((one) => Array.from(one.x)) : x.values;
  let offset = 0;
  const values = series.map((one) => {
    if (!curve) return one.values;
    const own = new Array(xs.length).fill(null);
    for (let i = 0; i < one.values.length; i += 1) own[offset + i] = one.values[i];
    offset += one.values.length;
    return own;
  });
  const xUnit = unitFor(largest(xs), x.dimension, settings.units);
  const yUnit = unitFor(Math.max(0, ...series.map((one) => largest(one.values))), y.dimension, settings.units);
  const finite = Array.from(xs).filter(Number.isFinite);
  return {
    spec, kind, settings, xs, values, xUnit, yUnit, series,
    from: curve ? Math.min(0, ...finite) : finite[0] ?? 0, to: curve ? Math.max(...finite) : finite[finite.length - 1] ?? 1,
    heading: spec.title, hidden: new Set(),
  };
}

function frame(state) {
  const canvas = h('div.chart-canvas');
  const tools = h('div.chart-tools');
  const names = h('ul.chart-legend');
  const live = h('output.chart-at');
  const root = h('section.chart', { tabindex: '0', role: 'group', 'aria-label': `${state.heading}. ${t('chart-keys')}` },
    h('header.chart-head', {}, h('h4', {}, state.heading), live, tools), canvas, names);
  return { root, canvas, tools, names, live };
}

/** Number of the colour and dash of a series: its own, or its place. */
const look = (one, i) => one.look ?? i;
const dashOf = (one, i) => Math.floor(look(one, i) / COLOURS) % DASHES.length;
const palette = (series) => series.map((one, i) => colour(`--series-${(look(one, i) % COLOURS) + 1}`));

function options(self) {
  const { state } = self;
  const profile = state.kind === 'profile';
  const label = (title, unit) => (unit.symbol ? `${title ?? ''} [${unit.symbol}]`.trim() : title ?? '');
  const axis = (more) => ({ stroke: () => colour('--soft'), grid: { stroke: () => colour('--line'), width: 1 }, ticks: { stroke: () => colour('--line'), width: 1, size: 4 }, font: FONT,
    labelFont: FONT, values: ticks, ...more });
  const xAxis = axis({ label: label(state.spec.x.title, state.xUnit), labelSize: 20, size: profile ? 56 : 26, side: profile ? 3 : 2 });
  const yAxis = axis({ label: label(state.spec.y.title, state.yUnit), labelSize: 20, size: profile ? 26 : 62, side: profile ? 2 : 3 });
  const whole = self.state.kind === 'curve';
  return {
    width: Math.max(240, self.parts.root.clientWidth || 600), height: state.spec.height ?? 220, padding: [8, 12, 0, 0], legend: { show: false },
    cursor: { drag: { x: state.kind === 'history', y: false, setScale: false }, focus: { prox: 30 }, points: { size: 7 }, x: true, y: state.kind !== 'history' },
    scales: {
      x: { time: false, ori: profile ? 1 : 0, distr: state.spec.logarithmic ? 3 : 1, range: whole ? wholeRange(self, 'x') : state.spec.logarithmic ? (plot, low, high) => [low, high] : undefined },
      y: { ori: profile ? 0 : 1, range: whole ? wholeRange(self, 'y') : undefined },
    },
    axes: [xAxis, yAxis],
    series: [{}, ...state.series.map((one, i) => ({
      label: one.title, stroke: () => self.colours[i], width: 1.5, dash: DASHES[dashOf(one, i)], points: { show: false }, spanGaps: false,
      ...(whole ? { paths: curvePath } : {}),
    }))],
    hooks: { setCursor: [(plot) => moved(self, plot)], setSelect: [(plot) => selected(self, plot)], drawAxes: [(plot) => zero(plot)] },
  };
}

/** Range of a whole curve with a margin. */
function wholeRange(self, scale) {
  return () => {
    const { state } = self;
    const columns = scale === 'x' ? [scaled(state.xs, state.xUnit)] : state.values.map((values) => scaled(values, state.yUnit));
    let low = 0;
    let high = 0;
    for (const values of columns) {
      for (const value of values) {
        if (value !== null && value < low) low = value;
        if (value !== null && value > high) high = value;
      }
    }
    const margin = (high - low || 1) * 0.04;
    return [low === 0 ? 0 : low - margin, high + margin];
  };
}

/** The path of a curve whose x may go back. */
function curvePath(plot, index) {
  const path = new Path2D();
  const [xs, ys] = [plot.data[0], plot.data[index]];
  let down = false;
  for (let i = 0; i < xs.length; i += 1) {
    if (ys[i] === null) { down = false; continue; }
    const [x, y] = [plot.valToPos(xs[i], 'x', true), plot.valToPos(ys[i], 'y', true)];
    if (down) path.lineTo(x, y);
    else path.moveTo(x, y);
    down = true;
  }
  return { stroke: path, fill: null, clip: null, band: null, gaps: null, flags: 1 };
}

/** Texts of the ticks: as many decimals as the step needs. */
function ticks(plot, splits, axis, space, step) {
  const logarithmic = plot.scales[plot.axes[axis].scale].distr === 3;
  return splits.map((value) => {
    if (value === null) return '';
    if (logarithmic) return localised(String(Number(value.toPrecision(2))));
    if (!(step > 0)) return significant(value, 2);
    if (Math.abs(value) >= 1e6 || (value !== 0 && step < 1e-5)) return localised(value.toExponential(1));
    return localised(value.toFixed(decimals(step)));
  });
}

/** Decimals that a step needs: 1 for 2.5. */
function decimals(step) {
  for (let count = 0; count < 8; count += 1) if (Math.abs(step * 10 ** count - Math.round(step * 10 ** count)) < 1e-6 * step * 10 ** count) return count;
  return 8;
}

/** A stronger line at y = 0. */
function zero(plot) {
  const { ctx, bbox } = plot;
  const across = plot.scales.y.ori === 1;
  if (!(plot.scales.y.min < 0 && plot.scales.y.max > 0)) return;
  const at = Math.round(plot.valToPos(0, 'y', true));
  ctx.save();
  ctx.strokeStyle = colour('--edge');
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  if (across) { ctx.moveTo(bbox.left, at); ctx.lineTo(bbox.left + bbox.width, at); }
  else { ctx.moveTo(at, bbox.top); ctx.lineTo(at, bbox.top + bbox.height); }
  ctx.stroke();
  ctx.restore();
}

const scaled = (values, unit) => Array.from(values, (value) => (value === null || Number.isNaN(value) ? null : value / unit.factor));

/** What uPlot draws between two x (SI): thinned and in the units of the chart. */
function data(self, from, to) {
  const { state } = self;
  const columns = state.kind === 'history' ? thinned(state.xs, state.values, from, to, Math.max(300, self.parts.canvas.clientWidth || 800)) : [state.xs, ...state.values];
  return columns.map((values, i) => scaled(values, i === 0 ? state.xUnit : state.yUnit));
}

/** Names with a switch each, the value under the cursor or the peak. */
function legend(self) {
  const { state, parts } = self;
  self.rows = state.series.map((one, i) => {
    const line = h('i.chart-line');
    const value = h('span.chart-value');
    const name = h('button.quiet.chart-name', { type: 'button', 'aria-pressed': 'true', title: t('chart-hide', { title: one.title }), onclick: () => toggle(self, i) }, line, one.title);
    parts.names.append(h('li', {}, name, value));
    return { line, value, name, peak: peakOf(state, one) };
  });
  const tool = (id, long, act) => h('button.quiet', { type: 'button', title: t(long), 'aria-label': t(long), onclick: act }, t(id));
  parts.reset = tool('chart-reset', 'chart-reset', () => zoomAll(self, null));
  parts.reset.hidden = true;
  parts.tools.append(parts.reset, tool('chart-csv', 'chart-csv-long', () => csv(self)), tool('chart-png', 'chart-png-long', () => png(self)));
  paintLegend(self);
  values(self, null);
}

/** The peak of a series `{value, at, sample}`: the one it brings, which may lie between samples, else its largest sample. */
function peakOf(state, one) {
  if (one.peak) return { ...one.peak, sample: false };
  const { at, value } = peak(Array.from(one.values, (v) => v ?? 0));
  return { value, at: (state.kind === 'curve' ? one.x : state.xs)[at], sample: Boolean(state.spec.sampled) };
}

function paintLegend(self) {
  self.rows.forEach(({ line }, i) => {
    line.style.borderTopColor = self.colours[i];
    line.style.borderTopStyle = ['solid', 'dashed', 'dotted', 'dashed'][dashOf(self.state.series[i], i)];
  });
}

function toggle(self, i) {
  const { hidden } = self.state;
  if (!hidden.delete(i)) hidden.add(i);
  self.rows[i].name.setAttribute('aria-pressed', String(!hidden.has(i)));
  self.plot.setSeries(i + 1, { show: !hidden.has(i) });
}

/** Values at an x (SI), or the peaks. */
function values(self, x) {
  const { state, parts } = self;
  const text = (value) => (value === null || value === undefined ? '–' : withUnit(significant(value / state.yUnit.factor, 4), state.yUnit));
  const place = (value, digits = 4) => withUnit(significant(value / state.xUnit.factor, digits), state.xUnit);
  self.rows.forEach((row, i) => {
    const one = state.series[i];
    const xs = state.kind === 'curve' ? one.x : state.xs;
    if (x === null) row.value.textContent = one.values.length ? t(row.peak.sample ? 'chart-sample' : 'chart-peak', { value: text(row.peak.value), at: place(row.peak.at, 3) }) : '–';
    else row.value.textContent = text(one.values[state.kind === 'curve' ? closest(xs, x) : nearest(xs, x)]);
  });
  parts.live.textContent = x === null ? '' : place(x);
}

function closest(xs, x) {
  let at = 0;
  for (let i = 1; i < xs.length; i += 1) if (Math.abs(xs[i] - x) < Math.abs(xs[at] - x)) at = i;
  return at;
}

/** The cursor of uPlot moved: values here, cursors of the others. */
function moved(self, plot) {
  if (self.quiet) return;
  const along = self.state.kind === 'profile' ? plot.cursor.top : plot.cursor.left;
  if (!(along >= 0)) {
    for (const one of self.group.charts) if (one !== self) one.clear?.();
    values(self, null);
    self.at = null;
    return;
  }
  const x = plot.posToVal(along, 'x') * self.state.xUnit.factor;
  self.at = x;
  values(self, x);
  for (const one of self.group.charts) if (one !== self && one.state.kind === self.state.kind) one.show?.(x);
}

/** Puts the cursor at x (SI). */
function show(self, x) {
  const { plot, state } = self;
  self.quiet = true;
  const along = plot.valToPos(x / state.xUnit.factor, 'x');
  plot.setCursor(state.kind === 'profile' ? { left: 1, top: along } : { left: along, top: 1 }, false);
  self.quiet = false;
  self.at = x;
  values(self, x);
}

function clear(self) {
  self.quiet = true;
  self.plot.setCursor({ left: -10, top: -10 }, false);
  self.quiet = false;
  self.at = null;
  values(self, null);
}

function selected(self, plot) {
  const { left, width } = plot.select;
  plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
  if (width < 4) return;
  const factor = self.state.xUnit.factor;
  zoomAll(self, [plot.posToVal(left, 'x') * factor, plot.posToVal(left + width, 'x') * factor]);
}

function zoomAll(self, range) {
  for (const one of self.group.charts) if (one.state.kind === self.state.kind) zoom(one, range?.[0], range?.[1]);
}

/** Shows x from … to … (SI); without arguments all. */
function zoom(self, from, to) {
  const { state, plot, parts } = self;
  if (state.kind !== 'history') return;
  const range = from === undefined || !(to > from) ? [state.from, state.to] : [Math.max(from, state.from), Math.min(to, state.to)];
  if (!(range[1] > range[0])) return;
  self.zoomed = range[0] > state.from || range[1] < state.to ? range : null;
  parts.reset.hidden = !self.zoomed;
  plot.batch(() => {
    plot.setData(data(self, ...range), false);
    plot.setScale('x', { min: range[0] / state.xUnit.factor, max: range[1] / state.xUnit.factor });
  });
  place(self);
}

/** Draws the moment of the clock. */
function place(self) {
  if (!self.marker) return;
  const along = self.plot.valToPos(self.group.clock.time / self.state.xUnit.factor, 'x');
  const inside = self.group.clock.time > self.state.from && along <= self.plot.over.clientWidth && along >= 0;
  self.marker.hidden = !inside;
  if (inside) self.marker.style.transform = `translateX(${along.toFixed(1)}px)`;
}

function listen(self) {
  const { plot, parts, state, group } = self;
  self.size = new ResizeObserver(() => {
    const width = Math.floor(parts.canvas.clientWidth);
    if (width < 40 || width === plot.width) return;
    plot.setSize({ width, height: plot.height });
    if (self.zoomed) zoom(self, ...self.zoomed);
    place(self);
  });
  self.size.observe(parts.canvas);
  parts.root.addEventListener('keydown', (event) => key(self, event));
  plot.over.addEventListener('dblclick', () => zoomAll(self, null));
  const { clock } = group;
  if (state.kind !== 'history' || !clock || state.spec.x.dimension !== 'time' || state.spec.logarithmic) return;
  self.marker = h('div.chart-now');
  plot.over.append(self.marker);
  let told = 0;
  self.off = clock.on(() => {
    // A marker that moves in every frame makes the browser compose the whole way from the scene to the chart.
    if (clock.playing && performance.now() - told < 100) return;
    told = performance.now();
    place(self);
  });
  requestAnimationFrame(() => place(self));
  scrub(self, clock);
}

/** A click sets the clock; with `scrub` dragging does, too, instead of zooming. */
function scrub(self, clock) {
  const { plot, state } = self;
  const set = (event) => {
    const box = plot.over.getBoundingClientRect();
    clock.set(plot.posToVal(Math.min(Math.max(event.clientX - box.left, 0), box.width), 'x') * state.xUnit.factor, self);
  };
  if (state.spec.scrub) {
    plot.cursor.drag.x = false;
    plot.over.classList.add('chart-scrub');
    plot.over.addEventListener('pointerdown', (event) => {
      plot.over.setPointerCapture(event.pointerId);
      set(event);
    });
    plot.over.addEventListener('pointermove', (event) => event.buttons === 1 && set(event));
    return;
  }
  let from = 0;
  plot.over.addEventListener('pointerdown', (event) => { from = event.clientX; });
  plot.over.addEventListener('pointerup', (event) => Math.abs(event.clientX - from) < 4 && set(event));
}

function key(self, event) {
  const { state, group } = self;
  if (event.ctrlKey || event.metaKey || event.altKey || (event.target !== self.element && event.target.closest('button'))) return;
  const { xs } = state;
  const up = state.kind === 'profile';
  const step = { [up ? 'ArrowUp' : 'ArrowRight']: 1, [up ? 'ArrowDown' : 'ArrowLeft']: -1 }[event.key];
  const [from, to] = self.zoomed ?? [state.from, state.to];
  const at = self.at ?? group.clock?.time ?? from;
  const go = (index) => {
    const x = xs[Math.max(0, Math.min(xs.length - 1, index))];
    for (const one of group.charts) if (one.state.kind === state.kind) one.show(x);
  };
  const stretch = (factor) => {
    const middle = Math.min(Math.max(at, from), to);
    zoomAll(self, [middle - (middle - from) * factor, middle + (to - middle) * factor]);
  };
  if (step && state.kind !== 'curve') go(nearest(xs, at) + step * (event.shiftKey ? Math.max(10, Math.round(xs.length / 50)) : 1));
  else if (event.key === 'Home') go(0);
  else if (event.key === 'End') go(xs.length - 1);
  else if (event.key === '+') stretch(0.5);
  else if (event.key === '-') stretch(2);
  else if (event.key === 'Escape') zoomAll(self, null);
  else if (event.key === 'Enter' && group.clock) group.clock.set(at, self);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

function csv(self) {
  const { state } = self;
  const head = (title, dimension) => `${title} [SI: ${unitFor(0, dimension, 'si').symbol || '1'}]`;
  const xOf = (values) => ({ head: head(state.spec.x.title, state.spec.x.dimension), values });
  const columns = state.kind === 'curve' ? state.series.flatMap((one) => [xOf(one.x), { head: head(one.title, state.spec.y.dimension), values: one.values }])
    : [xOf(state.xs), ...state.series.map((one) => ({ head: head(one.title, state.spec.y.dimension), values: one.values }))];
  saveCsv(fileName(state.heading, 'csv'), columns);
}

/** The picture with its title and legend. */
function png(self) {
  const { state, plot } = self;
  const source = plot.ctx.canvas;
  const ratio = source.width / plot.width;
  const shown = state.series.map((one, i) => ({ one, i })).filter(({ i }) => !state.hidden.has(i));
  const canvas = h('canvas', { width: source.width, height: source.height + Math.round((30 + shown.length * 18) * ratio) });
  const draw = canvas.getContext('2d');
  draw.fillStyle = colour('--panel');
  draw.fillRect(0, 0, canvas.width, canvas.height);
  draw.scale(ratio, ratio);
  draw.fillStyle = colour('--ink');
  draw.font = `600 13px ${FONT.slice(5)}`;
  draw.fillText(state.heading, 10, 18);
  draw.drawImage(source, 0, 26, plot.width, plot.height);
  draw.font = FONT;
  shown.forEach(({ one, i }, row) => {
    const y = 26 + plot.height + 10 + row * 18;
    draw.strokeStyle = self.colours[i];
    draw.lineWidth = 2;
    draw.setLineDash(DASHES[dashOf(one, i)]);
    draw.beginPath();
    draw.moveTo(14, y);
    draw.lineTo(38, y);
    draw.stroke();
    draw.fillText(`${one.title}: ${self.rows[i].value.textContent}`, 46, y + 4);
  });
  savePng(fileName(state.heading, 'png'), canvas);
}
