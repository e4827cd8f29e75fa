// The npm package as programs use it: it maintains the same strips as the native program, takes what programs have in hand
// and refuses misuse with a sentence, gives memory back, keeps points in step with undo and redo (a twin copies all points
// in each frame), and is what its package.json and its types say. tests/c has the operations themselves.
//   node package_test.mjs WEB_FOLDER RESTRIP SCRATCH [TSC]
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createServer } from 'node:http';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { standIn } from './use_checks.mjs';

const [folder, program, scratch, tsc] = process.argv.slice(2);
mkdirSync(scratch, { recursive: true });
const { Restrip, load, none, restartIndex } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')));
const { loadReaders } = await import(pathToFileURL(join(folder, 'package/formats.mjs')));
const wasm = readFileSync(join(folder, 'package/restrip.wasm'));
const { readMesh, simplified, simplifying } = await loadReaders();
const restrip = await load();
const file = join(folder, 'hare.pm');
const source = await readMesh('hare.pm', readFileSync(file));

const sorted = (triangles) => {
  const keys = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const t = [triangles[i], triangles[i + 1], triangles[i + 2]];
    const least = t.indexOf(Math.min(...t));
    keys.push([t[least], t[(least + 1) % 3], t[(least + 2) % 3]].join(' '));
  }
  return keys.sort();
};
/// What a graphics card draws of a triangle strip with restarts.
const drawn = (indices) => {
  const out = [];
  let begin = 0;
  for (let i = 0; i < indices.length; ++i) {
    if (indices[i] === restartIndex) begin = i + 1;
    if (i < begin + 2) continue;
    const [a, b, c] = (i - begin) % 2 === 0 ? [indices[i - 2], indices[i - 1], indices[i]] : [indices[i - 1], indices[i - 2], indices[i]];
    if (a !== b && b !== c && c !== a) out.push(a, b, c);
  }
  return out;
};
/// `random(n)`: a number below n.
const randomOf = (seed) => (n) => (seed = (seed * 48271) % 2147483647) % n;

/// A flat grid of n by m vertices.
function grid(n, m) {
  const points = new Float32Array(3 * n * m);
  const triangles = [];
  for (let y = 0; y < m; ++y)
    for (let x = 0; x < n; ++x) {
      const v = y * n + x;
      points.set([x, y, 0], 3 * v);
      if (x > 0 && y > 0) triangles.push(v - n - 1, v - n, v, v - n - 1, v, v - 1);
    }
  return { points, triangles };
}

/// Some operations of every kind on a mesh; what became of them.
function sculpted(mesh, random, count) {
  return Array.from({ length: count }, () => {
    const { triangles } = mesh;
    const t = 3 * random(triangles.length / 3);
    const [a, b, c] = triangles.subarray(t, t + 3);
    return [() => mesh.collapse(a, b), () => mesh.flip(a, b), () => mesh.bisect(a, b), () => mesh.splitFace(a, b, c),
      () => mesh.split(a, mesh.addPoint(a, b, c), b, c)][random(5)]();
  });
}

/// `restrip replay` and the package report the same numbers at all levels, up and down, with an update for every operation.
function sameAsReplay() {
  let compared = 0;
  for (const [policy, cost] of [['local', 'strips'], ['quick', 'indices']]) {
    const reported = join(scratch, `${policy}-${cost}.json`);
    execFileSync(program, ['replay', file, '--policy', policy, '--cost', cost, '--repeats', '0', '--json', reported]);
    const native = JSON.parse(readFileSync(reported, 'utf8'));
    const mesh = restrip.progressive(source).begin({ policy, cost });
    mesh.update();
    const walk = (levels, to) => {
      const byTriangles = new Map(levels.map((level) => [level.triangles, level]));
      for (;;) {
        const { triangles, strips, bufferIndices, played } = mesh.figures;
        const level = byTriangles.get(triangles);
        if (level) {
          assert.deepEqual({ strips, indices: mesh.plainIndices, buffer: bufferIndices }, { strips: level.strips, indices: level.indices, buffer: level.buffer_indices });
          ++compared;
        }
        if (played === to) return;
        mesh.moveTo(played + Math.sign(to - played));
        mesh.update();
      }
    };
    walk(native.levels, mesh.levels);
    assert.deepEqual([mesh.figures.addingStrip, mesh.figures.isolating], [native.operations_adding_strip, native.operations_isolating]);
    walk(native.levels_down, 0);
    const { indicesWritten, operations } = mesh.figures;
    assert.ok(Math.abs(4 * indicesWritten / operations - native.live_buffers[0].bytes_per_operation) < 1e-6);
    assert.ok(mesh.valid);
    mesh.close();
  }
  assert.ok(compared >= 45, `only ${compared} levels were compared`);
}

/// Baked strips: the levels of the progressive mesh, in and out of order, and back by begin(). Damage is refused.
function playsBaked() {
  const bytes = readFileSync(join(folder, 'hare.baked'));
  const mesh = restrip.baked(bytes).begin({ policy: 'baked' });
  const straight = restrip.progressive(source).begin({ policy: 'local' });
  assert.ok(mesh.hasBakedStrips && !straight.hasBakedStrips);
  assert.deepEqual([mesh.levels, mesh.points.length], [straight.levels, source.points.length]);
  for (const level of [1, 700, 699, mesh.levels, 5]) {
    const from = mesh.figures.played;
    assert.equal(mesh.moveTo(level), Math.abs(level - from));
    straight.moveTo(level);
    mesh.update();
    const { triangles } = mesh;
    assert.deepEqual(sorted(triangles), sorted(straight.triangles));
    assert.deepEqual(sorted(drawn(mesh.indices)), sorted(triangles));
    assert.ok(mesh.figures.baked && mesh.figures.inOrder);
  }
  mesh.approach(new Uint8Array(mesh.levels).fill(1, 800, 1000));
  assert.ok(!mesh.figures.baked && !mesh.figures.inOrder && mesh.valid);
  mesh.moveTo(300);
  straight.moveTo(300);
  assert.deepEqual(sorted(mesh.triangles), sorted(straight.triangles));
  assert.ok(!mesh.figures.baked && mesh.begin({ policy: 'baked' }).figures.baked && mesh.moveTo(9) === 9);
  const [a, b, c] = mesh.triangles;
  assert.ok(mesh.flip(a, b).ok || mesh.flip(b, c).ok);
  assert.ok(!mesh.figures.baked && mesh.valid);
  assert.throws(() => straight.begin({ policy: 'baked' }), /no baked strips/);
  mesh.begin({ policy: 'quick' }).moveTo(1000);
  assert.ok(!mesh.figures.baked && mesh.valid);
  for (let at = 0; at < bytes.length; at += 997) {
    const altered = Buffer.from(bytes);
    altered[at] ^= 1 << at % 8;
    for (const wrong of [altered, bytes.subarray(0, at)]) assert.throws(() => restrip.baked(wrong), /^Error: baked mesh: [a-z]/);
  }
  for (const each of [mesh, straight]) each.close();
}

