// Reads scene.json beside the page: the text is twenty megabytes and more, and a thread that ends leaves no garbage behind.

import { decoded } from './scene-data.js';

onmessage = async ({ data: address }) => {
  try {
    const answer = await fetch(address, { cache: 'no-store' });
    if (answer.status === 404) return void postMessage({ none: true });
    const json = await answer.json();
    if (!answer.ok) throw new Error(json?.error?.message ?? `${answer.status} ${answer.statusText}`);
    const scene = decoded(json);
    postMessage({ scene }, [...new Set(buffers(scene))]);
  } catch (error) {
    postMessage({ fault: error.message });
  }
};

/** The memory of all arrays of a value. */
function buffers(value) {
  if (ArrayBuffer.isView(value)) return [value.buffer];
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(buffers) : [];
}
