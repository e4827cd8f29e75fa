import { load } from 'restrip-wasm';
import { loadReaders } from 'restrip-wasm/formats';

// points: x, y, z of each vertex; triangles: three vertices each.
export async function begin(points, triangles, options = { policy: 'quick', cost: 'indices' }) {
  const [restrip, { simplified }] = await Promise.all([load(), loadReaders()]);
  return restrip.progressive(await simplified({ points, triangles })).begin(options);
}
