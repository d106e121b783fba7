// Verdict, checks and the table of methods of a result.

import { h } from './dom.js';
import { add, t } from './words.js';
import { display, largest, significant, unitFor } from './display.js';
import { titled } from './titles.js';
import { recordSentence } from './verdict.js';

add({
  'look-holds': ['Holds', 'Eingehalten'],
  'look-fails': ['Fails', 'Nicht eingehalten'],
  'look-incomplete': ['Open', 'Offen'],
  'look-not_assessed': ['Not assessed', 'Nicht beurteilt'],
  'look-not_checked': ['open', 'offen'],
  'look-accepted': ['accepted', 'akzeptiert'],
  'look-not_applicable': ['not required', 'nicht gefordert'],
  'look-state-holds': ['holds', 'eingehalten'],
  'look-state-fails': ['fails', 'nicht eingehalten'],
  'look-holds-accepted': ['Holds with accepted gaps', 'Eingehalten mit akzeptierten Lücken'],
  'look-accepted-gaps': ['Accepted gaps', 'Akzeptierte Lücken'],
  'look-missing': ['Open, as required and not checked', 'Offen, da gefordert und nicht nachgewiesen'],
  'look-counts': [
    '{holds} checks hold, {fails} fail, {open} open, {accepted} gaps accepted',
    '{holds} Nachweise eingehalten, {fails} nicht, {open} offen, {accepted} Lücken akzeptiert',
  ],
  'look-governing': ['Governing: {check}, {method}, utilisation {value}', 'Maßgebend: {check}, {method}, Ausnutzung {value}'],
  'look-deciding': ['Deciding: {methods}', 'Entscheidend: {methods}'],
  'look-checks': ['Checks', 'Nachweise'],
  'look-all-checks': ['all methods', 'alle Verfahren'],
  'look-deciding-only': ['deciding methods', 'entscheidende Verfahren'],
  'look-check': ['Check', 'Nachweis'],
  'look-method': ['Method', 'Verfahren'],
  'look-demand': ['Demand', 'Einwirkung'],
  'look-capacity': ['Capacity', 'Widerstand'],
  'look-utilisation': ['Utilisation', 'Ausnutzung'],
  'look-state': ['Result', 'Ergebnis'],
  'look-clause': ['Clause', 'Abschnitt'],
  'look-methods': ['Quantities by method', 'Größen nach Verfahren'],
  'look-methods-note': [
    'Seismic part alone, largest over time and circumference. The small number is the ratio to the finite elements.',
    'Nur der seismische Anteil, Größtwerte über Zeit und Umfang. Die kleine Zahl ist das Verhältnis zu den Finiten Elementen.',
  ],
  'look-quantity': ['Quantity', 'Größe'],
  'look-record': ['record', 'Beben'],
  'look-site': ['site', 'Standort'],
  'look-measured': ['measured', 'gemessen'],
  'look-limits': ['Limits of the model', 'Grenzen des Modells'],
  'look-limit': ['Limit', 'Grenze'],
  'look-value': ['Value', 'Wert'],
  'look-bound': ['Bound', 'Schranke'],
  'look-exceeded': ['exceeded', 'überschritten'],
  'look-within': ['within', 'eingehalten'],
  'look-about': ['{name}. Written {when} by tankcheck {version}.', '{name}. Geschrieben {when} von tankcheck {version}.'],
});

/** A method with its excitation, short. */
export const methodName = (method, language) => `${titled(method.label, language)}, ${t(`look-${method.excitation}`)}`;

const STATE_CLASS = { holds: 'holds', fails: 'fails', not_checked: 'open-state', accepted: 'accepted', incomplete: 'open-state' };

/** The word of the state of a check. */
export const stateWord = (status) =>
  h('span', { class: STATE_CLASS[status] ?? 'hint' }, t(['holds', 'fails'].includes(status) ? `look-state-${status}` : `look-${status}`));

/** The verdict as a badge. */
export const verdictBadge = (status) => h('strong.look-badge', { class: STATE_CLASS[status] ?? '' }, t(`look-${status ?? 'not_assessed'}`));

