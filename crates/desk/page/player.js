// Play, pause, step, scrub, speed and loop of a scene: moves the clock.

import { h } from './dom.js';
import { t, localised } from './words.js';
import './scene-words.js';

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

/**
 * The bar under a scene.
 *
 * @param {object} clock of clock.js
 * @param {{times: ArrayLike<number>, moving(moving: boolean): void, frame(): void}} scene `frame` draws, `moving` tells of play and pause
 * @returns `{element, toggle(), pause(), step(count), slow(), playing, destroy(), oscillate(draw|null)}`; with a function, play calls it with seconds instead of moving the clock
 */
export function createPlayer(clock, { times, moving, frame }) {
  const first = times[0] ?? 0;
  const last = times[times.length - 1] ?? 0;
  const state = { playing: false, handle: 0, before: 0, speed: 1, loop: true, wave: null, seconds: 0, told: 0 };
  const button = h('button.primary', { type: 'button', onclick: () => toggle() }, t('scene-play'));
  const scrub = h('input.player-scrub', {
    type: 'range',
    min: String(first),
    max: String(last),
    step: 'any',
    value: String(first),
    'aria-label': t('scene-time'),
    oninput: () => clock.set(Number(scrub.value), state),
  });
  const label = h('output.player-time');
  const speed = h(
    'select',
    {
      'aria-label': t('scene-speed'),
      title: t('scene-speed'),
      onchange: () => {
        state.speed = Number(speed.value);
      },
    },
    SPEEDS.map((value) => h('option', { value: String(value) }, `${localised(String(value))} ×`)),
  );
  speed.value = '1';
  const loop = h('input', {
    type: 'checkbox',
    onchange: () => {
      state.loop = loop.checked;
    },
  });
  loop.checked = true;
  const step = (text, title, count) => h('button.quiet', { type: 'button', title: t(title), 'aria-label': t(title), onclick: () => go(count) }, text);
  const timed = h('span.player-timed', {}, step('◀', 'scene-back', -1), step('▶', 'scene-on', 1), scrub, label);
  const element = h('div.player', {}, button, timed, speed, h('label.tick', {}, loop, t('scene-loop')));

  function show(time, by) {
    // While it plays, ten times a second are enough: each change makes the browser paint the bar.
    const now = performance.now();
    if (state.playing && now - state.told < 100) return;
    state.told = now;
    const text = `${localised(time.toFixed(2))} s`;
    label.textContent = text;
    if (by !== state || state.playing) scrub.value = String(time);
    scrub.setAttribute('aria-valuetext', text);
  }

  function tick(now) {
    if (!state.playing) return;
    state.handle = requestAnimationFrame(tick);
    // A page that was hidden goes on where it stood.
    const passed = Math.min(0.1, (now - state.before) / 1000) * state.speed;
    state.before = now;
    if (state.wave) {
      state.seconds += passed;
      state.wave(state.seconds);
    } else advance(passed);
    if (state.playing) frame();
  }

  function advance(passed) {
    let time = clock.time + passed;
    if (time > last) {
      if (!state.loop) {
        clock.set(last, state);
        pause();
        return;
      }
      time = first;
    }
    clock.set(time, state);
  }

  function toggle() {
    if (state.playing) pause();
    else play();
  }

  function play() {
    if (state.playing || (!state.wave && !(last > first))) return;
    if (!state.wave && (clock.time >= last || clock.time < first)) clock.set(first, state);
    state.playing = true;
    clock.playing = true;
    state.before = performance.now();
    button.textContent = t('scene-pause');
    moving(true);
    state.handle = requestAnimationFrame(tick);
  }

  function pause() {
    if (!state.playing) return;
    state.playing = false;
    clock.playing = false;
    cancelAnimationFrame(state.handle);
    clock.set(clock.time, null);
    button.textContent = t('scene-play');
    moving(false);
  }

  function go(count) {
    pause();
    if (state.wave) return;
    let at = 0;
    while (at + 1 < times.length && times[at + 1] <= clock.time + 1e-9) at += 1;
    clock.set(times[Math.min(times.length - 1, Math.max(0, at + count))] ?? 0, state);
  }

  const hidden = () => document.hidden && pause();
  document.addEventListener('visibilitychange', hidden);
  const off = clock.on(show);
  show(clock.time, null);
  return {
    element,
    toggle,
    play,
    pause,
    step: go,
    /** The slowest speed. */
    slow() {
      state.speed = SPEEDS[0];
      speed.value = String(SPEEDS[0]);
    },
    get playing() {
      return state.playing;
    },
    oscillate(wave) {
      pause();
      state.wave = wave;
      state.seconds = 0;
      timed.hidden = Boolean(wave);
    },
    destroy() {
      pause();
      off();
      document.removeEventListener('visibilitychange', hidden);
    },
  };
}
