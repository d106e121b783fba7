// The view of a value that is more than one field. The views know each other through this module alone.

const kinds = new Map();

/** Says which class shows values of a kind: a group of rows, a table, a list, a map, a choice of shapes. */
export function showAs(kind, make) {
  kinds.set(kind, make);
}

export function makeView(form, parts, field, options = {}) {
  return kinds.get(field.kind)(form, parts, field, options);
}
