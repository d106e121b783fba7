// The room Look: the results of the folder, one opened, two side by side.

import { h, fill } from './dom.js';
import { t, moment } from './words.js';
import './results-words.js';
import { loadScene } from './scene-load.js';
import { mount as mountViewer } from './viewer.js';
import { verdictBadge } from './summary.js';
import { comparison } from './results-compare.js';
import { curves, hasCurves } from './results-curves.js';

/** Results kept in memory, so that going back is at once. */
const KEPT = 4;
/** Forms of a report, with the options of `tankcheck report` that write them. */
const FORMS = [
  ['look-form-pdf', '--format', 'pdf'],
  ['look-form-xlsx', '--format', 'xlsx'],
  ['look-form-docx', '--format', 'docx'],
  ['look-form-interactive', '--interactive'],
];

/**
 * @param {HTMLElement} element
 * @param {object} desk of the shell
 * @returns `{show({path, with}), hide()}`
 */
export function mount(element, desk) {
  const room = { desk, list: [], path: null, beside: null, view: null, tab: null, data: new Map(), shown: false, turn: 0 };
  room.names = h('ul.look-list');
  room.head = h('div.look-head', { dataset: { area: '' } });
  room.body = h('div.look-body', { dataset: { area: '' } });
  room.side = h('details.look-side', { open: true, dataset: { area: '' } }, h('summary', {}, t('look-results')), room.names);
  fill(element, h('div.look', {}, room.side, h('div.look-main', {}, room.head, room.body)));
  desk.events.addEventListener('folder', () => (room.shown ? refresh(room) : (room.stale = true)));
  desk.events.addEventListener('settings', (event) => settings(room, event.detail));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => room.view?.repaint?.());
  desk.shortcut?.('Space', 'look-key-play');
  desk.shortcut?.('← → ↑ ↓', 'look-key-arrows');
  desk.shortcut?.('+ −', 'look-key-zoom');
  return {
    async show(args = {}) {
      room.shown = true;
      if (!room.list.length || room.stale) await refresh(room);
      const path = args.path ?? room.path ?? room.list[0]?.path ?? null;
      const beside = args.with ?? (args.path && args.path !== room.path ? null : room.beside);
      if (path !== room.path || beside !== room.beside || !room.view) await open(room, path, beside);
      else room.view.resume?.();
    },
    hide() {
      room.shown = false;
      room.view?.pause?.();
    },
  };
}

async function refresh(room) {
  room.stale = false;
  try {
    room.list = (await room.desk.api.get('folder')).results ?? [];
  } catch (error) {
    room.desk.sayError?.(error);
    return;
  }
  const now = entry(room, room.path);
  // A result that came meanwhile can be compared with.
  if (now && room.compared !== comparables(room).join('\n')) header(room, now);
  if (room.opened && now && stamp(now) !== room.opened) changed(room);
  names(room);
}

const entry = (room, path) => room.list.find((one) => one.path === path);
const stamp = (one) => `${one.created ?? ''}/${one.modified ?? ''}`;

function names(room) {
  fill(
    room.names,
    room.list.length
      ? room.list.map((one) =>
          h(
            'li',
            {},
            h(
              'button.look-name',
              {
                type: 'button',
                'aria-current': one.path === room.path ? 'true' : null,
                onclick: () => room.desk.go('look', { path: one.path }),
              },
              h('b', {}, one.path || '.'),
              h('span.look-kind', {}, kind(one)),
              one.name ? h('span.hint', {}, one.name) : null,
              h('span.look-when', {}, when(one), one.status ? verdictBadge(one.status) : null),
            ),
          ),
        )
      : h('li.empty', {}, t('look-no-results')),
  );
}

const when = (one) => (one.created ? moment(one.created) : '');

function kind(one) {
  const word = t(`look-kind-${one.kind}`);
  return word.startsWith('look-kind-') ? one.kind : word;
}

/** Says that the opened result was written again. */
function changed(room) {
  if (room.head.querySelector('.look-again')) return;
  room.head.append(
    h(
      'p.look-again',
      { role: 'status' },
      t('look-changed'),
      ' ',
      h(
        'button',
        {
          type: 'button',
          onclick: () => {
            room.data.delete(room.path);
            open(room, room.path, room.beside);
          },
        },
        t('look-reload'),
      ),
    ),
  );
}

function settings(room, { name } = {}) {
  if (name === 'theme') {
    room.view?.repaint?.();
    return;
  }
  names(room);
  room.side.querySelector('summary').textContent = t('look-results');
  if (room.path !== null) open(room, room.path, room.beside);
}

