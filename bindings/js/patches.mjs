// Walks over a mesh by its halfedges, and the patches of operations as they are, numbered as in docs/reference/notation.md.
// Side s of triangle t is halfedge 4 t + s; those from 2^31 on have no triangle.
import { absent } from './arguments.mjs';

const largestFan = 61;
export const onBoundary = (h) => h >= 0x80000000;
export const triangleOf = (h) => h >>> 2;
/// Around the triangle.
export const after = (h) => ((h & 3) === 2 ? h - 2 : h + 1);
const before = (h) => ((h & 3) === 0 ? h + 2 : h - 1);

export class Walks {
  #library;
  #mesh;
  constructor(library, mesh) { [this.#library, this.#mesh] = [library, mesh]; }

  find(v, w) { return this.#library.restrip_mesh_find(this.#mesh, v, w); }
  spoke(v) { return this.#library.restrip_mesh_spoke(this.#mesh, v); }
  opposite(h) { return this.#library.restrip_mesh_opposite(this.#mesh, h); }
  to(h) { return this.#library.restrip_mesh_to(this.#mesh, h); }
  solid(h) { return this.#library.restrip_mesh_solid(this.#mesh, h) === 1; }
  /// The next halfedge that leaves the same vertex.
  ccw(h) { return this.opposite(before(h)); }
  cw(h) { return after(this.opposite(h)); }
  /// Third corner of the triangle that has the side from u to v, counter-clockwise; `absent` if it does not exist.
  apex(u, v) {
    const h = this.find(u, v);
    return onBoundary(h) ? absent : this.to(after(h));
  }
  /// The halfedges that leave v, counter-clockwise; of a non-manifold vertex only some.
  spokes(v) {
    const [all, first] = [[], this.spoke(v)];
    for (let h = first; h !== absent;) {
      all.push(h);
      if (onBoundary(h) || (h = this.ccw(h)) === first) break;
    }
    return all;
  }
  /// The triangles around these vertices, each once.
  around(...vertices) {
    const triangles = new Set();
    for (const v of vertices) for (const h of this.spokes(v)) if (!onBoundary(h)) triangles.add(triangleOf(h));
    return [...triangles];
  }

  /// The triangles of the vertex that h leaves, counter-clockwise from h, then clockwise if the fan is open.
  #turn(h) {
    const all = [];
    let g = h;
    while (!onBoundary(g)) {
      all.push(triangleOf(g));
      if ((g = this.ccw(g)) === h) return all;
    }
    for (g = h; !onBoundary(this.opposite(g));) all.push(triangleOf(g = this.cw(g)));
    return all;
  }
  #corners(triangles) { return Uint32Array.from(triangles.flatMap((t) => [0, 1, 2].map((side) => this.#library.restrip_mesh_from(this.#mesh, 4 * t + side)))); }
  /// Adds the triangles counter-clockwise from one spoke to another; false if they are too many or reach the boundary.
  #add(patch, from, to) {
    for (let h = from; h !== to; ++patch.k, ++patch.edge) {
      if (onBoundary(h) || patch.k === largestFan) return false;
      if (this.solid(after(h))) patch.ports |= 1n << BigInt(patch.k);
      if (this.solid(before(h))) patch.edges |= 1n << BigInt(patch.edge);
      h = this.ccw(h);
    }
    return true;
  }
  /// The fan of v, t_0 to the left of the edge to vL.
  fan(v, vL, vR) {
    const [left, right] = [this.find(v, vL), this.find(v, vR)];
    const first = left === absent ? right : left;
    const triangles = this.#corners(first === absent ? this.around(v) : this.#turn(first));
    const patch = { closed: false, k: 0, a: 0, edge: 0, edges: 0n, ports: 0n, triangles };
    if (left === absent || right === absent) return patch;
    patch.closed = this.#add(patch, left, right);
    patch.a = patch.k;
    patch.closed &&= this.#add(patch, right, left);
    return patch;
  }
  /// The ring with chord around the edge from v to w.
  ring(v, w) {
    const patch = { closed: false, k: 0, a: 0, edge: 0, edges: 0n, ports: 0n, triangles: this.#corners(this.around(v, w)) };
    const chord = this.find(v, w);
    if (chord === absent || [v, w].some((end) => this.spokes(end).some(onBoundary))) return patch;
    patch.closed = true;
    for (const start of [chord, this.opposite(chord)]) {
      const first = this.ccw(start);
      if (this.solid(first)) patch.edges |= 1n << BigInt(patch.edge);
      ++patch.edge;
      patch.closed &&= this.#add(patch, first, this.cw(start));
      if (start === chord) patch.a = patch.k;
    }
    if (this.solid(chord)) patch.edges |= 1n << BigInt(patch.edge);
    return patch;
  }
}
