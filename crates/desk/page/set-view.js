// A set of records: made from chosen records, shown with its records, and what its rule says.

import { choice, fill, h, labelled } from './dom.js';
import { reading } from './reading.js';
import { keeping } from './record-keep.js';
import { drawRule } from './set-rule.js';
import { t } from './words.js';

const RULES = [['', 'set-rule-site'], ['en1998-1', 'EN 1998-1:2004 3.2.3.1.2(4)'], ['asce7-16', 'ASCE/SEI 7-16 chapter 16']];
const DESIGN = [['', 'set-combine-rule'], ['mean', 'set-mean'], ['worst', 'set-worst']];
const titled = (pairs) => pairs.map(([id, words]) => [id, t(words)]);

/* New */

/** Shows the form of a new set of these records; `done(path)` is called when it is saved. */
export function editSet(room, paths, done) {
  const records = room.files.filter((file) => file.kind === 'record').map((file) => file.path);
  const fields = {
    name: h('input', { value: t('set-name-of', { count: paths.length }) }),
    file: h('input.mono', { value: freeName(room), spellcheck: 'false' }),
    rule: choice(titled(RULES), ''),
    combine: choice(titled(DESIGN), ''),
    factor: h('input', { inputmode: 'decimal', placeholder: '1' }),
    fit: h('input', { type: 'checkbox' }),
  };
  const rows = paths.map((path) => componentsRow(path, records));
  const form = h('form.panel.stack', { onsubmit: (event) => { event.preventDefault(); save(room, fields, rows, done); } },
    h('h2', {}, t('set-new')), h('p.hint', {}, t('set-hint')),
    h('div.set-fields', {}, labelled(t('set-name'), fields.name), labelled(t('set-file'), fields.file), labelled(t('set-rule'), fields.rule),
      labelled(t('set-combine'), fields.combine), labelled(t('set-factor'), fields.factor)),
    h('label.tick', {}, fields.fit, t('set-fit')),
    h('h3', {}, t('set-records')), h('ul.set-paths', {}, paths.map((path) => h('li', {}, path))),
    h('details', {}, h('summary', {}, t('set-components')), h('div.scroll', {}, h('table', {},
      h('thead', {}, h('tr', {}, ['set-along', 'set-across', 'set-up'].map((id) => h('th', { scope: 'col' }, t(id))))),
      h('tbody', {}, rows.map((row) => row.element))))),
    h('div.row', {}, h('button.primary', {}, t('set-save'))));
  fill(room.detail, form);
  fields.name.select();
  return { close() {} };
}

function componentsRow(path, records) {
  const pairs = [['', t('set-no-component')], ...records.filter((one) => one !== path).map((one) => [one, one])];
  const across = choice(pairs, '', { 'aria-label': `${t('set-across')}: ${path}` });
  const up = choice(pairs, '', { 'aria-label': `${t('set-up')}: ${path}` });
  return { path, across, up, element: h('tr', {}, h('td', {}, path), h('td', {}, across), h('td', {}, up)) };
}

function freeName(room) {
  const there = new Set(room.files.map((file) => file.path));
  let name = 'set.json';
  for (let i = 2; there.has(name); i += 1) name = `set-${i}.json`;
  return name;
}

async function save(room, fields, rows, done) {
  const { desk } = room;
  // A set has no keys for what only the command line can say of a record.
  const special = rows.find((row) => reading(row.path).skip_lines || reading(row.path).columns);
  if (special) return void desk.say(t('set-special', { path: special.path }), 'error');
  const path = fields.file.value.trim();
  if (!path.endsWith('.json') || path.startsWith('/') || path.split('/').includes('..')) return void desk.say(t('set-bad-name'), 'error');
  const set = { name: fields.name.value.trim() || undefined, code: fields.rule.value || undefined, combine: fields.combine.value || undefined };
  const factor = Number(fields.factor.value.trim().replace(',', '.') || 1);
  if (!(factor > 0)) {
    fields.factor.setAttribute('aria-invalid', 'true');
    return void fields.factor.focus();
  }
  if (factor !== 1) set.factor = factor;
  if (fields.fit.checked) set.fit = true;
  set.records = rows.map((row) => entry(path, row));
  try {
    await desk.api.put('file', { path, text: setText(set), was: null });
    await done(path);
  } catch (error) {
    if (error.status === 409) desk.say(t('set-exists', { path }), 'error');
    else desk.sayError(error);
  }
}

