// Meshes of a visitor: chosen or dropped, prepared in a worker, and shown.
import { embedded } from './embedded.mjs';

export class Files {
  #worker = null;
  #address = null;  // of the worker's script

  /// `wasm`: its bytes, for the workers. `show` takes what prepared() gave, `fault` a sentence.
  constructor(by, wasm, { show, fault }) {
    Object.assign(this, { by, wasm, show, fault });
    by('file').addEventListener('change', () => by('file').files.length && this.open(by('file').files[0]));
    const stage = by('stage');
    document.addEventListener('dragover', (event) => { event.preventDefault(); stage.classList.add('over'); });
    document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) stage.classList.remove('over'); });
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      stage.classList.remove('over');
      if (event.dataTransfer.files.length) this.open(event.dataTransfer.files[0]);
    });
  }

  /// Prepares a file in a worker and shows it; a file that is opened meanwhile takes its place.
  async open(file) {
    this.#worker?.terminate();
    this.#address ??= URL.createObjectURL(new Blob([this.by('worker').textContent], { type: 'text/javascript' }));
    const worker = this.#worker = new Worker(this.#address);
    this.#working(`${file.name} …`);
    try {
      const [bytes, readers] = await Promise.all([file.arrayBuffer(), embedded('readers')]);
      const mesh = await new Promise((resolve, reject) => {
        worker.onmessage = ({ data }) => {
          if (data.fault !== undefined) reject(new Error(data.fault));
          else if (data.mesh) resolve(data.mesh);
          else if (this.#worker === worker) this.#working(`${file.name}: ${Math.floor(100 * data.share)} % simplified`, data.share);
        };
        worker.onerror = (event) => reject(new Error(event.message ?? 'the worker of this page did not start'));
        worker.postMessage({ wasm: this.wasm, readers, name: file.name, bytes }, [bytes]);
      });
      if (this.#worker === worker) await this.show(mesh);
    } catch (error) {
      if (this.#worker === worker) this.fault(error.message.startsWith(file.name) ? error.message : `${file.name}: ${error.message}`);
    } finally {
      worker.terminate();
      if (this.#worker === worker) this.#working(null);
    }
  }
  /// The current file, and the share that is done if known.
  #working(text, share) {
    this.by('working').hidden = text === null;
    this.by('working-text').textContent = text ?? '';
    if (share === undefined) this.by('progress').removeAttribute('value');
    else this.by('progress').value = share;
  }
}
