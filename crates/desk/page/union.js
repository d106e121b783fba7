// A value that is either a word ("none") or described by a group: not stated, a word, or the group.

import { h, uniqueId } from './dom.js';
import { helpFor } from './help.js';
import { labelOf } from './labels.js';
import { formatPath } from './path.js';
import { makeView } from './views.js';
import { t } from './words.js';

export class Union {
  constructor(form, parts, field) {
    Object.assign(this, { form, parts, field, extra: new Set(), title: labelOf(parts.at(-1)) });
    this.other = form.schema.field(field.other);
    this.select = h('select', { id: uniqueId('shape'), onchange: () => this.chosen() },
      h('option', { value: '' }, t('form-not-stated')),
      field.words.map((word) => h('option', { value: `=${word}` }, word === 'none' ? t('form-none') : word)),
      h('option', { value: '+' }, t('form-described')));
    this.select.dataset.path = formatPath(parts);
    this.list = h('ul.field-faults', { hidden: true });
    const { button, note } = helpFor(field, parts, this.title);
    this.element = h('section.field-group', { 'aria-label': this.title },
      h('div.field-head', {}, h('h3', {}, h('label', { for: this.select.id }, this.title)), this.select, button), note, this.list);
    form.register(this);
  }

  update(node) {
    const inner = node?.type === 'object' || node?.type === 'array';
    this.select.value = node === undefined ? '' : inner ? '+' : `=${node.value}`;
    if (inner && !this.view) {
      this.view = makeView(this.form, this.parts, this.other, { flat: true });
      this.element.append(this.view.element);
    }
    if (!inner && this.view) {
      this.view.remove();
      this.view = null;
      this.form.register(this);
    }
    this.view?.update(node);
  }

  // What was described is kept while the page is open, so that a look at the other choice loses nothing.
  async chosen() {
    const choice = this.select.value;
    if (this.view && choice !== '+') this.kept = this.form.valueAt(this.parts);
    const value = choice === '' ? undefined : choice === '+' ? this.kept ?? (this.other.kind === 'list' ? [] : {}) : choice.slice(1);
    await this.form.put(this.parts, value);
  }

  setFaults(faults) {
    if (this.view) this.view.setFaults(faults);
    this.form.listFaults(this.list, this.view ? [] : faults);
    this.select.toggleAttribute('aria-invalid', faults.length > 0 && !this.view);
  }

  focus() {
    this.select.focus();
    this.element.scrollIntoView({ block: 'start' });
  }

  remove() {
    this.view?.remove();
    this.form.unregister(this);
    this.element.remove();
  }
}
