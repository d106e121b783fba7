// A list of single values: ticks where they are words of a fixed set, else one field for each and an empty one at the end.

import { meaning } from './choices.js';
import { h } from './dom.js';
import { Field } from './field.js';
import { helpFor } from './help.js';
import { labelOf } from './labels.js';
import { t } from './words.js';

export class List {
  constructor(form, parts, field, { flat = false, removable = true } = {}) {
    Object.assign(this, { form, parts, field, fields: [], title: labelOf(parts.at(-1)) });
    this.item = form.schema.field(field.item);
    this.body = h('div.field-items');
    this.list = h('ul.field-faults', { hidden: true });
    this.element = h('section.field-group', { 'aria-label': this.title });
    if (!flat) this.element.append(...this.head(removable));
    this.element.append(this.list, this.body);
    if (this.item.kind === 'choice') this.makeTicks();
    form.register(this);
  }

  head(removable) {
    const { button, note } = helpFor(this.field, this.parts, this.title);
    const remove = removable ? h('button.field-remove.quiet', {
      type: 'button', 'aria-label': t('form-remove', { name: this.title }), onclick: () => this.form.put(this.parts, undefined),
    }, '×') : null;
    return [h('div.field-head', {}, h('h3', {}, this.title), button, remove), note];
  }

  makeTicks() {
    this.ticks = new Map(this.item.options.map(({ value, help }) => {
      const tick = h('input', { type: 'checkbox', onchange: () => this.ticked() });
      this.body.append(h('label.field-tick', {}, tick, h('span', {}, String(value)), h('small', {}, meaning(help))));
      return [value, tick];
    }));
  }

  ticked() {
    const before = this.form.valueAt(this.parts) ?? [];
    const chosen = [...this.ticks].filter(([, tick]) => tick.checked).map(([value]) => value);
    const kept = before.filter((value) => chosen.includes(value) || !this.ticks.has(value));
    const value = [...kept, ...chosen.filter((one) => !kept.includes(one))];
    this.form.put(this.parts, value.length ? value : undefined);
  }

  update(node) {
    const items = node?.items ?? [];
    if (this.ticks) {
      const given = new Set(items.map((item) => item.value));
      for (const [value, tick] of this.ticks) tick.checked = given.has(value);
      return;
    }
    while (this.fields.length > items.length + 1) this.fields.pop().remove();
    while (this.fields.length < items.length + 1) {
      const index = this.fields.length;
      const field = new Field(this.form, [...this.parts, index], this.item, { bare: true, label: `${this.title} ${index + 1}` });
      field.above = () => this.fields[index - 1]?.shown ?? '';
      this.fields.push(field);
      this.body.append(field.element);
    }
    this.fields.forEach((field, index) => field.update(items[index]));
  }

  setFaults(faults) {
    this.form.listFaults(this.list, faults);
  }

  focus() {
    (this.body.querySelector('input') ?? this.element).focus();
    this.element.scrollIntoView({ block: 'start' });
  }

  remove() {
    for (const field of this.fields) field.remove();
    this.form.unregister(this);
    this.element.remove();
  }
}
