// Mesh files, read by the readers of the program `restrip`, as a WebAssembly module. formats.d.ts is the manual.
import { compiled, contentOf } from './module.mjs';

/// Compiles the readers: their bytes, or where to fetch them from; by default the file next to this one.
export async function loadReaders(source = new URL('./restrip-readers.wasm', import.meta.url)) {
  const module = await compiled(source);
  return async (name, content) => readWith(module, name, await contentOf(name, content));
}

// The C library would print last messages to a file, which does not exist here.
const badDescriptor = 8;
const noFiles = { fd_write: () => badDescriptor, fd_seek: () => badDescriptor, fd_close: () => badDescriptor };

/// Each file has a new module, so memory left by a refused file is released with it.
async function readWith(module, name, bytes) {
  let memory;
  const text = (address, bytes) => new TextDecoder().decode(new Uint8Array(memory.buffer, address >>> 0, bytes));
  const refuse = (address) => {
    const from = new Uint8Array(memory.buffer, address >>> 0);
    throw new Error(text(address, from.indexOf(0)));
  };
  const { exports } = await WebAssembly.instantiate(module, { readers: { refuse }, wasi_snapshot_preview1: noFiles });
  memory = exports.memory;
  exports._initialize();
  const put = (bytes) => {
    const address = exports.readers_take(bytes.length) >>> 0;
    if (address === 0) throw new Error(`${name}: is larger than the memory that a page can have`);
    new Uint8Array(memory.buffer, address, bytes.length).set(bytes);
    return [address, bytes.length];
  };
  let found;
  try {
    found = exports.readers_read(...put(bytes), ...put(new TextEncoder().encode(name))) >>> 0;
  } catch (error) {
    throw error instanceof WebAssembly.RuntimeError ? new Error(`${name}: takes more memory than a page can have`) : error;
  }
  const [kind, ...lists] = new Uint32Array(memory.buffer, found, 11);
  const list = (Kind, n) => new Kind(memory.buffer.slice(lists[2 * n], lists[2 * n] + Kind.BYTES_PER_ELEMENT * lists[2 * n + 1]));
  const leftOut = text(lists[8], lists[9]);
  if (kind === 2) return { baked: list(Uint8Array, 3), leftOut };
  const [points, triangles] = [list(Float32Array, 0), list(Uint32Array, 1)];
  return kind === 1 ? { points, base: triangles, splits: list(Uint32Array, 2), leftOut } : { points, triangles, leftOut };
}
