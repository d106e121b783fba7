// The server's answers. Addresses are relative to the page, which lies below the token.

import { language } from './language.js';
import { t } from './words.js';

/** An answer other than 2xx, or none at all (`status` 0). */
export class ApiError extends Error {
  constructor(message, { status = 0, help = null, body = null } = {}) {
    super(message);
    this.name = 'ApiError';
    this.status = status;
    /** What to do about it, in the words of the program; or null. */
    this.help = help;
    /** The whole answer as an object: a 409 holds the text and sum of the file as it is now. */
    this.body = body;
  }
}

/**
 * @param {EventTarget} events gets `runs`, `folder` (details as the server sent them), `lost` and `back`
 * @returns calls; each resolves to the JSON of the answer and rejects with `ApiError`
 */
export function createApi(events) {
  const state = { lost: false, source: null, timer: 0, wait: 0 };

  function signalLost() {
    if (state.lost) return;
    state.lost = true;
    state.wait = 1000;
    events.dispatchEvent(new CustomEvent('lost', { detail: {} }));
    retry();
  }

  function retry() {
    clearTimeout(state.timer);
    state.timer = setTimeout(probe, state.wait);
  }

  // Another status than 200 means that another server listens here now: this page cannot reach it.
  async function probe() {
    try {
      const answer = await fetch('api/desk', { cache: 'no-store' });
      if (answer.ok) {
        state.lost = false;
        listen();
        events.dispatchEvent(new CustomEvent('back'));
        return;
      }
      events.dispatchEvent(new CustomEvent('lost', { detail: { other: true } }));
    } catch { /* Still gone. */ }
    state.wait = Math.min(state.wait * 1.5, 10_000);
    retry();
  }

  async function request(method, call, { query, body, raw, signal } = {}) {
    const address = `api/${call}${query ? `?${new URLSearchParams(query)}` : ''}`;
    const headers = { 'Accept-Language': language(), ...(body === undefined ? {} : { 'Content-Type': 'application/json' }) };
    let answer;
    let text;
    try {
      answer = await fetch(address, {
        method, headers, signal, cache: 'no-store', body: raw ?? (body === undefined ? undefined : JSON.stringify(body)),
      });
      text = await answer.text();
    } catch (error) {
      if (error.name === 'AbortError') throw error;
      signalLost();
      throw new ApiError(t('desk-silent'), { status: 0 });
    }
    const value = parse(text);
    if (answer.ok) return value;
    const fault = value?.error ?? {};
    throw new ApiError(fault.message ?? `${answer.status} ${answer.statusText}`.trim(), {
      status: answer.status, help: fault.help ?? null, body: value,
    });
  }

  function listen() {
    state.source?.close();
    const source = new EventSource('api/events');
    state.source = source;
    for (const name of ['runs', 'folder']) {
      source.addEventListener(name, (message) => {
        events.dispatchEvent(new CustomEvent(name, { detail: parse(message.data) }));
      });
    }
    source.onerror = () => {
      source.close();
      if (state.source === source) signalLost();
    };
  }

  return {
    get: (call, query, options = {}) => request('GET', call, { query, ...options }),
    put: (call, body, options = {}) => request('PUT', call, { body, ...options }),
    post: (call, body, options = {}) => request('POST', call, { body, ...options }),
    remove: (call, options = {}) => request('DELETE', call, options),
    upload: (name, raw, options = {}) => request('POST', 'upload', { query: { name }, raw, ...options }),
    /** Address of a file of a results folder, for links, images and frames. */
    resultAddress(folder, file, save = false) {
      const parts = [...folder.split('/'), ...file.split('/')].filter((part) => part !== '' && part !== '.');
      return `api/result/${parts.map(encodeURIComponent).join('/')}${save ? '?download=1' : ''}`;
    },
    listen,
    /** Whether the server did not answer last time. */
    get lost() { return state.lost; },
    /** Tries to reach the server now. */
    retry() { clearTimeout(state.timer); return probe(); },
  };
}

function parse(text) {
  if (!text) return null;
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
