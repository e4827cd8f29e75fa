// The logic of the viewer's part Your turn, in Node. A colouring is sound for the page exactly if it is by the
// definition, counted another way: for all colourings of patches up to k = 4, for a fifth of the colourings of k = 5,
// and for random ones of larger patches. A fault that the page names exists in the colouring. No sound colouring of a
// fully tried patch is better than the library's rule. Each rule of the certificate is a puzzle, whose patch before is
// valid and has its key. Its reason shows, as the page checks it, that the library's rule is best; so does the reason
// of a random patch, moved from the row of its orbit. Reasons that are altered are refused.
//   node puzzle_test.mjs WEB_FOLDER
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Puzzle, bitsIn, fullest } from '../../web/viewer/judge.mjs';
import { Puzzles, casesOf, shown } from '../../web/viewer/puzzles.mjs';

const [folder] = process.argv.slice(2);
const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')));
const restrip = await load();
const puzzles = new Puzzles(readFileSync(join(folder, 'puzzles.txt'), 'ascii'));
const rule = ({ k, a, loop, ports }) => restrip.rule({ family: 'split', k, a, edges: loop, ports });
let seed = 5;
const random = (n) => (seed = seed * 48271 % 2147483647) % n;
const bit = (mask, n) => (Number(mask) >> n) & 1;

/// The connected component of each node.
function components(count, edges) {
  const of = Array.from({ length: count }, (_, i) => i);
  for (const [i, j] of edges) { const [p, q] = [of[i], of[j]]; of.forEach((c, n) => { if (c === p) of[n] = q; }); }
  return of;
}
const fanComponents = (k, loop) => components(k, Array.from({ length: k }, (_, i) => [i, (i + 1) % k]).filter((_, i) => bit(loop, i)));

/// Soundness by counting: solid degrees; a component with N edges and N triangles has a cycle; ports in one component.
function isSound(k, a, loop, ports, inner) {
  const before = fanComponents(k, loop);
  // In the numbering of docs/reference/notation.md: A, t_0 to t_{a-1}, D, t_a to t_{k-1} in a ring, and the chord.
  const order = ['A', ...Array.from({ length: a }, (_, i) => i), 'D', ...Array.from({ length: k - a }, (_, i) => a + i)];
  const edges = [...order.map((name, n) => [name, order[(n + 1) % order.length]]), ['A', 'D']];
  const number = (name) => (name === 'A' ? k : name === 'D' ? k + 1 : name);
  const solid = edges.filter((_, n) => bit(inner, n)).map((pair) => pair.map(number));
  const after = components(k + 2, solid);
  for (let t = 0; t < k + 2; ++t) if (solid.flat().filter((end) => end === t).length + (t < k ? bit(ports, t) : 0) > 2) return false;
  for (const c of new Set(after)) if (solid.filter(([i]) => after[i] === c).length >= after.filter((d) => d === c).length) return false;
  for (let p = 0; p < k; ++p)
    for (let q = 0; q < p; ++q) if (bit(ports, p) && bit(ports, q) && after[p] === after[q] && before[p] !== before[q]) return false;
  return true;
}

/// The fault lies in the colouring, and no edge of it is too many: three edges of one triangle, or exactly one cycle,
/// which may pass outside between two ports that are not connected before.
function hasFault({ k, loop, edges, ports }, inner, { inner: set, ports: used, world, triangle }) {
  assert.ok((BigInt(set) & ~BigInt(inner)) === 0n && (BigInt(used) & ~ports) === 0n);
  const solid = edges.filter((_, edge) => bit(set, edge));
  for (let port = 0; port < k; ++port) if (bit(used, port)) solid.push([port, k + 2 + port]);
  if (triangle !== null) return world.length === 0 && solid.length === 3 && solid.every((ends) => ends.includes(triangle));
  const before = fanComponents(k, loop);
  if (world.length > 0 && before[world[0]] === before[world[1]]) return false;
  if (world.length > 0) solid.push(world.map((port) => k + 2 + port));
  const of = components(2 * k + 2, solid);
  const ends = solid.flat();
  return ends.every((node) => ends.filter((end) => end === node).length === 2 && of[node] === of[ends[0]]);
}

const kinds = { branch: 0, cycle: 0, join: 0, sound: 0 };
function check(puzzle, inner) {
  const fault = puzzle.fault(inner);
  assert.equal(fault === null, isSound(puzzle.k, puzzle.a, puzzle.loop, puzzle.ports, inner), `${puzzle.name}, ${inner}`);
  if (fault) assert.ok(hasFault(puzzle, inner, fault), `${puzzle.name}, ${inner}: ${JSON.stringify(fault)}`);
  ++kinds[!fault ? 'sound' : fault.triangle !== null ? 'branch' : fault.world.length > 0 ? 'join' : 'cycle'];
  return fault === null;
}

