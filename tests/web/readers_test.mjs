// The package reads what the program reads, with the same triangles and positions, and refuses the same files with the
// same messages: every format, in each form that the program writes, glTF with nodes, numbers of every spelling,
// damaged files.
//   node readers_test.mjs WEB_FOLDER RESTRIP SCRATCH
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, program, scratch] = process.argv.slice(2);
mkdirSync(scratch, { recursive: true });
const { loadReaders } = await import(pathToFileURL(join(folder, 'package/formats.mjs')));
const { readMesh } = await loadReaders();

const within = (name) => join(scratch, name);
const read = (file) => readMesh(file, readFileSync(file));
/// What the program reads from a file, from the OFF that it writes; triangles begun at their first corner in the file.
function nativelyRead(file, ...options) {
  execFileSync(program, ['convert', file, ...options, '-o', within('native.off')]);
  const words = readFileSync(within('native.off'), 'utf8').split(/\s+/).slice(1).map(Number);
  const [pointCount, faceCount] = words;
  const points = Float32Array.from(words.slice(3, 3 + 3 * pointCount));
  const faces = words.slice(3 + 3 * pointCount, 3 + 3 * pointCount + 4 * faceCount);
  return { points, triangles: Uint32Array.from(faces.filter((_, n) => n % 4 !== 0)) };
}
/// The sentence that the program refuses a file with.
function nativeRefusal(file) {
  const { status, stderr } = spawnSync(program, ['stats', file], { encoding: 'utf8' });
  assert.equal(status, 2, `${file} is not refused`);
  return stderr.trim().replace(/^restrip: /, '');
}
async function sameRefusal(name, content) {
  writeFileSync(within(name), content);
  const sentence = nativeRefusal(within(name));
  await assert.rejects(read(within(name)), { message: sentence });
}
/// What the program leaves out of a file.
function nativelyLeftOut(file) {
  const line = execFileSync(program, ['stats', file], { encoding: 'utf8' }).split('\n').find((each) => each.startsWith('left out: '));
  return (line ?? '').replace('left out: ', '');
}
async function sameTriangles(file, ...options) {
  const { points, triangles, leftOut } = await read(file);
  assert.deepEqual({ points, triangles }, nativelyRead(file, ...options), file);
  assert.equal(leftOut, nativelyLeftOut(file));
}

async function everyFormat() {
  const hare = join(folder, 'hare.obj');
  await sameTriangles(hare);
  for (const to of ['off', 'stl', 'ply', 'glb', 'obj']) {
    execFileSync(program, ['convert', hare, '-o', within(`hare.${to}`)]);
    await sameTriangles(within(`hare.${to}`));
  }
  for (const [to, ...form] of [['ply'], ['glb'], ['glb', '--gltf', 'restart'], ['glb', '--gltf', 'list']]) {
    const file = within(`strips${form[1] ?? ''}.${to}`);
    execFileSync(program, ['stripify', hare, ...form, '-o', file]);
    await sameTriangles(file);
  }
  const progressive = await read(join(folder, 'hare.pm'));
  const bytes = readFileSync(join(folder, 'hare.pm'));
  const [vertices, faces, splits] = [8, 12, 16].map((at) => bytes.readUInt32LE(at));
  assert.deepEqual([progressive.points.length, progressive.base.length, progressive.splits.length], [3 * (vertices + splits), 3 * faces, 4 * splits]);
  assert.deepEqual([...progressive.base], Array.from({ length: 3 * faces }, (_, n) => bytes.readUInt32LE(20 + 12 * vertices + 4 * n)));
  const baked = readFileSync(join(folder, 'hare.baked'));
  assert.deepEqual((await read(join(folder, 'hare.baked'))).baked, new Uint8Array(baked));
  execFileSync(program, ['convert', join(folder, 'hare.baked'), '-o', within('baked.glb')]);
  assert.deepEqual((await read(within('baked.glb'))).baked, new Uint8Array(baked));
}

const tetrahedron = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];
const points = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];

