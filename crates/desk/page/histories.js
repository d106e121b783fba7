// Histories of a result: choose some, one chart a dimension with linked cursors and zoom; of two results both in one chart.

import { h } from './dom.js';
import { add, t } from './words.js';
import { dimensionOf } from './display.js';
import { titled } from './titles.js';
import { chart, createGroup } from './charts.js';
import { lower } from './series.js';

add({
  'history-choose': ['Histories', 'Zeitverläufe'],
  'history-filter': ['Filter', 'Filter'],
  'history-none': ['This result holds no histories.', 'Dieses Ergebnis enthält keine Zeitverläufe.'],
  'history-pick': ['Choose histories in the list.', 'Wählen Sie Zeitverläufe in der Liste.'],
  'history-every': ['Of every {count} samples the smallest and the largest are shown.', 'Von je {count} Werten sind der kleinste und der größte gezeigt.'],
  'history-engine': ['{title}, {engine}', '{title}, {engine}'],
  'engine-harmonic': ['harmonic elements', 'harmonische Elemente'],
  'engine-solid': ['3-D elements', '3-D-Elemente'],
  'engine-nonlinear': ['nonlinear elements', 'nichtlineare Elemente'],
  'dim-dimensionless': ['Ratios', 'Verhältnisse'],
  'dim-length': ['Lengths', 'Längen'],
  'dim-velocity': ['Velocities', 'Geschwindigkeiten'],
  'dim-acceleration': ['Accelerations', 'Beschleunigungen'],
  'dim-angle': ['Rotations', 'Verdrehungen'],
  'dim-force': ['Forces', 'Kräfte'],
  'dim-moment': ['Moments', 'Momente'],
  'dim-stress': ['Stresses', 'Spannungen'],
  'dim-line_moment': ['Wall moments', 'Wandmomente'],
  'dim-line_force': ['Wall forces', 'Wandkräfte'],
  'dim-energy': ['Energies', 'Energien'],
});

const FIRST = ['ground_acceleration', 'wave_height_theta_0', 'base_shear', 'base_moment', 'overturning_moment'];

/** Columns of `api/series` as `[{name, title, dimension, values, peak}]`; title and peak `{value, time}` are those of results.json, where it has them. */
export function columnsOf(series, results, language) {
  const titles = new Map();
  const peaks = new Map();
  (results?.runs ?? []).forEach((run, number) => {
    for (const info of run.histories ?? []) {
      const title = titled(info.title, language);
      const name = number ? `${run.engine}_${info.id}` : info.id;
      if (Number.isFinite(info.peak)) peaks.set(name, { value: info.peak, time: info.time });
      titles.set(name, number ? t('history-engine', { title, engine: t(`engine-${run.engine}`) }) : title);
    }
  });
  return (series?.columns ?? []).map(({ name, unit }, i) => ({
    name,
    title: titles.get(name) ?? name.replaceAll('_', ' '),
    dimension: dimensionOf(unit),
    values: Float64Array.from(series.values[i], (v) => v ?? NaN),
    peak: peaks.get(name) ?? null,
  }));
}

/**
 * The tab of histories.
 *
 * @param {{label?: string, time: number[], columns: object[]}[]} sources one result, or two that are compared
 * @param {object} settings
 * @param {object} clock
 * @returns `{element, repaint(), destroy()}`
 */
