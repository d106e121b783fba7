// An object of the file as a group of rows. Keys that are given, needed or faulty stand in front; the rest is offered below a fold.

import { h, fill } from './dom.js';
import { expectedKeys } from './expected.js';
import { Field } from './field.js';
import { helpFor } from './help.js';
import { childOf, plain } from './jsonc.js';
import { labelAt, labelOf } from './labels.js';
import { formatPath } from './path.js';
import { isLeaf } from './schema.js';
import { makeView } from './views.js';
import { t } from './words.js';

/** Keys that are not offered for a shape of the tank. */
const NOT_FOR = { cylinder: ['length', 'breadth', 'strip'], rectangle: ['radius'] };

export class Group {
  /** `only`: the keys of the object that this group has; `flat`: without a heading of its own. */
  constructor(form, parts, field, { only = null, flat = false, removable = false, title = labelOf(parts.at(-1) ?? ''), head = null } = {}) {
    Object.assign(this, { form, parts, field, children: new Map(), extra: new Set(), title });
    this.keys = Object.keys(field.properties).filter((key) => !only || only.includes(key));
    this.rows = h('div.field-rows');
    this.groups = h('div.field-groups');
    this.folded = h('div.field-rows');
    this.offers = h('div.field-offers');
    this.summary = h('summary');
    this.fold = h('details.field-fold', { ontoggle: () => this.opened() }, this.summary, this.folded, this.offers);
    this.list = h('ul.field-faults', { hidden: true });
    this.element = h(flat ? 'div.field-flat' : 'section.field-group', { 'aria-label': flat ? null : title });
    if (!flat) this.element.append(...(head ? [head] : this.head(removable)));
    this.element.append(this.list, this.rows, this.groups, this.fold);
    form.register(this);
  }

  head(removable) {
    const { button, note } = helpFor(this.field, this.parts, this.title);
    const remove = removable ? h('button.field-remove.quiet', {
      type: 'button', 'aria-label': t('form-remove', { name: this.title }), title: t('form-remove', { name: this.title }), onclick: () => this.form.put(this.parts, undefined),
    }, '×') : null;
    return [h('div.field-head', {}, h('h3', {}, this.title), button, remove), note];
  }

  update(node) {
    this.node = node;
    const value = plain(node);
    this.value = value;
    const wanted = expectedKeys(this.field.schema, value);
    this.wanted = new Set([...wanted.own, ...this.extra]);
    this.below = wanted.below;
    this.ruledOut = new Set(NOT_FOR[value?.shape]);
    const folded = [];
    for (const key of this.keys) {
      const child = childOf(node, key);
      const given = child !== undefined || this.wanted.has(key) || this.asks(key) || this.form.mustShow([...this.parts, key]);
      if (given || this.isBusy(key)) this.place(key, child);
      else if (!this.ruledOut.has(key)) folded.push(key);
    }
    // An object that was just added and needs nothing shows what it may have.
    if (node?.members?.length === 0 && !this.wanted.size) this.fold.open = true;
    this.updateFold(folded);
  }

  // A part of the tank that may be answered with "none" is always asked for.
  asks(key) { return this.fieldOf(key).words?.includes('none') ?? false; }

  // A row that is in use stays where it is: it must not lose the focus.
  isBusy(key) {
    const view = this.children.get(key);
    return Boolean(view?.element.contains(document.activeElement) && !this.folded.contains(view.element));
  }

  place(key, node) {
    const leaf = isLeaf(this.fieldOf(key));
    let view = this.children.get(key);
    const inFold = view && this.folded.contains(view.element);
    if (!view) view = this.make(key);
    if (!view.element.parentNode || (inFold && !(this.fold.open && view.element.contains(document.activeElement)))) {
      this.insert(leaf ? this.rows : this.groups, key, view);
    }
    view.setRequired?.(this.wanted.has(key));
    view.relabel?.(labelAt([...this.parts, key], this.value));
    if (view.extra) view.extra = this.below.get(key) ?? new Set();
    view.update(node);
  }

  make(key) {
    const view = isLeaf(this.fieldOf(key))
      ? new Field(this.form, [...this.parts, key], this.fieldOf(key))
      : makeView(this.form, [...this.parts, key], this.fieldOf(key), { removable: !this.field.required.has(key) });
    this.children.set(key, view);
    return view;
  }

  fieldOf(key) { return this.form.schema.field(this.field.properties[key]); }

  // Keeps the order of the schema among the elements of a container.
  insert(container, key, view) {
    const order = this.keys.indexOf(key);
    view.element.dataset.order = order;
    const next = [...container.children].find((element) => Number(element.dataset.order) > order);
    container.insertBefore(view.element, next ?? null);
  }

  updateFold(keys) {
    this.waiting = keys;
    for (const [key, view] of this.children) {
      if (!keys.includes(key)) {
        if (this.ruledOut.has(key) && this.folded.contains(view.element)) this.drop(key);
        continue;
      }
      if (!isLeaf(this.fieldOf(key))) this.drop(key);
      else if (this.fold.open) this.stow(key, view);
      else this.drop(key);
    }
    // What has the focus must not vanish: the key that is typed would be lost.
    this.fold.hidden = keys.length === 0 && !this.fold.contains(document.activeElement);
    fill(this.summary, t('form-more', { count: keys.length }), h('span.field-names', {}, keys.map((key) => labelAt([...this.parts, key], this.value)).join(', ')));
    if (this.fold.open) this.opened();
  }

  stow(key, view) {
    if (!this.folded.contains(view.element)) this.insert(this.folded, key, view);
    view.setRequired(false);
    view.relabel?.(labelAt([...this.parts, key], this.value));
    view.update(undefined);
  }

  drop(key) {
    this.children.get(key)?.remove();
    this.children.delete(key);
  }

  // The fold is filled when it is first opened.
  opened() {
    if (!this.fold.open) return;
    for (const key of this.waiting) {
      if (isLeaf(this.fieldOf(key)) && !this.children.has(key)) this.stow(key, this.make(key));
    }
    const groups = this.waiting.filter((key) => !isLeaf(this.fieldOf(key)));
    const names = groups.join(' ');
    if (this.offers.dataset.names === names) return;
    this.offers.dataset.names = names;
    fill(this.offers, groups.map((key) => h('button.field-offer', {
      type: 'button', title: this.fieldOf(key).help, dataset: { path: formatPath([...this.parts, key]) }, onclick: () => this.add(key),
    }, `+ ${labelOf(key)}`)));
  }

  async add(key) {
    const field = this.fieldOf(key);
    const empty = { list: [], union: field.words?.[0] ?? {} }[field.kind] ?? {};
    await this.form.put([...this.parts, key], empty);
    this.form.focusPath([...this.parts, key]);
  }

  setFaults(faults) {
    this.form.listFaults(this.list, faults);
  }

  focus() {
    const first = this.element.querySelector('input, select, textarea, summary');
    first?.focus();
    this.element.scrollIntoView({ block: 'start' });
  }

  remove() {
    for (const key of [...this.children.keys()]) this.drop(key);
    this.form.unregister(this);
    this.element.remove();
  }
}
