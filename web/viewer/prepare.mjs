// Prepares a mesh file for the viewer: a progressive mesh, and the normals of its finest level.

function normalsOf(points, triangles) {
  const normals = new Float32Array(points.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
    const [ux, uy, uz] = [points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]];
    const [vx, vy, vz] = [points[c] - points[a], points[c + 1] - points[a + 1], points[c + 2] - points[a + 2]];
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const v of [a, b, c]) for (let k = 0; k < 3; ++k) normals[v + k] += n[k];
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[v + k] /= length;
  }
  return normals;
}

/// `read`: a progressive or baked mesh, as the readers give it (bindings/js/formats.d.ts). Throws an Error that says what is
/// wrong.
export function prepared(restrip, name, read) {
  const mesh = read.baked ? restrip.baked(read.baked) : restrip.progressive(read);
  try {
    if (mesh.levels === 0) throw new Error(`${name}: no edge of it can be collapsed, so it has one level only`);
    const { points, splits, leftOut } = mesh.begin({ policy: 'local' });
    const base = mesh.triangles;
    mesh.moveTo(mesh.levels);
    return { name, points, base, splits, leftOut, normals: normalsOf(points, mesh.triangles), baked: read.baked };
  } finally {
    mesh.close();
  }
}
