// The form of a new run, with its command.

import { choice, copy, fill, h, labelled } from './dom.js';
import { KINDS, freeFolder, takenFolders, typed } from './run-options.js';
import { t } from './words.js';

/** Makes the form; `started(id, spec)` is called after a start. */
export function createForm(desk, started) {
  const along = desk.record?.path;
  const form = { desk, started, kind: 'compare', values: {}, out: {}, files: [], results: [], runs: [], inputs: new Map(), element: h('section.panel.run-form', { dataset: { area: '' } }) };
  for (const [kind, { options }] of Object.entries(KINDS)) form.values[kind] = Object.fromEntries(options.map((option) => [option.id, option.value ?? (option.kind === 'tick' ? false : '')]));
  if (along) form.values.compare.along = form.values.ida.along = along;
  return {
    element: form.element,
    /** Files, results and runs as they are now. */
    update(known) {
      const before = picture(form);
      Object.assign(form, known);
      preselect(form);
      if (picture(form) !== before) redrawKept(form);
      else drawSpec(form);
    },
    open({ kind, set, along, folder } = {}) {
      if (kind && KINDS[kind]) form.kind = kind;
      if (folder) form.values.report.folder = folder;
      if (set) form.values.set.set = set;
      if (along !== undefined) for (const one of ['compare', 'ida']) form.values[one].along = along;
      draw(form);
    },
    /** Fills in what an earlier run had. */
    again(spec) {
      form.kind = spec.kind;
      form.values[spec.kind] = { ...form.values[spec.kind], ...spec.values };
      draw(form);
      form.element.scrollIntoView({ block: 'nearest' });
    },
    redraw: () => draw(form),
  };
}

/** What the choices of the form depend on: where it is the same, the form is not built again under the fingers. */
function picture(form) {
  return JSON.stringify([form.files.map((file) => [file.path, file.kind]), form.results.map((one) => [one.path, one.kind])]);
}

const paths = (form, kind) => form.files.filter((file) => file.kind === kind).map((file) => file.path);
const planned = (form) => form.results.filter((one) => one.kind === 'study').map((one) => one.path);
const reported = (form) => form.results.map((one) => one.path);

/** Builds the form again where files came or went; focus, place of typing and opened options stay. */
function redrawKept(form) {
  const active = form.element.contains(document.activeElement) ? document.activeElement : null;
  const { option } = active?.dataset ?? {};
  const [from, to] = [active?.selectionStart, active?.selectionEnd];
  const opened = form.element.querySelector('details')?.open;
  draw(form);
  const details = form.element.querySelector('details');
  if (details && opened) details.open = true;
  const again = option && form.element.querySelector(`[data-option="${option}"]`);
  again?.focus();
  if (again?.setSelectionRange && again.type === 'text' && from !== null) again.setSelectionRange(from, to);
}

/** The tank of the desk, its record, the only set: what is likely meant. */
function preselect(form) {
  const tanks = paths(form, 'tank');
  const first = { tank: tanks.includes(form.desk.document?.path) ? form.desk.document.path : tanks[0] ?? '', set: paths(form, 'set')[0] ?? '', study: paths(form, 'study')[0] ?? '', planned: planned(form)[0] ?? '', result: reported(form)[0] ?? '' };
  for (const [kind, { options }] of Object.entries(KINDS)) {
    const values = form.values[kind];
    for (const option of options) {
      if (!(option.kind in first)) continue;
      const there = option.kind === 'planned' ? planned(form) : option.kind === 'result' ? reported(form) : paths(form, option.kind);
      if (!there.includes(values[option.id])) values[option.id] = first[option.kind];
    }
  }
}

/* Drawing */

function draw(form) {
  const { kind } = form;
  const { options } = KINDS[kind];
  form.inputs.clear();
  const tabs = h('div.run-kinds', { role: 'radiogroup', 'aria-label': t('run-kind') }, Object.keys(KINDS).map((id) => h('button', {
    type: 'button', role: 'radio', dataset: { option: `kind-${id}` }, 'aria-checked': String(id === kind), tabindex: id === kind ? '0' : '-1', title: t(`run-${id}-hint`),
    onclick: () => choose(form, id), onkeydown: (event) => arrows(form, event, id),
  }, t(`run-${id}`))));
  const fields = options.map((option) => ({ option, element: field(form, option) }));
  const main = fields.filter(({ option }) => !option.more).map(({ element }) => element);
  const more = fields.filter(({ option }) => option.more);
  const changed = more.some(({ option }) => form.values[kind][option.id] !== (option.value ?? (option.kind === 'tick' ? false : '')));
  form.fields = fields;
  form.parts = { out: h('div.run-out'), command: h('code.run-typed', { tabindex: '0' }), start: h('button.primary', {}, t('run-start')), note: h('p.hint', { role: 'status' }) };
  fill(form.element, h('form.stack', { onsubmit: (event) => { event.preventDefault(); start(form); } },
    h('h2', {}, t('run-new')), tabs, h('p.hint', {}, t(`run-${kind}-hint`)), h('div.run-fields', {}, main),
    more.length ? h('details', { open: changed }, h('summary', {}, t('run-more')), h('div.run-fields', {}, more.map(({ element }) => element))) : null,
    form.parts.out,
    h('div.run-command', {}, h('p.hint', {}, t('run-command', { folder: form.desk.info.folder })), form.parts.command,
      h('button.quiet', { type: 'button', onclick: () => copyCommand(form.desk, form.parts.command.textContent) }, t('copy'))),
    h('div.row', {}, form.parts.start, form.parts.note)));
  drawOut(form);
  apply(form);
}

