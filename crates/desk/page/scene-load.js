// Reads a scene from its address in a worker thread.

/** Resolves to the scene of scene-data.js, or to null where there is none. */
export function loadScene(address) {
  return new Promise((resolve, reject) => {
    const worker = new Worker(new URL('scene-worker.js', document.baseURI), { type: 'module' });
    const end = (act, value) => {
      worker.terminate();
      act(value);
    };
    worker.onmessage = ({ data }) => (data.fault ? end(reject, new Error(data.fault)) : end(resolve, data.scene ?? null));
    worker.onerror = (event) => end(reject, new Error(event.message || 'scene-worker.js'));
    worker.postMessage(new URL(address, document.baseURI).href);
  });
}
