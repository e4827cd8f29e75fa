// The puzzles of the part Your turn: every rule of the certificate of splits, small vertices first, and among equal ones those that
// real meshes meet most often (web/puzzles.py); one of them for each day; and patches from elsewhere.
import { listed, representative, ruleName } from './patch.mjs';
import { Puzzle, fullest, bitsIn } from './judge.mjs';

// The reasons of a certificate (docs/reference/certificate.md, "Reasons"): sets of edges of which not all can be solid, under cases.

/// The lists of a reason, each with the edges that its case settles: [{ solid, dashed, sets }], all masks.
export function casesOf(text) {
  const words = text.split(' ');
  const take = (wanted) => {
    const word = words.shift();
    if (word !== wanted) throw new Error(`a reason has ${word} in place of ${wanted}`);
  };
  const read = (solid, dashed) => {
    if (words[0] === 'if') {
      words.shift();
      const edge = 1n << BigInt(words.shift());
      take('then');
      const first = read(solid | edge, dashed);
      take('else');
      return [...first, ...read(solid, dashed | edge)];
    }
    const sets = [];
    for (; words.length > 0 && words[0] !== 'else'; words.shift()) if (words[0] !== '-') sets.push(BigInt(`0x${words[0]}`));
    return [{ solid, dashed, sets }];
  };
  const cases = read(0n, 0n);
  if (words.length > 0) throw new Error(`a reason continues with ${words[0]}`);
  return cases;
}

/// What each case shows for any sound colouring in it: why its sets cannot be all solid, the least number of dashed
/// edges, and the triangles that are isolated in a colouring with this number. Throws if a case does not show that no
/// sound colouring has fewer dashed edges than `inner`, or the same number and fewer isolated triangles.
export function shown(puzzle, text, inner) {
  const edges = puzzle.edges.length;
  const all = (1n << BigInt(edges)) - 1n;
  const [dashed, isolated] = [edges - bitsIn(inner), puzzle.isolated(inner).length];
  return casesOf(text).map(({ solid, dashed: settled, sets }) => {
    let met = solid | settled;
    const why = sets.map((set) => {
      if (set === 0n || (set & met) !== 0n || (set & ~all) !== 0n) throw new Error(`a set of a reason of ${puzzle.name} has edges that are met already`);
      met |= set;
      const fault = puzzle.fault(set | solid);
      if (!fault) throw new Error(`${puzzle.name}: a set of its reason can be all solid`);
      return { set, fault };
    });
    const least = bitsIn(settled) + sets.length;
    const single = sets.filter((set) => bitsIn(set) === 1).reduce((mask, set) => mask | set, settled);
    const left = puzzle.isolated(all & ~single);
    const enough = least > dashed || (least === dashed && left.length >= isolated);
    if (!enough) throw new Error(`${puzzle.name}: its reason shows too little`);
    return { solid, dashed: settled, why, least, left };
  });
}

/// A mask of inner edges, of the patch that a map of triangles t_i leads to, as one of the patch itself.
export function movedBack(puzzle, map, mask) {
  const { k, edges } = puzzle;
  const places = new Map(edges.map(([i, j], edge) => [`${Math.min(i, j)} ${Math.max(i, j)}`, edge]));
  for (const [A, D] of [[k, k + 1], [k + 1, k]]) {
    const node = (i) => (i === k ? A : i === k + 1 ? D : map(i));
    const images = edges.map(([i, j]) => places.get(`${Math.min(node(i), node(j))} ${Math.max(node(i), node(j))}`));
    if (images.includes(undefined)) continue;
    return images.reduce((out, image, edge) => (BigInt(mask) >> BigInt(image) & 1n ? out | 1n << BigInt(edge) : out), 0n);
  }
  throw new Error(`${puzzle.name}: not a symmetry of the patch`);
}

/// The same of the numbers and masks of a reason.
export const reasonBack = (puzzle, map, text) => text.split(' ').map((word, n, words) => {
  if (['if', 'then', 'else', '-'].includes(word)) return word;
  const edge = words[n - 1] === 'if';
  const back = movedBack(puzzle, map, edge ? 1n << BigInt(word) : BigInt(`0x${word}`));
  return edge ? `${back.toString(2).length - 1}` : back.toString(16);
}).join(' ');

/// Vertices of more triangles are too crowded to draw.
export const largestPuzzle = 24;

export class Puzzles {
  #rows;
  #numbers;

  constructor(text) {
    const [counted, ...columns] = text.trim().split('\n');
    this.counted = Number(counted);  // splits of real meshes
    const [met, k, a, ports, joined, reasons] = columns.map((column) => column.split(','));
    this.#rows = reasons.map((reason, n) => ({ met: +met[n], k: +k[n], a: +a[n], ports: BigInt(`0x${ports[n]}`), joined: BigInt(`0x${joined[n]}`), reason }))
      .sort((one, other) => one.k - other.k || other.met - one.met);
    this.#numbers = new Map(this.#rows.map((row, n) => [ruleName(row.k, row.a, row), n]));
  }
  get count() { return this.#rows.length; }
  /// The number of splits of real meshes that use it.
  met(n) { return this.#rows[n].met; }
  /// The puzzle of a day, by days since 1970: not an easy one, and one from real meshes.
  daily(day) {
    const numbers = this.#rows.flatMap(({ k, met }, n) => (k >= 5 && k <= 7 && met > 0 ? [n] : []));
    return numbers[day * 7919 % numbers.length];
  }
  at(n) {
    const { k, a, ports, joined } = this.#rows[n];
    return new Puzzle(k, a, fullest(k, ports, joined), ports);
  }
  /// A valid patch from elsewhere; seen from its other new triangle if the tables have it so.
  of({ k, a, loop, ports }) {
    const seen = listed(k, a, BigInt(loop), BigInt(ports));
    return new Puzzle(k, seen.a, seen.loop, seen.ports);
  }
  /// The rule of a puzzle: its number, its name in the atlas, and its reason for this patch. Null beyond the
  /// certificate.
  find(puzzle) {
    const { k, a, loop, ports } = puzzle;
    if (k > 8) return null;
    const key = representative(k, a, loop, ports);
    const rule = ruleName(k, a, key);
    const index = this.#numbers.get(rule);
    if (index === undefined) throw new Error(`the certificate has no rule ${rule}`);
    return { index, rule, reason: reasonBack(puzzle, key.map, this.#rows[index].reason) };
  }
  /// The puzzle that a link names, or null.
  named(text, restrip) {
    const found = /^(\d{1,2})-(\d{1,2})-([0-9a-f]{1,6})-([0-9a-f]{1,6})$/.exec(text ?? '');
    if (!found) return null;
    const [k, a] = [+found[1], +found[2]];
    const [loop, ports] = [found[3], found[4]].map((mask) => BigInt(`0x${mask}`));
    const within = k >= 3 && k <= largestPuzzle && a >= 1 && a < k && (loop | ports) < 1n << BigInt(k);
    return within && restrip.rule({ family: 'split', k, a, edges: loop, ports }).valid ? this.of({ k, a, loop, ports }) : null;
  }
}
