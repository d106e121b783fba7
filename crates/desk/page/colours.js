// Colour maps of the scene. Both are perceptually uniform and readable with colour blindness: viridis (van der Walt, Smith; CC0) for values of one
// sign, a diverging blue–grey–red after Moreland (2009) for signed ones, symmetric about zero.

const hex = (text) => text.match(/../g).map((pair) => parseInt(pair, 16) / 255);

/** Eleven colours, equally spaced; between them the colour is linear. */
export const SEQUENTIAL = ['440154', '482475', '414487', '355f8d', '2a788e', '21918c', '22a884', '44bf70', '7ad151', 'bddf26', 'fde725'].map(hex);
export const DIVERGING = ['3b4cc0', '5977e3', '7b9ff9', '9ebeff', 'c0d4f5', 'dddcdc', 'f2cbb7', 'f7ac8e', 'ee8468', 'd65244', 'b40426'].map(hex);

/** A range of values and its colours: symmetric where the values have both signs. */
export function scaleOf(low, high) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (!(size > 0)) return { low: 0, high: 1, colours: SEQUENTIAL };
  if (low < -0.02 * size && high > 0.02 * size) return { low: -size, high: size, colours: DIVERGING };
  return { low: high <= 0.02 * size ? low : Math.min(0, low), high: high <= 0.02 * size ? 0 : high, colours: SEQUENTIAL };
}

/** A CSS gradient from bottom to top. */
export function gradient(colours) {
  const css = ([r, g, b]) => `rgb(${Math.round(r * 255)} ${Math.round(g * 255)} ${Math.round(b * 255)})`;
  return `linear-gradient(to top, ${colours.map(css).join(', ')})`;
}
