// The mesh that is shown and its figures, as text.
import { none } from '../js/restrip.mjs';

export const asNumber = (n) => n.toLocaleString('en');
export const asKilobytes = (bytes) => (bytes < 99950 ? (bytes / 1000).toFixed(bytes < 1000 ? 2 : 1) : asNumber(Math.round(bytes / 1000)));

/// `level`: that of the slider, to which the splits may still be on their way.
export function showLevel(by, played, levels, level) {
  by('level').value = level;
  by('level-text').textContent = `${asNumber(played)} of ${asNumber(levels)} splits`;
  by('down').disabled = level === 0;
  by('up').disabled = level === levels;
}

export function showFigures(by, { figures: { triangles, strips }, source }) {
  const name = source.name === 'hare' ? 'this hare' : 'this mesh';
  by('claim').textContent = strips === 1 ? `All ${asNumber(triangles)} triangles of ${name} are one strip. Move the level.`
    : `${asNumber(triangles)} triangles of ${name} in ${asNumber(strips)} strips. Move the level.`;
  by('f-triangles').textContent = asNumber(triangles);
  by('f-strips').textContent = asNumber(strips);
  by('f-length').textContent = (triangles / strips).toFixed(1);
}

/// How many the finest level has. `source`: of prepared().
export function fineTriangles({ base, splits }) {
  let triangles = base.length / 3;
  for (let i = 0; i < splits.length; i += 4) triangles += splits[i + 2] !== none && splits[i + 3] !== none ? 2 : 1;
  return triangles;
}

export function showMesh(by, source, { levels }) {
  const { name, leftOut } = source;
  by('mesh-text').textContent = `${name}: ${asNumber(fineTriangles(source))} triangles, ${asNumber(levels)} levels below.` +
    (leftOut.triangles ? ` ${leftOut.triangles} degenerate triangles were left out.` : '') +
    (leftOut.nonManifoldVertices ? ` The mesh is not a manifold at ${leftOut.nonManifoldVertices} vertices, which stay as they are.` : '');
}
