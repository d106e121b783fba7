// The shell: header, rooms, settings, keyboard, lost connection. Each room is a module of its own, loaded when it is first shown.

import { createApi } from './api.js';
import { nextArea } from './areas.js';
import { ask, say, sayError, show } from './dialogs.js';
import { choice, download, fill, h } from './dom.js';
import { drawBusy, watchRuns } from './run-watch.js';
import { keepSetting, readSettings } from './settings.js';
import './shell-words.js';
import { setLanguage, t } from './words.js';

/** Rooms in the order of the tabs. */
const ROOMS = [
  { id: 'tank', module: './tank.js' },
  { id: 'records', module: './records.js' },
  { id: 'runs', module: './runs.js' },
  { id: 'look', module: './results.js' },
];

const events = new EventTarget();
const api = createApi(events);
const rooms = new Map();
const keys = [];
let current = null;

const desk = {
  api,
  t,
  events,
  settings: readSettings(),
  /** Version, folder and tank file, as the server says. */
  info: { version: '', folder: '', tank: null },
  /** The text of tank.json: see document.js. Null where that module is missing. */
  document: null,
  /** The record for the checks and runs: `{path, units?, dt?, channel?}` or null. */
  record: null,
  /** Runs that wait or compute. */
  busy: 0,
  /** Goes to a room; `args` are passed to its `show`. */
  go,
  /** Opens another tank file; asks about unsaved text first. */
  openFile,
  say,
  sayError,
  ask,
  showDialog: show,
  /** Tells the shell of keys that a room handles itself, for the help. */
  shortcut(combination, words) { keys.push([combination, words]); },
  /** Sets the record for checks and runs, and dispatches `record`. */
  setRecord(record) {
    desk.record = record;
    keepRecord(record);
    events.dispatchEvent(new CustomEvent('record', { detail: record }));
  },
};

start();

async function start() {
  // What the first room needs is fetched while the server is asked.
  const opening = import('./document.js');
  const first = import(ROOMS.find((room) => location.hash.slice(1).split('/')[0] === room.id)?.module ?? ROOMS[0].module);
  for (const early of [opening, first]) early.catch(() => {});
  setLanguage(desk.settings.language);
  drawHeader();
  events.addEventListener('lost', (event) => drawLost(true, event.detail?.other));
  events.addEventListener('back', () => { drawLost(false); say(t('back'), 'ok'); });
  events.addEventListener('text', drawFile);
  events.addEventListener('record', drawFile);
  try {
    desk.info = await api.get('desk');
    desk.settings = readSettings(desk.info.language);
    setLanguage(desk.settings.language);
    desk.record = keptRecord();
  } catch (error) {
    sayError(error);
  }
  try {
    desk.document = await (await opening).openDocument(desk);
  } catch (error) {
    console.warn('document.js:', error);
  }
  drawHeader();
  watchRuns(desk, () => current);
  api.listen();
  addEventListener('hashchange', followAddress);
  addEventListener('keydown', pressed);
  addEventListener('pointerdown', (event) => { if (!event.target.closest?.('#settings, .more')) closeSettings(); });
  addEventListener('dragover', (event) => { if (withFiles(event)) event.preventDefault(); });
  addEventListener('drop', dropped);
  addEventListener('beforeunload', (event) => { if (desk.document?.dirty) event.preventDefault(); });
  await followAddress();
}

// The record in use stays when the page is loaded again.
function keepRecord(record) {
  try {
    sessionStorage.setItem('desk.record', JSON.stringify({ folder: desk.info.folder, record }));
  } catch { /* Storage may be blocked. */ }
}

function keptRecord() {
  try {
    const { folder, record } = JSON.parse(sessionStorage.getItem('desk.record'));
    return folder === desk.info.folder ? record : null;
  } catch {
    return null;
  }
}

/* Rooms */

function followAddress() {
  const [id, ...rest] = location.hash.slice(1).split('/').map(decode);
  const room = ROOMS.some((one) => one.id === id) ? id : current ?? 'tank';
  return enter(room, rest.length ? { path: rest.join('/') } : {});
}

