// A list of objects, or of rows of numbers, as a table: courses, bars, spectra. It works like a spreadsheet: Enter goes down,
// an empty row at the end takes what is typed or pasted, rows are moved, repeated and removed.

import { h, fill } from './dom.js';
import { expectedKeys } from './expected.js';
import { Field } from './field.js';
import { Group } from './group.js';
import { helpFor } from './help.js';
import { childOf, plain } from './jsonc.js';
import { labelOf } from './labels.js';
import { cellsOf, pasteInto } from './paste.js';
import { exchange, repeat } from './rows.js';
import { isLeaf } from './schema.js';
import { t } from './words.js';

export class Table {
  constructor(form, parts, field, { flat = false, removable = true } = {}) {
    Object.assign(this, { form, parts, field, rows: [], chosen: new Set(), title: labelOf(parts.at(-1)), rowFaults: new Map(), own: [] });
    this.item = form.schema.field(field.item);
    this.leaves = this.item.kind === 'object' ? Object.keys(this.item.properties).filter((key) => isLeaf(this.fieldOf(key))) : null;
    this.nested = this.item.kind === 'object' ? Object.keys(this.item.properties).filter((key) => !this.leaves.includes(key)) : [];
    this.heading = h('tr');
    this.body = h('tbody', { onkeydown: (event) => this.pressed(event), onpaste: (event) => this.pasted(event), onfocusin: (event) => this.entered(event.target), onpointerdown: () => { this.begun = null; } });
    this.body.addEventListener('focusout', ({ relatedTarget }) => { if (!this.body.contains(relatedTarget)) this.begun = null; });
    this.list = h('ul.field-faults', { hidden: true });
    this.columnSelect = h('select', { 'aria-label': t('form-column'), onchange: () => this.addColumn() });
    const tools = h('div.field-tools', {},
      h('button', { type: 'button', onclick: () => this.append() }, t('form-add-row')), this.leaves ? this.columnSelect : null,
      h('span.hint', {}, t('form-paste')));
    this.element = h('section.field-group', { 'aria-label': this.title });
    if (!flat) this.element.append(...this.head(removable));
    this.element.append(this.list, h('div.field-scroll', {}, h('table.field-table', {}, h('thead', {}, this.heading), this.body)), tools);
    form.register(this);
  }

  head(removable) {
    const { button, note } = helpFor(this.field, this.parts, this.title);
    const remove = removable ? h('button.field-remove.quiet', {
      type: 'button', 'aria-label': t('form-remove', { name: this.title }), onclick: () => this.form.put(this.parts, undefined),
    }, '×') : null;
    return [h('div.field-head', {}, h('h3', {}, this.title), button, remove), note];
  }

  fieldOf(key) {
    return this.form.schema.field(this.item.kind === 'object' ? this.item.properties[key] : this.item.item);
  }

  /* From the text */

  update(node) {
    this.node = node;
    const items = node?.items ?? [];
    const columns = this.columnsFor(items);
    if (columns.join() !== this.columns?.join()) this.setColumns(columns);
    while (this.rows.length > items.length + 1) this.rows.pop().remove();
    while (this.rows.length < items.length + 1) this.rows.push(new Row(this, this.rows.length));
    this.rows.forEach((row, index) => row.update(items[index]));
    this.stops();
  }

  // Tab goes through the cells of one row: the one that had the focus last.
  stops() {
    if (!this.rows.includes(this.current)) this.current = this.rows[0];
    for (const row of this.rows) row.setStops(row === this.current);
  }

  entered(target) {
    const row = this.rows.find((one) => one.element.contains(target));
    if (!row || row === this.current) return;
    this.current = row;
    this.stops();
  }

  columnsFor(items) {
    if (!this.leaves) {
      const most = Math.max(2, ...items.map((item) => item.items?.length ?? 0));
      return Array.from({ length: most }, (_, index) => index);
    }
    const shown = new Set(this.chosen);
    for (const item of items) {
      const value = plain(item);
      for (const key of Object.keys(value ?? {})) shown.add(key);
      for (const key of expectedKeys(this.item.schema, value).own) shown.add(key);
    }
    if (!items.length) for (const key of expectedKeys(this.item.schema, {}).own) shown.add(key);
    for (const { path } of this.form.faultsBelow(this.parts)) if (path.length === this.parts.length + 2) shown.add(path.at(-1));
    return this.leaves.filter((key) => shown.has(key));
  }

