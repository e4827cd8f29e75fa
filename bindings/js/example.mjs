// The savings of maintained strips:  node example.mjs MESH
// The mesh goes from its coarsest level to its finest in steps of 1 %, once for each kind of index buffer.
import { readFile } from 'node:fs/promises';
import { load } from 'restrip-wasm';
import { loadReaders } from 'restrip-wasm/formats';

const [file] = process.argv.slice(2);
if (!file) {
  console.error('usage: node example.mjs MESH');
  process.exit(2);
}
const restrip = await load();
const { readMesh, simplified } = await loadReaders();
const read = await readMesh(file, await readFile(file));
const levels = read.triangles ? await simplified(read) : read;
const open = () => (levels.baked ? restrip.baked(levels.baked) : restrip.progressive(levels));

const sum = (ranges) => ranges.reduce((all, { count }) => all + count, 0);
/// Each brings its index buffer in step with the mesh; it returns the number written, and the number in the buffer.
const ways = {
  'strips kept': { policy: 'quick', follow: (mesh) => [sum(mesh.update()), mesh.indices.length] },
  'strips from scratch': { policy: 'bare', follow: (mesh) => { const { length } = mesh.fromScratch({ cost: 'indices' }); return [length, length]; } },
  'list with slots': { policy: 'bare', form: 'list', follow: (mesh) => [sum(mesh.update()), mesh.indices.length] },
};
for (const [name, { policy, form, follow }] of Object.entries(ways)) {
  const mesh = open().begin({ policy, form, cost: 'indices' });
  follow(mesh);
  let [written, drawn] = [0, 0];
  const start = performance.now();
  for (let percent = 1; percent <= 100; ++percent) {
    mesh.moveTo(Math.round(mesh.levels * percent / 100));
    const [now, all] = follow(mesh);
    written += now;
    drawn = all;
  }
  const took = performance.now() - start;
  console.log(`${name}: ${4 * written} bytes written, ${took.toFixed(0)} ms, ${drawn} indices draw ${mesh.figures.triangles} triangles`);
  mesh.close();
}
