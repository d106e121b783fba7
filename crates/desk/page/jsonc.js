// A tolerant reader of JSON with comments and trailing commas. It never throws: what it cannot read is left out,
// so that the form follows a text that is being typed. The server judges the text; this reader only finds values and their places.
//
// A node is {type, start, end, value?} with `members: [{key, keyStart, keyEnd, node}]` of an object or `items` of an array.

const WORDS = { true: true, false: false, null: null };

// The root node of a text, or null where it holds no value.
export function parse(text) {
  const reader = new Reader(text);
  reader.skip();
  return reader.value();
}

// The pieces of a text in order, for colouring: {kind: "key"|"string"|"number"|"word"|"comment"|"mark", start, end}.
export function pieces(text) {
  const found = [];
  const pattern = /\/\/[^\n]*|\/\*[\s\S]*?(?:\*\/|$)|"(?:[^"\\\n]|\\.)*"?|-?\d[\w.+-]*|[A-Za-z]+|[{}[\],:]/g;
  for (const match of text.matchAll(pattern)) {
    const start = match.index;
    const end = start + match[0].length;
    found.push({ kind: kindOf(text, match[0], end), start, end });
  }
  return found;
}

function kindOf(text, piece, end) {
  if (piece.startsWith('//') || piece.startsWith("/*")) return 'comment';
  if (piece.startsWith('"')) return /^\s*:/.test(text.slice(end, end + 40)) ? 'key' : 'string';
  if (/^[-\d]/.test(piece)) return 'number';
  return /^[A-Za-z]/.test(piece) ? 'word' : 'mark';
}

class Reader {
  constructor(text) {
    this.text = text;
    this.at = text.charCodeAt(0) === 0xfeff ? 1 : 0;
    this.depth = 0;
  }

  // Passes blanks and comments.
  skip() {
    const blank = /(?:\s+|\/\/[^\n]*|\/\*[\s\S]*?(?:\*\/|$))*/y;
    blank.lastIndex = this.at;
    blank.exec(this.text);
    this.at = blank.lastIndex;
  }

  value() {
    const start = this.at;
    const mark = this.text[start];
    if (mark === undefined || this.depth > 60) return null;
    this.depth += 1;
    const node = mark === '{' ? this.object() : mark === '[' ? this.array() : mark === '"' ? this.string() : this.word();
    this.depth -= 1;
    if (node === null) return null;
    return Object.assign(node, { start, end: this.at });
  }

  string() {
    const pattern = /"(?:[^"\\\n]|\\.)*"?/y;
    pattern.lastIndex = this.at;
    const raw = pattern.exec(this.text)[0];
    this.at = pattern.lastIndex;
    let value = raw.slice(1).replace(/"$/, '');
    try {
      value = JSON.parse(raw);
    } catch {
      // An unfinished text is shown as it stands.
    }
    return { type: 'string', value };
  }

  word() {
    const pattern = /[^\s,:{}[\]"/]+/y;
    pattern.lastIndex = this.at;
    const match = pattern.exec(this.text);
    if (!match) return null;
    this.at = pattern.lastIndex;
    const raw = match[0];
    if (raw in WORDS) return { type: raw === 'null' ? 'null' : 'boolean', value: WORDS[raw] };
    const number = Number(raw);
    return Number.isNaN(number) ? { type: 'unknown', value: raw } : { type: 'number', value: number, raw };
  }

  object() {
    const members = [];
    this.at += 1;
    for (this.skip(); this.at < this.text.length && this.text[this.at] !== '}'; this.skip()) {
      const keyStart = this.at;
      const key = this.text[keyStart] === '"' ? this.string() : this.word();
      if (key === null) {
        this.at += 1;
        continue;
      }
      const keyEnd = this.at;
      this.skip();
      if (this.text[this.at] !== ':') continue;
      this.at += 1;
      this.skip();
      const node = /[,}\]]/.test(this.text[this.at] ?? ',') ? null : this.value();
      if (node) members.push({ key: String(key.value), keyStart, keyEnd, node });
    }
    this.at = Math.min(this.at + 1, this.text.length);
    return { type: 'object', members };
  }

  array() {
    const items = [];
    this.at += 1;
    for (this.skip(); this.at < this.text.length && this.text[this.at] !== ']'; this.skip()) {
      if (this.text[this.at] === '}') break;
      const node = this.value();
      if (node) items.push(node);
      else this.at += 1;
    }
    if (this.text[this.at] === ']') this.at += 1;
    return { type: 'array', items };
  }
}

export function memberOf(node, key) {
  return node?.type === 'object' ? node.members.findLast((member) => member.key === key) : undefined;
}

// The child of a node by key or index, undefined where there is none.
export function childOf(node, part) {
  if (typeof part === 'number') return node?.type === 'array' ? node.items[part] : undefined;
  return memberOf(node, part)?.node;
}

export function nodeAt(root, parts) {
  return parts.reduce((node, part) => childOf(node, part), root ?? undefined);
}

// The plain value of a node.
export function plain(node) {
  if (!node) return undefined;
  if (node.type === 'array') return node.items.map(plain);
  if (node.type !== 'object') return node.value;
  return Object.fromEntries(node.members.map((member) => [member.key, plain(member.node)]));
}

// The parts of the path of the innermost value or key around an offset.
export function pathAt(root, offset) {
  const parts = [];
  for (let node = root; node; ) {
    const member = node.members?.find((one) => one.keyStart <= offset && offset <= one.node.end);
    const index = node.items?.findIndex((one) => one.start <= offset && offset <= one.end) ?? -1;
    if (member) parts.push(member.key);
    else if (index >= 0) parts.push(index);
    node = member ? member.node : index >= 0 ? node.items[index] : null;
  }
  return parts;
}

// Calls `visit(node, key)` for every value below a node.
export function walk(node, visit, key = null) {
  if (!node) return;
  visit(node, key);
  for (const member of node.members ?? []) walk(member.node, visit, member.key);
  for (const item of node.items ?? []) walk(item, visit, key);
}
