// Edits of a list that keep comments within its rows: each works on the text and the places of the items,
// where `api/edit` would write the moved values anew.

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
