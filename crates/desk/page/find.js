// Finds a field by its name or key, also one that is folded or not given yet.

import { choose } from './files.js';
import { labelAt } from './labels.js';
import { nodeAt, plain } from './jsonc.js';
import { formatPath } from './path.js';
import { isLeaf } from './schema.js';
import { t } from './words.js';

/** Asks for a field; resolves to its path or null. */
export async function findField(desk, schema) {
  const entries = [];
  collect(schema, schema.json, [], desk.document.root, entries);
  const chosen = await choose(desk, t('tank-find'), entries, '');
  return entries.find((entry) => entry.id === chosen)?.parts ?? null;
}

function collect(schema, node, parts, root, entries) {
  const field = schema.field(node);
  if (parts.length) entries.push(entryOf(field, parts, root));
  if (isLeaf(field) || parts.length > 5) return;
  if (field.kind === 'union') inside(schema, field.other, parts, root, entries);
  else if (field.kind === 'map') for (const { key } of nodeAt(root, parts)?.members ?? []) collect(schema, field.item, [...parts, key], root, entries);
  else inside(schema, node, parts, root, entries);
}

function inside(schema, node, parts, root, entries) {
  const field = schema.field(node);
  for (const [key, property] of Object.entries(field.properties ?? {})) collect(schema, property, [...parts, key], root, entries);
}

function entryOf(field, parts, root) {
  const path = formatPath(parts);
  const title = parts.map((part, index) => (index && parts[index - 1] === 'materials' ? part : labelAt(parts.slice(0, index + 1), plain(nodeAt(root, parts.slice(0, index)))))).join(' › ');
  return { id: path, parts, title, words: `${path} ${field.help.slice(0, 160)}` };
}
