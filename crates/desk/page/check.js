// The verdict and every check as a row: utilisation, demand, capacity, clause. Failing and open checks of the deciding
// methods stand first; a row opens the sheet of its check.

import { rove, toolbar } from './areas.js';
import { h, fill } from './dom.js';
import { isMissing, marked, tongue, wording } from './marked.js';
import { significant, show, unitFor } from './units.js';
import { decides, recordSentence } from './verdict.js';
import { localised, t } from './words.js';
import './check-words.js';

const ROLES = ['decides', 'record', 'informs'];
const ORDER = ['fails', 'not_checked', 'accepted', 'holds', 'not_applicable'];
/** Utilisation at the end of a bar. */
const BAR_END = 1.5;
/** What arrows go through in the list. */
const STOPS = '.check-row, .check-method';

export class Checks {
  /** `open(method index, check)` shows a sheet, `goTo(path)` a field of the form. */
  constructor(desk, open, goTo) {
    Object.assign(this, { desk, open, goTo, rows: new Map(), filter: 'all', others: false });
    this.status = h('strong.check-status', { role: 'status' });
    this.says = h('p.check-says');
    this.time = h('span.check-time');
    this.head = h('header.check-verdict', {}, h('div.check-line', {}, this.status, this.time), this.says);
    this.filters = h('div.check-filters', { role: 'group', 'aria-label': t('check-filter') });
    this.search = h('input.check-search', { type: 'search', oninput: () => this.draw() });
    this.list = h('div.check-list');
    this.warnings = h('ul.check-warnings');
    this.element = h('section.check', { 'aria-label': t('check-title') }, this.head, h('div.check-tools', {}, this.filters, this.search), this.list, this.warnings);
    this.drawTools = toolbar(this.filters);
    this.list.addEventListener('keydown', (event) => this.pressed(event));
    this.list.addEventListener('focusin', ({ target }) => { if (target.matches(STOPS)) this.stop(target); });
  }

  /** Shows an answer of `api/check`; while a text has faults the last results stay, marked as old. */
  update(answer) {
    this.answer = answer;
    if (answer.results) this.results = answer.results;
    this.element.classList.toggle('check-old', !answer.results);
    this.drawVerdict();
    this.draw();
    fill(this.warnings, (answer.warnings ?? []).map((warning) => h('li', {}, h('code', {}, warning.code), h('span', { lang: tongue(warning) }, ` ${wording(warning)}`))));
  }

  clear() {
    this.results = null;
    this.answer = null;
    this.rows.clear();
    this.list.replaceChildren();
    this.drawVerdict();
  }

  drawVerdict() {
    if (this.answer?.untouched) return this.drawUntouched();
    const faults = this.answer?.faults?.length ?? 0;
    const verdict = this.results?.verdict;
    const status = faults ? 'faulty' : stateOf(verdict);
    this.head.dataset.status = status;
    const missing = faults > 0 && this.answer.faults.every(isMissing);
    if (missing) this.head.dataset.status = 'open';
    this.status.textContent = faults ? t(missing ? 'check-missing' : 'check-faulty', { count: faults }) : t(status === 'accepted' ? 'check-holds-accepted' : `check-is-${status}`);
    const before = faults && verdict ? h('strong', {}, `${t('check-before-fault')} `) : null;
    fill(this.says, before, verdict ? this.sentences(verdict) : this.answer ? '' : t('check-waiting'));
    this.says.classList.toggle('check-before', Boolean(before));
    const waited = this.answer?.waited;
    this.time.textContent = this.answer ? t('check-time', { server: Math.round(this.answer.milliseconds ?? 0), total: waited ? Math.round(waited) : '–' }) : '';
    this.search.setAttribute('aria-label', t('check-search'));
    this.search.placeholder = t('check-search');
  }

  // An empty form has no faults yet.
  drawUntouched() {
    this.head.dataset.status = 'none';
    this.status.textContent = t('check-empty');
    this.says.textContent = t('check-fill');
    this.time.textContent = '';
  }

  // Says who decides, what governs and what is open, and what a record would say that does not decide.
  sentences(verdict) {
    const title = (id) => this.results.methods.find((method) => method.id === id)?.label ?? id;
    const deciding = [...new Set((verdict.deciding ?? []).map((one) => title(one.method)))];
    const parts = deciding.length ? [t('check-decide', { who: deciding.join(', ') })] : [];
    const counts = verdict.counts ?? {};
    const named = ['fails', 'not_checked', 'accepted', 'holds'].filter((key) => counts[key]).map((key) => `${counts[key]} ${t(`check-count-${key}`)}`);
    if (named.length) parts.push(`${named.join(', ')}.`);
    const { governing } = verdict;
    if (governing?.check?.utilisation != null) {
      parts.push(t('check-governs', { name: governing.check.name, method: title(governing.method), ratio: localised(significant(governing.check.utilisation)) }));
    }
    const record = recordSentence(verdict.record, (one) => title(one.method), (name) => name);
    return [parts.join(' '), record ? h('span.check-record', {}, record) : null];
  }

