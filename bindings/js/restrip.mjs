// restrip for JavaScript: maintains triangle strips while a mesh changes. restrip.d.ts is the manual.
//
// The library is one WebAssembly module without imports. Lists are copied in as arguments; the index buffer is a view of
// the module's memory.
import { compiled } from './module.mjs';

const families = ['split', 'collapse', 'open-split', 'open-collapse', 'boundary-split', 'boundary-collapse', 'flip'];
const costs = { strips: { restart: 1, swap: 0, isolated: 0 }, indices: { restart: 3, swap: 1, isolated: 0 } };
const forms = ['restart', 'stitched', 'lengths', 'list'];
export const restartIndex = 0xffffffff;
export const none = 0xffffffff;
const refusals = { noSuchEdge: 1, sameSpoke: 3, spokeOnBoundary: 6 };  // of Refusal, restrip/mesh/refusal.hpp

const figureNames = ['triangles', 'strips', 'played', 'inOrder', 'bufferIndices', 'operations', 'addingStrip',
  'isolating', 'refused', 'indicesWritten', 'updates', 'baked'];

export const small = new URL('./restrip-small.wasm', import.meta.url);

/// Compiles the module: its bytes, or where to fetch it from; by default the file next to this one.
export async function load(source = new URL('./restrip.wasm', import.meta.url)) {
  const instance = await WebAssembly.instantiate(await compiled(source), {});
  instance.exports._initialize();
  // A number of WebAssembly is signed; ours are addresses, some above 2 GB, and counts.
  const unsigned = (call) => (typeof call === 'function' ? (...values) => call(...values) >>> 0 : call);
  return new Restrip(Object.fromEntries(Object.entries(instance.exports).map(([name, each]) => [name, unsigned(each)])));
}

// ---- arguments: checked against the manual; an error has one sentence

/// As it is written in a program: strings in quotes, 5n.
function quoted(value) {
  return typeof value === 'string' ? `'${value}'` : typeof value === 'bigint' ? `${value}n` : String(value);
}
/// The options given, without others than `names`.
function known(what, options, names) {
  const other = Object.keys(options).find((name) => !names.includes(name));
  if (other === undefined) return options;
  throw new RangeError(`${what} has no option ${quoted(other)}: expected ${names.join(', ')}`);
}
/// A whole number from 0 to `most`.
function whole(what, n, most = 0xffffffff) {
  if (Number.isInteger(n) && n >= 0 && n <= most) return n;
  throw new RangeError(`${what} is ${quoted(n)}; it must be a whole number from 0 to ${most}`);
}
/// The largest number of operations; without a limit more than any mesh has.
function limit(most) {
  if (typeof most === 'number' && most >= 0) return Math.min(Math.floor(most), 0xffffffff);
  throw new RangeError(`the number of operations is ${quoted(most)}; it must be 0 or more`);
}
/// `width` numbers for each item.
function groups(what, list, width) {
  if (typeof list?.length !== 'number' || list.length % width !== 0)
    throw new RangeError(`${what}: ${list?.length === undefined ? 'no list' : `${list.length} numbers`}; they must be ${width} for each`);
  return list.length / width;
}
function coordinates(list) {
  groups('points', list, 3);
  const out = Float32Array.from(list);
  const wrong = out.findIndex((coordinate) => !Number.isFinite(coordinate));
  if (wrong >= 0) throw new RangeError(`points: vertex ${Math.floor(wrong / 3)} has the coordinate ${quoted(list[wrong])}, which no float can hold`);
  return out;
}
/// Vertices, `width` for each `what`; `or`: a number that may stand for none of them.
function vertices(what, list, width, count, or = NaN) {
  groups(what, list, width);
  for (let i = 0; i < list.length; ++i)
    if (!(Number.isInteger(list[i]) && list[i] >= 0 && list[i] < count) && list[i] !== or)
      throw new RangeError(`${what} ${Math.floor(i / width)} names vertex ${quoted(list[i])}; there are ${count}`);
  return Uint32Array.from(list);
}
function weights(cost) {
  const own = typeof cost === 'string' && Object.hasOwn(costs, cost) ? costs[cost] : cost;
  if (typeof own !== 'object' || own === null)
    throw new RangeError(`unknown cost ${quoted(cost)}: expected ${Object.keys(costs).join(', ')} or custom weights`);
  const { restart, swap, isolated = 0 } = own;
  return Object.entries({ restart, swap, isolated }).map(([name, weight]) => whole(`the weight ${name}`, weight, 1000));
}
function mask(what, bits) {
  const out = BigInt(bits);
  if (BigInt.asUintN(64, out) !== out) throw new RangeError(`${what} is ${out}; it must have bits 0 to 63 only`);
  return out;
}

