// The runs since the desk was started: one card each, changed in place so that focus and opened messages stay.

import { fill, h } from './dom.js';
import { copyCommand, drawCommand } from './run-form.js';
import { endWords, judges, resultOf } from './run-end.js';
import { nextOfStudy, printed, writtenForms } from './run-options.js';
import { duration, t } from './words.js';

const ENDED = new Set(['done', 'failed', 'cancelled']);

/** Makes the list. `acts` has `again(spec)`, `resume(spec)` and `post(spec)`; `specs` maps ids to what this page has started. */
export function createList(desk, specs, acts) {
  const list = { desk, specs, acts, cards: new Map(), element: h('div.run-list', { dataset: { area: '' } }), results: [] };
  return {
    element: list.element,
    update(runs, results) {
      list.results = results;
      draw(list, runs);
    },
    redraw(runs) {
      list.cards.clear();
      list.element.replaceChildren();
      draw(list, runs);
    },
  };
}

function draw(list, runs) {
  list.runs = runs;
  if (!runs.length) {
    list.cards.clear();
    fill(list.element, h('h2', {}, t('run-list')), h('p.empty', {}, t('run-list-none')));
    return;
  }
  if (!list.cards.size) fill(list.element, h('h2', {}, t('run-list')));
  const heading = list.element.firstElementChild;
  // A new card goes on top.
  for (const run of [...runs].sort((a, b) => a.id - b.id)) {
    let card = list.cards.get(run.id);
    if (!card) {
      card = createCard(list, run);
      list.cards.set(run.id, card);
      heading.after(card.element);
    }
    updateCard(list, card, run);
  }
  for (const [id, card] of list.cards) {
    if (runs.some((run) => run.id === id)) continue;
    card.element.remove();
    list.cards.delete(id);
  }
}

function createCard(list, run) {
  const card = {
    shown: '', text: '', stopping: false,
    name: h('h3.run-name'), state: h('span.tag'), bar: h('progress', { max: 100, 'aria-label': t('run-progress', { out: run.out ?? run.id }) }), line: h('p.hint.run-line'),
    words: h('p.run-words'), acts: h('div.row'), command: h('code.run-typed', { tabindex: '0' }), output: h('pre.run-output', { tabindex: '0' }), summary: h('summary'),
  };
  card.details = h('details', {}, card.summary, card.output);
  card.element = h('article.panel.run', { dataset: { id: run.id } }, h('div.row.spread', {}, card.name, card.state), card.bar, card.line, card.words, card.acts,
    h('div.run-command', {}, card.command, h('button.quiet', { type: 'button', 'aria-label': t('run-copy'), onclick: () => copyCommand(list.desk, card.command.textContent) }, t('copy'))), card.details);
  return card;
}

function updateCard(list, card, run) {
  const ended = ENDED.has(run.state);
  if (ended) card.stopping = false;
  const there = ended ? resultOf(run, list.results) : undefined;
  card.name.textContent = run.out ?? run.command;
  card.element.dataset.state = run.state;
  card.state.textContent = t(card.stopping ? 'run-stopping' : stateWords(run));
  card.state.className = `tag ${stateClass(run)}`;
  card.bar.hidden = ended;
  if (run.state === 'running' && Number.isFinite(run.percent)) card.bar.value = run.percent;
  else if (run.state === 'running') card.bar.removeAttribute('value');
  else card.bar.value = 0;
  card.line.textContent = line(run, ended);
  card.words.hidden = !ended;
  if (ended) fill(card.words, endWords(run, Boolean(there)));
  drawCommand(card.command, run.command);
  const kind = `${run.state} ${card.stopping} ${Boolean(there)} ${there?.status} ${followed(list, run)}`;
  if (card.shown !== kind) {
    const first = card.shown === '';
    card.shown = kind;
    fill(card.acts, buttons(list, card, run));
    if (ended && (run.code === 2 || run.code === 3 || run.state === 'failed')) card.details.open = true;
    else if (first && run.state === 'running') card.details.open = false;
  }
  drawOutput(card, run);
}

