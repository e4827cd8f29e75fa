// The package maintains exactly the same strips as the native program: for each policy and cost, at the base, at the
// top and back at the base, after an update of the index buffer for every single operation, `restrip replay` and the
// package report the same numbers. The index buffer, copied only by its ranges, draws the mesh. Operations that the
// mesh refuses change nothing, and misuse throws a sentence. A view-dependent walk ends, wherever it went, at the
// triangles that the levels have. Rules are the same as in the native tables. What
// a program no longer reaches is freed. The module is compiled while it arrives if the server allows it.
//   node package_test.mjs WEB_FOLDER RESTRIP DUMP_TABLES SCRATCH [TSC]
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createServer } from 'node:http';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { standIn } from './use_checks.mjs';

const [folder, program, dumpProgram, scratch, tsc] = process.argv.slice(2);
mkdirSync(scratch, { recursive: true });
const { load, none, restartIndex } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')));
const { loadReaders } = await import(pathToFileURL(join(folder, 'package/formats.mjs')));
const readMesh = await loadReaders();
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

function sameAsReplay() {
  let compared = 0;
  for (const cost of ['strips', 'indices']) {
    for (const policy of ['local', 'quick']) {
      const reported = join(scratch, `${policy}-${cost}.json`);
      execFileSync(program, ['replay', file, '--policy', policy, '--cost', cost, '--repeats', '0', '--json', reported]);
      const native = JSON.parse(readFileSync(reported, 'utf8'));
      const mesh = restrip.progressive(source).begin({ policy, cost });
      mesh.update();
      const levels = new Map(native.levels.map((level) => [level.triangles, level]));
      const levelsDown = new Map(native.levels_down.map((level) => [level.triangles, level]));
      const compare = (level) => {
        if (!level) return;
        const { triangles, strips, bufferIndices } = mesh.figures;
        assert.deepEqual({ triangles, strips, indices: mesh.plainIndices, buffer: bufferIndices },
          { triangles: level.triangles, strips: level.strips, indices: level.indices, buffer: level.buffer_indices });
        ++compared;
      };
      compare(levels.get(mesh.figures.triangles));
      for (let level = 1; level <= mesh.levels; ++level) {
        assert.equal(mesh.moveTo(level), 1);
        mesh.update();
        compare(levels.get(2 * level + source.base.length / 3));
      }
      assert.equal(mesh.figures.addingStrip, native.operations_adding_strip);
      assert.equal(mesh.figures.isolating, native.operations_isolating);
      compare(levelsDown.get(mesh.figures.triangles));
      for (let level = mesh.levels; level-- > 0;) {
        assert.equal(mesh.moveTo(level), 1);
        mesh.update();
        compare(levelsDown.get(2 * level + source.base.length / 3));
      }
      const { indicesWritten, operations } = mesh.figures;
      assert.equal(operations, 2 * mesh.levels);
      assert.ok(Math.abs(4 * indicesWritten / operations - native.live_buffers[0].bytes_per_operation) < 1e-6);
      assert.ok(mesh.valid);
      mesh.close();
    }
  }
  assert.ok(compared >= 5 * 19, `only ${compared} levels were compared`);
}

