// Units of the values that are typed and shown, with the factors and choices of the program (crates/tank/src/units).

import { localised } from './words.js';

const INCH = 0.0254;
const FOOT = 0.3048;
const POUND = 0.45359237;
const GRAVITY = 9.80665;
const LBF = POUND * GRAVITY;

// Per dimension: [symbol, text, factor, aliases?]. `si`: those that print chooses, ascending; `us`: with the value from which on each is chosen.
const TABLE = {
  length: {
    units: [['mm', 'mm', 1e-3], ['cm', 'cm', 1e-2], ['m', 'm', 1], ['in', 'in', INCH, 'inch inches ″'], ['ft', 'ft', FOOT, 'foot feet ′']],
    si: 'mm m', us: [['in', 0], ['ft', 3]],
  },
  time: { units: [['ms', 'ms', 1e-3], ['s', 's', 1, 'sec']], si: 's' },
  mass: {
    units: [['g', 'g', 1e-3], ['kg', 'kg', 1], ['t', 't', 1e3, 'Mg tonne tonnes'], ['lb', 'lb', POUND, 'lbm lbs'], ['klb', 'klb', 1e3 * POUND]],
    si: 'kg t', us: [['lb', 0], ['klb', 10]],
  },
  density: {
    units: [['kg/m³', 'kg/m3', 1], ['t/m³', 't/m3', 1e3], ['g/cm³', 'g/cm3', 1e3, 'g/ml kg/l kg/L kg/dm3'], ['SG', 'SG', 1e3],
      ['lb/ft³', 'lb/ft3', POUND / FOOT ** 3, 'lbm/ft3 pcf']],
    si: 'kg/m3', us: [['lb/ft3', 0]],
  },
  velocity: {
    units: [['mm/s', 'mm/s', 1e-3], ['cm/s', 'cm/s', 1e-2], ['m/s', 'm/s', 1], ['in/s', 'in/s', INCH], ['ft/s', 'ft/s', FOOT]],
    si: 'm/s', us: [['in/s', 0], ['ft/s', 3]],
  },
  acceleration: {
    units: [['m/s²', 'm/s2', 1, 'm/s/s'], ['cm/s²', 'cm/s2', 1e-2, 'cm/s/s'], ['gal', 'gal', 1e-2, 'Gal'], ['mm/s²', 'mm/s2', 1e-3, 'mm/s/s'],
      ['g', 'g', GRAVITY], ['in/s²', 'in/s2', INCH], ['ft/s²', 'ft/s2', FOOT]],
    si: 'm/s2', us: [['ft/s2', 0]],
  },
  frequency: { units: [['Hz', 'Hz', 1], ['kHz', 'kHz', 1e3]], si: 'Hz' },
  angular_frequency: { units: [['rad/s', 'rad/s', 1]], si: 'rad/s' },
  angle: { units: [['rad', 'rad', 1], ['°', 'deg', Math.PI / 180, 'degree degrees']], si: 'rad' },
  force: {
    units: [['N', 'N', 1], ['kN', 'kN', 1e3], ['MN', 'MN', 1e6], ['lbf', 'lbf', LBF], ['kip', 'kip', 1e3 * LBF, 'kips'], ['kgf', 'kgf', GRAVITY]],
    si: 'N kN MN', us: [['lbf', 0], ['kip', 1]],
  },
  moment: {
    units: [['N·m', 'Nm', 1], ['kN·m', 'kNm', 1e3], ['MN·m', 'MNm', 1e6], ['N·mm', 'Nmm', 1e-3],
      ['lbf·ft', 'lbf*ft', LBF * FOOT, 'ft·lbf'], ['kip·ft', 'kip*ft', 1e3 * LBF * FOOT, 'ft·kip']],
    si: 'Nm kNm MNm', us: [['lbf*ft', 0], ['kip*ft', 1]],
  },
  stress: {
    units: [['Pa', 'Pa', 1, 'N/m2'], ['kPa', 'kPa', 1e3, 'kN/m2'], ['mbar', 'mbar', 1e2], ['MPa', 'MPa', 1e6, 'N/mm2 MN/m2'],
      ['kN/cm²', 'kN/cm2', 1e7], ['GPa', 'GPa', 1e9, 'kN/mm2'], ['bar', 'bar', 1e5], ['psi', 'psi', LBF / INCH ** 2, 'lbf/in2 lb/in2'],
      ['ksi', 'ksi', 1e3 * LBF / INCH ** 2, 'kip/in2'], ['psf', 'psf', LBF / FOOT ** 2, 'lbf/ft2']],
    si: 'Pa kPa MPa GPa', us: [['psf', 0], ['psi', 10], ['ksi', 1]],
  },
  line_force: {
    units: [['N/m', 'N/m', 1], ['kN/m', 'kN/m', 1e3, 'N/mm'], ['MN/m', 'MN/m', 1e6], ['lbf/ft', 'lbf/ft', LBF / FOOT, 'plf'],
      ['kip/ft', 'kip/ft', 1e3 * LBF / FOOT], ['lbf/in', 'lbf/in', LBF / INCH, 'pli'], ['kip/in', 'kip/in', 1e3 * LBF / INCH]],
    si: 'N/m kN/m MN/m', us: [['lbf/ft', 0], ['kip/ft', 1]],
  },
  line_moment: {
    units: [['N·m/m', 'Nm/m', 1], ['kN·m/m', 'kNm/m', 1e3], ['lbf·ft/ft', 'lbf*ft/ft', LBF], ['kip·ft/ft', 'kip*ft/ft', 1e3 * LBF]],
    si: 'Nm/m kNm/m', us: [['lbf*ft/ft', 0], ['kip*ft/ft', 1]],
  },
  line_area: {
    units: [['mm²/m', 'mm2/m', 1e-6], ['cm²/m', 'cm2/m', 1e-4], ['m²/m', 'm2/m', 1], ['in²/ft', 'in2/ft', INCH ** 2 / FOOT]],
    si: 'cm2/m m2/m', us: [['in2/ft', 0]],
  },
  subgrade: {
    units: [['N/m³', 'N/m3', 1], ['kN/m³', 'kN/m3', 1e3], ['MN/m³', 'MN/m3', 1e6], ['lb/in³', 'lb/in3', LBF / INCH ** 3, 'pci lbf/in3']],
    si: 'N/m3 kN/m3 MN/m3', us: [['lb/in3', 0]],
  },
  area: { units: [['mm²', 'mm2', 1e-6], ['cm²', 'cm2', 1e-4], ['m²', 'm2', 1], ['in²', 'in2', INCH ** 2]], si: 'cm2 m2', us: [['in2', 0]] },
  second_moment: { units: [['mm⁴', 'mm4', 1e-12], ['cm⁴', 'cm4', 1e-8], ['m⁴', 'm4', 1], ['in⁴', 'in4', INCH ** 4]], si: 'cm4 m4', us: [['in4', 0]] },
  area_mass: { units: [['kg/m²', 'kg/m2', 1], ['lb/ft²', 'lb/ft2', POUND / FOOT ** 2, 'lbm/ft2']], si: 'kg/m2', us: [['lb/ft2', 0]] },
  fraction: { units: [['%', '%', 1e-2]], si: '' },
};