/// Every form and width, for a mesh without records: a copy that gets the ranges alone, in storage made when the update says
/// so, draws the mesh.
function copiesByRanges() {
  for (const form of ['restart', 'stitched', 'lengths', 'list'])
    for (const bits of [16, 32, 'auto']) {
      const mesh = restrip.mesh({ points: source.points, triangles: source.base }).begin({ form, bits });
      let storage = null;
      for (let frame = 0; frame < 12; ++frame) {
        const [join, align] = [[2, 4], [40, 16], [0, 2]][frame % 3];
        const ranges = mesh.update({ join, align });
        const live = mesh.indices;
        assert.equal(live.BYTES_PER_ELEMENT, bits === 32 ? 4 : 2);
        if (ranges.outgrown) storage = new live.constructor(mesh.room).fill(7);
        ranges.forEach(({ first, count }, n) => {
          storage.set(live.subarray(first, first + count), first);
          assert.equal(first * live.BYTES_PER_ELEMENT % align, 0);
          assert.ok(n === 0 || first - ranges[n - 1].first - ranges[n - 1].count > join);
        });
        assert.deepEqual([...storage.subarray(0, live.length)], [...live]);
        const restart = form === 'restart' ? 2 ** (8 * live.BYTES_PER_ELEMENT) - 1 : -1;
        const shown = mesh.draws.flatMap(({ first, count }) => {
          const part = Array.from(storage.subarray(first, first + count));
          return form === 'list' ? part : drawn(part.map((index) => (index === restart ? restartIndex : index)));
        });
        assert.deepEqual(sorted(shown), sorted(mesh.triangles));
        assert.equal(mesh.figures.bufferIndices, mesh.draws.reduce((sum, { count }) => sum + count, 0));
        const done = sculpted(mesh, randomOf(frame + 1), 9).filter(({ ok }) => ok);
        assert.equal(mesh.figures.bufferIndices === null, done.length > 0);
      }
      assert.ok(mesh.valid && mesh.figures.operations > 20);
      mesh.close();
    }
}

/// Random operations, writes of points, frames, undo and redo; a twin copies all points in each frame, and so do triangles and
/// levels.
async function pointsFollowFrames() {
  const levels = await simplified(grid(9, 9), 0.3);
  let [steps, restored] = [0, 0];
  for (let seed = 1; seed <= 40; ++seed) {
    const random = randomOf(seed * 7919);
    const open = [() => restrip.mesh(grid(6, 6)), () => restrip.progressive(levels)][seed % 2];
    const mesh = open().begin({ policy: ['bare', 'local'][seed % 3 % 2], history: 1e6 });
    mesh.update();
    const played = () => {
      try {
        return mesh.figures.played + mesh.moveTo(mesh.figures.played);
      } catch {
        return 'left';
      }
    };
    const now = () => ({ points: [...mesh.points], triangles: sorted(mesh.triangles), played: played() });
    let [frames, at] = [[now()], 0];
    /// Ends a frame if the mesh has changed.
    const end = (changed) => {
      if (changed) frames.length = ++at;
      frames[at] = now();
    };
    let changed = false;
    for (let n = 0; n < 60; ++n, ++steps) {
      const what = random(10);
      const some = () => random(mesh.points.length / 3);
      if (what < 3) changed ||= sculpted(mesh, random, 2).some(({ ok }) => ok);
      else if (what === 3) mesh.setPoint(some(), random(100), random(100), 1);
      else if (what === 4) mesh.addPoint(random(100), 2, 3);
      else if (what === 5 && mesh.levels > 0) {
        try {
          if (mesh.moveTo(random(mesh.levels + 1)) > 0) changed = true;
        } catch (error) {
          assert.match(error.message, /single operations/);
        }
      } else if (what < 8) {
        mesh.update();
        end(changed);
        changed = false;
      } else {
        const forward = what === 9;
        end(changed);
        changed = false;
        const [to, done] = [at + (forward ? 1 : -1), forward ? mesh.redo() : mesh.undo()];
        assert.equal(done, to in frames, `${seed}, ${n}`);
        if (!done) continue;
        at = to;
        assert.deepEqual(now(), frames[at], `${seed}, ${n}`);
        ++restored;
      }
    }
    mesh.close();
  }
  assert.ok(restored > 200, `${restored} of ${steps}`);
  // Undone frames that left the records do not count, also after another frame took their place.
  const mesh = restrip.progressive(levels).begin({ history: 1e5 });
  mesh.moveTo(10);
  mesh.update();
  const flipped = () => { for (let i = 0; ; i += 3) if (mesh.flip(...mesh.triangles.subarray(i, i + 2)).ok) return; };
  flipped();
  mesh.update();
  assert.throws(() => mesh.moveTo(9), /undo them, or call begin\(\) again/);
  mesh.undo();
  mesh.update();
  mesh.recolor({ effort: 'full', cost: 'strips' });
  mesh.update();
  while (mesh.undo());
  while (mesh.redo());
  assert.equal(mesh.moveTo(9), 1);
  // The points of records are those given, whatever operations made of their numbers.
  mesh.moveTo(0);
  const given = [...mesh.points];
  for (let i = 0; i < 12; i += 3) mesh.bisect(...mesh.triangles.subarray(i, i + 2));
  assert.notDeepEqual([...mesh.points], given);
  assert.deepEqual([...mesh.begin().points.subarray(0, given.length)], given);
  // A limited history forgets its oldest frames, with their points.
  const short = restrip.mesh(grid(9, 9)).begin({ history: 60 });
  const states = [];
  for (let n = 0; n < 40; ++n) {
    short.update();
    states.push([...short.points]);
    sculpted(short, randomOf(n + 1), 4);
  }
  let back = 0;
  for (; short.undo(); ++back) assert.deepEqual([...short.points], states.at(-1 - back));
  assert.ok(back >= 1 && back < 20 && !restrip.mesh(grid(3, 3)).begin().undo(), `${back} frames undone`);
}