  setColumns(columns) {
    this.columns = columns;
    const named = (key) => (this.leaves ? labelOf(key) : this.columnName(key));
    const help = (key) => (this.leaves ? this.fieldOf(key).help : '');
    fill(this.heading, h('th', { scope: 'col' }, '#'), columns.map((key) => h('th', { scope: 'col', title: help(key) }, named(key))), h('th', {}, h('span.only-read', {}, t('form-row'))));
    const others = this.leaves?.filter((key) => !columns.includes(key)) ?? [];
    this.columnSelect.hidden = !others.length;
    fill(this.columnSelect, h('option', { value: '' }, t('form-column')), others.map((key) => h('option', { value: key }, labelOf(key))));
  }

  columnName(index) {
    return { table: ['T [s]', 'S_a'], vertical: ['T [s]', 'S_a'] }[this.parts.at(-1)]?.[index] ?? String(index + 1);
  }

  addColumn() {
    if (this.columnSelect.value) this.chosen.add(this.columnSelect.value);
    this.update(this.node);
    this.rows[0]?.cells.get(this.columns.at(-1))?.focus();
  }

  /* Rows */

  get count() { return this.node?.items?.length ?? 0; }

  async append() {
    const last = this.count - 1;
    const { document } = this.form;
    if (last >= 0) document.replace(repeat(document.text, document.root, this.parts, last), { origin: 'form' });
    (last >= 0 ? this.rows[last + 1] : this.rows[0])?.focus();
  }

  repeat(index) {
    const { document } = this.form;
    document.replace(repeat(document.text, document.root, this.parts, index), { origin: 'form' });
    this.rows[index + 1]?.focus();
  }

  move(index, step) {
    const column = this.columnOf(document.activeElement);
    const { document: file } = this.form;
    file.replace(exchange(file.text, file.root, this.parts, Math.min(index, index + step)), { origin: 'form' });
    this.rows[index + step]?.focus(column);
  }

  async removeRow(index) {
    await this.form.put([...this.parts, index], undefined);
    this.rows[Math.min(index, this.count)]?.focus();
  }

  columnOf(element) {
    return this.columns.find((key) => this.rows.some((row) => row.cells.get(key)?.control === element));
  }

  pressed(event) {
    const row = this.rows.findIndex((one) => one.element.contains(event.target));
    const column = this.columnOf(event.target);
    if (row < 0 || column === undefined) return;
    // As in a spreadsheet, Enter after Tab goes on where the row was begun.
    if (event.key === 'Tab') this.begun ??= column;
    const from = event.key === 'Enter' ? this.begun ?? column : column;
    if (['Enter', 'ArrowUp', 'ArrowDown'].includes(event.key)) this.begun = null;
    const step = { ArrowUp: -1, ArrowDown: 1, Enter: event.shiftKey ? -1 : 1 }[event.key];
    if (!step || (event.target.tagName === 'SELECT' && event.key !== 'Enter') || event.ctrlKey) return;
    event.preventDefault();
    if (event.altKey && event.key !== 'Enter') {
      if (row + step >= 0 && row + step < this.count && row < this.count) this.move(row, step);
      return;
    }
    this.rows[row].cells.get(column).finish?.();
    // The row below may be made by what was just finished.
    this.form.afterEdits(() => this.rows[row + step]?.focus(from));
  }

  pasted(event) {
    const cells = cellsOf(event.clipboardData.getData('text/plain'));
    const row = this.rows.findIndex((one) => one.element.contains(event.target));
    const column = this.columns.indexOf(this.columnOf(event.target));
    if (row < 0 || column < 0 || (cells.length === 1 && cells[0].length === 1)) return;
    event.preventDefault();
    pasteInto(this, cells, row, column);
  }

  /* Faults */

  setFaults(faults) {
    this.own = faults;
    this.showFaults();
  }

  setRowFaults(index, faults) {
    const inRow = (text) => text && `${t('form-row')} ${index + 1}: ${text}`;
    const german = (fault) => fault.german && { ...fault.german, message: inRow(fault.german.message) };
    this.rowFaults.set(index, faults.map((fault) => ({ ...fault, message: inRow(fault.message), german: german(fault) })));
    this.showFaults();
  }

  showFaults() {
    this.form.listFaults(this.list, [...this.own, ...[...this.rowFaults.values()].flat()]);
  }

  focus() {
    this.rows[0]?.focus();
    this.element.scrollIntoView({ block: 'start' });
  }

  remove() {
    for (const row of this.rows) row.remove();
    this.form.unregister(this);
    this.element.remove();
  }
}

