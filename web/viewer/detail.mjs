// The distribution of detail: the level everywhere, and in the view-dependent modes all records near the view.

/// A byte for each record, 1 if it is wanted; null: only the records of the level. `look`: a ray through the cursor.
export function wantedRecords({ mode, mesh, level, clicks, splits, normals, camera, look }) {
  const { points, levels } = mesh;
  const wanted = new Uint8Array(levels).fill(1, 0, level);
  for (const record of clicks) wanted[record] = 1;
  if (mode === 'level') return clicks.length > 0 ? wanted : null;
  if (mode === 'cursor') {
    const hit = mesh.pick(look.from, look.along);
    if (!hit) return wanted;
    const near = (0.22 * camera.size) ** 2;
    for (let i = level; i < levels; ++i) {
      const v = 3 * splits[4 * i + 1];
      if ((points[v] - hit[0]) ** 2 + (points[v + 1] - hit[1]) ** 2 + (points[v + 2] - hit[2]) ** 2 < near) wanted[i] = 1;
    }
    return wanted;
  }
  const eye = camera.eye;
  for (let i = level; i < levels; ++i) {
    const v = 3 * splits[4 * i + 1];
    const [x, y, z] = [eye[0] - points[v], eye[1] - points[v + 1], eye[2] - points[v + 2]];
    const facing = (x * normals[v] + y * normals[v + 1] + z * normals[v + 2]) / Math.hypot(x, y, z);
    if (Math.abs(facing) < 0.12) wanted[i] = 1;
  }
  return wanted;
}
