// Areas of the page, between which F6 goes: elements with `data-area`. Each remembers where the focus was in it.

const last = new WeakMap();
const FOCUSABLE = 'a[href], button, input, select, textarea, summary, iframe, [tabindex]';

document.addEventListener('focusin', (event) => {
  const area = event.target.closest?.('[data-area]');
  if (area) last.set(area, event.target);
});

const seen = (element) => element.getClientRects().length > 0;
const reached = (element) => seen(element) && !element.disabled && element.tabIndex >= 0;

/** Moves the focus to the next area, or to the one before; says whether there is one. */
export function nextArea(back = false) {
  const areas = [...document.querySelectorAll('[data-area]')].filter(seen);
  if (!areas.length) return false;
  const here = areas.findIndex((area) => area.contains(document.activeElement));
  const step = back ? -1 : 1;
  // From outside of all areas the way begins at the first, backwards at the last.
  const from = here < 0 && back ? 0 : here;
  for (let i = 1; i <= areas.length; i += 1) if (enter(areas[(from + step * i + areas.length * i) % areas.length])) return true;
  return false;
}

/** Moves the focus into an area; says whether something in it takes it. */
export function enter(area) {
  const before = last.get(area);
  const target = before && area.contains(before) && reached(before) ? before : [...area.querySelectorAll(FOCUSABLE)].find(reached);
  target?.focus();
  target?.scrollIntoView({ block: 'nearest' });
  return Boolean(target);
}

/** Makes a toolbar one stop of Tab; arrows go between its buttons. Call `draw` after buttons were enabled or disabled. */
export function toolbar(element) {
  let current = null;
  const buttons = () => [...element.querySelectorAll('button')].filter((button) => !button.disabled && !button.hidden);
  const draw = () => { current = rove(buttons(), current); };
  element.addEventListener('focusin', ({ target }) => { current = target; draw(); });
  element.addEventListener('keydown', (event) => {
    const all = buttons();
    const here = all.indexOf(event.target);
    const next = { ArrowRight: all[here + 1] ?? all[0], ArrowLeft: all[here - 1] ?? all.at(-1), Home: all[0], End: all.at(-1) }[event.key];
    if (here < 0 || !next) return;
    event.preventDefault();
    next.focus();
  });
  draw();
  return draw;
}

/**
 * One stop of Tab for a list: `items` are its elements in order, `current` the one that keeps the stop where it still is one of them.
 * Returns the element that has the stop.
 */
export function rove(items, current = null) {
  const stop = items.includes(current) ? current : items[0] ?? null;
  for (const item of items) item.tabIndex = item === stop ? 0 : -1;
  return stop;
}
