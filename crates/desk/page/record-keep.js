// Records and sets of the folder are renamed and removed here. What names them is asked about first, and follows a new name.

import { h, labelled } from './dom.js';
import { moveReading } from './reading.js';
import { t } from './words.js';

/** Buttons for the file at `path`; `room` is the room Records. */
export function keeping(room, path) {
  return [
    h('button.quiet', { type: 'button', onclick: () => rename(room, path) }, t('rec-rename')),
    h('button.quiet', { type: 'button', onclick: () => remove(room, path) }, t('rec-remove')),
  ];
}

const listed = (room, path) => room.files.find((file) => file.path === path);

async function rename(room, path) {
  const { desk } = room;
  const input = h('input.mono', { type: 'text', value: path, spellcheck: 'false', autocomplete: 'off' });
  const content = h('form', { onsubmit: (event) => { event.preventDefault(); content.closest('dialog').querySelector('.primary').click(); } },
    labelled(t('rec-new-name'), input, t('rec-new-name-hint')));
  // The name without folder and ending is what changes most.
  setTimeout(() => { input.focus(); input.setSelectionRange(path.lastIndexOf('/') + 1, path.includes('.') ? path.lastIndexOf('.') : path.length); });
  const answer = await desk.ask(content, [{ id: 'go', title: t('rec-rename'), kind: 'primary' }, { id: 'cancel', title: t('cancel') }], { title: t('rec-rename-title', { name: path }) });
  const to = input.value.trim().replace(/\\/g, '/');
  if (answer !== 'go' || !to || to === path) return;
  const send = (named) => desk.api.post('rename', { path, to, was: listed(room, path)?.stamp ?? '', named });
  const done = await asked(room, send, 'rec-named-rename', [{ id: 'go', title: t('rec-rename-all'), kind: 'primary' }]);
  if (!done) return;
  moveReading(path, to);
  if (room.ticked.delete(path)) room.ticked.add(to);
  if (desk.record?.path === path) desk.setRecord({ ...desk.record, path: to });
  desk.say(t('rec-renamed', { name: to }), 'ok');
  await room.reload();
  desk.go('records', { path: to });
}

async function remove(room, path) {
  const { desk } = room;
  const sure = await desk.ask(t('rec-remove-sure', { name: path }), [{ id: 'go', title: t('rec-remove'), kind: 'danger' }, { id: 'cancel', title: t('cancel'), kind: 'primary' }]);
  if (sure !== 'go') return;
  const send = (named) => desk.api.remove('file', { query: { path, was: listed(room, path)?.stamp ?? '', named: String(named) } });
  const done = await asked(room, send, 'rec-named-remove', [{ id: 'go', title: t('rec-remove-all'), kind: 'danger' }]);
  if (!done) return;
  room.ticked.delete(path);
  desk.say(t('rec-removed', { name: path }), 'ok');
  room.forget();
  await room.reload();
  desk.go('records');
}

/** Sends a wish; where other files name the record, asks and sends it again. Resolves to the answer, or null. */
async function asked({ desk, reload }, send, words, choices) {
  try {
    return (await send(false)) ?? {};
  } catch (error) {
    const named = error.body?.named;
    if (!named?.length) {
      desk.sayError(error);
      // It may have changed meanwhile.
      if (error.status === 409 || error.status === 404) await reload();
      return null;
    }
    const answer = await desk.ask(t(words, { list: named.join(', ') }), [...choices, { id: 'cancel', title: t('cancel') }]);
    if (answer !== 'go') return null;
  }
  try {
    return (await send(true)) ?? {};
  } catch (error) {
    desk.sayError(error);
    return null;
  }
}
