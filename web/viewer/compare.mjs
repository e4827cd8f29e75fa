// What each policy costs on the mesh that is shown, from the coarsest to the finest level, in this browser.
const firstShare = 256;  // operations, before their speed is known

export async function compare(by, restrip, source, cost) {
  by('compare').disabled = true;
  const rows = [];
  let bound = 0;
  for (const policy of ['local', 'linked', 'quick', 'full', ...(source.baked ? ['baked'] : [])]) {
    const mesh = (policy === 'baked' ? restrip.baked(source.baked) : restrip.progressive(source)).begin({ policy, cost });
    let took = 0;
    for (let most = firstShare;;) {  // in parts, so that the page goes on
      by('compared').textContent = `${policy}: ${Math.floor(100 * mesh.figures.played / mesh.levels)} %`;
      await new Promise((rested) => setTimeout(rested, 0));
      const before = performance.now();
      const done = mesh.moveTo(mesh.levels, most);
      const part = performance.now() - before;
      took += part;
      if (done < most) break;
      most = Math.max(1, Math.min(4 * most, Math.floor(done * 50 / Math.max(part, 0.1))));
    }
    const each = took * 1000 / mesh.levels;
    const { triangles, strips, addingStrip } = mesh.figures;
    rows.push([policy, strips, (mesh.plainIndices / triangles).toFixed(3), `${(100 * addingStrip / mesh.levels).toFixed(1)} %`, each.toFixed(1)]);
    if (policy === 'full') bound = mesh.indexBound / triangles;
    mesh.close();
  }
  by('compared').innerHTML = '<table><thead><tr><th>policy<th>strips<th>indices per triangle<th>splits that add a strip<th>µs a split</tr></thead><tbody>' +
    rows.map((row) => `<tr>${row.map((cell) => `<td>${typeof cell === 'number' ? cell.toLocaleString('en') : cell}`).join('')}</tr>`).join('') +
    `</tbody></table><p>At the finest level. No index buffer of this mesh has fewer than ${bound.toFixed(3)} indices per triangle; a triangle list has 3.</p>`;
  by('compare').disabled = false;
}