/// The file read in the browser and played, compared with `restrip replay` of the same file; every level twice, up and
/// down.
function sameAsBaked() {
  const baked = join(folder, 'hare.baked');
  const reported = join(scratch, 'baked.json');
  execFileSync(program, ['replay', baked, '--policy', 'baked', '--repeats', '0', '--levels', '40', '--json', reported]);
  const native = JSON.parse(readFileSync(reported, 'utf8'));
  assert.ok(native.levels.length >= 30);
  const mesh = restrip.baked(readFileSync(baked));
  assert.ok(mesh.hasBakedStrips);
  assert.deepEqual([mesh.levels, mesh.points.length], [source.splits.length / 4, source.points.length]);
  mesh.begin({ policy: 'baked' });
  const straight = restrip.progressive(source).begin({ policy: 'local' });
  mesh.update();
  const levels = new Map(native.levels.map((level) => [level.triangles, level]));
  const buffers = new Map();
  let compared = 0;
  const compare = () => {
    const { triangles, strips, played, inOrder, baked: inStep } = mesh.figures;
    assert.ok(inStep && inOrder);
    const level = levels.get(triangles);
    if (!level) return;
    assert.deepEqual({ strips, indices: mesh.plainIndices }, { strips: level.strips, indices: level.indices });
    straight.moveTo(played);
    const shown = sorted(mesh.triangles);
    assert.deepEqual(shown, sorted(straight.triangles));
    assert.deepEqual(sorted(drawn(mesh.indices)), shown);
    // The strips of a level are the same from both sides: so are its lines, named by their lowest triangle.
    const lines = mesh.lines;
    if (buffers.has(triangles)) assert.deepEqual(lines, buffers.get(triangles));
    else buffers.set(triangles, lines);
    ++compared;
  };
  const to = (level) => {
    assert.equal(mesh.moveTo(level), 1);
    mesh.update();
    compare();
  };
  compare();
  for (let level = 1; level <= mesh.levels; ++level) to(level);
  assert.equal(mesh.figures.addingStrip, native.operations_adding_strip);
  for (let level = mesh.levels; level-- > 0;) to(level);
  assert.equal(compared, 2 * native.levels.length - 1);  // the finest one once
  assert.ok(Math.abs(4 * mesh.figures.indicesWritten / mesh.figures.operations - native.live_buffers[0].bytes_per_operation) < 1e-6);

  // Out of order the rules continue, with valid strips that are counted; begin() leads back.
  const wanted = new Uint8Array(mesh.levels).fill(1, 800, 1000);
  mesh.approach(wanted);
  assert.ok(!mesh.figures.baked && !mesh.figures.inOrder && mesh.valid);
  mesh.moveTo(mesh.levels);
  mesh.update();
  assert.ok(!mesh.figures.baked && mesh.valid);
  assert.equal(mesh.figures.strips, new Set(Array.from(mesh.ribbon).filter((_, n) => n % 9 === 8)).size);
  mesh.begin({ policy: 'baked' }).moveTo(mesh.levels);
  // Strips from scratch draw the same triangles, and leave those that are kept; so does a list, whose slots change alone.
  const again = mesh.fromScratch({ cost: 'indices' });
  assert.deepEqual(sorted(drawn(again)), sorted(mesh.triangles));
  assert.deepEqual(sorted(drawn(mesh.fromScratch({ cacheSize: 16 }))), sorted(mesh.triangles));
  assert.ok(mesh.fromScratch({ cacheSize: 16, cacheWeight: 50 }).length > mesh.fromScratch({ cacheSize: 16, cacheWeight: 0.1 }).length);
  assert.throws(() => mesh.fromScratch({ cacheSize: 16, cacheWeight: -1 }), /cacheWeight must be a number from 0 to 1000/);
  mesh.fromScratch({ cost: 'indices' });
  assert.equal(new Set(Array.from(mesh.scratchRibbon).filter((_, n) => n % 9 === 8)).size, again.filter((index) => index === restartIndex).length + 1);
  const listed = restrip.progressive(source).begin({ policy: 'bare', form: 'list' });
  listed.moveTo(listed.levels);
  listed.update();
  assert.equal(listed.moveTo(listed.levels - 1), 1);
  assert.ok(listed.update().reduce((sum, { count }) => sum + count, 0) < 100);
  assert.deepEqual(sorted(listed.indices.slice()), sorted(listed.triangles));
  listed.close();
  mesh.moveTo(mesh.levels);
  // Nothing can be split at the finest level; one step below, one record.
  assert.equal(mesh.ready.length, 0);
  mesh.moveTo(mesh.levels - 1);
  assert.deepEqual([...mesh.ready], [mesh.levels - 1]);
  mesh.moveTo(mesh.levels);
  assert.ok(mesh.figures.baked);
  assert.equal(mesh.figures.strips, native.levels.at(-1).strips);
  // An operation that is none of the records ends it as well, even if it adds the next vertex.
  mesh.begin({ policy: 'baked' });
  const [, vT] = mesh.splits;
  const [a, b, c] = mesh.triangles;
  assert.ok(mesh.flip(a, b).ok || mesh.flip(b, c).ok || mesh.split(a, vT, b, c).ok);
  assert.ok(!mesh.figures.baked && mesh.valid);
  assert.throws(() => straight.begin({ policy: 'baked' }), /no baked strips/);
  // The same mesh under another policy is the one of the progressive mesh.
  mesh.begin({ policy: 'quick' }).moveTo(1000);
  straight.begin({ policy: 'quick' }).moveTo(1000);
  mesh.update();
  straight.update();
  assert.deepEqual(mesh.indices.slice(), straight.indices.slice());
  mesh.close();
  straight.close();
}

function refusesDamage() {
  // A small baked mesh: an octahedron, each triangle cut into four, twice.
  let triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
  const points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  for (let round = 0; round < 2; ++round) {
    const between = new Map();
    const middle = (i, j) => {
      const key = `${Math.min(i, j)} ${Math.max(i, j)}`;
      if (!between.has(key)) between.set(key, points.push(points[i].map((x, n) => x + points[j][n])) - 1);
      return between.get(key);
    };
    triangles = triangles.flatMap(([i, j, k]) => {
      const [ij, jk, ki] = [middle(i, j), middle(j, k), middle(k, i)];
      return [[i, ij, ki], [j, jk, ij], [k, ki, jk], [ij, jk, ki]];
    });
  }
  const file = join(scratch, 'small.obj');
  writeFileSync(file, points.map((p) => `v ${p.join(' ')}\n`).join('') + triangles.map((t) => `f ${t.map((v) => v + 1).join(' ')}\n`).join(''));
  execFileSync(program, ['bake', file, '--base', '0.2', '-o', join(scratch, 'small.baked')]);
  const whole = readFileSync(join(scratch, 'small.baked'));
  const mesh = restrip.baked(whole).begin({ policy: 'baked' });
  mesh.moveTo(mesh.levels);
  assert.equal(mesh.figures.triangles, triangles.length);
  mesh.close();
  const refused = (bytes, why = /^Error: baked mesh: [a-z]/) => assert.throws(() => restrip.baked(bytes), why);
  for (let size = 0; size < whole.length; ++size) refused(whole.subarray(0, size));
  for (let at = 0; at < whole.length; ++at) {
    for (const change of [1, 0x80, 0xff]) {
      const altered = Buffer.from(whole);
      altered[at] ^= change;
      refused(altered);
    }
  }
  refused(Buffer.concat([whole, Buffer.alloc(1)]), /checksum/);
  refused(Buffer.from('ProgMesh'), /not a baked mesh/);
  // With a checksum that fits: refused by what is wrong, or at least a mesh that can be played.
  const said = new Set();
  let played = 0;
  for (let at = 12; at < whole.length - 8; ++at) {
    const altered = Buffer.from(whole);
    altered[at] ^= 1 << at % 8;
    let hash = 0xcbf29ce484222325n;
    for (const byte of altered.subarray(0, -8)) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
    altered.writeBigUInt64LE(hash, altered.length - 8);
    try {
      const forged = restrip.baked(altered).begin({ policy: 'baked' });
      forged.moveTo(forged.levels);
      assert.ok(forged.valid);
      forged.close();
      ++played;
    } catch (error) {
      assert.match(error.message, /^baked mesh: /);
      said.add(error.message.replace(/\d+/g, 'n'));
    }
  }
  assert.ok(played > 0 && said.size >= 6, `${played} played, and ${[...said].join('; ')}`);
}

