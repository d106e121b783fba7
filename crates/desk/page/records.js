// The room Records: the records and sets of the folder, one of them shown.

import { fill, h } from './dom.js';
import { showRecord } from './record-view.js';
import './records-words.js';
import { editSet, showSet } from './set-view.js';
import { bytes, t } from './words.js';

const LARGEST = 64 * 1024 * 1024;

/** Mounts the room into `element`. */
export function mount(element, desk) {
  const room = {
    desk, files: [], results: [], ticked: new Set(), filter: '', shown: null, view: null, visible: false, stale: true,
    list: h('div.rec-list', { dataset: { area: '' } }), detail: h('div.rec-detail', { tabindex: '-1', dataset: { area: '' } }),
  };
  room.reload = () => load(room);
  room.forget = () => { drawNothing(room); room.shown = null; };
  element.classList.add('records');
  fill(element, room.list, room.detail);
  buildList(room);
  acceptDrops(room, element);
  desk.events.addEventListener('folder', () => refresh(room));
  desk.events.addEventListener('back', () => refresh(room));
  desk.events.addEventListener('record', () => { drawList(room); room.view?.used?.(); });
  desk.events.addEventListener('text', () => { room.view?.tankChanged?.(); });
  desk.events.addEventListener('settings', ({ detail }) => {
    if (detail.name === 'theme') return room.view?.repaint?.();
    buildList(room);
    drawList(room);
    if (room.shown) open(room, room.shown, true);
    else drawNothing(room);
  });
  return {
    async show({ path, files } = {}) {
      room.visible = true;
      if (room.stale) await load(room);
      if (files) return void addFiles(room, files);
      if (path) open(room, path);
      else if (!room.shown) drawNothing(room);
      room.view?.repaint?.();
    },
    hide() { room.visible = false; },
  };
}

function refresh(room) {
  if (room.visible) load(room);
  else room.stale = true;
}

async function load(room) {
  try {
    const { files, results, more } = await room.desk.api.get('folder');
    room.files = files;
    room.results = results;
    room.more = more;
    room.stale = false;
    const there = new Set(files.map((file) => file.path));
    for (const path of room.ticked) if (!there.has(path)) room.ticked.delete(path);
    if (room.desk.record && !more && !there.has(room.desk.record.path)) room.desk.setRecord(null);
    drawList(room);
    room.view?.folderChanged?.(results);
  } catch (error) {
    room.desk.sayError(error);
  }
}

const ofKind = (room, kind) => room.files.filter((file) => file.kind === kind);

/* The list */

function buildList(room) {
  const input = h('input', { type: 'file', multiple: true, class: 'only-read', id: 'rec-files', onchange: () => { addFiles(room, [...input.files]); input.value = ''; } });
  room.parts = { records: h('ul.rec-items'), sets: h('ul.rec-items'), others: h('ul.rec-items'), bar: h('div.rec-ticked') };
  room.parts.setsTitle = h('h3', {}, t('rec-sets'));
  room.parts.othersTitle = h('summary');
  room.parts.othersBox = h('details.rec-others', {}, room.parts.othersTitle, room.parts.others);
  const filter = h('input', { type: 'search', placeholder: t('rec-filter'), 'aria-label': t('rec-filter'), value: room.filter, oninput: () => { room.filter = filter.value; drawList(room); } });
  room.parts.filter = filter;
  fill(room.list,
    h('div.rec-drop', {}, h('p', {}, t('rec-drop'), ' ', h('label.rec-choose', { for: input.id }, t('rec-choose')), input), h('p.hint', {}, t('rec-formats'))),
    h('h3', {}, t('rec-list')), filter, room.parts.records, room.parts.bar,
    room.parts.setsTitle, room.parts.sets, room.parts.othersBox);
}

function drawList(room) {
  const wanted = room.filter.trim().toLowerCase();
  const match = (file) => file.path.toLowerCase().includes(wanted);
  const records = ofKind(room, 'record');
  const found = records.filter(match);
  room.parts.filter.hidden = records.length < 8 && !wanted;
  const focus = room.list.contains(document.activeElement) ? document.activeElement.dataset?.key : null;
  fill(room.parts.records, found.length ? found.map((file) => item(room, file, true))
    : h('li.hint', {}, t(records.length ? 'rec-none-found' : 'rec-none')));
  const sets = ofKind(room, 'set');
  room.parts.setsTitle.hidden = !sets.length;
  fill(room.parts.sets, sets.map((file) => item(room, file, false)));
  const others = ofKind(room, 'other').filter(match);
  room.parts.othersBox.hidden = !others.length && !room.more;
  room.parts.othersTitle.textContent = t('rec-others', { count: others.length });
  fill(room.parts.others, others.map((file) => item(room, file, false)));
  if (room.more) room.parts.others.append(h('li.hint', {}, t('rec-more')));
  drawTicked(room, found);
  if (focus) room.list.querySelector(`[data-key="${CSS.escape(focus)}"]`)?.focus();
}

