// The viewer's part Your turn judges as `restrip-verify explain` does, in the same words: the verdict and its sentence,
// the set of edges that cannot all be solid, and the change of strips and isolated triangles. Compared are one recolouring
// of every configuration up to k = 6, by `restrip-verify rules`, and some by `explain`; the viewer's pictures of these
// mark the same numbers of edges and of connections outside.
//   node explain_test.mjs WEB_FOLDER RESTRIP_VERIFY SCRATCH
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Puzzle, bitsIn } from '../../web/viewer/judge.mjs';
import { fanPicture, ringPicture } from '../../web/viewer/patch.mjs';

const [folder, program, scratch] = process.argv.slice(2);
mkdirSync(scratch, { recursive: true });
const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')));
const restrip = await load();
const rule = ({ k, a, loop, ports }) => restrip.rule({ family: 'split', k, a, edges: loop, ports });
let seed = 7;
const random = (n) => (seed = seed * 48271 % 2147483647) % n;
function verify(...words) {
  const { status, stdout, stderr } = spawnSync(program, [...words, '--json', '-'], { encoding: 'utf8', maxBuffer: 1 << 28 });
  assert.ok(status === 0 || status === 1, `${words.join(' ')}: ${stderr}`);
  return JSON.parse(stdout);
}

/// Random colours, few or many solid, and some that differ from the rule by an edge or two.
function recoloring({ k }, best) {
  const [some, other, bits] = [random(1 << k + 3), random(1 << k + 3), [random(k + 3), random(k + 3)]];
  return [BigInt(some), BigInt(some & other), best ^ 1n << BigInt(bits[0]), best & ~(1n << BigInt(bits[0]) | 1n << BigInt(bits[1]))][random(4)];
}

const verdicts = {};
const shown = [];
for (let k = 3; k <= 6; ++k) {
  const rows = [];
  for (let a = 1; 2 * a <= k; ++a)
    for (let loop = 0; loop < 1 << k; ++loop)
      for (let ports = 0; ports < 1 << k; ++ports) {
        const found = rule({ k, a, loop: BigInt(loop), ports: BigInt(ports) });
        if (!found.valid) continue;
        const puzzle = new Puzzle(k, a, loop, ports);
        const best = BigInt(found.colors);
        const mine = recoloring(puzzle, best);
        rows.push({ puzzle, mine, ...puzzle.judged(mine, best) });
      }
  const file = join(scratch, `rules-${k}.csv`);
  writeFileSync(file, ['k,a,loop,ports,inner', ...rows.map(({ puzzle, mine }) => [k, puzzle.a, puzzle.loop, puzzle.ports, mine].join())].join('\n') + '\n');
  const report = verify('rules', file, '--worst', String(rows.length));
  assert.deepEqual([report.rows, report.not_configurations, report.configurations_without_row], [rows.length, 0, 0]);
  const bad = new Map(report.worst.map(({ line, verdict, because }) => [line - 2, `${verdict}: ${because}`]));
  rows.forEach(({ puzzle, mine, verdict, because }, n) => {
    verdicts[verdict] = (verdicts[verdict] ?? 0) + 1;
    const good = verdict === 'best' || verdict === 'equally good';
    assert.equal(good ? undefined : `${verdict}: ${because}`, bad.get(n), `${puzzle.name}, ${mine.toString(16)}`);
  });
  for (const wanted of ['not valid', 'unsound', 'worse', 'equally good', 'best']) {
    const all = rows.filter(({ verdict }) => verdict === wanted);
    for (let n = 0; n < 3 && all.length > 0; ++n) shown.push(all[random(all.length)]);
  }
}
for (const verdict of ['not valid', 'unsound', 'worse', 'equally good', 'best']) assert.ok(verdicts[verdict] > 15, JSON.stringify(verdicts));

const count = (text, what) => text.split(what).length - 1;
for (const { puzzle, mine } of shown) {
  const { k, a, loop, ports } = puzzle;
  const hex = (mask) => mask.toString(16);
  const said = verify('explain', '--family', 'split', '--k', String(k), '--at', String(a), '--before', String(loop), '--ports', String(ports), '--after', String(mine));
  // The best of the smallest mask; a table may have another.
  const { verdict, because, fault } = puzzle.judged(mine, BigInt(`0x${said.best.inner}`));
  assert.deepEqual([verdict, because], [said.verdict, said.because], puzzle.name);
  assert.deepEqual(fault && [hex(fault.inner), hex(fault.ports)], said.obstacle && [said.obstacle.inner, said.obstacle.ports]);
  assert.deepEqual(fault && (fault.world.length > 0 ? [fault.world] : []), said.obstacle && said.obstacle.world);
  const { strips, isolated } = said.recolouring;
  const signed = (n) => (n < 0 ? `${n}` : `+${n}`);
  assert.equal(puzzle.change(mine), `strips ${signed(strips)}, isolated ${signed(isolated)}`);
  const after = ringPicture(k, a, mine, ports, '', { named: true, fault });
  const before = fanPicture(k, a, loop, ports, '', { world: fault?.world });
  const { inner, ports: among, world } = said.obstacle ?? { inner: '0', ports: '0', world: [] };
  assert.equal(count(/class="solid marked" d="([^"]*)"/.exec(after)?.[1] ?? '', 'M'), bitsIn(parseInt(inner, 16)) + bitsIn(parseInt(among, 16)));
  assert.equal(count(before, 'class="outside"') + count(after, 'class="outside"'), 2 * world.length);
  for (const name of puzzle.names) assert.ok(after.includes(`>${name}</text>`), name);
}
console.log(`${Object.entries(verdicts).map(([verdict, n]) => `${verdict} ${n}`).join(', ')}; ${shown.length} pictures`);
