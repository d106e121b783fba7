// The page of interactive.html: one result with its data embedded, and the same viewer as in the desk.

import { h, fill, choice } from './dom.js';
import { add, setLanguage, t } from './words.js';
import { decoded } from './scene-data.js';
import { mount } from './viewer.js';

add({
  'file-language': ['Language', 'Sprache'],
  'file-units': ['Units', 'Einheiten'],
  'file-theme': ['Appearance', 'Darstellung'],
  'file-auto': ['Auto', 'Automatisch'],
  'file-light': ['Light', 'Hell'],
  'file-dark': ['Dark', 'Dunkel'],
});

/** JSON that the file holds, or null. */
function held(id) {
  const element = document.getElementById(id);
  return element ? JSON.parse(element.textContent) : null;
}

const start = held('settings');
const settings = { language: start.language, units: start.units };
const results = held('results');
const figures = (held('figures') ?? []).map(([name, svg]) => ({ name, address: URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' })) }));
const source = {
  results: async () => results,
  series: async () => held('series'),
  scene: async () => {
    const json = held('scene');
    return json && decoded(json);
  },
  ...(figures.length ? { figures: async () => figures } : {}),
};
const head = document.getElementById('top');
const host = h('div.look-file');
let view = null;
document.getElementById('main').append(host);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => view?.repaint());
draw();

/** Head and viewer in the present language and units. */
async function draw() {
  setLanguage(settings.language);
  const select = (id, pairs, value, act) =>
    choice(pairs, value, { 'aria-label': t(`file-${id}`), title: t(`file-${id}`), onchange: (event) => act(event.target.value) });
  const change = (name) => (value) => {
    settings[name] = value;
    draw();
  };
  fill(
    head,
    h('h1.look-file-name', {}, results.name ?? 'tankcheck'),
    select(
      'language',
      [
        ['en', 'English'],
        ['de', 'Deutsch'],
      ],
      settings.language,
      change('language'),
    ),
    select(
      'units',
      [
        ['si', 'SI'],
        ['us', 'US'],
      ],
      settings.units,
      change('units'),
    ),
    select(
      'theme',
      ['auto', 'light', 'dark'].map((theme) => [theme, t(`file-${theme}`)]),
      document.documentElement.dataset.theme,
      (theme) => {
        document.documentElement.dataset.theme = theme;
        view?.repaint();
      },
    ),
  );
  const tab = view?.tab;
  view?.destroy();
  view = await mount(host, source, { settings: { ...settings }, tab });
}
