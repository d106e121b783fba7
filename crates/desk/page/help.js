// The "?" beside a field: its help, limits and default from the schema, opened by click or Enter, closed by Escape.

import { h, uniqueId } from './dom.js';
import { marked } from './marked.js';
import { formatPath } from './path.js';
import { t } from './words.js';

/** `{button, note, toggle}`; the note stands hidden until the button opens it. Fields open theirs with F1, so that Tab goes from value to value. */
export function helpFor(field, parts, label, { tabbed = true } = {}) {
  const note = h('div.field-help', { id: uniqueId('help'), hidden: true });
  const button = h('button.field-ask.quiet', {
    type: 'button', 'aria-expanded': 'false', 'aria-controls': note.id, 'aria-label': t('form-help', { name: label }), title: field.help, tabindex: tabbed ? null : -1,
  }, '?');
  const toggle = (open) => {
    if (open && !note.childNodes.length) note.append(...content(field, parts));
    note.hidden = !open;
    button.setAttribute('aria-expanded', String(open));
  };
  button.addEventListener('click', () => toggle(note.hidden));
  for (const element of [button, note]) {
    element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || note.hidden) return;
      event.stopPropagation();
      toggle(false);
      if (tabbed) button.focus();
    });
  }
  return { button, note, toggle: () => toggle(note.hidden) };
}

function content(field, parts) {
  const paragraphs = field.help.split(/\n\n+/).map((text) => h('p', {}, marked(text)));
  const options = (field.options ?? []).filter((option) => option.help);
  const list = options.length ? h('dl.field-options', {}, options.map((option) => [h('dt', {}, String(option.value)), h('dd', {}, marked(option.help))])) : null;
  const key = h('p.field-key', {}, h('code', {}, formatPath(parts)));
  return [...paragraphs, list, key].filter(Boolean);
}
