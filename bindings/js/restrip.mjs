// restrip for JavaScript: maintains triangle strips while a mesh changes. restrip.d.ts is the manual.
//
// The library is one WebAssembly module without imports. Lists are copied in as arguments; the index buffer is a view of
// the module's memory.
import { compiled } from './module.mjs';
import { Points } from './points.mjs';
import { Records } from './records.mjs';

const families = ['split', 'collapse', 'open-split', 'open-collapse', 'boundary-split', 'boundary-collapse', 'flip'];
const costs = { strips: { restart: 1, swap: 0, isolated: 0 }, indices: { restart: 3, swap: 1, isolated: 0 } };
const efforts = ['fast', 'full', 'best'];
const layouts = { cache: [32, 64], waste: [95, 1e6], work: [5, 100] };  // of LayoutOptions: the default, and the most
const forms = ['restart', 'stitched', 'lengths', 'list'];
export const restartIndex = 0xffffffff;
export const none = 0xffffffff;
const refusals = { noSuchEdge: 1, sameSpoke: 3, spokeOnBoundary: 6 };  // of Refusal, restrip/mesh/refusal.hpp

const figureNames = ['triangles', 'strips', 'bufferIndices', 'operations', 'addingStrip', 'isolating', 'baked', 'lastStrips', 'lastIsolated'];