const canonical = (text) => text.trim().replace(/\s*\/\s*/g, '/').replace(/\^/g, '').replace(/²/g, '2').replace(/³/g, '3').replace(/⁴/g, '4').replace(/·/g, '*');

const bySpelling = new Map();
for (const [dimension, { units }] of Object.entries(TABLE)) {
  for (const [symbol, text, factor, aliases] of units) {
    const unit = { symbol, text, factor, dimension };
    for (const spelling of [symbol, text, ...(aliases?.split(' ') ?? [])]) {
      const key = canonical(spelling);
      bySpelling.set(key, [...(bySpelling.get(key) ?? []), unit]);
    }
  }
}

/** The unit with this spelling, of one of the dimensions (`g` is a mass and an acceleration); null where there is none. */
export function findUnit(spelling, dimensions) {
  const found = bySpelling.get(canonical(spelling)) ?? [];
  return found.find((unit) => dimensions.includes(unit.dimension)) ?? null;
}

/** The texts of the units of a dimension, as the file has them. */
export const unitsOf = (dimension) => TABLE[dimension]?.units.map((unit) => unit[1]) ?? [];

/** Whether the system has units of its own for this dimension. */
export const differs = (dimension) => Boolean(TABLE[dimension]?.us);

/** The unit in which the program prints a value [SI] of a dimension. */
export function unitFor(value, dimension, system) {
  const entry = TABLE[dimension];
  if (!entry || !entry.si) return null;
  const named = (text) => findUnit(text, [dimension]);
  if (system === 'us' && entry.us) {
    const pairs = entry.us.map(([text, from]) => [named(text), from]);
    return pairs.findLast(([unit, from]) => Math.abs(value) >= from * unit.factor)[0];
  }
  const units = entry.si.split(' ').map(named);
  if (!value) return units[0].factor === 1 || dimension === 'length' ? named(dimension === 'length' ? 'm' : units[0].text) : units[0];
  return units.findLast((unit) => Math.abs(value) >= unit.factor * (unit.text === 't' ? 10 : 1)) ?? units[0];
}

/** Significant digits as the program prints them: the integer part is never cut. */
export function significant(value, digits = 3) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const exponent = Number(value.toExponential(digits - 1).split('e')[1]);
  if (exponent < -4 || exponent >= 7) return value.toExponential(digits - 1).replace('e+', 'e');
  return value.toFixed(Math.max(0, digits - 1 - exponent));
}

/** A value [SI] with three digits and the unit of print: `137 mm`. */
export function show(value, dimension, system, digits = 3, unit = unitFor(value, dimension, system)) {
  if (value === null || value === undefined) return '–';
  if (!unit) return localised(significant(value, digits));
  const number = localised(significant(value / unit.factor, digits));
  return unit.symbol === '°' ? `${number}°` : `${number} ${unit.symbol}`;
}