class Row {
  constructor(table, index) {
    Object.assign(this, { table, form: table.form, index, parts: [...table.parts, index], cells: new Map() });
    this.number = h('th', { scope: 'row' }, String(index + 1));
    this.tools = h('td.field-row-tools', { role: 'toolbar', 'aria-label': `${t('form-row')} ${index + 1}`, onkeydown: (event) => this.toolKey(event) });
    this.element = h('tr', {}, this.number, this.tools);
    this.more = h('tr.field-row-more', { hidden: true }, h('td', { colspan: 12 }));
    table.body.append(this.element, this.more);
    this.form.register(this);
  }

  update(node) {
    const { columns } = this.table;
    if (this.columns !== columns) this.setColumns(columns);
    const value = plain(node);
    const wanted = this.table.leaves && node ? expectedKeys(this.table.item.schema, value).own : new Set(node ? columns : []);
    for (const [key, cell] of this.cells) {
      cell.update(childOf(node, key));
      cell.setRequired(wanted.has(key));
    }
    this.element.classList.toggle('field-new', !node);
    this.updateTools(Boolean(node));
    this.updateMore(node);
  }

  setColumns(columns) {
    for (const [key, cell] of this.cells) {
      if (columns.includes(key)) continue;
      cell.element.parentNode.remove();
      cell.remove();
      this.cells.delete(key);
    }
    let before = this.number;
    for (const key of columns) {
      if (!this.cells.has(key)) this.cells.set(key, this.makeCell(key));
      const cell = this.cells.get(key).element.parentNode ?? h('td', {}, this.cells.get(key).element);
      if (before.nextSibling !== cell) before.after(cell);
      before = cell;
    }
    this.columns = columns;
  }

  makeCell(key) {
    const name = this.table.leaves ? labelOf(key) : this.table.columnName(key);
    const cell = new Field(this.form, [...this.parts, key], this.table.fieldOf(key), { bare: true, label: `${name}, ${t('form-row')} ${this.index + 1}` });
    cell.above = () => this.table.rows[this.index - 1]?.cells.get(key)?.shown ?? '';
    return cell;
  }

  updateTools(real) {
    const last = this.index === this.table.count - 1;
    const state = `${real}${last}`;
    if (this.state === state) return;
    this.state = state;
    const button = (sign, words, act, off = false) => h('button.quiet', {
      type: 'button', title: t(words), 'aria-label': `${t(words)}, ${t('form-row')} ${this.index + 1}`, disabled: off, onclick: act,
    }, sign);
    const { table, index } = this;
    const at = [...this.tools.children].indexOf(document.activeElement);
    fill(this.tools, real ? [
      table.nested.length ? button('⋯', 'form-row-more', () => this.toggleMore()) : null,
      button('↑', 'form-row-up', () => table.move(index, -1), index === 0), button('↓', 'form-row-down', () => table.move(index, 1), last),
      button('+', 'form-row-repeat', () => table.repeat(index)), button('×', 'form-row-remove', () => table.removeRow(index)),
    ] : []);
    this.setStops(this === table.current);
    this.tools.children[at]?.focus();
  }

  // One stop of Tab for the buttons of a row; arrows go between them.
  setStops(on) {
    for (const { control } of this.cells.values()) control.tabIndex = on ? 0 : -1;
    [...this.tools.children].forEach((tool, place) => { tool.tabIndex = on && !place ? 0 : -1; });
  }

  toolKey(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const tools = [...this.tools.children].filter((tool) => !tool.disabled);
    if (step) tools[tools.indexOf(event.target) + step]?.focus();
  }

  // Layers and bars of a row stand below it.
  updateMore(node) {
    const { nested, item } = this.table;
    const given = Boolean(node) && nested.some((key) => childOf(node, key) !== undefined);
    const shown = Boolean(node) && nested.length > 0 && (given || this.wide || nested.some((key) => this.form.mustShow([...this.parts, key])));
    this.more.hidden = !shown;
    if (shown && !this.group) {
      this.group = new Group(this.form, this.parts, item, { only: nested, flat: true });
      this.group.fold.open = true;
      this.more.firstElementChild.append(this.group.element);
    }
    if (shown) this.group.update(node);
    else this.dropGroup();
  }

  toggleMore() {
    this.wide = !this.wide;
    this.updateMore(childOf(this.table.node, this.index));
  }

  dropGroup() {
    if (!this.group) return;
    this.group.remove();
    this.group = null;
    this.form.register(this);
  }

  setFaults(faults) {
    this.table.setRowFaults(this.index, faults);
  }

  focus(column = this.table.columns[0]) {
    const control = this.cells.get(column)?.control;
    control?.focus();
    control?.select?.();
  }

  remove() {
    this.dropGroup();
    for (const cell of this.cells.values()) cell.remove();
    this.table.rowFaults.delete(this.index);
    this.form.unregister(this);
    this.element.remove();
    this.more.remove();
  }
}
