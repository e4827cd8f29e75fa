// Meshes of a visitor: chosen or dropped, prepared in a worker, and shown.
import { embedded } from './embedded.mjs';

/// The name and the bytes of a mesh: out of gzip, and with the buffers of a .gltf put into it.
async function unpacked(file, others) {
  if (/\.xz$/i.test(file.name)) throw new Error('browsers do not unpack xz; unpack it first (xz -d)');
  if (/\.gz$/i.test(file.name)) {
    const stream = file.stream().pipeThrough(new DecompressionStream('gzip'));
    return { name: file.name.slice(0, -3), bytes: await new Response(stream).arrayBuffer().catch(() => { throw new Error('its gzip is damaged'); }) };
  }
  if (!/\.gltf$/i.test(file.name) || others.length === 0) return { name: file.name, bytes: await file.arrayBuffer() };
  const scene = JSON.parse(await file.text());
  for (const buffer of scene.buffers ?? []) {
    const other = others.find(({ name }) => name === decodeURIComponent(buffer.uri ?? '').split('/').at(-1));
    if (other) buffer.uri = await new Promise((resolve) => {
      const reader = new FileReader();
      reader.onload = () => resolve(reader.result.replace(/^data:[^;,]*/, 'data:application/octet-stream'));
      reader.readAsDataURL(other);
    });
  }
  return { name: file.name, bytes: new TextEncoder().encode(JSON.stringify(scene)).buffer };
}

export class Files {
  #worker = null;
  #address = null;  // of the worker's script

  /// `wasm`: its bytes, for the workers. `show` takes what prepared() gave, `fault` a sentence.
  constructor(by, wasm, { show, fault }) {
    Object.assign(this, { by, wasm, show, fault });
    by('file').addEventListener('change', () => this.#choose(by('file').files));
    const stage = by('stage');
    document.addEventListener('dragover', (event) => { event.preventDefault(); stage.classList.add('over'); });
    document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) stage.classList.remove('over'); });
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      stage.classList.remove('over');
      this.#choose(event.dataTransfer.files);
    });
  }
  /// A mesh, and for .gltf the files of its buffers.
  #choose(files) {
    const mesh = [...files].find(({ name }) => /\.gltf$/i.test(name)) ?? files[0];
    if (mesh) this.open(mesh, [...files].filter((file) => file !== mesh));
  }

  /// Prepares a file in a worker and shows it; a file that is opened meanwhile takes its place.
  async open(file, others = []) {
    this.#worker?.terminate();
    this.#address ??= URL.createObjectURL(new Blob([this.by('worker').textContent], { type: 'text/javascript' }));
    const worker = this.#worker = new Worker(this.#address);
    this.#working(`${file.name} …`);
    try {
      const [{ name, bytes }, readers] = await Promise.all([unpacked(file, others), embedded('readers')]);
      const mesh = await new Promise((resolve, reject) => {
        worker.onmessage = ({ data }) => {
          if (data.fault !== undefined) reject(new Error(data.fault));
          else if (data.mesh) resolve(data.mesh);
          else if (this.#worker === worker) this.#working(`${file.name}: ${Math.floor(100 * data.share)} % simplified`, data.share);
        };
        worker.onerror = (event) => reject(new Error(event.message ?? 'the worker of this page did not start'));
        worker.postMessage({ wasm: this.wasm, readers, name, bytes }, [bytes]);
      });
      if (this.#worker === worker) await this.show(mesh);
    } catch (error) {
      const words = error.message.replace('; name the format by --from: ', '; this page reads ');
      if (this.#worker === worker) this.fault(words.startsWith(file.name.replace(/\.gz$/i, '')) ? words : `${file.name}: ${words}`);
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
