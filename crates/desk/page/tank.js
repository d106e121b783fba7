// The room Tank: form and text of the tank on one side, sketch, verdict and sheet on the other, all of one document.

import { toolbar } from './areas.js';
import { Checks, stateOf } from './check.js';
import { openDocument } from './document.js';
import { fill, h } from './dom.js';
import { chooseFile, chooseTemplate } from './files.js';
import { findField } from './find.js';
import { Form } from './form.js';
import { plain } from './jsonc.js';
import { labelAt } from './labels.js';
import { isMissing, marked, placeOf, tongue, withoutStyles, wording } from './marked.js';
import { parsePath, valueAt } from './path.js';
import { Schema } from './schema.js';
import { Sheet } from './sheet.js';
import { Solver } from './solve.js';
import { TextEditor } from './text.js';
import { moment, t } from './words.js';
import './tank-words.js';

export function mount(element, desk) {
  const room = new TankRoom(element, desk);
  return { show: (args) => room.show(args ?? {}), hide: () => room.hide() };
}

class TankRoom {
  constructor(element, desk) {
    Object.assign(this, { element, desk, shown: false, mode: 'form' });
    this.ready = this.start();
    addEventListener('keydown', (event) => this.pressed(event), { capture: true });
    desk.shortcut?.('Ctrl+Z', 'tank-key-undo');
    desk.shortcut?.('Ctrl+Shift+Z', 'tank-key-redo');
    desk.shortcut?.('Ctrl+E', 'tank-key-text');
    desk.shortcut?.('Enter ↑ ↓', 'tank-key-row');
    desk.shortcut?.('Alt+↑ ↓', 'tank-key-move');
    desk.shortcut?.('↑ ↓', 'tank-key-checks');
    desk.shortcut?.('Ctrl+K', 'tank-find');
    desk.shortcut?.('F1', 'tank-key-help');
  }

  async start() {
    try {
      this.desk.document ??= await openDocument(this.desk);
      while (!(await this.readSchema()));
    } catch (error) {
      fill(this.element, h('p.empty', {}, error.message));
      throw error;
    }
    this.build();
    const { events } = this.desk;
    events.addEventListener('text', (event) => this.changed(event.detail.origin));
    events.addEventListener('checked', (event) => this.checked(event.detail));
    events.addEventListener('tank-sheet', () => this.element.classList.remove('tank-with-sheet'));
    events.addEventListener('settings', (event) => this.settingChanged(event.detail?.name));
  }

  get document() { return this.desk.document; }

  /** The schema, its descriptions in the language of the page; whether that still is the language when it has come. */
  async readSchema() {
    const { language } = this.desk.settings;
    const schema = new Schema(await this.desk.api.get('schema', { language }));
    if (language !== this.desk.settings.language) return false;
    this.schema = schema;
    return true;
  }

  async show(args) {
    this.shown = true;
    await this.ready;
    if (args.path && args.path !== this.document.path) await this.document.open(args.path).catch((error) => this.desk.sayError(error));
    if (args.field) this.goTo(parsePath(args.field));
    if (args.check && this.checks.results) {
      const method = this.checks.results.methods.findIndex((one) => one.id === args.check.method);
      const check = this.checks.results.methods[method]?.checks.find((one) => one.id === args.check.id);
      if (method >= 0) this.openSheet(method, check ?? null);
    }
    this.text.update();
  }

  hide() { this.shown = false; }

  build() {
    this.form = new Form(this.desk, this.schema);
    this.text = new TextEditor(this.desk, this.form);
    this.checks = new Checks(this.desk, (method, check) => this.openSheet(method, check), (path) => this.goTo(parsePath(path)));
    this.sheet = new Sheet(this.desk, (parts) => this.goTo(parts));
    this.solver = new Solver(this.desk);
    this.draft = h('div.tank-draft.panel', { hidden: true });
    this.faultList = h('details.tank-faults.panel', { open: true, hidden: true });
    this.sketch = h('figure.tank-sketch', { 'aria-label': t('tank-sketch') });
    this.formPane = h('div.tank-pane', {}, this.form.element);
    this.textPane = h('div.tank-pane', { hidden: true }, this.text.element);
    this.begin = this.startPanel();
    this.work = h('div.tank-work', {}, this.form.nav, h('div.tank-data', { dataset: { area: '' } }, this.faultList, this.formPane, this.textPane),
      h('div.tank-side', { id: 'tank-side', dataset: { area: '' } }, h('div.panel.tank-sketch-panel', {}, this.sketch), h('div.panel', {}, this.checks.element)), this.sheet.element);
    this.strip = h('a.tank-strip', { href: '#tank-side', onclick: (event) => { event.preventDefault(); this.element.querySelector('#tank-side').scrollIntoView({ block: 'start' }); } });
    this.bar = this.toolbar();
    this.drawBar = toolbar(this.bar);
    const skip = h('a.skip', { href: '#tank-side', onclick: (event) => { event.preventDefault(); this.checks.focus(); } }, t('tank-skip'));
    fill(this.element, skip, this.bar, this.draft, this.solver.element, this.begin, this.work, this.strip);
    this.setMode(this.mode);
    this.changed('open');
    if (this.document.check) this.checked(this.document.check);
  }