/// A mesh that was saved continues in another library; begin() keeps operations on a mesh without records; strips can be made
/// again, kept under another policy, and improved; fromScratch() changes nothing.
async function continues() {
  const other = await load();
  const mesh = restrip.mesh(grid(9, 9)).begin({ form: 'stitched', layout: { cache: 16 }, history: 1e5 });
  sculpted(mesh, randomOf(3), 40);
  mesh.update();
  const { points } = mesh;
  const shown = sorted(mesh.triangles);
  const resumed = other.saved(mesh.save(), { points, history: 1e5 });
  assert.ok(resumed.update().outgrown);
  assert.deepEqual([sorted(resumed.triangles), sorted(drawn(resumed.indices)), resumed.figures.strips], [shown, shown, mesh.figures.strips]);
  assert.ok(sculpted(resumed, randomOf(4), 9).some(({ ok }) => ok) && resumed.undo());
  assert.deepEqual(sorted(resumed.triangles), shown);
  assert.throws(() => other.saved(mesh.save(), { points: [0, 0, 0] }), /^Error: saved mesh: it has \d+ vertices; there are 1 points$/);
  assert.throws(() => other.saved(mesh.save(), { points, form: 'list' }), /saved has no option 'form'/);
  const whole = mesh.save();
  for (let at = 0; at < whole.length; at += 3) {
    const altered = whole.slice();
    altered[at] ^= 1 << at % 8;
    for (const wrong of [altered, whole.subarray(0, at)]) assert.throws(() => other.saved(wrong, { points }), (error) => !(error instanceof WebAssembly.RuntimeError) && error.message.length > 15);
  }
  for (const form of ['list', 'restart']) {
    mesh.begin({ policy: 'rules', form, history: 1e5 });
    assert.deepEqual([sorted(mesh.triangles), [...mesh.points]], [shown, [...points]]);
    assert.ok(mesh.update().outgrown && mesh.valid);
  }
  const before = mesh.plainIndices;
  assert.equal(mesh.recolor({ effort: 'full', cost: 'indices' }), mesh.figures.strips);
  assert.ok(mesh.plainIndices <= before);
  mesh.update();
  const strips = mesh.figures.strips;
  mesh.keep({ policy: 'full', cost: 'strips' });
  mesh.improve(30000);
  assert.ok(mesh.figures.strips < strips, `${mesh.figures.strips} of ${strips}`);
  mesh.update();
  assert.deepEqual(sorted(drawn(mesh.indices)), shown);
  const kept = [...mesh.ribbon];
  const again = mesh.fromScratch({ cost: 'indices' });
  assert.deepEqual(sorted(drawn(again)), shown);
  assert.equal(new Set(Array.from(mesh.scratchRibbon).filter((_, n) => n % 9 === 8)).size, again.filter((index) => index === restartIndex).length + 1);
  assert.deepEqual(sorted(drawn(mesh.fromScratch({ cacheSize: 16 }))), shown);
  assert.ok(mesh.fromScratch({ cacheSize: 16, cacheWeight: 50 }).length >= mesh.fromScratch({ cacheSize: 16, cacheWeight: 0.1 }).length);
  assert.throws(() => mesh.fromScratch({ cacheSize: 16, cacheWeight: -1 }), /cacheWeight must be a number from 0 to 1000/);
  assert.deepEqual([...mesh.ribbon], kept);
  // Neighbours, by the triangles of the mesh: each triangle goes from one to the next.
  const { triangles } = mesh;
  for (let v = 0; v < mesh.points.length / 3; ++v) {
    const next = new Map();
    for (let i = 0; i < triangles.length; ++i)
      if (triangles[i] === v) next.set(triangles[i - i % 3 + (i + 1) % 3], triangles[i - i % 3 + (i + 2) % 3]);
    const around = [...mesh.around(v)];
    assert.deepEqual([...around].sort(), [...new Set([...next.keys(), ...next.values()])].sort(), `${v}`);
    around.slice(1).forEach((w, n) => assert.equal(next.get(around[n]), w));
  }
  assert.equal(mesh.around(70000).length, 0);
  for (const each of [mesh, resumed]) each.close();
}

/// Any triangles are replaced by any others, each by its vertices.
function trianglesAreReplaced() {
  const mesh = restrip.mesh(grid(6, 5)).begin();
  const before = sorted(mesh.triangles);
  const count = mesh.triangles.length;
  const [a, b, c] = mesh.triangles;
  assert.deepEqual(mesh.replace([b, c, a], []), { ok: true });
  assert.equal(mesh.triangles.length, count - 3);
  assert.match(mesh.replace([a, b, c], []).reason, /no triangle has the corners/);
  assert.deepEqual(mesh.replace([], [a, b, c]), { ok: true });
  assert.deepEqual(sorted(mesh.triangles), before);
  assert.match(mesh.replace([], [a, b, c]).reason, /these triangles cannot be replaced: the mesh would not be a manifold/);
  assert.throws(() => mesh.replace([], [a, b, 1e6]), /inserted: number 0 names vertex 1000000/);
  const v = mesh.addPoint(0.5, 0.5, 0);
  assert.ok(mesh.replace([a, b, c], [a, b, v, b, c, v, c, a, v]).ok && mesh.valid);
  assert.equal(mesh.around(v).length, 3);
}

/// 16 bits name vertices up to 65,534. An operation that would add the next one is refused, and the mesh stays in use.
function sixteenBitsAreKept() {
  const mesh = restrip.mesh(grid(257, 255)).begin({ policy: 'bare', bits: 16 });
  mesh.update();
  const [a, b, c] = mesh.triangles;
  const why = /it needs a vertex above 65,534, which 16 bits cannot name; begin with bits 'auto'/;
  const v = mesh.addPoint(0, 0, 0);
  for (const refused of [mesh.bisect(a, b), mesh.splitFace(a, b, c), mesh.split(...[258, v, 259, 515])]) {
    assert.ok(!refused.ok);
    assert.match(refused.reason, why);
  }
  assert.equal(mesh.update().length, 0);
  mesh.begin({ policy: 'bare', bits: 'auto' }).update();
  assert.equal(mesh.indices.BYTES_PER_ELEMENT, 2);
  assert.equal(mesh.bisect(a, b).vertex, 65535);
  assert.ok(mesh.update().outgrown);
  assert.equal(mesh.indices.BYTES_PER_ELEMENT, 4);
  mesh.close();
}

