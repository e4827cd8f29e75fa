// Reads restrip_automaton.json by restrip_automaton.mjs, and prints digests of what it answers, as `restrip-dump-tables
// --automaton --digests` does.
//   node restrip_automaton_check.mjs [K]
// A line for each operation, 0 split, 1 collapse, 2 open split, 3 fan collapse and 4 boundary split, and each position with
// k <= K, by default 28: "operation k p q digest". Where a position has at most 7,000 keys all are asked, else 64 that are
// drawn.
import { readFileSync } from 'node:fs';
import { Automaton } from './restrip_automaton.mjs';

const automaton = new Automaton(JSON.parse(readFileSync(new URL('restrip_automaton.json', import.meta.url), 'utf8')));
const maxK = Number(process.argv[2] ?? 28);

function mix(before, ports, answer) {
  let h = answer ^ Math.imul(before, 0x9e3779b1) ^ Math.imul(ports, 0x85ebca77);
  h = Math.imul(h ^ h >>> 16, 0x85ebca6b);
  h = Math.imul(h ^ h >>> 13, 0xc2b2ae35);
  return (h ^ h >>> 16) >>> 0;
}

const folded = (mask) => Number(mask & 0xffffffffn) ^ Math.imul(Number(mask >> 32n), 0x9e3779b1);

/// The keys that are asked for a fan of k triangles: of each port its letter, or masks that are drawn.
function keysOf(k) {
  const count = 3 ** k;
  const drawn = (n, i) => BigInt.asUintN(k, BigInt(mix(n, i, 0)) | BigInt(mix(n, i + 8, 0)) << 32n);
  if (count > 7000)
    return Array.from({ length: 64 }, (_, n) => ({ ports: drawn(n, 0), joined: drawn(n, 1) }));
  return Array.from({ length: count }, (_, n) => {
    const word = [...n.toString(3).padStart(k, '0')].reverse();  // the last port is the lowest digit
    const where = (holds) => BigInt('0b0' + word.map((letter) => Number(holds(Number(letter)))).join(''));
    return { ports: where((x) => x !== 0), joined: where((x) => x === 2) };
  });
}

const operations = { split: 2, collapse: 1, open_split: 3, fan_collapse: 1, boundary_split: 2 };  // numbers of a position
let outside = 0;
Object.entries(operations).forEach(([name, numbers], operation) => {
  for (let k = 0; k < 70; ++k) {
    const keys = k <= maxK ? keysOf(k) : [];
    for (let p = 0; p < (numbers > 1 ? 70 : 1); ++p)
      for (let q = 0; q < (numbers > 2 ? 70 : 1); ++q) {
        const isOpen = operation > 1;
        const inside = k >= (isOpen ? 1 : 3) && (numbers === 1 || (isOpen ? numbers === 3 ? p < q && q <= k : p <= k : p >= 1 && p < k));
        if (!inside) outside += automaton.best(name, [k, p, q], { ports: 0n }) === null ? 0 : 1;
        if (!inside || k > maxK) continue;
        const digest = keys.reduce((sum, key, n) =>
          sum + mix(n, folded(key.ports), 0x80000000 | folded(automaton.best(name, [k, p, q], key))) | 0, 0);
        console.log(operation, k, p, q, (digest >>> 0).toString(16).padStart(8, '0'));
      }
  }
});
console.log(`rules outside the tables: ${outside}`);