function item(room, file, tickable) {
  const cut = file.path.lastIndexOf('/') + 1;
  const used = room.desk.record?.path === file.path;
  const tick = tickable && h('input', {
    type: 'checkbox', checked: room.ticked.has(file.path), 'aria-label': t('rec-tick', { name: file.path }), dataset: { key: `tick ${file.path}` },
    onchange: (event) => {
      if (event.target.checked) room.ticked.add(file.path);
      else room.ticked.delete(file.path);
      drawTicked(room);
    },
  });
  return h('li', { class: room.shown === file.path ? 'shown' : '' }, tick,
    h('button.quiet', { type: 'button', 'aria-current': room.shown === file.path ? 'true' : null, title: file.path, dataset: { key: file.path },
      onclick: () => pick(room, file.path) },
    h('span.rec-name', {}, cut ? h('small', {}, file.path.slice(0, cut)) : null, file.path.slice(cut)),
    used ? h('span.rec-mark', { title: t('rec-used') }, '●') : null,
    h('small', {}, bytes(file.size))));
}

// On a narrow screen the record stands below the list.
function pick(room, path) {
  room.desk.go('records', { path });
  if (room.detail.offsetTop > room.list.offsetTop + 100) room.detail.scrollIntoView({ block: 'start' });
}

function drawTicked(room, found = ofKind(room, 'record')) {
  const count = room.ticked.size;
  const all = h('button.link', { type: 'button', onclick: () => { for (const file of found) room.ticked.add(file.path); drawList(room); } }, t('rec-tick-all'));
  const none = h('button.link', { type: 'button', onclick: () => { room.ticked.clear(); drawList(room); } }, t('rec-untick'));
  fill(room.parts.bar, found.length > 2 && count < found.length ? all : null, count ? none : null,
    count ? h('span.hint', {}, t('rec-ticked', { count })) : null,
    count ? h('button', { type: 'button', disabled: count < 3, title: count < 3 ? t('set-few') : null, onclick: () => makeSet(room) }, t('rec-make-set')) : null);
}

/* Adding files */

function acceptDrops(room, element) {
  const files = (event) => [...(event.dataTransfer?.types ?? [])].includes('Files');
  let depth = 0;
  element.addEventListener('dragenter', (event) => { if (files(event)) { depth += 1; element.classList.add('dropping'); } });
  element.addEventListener('dragleave', (event) => { if (files(event) && (depth -= 1) <= 0) element.classList.remove('dropping'); });
  element.addEventListener('dragover', (event) => { if (files(event)) event.preventDefault(); });
  element.addEventListener('drop', (event) => {
    depth = 0;
    element.classList.remove('dropping');
    if (!files(event)) return;
    event.preventDefault();
    addFiles(room, [...event.dataTransfer.files]);
  });
}

async function addFiles(room, files) {
  const { desk } = room;
  let last = null;
  for (const file of files) {
    if (file.size > LARGEST) {
      desk.say(t('rec-too-large', { name: file.name, size: bytes(file.size) }), 'error');
      continue;
    }
    try {
      const { path } = await desk.api.upload(file.name, file);
      last = path;
      desk.say(t('rec-saved', { name: path }), 'ok');
    } catch (error) {
      desk.sayError(error);
    }
  }
  if (!last) return;
  await load(room);
  if (room.files.find((file) => file.path === last)?.kind === 'tank') {
    return void desk.say(t('rec-is-tank', { name: last }), 'info', { title: t('rec-open-tank'), act: () => desk.openFile(last) });
  }
  desk.go('records', { path: last });
}

/* The detail */

function drawNothing(room) {
  room.view?.close?.();
  room.view = null;
  fill(room.detail, h('p.empty', {}, t('rec-pick')));
}

function open(room, path, again = false) {
  if (room.shown === path && room.view && !again) return;
  room.view?.close?.();
  room.shown = path;
  drawList(room);
  const kind = room.files.find((file) => file.path === path)?.kind;
  room.view = kind === 'set' ? showSet(room, path) : showRecord(room, path);
}

async function makeSet(room) {
  room.view?.close?.();
  room.shown = null;
  drawList(room);
  room.view = editSet(room, [...room.ticked].sort(), async (path) => {
    room.ticked.clear();
    room.desk.say(t('set-saved', { path }), 'ok');
    await load(room);
    room.desk.go('records', { path });
  });
  room.detail.focus();
}
