// Curves of a pushover and of an incremental dynamic analysis.

import { h } from './dom.js';
import { t } from './words.js';
import './results-words.js';
import { chart } from './charts.js';

/** Whether there is a curve to draw. */
export const hasCurves = (data) => /^tankcheck-(push|ida)\//.test(String(data?.format));

/** The curves: `{element, repaint(), destroy()}`. */
export function curves(data, settings) {
  const element = h('div.profile-charts');
  const specs = data.format.startsWith('tankcheck-push') ? pushed(data) : grown(data);
  let drawn = [];
  queueMicrotask(() => {
    drawn = specs.map((spec) => chart(element, { kind: 'curve', height: 320, ...spec }, settings));
  });
  return { element, repaint: () => drawn.forEach((one) => one.repaint()), destroy: () => drawn.forEach((one) => one.destroy()) };
}

function pushed({ shells }) {
  const name = (i) => (i === 0 ? t('curve-perfect') : t('curve-imperfect', { number: i }));
  const against = (key) =>
    (shells ?? []).map((shell, i) => ({ title: name(i), x: shell.path.map((step) => step.top), values: shell.path.map((step) => step[key]) }));
  const x = { title: t('curve-top'), dimension: 'length' };
  return [
    { title: t('curve-capacity'), x, y: { title: t('curve-acceleration'), dimension: 'acceleration' }, series: against('acceleration') },
    { title: t('curve-moment'), x, y: { title: t('curve-moment'), dimension: 'moment' }, series: against('base_moment') },
  ];
}

function grown({ runs, moment }) {
  const records = new Map();
  for (const run of runs ?? []) records.set(run.record ?? '', [...(records.get(run.record ?? '') ?? []), run]);
  const against = (key, title, dimension) => ({
    title: t('curve-ida', { what: title }),
    x: { title, dimension },
    y: { title: t('curve-pga'), dimension: 'acceleration' },
    series: [...records]
      .map(([record, own]) => [record, own.filter((run) => Number.isFinite(run[key])).sort((a, b) => a.scale - b.scale)])
      .map(([record, own]) => ({ title: record || title, x: own.map((run) => run[key]), values: own.map((run) => run.pga) })),
  });
  return [
    against('wall_displacement', t('curve-wall'), 'length'),
    against('base_moment', t('curve-moment'), moment ?? 'moment'),
    against('wave', t('curve-wave'), 'length'),
  ];
}