  // The methods that decide, then those under the record, then the rest.
  groups() {
    const { verdict, methods = [] } = this.results ?? {};
    const role = (method) => (decides(verdict, method) ? 'decides' : method.excitation === 'record' && verdict?.deciding?.length ? 'record' : 'informs');
    const groups = methods.map((method, index) => ({ method, index, role: role(method) }));
    return groups.sort((a, b) => ROLES.indexOf(a.role) - ROLES.indexOf(b.role) || a.index - b.index);
  }

  // Whether a group has something to show: a check that passes the filter, or why its method has none.
  hasRows({ method }) {
    const bare = this.filter === 'all' && !this.search.value.trim();
    return this.sorted(method.checks ?? []).length > 0 || (bare && !method.checks?.length && Boolean(method.status?.reason));
  }

  draw() {
    this.drawFilters();
    const kept = new Set();
    // Where nothing decides, all methods are shown.
    const groups = this.groups();
    const alone = !groups.some(({ role }) => role === 'decides');
    const filled = groups.filter((group) => this.hasRows(group));
    const sections = filled.filter(({ role }) => role !== 'informs' || this.others || alone).map((group) => this.section(group, kept));
    for (const key of [...this.rows.keys()]) if (!kept.has(key)) this.rows.delete(key);
    const others = alone ? 0 : filled.filter(({ role }) => role === 'informs').length;
    this.othersButton ??= h('button.quiet.check-others', { type: 'button', onclick: () => { this.others = !this.others; this.draw(); } });
    this.othersButton.textContent = t(this.others ? 'check-hide-others' : 'check-show-others', { count: others });
    const wanted = [...sections, ...(others ? [this.othersButton] : [])];
    // Elements that stay are not moved: a focused row keeps the focus.
    wanted.forEach((element, index) => { if (this.list.children[index] !== element) this.list.insertBefore(element, this.list.children[index] ?? null); });
    while (this.list.children.length > wanted.length) this.list.lastElementChild.remove();
    this.stop(this.current);
  }

  // The list is one stop of Tab; arrows go from row to row.
  stop(current) {
    this.current = rove([...this.list.querySelectorAll(STOPS)], current);
    for (const go of this.list.querySelectorAll('.check-go')) go.tabIndex = go.parentElement.contains(this.current) ? 0 : -1;
  }

  focus() {
    (this.current ?? this.search).focus();
    this.element.scrollIntoView({ block: 'nearest' });
  }

  section(group, kept) {
    const key = `method ${group.method.id} ${group.method.excitation}`;
    kept.add(key);
    if (!this.rows.has(key)) {
      const heading = h('button.check-method', { type: 'button', onclick: () => this.open(this.indexOf(key), null) });
      this.rows.set(key, { heading, body: h('div.check-rows', { role: 'list' }), element: null });
      const made = this.rows.get(key);
      made.element = h('section.check-group', {}, heading, made.body);
    }
    const made = this.rows.get(key);
    made.group = group;
    const checks = this.sorted(group.method.checks ?? []);
    const state = group.method.status?.state ?? '';
    fill(made.heading, h('span', {}, group.method.title), h('small', {}, t(`check-${group.role}`)),
      checks.length ? null : h('small', {}, group.method.status?.reason ?? state));
    const rows = checks.map((check, index) => this.row(key, check, index, kept));
    rows.forEach((row, index) => { if (made.body.children[index] !== row) made.body.insertBefore(row, made.body.children[index] ?? null); });
    while (made.body.children.length > rows.length) made.body.lastElementChild.remove();
    return made.element;
  }

  indexOf(key) { return this.rows.get(key).group.index; }

  sorted(checks) {
    const words = this.search.value.trim().toLowerCase();
    const shown = checks.filter((check) => this.passes(check) && (!words || `${check.name} ${check.id} ${check.clause}`.toLowerCase().includes(words)));
    return shown.sort((a, b) => ORDER.indexOf(a.status) - ORDER.indexOf(b.status) || (b.utilisation ?? -1) - (a.utilisation ?? -1));
  }

  passes(check) {
    if (this.filter === 'all') return check.status !== 'not_applicable';
    return this.filter === check.status;
  }

