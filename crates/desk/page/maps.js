// Maps over the developed wall: cracks, plastic strain, stresses of bars, pressure; of a nonlinear run and of the three-dimensional engine.

import { h, fill } from './dom.js';
import { add, t, localised } from './words.js';
import { significant, unitFor, largest, withUnit, display } from './display.js';
import { titled } from './titles.js';
import { gradient, scaleOf } from './colours.js';
import { savePng, fileName } from './save.js';

add({
  'map-none': ['This result holds no maps.', 'Dieses Ergebnis enthält keine Karten.'],
  'map-cracks': ['Cracks', 'Risse'],
  'map-no-cracks': ['none', 'keine'],
  'map-crack-state': ['{title}, {face}', '{title}, {face}'],
  'map-crack-note': [
    'Lines lie along the cracks; the thickest are the widest, {width}.',
    'Linien liegen in Richtung der Risse; die dicksten sind die breitesten, {width}.',
  ],
  'map-place': ['{column}, z = {z}: {value}', '{column}, z = {z}: {value}'],
  'map-label': ['{title} over the developed wall, largest {value}', '{title} über der abgewickelten Wand, größter Wert {value}'],
});

/** Whether there are maps. */
export const hasMaps = (results) => (results.runs ?? []).some((run) => run.nonlinear?.maps?.length || run.fields?.maps?.length);

/** The tab of maps: `{element, repaint(), destroy()}`. */
export function maps(results, settings) {
  const found = (results.runs ?? []).flatMap((run) => [...ofCells(run.nonlinear), ...ofNodes(run.fields)]);
  const states = (results.runs ?? []).flatMap((run) => run.nonlinear?.cracks ?? []);
  const select = h(
    'select',
    { onchange: () => cards.forEach((card) => card.draw()) },
    h('option', { value: '' }, t('map-no-cracks')),
    states.map(({ title, face }, i) =>
      h('option', { value: String(i) }, t('map-crack-state', { title: titled(title, settings.language), face: titled(face, settings.language) })),
    ),
  );
  const note = h('span.hint');
  const chosen = () => {
    const state = states[Number(select.value)] ?? null;
    const shown = select.value === '' ? null : state;
    note.textContent = shown
      ? t('map-crack-note', { width: display(largest(shown.cracks.map((crack) => crack.width)), 'length', settings.units) })
      : '';
    return shown;
  };
  const cards = found.map((map) => card(map, settings, chosen));
  const tools = states.length ? h('div.look-line', {}, h('label.scene-field', {}, h('span', {}, t('map-cracks')), select), note) : null;
  const element = h(
    'div',
    {},
    tools,
    h(
      'div.profile-charts',
      {},
      cards.map((one) => one.element),
    ),
  );
  const sizes = new ResizeObserver(() => cards.forEach((one) => one.draw()));
  sizes.observe(element);
  return { element, repaint: () => cards.forEach((one) => one.draw()), destroy: () => sizes.disconnect() };
}

/** Maps of cells, row by row from the base. */
function ofCells(run) {
  if (!run?.maps?.length) return [];
  const { columns, z } = run.grid;
  const edges = columns.edges ?? columns.names.map((_, i) => i).concat(columns.names.length);
  const count = edges.length - 1;
  return run.maps.map((map) => ({ ...map, edges, names: columns.names, heights: z, cells: true, at: (i, j) => map.values[j * count + i] }));
}

/** Maps of nodes, θ by θ; each value stands for what is nearest to it. */
function ofNodes(fields) {
  return (fields?.maps ?? []).map((map) => ({
    ...map,
    edges: between(map.theta),
    heights: between(map.z),
    cells: false,
    at: (i, j) => map.values[i * map.z.length + j],
  }));
}

function between(places) {
  const last = places.length - 1;
  return [places[0], ...places.slice(1).map((place, i) => (place + places[i]) / 2), places[last]];
}

