// Long series for charts: thinning that loses no peak, looking up a time, joining profiles.

/** Index of the sample nearest to `x` in ascending `xs`. */
export function nearest(xs, x) {
  const at = lower(xs, x);
  return at > 0 && (at === xs.length || x - xs[at - 1] < xs[at] - x) ? at - 1 : at;
}

/** First index whose value is not below `x`. */
export function lower(xs, x) {
  let low = 0;
  let high = xs.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (xs[middle] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * The samples between `from` and `to` for a chart `width` pixels wide: each pixel keeps the smallest and the largest value of every series, in the
 * order in which they come. Series that are short enough are returned whole.
 *
 * @param {ArrayLike<number>} xs ascending
 * @param {ArrayLike<number>[]} series
 * @returns {number[][]} `[xs, ...series]`
 */
export function thinned(xs, series, from, to, width) {
  const first = Math.max(0, lower(xs, from) - 1);
  const last = Math.min(xs.length - 1, lower(xs, to) + 1);
  const count = last - first + 1;
  if (count <= 4 * width) return [xs, ...series].map((values) => Array.from(values.slice(first, last + 1)));
  const bucket = count / width;
  const out = Array.from({ length: series.length + 1 }, () => new Array(2 * width));
  for (let i = 0; i < width; i += 1) {
    const start = first + Math.floor(i * bucket);
    const end = Math.min(last + 1, first + Math.floor((i + 1) * bucket));
    out[0][2 * i] = xs[start];
    out[0][2 * i + 1] = (xs[start] + xs[end - 1]) / 2;
    for (let s = 0; s < series.length; s += 1) extremes(series[s], start, end, out[s + 1], 2 * i);
  }
  return out;
}

function extremes(values, start, end, out, at) {
  let low = start;
  let high = start;
  for (let i = start + 1; i < end; i += 1) {
    if (!(values[i] >= values[low])) low = i;
    if (!(values[i] <= values[high])) high = i;
  }
  out[at] = values[Math.min(low, high)];
  out[at + 1] = values[Math.max(low, high)];
}

/** Largest absolute value of a series and its index. */
export function peak(values) {
  let at = 0;
  for (let i = 1; i < values.length; i += 1) if (Math.abs(values[i]) > Math.abs(values[at]) || Number.isNaN(values[at])) at = i;
  return { at, value: values[at] };
}

/**
 * Profiles on one list of heights: `profiles` are `{z, values}`. A height that a profile has twice (a step between courses) stays twice, with the value below
 * and above it; outside its heights a profile is null.
 */
export function joined(profiles) {
  const times = new Map();
  for (const { z } of profiles) {
    const own = new Map();
    for (const height of z) own.set(height, (own.get(height) ?? 0) + 1);
    for (const [height, count] of own) times.set(height, Math.min(2, Math.max(times.get(height) ?? 0, count)));
  }
  const heights = [...times.keys()].sort((a, b) => a - b).flatMap((height) => new Array(times.get(height)).fill(height));
  const values = profiles.map(({ z, values: own }) => heights.map((height, i) => interpolated(z, own, height, i > 0 && heights[i - 1] === height)));
  return { heights, values };
}

function interpolated(z, values, height, above) {
  if (!z.length || height < z[0] || height > z[z.length - 1]) return null;
  let at = lower(z, height);
  if (z[at] === height) {
    if (above && z[at + 1] === height) at += 1;
    return values[at];
  }
  const share = (height - z[at - 1]) / (z[at] - z[at - 1]);
  return values[at - 1] + share * (values[at] - values[at - 1]);
}
