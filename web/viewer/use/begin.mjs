import { load } from 'restrip-wasm';

// points: x, y, z of each vertex; triangles: three vertices each.
export async function begin(points, triangles, options = { policy: 'quick', cost: 'indices' }) {
  const restrip = await load();
  return restrip.simplified({ points, triangles }).begin(options);
}