/** Calls for the data of a result, whose answers are kept for a while. */
function fetched(room, path) {
  const { api } = room.desk;
  let own = room.data.get(path);
  if (own) room.data.delete(path);
  else {
    const once = (call) => {
      let promise = null;
      return () =>
        (promise ??= call().catch((error) => {
          promise = null;
          throw error;
        }));
    };
    const none = (error) => {
      if (error.status === 404) return null;
      throw error;
    };
    own = {
      results: once(() => api.get('results', { path })),
      series: once(() =>
        entry(room, path)?.files?.includes('series.csv') === false ? Promise.resolve(null) : api.get('series', { path }).catch(none),
      ),
      // A scene is large and is read for each view.
      scene: async () => (entry(room, path)?.scene === false ? null : loadScene(`api/scene?${new URLSearchParams({ path })}`)),
    };
  }
  room.data.set(path, own);
  while (room.data.size > KEPT) room.data.delete(room.data.keys().next().value);
  return own;
}

async function open(room, path, beside) {
  room.turn += 1;
  const { turn } = room;
  room.view?.destroy?.();
  room.view = null;
  Object.assign(room, { path, beside });
  names(room);
  fill(room.head);
  if (path === null) {
    fill(room.body, h('p.empty', {}, t(room.list.length ? 'look-choose' : 'look-no-results')));
    return;
  }
  const own = entry(room, path);
  room.opened = own ? stamp(own) : null;
  if (matchMedia('(max-width: 900px)').matches) room.side.open = false;
  header(room, own);
  fill(room.body, h('p.empty', {}, t('look-loading')));
  try {
    const view = beside ? await twice(room, path, beside) : await single(room, path, turn);
    if (turn !== room.turn) view?.destroy?.();
    else room.view = view;
  } catch (error) {
    if (turn === room.turn) fill(room.body, h('p.empty', {}, error.message, error.help ? ` ${error.help}` : ''));
  }
}

const comparable = (one) => ['compare', 'check', 'set'].includes(one?.kind);
/** Paths of the results that the opened one can be compared with. */
const comparables = (room) => room.list.filter((one) => one.path !== room.path && comparable(one)).map((one) => one.path);

function header(room, own) {
  const others = comparables(room);
  room.compared = others.join('\n');
  const select = h(
    'select',
    { onchange: () => open(room, room.path, select.value || null) },
    h('option', { value: '' }, t('look-compare-none')),
    others.map((path) => h('option', { value: path }, path)),
  );
  select.value = room.beside ?? '';
  fill(
    room.head,
    h('h2', {}, room.path || '.'),
    own?.status ? verdictBadge(own.status) : null,
    own ? h('span.hint', {}, kind(own)) : null,
    comparable(own) && others.length ? h('label.scene-field', {}, h('span', {}, t('look-compare-with')), select) : null,
  );
}

async function single(room, path, turn) {
  const { desk } = room;
  const own = fetched(room, path);
  const data = await own.results();
  if (turn !== room.turn) return null;
  const address = (name, save = false) => desk.api.resultAddress(path, name, save);
  const report = address('report.html');
  const host = h('div');
  fill(room.body, host);
  if (!String(data?.format).startsWith('tankcheck-results/')) return foreign(room, host, data, report);
  const listed = entry(room, path)?.files ?? ['results.json', 'series.csv', 'report.html'];
  const figures = listed.filter((name) => name.endsWith('.svg'));
  const source = {
    results: own.results,
    series: own.series,
    scene: own.scene,
    report,
    forms: FORMS.map(([word, ...options]) => ({ title: t(word), make: () => make(room, path, options) })),
    files: listed.filter((name) => !name.endsWith('.svg')).map((name) => ({ name, address: address(name, true) })),
    ...(figures.length ? { figures: async () => figures.map((name) => ({ name, address: address(name) })) } : {}),
  };
  return mountViewer(host, source, {
    settings: desk.settings,
    tab: room.tab,
    onTab: (tab) => {
      room.tab = tab;
    },
  });
}

/** Starts the run that writes a form of the report into the folder of the result. */
async function make(room, path, options) {
  const { desk } = room;
  try {
    await desk.api.post('runs', { command: 'report', arguments: [path, ...options, '--lang', desk.settings.language], out: path });
    desk.say(t('look-making'), 'info', { title: t('look-to-runs'), act: () => desk.go('runs') });
  } catch (error) {
    desk.sayError(error);
  }
}

/** Push, IDA, study and others: their curves where there are some, and the report. */
function foreign(room, host, data, report) {
  const drawn = hasCurves(data) ? curves(data, room.desk.settings) : null;
  fill(
    host,
    drawn?.element,
    h(
      'div.look-report',
      {},
      h('p', {}, h('a', { href: report, target: '_blank', rel: 'noopener' }, t('look-open-report'))),
      h('iframe', { src: report, sandbox: 'allow-popups', title: t('look-tab-report') }),
    ),
  );
  return { repaint: () => drawn?.repaint(), destroy: () => drawn?.destroy() };
}

async function twice(room, path, beside) {
  const two = await Promise.all(
    [path, beside].map(async (one) => ({ label: one, results: await fetched(room, one).results(), series: fetched(room, one).series })),
  );
  if (two.some(({ results }) => !String(results?.format).startsWith('tankcheck-results/'))) throw new Error(t('look-not-comparable'));
  const made = comparison(two, room.desk.settings);
  fill(room.body, made.element);
  return made;
}
