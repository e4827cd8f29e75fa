// Ways to maintain an index buffer while the level of a mesh changes, each with a separate mesh: the bytes that a
// change writes, and the bytes that each drawn frame reads.
import { restartIndex } from '../../bindings/js/restrip.mjs';

/// Their names on the page.
export const ways = { kept: 'Maintained strips', scratch: 'Strips from scratch', whole: 'List written whole', slots: 'List with slots' };

export class Lane {
  #scratch = null;  // the last index buffer from scratch

  /// `source`: of prepared(). Policy and cost are for strips; a list does not maintain strips. `width`: bytes of an
  /// index.
  constructor(restrip, way, source, { policy, cost, width }) {
    Object.assign(this, { way, cost, width });
    this.mesh = restrip.progressive(source).begin({ policy: way === 'kept' ? policy : 'bare', cost, form: this.isList ? 'list' : 'restart' });
    this.#follow();
    this.startHere();
  }
  /// Steps count from here on.
  startHere() { this.total = { steps: 0, operations: 0, written: 0, drawn: 0 }; }
  /// A step ends after that many operations, in any number of frames: the index buffer follows it once. Uploading is
  /// the caller's.
  endStep(operations) {
    this.#follow();
    this.total.steps += 1;
    this.total.operations += operations;
    this.total.written += this.width * this.ranges.reduce((sum, { count }) => sum + count, 0);
    this.total.drawn += this.width * this.length;
  }
  #follow() {
    if (this.way === 'scratch') {
      this.#scratch = this.mesh.fromScratch({ cost: this.cost });
      this.ranges = [{ first: 0, count: this.#scratch.length }];
    } else this.ranges = this.mesh.update();
    this.length = this.indices.length;
    if (this.way === 'whole') this.ranges = [{ first: 0, count: this.length }];
  }
  /// The indices to draw: a view, valid until the next call of any mesh.
  get indices() { return this.#scratch ?? this.mesh.indices; }
  get isList() { return this.way === 'whole' || this.way === 'slots'; }
  get ribbon() { return this.way === 'scratch' ? this.mesh.scratchRibbon : this.mesh.ribbon; }
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
