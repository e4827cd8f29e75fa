// restrip for JavaScript: triangle strips kept while the mesh changes. restrip.d.ts is the manual.
//
// The library is one WebAssembly module without imports. Arguments that are lists are copied in; the index buffer is
// looked at where it lies.

const families = ['split', 'collapse', 'open-split', 'open-collapse', 'boundary-split', 'boundary-collapse', 'flip'];
const costs = { strips: { restart: 1, swap: 0, isolated: 0 }, indices: { restart: 3, swap: 1, isolated: 0 } };
export const restartIndex = 0xffffffff;
export const none = 0xffffffff;

const figureNames = ['triangles', 'strips', 'played', 'inOrder', 'bufferIndices', 'operations', 'addingStrip',
  'isolating', 'refused', 'indicesWritten', 'updates', 'baked'];

export const small = new URL('./restrip-small.wasm', import.meta.url);

/// Compiles the module: its bytes, or where to fetch it from; the file beside this one when nothing is given.
export async function load(source = new URL('./restrip.wasm', import.meta.url)) {
  let module;
  if (source instanceof WebAssembly.Module) module = source;
  else if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) module = await WebAssembly.compile(source);
  else if (String(source).startsWith('file:')) {
    const files = 'node:fs/promises';  // a name that bundlers for browsers do not look for
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files);
    module = await WebAssembly.compile(await readFile(new URL(source)));
  } else {
    const answer = await fetch(source);
    if (!answer.ok) throw new Error(`${source}: ${answer.status} ${answer.statusText}`);
    module = await WebAssembly.compile(await answer.arrayBuffer());
  }
  const instance = await WebAssembly.instantiate(module, {});
  instance.exports._initialize();
  return new Restrip(instance.exports);
}

export class Restrip {
  #wasm;

  constructor(wasm) {
    this.#wasm = wasm;
  }

  /// A progressive mesh as it is.
  progressive({ points, base, splits }) {
    return this.#opened(this.#with([Float32Array.from(points), Uint32Array.from(base), Uint32Array.from(splits)],
      (p, b, s) => this.#wasm.restrip_open(p, points.length / 3, b, base.length / 3, s, splits.length / 4)), points);
  }
  /// A mesh, simplified here to `share` of its triangles.
  simplified({ points, triangles }, share = 0.02) {
    const wanted = Math.max(4, Math.round(triangles.length / 3 * share));
    return this.#opened(this.#with([Float32Array.from(points), Uint32Array.from(triangles)],
      (p, t) => this.#wasm.restrip_simplify(p, points.length / 3, t, triangles.length / 3, wanted)), points);
  }

  /// A baked mesh, from the bytes of its file.
  baked(bytes) {
    const copy = Uint8Array.from(ArrayBuffer.isView(bytes) ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) : new Uint8Array(bytes));
    const page = this.#with([copy], (b) => this.#wasm.restrip_open_baked(b, copy.length));
    const damage = textAt(this.#wasm, this.#wasm.restrip_damage(page));
    if (damage !== '') {
      this.#wasm.restrip_close(page);
      throw new Error(`baked mesh: ${damage}`);
    }
    return this.#opened(page, this.#list(this.#wasm.restrip_points(page), Float32Array));
  }

  /// The rule of a configuration.
  rule({ family, k = 0, a = 0, i = 0, j = 0, edges, ports }) {
    const number = families.indexOf(family);
    if (number < 0) throw new RangeError(`there is no family ${family}; there are ${families.join(', ')}`);
    const x = number < 2 ? a : i;
    const [valid, strips, low, high, kept] =
      this.#list(this.#wasm.restrip_rule(number, k, x, j, BigInt(edges), BigInt(ports)), Uint32Array);
    return { valid: valid === 1, strips: strips | 0, colors: BigInt(high) << 32n | BigInt(low),
      ports: family === 'flip' ? BigInt(kept) : BigInt(ports) };
  }

