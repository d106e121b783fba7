// The groups of the form in the order of a data sheet. A part is an object of the file and the keys that the group has of it;
// `rest` takes the keys that no other group names, so that a new key of the schema has a place.

const TANK = ['tank'];

export const SECTIONS = [
  { id: 'project', parts: [{ path: [], keys: ['name', 'project', 'notes'] }] },
  { id: 'tank', parts: [{ path: TANK, rest: true }] },
  { id: 'courses', parts: [{ path: TANK, keys: ['courses'] }] },
  { id: 'fittings', parts: [{ path: TANK, keys: ['rings', 'attachments', 'insulation'] }] },
  { id: 'roof', parts: [{ path: TANK, keys: ['roof'] }] },
  { id: 'bottom', parts: [{ path: TANK, keys: ['bottom', 'foundation', 'isolators'] }] },
  { id: 'liquid', parts: [{ path: ['liquid'], rest: true }] },
  { id: 'materials', parts: [{ path: [], keys: ['materials'] }] },
  { id: 'anchors', parts: [{ path: TANK, keys: ['anchors', 'pipes'] }] },
  { id: 'site', parts: [{ path: ['site'], rest: true }] },
  { id: 'damping', parts: [{ path: [], keys: ['damping', 'record', 'gravity'] }] },
  { id: 'procedures', parts: [{ path: [], keys: ['procedures', 'accepted'] }] },
  { id: 'analysis', folded: true, parts: [{ path: [], rest: true }] },
];

const named = (path) => SECTIONS.flatMap((section) => section.parts).filter((part) => part.path.join() === path.join())
  .flatMap((part) => part.keys ?? []);

// Objects of the root that have groups of their own.
const OWN = SECTIONS.flatMap((section) => section.parts).filter((part) => part.path.length).map((part) => part.path[0]);

/** The keys of a part. */
export function keysOf(field, part) {
  if (part.keys) return part.keys;
  const taken = new Set([...named(part.path), ...(part.path.length ? [] : OWN)]);
  return Object.keys(field.properties).filter((key) => !taken.has(key));
}