/// A vertex more copies its point, not the mesh: all copies together have a few numbers for each vertex, at two sizes.
function pointsGrowInConstantTime() {
  const { set, slice } = Float32Array.prototype;
  const { from } = Float32Array;
  for (const size of [20, 80]) {
    const mesh = restrip.mesh(grid(size, size)).begin({ policy: 'bare' });
    const view = mesh.points;
    let copied = 0;
    Float32Array.prototype.set = function (list, at) { copied += list.length; return set.call(this, list, at); };
    Float32Array.prototype.slice = function (...at) { copied += this.length; return slice.apply(this, at); };
    Float32Array.from = function (list) { copied += list.length; return from.call(Float32Array, list); };
    try {
      for (let n = 0; n < 1000; ++n) {
        const v = n % 3 === 0 ? mesh.addPoint(n, 0, 0) : n % 3 === 1 ? mesh.bisect(...mesh.triangles.subarray(3 * n, 3 * n + 2)).vertex
          : mesh.splitFace(...mesh.triangles.subarray(3 * n, 3 * n + 3)).vertex;
        assert.equal(typeof v, 'number');
      }
    } finally {
      Object.assign(Float32Array.prototype, { set, slice });
      Float32Array.from = from;
    }
    assert.ok(copied < 6 * 1000 + 2 * mesh.points.length, `${copied} numbers copied for 1000 vertices, the mesh has ${mesh.points.length}`);
    assert.deepEqual([...mesh.points.subarray(0, view.length)], [...view]);
    mesh.close();
  }
}

/// README's function for three.js: a device that copies what the attributes mark draws the mesh with its points.
async function threeFollows() {
  const project = join(scratch, 'three');
  const stand = join(project, 'node_modules/three');
  mkdirSync(stand, { recursive: true });
  writeFileSync(join(stand, 'package.json'), '{ "name": "three", "type": "module", "exports": "./three.js" }');
  writeFileSync(join(stand, 'three.js'), standIn);
  const [, text] = readFileSync(join(folder, 'package/README.md'), 'utf8').match(/```js\n(import [^`]*function sync[^`]*)```/);
  writeFileSync(join(project, 'sync.mjs'), text);
  const { sync } = await import(pathToFileURL(join(project, 'sync.mjs')));
  const { BufferGeometry } = await import(pathToFileURL(join(stand, 'three.js')));
  const card = new Map();  // by attribute, as the renderer of three.js
  let whole = 0;
  const upload = (attribute) => {
    const old = card.get(attribute);
    if (!old || (old.version !== attribute.version && attribute.updateRanges.length === 0)) {
      card.set(attribute, { version: attribute.version, array: attribute.array.slice() });
      ++whole;
    } else if (old.version !== attribute.version) {
      for (const { start, count } of attribute.updateRanges) old.array.set(attribute.array.subarray(start, start + count), start);
      attribute.clearUpdateRanges();
      old.version = attribute.version;
    }
    return card.get(attribute).array;
  };
  const geometry = new BufferGeometry();
  const mesh = restrip.mesh(grid(8, 8)).begin({ policy: 'bare', form: 'list', bits: 'auto' });
  let moved = [];
  let seed = 5;
  const random = (n) => (seed = (seed * 48271) % 2147483647) % n;
  const frames = 300;
  for (let frame = 0; frame < frames; ++frame) {
    sync(geometry, mesh, moved);
    moved = [];
    const [indices, points] = [upload(geometry.index), upload(geometry.getAttribute('position'))];
    const { start, count } = geometry.drawRange;
    assert.equal(start, 0);
    assert.deepEqual(sorted(indices.subarray(0, count)), sorted(mesh.triangles));
    assert.deepEqual([...points.subarray(0, mesh.points.length)], [...mesh.points]);
    const { triangles } = mesh;
    const t = 3 * random(triangles.length / 3);
    const [a, b, c] = triangles.subarray(t, t + 3);
    const added = [() => mesh.bisect(a, b), () => mesh.splitFace(a, b, c), () => mesh.flip(a, b), () => mesh.collapse(a, b)][random(4)]();
    if (added.vertex !== undefined) moved.push(added.vertex);
    mesh.setPoint(c, frame, 1, 2);
    moved.push(c);
  }
  assert.ok(mesh.points.length > 300 && whole > 3 && whole < 20, `${whole} uploads of whole attributes`);
  mesh.close();
}

function viewDependent() {
  const mesh = restrip.progressive(source).begin({ policy: 'quick' });
  const splits = mesh.splits;
  const wanted = new Uint8Array(mesh.levels);
  const near = (x, most) => {
    for (let i = 0; i < mesh.levels; ++i) wanted[i] = Math.abs(mesh.points[3 * splits[4 * i + 1]] - x) < 0.2 ? 1 : 0;
    const before = mesh.figures.operations;
    while (mesh.approach(wanted, most) === most);
    assert.ok(mesh.figures.operations - before <= mesh.levels, `approached with ${most} operations at a time, a record was undone and played again`);
    assert.equal(mesh.approach(wanted), 0);
    assert.ok(!mesh.figures.inOrder, 'a part of the records out of order');
    assert.ok(mesh.valid);
    mesh.update();
    assert.deepEqual(sorted(drawn(mesh.indices)), sorted(mesh.triangles));
  };
  for (const [x, most] of [[0.5, 500], [0.3, 64], [-0.4, 7], [0.1, 1]]) near(x, most);
  // Wherever it went, the levels have their triangles.
  const straight = restrip.progressive(source).begin({ policy: 'local' });
  for (const share of [0.6, 0]) {
    mesh.moveTo(Math.round(share * mesh.levels));
    straight.moveTo(Math.round(share * mesh.levels));
    assert.deepEqual(sorted(mesh.triangles), sorted(straight.triangles));
  }
  mesh.close();
  straight.close();
}

function singleOperations() {
  // An octahedron: split 4 along its edges to 0 and 1, flip, and collapse again.
  const base = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  const points = [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 1.1];
  const mesh = restrip.progressive({ points, base, splits: [] }).begin({ policy: 'local' });
  assert.deepEqual(mesh.split(4, 6, 0, 1), { ok: true });
  assert.equal(mesh.figures.triangles, 10);
  const { kind, closed, k, a, before, ports, after } = mesh.last;
  assert.deepEqual({ kind, closed, k, a }, { kind: 'split', closed: true, k: 4, a: 2 });
  assert.equal(after, restrip.rule({ family: 'split', k, a, edges: before, ports }).colors);
  const refused = (outcome, why) => { assert.equal(outcome.ok, false); assert.match(outcome.reason, why); };
  refused(mesh.split(4, 6, 0, 1), /already in use/);
  refused(mesh.split(4, 6, 5, 1), /^vertex 4 has no edge to 5 or to 1$/);
  refused(mesh.collapse(4, 5), /^no triangle has a side between 4 and 5$/);
  refused(mesh.collapse(4, 4000), /^no triangle has a side between 4 and 4000$/);
  assert.ok(mesh.flip(4, 6).ok);
  refused(mesh.flip(4, 6), /^no triangle has a side between 4 and 6$/);
  assert.ok(mesh.flip(0, 1).ok && mesh.collapse(4, 6).ok);
  assert.equal(mesh.figures.triangles, 8);
  assert.ok(mesh.valid);
  assert.throws(() => restrip.progressive({ points, base, splits: [4, 6, 0, 4] }), /split 0 of the progressive mesh cannot be done \(.*\); all before it can/);
  mesh.close();
}