  toolbar() {
    const button = (words, act, keys = '') => h('button', { type: 'button', title: keys, onclick: act }, t(words));
    this.undoButton = button('tank-undo', () => this.document.undo(), 'Ctrl+Z');
    this.redoButton = button('tank-redo', () => this.document.redo(), 'Ctrl+Shift+Z');
    this.saveButton = button('doc-save', () => this.document.save(), 'Ctrl+S');
    this.modes = ['form', 'text'].map((mode) => h('button', { type: 'button', dataset: { mode }, title: 'Ctrl+E', onclick: () => this.setMode(mode) }, t(`tank-${mode}`)));
    return h('div.tank-toolbar', { dataset: { area: '' }, role: 'toolbar', 'aria-label': t('tank-toolbar') },
      h('span.tank-modes', { role: 'group', 'aria-label': t('tank-view') }, this.modes),
      h('span', {}, button('tank-new', () => chooseTemplate(this.desk)), button('tank-open', () => chooseFile(this.desk)), this.saveButton, button('tank-save-as', () => this.document.saveAs())),
      h('span', {}, this.undoButton, this.redoButton, button('tank-find', () => this.find(), 'Ctrl+K')),
      h('span', {}, this.solver.buttons()));
  }

  startPanel() {
    return h('div.tank-begin.panel', { hidden: true }, h('h2', {}, t('tank-begin')), h('p', {}, t('tank-begin-says')),
      h('div.row', {}, h('button.primary', { type: 'button', onclick: () => chooseTemplate(this.desk) }, t('doc-templates')),
        h('button', { type: 'button', onclick: () => chooseFile(this.desk) }, t('doc-open')),
        h('button', { type: 'button', onclick: () => { this.document.startFrom('{\n}\n'); this.form.element.querySelector('input')?.focus(); } }, t('doc-empty'))));
  }

  async settingChanged(name) {
    if (name === 'language') {
      this.sheet.close();
      // Without an answer the form keeps the help that it has.
      const read = await this.readSchema().catch(() => true);
      if (read) this.build();
    }
    if (name === 'units') {
      this.form.update();
      if (this.checks.answer) this.checks.update(this.checks.answer);
    }
  }

  setMode(mode) {
    this.mode = mode;
    this.formPane.hidden = mode !== 'form';
    this.form.nav.hidden = mode !== 'form';
    this.textPane.hidden = mode !== 'text';
    for (const button of this.modes) button.setAttribute('aria-pressed', String(button.dataset.mode === mode));
    this.element.classList.toggle('tank-text-mode', mode === 'text');
    if (mode === 'text') this.text.update();
  }

  /* Events */

  changed(origin) {
    const { document } = this;
    this.begin.hidden = !document.empty;
    this.work.hidden = document.empty;
    this.strip.hidden = document.empty;
    this.bar.hidden = document.empty;
    if (origin === 'open' || origin === 'undo') this.form.forgetTyping();
    if (origin === 'open' && !document.check) this.clear();
    this.form.update();
    this.text.update();
    this.undoButton.disabled = !document.canUndo;
    this.redoButton.disabled = !document.canRedo;
    this.saveButton.disabled = !document.dirty && document.path !== null;
    this.drawBar();
    this.drawDraft();
  }

  clear() {
    this.checks.clear();
    this.solver.clear();
    this.sketch.replaceChildren();
    this.setFaults([]);
    this.drawStrip();
  }

