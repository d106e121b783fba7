// Elements without markup: everything that comes from a file becomes a text node.

/**
 * Makes an element. `h('button.primary', { type: 'button', onclick: save }, 'Save')`
 *
 * @param {string} name tag, with classes after dots
 * @param {object} [attributes] `on…` are listeners, `dataset` and `style` are objects; true sets an empty attribute,
 *   false, null and undefined none
 * @param {...(Node|string|number|null|Array)} children texts become text nodes; null is left out
 */
export function h(name, attributes = {}, ...children) {
  const [tag, ...classes] = name.split('.');
  const element = document.createElement(tag);
  if (classes.length) element.className = classes.join(' ');
  for (const [key, value] of Object.entries(attributes ?? {})) setAttribute(element, key, value);
  put(element, children);
  return element;
}

function setAttribute(element, key, value) {
  if (value === null || value === undefined || value === false) return;
  if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
  else if (key === 'dataset') Object.assign(element.dataset, value);
  else if (key === 'style') for (const [name, one] of Object.entries(value)) element.style.setProperty(name, one);
  else if (key === 'value') element.value = value;
  else if (key === 'class') element.classList.add(...String(value).split(' ').filter(Boolean));
  else element.setAttribute(key, value === true ? '' : value);
}

function put(element, children) {
  for (const child of children) {
    if (Array.isArray(child)) put(element, child);
    else if (child instanceof Node) element.append(child);
    else if (child !== null && child !== undefined && child !== false) element.append(String(child));
  }
}

/** A text of the program as nodes: what stands between backticks becomes code. */
export function spoken(text) {
  return String(text).split('`').map((part, i) => (i % 2 ? h('code', {}, part) : part));
}

/** Replaces the children of an element. */
export function fill(element, ...children) {
  const whole = document.createDocumentFragment();
  put(whole, children);
  element.replaceChildren(whole);
  return element;
}

let last = 0;
/** An id that is unique in the page, for labels. */
export function uniqueId(stem = 'e') {
  last += 1;
  return `${stem}-${last}`;
}

/** A labelled control with a hint below it. */
export function labelled(text, control, hint = null) {
  if (!control.id) control.id = uniqueId('field');
  let note = null;
  if (hint) {
    note = h('p.hint', { id: `${control.id}-hint` }, hint);
    control.setAttribute('aria-describedby', note.id);
  }
  return h('div.field', {}, h('label', { for: control.id }, text), control, note);
}

/** A select of `[value, title]` pairs. */
export function choice(pairs, value, attributes = {}) {
  const element = h('select', attributes, pairs.map(([id, title]) => h('option', { value: id }, title)));
  if (value !== null && value !== undefined) element.value = value;
  return element;
}

/** The present value of a CSS variable as a colour that a canvas takes, for light or dark. */
export function colour(variable) {
  const probe = h('i', { hidden: true, style: { color: `var(${variable})` } });
  document.body.append(probe);
  const value = getComputedStyle(probe).color;
  probe.remove();
  return value;
}

/** Offers a text as a file to save. */
export function download(name, text, type = 'text/plain') {
  const link = h('a', { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Copies a text; resolves to whether that was possible. */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/** Calls `act` once things have been quiet for some time [ms]. */
export function debounce(act, milliseconds) {
  let timer = 0;
  return (...args) => {
    clearTimeout(timer);
    timer = setTimeout(() => act(...args), milliseconds);
  };
}
