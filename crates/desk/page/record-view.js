// One record: how it is read, its history, its numbers, its spectra beside those of the site.

import { choice, fill, h, labelled, spoken } from './dom.js';
import { nodeAt, plain } from './jsonc.js';
import { tongue, wording } from './marked.js';
import { marks } from './marks.js';
import { keeping } from './record-keep.js';
import { UNITS, reading, recordOf, setReading } from './reading.js';
import { show as display } from './units.js';
import { number, t } from './words.js';

/** Shows a record in the detail of the room; returns what the room calls on changes. */
export function showRecord(room, path) {
  const view = { room, desk: room.desk, path, charts: [], asked: null, answer: null, parts: {} };
  const { parts } = view;
  parts.head = h('header.rec-head');
  parts.body = h('div.stack');
  parts.spectra = h('section.panel.rec-spectra');
  fill(room.detail, parts.head, parts.body);
  drawHead(view);
  read(view);
  return {
    close() {
      view.asked?.abort();
      view.checked?.abort();
      for (const chart of view.charts) chart.destroy();
      view.charts = [];
    },
    used: () => drawHead(view),
    repaint() {
      if (view.stale) drawSpectra(view);
      for (const chart of view.charts) chart.repaint();
    },
    tankChanged() {
      view.stale = view.answer !== null;
      clearTimeout(view.timer);
      view.timer = setTimeout(() => { if (view.stale && room.visible) drawSpectra(view); }, 600);
    },
  };
}

function drawHead(view) {
  const { desk, path } = view;
  const used = desk.record?.path === path;
  const name = path.slice(path.lastIndexOf('/') + 1);
  const use = h('button.primary', { type: 'button', onclick: () => useIt(view) }, t('rec-use'));
  fill(view.parts.head, h('div', {}, h('h1', {}, name), path !== name ? h('p.hint', {}, path) : null),
    h('div.row', {}, keeping(view.room, path), !view.answer ? null : [
      used ? h('span.tag.holds', {}, t('rec-used')) : use,
      used ? h('button', { type: 'button', onclick: () => desk.setRecord(null) }, t('rec-unuse')) : null,
      h('button', { type: 'button', onclick: () => { useIt(view, true); desk.go('runs', { kind: 'compare' }); } }, t('rec-run'))]));
}

function useIt(view, quiet = false) {
  view.desk.setRecord(recordOf(view.path));
  if (!quiet) view.desk.say(t('rec-now-used', { name: view.path }), 'ok');
}

/** Reads the record; `asked` after an answer of the user. */
async function read(view, asked = false) {
  const { desk, path, parts } = view;
  view.asked?.abort();
  view.asked = new AbortController();
  fill(parts.body, h('p.empty', {}, t('rec-reading', { name: path })));
  try {
    view.answer = await desk.api.post('record', { ...recordOf(path), language: desk.settings.language }, { signal: view.asked.signal });
  } catch (error) {
    if (error.name === 'AbortError') return;
    view.answer = null;
    drawHead(view);
    drawFault(view, error, asked);
    return;
  }
  if (desk.record?.path === path) desk.setRecord(recordOf(path));
  drawHead(view);
  await draw(view);
}

/** Faults that an answer of the user mends, with the field that asks for it. */
const ASKED = { T0403: 'units', T0404: 'dt', T0406: 'channel' };
/** The same by the option that the help of a fault names. */
const OPTIONS = [[/--skip-lines/, 'skip'], [/--columns/, 'columns'], [/--dt/, 'dt'], [/--units/, 'units'], [/--channel/, 'channel']];

/** The fields that a fault asks for. */
function askedBy({ message, help }) {
  const said = `${message} ${help ?? ''}`;
  const own = ASKED[said.match(/\bT04\d\d\b/)?.[0]];
  return [...new Set([own, ...OPTIONS.filter(([option]) => option.test(said)).map(([, name]) => name)])].filter(Boolean);
}

function drawFault(view, error, asked) {
  const fields = askedBy(error);
  const [field] = fields;
  const form = readingForm(view, error.message, fields);
  fill(view.parts.body, h('section.panel.stack', {}, h('h2', {}, t(field ? 'rec-unclear' : 'rec-unreadable')), h('pre.rec-fault', { lang: 'en' }, faultText(error)),
    field ? form : h('details', {}, h('summary', {}, t('rec-how')), form)));
  if (asked && field) form.querySelector(`[name=${field}]`)?.focus();
}

