// The kinds of runs: their options, and the command that they make.

import { reading } from './reading.js';

const ENGINES = ['auto', 'harmonic', 'solid', 'both', 'nonlinear', 'none'].map((id) => [id === 'auto' ? '' : id, `run-engine-${id}`]);
const REPORTS = ['standard', 'summary', 'full', 'none'].map((id) => [id === 'standard' ? '' : id, `run-report-${id}`]);

// An option: id, kind (tank, record, set, study, planned, result, choice, number, text, tick), words, where it stands (`more`), `if(values)`.
const tank = { id: 'tank', kind: 'tank', words: 'run-tank' };
const up = { id: 'up', kind: 'record', words: 'run-up', none: 'run-none' };
const memory = { id: 'memory', kind: 'number', words: 'run-memory', from: 64, to: 1e6, placeholder: '4096', more: true };
const lang = { id: 'lang', kind: 'choice', words: 'run-lang', choices: [['', 'run-lang-file'], ['en', 'English'], ['de', 'Deutsch']], more: true };
const units = { id: 'units', kind: 'choice', words: 'run-report-units', choices: [['', 'run-lang-file'], ['si', 'SI'], ['us', 'US'], ['both', 'run-both-units']], more: true };
const resume = { id: 'resume', kind: 'tick', words: 'run-resume', more: true };
const linear = (values) => values.fe !== 'none' && values.fe !== 'nonlinear';
const computed = [
  { id: 'refine', kind: 'number', words: 'run-refine', hint: 'run-refine-hint', from: 0.25, to: 16, placeholder: '1', if: (values) => values.fe !== 'none' },
  { id: 'report', kind: 'choice', words: 'run-report', choices: REPORTS },
  lang, units, memory,
  { id: 'meshError', kind: 'tick', words: 'run-mesh-error', value: true, more: true, if: (values) => values.fe !== 'none' },
  { id: 'newmark', kind: 'tick', words: 'run-newmark', more: true, if: linear },
];

/** The kinds in the order of their tabs. */
export const KINDS = {
  compare: {
    out: 'out',
    options: [
      tank,
      { id: 'fe', kind: 'choice', words: 'run-engine', choices: ENGINES },
      { id: 'along', kind: 'record', words: 'run-record', none: 'run-record-none' },
      { id: 'across', kind: 'record', words: 'run-across', none: 'run-none', if: (values) => values.along },
      { ...up, if: (values) => values.along },
      ...computed,
      { ...resume, if: (values) => values.fe === 'nonlinear' },
    ],
    build: (values) => ({
      command: 'compare',
      arguments: [values.tank, ...record('--quake', values.along), ...(values.along ? [...record('--quake-y', values.across), ...record('--vertical', values.up)] : []),
        ...how(values), ...engine(values), ...pages(values)],
    }),
  },
  set: {
    out: 'out-set',
    options: [
      tank,
      { id: 'set', kind: 'set', words: 'run-set-file' },
      { id: 'fe', kind: 'choice', words: 'run-engine', choices: ENGINES.filter(([id]) => id !== 'nonlinear') },
      { id: 'fit', kind: 'tick', words: 'run-fit' },
      ...computed,
    ],
    build: (values) => ({ command: 'compare', arguments: [values.tank, '--set', values.set, ...flag('--fit', values.fit), ...engine(values), ...pages(values)] }),
  },
  ida: {
    out: 'ida',
    options: [
      tank,
      { id: 'along', kind: 'record', words: 'run-record', none: null },
      up,
      { id: 'scale', kind: 'text', words: 'run-scale', hint: 'run-scale-hint', value: '0..1.1' },
      { id: 'steps', kind: 'number', words: 'run-steps', from: 2, to: 200, value: '12', if: (values) => values.scale.includes('..') },
      { id: 'jobs', kind: 'number', words: 'run-jobs', from: 1, to: 256, placeholder: '1', more: true },
      lang, units, memory, resume,
    ],
    build: (values) => ({
      command: 'ida',
      arguments: [values.tank, ...record('--quake', values.along), ...record('--vertical', values.up), ...how(values), ...given('--scale', values.scale),
        ...(values.scale.includes('..') ? given('--steps', values.steps) : []), ...given('--jobs', values.jobs), ...words(values), ...given('--memory-limit', values.memory), ...flag('--resume', values.resume)],
    }),
  },
  push: {
    out: 'push',
    options: [
      tank,
      { id: 'imperfection', kind: 'text', words: 'run-imperfection', hint: 'run-imperfection-hint', value: '' },
      { id: 'shape', kind: 'choice', words: 'run-shape', choices: [['', 'run-shape-weld'], ['mode', 'run-shape-mode']], if: (values) => values.imperfection },
      { id: 'planeFoot', kind: 'tick', words: 'run-plane-foot', more: true },
      lang, units, memory, resume,
    ],
    build: (values) => ({
      command: 'push',
      // An amplitude may be negative: joined, it is not taken for an option.
      arguments: [values.tank, ...(values.imperfection ? [`--imperfection=${values.imperfection}`, ...given('--imperfection-shape', values.shape)] : []),
        ...flag('--plane-foot', values.planeFoot), ...words(values), ...given('--memory-limit', values.memory), ...flag('--resume', values.resume)],
    }),
  },
  study: {
    out: 'study',
    options: [
      { id: 'step', kind: 'choice', words: 'run-step', choices: [['plan', 'run-step-plan'], ['run', 'run-step-run'], ['merge', 'run-step-merge']], value: 'plan' },
      { id: 'study', kind: 'study', words: 'run-study-file', if: (values) => values.step === 'plan' },
      { id: 'planned', kind: 'planned', words: 'run-study-folder', if: (values) => values.step !== 'plan' },
      { id: 'jobs', kind: 'number', words: 'run-jobs', from: 1, to: 256, placeholder: '', more: true, if: (values) => values.step === 'run' },
      { ...memory, if: (values) => values.step === 'run' },
    ],
    build: (values) => ({
      command: `study ${values.step}`,
      arguments: values.step === 'plan' ? [values.study] : [values.planned, ...(values.step === 'run' ? [...given('--jobs', values.jobs), ...given('--memory-limit', values.memory)] : [])],
    }),
    /** Only the plan makes a folder; the other steps work in that of the plan. */
    folder: (values) => (values.step === 'plan' ? null : values.planned),
  },
  report: {
    out: '',
    options: [
      { id: 'folder', kind: 'result', words: 'run-results' },
      { id: 'level', kind: 'choice', words: 'run-report', choices: REPORTS.filter(([id]) => id !== 'none') },
      lang, units,
      { id: 'pdf', kind: 'tick', words: 'run-form-pdf', value: true },
      { id: 'docx', kind: 'tick', words: 'run-form-docx' },
      { id: 'xlsx', kind: 'tick', words: 'run-form-xlsx' },
    ].map((option) => ({ ...option, more: false })),
    build: (values) => ({
      command: 'report',
      arguments: [values.folder, ...given('--report', values.level), ...given('--format', ['pdf', 'docx', 'xlsx'].filter((form) => values[form]).join(',')), ...words(values)],
    }),
    folder: (values) => values.folder,
  },
};

