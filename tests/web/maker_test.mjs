// Claim: the page's module is the programs. For every operation file of the project, for families, and for 30 random
// operations, the module writes the same certificate, header and tables in other languages, and the verifier's claims
// and its last line are the same, byte by byte. Files with mistakes are refused in the same words. Of 60 certificates
// with one rule changed, and sealed again, the module and the program say the same: first line, claims, counterexamples.
// On the page's sheet of triangles each table can be applied, and adds no more strips than its report says.
//   node maker_test.mjs WEB_FOLDER RESTRIP_GENERATE RESTRIP_VERIFY MODULE SCRATCH
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { load } from '../../bindings/js/restrip.mjs';
import { judged, made, program } from '../../web/maker/programs.mjs';
import { Drawing } from '../../web/maker/surface.mjs';
import { Trial } from '../../web/maker/trial.mjs';
import { randomOperation } from './random_operations.mjs';

/// The certificate with its last line made again: the number of rows, the sum of all bytes, and the sum of each byte times
/// its number (docs/reference/certificate.md).
function sealed(text) {
  const body = text.replace(/end [^\n]*\n$/, '');
  let [plain, numbered] = [0n, 0n];
  new TextEncoder().encode(body).forEach((byte, i) => {
    plain += BigInt(byte);
    numbered += BigInt(byte) * BigInt(i + 1);
  });
  return `${body}end ${body.split('\n').filter((line) => /^(rule|copy|alternative) /.test(line)).length} ${plain} ${numbered}\n`;
}

const [folder, generateProgram, verifyProgram, module, scratch] = process.argv.slice(2);
const root = fileURLToPath(new URL('../../', import.meta.url));
rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });
let heard = [];
const started = async (file, listen) => {
  const compiled = await WebAssembly.compile(readFileSync(file));
  return { generate: await program(compiled, 'generate'), judge: await program(compiled, 'judge', listen) };
};
const modules = await started(module, (one) => heard.push(one));
const languages = ['c++', 'c', 'glsl', 'json', 'rust', 'wgsl'];

const run = (program, ...words) => spawnSync(program, words, { cwd: scratch, encoding: 'utf8', maxBuffer: 1 << 28 });
/// Claims without their times.
const untimed = (claims) => claims.map(({ seconds, ...rest }) => rest);

/// The verdict of the program on files of the scratch folder.
function nativeVerdict(name, certificate, header, words = []) {
  const given = ['--operation', name, '--certificate', certificate, ...(header ? ['--header', header] : []), ...words];
  const { status, stdout, stderr } = run(verifyProgram, ...given, '--json', 'verdict.json');
  if (status === 2) return { error: stderr.trim().replace(/^restrip-verify: /, '') };
  const { claims, failed } = JSON.parse(readFileSync(join(scratch, 'verdict.json'), 'utf8'));
  assert.equal(status, failed === 0 ? 0 : 1);
  return { claims: untimed(claims), failed, last: stdout.trim().split('\n').at(-1) };
}
const told = ({ error, claims, failed, last }) => (error ? { error } : { claims: untimed(claims), failed, last: last.trim().split('\n').at(-1) });

/// Both ways of one file; returns what the modules made.
async function compare(name, text, maxK) {
  writeFileSync(join(scratch, name), text);
  const words = maxK ? ['--max-k', String(maxK)] : [];
  const native = run(generateProgram, 'rules', '--operation', name, '--out', 'rules', '--language', languages.join(), '--json', 'report.json', ...words);
  heard = [];
  const mine = await made(modules, name, text, { languages, ...(maxK ? { max_k: maxK } : {}) });
  if (native.status !== 0) {
    assert.equal(mine.error, native.stderr.trim().replace(/^restrip-generate: /, ''), name);
    return mine;
  }
  assert.equal(mine.error, undefined, name);
  for (const [file, bytes] of Object.entries(mine.files)) assert.ok(bytes === readFileSync(join(scratch, 'rules', file), 'utf8'), `${name}: ${file} differs`);
  for (const [file, bytes] of Object.entries(mine.bytes)) assert.ok(Buffer.from(bytes).equals(readFileSync(join(scratch, 'rules', file))), `${name}: ${file} differs`);
  const checks = Object.keys(mine.files).filter((file) => /restrip_check_of_/.test(file)).length;
  assert.deepEqual([Object.keys(mine.files).length - checks, Object.keys(mine.bytes).length], [languages.length + 1, 1]);
  assert.deepEqual(mine.report, JSON.parse(readFileSync(join(scratch, 'report.json'), 'utf8')).operations);
  const [certificate, header] = ['.cert', '.hpp'].map((ending) => `rules/${Object.keys(mine.files).find((file) => file.endsWith(ending))}`);
  // The files of the programs have other names.
  const renamed = JSON.parse(JSON.stringify(nativeVerdict(name, certificate, header, words)).replaceAll(certificate, 'rules.cert').replaceAll(header, 'rules.hpp'));
  assert.deepEqual(told(mine.verdict), renamed, name);
  assert.deepEqual(heard.filter(({ claim }) => claim).map(({ claim }) => claim), mine.verdict.claims);
  assert.equal(mine.verdict.failed, 0, name);
  return mine;
}

