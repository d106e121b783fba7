// Dialogs about files: open, name for saving, templates, a file that was changed elsewhere.

import { differenceBlock } from './difference.js';
import { h, labelled } from './dom.js';
import { t } from './words.js';

/** The name for a file after the title of its tank: the tag in it, such as `tk-204.json` for TK-204; else tank.json. */
export function proposedName(title) {
  const tag = /(?<![\p{L}\d.,-])(?=[\p{L}\d-]*\p{L})(?=[\p{L}\d-]*\d)\p{L}[\p{L}\d]*(?:-[\p{L}\d]+)*/u.exec(String(title ?? ''))?.[0];
  return tag ? `${tag.toLowerCase()}.json` : 'tank.json';
}

/** Asks for a file name in the opened folder; resolves to a path or null. */
export async function nameForSaving(desk, path) {
  const input = h('input', { type: 'text', value: path ?? 'tank.json', spellcheck: 'false', autocomplete: 'off' });
  const content = h('form', { onsubmit: (event) => { event.preventDefault(); content.closest('dialog').querySelector('.primary').click(); } },
    labelled(t('doc-name'), input, t('doc-name-hint', { folder: desk.info.folder })));
  setTimeout(() => { input.focus(); input.setSelectionRange(0, input.value.replace(/\.json$/, '').length); });
  const answer = await desk.ask(content, [
    { id: 'save', title: t('doc-save'), kind: 'primary' }, { id: 'cancel', title: t('doc-cancel') },
  ], { title: t('doc-save-as') });
  const name = input.value.trim().replace(/\\/g, '/');
  if (answer !== 'save' || !name) return null;
  return /\.json$/i.test(name) ? name : `${name}.json`;
}

/** Asks which of two texts of a file counts: 'mine', 'theirs' or null. */
export async function changedElsewhere(desk, path, mine, theirs, created) {
  const choices = [
    { id: 'mine', title: t('doc-mine') }, { id: 'theirs', title: t('doc-theirs') },
    { id: 'difference', title: t('doc-difference'), kind: 'primary' }, { id: 'cancel', title: t('doc-cancel') },
  ];
  let answer = await desk.ask(t(created ? 'doc-exists' : 'doc-conflict', { name: path }), choices, { title: t(created ? 'doc-exists-title' : 'doc-conflict-title') });
  while (answer === 'difference') {
    const shown = h('div.stack', {}, h('p', {}, t('doc-difference-says')), differenceBlock(theirs, mine));
    answer = await desk.ask(shown, choices.filter((choice) => choice.id !== 'difference'), { title: path });
  }
  return answer === 'mine' || answer === 'theirs' ? answer : null;
}

/** Resolves to whether the present text may be left. */
export async function mayLeave(desk) {
  const document = desk.document;
  if (!document.dirty) return true;
  const answer = await desk.ask(t('doc-unsaved', { name: document.path ?? t('doc-new') }), [
    { id: 'save', title: t('doc-save-first'), kind: 'primary' }, { id: 'leave', title: t('doc-discard'), kind: 'danger' },
    { id: 'cancel', title: t('doc-cancel') },
  ]);
  if (answer === 'save') return document.save();
  return answer === 'leave';
}

/** Lets a tank file of the folder be chosen and opens it. */
export async function chooseFile(desk) {
  try {
    const { files } = await desk.api.get('folder');
    const tanks = files.filter((file) => file.kind === 'tank').map((file) => ({ id: file.path, title: file.path }));
    const path = await choose(desk, t('doc-open'), tanks, t('doc-none', { folder: desk.info.folder }));
    if (path && (await mayLeave(desk))) await desk.document.open(path);
  } catch (error) {
    desk.sayError(error);
  }
}

/** Lets a template be chosen and starts a new text from it. */
export async function chooseTemplate(desk) {
  try {
    const templates = await desk.api.get('templates');
    const pairs = [...templates.map(({ id, title }) => ({ id, title })), { id: 'empty', title: t('doc-empty') }];
    const id = await choose(desk, t('doc-templates'), pairs, '');
    if (!id || !(await mayLeave(desk))) return;
    desk.document.startFrom(templates.find((one) => one.id === id)?.text ?? '{\n}\n');
  } catch (error) {
    desk.sayError(error);
  }
}

/** A list in a dialog, filtered by what is typed; arrows and Enter work. Resolves to the id of an entry or null. */
export function choose(desk, title, entries, none) {
  return new Promise((resolve) => {
    let answer = null;
    const list = h('div.tank-choices', {}, entries.map((entry) => h('button', {
      type: 'button', dataset: { name: `${entry.title} ${entry.words ?? ''}`.toLowerCase() }, onclick: () => { answer = entry.id; dialog.close(); },
    }, entry.title)));
    const filter = h('input', { type: 'search', placeholder: t('doc-filter'), 'aria-label': t('doc-filter'), hidden: entries.length < 9 });
    filter.addEventListener('input', () => {
      for (const button of list.children) button.hidden = !filter.value.toLowerCase().split(/\s+/).every((word) => button.dataset.name.includes(word));
    });
    const content = h('div.stack', {}, entries.length ? [filter, list] : h('p.empty', {}, none));
    content.addEventListener('keydown', (event) => {
      const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      const shown = [...list.children].filter((button) => !button.hidden);
      if (event.key === 'Enter' && event.target === filter) shown[0]?.click();
      if (!step || !shown.length) return;
      event.preventDefault();
      shown[(shown.indexOf(event.target) + step + shown.length) % shown.length].focus();
    });
    const dialog = desk.showDialog(title, content);
    dialog.addEventListener('close', () => resolve(answer));
    (entries.length < 9 ? list.firstElementChild : filter)?.focus();
  });
}