/// A custom operation by its table, here the division of a face.
function appliesTables() {
  const table = { format: 'restrip-operation-table', name: 'divide-face', matching: false, none: 255, entries: [24, 25, 50, 51, 44, 29, 46, 255], numbers: [],
    positions: [{ numbers: [], before: { triangles: 1, edges: 0 }, after: { triangles: 3, edges: 3 }, ports: 3, first: 0, vertices: 4,
      triangles_before: [[0, 0, 0, 1, 2, 64, 65, 66]], triangles_after: [[0, 0, 0, 1, 3, 64, 0, 2], [0, 1, 3, 1, 2, 0, 65, 1], [1, 2, 3, 2, 0, 1, 66, 2]] }] };
  const mesh = restrip.mesh(grid(6, 6)).begin({ history: 1000 });
  mesh.update();
  const [a, b, c] = mesh.triangles.subarray(30);
  const before = sorted(mesh.triangles);
  const done = mesh.apply(table, a, b);
  assert.deepEqual(done, { ok: true, vertices: [36] });
  const expected = [a, b, c].reduce((sum, v) => sum + mesh.points[3 * v], 0) / 3;
  assert.ok(Math.abs(mesh.points[3 * 36] - expected) < 1e-6);
  assert.ok(mesh.valid && mesh.figures.triangles === 52);
  for (const t of [[a, b, 36], [b, c, 36], [c, a, 36]]) assert.ok(sorted(mesh.triangles).includes(sorted(t)[0]));
  mesh.update();
  assert.deepEqual(sorted(drawn(mesh.indices)), sorted(mesh.triangles));
  assert.ok(mesh.undo());
  assert.deepEqual([sorted(mesh.triangles), mesh.points.length], [before, 3 * 36]);
  assert.deepEqual(mesh.apply(table, 0, 35), { ok: false, reason: 'no triangle has a side from 0 to 35' });
  assert.throws(() => mesh.apply({ ...table, entries: [56, ...table.entries.slice(1)] }, a, b), /the table divide-face: entry 0 is not a sound rule/);
  for (const wrong of [undefined, {}, '{}']) assert.throws(() => mesh.apply(wrong, a, b), /apply\(\) needs the table of an operation/);
  mesh.close();
}

async function simplifies() {
  const soup = await readMesh('hare.obj', readFileSync(join(folder, 'hare.obj')));
  const levels = await simplified(soup, 0.1);
  const mesh = restrip.progressive(levels).begin({ policy: 'quick' });
  assert.ok(mesh.figures.triangles <= 0.11 * soup.triangles.length / 3);
  mesh.moveTo(mesh.levels);
  assert.deepEqual(sorted(mesh.triangles), sorted(soup.triangles));
  mesh.close();
  // In steps the result is the same, and the share done is reported; the caller may stop in between.
  const steps = simplifying(soup, 0.1);
  const shares = [];
  let last;
  while (!(last = await steps.next()).done) shares.push(last.value);
  assert.ok(shares.length > 2 && shares.every((share, n) => share >= (shares[n - 1] ?? 0) && share < 1), shares.join());
  assert.deepEqual(last.value, levels);
  for await (const share of simplifying(soup, 0.1)) {
    assert.ok(share > 0);
    break;
  }
  // The program makes the same levels of these points, which are floats.
  const [obj, pm] = ['soup.obj', 'soup.pm'].map((name) => join(scratch, name));
  const lines = (letter, list, of) => Array.from({ length: list.length / 3 }, (_, i) => `${letter} ${Array.from(list.subarray(3 * i, 3 * i + 3), of).join(' ')}\n`).join('');
  writeFileSync(obj, lines('v', soup.points, (x) => x) + lines('f', soup.triangles, (v) => v + 1));
  execFileSync(program, ['simplify', obj, '--triangles', `${Math.round(soup.triangles.length / 30)}`, '-o', pm]);
  // Its file names the vertices of the base first.
  const places = ({ points, base, splits }) => [base, splits].map((list) => Array.from(list, (v) => (v === none ? 'none' : points.subarray(3 * v, 3 * v + 3).join())));
  assert.deepEqual(places(await readMesh('soup.pm', readFileSync(pm))), places(levels));
  // A mesh of which no edge may collapse is its own base.
  const tetrahedron = { points: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], triangles: [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3] };
  const { base: same, splits: no } = await simplified(tetrahedron, 0);
  assert.deepEqual([[...same], no.length], [tetrahedron.triangles, 0]);
  for (const empty of [{ points: [], triangles: [] }, { points: [0, 0, 0], triangles: [] }])
    assert.deepEqual(await simplified(empty), { points: Float32Array.from(empty.points), base: new Uint32Array(0), splits: new Uint32Array(0) });
}

/// What a program has in hand is read, or refused for the true reason.
async function takesContent() {
  const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
  const bytes = new TextEncoder().encode(text);
  const shared = (from) => {
    const copy = new Uint8Array(new SharedArrayBuffer(from.length));
    copy.set(from);
    return copy;
  };
  const foreign = (from) => runInNewContext('Uint8Array.from(list)', { list: [...from] });
  const response = () => new Response(wasm, { headers: { 'content-type': 'application/wasm' } });
  const address = pathToFileURL(join(folder, 'package/restrip.wasm'));
  for (const content of [bytes, bytes.buffer, text, new Blob([text]), new Response(text), Promise.resolve(new Response(text)), shared(bytes), shared(bytes).buffer, foreign(bytes), foreign(bytes).buffer,
    new DataView(bytes.buffer)])
    assert.deepEqual([...(await readMesh('a.obj', content)).triangles], [0, 1, 2]);
  for (const module of [wasm, foreign(wasm).buffer, shared(wasm), new Blob([wasm]), response(), Promise.resolve(response()), new WebAssembly.Module(wasm), address, `${address}`])
    assert.ok((await load(module)).mesh(grid(2, 2)));
  await assert.rejects(readMesh('a.obj', 3), /a value of the kind Number is not bytes/);
  await assert.rejects(load(new Response('', { status: 404, statusText: 'Not Found' })), /404 Not Found/);
  await assert.rejects(load('/restrip.wasm'), /'\/restrip.wasm' is not an address; give new URL/);
  const mesh = restrip.mesh(grid(3, 3)).begin();
  const { points } = mesh;
  for (const saved of [mesh.save(), shared(mesh.save()), foreign(mesh.save()).buffer]) assert.ok(restrip.saved(saved, { points }).valid);
  for (const [wrong, why] of [['text', /a text is not bytes/], [new Blob([wasm]), /kind Blob is not bytes; await its arrayBuffer\(\)/], [Promise.resolve(wasm), /kind Promise is not bytes; await it/],
    [[...bytes], /kind Array is not bytes; make it Uint8Array/]])
    for (const open of [() => restrip.baked(wrong), () => restrip.saved(wrong, { points })]) assert.throws(open, why);
  // A page from the file system says so.
  const { versions } = process;
  Object.defineProperty(process, 'versions', { value: {}, configurable: true });
  await assert.rejects(load(), /a page that was opened as a file cannot read files; serve it/);
  Object.defineProperty(process, 'versions', { value: versions, configurable: true });
}

