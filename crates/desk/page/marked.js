// Texts of the program with `code` in them, as nodes.

import { h } from './dom.js';

/** Markup of the server without styles in attributes: the policy of the page forbids them. */
export const withoutStyles = (markup) => markup.replace(/ style="[^"]*"/g, '');

export function marked(text) {
  return text.split('`').map((part, index) => (index % 2 ? h('code', {}, part) : part));
}
