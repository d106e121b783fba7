// Which keys an object needs besides the required ones: by conditions (`allOf` with `if`) and by its alternatives
// (`oneOf`, `anyOf` with `required`). The form shows these keys; the server judges.

/** `{own: Set of keys, below: Map of key → Set}` of an object with this plain value. */
export function expectedKeys(schema, value) {
  const wanted = { own: new Set(schema.required ?? []), below: new Map() };
  for (const rule of schema.allOf ?? []) {
    if (rule.if && !matches(rule.if, value)) continue;
    const then = rule.then ?? (rule.if ? {} : rule);
    addTo(wanted.own, then, value);
    for (const [key, part] of Object.entries(then.properties ?? {})) {
      const keys = wanted.below.get(key) ?? new Set();
      addTo(keys, part, value?.[key]);
      wanted.below.set(key, keys);
    }
  }
  addTo(wanted.own, { anyOf: schema.anyOf, oneOf: schema.oneOf }, value);
  return wanted;
}

function addTo(keys, part, value) {
  for (const key of part.required ?? []) keys.add(key);
  const ways = [...(part.oneOf ?? []), ...(part.anyOf ?? [])].map((way) => way.required ?? []).filter((way) => way.length);
  if (!ways.length) return;
  const has = (key) => value?.[key] !== undefined;
  const begun = ways.filter((way) => way.some(has));
  for (const key of begun.length ? begun.flat() : ways[0]) keys.add(key);
}

function matches(rule, value) {
  if (rule.not) return !matches(rule.not, value);
  const has = (rule.required ?? []).every((key) => value?.[key] !== undefined);
  const equal = Object.entries(rule.properties ?? {}).every(([key, part]) => part.const === undefined || value?.[key] === undefined || value[key] === part.const);
  return has && equal;
}