/** A record of set.json; files are relative to the set file. */
function entry(setPath, row) {
  const { units, dt, channel } = reading(row.path);
  const along = relative(setPath, row.path) + (channel ? `#${channel}` : '');
  return {
    along, across: row.across.value ? relative(setPath, row.across.value) : undefined, up: row.up.value ? relative(setPath, row.up.value) : undefined, units, dt,
  };
}

/** The text of a set, a record a line. */
function setText(set) {
  const { records, ...rest } = set;
  const head = Object.entries(rest).filter(([, value]) => value !== undefined).map(([key, value]) => `  ${JSON.stringify(key)}: ${JSON.stringify(value)},\n`);
  const lines = records.map((record) => `    ${JSON.stringify(record).replaceAll('":', '": ').replaceAll(',"', ', "').replace(/^\{/, '{ ').replace(/\}$/, ' }')}`);
  return `{\n${head.join('')}  "records": [\n${lines.join(',\n')}\n  ]\n}\n`;
}

/** The path `to` as it is written in the file `from`. */
export function relative(from, to) {
  const here = from.split('/').slice(0, -1);
  const there = to.split('/');
  while (here.length && there.length > 1 && here[0] === there[0]) {
    here.shift();
    there.shift();
  }
  return [...here.map(() => '..'), ...there].join('/');
}

/** A path that is written in the file `from`, from the folder; null where it leaves the folder. */
export function resolved(from, path) {
  const parts = from.split('/').slice(0, -1);
  for (const part of path.split('/')) {
    if (part === '..') {
      if (!parts.length) return null;
      parts.pop();
    } else if (part !== '.' && part !== '') parts.push(part);
  }
  return parts.join('/');
}

/* One set */

/** Shows a set; returns what the room calls on changes. */
export function showSet(room, path) {
  const view = { room, desk: room.desk, path, closed: false, charts: [], run: null };
  view.runs = ({ detail }) => followRun(view, detail);
  view.desk.events.addEventListener('runs', view.runs);
  draw(view);
  return {
    close() {
      view.closed = true;
      view.desk.events.removeEventListener('runs', view.runs);
      for (const chart of view.charts) chart.destroy();
    },
    repaint: () => view.charts.forEach((chart) => chart.repaint()),
    folderChanged() { if (!view.run) loadRule(view); },
  };
}

async function draw(view) {
  const { room, desk, path } = view;
  fill(room.detail);
  let set;
  try {
    const { text } = await desk.api.get('file', { path });
    if (view.closed) return;
    set = JSON.parse(text);
  } catch (error) {
    if (!view.closed) fill(room.detail, h('p.empty', {}, t('set-bad', { path, message: error.message })));
    return;
  }
  view.set = set;
  view.rule = h('section.panel.stack');
  fill(room.detail,
    h('header.rec-head', {}, h('div', {}, h('h1', {}, set.name ?? path), h('p.hint', {}, path)),
      h('div.row', {}, keeping(room, path), h('button', { type: 'button', onclick: () => desk.go('runs', { kind: 'set', set: path }) }, t('set-run')))),
    h('div.stack', {}, view.rule, h('section.panel.stack', {}, options(set), recordsTable(view))));
  await loadRule(view);
}

function options(set) {
  const name = (pairs, value) => t(pairs.find(([id]) => id === (value ?? ''))?.[1] ?? String(value));
  return h('dl.facts', {},
    h('dt', {}, t('set-rule')), h('dd', {}, name(RULES, set.code)),
    h('dt', {}, t('set-combine')), h('dd', {}, name(DESIGN, set.combine)),
    set.factor !== undefined ? [h('dt', {}, t('set-factor')), h('dd', {}, String(set.factor))] : null,
    set.fit ? [h('dt', {}, t('set-factor')), h('dd', {}, t('set-fit'))] : null);
}

