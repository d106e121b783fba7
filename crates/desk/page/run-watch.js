// Runs seen from any room: how many there are stands on the tab, and the end of one is told.

import { endWords, resultOf } from './run-end.js';
import { t } from './words.js';

const RUNNING = new Set(['waiting', 'running']);

/** Watches the events of the desk; `current()` is the room that is shown. */
export function watchRuns(desk, current) {
  const before = new Map();
  desk.events.addEventListener('runs', ({ detail }) => {
    if (!Array.isArray(detail)) return;
    for (const run of detail) {
      if (RUNNING.has(before.get(run.id)) && !RUNNING.has(run.state)) told(desk, run, current());
      before.set(run.id, run.state);
    }
    desk.busy = detail.filter((run) => RUNNING.has(run.state)).length;
    drawBusy(desk);
  });
}

async function told(desk, run, room) {
  if (room === 'runs' || room === 'records' && run.out?.endsWith('-rule')) return;
  const kind = run.state === 'done' ? { 0: 'ok', 1: 'warning', 4: 'warning' }[run.code] ?? 'info' : 'error';
  const { results } = await desk.api.get('folder').catch(() => ({ results: [] }));
  const kept = Boolean(resultOf(run, results ?? []));
  const act = run.state === 'failed' || !kept ? { title: t('room-runs'), act: () => desk.go('runs') } : { title: t('run-look'), act: () => desk.go('look', { path: run.out }) };
  desk.say(t('run-ended', { out: run.out ?? run.command, text: endWords(run, kept) }), kind, act);
}

/** Puts the number of runs on the tab. */
export function drawBusy(desk) {
  const tab = document.getElementById('tab-runs');
  if (!tab) return;
  tab.dataset.busy = desk.busy ? String(desk.busy) : '';
}
