// Language, units and theme. Kept in localStorage, and in a cookie because the port, and with it the storage, differs
// from one start of the desk to the next.

const ALLOWED = { language: ['en', 'de'], units: ['si', 'us'], theme: ['auto', 'light', 'dark'] };

/** The settings as kept, or defaults; `fromServer` is the language that the server proposes. */
export function readSettings(fromServer = null) {
  const browser = (navigator.language || 'en').startsWith('de') ? 'de' : 'en';
  return {
    language: kept('language') ?? (ALLOWED.language.includes(fromServer) ? fromServer : browser),
    units: kept('units') ?? 'si',
    theme: kept('theme') ?? 'auto',
  };
}

/** Keeps one setting for the next time. */
export function keepSetting(name, value) {
  try {
    localStorage.setItem(`desk.${name}`, value);
  } catch { /* Storage may be blocked. */ }
  document.cookie = `desk-${name}=${value}; path=/; max-age=31536000; samesite=strict`;
}

function kept(name) {
  let value = null;
  try {
    value = localStorage.getItem(`desk.${name}`);
  } catch { /* Storage may be blocked. */ }
  value ??= document.cookie.match(new RegExp(`(?:^|; )desk-${name}=([a-z]+)`))?.[1] ?? null;
  return ALLOWED[name].includes(value) ? value : null;
}
