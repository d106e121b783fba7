// One value of the form: a text with its unit, a number, a choice, yes or no. What is typed goes to the document as soon as
// it is a complete value; what is not complete waits for the end of typing.

import { meaning } from './choices.js';
import { h, fill, uniqueId } from './dom.js';
import { helpFor } from './help.js';
import { labelAt } from './labels.js';
import { isMissing, marked, tongue, wording } from './marked.js';
import { formatPath } from './path.js';
import { complete, completed, converted, halved, split, tidy } from './quantity.js';
import { localised, t } from './words.js';

/** Texts that are short. */
const SHORT = new Set(['material', 'grade', 'date', 'revision', 'by', 'check']);

/** Number of times that a field was entered. */
let stays = 0;

/** Time without a key after which an incomplete value is judged all the same [ms]. */
const PAUSE = 1200;

export class Field {
  constructor(form, parts, field, { bare = false, label = labelAt(parts, null) } = {}) {
    Object.assign(this, { form, parts, field, label, required: false, before: '', typed: false, faults: [] });
    this.control = this.makeControl();
    this.control.id = uniqueId('value');
    this.control.dataset.path = formatPath(parts);
    this.hint = h('span.field-hint', { 'aria-live': 'polite' });
    this.list = h('ul.field-faults', { id: uniqueId('faults'), hidden: true });
    this.element = bare ? this.bare() : this.row();
    form.register(this);
  }

  row() {
    const { button, note, toggle } = helpFor(this.field, this.parts, this.label, { tabbed: false });
    this.control.addEventListener('keydown', (event) => {
      if (event.key !== 'F1') return;
      event.preventDefault();
      toggle();
    });
    const wide = this.field.kind === 'text' && !SHORT.has(this.parts.at(-1));
    this.named = h('label', { for: this.control.id }, this.label);
    return h('div.field-row', { class: wide ? 'field-wide' : '' },
      this.named, h('div.field-entry', {}, this.control, button, this.hint), note, this.list);
  }

  /** Another name for the same key: what it means may hang on its neighbours. */
  relabel(label) {
    if (this.label === label || !this.named) return;
    this.label = label;
    this.named.textContent = label;
  }

  bare() {
    this.control.setAttribute('aria-label', this.label);
    const wide = this.field.kind === 'text' && !SHORT.has(this.parts.at(-1));
    this.cell = true;
    return h('div.field-cell', { class: wide ? 'field-text' : '' }, this.control, this.hint, this.list);
  }

