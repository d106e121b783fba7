// Two results side by side: differences by quantity and by check, histories in one chart.

import { h, fill } from './dom.js';
import { t } from './words.js';
import './results-words.js';
import { display, largest, significant, unitFor, withUnit } from './display.js';
import { titled } from './titles.js';
import { methodName, stateWord } from './summary.js';
import { histories, columnsOf } from './histories.js';
import { createClock } from './clock.js';

/** Values closer than this are equal. */
const EQUAL = 1e-9;
/** Number of different inputs that are listed. */
const INPUTS = 8;

/**
 * Quantities of two results: `{rows: [{title, method, dimension, one, other, ratio}], equal, single}`, largest change first.
 * Methods are the same where id and excitation are.
 */
export function quantityDifferences(one, other, language) {
  const [mine, theirs] = [quantities(one, language), quantities(other, language)];
  const rows = [];
  const single = [];
  for (const [key, row] of mine) {
    const match = theirs.get(key);
    if (match) rows.push({ ...row, one: row.value, other: match.value, ratio: match.value === 0 ? NaN : row.value / match.value });
    else single.push(`${row.title}, ${row.method}`);
  }
  for (const [key, row] of theirs) if (!mine.has(key)) single.push(`${row.title}, ${row.method}`);
  rows.sort((a, b) => change(b) - change(a));
  return { rows, equal: rows.filter((row) => change(row) < EQUAL).length, single };
}

const change = ({ one, other }) => (one === other ? 0 : one * other > 0 ? Math.abs(Math.log(one / other)) : Infinity);

function quantities(results, language) {
  const found = new Map();
  for (const row of results.comparison?.rows ?? []) {
    row.cells.forEach((cell, i) => {
      const method = results.methods[i];
      if (cell && method)
        found.set(`${row.quantity}/${method.id}/${method.excitation}`, {
          title: titled(row.title, language),
          method: methodName(method, language),
          dimension: row.dimension,
          value: cell.value,
        });
    });
  }
  return found;
}

/** Checks of two results, as `quantityDifferences`; a change of the state comes first. */
export function checkDifferences(one, other, language) {
  const listed = (results) =>
    new Map(
      (results.methods ?? []).flatMap((method) =>
        (method.checks ?? [])
          .filter((check) => check.status !== 'not_applicable')
          .map((check) => [
            `${method.id}/${method.excitation}/${check.id}`,
            { title: titled(check.name, language), method: methodName(method, language), check },
          ]),
      ),
    );
  const [mine, theirs] = [listed(one), listed(other)];
  const rows = [];
  const single = [];
  for (const [key, row] of mine) {
    const match = theirs.get(key);
    if (!match) {
      single.push(`${row.title}, ${row.method}`);
      continue;
    }
    const [a, b] = [row.check, match.check];
    const moved = a.status !== b.status;
    const values = [a.utilisation, b.utilisation].every((value) => Number.isFinite(value));
    const size = values ? change({ one: a.utilisation, other: b.utilisation }) : moved ? 1 : 0;
    rows.push({ ...row, a, b, moved, size: size < EQUAL ? 0 : size });
  }
  for (const [key, row] of theirs) if (!mine.has(key)) single.push(`${row.title}, ${row.method}`);
  rows.sort((p, q) => Number(q.moved) - Number(p.moved) || q.size - p.size);
  return { rows, equal: rows.filter((row) => !row.moved && row.size === 0).length, single };
}

/**
 * The comparison of two results.
 *
 * @param {{label: string, results: object, series(): Promise<object|null>}[]} two
 * @returns `{element, repaint(), destroy()}`
 */
export function comparison(two, settings) {
  const [one, other] = two;
  const body = h('div.look-pane');
  let shown = null;
  const tabs = ['quantities', 'checks', 'histories'];
  const buttons = tabs.map((tab) => h('button.look-tab', { type: 'button', role: 'tab', onclick: () => show(tab) }, t(`look-tab-${tab}`)));
  const list = h(
    'div.look-tabs',
    {
      role: 'tablist',
      'aria-label': t('look-tabs'),
      onkeydown: (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!step) return;
        const next = (tabs.indexOf(list.dataset.tab) + step + tabs.length) % tabs.length;
        show(tabs[next]);
        buttons[next].focus();
      },
    },
    buttons,
  );

  async function show(tab) {
    shown?.destroy?.();
    shown = null;
    list.dataset.tab = tab;
    buttons.forEach((button, i) => {
      button.setAttribute('aria-selected', String(tabs[i] === tab));
      button.tabIndex = tabs[i] === tab ? 0 : -1;
    });
    if (tab === 'quantities') fill(body, quantityTable(one, other, settings));
    if (tab === 'checks') fill(body, checkTable(one, other, settings));
    if (tab !== 'histories') return;
    fill(body, h('p.empty', {}, t('look-loading')));
    const series = await Promise.all(two.map((own) => own.series().catch(() => null)));
    if (list.dataset.tab !== 'histories') return;
    const sources = two
      .map((own, i) => series[i] && { label: own.label, time: series[i].time, columns: columnsOf(series[i], own.results, settings.language) })
      .filter(Boolean);
    shown = histories(sources, settings, createClock(), Math.max(...series.map((own) => own?.every ?? 1)));
    fill(body, shown.element);
  }

  show('quantities');
  return { element: h('div', {}, inputs(one, other), list, body), repaint: () => shown?.repaint?.(), destroy: () => shown?.destroy?.() };
}