// ---- every operation file, under a name that is free, and families
const operations = new Map();
for (const name of readdirSync(join(root, 'tables/operations'))) {
  const text = readFileSync(join(root, 'tables/operations', name), 'utf8').replace(/"name": "([^"]*)"/, '"name": "my-$1"');
  operations.set(`my-${name}`, [text, await compare(`my-${name}`, text)]);
}
assert.ok(operations.size >= 10);
for (const name of ['own_cost', 'own_operation']) await compare(`${name}.json`, readFileSync(join(root, 'examples', `${name}.json`), 'utf8'));
for (const k of [3, 5]) await compare('own_family.json', readFileSync(join(root, 'examples/own_family.json'), 'utf8'), k);

// ---- 30 random ones
let seed = 20;
const random = (n) => (seed = seed * 48271 % 2147483647) % n;
let refused = 0;
const shapes = new Set();
for (let n = 0; n < 30; ++n) {
  const operation = randomOperation(random, `random-${n}`);
  shapes.add(`${operation.before.length} ${operation.after.length} ${operation.constraint} ${operation.cost ? 'cost' : ''} ${operation.boundary ? 'boundary' : ''}`);
  const text = JSON.stringify(operation, null, 1);
  const mine = await compare(`random-${n}.json`, text);
  if (mine.error) ++refused;
  else operations.set(`random-${n}.json`, [text, mine]);
}
assert.ok(refused < 15 && shapes.size > 15, `${refused} refused, ${shapes.size} shapes`);

// ---- tried on the sheet of the page: the mesh stays valid, and no strip more than the table allows is added; undone, all is as before
globalThis.document = { activeElement: null };
const element = { addEventListener() {}, contains: () => false, querySelector: () => ({ setAttribute() {} }) };
const restrip = await load(readFileSync(join(folder, 'package/restrip.wasm')));
let applied = 0;
for (const [name, [text, mine]] of operations) {
  const table = JSON.parse(Object.entries(mine.files).find(([file]) => file.endsWith('.json'))[1]);
  if (table.matching) continue;
  let words = '';
  const drawing = Drawing.of(text);
  const trial = new Trial(restrip, element, (said) => { words = said; });
  trial.begin(drawing, table);
  for (let n = 0; n < 3 && trial.places.length > 0; ++n) {
    const [before, { triangles }] = [trial.strips, trial.mesh.figures];
    trial.near = random(trial.places.length);
    trial.apply();
    assert.match(words, /^Applied/, `${name}: ${words}`);
    ++applied;
    assert.ok(trial.mesh.valid && trial.strips <= before + mine.report[0].worst_strips, `${name}: ${words}`);
    assert.equal(trial.mesh.figures.triangles, triangles + drawing.operation.after.length - drawing.operation.before.length);
    trial.undo();
    assert.equal(trial.strips, before);
    trial.apply();
  }
}
assert.ok(applied > 40, `${applied} operations on the sheet`);

// ---- files with mistakes: the same sentence, with line, column and member
const good = [...operations.values()][0][0];
const mistakes = [good.replace('"before"', '"befor"'), good.slice(0, 90), good.replace('"a", "b", "c"', '"a", "b", "b"'), good.replace(/"name": "[^"]*"/, '"name": "Big Name"'),
  good.replace('"after": [', '"after": [["x", "y", "z"], '), '[]', '{', '', '\u0000', '{"restrip_operation": 1, "name": "x", "before": {"triangles": 1}, "after": {"triangles": 1}}'];
const sentences = new Set();
for (const [n, text] of mistakes.entries()) {
  const { error } = await compare(`mistake-${n}.json`, text);
  assert.match(error, new RegExp(`^mistake-${n}\\.json`));
  sentences.add(error.replace(/^[^ ]* /, ''));
}
assert.ok(sentences.size > 7, [...sentences].join('\n'));

// ---- 60 certificates with one rule changed
const all = [...operations].filter(([, [, mine]]) => mine.certificate.split('\n').length > 8);
let notVerified = 0;
for (let n = 0; n < 60; ++n) {
  const [name, [text, mine]] = all[random(all.length)];
  const lines = mine.certificate.split('\n');
  const rows = [...lines.keys()].filter((i) => /^(rule|copy) /.test(lines[i]));
  const row = rows[random(rows.length)];
  const words = lines[row].split(' ');
  const inner = +/\{\d+, \d+\},\s*\{\d+, (\d+)\},/.exec(mine.header)[1];
  words[3] = (parseInt(words[3], 16) ^ 1 << random(inner)).toString(16);
  lines[row] = words.join(' ');
  const certificate = sealed(lines.join('\n'));
  writeFileSync(join(scratch, 'rules.cert'), certificate);
  const verdict = await judged(modules.judge, name, text, { certificate });
  assert.deepEqual(told(verdict), nativeVerdict(name, 'rules.cert'), `${name}: ${lines[row]}`);
  assert.ok(verdict.error || verdict.failed > 0, `${name}: ${lines[row]} is accepted`);
  if (!verdict.error) ++notVerified;
}
assert.ok(notVerified > 45, `${notVerified} judged`);
// What is not sealed is refused by its sums, in the same words.
{
  const [name, [text, mine]] = all[0];
  const certificate = mine.certificate.replace('claim keys', 'claim kexs');
  writeFileSync(join(scratch, 'rules.cert'), certificate);
  const verdict = await judged(modules.judge, name, text, { certificate });
  assert.deepEqual(told(verdict), nativeVerdict(name, 'rules.cert'));
  assert.match(verdict.error, /^rules\.cert/);
}
console.log(`${operations.size} operations, ${refused} refused, ${sentences.size} sentences, 60 changed rules, ${notVerified} of them judged`);