/** Everything of the tab. */
export function summary(results, settings) {
  return h('div.look-summary', {}, verdict(results, settings), checks(results, settings), methods(results, settings), limits(results, settings));
}

function verdict({ verdict: found, methods: all }, settings) {
  if (!found) return null;
  const { counts, governing, deciding } = found;
  const label = (of) => {
    const method = (all ?? []).find((one) => one.id === of.method && one.excitation === of.excitation);
    return method ? methodName(method, settings.language) : of.method;
  };
  const record = recordSentence(found.record, label, (name) => titled(name, settings.language));
  const partly = found.status === 'holds' && counts?.accepted > 0;
  const badge = partly ? h('strong.look-badge.accepted', {}, t('look-holds-accepted')) : verdictBadge(found.status);
  return h(
    'section.look-verdict',
    {},
    h('p.look-big', {}, badge),
    counts ? h('p', {}, t('look-counts', { holds: counts.holds, fails: counts.fails, open: counts.not_checked, accepted: counts.accepted })) : null,
    governing
      ? h(
          'p',
          {},
          t('look-governing', {
            check: titled(governing.check.name, settings.language),
            method: label(governing),
            value: significant(governing.check.utilisation, 3),
          }),
        )
      : null,
    record ? h('p.look-record', {}, record) : null,
    deciding?.length ? h('p', {}, t('look-deciding', { methods: deciding.map(label).join('; ') })) : null,
    listed('look-missing', found.missing, settings),
    listed('look-accepted-gaps', found.accepted, settings),
  );
}

/** Gaps with who accepted them and why. */
function listed(title, gaps, settings) {
  if (!gaps?.length) return null;
  const why = ({ reason, note, accepted }) => [reason ?? note, accepted ? `${accepted.by}, ${accepted.date}` : null].filter(Boolean).join('; ');
  return h(
    'details.look-gaps',
    {},
    h('summary', {}, `${t(title)}: ${gaps.length}`),
    h(
      'ul',
      {},
      gaps.map(({ check }) =>
        h('li', {}, h('b', {}, titled(check?.name ?? '', settings.language)), ' ', h('span.hint', {}, check ? why(check) : '')),
      ),
    ),
  );
}

/** A bar of a utilisation: full length at 1.25. */
export function utilisation(value, status) {
  if (value === null || value === undefined) return h('span.hint', {}, '–');
  const bar = h('i', { class: value > 1 ? 'look-over' : '' });
  bar.style.width = `${Math.min(100, value * 80)}%`;
  return h(
    'span.look-use',
    { role: 'img', 'aria-label': significant(value, 3), class: status === 'fails' ? 'fails' : '' },
    h('span', {}, significant(value, 3)),
    h('span.look-bar', {}, bar),
  );
}

const ORDER = { fails: 0, not_checked: 1, accepted: 2, holds: 3, not_applicable: 4 };

function checks(results, settings) {
  const deciding = new Set((results.verdict?.deciding ?? []).map((one) => `${one.method}/${one.excitation}`));
  const rows = (results.methods ?? []).flatMap((method) =>
    (method.checks ?? []).filter((check) => check.status !== 'not_applicable').map((check) => ({ method, check })),
  );
  if (!rows.length) return null;
  rows.sort((a, b) => ORDER[a.check.status] - ORDER[b.check.status] || (b.check.utilisation ?? 0) - (a.check.utilisation ?? 0));
  const body = h('tbody');
  const only = h(
    'select',
    { 'aria-label': t('look-checks'), onchange: () => show() },
    [
      ['deciding', t('look-deciding-only')],
      ['all', t('look-all-checks')],
    ].map(([id, text]) => h('option', { value: id }, text)),
  );
  only.value = deciding.size ? 'deciding' : 'all';
  const show = () => {
    const shown = rows.filter(({ method }) => only.value === 'all' || deciding.has(`${method.id}/${method.excitation}`));
    body.replaceChildren(...shown.map(({ method, check }) => row(method, check, settings)));
  };
  show();
  return h(
    'section',
    {},
    h('header.look-line', {}, h('h3', {}, t('look-checks')), deciding.size ? only : null),
    h(
      'div.scroll',
      { tabindex: '0', role: 'region', 'aria-label': t('look-checks') },
      h(
        'table.look-table',
        {},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            heads(['look-check', 'look-method']),
            numeric(['look-demand', 'look-capacity']),
            heads(['look-utilisation', 'look-state', 'look-clause']),
          ),
        ),
        body,
      ),
    ),
  );
}

