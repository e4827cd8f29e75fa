// Reads restrip_tables.json by restrip_tables.mjs, asks everything, and prints digests of what it answers, as
// `restrip-dump-tables --digests` does: a line for each operation, 0, 1 and 6, and position: "operation k p q digest".
//   node restrip_tables_check.mjs [K]
import { readFileSync } from 'node:fs';
import { Tables } from './restrip_tables.mjs';

const tables = new Tables(JSON.parse(readFileSync(new URL('restrip_tables.json', import.meta.url), 'utf8')));
const maxK = Number(process.argv[2] ?? tables.json.max_k);

function mix(before, ports, answer) {
  let h = answer ^ Math.imul(before, 0x9e3779b1) ^ Math.imul(ports, 0x85ebca77);
  h = Math.imul(h ^ h >>> 16, 0x85ebca6b);
  h = Math.imul(h ^ h >>> 13, 0xc2b2ae35);
  return h ^ h >>> 16;
}
const packed = (rule, colors) => (rule ? 0x80000000 | rule.strips + 8 << 16 | colors : 0);

function line(operation, [k, p], beforeBits, portBits, answer) {
  let digest = 0;
  for (let before = 0; before >> beforeBits === 0; ++before)
    for (let ports = 0; ports >> portBits === 0; ++ports) digest = digest + mix(before, ports, answer(before, ports)) | 0;
  console.log(operation, k, p, 0, (digest >>> 0).toString(16).padStart(8, '0'));
}

const inside = (k, p) => k >= 3 && k <= tables.json.max_k && p >= 1 && p < k;

let outside = 0;
tables.json.operations.forEach(({ name, before_bits }, operation) => {
  if (name === 'flip')
    return line(6, [0, 0], 1, 4, (inner, ports) => {
      const rule = tables.flip(inner, ports);
      return packed(rule, rule && rule.inner << 4 | rule.ports);
    });
  for (let k = 0; k < 20; ++k)
    for (let p = 0; p < 20; ++p) {
      const place = tables.at(name, [k, p]);
      if (!inside(k, p)) outside += place === null ? 0 : 1;
      else if (k <= maxK)
        line(operation, [k, p], k + before_bits, k, (before, ports) => {
          const rule = place.rule(before, ports);
          return packed(rule, rule?.colors);
        });
    }
});
outside += tables.flip(2, 0) === null && tables.flip(0, 16) === null ? 0 : 1;
console.log(`rules outside the tables: ${outside}`);
