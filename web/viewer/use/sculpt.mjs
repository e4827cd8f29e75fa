// Refines the mesh under a brush. Returns the removed and the added triangles, each with its slot in the index buffer.
// The mesh was begun with { policy: 'bare', form: 'list' }. `wanted`: a byte for each record; `seen`: the list so far.
export function stroke(mesh, { center, radius }, wanted, seen) {
  const { points, splits } = mesh;
  for (let i = 0; i < mesh.levels; ++i) {
    const place = 3 * splits[4 * i + 1];  // of the vertex that record i adds
    const away = Math.hypot(...center.map((c, n) => points[place + n] - c));
    if (away < radius) wanted[i] = 1;
  }
  mesh.approach(wanted);  // splits the wanted vertices and those that they depend on

  const slots = new Set();
  for (const { first, count } of mesh.update())
    for (let slot = Math.floor(first / 3); 3 * slot < first + count; ++slot) slots.add(slot);
  const now = mesh.indices.slice();
  for (let slot = now.length / 3; 3 * slot < seen.length; ++slot) slots.add(slot);
  const changed = (list) => [...slots].filter((slot) => 3 * slot < list.length)
    .map((slot) => ({ slot, corners: [...list.subarray(3 * slot, 3 * slot + 3)] }));
  return { removed: changed(seen), added: changed(now), seen: now };
}
