// The mesh that is shown and its figures, as text.
import { none } from '../../bindings/js/restrip.mjs';

export const asNumber = (n, digits = 0) => n.toLocaleString('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });
/// With two digits that count, and all before the point.
export const asRatio = (n) => (n >= 9.95 ? asNumber(n) : n.toLocaleString('en', { maximumSignificantDigits: 2 }));
/// Kilobytes, to the byte if they are few.
export const asBytes = (bytes) => `${bytes < 99950 ? asNumber(bytes / 1000, bytes < 1000 ? 2 : 1) : asNumber(bytes / 1000)} kB`;

/// Bytes of an index of a mesh, in strips and in lists alike: two, if one number is left for restarts.
export const indexWidth = ({ points }) => (points.length / 3 < 0xffff ? 2 : 4);

/// A row of a table with a bar below it: the share that is written, and the share that is written or read.
export const barRow = (name, cells, written, all, least) => `<tr style="--written:${100 * written}%;--all:${100 * all}%"${least ? ' class="least"' : ''}>` +
  `<th scope="row">${name}</th>${cells.map((cell) => `<td>${cell}</td>`).join('')}</tr>`;

/// `level`: the level of the slider, which the splits may not have reached yet.
export function showLevel(by, played, levels, level) {
  by('level').value = level;
  by('level-text').textContent = `${asNumber(played)} of ${asNumber(levels)} splits`;
  by('down').disabled = level === 0;
  by('up').disabled = level === levels;
}

export function showFigures(by, { figures: { triangles, strips, baked }, source }) {
  const name = source.name === 'hare' ? 'this hare' : 'this mesh';
  by('claim').textContent = strips === 1 ? `One strip runs over all ${asNumber(triangles)} triangles of ${name}.`
    : `${asNumber(strips)} strips run over the ${asNumber(triangles)} triangles of ${name}.`;
  by('single').setAttribute('aria-pressed', String(baked));
  by('one-why').hidden = !baked;
  by('f-triangles').textContent = asNumber(triangles);
  by('f-strips').textContent = asNumber(strips);
  by('f-length').textContent = asNumber(triangles / strips, 1);
}

/// The indices that a drawn frame reads: as a list, as strips from scratch, as the strips of the mesh, one after the
/// other and in the buffer that is updated in place.
export function showReads(by, { mesh, figures: { triangles }, source }) {
  const list = 3 * triangles;
  const rows = [['Triangle list', list], ['Strips from scratch', mesh.fromScratch({ cost: 'indices' }).length],
    ['These strips, maintained', mesh.plainIndices], ['The live buffer with them', mesh.indices.length]];
  by('reads').parentElement.removeAttribute('aria-busy');
  by('reads').innerHTML = rows.map(([name, count]) =>
    barRow(name, [asBytes(count * indexWidth(source)), asNumber(count / triangles, 2)], 0, count / list, false)).join('');
}

/// The number at the finest level. `source`: of prepared().
export function fineTriangles({ base, splits }) {
  let triangles = base.length / 3;
  for (let i = 0; i < splits.length; i += 4) triangles += splits[i + 2] !== none && splits[i + 3] !== none ? 2 : 1;
  return triangles;
}

export function showMesh(by, source, { levels }) {
  const { name, leftOut } = source;
  by('coarser').href = `#part=cut&level=${levels >> 1}`;
  by('mesh-text').textContent = `${name}: ${asNumber(fineTriangles(source))} triangles, ${asNumber(levels)} levels below.` +
    (leftOut.triangles ? ` ${leftOut.triangles} degenerate triangle${leftOut.triangles === 1 ? ' was' : 's were'} left out.` : '') +
    (leftOut.nonManifoldVertices === 1 ? ' The mesh is not a manifold at one vertex, which stays as it is.'
      : leftOut.nonManifoldVertices ? ` The mesh is not a manifold at ${asNumber(leftOut.nonManifoldVertices)} vertices, which stay as they are.` : '');
}