const heads = (ids) => ids.map((id) => h('th', { scope: 'col' }, t(id)));
const numeric = (ids) => ids.map((id) => h('th.number', { scope: 'col' }, t(id)));

function row(method, check, settings) {
  const value = (number) => display(number, check.dimension, settings.units);
  return h(
    'tr',
    { title: check.note || check.reason || null },
    h('th', { scope: 'row' }, titled(check.name, settings.language)),
    h('td', {}, methodName(method, settings.language)),
    h('td.number', {}, value(check.demand)),
    h('td.number', {}, value(check.capacity)),
    h('td', {}, utilisation(check.utilisation, check.status)),
    h('td', {}, stateWord(check.status)),
    h('td.look-clause', {}, check.clause),
  );
}

function methods({ comparison, methods: all }, settings) {
  const rows = comparison?.rows ?? [];
  if (!rows.length) return null;
  const used = (all ?? []).map((method, i) => ({ method, i })).filter(({ i }) => rows.some((one) => one.cells[i]));
  const head = h(
    'tr',
    {},
    h('th', { scope: 'col' }, t('look-quantity')),
    used.map(({ method }) =>
      h('th.number', { scope: 'col' }, titled(method.label, settings.language), h('small', {}, t(`look-${method.excitation}`))),
    ),
  );
  const body = rows.map((one) => {
    const unit = unitFor(largest(one.cells.map((cell) => cell?.value)), one.dimension, settings.units);
    return h(
      'tr',
      {},
      h('th', { scope: 'row' }, titled(one.title, settings.language), unit.symbol ? h('small', {}, ` [${unit.symbol}]`) : null),
      used.map(({ i, method }) => {
        const cell = one.cells[i];
        return h(
          'td.number',
          {},
          cell ? significant(cell.value / unit.factor, 3) : '–',
          cell && Number.isFinite(cell.ratio) && method.id !== 'fe' ? h('small', {}, significant(cell.ratio, 3)) : null,
        );
      }),
    );
  });
  return h(
    'section',
    {},
    h('h3', {}, t('look-methods')),
    h('p.hint', {}, t('look-methods-note')),
    h(
      'div.scroll',
      { tabindex: '0', role: 'region', 'aria-label': t('look-methods') },
      h('table.look-table', {}, h('thead', {}, head), h('tbody', {}, body)),
    ),
  );
}

function limits({ runs }, settings) {
  const rows = (runs ?? []).flatMap((run) => run.limits ?? []);
  if (!rows.length) return null;
  return h(
    'section',
    {},
    h('h3', {}, t('look-limits')),
    h(
      'div.scroll',
      { tabindex: '0', role: 'region', 'aria-label': t('look-limits') },
      h(
        'table.look-table',
        {},
        h('thead', {}, h('tr', {}, heads(['look-limit']), numeric(['look-value', 'look-bound']), heads(['look-state']))),
        h(
          'tbody',
          {},
          rows.map((limit) =>
            h(
              'tr',
              { title: limit.note || null },
              h('th', { scope: 'row' }, titled(limit.name, settings.language)),
              h('td.number', {}, display(limit.value, limit.dimension, settings.units)),
              h('td.number', {}, display(limit.limit, limit.dimension, settings.units)),
              h('td', {}, h('span', { class: limit.holds ? 'holds' : 'open-state' }, t(limit.holds ? 'look-within' : 'look-exceeded'))),
            ),
          ),
        ),
      ),
    ),
  );
}
