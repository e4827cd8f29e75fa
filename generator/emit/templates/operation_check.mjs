// Prints what restrip_rule_of_@name@.json answers to every configuration, for
//   restrip-verify --operation FILE --header HEADER --dump-command "node THIS_FILE"
// Written by `restrip-generate rules --language json`. Do not edit.
import { readFileSync } from 'node:fs';

const table = JSON.parse(readFileSync(new URL('restrip_rule_of_@name@.json', import.meta.url), 'utf8'));
const names = [
@positions@
];
const count = (mask) => mask.toString(2).replaceAll('0', '').length;
const lines = ['restrip-table-dump 4'];
table.positions.forEach((position, i) => {
  const { before, after, ports: portCount, first } = position;
  lines.push(`table ${names[i]}`);
  for (let inner = 0; inner < (table.matching ? 1 : 1 << before.edges); ++inner)
    for (let ports = 0; ports < 1 << portCount; ++ports) {
      const entry = table.entries[first + (table.matching ? ports : inner << portCount | ports)];
      const kept = entry & ((1 << portCount) - 1);
      const strips = after.triangles - before.triangles - count(entry) + count(inner) + count(ports);
      const rule = entry === table.none ? '-' : `${(entry >>> portCount).toString(16)} ${kept.toString(16)} ${strips}`;
      lines.push(`${inner.toString(16)} ${ports.toString(16)} ${rule}`);
    }
});
process.stdout.write(`${lines.join('\n')}\nend ${lines.length - 1 - names.length}\n`);