// ---- memory of the module

/// What an object here has there: a mesh, marks of its records, a mesh that is being simplified; 0 if it does not.
function holding(wasm, held) { return { wasm, page: 0, marks: 0, simplifier: 0, ...held }; }
function release(held) {
  const { wasm, page, marks, simplifier } = held;
  Object.assign(held, { page: 0, marks: 0, simplifier: 0 });
  if (marks !== 0) wasm.restrip_give_back(marks);
  if (page !== 0) wasm.restrip_close(page);
  if (simplifier !== 0) wasm.restrip_close(wasm.restrip_simplify_end(simplifier));
}
/// Releases what objects held that a program can no longer reach and did not close.
const unreachable = new FinalizationRegistry(release);

export class Restrip {
  #wasm;

  constructor(wasm) {
    this.#wasm = wasm;
  }

  /// A progressive mesh.
  progressive({ points, base, splits }) {
    const places = coordinates(points);
    const count = places.length / 3;
    const corners = vertices('triangle', base, 3, count);
    const records = vertices('record', splits, 4, count, none);
    return this.#opened(this.#with([places, corners, records],
      (p, b, s) => this.#wasm.restrip_open(p, count, b, corners.length / 3, s, records.length / 4)), places);
  }
  /// A mesh without records.
  mesh({ points, triangles }) { return this.progressive({ points, base: triangles, splits: [] }); }
  /// A mesh, simplified here to `share` of its triangles.
  simplified(source, share) {
    const steps = this.simplifying(source, share);
    for (;;) {
      const { done, value } = steps.next();
      if (done) return value;
    }
  }
  /// The same in steps of some thousand attempts.
  simplifying({ points, triangles }, share = 0.02) {
    if (!(share >= 0 && share <= 1)) throw new RangeError(`share is ${quoted(share)}; it must be from 0 to 1`);
    const places = coordinates(points);
    const count = places.length / 3;
    const corners = vertices('triangle', triangles, 3, count);
    const wanted = Math.max(4, Math.round(corners.length / 3 * share));
    const simplifier = this.#with([places, corners], (p, t) => this.#wasm.restrip_simplify_begin(p, count, t, corners.length / 3));
    const held = holding(this.#wasm, { simplifier });
    const steps = this.#collapses(held, places, wanted, Math.max(1, corners.length / 3 - wanted));
    unreachable.register(steps, held);
    return steps;
  }
  *#collapses(held, places, wanted, all) {
    try {
      for (let left; (left = this.#wasm.restrip_simplify_run(held.simplifier, wanted, 1000)) > 0;) yield 1 - left / all;
      const page = this.#wasm.restrip_simplify_end(held.simplifier);
      held.simplifier = 0;
      return this.#opened(page, places);
    } finally {
      release(held);  // the caller has stopped early
    }
  }

  /// A baked mesh, from the bytes of its file.
  baked(bytes) {
    const view = ArrayBuffer.isView(bytes) ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) : new Uint8Array(bytes);
    const page = this.#with([view], (b) => this.#wasm.restrip_open_baked(b, view.length));
    const damage = textAt(this.#wasm, this.#wasm.restrip_damage(page));
    if (damage !== '') {
      this.#wasm.restrip_close(page);
      throw new Error(`baked mesh: ${damage}`);
    }
    return this.#opened(page, this.#list(this.#wasm.restrip_points(page), Float32Array).slice());
  }

  /// The rule of a configuration.
  rule({ family, k = 0, a = 0, i = 0, j = 0, edges, ports }) {
    const number = families.indexOf(family);
    if (number < 0) throw new RangeError(`unknown family ${quoted(family)}: expected one of ${families.join(', ')}`);
    const x = number < 2 ? whole('a', a) : whole('i', i);
    const solid = mask('ports', ports);
    const [valid, strips, low, high, kept] =
      this.#list(this.#wasm.restrip_rule(number, whole('k', k), x, whole('j', j), mask('edges', edges), solid), Uint32Array);
    return { valid: valid === 1, strips: strips | 0, colors: BigInt(high) << 32n | BigInt(low),
      ports: family === 'flip' ? BigInt(kept) : solid };
  }

  #opened(page, points) {
    const mesh = new StripMesh(this.#wasm, page, points);
    const refused = this.#wasm.restrip_refused_record(page);
    if (refused !== none) {
      mesh.close();
      throw new Error(`split ${refused} of the progressive mesh cannot be done; all before it can`);
    }
    return mesh;
  }
  /// Copies the arrays into the module's memory for the time of the call.
  #with(arrays, call) {
    const places = [];
    try {
      for (const { byteLength } of arrays) places.push(taken(this.#wasm, byteLength));
      arrays.forEach((array, n) => new array.constructor(this.#wasm.memory.buffer, places[n], array.length).set(array));
      return call(...places);
    } finally {
      places.forEach((place) => this.#wasm.restrip_give_back(place));
    }
  }
  #list(address, Type) {
    return listAt(this.#wasm, address, Type, 1);
  }
}

function taken(wasm, bytes) {
  const place = wasm.restrip_take(Math.max(bytes, 1));
  if (place === 0) throw new RangeError(`out of memory: ${bytes} bytes more cannot be had`);
  return place;
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
  #held;
  #levels;
  #begun = false;
  #bits = 32;
  #store;  // points, and room for more
  /// Three coordinates a vertex.
  points;

  constructor(wasm, page, points) {
    this.#wasm = wasm;
    this.#held = holding(wasm, { page });
    unreachable.register(this, this.#held);
    this.points = this.#store = points;
    this.#levels = wasm.restrip_levels(page);
  }
  close() { release(this.#held); }
  [Symbol.dispose ?? Symbol.for('Symbol.dispose')]() { this.close(); }

  /// The mesh in the module's memory.
  get #open() {
    if (this.#held.page === 0) throw new Error('this mesh is closed: close() gave its memory back');
    return this.#held.page;
  }
  /// The same, with strips.
  get #kept() {
    if (!this.#begun && this.#held.page !== 0) throw new Error('this mesh has no strips yet; call begin() first');
    return this.#open;
  }

  get levels() { return this.#levels; }
  get splits() { return listAt(this.#wasm, this.#wasm.restrip_splits(this.#open), Uint32Array, 4).slice(); }
  get leftOut() {
    const count = (what) => this.#wasm.restrip_left_out(this.#open, what);
    return { triangles: count(0), nonManifoldVertices: count(1), boundaryEdges: count(2) };
  }

  get hasBakedStrips() { return this.#wasm.restrip_has_baked_strips(this.#open) === 1; }

  begin(options = {}) {
    const { policy = 'quick', cost = 'indices', form = 'restart', bits = 32 } = known('begin', options, ['policy', 'cost', 'form', 'bits']);
    if (!forms.includes(form)) throw new RangeError(`unknown form ${quoted(form)}: expected one of ${forms.join(', ')}`);
    if (![16, 32, 'auto'].includes(bits)) throw new RangeError(`bits is ${quoted(bits)}; it must be 16, 32 or 'auto'`);
    if (bits === 16 && this.points.length > 3 * 0xffff) throw new RangeError('16 bits do not name all vertices; leave it to bits: \'auto\'');
    const page = this.#open;
    const policies = policiesOf(this.#wasm);
    const number = policies.indexOf(policy);
    if (policy === 'baked' && !this.hasBakedStrips) throw new RangeError('this mesh has no baked strips; open the file of a baked mesh');
    if (policy !== 'baked' && number < 0)
      throw new RangeError(`unknown policy ${quoted(policy)}: expected one of ${policies.join(', ')}, or baked for baked meshes`);
    const wanted = policy === 'baked' ? null : weights(cost);
    const format = [forms.indexOf(form), bits === 'auto' ? 0 : bits];
    if (wanted === null) this.#wasm.restrip_begin_baked(page, ...format);
    else this.#wasm.restrip_begin(page, ...format, number, ...wanted);
    this.#bits = bits;
    this.#begun = true;
    return this;
  }
  /// The same, at a level: after split(), collapse() or flip() records no longer fit the mesh.
  get #inRecords() {
    if (this.#wasm.restrip_left_records(this.#kept) === 1)
      throw new Error('single operations have changed the mesh since begin(), so its records do not fit it; call begin() again');
    return this.#kept;
  }
  moveTo(level, most = 0xffffffff) {
    return this.#wasm.restrip_move(this.#inRecords, whole('the level', level, this.#levels), limit(most));
  }
  approach(wanted, most = 0xffffffff) {
    if (wanted?.length !== this.#levels)
      throw new RangeError(`there are ${String(wanted?.length ?? 'no')} marks; there must be one for each of the ${this.#levels} records`);
    const page = this.#inRecords;
    this.#held.marks ||= taken(this.#wasm, this.#levels);
    new Uint8Array(this.#wasm.memory.buffer, this.#held.marks, this.#levels).set(wanted);
    return this.#wasm.restrip_approach(page, this.#held.marks, limit(most));
  }
  split(vS, vT, vL, vR) {
    // The new vertex must have a point; of the others the library says whether the mesh has them.
    whole('vT', vT, this.points.length / 3 - 1);
    const sides = [vL, vR].filter((v) => v !== none);
    return this.#outcome(this.#wasm.restrip_split(this.#kept, whole('vS', vS), vT, whole('vL', vL), whole('vR', vR)), `vertex ${vS} cannot be split`, {
      [refusals.noSuchEdge]: `vertex ${vS} has no edge to ${sides.join(' or to ') || '`none`'}`,
      [refusals.sameSpoke]: `vertex ${vS} needs two edges, but vL and vR are both ${vL}`,
      [refusals.spokeOnBoundary]: `vertex ${vS} is not on the boundary, so neither vL nor vR may be \`none\`` });
  }
  collapse(vS, vT) { return this.#atEdge(this.#wasm.restrip_collapse(this.#kept, whole('vS', vS), whole('vT', vT)), vS, vT, 'collapsed'); }
  flip(u, v) { return this.#atEdge(this.#wasm.restrip_flip(this.#kept, whole('u', u), whole('v', v)), u, v, 'flipped'); }
  bisect(u, v) {
    return this.#added((page) => this.#atEdge(this.#wasm.restrip_bisect(page, whole('u', u), whole('v', v)), u, v, 'bisected'));
  }
  splitFace(a, b, c) {
    return this.#added((page) => this.#outcome(this.#wasm.restrip_split_face(page, whole('a', a), whole('b', b), whole('c', c)),
      `the triangle ${a}, ${b}, ${c} cannot be split`, { [refusals.noSuchEdge]: `no triangle has the corners ${a}, ${b}, ${c} in this order` }));
  }
  /// Why an index cannot be this vertex; null if it can.
  #cannotName(v) {
    return this.#begun && this.#bits === 16 && v >= 0xffff ? `16 bits cannot name vertex ${v.toLocaleString('en')}; begin with bits 'auto'` : null;
  }
  /// An operation with a new vertex.
  #added(operation) {
    const page = this.#kept;
    const reason = this.#cannotName(this.#wasm.restrip_next_vertex(page));
    if (reason !== null) return { ok: false, reason };
    const outcome = operation(page);
    if (!outcome.ok) return outcome;
    const vertex = this.#wasm.restrip_new_vertex(page);
    this.#readPoint(vertex);
    return { ok: true, vertex };
  }
  /// Copies the point of a vertex from the module; `points` is as long as the vertices then.
  #readPoint(v) {
    const all = listAt(this.#wasm, this.#wasm.restrip_points(this.#held.page), Float32Array, 1);
    if (all.length > this.#store.length) {
      const store = new Float32Array(2 * all.length);
      store.set(this.points);
      this.#store = store;
    }
    if (all.length !== this.points.length) this.points = this.#store.subarray(0, all.length);
    this.points.set(all.subarray(3 * v, 3 * v + 3), 3 * v);
  }
  /// `fault`: what cannot be done, by its vertices. `sentences`, by refusal: in place of the library's that speak of halfedges.
  #outcome(refusal, fault, sentences) {
    if (refusal === 0) return { ok: true };
    return { ok: false, reason: sentences[refusal] ?? `${fault}: ${textAt(this.#wasm, this.#wasm.restrip_describe(refusal))}` };
  }
  #atEdge(refusal, u, v, done) {
    return this.#outcome(refusal, `the edge from ${u} to ${v} cannot be ${done}`, { [refusals.noSuchEdge]: `no triangle has a side between ${u} and ${v}` });
  }

  around(v) { return listAt(this.#wasm, this.#wasm.restrip_around(this.#kept, whole('v', v)), Uint32Array, 1).slice(); }
  get ready() { return listAt(this.#wasm, this.#wasm.restrip_ready(this.#kept), Uint32Array, 1).slice(); }

  addPoint(x, y, z) {
    const place = coordinates([x, y, z]);
    const page = this.#open;
    const refused = this.#cannotName(this.points.length / 3);
    if (refused !== null) throw new RangeError(refused);
    const v = this.#wasm.restrip_add_point(page, ...place);
    this.#readPoint(v);
    return v;
  }
  setPoint(v, x, y, z) {
    const place = coordinates([x, y, z]);
    this.#wasm.restrip_set_point(this.#open, whole('v', v, this.points.length / 3 - 1), ...place);
    this.points.set(place, 3 * v);
  }

  update(options = {}) {
    const { join = 2, align = 4 } = known('update', options, ['join', 'align']);
    if (align !== 2 && (whole('align', align) === 0 || align % 4 !== 0)) throw new RangeError(`align is ${align}; it must be 2 or a multiple of 4`);
    const ranges = this.#ranges(this.#wasm.restrip_update(this.#kept, whole('join', join), align));
    return Object.assign(ranges, { outgrown: this.#wasm.restrip_outgrown(this.#held.page) === 1 });
  }
  get room() { return this.#wasm.restrip_room(this.#kept); }
  get draws() { return this.#ranges(this.#wasm.restrip_draws(this.#kept)); }
  updateList(options = {}) {
    const { whole: all = false } = known('updateList', options, ['whole']);
    return this.#ranges(this.#wasm.restrip_update_list(this.#kept, all ? 1 : 0));
  }
  get listIndices() { return listAt(this.#wasm, this.#wasm.restrip_list(this.#kept), Uint32Array, 1); }
  fromScratch(options = {}) {
    const { cost = 'indices', cacheSize = 0, cacheWeight = 0 } = known('fromScratch', options, ['cost', 'cacheSize', 'cacheWeight']);
    const size = whole('cacheSize', cacheSize, 1e6);
    if (!(typeof cacheWeight === 'number' && cacheWeight >= 0 && cacheWeight <= 1000))
      throw new RangeError(`cacheWeight must be a number from 0 to 1000, not ${quoted(cacheWeight)}`);
    return listAt(this.#wasm, this.#wasm.restrip_from_scratch(this.#kept, ...weights(cost), size, cacheWeight), Uint32Array, 1).slice();
  }
  #ranges(address) {
    const flat = listAt(this.#wasm, address, Uint32Array, 2);
    const ranges = [];
    for (let i = 0; i < flat.length; i += 2) ranges.push({ first: flat[i], count: flat[i + 1] });
    return ranges;
  }
  get indices() {
    const [data, bytes] = new Uint32Array(this.#wasm.memory.buffer, this.#wasm.restrip_indices(this.#kept), 2);
    const Type = this.#wasm.restrip_index_bytes(this.#held.page) === 2 ? Uint16Array : Uint32Array;
    return bytes === 0 ? new Type(0) : new Type(this.#wasm.memory.buffer, data, bytes / Type.BYTES_PER_ELEMENT);
  }
  get triangles() { return listAt(this.#wasm, this.#wasm.restrip_triangles(this.#kept), Uint32Array, 3).slice(); }

  get figures() {
    const raw = new Uint32Array(this.#wasm.memory.buffer, this.#wasm.restrip_figures(this.#kept), figureNames.length);
    const figures = Object.fromEntries(figureNames.map((name, n) => [name, raw[n]]));
    for (const flag of ['inOrder', 'baked']) figures[flag] = figures[flag] === 1;
    if (figures.bufferIndices === none) figures.bufferIndices = null;
    return figures;
  }
  get plainIndices() { return this.#wasm.restrip_plain_indices(this.#kept); }
  get indexBound() { return this.#wasm.restrip_index_bound(this.#kept); }
  get valid() { return this.#wasm.restrip_valid(this.#kept) === 1; }

  get ribbon() { return listAt(this.#wasm, this.#wasm.restrip_ribbon(this.#kept, 0), Uint32Array, 9).slice(); }
  get scratchRibbon() { return listAt(this.#wasm, this.#wasm.restrip_ribbon(this.#kept, 1), Uint32Array, 9).slice(); }
  pick(from, along) {
    for (const [what, place] of [['from', from], ['along', along]])
      if (place?.length !== 3 || ![...place].every(Number.isFinite)) throw new RangeError(`${what} must be three finite numbers`);
    const hit = listAt(this.#wasm, this.#wasm.restrip_pick(this.#kept, ...from, ...along), Float32Array, 1);
    return hit.length === 0 ? null : Array.from(hit);
  }
  get last() {
    const n = listAt(this.#wasm, this.#wasm.restrip_last(this.#kept), Uint32Array, 1);
    if (n[0] === 0) return null;
    const mask = (at) => BigInt(n[at + 1]) << 32n | BigInt(n[at]);
    const operation = { kind: families[[0, 0, 1, 6][n[0]]], closed: n[1] === 1, k: n[2], a: n[3],
      before: mask(4), ports: mask(6), after: mask(8), portsAfter: mask(10), strips: n[12] | 0, isolated: n[13] | 0 };
    const triangles = (after) =>
      listAt(this.#wasm, this.#wasm.restrip_last_triangles(this.#kept, after), Uint32Array, 3).slice();
    return { ...operation, trianglesBefore: triangles(0), trianglesAfter: triangles(1) };
  }
}