function choose(form, kind, focus = false) {
  form.kind = kind;
  draw(form);
  if (focus) form.element.querySelector('[role=radio][aria-checked=true]').focus();
}

function arrows(form, event, id) {
  const all = Object.keys(KINDS);
  const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  choose(form, all[(all.indexOf(id) + step + all.length) % all.length], true);
}

function field(form, option) {
  const values = form.values[form.kind];
  const change = (value) => {
    values[option.id] = value;
    apply(form);
  };
  if (option.kind === 'tick') {
    const input = h('input', { type: 'checkbox', checked: Boolean(values[option.id]), dataset: { option: option.id }, onchange: () => change(input.checked) });
    form.inputs.set(option.id, input);
    return h('label.tick', {}, input, t(option.words));
  }
  const input = control(form, option, values[option.id]);
  input.dataset.option = option.id;
  input.addEventListener('input', () => change(input.value.trim()));
  form.inputs.set(option.id, input);
  const empty = input instanceof HTMLSelectElement && !input.options.length;
  return empty ? h('p.open-state.run-wide', {}, t({ tank: 'run-no-tank', set: 'run-no-set', study: 'run-no-study', planned: 'run-no-plan', result: 'run-no-results', record: 'rec-none' }[option.kind] ?? option.words))
    : labelled(t(option.words), input, option.hint ? t(option.hint) : null);
}

function control(form, option, value) {
  if (option.kind === 'choice') return choice(option.choices.map(([id, words]) => [id, t(words)]), value);
  if (option.kind === 'record') {
    const records = paths(form, 'record');
    if (value && !records.includes(value)) records.unshift(value);
    const none = option.none ? [['', t(option.none)]] : [['', t('run-record-choose')]];
    return choice([...none, ...records.map((path) => [path, path])], value);
  }
  if (option.kind in { tank: 0, set: 0, study: 0 }) return choice(paths(form, option.kind).map((path) => [path, path]), value);
  if (option.kind === 'planned') return choice(planned(form).map((path) => [path, path]), value);
  if (option.kind === 'result') return choice(reported(form).map((path) => [path, path]), value);
  return h('input', { value, placeholder: option.placeholder, inputmode: option.kind === 'number' ? 'decimal' : null, spellcheck: 'false' });
}

function drawOut(form) {
  const fixed = KINDS[form.kind].folder?.(form.values[form.kind]);
  if (fixed !== null && fixed !== undefined) return void fill(form.parts.out);
  const input = h('input.mono', { spellcheck: 'false', dataset: { option: 'out' }, value: form.out[form.kind] ?? proposal(form), oninput: () => { form.out[form.kind] = input.value.trim(); drawSpec(form); } });
  form.outInput = input;
  form.parts.outNote = h('p.hint', { role: 'status' });
  fill(form.parts.out, labelled(t('run-out'), input), form.parts.outNote);
}

const taken = (form) => takenFolders(form.files, form.results, form.runs);
const proposal = (form) => freeFolder(KINDS[form.kind].out, taken(form));

/** Shows the options that apply, and the command. */
function apply(form) {
  const values = form.values[form.kind];
  for (const { option, element } of form.fields) element.hidden = option.if ? !option.if(values) : false;
  if (form.kind === 'study') drawOut(form);
  drawSpec(form);
}

function drawSpec(form) {
  if (!form.parts) return;
  // A proposal follows what is free; what was typed stays.
  if (form.outInput?.isConnected && form.out[form.kind] === undefined) form.outInput.value = proposal(form);
  const spec = specOf(form);
  drawCommand(form.parts.command, typed(spec).replaceAll("''", '…'));
  const busy = form.runs.some((run) => run.state === 'running' || run.state === 'waiting');
  form.parts.start.textContent = t(busy ? 'run-queue' : 'run-start');
  form.parts.start.disabled = missing(form) !== undefined;
  const { document } = form.desk;
  const unsaved = document?.dirty && document.path === form.values[form.kind].tank ? t('run-unsaved', { path: document.path }) : '';
  const own = document && document.path === form.values[form.kind].tank;
  const faults = own ? document.check?.faults?.length ?? 0 : 0;
  if (!missing(form) && faults) {
    fill(form.parts.note, t('run-faulty', { path: document.path, count: faults }), ' ',
      h('button.link', { type: 'button', onclick: () => form.desk.go('tank') }, t('run-to-tank')));
  } else form.parts.note.textContent = missing(form) ? t('run-missing', { name: t(missing(form).words) }) : unsaved;
  if (form.parts.outNote?.isConnected) noteOut(form, spec.out);
}

