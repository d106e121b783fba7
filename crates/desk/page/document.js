// The text of tank.json: the one truth that form, text editor and checks share. Every change is a new text on a stack,
// so that undo works across all of them. What is not saved is kept as a draft in the browser.

import { changedElsewhere, nameForSaving, proposedName } from './files.js';
import { nodeAt, parse, plain } from './jsonc.js';
import { formatPath } from './path.js';
import { keepDraft, keepLast, lastFile, removeDraft, storedDraft } from './drafts.js';
import { putShort } from './rows.js';
import { t } from './words.js';
import './document-words.js';

const STEPS = 500;
/** Changes of one value within this time are one step of undo [ms]. */
const ONE_STEP = 10_000;

export async function openDocument(desk) {
  const document = new TankDocument(desk);
  await document.start();
  return document;
}

// The tank file in the address: #tank/PATH.
function addressed() {
  const [room, ...path] = location.hash.slice(1).split('/');
  try {
    return room === 'tank' ? decodeURIComponent(path.join('/')) : '';
  } catch {
    return '';
  }
}

export class TankDocument {
  constructor(desk) {
    this.desk = desk;
    this.path = null;
    this.text = '';
    this.saved = '';
    this.sha = null;
    this.root = null;
    this.past = [];
    this.future = [];
    this.edits = [];
    /** The last answer of `api/check`, or null. */
    this.check = null;
    /** A draft of another time that differs from the file: `{text, at}` or null. */
    this.draft = null;
    this.checking = null;
    this.stale = false;
    desk.events.addEventListener('folder', () => this.lookAtDisk());
    desk.events.addEventListener('record', () => this.requestCheck());
    desk.events.addEventListener('settings', (event) => {
      if (event.detail?.name !== 'theme') this.requestCheck();
    });
  }

  get dirty() { return this.text !== this.saved; }
  get empty() { return this.path === null && this.text.trim() === ''; }
  /** Whether nothing has been entered into an empty form yet. */
  get untouched() { return this.path === null && !this.canUndo && this.root?.members?.length === 0; }
  get canUndo() { return this.past.length > 0; }
  get canRedo() { return this.future.length > 0; }

  async start() {
    const { folder, tank } = this.desk.info;
    const { here, ever } = lastFile(folder);
    const address = addressed();
    const file = address || (here ?? (tank || ever));
    try {
      if (file) return await this.open(file);
    } catch (error) {
      // A file that is only remembered may be gone.
      if (file === address || file === tank) this.desk.sayError(error);
    }
    this.draft = storedDraft(folder, null);
    this.tell('open');
  }

  /** Loads a file; the caller has asked about unsaved text. */
  async open(path) {
    const file = await this.desk.api.get('file', { path });
    this.path = file.path ?? path;
    this.begin(file.text, file.text, file.sha256);
  }

  /** Starts a new text without a file. */
  startFrom(text) {
    this.path = null;
    this.begin(text, '', null);
  }

  begin(text, saved, sha) {
    this.past = [];
    this.future = [];
    this.edits = [];
    this.saved = saved;
    this.sha = sha;
    this.check = null;
    const draft = storedDraft(this.desk.info.folder, this.path);
    this.draft = draft && draft.text !== text ? draft : null;
    this.put(text, 'open');
  }

  /* Changes */

  /** Sets a value by its path; `undefined` removes it. Comments and order of all else are kept. */
  set(parts, value, key = null) {
    const path = formatPath(parts);
    const waiting = this.edits.at(-1);
    const same = waiting && !waiting.started && waiting.path === path;
    if (same) Object.assign(waiting, { value, key: key ?? path });
    else this.edits.push({ parts, path, value, key: key ?? path, started: false });
    this.working ??= this.work().finally(() => { this.working = null; });
    return this.working;
  }

  /** Whether a change of the form has not reached the text yet. */
  get pending() { return this.edits.length > 0; }

  async work() {
    while (this.edits.length) {
      const edit = this.edits[0];
      edit.started = true;
      const base = this.text;
      try {
        const text = await this.edited(base.trim() === '' ? '{\n}\n' : base, edit);
        // Undo has taken the wish away, or the text has changed meanwhile: the edit is then made on the new one.
        if (this.edits[0] !== edit || this.text !== base) continue;
        this.edits.shift();
        this.replace(text, { key: edit.key, origin: 'form' });
      } catch (error) {
        if (this.edits[0] === edit) this.edits.shift();
        if (error.name !== 'AbortError') this.desk.sayError(error);
        this.tell('failed');
      }
    }
  }

  // The text with an edit made; what lies between it and the next given value is made first, so that each has its lines.
  async edited(text, { parts, value }) {
    if (value === undefined) return this.editedByServer(text, parts, value);
    let now = text;
    for (let length = 1; length < parts.length; length += 1) {
      const above = parts.slice(0, length);
      if (nodeAt(parse(now), above) === undefined) now = await this.placed(now, above, typeof parts[length] === 'number' ? [] : {});
    }
    return this.placed(now, parts, value);
  }

  async placed(text, parts, value) {
    return putShort(text, parse(text), parts, value) ?? this.editedByServer(text, parts, value);
  }

  async editedByServer(text, parts, value) {
    const body = { text, path: formatPath(parts) };
    if (value !== undefined) body.value = value;
    return (await this.desk.api.post('edit', body)).text;
  }

