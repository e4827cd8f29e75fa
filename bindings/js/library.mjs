// The module: the functions of the C interface (bindings/c/include/restrip.h), which have their names, and its memory. A
// size and an address have 32 bits there.

/// A function that is stopped throws an Error with the reason.
export class Library {
  #memory;
  #view = new Uint32Array(0);
  #tables = new WeakMap();  // by table as data: its positions here
  #forgotten = new FinalizationRegistry((positions) => positions.forEach((address) => this.restrip_table_free(address)));
  /// Places for results: 16 numbers, and a text.
  out;
  text;

  constructor({ memory, __stack_pointer: stack, restrip_js_stopped: reason, ...calls }) {
    const top = stack.value;
    this.#memory = memory;
    for (const [name, call] of Object.entries(calls)) {
      this[name] = (...values) => {
        try {
          return call(...values) >>> 0;  // numbers of WebAssembly are signed; ours are addresses, some above 2 GB, and counts
        } catch (error) {
          stack.value = top;
          const why = reason() >>> 0;
          throw why === 0 ? error : new Error(this.textAt(why).replace(/^restrip: /, ''));
        }
      };
    }
    this._initialize();
    this.out = this.take(64);
    this.text = this.take(256);
  }
  /// All memory as numbers of 32 bits; valid until the next call.
  get words() {
    if (this.#view.buffer !== this.#memory.buffer) this.#view = new Uint32Array(this.#memory.buffer);
    return this.#view;
  }
  /// Result n of the last call.
  result(n = 0) { return this.words[this.out / 4 + n]; }
  /// A view, valid until the next call.
  at(address, count, Type = Uint32Array) { return count === 0 ? new Type(0) : new Type(this.#memory.buffer, address, count); }
  textAt(address) {
    const bytes = new Uint8Array(this.#memory.buffer);
    return new TextDecoder().decode(bytes.slice(address, bytes.indexOf(0, address)));
  }

  take(bytes) {
    const place = this.restrip_js_take(Math.max(bytes, 1));
    if (place === 0) throw new RangeError(`out of memory: ${bytes} bytes more cannot be had`);
    return place;
  }
  /// Copies arrays into the memory for the time of the call.
  with(arrays, call) {
    const places = [];
    try {
      for (const { byteLength } of arrays) places.push(this.take(byteLength));
      arrays.forEach((array, n) => this.at(places[n], array.length, array.constructor).set(array));
      return call(...places);
    } finally {
      places.forEach((place) => this.restrip_js_give_back(place));
    }
  }
  /// What a call writes into an array of that many numbers.
  filled(count, call, Type = Uint32Array) {
    return this.with([new Type(count)], (place) => {
      this.done(call(place));
      return this.at(place, count, Type).slice();
    });
  }
  describe(status) { return this.textAt(this.restrip_describe(status)); }
  /// Throws unless the status is that of success. `what` was called.
  done(status, what = '') {
    if (status !== 0) throw new Error(`${what}${this.describe(status)}`);
  }
  /// The same for a call that explains what is wrong with its argument.
  explained(status, what) {
    const why = this.textAt(this.text);
    if (status !== 0) throw new Error(`${what}: ${why || this.describe(status)}`);
  }

  /// The positions of the table of a custom operation, as restrip-generate writes it in JSON, copied here and checked once.
  tables(table) {
    if (table?.format !== 'restrip-operation-table' || !Array.isArray(table.positions))
      throw new TypeError('apply() needs the table of an operation: the JSON that the page Make a rule or restrip-generate rules --language json writes');
    if (this.#tables.has(table)) return this.#tables.get(table);
    const positions = [];
    try {
      for (const { ports, before, after, first, vertices, triangles_before: from, triangles_after: to } of table.positions) {
        if (!from) throw new Error(`the table ${table.name} has no triangles; make it with restrip-generate rules --language json`);
        const size = 2 ** (table.matching ? ports : before.edges + ports);
        const entries = Uint32Array.from(table.entries.slice(first, first + size), (entry) => (entry === table.none ? 0xffffffff : entry));
        const bytes = [from, to].map((triangles) => Uint8Array.from(triangles.flat()));
        this.with([...bytes, entries, new Uint32Array(11)], (old, made, listed, place) => {
          this.at(place, 11).set([ports, before.edges, after.edges, vertices, table.matching ? 1 : 0, old, from.length, made, to.length, listed, entries.length]);
          this.explained(this.restrip_table_make(place, this.text, 256, this.out), `the table ${table.name}`);
        });
        positions.push(this.result());
      }
    } catch (error) {
      positions.forEach((address) => this.restrip_table_free(address));
      throw error;
    }
    this.#tables.set(table, positions);
    this.#forgotten.register(table, positions);
    return positions;
  }

  /// A mesh of these triangles.
  build(corners, count) {
    this.with([corners], (place) => this.done(this.restrip_mesh_build_u32(place, corners.length, count, this.out + 4, 0, this.out)));
    return this.result();
  }
  triangles(mesh) {
    const numbers = 3 * this.restrip_mesh_triangle_count(mesh);
    return this.filled(numbers, (place) => this.restrip_mesh_triangles(mesh, place, numbers));
  }
}