function noteOut(form, out) {
  const state = outState(form, out);
  form.outInput.setAttribute('aria-invalid', String(state === 'bad'));
  const free = proposal(form);
  const text = { bad: t('run-out-bad'), results: t('run-out-taken', { out }), files: t('run-out-files', { out }) }[state];
  fill(form.parts.outNote, text ?? '', text && free !== out ? [' ', h('button.link', { type: 'button', onclick: () => { delete form.out[form.kind]; drawSpec(form); } }, t('run-out-free', { out: free }))] : null);
  form.parts.outNote.className = state === 'free' ? 'hint' : 'open-state';
}

/** `bad`, `results`, `files` or `free`. */
function outState(form, out) {
  const parts = out.split('/');
  if (!out || out.startsWith('-') || /[\\:]/.test(out) || parts.some((part) => part === '' || part === '.' || part === '..')) return 'bad';
  if (form.results.some((one) => one.path === out) || form.runs.some((run) => run.out === out && (run.state === 'running' || run.state === 'waiting'))) return 'results';
  return taken(form).has(out) ? 'files' : 'free';
}

function specOf(form) {
  const kind = KINDS[form.kind];
  const values = { ...form.values[form.kind] };
  for (const option of kind.options) if (option.kind === 'number') values[option.id] = values[option.id].replace(',', '.');
  const fixed = kind.folder?.(values);
  const spec = kind.build(values);
  if (fixed !== null && fixed !== undefined) return { ...spec, out: fixed };
  const out = form.out[form.kind] ?? form.outInput?.value ?? '';
  return { command: spec.command, arguments: [...spec.arguments, '--out', out], out };
}

/** The first option without which there is no run. */
function missing(form) {
  const values = form.values[form.kind];
  const needed = (option) => ['tank', 'set', 'study', 'planned', 'result'].includes(option.kind) || (option.kind === 'record' && option.none === null);
  return KINDS[form.kind].options.find((option) => needed(option) && !values[option.id] && !(option.if && !option.if(values)));
}

/* Start */

async function start(form) {
  const { desk, kind } = form;
  if (missing(form) || !numbersFit(form)) return;
  const values = { ...form.values[kind] };
  const spec = specOf(form);
  if (form.parts.outNote?.isConnected && !(await mayWrite(form, spec.out, values.resume))) return;
  if (!(await savedOrAgreed(form, values.tank))) return;
  try {
    form.parts.start.disabled = true;
    const { id } = await desk.api.post('runs', { command: spec.command, arguments: spec.arguments, out: spec.out });
    delete form.out[kind];
    form.started(id, { ...spec, kind, values });
  } catch (error) {
    desk.sayError(error);
  } finally {
    drawSpec(form);
  }
}

function numbersFit(form) {
  for (const { option } of form.fields) {
    if (option.kind !== 'number' || (option.if && !option.if(form.values[form.kind]))) continue;
    const text = form.values[form.kind][option.id];
    const value = Number(text.replace(',', '.'));
    const input = form.inputs.get(option.id);
    const bad = text !== '' && !(value >= option.from && value <= option.to);
    input.setAttribute('aria-invalid', String(bad));
    if (!bad) continue;
    form.desk.say(t('run-bad-number', { name: t(option.words), text, from: option.from, to: option.to }), 'error');
    input.closest('details')?.setAttribute('open', '');
    input.focus();
    return false;
  }
  return true;
}

async function mayWrite(form, out, resume) {
  const state = outState(form, out);
  if (state === 'free' || resume) return true;
  if (state === 'bad') {
    form.outInput.focus();
    return false;
  }
  const free = proposal(form);
  const answer = await form.desk.ask(t(state === 'results' ? 'run-out-taken' : 'run-out-files', { out }), [
    { id: 'free', title: t('run-out-free', { out: free }), kind: 'primary' },
    { id: 'replace', title: t('run-replace'), kind: 'danger' },
    { id: 'cancel', title: t('cancel') },
  ]);
  if (answer === 'free') {
    delete form.out[form.kind];
    drawSpec(form);
  }
  return answer === 'replace';
}

async function savedOrAgreed(form, tank) {
  const { document } = form.desk;
  if (!tank || !document?.dirty || document.path !== tank) return true;
  const answer = await form.desk.ask(t('run-unsaved', { path: tank }), [
    { id: 'save', title: t('run-save-start'), kind: 'primary' },
    { id: 'saved', title: t('run-start-saved') },
    { id: 'cancel', title: t('cancel') },
  ]);
  if (answer !== 'save') return answer === 'saved';
  await document.save();
  return !document.dirty;
}

/** Shows a command; options are not broken at their hyphens. */
export function drawCommand(element, text) {
  if (element.textContent !== text) fill(element, text.split(' ').flatMap((word, i) => [i ? ' ' : null, h('span', {}, word)]));
}

/** Copies a command and says so. */
export async function copyCommand(desk, text) {
  desk.say(t(await copy(text) ? 'copied' : 'not-copied'), 'ok');
}
