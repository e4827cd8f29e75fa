#!/usr/bin/env node
// How often the splits of real meshes meet each rule of closed fans, as CSV: web/atlas/met.csv is made by
//   scripts/met_rules.mjs $RESTRIP_MESHES fandisk rocker-arm nefertiti bunny > web/atlas/met.csv
// Each mesh is simplified to 2 % of its triangles and played up under the policy `local`. A rule is named as in the atlas: by
// k, a and the key that represents its orbit. Rows `boundary` and `larger` are splits at the boundary and of fans with
// k > 8. Build the targets `web` and `restrip_program` of the preset release first.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('../', import.meta.url));
const [meshes, ...names] = process.argv.slice(2);
if (names.length === 0) {
  console.error('usage: scripts/met_rules.mjs FOLDER MESH…   (MESH: the name of an .obj file in it, without extension)');
  process.exit(2);
}
const folder = join(root, 'build/release/web/package');
const { load } = await import(pathToFileURL(join(folder, 'restrip.mjs')));
const { loadReaders } = await import(pathToFileURL(join(folder, 'formats.mjs')));
const { readMesh } = await loadReaders();
const { listed, representative, ruleName } = await import('../web/viewer/patch.mjs');
const restrip = await load();
const scratch = mkdtempSync(join(tmpdir(), 'restrip-met-'));

const rules = new Map();  // by name, a count for each mesh
for (const [n, name] of names.entries()) {
  const file = join(scratch, `${name}.pm`);
  execFileSync(join(root, 'build/release/bin/restrip'), ['simplify', join(meshes, `${name}.obj`), '--base', '0.02', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
  const mesh = restrip.progressive(await readMesh(file, readFileSync(file))).begin({ policy: 'local' });
  for (let level = 1; level <= mesh.levels; ++level) {
    mesh.moveTo(level);
    const { closed, k, a, before, ports } = mesh.last;
    const there = listed(k, a, before, ports);
    const rule = !closed ? 'boundary' : k > 8 ? 'larger' : ruleName(k, there.a, representative(k, there.a, there.loop, there.ports));
    if (!rules.has(rule)) rules.set(rule, names.map(() => 0));
    ++rules.get(rule)[n];
  }
  mesh.close();
}
rmSync(scratch, { recursive: true });
console.log(['rule', ...names].join());
for (const rule of [...rules.keys()].sort()) console.log([rule, ...rules.get(rule)].join());
