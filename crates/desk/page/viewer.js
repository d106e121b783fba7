// A result to look at, for the desk and for interactive.html: summary, scene, histories, profiles, spectra, report, files.

import { h, fill } from './dom.js';
import { add, t, moment } from './words.js';
import { createClock } from './clock.js';
import { summary } from './summary.js';
import { histories, columnsOf } from './histories.js';
import { profiles, spectra } from './profiles.js';
import { hasMaps, maps } from './maps.js';
import { chart, createGroup } from './charts.js';
import { modesOf } from './scene-data.js';
import './scene-words.js';

add({
  'look-tab-summary': ['Summary', 'Übersicht'],
  'look-tab-scene': ['Scene', 'Szene'],
  'look-tab-histories': ['Histories', 'Verläufe'],
  'look-tab-profiles': ['Profiles', 'Profile'],
  'look-tab-maps': ['Maps', 'Karten'],
  'look-tab-spectra': ['Spectra', 'Spektren'],
  'look-tab-report': ['Report', 'Bericht'],
  'look-tab-figures': ['Figures', 'Bilder'],
  'look-tab-files': ['Files', 'Dateien'],
  'look-tabs': ['Parts of the result', 'Teile des Ergebnisses'],
  'look-loading': ['Loading …', 'Lädt …'],
  'look-save': ['Save {name}', '{name} sichern'],
  'look-open-report': ['Open in a tab of its own', 'In eigenem Reiter öffnen'],
  'look-make': ['Make from this result:', 'Aus diesem Ergebnis erzeugen:'],
});

/** Time after which a scene that nobody sees gives its memory back [ms]. */
const LINGER = 20_000;

/**
 * Mounts the viewer of one result.
 *
 * @param {HTMLElement} element
 * @param {{results(): Promise<object>, series(): Promise<object|null>, scene(): Promise<object|null>, report?: string, figures?(): Promise<{name, address}[]>,
 *   files?: {name: string, address: string}[], forms?: {title: string, make(): void}[]}} source `scene` resolves to that of scene-data.js, to null where the result holds none
 * @param {{settings: {language, units}, name?: string, tab?: string, onTab?(tab: string): void}} options
 * @returns `{repaint(), pause(), resume(), destroy(), tab}`: `repaint` after a change of light and dark; after a change of other settings, destroy it and mount it again;
 *   `pause` while the viewer is not seen
 */
export async function mount(element, source, options) {
  const { settings } = options;
  fill(element, h('p.empty', {}, t('look-loading')));
  const results = await source.results();
  const state = { source, options, settings, results, clock: createClock(), open: new Map(), tab: null, dead: false };
  const tabs = [
    'summary',
    'scene',
    'histories',
    'profiles',
    ...(hasMaps(results) ? ['maps'] : []),
    'spectra',
    ...(source.figures ? ['figures'] : []),
    ...(source.report ? ['report'] : []),
    ...(source.files ? ['files'] : []),
  ];
  const buttons = tabs.map((tab) =>
    h(
      'button.look-tab',
      { type: 'button', role: 'tab', id: `look-tab-${tab}`, 'aria-controls': `look-pane-${tab}`, tabindex: '-1', onclick: () => show(tab) },
      t(`look-tab-${tab}`),
    ),
  );
  const list = h('div.look-tabs', { role: 'tablist', 'aria-label': t('look-tabs'), onkeydown: (event) => along(event) }, buttons);
  const panes = new Map(
    tabs.map((tab) => [
      tab,
      h('div.look-pane', { role: 'tabpanel', id: `look-pane-${tab}`, 'aria-labelledby': `look-tab-${tab}`, tabindex: '-1', hidden: true }),
    ]),
  );
  fill(element, list, [...panes.values()]);

  function along(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const next = tabs[(tabs.indexOf(state.tab) + step + tabs.length) % tabs.length];
    show(next);
    buttons[tabs.indexOf(next)].focus();
  }

  /** Lets the scene go where it is not seen for a while; it is read again when it is shown. */
  function linger(seen) {
    clearTimeout(state.lingering);
    if (seen || !state.open.has('scene')) return;
    state.lingering = setTimeout(() => {
      state.open.get('scene')?.destroy?.();
      state.open.delete('scene');
      panes.get('scene').replaceChildren();
    }, LINGER);
  }

  function show(tab) {
    state.open.get(state.tab)?.pause?.();
    state.tab = tab;
    linger(tab === 'scene');
    tabs.forEach((one, i) => {
      panes.get(one).hidden = one !== tab;
      buttons[i].setAttribute('aria-selected', String(one === tab));
      buttons[i].tabIndex = one === tab ? 0 : -1;
    });
    options.onTab?.(tab);
    if (!state.open.has(tab)) {
      const place = {};
      state.open.set(tab, place);
      build(state, tab, panes.get(tab)).then(
        (made) => (state.dead || state.open.get(tab) !== place ? made?.destroy?.() : state.open.set(tab, made ?? {})),
        (error) => fill(panes.get(tab), h('p.empty', {}, error.message)),
      );
    }
  }

  show(tabs.includes(options.tab) ? options.tab : 'summary');
  return {
    get tab() {
      return state.tab;
    },
    results,
    repaint: () => state.open.forEach((one) => one.repaint?.()),
    pause() {
      state.open.forEach((one) => one.pause?.());
      linger(false);
    },
    resume: () => show(state.tab),
    destroy() {
      state.dead = true;
      clearTimeout(state.lingering);
      state.open.forEach((one) => one.destroy?.());
      element.replaceChildren();
    },
  };
}

