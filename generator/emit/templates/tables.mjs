// A complete reader of restrip_tables.json: the rule of each of its operations, in any position, for any colours, valid or not.
// It follows docs/reference/notation.md and works with lists of triangles, edges and strands, where the compiled look-ups do sums
// of masks, so that it can check them.

/// A patch before an operation: a ring of elements, two of them perhaps without a port and joined by a chord.
class Patch {
  #known = [];

  constructor(k, inserted) {
    this.k = k;
    const size = k + inserted.length;
    this.edges = Array.from({ length: size }, (_, m) => [m, (m + 1) % size]);
    if (inserted.length === 2) this.edges.push(inserted);
    let port = 0;
    this.ports = Array.from({ length: size }, (_, element) => (inserted.includes(element) ? -1 : port++));
  }

  /// What follows from the inner edges alone: the ports that must not be solid, because their triangles have two solid edges, and
  /// the pairs of ports, ascending, at the two ends of a strand. Null if a triangle has three solid edges or a cycle is
  /// solid.
  #strands(inner) {
    const near = this.ports.map(() => []);
    this.edges.forEach(([u, v], m) => {
      if ((inner >> m & 1) === 0) return;
      near[u].push(v);
      near[v].push(u);
    });
    if (near.some((list) => list.length > 2)) return null;
    const seen = new Set();
    const pairs = [];
    for (let start = 0; start < near.length; ++start) {
      if (near[start].length > 1 || seen.has(start)) continue;
      let at = start;
      for (let next = start; next !== undefined; next = near[at].find((element) => !seen.has(element))) seen.add(at = next);
      const [one, two] = [this.ports[start], this.ports[at]].sort((x, y) => x - y);
      if (one >= 0 && at !== start) pairs.push([one, two]);
    }
    if (seen.size < near.length) return null;
    let full = 0;
    near.forEach((list, element) => { if (list.length === 2 && this.ports[element] >= 0) full |= 1 << this.ports[element]; });
    return { full, pairs };
  }

  /// The mask `joined` of a key, or null if the colours are not valid.
  joined(inner, ports) {
    if (inner >>> this.edges.length !== 0 || ports >>> this.k !== 0) return null;
    const strands = this.#known[inner] ??= this.#strands(inner) ?? 'not valid';
    if (strands === 'not valid' || (strands.full & ports) !== 0) return null;
    let joined = 0;
    for (const [low, high] of strands.pairs) {
      if ((ports >> low & 1) === 0 || (ports >> high & 1) === 0) continue;
      const within = (2 << high) - (1 << low);
      if ((ports & within) === (1 << low | 1 << high)) joined |= 1 << high;
      else if ((ports & ~within) === 0) joined |= 1 << low;
    }
    return joined;
  }
}

const count = (mask) => { let n = 0; for (; mask !== 0; mask &= mask - 1) ++n; return n; };
const turned = (mask, by, n) => (mask >> by | mask << (n - by)) & ((1 << n) - 1);

/// The rules of one position of an operation.
class Place {
  #patch;
  #table;
  #starts;
  #seen;  // how the colours of a split are seen from a position that the tables have, and its answer from here
  #first;

  constructor(json, operation, [k, p]) {
    this.operation = operation;
    this.#table = json.families[operation.family];
    this.#patch = new Patch(k, operation.from_fan ? [] : [0, p + 1]);
    this.#starts = json.rows;
    const [place, seen] = operation.from_fan ? Place.#place(k, p) : [0, null];
    this.#first = this.#table.first[k] + (place === 0 ? 0 : place * this.#table.cells[k]);
    this.#seen = seen;
  }

  /// The tables have half of the positions of splits; the others have A and D exchanged.
  static #place(k, p) {
    if (2 * p <= k) return [p - 1, null];
    return [k - p - 1, { loop: (loop) => turned(loop, p, k), ports: (ports) => turned(ports, p, k),
                                   answer: (cell) => turned(cell & (4 << k) - 1, k - p + 1, k + 2) | cell & 4 << k }];
  }

  /// { colors, strips }: the inner edges after the operation and the change in the number of strips; null if the colours
  /// are not valid.
  rule(before, ports) {
    let joined = this.#patch.joined(before, ports);
    if (joined === null) return null;
    if (this.#seen) {
      ports = this.#seen.ports(ports);
      joined = this.#patch.joined(this.#seen.loop(before), ports);
    }
    const cell = this.#table.rules[this.#first + this.#starts[1 << this.#patch.k | ports] + joined];
    const colors = this.#seen ? this.#seen.answer(cell) : cell;
    return { colors, strips: this.operation.triangles - count(colors) + count(before) };
  }
}

export class Tables {
  /// `json`: what JSON.parse makes of the file.
  constructor(json) {
    if (json.format !== 'restrip-tables' || json.version !== 2) throw new Error('not tables of restrip, version 2');
    this.json = json;
    this.operations = new Map(json.operations.map((operation) => [operation.name, operation]));
  }

  /// A position [k, a] of an operation; null if the tables do not have it.
  at(name, position) {
    const [k, a] = position;
    return k >= 3 && k <= this.json.max_k && a >= 1 && a < k ? new Place(this.json, this.operations.get(name), position) : null;
  }

  /// { inner, ports, strips }: the ports are those that stay solid. Null if the colours are not valid.
  flip(inner, ports) {
    const entry = inner >>> 1 === 0 && ports >>> 4 === 0 ? this.json.flip[inner << 4 | ports] : 255;
    return entry === 255 ? null : { inner: entry >> 4, ports: entry & 15, strips: count(inner) + count(ports) - count(entry) };
  }
}