  #opened(page, points) {
    const mesh = new StripMesh(this.#wasm, page, Float32Array.from(points));
    const refused = this.#wasm.restrip_refused_record(page) >>> 0;
    if (refused !== none) {
      mesh.close();
      throw new Error(`split ${refused} of the progressive mesh cannot be done; all before it can`);
    }
    return mesh;
  }
  /// Copies the arrays into the module's memory for the time of the call.
  #with(arrays, call) {
    const places = arrays.map((array) => {
      const place = this.#wasm.restrip_take(Math.max(array.byteLength, 1));
      if (place === 0) throw new RangeError('out of memory');
      return place;
    });
    arrays.forEach((array, n) => new array.constructor(this.#wasm.memory.buffer, places[n], array.length).set(array));
    try {
      return call(...places);
    } finally {
      places.forEach((place) => this.#wasm.restrip_give_back(place));
    }
  }
  #list(address, Type) {
    return listAt(this.#wasm, address, Type, 1);
  }
}

function listAt(wasm, address, Type, width) {
  const [data, size] = new Uint32Array(wasm.memory.buffer, address, 2);
  return size === 0 ? new Type(0) : new Type(wasm.memory.buffer, data, size * width);
}

/// The names of the library's policies, in its order.
function policiesOf(wasm) {
  const names = [];
  for (let at = wasm.restrip_policy_name(0); at !== 0; at = wasm.restrip_policy_name(names.length)) names.push(textAt(wasm, at));
  return names;
}

function textAt(wasm, address) {
  const memory = new Uint8Array(wasm.memory.buffer);
  return new TextDecoder().decode(memory.slice(address, memory.indexOf(0, address)));
}

export class StripMesh {
  #wasm;
  #page;
  #levels;
  #wanted = 0;
  /// Three coordinates a vertex; they never change.
  points;

  constructor(wasm, page, points) {
    this.#wasm = wasm;
    this.#page = page;
    this.points = points;
    this.#levels = wasm.restrip_levels(page);
  }
  close() {
    if (this.#wanted) this.#wasm.restrip_give_back(this.#wanted);
    if (this.#page) this.#wasm.restrip_close(this.#page);
    this.#page = this.#wanted = 0;
  }

  get levels() { return this.#levels; }
  get splits() { return listAt(this.#wasm, this.#wasm.restrip_splits(this.#page), Uint32Array, 4).slice(); }
  get leftOut() {
    const count = (what) => this.#wasm.restrip_left_out(this.#page, what);
    return { triangles: count(0), nonManifoldVertices: count(1), boundaryEdges: count(2) };
  }

  get hasBakedStrips() { return this.#wasm.restrip_has_baked_strips(this.#page) === 1; }

  begin({ policy = 'quick', cost = 'strips' } = {}) {
    if (policy === 'baked') {
      if (!this.hasBakedStrips) throw new RangeError('this mesh has no baked strips; open the file of a baked mesh');
      this.#wasm.restrip_begin_baked(this.#page);
      return this;
    }
    const policies = policiesOf(this.#wasm);
    const number = policies.indexOf(policy);
    if (number < 0) throw new RangeError(`there is no policy ${policy}; there are ${policies.join(', ')}, and baked for baked meshes`);
    const { restart, swap, isolated = 0 } = typeof cost === 'string' ? costs[cost] : cost;
    this.#wasm.restrip_begin(this.#page, number, restart, swap, isolated);
    return this;
  }
  moveTo(level, most = 0xffffffff) {
    return this.#wasm.restrip_move(this.#page, Math.min(level, this.#levels), most);
  }
  approach(wanted, most = 0xffffffff) {
    if (wanted.length !== this.#levels) throw new RangeError(`${wanted.length} records of ${this.#levels}`);
    if (!this.#wanted) this.#wanted = this.#wasm.restrip_take(Math.max(1, this.#levels));
    new Uint8Array(this.#wasm.memory.buffer, this.#wanted, this.#levels).set(wanted);
    return this.#wasm.restrip_approach(this.#page, this.#wanted, most);
  }
  split(vS, vT, vL, vR) { return this.#done(this.#wasm.restrip_split(this.#page, vS, vT, vL, vR)); }
  collapse(vS, vT) { return this.#done(this.#wasm.restrip_collapse(this.#page, vS, vT)); }
  flip(u, v) { return this.#done(this.#wasm.restrip_flip(this.#page, u, v)); }
  #done(refusal) {
    if (refusal === 0) return null;
    return textAt(this.#wasm, this.#wasm.restrip_describe(refusal));
  }

  update() {
    const flat = listAt(this.#wasm, this.#wasm.restrip_update(this.#page), Uint32Array, 2);
    const ranges = [];
    for (let i = 0; i < flat.length; i += 2) ranges.push({ first: flat[i], count: flat[i + 1] });
    return ranges;
  }
  get indices() { return listAt(this.#wasm, this.#wasm.restrip_indices(this.#page), Uint32Array, 1); }
  get triangles() { return listAt(this.#wasm, this.#wasm.restrip_triangles(this.#page), Uint32Array, 3).slice(); }

  get figures() {
    const raw = new Uint32Array(this.#wasm.memory.buffer, this.#wasm.restrip_figures(this.#page), figureNames.length);
    const figures = Object.fromEntries(figureNames.map((name, n) => [name, raw[n]]));
    for (const flag of ['inOrder', 'baked']) figures[flag] = figures[flag] === 1;
    return figures;
  }
  get plainIndices() { return this.#wasm.restrip_plain_indices(this.#page); }
  get indexBound() { return this.#wasm.restrip_index_bound(this.#page); }
  get valid() { return this.#wasm.restrip_valid(this.#page) === 1; }

  get runs() { return listAt(this.#wasm, this.#wasm.restrip_runs(this.#page), Uint32Array, 3).slice(); }
  get lines() { return listAt(this.#wasm, this.#wasm.restrip_lines(this.#page), Float32Array, 1).slice(); }
  pick(from, along) {
    const hit = listAt(this.#wasm, this.#wasm.restrip_pick(this.#page, ...from, ...along), Float32Array, 1);
    return hit.length === 0 ? null : Array.from(hit);
  }
  get last() {
    const n = listAt(this.#wasm, this.#wasm.restrip_last(this.#page), Uint32Array, 1);
    if (n[0] === 0) return null;
    const mask = (at) => BigInt(n[at + 1]) << 32n | BigInt(n[at]);
    const told = { kind: families[[0, 0, 1, 6][n[0]]], closed: n[1] === 1, k: n[2], a: n[3],
      before: mask(4), ports: mask(6), after: mask(8), portsAfter: mask(10), strips: n[12] | 0, isolated: n[13] | 0 };
    const triangles = (after) =>
      listAt(this.#wasm, this.#wasm.restrip_last_triangles(this.#page, after), Uint32Array, 3).slice();
    return { ...told, trianglesBefore: triangles(0), trianglesAfter: triangles(1) };
  }
}