  row(group, check, index, kept) {
    const key = `${group} ${check.id} ${index < 0 ? '' : this.times(group, check.id, kept)}`;
    kept.add(key);
    if (!this.rows.has(key)) {
      const bar = h('i');
      const parts = { name: h('span.check-name'), bar, ratio: h('span.check-ratio'), values: h('span.check-values'), clause: h('span.check-clause'), reason: h('span.check-reason') };
      const element = h('button.check-row', { type: 'button', onclick: () => this.open(this.indexOf(group), this.rows.get(key).check) },
        parts.name, h('span.check-bar', { 'aria-hidden': true }, bar), parts.ratio, parts.values, parts.clause, parts.reason);
      const go = h('button.link.check-go', { type: 'button', onclick: () => this.goTo(this.rows.get(key).check.input) }, t('check-input'));
      this.rows.set(key, { ...parts, element, go, holder: h('div', { role: 'listitem' }, element, go) });
    }
    this.fillRow(this.rows.get(key), check);
    return this.rows.get(key).holder;
  }

  times(group, id, kept) {
    let count = 0;
    while (kept.has(`${group} ${id} ${count}`)) count += 1;
    return count;
  }

  fillRow(row, check) {
    row.check = check;
    row.element.dataset.status = check.status;
    const ratio = check.utilisation;
    const has = ratio !== null && ratio !== undefined;
    row.name.textContent = check.name;
    row.bar.style.width = `${has ? Math.min(ratio / BAR_END, 1) * 100 : 0}%`;
    row.ratio.textContent = has ? localised(ratio < 10 ? ratio.toFixed(2) : significant(ratio)) : '–';
    const { units } = this.desk.settings;
    const unit = unitFor(Math.max(Math.abs(check.demand ?? 0), Math.abs(check.capacity ?? 0)), check.dimension, units);
    // A value keeps its unit beside it where the two are broken into lines.
    const value = (number) => show(number, check.dimension, units, 3, unit).replace(' ', '\u00a0');
    row.values.textContent = check.demand === null && check.capacity === null ? t(`check-is-${check.status}`) : `${value(check.demand)} / ${value(check.capacity)}`;
    row.clause.textContent = check.clause ?? '';
    fill(row.reason, marked(check.reason ?? ''));
    row.reason.hidden = !check.reason;
    row.go.hidden = check.status !== 'not_checked' || !check.input;
    row.go.setAttribute('aria-label', `${t('check-input')}: ${check.name}`);
    row.element.title = check.note ?? '';
    row.element.setAttribute('aria-label', [check.name, t(`check-is-${check.status}`), has ? t('check-utilised', { ratio: row.ratio.textContent }) : '',
      row.values.textContent, check.clause, check.reason].filter(Boolean).join(', '));
  }

  drawFilters() {
    const groups = this.groups();
    const alone = !groups.some(({ role }) => role === 'decides');
    const count = (id, role) => groups.filter((group) => alone || group.role === role)
      .reduce((sum, { method }) => sum + (method.checks ?? []).filter((check) => check.status === id).length, 0);
    if (!this.filters.childNodes.length) {
      fill(this.filters, ['all', ...ORDER].map((id) => h('button.quiet', {
        type: 'button', dataset: { filter: id }, onclick: () => { this.filter = id; this.draw(); },
      })));
    }
    for (const button of this.filters.children) {
      const id = button.dataset.filter;
      const [own, record] = [count(id, 'decides'), alone ? 0 : count(id, 'record')];
      button.hidden = id !== 'all' && !own && !record && this.filter !== id;
      fill(button, id === 'all' ? t('check-all') : `${t(`check-filter-${id}`)} ${own}`, record ? h('small', {}, ` ${t('check-filter-record', { count: record })}`) : null);
      button.setAttribute('aria-pressed', String(this.filter === id));
    }
    this.drawTools?.();
  }

  // Arrows go from row to row.
  pressed(event) {
    const rows = [...this.list.querySelectorAll(STOPS)];
    const here = rows.indexOf(event.target);
    const next = { ArrowDown: rows[here + 1], ArrowUp: rows[here - 1], Home: rows[0], End: rows.at(-1) }[event.key];
    if (here < 0 || !next) return;
    event.preventDefault();
    next.focus();
  }
}

/** holds, fails, open or accepted: the word for a verdict. */
export function stateOf(verdict) {
  if (!verdict) return 'none';
  const { status } = verdict;
  if (status === 'not_assessed') return 'none';
  if (status === 'holds') return verdict.counts?.accepted ? 'accepted' : 'holds';
  return status === 'fails' ? 'fails' : 'open';
}
