// Texts of the program with `code` in them, as nodes.

import { h } from './dom.js';

export function marked(text) {
  return text.split('`').map((part, index) => (index % 2 ? h('code', {}, part) : part));
}
