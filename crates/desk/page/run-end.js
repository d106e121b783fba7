// What the end of a run means.

import './runs-words.js';
import { t } from './words.js';

/** Whether the exit code of a run is a verdict on the tank. */
export function judges(run) {
  return /^tankcheck (compare|check)\b/.test(run.command);
}

/** The exit code in words. */
export function endWords(run) {
  if (run.state === 'cancelled') return t(run.code === 130 || run.code === null ? 'run-code-130' : 'run-kept');
  if (run.code === 0) return t(judges(run) ? 'run-code-0' : 'run-code-0-plain');
  return t([1, 2, 3, 4, 130].includes(run.code) ? `run-code-${run.code}` : 'run-code-other');
}
