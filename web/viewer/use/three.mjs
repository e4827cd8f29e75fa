import { BufferAttribute, BufferGeometry } from 'three';

// For a mesh with levels; README.md of the package has a function for meshes to which vertices are added.
// The mesh has begun with { policy: 'bare', form: 'list' }, which does not maintain strips.
export function geometryOf(mesh) {
  const most = mesh.figures.triangles + 2 * mesh.levels;  // of the finest level
  return new BufferGeometry()
    .setAttribute('position', new BufferAttribute(mesh.points, 3))
    .setIndex(new BufferAttribute(new Uint32Array(3 * most), 1));
}

// After mesh.moveTo(level), before the geometry is rendered.
export function follow(mesh, geometry) {
  const { index } = geometry;
  const ranges = mesh.update();
  const { indices } = mesh;
  for (const { first, count } of ranges) {
    index.array.set(indices.subarray(first, first + count), first);
    index.addUpdateRange(first, count);
  }
  index.needsUpdate = ranges.length > 0;
  geometry.setDrawRange(0, indices.length);
}

// An experiment: one object is drawn as a triangle strip, which three.js does not support. Its mesh maintains strips.
export function drawAsStrips(renderer, object) {
  const gl = renderer.getContext();
  const draw = gl.drawElements.bind(gl);
  let strips = false;
  gl.drawElements = (mode, ...rest) => draw(strips ? gl.TRIANGLE_STRIP : mode, ...rest);
  object.onBeforeRender = () => { strips = true; };
  object.onAfterRender = () => { strips = false; };
}
