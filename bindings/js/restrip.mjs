// restrip for JavaScript: maintains triangle strips while a mesh changes. restrip.d.ts is the manual.
//
// The library is one WebAssembly module without imports, the C interface (library.mjs). Lists are copied in as arguments;
// the index buffer is a view of the module's memory.
import { absent, coordinates, known, limit, lists, mask, oneOf, point, quoted, vertices, weights, whole } from './arguments.mjs';
import { Library } from './library.mjs';
import { bytesOf, compiled } from './module.mjs';
import { triangleOf, Walks } from './patches.mjs';
import { Points } from './points.mjs';
import { Records } from './records.mjs';

export const none = absent;
export const restartIndex = 0xffffffff;

// The words of the manual, in the order of the numbers of restrip.h.
const families = ['split', 'collapse', 'open-split', 'open-collapse', 'boundary-split', 'boundary-collapse', 'flip'];
const policies = ['bare', 'rules', 'local', 'quick', 'full'];
const efforts = ['fast', 'full', 'best'];
const forms = ['restart', 'stitched', 'lengths', 'list'];
const layouts = { cache: [32, 64], waste: [95, 1e6], work: [5, 100] };  // the default, and the most
const bare = 0;
const codes = { noSuchEdge: 1, sameSpoke: 3, spokeOnBoundary: 6, tooLarge: 103 };

/// Compiles the module: by default the file next to this one.
export async function load(source = new URL('./restrip.wasm', import.meta.url)) {
  const { exports } = await WebAssembly.instantiate(await compiled(source), {});
  return new Restrip(new Library(exports));
}

// ---- memory of the module

/// Releases what an object here holds there.
function release(held) {
  const { library, mesh, scratch } = held;
  Object.assign(held, { mesh: 0, scratch: 0 });
  for (const each of [mesh, scratch]) library.restrip_mesh_free(each);
}
/// Releases what objects held that a program can no longer reach and did not close.
const unreachable = new FinalizationRegistry(release);
/// Holds a mesh and its strips from scratch for `owner`; 0: not.
function holding(owner, library, held) {
  const all = { library, mesh: 0, scratch: 0, ...held };
  unreachable.register(owner, all);
  return all;
}

export class Restrip {
  #library;

  constructor(library) {
    if (!(library instanceof Library)) throw new TypeError('a Restrip is made by load(): const restrip = await load()');
    this.#library = library;
  }

  /// A progressive mesh.
  progressive(source) {
    const [points, base, splits] = lists('progressive()', source, ['points', 'base', 'splits']);
    const places = coordinates(points);
    const count = places.length / 3;
    return this.#opened(places, vertices('base', base, 3, count), vertices('splits', splits, 4, count, none));
  }
  /// A mesh without records.
  mesh(source) {
    const [points, triangles] = lists('mesh()', source, ['points', 'triangles']);
    const places = coordinates(points);
    return this.#opened(places, vertices('triangles', triangles, 3, places.length / 3), new Uint32Array(0));
  }
  #opened(places, base, splits) {
    return new StripMesh(this.#library, { places, base, splits, mesh: this.#library.build(base, places.length / 3) });
  }

  /// A baked mesh, from the bytes of its file.
  baked(content) {
    const library = this.#library;
    const bytes = bytesOf('baked mesh', content);
    library.with([bytes], (place) => library.explained(library.restrip_baked_read(place, bytes.length, library.text, 256, library.out), 'baked mesh'));
    const mesh = library.result();
    library.done(library.restrip_baked_points(mesh, library.out, library.out + 4));
    const places = library.at(library.result(), 3 * library.result(1), Float32Array).slice();
    const splits = new Uint32Array(4 * library.restrip_baked_levels(mesh));
    for (let i = 0; i < splits.length; i += 4) {
      library.done(library.restrip_baked_record(mesh, i / 4, library.out));
      splits.set(library.at(library.out, 4), i);
    }
    return new StripMesh(library, { places, base: library.triangles(mesh), splits, mesh, baked: true });
  }
  /// A mesh that was saved, with the points of its vertices.
  saved(content, options) {
    const { points, history = 0 } = known('saved', options, ['points', 'history']);
    const library = this.#library;
    const [bytes, places] = [bytesOf('saved mesh', content), coordinates(points)];
    library.with([bytes], (place) => library.explained(
      library.restrip_mesh_load(place, bytes.length, whole('history', history), library.text, 256, library.out), 'saved mesh'));
    const mesh = library.result();
    const bound = library.restrip_mesh_vertex_bound(mesh);
    if (bound > places.length / 3) {
      library.restrip_mesh_free(mesh);
      throw new Error(`saved mesh: it has ${bound} vertices; there are ${places.length / 3} points`);
    }
    return new StripMesh(library, { places, base: new Uint32Array(0), splits: new Uint32Array(0), mesh, history });
  }

