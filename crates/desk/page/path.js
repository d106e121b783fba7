// Paths of values in tank.json, as the faults write them: tank.courses[0].thickness, materials["A 283 C"].density.

const PLAIN = /^[A-Za-z_$][A-Za-z0-9_$]*/;

// Splits a path into keys (texts) and indices (numbers); stops at the first part that it cannot read.
export function parsePath(text) {
  const parts = [];
  let rest = text ?? '';
  while (rest) {
    if (rest.startsWith('.')) rest = rest.slice(1);
    const index = /^\[(\d+)\]/.exec(rest);
    const quoted = /^\[("(?:[^"\\]|\\.)*")\]/.exec(rest);
    const plain = PLAIN.exec(rest);
    if (index) parts.push(Number(index[1]));
    else if (quoted) parts.push(unquote(quoted[1]));
    else if (plain) parts.push(plain[0]);
    else break;
    rest = rest.slice((index ?? quoted ?? plain)[0].length);
  }
  return parts;
}

function unquote(text) {
  try {
    return JSON.parse(text);
  } catch {
    return text.slice(1, -1);
  }
}

export function formatPath(parts) {
  let text = '';
  for (const part of parts) {
    if (typeof part === 'number') text += `[${part}]`;
    else if (PLAIN.exec(part)?.[0] === part) text += text ? `.${part}` : part;
    else text += `[${JSON.stringify(part)}]`;
  }
  return text;
}

// The value at a path of a plain value, undefined where there is none.
export function valueAt(value, parts) {
  return parts.reduce((at, part) => (at !== null && typeof at === 'object' ? at[part] : undefined), value);
}