/** The words of the readers without what only a terminal needs: the path, the count, the hint to `explain`. */
function faultText({ message, help }) {
  const told = message.split(/\n+error: \d+ faults? in /)[0].split('\n').filter((line) => !line.trim().startsWith('-->'));
  return [...told, help && !help.includes('tankcheck explain') ? help.trim() : null].filter(Boolean).join('\n');
}

/* Unit, time step, channel, columns, lines */

/** A form for what the file does not say; `fault` may list the channels, `wanted` are the fields that it asks for. */
function readingForm(view, fault = '', wanted = []) {
  const given = reading(view.path);
  const units = choice([['', t('rec-as-file')], ...UNITS.map((unit) => [unit, unit])], given.units ?? '', { name: 'units' });
  const dt = h('input', { name: 'dt', inputmode: 'decimal', value: given.dt ?? '', placeholder: t('rec-as-file') });
  const channels = channelsOf(fault);
  const channel = channels.length ? choice([['', '–'], ...channels], given.channel ?? '', { name: 'channel' })
    : h('input', { name: 'channel', value: given.channel ?? '', placeholder: t('rec-as-file'), title: t('rec-channel-hint') });
  const columns = h('input', { name: 'columns', value: given.columns ?? '', placeholder: t('rec-as-file'), spellcheck: 'false' });
  const skip = h('input', { name: 'skip', inputmode: 'numeric', value: given.skip_lines ?? '', placeholder: '0' });
  const refuse = (input, bad, words) => {
    input.setAttribute('aria-invalid', String(bad));
    if (!bad) return false;
    view.desk.say(t(words), 'error');
    input.closest('details')?.setAttribute('open', '');
    input.focus();
    return true;
  };
  const submit = (event) => {
    event.preventDefault();
    const [step, lines, which] = [dt.value.trim().replace(',', '.'), skip.value.trim(), columns.value.replace(/\s/g, '').replace(/;/g, ',').toLowerCase()];
    if (refuse(dt, step !== '' && !(Number(step) > 0), 'rec-bad-dt') || refuse(skip, lines !== '' && !/^\d{1,9}$/.test(lines), 'rec-bad-skip')
      || refuse(columns, which !== '' && !/^([1-9]\d{0,3}(,[1-9]\d{0,3})?|all)$/.test(which), 'rec-bad-columns')) return;
    setReading(view.path, {
      units: units.value, dt: step === '' ? null : Number(step), channel: channel.value.trim(), columns: which, skip_lines: Number(lines) || null,
    });
    read(view, true);
  };
  return h('form.rec-form', { onsubmit: submit }, labelled(t('rec-unit'), units), labelled(t('rec-dt'), dt),
    labelled(t('rec-channel'), channel), labelled(t('rec-columns'), columns, wanted.includes('columns') ? t('rec-columns-hint') : null),
    labelled(t('rec-skip'), skip, wanted.includes('skip') ? t('rec-skip-hint') : null), h('button.primary', {}, t('rec-read')),
    h('p.hint', {}, t('rec-how-hint')));
}

/** Channels that a fault lists: `found 1: N-S; 2: E-W`. */
function channelsOf(fault) {
  const listed = fault.match(/found (1: .*)/)?.[1] ?? '';
  return listed.split(';').map((text) => text.trim().match(/^(\d+): (.*)$/)).filter(Boolean).map(([, id, name]) => [id, `${id}: ${name}`]);
}

/* What was read */

async function draw(view) {
  const { parts, answer } = view;
  const history = h('div.rec-history');
  fill(parts.body, history, h('div.rec-two', {}, facts(view), parts.spectra));
  for (const chart of view.charts) chart.destroy();
  view.charts = [];
  try {
    const { chart } = await import('./charts.js');
    view.draw = chart;
    const drawn = chart(history, {
      title: t('rec-history'), kind: 'history', height: 200, x: { title: t('rec-time'), values: answer.time, dimension: 'time' },
      y: { title: t('rec-history'), dimension: 'acceleration' }, series: [{ title: answer.info.name, values: answer.acceleration }],
    }, view.desk.settings);
    const { significant_start: from, significant_duration: long } = answer.info;
    if (long > 0) marks(drawn, [{ x: from, title: '5 %' }, { x: from + long, title: '95 %' }]);
    view.charts.push(drawn);
  } catch (error) {
    console.error(error);
    fill(history, h('p.hint', {}, String(error.message)));
  }
  await drawSpectra(view);
}