function card(map, settings, cracks) {
  const title = titled(map.title, settings.language);
  const unit = unitFor(largest(map.values), map.dimension, settings.units);
  const finite = map.values.filter(Number.isFinite);
  const scale = scaleOf(Math.min(...finite), Math.max(...finite));
  const text = (value) => withUnit(significant(value / unit.factor, 3), unit);
  const canvas = h('canvas.map-canvas', { role: 'img', 'aria-label': t('map-label', { title, value: text(largest(map.values)) }) });
  const live = h('output.chart-at');
  const bar = h('div.scene-bar');
  bar.style.background = gradient(scale.colours);
  const marks = [1, 0.5, 0].map((share) => h('span', {}, significant((scale.low + share * (scale.high - scale.low)) / unit.factor, 3)));
  const png = h(
    'button.quiet',
    { type: 'button', title: t('chart-png-long'), 'aria-label': t('chart-png-long'), onclick: () => savePng(fileName(title, 'png'), canvas) },
    t('chart-png'),
  );
  const columns = map.names ?? [degrees(map.edges[0]), degrees(map.edges.at(-1))];
  const element = h(
    'section.chart',
    {},
    h('header.chart-head', {}, h('h4', {}, title, unit.symbol ? ` [${unit.symbol}]` : ''), live, h('div.chart-tools', {}, png)),
    h('div.map-body', {}, canvas, h('div.scene-scale', {}, bar, h('div.scene-marks', {}, marks))),
    h(
      'div.map-ends',
      {},
      columns.map((column) => h('span', {}, column)),
    ),
    map.note ? h('p.hint', {}, titled(map.note, settings.language)) : null,
  );
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    const across = map.edges[0] + ((event.clientX - box.left) / box.width) * (map.edges.at(-1) - map.edges[0]);
    const up = map.heights[0] + (1 - (event.clientY - box.top) / box.height) * (map.heights.at(-1) - map.heights[0]);
    const [i, j] = [within(map.edges, across), within(map.heights, up)];
    live.textContent = t('map-place', {
      column: map.names?.[i] ?? degrees(across),
      z: display(up, 'length', settings.units),
      value: text(map.at(i, j)),
    });
  };
  canvas.addEventListener('pointermove', place);
  canvas.addEventListener('pointerleave', () => fill(live));
  return { element, draw: () => draw(canvas, map, scale, map.cells ? cracks() : null) };
}

const degrees = (angle) => `θ = ${localised(((angle * 180) / Math.PI).toFixed(0))}°`;
const within = (edges, value) =>
  Math.max(
    0,
    Math.min(
      edges.length - 2,
      edges.findLastIndex((edge) => edge <= value),
    ),
  );

function colourAt({ low, high, colours }, value) {
  const at = Math.min(1, Math.max(0, (value - low) / (high - low))) * (colours.length - 1);
  const i = Math.min(colours.length - 2, Math.floor(at));
  const mixed = colours[i].map((part, k) => Math.round(255 * (part + (at - i) * (colours[i + 1][k] - part))));
  return `rgb(${mixed.join(' ')})`;
}

function draw(canvas, map, scale, state) {
  const ratio = Math.min(2, devicePixelRatio);
  const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
  if (width < 2) return;
  Object.assign(canvas, { width, height });
  const ink = canvas.getContext('2d');
  const span = (edges) => edges.at(-1) - edges[0];
  const x = (i) => ((map.edges[i] - map.edges[0]) / span(map.edges)) * width;
  const y = (j) => height - ((map.heights[j] - map.heights[0]) / span(map.heights)) * height;
  for (let i = 0; i + 1 < map.edges.length; i += 1) {
    for (let j = 0; j + 1 < map.heights.length; j += 1) {
      ink.fillStyle = colourAt(scale, map.at(i, j));
      const [left, top] = [Math.floor(x(i)), Math.floor(y(j + 1))];
      ink.fillRect(left, top, Math.ceil(x(i + 1)) - left, Math.ceil(y(j)) - top);
    }
  }
  if (!state) return;
  const widest = largest(state.cracks.map((crack) => crack.width)) || 1;
  const count = map.edges.length - 1;
  ink.strokeStyle = '#d01f3c';
  for (const { cell, angle, width: wide } of state.cracks) {
    const [i, j] = [cell % count, Math.floor(cell / count)];
    const [cx, cy] = [(x(i) + x(i + 1)) / 2, (y(j) + y(j + 1)) / 2];
    const half = 0.45 * Math.min(x(i + 1) - x(i), 2 * (y(j) - y(j + 1)));
    ink.lineWidth = ratio * (0.4 + (2.6 * wide) / widest);
    ink.beginPath();
    ink.moveTo(cx - half * Math.cos(angle), cy + half * Math.sin(angle));
    ink.lineTo(cx + half * Math.cos(angle), cy - half * Math.sin(angle));
    ink.stroke();
  }
}
