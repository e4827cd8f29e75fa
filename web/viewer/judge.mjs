// Judges a colouring of the patch after a split: its value, and its fault if it is not sound
// (docs/reference/notation.md).
import { has, joinedPairs, pairsMask, ringEdges } from './patch.mjs';

/// The triangles of the patch after a split by name: t0 to t_{k-1}, A and D.
export const namesOf = (k) => [...Array.from({ length: k }, (_, i) => `t${i}`), 'A', 'D'];
/// The number of bits.
export const bitsIn = (mask) => BigInt(mask).toString(2).replaceAll('0', '').length;

/// A patch that is split, with its colours before.
export class Puzzle {
  constructor(k, a, loop, ports) {
    [this.k, this.a, this.loop, this.ports] = [k, a, BigInt(loop), BigInt(ports)];
    this.edges = ringEdges(k, a);
    this.names = namesOf(k);
    this.pairs = joinedPairs(k, this.loop, this.ports);
  }
  get name() { return [this.k, this.a, this.loop.toString(16), this.ports.toString(16)].join('-'); }
  /// What an inner edge is called: by its two triangles.
  edgeName(edge) { return this.edges[edge].map((node) => this.names[node]).join('–'); }
  /// Strips, counted inside the patch: before the split, and after it with these inner edges if they close no cycle.
  get before() { return this.k - bitsIn(this.loop); }
  after(inner) { return this.k + 2 - bitsIn(inner); }
  /// The solid inner edges of each triangle.
  around(inner) {
    const solid = Number(inner);  // a picture has fewer edges than a number has bits
    const edges = this.names.map(() => []);
    this.edges.forEach(([i, j], edge) => {
      if ((solid >> edge & 1) === 0) return;
      edges[i].push(edge);
      edges[j].push(edge);
    });
    return edges;
  }
  hasPort(node) { return node < this.k && has(this.ports, node); }
  /// The triangles that no solid edge leads away from.
  alone(inner) {
    return this.around(inner).flatMap((edges, node) => (edges.length === 0 && !this.hasPort(node) ? [node] : []));
  }
  /// The fault of a colouring: { kind, triangles, edges, ports }, or null if it is sound. `kind` is 'branch' (a
  /// triangle has three solid edges), 'cycle' (inside) or 'join' (two ports that were not joined before).
  fault(inner) {
    const around = this.around(inner);
    for (const [node, edges] of around.entries()) {
      const ports = this.hasPort(node) ? [node] : [];
      if (edges.length + ports.length > 2) return { kind: 'branch', triangles: [node], edges, ports };
    }
    // Every triangle has at most two solid edges, so a path from an end is a strip, and a component without an end is a
    // cycle.
    const seen = new Set();
    const follow = (from) => {
      const way = { triangles: [from], edges: [] };
      seen.add(from);
      for (let node = from;;) {
        const edge = around[node].find((e) => !way.edges.includes(e));
        if (edge === undefined) return way;
        way.edges.push(edge);
        node = this.edges[edge].find((end) => end !== node);
        if (seen.has(node)) return way;
        seen.add(node);
        way.triangles.push(node);
      }
    };
    for (const [node, edges] of around.entries()) {
      if (seen.has(node) || edges.length > 1) continue;
      const way = follow(node);
      const ports = [...new Set([way.triangles[0], way.triangles.at(-1)])].filter((end) => this.hasPort(end));
      if (ports.length === 2 && !this.pairs.some((pair) => ports.every((port) => pair.includes(port)))) return { kind: 'join', ...way, ports };
    }
    for (const node of around.keys())
      if (!seen.has(node)) return { kind: 'cycle', ...follow(node), ports: [] };
    return null;
  }
}

/// The patch before with the most solid edges of those that have a key (ports, joined pairs; docs/reference/certificate.md).
export function fullest(k, ports, joined) {
  const wanted = BigInt(joined);
  const solid = Number(ports);
  let [best, most] = [null, -1];
  for (let loop = 0; loop + 1 < 1 << k; ++loop) {
    const before = loop << 1 | loop >> k - 1;  // bit i: e_{i-1}
    if ((solid & loop & before) !== 0 || bitsIn(loop) <= most) continue;
    if (pairsMask(joinedPairs(k, loop, ports)) === wanted) [best, most] = [BigInt(loop), bitsIn(loop)];
  }
  return best;
}
