// The text of tank.json with line numbers, colours and the faults in place. The text area is the browser's own, so that
// selection, search and input methods work; a coloured copy lies below it.

import { h, fill } from './dom.js';
import { faultItem } from './field.js';
import { pieces } from './jsonc.js';
import { wording } from './marked.js';
import { t } from './words.js';

export class TextEditor {
  constructor(desk, form) {
    Object.assign(this, { desk, form, faults: [], stale: true });
    this.area = h('textarea.text-area', {
      spellcheck: 'false', autocomplete: 'off', autocapitalize: 'off', wrap: 'off', 'aria-label': t('text-label'), 'aria-describedby': 'text-faults',
      oninput: () => this.typed(), onscroll: () => this.follow(), onkeydown: (event) => this.pressed(event),
    });
    this.back = h('pre.text-back', { 'aria-hidden': true });
    this.gutter = h('pre.text-gutter', { 'aria-hidden': true });
    this.list = h('ul.field-faults', { id: 'text-faults', hidden: true });
    this.element = h('div.text', {}, h('div.text-frame', {}, this.gutter, h('div.text-pane', {}, this.back, this.area)), this.list);
    new ResizeObserver(() => this.follow()).observe(this.area);
  }

  get visible() { return this.element.isConnected && this.element.closest('[hidden]') === null; }

  /** Shows the document's text; the place of the cursor stays with its text. */
  update() {
    this.stale = true;
    if (!this.visible) return;
    const { text } = this.desk.document;
    if (this.area.value !== text) {
      const { selectionStart, value, scrollTop } = this.area;
      const focused = document.activeElement === this.area;
      this.area.value = text;
      const place = focused ? movedPlace(value, text, selectionStart) : selectionStart;
      this.area.setSelectionRange(place, place);
      this.area.scrollTop = scrollTop;
    }
    this.draw();
  }

  typed() {
    this.desk.document.replace(this.area.value, { key: 'text', origin: 'text', within: 1200 });
  }

  // Enter keeps the indentation of the line.
  pressed(event) {
    if (event.key !== 'Enter' || event.ctrlKey || event.metaKey || event.isComposing) return;
    const { value, selectionStart, selectionEnd } = this.area;
    const line = value.slice(value.lastIndexOf('\n', selectionStart - 1) + 1, selectionStart);
    const indent = /^[ \t]*/.exec(line)[0] + (/[[{]\s*$/.test(line) ? '  ' : '');
    event.preventDefault();
    this.area.setRangeText(`\n${indent}`, selectionStart, selectionEnd, 'end');
    this.typed();
  }

  setFaults(faults) {
    this.faults = faults;
    this.list.hidden = !faults.length;
    fill(this.list, faults.map((fault) => {
      const item = faultItem(this.form, fault);
      item.prepend(h('button.link', { type: 'button', onclick: () => this.goTo(fault.start, fault.end) }, t('text-line', { line: fault.line })));
      return item;
    }));
    this.stale = true;
    if (this.visible) this.draw();
  }

  draw() {
    if (!this.stale) return;
    this.stale = false;
    const { text } = this.desk.document;
    fill(this.back, this.coloured(text), '\n');
    this.drawGutter(text.split('\n').length);
    this.follow();
  }

  drawGutter(count) {
    const wrong = new Map(this.faults.map((fault) => [fault.line, wording(fault)]));
    const lines = Array.from({ length: count }, (_, index) => {
      const message = wrong.get(index + 1);
      return message ? h('b', { title: message }, `${index + 1}\n`) : `${index + 1}\n`;
    });
    fill(this.gutter, lines);
  }

  coloured(text) {
    const marks = this.faults.map((fault) => [fault.start, Math.max(fault.end, fault.start + 1)]).filter(([start]) => start < text.length);
    const nodes = [];
    let at = 0;
    for (const { kind, start, end } of pieces(text)) {
      if (start > at) nodes.push(...cut(text, at, start, null, marks));
      nodes.push(...cut(text, start, end, kind, marks));
      at = end;
    }
    nodes.push(...cut(text, at, text.length, null, marks));
    return nodes;
  }

  follow() {
    this.back.style.transform = `translate(${-this.area.scrollLeft}px, ${-this.area.scrollTop}px)`;
    this.gutter.style.transform = `translateY(${-this.area.scrollTop}px)`;
  }

  /** Selects a place and brings it into view. */
  goTo(start, end = start) {
    this.draw();
    this.area.focus();
    this.area.setSelectionRange(start, end);
    const line = this.area.value.slice(0, start).split('\n').length - 1;
    const height = Number.parseFloat(getComputedStyle(this.area).lineHeight);
    this.area.scrollTop = Math.max(0, line * height - this.area.clientHeight / 2);
    this.area.scrollIntoView({ block: 'nearest' });
  }
}

// A piece of text as nodes, with the parts that are faulty marked.
function cut(text, start, end, kind, marks) {
  const nodes = [];
  let at = start;
  const put = (until, wrong) => {
    if (until <= at) return;
    const part = text.slice(at, until);
    const style = [kind ? `text-${kind}` : '', wrong ? 'text-fault' : ''].filter(Boolean).join(' ');
    nodes.push(style ? h('span', { class: style }, part) : part);
    at = until;
  };
  for (const [from, to] of marks) {
    if (to <= start || from >= end) continue;
    put(Math.max(from, at), false);
    put(Math.min(to, end), true);
  }
  put(end, false);
  return nodes;
}

// Where a cursor stands after the text around it was replaced: behind the part that is equal in both.
function movedPlace(before, after, place) {
  let start = 0;
  while (start < place && start < after.length && before[start] === after[start]) start += 1;
  if (start === place) return place;
  let end = 0;
  while (end < before.length - start && end < after.length - start && before[before.length - 1 - end] === after[after.length - 1 - end]) end += 1;
  return Math.max(start, after.length - end);
}