/** What differs in the input of two results: `[{name, one, other}]` with the texts of the file, null where a result has no such value. */
export function inputDifferences(one, other) {
  const texts = (results) => {
    const found = new Map((results.input ?? []).map(({ path, text }) => [path, text]));
    const records = (results.records ?? []).map((record) => record.name ?? record.file ?? '').join(', ');
    if (records) found.set(t('look-record'), records);
    return found;
  };
  const [mine, theirs] = [texts(one), texts(other)];
  const names = [...new Set([...mine.keys(), ...theirs.keys()])];
  return names.map((name) => ({ name, one: mine.get(name) ?? null, other: theirs.get(name) ?? null })).filter((row) => row.one !== row.other);
}

function inputs(one, other) {
  const rows = inputDifferences(one.results, other.results);
  if (!rows.length) return h('p.hint.look-inputs', {}, t('look-input-same'));
  const more = rows.length > INPUTS ? h('p.hint', {}, t('look-input-more', { count: rows.length - INPUTS })) : null;
  return h(
    'section.look-inputs',
    {},
    h('h3', {}, t('look-input-differs')),
    table(
      t('look-input-differs'),
      head([['look-input'], ['', false, one.label], ['', false, other.label]]),
      h('tbody', {}, rows.slice(0, INPUTS).map((row) => h('tr', {}, h('th', { scope: 'row' }, row.name), [row.one, row.other].map((text) => h('td', {}, text ?? '–'))))),
    ),
    more,
  );
}

const head = (ids) =>
  h(
    'thead',
    {},
    h(
      'tr',
      {},
      ids.map(([id, number, text]) => h(number ? 'th.number' : 'th', { scope: 'col' }, text ?? t(id))),
    ),
  );
const table = (label, ...parts) => h('div.scroll', { tabindex: '0', role: 'region', 'aria-label': label }, h('table.look-table', {}, parts));

/** A table with a choice of methods and a switch for equal rows. */
function filtered({ rows, equal, single }, [one, other], isEqual, made) {
  const methods = [...new Set(rows.map((row) => row.method))];
  const body = h('tbody');
  const all = h('input', { type: 'checkbox', onchange: () => show() });
  // Where all are equal, an empty table would say less.
  all.checked = rows.every(isEqual);
  const select = h(
    'select',
    { 'aria-label': t('look-method'), onchange: () => show() },
    h('option', { value: '' }, t('look-all-methods')),
    methods.map((method) => h('option', { value: method }, method)),
  );
  const show = () =>
    body.replaceChildren(...rows.filter((row) => (all.checked || !isEqual(row)) && (!select.value || row.method === select.value)).map(made));
  show();
  const note = [t('look-sorted', { one: one.label, other: other.label }), equal ? t('look-equal', { count: equal }) : ''].join(' ');
  return {
    body,
    tools: h('div.look-line', {}, select, h('label.tick', {}, all, t('look-equal-shown')), h('span.hint', {}, note)),
    single: single.length ? h('p.hint', {}, t('look-only-one', { list: single.join('; ') })) : null,
  };
}

function quantityTable(one, other, settings) {
  const found = quantityDifferences(one.results, other.results, settings.language);
  if (!found.rows.length) return h('p.empty', {}, t('look-nothing-common'));
  const { body, tools, single } = filtered(
    found,
    [one, other],
    (row) => change(row) < EQUAL,
    (row) => {
      const unit = unitFor(largest([row.one, row.other]), row.dimension, settings.units);
      const value = (number) => withUnit(significant(number / unit.factor, 4), unit);
      return h(
        'tr',
        {},
        h('th', { scope: 'row' }, row.title),
        h('td', {}, row.method),
        h('td.number', {}, value(row.one)),
        h('td.number', {}, value(row.other)),
        h('td.number', {}, signed(value(row.one - row.other), row.one - row.other)),
        h('td.number', {}, significant(row.ratio, 4)),
      );
    },
  );
  return [
    tools,
    table(
      t('look-tab-quantities'),
      head([['look-quantity'], ['look-method'], ['', true, one.label], ['', true, other.label], ['look-difference', true], ['look-ratio', true]]),
      body,
    ),
    single,
  ];
}

const signed = (text, value) => (value > 0 ? `+${text}` : text);

function checkTable(one, other, settings) {
  const found = checkDifferences(one.results, other.results, settings.language);
  if (!found.rows.length) return h('p.empty', {}, t('look-nothing-common'));
  const cell = (check) =>
    h(
      'td.number',
      {
        title: Number.isFinite(check.demand)
          ? `${display(check.demand, check.dimension, settings.units)} / ${display(check.capacity, check.dimension, settings.units)}`
          : null,
      },
      significant(check.utilisation, 3),
      ' ',
      h('small', {}, stateWord(check.status)),
    );
  const { body, tools, single } = filtered(
    found,
    [one, other],
    (row) => !row.moved && row.size === 0,
    (row) => {
      const gap = row.a.utilisation - row.b.utilisation;
      const both = Number.isFinite(row.a.utilisation) && Number.isFinite(row.b.utilisation);
      return h(
        'tr',
        { class: row.moved ? 'look-moved' : '' },
        h('th', { scope: 'row' }, row.title),
        h('td', {}, row.method),
        cell(row.a),
        cell(row.b),
        h('td.number', {}, both ? signed(significant(gap, 3), gap) : '–'),
        h('td.number', {}, both ? significant(row.a.utilisation / row.b.utilisation, 4) : '–'),
      );
    },
  );
  return [
    tools,
    table(
      t('look-tab-checks'),
      head([['look-check'], ['look-method'], ['', true, one.label], ['', true, other.label], ['look-difference', true], ['look-ratio', true]]),
      body,
    ),
    single,
  ];
}
