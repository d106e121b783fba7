// Values with their units as they are typed: "12.5 mm", "0,5 in". The text keeps what was typed; a bare number is completed visibly.

import { differs, findUnit, significant, show, unitFor } from './units.js';

const NUMBER = /^\s*([-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$/;

/** US units that stand for the usual ones of a data sheet. */
const US_FOR = {
  mm: 'in', cm: 'in', m: 'ft', t: 'klb', kg: 'lb', MPa: 'ksi', GPa: 'ksi', kPa: 'psf', kN: 'kip', MN: 'kip', N: 'lbf',
  'kg/m3': 'lb/ft3', 'kN/m': 'kip/ft', 'MN/m': 'kip/in', 'm/s': 'ft/s', 'cm2/m': 'in2/ft', 'MN/m3': 'lb/in3', kNm: 'kip*ft',
  mm2: 'in2', cm2: 'in2', mm4: 'in4', cm4: 'in4', 'kg/m2': 'lb/ft2',
};

/** A decimal comma becomes a point, a minus sign a hyphen: the file has points. */
export function tidy(text) {
  return text.trim().replace(/^([-+−]?\d*),(\d+)(?!,)/, '$1.$2').replace(/^−/, '-').replace(/\s+/g, ' ');
}

const DIAMETER = /^(?:⌀|ø|Ø|d|D|dia\.?)\s*=?\s*(?=[\d.,])/;

/** A diameter, `D 40 m`, as the radius that the file has; other texts stay. */
export function halved(text) {
  const parts = DIAMETER.test(text.trim()) ? split(text.trim().replace(DIAMETER, '')) : null;
  return parts ? [Number((Number(parts.number) / 2).toPrecision(12)), parts.unit].filter((part) => part !== '').join(' ') : text;
}

/** `{number, unit}` of a text, or null where it does not begin with a number. */
export function split(text) {
  const match = NUMBER.exec(tidy(String(text ?? '')));
  return match ? { number: match[1], unit: match[2] } : null;
}

/** The value in SI and its unit, or null. */
export function read(text, dimensions) {
  const parts = split(text);
  const unit = parts && findUnit(parts.unit, dimensions);
  return unit ? { value: Number(parts.number) * unit.factor, unit } : null;
}

/** Whether a text is a complete value for a field. */
export function complete(field, text) {
  return field.patterns.some((pattern) => pattern.test(tidy(text)));
}

/** The unit that a bare number gets in a field: that of the value before it, else that of the example, in the units of the page. */
export function suggestedUnit(field, before, system) {
  const had = split(before)?.unit;
  if (had && findUnit(had, field.dimensions)) return had;
  const usual = split(field.example)?.unit ?? '';
  return system === 'us' && US_FOR[usual] && differs(field.dimensions[0]) ? US_FOR[usual] : usual;
}

/** The text with the suggested unit where it is a bare number. */
export function completed(field, text, before, system) {
  const tidied = tidy(text);
  const parts = split(tidied);
  if (!parts || parts.unit || !Number.isFinite(Number(parts.number)) || complete(field, tidied)) return tidied;
  const unit = suggestedUnit(field, before, system);
  return unit ? `${parts.number} ${unit}` : tidied;
}

/** The value in the units of the page, where they are others than those typed; else an empty text. */
export function converted(field, text, system) {
  const found = read(text, field.dimensions);
  if (!found || !differs(found.unit.dimension)) return '';
  const american = ['in', 'ft', 'lb', 'klb', 'lbf', 'kip', 'psi', 'ksi', 'psf'].some((name) => found.unit.text.split(/[/*\d]/).includes(name));
  if (american === (system === 'us')) return '';
  if (found.unit.text === 'g' && found.unit.dimension === 'acceleration') return '';
  return show(found.value, found.unit.dimension, system, 4);
}

/** A value [SI] as a text for the file, in the unit of a text that stands there. */
export function inUnitOf(value, like, dimension, system) {
  const unit = findUnit(split(like)?.unit ?? '', [dimension]) ?? unitFor(value, dimension, system);
  return unit ? `${significant(value / unit.factor, 4)} ${unit.text}` : significant(value, 4);
}