async function build(state, tab, pane) {
  const { results, settings, source, clock } = state;
  if (tab === 'summary') return put(pane, { element: h('div', {}, about(results), summary(results, settings)) });
  if (tab === 'profiles') return put(pane, profiles(results, settings));
  if (tab === 'maps') return put(pane, maps(results, settings));
  if (tab === 'spectra') return put(pane, spectra(results, settings));
  if (tab === 'report') return put(pane, { element: report(source.report) });
  if (tab === 'files') return put(pane, { element: h('div', {}, files(source.files), forms(source.forms)) });
  fill(pane, h('p.empty', {}, t('look-loading')));
  if (tab === 'figures') return put(pane, { element: figures(await source.figures()) });
  const series = await (state.series ??= source.series().catch(() => null));
  const columns = columnsOf(series, results, settings.language);
  if (tab === 'histories') return put(pane, histories(series ? [{ time: series.time, columns }] : [], settings, clock, series?.every ?? 1));
  return sceneTab(state, pane, series, columns);
}

function put(pane, made) {
  fill(pane, made.element);
  return made;
}

function about(results) {
  const { created, version, command } = results.volatile ?? {};
  return h(
    'section.look-about',
    {},
    h('p', {}, t('look-about', { name: results.name ?? '', when: moment(created), version: version ?? '' })),
    command ? h('p.hint', {}, h('code', {}, command)) : null,
  );
}

function report(address) {
  return h(
    'div.look-report',
    {},
    h('p', {}, h('a', { href: address, target: '_blank', rel: 'noopener' }, t('look-open-report'))),
    h('iframe', { src: address, sandbox: 'allow-popups', title: t('look-tab-report') }),
  );
}

const files = (list) =>
  h(
    'ul.look-files',
    {},
    list.map(({ name, address }) => h('li', {}, h('a', { href: address, download: name.split('/').at(-1) }, t('look-save', { name })))),
  );

/** Forms of the report that are made on demand: `[{title, make()}]`. */
const forms = (list) =>
  list?.length
    ? h(
        'p.look-line.look-forms',
        {},
        t('look-make'),
        list.map(({ title, make }) => h('button', { type: 'button', onclick: make }, title)),
      )
    : null;

const figures = (list) =>
  h(
    'div.look-figures',
    {},
    list.map(({ name, address }) =>
      h(
        'figure',
        {},
        h('img', { src: address, alt: name.replace(/\.svg$/, '').replaceAll('_', ' '), loading: 'lazy' }),
        h('figcaption', {}, h('a', { href: address, download: name.split('/').at(-1) }, t('look-save', { name }))),
      ),
    ),
  );

/** The scene with the record under it; without scene.json the modes, and the command that keeps a scene. */
async function sceneTab(state, pane, series, columns) {
  const { results, settings, source, clock } = state;
  const notes = [];
  let scene = null;
  try {
    scene = await source.scene();
  } catch (error) {
    notes.push(h('p.look-note', {}, t('scene-fault', { fault: error.message })));
  }
  if (!scene) {
    scene = modesOf(results);
    const command = results.volatile?.command;
    if (!notes.length) notes.push(noScene(h('code', {}, kept(command)), Boolean(scene), Boolean(source.forms)));
  }
  const host = h('div');
  const under = h('div');
  fill(pane, notes, host, under);
  let panel = null;
  if (scene) {
    try {
      const { createScenePanel } = await import('./scene-panel.js');
      panel = createScenePanel(scene, clock, settings, results.name ?? 'tank');
      host.append(panel.element);
      panel.element.querySelector('.scene-main').append(under);
    } catch (error) {
      console.warn(error);
      host.append(h('p.look-note', {}, t('scene-no-webgl')));
    }
  }
  const ground = columns.find(({ name }) => name === 'ground_acceleration') ?? columns[0];
  const record =
    ground &&
    chart(
      under,
      {
        title: ground.title,
        x: { title: t('scene-time'), values: series.time, dimension: 'time' },
        y: { dimension: ground.dimension },
        series: [{ title: ground.title, values: ground.values }],
        height: 130,
        scrub: Boolean(scene?.frames),
      },
      settings,
      createGroup(clock),
    );
  return {
    element: pane,
    repaint() {
      panel?.repaint();
      record?.repaint();
    },
    pause: () => panel?.pause(),
    destroy() {
      panel?.destroy();
      record?.destroy();
    },
  };
}

/** Says how a scene is had: by a run from the desk, or by a command where there is only this file. */
function noScene(command, modes, desk) {
  const drawn = modes ? t('scene-none-modes') : '';
  if (!desk) return h('p.look-note', {}, t('scene-none-file'), ' ', command, ' ', drawn);
  return h('div.look-note', {}, h('p', {}, t('scene-none'), ' ', drawn), h('details', {}, h('summary', {}, t('scene-command')), command));
}

/** The command of the result with `--scene`. */
function kept(command) {
  if (!command) return 'tankcheck compare … --scene';
  return command.includes('--scene') ? command : `${command} --scene`;
}