  /// The rule of a configuration.
  rule({ family, k = 0, a = 0, i = 0, j = 0, edges, ports }) {
    const library = this.#library;
    const number = oneOf('family', family, families);
    const x = number < 2 ? whole('a', a) : whole('i', i);
    const valid = library.restrip_lookup(number, whole('k', k), x, whole('j', j), mask('edges', edges), mask('ports', ports), library.out) === 0;
    const [low, high, lowPorts, highPorts, strips] = valid ? library.at(library.out, 5) : [0, 0, 0, 0, 0];
    return { valid, strips: strips | 0, colors: BigInt(high) << 32n | BigInt(low), ports: BigInt(highPorts) << 32n | BigInt(lowPorts) };
  }
}

export class StripMesh {
  #library;
  #held;
  #walks;
  #points;
  #base;
  #splits;
  #records;
  #leftOut;
  #baked;  // whether the file has strips for each level
  #begun = false;
  #history = false;  // whether frames can be undone
  #behind = false;  // the buffer is not the one of the mesh
  #fresh = true;  // not updated yet
  #counts;
  #last = null;

  /// `history`: of a mesh that was saved, which has begun.
  constructor(library, { places, base, splits, mesh, baked = false, history }) {
    this.#library = library;
    this.#held = holding(this, library, { mesh });
    this.#walks = new Walks(library, mesh);
    this.#base = base;
    this.#splits = splits;
    this.#baked = baked;
    const report = library.at(library.out + 4, 6);
    this.#leftOut = { triangles: report[0] + report[1], nonManifoldVertices: report[5], boundaryEdges: report[2] };
    this.#points = new Points(places, splits.length === 0 ? 0 : places.length / 3);
    try {
      this.#records = this.#played();
    } catch (error) {
      this.close();
      throw error;
    }
    if (history !== undefined) this.#beginHistory(history);
  }
  /// The records, each of which is split once on a copy of the mesh.
  #played() {
    const library = this.#library;
    if (this.levels === 0) return new Records([]);
    library.done(library.restrip_mesh_copy(this.#held.mesh, library.out));
    const copy = library.result();
    try {
      library.done(library.restrip_mesh_keep(copy, bare, 0));
      const walks = new Walks(library, copy);
      return new Records(this.#splits, {
        around: (...vertices) => walks.around(...vertices),
        split: (i) => {
          const refusal = this.#splits[4 * i + 1] === none ? codes.noSuchEdge : this.#splitAt(copy, walks, ...this.#record(i));
          if (refusal !== 0) throw new Error(`split ${i} of the progressive mesh cannot be done (${library.describe(refusal)}); all before it can`);
        } });
    } finally {
      library.restrip_mesh_free(copy);
    }
  }
  /// Three coordinates a vertex.
  get points() { return this.#points.all; }
  get levels() { return this.#splits.length / 4; }
  #record(i) { return this.#splits.subarray(4 * i, 4 * i + 4); }
  close() { release(this.#held); }
  [Symbol.dispose ?? Symbol.for('Symbol.dispose')]() { this.close(); }

  /// The mesh in the module's memory.
  get #open() {
    if (this.#held.mesh === 0) throw new Error('this mesh is closed: close() gave its memory back');
    return this.#held.mesh;
  }
  /// The same, with strips.
  get #kept() {
    if (!this.#begun && this.#held.mesh !== 0) throw new Error('this mesh has no strips yet; call begin() first');
    return this.#open;
  }

  get splits() {
    void this.#open;
    return this.#splits.slice();
  }
  get leftOut() {
    void this.#open;
    return { ...this.#leftOut };
  }
  get hasBakedStrips() {
    void this.#open;
    return this.#baked;
  }

  begin(options = {}) {
    const { policy = 'quick', cost = 'indices', form = 'restart', bits = 32, history = 0, layout = {} } =
      known('begin', options, ['policy', 'cost', 'form', 'bits', 'history', 'layout']);
    const shape = oneOf('form', form, forms);
    if (![16, 32, 'auto'].includes(bits)) throw new RangeError(`bits is ${quoted(bits)}; it must be 16, 32 or 'auto'`);
    if (bits === 16 && this.#points.count > 0xffff) throw new RangeError('16 bits do not name all vertices; leave it to bits: \'auto\'');
    const library = this.#library;
    let mesh = this.#open;
    if (policy === 'baked' && !this.#baked) throw new RangeError('this mesh has no baked strips; open the file of a baked mesh');
    const kept = policy === 'baked' ? null : [oneOf('policy', policy, [...policies, ...this.#baked ? ['baked'] : []]), weights(cost)];
    const given = known('layout', layout, Object.keys(layouts));
    const placed = Uint32Array.from(Object.entries(layouts), ([name, [usual, most]]) => whole(`layout.${name}`, given[name] ?? usual, most));
    whole('history', history);
    // The base: a mesh without records is its own.
    if (this.#baked) library.done(library.restrip_baked_restart(mesh));
    else if (this.#begun && this.levels > 0) {
      mesh = library.build(this.#base, this.#points.count);
      library.restrip_mesh_free(this.#held.mesh);
      this.#held.mesh = mesh;
      this.#walks = new Walks(library, mesh);
    }
    if (kept !== null) {
      library.with([kept[1]], (weighed) => {
        library.done(library.restrip_mesh_stripify(mesh, 0, weighed, 0n, 0));
        library.done(library.restrip_mesh_keep(mesh, kept[0], weighed));
      });
    }
    const format = Int32Array.of(shape, bits === 'auto' ? 0 : bits, 0, 0, 1);
    library.with([format, placed], (formed, laid) => library.done(library.restrip_live_begin(mesh, formed, laid, history)));
    let triangles = this.#base.length / 3;
    for (let i = 0; i < this.#splits.length; i += 4) triangles += (this.#splits[i + 2] !== none) + (this.#splits[i + 3] !== none);
    if (this.levels > 0) library.done(library.restrip_mesh_reserve(mesh, triangles, this.#points.count));
    this.#updated(2, 4);
    this.#records.reset();
    this.#beginHistory(history);
    return this;
  }
  #beginHistory(history) {
    this.#begun = this.#fresh = true;
    this.#history = history > 0;
    this.#points.begin(this.#history ? this.#library.restrip_live_frame(this.#held.mesh) : null);
    this.#counts = { operations: 0, addingStrip: 0, isolating: 0, updates: 0, indicesWritten: 0 };
    this.#last = null;
  }
  keep(options = {}) {
    const { policy = 'quick', cost = 'indices' } = known('keep', options, ['policy', 'cost']);
    const [mesh, number] = [this.#kept, oneOf('policy', policy, policies)];
    this.#library.with([weights(cost)], (weighed) => this.#library.done(this.#library.restrip_mesh_keep(mesh, number, weighed)));
  }
  recolor(options = {}) {
    const { effort = 'fast', cost = 'indices' } = known('recolor', options, ['effort', 'cost']);
    const [library, mesh, number] = [this.#library, this.#kept, oneOf('effort', effort, efforts)];
    this.#last = null;
    this.#behind = true;
    return library.with([weights(cost)], (weighed) => {
      library.done(library.restrip_mesh_stripify(mesh, number, weighed, 0n, library.out));
      return library.result();
    });
  }
  improve(budget) {
    const library = this.#library;
    library.done(library.restrip_mesh_improve(this.#kept, whole('the budget', budget), library.out));
    const saved = library.result();
    if (saved > 0) this.#behind = true;
    return saved;
  }

  // ---- records

  /// The records, while the mesh is made of them: after split(), collapse() or flip() they no longer fit it.
  get #inRecords() {
    void this.#kept;
    if (this.#points.left) throw new Error('single operations have changed the mesh since begin(), so its records do not fit it; undo them, or call begin() again');
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
  get ready() {
    void this.#kept;
    return this.#records.ready;
  }
  /// Does the operations of a plan: each splits its record, or undoes it if it is split. The last one is described.
  #play(plan) {
    plan.forEach((i, n) => {
      const [vS, vT, vL, vR] = this.#record(i);
      const splits = this.#records.isSplit(i);
      const operation = () => this.#level === (splits ? i : i + 1) ? this.#moveLevel(splits ? i + 1 : i)
        : splits ? this.#splitAt(this.#held.mesh, this.#walks, vS, vT, vL, vR)
        : this.#library.restrip_mesh_collapse(this.#held.mesh, this.#walks.find(vS, vT), this.#library.out);
      const described = n + 1 < plan.length ? operation : () => (splits ? this.#splitBy(operation, vS, vT, vL, vR) : this.#collapseBy(operation, vS, vT));
      this.#library.done(this.#counted(described()), `record ${i}: `);
    });
    return plan.length;
  }
  /// The baked level, -1 when there is none.
  get #level() {
    return this.#baked && this.#library.restrip_baked_level(this.#held.mesh, this.#library.out) === 0 ? this.#library.result() : -1;
  }
  /// One record of baked strips, reported as an operation.
  #moveLevel(level) {
    const [library, mesh, before] = [this.#library, this.#held.mesh, this.#strips];
    const status = library.restrip_baked_move(mesh, level, 1, 0);
    const strips = this.#strips - before;
    library.words.set([none, 0, strips, 0], library.out / 4);
    return status;
  }
  get #strips() {
    this.#library.done(this.#library.restrip_mesh_strip_count(this.#held.mesh, this.#library.out));
    return this.#library.result();
  }

  // ---- single operations

  #splitAt(mesh, walks, vS, vT, vL, vR) {
    const left = vL === none ? none : walks.find(vS, vL);
    const right = vR === none ? none : walks.find(vS, vR);
    if ((vL !== none && left === none) || (vR !== none && right === none)) return codes.noSuchEdge;
    return this.#library.restrip_mesh_split(mesh, left, right, vT, this.#library.out);
  }
  /// Counts an operation by its restrip_change. Returns its status.
  #counted(refusal) {
    if (refusal !== 0) return refusal;
    const { words, out } = this.#library;
    const [strips, isolated] = [words[out / 4 + 2] | 0, words[out / 4 + 3] | 0];
    ++this.#counts.operations;
    if (strips > 0) ++this.#counts.addingStrip;
    if (isolated > 0) ++this.#counts.isolating;
    this.#behind = true;
    if (this.#last) Object.assign(this.#last, { strips, isolated });
    return 0;
  }
  // The operations with their patches before and after, for `last`.
  #described(kind, operation, before, after) {
    const { triangles, k, a, closed, edges, ports } = before();
    const refusal = operation();
    if (refusal !== 0) return refusal;
    const { words, out } = this.#library;
    const change = words.slice(out / 4, out / 4 + 4);
    const then = after();
    this.#last = { kind, closed: closed && then.closed, k, a, before: edges, ports, after: then.edges, portsAfter: then.ports,
      strips: 0, isolated: 0, trianglesBefore: triangles, trianglesAfter: then.triangles };
    this.#library.words.set(change, out / 4);  // the walks have used its place
    return 0;
  }
  #splitBy(operation, vS, vT, vL, vR) {
    return this.#described('split', operation, () => this.#walks.fan(vS, vL, vR), () => this.#walks.ring(vS, vT));
  }
  #collapseBy(operation, vS, vT) {
    const [vL, vR] = [this.#walks.apex(vS, vT), this.#walks.apex(vT, vS)];
    return this.#described('collapse', operation, () => this.#walks.ring(vS, vT), () => this.#walks.fan(vS, vL, vR));
  }
  split(vS, vT, vL, vR) {
    // The new vertex must have a point; of the others the library says whether the mesh has them.
    whole('vT', vT, this.#points.count - 1);
    const [mesh, walks] = [this.#kept, this.#walks];
    const sides = [vL, vR].filter((v) => v !== none);
    for (const [name, v] of Object.entries({ vS, vL, vR })) whole(name, v);
    return this.#outcome(this.#splitBy(() => this.#splitAt(mesh, walks, vS, vT, vL, vR), vS, vT, vL, vR), `vertex ${vS} cannot be split`, {
      [codes.noSuchEdge]: `vertex ${vS} has no edge to ${sides.join(' or to ') || '`none`'}`,
      [codes.sameSpoke]: `vertex ${vS} needs two edges, but vL and vR are both ${vL}`,
      [codes.spokeOnBoundary]: `vertex ${vS} is not on the boundary, so neither vL nor vR may be \`none\`` });
  }
  collapse(vS, vT) {
    const mesh = this.#kept;
    for (const [name, v] of Object.entries({ vS, vT })) whole(name, v);
    const collapse = () => this.#library.restrip_mesh_collapse(mesh, this.#walks.find(vS, vT), this.#library.out);
    return this.#atEdge(this.#collapseBy(collapse, vS, vT), vS, vT, 'collapsed');
  }
  flip(u, v) {
    const mesh = this.#kept;
    for (const [name, w] of Object.entries({ u, v })) whole(name, w);
    const quad = (a, b) => ({ closed: false, k: 0, a: 0, edges: 0n, ports: 0n,
      triangles: Uint32Array.of(a, b, this.#walks.apex(a, b), b, a, this.#walks.apex(b, a)) });
    const [l, r] = [this.#walks.apex(u, v), this.#walks.apex(v, u)];
    const flip = () => this.#library.restrip_mesh_flip(mesh, this.#walks.find(u, v), this.#library.out);
    return this.#atEdge(this.#described('flip', flip, () => quad(u, v), () => quad(l, r)), u, v, 'flipped');
  }
  apply(table, u, v) {
    const mesh = this.#kept;
    for (const [name, w] of Object.entries({ u, v })) whole(name, w);
    const [library, h] = [this.#library, this.#walks.find(u, v)];
    const corners = [u, v, this.#walks.apex(u, v)];
    let first;
    for (const position of library.tables(table)) {
      const most = 18;
      const [done, added] = library.with([new Uint32Array(most)], (place) => {
        const status = library.restrip_mesh_apply(mesh, position, h, library.out, place, library.out + 16);
        return [status, status === 0 ? [...library.at(place, library.result(4))] : []];
      });
      if (done !== 0) {
        first ??= done;
        continue;
      }
      this.#last = null;
      this.#outcome(done);
      const middle = this.#middle(corners);
      for (const w of added) this.#points.make(w, middle);
      return { ok: true, vertices: added };
    }
    return this.#outcome(first ?? codes.noSuchEdge, `'${table.name}' cannot be done at the edge from ${u} to ${v}`, { [codes.noSuchEdge]: `no triangle has a side from ${u} to ${v}` });
  }
  bisect(u, v) {
    const mesh = this.#kept;
    for (const [name, w] of Object.entries({ u, v })) whole(name, w);
    const refusal = this.#library.restrip_mesh_bisect(mesh, this.#walks.find(u, v), this.#library.out);
    return this.#added(refusal, [u, v], (each) => this.#atEdge(each, u, v, 'bisected'));
  }
  splitFace(a, b, c) {
    const mesh = this.#kept;
    for (const [name, w] of Object.entries({ a, b, c })) whole(name, w);
    const h = this.#walks.apex(a, b) === c ? this.#walks.find(a, b) : none;
    const refusal = this.#library.restrip_mesh_split_face(mesh, h, this.#library.out);
    return this.#added(refusal, [a, b, c], (each) => this.#outcome(each, `the triangle ${a}, ${b}, ${c} cannot be split`,
      { [codes.noSuchEdge]: `no triangle has the corners ${a}, ${b}, ${c} in this order` }));
  }
  replace(removed, inserted) {
    const [mesh, library] = [this.#kept, this.#library];
    const [out, made] = [vertices('removed', removed, 3, this.#points.count), vertices('inserted', inserted, 3, this.#points.count)];
    const triangles = new Uint32Array(out.length / 3);
    for (let i = 0; i < triangles.length; ++i) {
      const [a, b, c] = out.subarray(3 * i, 3 * i + 3);
      if (this.#walks.apex(a, b) !== c) return this.#outcome(codes.noSuchEdge, '', { [codes.noSuchEdge]: `no triangle has the corners ${a}, ${b}, ${c} in this order` });
      triangles[i] = triangleOf(this.#walks.find(a, b));
    }
    const refusal = library.with([triangles, made], (gone, added) =>
      library.restrip_mesh_replace(mesh, gone, triangles.length, added, made.length / 3, library.out));
    if (refusal === 0) this.#last = null;
    return this.#outcome(refusal, 'these triangles cannot be replaced', {});
  }
  /// An operation with a new vertex, between others.
  #added(refusal, corners, outcome) {
    const halfedge = this.#library.result();
    if (refusal === 0) this.#last = null;
    const done = outcome(refusal);
    if (!done.ok) return done;
    const vertex = this.#walks.to(halfedge);
    this.#points.make(vertex, this.#middle(corners));
    return { ...done, vertex };
  }
  #middle(corners) { return [0, 1, 2].map((x) => corners.reduce((sum, v) => sum + this.points[3 * v + x], 0) / corners.length); }
  /// `fault`: what cannot be done, by its vertices. `sentences`, by status: in place of the library's that speak of halfedges.
  #outcome(refusal, fault, sentences) {
    if (this.#counted(refusal) === 0) {
      this.#points.leave();
      return { ok: true };
    }
    const why = refusal === codes.tooLarge ? 'it needs a vertex above 65,534, which 16 bits cannot name; begin with bits \'auto\'' : this.#library.describe(refusal);
    return { ok: false, reason: sentences[refusal] ?? `${fault}: ${why}` };
  }
  #atEdge(refusal, u, v, done) {
    return this.#outcome(refusal, `the edge from ${u} to ${v} cannot be ${done}`, { [codes.noSuchEdge]: `no triangle has a side between ${u} and ${v}` });
  }

  around(v) {
    void this.#kept;
    return Uint32Array.from(this.#walks.spokes(whole('v', v)), (h) => this.#walks.to(h));
  }

  addPoint(x, y, z) {
    const place = point(x, y, z);
    void this.#open;
    const v = this.#points.count;
    this.#points.put(v, place);
    return v;
  }
  setPoint(v, x, y, z) {
    const place = point(x, y, z);
    void this.#open;
    this.#points.put(whole('v', v, this.#points.count - 1), place);
  }

  // ---- history

  undo() { return this.#step(false); }
  redo() { return this.#step(true); }
  #step(forward) {
    const [library, mesh] = [this.#library, this.#kept];
    library.done((forward ? library.restrip_live_redo : library.restrip_live_undo)(mesh, library.out));
    const done = library.result() === 1;
    if (!done) {
      this.#endFrame();
      return false;
    }
    this.#points.step(library.restrip_live_frame(mesh), forward);
    const played = new Uint8Array(this.levels);
    for (let i = 0; i < played.length; ++i) played[i] = this.#walks.spoke(this.#splits[4 * i + 1]) === none ? 0 : 1;
    this.#records.reset(played);
    this.#behind = true;
    this.#last = null;
    return true;
  }
  #endFrame() {
    if (this.#history) this.#points.end(this.#library.restrip_live_frame(this.#held.mesh), this.history.undoable);
  }
  get history() {
    const library = this.#library;
    library.done(library.restrip_live_history_size(this.#kept, library.out, library.out + 4));
    return { undoable: library.result(), redoable: library.result(1) };
  }
  save() {
    const library = this.#library;
    library.done(library.restrip_mesh_save(this.#kept, library.out, library.out + 4));
    return library.at(library.result(), library.result(1), Uint8Array).slice();
  }

  // ---- the index buffer

  /// Brings the buffer in step. Returns the ranges, and whether it is outgrown.
  #updated(join, align) {
    const library = this.#library;
    const { out } = library;
    library.done(library.restrip_live_update(this.#held.mesh, join, align, out, out + 4, out + 8));
    this.#behind = false;
    return [this.#ranges(library.result(), library.result(1)), library.result(2) === 1];
  }
  update(options = {}) {
    const { join = 2, align = 4 } = known('update', options, ['join', 'align']);
    if (align !== 2 && (whole('align', align) === 0 || align % 4 !== 0)) throw new RangeError(`align is ${align}; it must be 2 or a multiple of 4`);
    void this.#kept;
    let [ranges, outgrown] = this.#updated(whole('join', join), align);
    if (this.#fresh) {
      const count = this.indices.length;
      [ranges, outgrown] = [count === 0 ? [] : [{ first: 0, count }], true];
    } else this.#counts.indicesWritten += ranges.reduce((sum, { count }) => sum + count, 0);
    this.#fresh = false;
    ++this.#counts.updates;
    this.#endFrame();
    return Object.assign(ranges, { outgrown });
  }
  #ranges(address, count) {
    const flat = this.#library.at(address, 2 * count);
    return Array.from({ length: count }, (_, i) => ({ first: flat[2 * i], count: flat[2 * i + 1] }));
  }
  /// The fields of restrip_buffer_view, and the room.
  get #view() {
    const library = this.#library;
    library.done(library.restrip_live_buffer(this.#kept, library.out, library.out + 28));
    const [indices, count, bits, form, draws, drawCount, , room] = library.at(library.out, 8);
    return { indices, count, bits, form, draws, drawCount, room };
  }
  get room() { return this.#view.room; }
  get draws() {
    const { draws, drawCount } = this.#view;
    return this.#ranges(draws, drawCount);
  }
  get indices() {
    const { indices, count, bits } = this.#view;
    return this.#library.at(indices, count, bits === 16 ? Uint16Array : Uint32Array);
  }
  get triangles() { return this.#library.triangles(this.#kept); }
  fromScratch(options = {}) {
    const { cost = 'indices', cacheSize = 0, cacheWeight = 0 } = known('fromScratch', options, ['cost', 'cacheSize', 'cacheWeight']);
    const size = whole('cacheSize', cacheSize, 1e6);
    if (!(typeof cacheWeight === 'number' && cacheWeight >= 0 && cacheWeight <= 1000))
      throw new RangeError(`cacheWeight must be a number from 0 to 1000, not ${quoted(cacheWeight)}`);
    const [library, mesh, weighed] = [this.#library, this.#kept, weights(cost)];
    library.done(library.restrip_mesh_copy(mesh, library.out));
    library.restrip_mesh_free(this.#held.scratch);
    this.#held.scratch = library.result();
    library.with([weighed], (place) => library.done(library.restrip_mesh_stripify(this.#held.scratch, 0, place, 0n, 0)));
    return this.#written(this.#held.scratch, new Uint32Array(Float64Array.of(0, cacheWeight).buffer).map((word, n) => (n === 0 ? size : word)));
  }
  /// The indices of a buffer that is made for this mesh, and their number alone if `counted`.
  #written(mesh, cache = new Uint32Array(4), counted = false) {
    const library = this.#library;
    const format = Int32Array.of(0, 32, 0, 0, 1);
    library.with([cache, format], (cached, formed) => library.done(library.restrip_mesh_buffer(mesh, cached, formed, library.out)));
    const buffer = library.result();
    library.done(library.restrip_buffer_read(buffer, library.out));
    const [indices, count] = library.at(library.out, 2);
    const made = counted ? count : library.at(indices, count).slice();
    library.restrip_buffer_free(buffer);
    return made;
  }

  // ---- figures and pictures

  get figures() {
    const mesh = this.#kept;
    return { triangles: this.#library.restrip_mesh_triangle_count(mesh), strips: this.#strips, ...this.#counts,
      bufferIndices: this.#behind ? null : this.draws.reduce((sum, { count }) => sum + count, 0), baked: this.#level >= 0,
      played: this.#records.count, inOrder: this.#records.inOrder };
  }
  get plainIndices() { return this.#written(this.#kept, undefined, true); }
  get valid() {
    this.#library.done(this.#library.restrip_mesh_check(this.#kept, this.#library.out));
    return this.#library.result(3) === 1;
  }
  get ribbon() { return this.#ribbonOf(this.#kept); }
  get scratchRibbon() {
    void this.#kept;
    return this.#held.scratch === 0 ? new Uint32Array(0) : this.#ribbonOf(this.#held.scratch);
  }
  #ribbonOf(mesh) {
    const library = this.#library;
    return library.filled(9 * library.restrip_mesh_triangle_count(mesh), (place) => library.restrip_js_ribbon(mesh, place));
  }
  pick(from, along) {
    for (const [what, place] of [['from', from], ['along', along]])
      if (place?.length !== 3 || ![...place].every(Number.isFinite)) throw new RangeError(`${what} must be three finite numbers`);
    const [{ triangles, points }, minus] = [this, (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]]];
    const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const place = (v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
    let nearest = Infinity;
    for (let t = 0; t < triangles.length; t += 3) {
      // The distance along the ray (Moller and Trumbore 1997).
      const a = place(triangles[t]);
      const [e, f, s] = [minus(place(triangles[t + 1]), a), minus(place(triangles[t + 2]), a), minus(from, a)];
      const [p, q] = [cross(along, f), cross(s, e)];
      const determinant = dot(e, p);
      const [u, v, distance] = [dot(s, p), dot(along, q), dot(f, q)].map((each) => each / determinant);
      if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest) nearest = distance;
    }
    return nearest === Infinity ? null : [0, 1, 2].map((x) => from[x] + nearest * along[x]);
  }
  get last() {
    void this.#kept;
    return this.#last && { ...this.#last };
  }
}