/// glTF with meshes that nodes move, turn and mirror, one of them used twice; positions are quantized.
function scene(nodes, more = {}, count = 4) {
  const text = JSON.stringify({ asset: { version: '2.0' }, extensionsUsed: ['KHR_mesh_quantization'], extensionsRequired: ['KHR_mesh_quantization'],
    scene: 1, scenes: [{ nodes: [0] }, { nodes: [1, 3] }], nodes,
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }, { mode: 5, attributes: { POSITION: 2 } }] }],
    accessors: [{ bufferView: 0, componentType: 5122, type: 'VEC3', count: 4, min: [-32767, 0, 0], max: [32767, 32767, 32767], ...more },
      { bufferView: 1, componentType: 5121, type: 'SCALAR', count: 12 }, { bufferView: 2, componentType: 5120, type: 'VEC3', count, min: [-2, 0, 0], max: [5, 5, 7] }],
    bufferViews: [{ buffer: 0, byteOffset: 0, byteLength: 32, byteStride: 8 }, { buffer: 0, byteOffset: 32, byteLength: 12 }, { buffer: 0, byteOffset: 44, byteLength: 16, byteStride: 4 }],
    buffers: [{ byteLength: 60 }] });
  const padded = text.padEnd(Math.ceil(text.length / 4) * 4);
  const out = Buffer.alloc(28 + padded.length + 60);
  [0x46546c67, 2, out.length, padded.length].forEach((n, i) => out.writeUInt32LE(n, 4 * i));
  out.write('JSON', 16);
  out.write(padded, 20);
  out.writeUInt32LE(60, 20 + padded.length);
  out.write('BIN\0', 24 + padded.length, 'latin1');
  const at = 28 + padded.length;
  points.forEach((c, i) => out.writeInt16LE(i === 3 ? -32767 : c * 32767, at + 8 * Math.floor(i / 3) + 2 * (i % 3)));
  tetrahedron.forEach((v, i) => out.writeUInt8(v, at + 32 + i));
  [[3, 3, 3], [5, 3, 3], [-2, 5, 3], [5, 5, 7]].flat().forEach((c, i) => out.writeInt8(c, at + 44 + 4 * Math.floor(i / 3) + i % 3));
  return out;
}

async function nodesOfScenes() {
  const nodes = [{ mesh: 0, translation: [100, 0, 0] }, { translation: [8, 0, -4], rotation: [0, 1, 0, 0], children: [2, 4] }, { mesh: 0, scale: [2, -0.5, 4] },
    { mesh: 0, matrix: [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 32, 16, 8, 1] }, { mesh: 0, translation: [0, 64, 0] }];
  for (const more of [{ normalized: true }, {}]) {
    writeFileSync(within('nodes.glb'), scene(nodes, more));
    assert.equal((await read(within('nodes.glb'))).triangles.length, 3 * 3 * 6);
    await sameTriangles(within('nodes.glb'), '--weld');
  }
  await sameRefusal('twice.glb', scene([nodes[0], { children: [2, 2] }, nodes[2], nodes[3]]));
  await sameRefusal('cut.glb', scene(nodes).subarray(0, -30));
}

/// Vertices that glTF repeats, for example because normals differ, become one.
async function seamsAreWelded() {
  const json = { asset: { version: '2.0' }, meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count: 12 }], bufferViews: [{ buffer: 0, byteLength: 144 }],
    buffers: [{ byteLength: 144, uri: `data:application/octet-stream;base64,${Buffer.from(Float32Array.from(tetrahedron.flatMap((v) => points.slice(3 * v, 3 * v + 3))).buffer).toString('base64')}` }] };
  const found = await readMesh('seams.gltf', new TextEncoder().encode(JSON.stringify(json)));
  assert.deepEqual([found.points.length, found.triangles.length, found.leftOut], [12, 12, 'normals']);
  json.buffers[0].uri = 'other.bin';
  await assert.rejects(readMesh('seams.gltf', new TextEncoder().encode(JSON.stringify(json))), /'other\.bin', which is not at hand; save it as one file/);
}