  checked(given) {
    const answer = this.document.untouched ? { ...given, faults: [], untouched: true } : given;
    this.checks.update(answer);
    if (answer.sketch) this.drawSketch(answer.sketch);
    this.sketch.classList.toggle('check-old', !answer.sketch);
    this.setFaults(answer.faults ?? [], answer.text);
    this.form.setMaterials(answer.results);
    this.sheet.update(answer.results);
    this.drawStrip();
  }

  // The server draws the sketch to scale; equal ones are not put again.
  drawSketch(svg) {
    if (this.lastSketch === svg && this.sketch.childNodes.length) return;
    this.lastSketch = svg;
    this.sketch.innerHTML = withoutStyles(svg);
  }

  drawStrip() {
    const verdict = this.checks.results?.verdict;
    const faults = this.checks.answer?.faults?.length ?? 0;
    this.strip.dataset.status = faults ? (this.checks.head.dataset.status === 'open' ? 'open' : 'faulty') : stateOf(verdict);
    fill(this.strip, h('strong', {}, this.checks.status.textContent), faults ? '' : ` ${verdict?.governing?.check?.name ?? ''}`);
  }

  drawDraft() {
    const { draft } = this.document;
    this.draft.hidden = !draft;
    if (!draft) return;
    fill(this.draft, h('p', {}, t('doc-draft', { when: moment(draft.at) })), h('div.row', {},
      h('button.primary', { type: 'button', onclick: () => this.document.settleDraft(true) }, t('doc-draft-take')),
      h('button', { type: 'button', onclick: () => this.document.settleDraft(false) }, t('doc-draft-drop'))));
  }

  setFaults(faults, text = this.document.text) {
    this.form.setFaults(faults);
    this.text.setFaults(text === this.document.text ? faults : []);
    this.countText(faults.filter((fault) => !placeOf(fault).length).length);
    this.faultList.hidden = !faults.length;
    const missing = faults.filter(isMissing).length;
    const value = plain(this.document.root);
    const summary = h('summary', {}, t(missing === faults.length ? 'tank-missing' : 'tank-faulty', { count: faults.length }));
    fill(this.faultList, summary, h('ul', {}, faults.map((fault) => h('li', { class: isMissing(fault) ? 'field-missing' : '' },
      h('button.link', { type: 'button', onclick: () => this.goToFault(fault) }, placeWords(fault, value)), ' ', h('span', { lang: tongue(fault) }, marked(wording(fault)))))));
  }

  // A fault of the text as such belongs to no group of the form: it is counted at the text.
  countText(count) {
    fill(this.modes[1], t('tank-text'), count ? h('span.field-count', { title: t('form-faults', { count }) }, String(count)) : null);
  }

  goToFault(fault) {
    if (this.mode === 'form' && this.form.focusPath(placeOf(fault))) return;
    this.setMode('text');
    this.text.update();
    this.text.goTo(fault.start ?? 0, fault.end);
  }

  goTo(parts) {
    this.setMode('form');
    this.form.reveal(parts);
  }

  async find() {
    if (this.document.empty) return;
    const parts = await findField(this.desk, this.schema);
    if (parts) this.goTo(parts);
  }

  openSheet(method, check) {
    if (!this.checks.results) return;
    this.element.classList.add('tank-with-sheet');
    this.sheet.open(method, check, this.checks.results);
  }

  pressed(event) {
    if (!this.shown || !(event.ctrlKey || event.metaKey) || event.altKey || document.querySelector('dialog[open]')) return;
    const key = event.key.toLowerCase();
    if (key === 'z' || key === 'y') {
      event.preventDefault();
      event.stopPropagation();
      if (this.form.takeBackTyping()) return;
      if (key === 'y' || event.shiftKey) this.document.redo();
      else this.document.undo();
    } else if (key === 'e') {
      event.preventDefault();
      this.setMode(this.mode === 'form' ? 'text' : 'form');
      if (this.mode === 'text') this.text.area.focus();
    } else if (key === 'k') {
      event.preventDefault();
      this.find();
    } else if (key === 's') {
      this.form.finishTyping();
    }
  }
}

// The words for the place of a fault: the names of its keys, or its line.
function placeWords(fault, value) {
  const parts = placeOf(fault);
  if (!parts.length) return t('text-line', { line: fault.line });
  const label = (part, index) => labelAt(parts.slice(0, index + 1), valueAt(value, parts.slice(0, index)));
  return parts.map((part, index) => (typeof part === 'number' ? `${t('form-row')} ${part + 1}` : label(part, index))).join(' › ');
}
