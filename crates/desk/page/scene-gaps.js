// How close the pictures of a scene are, against the first period of the wall: a slower motion than the true one would be seen, and nothing would say so.

/** Pictures in a period that show it. */
const ENOUGH = 4;
/** Pictures of which a part that resolves the period has at least so many. */
const LEAST = 3 * ENOUGH;

/**
 * The longest part of a scene in which the first period of the wall is resolved.
 *
 * @returns null where all of it is, or no mode of the wall is known; else `{period, gap, from, to}`: the usual time between two pictures, and the part
 *   (`from` null where there is none) [s]
 */
export function gapsOf({ times, modes }) {
  const frequency = Math.min(...modes.filter((mode) => mode.title && !mode.title.startsWith('Sloshing')).map((mode) => mode.frequency).filter((f) => f > 0));
  if (!Number.isFinite(frequency) || times.length < 3) return null;
  const period = 1 / frequency;
  const gaps = Array.from({ length: times.length - 1 }, (_, i) => times[i + 1] - times[i]);
  const fine = gaps.map((gap) => gap <= (1.02 * period) / ENOUGH);
  if (fine.every(Boolean)) return null;
  const coarse = gaps.filter((_, i) => !fine[i]).sort((a, b) => a - b);
  let best = { length: 0, start: 0 };
  for (let i = 0, start = 0; i <= fine.length; i += 1) {
    if (fine[i]) continue;
    if (i - start > best.length) best = { length: i - start, start };
    start = i + 1;
  }
  const found = best.length >= LEAST;
  return { period, gap: coarse[Math.floor(coarse.length / 2)], from: found ? times[best.start] : null, to: found ? times[best.start + best.length] : null };
}