/// What is left out of any file is the program's sentence.
async function leftOut() {
  const mesh = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
  const ply = (vertex, face, values, more) => 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n' +
    `${vertex}element face 1\nproperty list uchar int vertex_index\n${face}end_header\n` + ['0 0 0', '1 0 0', '0 1 0'].map((p) => `${p} ${values}\n`).join('') + `3 0 1 2 ${more}\n`;
  const gltf = (node, more) => JSON.stringify({ asset: { version: '2.0' }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, ...node }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }, { attributes: { POSITION: 0 }, mode: 1 }, { attributes: {}, mode: 4 }] }],
    accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count: 3 }], bufferViews: [{ buffer: 0, byteLength: 36 }],
    buffers: [{ byteLength: 36, uri: `data:;base64,${Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer).toString('base64')}` }], ...more });
  for (const [name, content, words] of [
    ['other.obj', `${mesh}l 1 2\np 1\nvn 0 0 1\nwobble\n`, 'normals, lines `wobble`'], ['bad.obj', `${mesh}f 1//0 2 3\n`, ''],
    ['polygon.obj', `${mesh}v 1 1 0\nusemtl a\nf 1 2 4 3\n`, 'materials'],
    ['other.ply', ply('property int near\n', 'property uchar red\n', '7', '255'), 'property `near` of `vertex`, colours of `face`'],
    ['other.off', 'COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\nmore\n', 'colours, text after the last face'],
    ['other.stl', 'solid\nfacet normal 0 0 1 colour outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid\n', '`colour`'],
    ['other.gltf', gltf({ skin: 0, camera: 0 }, { animations: [{}], extensionsUsed: ['EXT_mesh_gpu_instancing'] }), 'instances (EXT_mesh_gpu_instancing)']]) {
    writeFileSync(within(name), content);
    const found = await read(within(name));
    assert.equal(found.leftOut, nativelyLeftOut(within(name)));
    assert.ok(found.leftOut.includes(words) && (words !== '' || found.leftOut === ''), found.leftOut);
  }
}

/// Each is the same number to both, or refused in the same words.
async function numbersInWords() {
  const spelled = ['+1', '1.', '.5', '-0', '1e5', '1E-3', '1e-40', '0.1000000000000000055511151231257827', '16777217', '1e-999'];
  const refused = ['1e999', '0x10', '++1', '1e', '-', '1d5', 'nan', 'inf', '-infinity', '1_0', ''];
  for (const [n, word] of spelled.entries()) {
    writeFileSync(within('number.obj'), `v ${word} 2 3\nv 1 0 0\nv 0 1 ${n}\nf 1 2 3\n`);
    await sameTriangles(within('number.obj'));
  }
  for (const word of refused) await sameRefusal('number.obj', `v 1 2 ${word}\nv 1 0 0\nv 0 1 0\nf 1 2 3\n`);
}

async function damaged() {
  for (const [name, content] of [['empty.obj', ''], ['no.obj', 'v 0 0 0\n'], ['beyond.obj', 'v 0 0 0\nf 1 2 3\n'], ['cut.off', 'OFF\n4 4 0\n1 2'],
    ['no.ply', 'nothing'], ['no.pm', 'nothing'], ['no.glb', 'nothing'], ['no.stl', 'nothing'], ['no.baked', 'nothing'], ['no.xyz', 'nothing'],
    ['large.ply', 'ply\nformat ascii 1.0\nelement vertex 18446744073709551615\nproperty float x\nend_header\n'],
    ['wraps.ply', 'ply\nformat ascii 1.0\nelement vertex 4294967297\nproperty float x\nend_header\n1\n'],
    ['beyond.gltf', '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[4294967296]}],"nodes":[{}]}'],
    ['json.gltf', '{"asset":']])
    await sameRefusal(name, content);
  for (const [from, at] of [['hare.pm', 21], ['hare.baked', 40], ['hare.baked', 3000]]) {
    const bytes = readFileSync(join(folder, from));
    bytes[at] ^= 0x40;
    await sameRefusal(from.replace('.', `${at}.`), from === 'hare.pm' ? bytes.subarray(0, -1) : bytes);
  }
  await sameRefusal('photo.png', readFileSync(new URL('../../docs/ribbon.png', import.meta.url)));
  await assert.rejects(read(within('photo.png')), /photo.png: a picture, which has no triangles; give a mesh: .obj/);
  // One refused file is not a fault of the next.
  assert.equal((await readMesh('t.obj', new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'))).triangles.length, 3);
}

for (const test of [everyFormat, nodesOfScenes, seamsAreWelded, leftOut, numbersInWords, damaged]) {
  await test();
  console.log(`${test.name}: as claimed`);
}
