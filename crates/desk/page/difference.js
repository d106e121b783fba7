// The lines in which two texts differ.

import { h } from './dom.js';
import { t } from './words.js';

const SHOWN_AROUND = 2;

/** Steps from one list of lines to another: `[{sign: ' '|'-'|'+', line}]`. */
export function steps(before, after) {
  const [a, b] = [before.split('\n'), after.split('\n')];
  let start = 0;
  while (start < a.length && start < b.length && a[start] === b[start]) start += 1;
  let end = 0;
  while (end < a.length - start && end < b.length - start && a[a.length - 1 - end] === b[b.length - 1 - end]) end += 1;
  const middle = between(a.slice(start, a.length - end), b.slice(start, b.length - end));
  const same = (lines) => lines.map((line) => ({ sign: ' ', line }));
  return [...same(a.slice(0, start)), ...middle, ...same(end ? a.slice(-end) : [])];
}

// Longest common subsequence; very long differing parts are shown as a whole.
function between(a, b) {
  if (a.length * b.length > 4e6) return [...mark(a, '-'), ...mark(b, '+')];
  const width = b.length + 1;
  const length = new Uint16Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; i -= 1) {
    for (let j = b.length - 1; j >= 0; j -= 1) {
      length[i * width + j] = a[i] === b[j]
        ? length[(i + 1) * width + j + 1] + 1 : Math.max(length[(i + 1) * width + j], length[i * width + j + 1]);
    }
  }
  const found = [];
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      found.push({ sign: ' ', line: a[i] });
      i += 1;
      j += 1;
    } else if (i < a.length && (j >= b.length || length[(i + 1) * width + j] >= length[i * width + j + 1])) {
      found.push({ sign: '-', line: a[i++] });
    } else {
      found.push({ sign: '+', line: b[j++] });
    }
  }
  return found;
}

const mark = (lines, sign) => lines.map((line) => ({ sign, line }));

/** The difference as a block; unchanged lines far from a change are left out. */
export function differenceBlock(before, after) {
  const all = steps(before, after);
  const near = all.map((_, index) => all.slice(Math.max(0, index - SHOWN_AROUND), index + SHOWN_AROUND + 1).some((one) => one.sign !== ' '));
  const block = h('pre.tank-difference', { tabindex: 0 });
  all.forEach((step, index) => {
    if (near[index]) block.append(h('span', { class: { '-': 'gone', '+': 'come', ' ': 'same' }[step.sign] }, `${step.sign} ${step.line}\n`));
    else if (index > 0 && near[index - 1]) block.append(h('span.same', {}, '  …\n'));
  });
  if (!block.childNodes.length) block.append(t('doc-no-difference'));
  return block;
}
