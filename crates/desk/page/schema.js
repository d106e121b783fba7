// The JSON Schema of tank.json, read for the form: what kind of field a key has, with unit, limits, default and help.

const DIMENSIONS = {
  Acceleration: 'acceleration', Angle: 'angle', Area: 'area', AreaMass: 'area_mass', Density: 'density', Force: 'force', Length: 'length', LineArea: 'line_area',
  LineForce: 'line_force', Mass: 'mass', Moment: 'moment', SecondMoment: 'second_moment', Stress: 'stress', Subgrade: 'subgrade', Time: 'time', Velocity: 'velocity',
};
const BY_UNIT = [[/\|s\|/, 'time'], [/Hz/, 'frequency'], [/rad \?/, 'angular_frequency'], [/m ?\\?\??.*s.*\|gal/, 'acceleration']];

export class Schema {
  constructor(json) {
    this.json = json;
    this.fields = new WeakMap();
  }

  /** A schema with its reference followed; its own description, default and examples go before those of the reference. */
  resolve(node) {
    if (!node?.$ref) return node ?? {};
    const name = node.$ref.split('/').at(-1);
    const base = this.resolve(this.json.$defs?.[name]);
    const { $ref, ...own } = node;
    const merged = { ...base, ...own, named: base.named ?? name };
    if (base.properties && own.properties) merged.properties = { ...base.properties, ...own.properties };
    return merged;
  }

  /**
   * The field of a schema: `{kind, help, placeholder, …}` with kind
   * `quantity`, `number`, `integer`, `text`, `choice`, `boolean`, `object`, `map`, `list` or `union`.
   */
  field(node) {
    if (!this.fields.has(node)) this.fields.set(node, this.read(node));
    return this.fields.get(node);
  }

  read(node) {
    const whole = this.resolve(node);
    const example = whole.examples?.[0];
    const field = { schema: whole, help: whole.description ?? '', default: whole.default, example, fallback: fallbackOf(whole.description) };
    return Object.assign(field, this.kind(whole, field));
  }

  kind(whole) {
    if (whole.anyOf && !whole.properties) return this.union(whole);
    const words = wordsOf(whole);
    if (words.length) return { kind: 'choice', options: words.map((value) => ({ value, help: wordHelp(whole, value) })) };
    if (whole.type === 'object' || whole.properties) return this.object(whole);
    if (whole.type === 'array') return { kind: 'list', item: whole.items ?? {}, most: whole.maxItems ?? 1000 };
    if (whole.type === 'boolean' || whole.type === 'integer') return { kind: whole.type };
    if (whole.type === 'number') return { kind: 'number', patterns: [] };
    if (whole.pattern) return { kind: 'quantity', ...this.measured([whole]) };
    return { kind: 'text' };
  }

  object(whole) {
    if (!Object.keys(whole.properties ?? {}).length && typeof whole.additionalProperties === 'object') {
      return { kind: 'map', item: whole.additionalProperties };
    }
    return { kind: 'object', properties: whole.properties ?? {}, required: new Set(whole.required ?? []) };
  }

  union(whole) {
    const parts = whole.anyOf.map((one) => this.resolve(one));
    const words = parts.flatMap(wordsOf);
    const object = parts.find((part) => part.properties);
    const list = parts.find((part) => part.type === 'array');
    if (object || list) return { kind: 'union', words, other: whole.anyOf[parts.indexOf(object ?? list)] };
    const patterns = parts.filter((part) => part.pattern);
    const helps = words.map((value) => ({ value, help: parts.map((part) => wordHelp(part, value)).find(Boolean) ?? '' }));
    const number = parts.find((part) => part.type === 'number');
    const percent = patterns.some((part) => part.pattern.endsWith('(%)?$'));
    if (number && percent) {
      return { kind: 'number', patterns: patterns.map((part) => new RegExp(part.pattern)), suggestions: number.enum ?? [] };
    }
    const measured = this.measured(patterns);
    if (number) measured.patterns.push(/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/);
    measured.patterns.push(...words.map((word) => new RegExp(`^${word}$`)));
    return { kind: 'quantity', ...measured, bare: Boolean(number), suggestions: words, options: helps.filter(({ help }) => help) };
  }

  measured(parts) {
    const dimensions = parts.map((part) => DIMENSIONS[part.named] ?? dimensionOf(part.pattern)).filter(Boolean);
    return { patterns: parts.map((part) => new RegExp(part.pattern)), dimensions, suggestions: [] };
  }
}

// The dimension of a pattern without a name, by the units that it takes.
function dimensionOf(pattern) {
  return BY_UNIT.find(([units]) => units.test(pattern))?.[1] ?? (/\(ms\|s\|sec\)/.test(pattern) ? 'time' : null);
}

/** The words that a value may be. */
const wordsOf = (whole) => [whole.const ?? whole.enum ?? whole.oneOf?.map((one) => one.const) ?? []].flat().filter((one) => one !== undefined);

const wordHelp = (whole, value) => whole.oneOf?.find((one) => one.const === value)?.description ?? '';

// What holds where a key is not given: after "If not given:" or "Default:" in its description, in either language.
function fallbackOf(description) {
  return /(?:If not given|Default|Ohne Angabe|Vorgabe): (.*?)(?:\.(?=\s|$)|$)/s.exec(description ?? '')?.[1] ?? '';
}

/** Whether a value is written in one field, not in a group of its own. */
export const isLeaf = (field) => !['object', 'map', 'list', 'union'].includes(field.kind);
