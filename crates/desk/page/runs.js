// The room Runs: a form for a new run beside the queue.

import { fill } from './dom.js';
import './records-words.js';
import { createForm } from './run-form.js';
import { createList } from './run-list.js';
import './runs-words.js';

/** Mounts the room into `element`. */
export function mount(element, desk) {
  const room = { desk, runs: [], files: [], results: [], specs: new Map(), visible: false, wanted: null, ended: '' };
  room.form = createForm(desk, (id, spec) => {
    room.specs.set(id, spec);
    loadRuns(room);
  });
  room.list = createList(desk, room.specs, { again: (spec) => room.form.again(spec), resume: (spec) => resume(room, spec), post: (spec) => post(room, spec) });
  element.classList.add('runs');
  fill(element, room.form.element, room.list.element);
  listen(room);
  return {
    async show(args = {}) {
      room.visible = true;
      await Promise.all([loadFolder(room), loadRuns(room)]);
      room.form.open({ ...args, along: args.kind ? desk.record?.path : undefined });
    },
    hide() { room.visible = false; },
  };
}

function listen(room) {
  const { events } = room.desk;
  events.addEventListener('runs', ({ detail }) => takeRuns(room, detail));
  events.addEventListener('folder', () => { if (room.visible) loadFolder(room); });
  events.addEventListener('back', () => { if (room.visible) { loadFolder(room); loadRuns(room); } });
  events.addEventListener('record', ({ detail }) => room.form.open({ along: detail?.path ?? '' }));
  events.addEventListener('text', () => room.form.update({}));
  events.addEventListener('settings', ({ detail }) => {
    if (detail.name === 'theme') return;
    room.form.redraw();
    room.list.redraw(room.runs);
  });
}

function takeRuns(room, runs) {
  if (!Array.isArray(runs)) return;
  room.runs = runs;
  room.list.update(runs, room.results);
  room.form.update({ runs });
  // A run that has ended has left results: the folder is read again for its links.
  const ended = runs.filter((run) => run.state !== 'waiting' && run.state !== 'running').map((run) => run.id).join();
  if (ended !== room.ended && room.visible) loadFolder(room);
  room.ended = ended;
}

async function loadRuns(room) {
  try {
    takeRuns(room, await room.desk.api.get('runs'));
  } catch (error) {
    room.desk.sayError(error);
  }
}

async function loadFolder(room) {
  try {
    const { files, results } = await room.desk.api.get('folder');
    room.files = files;
    room.results = results;
    room.form.update({ files, results });
    room.list.update(room.runs, results);
  } catch (error) {
    room.desk.sayError(error);
  }
}

function resume(room, spec) {
  const more = spec.arguments.includes('--resume') ? [] : ['--resume'];
  return post(room, { ...spec, arguments: [...spec.arguments, ...more], values: { ...spec.values, resume: true } });
}

/** Starts what a button of a card means, without the form. */
async function post(room, spec) {
  try {
    const { id } = await room.desk.api.post('runs', { command: spec.command, arguments: spec.arguments, out: spec.out });
    if (spec.kind) room.specs.set(id, spec);
    await loadRuns(room);
  } catch (error) {
    room.desk.sayError(error);
  }
}