function copiesByRanges() {
  const mesh = restrip.progressive(source).begin({ policy: 'quick' });
  let copy = [];
  const follow = () => {
    const ranges = mesh.update();
    const live = mesh.indices;
    copy.length = live.length;
    for (const { first, count } of ranges) for (let i = first; i < first + count; ++i) copy[i] = live[i];
    assert.deepEqual(copy, Array.from(live));
    assert.deepEqual(sorted(drawn(copy)), sorted(mesh.triangles));
  };
  follow();
  for (const share of [0.3, 0.31, 0.9, 0.2, 1, 0]) {
    mesh.moveTo(Math.round(share * mesh.levels));
    follow();
  }
  mesh.close();
}

/// Every form and width, for a mesh without records that is sculpted: a copy that gets the ranges alone, in storage made when
/// the update says so, draws the mesh; ranges are joined and aligned as asked for.
function sculpts() {
  const open = () => restrip.mesh({ points: source.points, triangles: source.base });
  for (const form of ['restart', 'stitched', 'lengths', 'list'])
    for (const bits of [16, 32, 'auto']) {
      const mesh = open().begin({ policy: 'quick', cost: 'indices', form, bits });
      assert.equal(mesh.levels, 0);
      let storage = null;
      const follow = (options) => {
        const ranges = mesh.update(options);
        const live = mesh.indices;
        assert.equal(live.BYTES_PER_ELEMENT, bits === 32 ? 4 : 2);
        if (ranges.outgrown) storage = new live.constructor(mesh.room).fill(7);
        for (const { first, count } of ranges) storage.set(live.subarray(first, first + count), first);
        assert.deepEqual(Array.from(storage.subarray(0, live.length)), Array.from(live));
        const { join = 2, align = 4 } = options ?? {};
        ranges.forEach(({ first, count }, n) => {
          assert.equal(first * live.BYTES_PER_ELEMENT % align, 0);
          assert.ok((first + count) * live.BYTES_PER_ELEMENT % align === 0 || first + count === live.length);
          if (n > 0) assert.ok(first - ranges[n - 1].first - ranges[n - 1].count > join);
        });
        const restart = form === 'restart' ? 2 ** (8 * live.BYTES_PER_ELEMENT) - 1 : -1;
        const { triangles, bufferIndices } = mesh.figures;
        if (form === 'list') assert.deepEqual([mesh.draws, bufferIndices], [[{ first: 0, count: 3 * triangles }], 3 * triangles]);
        const shown = mesh.draws.flatMap(({ first, count }) => {
          const part = Array.from(storage.subarray(first, first + count));
          return form === 'list' ? part : drawn(part.map((index) => index === restart ? restartIndex : index));
        });
        assert.deepEqual(sorted(shown), sorted(mesh.triangles));
      };
      follow();
      const { triangles } = mesh;
      let done = 0;
      for (let i = 0; i + 2 < triangles.length && i < 120; i += 3) {
        const [a, b, c] = triangles.subarray(i, i + 3);
        const v = mesh.addPoint(i, 1, 2);
        assert.deepEqual([...mesh.points.slice(3 * v)], [i, 1, 2]);
        if (mesh.split(a, v, b, c).ok) ++done;
        if (mesh.collapse(b, c).ok) ++done;
        mesh.setPoint(a, 4, 5, 6);
        const [d, e, f] = mesh.triangles.subarray(i, i + 3);
        for (const [added, corners] of [[mesh.bisect(d, e), [d, e]], [mesh.splitFace(...mesh.triangles.subarray(0, 3)), null]]) {
          if (!added.ok) continue;
          ++done;
          assert.equal(mesh.points.length % 3, 0);
          if (corners) assert.equal(mesh.points[3 * added.vertex], Math.fround((mesh.points[3 * d] + mesh.points[3 * e]) / 2));
        }
        assert.deepEqual(mesh.bisect(d, d), { ok: false, reason: `no triangle has a side between ${d} and ${d}` });
        assert.deepEqual(mesh.splitFace(d, e, d), { ok: false, reason: `no triangle has the corners ${d}, ${e}, ${d} in this order` });
        follow([undefined, { join: 40, align: 16 }, { join: 0, align: 2 }][i % 4 % 3]);
      }
      assert.ok(done > 20 && mesh.valid);
      mesh.close();
    }
  const mesh = restrip.progressive(source).begin();
  const [a, b, c] = mesh.triangles;
  assert.ok(mesh.collapse(a, b).ok || mesh.flip(a, b).ok || mesh.flip(b, c).ok);
  assert.throws(() => mesh.moveTo(10), /call begin\(\) again/);
  assert.throws(() => mesh.approach(new Uint8Array(mesh.levels)), /call begin\(\) again/);
  assert.throws(() => mesh.begin({ form: 'fans' }), /unknown form 'fans'/);
  assert.throws(() => mesh.begin({ bits: 8 }), /must be 16, 32/);
  assert.throws(() => mesh.update({ align: 6 }), /multiple of 4/);
  assert.throws(() => mesh.addPoint(1, NaN, 2));
  assert.equal(mesh.begin().moveTo(10), 10);
  mesh.close();
}

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

