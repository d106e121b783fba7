// Edits that work on the text and the places of its values: rows of a list are moved and repeated with their comments, and
// objects on one line stay on one line, where `api/edit` would write the values anew.

import { nodeAt, walk } from './jsonc.js';

// Exchanges item `index` with the one after it.
export function exchange(text, root, list, index) {
  const items = nodeAt(root, list)?.items ?? [];
  const [one, two] = [items[index], items[index + 1]];
  if (!one || !two) return text;
  const slice = (node) => text.slice(node.start, node.end);
  return text.slice(0, one.start) + slice(two) + text.slice(one.end, two.start) + slice(one) + text.slice(two.end);
}

// Repeats item `index` after itself.
export function repeat(text, root, list, index) {
  const item = nodeAt(root, list)?.items?.[index];
  if (!item) return text;
  const lineStart = text.lastIndexOf("\n", item.start) + 1;
  const indent = text.slice(lineStart, item.start);
  const between = /^\s*$/.test(indent) ? `,\n${indent}` : ', ';
  return text.slice(0, item.end) + between + text.slice(item.start, item.end) + text.slice(item.end);
}

// Renames a key of an object; with `follow`, also every text of that name under the key `follow`.
export function rename(text, root, parts, name, follow) {
  const key = parts.at(-1);
  const parent = nodeAt(root, parts.slice(0, -1));
  const member = parent?.members?.find((one) => one.key === key);
  if (!member || parent.members.some((one) => one.key === name)) return text;
  const places = [[member.keyStart, member.keyEnd]];
  if (follow) {
    walk(root, (node, under) => {
      if (under === follow && node.type === 'string' && node.value === key) places.push([node.start, node.end]);
    });
  }
  places.sort((a, b) => b[0] - a[0]);
  return places.reduce((now, [start, end]) => now.slice(0, start) + JSON.stringify(name) + now.slice(end), text);
}

const WIDTH = 140;

/**
 * The text with a value put in by its place, or null where `api/edit` should do it: a key of an object on one line,
 * the first item of an empty list, a new value in place of a single old one.
 */
export function putShort(text, root, parts, value) {
  const parent = nodeAt(root, parts.slice(0, -1));
  const key = parts.at(-1);
  if (!parent || text[parent.end - 1] !== (parent.type === 'array' ? ']' : '}')) return null;
  if (typeof key === 'number' && parent.items?.[key] === undefined) return parent.items?.length === 0 && key === 0 ? firstItem(text, parent, value) : null;
  const old = nodeAt(root, parts);
  if (old) return isSingle(old, text) && !isWhole(value) ? splice(text, old.start, old.end, JSON.stringify(value)) : null;
  if (parent.type !== 'object' || isWhole(value)) return null;
  const slice = text.slice(parent.start, parent.end);
  const member = `${JSON.stringify(key)}: ${JSON.stringify(value)}`;
  if (!parent.members.length) return typeof parts.at(-2) === 'number' && /^\{\s*\}$/.test(slice) ? splice(text, parent.start, parent.end, `{ ${member} }`) : null;
  const lineStart = text.lastIndexOf('\n', parent.start) + 1;
  if (/[\n/]/.test(slice.replace(/"(?:[^"\\]|\\.)*"/g, '')) || parent.end - lineStart + member.length > WIDTH) return null;
  const { end } = parent.members.at(-1).node;
  return splice(text, end, end, `, ${member}`);
}

function firstItem(text, list, value) {
  if (!/^\[\s*\]$/.test(text.slice(list.start, list.end))) return null;
  const indent = /^[ \t]*/.exec(text.slice(text.lastIndexOf('\n', list.start) + 1))[0];
  return splice(text, list.start, list.end, `[\n${indent}  ${onOneLine(value)}\n${indent}]`);
}

const isWhole = (value) => value !== null && typeof value === 'object';
const isSingle = (node, text) => !node.members && !node.items && (node.type !== 'string' || /^"(?:[^"\\]|\\.)*"$/.test(text.slice(node.start, node.end)));
const splice = (text, start, end, put) => text.slice(0, start) + put + text.slice(end);

/** A value as JSON on one line, with blanks within its braces. */
function onOneLine(value) {
  if (Array.isArray(value)) return `[${value.map(onOneLine).join(', ')}]`;
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const members = Object.entries(value).map(([key, one]) => `${JSON.stringify(key)}: ${onOneLine(one)}`);
  return members.length ? `{ ${members.join(', ')} }` : '{}';
}
