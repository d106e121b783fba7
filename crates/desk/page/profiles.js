// Profiles over the height (the methods and the engines in one chart each) and response spectra.

import { h } from './dom.js';
import { add, t } from './words.js';
import { titled } from './titles.js';
import { joined } from './series.js';
import { chart, createGroup } from './charts.js';
import { methodName } from './summary.js';

add({
  'profile-none': ['This result holds no profiles.', 'Dieses Ergebnis enthält keine Profile.'],
  'profile-under': ['Under', 'Unter'],
  'profile-height': ['Height', 'Höhe'],
  'profile-static': ['{engine}, at rest', '{engine}, in Ruhe'],
  'profile-with-static': ['With the state at rest', 'Mit dem Ruhezustand'],
  'profile-note': ['Seismic part, largest absolute value over time.', 'Seismischer Anteil, größter Absolutwert über die Zeit.'],
  'spectrum-period': ['Period', 'Periode'],
  'spectrum-title': ['Spectral acceleration', 'Spektralbeschleunigung'],
  'spectrum-none': ['This result holds no spectra.', 'Dieses Ergebnis enthält keine Spektren.'],
});

/** Ids that show the same quantity. */
const SAME = { pressure_dynamic: 'pressure' };

/** Profiles by quantity: `Map(id → {title, dimension, series: [{title, z, values, look}]})`; a method has the same look in all. */
export function profilesOf(results, excitation, settings, rest = false) {
  const found = new Map();
  const looks = new Map();
  const into = (id, profile, title, values) => {
    const key = SAME[id] ?? id;
    if (!looks.has(title)) looks.set(title, looks.size);
    const own = found.get(key) ?? { title: titled(profile.title, settings.language), dimension: profile.dimension, series: [] };
    own.series.push({ title, z: profile.z, values, look: looks.get(title) });
    found.set(key, own);
  };
  for (const run of excitation === 'record' ? (results.runs ?? []) : []) {
    const engine = t(`engine-${run.engine}`);
    for (const profile of run.envelopes ?? []) {
      into(
        profile.id,
        profile,
        engine,
        profile.min.map((low, i) => Math.max(Math.abs(low), Math.abs(profile.max[i]))),
      );
      const still = profile.static_ ?? profile.static;
      if (rest && still?.length) into(profile.id, profile, t('profile-static', { engine }), still);
    }
  }
  for (const method of results.methods ?? []) {
    if (method.excitation !== excitation) continue;
    for (const profile of method.profiles ?? []) into(profile.id, profile, methodName(method, settings.language), profile.values);
  }
  return found;
}

/** The tab of profiles: `{element, repaint(), destroy()}`. */
export function profiles(results, settings) {
  const kinds = ['record', 'site'].filter((kind) => profilesOf(results, kind, settings).size);
  if (!kinds.length) return { element: h('p.empty', {}, t('profile-none')), repaint() {}, destroy() {} };
  const charts = h('div.profile-charts');
  let drawn = [];
  const select = h(
    'select',
    { onchange: () => draw() },
    kinds.map((kind) => h('option', { value: kind }, t(`look-${kind}`))),
  );
  const rest = h('input', { type: 'checkbox', onchange: () => draw() });

  function draw() {
    for (const one of drawn) one.destroy();
    const group = createGroup();
    drawn = [...profilesOf(results, select.value, settings, rest.checked).values()].map(({ title, dimension, series }) => {
      const { heights, values } = joined(series);
      return chart(
        charts,
        {
          kind: 'profile',
          title,
          x: { title: t('profile-height'), values: heights, dimension: 'length' },
          y: { dimension },
          series: series.map(({ title: name, look }, i) => ({ title: name, look, values: values[i] })),
          height: 340,
        },
        settings,
        group,
      );
    });
  }

  queueMicrotask(draw);
  const tools = h(
    'div.look-line',
    {},
    h('label.scene-field', {}, h('span', {}, t('profile-under')), select),
    h('label.tick', {}, rest, t('profile-with-static')),
    h('span.hint', {}, t('profile-note')),
  );
  return {
    element: h('div', {}, tools, charts),
    repaint: () => drawn.forEach((one) => one.repaint()),
    destroy: () => drawn.forEach((one) => one.destroy()),
  };
}

/** The tab of spectra. */
export function spectra(results, settings) {
  const found = (results.spectra ?? []).filter((one) => one.period?.length && one.psa?.length);
  if (!found.length) return { element: h('p.empty', {}, t('spectrum-none')), repaint() {}, destroy() {} };
  const element = h('div');
  let drawn = null;
  queueMicrotask(() => {
    const { heights, values } = joined(found.map((one) => ({ z: one.period, values: one.psa })));
    drawn = chart(
      element,
      {
        title: t('spectrum-title'),
        x: { title: t('spectrum-period'), values: heights, dimension: 'time' },
        y: { dimension: 'acceleration' },
        logarithmic: heights[0] > 0,
        series: found.map((one, i) => ({ title: one.title, values: values[i] })),
        height: 360,
      },
      settings,
    );
  });
  return { element, repaint: () => drawn?.repaint(), destroy: () => drawn?.destroy() };
}
