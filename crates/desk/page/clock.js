// The moment that is shown: the scene and all charts of a result follow one clock.

/** A clock: `set` moves it, `on` calls back at every move and returns a function that ends this. */
export function createClock() {
  const listeners = new Set();
  return {
    time: 0,
    /** Whether a player moves it: what is costly to draw may then follow a few times a second. */
    playing: false,
    set(time, by = null) {
      this.time = time;
      for (const listener of listeners) listener(time, by);
    },
    on(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