/// Each wrong argument and each call out of turn throws a sentence, and leaves the mesh as it was.
function misuseThrows() {
  const base = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  const points = [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 1.1];
  const splits = [4, 6, 0, 1];
  const source = { points, base, splits };
  const sentence = /^[^\n]{15,}$/;
  const throws = (wrong, why) => assert.throws(wrong, (error) => {
    assert.ok(!(error instanceof WebAssembly.RuntimeError) && !/of undefined|not a function|iterable/.test(error.message), `${wrong}: ${error}`);
    assert.match(error.message, sentence);
    assert.match(error.message, why, `${wrong}`);
    return true;
  });
  const changed = (list, at, value) => list.map((n, i) => (i === at ? value : n));
  for (const value of [7, -1, 1.5, NaN, 2 ** 32]) {
    throws(() => restrip.progressive({ ...source, base: changed(base, 4, value) }), /base: number 1 names vertex .*; there are 7/);
    throws(() => simplifying({ points, triangles: changed(base, 23, value) }), /triangles: number 7 names vertex/);
    throws(() => restrip.progressive({ ...source, splits: changed(splits, 3, value) }), /splits: number 0 names vertex/);
  }
  for (const value of [NaN, Infinity, 1e39, undefined]) {
    throws(() => restrip.progressive({ ...source, points: changed(points, 4, value) }), /vertex 1 has the coordinate/);
    throws(() => simplifying({ points: changed(points, 20, value), triangles: base }), /vertex 6 has the coordinate/);
  }
  throws(() => restrip.progressive({ ...source, points: points.slice(1) }), /points: 20 numbers/);
  throws(() => restrip.progressive({ ...source, splits: [1] }), /splits: 1 numbers/);
  throws(() => simplifying({ points }), /simplified\(\) needs { points, triangles }; triangles is missing/);
  throws(() => restrip.mesh({ points }), /mesh\(\) needs { points, triangles }; triangles is missing/);
  throws(() => restrip.mesh(), /mesh\(\) needs { points, triangles }; nothing of it is given/);
  throws(() => restrip.mesh({ points: [[0, 0, 0], [1, 0, 0]], triangles: [] }), /points: its elements are lists; give the numbers in one list: points.flat\(\)/);
  throws(() => restrip.mesh({ points, triangles: [[0, 1, 2]] }), /triangles: its elements are lists/);
  throws(() => restrip.mesh({ points, triangles: 'abc' }), /triangles: 'abc' is not a list/);
  throws(() => new Restrip(), /a Restrip is made by load\(\)/);
  for (const share of [-1, NaN, 2, 'half']) throws(() => simplifying({ points, triangles: base }, share), /share is/);
  for (const [wrong, why] of [[{ k: NaN }, /k is NaN/], [{ k: 2 ** 32 + 4 }, /k is 4294967300/], [{ a: -2 }, /a is -2/], [{ edges: -1n }, /edges is -1/], [{ ports: 1n << 64n }, /bits 0 to 63/], [{ family: 'fold' }, /unknown family 'fold'/]])
    throws(() => restrip.rule({ family: 'split', k: 4, a: 2, edges: 0, ports: 0, ...wrong }), why);

  const mesh = restrip.progressive(source);
  const needStrips = {
    moveTo: () => mesh.moveTo(1), approach: () => mesh.approach([1]), split: () => mesh.split(4, 6, 0, 1), collapse: () => mesh.collapse(4, 5),
    around: () => mesh.around(0), apply: () => mesh.apply({}, 0, 2), bisect: () => mesh.bisect(0, 2), splitFace: () => mesh.splitFace(0, 2, 4), replace: () => mesh.replace([], []), flip: () => mesh.flip(0, 1), update: () => mesh.update(), keep: () => mesh.keep(), recolor: () => mesh.recolor(), improve: () => mesh.improve(1),
    undo: () => mesh.undo(), redo: () => mesh.redo(), save: () => mesh.save(), fromScratch: () => mesh.fromScratch(), pick: () => mesh.pick([0, 0, 0], [0, 0, 1]),
    ...Object.fromEntries(['indices', 'triangles', 'figures', 'plainIndices', 'valid', 'ribbon', 'scratchRibbon', 'last', 'ready', 'history', 'draws', 'room'].map((name) => [name, () => mesh[name]])) };
  const others = { begin: () => mesh.begin(), addPoint: () => mesh.addPoint(0, 0, 0), setPoint: () => mesh.setPoint(0, 1, 0, 0), splits: () => mesh.splits, leftOut: () => mesh.leftOut, hasBakedStrips: () => mesh.hasBakedStrips };
  // No method is forgotten here.
  const own = Object.getOwnPropertyNames(Object.getPrototypeOf(mesh)).filter((name) => !['constructor', 'close', 'points', 'levels'].includes(name));
  assert.deepEqual(own.sort(), Object.keys({ ...needStrips, ...others }).sort());
  for (const call of Object.values(needStrips)) throws(call, /call begin\(\) first/);
  throws(() => mesh.begin({ cost: 'bytes' }), /unknown cost 'bytes'/);
  throws(() => mesh.begin({ cost: { restart: 1, swap: -1 } }), /weight swap is -1/);
  throws(() => mesh.begin({ policy: 'none' }), /unknown policy 'none'/);
  throws(() => mesh.begin({ policies: 'quick' }), /begin has no option 'policies': expected policy, cost, form, bits/);
  throws(needStrips.update, /call begin\(\) first/);

  mesh.begin({ policy: 'local' });
  for (const level of [-1, NaN, 0.5, 2, Infinity, '1', undefined]) throws(() => mesh.moveTo(level), /the level is/);
  throws(() => mesh.moveTo('1'), /the level is '1'; /);
  throws(() => mesh.moveTo(1n), /the level is 1n; /);
  throws(() => mesh.update({ gap: 3 }), /update has no option 'gap': expected join, align/);
  throws(() => mesh.begin({ history: -1 }), /history is -1/);
  throws(() => mesh.begin({ layout: { cash: 16 } }), /layout has no option 'cash': expected cache, waste, work/);
  throws(() => mesh.begin({ layout: { cache: 65 } }), /layout.cache is 65; it must be a whole number from 0 to 64/);
  throws(() => mesh.keep({ policy: 'baked' }), /unknown policy 'baked': expected one of bare, /);
  throws(() => mesh.keep({ effort: 'fast' }), /keep has no option 'effort'/);
  throws(() => mesh.recolor({ effort: 'slow' }), /unknown effort 'slow': expected one of fast, full, best/);
  for (const budget of [-1, 0.5, undefined]) throws(() => mesh.improve(budget), /the budget is/);
  throws(() => mesh.fromScratch({ form: 'list' }), /has no option 'form'/);
  for (const most of [-1, NaN, '5']) throws(() => mesh.moveTo(1, most), /the number of operations is/);
  throws(() => mesh.approach([1, 1]), /there are 2 marks/);
  throws(() => mesh.split(4, 7, 0, 1), /vT is 7/);
  for (const wrong of [-1, NaN, 0.5]) {
    for (let at = 0; at < 4; ++at) throws(() => mesh.split(...changed([4, 6, 0, 1], at, wrong)), /^v[STLR] is/);
    throws(() => mesh.collapse(4, wrong), /vT is/);
    throws(() => mesh.flip(wrong, 4), /u is/);
  }
  for (const [x, y, z, why] of [[NaN, 0, 0, /x is NaN; it must be a finite number/], [0, '1', 0, /y is '1'/], [0, 0, 1e39, /z is 1e\+39/]]) {
    throws(() => mesh.addPoint(x, y, z), why);
    throws(() => mesh.setPoint(0, x, y, z), why);
  }
  throws(() => mesh.pick([0, 0, NaN], [0, 0, 1]), /from must be three/);
  assert.deepEqual([mesh.figures.operations, mesh.figures.triangles, mesh.valid], [0, 8, true]);
  assert.equal(mesh.moveTo(1, Infinity), 1);

  assert.equal(typeof mesh[Symbol.dispose], 'function');
  mesh[Symbol.dispose]();
  mesh.close();  // once more does nothing
  for (const call of [...Object.values(needStrips), ...Object.values(others)]) throws(call, /this mesh is closed/);
  // A mesh that was refused has not spoiled the library.
  const next = restrip.progressive(source).begin();
  assert.equal(next.moveTo(1), 1);
  next.close();
}

