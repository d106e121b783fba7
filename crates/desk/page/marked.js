// Texts of the program with `code` in them, as nodes.

import { h } from './dom.js';
import { parsePath } from './path.js';

/** Whether a fault says that something has yet to be filled in. */
export const isMissing = (fault) => fault.code === 'T0207' || fault.code === 'T0104';

/** The place of a fault; one without a path may name the key to add. */
export const placeOf = (fault) => parsePath(fault.path || (/^add `([\w.]+)`/.exec(fault.help ?? '')?.[1] ?? ''));

/** A text of a fault or a warning: German on a German page where there is one, English elsewhere. */
export const wording = (fault, part = 'message') => fault.german?.[part] ?? fault[part];

/** `lang` of that text: the language of the page has no mark. */
export const tongue = (fault, part = 'message') => (fault.german?.[part] ? null : 'en');

/** Markup of the server without styles in attributes: the policy of the page forbids them. */
export const withoutStyles = (markup) => markup.replace(/ style="[^"]*"/g, '');

export function marked(text) {
  return text.split('`').map((part, index) => (index % 2 ? h('code', {}, part) : part));
}
