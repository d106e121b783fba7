// Unsaved texts, kept in the browser for each file, so that neither a closed window nor a killed server loses them.

const name = (folder, path) => `desk.draft:${folder}:${path ?? ''}`;

export function keepDraft(folder, path, text) {
  try {
    localStorage.setItem(name(folder, path), JSON.stringify({ text, at: new Date().toISOString() }));
  } catch {
    // Storage may be blocked or full; the window still asks before it closes.
  }
}

export function removeDraft(folder, path) {
  try {
    localStorage.removeItem(name(folder, path));
  } catch {
    // Nothing was kept.
  }
}

/** `{text, at}` or null. */
export function storedDraft(folder, path) {
  try {
    const draft = JSON.parse(localStorage.getItem(name(folder, path)));
    return typeof draft?.text === 'string' ? draft : null;
  } catch {
    return null;
  }
}

const lastName = (folder) => `desk.last:${folder}`;

/** Keeps which file of a folder is open; an empty text for a new tank. */
export function keepLast(folder, path) {
  try {
    sessionStorage.setItem(lastName(folder), path ?? '');
    if (path) localStorage.setItem(lastName(folder), path);
  } catch {
    // Without storage a reload begins anew.
  }
}

/** The file that was open last in a folder: `{here, ever}`, in this window before a reload and in any window; null where there was none. */
export function lastFile(folder) {
  try {
    return { here: sessionStorage.getItem(lastName(folder)), ever: localStorage.getItem(lastName(folder)) };
  } catch {
    return { here: null, ever: null };
  }
}