// Every puzzle of the certificate: small vertices first, and among equal ones those that are met most often.
let before = { k: 0 };
assert.ok(puzzles.count > 5000 && puzzles.at(0).k === 3 && puzzles.at(puzzles.count - 1).k === 8);
const cases = new Set();
for (let n = 0; n < puzzles.count; ++n) {
  const puzzle = puzzles.at(n);
  assert.ok(before.k < puzzle.k || (before.k === puzzle.k && before.met >= puzzles.met(n)), puzzle.name);
  before = { k: puzzle.k, met: puzzles.met(n) };
  const best = rule(puzzle);
  assert.ok(best.valid && best.strips === puzzle.after(best.colors) - puzzle.before, puzzle.name);
  assert.ok(check(puzzle, best.colors));
  const { index, reason } = puzzles.find(puzzle);
  assert.equal(index, n);
  const lists = shown(puzzle, reason, best.colors);
  cases.add(lists.length);
  for (const { why, solid } of lists) for (const { set, fault } of why) assert.ok(hasFault(puzzle, set | solid, fault));
  if (puzzle.k > 5 || (puzzle.k === 5 && n % 5 > 0)) continue;
  for (let inner = 0n; inner < 1n << BigInt(puzzle.edges.length); ++inner) {
    if (!check(puzzle, inner)) continue;
    const [mine, its] = [inner, best.colors].map((colors) => [puzzle.after(colors), puzzle.isolated(colors).length]);
    assert.ok(mine[0] > its[0] || (mine[0] === its[0] && mine[1] >= its[1]), `${puzzle.name}: ${inner} is better than the rule`);
  }
}
assert.ok(cases.has(1) && Math.max(...cases) > 2, `cases: ${[...cases]}`);

// Random patches, up to k = 8 with the reason of another one's row, beyond without.
let moved = 0;
for (let tries = 0; moved < 2000; ++tries) {
  const k = 3 + random(8);
  const given = { k, a: 1 + random(k - 1), loop: BigInt(random(1 << k)), ports: BigInt(random(1 << k)) };
  if (!rule(given).valid) continue;
  const puzzle = puzzles.of(given);
  assert.ok(2 * puzzle.a <= k && rule(puzzle).strips === rule(given).strips);
  const best = rule(puzzle).colors;
  assert.ok(check(puzzle, best));
  check(puzzle, BigInt(random(1 << k + 3)));
  // The ring, and the chord with either side of it, in a patch that no strip enters.
  const [chord, ring, side] = [1 << k + 2, (1 << k + 2) - 1, (2 << puzzle.a) - 1];
  for (const cycle of [ring, chord | side, chord | (ring & ~side)]) assert.ok(!check(new Puzzle(k, puzzle.a, 0n, 0n), BigInt(cycle)));
  const { index, reason } = puzzles.find(puzzle) ?? { index: null };
  assert.equal(index === null, k > 8);
  if (index === null) continue;
  shown(puzzle, reason, best);
  ++moved;
}
for (const [kind, count] of Object.entries(kinds)) assert.ok(count > 100, `${kind}: ${count}`);

// Altered reasons: a set that can be all solid, one set less, a set twice, edges that do not exist, half a reason.
const altered = { less: 0, smaller: 0 };
for (let n = 0; n < 200; ++n) {
  const puzzle = puzzles.at(n);
  const { reason } = puzzles.find(puzzle);
  const best = rule(puzzle).colors;
  if (reason.includes('if')) continue;
  const sets = reason.split(' ');
  assert.throws(() => shown(puzzle, sets.slice(1).join(' ') || '-', best), /shows too little/);
  assert.throws(() => shown(puzzle, `${reason} ${sets[0]}`, best), /met already/);
  assert.throws(() => shown(puzzle, `${reason} ${(1 << puzzle.edges.length).toString(16)}`, best), /met already/);
  ++altered.less;
  const solid = sets.findIndex((set) => bitsIn(best & BigInt(`0x${set}`)) > 0);
  if (solid < 0) continue;
  sets[solid] = (best & BigInt(`0x${sets[solid]}`)).toString(16);
  assert.throws(() => shown(puzzle, sets.join(' '), best), /can be all solid/);
  ++altered.smaller;
}
assert.ok(altered.less > 50 && altered.smaller > 50, JSON.stringify(altered));
for (const wrong of ['if 3 then 1 4', 'if 3 1 else 2', '1 else 2', 'if 3 then 1 else 2 else 4']) assert.throws(() => casesOf(wrong), /a reason/);

// What a link may say.
for (const text of ['', '6-3', '6-3-f-zz', '2-1-0-0', '25-3-0-0', '6-0-0-0', '6-6-0-0', '6-3-3f-0', '6-3-40-0', '6-3-3-7', '6-3-1-1-1'])
  assert.equal(puzzles.named(text, restrip), null, text);
assert.equal(puzzles.named('6-3-1-1', restrip).name, '6-3-1-1');
assert.equal(puzzles.named('6-4-1-0', restrip).a, 2);
assert.equal(fullest(3, 7n, 7n), null);
console.log(`${puzzles.count} puzzles; ${Object.entries(kinds).map(([kind, count]) => `${kind} ${count}`).join(', ')}`);