  makeControl() {
    const { kind } = this.field;
    if (kind === 'choice' || kind === 'boolean') return this.makeSelect();
    const long = this.parts.at(-1) === 'notes';
    const control = h(long ? 'textarea' : 'input', {
      type: long ? null : 'text', rows: long ? 3 : null, spellcheck: kind === 'text' ? null : 'false', autocomplete: 'off',
      inputmode: kind === 'number' || kind === 'integer' ? 'decimal' : null,
      list: this.suggestions(), oninput: () => this.typing(), onfocus: () => this.entered(), onblur: () => this.finish(),
    });
    control.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && !long) this.finish();
      if (event.key === 'Escape' && this.typed) this.reset(event);
    });
    return control;
  }

  makeSelect() {
    const options = this.field.kind === 'boolean' ? [{ value: true, title: t('form-yes') }, { value: false, title: t('form-no') }] : this.field.options;
    this.values = new Map(options.map((option) => [String(option.value), option.value]));
    this.nothing = h('option', { value: '' }, this.emptyWords());
    const title = ({ value, title: words, help }) => words ?? (help ? `${value} – ${meaning(help)}` : String(value));
    return h('select', { onchange: () => this.chosen() }, this.nothing, options.map((option) => h('option', { value: String(option.value) }, title(option))));
  }

  emptyWords() {
    if (this.field.default !== undefined) return t('form-default', { value: defaultWords(this.field.default) });
    return '–';
  }

  suggestions() {
    if (this.parts.at(-1) === 'material') return this.form.names.id;
    if (this.parts.at(-1) === 'grade') return this.form.grades.id;
    if (!this.field.suggestions?.length) return null;
    const list = h('datalist', { id: uniqueId('list') }, this.field.suggestions.map((value) => h('option', { value: String(value) })));
    this.form.element.append(list);
    return list.id;
  }

  /* From the text */

  update(node) {
    const text = node === undefined ? '' : node.type === 'string' ? node.value : node.raw ?? String(node.value ?? '…');
    this.shown = text;
    if (this.values) this.updateSelect(text);
    else if (!this.typed && this.control.value !== text && !(this.form.document.pending && this.hasFocus())) this.control.value = text;
    if (!this.values) this.control.placeholder = this.placeholder();
    this.updateHint();
  }

  updateSelect(text) {
    this.strange?.remove();
    this.strange = null;
    if (text !== '' && !this.values.has(text)) {
      this.strange = h('option', { value: text }, text);
      this.control.append(this.strange);
    }
    this.control.value = text;
  }

  hasFocus() { return document.activeElement === this.control; }

  placeholder() {
    const { field } = this;
    const graded = this.form.fromGrade(this.parts, field);
    if (graded !== null) return graded;
    if (field.default !== undefined) return defaultWords(field.default);
    if (!this.required && field.fallback) return field.fallback;
    // Beside a quantity, words such as "none" are answers.
    const words = field.kind === 'quantity' ? field.suggestions ?? [] : [];
    if (words.length) return [...words, ...(field.example !== undefined && !words.includes(field.example) ? [field.example] : [])].join(', ');
    return field.example === undefined ? '' : t('form-example', { value: field.example });
  }

  updateHint() {
    if (this.values) return;
    const text = this.control.value;
    if (this.typed && this.field.kind === 'quantity') {
      const whole = completed(this.field, this.isRadius() ? halved(text) : text, this.model(), this.form.units);
      const other = converted(this.field, whole, this.form.units);
      this.hint.textContent = whole === tidy(text) ? '' : `→ ${whole}${other ? ` = ${other}` : ''}`;
      if (this.hint.textContent) return;
    }
    const words = this.field.dimensions ? converted(this.field, text, this.form.units) : '';
    this.hint.textContent = this.cell ? '' : [words ? `= ${words}` : '', this.diameter(text)].filter(Boolean).join(' · ');
    this.control.title = words ? `${text} = ${words}` : '';
  }

  isRadius() { return this.field.kind === 'quantity' && formatPath(this.parts) === 'tank.radius'; }

  // Data sheets give the diameter.
  diameter(text) {
    if (!this.isRadius()) return '';
    const parts = split(text);
    if (text.trim() === '') return t('form-or-diameter');
    return parts?.unit && Number(parts.number) > 0 ? t('form-diameter', { value: localised(`${Number((2 * Number(parts.number)).toPrecision(12))} ${parts.unit}`) }) : '';
  }

  setRequired(required) {
    if (this.required === required) return;
    this.required = required;
    this.control.setAttribute('aria-required', String(required));
    this.element.classList.toggle('field-required', required);
  }

  /* To the text */

  entered() {
    this.before = this.shown ?? '';
    this.stay = (stays += 1);
  }

  typing() {
    this.typed = true;
    clearTimeout(this.timer);
    if (this.isComplete(this.control.value)) this.commit();
    else this.timer = setTimeout(() => this.commit(), PAUSE);
    this.updateHint();
  }

  isComplete(text) {
    const { kind } = this.field;
    if (text.trim() === '') return false;
    if (this.parts.at(-1) === 'material') return this.form.isMaterial(text.trim());
    if (kind === 'text') return !['grade', 'date', 'file', 'table', 'check'].includes(this.parts.at(-1));
    if (kind === 'quantity') return complete(this.field, text);
    return /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(tidy(text)) || this.field.patterns?.some((pattern) => pattern.test(tidy(text)));
  }

  /** The end of typing: a bare number gets its unit, where everybody sees it. */
  finish() {
    clearTimeout(this.timer);
    if (!this.typed) return;
    if (this.isRadius()) this.control.value = halved(this.control.value);
    if (this.field.kind === 'quantity') this.control.value = completed(this.field, this.control.value, this.model(), this.form.units);
    else if (this.field.kind !== 'text') this.control.value = tidy(this.control.value);
    this.commit();
    this.typed = false;
    this.before = this.control.value;
    this.updateHint();
  }

  reset(event) {
    event.stopPropagation();
    clearTimeout(this.timer);
    this.typed = false;
    this.control.value = this.before;
    this.put(this.valueOf(this.before));
    this.updateHint();
  }

  forget() {
    clearTimeout(this.timer);
    this.typed = false;
  }

  takeBack() {
    if (!this.typed || this.control.value === this.shown) return false;
    this.forget();
    this.control.value = this.shown;
    this.updateHint();
    return true;
  }

  chosen() { this.put(this.values.get(this.control.value)); }

  commit() { this.put(this.valueOf(this.isRadius() ? halved(this.control.value) : this.control.value)); }

  valueOf(text) {
    const { kind } = this.field;
    if (text.trim() === '') return undefined;
    if (kind === 'text') return text;
    const tidied = tidy(text);
    const number = Number(tidied);
    const bare = tidied !== '' && Number.isFinite(number);
    return bare && (kind === 'number' || kind === 'integer' || this.field.bare) ? number : tidied;
  }

  // What is typed while the field has the focus is one step of undo.
  put(value) { this.form.put(this.parts, value, `${formatPath(this.parts)} ${this.stay ?? ''}`); }

  /** The text whose unit a bare number gets: the value before it, or the one above it in a table. */
  model() { return this.before || this.above?.() || ''; }

  /** The value of a pasted cell; `unit` is that of the heading of its column, if any. */
  pasted(text, unit = '') {
    if (this.field.kind !== 'quantity') return this.valueOf(tidy(text));
    return this.valueOf(completed(this.field, text, unit || this.shown || this.model(), this.form.units));
  }

  /* Faults */

  setFaults(faults) {
    if (!faults.length && !this.faults.length) return;
    this.faults = faults;
    this.control.toggleAttribute('aria-invalid', faults.length > 0);
    if (faults.length) {
      this.control.setAttribute('aria-invalid', 'true');
      this.control.setAttribute('aria-describedby', this.list.id);
    } else {
      this.control.removeAttribute('aria-describedby');
    }
    this.list.hidden = !faults.length;
    fill(this.list, faults.map((fault) => faultItem(this.form, fault)));
  }

  focus() {
    this.control.focus();
    this.control.scrollIntoView({ block: 'center' });
  }

  remove() {
    clearTimeout(this.timer);
    this.form.unregister(this);
    this.element.remove();
  }
}

const defaultWords = (value) => (value === true ? t('form-yes') : value === false ? t('form-no') : typeof value === 'number' ? String(Number(value.toPrecision(6))) : String(value));

/** What to do about a fault. The program speaks of its options where the page has a room. */
const helpWords = (fault) => (fault.code === 'T0104' ? t('form-no-motion') : wording(fault, 'help'));

/** A fault in the words of the terminal, with what it found, what it takes and what to do. */
export function faultItem(form, fault) {
  const help = helpWords(fault);
  const own = help !== fault.help;
  return h('li', { class: isMissing(fault) ? 'field-missing' : '' }, h('strong', { lang: tongue(fault) }, marked(wording(fault))),
    fault.allowed ? h('span', { lang: tongue(fault, 'allowed') }, marked(t('form-expected', { what: wording(fault, 'allowed') }))) : null,
    help ? h('span', { lang: own ? null : 'en' }, marked(help)) : null, form.remedies(fault));
}
