// The form of a tank, made from the schema and grouped as a data sheet. It is brought up to date in place: what has the
// focus keeps it, and what is being typed stays.

import { h, fill, uniqueId } from './dom.js';
import { faultItem } from './field.js';
import { Group } from './group.js';
import { nodeAt, plain } from './jsonc.js';
import { List } from './list.js';
import { Named } from './map.js';
import { isMissing, placeOf } from './marked.js';
import { formatPath, parsePath, valueAt } from './path.js';
import { rename } from './rows.js';
import { SECTIONS, keysOf } from './sections.js';
import { Table } from './table.js';
import { Union } from './union.js';
import { show } from './units.js';
import { showAs } from './views.js';
import { t } from './words.js';
import './form-words.js';

showAs('object', (form, parts, field, options) => new Group(form, parts, field, options));
showAs('union', (form, parts, field, options) => new Union(form, parts, field, options));
showAs('map', (form, parts, field, options) => new Named(form, parts, field, options));
showAs('list', (form, parts, field, options) => {
  const kind = form.schema.field(field.item).kind;
  return kind === 'object' || kind === 'list' ? new Table(form, parts, field, options) : new List(form, parts, field, options);
});

export class Form {
  constructor(desk, schema) {
    Object.assign(this, { desk, schema, views: new Map(), faults: [], faulty: new Set(), revealed: new Set(), sections: [] });
    this.names = h('datalist', { id: uniqueId('materials') });
    this.grades = h('datalist', { id: uniqueId('grades') });
    this.nav = h('nav.tank-nav', { 'aria-label': t('form-groups') });
    this.element = h('div.tank-form', {}, this.names, this.grades);
    this.readGrades();
    this.build();
  }

  get document() { return this.desk.document; }
  get units() { return this.desk.settings.units; }

