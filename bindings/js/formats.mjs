// Mesh files, read by the readers of the program `restrip`, and its simplifier, as a WebAssembly module. formats.d.ts is
// the manual.
import { coordinates, lists, quoted, vertices } from './arguments.mjs';
import { compiled, contentOf } from './module.mjs';

/// Compiles the readers: their bytes, or where to fetch them from; by default the file next to this one.
export async function loadReaders(source = new URL('./restrip-readers.wasm', import.meta.url)) {
  const module = await compiled(source);
  const simplifying = (mesh, share = 0.02) => {
    if (!(share >= 0 && share <= 1)) throw new RangeError(`share is ${quoted(share)}; it must be from 0 to 1`);
    const [points, triangles] = lists('simplified()', mesh, ['points', 'triangles']);
    const places = coordinates(points);
    return simplifyWith(module, places, vertices('triangles', triangles, 3, places.length / 3), share);
  };
  return {
    readMesh: async (name, content) => readWith(module, name, await contentOf(name, content)),
    simplifying,
    simplified: async (mesh, share) => {
      const steps = simplifying(mesh, share);
      for (;;) {
        const { done, value } = await steps.next();
        if (done) return value;
      }
    },
  };
}

// The C library would print last messages to a file, which does not exist here.
const badDescriptor = 8;
const noFiles = { fd_write: () => badDescriptor, fd_seek: () => badDescriptor, fd_close: () => badDescriptor };

/// A new module for each file and each mesh, so memory left by a refused file is released with it. `what` is named by errors.
class Instance {
  static async of(module, what) {
    const made = new Instance(what);
    const { exports } = await WebAssembly.instantiate(module, { readers: { refuse: (address) => made.#refuse(address) }, wasi_snapshot_preview1: noFiles });
    made.exports = exports;
    made.do((own) => own._initialize());
    return made;
  }
  constructor(what) { this.what = what; }
  get #memory() { return this.exports.memory.buffer; }
  text(address, bytes) { return new TextDecoder().decode(new Uint8Array(this.#memory, address >>> 0, bytes)); }
  #refuse(address) {
    const from = new Uint8Array(this.#memory, address >>> 0);
    throw new Error(this.text(address, from.indexOf(0)));
  }
  /// Address and length of a copy of the list.
  put(list) {
    const address = this.exports.readers_take(list.byteLength) >>> 0;
    if (address === 0) throw new Error(`${this.what}: is larger than the memory that a page can have`);
    new list.constructor(this.#memory, address, list.length).set(list);
    return [address, list.length];
  }
  /// Calls functions of the module.
  do(calls) {
    try {
      return calls(this.exports);
    } catch (error) {
      throw error instanceof WebAssembly.RuntimeError ? new Error(`${this.what}: takes more memory than a page can have`) : error;
    }
  }
  /// The ReadResult there.
  found(address) {
    const [kind, ...all] = new Uint32Array(this.#memory, address >>> 0, 11);
    const list = (Kind, n) => new Kind(this.#memory.slice(all[2 * n], all[2 * n] + Kind.BYTES_PER_ELEMENT * all[2 * n + 1]));
    return { kind, points: list(Float32Array, 0), triangles: list(Uint32Array, 1), splits: list(Uint32Array, 2), baked: list(Uint8Array, 3), leftOut: this.text(all[8], all[9]) };
  }
}

async function readWith(module, name, bytes) {
  const own = await Instance.of(module, name);
  const [file, title] = [own.put(bytes), own.put(new TextEncoder().encode(name))];
  const { kind, points, triangles, splits, baked, leftOut } = own.found(own.do(({ readers_read: read }) => read(...file, ...title)));
  return [{ points, triangles, leftOut }, { points, base: triangles, splits, leftOut }, { baked, leftOut }][kind];
}

async function* simplifyWith(module, points, corners, share) {
  const own = await Instance.of(module, 'simplified()');
  const [places, triangles] = [own.put(points), own.put(corners)];
  const count = corners.length / 3;
  const wanted = Math.max(4, Math.round(count * share));
  own.do(({ readers_simplify: begin }) => begin(...places, ...triangles));
  for (;;) {
    const left = own.do(({ readers_simplify_on: more }) => more(wanted, 1000)) >>> 0;
    if (left === 0) break;
    yield 1 - left / Math.max(1, count - wanted);
  }
  const { triangles: base, splits } = own.found(own.do(({ readers_simplified: found }) => found()));
  return { points, base, splits };
}
