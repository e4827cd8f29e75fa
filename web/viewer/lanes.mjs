// Ways to have an index buffer while the level of a mesh moves, each with a mesh of its own, and what a step costs it.
import { restartIndex } from '../js/restrip.mjs';

/// And what the page calls them.
export const ways = { kept: 'Strips kept', scratch: 'Strips from scratch', whole: 'List written whole', slots: 'List with slots' };

const indicesIn = (ranges) => ranges.reduce((sum, { count }) => sum + count, 0);

export class Lane {
  #scratch = null;  // the last index buffer from scratch

  /// `source`: of prepared(). Policy and cost are those of strips; a list keeps none.
  constructor(restrip, way, source, { policy, cost }) {
    this.way = way;
    this.cost = cost;
    this.mesh = restrip.progressive(source).begin({ policy: way === 'kept' ? policy : 'bare', cost });
    this.ranges = this.#follow();
    this.startHere();
  }
  /// Steps count from here on.
  startHere() {
    this.last = { bytes: 0, moving: 0 };
    this.total = { steps: 0, bytes: 0, milliseconds: 0 };
  }
  /// Towards the level by at most so many operations, and the index buffer after it; uploading is another's. Returns the
  /// number of operations.
  step(level, most = Infinity) {
    const start = performance.now();
    const operations = this.mesh.moveTo(level, most);
    const moved = performance.now();
    this.ranges = this.#follow();
    const took = performance.now() - start;
    this.last = { bytes: 4 * indicesIn(this.ranges), moving: moved - start };
    this.total.steps += 1;
    this.total.bytes += this.last.bytes;
    this.total.milliseconds += took;
    return operations;
  }
  #follow() {
    if (this.way === 'kept') return this.mesh.update();
    if (this.way !== 'scratch') return this.mesh.updateList({ whole: this.way === 'whole' });
    this.#scratch = this.mesh.fromScratch({ cost: this.cost });
    return [{ first: 0, count: this.#scratch.length }];
  }
  /// What is drawn: a view, valid until the next call of any mesh.
  get indices() {
    if (this.way === 'kept') return this.mesh.indices;
    return this.#scratch ?? this.mesh.listIndices;
  }
  get isList() { return this.way === 'whole' || this.way === 'slots'; }
  get ribbon() { return this.way === 'scratch' ? this.mesh.scratchRibbon : this.mesh.ribbon; }
  /// 0: a list has none.
  get strips() {
    if (this.way === 'kept') return this.mesh.figures.strips;
    return this.isList ? 0 : this.indices.reduce((sum, index) => sum + (index === restartIndex ? 1 : 0), 1);
  }
  /// The triangles that the written indices draw, three corners each.
  get written() {
    const { indices } = this;
    const out = [];
    const add = (i) => {  // the triangle whose last index this is
      const [a, b, c] = [indices[i - 2], indices[i - 1], indices[i]];
      if (a !== b && b !== c && c !== a && Math.max(a, b, c) !== restartIndex) out.push(a, b, c);
    };
    // A triangle of a list ends at every third index, one of a strip at every index; each has the two before as well.
    const apart = this.isList ? 3 : 1;
    let next = 2;
    for (const { first, count } of this.ranges) {
      for (next = Math.max(next, first - first % apart + apart - 1); next < Math.min(first + count + 2, indices.length); next += apart) add(next);
    }
    return new Uint32Array(out);
  }
  close() { this.mesh.close(); }
}