/// 16 bits name vertices up to 65,534. An operation that would add the next one is refused, and the mesh stays in use.
function sixteenBitsAreKept() {
  const source = grid(256, 255);
  const mesh = restrip.mesh(source).begin({ policy: 'local', bits: 16 });
  mesh.update();
  for (let v = 65280; v < 65535; ++v) assert.equal(mesh.bisect(...mesh.triangles.subarray(300 * (v - 65280), 300 * (v - 65280) + 2)).vertex, v);
  mesh.update();
  const before = [...mesh.triangles];
  const why = "16 bits cannot name vertex 65,535; begin with bits 'auto'";
  const [a, b, c] = mesh.triangles.subarray(3000);
  for (const refused of [mesh.bisect(a, b), mesh.splitFace(a, b, c)]) assert.deepEqual(refused, { ok: false, reason: why });
  assert.throws(() => mesh.addPoint(0, 0, 0), { message: why });
  assert.deepEqual([...mesh.triangles], before);
  assert.equal(mesh.points.length, 3 * 65535);
  assert.equal(mesh.update().length, 0);
  // A vertex that has been removed gives its number back.
  const removed = mesh.triangles.find((v, i) => v > 65000 && v < 65280 && mesh.collapse(mesh.triangles[i - i % 3 + (i + 1) % 3], v).ok);
  const [d, e] = mesh.triangles.subarray(6000);
  assert.deepEqual(mesh.bisect(d, e), { ok: true, vertex: removed });
  mesh.update();
  assert.ok(mesh.valid);
  // Widened, the same mesh gets its vertex.
  const shown = sorted(mesh.triangles);
  mesh.begin({ policy: 'local', bits: 'auto' });
  assert.deepEqual(sorted(mesh.triangles), shown);
  mesh.update();
  assert.equal(mesh.indices.BYTES_PER_ELEMENT, 2);
  assert.equal(mesh.bisect(...mesh.triangles.subarray(0, 2)).vertex, 65535);
  assert.ok(mesh.update().outgrown);
  assert.equal(mesh.indices.BYTES_PER_ELEMENT, 4);
  assert.deepEqual(sorted(drawn([...mesh.indices])), sorted(mesh.triangles));
  mesh.close();
}

/// begin() again keeps the operations on a mesh without records, with vertices and points.
function beginKeepsEdits() {
  const mesh = restrip.mesh(grid(9, 9)).begin({ policy: 'local' });
  for (let v = 10; v < 60; v += 11) assert.ok(mesh.bisect(v, v + 1).ok);
  assert.deepEqual(mesh.collapse(70, 71), { ok: true });
  const [shown, points] = [sorted(mesh.triangles), [...mesh.points]];
  for (const form of ['list', 'restart']) {
    mesh.begin({ policy: 'quick', form });
    assert.deepEqual([sorted(mesh.triangles), [...mesh.points]], [shown, points]);
    assert.ok(mesh.update().outgrown);
    assert.ok(mesh.valid);
  }
  assert.deepEqual(sorted(drawn([...mesh.indices])), shown);
  // Neighbours: by the triangles of the mesh, on the boundary and inside; each triangle goes from one to the next.
  const { triangles } = mesh;
  for (let v = 0; v < mesh.points.length / 3; ++v) {
    const next = new Map();
    for (let i = 0; i < triangles.length; ++i)
      if (triangles[i] === v) next.set(triangles[i - i % 3 + (i + 1) % 3], triangles[i - i % 3 + (i + 2) % 3]);
    const around = [...mesh.around(v)];
    assert.deepEqual([...around].sort(), [...new Set([...next.keys(), ...next.values()])].sort(), `${v}`);
    around.slice(1).forEach((w, n) => assert.equal(next.get(around[n]), w));
  }
  assert.equal(mesh.around(71).length, 0);
  assert.equal(mesh.around(70000).length, 0);
  const v = mesh.bisect(30, 31).vertex;
  assert.deepEqual([...mesh.points.subarray(3 * v, 3 * v + 3)], [3.5, 3, 0]);
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
  assert.throws(() => restrip.progressive({ points, base, splits: [4, 6, 0, 4] }), /split 0/);
  mesh.close();
}

