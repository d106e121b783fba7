// Toasts and dialogs.

import { fill, h } from './dom.js';
import { t } from './words.js';

const SECONDS = { info: 5, ok: 4, warning: 9, error: 15 };

/**
 * Shows a short message at the edge of the page, which screen readers announce.
 *
 * @param {string} text
 * @param {'info'|'ok'|'warning'|'error'} [kind]
 * @param {{title: string, act: Function}} [action] a button in the message
 */
export function say(text, kind = 'info', action = null) {
  const list = document.getElementById('toasts');
  for (const same of list.querySelectorAll('.toast')) if (same.dataset.text === text) same.remove();
  const toast = h('div', { class: `toast ${kind}`, dataset: { text } }, h('p', {}, text));
  const close = () => toast.remove();
  if (action) toast.append(h('button', { type: 'button', onclick: () => { close(); action.act(); } }, action.title));
  toast.append(h('button.quiet', { type: 'button', 'aria-label': t('close'), onclick: close }, '×'));
  list.append(toast);
  while (list.children.length > 4) list.firstElementChild.remove();
  let timer = setTimeout(close, SECONDS[kind] * 1000);
  toast.addEventListener('pointerenter', () => clearTimeout(timer));
  toast.addEventListener('pointerleave', () => { timer = setTimeout(close, 3000); });
}

/** Shows an `ApiError` with its help. */
export function sayError(error) {
  if (error?.name === 'AbortError' || error?.status === 0) return;
  say([error?.message ?? String(error), error?.help].filter(Boolean).join('\n'), 'error');
}

/**
 * Asks something and waits for the answer.
 *
 * @param {string|Node} text
 * @param {Array<{id: string, title: string, kind?: 'primary'|'danger'}|string>} choices buttons, in reading order
 * @param {{title?: string}} [options]
 * @returns {Promise<string|null>} the id that was chosen; null after Escape
 */
export function ask(text, choices, options = {}) {
  return new Promise((resolve) => {
    const dialog = open(options.title ?? null, typeof text === 'string' ? h('p.asked', {}, text) : text);
    let answer = null;
    const buttons = choices.map((choice) => {
      const { id, title, kind } = typeof choice === 'string' ? { id: choice, title: choice } : choice;
      return h('button', {
        type: 'button', class: kind ?? '', autofocus: kind === 'primary', onclick: () => { answer = id; dialog.close(); },
      }, title);
    });
    dialog.append(h('div.choices', {}, buttons));
    dialog.addEventListener('close', () => resolve(answer));
    dialog.showModal();
    (buttons.find((button) => button.classList.contains('primary')) ?? buttons.at(-1))?.focus();
  });
}

/** Shows content until it is closed. Returns the dialog. */
export function show(title, ...content) {
  const dialog = open(title, ...content);
  dialog.append(h('div.choices', {}, h('button.primary', { type: 'button', onclick: () => dialog.close() }, t('close'))));
  dialog.showModal();
  return dialog;
}

function open(title, ...content) {
  const before = document.activeElement;
  const dialog = h('dialog');
  fill(dialog, title ? h('h2', {}, title) : null, content);
  if (title) dialog.setAttribute('aria-label', title);
  document.body.append(dialog);
  dialog.addEventListener('close', () => {
    dialog.remove();
    if (before instanceof HTMLElement && before.isConnected) before.focus();
  });
  dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
  return dialog;
}
