// Objects by name: materials. A name can be changed; the courses that use it follow.

import { h, uniqueId } from './dom.js';
import { Group } from './group.js';
import { helpFor } from './help.js';
import { labelOf } from './labels.js';
import { rename } from './rows.js';
import { t } from './words.js';

export class Named {
  constructor(form, parts, field, { flat = false } = {}) {
    Object.assign(this, { form, parts, field, entries: new Map(), title: labelOf(parts.at(-1)) });
    this.item = form.schema.field(field.item);
    this.body = h('div.field-groups');
    this.list = h('ul.field-faults', { hidden: true });
    this.name = h('input', { type: 'text', id: uniqueId('name'), list: form.grades.id, autocomplete: 'off', 'aria-label': t('form-new-name'), placeholder: t('form-new-name') });
    this.name.addEventListener('keydown', (event) => { if (event.key === 'Enter') this.add(); });
    const adding = h('div.field-adding', {}, this.name, h('button', { type: 'button', onclick: () => this.add() }, t('form-add-material')));
    this.element = h('section.field-group', { 'aria-label': this.title });
    if (!flat) {
      const { button, note } = helpFor(field, parts, this.title);
      this.element.append(h('div.field-head', {}, h('h3', {}, this.title), button), note);
    }
    this.element.append(this.list, this.body, adding);
    form.register(this);
  }

  update(node) {
    const members = node?.members ?? [];
    const names = new Set(members.map((member) => member.key));
    for (const [name, view] of this.entries) {
      if (names.has(name)) continue;
      view.remove();
      this.entries.delete(name);
    }
    for (const member of members) {
      if (!this.entries.has(member.key)) this.entries.set(member.key, this.make(member.key));
      const view = this.entries.get(member.key);
      if (view.element.parentNode !== this.body) this.body.append(view.element);
      view.update(member.node);
    }
  }

  make(name) {
    const parts = [...this.parts, name];
    const input = h('input.field-name', { type: 'text', value: name, autocomplete: 'off', 'aria-label': t('form-name-of', { name }), onchange: () => this.rename(name, input) });
    input.addEventListener('keydown', (event) => { if (event.key === 'Enter') this.rename(name, input); });
    const remove = h('button.field-remove.quiet', {
      type: 'button', 'aria-label': t('form-remove', { name }), title: t('form-remove', { name }), onclick: () => this.form.put(parts, undefined),
    }, '×');
    return new Group(this.form, parts, this.item, { title: name, head: h('div.field-head', {}, input, remove) });
  }

  rename(name, input) {
    const wanted = input.value.trim();
    if (!wanted || wanted === name) return void (input.value = name);
    const { document } = this.form;
    const text = rename(document.text, document.root, [...this.parts, name], wanted, 'material');
    if (text === document.text) input.value = name;
    else document.replace(text, { origin: 'form' });
  }

  async add() {
    const name = this.name.value.trim();
    if (!name || this.entries.has(name)) return void this.name.focus();
    this.name.value = '';
    await this.form.put([...this.parts, name], this.form.isGrade(name) ? { grade: name } : {});
    this.form.focusPath([...this.parts, name]);
  }

  setFaults(faults) {
    this.form.listFaults(this.list, faults);
  }

  focus() {
    this.name.focus();
    this.element.scrollIntoView({ block: 'start' });
  }

  remove() {
    for (const view of this.entries.values()) view.remove();
    this.form.unregister(this);
    this.element.remove();
  }
}
