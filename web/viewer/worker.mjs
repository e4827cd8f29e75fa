// The worker that prepares one mesh, so that the page continues meanwhile.
import { loadReaders } from '../../bindings/js/formats.mjs';
import { load } from '../../bindings/js/restrip.mjs';
import { prepared } from './prepare.mjs';

/// The result of a generator of the share that is done.
async function reported(steps) {
  for (;;) {
    const { done, value } = await steps.next();
    if (done) return value;
    postMessage({ share: value });
  }
}

onmessage = async ({ data: { wasm, readers, name, bytes } }) => {
  try {
    const { readMesh, simplifying } = await loadReaders(readers);
    const read = await readMesh(name, bytes);
    const levels = read.triangles ? await reported(simplifying(read)) : read;
    postMessage({ mesh: prepared(await load(wasm), name, levels) });
  } catch (error) {
    postMessage({ fault: error.message });
  }
};