const stateWords = (run) => (run.state === 'done' && judges(run) ? { 0: 'run-holds', 1: 'run-fails', 4: 'run-open' }[run.code] ?? 'run-done' : `run-${run.state}`);
/** Whether a later run works in the same folder. */
const followed = (list, run) => list.runs.some((other) => other.id > run.id && other.out === run.out && other.state !== 'failed');

const stateClass = (run) => ({ failed: 'fails', cancelled: 'open-state', running: 'run-now' }[run.state]
  ?? (run.state === 'done' ? { 0: 'holds', 1: 'fails', 4: 'open-state' }[run.code] ?? '' : ''));

function line(run, ended) {
  if (ended) return t('run-took', { time: duration(run.seconds) });
  if (run.state === 'waiting') return '';
  const stage = run.stage ? `${run.stage}${Number.isFinite(run.percent) ? `, ${Math.round(run.percent)} %` : ''}` : t('run-starting');
  return [stage, t('run-elapsed', { time: duration(run.seconds) }), Number.isFinite(run.left) ? t('run-left', { time: duration(run.left) }) : null].filter(Boolean).join(' · ');
}

function buttons(list, card, run) {
  const { desk } = list;
  const act = (words, onclick, kind = '') => h('button', { type: 'button', class: kind, onclick }, t(words));
  if (!ENDED.has(run.state)) return act(card.stopping ? 'run-cancel-now' : 'run-cancel', () => cancel(list, card, run), 'danger');
  const spec = list.specs.get(run.id);
  const there = Boolean(resultOf(run, list.results));
  const report = desk.api.resultAddress(run.out ?? '', 'report.html');
  const step = followed(list, run) ? null : nextOfStudy(run);
  const planned = /^tankcheck study (plan|run)/.test(run.command);
  const paged = there && run.state !== 'failed' && !run.command.includes('--no-report') && !planned;
  const files = run.code === 0 ? writtenForms(run) : [];
  const resumable = spec && (run.state === 'cancelled' || run.code === 3) && (spec.kind === 'ida' || spec.kind === 'push' || spec.values.fe === 'nonlinear');
  return [
    files.map((file) => h('a.button', { href: desk.api.resultAddress(run.out, file, true), download: file }, t('run-save-file', { file }))),
    step ? act(`run-next-${step.step}`, () => list.acts.post(step), 'primary') : null,
    there && !planned ? act('run-look', () => desk.go('look', { path: run.out }), files.length ? '' : 'primary') : null,
    paged ? h('a.button', { href: report, target: '_blank', rel: 'noopener' }, t('run-open-report')) : null,
    paged && !run.command.startsWith('tankcheck report') ? act('run-print', () => list.acts.post(printed(run))) : null,
    resumable ? act('run-go-on', () => list.acts.resume(spec)) : null,
    spec ? act('run-again', () => list.acts.again(spec)) : null,
  ];
}

// A second cancel of a run that stops discards the finished part, as a second Ctrl-C does.
async function cancel(list, card, run) {
  try {
    card.stopping = run.state === 'running';
    card.shown = '';
    await list.desk.api.remove(`runs/${encodeURIComponent(run.id)}`);
  } catch (error) {
    card.stopping = false;
    list.desk.sayError(error);
  }
}

// What the program has written, and its exit code for whoever runs it by a script.
function drawOutput(card, run) {
  const coded = run.code !== null && run.code !== undefined && ENDED.has(run.state) ? [t('run-code', { code: run.code })] : [];
  const text = [...(run.output ?? []).map(plain), ...coded].join('\n').trimEnd();
  card.details.hidden = text === '';
  if (text === card.text) return;
  card.text = text;
  card.summary.textContent = t('run-messages', { count: text.split('\n').length });
  const { output } = card;
  const atEnd = output.scrollTop + output.clientHeight >= output.scrollHeight - 24;
  output.textContent = text;
  if (atEnd) output.scrollTop = output.scrollHeight;
}

/** A line without the escapes of a terminal. */
function plain(text) {
  // eslint-disable-next-line no-control-regex
  return String(text).replace(/\u001b\[[0-9;?]*[ -/]*[@-~]|\u001b\][^\u0007]*\u0007/g, '').replace(/^.*\r(?!$)/, '');
}