  readGrades() {
    const help = this.schema.field(this.schema.json.$defs?.Material?.properties?.grade ?? {}).help;
    const lists = [...help.matchAll(/(?:Plates|Concrete|Bars|Bleche|Beton|Stäbe): ([^\n]*?)\.(?=\s(?:Bars|Stäbe|$)|\n|$)/g)].map((match) => match[1]);
    const names = lists.join(', ').replace(/\([^)]*\)/g, '').split(',').map((name) => name.trim()).filter(Boolean);
    this.gradeNames = new Set(names);
    fill(this.grades, names.map((name) => h('option', { value: name })));
  }

  isGrade(name) { return this.gradeNames.has(name) || this.gradeNames.has(name.replace(/^A /, 'A')); }
  isMaterial(name) { return Boolean(this.materials?.includes(name)); }

  build() {
    const root = this.schema.field(this.schema.json);
    for (const section of SECTIONS) {
      if (!this.hasKeys(root, section)) continue;
      const id = `tank-section-${section.id}`;
      const count = h('span.field-count', { hidden: true });
      const heading = h('h2', { id, tabindex: -1 }, t(`form-section-${section.id}`), count);
      const body = h('div.tank-section-body');
      const element = section.folded
        ? h('details.tank-section.panel', {}, h('summary', {}, heading), body) : h('section.tank-section.panel', { 'aria-labelledby': id }, heading, body);
      const link = h('a', { href: `#${id}`, onclick: (event) => { event.preventDefault(); this.showSection(one); } }, t(`form-section-${section.id}`), h('span.field-count', { hidden: true }));
      const one = { ...section, element, count, link, heading, views: [] };
      for (const part of section.parts) one.views.push(this.makePart(root, part, body));
      // A group of one key has its heading already.
      element.classList.toggle('tank-single', section.parts.length === 1 && section.parts[0].keys?.length === 1);
      this.nav.append(link);
      this.element.append(element);
      this.sections.push(one);
    }
  }

  fieldAt(root, path) { return path.reduce((at, key) => this.schema.field(at.properties[key]), root); }

  // A schema need not have the keys of every group.
  hasKeys(root, section) {
    return section.parts.some((part) => {
      const field = this.fieldAt(root, part.path);
      return keysOf(field, part).some((key) => key in field.properties);
    });
  }

  makePart(root, part, body) {
    const field = this.fieldAt(root, part.path);
    const view = new Group(this, part.path, field, { only: keysOf(field, part), flat: true });
    body.append(view.element);
    return { view, path: part.path };
  }

  showSection(section) {
    if (section.element.tagName === 'DETAILS') section.element.open = true;
    section.element.scrollIntoView({ block: 'start' });
    section.heading.focus({ preventScroll: true });
  }

  /* From the text */

  update() {
    const { root } = this.document;
    this.materials = (nodeAt(root, ['materials'])?.members ?? []).map((member) => member.key);
    const known = this.materials.join('\n');
    if (this.names.dataset.known !== known) {
      this.names.dataset.known = known;
      const grades = [...this.gradeNames].filter((name) => !this.materials.includes(name));
      fill(this.names, [...this.materials, ...grades].map((name) => h('option', { value: name })));
    }
    for (const section of this.sections) for (const { view, path } of section.views) view.update(nodeAt(root, path));
  }

  valueAt(parts) { return plain(nodeAt(this.document.root, parts)); }

  /** Takes what the program knows of the materials, so that fields left empty show the value of the grade. */
  setMaterials(results) {
    if (!results) return;
    const known = materialsOf(results.tank);
    const picture = JSON.stringify([...known]);
    if (this.knownMaterials === picture) return;
    this.knownMaterials = picture;
    this.known = known;
    this.update();
  }

  /** What an empty field of a material with a grade stands for, or null where it is no such field. */
  fromGrade(parts, field) {
    if (parts[0] !== 'materials' || parts.length < 3 || parts[2] === 'grade' || !this.valueAt([...parts.slice(0, 2), 'grade'])) return null;
    const value = valueAt(this.known?.get(parts[1]), parts.slice(2));
    if (typeof value !== 'number') return t('form-from-grade');
    return t('form-value-from-grade', { value: show(value, field.dimensions?.[0], this.units) });
  }

  /* To the text */

  /** Sets a value of the document, where it is another one. */
  put(parts, value, key = null) {
    if (JSON.stringify(this.valueAt(parts)) === JSON.stringify(value) && !this.document.pending) return Promise.resolve();
    return this.document.set(parts, value, key);
  }

  /** Calls `act` when all changes have reached the form. */
  async afterEdits(act) {
    await this.document.working;
    act();
  }

  /* Typing */

  fields() { return [...this.views.values()].flat().filter((view) => view.control); }

  /** After undo or another file the fields show the text, not what was typed. */
  forgetTyping() {
    this.revealed.clear();
    for (const field of this.fields()) field.forget();
  }

  finishTyping() {
    for (const field of this.fields()) field.finish();
  }

  /** Takes back what is typed but not yet in the text; says whether there was something. */
  takeBackTyping() {
    return this.fields().some((field) => field.takeBack());
  }

  /* Views by path */

  register(view) {
    const path = formatPath(view.parts);
    const views = (this.views.get(path) ?? []).filter((one) => one !== view);
    this.views.set(path, [...views, view]);
  }

  unregister(view) {
    const path = formatPath(view.parts);
    const views = (this.views.get(path) ?? []).filter((one) => one !== view);
    if (views.length) this.views.set(path, views);
    else this.views.delete(path);
  }

  /** Shows a key, also one that is folded or whose object is not given, and moves the focus there. */
  reveal(parts) {
    parts.forEach((_, index) => this.revealed.add(formatPath(parts.slice(0, index + 1))));
    this.update();
    return this.focusPath(parts);
  }

  focusPath(parts) {
    for (let length = parts.length; length > 0; length -= 1) {
      const view = this.views.get(formatPath(parts.slice(0, length)))?.at(-1);
      if (!view?.element.isConnected) continue;
      for (let at = view.element.parentElement; at && at !== this.element; at = at.parentElement) if (at.tagName === 'DETAILS') at.open = true;
      view.focus();
      return true;
    }
    return false;
  }

  /* Faults */

  /** Whether a key is shown though it is not given: it has a fault, or somebody looks for it. */
  mustShow(parts) {
    const path = formatPath(parts);
    return this.faulty.has(path) || this.revealed.has(path);
  }

  faultsBelow(parts) {
    const before = formatPath(parts);
    return this.faults.filter((fault) => formatPath(fault.path.slice(0, parts.length)) === before);
  }

  /** Shows the faults at their fields, or at the nearest group around them. */
  setFaults(faults) {
    const was = [...this.faulty].join();
    this.faults = faults.map((fault) => ({ fault, path: placeOf(fault) }));
    this.faulty = new Set(this.faults.flatMap(({ path }) => path.map((_, index) => formatPath(path.slice(0, index + 1)))));
    if ([...this.faulty].join() !== was) this.update();
    const found = new Map();
    for (const { fault, path } of this.faults) {
      const view = this.nearest(path);
      if (view) found.set(view, [...(found.get(view) ?? []), fault]);
    }
    for (const views of this.views.values()) for (const view of views) view.setFaults?.(found.get(view) ?? []);
    for (const section of this.sections) this.countFaults(section);
  }

  nearest(path) {
    for (let length = path.length; length > 0; length -= 1) {
      const views = this.views.get(formatPath(path.slice(0, length))) ?? [];
      const view = views.length > 1 && length < path.length ? views.find((one) => one.keys?.includes(path[length])) ?? views[0] : views[0];
      if (view?.element.isConnected) return view;
    }
    return null;
  }

  countFaults(section) {
    const own = this.faults.filter(({ path }) => section.parts.some((part) => belongs(path, part, this.schema)));
    const count = own.length;
    const missing = own.every(({ fault }) => isMissing(fault));
    for (const badge of [section.count, section.link.lastElementChild]) {
      badge.hidden = count === 0;
      badge.classList.toggle('field-missing', missing);
      badge.textContent = String(count);
      badge.title = t('form-faults', { count });
    }
  }

  listFaults(list, faults) {
    if (!faults.length && list.hidden) return;
    list.hidden = !faults.length;
    fill(list, faults.map((fault) => faultItem(this, fault)));
  }

  /** Buttons that mend a fault where the way is clear. */
  remedies(fault) {
    const buttons = [];
    if (fault.code === 'T0209' && /is a grade/.test(fault.help ?? '')) {
      const name = /"((?:[^"\\]|\\.)*)"\s*$/.exec(fault.found ?? '')?.[1] ?? fault.found;
      buttons.push(h('button', { type: 'button', onclick: () => this.put(['materials', name], { grade: name }) }, t('form-add-grade', { name })));
    }
    if (fault.code === 'T0104') {
      buttons.push(h('button', { type: 'button', onclick: () => this.desk.go('records') }, t('form-choose-record')));
    }
    if (fault.code === 'T0206') {
      const meant = /did you mean `([^`]+)`/.exec(fault.help ?? '')?.[1];
      const { document } = this;
      if (meant) {
        const text = rename(document.text, document.root, parsePath(fault.path), meant);
        buttons.push(h('button', { type: 'button', onclick: () => document.replace(text, { origin: 'form' }) }, t('form-rename-key', { name: meant })));
      }
      buttons.push(h('button', { type: 'button', onclick: () => this.put(parsePath(fault.path), undefined) }, t('form-remove-key')));
    }
    return buttons;
  }
}

// The materials that parts of the tank have, by their names.
function materialsOf(part, found = new Map()) {
  if (part === null || typeof part !== 'object') return found;
  if (typeof part.name === 'string' && part.behaviour) found.set(part.name, part);
  for (const inner of Object.values(part)) materialsOf(inner, found);
  return found;
}

function belongs(path, part, schema) {
  if (part.path.some((key, index) => path[index] !== key)) return false;
  const next = path[part.path.length];
  const field = part.path.reduce((at, key) => schema.field(at.properties[key]), schema.field(schema.json));
  return keysOf(field, part).includes(next) || (part.rest === true && next !== undefined && !(next in field.properties));
}