const seconds = (value) => `${number(value, 3)} s`;

// What the tank file does to every record; a run does it too.
function scaled(view) {
  const { root } = view.desk.document ?? {};
  const value = (key) => plain(nodeAt(root, ['record', key]));
  const said = [value('scale_to') !== undefined && t('rec-scale-to', { value: value('scale_to') }), Number(value('scale_by') ?? 1) !== 1 && t('rec-scale-by', { value: value('scale_by') }),
    Number(value('time_factor') ?? 1) !== 1 && t('rec-time-factor', { value: value('time_factor') })].filter(Boolean);
  return said.join(', ');
}

function facts(view) {
  const { info } = view.answer;
  const system = view.desk.settings.units;
  const usable = view.answer.usable_period ?? info.usable_period_s;
  const gravity = `${number(info.pga_g, 3)} g`;
  const scaling = scaled(view);
  const rows = [
    ['rec-peak', `${display(info.pga, 'acceleration', system)} (${gravity})`],
    ...(scaling ? [['rec-scaling', scaling]] : []),
    ['rec-duration', t('rec-duration-of', { duration: seconds(info.duration), samples: info.samples, dt: seconds(info.dt) })],
    ['rec-usable', usable ? t('rec-usable-of', { period: `${number(usable, 3)} s`, frequency: `${number(info.low_cut_frequency_hz, 2)} Hz` }) : t('rec-usable-none')],
    ['rec-significant', t('rec-significant-of', { duration: seconds(info.significant_duration), start: seconds(info.significant_start) })],
    ['rec-pgv', display(info.pgv, 'velocity', system)],
    ['rec-pgd', display(info.pgd, 'length', system)],
    ['rec-arias', display(info.arias, 'velocity', system)],
    ['rec-cav', display(info.cav, 'velocity', system)],
    ['rec-format', info.format],
    ['rec-from', t('rec-unit-from', { unit: info.unit, source: info.unit_source })],
  ];
  if (info.channel) rows.push(['rec-channel', info.channel]);
  const asked = Object.keys(reading(view.path)).length > 0;
  return h('section.panel.stack', {},
    h('dl.facts', {}, rows.map(([id, text]) => [h('dt', {}, t(id)), h('dd', {}, spoken(text))])),
    view.answer.warnings?.map((warning) => h('p.open-state', { lang: tongue(warning) }, spoken(wording(warning)))),
    view.answer.notes?.length ? [h('h3', {}, t('rec-notes')), h('ul', {}, view.answer.notes.map((note) => h('li', { lang: tongue(note) }, spoken(wording(note)))))] : null,
    h('details', { open: asked }, h('summary', {}, t('rec-how')), readingForm(view)));
}

/* Spectra */

async function drawSpectra(view) {
  view.stale = false;
  const { parts, answer } = view;
  const results = await checkUnder(view);
  if (!parts.spectra.isConnected || view.answer !== answer) return;
  const own = view.charts.splice(1);
  for (const chart of own) chart.destroy();
  const all = results?.spectra ?? view.desk.document?.check?.results?.spectra ?? [];
  const scaled = all.filter((spectrum) => spectrum.id.startsWith('record'));
  const site = all.filter((spectrum) => !spectrum.id.startsWith('record'));
  fill(parts.spectra);
  const spectra = scaled.length ? [...scaled, ...site] : [ownSpectrum(answer), ...site];
  const periods = spectra[0].period;
  if (view.draw) {
    const drawn = view.draw(parts.spectra, {
      title: t('rec-spectrum'), kind: 'history', height: 260, logarithmic: true, x: { title: t('rec-period'), values: periods, dimension: 'time' },
      y: { title: t('rec-psa'), dimension: 'acceleration' },
      series: spectra.map((spectrum) => ({ title: spectrum.title, values: resampled(spectrum, periods) })),
    }, view.desk.settings);
    const usable = answer.usable_period;
    marks(drawn, [...periodsOf(results).filter(([, period]) => period).map(([id, period]) => ({ x: period, title: t(id) })),
      ...(usable ? [{ x: usable, title: t('rec-usable-mark') }] : [])]);
    view.charts.push(drawn);
  }
  parts.spectra.append(h('p.hint', {}, t(scaled.length && site.length ? 'rec-scaled' : scaled.length ? 'rec-unscaled' : 'rec-no-site')));
  if (results) parts.spectra.append(...atPeriods(view, results, scaled, site));
}

