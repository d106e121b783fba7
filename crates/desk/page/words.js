// All words of the page in English and German. A room adds its own with `add`; a missing text shows its id.

const table = new Map();
let language = 'en';

/** Adds texts: `add({ 'run-start': ['Start', 'Starten'] })`. `{name}` stands for an argument of `t`. */
export function add(texts) {
  for (const [id, pair] of Object.entries(texts)) table.set(id, pair);
}

/** The text `id` in the language of the page, with its arguments. */
export function t(id, args = {}) {
  const pair = table.get(id);
  if (!pair) return id;
  const text = pair[language === 'de' ? 1 : 0] ?? pair[0];
  return text.replace(/\{(\w+)\}/g, (whole, name) => (name in args ? String(args[name]) : whole));
}

/** Sets the language of `t` and `number`. */
export function setLanguage(value) {
  language = value === 'de' ? 'de' : 'en';
  document.documentElement.lang = language;
}

/** A number with some significant digits and the decimal sign of the language; `–` for none. */
export function number(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    return `${localised(mantissa)} · 10${raised(Number(exponent))}`;
  }
  const decimals = size === 0 ? 0 : Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return localised(value.toFixed(Math.min(decimals, 8)));
}

/** A plain decimal text with the decimal sign and the minus of the language. */
export function localised(text) {
  const signed = text.replace(/^-/, '−');
  return language === 'de' ? signed.replace('.', ',') : signed;
}

function raised(exponent) {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return (exponent < 0 ? '⁻' : '') + String(Math.abs(exponent)).replace(/\d/g, (digit) => digits[digit]);
}

/** A date and time, short. */
export function moment(value) {
  // A number below 10¹¹ is in seconds.
  const date = new Date(typeof value === 'number' && value < 1e11 ? value * 1000 : value);
  if (Number.isNaN(date.getTime())) return String(value ?? '–');
  return date.toLocaleString(language === 'de' ? 'de-DE' : 'en-GB', { dateStyle: 'medium', timeStyle: 'short' });
}

/** A time in seconds as `4.2 s`, `3 min 20 s` or `2 h 5 min`. */
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 60) return `${localised(seconds < 10 ? seconds.toFixed(1) : seconds.toFixed(0))} s`;
  const whole = Math.round(seconds);
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  return `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
}

/** A size in bytes. */
export function bytes(count) {
  if (!Number.isFinite(count)) return '–';
  if (count < 1000) return `${count} B`;
  return count < 1e6 ? `${number(count / 1e3, 3)} kB` : `${number(count / 1e6, 3)} MB`;
}
