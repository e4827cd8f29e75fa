import { BufferAttribute, BufferGeometry } from 'three';

// The mesh has begun with the policy 'bare', which keeps no strips.
export function geometryOf(mesh) {
  const most = mesh.figures.triangles + 2 * mesh.levels;  // of the finest level
  return new BufferGeometry()
    .setAttribute('position', new BufferAttribute(mesh.points, 3))
    .setIndex(new BufferAttribute(new Uint32Array(3 * most), 1));
}

// After mesh.moveTo(level), before the geometry is rendered.
export function follow(mesh, geometry) {
  const { index } = geometry;
  const ranges = mesh.updateList();
  for (const { first, count } of ranges) {
    index.array.set(mesh.listIndices.subarray(first, first + count), first);
    index.addUpdateRange(first, count);
  }
  index.needsUpdate = ranges.length > 0;
  geometry.setDrawRange(0, mesh.listIndices.length);
}
