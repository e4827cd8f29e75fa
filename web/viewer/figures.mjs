// The mesh that is shown and its figures, as text.
import { none } from '../js/restrip.mjs';

const number = (n) => n.toLocaleString('en');
const bytes = (n) => (n < 1e6 ? `${(n / 1000).toFixed(1)} kB` : `${(n / 1e6).toFixed(2)} MB`);

export function showFigures(by, { figures: f, source, mesh, level, lastFrame, timed }, milliseconds) {
  by('level').value = level;
  const name = source.name === 'hare' ? 'this hare' : 'this mesh';
  by('claim').textContent = f.strips === 1 ? `All ${number(f.triangles)} triangles of ${name} are one strip. Move the level.`
    : `${number(f.triangles)} triangles of ${name} in ${number(f.strips)} strips. Move the level.`;
  by('level-text').textContent = `${number(f.played)} of ${number(mesh.levels)} splits`;
  by('f-triangles').textContent = number(f.triangles);
  by('f-strips').textContent = number(f.strips);
  by('f-length').textContent = (f.triangles / f.strips).toFixed(1);
  by('f-indices').textContent = (f.bufferIndices / f.triangles).toFixed(3);
  by('f-operations').textContent = number(lastFrame.operations);
  by('f-bytes').textContent = bytes(lastFrame.bytes);
  by('f-whole').textContent = bytes(lastFrame.whole);
  by('f-time').textContent = timed.operations > 50 ? `${(1000 * timed.milliseconds / timed.operations).toFixed(1)} µs` : '–';
  by('f-frame').textContent = `${milliseconds.toFixed(1)} ms`;
  by('down').disabled = level === 0;
  by('up').disabled = level === mesh.levels;
}

/// `source`: of prepared().
export function showMesh(by, { name, base, splits, leftOut }, { levels }) {
  let triangles = base.length / 3;
  for (let i = 0; i < splits.length; i += 4) triangles += splits[i + 2] !== none && splits[i + 3] !== none ? 2 : 1;
  by('mesh-text').textContent = `${name}: ${number(triangles)} triangles, ${number(levels)} levels below.` +
    (leftOut.triangles ? ` ${leftOut.triangles} degenerate triangles were left out.` : '') +
    (leftOut.nonManifoldVertices ? ` The mesh is not a manifold at ${leftOut.nonManifoldVertices} vertices, which stay as they are.` : '');
}