function recordsTable(view) {
  const records = Array.isArray(view.set.records) ? view.set.records : [];
  const used = ['along', 'across', 'up'].filter((id) => records.some((record) => record?.[id]));
  const cell = (text) => {
    if (typeof text !== 'string') return h('td', {}, '–');
    const path = resolved(view.path, text.split('#')[0]);
    const there = path !== null && view.room.files.some((file) => file.path === path);
    return h('td', {}, there ? h('button.link', { type: 'button', onclick: () => view.desk.go('records', { path }) }, text) : text);
  };
  return h('div.scroll', {}, h('table', {}, h('thead', {}, h('tr', {}, used.map((id) => h('th', { scope: 'col' }, t(`set-${id}`))))),
    h('tbody', {}, records.map((record) => h('tr', {}, used.map((id) => cell(record?.[id])))))));
}

/* Its rule */

const ruleFolder = (path) => `${path.replace(/\.json$/, '')}-rule`;

async function loadRule(view) {
  view.turn = (view.turn ?? 0) + 1;
  const { turn } = view;
  const result = view.room.results.find((one) => one.path === ruleFolder(view.path));
  const file = view.room.files.find((one) => one.path === view.path);
  let results = null;
  if (result) {
    try {
      results = await view.desk.api.get('results', { path: result.path });
    } catch { /* It can be computed again. */ }
  }
  if (view.closed || !view.rule || view.turn !== turn) return;
  for (const chart of view.charts) chart.destroy();
  view.charts = [];
  const found = results?.record_set ? results : null;
  fill(view.rule, h('div.row.spread', {}, h('h2', {}, t('set-rule')),
    h('button', { type: 'button', class: found ? '' : 'primary', onclick: () => checkRule(view) }, t(found ? 'set-again' : 'set-check'))));
  if (!found) return;
  const { chart } = await import('./charts.js');
  if (view.turn === turn) view.charts = drawRule(view.rule, found, view.desk, chart, { created: result.modified, changed: file?.modified });
}

async function checkRule(view) {
  const { desk } = view;
  const tank = desk.document?.path ?? await whichTank(view);
  if (!tank) return;
  try {
    const { id } = await desk.api.post('runs', {
      command: 'compare', arguments: [tank, '--set', view.path, '--fe', 'none', '--no-report', '--out', ruleFolder(view.path)], out: ruleFolder(view.path),
    });
    view.run = id;
    fill(view.rule, h('h2', {}, t('set-rule')), h('p.hint', { role: 'status' }, t('set-checking', { tank })), h('progress'));
    followRun(view, await desk.api.get('runs'));
  } catch (error) {
    desk.sayError(error);
  }
}

/** The tank whose site and periods the rule asks for, where none is open. */
async function whichTank({ desk, room }) {
  const tanks = room.files.filter((file) => file.kind === 'tank').map((file) => file.path);
  if (!tanks.length) desk.say(t('set-needs-tank'), 'warning');
  return tanks.length > 1 ? desk.ask(t('set-which-tank'), tanks) : tanks[0] ?? null;
}

async function followRun(view, runs) {
  const run = Array.isArray(runs) && view.run !== null ? runs.find((one) => one.id === view.run) : null;
  if (!run || run.state === 'waiting' || run.state === 'running') return;
  view.run = null;
  if (run.code === 2 || run.code === 3 || run.state === 'cancelled') {
    await loadRule(view);
    view.rule.append(h('p.fails', {}, t('set-check-failed')), h('pre.rec-fault', {}, run.output.join('\n')));
    return;
  }
  const { files, results } = await view.desk.api.get('folder');
  Object.assign(view.room, { files, results });
  await loadRule(view);
}
