// Values for display: the same units and rounding as in the report (crates/tank/src/units).

import { localised } from './words.js';

const inch = 0.0254;
const foot = 0.3048;
const pound = 0.45359237;
const lbf = pound * 9.80665;
const ten = (symbol, exponent, from) => ({ symbol, factor: 10 ** exponent, from: from ?? 10 ** exponent });
const per = (symbol, factor, from = 1) => ({ symbol, factor, from: from * factor });

/** Units of SI by dimension, ascending; `from` is the value (SI) from which on one is chosen. */
const SI = {
  dimensionless: [ten('', 0)],
  length: [ten('mm', -3), ten('m', 0)],
  time: [ten('s', 0)],
  mass: [ten('kg', 0), ten('t', 3, 1e4)],
  density: [ten('kg/m³', 0)],
  velocity: [ten('m/s', 0)],
  acceleration: [ten('m/s²', 0)],
  frequency: [ten('Hz', 0)],
  angular_frequency: [ten('rad/s', 0)],
  angle: [ten('rad', 0)],
  force: [ten('N', 0), ten('kN', 3), ten('MN', 6)],
  moment: [ten('N·m', 0), ten('kN·m', 3), ten('MN·m', 6)],
  stress: [ten('Pa', 0), ten('kPa', 3), ten('MPa', 6), ten('GPa', 9)],
  line_force: [ten('N/m', 0), ten('kN/m', 3), ten('MN/m', 6)],
  line_moment: [ten('N·m/m', 0), ten('kN·m/m', 3)],
  energy: [ten('J', 0), ten('kJ', 3), ten('MJ', 6)],
  line_area: [ten('cm²/m', -4), ten('m²/m', 0)],
  curvature: [ten('rad/km', -3), ten('rad/m', 0)],
  subgrade: [ten('N/m³', 0), ten('kN/m³', 3), ten('MN/m³', 6)],
  rotational_stiffness: [ten('N·m/rad', 0), ten('kN·m/rad', 3), ten('MN·m/rad', 6), ten('GN·m/rad', 9)],
  dashpot: [ten('N·s/m', 0), ten('kN·s/m', 3), ten('MN·s/m', 6)],
  rotational_dashpot: [ten('N·m·s/rad', 0), ten('kN·m·s/rad', 3), ten('MN·m·s/rad', 6)],
  rotational_inertia: [ten('kg·m²', 0), ten('t·m²', 3)],
};

/** US customary units; a dimension that is not listed keeps SI. */
const US = {
  length: [per('in', inch), per('ft', foot, 3)],
  mass: [per('lb', pound), per('klb', 1000 * pound, 10)],
  density: [per('lb/ft³', pound / foot ** 3)],
  velocity: [per('in/s', inch), per('ft/s', foot, 3)],
  acceleration: [per('ft/s²', foot)],
  force: [per('lbf', lbf), per('kip', 1000 * lbf)],
  moment: [per('lbf·ft', lbf * foot), per('kip·ft', 1000 * lbf * foot)],
  stress: [per('psf', lbf / foot ** 2), per('psi', lbf / inch ** 2, 10), per('ksi', 1000 * lbf / inch ** 2)],
  line_force: [per('lbf/ft', lbf / foot), per('kip/ft', 1000 * lbf / foot)],
  line_moment: [per('lbf·ft/ft', lbf), per('kip·ft/ft', 1000 * lbf)],
  energy: [per('ft·lbf', lbf * foot), per('ft·kip', 1000 * lbf * foot)],
  line_area: [per('in²/ft', inch * inch / foot)],
  curvature: [per('rad/ft', 1 / foot)],
  subgrade: [per('lb/in³', lbf / inch ** 3)],
  rotational_stiffness: [per('lbf·ft/rad', lbf * foot), per('kip·ft/rad', 1000 * lbf * foot)],
  dashpot: [per('lbf·s/ft', lbf / foot), per('kip·s/ft', 1000 * lbf / foot)],
  rotational_dashpot: [per('lbf·ft·s/rad', lbf * foot), per('kip·ft·s/rad', 1000 * lbf * foot)],
  rotational_inertia: [per('lb·ft²', pound * foot ** 2), per('klb·ft²', 1000 * pound * foot ** 2, 10)],
};

/** Symbols of SI units as files write them, by dimension. */
const SYMBOLS = {
  1: 'dimensionless', '': 'dimensionless', m: 'length', s: 'time', kg: 'mass', 'kg/m3': 'density', 'm/s': 'velocity', 'm/s2': 'acceleration',
  Hz: 'frequency', 'rad/s': 'angular_frequency', rad: 'angle', N: 'force', 'N*m': 'moment', Pa: 'stress', 'N/m': 'line_force',
  'N*m/m': 'line_moment', J: 'energy', 'm2/m': 'line_area', 'rad/m': 'curvature', 'N/m3': 'subgrade', 'N*m/rad': 'rotational_stiffness',
  'N*s/m': 'dashpot', 'N*m*s/rad': 'rotational_dashpot', 'kg*m2': 'rotational_inertia',
};

/** The dimension of an SI symbol (`N*m` → `moment`). */
export const dimensionOf = (symbol) => SYMBOLS[symbol ?? ''] ?? 'dimensionless';

/** The usual unit `{symbol, factor}` of a value (SI); that of the largest absolute value suits a whole column. */
export function unitFor(value, dimension, system) {
  const units = (system === 'us' && US[dimension]) || SI[dimension] || SI.dimensionless;
  const size = Math.abs(value);
  if (!(size > 0) || !Number.isFinite(size)) return (system === 'us' && US[dimension] ? units[0] : units.find((u) => u.factor === 1)) ?? units[0];
  for (let i = units.length - 1; i > 0; i -= 1) if (size >= units[i].from * (1 - 1e-12)) return units[i];
  return units[0];
}

/** The largest absolute finite value. */
export function largest(values) {
  let peak = 0;
  for (const value of values) if (Number.isFinite(value) && Math.abs(value) > peak) peak = Math.abs(value);
  return peak;
}

/** A number with significant digits: the integer part is never cut; powers of ten from 10⁷ and below 10⁻⁴. */
export function significant(value, digits = 3) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const [mantissa, power] = value.toExponential(digits - 1).split('e');
  const exponent = Number(power);
  if (exponent < -4 || exponent >= 7) return localised(`${mantissa}e${exponent}`);
  return localised(value.toFixed(Math.max(0, digits - 1 - exponent)));
}

/** A value (SI) with three significant digits and its unit: `137 mm`. */
export function display(value, dimension, system, digits = 3) {
  if (value === null || value === undefined) return '–';
  const unit = unitFor(value, dimension, system);
  return withUnit(significant(value / unit.factor, digits), unit);
}

/** A number and its unit. */
export const withUnit = (number, unit) => (unit.symbol ? `${number} ${unit.symbol}` : number);