/// The library once more, with what its module exports.
async function loadOpen() {
  const { instantiate } = WebAssembly;
  let instance;
  WebAssembly.instantiate = async (...given) => (instance = await instantiate(...given));
  const library = await load();
  WebAssembly.instantiate = instantiate;
  return { library, exports: instance.exports };
}

/// The module gets 2 GB that it does not touch, so that all it takes from then on has addresses above.
async function worksAboveTwoGigabytes() {
  const { library: high, exports } = await loadOpen();
  exports.restrip_js_take(1);  // the first call makes all memory that is there then the heap
  exports.memory.grow(2 ** 15);
  const mesh = high.progressive(source).begin({ policy: 'quick' });
  mesh.moveTo(mesh.levels);
  mesh.update();
  const { indices } = mesh;
  assert.ok(indices.byteOffset > 2 ** 31, `the indices are at ${indices.byteOffset}`);
  assert.ok(mesh.valid);
  assert.deepEqual(sorted(drawn(indices.slice())), sorted(mesh.triangles));
  assert.match(mesh.split(0, 0, 1, 2).reason, /[a-z]/);
  mesh.close();
}

/// Meshes that were not closed give their memory back when the program cannot reach them; what it can reach stays.
async function unclosedIsFreed() {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const { library, exports } = await loadOpen();
  const source = grid(60, 60);
  const levels = await simplified(source, 0.5);
  const forget = {
    mesh: () => library.mesh(source).begin().update(),
    progressive: () => { const mesh = library.progressive(levels).begin(); mesh.approach(new Uint8Array(mesh.levels)); },
  };
  const kept = library.mesh(source).begin();
  const round = async (leave) => {
    for (let n = 0; n < 4; ++n) leave();
    collect();
    await new Promise((then) => setTimeout(then));
  };
  for (const [what, leave] of Object.entries(forget)) {
    for (let n = 0; n < 3; ++n) await round(leave);
    const { byteLength } = exports.memory.buffer;
    for (let n = 0; n < 12; ++n) await round(leave);
    // What fragments take is not a leak: 48 of these meshes have more than 10 MB.
    const grown = exports.memory.buffer.byteLength - byteLength;
    assert.ok(grown < 2 ** 20, `${what}: ${grown} bytes more`);
  }
  assert.ok(kept.valid && kept.triangles.length === source.triangles.length);
  // A mesh that was closed is not closed again when it is collected: another one has its memory by then.
  library.mesh(source).close();
  const heirs = [library.mesh(source).begin(), library.mesh(source).begin()];
  await round(() => {});
  for (const heir of heirs) assert.ok(heir.bisect(0, 1).ok && heir.valid);
}

