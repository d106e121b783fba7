// What the end of a run means.

import './runs-words.js';
import { t } from './words.js';

/** Moments of files have whole seconds, and clocks of page and program may differ a little [s]. */
const SLACK = 2;

/** Whether the exit code of a run is a verdict on the tank. */
export function judges(run) {
  return /^tankcheck (compare|check)\b/.test(run.command);
}

/** What the folder of an ended run holds of it: its entry among the results, or undefined. A run that did not finish may have met older results there. */
export function resultOf(run, results) {
  const found = results.find((one) => one.path === run.out);
  if (!found || run.state === 'done' || !Number.isFinite(run.age)) return found;
  const begun = Date.now() - 1000 * (run.age + SLACK);
  return Date.parse(found.created) < begun ? undefined : found;
}

/** The exit code in words; `kept`: whether the run has left results. */
export function endWords(run, kept) {
  if (run.state === 'cancelled') return t(kept ? 'run-kept' : 'run-cancelled-empty');
  if (run.state === 'failed' && run.code !== 2 && !kept) return `${codeWords(run)} ${t('run-empty')}`;
  return codeWords(run);
}

function codeWords(run) {
  if (run.code === 0) return t(judges(run) ? 'run-code-0' : 'run-code-0-plain');
  return t([1, 2, 3, 4, 130].includes(run.code) ? `run-code-${run.code}` : 'run-code-other');
}