  /** Replaces the whole text. Changes with an equal `key` that follow each other quickly are one step of undo. */
  replace(text, { key = null, origin = 'text', within = ONE_STEP } = {}) {
    if (text === this.text) return;
    const last = this.past.at(-1);
    const now = Date.now();
    if (key && last?.key === key && now - last.time < within && !this.future.length) last.time = now;
    else this.past.push({ text: this.text, key, time: now });
    if (this.past.length > STEPS) this.past.shift();
    this.future = [];
    this.put(text, origin);
  }

  undo() {
    const step = this.past.pop();
    if (!step) return;
    this.edits = [];
    this.future.push({ text: this.text });
    this.put(step.text, 'undo');
  }

  redo() {
    const step = this.future.pop();
    if (!step) return;
    this.edits = [];
    this.past.push({ text: this.text, key: null, time: 0 });
    this.put(step.text, 'undo');
  }

  put(text, origin) {
    this.text = text;
    this.root = parse(text);
    this.changedAt ??= performance.now();
    this.keep();
    this.tell(origin);
    this.requestCheck();
  }

  tell(origin) {
    keepLast(this.desk.info.folder, this.path);
    // An address with another file would open that one at a reload.
    if (addressed() && addressed() !== this.path) history.replaceState(null, '', '#tank');
    this.desk.events.dispatchEvent(new CustomEvent('text', { detail: { origin } }));
  }

  keep() {
    if (this.draft && !this.dirty) return;
    if (this.dirty) keepDraft(this.desk.info.folder, this.path, this.text);
    else removeDraft(this.desk.info.folder, this.path);
  }

  /** Takes the draft of another time as a change, or forgets it. */
  settleDraft(take) {
    const draft = this.draft;
    this.draft = null;
    if (take && draft) this.replace(draft.text, { origin: 'open' });
    else this.keep();
    this.tell('draft');
  }

  /* Checks */

  /** Asks for the checks of the text as it is now; while an answer is awaited, only the last wish counts. */
  requestCheck() {
    if (this.text.trim() === '') return;
    if (this.checking) this.stale = true;
    else this.checking = this.runChecks().finally(() => { this.checking = null; });
  }

  async runChecks() {
    do {
      this.stale = false;
      const text = this.text;
      const since = this.changedAt;
      this.changedAt = null;
      try {
        const answer = await this.desk.api.post('check', this.question(text));
        if (this.stale && this.text !== text) this.changedAt ??= since;
        answer.text = text;
        answer.waited = since === null ? null : performance.now() - since;
        this.check = answer;
        this.desk.events.dispatchEvent(new CustomEvent('checked', { detail: answer }));
      } catch (error) {
        if (error.status !== 0) this.desk.sayError(error);
        return;
      }
    } while (this.stale);
  }

  /** What `check`, `sheet` and `solve` have in common. */
  question(text = this.text) {
    const { language, units } = this.desk.settings;
    const question = { text, language, units };
    if (this.path) question.name = this.path;
    if (this.desk.record) question.record = this.desk.record;
    return question;
  }

  /* Files */

  /** Saves; asks for a name where there is none, and what to do where the file has changed. Resolves to whether it is saved. */
  async save() {
    await this.working;
    if (this.path === null) return this.saveAs();
    return this.write(this.path, this.sha);
  }

  async saveAs() {
    await this.working;
    const path = await nameForSaving(this.desk, this.path ?? proposedName(plain(nodeAt(this.root, ['name']))));
    return path ? this.write(path, path === this.path ? this.sha : null) : false;
  }

  async write(path, was) {
    const text = this.text;
    try {
      const { sha256 } = await this.desk.api.put('file', { path, text, was });
      if (path !== this.path) removeDraft(this.desk.info.folder, this.path);
      const moved = path !== this.path;
      Object.assign(this, { path, sha: sha256, saved: text, draft: null });
      this.keep();
      this.tell('save');
      if (moved) this.requestCheck();
      this.desk.say(t('doc-saved', { name: path }), 'ok');
      return true;
    } catch (error) {
      if (error.status === 409) return this.settle(path, error.body ?? {}, was === null);
      if (error.status === 0) this.desk.say(t('doc-kept'), 'warning');
      else this.desk.sayError(error);
      return false;
    }
  }

  // The file is not as it was read: another window or program has written it, or a new file has the name of another.
  async settle(path, { text: theirs, sha256 }, created) {
    const answer = await changedElsewhere(this.desk, path, this.text, theirs ?? '', created);
    if (answer === 'mine') return this.write(path, sha256);
    if (answer !== 'theirs') return false;
    const had = { text: this.text, key: null, time: 0 };
    Object.assign(this, { path, sha: sha256, saved: theirs });
    this.past.push(had);
    this.future = [];
    this.put(theirs, 'open');
    return true;
  }

  async lookAtDisk() {
    if (!this.path || this.looking) return;
    this.looking = true;
    try {
      const file = await this.desk.api.get('file', { path: this.path });
      if (file.sha256 === this.sha || this.working) return;
      if (this.dirty) {
        if (this.warned !== file.sha256) this.desk.say(t('doc-changed-dirty', { name: this.path }), 'warning');
        this.warned = file.sha256;
        return;
      }
      this.past.push({ text: this.text, key: null, time: 0 });
      Object.assign(this, { saved: file.text, sha: file.sha256 });
      this.put(file.text, 'open');
      this.desk.say(t('doc-reloaded', { name: this.path }));
    } catch {
      // The file may be gone; saving says so.
    } finally {
      this.looking = false;
    }
  }
}