function decode(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

// A room with a path (a result, a record) has it in the address, so that a reload and the back key find it again.
function go(id, args = {}) {
  const path = args.path ? `/${args.path.split('/').map(encodeURIComponent).join('/')}` : '';
  const address = `#${id}${path}`;
  if (location.hash !== address) history.pushState(null, '', address);
  return enter(id, args);
}

async function enter(id, args) {
  const same = current === id;
  if (current && !same) leave(current);
  current = id;
  const main = document.getElementById('main');
  for (const tab of document.querySelectorAll('[role=tab]')) select(tab, tab.dataset.room === id);
  let room = rooms.get(id);
  if (!room) {
    const element = h('section.room', { id: `room-${id}`, role: 'tabpanel', 'aria-labelledby': `tab-${id}` });
    main.append(element);
    room = { element, ready: build(id, element) };
    rooms.set(id, room);
  }
  room.element.hidden = false;
  document.title = title();
  const parts = await room.ready;
  if (current === id) parts.show(args);
}

function leave(id) {
  const room = rooms.get(id);
  if (!room) return;
  room.element.hidden = true;
  room.ready.then((parts) => parts.hide());
}

async function build(id, element) {
  try {
    const module = await import(ROOMS.find((room) => room.id === id).module);
    return module.mount(element, desk);
  } catch (error) {
    console.error(`room ${id}:`, error);
    fill(element, h('p.empty', {}, t('not-yet')));
    return { show() {}, hide() {} };
  }
}

/* Header */

function drawHeader() {
  const tabs = ROOMS.map(({ id }, index) => h('button.tab', {
    type: 'button', role: 'tab', id: `tab-${id}`, 'aria-controls': `room-${id}`, dataset: { room: id },
    title: `Alt+${index + 1}`, onclick: () => go(id), onkeydown: arrows,
  }, t(`room-${id}`)));
  const settings = h('div.settings', { id: 'settings' },
    setting('language', [['en', 'English'], ['de', 'Deutsch']]),
    setting('units', [['si', t('units-si')], ['us', t('units-us')]]),
    setting('theme', [['auto', t('theme-auto')], ['light', t('theme-light')], ['dark', t('theme-dark')]]));
  const more = h('button.quiet.more', {
    type: 'button', 'aria-label': t('settings'), 'aria-expanded': 'false', 'aria-controls': 'settings',
    onclick: () => more.setAttribute('aria-expanded', String(settings.classList.toggle('open'))),
  }, '⋯');
  fill(document.getElementById('top'),
    h('span.brand', { 'aria-hidden': true }, h('img', { src: 'icon.svg', alt: '', width: 22, height: 22 })),
    h('button.file.quiet', { type: 'button', id: 'file', onclick: chooseFile }),
    h('button.with.quiet', { type: 'button', id: 'with', hidden: true, onclick: () => go('records', { path: desk.record.path }) }),
    h('nav', { 'aria-label': t('rooms') }, h('div.tabs', { role: 'tablist' }, tabs)),
    settings, more,
    h('button.quiet.ask', { type: 'button', 'aria-label': t('help'), title: t('help'), onclick: showHelp }, '?'));
  for (const tab of tabs) select(tab, tab.dataset.room === current);
  const skip = document.getElementById('skip');
  skip.textContent = t('skip');
  // The address names the room, so the link must not change it.
  skip.onclick = (event) => { event.preventDefault(); document.getElementById('main').focus(); };
  drawBusy(desk);
  drawFile();
}

function select(tab, chosen) {
  tab.setAttribute('aria-selected', String(chosen));
  tab.tabIndex = chosen || (!current && tab.dataset.room === 'tank') ? 0 : -1;
}

function arrows(event) {
  const tabs = [...document.querySelectorAll('[role=tab]')];
  const here = tabs.indexOf(event.currentTarget);
  const target = { ArrowRight: here + 1, ArrowLeft: here - 1, Home: 0, End: tabs.length - 1 }[event.key];
  if (target === undefined) return;
  event.preventDefault();
  const tab = tabs[(target + tabs.length) % tabs.length];
  go(tab.dataset.room);
  tab.focus();
}

// A new text has no name until it is saved.
function fileName() {
  return desk.document ? desk.document.path : desk.info.tank;
}

function title() {
  const name = fileName();
  return [`${desk.document?.dirty ? '• ' : ''}${name ?? 'tankcheck'}`, current ? t(`room-${current}`) : null, 'tankcheck']
    .filter(Boolean).join(' – ');
}

function drawFile() {
  const button = document.getElementById('file');
  const name = fileName();
  const folder = desk.info.folder.split(/[/\\]/).filter(Boolean).at(-1) ?? '';
  fill(button, h('b', {}, name ?? t(desk.document && !desk.document.empty ? 'new-file' : 'no-file')), desk.document?.dirty ? h('i.unsaved', {}, t('unsaved')) : null);
  button.title = t('open-file', { folder });
  document.title = title();
  const used = document.getElementById('with');
  used.hidden = !desk.record;
  if (!desk.record) return;
  used.textContent = `+ ${desk.record.path.split('/').at(-1)}`;
  used.title = t('with-record', { path: desk.record.path });
}

function setting(name, pairs) {
  return choice(pairs, desk.settings[name], {
    'aria-label': t(name), title: t(name), name, onchange: (event) => changeSetting(name, event.target.value),
  });
}

function changeSetting(name, value) {
  desk.settings[name] = value;
  keepSetting(name, value);
  if (name === 'theme') document.documentElement.dataset.theme = value;
  if (name === 'language') setLanguage(value);
  const open = document.getElementById('settings').classList.contains('open');
  drawHeader();
  document.getElementById('settings').classList.toggle('open', open);
  document.querySelector(`#settings [name=${name}]`)?.focus();
  events.dispatchEvent(new CustomEvent('settings', { detail: { name, value } }));
}

function closeSettings() {
  document.getElementById('settings').classList.remove('open');
  document.querySelector('.more').setAttribute('aria-expanded', 'false');
}

async function chooseFile() {
  const { chooseFile: choose } = await import('./files.js');
  const before = desk.document?.path;
  await choose(desk);
  if (desk.document?.path !== before) go('tank');
}

async function openFile(path) {
  const { mayLeave } = await import('./files.js');
  try {
    if (!(await mayLeave(desk))) return;
    await desk.document.open(path);
    go('tank');
  } catch (error) {
    sayError(error);
  }
}

/* Files dropped anywhere go to the room Records; a file that misses must not replace the page. */

function withFiles(event) {
  return [...(event.dataTransfer?.types ?? [])].includes('Files');
}

function dropped(event) {
  if (event.defaultPrevented || !withFiles(event)) return;
  event.preventDefault();
  go('records', { files: [...event.dataTransfer.files] });
}

/* Keyboard and help */

function pressed(event) {
  const digit = /^Digit([1-4])$/.exec(event.code)?.[1];
  if (event.altKey && !event.ctrlKey && !event.metaKey && digit) {
    event.preventDefault();
    const id = ROOMS[digit - 1].id;
    go(id);
    document.getElementById(`tab-${id}`).focus();
    return;
  }
  if ((event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === 's') {
    event.preventDefault();
    Promise.resolve(desk.document?.save?.()).catch(sayError);
    return;
  }
  if (event.key === 'F6' && !event.ctrlKey && !event.altKey && !document.querySelector('dialog[open]')) {
    if (nextArea(event.shiftKey)) event.preventDefault();
    return;
  }
  if (event.key === 'Escape') closeSettings();
  const typing = event.target.closest?.('input, textarea, select, [contenteditable]');
  if (event.key === '?' && !typing && !document.querySelector('dialog[open]')) {
    event.preventDefault();
    showHelp();
  }
}

function showHelp() {
  const rows = [
    ['Alt+1 … Alt+4', 'key-room'], ['F6', 'key-area'], ['← →', 'key-arrows'], ['Ctrl+S', 'key-save'], ...keys, ['?', 'key-help'], ['Esc', 'key-escape'],
  ];
  show(t('help-title'),
    h('table.keys', {},
      h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, t('help-keys')), h('th', { scope: 'col' }, t('help-does')))),
      h('tbody', {}, rows.map(([combination, words]) => h('tr', {},
        h('td', {}, h('kbd', {}, combination)), h('td', {}, t(words)))))),
    h('p.hint', {}, t('about', desk.info)),
    h('p.hint', {}, t('about-more')));
}

/* Lost connection */

function drawLost(lost, other = false) {
  const bar = document.getElementById('lost');
  bar.hidden = !lost;
  if (!lost) return;
  const copy = () => download(desk.document.path?.split('/').at(-1) ?? 'tank.json', desk.document.text, 'application/json');
  fill(bar, h('p', {}, t(other ? 'lost-other' : 'lost')),
    h('button', { type: 'button', onclick: () => api.retry() }, t('try-again')),
    desk.document?.dirty ? h('button', { type: 'button', onclick: copy }, t('keep-copy')) : null);
}
