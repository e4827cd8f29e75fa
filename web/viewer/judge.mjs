// Judges a colouring of the patch after a split by the definition (docs/reference/notation.md), in the words of
// `restrip-verify explain` (verify/explain/explanation.cpp).
import { has, joinedPairs, pairsMask, ringEdges } from './patch.mjs';

/// The triangles of the patch after a split by name: t0 to t_{k-1}, A and D.
export const namesOf = (k) => [...Array.from({ length: k }, (_, i) => `t${i}`), 'A', 'D'];
/// The numbers of the bits, and how many they are.
export const bitsOf = (mask) => [...mask.toString(2)].reverse().flatMap((bit, n) => (bit === '1' ? [n] : []));
export const bitsIn = (mask) => BigInt(mask).toString(2).replaceAll('0', '').length;

/// A patch that is split, with its colours before.
export class Puzzle {
  constructor(k, a, loop, ports) {
    [this.k, this.a, this.loop, this.ports] = [k, a, BigInt(loop), BigInt(ports)];
    this.edges = ringEdges(k, a);
    this.names = namesOf(k);
    // Pairs of solid ports that may be connected outside, because they are not connected inside before.
    const joined = joinedPairs(k, this.loop, this.ports);
    const solid = bitsOf(this.ports);
    this.worlds = solid.flatMap((p) => solid.filter((q) => p < q && !joined.some((pair) => pair.includes(p) && pair.includes(q))).map((q) => [p, q]));
  }
  get name() { return [this.k, this.a, this.loop.toString(16), this.ports.toString(16)].join('-'); }
  /// Inner edges by the names of their triangles.
  edgeNames(mask, between = '=') { return bitsOf(mask).map((edge) => this.edges[edge].map((node) => this.names[node]).join(between)).join(' '); }
  /// Strips, counted inside the patch: before the split, and after it with these inner edges if they close no cycle.
  get before() { return this.k - bitsIn(this.loop); }
  after(inner) { return this.k + 2 - bitsIn(inner); }
  /// The triangles without a solid edge, and how many they were before.
  isolated(inner) {
    const used = new Set([...bitsOf(this.ports), ...bitsOf(inner).flatMap((edge) => this.edges[edge])]);
    return this.names.flatMap((_, node) => (used.has(node) ? [] : [node]));
  }
  get isolatedBefore() {
    const used = new Set([...bitsOf(this.ports), ...bitsOf(this.loop).flatMap((edge) => [edge, (edge + 1) % this.k])]);
    return this.k - used.size;
  }
  /// The connected component of each triangle; null if a triangle has three solid edges or a cycle is solid. `world`:
  /// two ports that are connected outside, or none.
  #components(inner, ports, world) {
    const of = this.names.map((_, node) => node);
    const degree = this.names.map((_, node) => ports >> node & 1);
    const solid = this.edges.filter((_, edge) => inner >> edge & 1);
    for (const node of solid.flat()) if (++degree[node] > 2) return null;
    if (world.length > 0 && world.every((port) => ports >> port & 1)) solid.push(world);
    for (const [i, j] of solid) {
      const [from, to] = [of[i], of[j]];
      if (from === to) return null;
      of.forEach((component, node) => { if (component === from) of[node] = to; });
    }
    return of;
  }
  /// A smallest set of edges that cannot all be solid, or null if the colouring is sound: { inner, ports, world,
  /// triangle }. In `world`, the first one with the fewest connections, they close a cycle, unless the triangle has three
  /// solid edges.
  fault(colors) {
    let [inner, ports] = [Number(colors), Number(this.ports)];  // a picture has fewer edges than a number has bits
    const of = this.#components(inner, ports, []);
    const world = of ? this.worlds.find(([p, q]) => of[p] === of[q]) : [];
    if (!world) return null;
    this.edges.forEach((_, edge) => { if (inner >> edge & 1 && !this.#components(inner ^ 1 << edge, ports, world)) inner ^= 1 << edge; });
    for (const port of bitsOf(ports)) if (!this.#components(inner, ports ^ 1 << port, world)) ports ^= 1 << port;
    const ends = bitsOf(inner).flatMap((edge) => this.edges[edge]).concat(bitsOf(ports));
    const triangle = ends.find((node) => ends.filter((end) => end === node).length > 2) ?? null;
    return { inner, ports, world, triangle };
  }
  /// What the edges of a fault do together, and the same with the edges.
  effect({ triangle, world }) {
    if (triangle !== null) return `triangle ${this.names[triangle]} has 3 solid edges`;
    return world.length === 0 ? 'a cycle' : `a cycle with ports ${world.join('-')} connected outside`;
  }
  faultText(fault) {
    const ports = bitsOf(fault.ports);
    const listed = ports.length > 0 ? `, port${ports.length === 1 ? '' : 's'} ${ports.join(' ')}` : '';
    return `${this.edgeNames(fault.inner)}${listed}: ${this.effect(fault)}`;
  }
  /// What a sound colouring changes: "strips +1, isolated +0".
  change(inner) {
    const [strips, isolated] = [this.after(inner) - this.before, this.isolated(inner).length - this.isolatedBefore];
    return `strips ${strips < 0 ? '' : '+'}${strips}, isolated ${isolated < 0 ? '' : '+'}${isolated}`;
  }
  /// Compares a colouring with the rule: { verdict, because, fault }.
  judged(inner, rule) {
    const fault = this.fault(inner);
    if (fault?.world.length === 0) return { verdict: 'not valid', because: this.faultText(fault), fault };
    if (fault) return { verdict: 'unsound', because: `${this.faultText(fault)}, and none before`, fault };
    const [mine, its] = [inner, rule].map((colors) => ({ strips: this.after(colors) - bitsIn(this.ports), 'isolated + given_up': this.isolated(colors).length }));
    const higher = Object.keys(mine).find((criterion) => mine[criterion] !== its[criterion]);
    if (higher) return { verdict: 'worse', because: `${higher} ${mine[higher] - its[higher]} above the best`, fault };
    if (inner === rule) return { verdict: 'best', because: '', fault };
    return { verdict: 'equally good', because: 'costs the same as the best; only a tie-break decides between them', fault };
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