/** The check of the tank under this record: its spectra have the damping of the site's, scaled as the tank file says. */
async function checkUnder(view) {
  const { desk } = view;
  if (!desk.document?.text) return null;
  view.checked?.abort();
  view.checked = new AbortController();
  try {
    const { language, units } = desk.settings;
    const body = { text: desk.document.text, name: desk.document.path ?? undefined, record: recordOf(view.path), language, units };
    return (await desk.api.post('check', body, { signal: view.checked.signal })).results;
  } catch {
    return null;
  }
}

function ownSpectrum({ spectrum, info }) {
  return { title: t('rec-own', { name: info.name, damping: `${number(100 * (spectrum.damping ?? 0.05), 2)} %` }), period: spectrum.period, psa: spectrum.psa, damping: spectrum.damping };
}

/** Ordinates of a spectrum at other periods, linear over log T; null outside. */
export function resampled({ period, psa }, periods) {
  if (period === periods) return psa;
  let at = 0;
  return periods.map((wanted) => {
    while (at < period.length - 2 && period[at + 1] < wanted) at += 1;
    if (wanted < period[0] * 0.999 || wanted > period.at(-1) * 1.001) return null;
    const share = Math.log(wanted / period[at]) / Math.log(period[at + 1] / period[at]);
    return psa[at] + Math.min(1, Math.max(0, share)) * (psa[at + 1] - psa[at]);
  });
}

/** The periods of the tank [s], of the procedure that decides where it gives them. */
function periodsOf(results) {
  const methods = results?.methods ?? [];
  const decides = results?.verdict?.deciding?.[0]?.method;
  const found = methods.find((one) => one.id === decides && one.quantities?.sloshing_period) ?? methods.find((one) => one.quantities?.sloshing_period);
  return [['rec-impulsive', found?.quantities.impulsive_period?.value], ['rec-sloshing', found?.quantities.sloshing_period?.value]];
}

/** Sloshing has the least damping of the spectra, the impulsive motion the others. */
function matched(spectra, id) {
  const least = Math.min(...spectra.map((one) => one.damping));
  const found = spectra.filter((one) => (one.damping === least) === (id === 'rec-sloshing'));
  return found.length ? found : spectra;
}

/** A table: record and site at the impulsive and the sloshing period, each with the spectra of the same damping. */
function atPeriods(view, results, scaled, site) {
  const system = view.desk.settings.units;
  const periods = periodsOf(results);
  const rows = [];
  for (const [id, period] of periods) {
    if (!period) continue;
    for (const one of matched(scaled, id)) {
      const other = site.find((spectrum) => spectrum.damping === one.damping);
      if (!other) continue;
      const [mine] = resampled(one, [period]);
      const [design] = resampled(other, [period]);
      rows.push(h('tr', {}, h('th', { scope: 'row' }, t(id)), h('td.number', {}, `${number(period, 3)} s`), h('td.number', {}, `${number(100 * one.damping, 2)} %`),
        h('td.number', {}, display(mine, 'acceleration', system)), h('td.number', {}, display(design, 'acceleration', system)),
        h('td.number', {}, design ? number(mine / design, 3) : '–')));
    }
  }
  const head = ['rec-motion', 'rec-period', null, 'rec-of-record', 'rec-of-site', 'rec-ratio'];
  const parts = [];
  if (rows.length) {
    parts.push(h('h3', {}, t('rec-at-periods')), h('div.scroll', {}, h('table', {}, h('thead', {}, h('tr', {}, head.map((id, i) => h('th', { scope: 'col', class: i ? 'number' : '' }, id ? t(id) : 'ξ')))),
      h('tbody', {}, rows))));
  }
  const usable = view.answer.usable_period;
  const sloshing = periods[1][1];
  if (usable && sloshing > usable) parts.push(h('p.open-state', {}, t('rec-usable-short', { period: `${number(sloshing, 3)} s` })));
  const counts = results.verdict?.record?.counts;
  if (counts) {
    const count = counts.holds + counts.fails;
    parts.push(h('p', { class: counts.fails ? 'fails' : 'holds' },
      t('rec-under', { text: counts.fails ? t('rec-counts', { fails: counts.fails, count }) : t('rec-counts-hold', { count }) })));
  }
  return parts;
}