async function simplifies() {
  const soup = await readMesh('hare.obj', readFileSync(join(folder, 'hare.obj')));
  const mesh = restrip.simplified(soup, 0.1).begin({ policy: 'quick' });
  assert.ok(mesh.figures.triangles <= 0.11 * soup.triangles.length / 3);
  mesh.moveTo(mesh.levels);
  assert.deepEqual(sorted(mesh.triangles), sorted(soup.triangles));
  mesh.close();
  // In steps the result is the same, and the share done is reported; the caller may stop in between.
  const steps = restrip.simplifying(soup, 0.1);
  const shares = [];
  let last;
  while (!(last = steps.next()).done) shares.push(last.value);
  assert.ok(shares.length > 2 && shares.every((share, n) => share >= (shares[n - 1] ?? 0) && share < 1), shares.join());
  assert.deepEqual(last.value.splits, restrip.simplified(soup, 0.1).splits);
  last.value.close();
  for (const share of restrip.simplifying(soup, 0.1)) {
    assert.ok(share > 0);
    break;
  }
}

/// The rules are the same as in the native dump: every fourth line, and all of the flip.
function sameRules() {
  const lines = execFileSync(dumpProgram, ['--max-k', '6'], { maxBuffer: 1 << 30, encoding: 'latin1' }).split('\n');
  let position = {};
  let compared = 0;
  lines.forEach((line, number) => {
    const words = line.split(' ');
    if (words[0] === 'table') {
      position = { family: words[1] };
      if (words[1] === 'flip') return;
      position.k = +words[3];
      if (words[4] === 'a') position.a = +words[5];
      if (words[4] === 'gap') position.i = +words[5];
      if (words[4] === 'gaps') [position.i, position.j] = [+words[5], +words[6]];
      return;
    }
    if (!(position.family in { split: 1, collapse: 1, 'open-split': 1, 'open-collapse': 1, 'boundary-split': 1, 'boundary-collapse': 1, flip: 1 })) return;
    if (position.family !== 'flip' && number % 4 !== 0) return;
    if (!/^[0-9a-f]+ [0-9a-f]+ /.test(line)) return;
    const mask = (word) => BigInt(`0x${word}`);
    const rule = restrip.rule({ ...position, edges: mask(words[0]), ports: mask(words[1]) });
    if (words[2] === '-') assert.ok(!rule.valid);
    else if (position.family === 'flip')
      assert.deepEqual([rule.valid, rule.colors, rule.ports], [true, mask(words[2]), mask(words[3])]);
    else assert.deepEqual([rule.valid, rule.colors], [true, mask(words[2])]);
    if (rule.valid) assert.equal(rule.strips, +words[4], line);
    ++compared;
  });
  assert.ok(compared > 10000, `only ${compared} rules were compared`);
  console.log(`${compared} rules compared`);
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
    const readMesh = await loadReaders();
    const content = new TextEncoder().encode('v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n');
    const mesh = (await load()).simplified(await readMesh('t.obj', content)).begin();
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

/// Each wrong argument and each call out of turn throws a sentence, and leaves the mesh as it was.
function misuseThrows() {
  const base = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  const points = [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 1.1];
  const splits = [4, 6, 0, 1];
  const source = { points, base, splits };
  const sentence = /^[^\n]{15,}$/;
  const throws = (wrong, why) => assert.throws(wrong, (error) => {
    assert.ok(!(error instanceof WebAssembly.RuntimeError) && !(error instanceof TypeError), `${wrong}: ${error}`);
    assert.match(error.message, sentence);
    assert.match(error.message, why, `${wrong}`);
    return true;
  });
  const changed = (list, at, value) => list.map((n, i) => (i === at ? value : n));
  for (const value of [7, -1, 1.5, NaN, 2 ** 32]) {
    throws(() => restrip.progressive({ ...source, base: changed(base, 4, value) }), /triangle 1 names vertex .*; there are 7/);
    throws(() => restrip.simplified({ points, triangles: changed(base, 23, value) }), /triangle 7 names vertex/);
    throws(() => restrip.progressive({ ...source, splits: changed(splits, 3, value) }), /record 0 names vertex/);
  }
  for (const value of [NaN, Infinity, 1e39, undefined]) {
    throws(() => restrip.progressive({ ...source, points: changed(points, 4, value) }), /vertex 1 has the coordinate/);
    throws(() => restrip.simplified({ points: changed(points, 20, value), triangles: base }), /vertex 6 has the coordinate/);
  }
  throws(() => restrip.progressive({ ...source, points: points.slice(1) }), /points: 20 numbers/);
  throws(() => restrip.progressive({ ...source, splits: [1] }), /record: 1 numbers/);
  throws(() => restrip.simplified({ points }), /triangle: no list/);
  for (const share of [-1, NaN, 2, 'half']) throws(() => restrip.simplified({ points, triangles: base }, share), /share is/);
  for (const [wrong, why] of [[{ k: NaN }, /k is NaN/], [{ k: 2 ** 32 + 4 }, /k is 4294967300/], [{ a: -2 }, /a is -2/], [{ edges: -1n }, /edges is -1/], [{ ports: 1n << 64n }, /bits 0 to 63/], [{ family: 'fold' }, /unknown family 'fold'/]])
    throws(() => restrip.rule({ family: 'split', k: 4, a: 2, edges: 0, ports: 0, ...wrong }), why);

  const mesh = restrip.progressive(source);
  const needStrips = {
    moveTo: () => mesh.moveTo(1), approach: () => mesh.approach([1]), split: () => mesh.split(4, 6, 0, 1), collapse: () => mesh.collapse(4, 5),
    around: () => mesh.around(0), bisect: () => mesh.bisect(0, 2), splitFace: () => mesh.splitFace(0, 2, 4), flip: () => mesh.flip(0, 1), update: () => mesh.update(), keep: () => mesh.keep(), recolor: () => mesh.recolor(), improve: () => mesh.improve(1), compact: () => mesh.compact(1),
    undo: () => mesh.undo(), redo: () => mesh.redo(), save: () => mesh.save(), fromScratch: () => mesh.fromScratch(), pick: () => mesh.pick([0, 0, 0], [0, 0, 1]),
    ...Object.fromEntries(['indices', 'triangles', 'figures', 'plainIndices', 'valid', 'ribbon', 'scratchRibbon', 'last', 'ready', 'history', 'draws', 'room'].map((name) => [name, () => mesh[name]])) };
  const others = { begin: () => mesh.begin(), addPoint: () => mesh.addPoint(0, 0, 0), setPoint: () => mesh.setPoint(0, 1, 0, 0), splits: () => mesh.splits, leftOut: () => mesh.leftOut, hasBakedStrips: () => mesh.hasBakedStrips };
  // No method is forgotten here.
  const own = Object.getOwnPropertyNames(Object.getPrototypeOf(mesh)).filter((name) => !['constructor', 'close', 'points'].includes(name));
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
  throws(() => mesh.keep({ policy: 'baked' }), /unknown policy 'baked': expected one of bare, .*best$/);
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
  exports.restrip_take(1);  // the first call makes all memory that is there then the heap
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

/// Meshes that nobody closed, and simplifications that nobody finished, give their memory back when the program cannot reach
/// them; what it can reach stays.
async function unclosedIsFreed() {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const { library, exports } = await loadOpen();
  const source = grid(60, 60);
  const forget = {
    mesh: () => library.mesh(source).begin().update(),
    simplified: () => { const mesh = library.simplified(source, 0.5).begin(); mesh.approach(new Uint8Array(mesh.levels)); },
    unfinished: () => library.simplifying(source, 0.5).next(),
    'not begun': () => library.simplifying(source, 0.5),
    'stopped early': () => { for (const share of library.simplifying(source, 0.5)) return share; },
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
  const module = readFileSync(join(folder, 'package/restrip.wasm'));
  const server = createServer(({ url }, answer) => {
    const type = decodeURIComponent(url.slice(1));
    if (type === 'absent') answer.writeHead(404).end();
    else answer.writeHead(200, type === '' ? {} : { 'content-type': type }).end(module);
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

/// Some operations of every kind on a mesh without records; what became of them.
function sculpted(mesh, seed, count) {
  const random = (n) => (seed = (seed * 48271) % 2147483647) % n;
  return Array.from({ length: count }, () => {
    const { triangles } = mesh;
    const t = 3 * random(triangles.length / 3);
    const [a, b, c] = triangles.subarray(t, t + 3);
    const operations = [() => mesh.collapse(a, b), () => mesh.flip(a, b), () => mesh.bisect(a, b), () => mesh.splitFace(a, b, c),
      () => mesh.split(a, mesh.addPoint(a, b, c), b, c)];
    return operations[random(5)]();
  });
}
/// Everything that undo restores.
function stateOf(mesh) {
  const { triangles, strips, played, inOrder, baked } = mesh.figures;
  return { triangles: [...mesh.triangles], points: [...mesh.points], ribbon: [...mesh.ribbon], figures: { triangles, strips, played, inOrder, baked } };
}

/// Undo restores points, triangles, strips and figures, and what is drawn are the triangles. Redo leads back, also to other levels and
/// to operations that left the records.
function undoRestores() {
  /// Frames of `operate`, the last one without an update; then back, forth and back.
  const thereAndBack = (mesh, operate) => {
    mesh.update();
    const states = [stateOf(mesh)];
    for (let n = 0; n < 5; ++n) {
      operate(mesh, n);
      if (n < 4) mesh.update();
      states.push(stateOf(mesh));
    }
    const seen = () => {
      mesh.update();
      return stateOf(mesh);
    };
    const last = mesh.triangles;
    for (let n = 5; n-- > 0;) {
      assert.ok(mesh.undo());
      assert.deepEqual(seen(), states[n]);
    }
    assert.ok(!mesh.undo() && mesh.last === null);
    assert.deepEqual(mesh.history, { undoable: 0, redoable: 5 });
    for (let n = 1; n < 5; ++n) {
      assert.ok(mesh.redo());
      assert.deepEqual(seen(), states[n]);
    }
    assert.ok(mesh.redo() && !mesh.redo() && mesh.valid);
    assert.deepEqual([mesh.triangles, [...mesh.points]], [last, states[5].points]);
    while (mesh.undo());
    mesh.update();
  };
  for (const [policy, cost] of [['local', 'strips'], ['quick', 'strips'], ['quick', 'indices'], ['full', 'indices']])
    for (const [form, bits] of [['restart', 32], ['stitched', 'auto'], ['lengths', 16]]) {
      const mesh = restrip.mesh(grid(9, 9)).begin({ policy, cost, form, bits, history: 1e6 });
      thereAndBack(mesh, (each, n) => sculpted(each, 100 * n + 7, 6));
      mesh.close();
    }
  // Levels, and operations that leave them.
  for (const options of [{ policy: 'quick' }, { policy: 'baked' }]) {
    const mesh = options.policy === 'baked' ? restrip.baked(readFileSync(join(folder, 'hare.baked'))) : restrip.progressive(source);
    mesh.begin({ ...options, history: 1e6 }).moveTo(600);
    mesh.update();
    const before = stateOf(mesh);
    const levels = [900, 400, 410, 1200, 1000];
    const start = mesh.history.undoable;
    for (const level of levels) {
      mesh.moveTo(level);
      mesh.update();
    }
    const [a, b] = mesh.triangles;
    assert.ok(mesh.bisect(a, b).ok);
    assert.throws(() => mesh.moveTo(10), /undo them, or call begin\(\) again/);
    assert.ok(mesh.undo());
    assert.deepEqual([mesh.figures.played, mesh.figures.inOrder, mesh.figures.baked], [1000, true, options.policy === 'baked']);
    assert.ok(mesh.redo());
    assert.throws(() => mesh.moveTo(10), /undo them/);
    while (mesh.history.undoable > start) mesh.undo();
    mesh.update();
    assert.deepEqual(stateOf(mesh), before);
    assert.ok(mesh.redo() && mesh.moveTo(10) > 0, 'a frame after undo is not one of those that left the records');
    mesh.close();
  }
  // A limited history forgets its oldest frames, with their points.
  const mesh = restrip.mesh(grid(9, 9)).begin({ history: 60 });
  const states = [];
  for (let n = 0; n < 40; ++n) {
    mesh.update();
    states.push(stateOf(mesh));
    sculpted(mesh, n + 1, 4);
  }
  let back = 0;
  for (; mesh.undo(); ++back) {
    mesh.update();
    assert.deepEqual(stateOf(mesh), states.at(-1 - back));
  }
  assert.ok(back >= 1 && back < 20, `${back} frames undone`);
  assert.ok(!restrip.mesh(grid(3, 3)).begin().undo());
}

/// A mesh that was saved has the same triangles, points and strips when it is loaded, also in another library. Bytes that were damaged are
/// refused with a sentence, and the library stays as it was.
async function savedIsLoaded() {
  const other = await load();
  for (const [policy, cost, form, bits] of [['quick', 'indices', 'restart', 32], ['full', 'strips', 'stitched', 'auto'], ['bare', 'indices', 'list', 16]]) {
    const mesh = restrip.mesh(grid(9, 9)).begin({ policy, cost, form, bits, layout: { cache: 16, waste: 50 } });
    sculpted(mesh, 3, 40);
    mesh.update();
    sculpted(mesh, 4, 4);
    const bytes = mesh.save();
    assert.ok(bytes instanceof Uint8Array);
    const resumed = other.saved(bytes, { points: mesh.points, history: 1e5 });
    mesh.update();
    assert.ok(resumed.update().outgrown);
    assert.deepEqual(stateOf(resumed), stateOf(mesh));
    const before = stateOf(resumed);
    sculpted(resumed, 1, 4);
    resumed.update();
    assert.ok(resumed.undo() && !mesh.undo());
    assert.deepEqual(stateOf(resumed), before);
    assert.throws(() => other.saved(bytes, { points: [0, 0, 0] }), /^Error: saved mesh with 1 points: it has \d+ vertices$/);
    assert.throws(() => other.saved(bytes, { points: mesh.points, form }), /saved has no option 'form'/);
    // Saved again, and begun again from what it is.
    const [shown, again] = [sorted(mesh.triangles), other.saved(mesh.save(), { points: mesh.points })];
    assert.deepEqual(sorted(again.begin({ policy: 'local' }).triangles), shown);
    assert.equal(again.levels, 0);
    for (const each of [mesh, resumed, again]) each.close();
  }
  const { library, exports } = await loadOpen();
  const mesh = library.mesh(grid(4, 4)).begin();
  const whole = mesh.save();
  const { points } = mesh;
  const wrong = (bytes, why) => assert.throws(() => library.saved(bytes, { points }), (error) => {
    assert.ok(!(error instanceof WebAssembly.RuntimeError), error);
    assert.match(error.message, why);
    return true;
  });
  wrong(new Uint8Array(40), /^these bytes are not a saved LiveMesh$/);
  const { byteLength } = exports.memory.buffer;
  for (let round = 0; round < 20; ++round)
    for (let at = 0; at < whole.length; at += 3) {
      wrong(whole.subarray(0, at), /truncated|checksum/);
      const altered = whole.slice();
      altered[at] ^= 1 << at % 8;
      wrong(altered, /not a saved|version|checksum/);
    }
  assert.equal(exports.memory.buffer.byteLength, byteLength);
  assert.ok(library.saved(whole.buffer.slice(whole.byteOffset, whole.byteOffset + whole.length), { points }).valid && mesh.bisect(0, 1).ok && mesh.valid);
}

/// Another policy and cost for the same mesh, strips from scratch that stay, background work and an order for a cache: each keeps
/// the triangles, and lowers what it is for.
function keepsAndRecolors() {
  const open = (options) => {
    const mesh = restrip.mesh(grid(40, 40)).begin({ history: 1e6, ...options });
    sculpted(mesh, 5, 400);
    mesh.update();
    return mesh;
  };
  const drawnSame = (mesh, triangles) => {
    const copy = mesh.indices.slice();
    for (const { first, count } of mesh.update()) copy.set(mesh.indices.slice(first, Math.min(first + count, copy.length)), first);
    assert.deepEqual(sorted(drawn([...mesh.indices])), triangles);
    assert.ok(mesh.valid);
  };
  const mesh = open({ policy: 'rules', cost: 'indices' });
  const triangles = sorted(mesh.triangles);
  const before = mesh.plainIndices;
  assert.equal(mesh.recolor({ effort: 'full', cost: 'indices' }), mesh.figures.strips);
  assert.equal(mesh.figures.bufferIndices, null);
  assert.ok(mesh.plainIndices < before, `${mesh.plainIndices} of ${before}`);
  drawnSame(mesh, triangles);
  assert.ok(mesh.undo() && mesh.plainIndices === before);
  drawnSame(mesh, triangles);
  assert.ok(mesh.redo() && mesh.plainIndices < before);
  drawnSame(mesh, triangles);
  const strips = mesh.figures.strips;
  mesh.keep({ policy: 'full', cost: 'strips' });
  for (let n = 0; n < 30; ++n) mesh.improve(1000);
  assert.ok(mesh.figures.strips < strips / 2, `${mesh.figures.strips} of ${strips}`);
  drawnSame(mesh, triangles);
  // Kept under another policy, later operations have its results: as if it had begun there.
  const [kept, other] = [open({ policy: 'rules', cost: 'indices' }), open({ policy: 'rules', cost: 'indices' })];
  kept.keep({ policy: 'quick', cost: 'indices' });
  for (const each of [kept, other]) sculpted(each, 9, 400);
  assert.ok(kept.plainIndices < other.plainIndices - 20, `${kept.plainIndices}, ${other.plainIndices}`);
  // In the order of a cache, a cache of that size misses less often.
  const misses = (indices) => {
    const cache = [];
    return indices.filter((v) => v !== restartIndex && !cache.includes(v) && cache.push(v) && (cache.length <= 32 || cache.shift() !== none)).length;
  };
  const [ordered, plain] = [open({ layout: { cache: 32 } }), open({ layout: { cache: 0, work: 0 } })];
  for (const each of [ordered, plain]) drawnSame(each, triangles);
  assert.ok(misses([...ordered.indices]) < 0.95 * misses([...plain.indices]), `${misses([...ordered.indices])}, ${misses([...plain.indices])}`);
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

/// What figures say of the buffer is of the mesh as it is: null from an operation to update(), otherwise what is drawn.
function bufferFiguresAreFresh() {
  for (const form of ['restart', 'stitched', 'list']) {
    const mesh = restrip.progressive(source).begin({ form });
    const drawnIndices = () => mesh.draws.reduce((sum, { count }) => sum + count, 0);
    const fresh = () => assert.equal(mesh.figures.bufferIndices, drawnIndices());
    fresh();
    for (const operate of [() => mesh.moveTo(100), () => mesh.moveTo(90), () => mesh.approach(new Uint8Array(mesh.levels)), () => mesh.flip(...mesh.triangles.subarray(0, 2)),
      () => mesh.bisect(...mesh.triangles.subarray(6, 8))]) {
      const done = operate();
      if (done.ok !== false) assert.equal(mesh.figures.bufferIndices, null);
      mesh.update();
      fresh();
    }
    const refused = mesh.collapse(0, 0);
    assert.ok(!refused.ok);
    fresh();
    mesh.close();
  }
}

for (const test of [asDependency, misuseThrows, worksAboveTwoGigabytes, unclosedIsFreed, compilesFromServers, undoRestores, savedIsLoaded, keepsAndRecolors, refusalsNameVertices, bufferFiguresAreFresh, singleOperations, sameRules, copiesByRanges, sculpts, sixteenBitsAreKept, beginKeepsEdits, pointsGrowInConstantTime, threeFollows, viewDependent, simplifies, refusesDamage, sameAsBaked, sameAsReplay]) {
  await test();
  console.log(`${test.name}: as claimed`);
}
