// The room Runs.

import { fill, h } from './dom.js';
import { t } from './words.js';

/** Mounts the room into `element`. */
export function mount(element) {
  return { show() { fill(element, h('p.empty', {}, t('not-yet'))); }, hide() {} };
}
