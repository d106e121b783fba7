// The sheet of a check beside the form: its steps with substituted numbers, as the server renders them. It follows the text.

import { h, fill } from './dom.js';
import { nodeAt } from './jsonc.js';
import { marked, withoutStyles } from './marked.js';
import { parsePath } from './path.js';
import { decides } from './verdict.js';
import { t } from './words.js';

export class Sheet {
  /** `goTo(parts)` shows a field of the form. */
  constructor(desk, goTo) {
    Object.assign(this, { desk, goTo, shown: null });
    this.title = h('h2', { tabindex: -1 });
    this.tools = h('div.check-sheet-tools');
    this.body = h('div.check-sheet-body', { tabindex: 0 });
    this.element = h('aside.check-sheet.panel', { hidden: true, dataset: { area: '' } }, h('header', {}, this.title, this.tools), this.body);
    this.element.addEventListener('keydown', (event) => { if (event.key === 'Escape') this.close(); });
  }

  /** Shows the sheet of a check, or of the whole method where `check` is null. */
  async open(method, check, results) {
    this.from = document.activeElement;
    this.shown = { method, id: check?.id ?? null, check, results, decides: decides(results.verdict, results.methods[method]) };
    this.element.hidden = false;
    this.title.textContent = check?.name ?? results.methods[method]?.title ?? t('check-sheet');
    this.element.setAttribute('aria-label', `${t('check-sheet')}: ${this.title.textContent}`);
    const whole = check ? h('button', { type: 'button', onclick: () => this.open(method, null, this.shown.results) }, t('check-whole-sheet')) : null;
    const field = check?.input ? h('button', { type: 'button', onclick: () => this.goTo(parsePath(check.input)) }, t('check-input')) : null;
    const gap = check?.status === 'not_checked' && this.shown.decides ? h('button', { type: 'button', onclick: () => this.accept(method, check) }, t('check-accept')) : null;
    fill(this.tools, field, gap, whole, h('button.quiet', { type: 'button', 'aria-label': t('check-close'), title: 'Esc', onclick: () => this.close() }, '×'));
    this.title.focus({ preventScroll: true });
    this.body.scrollTop = 0;
    await this.load();
  }

  // Whoever accepts a gap says why; the form asks for it.
  async accept(method, check) {
    const { document } = this.desk;
    const given = nodeAt(document.root, ['accepted'])?.items?.length ?? 0;
    const value = { check: `${this.shown.results.methods[method].id}/${check.limit_state ?? check.id}`, reason: '', by: '', date: new Date().toISOString().slice(0, 10) };
    await document.set(['accepted', given], value);
    this.close();
    this.goTo(['accepted', given, 'reason']);
  }

  /** Renders the shown sheet anew after a change. */
  update(results) {
    if (!this.shown || this.element.hidden || !results) return;
    const { method, id } = this.shown;
    this.shown.results = results;
    const check = results.methods[method]?.checks?.find((one) => one.id === id);
    if (id === null || check) this.load();
  }

  async load() {
    const wish = Symbol('sheet');
    this.wish = wish;
    const { method, id, check } = this.shown;
    try {
      const { html } = await this.desk.api.post('sheet', { ...this.desk.document.question(this.desk.document.check?.text), method, check: id });
      if (this.wish !== wish) return;
      const top = this.body.scrollTop;
      // The server renders this from results; texts of files are escaped there.
      this.body.innerHTML = withoutStyles(html);
      for (const cell of this.body.querySelectorAll('.clause')) if (cell.textContent === 'assumption') cell.textContent = t('check-assumption');
      if (check?.reason) this.body.prepend(h('p.check-reason', {}, marked(check.reason)));
      if (check?.note) this.body.append(h('p.hint', {}, marked(check.note)));
      this.body.scrollTop = top;
    } catch (error) {
      if (this.wish === wish) fill(this.body, h('p.empty', {}, error.message), error.help ? h('p.hint', {}, error.help) : null);
    }
  }

  close() {
    this.element.hidden = true;
    this.shown = null;
    if (this.from?.isConnected) this.from.focus();
    this.desk.events.dispatchEvent(new CustomEvent('tank-sheet'));
  }
}
