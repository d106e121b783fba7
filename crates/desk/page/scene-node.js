// The place that was clicked: position, values now, history as a chart.

import { h, fill } from './dom.js';
import { t, localised } from './words.js';
import './scene-words.js';
import { display, dimensionOf } from './display.js';
import { historyAt, motionOf } from './scene-data.js';
import { chart, createGroup } from './charts.js';
import { nearest } from './series.js';

/**
 * @param {{scene, fields, node, clock, settings, close}} what
 * @returns `{element, draw(), at(time), destroy()}`
 */
export function nodePanel({ scene, fields, node, clock, settings, close }) {
  const [x, y, z] = scene.nodes.subarray(3 * node, 3 * node + 3);
  const length = (value) => display(Math.abs(value) < 1e-9 * scene.size ? 0 : value, 'length', settings.units);
  const angle = localised(((Math.atan2(y, x) * 180) / Math.PI).toFixed(1));
  const histories = scene.frames ? found(scene, fields, node, Math.atan2(y, x)) : [];
  const values = h('dl.scene-values');
  const host = h('div');
  const select = h(
    'select',
    { onchange: () => draw() },
    histories.map((one, i) => h('option', { value: String(i) }, one.title)),
  );
  let drawn = null;

  function draw() {
    drawn?.destroy();
    drawn = null;
    const one = histories[Number(select.value) || 0];
    if (!one) return;
    drawn = chart(
      host,
      {
        title: `${one.title}, ${t('scene-node', { node: node + 1 })}`,
        x: { title: t('scene-time'), values: scene.times, dimension: 'time' },
        y: { dimension: one.dimension },
        series: [{ title: one.title, values: one.values }],
        height: 160,
      },
      settings,
      createGroup(clock),
    );
  }

  function at(time) {
    const frame = nearest(scene.times, time);
    fill(
      values,
      histories.map((one) => h('div', {}, h('dt', {}, one.title), h('dd', {}, display(one.values[frame], one.dimension, settings.units)))),
    );
  }

  if (histories.length) at(clock.time);
  const element = h(
    'section.scene-node-inside',
    {},
    h('header', {}, h('h4', {}, t('scene-node', { node: node + 1 })), h('button.quiet', { type: 'button', onclick: close }, t('scene-close'))),
    h('p', {}, t('scene-place', { x: length(x), y: length(y), z: length(z), r: length(Math.hypot(x, y)), theta: `${angle}°` })),
    values,
    histories.length ? h('label.scene-field', {}, h('span', {}, t('scene-node-field')), select) : null,
    host,
  );
  return { element, draw, at, destroy: () => drawn?.destroy() };
}

function found(scene, fields, node, theta) {
  const [ux, uy, uz] = motionOf(scene, node);
  const radial = ux.map((value, i) => value * Math.cos(theta) + uy[i] * Math.sin(theta));
  const along = (axis, values) => ({ title: t('scene-along', { axis }), dimension: 'length', values });
  const own = fields
    .filter((field) => !field.of)
    .map((field) => ({ title: field.title, dimension: dimensionOf(field.unit), values: historyAt(scene, field, node) }));
  return [
    ...own.filter((one) => one.values),
    { title: t('scene-radial'), dimension: 'length', values: radial },
    along('x', ux),
    along('y', uy),
    along('z', uz),
  ];
}