/** The next step of a study after one that is done; null after the last. */
export function nextOfStudy(run) {
  const step = { plan: 'run', run: 'merge' }[run.command.match(/^tankcheck study (plan|run) /)?.[1]];
  return step && run.code === 0 && run.out ? { command: `study ${step}`, arguments: [run.out], out: run.out, step } : null;
}

/** The PDF of a folder of results. */
export const printed = ({ out, command }) => {
  // In the language and units that the report was asked for in.
  const asked = ['--lang', '--report-units'].flatMap((option) => new RegExp(`${option} (\\w+)`).exec(command)?.slice(1).flatMap((value) => [option, value]) ?? []);
  return { command: 'report', arguments: [out, '--format', 'pdf', ...asked], out };
};

/** Files that `report` has written beside the page. */
export function writtenForms(run) {
  const forms = run.command.match(/^tankcheck report .*--format ([\w,]+)/)?.[1] ?? '';
  return forms.split(',').filter((form) => ['pdf', 'docx', 'xlsx'].includes(form)).map((form) => `report.${form}`);
}

/* Arguments */

const given = (name, value) => (value === '' || value === undefined || value === null ? [] : [name, String(value)]);
const flag = (name, on) => (on ? [name] : []);
const words = (values) => [...given('--lang', values.lang), ...given('--report-units', values.units)];

function record(name, path) {
  if (!path) return [];
  const { channel } = reading(path);
  return [name, channel ? `${path}#${channel}` : path];
}

// One unit, time step and so on stand for all records of a run: those of the first that needs them.
function how(values) {
  const all = [values.along, values.across, values.up].filter(Boolean).map(reading);
  const first = (key) => all.find((one) => one[key])?.[key];
  return [...given('--units', first('units')), ...given('--dt', first('dt')), ...given('--columns', first('columns')), ...given('--skip-lines', first('skip_lines'))];
}

function engine(values) {
  const some = values.fe !== 'none';
  return [...given('--fe', values.fe), ...(some ? given('--refine', values.refine) : []), ...flag('--no-mesh-error', some && values.meshError === false),
    ...(linear(values) && values.newmark ? ['--integrator', 'newmark'] : []), ...given('--memory-limit', values.memory), ...flag('--resume', values.fe === 'nonlinear' && values.resume),
    ...flag('--scene', some)];
}

function pages(values) {
  return [...(values.report === 'none' ? ['--no-report'] : given('--report', values.report)), ...words(values)];
}

/** The command as it is typed in a shell. */
export function typed(spec) {
  return ['tankcheck', ...spec.command.split(' '), ...spec.arguments].map(quoted).join(' ');
}

function quoted(text) {
  return /^[\w@%+=:,./#^-]+$/.test(text) && !text.startsWith('#') ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/** A folder name that is not taken: out, out-2, out-3 … */
export function freeFolder(stem, taken) {
  let name = stem;
  for (let i = 2; taken.has(name); i += 1) name = `${stem}-${i}`;
  return name;
}

/** Folders that hold results or files, with those on the way to them. */
export function takenFolders(files, results, runs) {
  const taken = new Set();
  for (const { path } of [...files, ...results.map((one) => ({ path: `${one.path}/x` }))]) {
    const parts = path.split('/').slice(0, -1);
    for (let i = 1; i <= parts.length; i += 1) taken.add(parts.slice(0, i).join('/'));
  }
  for (const run of runs) if (run.out && (run.state === 'waiting' || run.state === 'running')) taken.add(run.out);
  return taken;
}