/// A module from a server is compiled while it arrives, if the server says that it is one and the engine can; else after it.
async function compilesFromServers() {
  const server = createServer(({ url }, answer) => {
    const type = decodeURIComponent(url.slice(1));
    if (type === 'absent') answer.writeHead(404).end();
    else answer.writeHead(200, type === '' ? {} : { 'content-type': type }).end(wasm);
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  const address = (type) => `http://127.0.0.1:${server.address().port}/${encodeURIComponent(type)}`;
  const { compileStreaming } = WebAssembly;
  let streamed = 0;
  const observed = (answer) => (++streamed, compileStreaming(answer));
  try {
    for (const [type, engine, streams] of [['application/wasm', observed, 1], ['Application/WASM', observed, 0], ['application/octet-stream', observed, 0],
      ['application/wasm; charset=utf-8', observed, 0], ['', observed, 0], ['application/wasm', undefined, 0]]) {
      WebAssembly.compileStreaming = engine;
      streamed = 0;
      const mesh = (await load(address(type))).mesh(grid(3, 3)).begin();
      assert.deepEqual([mesh.triangles.length, streamed], [24, streams], `'${type}'`);
    }
    assert.equal((await load(new URL(address('application/wasm')))).mesh(grid(2, 2)).begin().figures.triangles, 2);
    await assert.rejects(load(address('absent')), /absent: 404/);
  } finally {
    WebAssembly.compileStreaming = compileStreaming;
    server.close();
  }
}

function asDependency() {
  // As another project sees the package: by its name and its exports, with what is packed alone.
  const project = join(scratch, 'project');
  rmSync(project, { recursive: true, force: true });
  const about = JSON.parse(readFileSync(join(folder, 'package/package.json'), 'utf8'));
  const installed = join(project, 'node_modules', about.name);
  mkdirSync(installed, { recursive: true });
  for (const packed of ['package.json', ...about.files]) copyFileSync(join(folder, 'package', packed), join(installed, packed));
  writeFileSync(join(project, 'main.mjs'), `import { load } from '${about.name}';
    import { loadReaders } from '${about.name}/formats';
    const { readMesh, simplified } = await loadReaders();
    const content = new TextEncoder().encode('v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n');
    const mesh = (await load()).progressive(await simplified(await readMesh('t.obj', content))).begin();
    mesh.update();
    console.log(mesh.indices.join());`);
  assert.equal(execFileSync(process.execPath, ['main.mjs'], { cwd: project, encoding: 'utf8' }).trim(), '0,1,2,4294967295');
  // The example runs as it is installed, and says what the mesh and its buffers say.
  const example = (...words) => execFileSync(process.execPath, [join(installed, 'example.mjs'), ...words], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  const printed = [...example(join(folder, 'hare.pm')).matchAll(/^(.+): (\d+) bytes written, \d+ ms, (\d+) indices draw (\d+) triangles$/gm)]
    .map(([, name, ...numbers]) => [name, ...numbers.map(Number)]);
  assert.deepEqual(printed.map(([name]) => name), ['strips kept', 'strips from scratch', 'list with slots']);
  const fine = restrip.progressive(source).begin({ policy: 'bare' });
  fine.moveTo(fine.levels);
  const { triangles } = fine.figures;
  assert.deepEqual(printed.map(([, , , count]) => count), [triangles, triangles, triangles]);
  assert.deepEqual([printed[1][2], printed[2][2]], [fine.fromScratch({ cost: 'indices' }).length, 3 * triangles]);
  assert.ok(printed[0][2] < 2 * triangles && printed.every(([, bytes, indices]) => bytes > 4 * indices / 2), JSON.stringify(printed));
  fine.close();
  assert.throws(() => example(), /usage: node example.mjs MESH/);
  for (const { types, default: code } of Object.values(about.exports))
    for (const path of [types, code]) assert.ok(path && about.files.includes(path.slice(2)), path);
  for (const field of ['version', 'author', 'license', 'description']) assert.ok(about[field] && !about[field].includes('@'), field);
  // The types, if a compiler for them is available: right uses compile, uses marked as wrong do not.
  if (tsc) {
    copyFileSync(fileURLToPath(new URL('types.mts', import.meta.url)), join(project, 'types.mts'));
    for (const [module, resolution] of [['nodenext', 'nodenext'], ['esnext', 'bundler']])
      execFileSync(tsc, ['--strict', '--noEmit', '--target', 'es2022', '--module', module, '--moduleResolution', resolution, 'types.mts'],
        { cwd: project, stdio: 'inherit' });
    // Neither the library of a browser nor Node's types are needed.
    writeFileSync(join(project, 'bare.mts'), "import { load } from 'restrip-wasm';\nimport { loadReaders } from 'restrip-wasm/formats';\nimport address from 'restrip-wasm/restrip.wasm';\n" +
      "const text: string = address;\nawait load(text);\nawait loadReaders(new Uint8Array(3));\n// @ts-expect-error\nawait load(3);\n");
    execFileSync(tsc, ['--strict', '--noEmit', '--target', 'es2022', '--module', 'nodenext', '--lib', 'es2022', 'bare.mts'],
      { cwd: project, stdio: 'inherit' });
    console.log('types: as claimed');
  }
  // Bundlers for browsers would look for a module of Node that is named in the text.
  assert.doesNotMatch(readFileSync(join(installed, 'restrip.mjs'), 'utf8'), /(import\(|from )[^\n]*'node:/);
}

/// Every refusal is a sentence about the vertices that the caller named, and leaves the mesh as it was. The mesh has a boundary, a
/// vertex with three neighbours, and one that two fans share.
function refusalsNameVertices() {
  const { points, triangles } = grid(5, 4);
  const apex = 20;
  const [a, b, c] = triangles.splice(18, 3);
  triangles.push(a, b, apex, b, c, apex, c, a, apex, 4, 21, 22);
  const places = [...points, 1.3, 0.6, 0, 9, 1, 0, 9, 2, 0, 9, 9, 9];
  const open = () => restrip.mesh({ points: places, triangles }).begin({ policy: 'local' });
  const before = sorted(open().triangles);
  const reasons = new Set();
  const attempt = (name, vertices, named = vertices) => {
    const mesh = open();
    const { ok, reason } = mesh[name](...vertices);
    if (!ok) {
      assert.deepEqual(sorted(mesh.triangles), before);
      assert.doesNotMatch(reason, /halfedge|spoke|undefined|4294967295/);
      for (const v of named) assert.match(reason, new RegExp(`\\b${v}\\b`));
      reasons.add(reason.replace(/\d+/g, 'n'));
    }
    mesh.close();
  };
  const all = Array.from({ length: 24 }, (_, v) => v);
  for (const u of all)
    for (const v of all) {
      for (const name of ['collapse', 'flip', 'bisect']) attempt(name, [u, v]);
      attempt('split', [u, 23, v, none], [u]);
      attempt('split', [u, 23, none, v], [u]);
      attempt('splitFace', [u, v, 5]);
    }
  for (const u of all.slice(0, 12)) for (const v of all.slice(0, 12)) for (const w of all.slice(0, 12)) attempt('split', [u, 23, v, w], [u]);
  attempt('split', [6, 7, 1, 11], [6]);
  attempt('split', [6, 23, none, none], [6]);
  for (const each of [/^no triangle has a side between n and n$/, /^vertex n has no edge to n or to n$/, /^vertex n needs two edges, but vL and vR are both n$/,
    /^vertex n is not on the boundary, so neither vL nor vR may be `none`$/, /^the edge from n to n cannot be flipped: the edge lies on the boundary$/,
    /^the edge from n to n cannot be collapsed: .*pinch/, /^the edge from n to n cannot be collapsed: .*manifold/, /^vertex n cannot be split: .*in use/,
    /^no triangle has the corners n, n, n in this order$/, /^vertex n has no edge to `none`$/])
    assert.ok([...reasons].some((reason) => each.test(reason)), `${each} in ${[...reasons].join('\n')}`);
}

for (const test of [asDependency, takesContent, misuseThrows, worksAboveTwoGigabytes, unclosedIsFreed, compilesFromServers, pointsFollowFrames, continues, refusalsNameVertices, singleOperations, appliesTables, copiesByRanges, trianglesAreReplaced, sixteenBitsAreKept, pointsGrowInConstantTime, threeFollows, viewDependent, simplifies, playsBaked, sameAsReplay]) {
  await test();
  console.log(`${test.name}: as claimed`);
}
