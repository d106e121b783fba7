// What the rule of a set says: numbers, and the spectra of the set beside its target.

import { h } from './dom.js';
import { marks } from './marks.js';
import { moment, number, t } from './words.js';

/** Appends the outcome of the rule to an element; returns the charts, made with `chart`. `times` may hold `created` and `changed` [s]. */
export function drawRule(element, results, desk, chart, times = {}) {
  const set = results.record_set;
  const rule = set.compatibility;
  if (!rule) return [];
  element.append(h('p', { class: `set-verdict ${rule.holds ? 'holds' : 'fails'}` }, t(rule.holds ? 'set-holds' : 'set-fails'), h('span.hint', {}, rule.clause)));
  const combine = { mean: 'set-mean', worst: 'set-worst' }[set.combine];
  const facts = [
    [t('set-count'), t('set-count-of', { count: set.records.length, fewest: rule.fewest_records })],
    rule.mean_zero_period_ratio !== undefined && [t('set-peaks'), number(rule.mean_zero_period_ratio, 3)],
    [t('set-factor-used'), number(set.factor ?? rule.factor, 4)],
    [t('set-design'), `${combine ? t(combine) : set.combine} (${set.clause})`],
  ].filter(Boolean);
  element.append(h('dl.facts', {}, facts.map(([name, value]) => [h('dt', {}, name), h('dd', {}, value)])), periodsTable(rule));
  if (times.created) {
    const late = times.changed > times.created;
    element.append(h('p', { class: late ? 'open-state' : 'hint' }, t('set-computed', { when: moment(times.created) }), late ? ` ${t('set-changed')}` : ''));
  }
  return charts(element, set, rule, desk, chart);
}

const motion = (which) => (which === 'impulsive' ? t('rec-impulsive') : which === 'sloshing' ? t('rec-sloshing') : String(which));

function periodsTable(rule) {
  const head = ['rec-motion', 'rec-period', 'set-range', 'set-share', 'set-where', 'set-result'];
  return h('div.scroll', {}, h('table', {}, h('thead', {}, h('tr', {}, head.map((id, i) => h('th', { scope: 'col', class: i && i < 5 ? 'number' : '' }, t(id))))),
    h('tbody', {}, rule.periods.map((one) => h('tr', {}, h('th', { scope: 'row' }, motion(one.which)), h('td.number', {}, `${number(one.period, 3)} s`),
      h('td.number', {}, `${number(one.range[0], 3)} … ${number(one.range[1], 3)} s`), h('td.number', {}, `${number(one.smallest_ratio, 3)} (${t('set-needs', { share: number(rule.share, 2) })})`),
      h('td.number', {}, `${number(one.at_period, 3)} s`), h('td', { class: one.holds ? 'holds' : 'fails' }, t(one.holds ? 'set-one-holds' : 'set-one-fails')))))));
}

function charts(element, set, rule, desk, chart) {
  const names = set.records.map((record) => record.id);
  return rule.periods.filter((one) => one.periods?.length).map((one) => {
    const place = h('div.set-chart');
    element.append(place);
    const drawn = chart(place, {
      title: t('set-spectrum-of', { which: motion(one.which), damping: `${number(100 * one.damping, 2)} %` }), kind: 'history', height: 240, logarithmic: true,
      x: { title: t('rec-period'), values: one.periods, dimension: 'time' }, y: { title: t('rec-psa'), dimension: 'acceleration' },
      series: [{ title: t('set-target'), values: one.target }, { title: t('set-mean-line'), values: one.mean },
        ...one.records.map((values, i) => ({ title: names[i] ?? String(i + 1), values }))],
    }, desk.settings);
    // Target and mean are what counts; the records stand behind them. The chart is first drawn after this.
    drawn.plot?.series.forEach((line, i) => { if (i) line.width = i < 3 ? 2.5 : 0.8; });
    marks(drawn, [{ x: one.period, title: `T = ${number(one.period, 3)} s` }]);
    return drawn;
  });
}
