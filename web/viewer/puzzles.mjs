// The puzzles of the part Your turn: every rule of the certificate of splits, small vertices first, and among equal ones those that
// real meshes meet most often (web/puzzles.py); one of them for each day; and patches from elsewhere.
import { listed, representative, ruleName } from './patch.mjs';
import { Puzzle, fullest } from './judge.mjs';
import { reasonBack } from './reason.mjs';

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