/// Compiles the module: its bytes, or where to fetch it from; by default the file next to this one.
export async function load(source = new URL('./restrip.wasm', import.meta.url)) {
  const instance = await WebAssembly.instantiate(await compiled(source), {});
  instance.exports._initialize();
  const { memory, __stack_pointer: stack, restrip_stopped_because: reason, ...calls } = instance.exports;
  const top = stack.value;
  // A number of WebAssembly is signed; ours are addresses, some above 2 GB, and counts. A call that was stopped says why.
  const called = (call) => (...values) => {
    try {
      return call(...values) >>> 0;
    } catch (error) {
      stack.value = top;
      const why = reason() >>> 0;
      throw why === 0 ? error : new Error(textAt({ memory }, why).replace(/^restrip: /, ''));
    }
  };
  return new Restrip({ memory, ...Object.fromEntries(Object.entries(calls).map(([name, call]) => [name, called(call)])) });
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

/// What an object here has there: a mesh, or a mesh that is being simplified; 0 if it does not.
function holding(wasm, held) { return { wasm, page: 0, simplifier: 0, ...held }; }
function release(held) {
  const { wasm, page, simplifier } = held;
  Object.assign(held, { page: 0, simplifier: 0 });
  if (page !== 0) wasm.restrip_close(page);
  if (simplifier !== 0) wasm.restrip_close(wasm.restrip_simplify_end(simplifier));
}
/// Releases what objects held that a program can no longer reach and did not close.
const unreachable = new FinalizationRegistry(release);
/// Copies the arrays into the module's memory for the time of the call.
function withArrays(wasm, arrays, call) {
  const places = [];
  try {
    for (const { byteLength } of arrays) places.push(taken(wasm, byteLength));
    arrays.forEach((array, n) => new array.constructor(wasm.memory.buffer, places[n], array.length).set(array));
    return call(...places);
  } finally {
    places.forEach((place) => wasm.restrip_give_back(place));
  }
}
function bytesOf(bytes) {
  return ArrayBuffer.isView(bytes) ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) : new Uint8Array(bytes);
}

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
    return this.#opened(this.#with([corners, records],
      (b, s) => this.#wasm.restrip_open(count, b, corners.length / 3, s, records.length / 4)), places);
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
    const view = bytesOf(bytes);
    const page = this.#accepted('baked mesh', this.#with([view], (b) => this.#wasm.restrip_open_baked(b, view.length)));
    return this.#opened(page, this.#list(this.#wasm.restrip_baked_points(page), Float32Array, 3).slice());
  }
  /// A mesh that was saved, with the points of its vertices.
  saved(bytes, options) {
    const { points, history = 0 } = known('saved', options, ['points', 'history']);
    const [view, places] = [bytesOf(bytes), coordinates(points)];
    const page = this.#with([view], (b) => this.#wasm.restrip_open_saved(b, view.length, places.length / 3, whole('history', history)));
    return new StripMesh(this.#wasm, this.#accepted(`saved mesh with ${places.length / 3} points`, page), places, history);
  }
  #accepted(what, page) {
    const damage = textAt(this.#wasm, this.#wasm.restrip_damage(page));
    if (damage === '') return page;
    this.#wasm.restrip_close(page);
    throw new Error(`${what}: ${damage}`);
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
  #with(arrays, call) { return withArrays(this.#wasm, arrays, call); }
  #list(address, Type, width = 1) { return listAt(this.#wasm, address, Type, width); }
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
  #points;
  #records;
  #begun;
  #history;  // whether frames can be undone
  #left = false;  // single operations have changed the mesh since begin()
  #leftAt = Infinity;  // the frame in which they began; none that can be redone has them
  #fresh = true;  // not updated yet
  #updates = 0;
  #indicesWritten = 0;
  #last = null;

  /// `history`: of a mesh that was saved, which has begun.
  constructor(wasm, page, places, history) {
    this.#wasm = wasm;
    this.#held = holding(wasm, { page });
    unreachable.register(this, this.#held);
    this.#points = new Points(places);
    this.#records = new Records(this.#list(wasm.restrip_needs(page, 1)).slice(), this.#list(wasm.restrip_needs(page, 0)).slice());
    this.levels = wasm.restrip_levels(page);
    this.#begun = history !== undefined;
    this.#history = history > 0;
  }
  /// Three coordinates a vertex.
  get points() { return this.#points.all; }
  #list(address, Type = Uint32Array, width = 1) { return listAt(this.#wasm, address, Type, width); }
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

  get splits() { return this.#list(this.#wasm.restrip_splits(this.#open), Uint32Array, 4).slice(); }
  get leftOut() {
    const count = (what) => this.#wasm.restrip_left_out(this.#open, what);
    return { triangles: count(0), nonManifoldVertices: count(1), boundaryEdges: count(2) };
  }

  get hasBakedStrips() { return this.#wasm.restrip_baked_points(this.#open) !== 0; }

  begin(options = {}) {
    const { policy = 'quick', cost = 'indices', form = 'restart', bits = 32, history = 0, layout = {} } =
      known('begin', options, ['policy', 'cost', 'form', 'bits', 'history', 'layout']);
    if (!forms.includes(form)) throw new RangeError(`unknown form ${quoted(form)}: expected one of ${forms.join(', ')}`);
    if (![16, 32, 'auto'].includes(bits)) throw new RangeError(`bits is ${quoted(bits)}; it must be 16, 32 or 'auto'`);
    if (bits === 16 && this.points.length > 3 * 0xffff) throw new RangeError('16 bits do not name all vertices; leave it to bits: \'auto\'');
    const page = this.#open;
    if (policy === 'baked' && !this.hasBakedStrips) throw new RangeError('this mesh has no baked strips; open the file of a baked mesh');
    const kept = policy === 'baked' ? [none, 0, 0, 0] : this.#policy(policy, cost, ', or baked for baked meshes');
    const given = known('layout', layout, Object.keys(layouts));
    const placed = Object.entries(layouts).map(([name, [usual, most]]) => whole(`layout.${name}`, given[name] ?? usual, most));
    this.#wasm.restrip_begin(page, this.points.length / 3, ...kept, forms.indexOf(form), bits === 'auto' ? 0 : bits, whole('history', history), ...placed);
    this.#begun = this.#fresh = true;
    this.#history = history > 0;
    this.#records.reset();
    this.#points = new Points(this.points);
    this.#left = false;
    this.#leftAt = Infinity;
    this.#updates = this.#indicesWritten = 0;
    this.#last = null;
    return this;
  }
  /// The number of the policy, and the weights of the cost. `more`: that is expected elsewhere.
  #policy(policy, cost, more = '') {
    const policies = policiesOf(this.#wasm);
    if (policies.includes(policy)) return [policies.indexOf(policy), ...weights(cost)];
    throw new RangeError(`unknown policy ${quoted(policy)}: expected one of ${policies.join(', ')}${more}`);
  }
  keep(options = {}) {
    const { policy = 'quick', cost = 'indices' } = known('keep', options, ['policy', 'cost']);
    this.#wasm.restrip_keep(this.#kept, ...this.#policy(policy, cost));
  }
  recolor(options = {}) {
    const { effort = 'fast', cost = 'indices' } = known('recolor', options, ['effort', 'cost']);
    if (!efforts.includes(effort)) throw new RangeError(`unknown effort ${quoted(effort)}: expected one of ${efforts.join(', ')}`);
    const page = this.#kept;
    this.#last = null;
    return this.#wasm.restrip_recolor(page, efforts.indexOf(effort), ...weights(cost));
  }
  improve(budget) { return this.#wasm.restrip_improve(this.#kept, whole('the budget', budget)); }

  /// The records, while the mesh is made of them: after split(), collapse() or flip() they no longer fit it.
  get #inRecords() {
    void this.#kept;
    if (this.#left) throw new Error('single operations have changed the mesh since begin(), so its records do not fit it; undo them, or call begin() again');
    return this.#records;
  }
  moveTo(level, most = none) {
    return this.#play(this.#inRecords.toLevel(whole('the level', level, this.levels), limit(most)));
  }
  approach(wanted, most = none) {
    if (wanted?.length !== this.levels)
      throw new RangeError(`there are ${String(wanted?.length ?? 'no')} marks; there must be one for each of the ${this.levels} records`);
    return this.#play(this.#inRecords.towards(wanted, limit(most)));
  }
  /// Does the operations of a plan, and describes the last one.
  #play(plan) {
    if (plan.length === 0) return 0;
    const [wasm, page, before] = [this.#wasm, this.#kept, plan.length - 1];
    this.#leftAt = Infinity;
    withArrays(wasm, [Uint32Array.from(plan)], (place) => {
      wasm.restrip_play(page, place, before);
      const last = () => wasm.restrip_play(page, place + 4 * before, 1);
      const [vS, vT, vL, vR] = this.#list(wasm.restrip_splits(page), Uint32Array, 4).slice(4 * plan[before], 4 * plan[before] + 4);
      if (this.#records.isSplit(plan[before])) this.#splitBy(last, vS, vT, vL, vR);
      else this.#collapseBy(last, vS, vT);
    });
    return plan.length;
  }
  // The operations with their patches before and after, for `last`.
  #patch(address) { return address === 0 ? new Uint32Array(7) : this.#list(address).slice(); }
  #described(kind, operation, before, after) {
    const patch = this.#patch(before());
    const refusal = operation();
    if (refusal === 0) this.#last = { kind, before: patch, after: this.#patch(after()) };
    return refusal;
  }
  #splitBy(operation, vS, vT, vL, vR) {
    const [wasm, page] = [this.#wasm, this.#kept];
    return this.#described('split', operation, () => wasm.restrip_fan(page, vS, vL, vR), () => wasm.restrip_ring(page, vS, vT));
  }
  #collapseBy(operation, vS, vT) {
    const [wasm, page] = [this.#wasm, this.#kept];
    const [vL, vR] = [wasm.restrip_apex(page, vS, vT), wasm.restrip_apex(page, vT, vS)];
    return this.#described('collapse', operation, () => wasm.restrip_ring(page, vS, vT), () => wasm.restrip_fan(page, vS, vL, vR));
  }
  split(vS, vT, vL, vR) {
    // The new vertex must have a point; of the others the library says whether the mesh has them.
    whole('vT', vT, this.points.length / 3 - 1);
    const [wasm, page] = [this.#wasm, this.#kept];
    const sides = [vL, vR].filter((v) => v !== none);
    for (const [name, v] of Object.entries({ vS, vL, vR })) whole(name, v);
    return this.#outcome(this.#splitBy(() => wasm.restrip_split(page, vS, vT, vL, vR), vS, vT, vL, vR), `vertex ${vS} cannot be split`, {
      [refusals.noSuchEdge]: `vertex ${vS} has no edge to ${sides.join(' or to ') || '`none`'}`,
      [refusals.sameSpoke]: `vertex ${vS} needs two edges, but vL and vR are both ${vL}`,
      [refusals.spokeOnBoundary]: `vertex ${vS} is not on the boundary, so neither vL nor vR may be \`none\`` });
  }
  collapse(vS, vT) {
    const [wasm, page] = [this.#wasm, this.#kept];
    for (const [name, v] of Object.entries({ vS, vT })) whole(name, v);
    return this.#atEdge(this.#collapseBy(() => wasm.restrip_collapse(page, vS, vT), vS, vT), vS, vT, 'collapsed');
  }
  flip(u, v) {
    const [wasm, page] = [this.#wasm, this.#kept];
    const at = (from, to) => [from, to, wasm.restrip_apex(page, whole('u', from), whole('v', to))];
    const [before, back] = [at(u, v), at(v, u)];
    const refusal = wasm.restrip_flip(page, u, v);
    if (refusal === 0) {
      const [l, r] = [before[2], back[2]];
      const quad = (...corners) => Uint32Array.from([...new Uint32Array(7), ...corners.flat()]);
      this.#last = { kind: 'flip', before: quad(before, back), after: quad(at(l, r), at(r, l)) };
    }
    return this.#atEdge(refusal, u, v, 'flipped');
  }
  bisect(u, v) {
    return this.#added((page) => this.#atEdge(this.#wasm.restrip_bisect(page, whole('u', u), whole('v', v)), u, v, 'bisected'), [u, v]);
  }
  splitFace(a, b, c) {
    return this.#added((page) => this.#outcome(this.#wasm.restrip_split_face(page, whole('a', a), whole('b', b), whole('c', c)),
      `the triangle ${a}, ${b}, ${c} cannot be split`, { [refusals.noSuchEdge]: `no triangle has the corners ${a}, ${b}, ${c} in this order` }), [a, b, c]);
  }
  /// Why an index cannot be this vertex; null if it can.
  #cannotName(v) {
    return this.#begun && this.#wasm.restrip_can_name(this.#open, v) === 0 ? `16 bits cannot name vertex ${v.toLocaleString('en')}; begin with bits 'auto'` : null;
  }
  /// An operation with a new vertex, between others.
  #added(operation, corners) {
    const page = this.#kept;
    const reason = this.#cannotName(this.#wasm.restrip_next_vertex(page));
    if (reason !== null) return { ok: false, reason };
    const outcome = operation(page);
    if (!outcome.ok) return outcome;
    this.#last = null;
    const vertex = this.#wasm.restrip_new_vertex(page);
    const middle = [0, 1, 2].map((x) => corners.reduce((sum, v) => sum + this.points[3 * v + x], 0) / corners.length);
    this.#points.put(vertex, middle, this.#frame);
    return { ok: true, vertex };
  }
  /// The number of the present frame; null without a history.
  get #frame() { return this.#begun && this.#history ? this.#list(this.#wasm.restrip_frames(this.#open))[2] : null; }
  /// `fault`: what cannot be done, by its vertices. `sentences`, by refusal: in place of the library's that speak of halfedges.
  #outcome(refusal, fault, sentences) {
    if (refusal === 0) {
      if (!this.#left) this.#leftAt = this.#frame ?? Infinity;
      this.#left = true;
      return { ok: true };
    }
    return { ok: false, reason: sentences[refusal] ?? `${fault}: ${textAt(this.#wasm, this.#wasm.restrip_describe(refusal))}` };
  }
  #atEdge(refusal, u, v, done) {
    return this.#outcome(refusal, `the edge from ${u} to ${v} cannot be ${done}`, { [refusals.noSuchEdge]: `no triangle has a side between ${u} and ${v}` });
  }

  around(v) { return this.#list(this.#wasm.restrip_around(this.#kept, whole('v', v))).slice(); }
  get ready() {
    void this.#kept;
    return this.#records.ready;
  }

  addPoint(x, y, z) {
    const place = coordinates([x, y, z]);
    void this.#open;
    const v = this.points.length / 3;
    const refused = this.#cannotName(v);
    if (refused !== null) throw new RangeError(refused);
    this.#points.put(v, place, this.#frame);
    return v;
  }
  setPoint(v, x, y, z) {
    const place = coordinates([x, y, z]);
    void this.#open;
    this.#points.set(whole('v', v, this.points.length / 3 - 1), place);
  }

  undo() { return this.#step(false); }
  redo() { return this.#step(true); }
  #step(forward) {
    if (this.#wasm.restrip_step(this.#kept, forward ? 1 : 0) === 0) return false;
    const frame = this.#frame;
    this.#points.step(frame, forward);
    this.#records.reset(this.#list(this.#wasm.restrip_played(this.#kept), Uint8Array).slice());
    this.#left = this.#leftAt < frame;
    this.#last = null;
    return true;
  }
  get history() {
    const [undoable, redoable] = this.#list(this.#wasm.restrip_frames(this.#kept));
    return { undoable, redoable };
  }
  save() { return this.#list(this.#wasm.restrip_save(this.#kept), Uint8Array).slice(); }

  update(options = {}) {
    const { join = 2, align = 4 } = known('update', options, ['join', 'align']);
    if (align !== 2 && (whole('align', align) === 0 || align % 4 !== 0)) throw new RangeError(`align is ${align}; it must be 2 or a multiple of 4`);
    const address = this.#wasm.restrip_update(this.#kept, whole('join', join), align);
    let outgrown = new Uint32Array(this.#wasm.memory.buffer, address, 3)[2] === 1;
    let ranges = this.#ranges(address);
    if (this.#fresh) {
      const count = this.indices.length;
      [ranges, outgrown] = [count === 0 ? [] : [{ first: 0, count }], true];
    } else this.#indicesWritten += ranges.reduce((sum, { count }) => sum + count, 0);
    this.#fresh = false;
    ++this.#updates;
    if (this.#history) this.#points.forget(this.#frame - this.history.undoable);
    return Object.assign(ranges, { outgrown });
  }
  get room() { return this.#wasm.restrip_room(this.#kept); }
  get draws() { return this.#ranges(this.#wasm.restrip_draws(this.#kept)); }
  fromScratch(options = {}) {
    const { cost = 'indices', cacheSize = 0, cacheWeight = 0 } = known('fromScratch', options, ['cost', 'cacheSize', 'cacheWeight']);
    const size = whole('cacheSize', cacheSize, 1e6);
    if (!(typeof cacheWeight === 'number' && cacheWeight >= 0 && cacheWeight <= 1000))
      throw new RangeError(`cacheWeight must be a number from 0 to 1000, not ${quoted(cacheWeight)}`);
    return this.#list(this.#wasm.restrip_from_scratch(this.#kept, ...weights(cost), size, cacheWeight), Uint32Array, 1).slice();
  }
  #ranges(address) {
    const flat = this.#list(address, Uint32Array, 2);
    const ranges = [];
    for (let i = 0; i < flat.length; i += 2) ranges.push({ first: flat[i], count: flat[i + 1] });
    return ranges;
  }
  get indices() {
    const [data, bytes] = new Uint32Array(this.#wasm.memory.buffer, this.#wasm.restrip_indices(this.#kept), 2);
    const Type = this.#wasm.restrip_index_bytes(this.#held.page) === 2 ? Uint16Array : Uint32Array;
    return bytes === 0 ? new Type(0) : new Type(this.#wasm.memory.buffer, data, bytes / Type.BYTES_PER_ELEMENT);
  }
  get triangles() { return this.#list(this.#wasm.restrip_triangles(this.#kept), Uint32Array, 3).slice(); }

  get figures() {
    const raw = new Uint32Array(this.#wasm.memory.buffer, this.#wasm.restrip_figures(this.#kept), figureNames.length);
    const { lastStrips, lastIsolated, ...figures } = Object.fromEntries(figureNames.map((name, n) => [name, raw[n]]));
    return { ...figures, bufferIndices: figures.bufferIndices === none ? null : figures.bufferIndices, baked: figures.baked === 1,
      played: this.#records.count, inOrder: this.#records.inOrder, updates: this.#updates, indicesWritten: this.#indicesWritten };
  }
  get plainIndices() { return this.#wasm.restrip_plain_indices(this.#kept); }
  get valid() { return this.#wasm.restrip_valid(this.#kept) === 1; }

  get ribbon() { return this.#list(this.#wasm.restrip_ribbon(this.#kept, 0), Uint32Array, 9).slice(); }
  get scratchRibbon() { return this.#list(this.#wasm.restrip_ribbon(this.#kept, 1), Uint32Array, 9).slice(); }
  pick(from, along) {
    for (const [what, place] of [['from', from], ['along', along]])
      if (place?.length !== 3 || ![...place].every(Number.isFinite)) throw new RangeError(`${what} must be three finite numbers`);
    const [{ triangles, points }, minus] = [this, (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]]];
    const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const point = (v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
    let nearest = Infinity;
    for (let t = 0; t < triangles.length; t += 3) {
      // The distance along the ray (Moller and Trumbore 1997).
      const a = point(triangles[t]);
      const [e, f, s] = [minus(point(triangles[t + 1]), a), minus(point(triangles[t + 2]), a), minus(from, a)];
      const [p, q] = [cross(along, f), cross(s, e)];
      const determinant = dot(e, p);
      const [u, v, distance] = [dot(s, p), dot(along, q), dot(f, q)].map((each) => each / determinant);
      if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest) nearest = distance;
    }
    return nearest === Infinity ? null : [0, 1, 2].map((x) => from[x] + nearest * along[x]);
  }
  get last() {
    void this.#kept;
    if (this.#last === null) return null;
    const { kind, before, after } = this.#last;
    const [strips, isolated] = new Int32Array(this.#wasm.memory.buffer, this.#wasm.restrip_figures(this.#open), figureNames.length).slice(-2);
    const mask = (patch, at) => BigInt(patch[at + 1]) << 32n | BigInt(patch[at]);
    return { kind, closed: before[0] === 1 && after[0] === 1, k: before[1], a: before[2], before: mask(before, 3), ports: mask(before, 5),
      after: mask(after, 3), portsAfter: mask(after, 5), strips, isolated, trianglesBefore: before.slice(7), trianglesAfter: after.slice(7) };
  }
}
