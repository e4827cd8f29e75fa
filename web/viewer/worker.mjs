// The worker that prepares one mesh, so that the page continues meanwhile.
import { loadReaders } from '../../bindings/js/formats.mjs';
import { load } from '../../bindings/js/restrip.mjs';
import { prepared } from './prepare.mjs';

onmessage = async ({ data: { wasm, readers, name, bytes } }) => {
  try {
    const readMesh = await loadReaders(readers);
    const steps = prepared(await load(wasm), name, await readMesh(name, bytes));
    for (;;) {
      const { done, value } = steps.next();
      postMessage(done ? { mesh: value } : { share: value });
      if (done) return;
    }
  } catch (error) {
    postMessage({ fault: error.message });
  }
};
