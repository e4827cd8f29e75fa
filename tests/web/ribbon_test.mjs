// Ribbons as the viewer paints them, on the hare under a policy. Laid flat, no triangle is turned over or larger than its place, a strip
// hangs together within a row, neighbours in a strip share two corners with their order, and all lie in the window. A large ribbon is
// painted in parts, one a call, and only while the mesh rests; a small one at once. Only the triangles of a patch keep
// their colours when a patch is set off from the rest.
//   node ribbon_test.mjs WEB_FOLDER
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Painter, Ribbon } from '../../web/viewer/ribbon.mjs';

const [folder] = process.argv.slice(2);
const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')).href);
const restrip = await load(readFileSync(join(folder, 'package/restrip.wasm')));
const mesh = restrip.baked(readFileSync(join(folder, 'hare.baked'))).begin({ policy: 'local' });
mesh.moveTo(2000);
const ribbon = new Ribbon(mesh.ribbon);
assert.ok(ribbon.strips.length > 20 && ribbon.count === mesh.figures.triangles);

for (const aspect of [0.5, 1.7]) {
  const flat = ribbon.flat(aspect);
  const place = (i, corner) => [...flat.subarray(9 * i + 3 * corner, 9 * i + 3 * corner + 3)];
  let rows = 0;
  let total = 0;
  for (const { first, count } of ribbon.strips) {
    for (let i = first; i < first + count; ++i) {
      const [a, b, c] = [0, 1, 2].map((corner) => place(i, corner));
      const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      assert.ok(area > 0, `triangle ${i} is turned over`);
      total += area / 2;
      for (const [x, y, t] of [a, b, c]) assert.ok(Math.abs(x) <= 1 && Math.abs(y) <= 1 && t >= 0 && t <= 1, `triangle ${i} at ${x}, ${y}, ${t}`);
      if (i === first) continue;
      const before = new Map([...ribbon.corners(i - 1)].map((v, corner) => [v, place(i - 1, corner)]));
      const shared = [...ribbon.corners(i)].map((v, corner) => [before.get(v), place(i, corner)]).filter(([there]) => there);
      assert.equal(shared.length, 2);
      assert.ok(shared.every(([there, here]) => there[2] === here[2]), `triangles ${i - 1} and ${i} part while they are peeled`);
      if (shared.some(([there, here]) => Math.hypot(there[0] - here[0], there[1] - here[1]) > 1e-5)) ++rows;
    }
  }
  // Rows break few strips, and the bands fill a good part of the window's area of 4.
  assert.ok(rows < 60 && total > 1.5 && total < 4, `${rows} breaks, area ${total}`);
}

const parts = [];
const scene = { paint: (vertices) => parts.push(vertices.length) };
const painted = (count, resting) => {
  // One strip of triangles in a row.
  const data = new Uint32Array(9 * count);
  for (let i = 0; i < count; ++i) data.set([i, i, i + 1, i + 2, 0xffffffff, i + 1 < count ? i + 1 : 0xffffffff, i > 0 ? i - 1 : 0xffffffff, (i + 1 < count ? 2 : 0) | (i > 0 ? 4 : 0), 0], 9 * i);
  let reads = 0;
  const painter = new Painter(scene);
  painter.ribbon = { count, names: [], next: 0 };
  const left = [];
  for (let n = 0; n < 4; ++n) left.push(painter.paint(() => (++reads, data), new Float32Array(3 * count + 6), resting));
  return { left, reads, painted: parts.splice(0) };
};
assert.deepEqual(painted(100, false), { left: [0, 0, 0, 0], reads: 1, painted: [1800] });
assert.deepEqual(painted(17000, true), { left: [2, 1, 0, 0], reads: 1, painted: [306000] });
assert.deepEqual(painted(17000, false), { left: [3, 3, 3, 3], reads: 0, painted: [] });

const only = new Set([ribbon.triangle(0)]);
const [usual, reported] = [{}, { only }].map((how) => new Uint32Array(ribbon.vertices(mesh.points, how).buffer));
const colors = (words) => Array.from({ length: ribbon.count }, (_, i) => words[18 * i + 3]);
const differing = colors(usual).map((word, i) => (word & 0xffffff) !== (colors(reported)[i] & 0xffffff)).filter(Boolean).length;
assert.ok(differing > 0.99 * (ribbon.count - 1) && (colors(usual)[0] & 0xffffff) === (colors(reported)[0] & 0xffffff), `${differing}`);
assert.equal(colors(reported)[0] >>> 27 & 7, 7, 'a patch of one triangle has three sides at its rim');
