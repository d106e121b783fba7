// How a record is read: unit, time step, channel, columns and skipped lines that its file does not give. Kept by path.

const KEY = 'desk.reading';
const kept = new Map(Object.entries(load()));

function load() {
  try {
    return JSON.parse(localStorage.getItem(KEY)) ?? {};
  } catch {
    return {};
  }
}

/** `{units?, dt?, channel?, columns?, skip_lines?}` of a record. */
export function reading(path) {
  return kept.get(path) ?? {};
}

/** Keeps how a record is read; empty values are left out. */
export function setReading(path, options) {
  const given = Object.fromEntries(Object.entries(options).filter(([, value]) => value !== null && value !== undefined && value !== ''));
  if (Object.keys(given).length) kept.set(path, given);
  else kept.delete(path);
  store();
  return given;
}

/** A record that has another path is read as before. */
export function moveReading(from, to) {
  const given = kept.get(from);
  kept.delete(from);
  if (given) kept.set(to, given);
  store();
}

function store() {
  try {
    localStorage.setItem(KEY, JSON.stringify(Object.fromEntries(kept)));
  } catch { /* Storage may be blocked: kept until the page is closed. */ }
}

/** The record as the API takes it. */
export function recordOf(path) {
  return { path, ...reading(path) };
}

/** Units of acceleration that the readers take. */
export const UNITS = ['g', '%g', 'mg', 'g/10', 'm/s2', 'gal', 'mm/s2', 'in/s2', 'ft/s2'];