export function histories(sources, settings, clock, every = 1) {
  const names = new Map();
  for (const { columns } of sources) for (const column of columns) if (!names.has(column.name)) names.set(column.name, column);
  if (!names.size) return { element: h('p.empty', {}, t('history-none')), repaint() {}, destroy() {} };
  const group = createGroup(clock);
  const chosen = new Set(FIRST.filter((name) => names.has(name)));
  if (!chosen.size) chosen.add([...names.keys()][0]);
  const charts = h('div.history-charts');
  let drawn = [];
  const rows = [...names.values()].map((column) => {
    const box = h('input', {
      type: 'checkbox',
      onchange: () => {
        if (box.checked) chosen.add(column.name);
        else chosen.delete(column.name);
        draw();
      },
    });
    box.checked = chosen.has(column.name);
    return { column, item: h('li', {}, h('label.tick', {}, box, column.title)) };
  });
  const filter = h('input', {
    type: 'search',
    placeholder: t('history-filter'),
    'aria-label': t('history-filter'),
    oninput: () => {
      const wanted = filter.value.trim().toLowerCase();
      for (const { column, item } of rows) item.hidden = Boolean(wanted) && !column.title.toLowerCase().includes(wanted);
    },
  });
  const list = h(
    'details.history-list',
    {},
    h('summary', {}, t('history-choose')),
    filter,
    h(
      'ul',
      {},
      rows.map(({ item }) => item),
    ),
    every > 1 ? h('p.hint', {}, t('history-every', { count: every })) : null,
  );
  list.open = !matchMedia('(max-width: 800px)').matches;

  function draw() {
    for (const one of drawn) one.destroy();
    const panels = new Map();
    for (const [name, column] of names) if (chosen.has(name)) panels.set(column.dimension, [...(panels.get(column.dimension) ?? []), column]);
    charts.replaceChildren();
    if (!panels.size) charts.append(h('p.empty', {}, t('history-pick')));
    drawn = [...panels].map(([dimension, columns]) => chart(charts, panel(sources, dimension, columns), settings, group));
  }

  const element = h('div.history', {}, list, charts);
  queueMicrotask(draw);
  return {
    element,
    repaint: () => drawn.forEach((one) => one.repaint()),
    destroy: () => drawn.forEach((one) => one.destroy()),
  };
}

function panel(sources, dimension, columns) {
  const title = columns.length <= 2 ? columns.map((column) => column.title).join('; ') : t(`dim-${dimension}`);
  const time = union(sources.map((source) => source.time));
  const series = columns
    .flatMap((column, k) =>
      sources.map((source, i) => {
        const own = source.columns.find((one) => one.name === column.name);
        const label = source.label ? `${column.title} (${source.label})` : column.title;
        // The other result has other colours and dashes.
        return (
          own && {
            title: label,
            peak: signed(own, source.time),
            look: sources.length > 1 ? 2 * k + 9 * i : k,
            values: sources.length > 1 ? onto(time, source.time, own.values) : own.values,
          }
        );
      }),
    )
    .filter(Boolean);
  return { title, x: { title: t('scene-time'), values: time, dimension: 'time' }, y: { dimension }, series, height: 210, sampled: true };
}

/** The peak of a history, between samples, with the sign of the samples beside it; null where the results have none. */
function signed({ peak, values }, time) {
  if (!peak) return null;
  const after = Math.min(lower(time, peak.time), time.length - 1);
  const [one, other] = [values[Math.max(0, after - 1)], values[after]];
  const near = Math.abs(one) > Math.abs(other) ? one : other;
  return { value: near < 0 ? -peak.value : peak.value, at: peak.time };
}

/** All times of several results, ascending. */
function union(lists) {
  if (lists.length === 1) return lists[0];
  const same = lists.every((list) => list.length === lists[0].length && list.every((value, i) => value === lists[0][i]));
  return same ? lists[0] : [...new Set(lists.flat())].sort((a, b) => a - b);
}

/** Values at other times, linear between samples; NaN outside. */
function onto(time, own, values) {
  if (time === own) return values;
  const out = new Float64Array(time.length).fill(NaN);
  let at = 0;
  for (let i = 0; i < time.length; i += 1) {
    while (at + 2 < own.length && own[at + 1] < time[i]) at += 1;
    if (time[i] < own[0] || time[i] > own[own.length - 1]) continue;
    const share = own.length > 1 ? (time[i] - own[at]) / (own[at + 1] - own[at]) : 0;
    out[i] = own.length > 1 ? values[at] + share * (values[at + 1] - values[at]) : values[0];
  }
  return out;
}
